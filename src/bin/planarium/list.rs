//! `planarium list`: what there is to choose from, and what the error codes mean.

use crate::Answer;
use crate::arguments::List;
use crate::files;
use planarium::error::Code;
use planarium::fleet;
use planarium::json::Node;
use planarium::neighbours;
use planarium::planner::{Fallback, Kind, ParameterInfo, catalogue, planners};
use planarium::reach::{self, methods};
use planarium::scenario::generate::{self, GENERATORS, OptionInfo, OptionKind};
use serde_json::{Value, json};
use std::fmt::Write;

/// Prints tables, or JSON.
pub fn list(arguments: &List) -> Answer {
    let text = if arguments.json { as_json() } else { as_tables() };
    files::print(&text).map(|()| true)
}

fn as_json() -> String {
    let errors: Vec<_> =
        Code::ALL.iter().map(|code| json!({ "code": code.as_str(), "meaning": code.meaning() })).collect();
    let table = |node: Node| -> Value { serde_json::from_str(&node.to_json()).expect("a tree is written as JSON") };
    let document = json!({
        "planners": table(catalogue()),
        "reach_methods": table(reach::catalogue()),
        "indexes": table(neighbours::catalogue()),
        "generators": table(generate::catalogue()),
        "trajectories": table(fleet::catalogue()),
        "errors": errors,
    });
    serde_json::to_string_pretty(&document).expect("tables of words and numbers are JSON")
}

fn as_tables() -> String {
    let mut text = String::from("PLANNERS\n");
    for planner in planners() {
        let _ = writeln!(text, "\n  {} ({}): {}", planner.id, planner.title, planner.summary);
        let _ = writeln!(text, "    for robots of type {}", planner.robots.join(", "));
        for parameter in planner.parameters {
            push_parameter(&mut text, parameter);
            // What the planner says of itself need not be said again.
            if planner.robots.iter().any(|robot| !parameter.robots.contains(robot)) {
                let _ = writeln!(text, "    {:<15} (for robots of type {} only)", "", parameter.robots.join(", "));
            }
        }
        for preset in planner.presets {
            let settings = preset.settings.iter().map(|(name, value)| format!("--set {name}={value}"));
            let _ = writeln!(
                text,
                "    preset {} ({}): {}",
                preset.id,
                preset.title,
                settings.collect::<Vec<_>>().join(" ")
            );
        }
    }
    text.push_str("\nMETHODS OF INVERSE KINEMATICS\n");
    for method in methods() {
        let _ = writeln!(text, "\n  {} ({}): {}", method.id, method.title, method.summary);
        method.parameters.iter().for_each(|parameter| push_parameter(&mut text, parameter));
    }
    text.push_str("\nINDEXES\n");
    for index in neighbours::indexes() {
        let _ = writeln!(text, "\n  {} ({}): {}", index.id, index.title, index.summary);
        index.parameters.iter().for_each(|parameter| push_parameter(&mut text, parameter));
    }
    text.push_str("\nGENERATORS\n");
    for generator in GENERATORS {
        let _ = writeln!(text, "\n  {} ({}): {}", generator.id, generator.title, generator.summary);
        for option in generator.options {
            let _ = writeln!(text, "    {:<15} {}", option.name, option.meaning);
            let _ = writeln!(text, "    {:<15} {}", "", option_values(option));
        }
    }
    text.push_str("\nTRAJECTORIES\n\n");
    for parameter in fleet::PARAMETERS {
        let _ = writeln!(text, "    {:<18} {}", parameter.name, parameter.meaning);
        let _ = writeln!(text, "    {:<18} {}", "", values(parameter));
    }
    let _ = write!(text, "\nERROR CODES\n");
    for code in Code::ALL {
        let _ = write!(text, "\n  {:<18} {}", code.as_str(), code.meaning());
    }
    text
}

/// What a parameter means, and what values it takes.
fn push_parameter(text: &mut String, parameter: &ParameterInfo) {
    let _ = writeln!(text, "    {:<15} {}", parameter.name, parameter.meaning);
    let _ = writeln!(text, "    {:<15} {}", "", values(parameter));
}

/// Type, range, unit and default in words.
fn values(parameter: &ParameterInfo) -> String {
    let values = match parameter.kind {
        Kind::Integer { min, max } => format!("whole number from {min} to {max}"),
        Kind::Number { min, max } => format!("number from {min} to {max}"),
        Kind::Choice(words) => words.join(" or "),
        Kind::Switch => "true or false".to_owned(),
    };
    let unit = if parameter.unit.is_empty() { String::new() } else { format!(", {}", parameter.unit) };
    match parameter.default {
        Fallback::Number(number) => format!("({values}{unit}; default {number})"),
        Fallback::Text(word) => format!("({values}{unit}; default {word})"),
        Fallback::Off => format!("({values}{unit}; default false)"),
        Fallback::Computed(words) => format!("({values}{unit}; default: {words})"),
    }
}

/// The same for an option of a generator.
fn option_values(option: &OptionInfo) -> String {
    let (values, default) = match option.kind {
        OptionKind::Integer { min, max, default } => (format!("whole number from {min} to {max}"), default.to_string()),
        OptionKind::Number { min, max, default } => (format!("number from {min} to {max}"), default.to_string()),
        OptionKind::Choice(words) => (words.join(" or "), words[0].to_owned()),
    };
    let unit = if option.unit.is_empty() { String::new() } else { format!(", {}", option.unit) };
    format!("({values}{unit}; default {default})")
}
