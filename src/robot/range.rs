//! The ranges of the numbers that a robot is made from.

use crate::error::{Code, Error, Number};

/// The largest coordinate, length or radius, in metres, and the largest angle of a circle joint, in radians (some 159,000
/// turns; beyond, an angle no longer determines a direction well).
pub const LARGEST: f64 = 1e6;

/// Returns an error unless the value is finite and within [low, 1e6].
pub(crate) fn check_range(pointer: &str, what: &str, value: f64, low: f64) -> Result<(), Error> {
    let range = format!("lie within [{}, {}]", Number(low), Number(LARGEST));
    check(pointer, what, value, (low..=LARGEST).contains(&value), &range)
}

/// The margin of a robot, if it is finite and within [0, 1e6].
pub(super) fn checked_margin(margin: f64) -> Result<f64, Error> {
    check_range("/margin", "a margin", margin, 0.0)?;
    Ok(margin + 0.0)
}

/// Whether a margin need not be written.
pub(super) fn is_zero(margin: &f64) -> bool {
    *margin == 0.0
}

/// Returns an error unless the value is finite and within (0, most].
pub(super) fn check_positive(pointer: &str, what: &str, value: f64, most: f64) -> Result<(), Error> {
    let range = format!("be greater than 0 and at most {}", Number(most));
    check(pointer, what, value, value > 0.0 && value <= most, &range)
}

/// Returns an error unless the limits are an increasing pair within [-most, most].
pub(super) fn check_limits(pointer: &str, what: &str, limits: [f64; 2], most: f64) -> Result<(), Error> {
    for (k, value) in limits.into_iter().enumerate() {
        check_size(&format!("{pointer}/{k}"), what, value, most)?;
    }
    if limits[0] >= limits[1] {
        let [low, high] = limits.map(Number);
        let sentence = format!("the lower limit {low} must be less than the upper {high}");
        return Err(Error::new(Code::OutOfRange, pointer, sentence));
    }
    Ok(())
}

/// Returns an error unless the value is finite and within [-most, most].
pub(super) fn check_size(pointer: &str, what: &str, value: f64, most: f64) -> Result<(), Error> {
    let range = format!("lie within [{}, {}]", Number(-most), Number(most));
    check(pointer, what, value, value.abs() <= most, &range)
}

/// Returns an error unless the value is finite and within its range.
fn check(pointer: &str, what: &str, value: f64, is_within: bool, range: &str) -> Result<(), Error> {
    let (code, range) =
        if value.is_finite() { (Code::OutOfRange, range) } else { (Code::NotFinite, "be a finite number") };
    if is_within {
        Ok(())
    } else {
        Err(Error::new(code, pointer, format!("{what} must {range}, not {}", Number(value))))
    }
}
