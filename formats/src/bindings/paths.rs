//! Paths read and written for JavaScript.

use super::content;
use super::options::options_of;
use super::thrown::Thrown;
use crate::{
    Angles, File, MAX_WAYPOINTS, PathForm, PathOptions, PathRead, PathRows, WriteOptions, read_path, write_path,
};
use js_sys::{Array, Float64Array, Uint8Array};
use planarium::scenario::{Robot, Scenario};
use planarium::{Error, error::Code, json};
use serde::Deserialize;
use serde_json::Value;
use wasm_bindgen::prelude::*;

/// What reading a path takes beside its file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReadRequest {
    /// The document of the scenario.
    scenario: Value,
    #[serde(default)]
    angles: Option<Angles>,
}

/// What writing a path takes beside its numbers.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WriteRequest {
    /// The document of the scenario.
    scenario: Value,
    form: PathForm,
    /// The name of the query.
    #[serde(default)]
    query: String,
    #[serde(default, rename = "frameId")]
    frame_id: Option<String>,
}

/// Reads a path for the robot of a scenario: the name and the content of its file and the options as JSON. Returns the number of
/// numbers of a configuration and the report, as JSON, and the waypoints one after the other.
///
/// # Errors
/// JSON of an error.
#[wasm_bindgen(js_name = readPathFile)]
pub fn read_path_file(name: &str, bytes: Uint8Array, options: &str) -> Result<Array, JsValue> {
    let request = options_of::<ReadRequest>(options);
    let prepared = request.and_then(|request| Ok((scenario_of(&request.scenario)?, request.angles)));
    let (scenario, angles) = prepared.map_err(|error| Thrown::of(&error).value())?;
    let bytes = content(bytes.into());
    let file = File { name, bytes: &bytes };
    let PathRead { waypoints, report } = read_path(file, scenario.robot(), scenario.frame(), &PathOptions { angles })
        .map_err(|error| Thrown::in_file(&error).value())?;
    let dimension = scenario.robot().dimension();
    let text = format!(r#"{{"dimension":{dimension},"report":{}}}"#, json::to_string(&report));
    let numbers = Float64Array::from(&waypoints.concat()[..]);
    Ok(Array::of2(&text.into(), &numbers))
}

/// Writes a path: its configurations one after the other, or if it `is_timed` its states, which are rows of the time, the
/// configuration, the velocity and the acceleration; the number of numbers of a configuration, if not that of the robot; and the
/// options as JSON. Returns the content of the file.
///
/// # Errors
/// JSON of an error.
#[wasm_bindgen(js_name = writePathFile)]
pub fn write_path_file(
    numbers: &Float64Array,
    is_timed: bool,
    dimension: Option<u32>,
    options: &str,
) -> Result<Uint8Array, JsValue> {
    let request = options_of::<WriteRequest>(options);
    let prepared = request.and_then(|request| Ok((scenario_of(&request.scenario)?, request)));
    let (scenario, WriteRequest { form, query, frame_id, .. }) =
        prepared.map_err(|error| Thrown::of(&error).value())?;
    let rows = dimension_of(&scenario, dimension)
        .and_then(|dimension| rows(dimension, query, numbers, is_timed))
        .map_err(|error| Thrown::of(&error).value())?;
    let written = write_path(&scenario, &rows, form, &WriteOptions { frame_id });
    written.map(|bytes| Uint8Array::from(&bytes[..])).map_err(|error| Thrown::in_file(&error).value())
}

fn scenario_of(document: &Value) -> Result<Scenario, Error> {
    Scenario::read(document).map_err(|error| error.under("/scenario"))
}

/// The number of numbers of a configuration: that of the robot, or of a disc with its heading 3.
fn dimension_of(scenario: &Scenario, given: Option<u32>) -> Result<usize, Error> {
    let (robot, own) = (scenario.robot(), scenario.robot().dimension());
    match given.map_or(own, |given| given as usize) {
        3 if matches!(robot, Robot::Disc(_)) => Ok(3),
        dimension if dimension == own => Ok(own),
        dimension => {
            let sentence = format!("a configuration of the robot {} has {own} numbers, not {dimension}", robot.kind());
            Err(Error::new(Code::WrongDimension, "/path/dimension", sentence))
        }
    }
}

/// The rows of numbers that follow each other.
fn rows(dimension: usize, query: String, numbers: &Float64Array, is_timed: bool) -> Result<PathRows, Error> {
    let (width, name) = if is_timed { (1 + 3 * dimension, "states") } else { (dimension, "configurations") };
    let count = numbers.length() as usize;
    if !count.is_multiple_of(width) {
        let sentence = format!("{name} has {count} numbers, which are no rows of {width}");
        return Err(Error::new(Code::WrongDimension, format!("/path/{name}"), sentence));
    }
    if count / width > MAX_WAYPOINTS {
        let sentence = format!("{name} has {} rows; at most {MAX_WAYPOINTS} are written", count / width);
        return Err(Error::new(Code::TooLarge, format!("/path/{name}"), sentence));
    }
    let numbers = numbers.to_vec();
    let rows = numbers.chunks_exact(width);
    Ok(if is_timed {
        let row =
            |state: &[f64]| (state[0], state[1..=dimension].to_vec(), state[1 + dimension..=2 * dimension].to_vec());
        PathRows::timed(query, rows.map(row))
    } else {
        PathRows { query, configurations: rows.map(<[f64]>::to_vec).collect(), timing: None }
    })
}
