//! Trials by number, and their rows.

use super::{Budget, Experiment, Measure, Planner, Source, Worlds};
use crate::error::Error;
use crate::json;
use crate::path::{ResultDocument, Verdict, verify};
use crate::problem::{Phase, Status};
use crate::run::{self, Run};
use crate::world::PlanningWorld;
use serde_json::Value;
use std::sync::Arc;

/// What a trial is made of: indices into the experiment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Trial {
    /// The number of the trial, from 0.
    pub number: u64,
    /// The entry of worlds.
    pub(super) worlds: usize,
    /// The combination of the generator's options.
    pub(super) variant: u64,
    /// The index of the generator's seed.
    pub(super) world_seed: u64,
    /// The query of the entry.
    pub(super) query: usize,
    /// The entry of planners.
    pub(super) planner: usize,
    /// The combination of its parameters.
    pub(super) setting: u64,
    /// The index of the seed.
    pub(super) seed: u64,
}

impl Experiment {
    /// The trial with this number. O(log n) in the entries of the document.
    ///
    /// # Panics
    /// If there are fewer trials.
    pub fn trial(&self, number: u64) -> Trial {
        assert!(number < self.trial_count(), "there are {} trials, and none is number {number}", self.trial_count());
        let (rest, seed) = (number / self.seeds.len(), number % self.seeds.len());
        let (problem, setting) = (rest / self.setting_count(), rest % self.setting_count());
        let planner = self.planners.partition_point(|planner| planner.before <= setting) - 1;
        let worlds = self.worlds.partition_point(|worlds| worlds.before <= problem) - 1;
        let entry = &self.worlds[worlds];
        let (rest, queries) = (problem - entry.before, entry.queries.len() as u64);
        Trial {
            number,
            worlds,
            variant: rest / queries / entry.seed_count(),
            world_seed: rest / queries % entry.seed_count(),
            query: (rest % queries) as usize,
            planner,
            setting: setting - self.planners[planner].before,
            seed,
        }
    }

    /// The columns of rows: the experiment, the number of the trial, what it is made of, its status with the reason, the measures
    /// that are not times, and the fingerprint of the run.
    pub fn columns(&self) -> Vec<String> {
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let [of_worlds, of_planners] = self.varied_names();
        let [of_worlds, of_planners] = [("world", of_worlds), ("planner", of_planners)]
            .map(|(prefix, names)| names.iter().map(|name| format!("{prefix}.{name}")).collect::<Vec<_>>());
        let measures: Vec<&str> = counts().map(Measure::as_str).collect();
        let valid: &[&str] = if self.verify { &["valid"] } else { &[] };
        [
            words(&["experiment", "trial", "world"]),
            of_worlds,
            words(&["world_seed", "query", "planner"]),
            of_planners,
            words(&["seed", "status", "reason"]),
            words(valid),
            words(&measures),
            words(&["fingerprint"]),
        ]
        .concat()
    }

    /// The names of all options of generators and of all parameters of planners that vary, each once, in alphabetical order.
    fn varied_names(&self) -> [Vec<&str>; 2] {
        let grids = self.worlds.iter().filter_map(|worlds| match &worlds.source {
            Source::Generator { grid, .. } => Some(grid),
            Source::Scenario(_) => None,
        });
        let mut names: [Vec<&str>; 2] = [
            grids.flat_map(|grid| grid.names()).collect(),
            self.planners.iter().flat_map(|planner| planner.grid.names()).collect(),
        ];
        names.iter_mut().for_each(|names| {
            names.sort_unstable();
            names.dedup();
        });
        names
    }
}

/// The measures that are part of rows.
fn counts() -> impl Iterator<Item = Measure> {
    Measure::ALL.iter().copied().filter(|measure| !measure.is_time())
}

/// Starts trials, and keeps the last world for those that follow in it.
pub struct Trials {
    experiment: Arc<Experiment>,
    /// The indices of a world, and the world.
    last: Option<([u64; 3], PlanningWorld)>,
}

impl Trials {
    /// The trials of an experiment.
    pub fn new(experiment: &Arc<Experiment>) -> Self {
        Self { experiment: Arc::clone(experiment), last: None }
    }

    /// Starts the trial with this number.
    ///
    /// # Errors
    /// Those of [`run::start`], with a pointer into the experiment, for a setting that does not fit a world of a generator; all
    /// else was checked when the document was read.
    ///
    /// # Panics
    /// If there are fewer trials.
    pub fn start(&mut self, number: u64) -> Result<TrialRun, Error> {
        let experiment = Arc::clone(&self.experiment);
        let trial = experiment.trial(number);
        let key = [trial.worlds as u64, trial.variant, trial.world_seed];
        let world = match &self.last {
            Some((last, world)) if *last == key => world.clone(),
            _ => experiment.world(trial.worlds, trial.variant, trial.world_seed)?,
        };
        self.last = Some((key, world.clone()));
        let query = experiment.worlds[trial.worlds].queries[trial.query].as_deref();
        let options = experiment.options(trial.planner, trial.setting, query, experiment.seeds.at(trial.seed));
        let located = |error| experiment.located(error, [trial.worlds, trial.query, trial.planner], trial.setting);
        let run = options.and_then(|options| run::start(&world, &options)).map_err(located)?;
        Ok(TrialRun { experiment, trial, world, run, is_over: false })
    }
}

