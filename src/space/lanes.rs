//! Numbers in lanes: what a metric computes with, for one pair of states or for several at once.

use std::ops::{Add, Mul, Sub};
use wide::{f32x4, f32x8, f64x2};

/// A number, or several in the lanes of a vector, in double or in single precision. Each lane has the bits that a single number
/// of its precision would have.
pub trait Lanes: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The number in every lane.
    fn splat(number: f64) -> Self;

    /// The absolute values.
    #[must_use]
    fn abs(self) -> Self;

    /// The square roots.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The lesser numbers. Of two numbers in a lane neither may be NaN unless both are; the result is then NaN.
    #[must_use]
    fn lesser(self, other: Self) -> Self;

    /// The greater numbers. Of two numbers in a lane neither may be NaN unless both are; the result is then NaN.
    #[must_use]
    fn greater(self, other: Self) -> Self;

    /// A bit for each lane, the lowest for the first: whether its number is greater than that of `other`.
    fn above(self, other: Self) -> u32;
}

impl Lanes for f64 {
    #[inline(always)]
    fn splat(number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn above(self, other: Self) -> u32 {
        u32::from(self > other)
    }
}

macro_rules! vectors {
    ($($vector:ty: $number:ty),*) => {$(
        impl Lanes for $vector {
            #[inline(always)]
            fn splat(number: f64) -> Self {
                <$vector>::splat(number as $number)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                <$vector>::abs(self)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                <$vector>::sqrt(self)
            }

            #[inline(always)]
            fn lesser(self, other: Self) -> Self {
                self.fast_min(other)
            }

            #[inline(always)]
            fn greater(self, other: Self) -> Self {
                self.fast_max(other)
            }

            #[inline(always)]
            fn above(self, other: Self) -> u32 {
                self.simd_gt(other).to_bitmask()
            }
        }
    )*};
}

vectors!(f32x4: f32, f32x8: f32, f64x2: f64);
