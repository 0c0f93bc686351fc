//! Whether an obstacle keeps clear of parts of a robot and of other obstacles.

use crate::geometry::{Disc, Point, Polygon, Segment, distance_point_segment, distance_segment_polygon};
use crate::robot::Part;

/// A clearance that any slack is far below, and a difference that no rounding makes, in metres.
pub(super) const SOME: f64 = 1e-9;

/// Whether the polygon is farther than `gap` metres from all of the parts.
pub(super) fn is_clear_of(polygon: &Polygon, parts: &[Part], gap: f64) -> bool {
    parts.iter().all(|part| match axis_and_radius(part) {
        Ok((axis, radius)) => distance_segment_polygon(&axis, polygon) - radius > gap + SOME,
        Err(corners) => are_apart(&self::polygon(corners), polygon, gap),
    })
}

/// Whether the disc is farther than `gap` metres from all of the parts.
pub(super) fn is_disc_clear_of(disc: &Disc, parts: &[Part], gap: f64) -> bool {
    let far = gap + SOME + disc.radius;
    parts.iter().all(|part| match axis_and_radius(part) {
        Ok((axis, radius)) => distance_point_segment(disc.center, &axis) - radius > far,
        Err(corners) => {
            let center = Segment::new(disc.center, disc.center);
            distance_segment_polygon(&center, &self::polygon(corners)) > far
        }
    })
}

/// The part as all points within a radius of a segment; else its corners.
fn axis_and_radius(part: &Part) -> Result<(Segment, f64), &[Point]> {
    match part {
        Part::Capsule { a, b, radius } => Ok((Segment::new(*a, *b), *radius)),
        Part::Disc { center, radius } => Ok((Segment::new(*center, *center), *radius)),
        Part::Polygon { vertices } => Err(vertices),
    }
}

/// Whether the two polygons are farther than `gap` metres from each other. O(product of their vertices).
pub(super) fn are_apart(p: &Polygon, q: &Polygon, gap: f64) -> bool {
    let corner: Point = q.vertices()[0];
    !p.aabb().grown(gap + SOME).intersects(q.aabb())
        || (!p.contains(corner) && p.edges().all(|edge| distance_segment_polygon(&edge, q) > gap + SOME))
}

/// The polygon of corners that are known to make one.
///
/// # Panics
/// If they do not.
pub(super) fn polygon(corners: &[Point]) -> Polygon {
    Polygon::new(corners).unwrap_or_else(|_| unreachable!("generators know their polygons"))
}
