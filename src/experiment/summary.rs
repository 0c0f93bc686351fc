//! The statistics of all rows of an experiment.

use super::{Experiment, Measure, Trial};
use crate::error::{Code, Error, quoted};
use crate::json::hex;
use crate::statistics::{Mean, Names, Paired, Quartiles, Share, mean, paired, quartiles, share};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// The most names of settings in the sentence of an error.
const MOST_NAMES: u64 = 30;

/// What the settings of an experiment are compared with, on the same worlds and seeds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Baseline {
    /// The first setting of the first planner.
    #[default]
    First,
    /// One setting: see [`Experiment::baseline`].
    Setting {
        /// The number of the planner in the document.
        planner: usize,
        /// The number of its setting.
        setting: u64,
    },
    /// Each other: every pair is compared once.
    AllPairs,
}

impl Experiment {
    /// The setting with the given name, to be compared with. A name is that of the planner, with the parameters that
    /// vary in parentheses, as comparisons print it: `prm (k=4)`. O(settings).
    ///
    /// # Errors
    /// `out-of-range`, pointer `/baseline`, for another name, naming those that exist.
    pub fn baseline(&self, name: &str) -> Result<Baseline, Error> {
        let settings =
            || self.planners.iter().enumerate().flat_map(|(i, planner)| (0..planner.grid.len()).map(move |n| (i, n)));
        let label = |&(planner, setting): &(usize, u64)| {
            let planner = &self.planners[planner];
            label(&planner.name, &by_name(planner.grid.varied(setting)))
        };
        if let Some((planner, setting)) = settings().find(|one| label(one) == name) {
            return Ok(Baseline::Setting { planner, setting });
        }
        let mut known: Vec<String> = settings().take(MOST_NAMES as usize).map(|one| quoted(&label(&one))).collect();
        if let Some(more) = self.setting_count().checked_sub(MOST_NAMES).filter(|more| *more > 0) {
            known.push(format!("and {more} more"));
        }
        let sentence = format!("no setting has the name {}; known names are {}", quoted(name), known.join(", "));
        Err(Error::new(Code::OutOfRange, "/baseline", sentence))
    }
}

/// Collects what is measured of trials, in any order, and summarises it: 8 bytes for each trial and measure.
pub struct Summary<'a> {
    experiment: &'a Experiment,
    rows: u64,
    /// By world, variant, query, planner and setting.
    groups: BTreeMap<[u64; 5], Group>,
}

/// The trials that differ in seeds alone: one place for each, NaN while it is unknown.
struct Group {
    solved: Vec<f64>,
    valid: Vec<f64>,
    /// Of each measure, the values of solved trials.
    measures: Vec<Vec<f64>>,
}

/// The summary as a document.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SummaryDocument {
    /// The fingerprint of the experiment, as in its rows.
    #[serde(with = "hex")]
    pub experiment: u64,
    /// The title of the experiment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// How many trials the experiment has.
    pub trials: u64,
    /// How many of them are summarised.
    pub rows: u64,
    /// The trials that differ in seeds alone.
    pub groups: Vec<GroupSummary>,
    /// The settings compared with their baseline, by default the first setting of the first planner, on the same worlds
    /// and seeds.
    pub comparisons: Vec<Comparison>,
}

/// The statistics of one planner with one setting in worlds of one kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupSummary {
    /// The name of the worlds.
    pub world: String,
    /// The options of the generator that vary.
    pub world_settings: Map<String, Value>,
    /// The name of the query; none if it is the first of each world.
    pub query: Option<String>,
    /// The name of the planner.
    pub planner: String,
    /// Its parameters that vary.
    pub settings: Map<String, Value>,
    /// The share of trials that are solved.
    pub solved: Share,
    /// The share of paths that the verifier accepts, if it was asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub valid: Option<Share>,
    /// The statistics of every measure, over the trials that are solved; those that are not are missing.
    pub measures: BTreeMap<&'static str, MeasureSummary>,
}

/// The statistics of one measure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MeasureSummary {
    /// The quartiles.
    pub quartiles: Quartiles,
    /// The mean with its interval.
    pub mean: Mean,
}

