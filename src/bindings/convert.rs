//! Between JavaScript's values and ours.

use crate::error::{Code, Error};
use crate::run::Value;
use crate::scenario::Node;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// The JavaScript error for ours: an `Error` with `code` and `pointer`.
pub(super) fn throw(error: Error) -> JsValue {
    let thrown = JsValue::from(js_sys::Error::new(error.message()));
    for (key, value) in [("code", error.code().as_str()), ("pointer", error.pointer())] {
        // Setting a property of a fresh object cannot fail.
        let _ = js_sys::Reflect::set(&thrown, &key.into(), &value.into());
    }
    thrown
}

/// A whole number from 0 to 2^53 - 1.
pub(super) fn count(value: f64, name: &str) -> Result<u64, JsValue> {
    if value >= 0.0 && value <= crate::random::MAX_SEED as f64 && value == value.trunc() {
        return Ok(value as u64);
    }
    let code = if value.is_finite() { Code::OutOfRange } else { Code::NotFinite };
    let sentence = format!("{name} must be a whole number from 0 to 2^53 - 1, not {value}");
    Err(throw(Error::new(code, format!("/{name}"), sentence)))
}

/// A cursor into `length` rows.
pub(super) fn cursor(value: f64, length: usize) -> Result<usize, JsValue> {
    let row = count(value, "row")?;
    if row > length as u64 {
        let sentence = format!("row {row} lies behind the last of {length} rows");
        return Err(throw(Error::new(Code::OutOfRange, "/row", sentence)));
    }
    Ok(row as usize)
}

/// A plain object (arrays, numbers, strings) of what serde can write.
pub(super) fn to_object<T: Serialize>(value: &T) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(|error| JsValue::from(js_sys::Error::new(&error.to_string())))
}

/// Name and value of every property of a plain object that is not undefined.
pub(super) fn entries(object: &JsValue) -> Result<Vec<(String, JsValue)>, JsValue> {
    let Some(object) = object.dyn_ref::<js_sys::Object>().filter(|_| !js_sys::Array::is_array(object)) else {
        return Err(throw(Error::new(Code::WrongType, "", "options must be an object")));
    };
    let listed = js_sys::Object::entries(object);
    let entries = listed.iter().map(|entry| {
        let pair: js_sys::Array = entry.unchecked_into();
        (pair.get(0).as_string().unwrap_or_default(), pair.get(1))
    });
    Ok(entries.filter(|(_, value)| !value.is_undefined()).collect())
}

/// A number, a word or a truth value.
pub(super) fn value(name: &str, value: &JsValue) -> Result<Value, JsValue> {
    if let Some(number) = value.as_f64() {
        return Ok(Value::Number(number));
    }
    if let Some(text) = value.as_string() {
        return Ok(Value::Text(text));
    }
    if let Some(yes) = value.as_bool() {
        return Ok(Value::Boolean(yes));
    }
    let sentence = format!("{name} must be a number, a word or a truth value");
    Err(throw(Error::new(Code::WrongType, format!("/{name}"), sentence)))
}

/// A word.
pub(super) fn text(name: &str, value: &JsValue) -> Result<String, JsValue> {
    let sentence = || format!("{name} must be a string");
    value.as_string().ok_or_else(|| throw(Error::new(Code::WrongType, format!("/{name}"), sentence())))
}

/// A number.
pub(super) fn number(name: &str, value: &JsValue) -> Result<f64, JsValue> {
    let sentence = || format!("{name} must be a number");
    value.as_f64().ok_or_else(|| throw(Error::new(Code::WrongType, format!("/{name}"), sentence())))
}

/// The JSON tree of a plain object.
pub(super) fn node(object: JsValue) -> Result<Node, JsValue> {
    Node::read(serde_wasm_bindgen::Deserializer::from(object)).map_err(throw)
}
