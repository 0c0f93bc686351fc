//! How far apart two numbers are on a line or on a circle.

/// The distance between two coordinates whose whole turn is `period` (infinite on a line), the short way round. Both within
/// one turn of each other. O(1).
///
/// The difference, or where that is shorter, what is left of the turn. Without a branch, and the same bits as asking whether
/// the difference passes half a turn: beyond half, the rest is exact (Sterbenz) and shorter; up to half, the rest rounds to
/// half or more.
#[inline(always)]
pub fn gap(a: f64, b: f64, period: f64) -> f64 {
    let straight = (a - b).abs();
    let rest = period - straight;
    if rest < straight { rest } else { straight }
}

/// The least [`gap`] between `a` and any number from `low` to `high`; 0 where `a` lies between them. O(1).
///
/// Exact in floating point, so that it never exceeds a gap that it bounds: seen from outside, `|a - b|` only grows or only
/// falls as `b` goes through the interval, and rounding keeps that order; as `|a - b|` grows, the gap first rises, up to half
/// a turn, and then falls, so on the interval it is least at an end. Both ends are asked, which takes care of the wrap.
#[inline(always)]
pub fn gap_to_interval(a: f64, low: f64, high: f64, period: f64) -> f64 {
    let (to_low, to_high) = (gap(a, low, period), gap(a, high, period));
    let least = if to_high < to_low { to_high } else { to_low };
    if (low <= a) & (a <= high) { 0.0 } else { least }
}
