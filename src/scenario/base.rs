//! The base of an arm never moves: what touches it would make every configuration a collision.

use crate::error::{Code, Error, Number};
use crate::geometry::{Point, Segment, distance_segment_polygon};
use crate::robot::Arm;
use crate::scenario::{Obstacle, Robot, World};

/// Refuses an obstacle within the arm's radius of its base, and a base whose disc of that radius is not within the bounds.
/// Contact with an obstacle is collision, contact with the bounds is not; both up to the slack of 1e-12 times the largest
/// coordinate plus the reach.
pub(super) fn check(world: &World, robot: &Robot) -> Result<(), Error> {
    let Robot::Arm(arm) = robot else { return Ok(()) };
    let (base, radius, slack) = (arm.base(), arm.radius(), slack(world, arm));
    for (i, obstacle) in world.obstacles.iter().enumerate() {
        let distance = distance_to(base, obstacle);
        if distance <= radius + slack {
            let [x, y, radius, distance] = [base.x, base.y, radius, distance].map(Number);
            let sentence =
                format!("obstacle {i} is {distance} from the arm's base [{x}, {y}], which takes {radius} around it");
            return Err(Error::new(Code::BaseInCollision, format!("/world/obstacles/{i}"), sentence));
        }
    }
    if world.bounds.is_some_and(|bounds| bounds.depth(base) - radius < -slack) {
        let [x, y, radius] = [base.x, base.y, radius].map(Number);
        let sentence = format!("the arm's base [{x}, {y}] with {radius} around it is not within the bounds");
        return Err(Error::new(Code::BaseInCollision, "/robot/base", sentence));
    }
    Ok(())
}

/// The distance from a point to an obstacle, in metres; 0 or less where the point lies in it.
fn distance_to(p: Point, obstacle: &Obstacle) -> f64 {
    match obstacle {
        Obstacle::Disc(disc) => nalgebra::distance(&disc.center, &p) - disc.radius,
        Obstacle::Polygon(polygon) => distance_segment_polygon(&Segment::new(p, p), polygon).max(0.0),
    }
}

/// 1e-12 of the largest coordinate plus the arm's reach, in metres.
fn slack(world: &World, arm: &Arm) -> f64 {
    let boxes = world.obstacles.iter().map(Obstacle::aabb).chain(world.bounds);
    let corners = boxes.flat_map(|aabb| [aabb.min, aabb.max]).chain([arm.base()]);
    let largest = corners.map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
    1e-12 * (largest + arm.reach() + arm.radius())
}
