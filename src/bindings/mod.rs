//! The classes and functions that JavaScript sees, thin over [`crate::run`] and [`crate::inspect`]. The package wraps them once
//! more in JavaScript, where use before `init` and after `free` can be caught.
//!
//! Every count comes in as a JavaScript number and is checked; every error is an `Error` with `code` and `pointer`.

mod convert;
mod planner;
mod scenario;

pub use planner::RawPlanner;
pub use scenario::RawScenario;

use crate::random::MAX_SEED;
use wasm_bindgen::prelude::*;

/// Every planner with its parameters, as plain objects.
#[wasm_bindgen]
pub fn planners() -> Result<JsValue, JsValue> {
    convert::to_object(&crate::planner::catalogue())
}

/// Every generator with its options, as plain objects.
#[wasm_bindgen]
pub fn generators() -> Result<JsValue, JsValue> {
    convert::to_object(&crate::scenario::generate::catalogue())
}

/// A seed from the platform's entropy: a whole number from 0 to 2^53 - 1.
#[wasm_bindgen]
pub fn fresh_seed() -> Result<f64, JsValue> {
    let bits = getrandom::u64().map_err(|error| JsValue::from(js_sys::Error::new(&error.to_string())))?;
    Ok((bits & MAX_SEED) as f64)
}

/// The version of the crate.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