/// A trial that runs. It is stepped by a caller, who may measure the time.
pub struct TrialRun {
    experiment: Arc<Experiment>,
    trial: Trial,
    world: PlanningWorld,
    run: Box<dyn Run>,
    is_over: bool,
}

impl TrialRun {
    /// Makes at most this many iterations; whether the trial goes on. Where a trial ends does not depend on how it is stepped.
    pub fn step(&mut self, iterations: u64) -> bool {
        match self.experiment.budget {
            Budget::Own | Budget::Iterations(_) => self.is_over = self.run.step(iterations) != Status::Running,
            Budget::ClearanceEvaluations(most) => {
                let mut left = iterations;
                while left > 0 && !self.is_over {
                    let is_running = self.run.step(1) == Status::Running;
                    self.is_over = !is_running || self.run.stats().clearance_evaluations >= most;
                    left -= 1;
                }
            }
        }
        if self.is_over {
            // The budget may be spent while a path is being improved.
            self.run.finish();
        }
        !self.is_over
    }

    /// Whether it has ended.
    pub fn is_over(&self) -> bool {
        self.is_over
    }

    /// The status of the run: `Running` while the trial goes on, and if its budget was spent without a path.
    pub fn status(&self) -> Status {
        self.run.status()
    }

    /// The columns of its row: [`Experiment::columns`].
    pub fn columns(&self) -> Vec<String> {
        self.experiment.columns()
    }

    /// Iterations made so far.
    pub fn iterations(&self) -> u64 {
        self.run.iterations()
    }

    /// The phase of the run.
    pub fn phase(&self) -> Phase {
        self.run.phase()
    }

    /// The result of the run; its seconds are 0. Its status is `running` if the budget was spent without a path.
    pub fn result(&self) -> ResultDocument {
        self.run.result()
    }

    /// The row of the trial, in the order of [`Experiment::columns`]: `null` where a column does not apply, as for the length of
    /// a path that was not found.
    ///
    /// # Errors
    /// Those of [`verify()`].
    pub fn row(&self) -> Result<Vec<Value>, Error> {
        let Self { experiment, trial, .. } = self;
        let result = self.result();
        let Worlds { name, source, .. } = &experiment.worlds[trial.worlds];
        let Planner { name: planner, grid, .. } = &experiment.planners[trial.planner];
        let world_seed =
            if let Source::Generator { seeds, .. } = source { seeds.at(trial.world_seed).into() } else { Value::Null };
        let [of_worlds, of_planners] = experiment.varied_names();
        let cells = |names: &[&str], varied: &[(&str, &Value)]| {
            let value = |name| {
                varied.iter().find(|(varied, _)| *varied == name).map_or(Value::Null, |(_, value)| (*value).clone())
            };
            names.iter().map(|name| value(*name)).collect::<Vec<_>>()
        };
        let mut row = vec![hex(experiment.fingerprint), trial.number.into(), name.as_str().into()];
        row.extend(cells(&of_worlds, &experiment.worlds[trial.worlds].varied(trial.variant)));
        row.extend([world_seed, result.query.as_str().into(), planner.as_str().into()]);
        row.extend(cells(&of_planners, &grid.varied(trial.setting)));
        row.extend([experiment.seeds.at(trial.seed).into(), result.status.as_str().into()]);
        row.push(result.reason.map_or(Value::Null, |reason| reason.as_str().into()));
        if experiment.verify {
            let is_solved = result.status == Status::Solved;
            let valid = || Ok(matches!(verify(self.world.scenario(), &result)?, Verdict::Valid { .. }));
            row.push(if is_solved { valid()?.into() } else { Value::Null });
        }
        row.extend(counts().map(|measure| measure.of(&result)));
        row.push(hex(result.fingerprint));
        Ok(row)
    }
}

fn hex(bits: u64) -> Value {
    format!("{bits:016x}").into()
}

impl Measure {
    /// Its value in a result.
    fn of(self, result: &ResultDocument) -> Value {
        let stats = &result.stats;
        let count = match self {
            Measure::Waypoints | Measure::Length | Measure::Cost | Measure::ChordLength
                if result.status != Status::Solved =>
            {
                return Value::Null;
            }
            Measure::Length => return result.length.into(),
            Measure::Cost => return result.cost.as_ref().map(|cost| cost.value).into(),
            Measure::ChordLength => return result.chord_length.into(),
            Measure::BuildSeconds => return stats.build_seconds.into(),
            Measure::SearchSeconds => return stats.search_seconds.into(),
            Measure::Waypoints => result.path.len() as u64,
            Measure::Iterations => stats.iterations,
            Measure::Vertices => stats.vertices,
            Measure::Edges => stats.edges,
            Measure::ConfigurationChecks => stats.configuration_checks,
            Measure::RejectedSamples => stats.rejected_samples,
            Measure::GoalSamples => stats.goal_samples,
            Measure::Reopened => stats.reopened,
            Measure::MotionChecks => stats.motion_checks,
            Measure::UncheckedEdges => stats.unchecked_edges,
            Measure::NearestQueries => stats.nearest_queries,
            Measure::Visited => stats.visited,
            Measure::ClearanceEvaluations => stats.clearance_evaluations,
            Measure::UnprovenMotions => stats.unproven_motions,
            Measure::Work => stats.work,
        };
        count.into()
    }
}

/// A cell of a row as text: a word as it is, a number with the fewest digits that read back to the same bits, nothing for `null`.
pub fn cell_text(cell: &Value) -> String {
    match cell {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        other => json::to_string(other),
    }
}
