//! `planarium nearest`: the configurations nearest to a target, with the time of a query.

use crate::arguments::{Answer, Given, coordinate};
use crate::files;
use clap::Args;
use planarium::error::Code;
use planarium::run::Value;
use planarium::run::inspect::Inspector;
use planarium::run::neighbours::{IndexOptions, Neighbours, index, recall};
use planarium::world::PlanningWorld;
use planarium::{Error, json};
use planarium_formats::npy;
use serde::Serialize;
use std::time::{Duration, Instant};

/// A query is repeated for this duration or this often, whichever comes first: a single one is too short for the clock.
const MEASURED: Duration = Duration::from_millis(50);
const REPEATS: usize = 1001;

#[derive(Args)]
#[command(after_help = "\
Prints {\"indices\", \"distances\", \"visited\", \"build_seconds\", \"query_seconds\", ...}, nearest first, ties by
index; of a forest, and of kd-tree-unwrapped, which takes angles as plain numbers, also \"recall\", the fraction of the
true nearest that it found. query_seconds is the median of many repetitions.

Examples:
  planarium nearest arm.json --samples 100000 --target 3.14,0 --k 10
  planarium nearest arm.json --configurations list.npy --target 3.14,0 --k 5 --index linear --metric naive
  planarium nearest arm.json --samples 20000 --target 0,0 --k 20 --index forest --set trees=4
  planarium nearest arm.json --samples 2000 --target 3.14,0 --k 10 --index kd-tree-unwrapped")]
pub struct Arguments {
    /// The scenario, a JSON file; - reads it from standard input
    file: String,

    /// The configurations: JSON, an array of arrays of numbers, or a NumPy array file; - reads them from standard input
    #[arg(long, value_name = "LIST", conflicts_with_all = ["samples", "seed", "free"])]
    configurations: Option<String>,

    /// The number of configurations drawn uniformly [default: 1000]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    samples: Option<u64>,

    #[command(flatten)]
    given: Given,

    /// Draw only configurations that are free
    #[arg(long)]
    free: bool,

    /// The configuration whose neighbours are searched for
    #[arg(long, value_name = "Q1,Q2,...", required = true, allow_hyphen_values = true, value_delimiter = ',',
          value_parser = coordinate)]
    target: Vec<f64>,

    /// The number of neighbours [default: 1]
    #[arg(long, value_name = "K", allow_negative_numbers = true, conflicts_with = "within")]
    k: Option<usize>,

    /// All neighbours within this distance, instead of a number of them
    #[arg(long, value_name = "RADIUS", allow_negative_numbers = true)]
    within: Option<f64>,

    /// The index: linear, kd-tree, kd-tree-unwrapped or forest
    #[arg(long, value_name = "ID", default_value = "kd-tree")]
    index: String,

    /// The metric of an arm: sum, euclidean or naive [default: sum]
    #[arg(long, value_name = "NAME")]
    metric: Option<String>,
}

/// The printed document.
#[derive(Serialize)]
struct Found<'a> {
    scenario: &'a str,
    index: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    metric: Option<&'a str>,
    configurations: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    seed: Option<u64>,
    target: &'a [f64],
    indices: Vec<u32>,
    distances: Vec<f64>,
    visited: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    recall: Option<f64>,
    build_seconds: f64,
    query_seconds: f64,
}

