//! 64 bits as 16 lower-case hexadecimal digits: for `#[serde(with = "hex")]`.

use crate::error::quoted;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

/// Writes the digits.
///
/// # Errors
/// Those of the serializer.
pub fn serialize<S: Serializer>(value: &u64, target: S) -> Result<S::Ok, S::Error> {
    target.collect_str(&format_args!("{value:016x}"))
}

/// Reads the digits.
///
/// # Errors
/// If the value is not 16 lower-case hexadecimal digits.
pub fn deserialize<'de, D: Deserializer<'de>>(source: D) -> Result<u64, D::Error> {
    let text = String::deserialize(source)?;
    let value = u64::from_str_radix(&text, 16).ok().filter(|value| format!("{value:016x}") == text);
    value.ok_or_else(|| {
        D::Error::custom(format!("this must be 16 lower-case hexadecimal digits, not {}", quoted(&text)))
    })
}
