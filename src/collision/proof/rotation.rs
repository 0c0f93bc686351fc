//! Unit vectors of angles by polynomials: for proofs alone, whose slack covers their error.
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
pub(in crate::collision) fn unit(angle: f64) -> Vector {
    if angle.abs() <= SMALL {
        return series(angle);
    }
    let turns = (angle * (1.0 / std::f64::consts::TAU) + TO_WHOLE) - TO_WHOLE;
    let rest = (angle - turns * TURN) - turns * TURN_REST;
    doubled(doubled(doubled(series(rest * 0.125))))
}

/// Cosine and sine of an angle of up to 1e4 radians, and its sine over the angle, 1 for 0.
#[inline]
pub(in crate::collision) fn unit_and_sinc(angle: f64) -> (Vector, f64) {
    let e = unit(angle);
    // A small sine is a product with the angle, off by a rounding or two: so is the quotient.
    (e, if angle == 0.0 { 1.0 } else { e.y / angle })
}

/// The unit vector of the sum of both angles.
#[inline(always)]
pub(in crate::collision) fn rotate(e: Vector, by: Vector) -> Vector {
    Vector::new(e.x * by.x - e.y * by.y, e.y * by.x + e.x * by.y)
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
fn doubled(e: Vector) -> Vector {
    Vector::new((e.x - e.y) * (e.x + e.y), 2.0 * e.x * e.y)
}

/// Unit vectors of `N` angles, side by side for a compiler that can treat two at a time.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct UnitVectors<const N: usize> {
    pub x: [f64; N],
    pub y: [f64; N],
}

impl<const N: usize> UnitVectors<N> {
    /// Of no angle: all point along x.
    pub const ZERO: Self = Self { x: [1.0; N], y: [0.0; N] };

    /// Of the angles times `factor`; `fastest` is the largest angle.
    #[inline(always)]
    pub fn new(angles: &[f64; N], factor: f64, fastest: f64) -> Self {
        let mut units = Self::ZERO;
        let is_small = fastest * factor <= SMALL;
        for (i, &angle) in angles.iter().enumerate() {
            let e = if is_small { series(angle * factor) } else { unit(angle * factor) };
            units.set(i, e);
        }
        units
    }

    #[inline(always)]
    pub fn at(&self, i: usize) -> Vector {
        Vector::new(self.x[i], self.y[i])
    }

    #[inline(always)]
    pub fn set(&mut self, i: usize, e: Vector) {
        (self.x[i], self.y[i]) = (e.x, e.y);
    }

    /// Of twice the angles.
    #[inline(always)]
    pub fn doubled(&self) -> Self {
        let mut units = *self;
        for i in 0..N {
            let (x, y) = (self.x[i], self.y[i]);
            (units.x[i], units.y[i]) = ((x - y) * (x + y), 2.0 * x * y);
        }
        units
    }

    /// Of the differences and of the sums of the angles and others.
    #[inline(always)]
    pub fn rotate_both_ways(&self, by: &Self) -> [Self; 2] {
        let [mut less, mut more] = [*self; 2];
        for i in 0..N {
            let (xx, yy) = (self.x[i] * by.x[i], self.y[i] * by.y[i]);
            let (xy, yx) = (self.x[i] * by.y[i], self.y[i] * by.x[i]);
            (less.x[i], less.y[i]) = (xx + yy, yx - xy);
            (more.x[i], more.y[i]) = (xx - yy, yx + xy);
        }
        [less, more]
    }
}
