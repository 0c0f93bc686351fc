//! Which numbers a robot may be made from.

use crate::error::{Code, Error, Number};

/// The largest coordinate, length or radius, in metres, and the largest angle of a circle joint, in radians (some 159,000
/// turns; beyond, an angle no longer determines a direction well).
pub const LARGEST: f64 = 1e6;

/// The error for a coordinate, length or radius that is not finite.
pub(super) fn not_finite(pointer: &str, what: &str, value: f64) -> Error {
    Error::new(Code::NotFinite, pointer, format!("{what} must be a finite number, not {}", Number(value)))
}

/// Returns an error unless the value is finite and within [low, 1e6].
pub(crate) fn check_range(pointer: &str, what: &str, value: f64, low: f64) -> Result<(), Error> {
    if !value.is_finite() {
        return Err(not_finite(pointer, what, value));
    }
    if !(low..=LARGEST).contains(&value) {
        let [low, value] = [low, value].map(Number);
        let sentence = format!("{what} must lie within [{low}, {}], not {value}", Number(LARGEST));
        return Err(Error::new(Code::OutOfRange, pointer, sentence));
    }
    Ok(())
}

/// Refuses a radius that is not a finite number within [0, 1e6].
pub(super) fn check_radius(radius: f64) -> Result<(), Error> {
    check_range("/radius", "a radius", radius, 0.0)
}
