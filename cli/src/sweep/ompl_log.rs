//! Rows as a log of OMPL's benchmarks, which `ompl_benchmark_statistics` and Planner Arena read.
//!
//! A log is about one problem. Here worlds, queries and seeds are properties of runs, so that one file has the whole experiment.
//! OMPL's own planners run until a time is over; ours have a budget of work, so the limits of time and memory are infinite.

use super::rows::{Row, Rows};
use crate::output::Output;
use planarium::Error;
use planarium::experiment::Experiment;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::{SystemTime, UNIX_EPOCH};

/// OMPL's words for how a planner ended, in the order of their numbers.
const STATUS: &str = "status|Unknown status|Invalid start|Invalid goal|Unrecognized goal type|Timeout|Approximate solution|\
    Exact solution|Crash|Abort|Infeasible";
const UNKNOWN: usize = 0;
const TIMEOUT: usize = 4;
const EXACT: usize = 6;

/// The properties of runs that are columns of rows: OMPL's name and type, and the column.
const COLUMNS: [(&str, &str); 22] = [
    ("world TEXT", "world"),
    ("world seed INTEGER", "world_seed"),
    ("query TEXT", "query"),
    ("seed INTEGER", "seed"),
    ("iterations INTEGER", "iterations"),
    ("graph states INTEGER", "vertices"),
    ("graph motions INTEGER", "edges"),
    ("path waypoints INTEGER", "waypoints"),
    ("solution length REAL", "length"),
    ("solution cost REAL", "cost"),
    ("chord length REAL", "chord_length"),
    ("configuration checks INTEGER", "configuration_checks"),
    ("rejected samples INTEGER", "rejected_samples"),
    ("goal samples INTEGER", "goal_samples"),
    ("motion checks INTEGER", "motion_checks"),
    ("nearest queries INTEGER", "nearest_queries"),
    ("visited INTEGER", "visited"),
    ("reopened INTEGER", "reopened"),
    ("clearance evaluations INTEGER", "clearance_evaluations"),
    ("unproven motions INTEGER", "unproven_motions"),
    ("work INTEGER", "work"),
    ("reason TEXT", "reason"),
];

/// The runs of one planner with one setting: its parameters that vary, a line of each run, and how many there are.
#[derive(Default)]
struct Runs {
    settings: Vec<String>,
    lines: String,
    count: usize,
}

/// Writes all rows.
pub fn write(experiment: &Experiment, rows: &Rows, seconds: f64, log_file: &Output) -> Result<(), Error> {
    let at = |name: &str| rows.columns.iter().position(|column| column == name).expect("a column of all rows");
    let ([status, reason, planner], columns) =
        (["status", "reason", "planner"].map(at), COLUMNS.map(|(_, column)| at(column)));
    let settings: Vec<_> =
        rows.columns.iter().enumerate().filter_map(|(i, name)| Some((i, name.strip_prefix("planner.")?))).collect();
    let mut runs: BTreeMap<String, Runs> = BTreeMap::new();
    rows.read(|Row { cells, seconds: [build, search], .. }| {
        let given = settings.iter().filter(|(i, _)| !cells[*i].is_empty());
        let given: Vec<String> = given.map(|(i, name)| format!("{name} = {}", plain(&cells[*i]))).collect();
        let label = [&[plain(&cells[planner])], &given[..]].concat().join(" ");
        let runs = runs.entry(label).or_insert_with(|| Runs { settings: given, ..Runs::default() });
        let is_solved = cells[status] == "solved";
        // A budget was spent, or the roadmap is complete without a path: that is no proof that none exists.
        let ended = match cells[reason].as_str() {
            _ if is_solved => EXACT,
            "" => TIMEOUT,
            limit if limit.ends_with("-limit") => TIMEOUT,
            _ => UNKNOWN,
        };
        let _ = write!(runs.lines, "{}; {ended}; {}; {build}; {search}; ", u8::from(is_solved), build + search);
        columns.iter().for_each(|column| runs.lines.extend([&plain(&cells[*column]), "; "]));
        runs.lines.push('\n');
        runs.count += 1;
        Ok(())
    })?;
    let title: String =
        experiment.title().unwrap_or("planarium-experiment").split_whitespace().collect::<Vec<_>>().join("-");
    let now = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let most = runs.values().map(|runs| runs.count).max().unwrap_or(0);
    let mut log = format!(
        "Planarium version {}\nExperiment {title}\nRunning on {}\nStarting at {now} seconds after 1970-01-01\n\
         <<<|\nexperiment {:016x}, {} trials\n|>>>\n0 is the random seed\ninf seconds per run\ninf MB per run\n\
         {most} runs per planner\n{seconds} seconds spent to collect the data\n1 enum type\n{STATUS}\n{} planners\n",
        env!("CARGO_PKG_VERSION"),
        std::env::var("HOSTNAME").ok().filter(|name| !name.is_empty()).unwrap_or_else(|| "unknown".to_owned()),
        experiment.fingerprint(),
        experiment.trial_count(),
        runs.len()
    );
    for (label, Runs { settings, lines, count }) in runs {
        let _ = write!(log, "{label}\n{} common properties\n", settings.len());
        settings.iter().for_each(|setting| log.extend([setting, "\n"]));
        let own = ["solved BOOLEAN", "status ENUM", "time REAL", "build time REAL", "search time REAL"];
        let properties: Vec<&str> = own.into_iter().chain(COLUMNS.map(|(property, _)| property)).collect();
        let _ = write!(
            log,
            "{} properties for each run\n{}\n{count} runs\n{lines}.\n",
            properties.len(),
            properties.join("\n")
        );
    }
    log_file.write_bytes(log.as_bytes())
}

/// A text without the separators of the log.
fn plain(text: &str) -> String {
    text.replace([';', '\n', '\r'], ",")
}