/// Finds and prints the neighbours; always true.
pub fn nearest(arguments: &Arguments) -> Answer {
    let list = arguments.configurations.as_deref().map(|name| ("configurations", name));
    let world = PlanningWorld::new(files::scenario(&arguments.file, list)?);
    let rows = rows(arguments, &Inspector::new(&world))?;
    let parameters = arguments.given.parameters("metric", arguments.metric.clone().map(Value::Text));

    let options = IndexOptions::read(Some(&arguments.index), &parameters)?;
    let mut held = index(&world, &options)?;
    let started = Instant::now();
    held.add(&rows)?;
    let build_seconds = started.elapsed().as_secs_f64();
    let ask = |held: &dyn Neighbours| {
        let answer = match arguments.within {
            Some(radius) => held.within(&arguments.target, radius),
            None => held.k_nearest(&arguments.target, arguments.k.unwrap_or(1)),
        };
        answer.map_err(name_target)
    };
    let answer = ask(&*held)?;
    let query_seconds = median_seconds(|| ask(&*held).map(drop))?;

    let recalled = if options.is_exact() {
        None
    } else {
        let mut scan = index(&world, &IndexOptions::Linear(options.measuring()))?;
        scan.add(&rows)?;
        Some(recall(&answer.neighbours, &ask(&*scan)?.neighbours))
    };
    let document = Found {
        scenario: world.scenario().name(),
        index: &arguments.index,
        metric: arguments.metric.as_deref(),
        configurations: held.len(),
        seed: arguments.configurations.is_none().then_some(arguments.given.seed),
        target: &arguments.target,
        indices: answer.neighbours.iter().map(|neighbour| neighbour.vertex.0).collect(),
        distances: answer.neighbours.iter().map(|neighbour| neighbour.distance).collect(),
        visited: answer.visited,
        recall: recalled,
        build_seconds,
        query_seconds,
    };
    files::print(&json::to_string(&document))?;
    let (found, count, visited) = (answer.neighbours.len(), held.len(), answer.visited);
    let [query, build] = [1e6 * query_seconds, 1e3 * build_seconds];
    files::say(&format!(
        "{found} of {count} configurations, {visited} visited, {query:.3} us a query after {build:.3} ms"
    ));
    Ok(true)
}

/// The same error, about the configuration that is named `target` on the command line.
fn name_target(error: Error) -> Error {
    match error.pointer().strip_prefix("/q") {
        Some(rest) => Error::new(error.code(), format!("/target{rest}"), error.message()),
        None => error,
    }
}

/// The median time of many repetitions.
fn median_seconds(work: impl Fn() -> Result<(), Error>) -> Result<f64, Error> {
    let (begun, mut seconds) = (Instant::now(), Vec::new());
    while seconds.len() < REPEATS && (seconds.is_empty() || begun.elapsed() < MEASURED) {
        let started = Instant::now();
        work()?;
        seconds.push(started.elapsed().as_secs_f64());
    }
    seconds.sort_by(f64::total_cmp);
    Ok(seconds[seconds.len() / 2])
}

/// The configurations: those of the list, or random ones.
fn rows(arguments: &Arguments, inspector: &Inspector) -> Result<Vec<f64>, Error> {
    let Some(name) = &arguments.configurations else {
        return inspector.samples(arguments.samples.unwrap_or(1000), arguments.given.seed, arguments.free);
    };
    let dimension = inspector.dimension();
    let bytes = files::read_bytes(name)?;
    let other_width = |pointer: String, width: usize| {
        let sentence = format!("a configuration of this robot has {dimension} numbers, not {width}");
        Err(Error::new(Code::WrongDimension, pointer, sentence))
    };
    let unreadable = |why: &str| Error::new(Code::File, "", format!("{name:?} {why}"));
    if bytes.starts_with(npy::MAGIC) {
        let table = npy::read(&bytes).map_err(|why| unreadable(&format!("cannot be read: {why}")))?;
        return if table.width == dimension { Ok(table.numbers) } else { other_width("/rows".into(), table.width) };
    }
    let text = String::from_utf8(bytes).map_err(|_| unreadable("contains neither JSON nor a NumPy array"))?;
    let list: Vec<Vec<f64>> = json::read(&json::parse(&text)?).map_err(|error| error.under("/rows"))?;
    if let Some(i) = list.iter().position(|row| row.len() != dimension) {
        return other_width(format!("/rows/{i}"), list[i].len());
    }
    Ok(list.concat())
}
