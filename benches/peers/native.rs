//! The crate's side of `npm run bench`: one job per line of standard input, one line of JSON for each.
//!
//!   FILE PLANNER SEED RUNS LIMIT name=value ...
//!   FILE first SEED RUNS
//!   FILE fleet SEED RUNS
//!
//! FILE is a scenario document; seeds are SEED, SEED + 1, ...; a run ends after LIMIT seconds, solved or not. Every run is
//! fresh: its set-up begins with the parsed scenario, its search ends with the path. `first` measures the default planner with
//! all around it, from the text of the document to the result, `fleet` the default planner of the fleet in FILE. Their replies are
//! empty if a run finds nothing.

use planarium::fleet::{Fleet, FleetOptions, FleetPlanner};
use planarium::problem::Stepped;
use planarium::run::{Options, Phase, PlannerOptions, Status, Value, start};
use planarium::scenario::Scenario;
use std::io::{BufRead, Write};
use std::time::Instant;

/// Iterations between two readings of the clock.
const SLICE: u64 = 32;

fn main() {
    if !std::env::args().any(|argument| argument == "--serve") {
        println!("The comparison with the peers is driven by `npm run bench`.");
        return;
    }
    println!("{}", serde_json::json!({ "name": concat!("Planarium ", env!("CARGO_PKG_VERSION"), ", native") }));
    for job in std::io::stdin().lock().lines() {
        let reply = reply_to(&job.expect("standard input is text"));
        let reply = reply.unwrap_or_else(|error| serde_json::json!({ "error": error.to_string() }));
        println!("{reply}");
        std::io::stdout().flush().expect("standard output can be written");
    }
}

fn reply_to(job: &str) -> Result<serde_json::Value, Box<dyn std::error::Error>> {
    let mut words = job.split(' ');
    let mut next = || words.next().ok_or("a job has too few words");
    let text = std::fs::read_to_string(next()?)?;
    let planner = next()?.to_owned();
    let (seed, runs): (u64, u64) = (next()?.parse()?, next()?.parse()?);
    if let "first" | "fleet" = planner.as_str() {
        let answer = if planner == "first" { first_answer } else { fleet_plan };
        let mut seconds = Vec::new();
        for seed in seed..seed + runs {
            match answer(&text, seed)? {
                Some(time) => seconds.push(time),
                None => return Ok(serde_json::json!({ "seconds": [] })),
            }
        }
        return Ok(serde_json::json!({ "seconds": seconds }));
    }
    let limit: f64 = next()?.parse()?;
    let scenario = Scenario::parse(&text)?;
    let parameters = words.map(parameter).collect::<Option<Vec<_>>>().ok_or("a parameter is name=value")?;
    let mut done = Vec::new();
    let planner = PlannerOptions::read(&planner, &parameters)?;
    for seed in seed..seed + runs {
        let options = Options { seed, ..Options::new(planner) };
        done.push(outcome(&scenario, &options, limit)?);
    }
    Ok(serde_json::json!({ "runs": done }))
}

fn parameter(word: &str) -> Option<(String, Value)> {
    let (name, value) = word.split_once('=')?;
    Some((name.to_owned(), Value::from_text(value)))
}

/// The seconds from the text of a scenario to the result of the default planner; `None` if that has no path.
fn first_answer(text: &str, seed: u64) -> Result<Option<f64>, planarium::Error> {
    let began = Instant::now();
    let mut run = start(&Scenario::parse(text)?, &Options { seed, ..Options::default() })?;
    while run.step(u64::MAX) == Status::Running {}
    let result = run.result();
    let seconds = began.elapsed().as_secs_f64();
    std::hint::black_box(result);
    Ok((run.status() == Status::Solved).then_some(seconds))
}

/// The seconds from a new planner of a fleet to its result; `None` if that has no plan.
fn fleet_plan(text: &str, seed: u64) -> Result<Option<f64>, planarium::Error> {
    let fleet = Fleet::parse(text)?;
    let began = Instant::now();
    let mut planner = FleetPlanner::new(&fleet, FleetOptions { seed, ..FleetOptions::default() })?;
    while planner.step(u64::MAX) == Status::Running {}
    let result = planner.result();
    let seconds = began.elapsed().as_secs_f64();
    std::hint::black_box(result);
    Ok((planner.status() == Status::Solved).then_some(seconds))
}

/// One run, from its set-up to its path.
fn outcome(scenario: &Scenario, options: &Options, limit: f64) -> Result<serde_json::Value, planarium::Error> {
    let entered = Instant::now();
    let mut run = start(scenario, options)?;
    let setup = entered.elapsed().as_secs_f64();
    let began = Instant::now();
    let mut built = None;
    while run.step(SLICE) == Status::Running && began.elapsed().as_secs_f64() < limit {
        if built.is_none() && run.phase() == Phase::Searching {
            built = Some(began.elapsed().as_secs_f64());
        }
    }
    let path = run.path();
    let seconds = began.elapsed().as_secs_f64();
    std::hint::black_box(path);
    let (stats, built) = (run.stats(), built.unwrap_or(seconds));
    Ok(serde_json::json!({
        "setup": setup, "build": built, "search": seconds - built, "solved": run.status() == Status::Solved, "length": run.length(),
        "motions": stats.motion_checks, "vertices": stats.vertices, "edges": stats.edges,
    }))
}