/// One setting compared with another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The index of the group in [`SummaryDocument::groups`].
    pub group: usize,
    /// The index of the group that it is compared with.
    pub with: usize,
    /// Which of the two is solved, pair by pair: 1 or 0.
    pub solved: Paired,
    /// Every measure, over the pairs in which both are solved.
    pub measures: BTreeMap<&'static str, Paired>,
}

impl<'a> Summary<'a> {
    /// A summary without rows.
    pub fn new(experiment: &'a Experiment) -> Self {
        Self { experiment, rows: 0, groups: BTreeMap::new() }
    }

    /// Adds a trial: whether it is solved, whether its path is valid if that was asked, and the value of each of
    /// [`Experiment::measures`], NaN if it is unknown. A trial that is added again counts once.
    ///
    /// # Errors
    /// `duplicate-name` (pointer `/trial`) if the trial has been added with other values; then nothing is changed.
    pub fn add(&mut self, trial: &Trial, is_solved: bool, is_valid: Option<bool>, values: &[f64]) -> Result<(), Error> {
        let experiment = self.experiment;
        let seeds = experiment.seeds.len();
        let size = (experiment.worlds[trial.worlds].seed_count() * seeds) as usize;
        let key = [trial.worlds as u64, trial.variant, trial.query as u64, trial.planner as u64, trial.setting];
        let unknown = || vec![f64::NAN; size];
        let group = self.groups.entry(key).or_insert_with(|| Group {
            solved: unknown(),
            valid: if experiment.verify { unknown() } else { Vec::new() },
            measures: experiment.measures.iter().map(|_| unknown()).collect(),
        });
        let place = (trial.world_seed * seeds + trial.seed) as usize;
        let number = |is_so: bool| f64::from(u8::from(is_so));
        let valid = is_valid.map_or(f64::NAN, number);
        let of_solved = |value: Option<&f64>| value.copied().filter(|_| is_solved).unwrap_or(f64::NAN);
        let given: Vec<f64> = [number(is_solved)]
            .into_iter()
            .chain(experiment.verify.then_some(valid))
            .chain((0..experiment.measures.len()).map(|i| of_solved(values.get(i))))
            .collect();
        let places: Vec<&mut f64> = [&mut group.solved]
            .into_iter()
            .chain(experiment.verify.then_some(&mut group.valid))
            .chain(&mut group.measures)
            .map(|all| &mut all[place])
            .collect();
        if !places[0].is_nan() {
            let is_same = |(old, new): (&&mut f64, &f64)| **old == *new || (old.is_nan() && new.is_nan());
            if places.iter().zip(&given).all(is_same) {
                return Ok(());
            }
            let sentence = format!("trial {} has two rows that differ", trial.number);
            return Err(Error::new(Code::DuplicateName, "/trial", sentence));
        }
        places.into_iter().zip(given).for_each(|(place, value)| *place = value);
        self.rows += 1;
        Ok(())
    }

    /// Adds the row of a trial: each cell as text, by its column or, of a time, by its word as a measure; empty if it is unknown.
    ///
    /// # Errors
    /// Those of [`Summary::add`].
    pub fn add_row(&mut self, trial: u64, cell: impl Fn(&str) -> String) -> Result<(), Error> {
        let number = |measure: &Measure| cell(measure.as_str()).parse().unwrap_or(f64::NAN);
        let values: Vec<f64> = self.experiment.measures().iter().map(number).collect();
        self.add(&self.experiment.trial(trial), cell("status") == "solved", cell("valid").parse().ok(), &values)
    }

    /// The summary of the trials that were added.
    pub fn document(&self) -> SummaryDocument {
        self.document_against(Baseline::First)
    }

    /// The same with another baseline. P-values are judged by the number of all tests of the document, of success and
    /// of every measure (Bonferroni's correction). All pairs of g settings are O(g^2) comparisons in every world.
    pub fn document_against(&self, baseline: Baseline) -> SummaryDocument {
        let groups: Vec<_> = self.groups.iter().map(|(key, group)| self.group(*key, group)).collect();
        SummaryDocument {
            experiment: self.experiment.fingerprint,
            title: self.experiment.title.clone(),
            trials: self.experiment.trial_count(),
            rows: self.rows,
            comparisons: self.comparisons(&groups, baseline),
            groups,
        }
    }

