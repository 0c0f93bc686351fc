//! `planarium optimum`: the shortest path of a query, and how much longer that of a result is.

use crate::arguments;
use crate::output::{Kind, Outputs};
use crate::{Answer, files};
use planarium::error::Code;
use planarium::optimum::{self, Optimum};
use planarium::path::{self, LengthMeasure, ResultDocument, Verdict};
use planarium::run::{Status, Value};
use planarium::scenario::Scenario;
use planarium::{Error, json};
use serde::Serialize;

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
pub fn optimum(arguments: &arguments::Optimum) -> Answer {
    let inputs = [Some(&*arguments.file), arguments.result.as_deref()];
    let mut outputs = Outputs::beside(inputs.into_iter().flatten(), arguments.force);
    let out = outputs.add(arguments.out.as_deref(), Kind::OPTIMUM)?;
    let other = arguments.result.as_deref().map(|name| ("result", name));
    let scenario = files::scenario(&arguments.file, other)?;
    let result = arguments.result.as_deref().map(|name| ResultDocument::parse(&files::read(name)?)).transpose()?;
    if let Some(result) = result.as_ref().filter(|result| result.scenario != scenario.name()) {
        let sentence = format!("the result is of the scenario {:?}, not {:?}", result.scenario, scenario.name());
        return Err(Error::new(Code::InvalidResult, "/scenario", sentence));
    }
    if let Some((asked, result)) = arguments.query.as_deref().zip(result.as_ref())
        && asked != result.query
    {
        let sentence = format!("the result is of the query {:?}, not {asked:?}", result.query);
        return Err(Error::new(Code::InvalidResult, "/query", sentence));
    }
    if let Some(result) = &result {
        check(&scenario, result)?;
    }
    let query = arguments.query.as_deref().or(result.as_ref().map(|result| &*result.query));
    let measured = result.as_ref().and_then(|result| result.length_measure);
    let own = (measured == Some(LengthMeasure::EuclideanOfJoints)).then(|| "euclidean".to_owned());
    let metric: Vec<_> =
        arguments.metric.clone().or(own).into_iter().map(|name| ("metric".to_owned(), Value::Text(name))).collect();
    let optimum = optimum::optimum(&scenario, query, &metric)?;
    if let Some(measured) = measured.filter(|&measured| measured != optimum.length_measure) {
        let [measured, own] = [measured, optimum.length_measure].map(|measure| json::to_string(&measure));
        let sentence = format!("the length of the result measures {measured}, that of the shortest path {own}");
        return Err(Error::new(Code::InvalidResult, "/length_measure", sentence));
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
