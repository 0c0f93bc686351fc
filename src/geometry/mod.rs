//! Plane geometry: points, segments, discs, simple polygons, polygons with holes, walls, angles and arcs; distance and
//! intersection, named `[operation]_[shape1]_[shape2]`.
//!
//! Lengths are metres, angles radians, counter-clockwise, y up. Shapes are closed and filled: touching is intersecting.
//! `intersects_*` is exact (Shewchuk's adaptive predicates); `distance_*` is rounded, with an error of a few units in the
//! last place of the largest coordinate.

mod angle;
mod blocks;
mod box_tree;
mod boxes;
mod chain;
mod convex_pieces;
mod crossing;
mod distance;
mod ellipsoid;
mod holes;
mod intersects;
mod order;
mod placed;
mod polygon;
mod polygons;
mod ring_tree;
mod rings;
mod shapes;
mod triangulation;
mod wall;

pub(crate) use angle::arc_length;
pub use angle::{angular_distance, arc_pose, euler_pose, unwind, wrap};
pub(crate) use box_tree::{BoxTree, LEAF};
pub(crate) use boxes::Boxes;
pub use convex_pieces::{convex_pieces, small_convex_pieces};
pub use distance::{
    distance_point_segment, distance_segment_segment, distance_squared_point_segment, distance_squared_segment_segment,
};
pub use ellipsoid::metres_per_degree;
pub use holes::PolygonWithHoles;
pub use intersects::intersects_segment_segment;
pub(crate) use order::{arrange, select_number, sort_numbers, sort_stably};
pub use placed::Placed;
pub use polygon::{MAX_MAGNITUDE, MIN_MAGNITUDE, Polygon, PolygonFault};
pub use polygons::{
    distance_point_polygon, distance_polygon_polygon, distance_segment_polygon, intersects_polygon_polygon,
    intersects_segment_polygon, signed_distance_point_polygon,
};
pub use rings::HoleFault;
pub use shapes::{Aabb, Disc, Segment};
pub use triangulation::triangles;
pub use wall::{Wall, WallFault};

/// A point of the workspace, in metres.
pub type Point = nalgebra::Point2<f64>;

/// A displacement in the workspace, in metres.
pub type Vector = nalgebra::Vector2<f64>;

/// On which side of the line from `a` to `b` the point `c` lies: positive to the left, negative to the right, zero
/// exactly on it. Exact in sign if every coordinate is 0 or of a magnitude in [[`MIN_MAGNITUDE`], [`MAX_MAGNITUDE`]]
/// (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates").
pub fn orientation(a: Point, b: Point, c: Point) -> f64 {
    let coord = |p: Point| robust::Coord { x: p.x, y: p.y };
    robust::orient2d(coord(a), coord(b), coord(c))
}
