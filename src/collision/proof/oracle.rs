//! The proof by distances, as simple as possible: the oracle of the tests.
//!
//! On every interval the clearance of each part from all obstacles, and its depth within the bounds, are compared with
//! the bound on its travel of the first order: of link i the sum over m <= i of L_m |w_m|, where w_m is the absolute rate
//! of link m; of a body the path of its frame's origin plus its turn times the distance of its farthest vertex. It has no
//! budget.

use crate::collision::Tolerance;

/// The distances of a part in the middle of an interval, in metres.
pub(in crate::collision) struct PartDistance {
    /// From the nearest obstacle.
    pub clearance: f64,
    /// Within the bounds.
    pub depth: f64,
    /// An upper bound on its travel along the whole motion.
    pub travel: f64,
}

/// The start, as a fraction of the motion, of the first interval that cannot be proven free; `None` if all is proven. `parts`
/// measures every part at a fraction of the motion.
pub(in crate::collision) fn first_hit(tolerance: &Tolerance, parts: &impl Fn(f64) -> Vec<PartDistance>) -> Option<f64> {
    first_hit_within(tolerance, parts, 0.5, 0.5)
}

fn first_hit_within(
    tolerance: &Tolerance,
    parts: &impl Fn(f64) -> Vec<PartDistance>,
    middle: f64,
    half: f64,
) -> Option<f64> {
    let (mut is_proven, mut is_hopeless) = (true, false);
    for PartDistance { clearance, depth, travel } in parts(middle) {
        let bound = travel * half;
        let is_apart = clearance - bound > tolerance.eta;
        let is_inside = depth - bound >= -tolerance.eta;
        is_proven &= is_apart && is_inside;
        is_hopeless |= (!is_apart && bound < tolerance.tau) || (!is_inside && bound < tolerance.bounds_tau);
    }
    if is_proven {
        return None;
    }
    if is_hopeless {
        return Some(middle - half);
    }
    let quarter = half / 2.0;
    first_hit_within(tolerance, parts, middle - quarter, quarter)
        .or_else(|| first_hit_within(tolerance, parts, middle + quarter, quarter))
}
