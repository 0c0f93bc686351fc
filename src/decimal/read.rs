//! Text as the nearest float, of two as near the one whose last bit is 0.

use super::big::Big;
use super::{LARGEST_EXACT, power_of_ten};
use std::cmp::Ordering;

/// Digits that can matter: halfway between two floats lies no number of more.
const MOST_DIGITS: i32 = 800;

/// The largest whole number up to which all are exact.
const EXACT: u64 = 1 << 53;

/// The float nearest to a number in the form of JSON (`-1.25e3`): 0 where it is too small for any other, infinite where it is too
/// large. What else a text may be is for the caller to refuse. O(n) in its length.
pub fn read(text: &str) -> f64 {
    let (sign, text) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    sign * read_positive(digits.as_bytes(), read_exponent(exponent))
}

/// The exponent as it is written, far out where it is farther out still.
fn read_exponent(text: &str) -> i64 {
    let digits = text.bytes().filter(u8::is_ascii_digit);
    let size = digits.fold(0, |all, digit| (10 * all + i64::from(digit - b'0')).min(1 << 40));
    if text.starts_with('-') { -size } else { size }
}

fn read_positive(text: &[u8], mut exponent: i64) -> f64 {
    let mut number = Big::new(0);
    let (mut first, mut count, mut is_fraction, mut is_cut) = (0, 0, false, false);
    for &byte in text {
        if byte == b'.' {
            is_fraction = true;
            continue;
        }
        let digit = u32::from(byte - b'0');
        exponent -= i64::from(is_fraction);
        if count < MOST_DIGITS {
            number.multiply(10, digit);
            count += i32::from(!number.is_zero());
            first = if count <= 18 { 10 * first + u64::from(digit) } else { EXACT };
        } else {
            // Of the rest it matters only whether it is nothing.
            is_cut |= digit != 0;
            exponent += 1;
        }
    }
    if number.is_zero() {
        return 0.0;
    }
    if first < EXACT && exponent.unsigned_abs() <= LARGEST_EXACT as u64 {
        let power = power_of_ten(exponent.unsigned_abs() as usize);
        return if exponent < 0 { first as f64 / power } else { first as f64 * power };
    }
    // Where the first digit stands decides far out.
    let place = exponent + i64::from(count);
    if !(-330..=310).contains(&place) {
        return if place < 0 { 0.0 } else { f64::INFINITY };
    }
    if is_cut {
        number.multiply(10, 1);
        exponent -= 1;
    }
    let mut divisor = Big::new(1);
    let scaled = if exponent < 0 { &mut divisor } else { &mut number };
    scaled.scale(exponent.unsigned_abs() as u32);
    divide(number, divisor)
}

/// The float nearest to a quotient that is not far out.
fn divide(mut number: Big, mut divisor: Big) -> f64 {
    // Shifted so that the quotient lies between a quarter and 1.
    let shift = number.bits() - divisor.bits() + 1;
    let smaller = if shift < 0 { &mut number } else { &mut divisor };
    smaller.shift(shift.unsigned_abs());
    let mut quotient = 0u64;
    for _ in 0..64 {
        number.multiply(2, 0);
        quotient <<= 1;
        if number.compare(&divisor) != Ordering::Less {
            number.subtract(&divisor);
            quotient |= 1;
        }
    }
    // The quotient counts steps of 2^unit; 53 bits of it are kept, or fewer where the result is below 2^-1022.
    let unit = shift - 64;
    let dropped = (11 - quotient.leading_zeros() as i32).max(-1074 - unit) as u32;
    let kept = quotient.checked_shr(dropped).unwrap_or(0);
    let rest = u128::from(quotient) - (u128::from(kept) << dropped);
    let is_odd = kept % 2 == 1 || !number.is_zero();
    let is_up = match rest.cmp(&(1u128 << dropped >> 1)) {
        Ordering::Less => false,
        Ordering::Equal => is_odd,
        Ordering::Greater => true,
    };
    (kept + u64::from(is_up)) as f64 * power_of_two(unit + dropped as i32)
}

/// 2^`exponent`, at least 2^-1074; infinite from 2^1024 on.
fn power_of_two(exponent: i32) -> f64 {
    match exponent {
        ..-1022 => f64::from_bits(1 << (exponent + 1074)),
        1024.. => f64::INFINITY,
        _ => f64::from_bits(((exponent + 1023) as u64) << 52),
    }
}
