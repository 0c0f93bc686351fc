//! The target of an end effector.

use crate::geometry::Point;
use serde::Serialize;

/// A position for the end effector of an arm, and optionally the orientation of its last link.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Target {
    /// The position of the tip in the world, in metres.
    pub point: Point,
    /// The angle of the last link in the world, in radians, in any number of turns; any angle if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<f64>,
}
