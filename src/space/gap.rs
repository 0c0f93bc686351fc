//! The distance between two numbers on a line or on a circle.

/// The distance between two coordinates whose whole turn is `period` (infinite on a line), the short way round. Both within
/// one turn of each other. O(1).
///
/// The difference, or if that is shorter, the rest of the turn. Without a branch, and the same bits as a test whether the
/// difference exceeds half a turn: beyond half, the rest is exact (Sterbenz) and shorter; up to half, the rest rounds to
/// half or more.
#[inline(always)]
pub fn gap(a: f64, b: f64, period: f64) -> f64 {
    let straight = (a - b).abs();
    lesser(period - straight, straight)
}

/// The lesser of two numbers that are not negative; NaN if one is NaN. WebAssembly chooses between two doubles by a jump that
/// cannot be predicted, so there the bits are compared: those of such numbers have the same order.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if cfg!(target_arch = "wasm32") {
        let (a, b) = (a.to_bits() as i64, b.to_bits() as i64);
        let below = a.wrapping_sub(b);
        f64::from_bits(b.wrapping_add(below & (below >> 63)) as u64)
    } else if a < b {
        a
    } else {
        b
    }
}

/// The least [`gap`] between `a` and any number from `low` to `high`; 0 if `a` lies between them. O(1).
///
/// Exact in floating point, so that it never exceeds a gap that it bounds: seen from outside, `|a - b|` only grows or only
/// falls as `b` goes through the interval, and rounding keeps that order; as `|a - b|` grows, the gap first rises, up to half
/// a turn, and then falls, so on the interval it is least at an end. Both ends are checked, which covers the wrap.
#[inline(always)]
pub fn gap_to_interval(a: f64, low: f64, high: f64, period: f64) -> f64 {
    let least = lesser(gap(a, high, period), gap(a, low, period));
    let outside = u64::from(!((low <= a) & (a <= high))).wrapping_neg();
    f64::from_bits(least.to_bits() & outside)
}
