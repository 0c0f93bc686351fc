//! Everything that can be chosen, as one document: planners, generators, methods, indexes and error codes, with their options.
//!
//! `schema/catalogue.json` holds it; a test compares. It is shipped beside the WebAssembly module, not in it.

use crate::error::Code;
use crate::ik::methods;
use crate::options::{Kind, OptionInfo, Options, Value};
use crate::planner::{ByControls, Preset, PseudocodeLine, planners};
use crate::run::neighbours::indexes;
use crate::scenario::generate::generators;
use crate::trajectories::TrajectoryOptions;
use serde_json::{Value as Json, json};

/// The document.
pub fn catalogue() -> Json {
    json!({
        "planners": planners().iter().map(|planner| {
            let info = planner.info();
            let line = |line: &PseudocodeLine| {
                let lit_by: Vec<&str> = line.lit_by.iter().map(|&mark| mark.into()).collect();
                json!({ "text": line.text, "indent": line.indent, "lit_by": lit_by })
            };
            let preset = |preset: &Preset| {
                let settings = preset.parameters().into_iter().map(|(name, setting)| (name, value(&setting)));
                let settings: serde_json::Map<String, Json> = settings.collect();
                json!({ "id": preset.id, "title": preset.title, "settings": settings })
            };
            let grows: &str = info.grows.into();
            json!({
                "id": info.id, "title": info.title, "summary": info.summary, "guarantee": info.guarantee,
                "grows": grows, "driven": planner.group::<ByControls>().is_some(),
                "pseudocode": info.pseudocode.iter().map(line).collect::<Vec<_>>(),
                "robots": planner.robots(),
                "presets": info.presets.iter().map(preset).collect::<Vec<_>>(),
                "parameters": table(&planner.table()),
            })
        }).collect::<Vec<_>>(),
        "reach_methods": methods().iter().map(|info| json!({
            "id": info.id, "title": info.title, "summary": info.summary, "parameters": table(&info.options),
        })).collect::<Vec<_>>(),
        "indexes": indexes().iter().map(|info| json!({
            "id": info.id, "title": info.title, "summary": info.summary, "exact": info.is_exact,
            "parameters": table(&info.parameters),
        })).collect::<Vec<_>>(),
        "generators": generators().iter().map(|info| json!({
            "id": info.id, "title": info.title, "summary": info.summary, "options": table(&info.options),
        })).collect::<Vec<_>>(),
        "trajectories": table(&TrajectoryOptions::table()),
        "errors": Code::ALL.iter().map(|code| json!({ "code": code.as_str(), "meaning": code.meaning() })).collect::<Vec<_>>(),
    })
}

/// A table of options: a default that depends on the rest is null and described in words.
fn table(options: &[OptionInfo]) -> Vec<Json> {
    let row = |info: &OptionInfo| {
        let (kind, range, choices) = match &info.kind {
            Kind::Integer(range) => ("integer", Some(range), None),
            Kind::Number(range) => ("number", Some(range), None),
            Kind::Choice(words) => ("choice", None, Some(words)),
            Kind::Switch => ("boolean", None, None),
        };
        json!({
            "name": info.name, "title": info.title, "kind": kind, "unit": info.unit,
            "min": range.map(|range| number(*range.start())), "max": range.map(|range| number(*range.end())),
            "choices": choices,
            "default": info.default.as_ref().map(value),
            "default_meaning": Some(info.computed).filter(|words| !words.is_empty()),
            "meaning": info.meaning, "robots": info.robots,
        })
    };
    options.iter().map(row).collect()
}

fn value(value: &Value) -> Json {
    match value {
        Value::Number(value) => number(*value),
        Value::Text(word) => json!(word),
        Value::Boolean(yes) => json!(yes),
        Value::Other(_) => Json::Null,
    }
}

/// A number, without a fraction if it is whole.
fn number(value: f64) -> Json {
    if value.fract() == 0.0 && value.abs() <= (1u64 << 53) as f64 { json!(value as i64) } else { json!(value) }
}
