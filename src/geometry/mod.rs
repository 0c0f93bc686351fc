//! Plane geometry: points, segments, discs, simple polygons; distance and intersection, one file a pair of shapes,
//! named `[operation]_[shape1]_[shape2]`.
//!
//! Lengths are metres, angles radians, counter-clockwise, y up. Shapes are closed and filled: touching is intersecting.
//! `intersects_*` is exact (Shewchuk's adaptive predicates); `distance_*` is rounded, with an error of a few units in the
//! last place of the largest coordinate.

mod aabb;
mod arc;
mod convex_pieces;
mod crossing;
mod disc;
mod distance_point_polygon;
mod distance_point_segment;
mod distance_polygon_polygon;
mod distance_segment_polygon;
mod distance_segment_segment;
mod intersects_polygon_polygon;
mod intersects_segment_polygon;
mod intersects_segment_segment;
mod polygon;
mod segment;
mod triangulation;

pub use aabb::Aabb;
pub use arc::arc_pose;
pub use convex_pieces::convex_pieces;
pub use disc::Disc;
pub use distance_point_polygon::distance_point_polygon;
pub use distance_point_segment::{distance_point_segment, distance_squared_point_segment};
pub use distance_polygon_polygon::distance_polygon_polygon;
pub use distance_segment_polygon::distance_segment_polygon;
pub use distance_segment_segment::{distance_segment_segment, distance_squared_segment_segment};
pub use intersects_polygon_polygon::intersects_polygon_polygon;
pub use intersects_segment_polygon::intersects_segment_polygon;
pub use intersects_segment_segment::intersects_segment_segment;
pub use polygon::{Polygon, PolygonFault};
pub use segment::Segment;
pub use triangulation::triangles;

/// A point of the workspace, in metres.
pub type Point = nalgebra::Point2<f64>;

/// A displacement in the workspace, in metres.
pub type Vector = nalgebra::Vector2<f64>;

/// On which side of the line from `a` to `b` the point `c` lies: positive to the left, negative to the right, zero
/// exactly on it. Exact in sign (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust
/// geometric predicates").
pub fn orientation(a: Point, b: Point, c: Point) -> f64 {
    let coord = |p: Point| robust::Coord { x: p.x, y: p.y };
    robust::orient2d(coord(a), coord(b), coord(c))
}
