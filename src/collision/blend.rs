//! The proof that a blend is free: a parabola that rounds a corner of a path.
//!
//! The parabola with the control points p, b, r is cut into n equal pieces. At a fraction u of a piece it is u (1 - u) w past the
//! chord of the piece, w = (2 b - p - r) / n^2, so it lies in a band: the chord moved by w/8, and all that is off that by at most
//! w/8, forward or back. A band is proven like a straight motion of a robot grown by how far w/8 can move any of its points. If
//! that fails, the piece is halved, which makes its band a quarter as wide.

/// Half the length of the shortest piece, as a fraction of the blend: 64 pieces at most.
const SHORTEST_STEP: f64 = 1.0 / 128.0;

/// Whether the blend of `corner` is proven free. It begins at `corner + before` and ends at `corner + after`. `is_band_free`
/// tells whether the straight motion from its first argument by its second one is proven free, also off by any part of the third
/// one, forward or back; it is called fewer than 200 times.
pub(super) fn is_free<const N: usize>(
    corner: &[f64; N],
    before: &[f64; N],
    after: &[f64; N],
    is_band_free: impl Fn(&[f64; N], &[f64; N], &[f64; N]) -> bool,
) -> bool {
    let at = |u: f64| -> [f64; N] {
        std::array::from_fn(|i| corner[i] + ((1.0 - u) * (1.0 - u) * before[i] + u * u * after[i]))
    };
    // The middles of pieces, and half their lengths.
    let (mut pieces, mut next) = (vec![(0.5, 0.5)], 0);
    while let Some(&(middle, half)) = pieces.get(next) {
        next += 1;
        let (start, end) = (at(middle - half), at(middle + half));
        // With n = 1 / (2 half).
        let aside: [f64; N] = std::array::from_fn(|i| 0.5 * half * half * -(before[i] + after[i]));
        let from = std::array::from_fn(|i| start[i] + aside[i]);
        let delta = std::array::from_fn(|i| end[i] - start[i]);
        if is_band_free(&from, &delta, &aside) {
            continue;
        }
        if half <= SHORTEST_STEP || !is_band_free(&at(middle), &[0.0; N], &[0.0; N]) {
            return false;
        }
        let quarter = 0.5 * half;
        pieces.extend([(middle - quarter, quarter), (middle + quarter, quarter)]);
    }
    true
}
