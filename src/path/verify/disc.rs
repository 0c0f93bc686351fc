//! A translating disc or point: the swept region of an edge is exact; a blend is examined like the motion of an arm, of one link
//! without length.

use super::blend::Quadratic;
use super::moving::{Checker, Moving, Stretch};
use super::near::{Near, near};
use super::{Examined, LARGEST, Scale};
use crate::geometry::{Aabb, Point, Segment, Vector};
use crate::path::PathCost;
use crate::robot::DiscRobot;
use crate::scenario::{Obstacle, World};

/// Examines every edge as the segment that the centre moves along, then every blend, given with its waypoint.
pub(super) fn check(
    world: &World,
    disc: &DiscRobot,
    path: &[Vec<f64>],
    blends: &[(usize, Quadratic)],
    scale: &Scale,
) -> Result<Examined, String> {
    let radius = disc.kept_radius();
    let centers: Vec<Point> = path.iter().map(|q| Point::new(q[0], q[1])).collect();
    if let Some(bounds) = &world.bounds {
        let overstep = if radius == 0.0 { 0.0 } else { scale.overstep };
        // The bounds are convex: with every waypoint, every edge is inside.
        if let Some(i) = centers.iter().position(|&p| bounds.depth(p) - radius < -overstep) {
            return Err(format!("waypoint {i} leaves the bounds"));
        }
    }
    let mut examined = Examined { samples: 0, clearance: f64::INFINITY };
    for edge in 0..(centers.len() - 1).max(1) {
        let swept = Segment::new(centers[edge], centers[(edge + 1).min(centers.len() - 1)]);
        examined.samples += 1;
        for (i, obstacle) in world.obstacles.iter().enumerate() {
            let apart = super::near::gap(&swept.aabb(), &obstacle.aabb()) - radius;
            if apart > scale.slack && apart >= examined.clearance {
                continue;
            }
            let clearance = obstacle.distance_to_segment(&swept) - radius;
            let exact = if radius == 0.0 { obstacle.meets_segment(&swept) } else { None };
            let touches = exact.unwrap_or(clearance <= scale.slack);
            if touches {
                return Err(format!("edge {edge} touches obstacle {i}{}", ends_inside(&swept, obstacle)));
            }
            examined.clearance = examined.clearance.min(clearance.max(0.0));
        }
    }
    let mut checker = Checker::new(world, scale);
    for (waypoint, Quadratic { from, rate, bend }) in blends {
        let points =
            |t: f64| vec![Point::new(0.0, 0.0) + Vector::from_fn(|i, _| from[i] + t * (rate[i] + t * bend[i])); 2];
        let speed = |at: f64| libm::hypot(rate[0] + at * bend[0], rate[1] + at * bend[1]);
        let travel = [speed(0.0).max(speed(2.0)); 2];
        let bulge = [libm::hypot(bend[0], bend[1]) / 4.0; 2];
        let stretch = Stretch::Blend(*waypoint);
        let part_name = |_| "the disc".into();
        let robot = Moving { stretch, points: &points, travel: &travel, bulge: &bulge, radius, body: None, part_name };
        checker.check_edge(&robot)?;
    }
    examined.samples += checker.examined.samples;
    examined.clearance = examined.clearance.min(checker.examined.clearance);
    Ok(examined)
}

/// The steps of a cost's recomputation, as a part of the clearance from which nothing is added.
const STEP: f64 = 1.0 / 64.0;

/// The least of that clearance, as a part of the longer side of the bounds: planners take no less.
const LEAST_WITHIN: f64 = 1.0 / 2048.0;

/// The largest weight that planners take.
const LARGEST_WEIGHT: f64 = 1e6;

/// What costs may differ by, as a part of the weight times the length along which something is added.
const COST: f64 = 1.0 / 32.0;

/// Returns an error if the given cost is not that of the path, by the trapezoidal rule.
pub(super) fn check_cost(world: &World, disc: &DiscRobot, path: &[Vec<f64>], cost: &PathCost) -> Result<(), String> {
    let &PathCost { value, weight, within } = cost;
    let least = LEAST_WITHIN * world.bounds.as_ref().map_or(0.0, Aabb::longer_side);
    if !(value.is_finite() && (0.0..=LARGEST_WEIGHT).contains(&weight) && (least..=LARGEST).contains(&within)) {
        return Err(format!("the cost is given as {value}, with the weight {weight} within {within} m"));
    }
    let radius = disc.kept_radius();
    let (mut length, mut nearness, mut beside) = (0.0, 0.0, 0.0);
    for ends in path.windows(2) {
        let [a, b] = [0, 1].map(|i| Point::new(ends[i][0], ends[i][1]));
        let near = near(&world.obstacles, &Segment::new(a, b).aabb(), radius + (1.0 + STEP) * within);
        let at = |t: f64| {
            let p = a + t * (b - a);
            let reach = radius + (1.0 + STEP) * within;
            let distance = |near: &Near| near.obstacle.distance_to_segment_within(&Segment::new(p, p), reach);
            near.iter().map(distance).fold(reach, f64::min) - radius
        };
        let added = |clearance: f64| (1.0 - clearance / within).clamp(0.0, 1.0);
        let whole = (b - a).norm();
        let steps = libm::ceil(whole / (STEP * within)).max(1.0);
        let mut before = at(0.0);
        for i in 1..=steps as u32 {
            let after = at(f64::from(i) / steps);
            nearness += whole / steps * 0.5 * (added(before) + added(after));
            // The planner's pieces are longer.
            beside += if before.min(after) < (1.0 + STEP) * within { whole / steps } else { 0.0 };
            before = after;
        }
        length += whole;
    }
    let measured = length + weight * nearness;
    if measured.is_nan() || (value - measured).abs() > COST * weight * beside + 1e-6 * measured {
        return Err(format!("the cost is given as {value}, but that of the path is {measured}"));
    }
    Ok(())
}

/// Which ends of the edge are in contact.
fn ends_inside(swept: &Segment, obstacle: &Obstacle) -> &'static str {
    let inside = |p: Point| obstacle.distance_to_segment(&Segment::new(p, p)) <= 0.0;
    match (inside(swept.a), inside(swept.b)) {
        (true, true) => ", which contains both its ends",
        (true, false) => ", which contains its first end",
        (false, true) => ", which contains its last end",
        (false, false) => "",
    }
}
