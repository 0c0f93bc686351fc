//! A rigid body that translates and turns: any simple polygon.

use super::Weights;
use crate::geometry::Polygon;
use serde::Serialize;

/// A rigid body. A configuration is (x, y, theta): the position of the origin of the shape's own frame, in metres, and the
/// rotation of the frame, in radians.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RigidBody {
    /// The shape in its own frame, in metres.
    pub shape: Polygon,
    /// The weights of the metric.
    #[serde(rename = "metric")]
    pub weights: Weights,
}
