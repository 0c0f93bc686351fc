//! Whether an obstacle keeps clear of parts of a robot and of other obstacles.

use crate::geometry::{Point, Polygon, Segment};
use crate::robot::Part;
use crate::scenario::Obstacle;

/// A clearance that any slack is far below, and a difference that no rounding makes, in metres.
pub(super) const SOME: f64 = 1e-9;

/// Whether the obstacle is farther than `gap` metres from all of the parts.
pub(super) fn is_clear_of(obstacle: &Obstacle, parts: &[Part], gap: f64) -> bool {
    let is_far = |axis: Segment, radius: f64| obstacle.distance_to_segment(&axis) - radius > gap + SOME;
    parts.iter().all(|part| match part {
        Part::Capsule { a, b, radius } => is_far(Segment::new(*a, *b), *radius),
        Part::Disc { center, radius } => is_far(Segment::new(*center, *center), *radius),
        Part::Polygon { vertices } => obstacle.distance_to_polygon(&polygon(vertices)) > gap + SOME,
    })
}

/// Whether the two obstacles are farther than `gap` metres from each other, a hole counting as filled. O(product of
/// their vertices).
pub(super) fn are_apart(p: &Obstacle, q: &Obstacle, gap: f64) -> bool {
    let far = gap + SOME;
    !p.aabb().grown(far).intersects(&q.aabb())
        || match p {
            Obstacle::Disc(disc) => q.distance_to_segment(&Segment::new(disc.center, disc.center)) - disc.radius > far,
            Obstacle::Polygon(polygon) => q.distance_to_polygon(polygon) > far,
            Obstacle::PolygonWithHoles(polygon) => q.distance_to_polygon(polygon.outline()) > far,
            Obstacle::Wall(wall) => wall.segments().all(|s| q.distance_to_segment(&s) - wall.radius() > far),
        }
}

/// The polygon of corners that are known to make one.
///
/// # Panics
/// If they do not.
pub(super) fn polygon(corners: &[Point]) -> Polygon {
    Polygon::new(corners).unwrap_or_else(|_| unreachable!("generators know their polygons"))
}
