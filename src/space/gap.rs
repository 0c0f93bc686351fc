//! The distance between two numbers on a line or on a circle.

use super::Lanes;

/// The distance between two coordinates whose whole turn is `period` (infinite on a line), the short way round. Both within
/// one turn of each other. O(1).
///
/// The difference, or if that is shorter, the rest of the turn. Without a branch, and the same bits as a test whether the
/// difference exceeds half a turn: beyond half, the rest is exact (Sterbenz) and shorter; up to half, the rest rounds to
/// half or more.
#[inline(always)]
pub fn gap<T: Lanes>(a: T, b: T, period: T) -> T {
    let straight = (a - b).abs();
    (period - straight).lesser(straight)
}

/// The least [`gap`] between `a` and any number from `low` to `high`; 0 if `a` lies between them. O(1).
///
/// Exact in floating point, so that it never exceeds a gap that it bounds: seen from outside, `|a - b|` only grows or only
/// falls as `b` goes through the interval, and rounding keeps that order; as `|a - b|` grows, the gap first rises, up to half
/// a turn, and then falls, so on the interval it is least at an end. Both ends are checked, which covers the wrap.
#[inline(always)]
pub fn gap_to_interval<T: Lanes>(a: T, low: T, high: T, period: T) -> T {
    gap(a, high, period).lesser(gap(a, low, period)).zero_between(a, low, high)
}
