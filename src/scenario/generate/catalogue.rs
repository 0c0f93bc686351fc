//! The table of generators, to be written.

use super::options::{OptionInfo, OptionKind};
use super::{GENERATORS, GeneratorInfo};
use serde::Serialize;

/// One generator of the table, as it is written.
#[derive(Debug, Serialize)]
pub struct GeneratorRow {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
    options: Vec<OptionRow>,
}

/// One option of a generator, as it is written, like a planner's parameter.
#[derive(Debug, Serialize)]
struct OptionRow {
    name: &'static str,
    title: &'static str,
    kind: &'static str,
    unit: &'static str,
    min: Option<f64>,
    max: Option<f64>,
    choices: Option<&'static [&'static str]>,
    default: Fallback,
    meaning: &'static str,
}

/// A default: a number or a word.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Fallback {
    Number(f64),
    Word(&'static str),
}

/// The table of generators, to be written.
pub fn catalogue() -> Vec<GeneratorRow> {
    let row = |info: &GeneratorInfo| GeneratorRow {
        id: info.id,
        title: info.title,
        summary: info.summary,
        options: info.options.iter().map(option_row).collect(),
    };
    GENERATORS.iter().map(row).collect()
}

fn option_row(info: &OptionInfo) -> OptionRow {
    let (kind, min, max, choices, default) = match info.kind {
        OptionKind::Integer { min, max, default } => ("integer", Some(min), Some(max), None, Fallback::Number(default)),
        OptionKind::Number { min, max, default } => ("number", Some(min), Some(max), None, Fallback::Number(default)),
        OptionKind::Choice(words) => ("choice", None, None, Some(words), Fallback::Word(words[0])),
    };
    let OptionInfo { name, title, unit, meaning, .. } = *info;
    OptionRow { name, title, kind, unit, min, max, choices, default, meaning }
}
