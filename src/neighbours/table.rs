//! The indexes that there are, with their parameters: the one table that help texts and controls are made from.

use crate::error::{Code, Error, quoted};
use crate::json::Node;
use crate::parameters::{Fallback, Kind, ParameterInfo};
use crate::planner::METRIC;
use crate::random::MAX_SEED;

/// What there is to know about an index before it is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IndexInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// Whether it always finds the nearest.
    pub is_exact: bool,
    /// Its parameters.
    pub parameters: &'static [ParameterInfo],
}

/// The index taken where none is named.
const DEFAULT: &str = "kd-tree";

/// Every robot, by its type in documents.
const ALL: &[&str] = &["arm", "disc", "rigid_body", "car"];

/// A row of the forest: a count.
const fn count(
    name: &'static str,
    title: &'static str,
    range: [f64; 2],
    default: f64,
    meaning: &'static str,
) -> ParameterInfo {
    let [min, max] = range;
    let kind = Kind::Integer { min, max };
    ParameterInfo { name, title, kind, unit: "", default: Fallback::Number(default), meaning, robots: ALL }
}

const INDEXES: [IndexInfo; 3] = [
    IndexInfo {
        id: "linear",
        title: "Linear scan",
        summary: "Looks at every configuration: simple, exact, and the measure of the others.",
        is_exact: true,
        parameters: &[METRIC],
    },
    IndexInfo {
        id: "kd-tree",
        title: "kd-tree",
        summary: "Halves the configurations again and again, and passes over boxes that are too far; knows that angles wrap. Exact.",
        is_exact: true,
        parameters: &[METRIC],
    },
    IndexInfo {
        id: "forest",
        title: "Forest of random projections",
        summary: "Looks at the leaves of several random trees that the target falls into: finds most of the nearest, not always all.",
        is_exact: false,
        parameters: &[
            METRIC,
            count(
                "trees",
                "Trees",
                [1.0, 64.0],
                8.0,
                "How many trees: more find more of the nearest, and take longer to build.",
            ),
            count("leaf", "Leaf", [8.0, 1024.0], 32.0, "How many configurations fill a leaf before it is halved."),
            count(
                "candidates",
                "Candidates",
                [1.0, 1e6],
                400.0,
                "How many configurations a question looks at, at least: more find more of the nearest, and take longer.",
            ),
            count("seed", "Seed", [0.0, MAX_SEED as f64], 0.0, "Decides the directions in which the trees halve."),
        ],
    },
];

/// Every index.
pub fn indexes() -> &'static [IndexInfo] {
    &INDEXES
}

/// The index with the given id; the kd-tree where there is none.
///
/// # Errors
/// `out-of-range`, pointer `/index`, naming those that exist.
pub fn index_info(id: Option<&str>) -> Result<&'static IndexInfo, Error> {
    let id = id.unwrap_or(DEFAULT);
    INDEXES.iter().find(|info| info.id == id).ok_or_else(|| {
        let known = INDEXES.iter().map(|info| info.id).collect::<Vec<_>>().join(", ");
        Error::new(Code::OutOfRange, "/index", format!("there is no index {}; there are {known}", quoted(id)))
    })
}

/// The table, to be written.
pub fn catalogue() -> Node {
    let row = |info: &IndexInfo| {
        Node::object(vec![
            ("id", Some(Node::text(info.id))),
            ("title", Some(Node::text(info.title))),
            ("summary", Some(Node::text(info.summary))),
            ("exact", Some(Node::Bool(info.is_exact))),
            ("parameters", Some(Node::Array(info.parameters.iter().map(ParameterInfo::node).collect()))),
        ])
    };
    Node::Array(INDEXES.iter().map(row).collect())
}
