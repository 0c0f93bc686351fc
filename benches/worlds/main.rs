//! The crate's side of `npm run bench:worlds`: one job per line of standard input, one line of JSON for each.
//!
//!   { "file": FILE, or "generate": KIND and "options": {}, "query": NAME, "planner": ID, "seed": N, "seconds": S, "parameters": {} }
//!
//! Without a planner the job asks for the shortest path. Time is that of the processor, where the system tells it: other programs that
//! run at the same time do not count.

use planarium::optimum::{MetricOptions, optimum};
use planarium::run::{Options, Request, Status, Value, start};
use planarium::scenario::{Scenario, generate::generate};
use planarium::{Error, PlanningWorld};
use serde_json::{Value as Json, json};
use std::io::{BufRead, Write};
use std::time::Instant;

/// Steps between two readings of the processor's clock.
const SLICE: u32 = 64;

/// Shorter runs are measured by the time of day.
const COARSE: f64 = 0.02;

fn main() {
    if !std::env::args().any(|argument| argument == "--serve") {
        println!("The table of all planners over many worlds is driven by `npm run bench:worlds`.");
        return;
    }
    let mut last: Option<(Json, PlanningWorld)> = None;
    for line in std::io::stdin().lock().lines() {
        let job: Json = serde_json::from_str(&line.expect("standard input is text")).expect("a job is JSON");
        let reply = reply_to(&job, &mut last).unwrap_or_else(|error| json!({ "error": error.to_string() }));
        println!("{reply}");
        std::io::stdout().flush().expect("standard output can be written");
    }
}

fn reply_to(job: &Json, last: &mut Option<(Json, PlanningWorld)>) -> Result<Json, Box<dyn std::error::Error>> {
    let key = json!([job["file"], job["generate"], job["options"]]);
    if last.as_ref().is_none_or(|(of, _)| *of != key) {
        let scenario = match job["file"].as_str() {
            Some(file) => Scenario::parse(&std::fs::read_to_string(file)?)?,
            None => generate(job["generate"].as_str().ok_or("a job has a file or a generator")?, &job["options"])?,
        };
        *last = Some((key, PlanningWorld::from(&scenario)));
    }
    let (_, world) = last.as_ref().expect("there is one now");
    let query = job["query"].as_str();
    if job["planner"].is_null() && job["defaults"] != true {
        let shortest = optimum(world.scenario(), query, MetricOptions::default())?;
        return Ok(json!({ "length": shortest.length, "exact": shortest.exact }));
    }
    let parameters = job["parameters"].as_object().into_iter().flatten();
    let request = Request {
        planner: job["planner"].as_str().map(str::to_owned),
        query: query.map(str::to_owned),
        seed: job["seed"].as_u64().unwrap_or_default(),
        parameters: parameters.map(|(name, value)| (name.clone(), Value::from(value))).collect(),
        events: false,
    };
    let options = request.for_robot(world.scenario().robot())?;
    Ok(outcome(world, &options, job["seconds"].as_f64().unwrap_or(5.0))?)
}

/// One run, from its set-up to its path.
fn outcome(world: &PlanningWorld, options: &Options, limit: f64) -> Result<Json, Error> {
    let (began, entered) = (seconds(), Instant::now());
    let mut run = start(world.clone(), options)?;
    let (mut longest, mut spent) = (0.0f64, seconds() - began);
    let mut first = None;
    while run.status() == Status::Running && spent < limit {
        let (mut slowest, before) = (0.0f64, spent);
        for _ in 0..SLICE {
            let entered = Instant::now();
            let status = run.step(1);
            let took = entered.elapsed().as_secs_f64();
            slowest = slowest.max(took);
            if status != Status::Running || took > 0.01 {
                break;
            }
        }
        spent = seconds() - began;
        longest = longest.max(slowest.min(spent - before));
        if first.is_none() && !run.raw_path().is_empty() {
            first = Some(spent);
        }
    }
    run.finish();
    // The processor's clock is too coarse for short runs.
    let wall = entered.elapsed().as_secs_f64();
    let spent = if wall < COARSE { wall } else { spent };
    let stats = run.stats();
    Ok(json!({
        "status": run.status().as_str(), "seconds": spent, "first": first, "length": run.length(), "longest": longest,
        "iterations": stats.iterations, "vertices": stats.vertices, "evaluations": stats.clearance_evaluations,
        "motions": stats.motion_checks,
    }))
}

/// The seconds that this thread has run so far; the time of day where the system does not tell.
fn seconds() -> f64 {
    let spent = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = spent.as_deref().and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(
        || std::time::SystemTime::UNIX_EPOCH.elapsed().map_or(0.0, |since| since.as_secs_f64()),
        |nanoseconds| nanoseconds * 1e-9,
    )
}
