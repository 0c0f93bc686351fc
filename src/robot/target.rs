//! Where an end effector is to be.

use crate::geometry::Point;

/// A place for the tip of an arm, and which way its last link is to point there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// Where the tip is to be, in the world, in metres.
    pub point: Point,
    /// The angle of the last link in the world, in radians, in any number of turns; any angle where there is none.
    pub orientation: Option<f64>,
}
