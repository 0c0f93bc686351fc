//! From a document to a checked experiment.

use super::document::{self, Document};
use super::grid::{Grid, Seeds, refused};
use super::{Budget, Experiment, FORMAT, MAX_LIST, MAX_TRIALS, Measure, Planner, Source, Worlds};
use crate::error::{Code, Error, quoted};
use crate::fingerprint::Fingerprint;
use crate::json;
use crate::run::{self, Options, PlannerOptions, Value};
use crate::scenario::Scenario;
use crate::world::PlanningWorld;
use crate::worlds::{self, Ensure};
use serde_json::Value as Json;
use std::collections::BTreeSet;

/// The columns that are summarised by default.
const MEASURES: [Measure; 3] = [Measure::Length, Measure::Iterations, Measure::ClearanceEvaluations];

impl Experiment {
    /// Reads an experiment from JSON text.
    ///
    /// # Errors
    /// The first rule that is violated: a stable code, a sentence with the offending value, and its JSON pointer. Codes: those of
    /// [`json::parse`] and [`json::read`]; `unknown-format`; `out-of-range` for an empty list or range; `too-large` for more than
    /// 10^8 trials; `duplicate-name`; those of scenarios, generators and their options; and those of [`run::start`], such as
    /// `unknown-planner`, `unknown-parameter`, `unsupported` and `start-in-collision`.
    ///
    /// # Complexity
    /// As many starts as there are queries of worlds times planners; and for each kind of world as many as there are settings.
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::read(&json::parse(text)?)
    }

    /// Reads an experiment from a tree of JSON values.
    ///
    /// # Errors
    /// Those of [`Experiment::parse`], except about the text.
    pub fn read(tree: &Json) -> Result<Self, Error> {
        let document: Document = json::read_document(tree, FORMAT)?;
        let document::Format::One = document.format;
        let seeds = Seeds::read(&document.seeds).map_err(|error| error.under("/seeds"))?;
        let measures = document.measures.unwrap_or_else(|| MEASURES.to_vec());
        let (verify, title, fingerprint) = (document.verify, document.title, fingerprint(tree));
        let budget = document.budget.map_or(Ok(Budget::Own), checked_budget)?;
        let (worlds, planners) = (checked_worlds(document.worlds)?, checked_planners(document.planners)?);
        let mut experiment = Self { title, worlds, planners, seeds, budget, verify, measures, fingerprint };
        experiment.check_size()?;
        experiment.draw_worlds()?;
        experiment.check_starts()?;
        Ok(experiment)
    }

    fn check_size(&self) -> Result<(), Error> {
        let [problems, settings] = [self.problem_count(), self.setting_count()];
        for (count, pointer, what) in
            [(problems, "/worlds", "queries of worlds"), (settings, "/planners", "settings of planners")]
        {
            if count > MAX_LIST {
                return refused(
                    Code::TooLarge,
                    pointer,
                    format!("there are {count} {what}; at most {MAX_LIST} are allowed"),
                );
            }
        }
        let trials = u128::from(problems * settings) * u128::from(self.seeds.len());
        if trials > u128::from(MAX_TRIALS) {
            let sentence = format!("these are {trials} trials; at most {MAX_TRIALS} are allowed");
            return refused(Code::TooLarge, "/seeds", sentence);
        }
        Ok(())
    }

    /// Draws the worlds with `ensure` once: from then on each is made from the seed that was drawn.
    fn draw_worlds(&mut self) -> Result<(), Error> {
        for w in 0..self.worlds.len() {
            let (variants, count) = (self.worlds[w].variants(), self.worlds[w].seed_count());
            let Source::Generator { id, grid, seeds, .. } = &self.worlds[w].source else { continue };
            let mut found = Vec::new();
            for variant in 0..variants {
                let located = |error| located(error, w, grid, variant);
                let options = grid.options(variant);
                let (_, ensured) = worlds::split(&options).map_err(located)?;
                for seed in (0..count).map(|seed| seeds.at(seed)) {
                    let is_drawn = ensured.ensure != Ensure::Any;
                    let seeded = || worlds::draw(id, &seeded(&options, seed)).map_err(located);
                    found.push(if is_drawn { Some(seeded()?.1) } else { None });
                }
            }
            if let (true, Source::Generator { drawn, .. }) =
                (found.iter().any(Option::is_some), &mut self.worlds[w].source)
            {
                *drawn = found;
            }
        }
        Ok(())
    }

    /// Starts every planner in every world, and every setting in the first world of every kind.
    fn check_starts(&self) -> Result<(), Error> {
        for (w, worlds) in self.worlds.iter().enumerate() {
            for world in 0..worlds.variants() * worlds.seed_count() {
                let [variant, seed] = [world / worlds.seed_count(), world % worlds.seed_count()];
                let prepared = self.world(w, variant, seed)?;
                for (query, name) in worlds.queries.iter().enumerate() {
                    for (p, planner) in self.planners.iter().enumerate() {
                        let settings = if seed == 0 { planner.grid.len() } else { 1 };
                        for setting in 0..settings {
                            self.options(p, setting, name.as_deref(), self.seeds.at(0))
                                .and_then(|options| run::start(&prepared, &options))
                                .map_err(|error| self.located(error, [w, query, p], setting))?;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// The world of an entry, one of its variants, and the index of the generator's seed.
    pub(super) fn world(&self, w: usize, variant: u64, seed: u64) -> Result<PlanningWorld, Error> {
        match &self.worlds[w].source {
            Source::Scenario(world) => Ok(world.clone()),
            Source::Generator { id, grid, seeds, drawn } => {
                let located = |error| located(error, w, grid, variant);
                let number = (variant * self.worlds[w].seed_count() + seed) as usize;
                let given = grid.options(variant);
                let options = match drawn.get(number).copied().flatten() {
                    Some(drawn) => seeded(&worlds::split(&given).map_err(located)?.0, drawn),
                    None => seeded(&given, seeds.at(seed)),
                };
                worlds::generate_with(id, &options).map(PlanningWorld::new).map_err(located)
            }
        }
    }

    /// The options of a run.
    ///
    /// # Errors
    /// Those of [`PlannerOptions::read`], before the experiment is validated.
    pub(super) fn options(
        &self,
        planner: usize,
        setting: u64,
        query: Option<&str>,
        seed: u64,
    ) -> Result<Options, Error> {
        let Planner { algorithm, grid, .. } = &self.planners[planner];
        let mut parameters = grid.options(setting);
        if let Budget::Iterations(most) = self.budget {
            parameters.push(("max_iterations".to_owned(), Value::Number(most as f64)));
        }
        let planner = PlannerOptions::read(algorithm, &parameters)?;
        Ok(Options { query: query.map(str::to_owned), seed, ..Options::new(planner) })
    }

    /// The error of a start with a pointer into the document of the experiment.
    pub(super) fn located(&self, error: Error, [w, query, p]: [usize; 3], setting: u64) -> Error {
        let option = error.pointer();
        let first = option.split('/').nth(1).unwrap_or_default();
        let pointer = match (first, self.planners[p].grid.pointer(setting, option)) {
            (_, Some(below)) => format!("/planners/{p}{below}"),
            ("algorithm", _) => format!("/planners/{p}/algorithm"),
            ("query", _) if self.worlds[w].queries[query].is_some() => format!("/worlds/{w}/queries/{query}"),
            ("queries", _) if matches!(self.worlds[w].source, Source::Scenario(_)) => {
                format!("/worlds/{w}/scenario{option}")
            }
            ("queries" | "query", _) => format!("/worlds/{w}"),
            ("max_iterations", _) => "/budget/iterations".to_owned(),
            _ => format!("/planners/{p}"),
        };
        Error::new(error.code(), pointer, error.message())
    }
}

/// The options and a seed.
fn seeded(options: &[(String, Value)], seed: u64) -> Vec<(String, Value)> {
    [options, &[("seed".to_owned(), Value::Number(seed as f64))]].concat()
}

/// The error of a generator with a pointer into the document of the experiment.
fn located(error: Error, w: usize, grid: &Grid, variant: u64) -> Error {
    let below = match error.pointer() {
        "" => "/generate".to_owned(),
        option => {
            grid.pointer(variant, option).unwrap_or_else(|| if option == "/seed" { "/seeds" } else { "" }.to_owned())
        }
    };
    Error::new(error.code(), format!("/worlds/{w}{below}"), error.message())
}

/// See [`Experiment::fingerprint`].
fn fingerprint(tree: &Json) -> u64 {
    let mut tree = tree.clone();
    if let Json::Object(fields) = &mut tree {
        fields.remove("title");
        fields.remove("measures");
    }
    let mut hash = Fingerprint::default();
    hash.bytes(json::to_string(&tree).as_bytes());
    hash.value()
}

fn checked_budget(budget: document::Budget) -> Result<Budget, Error> {
    match (budget.iterations, budget.clearance_evaluations) {
        (Some(most), None) => Ok(Budget::Iterations(most)),
        (None, Some(0)) => {
            refused(Code::OutOfRange, "/budget/clearance_evaluations", "a budget must be at least 1, not 0")
        }
        (None, Some(most)) => Ok(Budget::ClearanceEvaluations(most)),
        (Some(_), Some(_)) => refused(
            Code::UnknownField,
            "/budget/clearance_evaluations",
            "a budget has iterations or clearance_evaluations, not both",
        ),
        (None, None) => {
            let sentence = "the field \"iterations\" or \"clearance_evaluations\" is missing";
            refused(Code::MissingField, "/budget/iterations", sentence)
        }
    }
}

fn checked_worlds(entries: Vec<document::World>) -> Result<Vec<Worlds>, Error> {
    let (mut worlds, mut names, mut before) = (Vec::new(), BTreeSet::new(), 0u64);
    for (i, entry) in entries.into_iter().enumerate() {
        let pointer = format!("/worlds/{i}");
        let entry = checked_world(entry, before).map_err(|error| error.under(&pointer))?;
        check_name(&entry.name, &mut names).map_err(|error| error.under(&pointer))?;
        before = before.saturating_add(entry.problem_count());
        worlds.push(entry);
    }
    if worlds.is_empty() {
        refused(Code::OutOfRange, "/worlds", "there must be at least one world")
    } else {
        Ok(worlds)
    }
}

/// Checks that a name is not empty and not that of another entry: names distinguish rows.
fn check_name(name: &str, names: &mut BTreeSet<String>) -> Result<(), Error> {
    if name.is_empty() {
        return refused(Code::OutOfRange, "/name", "a name must not be empty");
    }
    if !names.insert(name.to_owned()) {
        let sentence = format!("another entry has the name {}, too; give one of them another name", quoted(name));
        return refused(Code::DuplicateName, "/name", sentence);
    }
    Ok(())
}

fn checked_world(entry: document::World, before: u64) -> Result<Worlds, Error> {
    let document::World { name, scenario, generate, set, vary, seeds, queries } = entry;
    let (default, source) = match (scenario, generate) {
        (Some(tree), None) => {
            let given = [("set", !set.is_empty()), ("vary", !vary.is_empty()), ("seeds", seeds.is_some())];
            if let Some((field, _)) = given.into_iter().find(|(_, is_given)| *is_given) {
                return refused(
                    Code::UnknownField,
                    format!("/{field}"),
                    format!("{field} is for generators; this is a scenario"),
                );
            }
            let scenario = Scenario::read(&tree).map_err(|error| error.under("/scenario"))?;
            (scenario.name().to_owned(), Source::Scenario(PlanningWorld::new(scenario)))
        }
        (None, Some(id)) => {
            let seeds =
                seeds.as_ref().map_or(Ok(Seeds::List(vec![0])), Seeds::read).map_err(|error| error.under("/seeds"))?;
            (id.clone(), Source::Generator { id, grid: Grid::read(set, &vary)?, seeds, drawn: Vec::new() })
        }
        (Some(_), Some(_)) => {
            return refused(Code::UnknownField, "/generate", "a world has a scenario or a generator, not both");
        }
        (None, None) => {
            return refused(Code::MissingField, "/scenario", "the field \"scenario\" or \"generate\" is missing");
        }
    };
    let queries = match queries {
        Some(names) if names.is_empty() => {
            return refused(Code::OutOfRange, "/queries", "there must be at least one query");
        }
        Some(names) => {
            let mut seen = BTreeSet::new();
            if let Some(i) = names.iter().position(|name| !seen.insert(name)) {
                let sentence = format!("the query {} occurs twice", quoted(&names[i]));
                return refused(Code::DuplicateName, format!("/queries/{i}"), sentence);
            }
            names.into_iter().map(Some).collect()
        }
        None => vec![None],
    };
    Ok(Worlds { name: name.unwrap_or(default), source, queries, before })
}

fn checked_planners(entries: Vec<document::Planner>) -> Result<Vec<Planner>, Error> {
    let (mut planners, mut names, mut before) = (Vec::new(), BTreeSet::new(), 0u64);
    for (i, entry) in entries.into_iter().enumerate() {
        let under = |error: Error| error.under(&format!("/planners/{i}"));
        let document::Planner { algorithm, name, set, vary } = entry;
        let name = name.unwrap_or_else(|| algorithm.clone());
        check_name(&name, &mut names).map_err(under)?;
        let grid = Grid::read(set, &vary).map_err(under)?;
        let settings = grid.len();
        planners.push(Planner { name, algorithm, grid, before });
        before = before.saturating_add(settings);
    }
    if planners.is_empty() {
        refused(Code::OutOfRange, "/planners", "there must be at least one planner")
    } else {
        Ok(planners)
    }
}
