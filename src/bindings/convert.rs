//! Conversions between JavaScript's values and ours.

use crate::error::{Code, Error, Number};
use crate::geometry::Point;
use crate::ik::{SolverOptions, Target};
use crate::json::{read, read_tree};
use crate::run::{Options, Value};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value as Json};
use serde_wasm_bindgen::{Deserializer, Serializer};
use wasm_bindgen::prelude::*;

/// An `Error` with `code` and `pointer`.
impl From<Error> for JsValue {
    fn from(error: Error) -> Self {
        let thrown = JsValue::from(js_sys::Error::new(error.message()));
        for (key, value) in [("code", error.code().as_str()), ("pointer", error.pointer())] {
            // Setting a property of a fresh object cannot fail.
            let _ = js_sys::Reflect::set(&thrown, &key.into(), &value.into());
        }
        thrown
    }
}

/// A whole number from 0 to 2^53 - 1.
pub(super) fn count(value: f64, name: &str) -> Result<u64, Error> {
    if value >= 0.0 && value <= crate::random::MAX_SEED as f64 && value == value.trunc() {
        return Ok(value as u64);
    }
    let code = if value.is_finite() { Code::OutOfRange } else { Code::NotFinite };
    let sentence = format!("{name} must be a whole number from 0 to 2^53 - 1, not {}", Number(value));
    Err(Error::new(code, format!("/{name}"), sentence))
}

/// A cursor into `length` rows.
pub(super) fn cursor(value: f64, length: usize) -> Result<usize, Error> {
    let row = count(value, "row")?;
    if row > length as u64 {
        let sentence = format!("row {row} lies behind the last of {length} rows");
        return Err(Error::new(Code::OutOfRange, "/row", sentence));
    }
    Ok(row as usize)
}

/// A count that saturates: more than this machine can count is beyond every limit too.
pub(super) fn size(value: f64, name: &str) -> Result<usize, Error> {
    count(value, name).map(|count| usize::try_from(count).unwrap_or(usize::MAX))
}

/// 16 hexadecimal digits.
pub(super) fn digits(fingerprint: u64) -> String {
    format!("{fingerprint:016x}")
}

/// A record as a JavaScript object of plain values.
pub(super) fn record<T: Serialize + ?Sized>(value: &T) -> JsValue {
    value.serialize(&Serializer::json_compatible()).expect("a record has a form in JavaScript")
}

/// The fields of an object of plain values.
pub(super) fn fields(object: JsValue) -> Result<Map<String, Json>, Error> {
    match read_tree(Deserializer::from(object)) {
        (Ok(Json::Object(fields)), _) => Ok(fields),
        (Ok(_), _) => Err(Error::new(Code::WrongType, "", "options must be an object")),
        (Err(error), pointer) => Err(Error::new(Code::InvalidJson, pointer, error.to_string())),
    }
}

/// Removes the field and reads it, if present.
fn take<T: DeserializeOwned>(fields: &mut Map<String, Json>, name: &str) -> Result<Option<T>, Error> {
    let value = fields.remove(name);
    value.map(|value| read(&value)).transpose().map_err(|error| error.under(&format!("/{name}")))
}

/// Options by name.
type Given = Vec<(String, Value)>;

/// The remaining fields, as options by name.
fn parameters(fields: Map<String, Json>) -> Given {
    fields.iter().map(|(name, value)| (name.clone(), Value::from(value))).collect()
}

/// The field of this name, if any, and the remaining fields as options by name.
pub(super) fn split<T: DeserializeOwned>(object: JsValue, name: &str) -> Result<(Option<T>, Given), Error> {
    let mut fields = fields(object)?;
    Ok((take(&mut fields, name)?, parameters(fields)))
}

/// The options of a run.
pub(super) fn options(object: JsValue) -> Result<Options, Error> {
    let mut fields = fields(object)?;
    Ok(Options {
        planner: take(&mut fields, "algorithm")?,
        query: take(&mut fields, "query")?,
        seed: take(&mut fields, "seed")?.unwrap_or(0),
        parameters: parameters(fields),
    })
}

/// The options of inverse kinematics.
pub(super) fn reach_options(object: JsValue) -> Result<SolverOptions, Error> {
    let mut fields = fields(object)?;
    let Some([x, y]) = take::<[f64; 2]>(&mut fields, "target")? else {
        return Err(Error::new(Code::MissingField, "/target", "the target is missing: [x, y]"));
    };
    Ok(SolverOptions {
        target: Target { point: Point::new(x, y), orientation: take(&mut fields, "orientation")? },
        method: take(&mut fields, "method")?,
        start: take(&mut fields, "start")?,
        seed: take(&mut fields, "seed")?.unwrap_or(0),
        parameters: parameters(fields),
    })
}
