//! Experiments: every planner with every one of its settings, in every world, with every seed; each combination is a trial.
//!
//! An [`Experiment`] is read from a document (`planarium-experiment-1`) and checked as a scenario is: a start of every planner in
//! every world, and of every setting in one world of each kind, is made before any trial. Trials are numbered, and none is
//! stored: a number gives the world, the query, the planner, its setting and the seed. Worlds vary slowest and seeds fastest, so
//! trials of one world are neighbours. A trial depends on nothing but its number, and its row is the same on every platform, to
//! the bit.
//!
//! # Files
//! - `document.rs`, `validate.rs`: the document, and its rules;
//! - `grid.rs`: lists of values, seeds, and their combinations;
//! - `trial.rs`: trials by number, and their rows;
//! - `summary.rs`: the statistics of all rows.

mod document;
mod grid;
mod summary;
mod trial;
mod validate;

pub use document::Measure;
#[cfg(feature = "schema")]
pub use document::schema;
pub use summary::{Baseline, Comparison, GroupSummary, MeasureSummary, Summary, SummaryDocument};
pub use trial::{Trial, TrialRun, Trials, cell_text};

use crate::world::PlanningWorld;
use grid::{Grid, Seeds};

/// The `format` of an experiment.
pub const FORMAT: &str = "planarium-experiment-1";

/// The most trials of an experiment.
pub const MAX_TRIALS: u64 = 100_000_000;

/// The most worlds, as many settings of planners, and the most values of one parameter.
pub const MAX_LIST: u64 = 100_000;

/// A checked experiment.
pub struct Experiment {
    title: Option<String>,
    worlds: Vec<Worlds>,
    planners: Vec<Planner>,
    seeds: Seeds,
    budget: Budget,
    verify: bool,
    measures: Vec<Measure>,
    fingerprint: u64,
}

/// One entry of the document's worlds.
struct Worlds {
    name: String,
    source: Source,
    /// The names of queries; `None` is the first one of the world.
    queries: Vec<Option<String>>,
    /// The number of problems, pairs of a world and a query, of the entries before.
    before: u64,
}

/// Where worlds come from.
enum Source {
    Scenario(PlanningWorld),
    Generator {
        id: String,
        grid: Grid,
        seeds: Seeds,
        /// Of worlds with `ensure` the seeds that were drawn for them, by the number of the variant and that of the seed; else
        /// empty.
        drawn: Vec<Option<u64>>,
    },
}

/// One entry of the document's planners.
struct Planner {
    name: String,
    algorithm: String,
    grid: Grid,
    /// The number of settings of the planners before.
    before: u64,
}

/// The work of a trial at most.
#[derive(Clone, Copy)]
enum Budget {
    /// The limits of the planners.
    Own,
    Iterations(u64),
    ClearanceEvaluations(u64),
}

impl Experiment {
    /// The title for people, if there is one.
    pub fn title(&self) -> Option<&str> {
        self.title.as_deref()
    }

    /// 64-bit FNV-1a over the document except its title and its measures, however its numbers are written: rows with the same
    /// belong together.
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint
    }

    /// The columns that are summarised.
    pub fn measures(&self) -> &[Measure] {
        &self.measures
    }

    /// Whether paths are verified.
    pub fn verifies(&self) -> bool {
        self.verify
    }

    /// How many trials there are.
    pub fn trial_count(&self) -> u64 {
        self.problem_count() * self.setting_count() * self.seeds.len()
    }

    /// The number of pairs of a world and a query.
    fn problem_count(&self) -> u64 {
        self.worlds.last().map_or(0, |worlds| worlds.before.saturating_add(worlds.problem_count()))
    }

    /// The number of settings of all planners.
    fn setting_count(&self) -> u64 {
        self.planners.last().map_or(0, |planner| planner.before.saturating_add(planner.grid.len()))
    }
}

impl Worlds {
    /// The combinations of the generator's options; 1 for a scenario.
    fn variants(&self) -> u64 {
        if let Source::Generator { grid, .. } = &self.source { grid.len() } else { 1 }
    }

    /// The seeds of each; 1 for a scenario.
    fn seed_count(&self) -> u64 {
        if let Source::Generator { seeds, .. } = &self.source { seeds.len() } else { 1 }
    }

    /// Pairs of a world and a query; saturates, as what is too many is refused.
    fn problem_count(&self) -> u64 {
        self.variants().saturating_mul(self.seed_count()).saturating_mul(self.queries.len() as u64)
    }

    /// The values of the options that vary.
    fn varied(&self, variant: u64) -> Vec<(&str, &serde_json::Value)> {
        if let Source::Generator { grid, .. } = &self.source { grid.varied(variant) } else { Vec::new() }
    }
}
