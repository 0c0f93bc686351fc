//! The types that an experiment's document is read into, and that its JSON Schema is generated from. `validate.rs` checks the
//! remaining rules.

#[cfg(feature = "schema")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use strum::{IntoStaticStr, VariantArray};

/// The objects of a document: each is read with its fields and no others, and has a schema.
macro_rules! objects {
    ($($item:item)*) => {
        $(
            #[derive(Deserialize)]
            #[cfg_attr(feature = "schema", derive(JsonSchema))]
            #[serde(deny_unknown_fields)]
            $item
        )*
    };
}

objects! {
    /// An experiment: every planner with every one of its settings plans in every world with every seed, each a trial of its own.
    #[cfg_attr(feature = "schema", schemars(title = "Planarium experiment"))]
    pub(super) struct Document {
        /// The format of the document.
        pub format: Format,
        /// The title for people.
        pub title: Option<String>,
        /// The worlds; names are distinct.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        pub worlds: Vec<World>,
        /// The planners; names are distinct.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        pub planners: Vec<Planner>,
        /// The seeds of the planners.
        #[cfg_attr(feature = "schema", schemars(with = "Seeds"))]
        pub seeds: Value,
        /// The work of a trial at most; without it, the limits of the planners.
        pub budget: Option<Budget>,
        /// Whether every path is verified by the independent verifier.
        #[serde(default)]
        pub verify: bool,
        /// The columns that are summarised; by default length, iterations and clearance_evaluations.
        pub measures: Option<Vec<Measure>>,
    }

    /// A scenario, or a generator with its options and seeds.
    #[cfg_attr(
        feature = "schema",
        schemars(extend("oneOf" = [{ "required": ["scenario"] }, { "required": ["generate"] }]))
    )]
    pub(super) struct World {
        /// The name in rows; by default that of the scenario, or the generator's id.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        pub name: Option<String>,
        /// The scenario's document. The command line also takes the name of its file, relative to that of the experiment.
        pub scenario: Option<Value>,
        /// The id of a generator.
        pub generate: Option<String>,
        /// Options of the generator by name.
        #[serde(default)]
        pub set: Map<String, Value>,
        /// Options of the generator that vary, each with its values.
        #[serde(default)]
        #[cfg_attr(feature = "schema", schemars(with = "std::collections::BTreeMap<String, Axis>"))]
        pub vary: Map<String, Value>,
        /// The seeds of the generator: a world each; 0 by default.
        #[cfg_attr(feature = "schema", schemars(with = "Option<Seeds>"))]
        pub seeds: Option<Value>,
        /// The queries by name; by default the first one of each world.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        pub queries: Option<Vec<String>>,
    }

    /// A planner with its parameters.
    pub(super) struct Planner {
        /// The id of the planner.
        pub algorithm: String,
        /// The name in rows; by default the id.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        pub name: Option<String>,
        /// Parameters by name; all others have their defaults.
        #[serde(default)]
        pub set: Map<String, Value>,
        /// Parameters that vary, each with its values: every combination is tried.
        #[serde(default)]
        #[cfg_attr(feature = "schema", schemars(with = "std::collections::BTreeMap<String, Axis>"))]
        pub vary: Map<String, Value>,
    }

    /// The values from `from` on in steps, up to `to`, rounded to nine decimals.
    pub(super) struct Span {
        /// The first value.
        pub from: f64,
        /// The last value at most.
        pub to: f64,
        /// The difference of two values; at least 1e-6.
        #[cfg_attr(feature = "schema", schemars(range(min = 1e-6)))]
        pub step: f64,
    }

    /// Consecutive seeds.
    pub(super) struct SeedRange {
        /// The first seed.
        #[cfg_attr(feature = "schema", schemars(with = "f64", range(min = 0)))]
        pub from: u64,
        /// How many there are.
        #[cfg_attr(feature = "schema", schemars(with = "f64", range(min = 1)))]
        pub count: u64,
    }

    /// The work of a trial at most: one of the two.
    #[cfg_attr(
        feature = "schema",
        schemars(extend("oneOf" = [{ "required": ["iterations"] }, { "required": ["clearance_evaluations"] }]))
    )]
    pub(super) struct Budget {
        /// The most iterations, attempts at improving a path not counted: the parameter `max_iterations` of every planner.
        #[cfg_attr(feature = "schema", schemars(with = "Option<f64>", range(min = 1)))]
        pub iterations: Option<u64>,
        /// A trial ends with the first iteration after which this number of clearances has been evaluated, as a race does.
        #[cfg_attr(feature = "schema", schemars(with = "Option<f64>", range(min = 1)))]
        pub clearance_evaluations: Option<u64>,
    }
}

crate::json::one_format!(pub(super) enum Format = "planarium-experiment-1");

/// Seeds: whole numbers from 0 to 2^53 - 1, each once.
#[cfg(feature = "schema")]
#[derive(JsonSchema)]
#[schemars(untagged)]
#[allow(dead_code)] // For the schema alone.
enum Seeds {
    List(#[schemars(with = "Vec<f64>", length(min = 1))] Vec<u64>),
    Range(SeedRange),
}

/// The values of a parameter: a list, or numbers in equal steps.
#[cfg(feature = "schema")]
#[derive(JsonSchema)]
#[schemars(untagged)]
#[allow(dead_code)] // For the schema alone.
enum Axis {
    List(#[schemars(length(min = 1))] Vec<Value>),
    Span(Span),
}

/// A measured number of a trial.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, IntoStaticStr, VariantArray)]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
#[non_exhaustive]
pub enum Measure {
    /// Iterations, attempts at improving the path included.
    Iterations,
    /// Vertices of the graph.
    Vertices,
    /// Edges of the graph.
    Edges,
    /// Configurations of the path, start and goal included.
    Waypoints,
    /// The length of the path, as results state it: metres of a disc or a car, radians of an arm, both weighted of a body.
    Length,
    /// Where `clearance_weight` is above 0, what was minimised: the length, and what nearness to obstacles adds.
    Cost,
    /// Of a path by controls, the sum of the distances between its waypoints, as course reports measure it.
    ChordLength,
    /// Configurations tested for collision.
    ConfigurationChecks,
    /// Samples drawn in collision.
    RejectedSamples,
    /// Samples that were a goal.
    GoalSamples,
    /// Motions tested for collision.
    MotionChecks,
    /// Candidate edges of a lazy roadmap that were not tested.
    UncheckedEdges,
    /// Queries of the index of neighbours.
    NearestQueries,
    /// Vertices that the search expanded.
    Visited,
    /// Vertices that the search expanded again.
    Reopened,
    /// Evaluations of the clearance of a part.
    ClearanceEvaluations,
    /// Motions refused because their proof had spent its budget.
    UnprovenMotions,
    /// The work of all of these, in units of about a microsecond.
    Work,
    /// Seconds of growing the graph. Times are not part of rows.
    BuildSeconds,
    /// Seconds of searching the graph and improving the path.
    SearchSeconds,
}

impl Measure {
    /// Every measure, in the order of the columns.
    pub const ALL: &[Measure] = Measure::VARIANTS;

    /// Its word in documents and in the columns of rows.
    pub fn as_str(self) -> &'static str {
        self.into()
    }

    /// Whether it is a time, which no seed decides.
    pub fn is_time(self) -> bool {
        matches!(self, Measure::BuildSeconds | Measure::SearchSeconds)
    }
}

/// The JSON Schema (draft 2020-12) of the documents that [`Experiment::parse`](super::Experiment::parse) accepts.
#[cfg(feature = "schema")]
pub fn schema() -> Value {
    crate::scenario::schema_of::<Document>()
}
