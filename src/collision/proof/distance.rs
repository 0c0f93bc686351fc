//! The proof by distances, as simple as it can be: the oracle of the fast one.
//!
//! On every stretch each link's clearance from the nearest obstacle is compared with the bound on its travel of the first
//! order, sum over m <= i of L_m |w_m| for link i, where w_m is the absolute rate of link m.

use super::{Motion, Setting};
use crate::geometry::Segment;
use crate::robot::MAX_LINKS;

/// Where the first stretch of the motion begins that cannot be proven free, as a fraction; `None` where all is proven.
pub(in crate::collision) fn first_hit<const N: usize>(
    setting: &Setting,
    motion: &Motion<N>,
    evaluations: &mut u64,
) -> Option<f64> {
    first_hit_within(setting, motion, evaluations, 0.5, 0.5)
}

fn first_hit_within<const N: usize>(
    setting: &Setting,
    motion: &Motion<N>,
    evaluations: &mut u64,
    middle: f64,
    half: f64,
) -> Option<f64> {
    let Setting { arm, obstacles, bounds, tolerance } = *setting;
    let travel = arm.travel(motion.delta);
    let mut q = [0.0; MAX_LINKS];
    for (i, angle) in q.iter_mut().enumerate().take(arm.links().len()) {
        *angle = motion.from[i] + middle * motion.delta[i];
    }
    let places = arm.joints(&q);
    let mut is_proven = true;
    let mut is_hopeless = false;
    for link in 0..arm.links().len() {
        let axis = Segment::new(places[link], places[link + 1]);
        let bound = travel[link] * half;
        *evaluations += obstacles.len() as u64;
        let clearance = obstacles.clearance(&axis) - arm.radius();
        let depth = bounds.map_or(f64::INFINITY, |box_| box_.depth(axis.a).min(box_.depth(axis.b)) - arm.radius());
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
    first_hit_within(setting, motion, evaluations, middle - quarter, quarter)
        .or_else(|| first_hit_within(setting, motion, evaluations, middle + quarter, quarter))
}
