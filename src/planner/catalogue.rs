//! The planners that exist, with their parameters: the one table that help texts, documents and controls are made from.

use super::parameters::{Fallback, Kind, ParameterInfo};
use super::pseudocode::PseudocodeLine;
use super::table::PLANNERS;
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
    /// How it works, line by line.
    pub pseudocode: &'static [PseudocodeLine],
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
    pseudocode: &'static [PseudocodeLine],
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
    default: Option<Default>,
    default_meaning: Option<&'static str>,
    meaning: &'static str,
}

/// A default, as it is written.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Default {
    Number(f64),
    Text(&'static str),
    Off(bool),
}

/// The table of planners, to be written.
pub fn catalogue() -> Vec<PlannerRow> {
    let row = |info: &PlannerInfo| PlannerRow {
        id: info.id,
        title: info.title,
        summary: info.summary,
        pseudocode: info.pseudocode,
        parameters: info.parameters.iter().map(parameter_row).collect(),
    };
    PLANNERS.iter().map(row).collect()
}

fn parameter_row(info: &ParameterInfo) -> ParameterRow {
    let (kind, min, max, choices) = match info.kind {
        Kind::Integer { min, max } => ("integer", Some(min), Some(max), None),
        Kind::Number { min, max } => ("number", Some(min), Some(max), None),
        Kind::Choice(words) => ("choice", None, None, Some(words)),
        Kind::Switch => ("boolean", None, None, None),
    };
    let (default, default_meaning) = match info.default {
        Fallback::Number(number) => (Some(Default::Number(number)), None),
        Fallback::Text(word) => (Some(Default::Text(word)), None),
        Fallback::Off => (Some(Default::Off(false)), None),
        Fallback::Computed(words) => (None, Some(words)),
    };
    let ParameterInfo { name, title, unit, meaning, .. } = *info;
    ParameterRow { name, title, kind, unit, min, max, choices, default, default_meaning, meaning }
}

/// The planner taken where none is named.
pub const DEFAULT_PLANNER: &str = "rrt-connect";

/// The tolerance taken where none is given, as a fraction of the world's longer side.
pub const DEFAULT_TOLERANCE: f64 = 1e-4;
