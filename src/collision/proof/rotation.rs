//! Unit vectors of angles by polynomials: for proofs alone, whose slack covers what they are off.
//!
//! Only sums, products, differences and one conversion occur, so the bits are the same on every platform.
//!
//! **Error.** Up to [`SMALL`] the series, cut off after the terms of order 11 and 12, are off by at most 0.4^13 / 13! = 1.1e-15
//! and by rounding below 3e-16; each squaring doubles that and adds three roundings. Three squarings, as in [`unit`], make
//! 1.4e-14 in all, and four from a thirty-second of an angle to half of it 2.8e-14.

use crate::geometry::Vector;

/// The largest angle of the bare series, in radians: a thirty-second of what four circle joints turn together.
const SMALL: f64 = 0.4;

/// 2 pi in two parts: the first has 27 bits, so that up to 2^26 times it is exact.
const TURN: f64 = 6.283185303211212;
const TURN_REST: f64 = 3.968374318722162e-9;

/// Added and taken off again it rounds to a whole number.
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;

/// Cosine and sine of an angle of up to 1e4 radians.
#[inline]
pub(super) fn unit(angle: f64) -> Vector {
    if angle.abs() <= SMALL {
        return series(angle);
    }
    let turns = (angle * (1.0 / std::f64::consts::TAU) + TO_WHOLE) - TO_WHOLE;
    let rest = (angle - turns * TURN) - turns * TURN_REST;
    doubled(doubled(doubled(series(rest * 0.125))))
}

/// Cosine and sine of a small angle.
#[inline(always)]
fn series(x: f64) -> Vector {
    let z = x * x;
    let sin = -1.0 / 39_916_800.0;
    let sin = 1.0 / 362_880.0 + z * sin;
    let sin = -1.0 / 5_040.0 + z * sin;
    let sin = 1.0 / 120.0 + z * sin;
    let sin = -1.0 / 6.0 + z * sin;
    let cos = 1.0 / 479_001_600.0;
    let cos = -1.0 / 3_628_800.0 + z * cos;
    let cos = 1.0 / 40_320.0 + z * cos;
    let cos = -1.0 / 720.0 + z * cos;
    let cos = 1.0 / 24.0 + z * cos;
    let cos = -0.5 + z * cos;
    Vector::new(1.0 + z * cos, x + x * (z * sin))
}

/// The unit vector of twice the angle.
#[inline(always)]
pub(super) fn doubled(e: Vector) -> Vector {
    Vector::new((e.x - e.y) * (e.x + e.y), 2.0 * e.x * e.y)
}

/// The unit vectors of the difference and of the sum of two angles.
#[inline(always)]
pub(super) fn turned_both_ways(e: Vector, by: Vector) -> [Vector; 2] {
    let (xx, yy, xy, yx) = (e.x * by.x, e.y * by.y, e.x * by.y, e.y * by.x);
    [Vector::new(xx + yy, yx - xy), Vector::new(xx - yy, yx + xy)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_within_the_stated_error_of_sine_and_cosine() {
        for i in -400_000..=400_000 {
            let angle = f64::from(i) * 0.0025;
            let (sin, cos) = libm::sincos(angle);
            let e = unit(angle);
            assert!((e.x - cos).abs() < 1.4e-14 && (e.y - sin).abs() < 1.4e-14, "{angle}");
        }
    }
}
