//! `planarium optimum`: the shortest path of a query, and how much longer that of a result is.

use crate::arguments::Answer;
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use crate::world::{self, WorldOptions};
use clap::Args;
use planarium::error::Code;
use planarium::optimum::{self, Optimum};
use planarium::options::Options;
use planarium::path::{self, LengthMeasure, ResultDocument, Verdict};
use planarium::run::{Status, Value};
use planarium::scenario::Scenario;
use planarium::{Error, json};
use serde::Serialize;

#[derive(Args)]
#[command(after_help = "\
Prints {\"length\", \"path\", \"method\", \"exact\", \"resolution\", ...}. Of a disc or a point, the length is the infimum of all free
paths, and null if there is none. Of an arm of two joints, and of a rigid body whose query keeps its angle, it is the length of a proven path on
a grid, made shorter by shortcuts. With a result document it prints as well by how much its path is longer: \"gap\", in percent.
Exit codes: 0 there is a path; 1 none was found; 2 the input is wrong.

Examples:
  planarium optimum discs.json --query across
  planarium plan discs.json --planner rrt-star | planarium optimum discs.json --result -")]
pub struct Arguments {
    /// The scenario, a JSON file, or a map (see `planarium import`); - reads it from standard input
    file: String,

    /// The query, by name [default: that of the result, else the first of the scenario]
    #[arg(long, value_name = "NAME")]
    query: Option<String>,

    /// The metric of an arm: sum, euclidean or naive [default: sum]
    #[arg(long, value_name = "NAME")]
    metric: Option<String>,

    /// A result document to compare; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    result: Option<String>,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

/// The printed document.
#[derive(Serialize)]
struct Compared {
    #[serde(flatten)]
    optimum: Optimum,
    /// By how much the path of the result is longer, in percent; null if either has no path.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap: Option<Option<f64>>,
}

/// Prints the shortest path; true if there is one.
pub fn optimum(arguments: &Arguments) -> Answer {
    let inputs = [Some(&*arguments.file), arguments.result.as_deref()];
    let (outputs, out) = arguments.destination.beside(inputs.into_iter().flatten(), Kind::OPTIMUM)?;
    let other = arguments.result.as_deref().map(|name| ("result", name));
    let scenario = world::scenario(&arguments.file, other, &arguments.world, &outputs)?;
    let result = arguments.result.as_deref().map(|name| ResultDocument::parse(&files::read(name)?)).transpose()?;
    if let Some(result) = result.as_ref().filter(|result| result.scenario != scenario.name()) {
        let sentence = format!("the result is of the scenario {:?}, not {:?}", result.scenario, scenario.name());
        return Err(Error::new(Code::InvalidResult, "/scenario", sentence).into());
    }
    if let Some((asked, result)) = arguments.query.as_deref().zip(result.as_ref())
        && asked != result.query
    {
        let sentence = format!("the result is of the query {:?}, not {asked:?}", result.query);
        return Err(Error::new(Code::InvalidResult, "/query", sentence).into());
    }
    if let Some(result) = &result {
        check(&scenario, result)?;
    }
    let query = arguments.query.as_deref().or(result.as_ref().map(|result| &*result.query));
    let measured = result.as_ref().and_then(|result| result.length_measure);
    let own = (measured == Some(LengthMeasure::EuclideanOfJoints)).then(|| "euclidean".to_owned());
    let metric = arguments.metric.clone().or(own).map(|name| ("metric".to_owned(), Value::Text(name)));
    let optimum = optimum::optimum(&scenario, query, Options::read(metric.as_slice())?)?;
    if let Some(measured) = measured.filter(|&measured| measured != optimum.length_measure) {
        let [measured, own] = [measured, optimum.length_measure].map(|measure| json::to_string(&measure));
        let sentence = format!("the length of the result measures {measured}, that of the shortest path {own}");
        return Err(Error::new(Code::InvalidResult, "/length_measure", sentence).into());
    }
    let gap = result.map(|result| {
        let length = optimum.length.filter(|_| !result.path.is_empty())?;
        (length > 0.0).then(|| 100.0 * (result.length / length - 1.0))
    });
    files::say(&message(&optimum, gap.flatten()));
    let is_found = optimum.length.is_some();
    out.write(&json::to_string(&Compared { optimum, gap }))?;
    Ok(is_found)
}

/// Refuses a result whose length cannot be compared: its path is not valid, or does not have that length.
fn check(scenario: &Scenario, result: &ResultDocument) -> Result<(), Error> {
    if result.status != Status::Solved {
        let sentence = format!("the status is {}, but there is a path", result.status.as_str());
        let is_empty = result.path.is_empty();
        return if is_empty { Ok(()) } else { Err(Error::new(Code::InvalidResult, "/path", sentence)) };
    }
    match path::verify(scenario, result)? {
        Verdict::Valid { .. } => Ok(()),
        Verdict::Invalid { why } => {
            Err(Error::new(Code::InvalidResult, "/path", format!("the result cannot be compared: {why}")))
        }
    }
}

/// The result for people.
fn message(optimum: &Optimum, gap: Option<f64>) -> String {
    let Some(length) = optimum.length else {
        let why = if optimum.exact { "there is no free path" } else { "the grid has no free path" };
        return why.to_owned();
    };
    let kind = if optimum.exact { "shortest path" } else { "short path, a reference" };
    let gap = gap.map_or(String::new(), |gap| format!("; the result is {gap:.3} % longer"));
    format!("{kind}: length {length:.6}{gap}")
}
