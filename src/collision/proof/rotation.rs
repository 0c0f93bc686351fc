//! Unit vectors of angles by polynomials: for proofs alone, whose slack covers their error.
//!
//! Only sums, products, differences and one conversion occur, so the bits are the same on every platform.
//!
//! **Error.** Up to [`SMALL`] the series, cut off after the terms of order 11 and 12, are off by at most 0.4^13 / 13! = 1.1e-15
//! and by rounding below 3e-16; each squaring doubles that and adds three roundings. Three squarings, as in [`unit`], make
//! 1.4e-14 in all, and four from a thirty-second of an angle to half of it 2.8e-14.

use super::moving_point::Plane;
use crate::space::Lanes;

/// The largest angle of the bare series, in radians: a thirty-second of what four circle joints turn together.
pub(super) const SMALL: f64 = 0.4;

/// 2 pi in two parts: the first has 27 bits, so that up to 2^26 times it is exact.
const TURN: f64 = 6.283185303211212;
const TURN_REST: f64 = 3.968374318722162e-9;

/// Added and taken off again it rounds to a whole number.
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;

/// Cosine and sine of an angle of up to 1e4 radians, in every lane.
#[inline]
pub(in crate::collision) fn unit<T: Lanes>(angle: T) -> Plane<T> {
    if angle.abs().above(T::splat(SMALL)) == 0 {
        return series(angle);
    }
    let turns = (angle * T::splat(1.0 / std::f64::consts::TAU) + T::splat(TO_WHOLE)) - T::splat(TO_WHOLE);
    let rest = (angle - turns * T::splat(TURN)) - turns * T::splat(TURN_REST);
    doubled(doubled(doubled(series(rest * T::splat(0.125)))))
}

/// Cosine and sine of a small angle.
#[inline(always)]
pub(super) fn series<T: Lanes>(x: T) -> Plane<T> {
    let z = x * x;
    let sin = T::splat(-1.0 / 39_916_800.0);
    let sin = T::splat(1.0 / 362_880.0) + z * sin;
    let sin = T::splat(-1.0 / 5_040.0) + z * sin;
    let sin = T::splat(1.0 / 120.0) + z * sin;
    let sin = T::splat(-1.0 / 6.0) + z * sin;
    let cos = T::splat(1.0 / 479_001_600.0);
    let cos = T::splat(-1.0 / 3_628_800.0) + z * cos;
    let cos = T::splat(1.0 / 40_320.0) + z * cos;
    let cos = T::splat(-1.0 / 720.0) + z * cos;
    let cos = T::splat(1.0 / 24.0) + z * cos;
    let cos = T::splat(-0.5) + z * cos;
    Plane { x: T::splat(1.0) + z * cos, y: x + x * (z * sin) }
}

/// The unit vector of twice the angle.
#[inline(always)]
pub(super) fn doubled<T: Lanes>(e: Plane<T>) -> Plane<T> {
    Plane { x: (e.x - e.y) * (e.x + e.y), y: T::splat(2.0) * e.x * e.y }
}
