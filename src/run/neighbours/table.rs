//! The indexes that there are, with their options.

use crate::error::{Code, Error, quoted};
use crate::options::{ALL, OptionInfo, Options};
use crate::planner::Measuring;
use crate::random::MAX_SEED;
use strum::{IntoStaticStr, VariantArray};

/// An index of configurations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum IndexId {
    /// A linear scan.
    Linear,
    /// A kd-tree, taken where none is named.
    KdTree,
    /// A forest of random projections.
    Forest,
}

/// What there is to know about an index before it is made.
#[derive(Debug, Clone, PartialEq)]
pub struct IndexInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// Whether it always finds the nearest.
    pub is_exact: bool,
    /// Its options.
    pub parameters: Vec<OptionInfo>,
}

crate::options! {
    /// Options of the exact indexes.
    pub struct ExactOptions for ALL;
    /// The metric.
    measuring: Measuring;
}

crate::options! {
    /// Options of the forest.
    pub struct ForestOptions for ALL;
    /// The metric.
    measuring: Measuring;
    /// How many trees: more find more of the nearest, and take longer to build.
    trees: usize = 8, in 1.0..=64.0, "Trees";
    /// How many configurations fill a leaf before it is halved.
    leaf: usize = 32, in 8.0..=1024.0, "Leaf";
    /// How many configurations a question looks at, at least: more find more of the nearest, and take longer.
    candidates: usize = 400, in 1.0..=1e6, "Candidates";
    /// Decides the directions in which the trees halve.
    seed: u64 = 0, in 0.0..=MAX_SEED as f64, "Seed";
}

impl IndexId {
    /// The id, in kebab-case.
    pub fn as_str(self) -> &'static str {
        self.into()
    }

    /// The index with the given id; the kd-tree where there is none.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/index`, naming those that exist.
    pub fn of(id: Option<&str>) -> Result<Self, Error> {
        let Some(id) = id else { return Ok(IndexId::KdTree) };
        Self::VARIANTS.iter().copied().find(|index| index.as_str() == id).ok_or_else(|| {
            let known = Self::VARIANTS.iter().map(|index| index.as_str()).collect::<Vec<_>>().join(", ");
            Error::new(Code::OutOfRange, "/index", format!("there is no index {}; there are {known}", quoted(id)))
        })
    }

    /// Whether it always finds the nearest.
    pub fn is_exact(self) -> bool {
        match self {
            IndexId::Linear | IndexId::KdTree => true,
            IndexId::Forest => false,
        }
    }

    /// What there is to know about it.
    pub fn info(self) -> IndexInfo {
        let (title, summary, parameters) = match self {
            IndexId::Linear => (
                "Linear scan",
                "Looks at every configuration: simple, exact, and the measure of the others.",
                ExactOptions::table(),
            ),
            IndexId::KdTree => (
                "kd-tree",
                "Halves the configurations again and again, and passes over boxes that are too far; knows that angles wrap. Exact.",
                ExactOptions::table(),
            ),
            IndexId::Forest => (
                "Forest of random projections",
                "Looks at the leaves of several random trees that the target falls into: finds most of the nearest, not always all.",
                ForestOptions::table(),
            ),
        };
        IndexInfo { id: self.as_str(), title, summary, is_exact: self.is_exact(), parameters }
    }
}

/// Every index.
pub fn indexes() -> Vec<IndexInfo> {
    IndexId::VARIANTS.iter().map(|index| index.info()).collect()
}
