//! The indexes with their options.

use crate::error::{Code, Error, quoted};
use crate::options::{ALL, OptionInfo, Options, Value};
use crate::planner::MetricOptions;
use crate::random::MAX_SEED;

/// An index with its options.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum IndexOptions {
    /// A linear scan.
    Linear(MetricOptions),
    /// A kd-tree, the default.
    KdTree(MetricOptions),
    /// A kd-tree that takes angles as plain numbers from -pi to pi. Faulty, for comparison: see
    /// [`KdTree::unwrapped`](crate::nearest::KdTree::unwrapped).
    KdTreeUnwrapped(MetricOptions),
    /// A forest of random projections.
    Forest(ForestOptions),
}

impl Default for IndexOptions {
    fn default() -> Self {
        IndexOptions::KdTree(MetricOptions::default())
    }
}

impl IndexOptions {
    /// The index with the given id, by default the kd-tree, and with options given by name; the rest have their defaults.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/index`, for another id, naming those that exist; `unknown-parameter`, `duplicate-field`,
    /// `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name`.
    pub fn read(id: Option<&str>, given: &[(String, Value)]) -> Result<Self, Error> {
        Ok(match id.unwrap_or("kd-tree") {
            "linear" => IndexOptions::Linear(Options::read(given)?),
            "kd-tree" => IndexOptions::KdTree(Options::read(given)?),
            "kd-tree-unwrapped" => IndexOptions::KdTreeUnwrapped(Options::read(given)?),
            "forest" => IndexOptions::Forest(Options::read(given)?),
            id => {
                let known = "linear, kd-tree, kd-tree-unwrapped, forest";
                let sentence = format!("unknown index {}; known indexes are {known}", quoted(id));
                return Err(Error::new(Code::OutOfRange, "/index", sentence));
            }
        })
    }

    /// Refuses values out of range: a metric is always in range.
    pub(super) fn check(&self) -> Result<(), Error> {
        if let IndexOptions::Forest(options) = self { options.check() } else { Ok(()) }
    }

    /// Its metric.
    pub fn measuring(&self) -> MetricOptions {
        match *self {
            IndexOptions::Linear(measuring)
            | IndexOptions::KdTree(measuring)
            | IndexOptions::KdTreeUnwrapped(measuring) => measuring,
            IndexOptions::Forest(ForestOptions { measuring, .. }) => measuring,
        }
    }

    /// Whether it always finds the nearest.
    pub fn is_exact(&self) -> bool {
        matches!(self, IndexOptions::Linear(_) | IndexOptions::KdTree(_))
    }
}

/// The description of an index.
#[derive(Debug, Clone, PartialEq)]
pub struct IndexInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in a sentence.
    pub summary: &'static str,
    /// Whether it always finds the nearest.
    pub is_exact: bool,
    /// Its options.
    pub parameters: Vec<OptionInfo>,
}

crate::options! {
    /// Options of the forest.
    pub struct ForestOptions for ALL;
    /// The metric.
    measuring: MetricOptions;
    /// Number of trees: more find more of the nearest but take longer to build.
    trees: usize = 8, in 1.0..=64.0, "Trees";
    /// Number of configurations in a leaf before it is split.
    leaf: usize = 32, in 8.0..=1024.0, "Leaf";
    /// Least number of configurations that a query examines: more find more of the nearest but take longer.
    candidates: usize = 400, in 1.0..=1e6, "Candidates";
    /// Seed of the directions in which the trees split.
    seed: u64 = 0, in 0.0..=MAX_SEED as f64, "Seed";
}

/// Every index.
pub fn indexes() -> Vec<IndexInfo> {
    vec![
        IndexInfo {
            id: "linear",
            title: "Linear scan",
            summary: "Examines every configuration: simple, exact, and the reference for the others.",
            is_exact: true,
            parameters: MetricOptions::table(),
        },
        IndexInfo {
            id: "kd-tree",
            title: "kd-tree",
            summary: "Halves the configurations recursively and skips boxes that are too far; angles wrap. Exact.",
            is_exact: true,
            parameters: MetricOptions::table(),
        },
        IndexInfo {
            id: "kd-tree-unwrapped",
            title: "kd-tree without wrap-around",
            summary: "Takes angles as plain numbers from -pi to pi: misses the nearest across that seam. Faulty, for comparison.",
            is_exact: false,
            parameters: MetricOptions::table(),
        },
        IndexInfo {
            id: "forest",
            title: "Forest of random projections",
            summary: "Examines the leaves of several random trees around the target: finds most of the nearest, not always all.",
            is_exact: false,
            parameters: ForestOptions::table(),
        },
    ]
}
