//! `planarium nearest`: the configurations of a list that are nearest to a target, with a clock.

use crate::Answer;
use crate::arguments::Nearest;
use crate::{files, npy};
use planarium::Error;
use planarium::error::Code;
use planarium::inspect::Inspector;
use planarium::json::Node;
use planarium::neighbours::{self, Neighbours, index, recall};
use planarium::run::Value;
use planarium::scenario::Scenario;
use std::time::{Duration, Instant};

/// A question is repeated for so long, or so often, whichever comes first: one alone is over before a clock has moved.
const MEASURED: Duration = Duration::from_millis(50);
const REPEATS: usize = 1001;

/// Finds and prints; yes, always.
pub fn nearest(arguments: &Nearest) -> Answer {
    if arguments.file == "-" && arguments.configurations.as_deref() == Some("-") {
        let sentence = "scenario and configurations cannot both come from standard input";
        return Err(Error::new(Code::Usage, "", sentence));
    }
    let scenario = Scenario::parse(&files::read(&arguments.file)?)?;
    let rows = rows(arguments, &scenario)?;
    let metric = arguments.metric.iter().map(|word| ("metric".to_owned(), Value::Text(word.clone())));
    let set = arguments.set.iter().map(|(key, value)| (key.clone(), Value::from_text(value)));
    let parameters: Vec<_> = metric.chain(set).collect();

    let mut held = index(&scenario, Some(&arguments.index), &parameters)?;
    let started = Instant::now();
    held.add(&rows)?;
    let build_seconds = started.elapsed().as_secs_f64();
    let ask = |held: &dyn Neighbours| match arguments.within {
        Some(radius) => held.within(&arguments.target, radius),
        None => held.k_nearest(&arguments.target, arguments.k.unwrap_or(1)),
    };
    let answer = ask(&*held)?;
    let query_seconds = median_seconds(|| ask(&*held).map(drop))?;

    let is_exact = neighbours::index_info(Some(&arguments.index))?.is_exact;
    let recalled = if is_exact {
        None
    } else {
        let metric: Vec<_> = parameters.into_iter().filter(|(name, _)| name == "metric").collect();
        let mut scan = index(&scenario, Some("linear"), &metric)?;
        scan.add(&rows)?;
        Some(recall(&answer.neighbours, &ask(&*scan)?.neighbours))
    };
    let indices: Vec<f64> = answer.neighbours.iter().map(|neighbour| f64::from(neighbour.vertex.0)).collect();
    let distances: Vec<f64> = answer.neighbours.iter().map(|neighbour| neighbour.distance).collect();
    let document = Node::object(vec![
        ("scenario", Some(Node::text(scenario.name()))),
        ("index", Some(Node::text(&arguments.index))),
        ("metric", arguments.metric.as_deref().map(Node::text)),
        ("configurations", Some(Node::Number(held.len() as f64))),
        ("target", Some(Node::numbers(&arguments.target))),
        ("indices", Some(Node::numbers(&indices))),
        ("distances", Some(Node::numbers(&distances))),
        ("visited", Some(Node::Number(answer.visited as f64))),
        ("recall", recalled.map(Node::Number)),
        ("build_seconds", Some(Node::Number(build_seconds))),
        ("query_seconds", Some(Node::Number(query_seconds))),
    ]);
    files::print(&document.to_json())?;
    let told = format!(
        "{} of {} configurations, {} visited, {:.3} us a question after {:.3} ms",
        indices.len(),
        held.len(),
        answer.visited,
        1e6 * query_seconds,
        1e3 * build_seconds
    );
    files::say(&told);
    Ok(true)
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
fn rows(arguments: &Nearest, scenario: &Scenario) -> Result<Vec<f64>, Error> {
    let Some(name) = &arguments.configurations else {
        return Inspector::new(scenario).samples(arguments.samples.unwrap_or(1000), arguments.seed, arguments.free);
    };
    let dimension = Inspector::new(scenario).dimension();
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
    let wrong =
        |pointer: &str, what: &str| Error::new(Code::WrongType, pointer, format!("configurations must be {what}"));
    let Node::Array(list) = Node::parse(&text)? else { return Err(wrong("/rows", "an array of arrays of numbers")) };
    let mut rows = Vec::with_capacity(list.len() * dimension);
    for (i, row) in list.into_iter().enumerate() {
        let Node::Array(row) = row else { return Err(wrong(&format!("/rows/{i}"), "arrays of numbers")) };
        if row.len() != dimension {
            return Err(Error::new(Code::WrongDimension, format!("/rows/{i}"), is_other(row.len()).message()));
        }
        for (j, number) in row.into_iter().enumerate() {
            let Node::Number(number) = number else { return Err(wrong(&format!("/rows/{i}/{j}"), "numbers")) };
            rows.push(number);
        }
    }
    Ok(rows)
}
