//! The length of a blend: a parabola that rounds a corner of a path.
//!
//! The quadratic Bezier curve with the control points p, b, r has the velocity 2 ((1 - u) A + u B) at u in [0, 1], where A = b -
//! p and B = r - b. With s = |A| + |B|, m = |B - A|, q = (|B| - |A|) / m and x = m / s, both at most 1, the integral of its
//! length is s/2 (1 + q^2 + (1 - q^2) (1 - x^2) atanh(x) / x). No term cancels, also where A and B are parallel or opposite.

/// By how much the parabola is shorter than its corner, p to b to r, which is s long: at least 0, at most half of s. `legs` are
/// the coordinates of A and B, whose length is Euclidean.
pub(super) fn saving(legs: impl Iterator<Item = [f64; 2]>) -> f64 {
    let [mut before, mut after, mut apart] = [0.0; 3];
    for [a, b] in legs {
        before += a * a;
        after += b * b;
        apart += (b - a) * (b - a);
    }
    let [before, after, apart] = [before, after, apart].map(f64::sqrt);
    let sum = before + after;
    if apart <= 0.0 {
        return 0.0;
    }
    let (q, x) = ((after - before) / apart, apart / sum);
    let straight = if x < 1.0 { (1.0 - x * x) * libm::atanh(x) / x } else { 0.0 };
    0.5 * sum * (1.0 - q * q).max(0.0) * (1.0 - straight).max(0.0)
}
