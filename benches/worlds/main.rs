//! The crate's side of `npm run bench:worlds`: one job per line of standard input, one line of JSON for each.
//!
//!   { "read": [FILE, ...], "options": {}, "times": N }
//!   { "file": FILE, or "generate": KIND and "options": {}, "query": NAME, "planner": ID, "seed": N, "seconds": S, "parameters": {} }
//!
//! The first reads the files of a world, the second plans. Without a planner it asks for the shortest path; with a `path` it
//! verifies that.
//! Time is that of the processor, where the system tells it: other programs that run at the same time do not count.

use planarium::optimum::{MetricOptions, optimum};
use planarium::path::{ResultDocument, Verdict, verify};
use planarium::run::inspect::Inspector;
use planarium::run::{self, Options, Request, Status, Value, start};
use planarium::scenario::{Scenario, generate::generate};
use planarium::{Error, PlanningWorld, json};
use planarium_formats::{Cell, File, Grid, read};
use serde_json::{Value as Json, json};
use std::io::{BufRead, Write};
use std::time::Instant;

/// Steps between two readings of the processor's clock.
const SLICE: u32 = 64;

/// Shorter runs are measured by the time of day.
const COARSE: f64 = 0.02;

type Failure = Box<dyn std::error::Error>;

fn main() {
    if !std::env::args().any(|argument| argument == "--serve") {
        println!("The tables of planners in many worlds are driven by `npm run bench:worlds`.");
        return;
    }
    let mut last: Option<(Json, PlanningWorld)> = None;
    for line in std::io::stdin().lock().lines() {
        let job: Json = serde_json::from_str(&line.expect("standard input is text")).expect("a job is JSON");
        let reply = if job["read"].is_array() { read_files(&job) } else { reply_to(&job, &mut last) };
        println!("{}", reply.unwrap_or_else(|error| json!({ "error": error.to_string() })));
        std::io::stdout().flush().expect("standard output can be written");
    }
}

/// What files say, and the median of the times that it takes to read them from memory.
fn read_files(job: &Json) -> Result<Json, Failure> {
    let names: Vec<&str> = job["read"].as_array().into_iter().flatten().filter_map(Json::as_str).collect();
    let contents = names.iter().map(std::fs::read).collect::<Result<Vec<_>, _>>()?;
    let files: Vec<File> = names.iter().zip(&contents).map(|(name, bytes)| File { name, bytes }).collect();
    let options = json::read(&job["options"])?;
    let mut times = Vec::new();
    let world = loop {
        let timed = Timed::begin();
        let world = read(&files, &options)?;
        times.push(timed.seconds());
        if times.len() as u64 >= job["times"].as_u64().unwrap_or(1) {
            break world;
        }
    };
    times.sort_by(f64::total_cmp);
    let scenario: Json = serde_json::from_str(&world.scenario.to_json_string())?;
    let cells = world.grid.as_ref().map(|grid| cells(grid, job["options"]["unknown"] == "free"));
    let seconds = times[times.len() / 2];
    Ok(json!({ "seconds": seconds, "report": world.report, "scenario": scenario, "grid": cells }))
}

/// The cells of a grid from its lowest row, 1 for what is an obstacle; the lower left corner, and the sides of the cell there.
fn cells(grid: &Grid, unknown_is_free: bool) -> Json {
    let digit = |cell: &Cell| match cell {
        Cell::Free => '0',
        Cell::Unknown if unknown_is_free => '0',
        Cell::Unknown | Cell::Occupied => '1',
    };
    let rows: Vec<String> =
        grid.cells().chunks(grid.width()).rev().map(|row| row.iter().map(digit).collect()).collect();
    let height = grid.height() as f64;
    let [origin, right, up] = [(0.0, height), (1.0, height), (0.0, height - 1.0)].map(|(x, y)| grid.corner(x, y));
    let resolution = grid.resolution();
    json!({ "rows": rows, "resolution": resolution, "origin": origin, "sides": [right - origin, up - origin] })
}

fn reply_to(job: &Json, last: &mut Option<(Json, PlanningWorld)>) -> Result<Json, Failure> {
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
    if job["path"].is_array() {
        let path: Vec<Vec<f64>> = serde_json::from_value(job["path"].clone())?;
        return Ok(json!({ "why": fault_of(world, query, path)? }));
    }
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

/// Why a path of another program is not valid; `None` if it is.
fn fault_of(world: &PlanningWorld, query: Option<&str>, path: Vec<Vec<f64>>) -> Result<Option<String>, Failure> {
    let request = Request { query: query.map(str::to_owned), ..Request::default() };
    let unsolved = run::start(world, &request.for_robot(world.scenario().robot())?)?.result();
    let inspector = Inspector::new(world);
    let lengths =
        path.windows(2).map(|pair| inspector.distance(&pair[0], &pair[1])).collect::<Result<Vec<f64>, _>>()?;
    let (status, length) = (Status::Solved, lengths.iter().sum());
    let claimed = ResultDocument { status, reason: None, explanation: None, path, length, ..unsolved };
    Ok(match verify(world.scenario(), &claimed)? {
        Verdict::Invalid { why } => Some(why),
        Verdict::Valid { .. } => None,
    })
}

/// A piece of work that has begun.
struct Timed {
    spent: f64,
    entered: Instant,
}

impl Timed {
    fn begin() -> Self {
        Self { spent: seconds(), entered: Instant::now() }
    }

    /// Of the processor; its clock is too coarse for short work.
    fn seconds(&self) -> f64 {
        let wall = self.entered.elapsed().as_secs_f64();
        if wall < COARSE { wall } else { seconds() - self.spent }
    }
}

/// One run, from its set-up to its path.
fn outcome(world: &PlanningWorld, options: &Options, limit: f64) -> Result<Json, Error> {
    let timed = Timed::begin();
    let mut run = start(world.clone(), options)?;
    let (mut longest, mut spent) = (0.0f64, timed.seconds());
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
        spent = timed.seconds();
        longest = longest.max(slowest.min(spent - before));
        if first.is_none() && !run.raw_path().is_empty() {
            first = Some(spent);
        }
    }
    run.finish();
    let spent = timed.seconds();
    let (result, stats) = (run.result(), run.stats());
    let is_valid = result.status == Status::Solved && verify(world.scenario(), &result)?.is_valid();
    Ok(json!({
        "status": result.status.as_str(), "seconds": spent, "first": first, "length": result.length, "longest": longest,
        "valid": is_valid, "iterations": stats.iterations, "vertices": stats.vertices,
        "evaluations": stats.clearance_evaluations, "motions": stats.motion_checks,
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
