//! A rigid body that translates and turns: any simple polygon.

use super::Weights;
use crate::geometry::Polygon;
use serde::Serialize;

/// A rigid body. A configuration is (x, y, theta): the position of the origin of the shape's own frame, in metres, and
/// the rotation of the frame, in radians.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RigidBody {
    shape: Polygon,
    #[serde(rename = "metric")]
    weights: Weights,
}

impl RigidBody {
    /// A body of the given shape in its own frame.
    pub fn new(shape: Polygon, weights: Weights) -> Self {
        Self { shape, weights }
    }

    /// The shape in its own frame, in metres.
    pub fn shape(&self) -> &Polygon {
        &self.shape
    }

    /// The weights of the metric.
    pub fn weights(&self) -> Weights {
        self.weights
    }
}
