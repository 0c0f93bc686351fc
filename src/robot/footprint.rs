//! The parts of a robot at one configuration, to be drawn or measured.

use crate::geometry::Point;

/// One part of a robot, placed in the workspace; lengths in metres.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// All points within `radius` of the segment from `a` to `b`; a segment if the radius is 0.
    Capsule {
        /// One end of the axis.
        a: Point,
        /// The second end of the axis.
        b: Point,
        /// Half the width, at least 0.
        radius: f64,
    },
    /// A disc; a point if the radius is 0.
    Disc {
        /// The centre.
        center: Point,
        /// The radius, at least 0.
        radius: f64,
    },
    /// A simple polygon, filled.
    Polygon {
        /// The corners, counter-clockwise.
        vertices: Vec<Point>,
    },
}
