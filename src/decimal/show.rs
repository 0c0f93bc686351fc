//! Floats as text.

use super::shortest::shortest;
use std::fmt::{Display, Formatter, Result, Write};

/// A float to be shown in a sentence: all its digits, never an exponent, a fraction only where there is one; `inf` and `NaN`.
/// The same as Rust's own form.
#[derive(Clone, Copy)]
pub struct Decimal(pub f64);

impl Display for Decimal {
    fn fmt(&self, f: &mut Formatter) -> Result {
        f.write_str(&written(self.0, i32::MIN, i32::MAX))
    }
}

/// Floats to be shown in a sentence as a list: `[0.5, 1.0]`.
#[derive(Clone, Copy)]
pub struct Row<'a>(pub &'a [f64]);

impl Display for Row<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        for (i, &number) in self.0.iter().enumerate() {
            f.write_str(if i == 0 { "[" } else { ", " })?;
            f.write_str(&exact(number, -3))?;
        }
        f.write_str(if self.0.is_empty() { "[]" } else { "]" })
    }
}

/// A float with a fraction or an exponent, so that it is seen to be one; with an exponent from 1e16 on, and below a number whose
/// first digit has this place: 0 stands behind the point, 1 before it.
pub(crate) fn exact(number: f64, lowest: i32) -> String {
    let mut text = written(number, lowest, 16);
    if number.is_finite() && !text.bytes().any(|byte| byte == b'.' || byte == b'e') {
        text.push_str(".0");
    }
    text
}

/// The number, with an exponent where the place of its first digit lies outside of these.
fn written(number: f64, lowest: i32, highest: i32) -> String {
    if number.is_nan() {
        return "NaN".to_owned();
    }
    let mut text = String::new();
    if number.is_sign_negative() {
        text.push('-');
    }
    let size = number.abs();
    if size == f64::INFINITY {
        text.push_str("inf");
    } else if size == 0.0 {
        text.push('0');
    } else {
        let (digits, exponent) = shortest(size);
        let digits = digits.to_string();
        let place = digits.len() as i32 + exponent;
        if !(lowest..=highest).contains(&place) {
            let (first, others) = digits.split_at_checked(1).unwrap_or_default();
            let point = if others.is_empty() { "" } else { "." };
            // Writing to a string cannot fail.
            let _ = write!(text, "{first}{point}{others}e{}", place - 1);
        } else if place <= 0 {
            text.push_str("0.");
            (place..0).for_each(|_| text.push('0'));
            text.push_str(&digits);
        } else if exponent >= 0 {
            text.push_str(&digits);
            (0..exponent).for_each(|_| text.push('0'));
        } else {
            let (whole, fraction) = digits.split_at_checked(place as usize).unwrap_or_default();
            text.push_str(whole);
            text.push('.');
            text.push_str(fraction);
        }
    }
    text
}
