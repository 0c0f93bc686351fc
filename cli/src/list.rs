//! `planarium list`: planners, methods, indexes, generators and their options, and the error codes.

use crate::arguments::Answer;
use crate::files;
use clap::Args;
use planarium::catalogue::catalogue;
use planarium_formats::Code;
use serde_json::{Value, json};
use std::fmt::Write;

/// The tables of entries with options: the title, the field of the catalogue, and the field of an entry with its options.
const TABLES: [(&str, &str, &str); 7] = [
    ("PLANNERS", "planners", "parameters"),
    ("METHODS OF INVERSE KINEMATICS", "reach_methods", "parameters"),
    ("INDEXES", "indexes", "parameters"),
    ("GENERATORS", "generators", "options"),
    ("PLANNERS OF FLEETS", "fleet_planners", "parameters"),
    ("GENERATORS OF FLEETS", "fleet_generators", "options"),
    ("GENERATORS OF NAVIGATION TASKS", "navigation_generators", "options"),
];

/// The tables of options: the title, and the field of the catalogue.
const LISTS: [(&str, &str); 4] = [
    ("ROLLOUTS OF AN EDGE", "rollouts"),
    ("TRAINING OF A POLICY", "training"),
    ("COMPARISON OF WAYS TO DRIVE", "comparison"),
    ("TRAJECTORIES", "trajectories"),
];

/// The field of the error codes of files that are no documents.
const WORLD_ERRORS: &str = "world_errors";

#[derive(Args)]
#[command(after_help = "\
Examples:
  planarium list
  planarium list --json")]
pub struct Arguments {
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

/// Prints tables, or JSON.
pub fn list(arguments: &Arguments) -> Answer {
    let mut catalogue = catalogue();
    catalogue[WORLD_ERRORS] =
        Code::ALL.iter().map(|code| json!({ "code": code.as_str(), "meaning": code.meaning() })).collect();
    let text = if arguments.json { format!("{catalogue:#}") } else { as_tables(&catalogue) };
    files::print(&text)?;
    Ok(true)
}

fn as_tables(catalogue: &Value) -> String {
    let mut text = String::new();
    for (title, field, options) in TABLES {
        let _ = writeln!(text, "{}{title}", if text.is_empty() { "" } else { "\n" });
        for entry in rows(&catalogue[field]) {
            push_entry(&mut text, entry, options);
        }
    }
    for (title, field) in LISTS {
        let _ = writeln!(text, "\n{title}\n");
        for option in rows(&catalogue[field]) {
            push_option(&mut text, option, 18);
        }
    }
    for (title, field) in [("ERROR CODES", "errors"), ("ERROR CODES OF MAPS AND PICTURES", WORLD_ERRORS)] {
        let _ = write!(text, "\n{title}\n");
        for error in rows(&catalogue[field]) {
            let _ = write!(text, "\n  {:<19} {}", word(&error["code"]), word(&error["meaning"]));
        }
        text.push('\n');
    }
    text.truncate(text.trim_end().len());
    text
}

fn push_entry(text: &mut String, entry: &Value, options: &str) {
    let _ = writeln!(text, "\n  {} ({}): {}", word(&entry["id"]), word(&entry["title"]), word(&entry["summary"]));
    if let Some(guarantee) = entry["guarantee"].as_str() {
        let _ = writeln!(text, "    {guarantee}");
        let _ = writeln!(text, "    for robots of type {}", words(&entry["robots"], ", "));
    }
    for option in rows(&entry[options]) {
        push_option(text, option, 15);
        // Not repeated if it applies to all robots of the planner.
        if rows(&entry["robots"]).iter().any(|robot| !rows(&option["robots"]).contains(robot)) {
            let _ = writeln!(text, "    {:<15} (for robots of type {} only)", "", words(&option["robots"], ", "));
        }
    }
    for preset in rows(&entry["presets"]) {
        let settings = preset["settings"].as_object().into_iter().flatten();
        let settings: Vec<String> = settings.map(|(name, value)| format!("--set {name}={}", word(value))).collect();
        let _ =
            writeln!(text, "    preset {} ({}): {}", word(&preset["id"]), word(&preset["title"]), settings.join(" "));
    }
}

/// The meaning and the values of an option.
fn push_option(text: &mut String, option: &Value, width: usize) {
    let (name, meaning) = (word(&option["name"]), word(&option["meaning"]));
    let _ = writeln!(text, "    {name:<width$} {meaning}\n    {:<width$} {}", "", values(option));
}

/// Type, range, unit and default in words.
fn values(option: &Value) -> String {
    let [min, max] = ["min", "max"].map(|field| word(&option[field]));
    let values = match word(&option["kind"]).as_str() {
        "integer" => format!("whole number from {min} to {max}"),
        "number" => format!("number from {min} to {max}"),
        "choice" => words(&option["choices"], " or "),
        _ => "true or false".to_owned(),
    };
    let unit =
        option["unit"].as_str().filter(|unit| !unit.is_empty()).map_or(String::new(), |unit| format!(", {unit}"));
    match option["default_meaning"].as_str() {
        Some(meaning) => format!("({values}{unit}; default: {meaning})"),
        None => format!("({values}{unit}; default {})", word(&option["default"])),
    }
}

fn rows(list: &Value) -> &[Value] {
    list.as_array().map_or(&[], Vec::as_slice)
}

fn words(list: &Value, between: &str) -> String {
    rows(list).iter().map(word).collect::<Vec<_>>().join(between)
}

/// A word without its quotes, or a number.
fn word(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}
