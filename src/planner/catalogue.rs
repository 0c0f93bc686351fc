//! The planners that exist, with their parameters: the one table that help texts, documents and controls are made from.

use super::parameters::{Fallback, Kind, ParameterInfo};
use crate::error::{Code, Error};
use serde::Serialize;

/// What there is to know about a planner before it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlannerInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// Its parameters.
    pub parameters: &'static [ParameterInfo],
}

/// Every planner.
pub fn planners() -> &'static [PlannerInfo] {
    &PLANNERS
}

/// The planner with the given id.
///
/// # Errors
/// `unknown-planner`, pointer `/algorithm`, naming those that exist.
pub fn planner_info(id: &str) -> Result<&'static PlannerInfo, Error> {
    PLANNERS.iter().find(|info| info.id == id).ok_or_else(|| {
        let known = PLANNERS.iter().map(|info| info.id).collect::<Vec<_>>().join(", ");
        Error::new(Code::UnknownPlanner, "/algorithm", format!("there is no planner {id:?}; there are {known}"))
    })
}

/// One planner of the table, as it is written.
#[derive(Debug, Serialize)]
pub struct PlannerRow {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    parameters: Vec<ParameterRow>,
}

/// One parameter of a planner, as it is written: a default that depends on the space is null and told in words.
#[derive(Debug, Serialize)]
struct ParameterRow {
    name: &'static str,
    title: &'static str,
    kind: &'static str,
    unit: &'static str,
    min: Option<f64>,
    max: Option<f64>,
    choices: Option<&'static [&'static str]>,
    default: Option<f64>,
    default_meaning: Option<&'static str>,
    meaning: &'static str,
}

/// The table of planners, to be written.
pub fn catalogue() -> Vec<PlannerRow> {
    let row = |info: &PlannerInfo| PlannerRow {
        id: info.id,
        title: info.title,
        summary: info.summary,
        parameters: info.parameters.iter().map(parameter_row).collect(),
    };
    PLANNERS.iter().map(row).collect()
}

fn parameter_row(info: &ParameterInfo) -> ParameterRow {
    let (kind, min, max, choices) = match info.kind {
        Kind::Integer { min, max } => ("integer", Some(min), Some(max), None),
        Kind::Number { min, max } => ("number", Some(min), Some(max), None),
        Kind::Choice(words) => ("choice", None, None, Some(words)),
    };
    let (default, default_meaning) = match info.default {
        Fallback::Number(number) => (Some(number), None),
        Fallback::Computed(words) => (None, Some(words)),
    };
    let ParameterInfo { name, title, unit, meaning, .. } = *info;
    ParameterRow { name, title, kind, unit, min, max, choices, default, default_meaning, meaning }
}

/// The planner taken where none is named.
pub const DEFAULT_PLANNER: &str = "rrt-connect";

/// The tolerance taken where none is given, as a fraction of the world's longer side.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;

const PLANNERS: [PlannerInfo; 2] = [
    PlannerInfo {
        id: "prm",
        title: "k-PRM",
        summary: "Scatters free samples, joins each to its nearest neighbours, then searches the roadmap.",
        parameters: &[SAMPLES, K, SHORTCUT, METRIC, TOLERANCE, MAX_ITERATIONS],
    },
    PlannerInfo {
        id: "rrt-connect",
        title: "RRT-Connect",
        summary: "Grows one tree from the start and one from the goal, each reaching for the other, until they meet.",
        parameters: &[STEP, SHORTCUT, METRIC, TOLERANCE, MAX_ITERATIONS],
    },
];

const SAMPLES: ParameterInfo = ParameterInfo {
    name: "samples",
    title: "Samples",
    kind: Kind::Integer { min: 0.0, max: 1e6 },
    unit: "",
    default: Fallback::Number(2000.0),
    meaning: "How many free samples become vertices of the roadmap, besides start and goal.",
};

const K: ParameterInfo = ParameterInfo {
    name: "k",
    title: "Neighbours",
    kind: Kind::Integer { min: 1.0, max: 1000.0 },
    unit: "",
    default: Fallback::Number(15.0),
    meaning: "To how many of its nearest neighbours each vertex is joined, where the motion is free.",
};

const STEP: ParameterInfo = ParameterInfo {
    name: "step",
    title: "Step",
    kind: Kind::Number { min: 1e-6, max: 1e7 },
    unit: "distance in the metric",
    default: Fallback::Computed("a fifth of the largest distance in the space"),
    meaning: "The longest edge: how far a tree grows towards a sample at once; at least a 10,000th of the largest distance.",
};

const SHORTCUT: ParameterInfo = ParameterInfo {
    name: "shortcut",
    title: "Shortcuts",
    kind: Kind::Integer { min: 0.0, max: 1e6 },
    unit: "",
    default: Fallback::Number(0.0),
    meaning: "How many proven shortcuts are tried on the path once it is found.",
};

const METRIC: ParameterInfo = ParameterInfo {
    name: "metric",
    title: "Metric",
    kind: Kind::Choice(&["sum", "euclidean"]),
    unit: "",
    default: Fallback::Computed("sum for arms, euclidean for discs"),
    meaning: "How the distances of an arm's joints make one: their sum, or the root of their squares; a disc is always Euclidean.",
};

const TOLERANCE: ParameterInfo = ParameterInfo {
    name: "tolerance",
    title: "Tolerance",
    kind: Kind::Number { min: 1e-9, max: 0.1 },
    unit: "of the world's longer side",
    default: Fallback::Number(DEFAULT_TOLERANCE),
    meaning: "A motion that stays this near to an obstacle may be refused unproven; none that touches one is ever accepted.",
};

const MAX_ITERATIONS: ParameterInfo = ParameterInfo {
    name: "max_iterations",
    title: "Iterations at most",
    kind: Kind::Integer { min: 1.0, max: 4e9 },
    unit: "",
    default: Fallback::Number(100_000.0),
    meaning: "After how many iterations without a path the planner gives up.",
};
