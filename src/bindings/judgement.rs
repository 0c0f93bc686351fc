//! The judge of paths of any origin, for JavaScript.

use super::arguments::{configurations, fields, whole_rows};
use super::records::object;
use super::scenario::Scenario;
use super::types::{Configurations, JsPathJudgement, JudgeOptions};
use crate::Error;
use crate::error::Code;
use crate::path::{self, MAX_WAYPOINTS};
use js_sys::{Float64Array, Uint8Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Scenario {
    /// Judges a path of any origin: waypoints alone, as rows of `dimension` numbers or as configurations, at most 2,000,000.
    /// Between two of them every coordinate changes at a constant rate, angles the short way round. It says whether all of it is
    /// free, by the proof of the planners, or where it first touches what; the smallest clearance of a free path and where; and
    /// of a car the turns that it cannot drive. The queries of the scenario do not count. It takes some microseconds for each
    /// waypoint: judge more than some thousand in a worker.
    /// @throws {PlanariumError} `out-of-range` for a path without waypoints, a coordinate too large and a `driveTolerance` below
    /// 0; `too-large`, `wrong-dimension`, `not-finite`, `wrong-type`, `unknown-field`; `unsupported` for `arcs` of a robot
    /// without a heading
    pub fn judge(&self, path: &Configurations, options: Option<JudgeOptions>) -> Result<JsPathJudgement, Error> {
        let mut fields = fields(options)?;
        let defaults = path::JudgeOptions::default();
        let options = path::JudgeOptions {
            arcs: fields.take("arcs")?.unwrap_or(defaults.arcs),
            drive_tolerance: fields.take("drive_tolerance")?.unwrap_or(defaults.drive_tolerance),
        };
        fields.finish("arcs, driveTolerance")?;
        let dimension = self.scenario().robot().dimension();
        refuse_length(path, dimension)?;
        let numbers = whole_rows(configurations(path, dimension, "path")?, dimension, "path")?;
        let waypoints: Vec<Vec<f64>> = numbers.chunks(dimension).map(<[f64]>::to_vec).collect();
        drop(numbers);
        let judgement = path::judge(&self.world, &waypoints, &options)?;
        Ok(object(&judgement).unchecked_into())
    }
}

/// Refuses a path with too many numbers before they are copied.
fn refuse_length(path: &JsValue, dimension: usize) -> Result<(), Error> {
    let numbers = path.dyn_ref::<Float64Array>().map(Float64Array::length);
    let bytes = path.dyn_ref::<Uint8Array>().map(Uint8Array::length);
    let waypoints = numbers.or(bytes).unwrap_or(0) as usize / dimension;
    if waypoints <= MAX_WAYPOINTS {
        return Ok(());
    }
    let sentence = format!("the path has {waypoints} waypoints; at most {MAX_WAYPOINTS} are judged");
    Err(Error::new(Code::TooLarge, "/path", sentence))
}
