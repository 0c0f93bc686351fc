//! `planarium nearest`: the configurations of a list that are nearest to a target, with a clock.

use crate::arguments::Nearest;
use crate::{Answer, files, npy};
use planarium::error::Code;
use planarium::run::Value;
use planarium::run::inspect::Inspector;
use planarium::run::neighbours::{self, Neighbours, index, recall};
use planarium::scenario::Scenario;
use planarium::world::PlanningWorld;
use planarium::{Error, json};
use serde::Serialize;
use std::time::{Duration, Instant};

/// A question is repeated for so long, or so often, whichever comes first: one alone is over before a clock has moved.
const MEASURED: Duration = Duration::from_millis(50);
const REPEATS: usize = 1001;

/// What is printed.
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

/// Finds and prints; yes, always.
pub fn nearest(arguments: &Nearest) -> Answer {
    if arguments.file == "-" && arguments.configurations.as_deref() == Some("-") {
        let sentence = "scenario and configurations cannot both come from standard input";
        return Err(Error::new(Code::Usage, "", sentence));
    }
    let world = PlanningWorld::new(Scenario::parse(&files::read(&arguments.file)?)?);
    let rows = rows(arguments, &Inspector::new(&world))?;
    let metric = arguments.metric.iter().map(|word| ("metric".to_owned(), Value::Text(word.clone())));
    let set = arguments.set.iter().map(|(key, value)| (key.clone(), Value::from_text(value)));
    let parameters: Vec<_> = metric.chain(set).collect();

    let mut held = index(&world, Some(&arguments.index), &parameters)?;
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

    let is_exact = neighbours::IndexId::of(Some(&arguments.index))?.info().is_exact;
    let recalled = if is_exact {
        None
    } else {
        let metric: Vec<_> = parameters.into_iter().filter(|(name, _)| name == "metric").collect();
        let mut scan = index(&world, Some("linear"), &metric)?;
        scan.add(&rows)?;
        Some(recall(&answer.neighbours, &ask(&*scan)?.neighbours))
    };
    let document = Found {
        scenario: world.scenario().name(),
        index: &arguments.index,
        metric: arguments.metric.as_deref(),
        configurations: held.len(),
        seed: arguments.configurations.is_none().then_some(arguments.seed),
        target: &arguments.target,
        indices: answer.neighbours.iter().map(|neighbour| neighbour.vertex.0).collect(),
        distances: answer.neighbours.iter().map(|neighbour| neighbour.distance).collect(),
        visited: answer.visited,
        recall: recalled,
        build_seconds,
        query_seconds,
    };
    files::print(&json::to_string(&document))?;
    let told = format!(
        "{} of {} configurations, {} visited, {:.3} us a question after {:.3} ms",
        answer.neighbours.len(),
        held.len(),
        answer.visited,
        1e6 * query_seconds,
        1e3 * build_seconds
    );
    files::say(&told);
    Ok(true)
}

/// The same error, of the configuration that is called `target` here.
fn name_target(error: Error) -> Error {
    match error.pointer().strip_prefix("/q") {
        Some(rest) => Error::new(error.code(), format!("/target{rest}"), error.message()),
        None => error,
    }
}

/// How long it takes, in the middle of many times.
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

/// The configurations: of the list, or drawn.
fn rows(arguments: &Nearest, inspector: &Inspector) -> Result<Vec<f64>, Error> {
    let Some(name) = &arguments.configurations else {
        return inspector.samples(arguments.samples.unwrap_or(1000), arguments.seed, arguments.free);
    };
    let dimension = inspector.dimension();
    let bytes = files::read_bytes(name)?;
    let is_other = |width: usize| {
        let sentence = format!("a configuration of this robot has {dimension} numbers, not {width}");
        Error::new(Code::WrongDimension, "/rows", sentence)
    };
    if npy::is_npy(&bytes) {
        let table =
            npy::read(&bytes).map_err(|why| Error::new(Code::File, "", format!("{name:?} is not read: {why}")))?;
        return if table.width == dimension { Ok(table.numbers) } else { Err(is_other(table.width)) };
    }
    let text = String::from_utf8(bytes)
        .map_err(|_| Error::new(Code::File, "", format!("{name:?} holds neither JSON nor an array of NumPy")))?;
    let list: Vec<Vec<f64>> = json::read(&json::parse(&text)?).map_err(|error| error.under("/rows"))?;
    if let Some(i) = list.iter().position(|row| row.len() != dimension) {
        return Err(Error::new(Code::WrongDimension, format!("/rows/{i}"), is_other(list[i].len()).message()));
    }
    Ok(list.concat())
}