    fn group(&self, [worlds, variant, query, planner, setting]: [u64; 5], group: &Group) -> GroupSummary {
        let experiment = self.experiment;
        let (worlds, planner) = (&experiment.worlds[worlds as usize], &experiment.planners[planner as usize]);
        GroupSummary {
            world: worlds.name.clone(),
            world_settings: by_name(worlds.varied(variant)),
            query: worlds.queries[query as usize].clone(),
            planner: planner.name.clone(),
            settings: by_name(planner.grid.varied(setting)),
            solved: share(&group.solved),
            valid: experiment.verify.then(|| share(&group.valid)),
            measures: self.by_measure(|i| MeasureSummary {
                quartiles: quartiles(&group.measures[i]),
                mean: mean(&group.measures[i]),
            }),
        }
    }

    /// One value for every measure, by its word.
    fn by_measure<T>(&self, of: impl Fn(usize) -> T) -> BTreeMap<&'static str, T> {
        let mut values = BTreeMap::new();
        let measures = self.experiment.measures.iter().enumerate();
        measures.for_each(|(i, measure)| drop(values.insert(measure.as_str(), of(i))));
        values
    }

    /// The groups that are compared, and those that they are compared with: all of one problem.
    fn pairs(&self, baseline: Baseline) -> Vec<(usize, usize)> {
        let keys: Vec<_> = self.groups.keys().collect();
        let mut pairs = Vec::new();
        // The groups are in order, so the first one of a problem is that of the first planner, if it has run.
        let mut first = 0;
        for problem in keys.chunk_by(|a, b| a[..3] == b[..3]) {
            let all = first..first + problem.len();
            let against = match baseline {
                Baseline::First => first..first + 1,
                Baseline::Setting { planner, setting } => {
                    let at = problem.iter().position(|key| key[3..] == [planner as u64, setting]);
                    at.map_or(0..0, |at| first + at..first + at + 1)
                }
                Baseline::AllPairs => all.clone(),
            };
            let is_pair = |&(group, with): &(usize, usize)| match baseline {
                Baseline::AllPairs => group > with,
                _ => group != with,
            };
            pairs.extend(against.flat_map(|with| all.clone().map(move |group| (group, with))).filter(is_pair));
            first = all.end;
        }
        pairs
    }

    fn comparisons(&self, summaries: &[GroupSummary], baseline: Baseline) -> Vec<Comparison> {
        let groups: Vec<_> = self.groups.iter().collect();
        let pairs = self.pairs(baseline);
        let tests = (pairs.len() * (1 + self.experiment.measures.len())) as u64;
        let compared = |&(group, with): &(usize, usize)| {
            let [a, b] = [group, with].map(|i| label(&summaries[i].planner, &summaries[i].settings));
            let [one, other] = [group, with].map(|i| groups[i].1);
            let compare = |x: &[f64], y: &[f64], measure: &str| paired(x, y, Names { a: &a, b: &b, measure }, tests);
            Comparison {
                group,
                with,
                solved: compare(&one.solved, &other.solved, "success"),
                measures: self.by_measure(|i| {
                    compare(&one.measures[i], &other.measures[i], self.experiment.measures[i].as_str())
                }),
            }
        };
        pairs.iter().map(compared).collect()
    }
}

/// Values of parameters by name.
fn by_name(values: Vec<(&str, &Value)>) -> Map<String, Value> {
    values.into_iter().map(|(name, value)| (name.to_owned(), value.clone())).collect()
}

/// A planner with its setting.
fn label(planner: &str, settings: &Map<String, Value>) -> String {
    let settings: Vec<String> =
        settings.iter().map(|(name, value)| format!("{name}={}", super::cell_text(value))).collect();
    if settings.is_empty() { planner.to_owned() } else { format!("{planner} ({})", settings.join(", ")) }
}

impl Measure {
    /// The measure with this word.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|measure| measure.as_str() == word)
    }
}
