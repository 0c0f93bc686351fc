//! The proof by distances for bodies, as simple as it can be: the oracle of the fast one.
//!
//! On every stretch the clearance of the whole body from the nearest obstacle, and its depth within the bounds, are compared
//! with the bound on its travel of the first order: no point of the body moves faster than the origin of its frame plus its
//! turn rate times the distance of its farthest vertex.

use super::BodySetting;
use crate::collision::BodyMotion;
use crate::collision::obstacles::depth;

/// Where the first stretch of the motion begins that cannot be proven free, as a fraction; `None` where all is proven.
pub(in crate::collision) fn first_hit(
    setting: &BodySetting,
    motion: &BodyMotion,
    evaluations: &mut u64,
) -> Option<f64> {
    first_hit_within(setting, motion, evaluations, 0.5, 0.5)
}

fn first_hit_within(
    setting: &BodySetting,
    motion: &BodyMotion,
    evaluations: &mut u64,
    middle: f64,
    half: f64,
) -> Option<f64> {
    let BodySetting { body, shape, whole: obstacles, bounds, tolerance, .. } = *setting;
    let bound = travel(motion, shape.reach()) * half;
    let placed = body.placed(motion.at(middle));
    *evaluations += obstacles.len() as u64;
    let clearance = (0..obstacles.len()).map(|i| obstacles.distance_from(&placed, i)).fold(f64::INFINITY, f64::min);
    let is_apart = clearance - bound > tolerance.eta;
    let is_inside = depth(bounds, placed.vertices()) - bound >= -tolerance.eta;
    if is_apart && is_inside {
        return None;
    }
    if (!is_apart && bound < tolerance.tau) || (!is_inside && bound < tolerance.bounds_tau) {
        return Some(middle - half);
    }
    let quarter = half / 2.0;
    first_hit_within(setting, motion, evaluations, middle - quarter, quarter)
        .or_else(|| first_hit_within(setting, motion, evaluations, middle + quarter, quarter))
}

/// How far any point of a body can travel along the whole motion, at most, in metres.
fn travel(motion: &BodyMotion, reach: f64) -> f64 {
    let (path, turn) = motion.extent();
    path + turn * reach
}
