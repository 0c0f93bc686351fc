//! The fewest digits that read back to the same bits, and of those the nearest to the number.

use super::big::Big;
use super::{LARGEST_EXACT, power_of_ten};
use std::cmp::Ordering;

/// Below this whole numbers of up to 15 digits are exact, and no two of them read as one float, whatever their exponent.
const EASY: f64 = 1e15;

/// A positive, finite number as digits without zeros at their end, and the exponent of ten to multiply them with.
pub(super) fn shortest(number: f64) -> (u64, i32) {
    for places in 0..=LARGEST_EXACT {
        let power = power_of_ten(places);
        let digits = libm::round(number * power);
        if digits >= EASY {
            break;
        }
        if digits / power == number {
            return without_zeros(digits as u64, -(places as i32));
        }
    }
    compare(number)
}

fn without_zeros(mut digits: u64, mut exponent: i32) -> (u64, i32) {
    while digits.is_multiple_of(10) {
        (digits, exponent) = (digits / 10, exponent + 1);
    }
    (digits, exponent)
}

/// The same by whole numbers: digit after digit of rest / one, until what is left is within half a step of the float to its
/// neighbours, `below` and `above`. Both count where the float is even, as reading rounds to even.
fn compare(number: f64) -> (u64, i32) {
    let bits = number.to_bits();
    let (field, fraction) = ((bits >> 52) as i32, bits & ((1 << 52) - 1));
    let (mantissa, exponent) = if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
    let is_even = mantissa % 2 == 0;
    // At a power of two the step below is half as wide: all counts in quarters of a step.
    let is_narrow = fraction == 0 && field > 1;
    let (mut rest, mut one) = (Big::new(4 * mantissa), Big::new(4));
    let (mut below, mut above) = (Big::new(if is_narrow { 1 } else { 2 }), Big::new(2));
    if exponent < 0 {
        one.shift(exponent.unsigned_abs());
    } else {
        [&mut rest, &mut below, &mut above].into_iter().for_each(|big| big.shift(exponent as u32));
    }
    // The place of the first digit, or of the one before it.
    let mut place = libm::floor(libm::log(number) * std::f64::consts::LOG10_E - 1e-9) as i32 + 1;
    if place >= 0 {
        one.scale(place as u32);
    } else {
        [&mut rest, &mut below, &mut above].into_iter().for_each(|big| big.scale(place.unsigned_abs()));
    }
    let reaches = |rest: &Big, above: &Big, one: &Big| {
        let mut sum = rest.clone();
        sum.add(above);
        sum.compare(one).then(if is_even { Ordering::Greater } else { Ordering::Less }) == Ordering::Greater
    };
    if reaches(&rest, &above, &one) {
        one.multiply(10, 0);
        place += 1;
    }
    let mut digits = 0;
    loop {
        [&mut rest, &mut below, &mut above].into_iter().for_each(|big| big.multiply(10, 0));
        let mut digit = 0;
        while rest.compare(&one) != Ordering::Less {
            rest.subtract(&one);
            digit += 1;
        }
        place -= 1;
        digits = 10 * digits + digit;
        let is_low =
            rest.compare(&below).then(if is_even { Ordering::Less } else { Ordering::Greater }) == Ordering::Less;
        let is_high = reaches(&rest, &above, &one);
        if is_low || is_high {
            rest.multiply(2, 0);
            let is_nearer_up = rest.compare(&one) != Ordering::Less;
            let is_up = is_high && (!is_low || is_nearer_up);
            return without_zeros(digits + u64::from(is_up), place);
        }
    }
}
