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

/// The least [`gap`] between a number and any in an interval, given by how far the number lies below the interval and how far
/// above it, each less than 0 if it does not; 0 if it lies inside. O(1).
///
/// Exact in floating point, so that it never exceeds a gap that it bounds: the number is at least as far from all others as from
/// the nearer end, and the other way round at least as far as from the farther end; rounding keeps that order.
#[inline(always)]
pub fn gap_to_interval<T: Lanes>(below: T, above: T, period: T) -> T {
    let around = period + below.lesser(above);
    below.greater(above).lesser(around).greater(T::splat(0.0))
}
