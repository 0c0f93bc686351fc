//! Values as JSON text in one normal form.

use super::put_before;
use crate::error::{Code, Error};
use serde::Serialize;
use serde_json::Value;
use serde_json::ser::{Formatter, Serializer};
use std::io::{self, Write};

/// Whole numbers below this are exact as 64-bit floats and are written without a fraction.
pub(super) const EXACT: f64 = (1u64 << 53) as f64;

/// The value as JSON text on one line. Numbers have the fewest digits that read back to the same bits, whole ones below 2^53 no
/// fraction; NaN and infinities are `null`. Equal values give equal text, on every platform.
///
/// # Panics
/// If the value has no form in JSON: a map whose keys are not strings, or an implementation of `Serialize` that fails.
pub fn to_string<T: Serialize + ?Sized>(value: &T) -> String {
    let mut text = Vec::new();
    value.serialize(&mut Serializer::with_formatter(&mut text, Normal)).expect("the value has a form in JSON");
    String::from_utf8(text).expect("JSON is UTF-8")
}

/// The value as a tree, if its numbers are finite. Its absent options must be left out, not written as null.
///
/// # Errors
/// `not-finite` with the pointer of the first NaN or infinity.
///
/// # Panics
/// As [`to_string`].
pub(crate) fn finite_tree<T: Serialize + ?Sized>(value: &T) -> Result<Value, Error> {
    let tree = serde_json::to_value(value).expect("the value has a form in JSON");
    // NaN and infinities are null in it, and nothing else is.
    match first_null(&tree) {
        Some(pointer) => Err(Error::new(Code::NotFinite, pointer, "a number must be finite, not NaN or infinite")),
        None => Ok(tree),
    }
}

/// The pointer of the first null in a tree.
fn first_null(tree: &Value) -> Option<String> {
    let below = |name: &str, mut rest: String| {
        put_before(&mut rest, name);
        rest
    };
    match tree {
        Value::Null => Some(String::new()),
        Value::Array(parts) => {
            parts.iter().enumerate().find_map(|(i, part)| Some(below(&i.to_string(), first_null(part)?)))
        }
        Value::Object(parts) => parts.iter().find_map(|(name, part)| Some(below(name, first_null(part)?))),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => None,
    }
}

/// Compact, whole numbers without a fraction.
struct Normal;

impl Formatter for Normal {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        if value.abs() < EXACT && value == libm::trunc(value) && (value != 0.0 || value.is_sign_positive()) {
            write!(writer, "{}", value as i64)
        } else {
            serde_json::ser::CompactFormatter.write_f64(writer, value)
        }
    }
}
