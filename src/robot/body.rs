//! A rigid body that translates and turns, any simple polygon, and the weights of its metric.

use super::range::{LARGEST, check_positive, checked_margin, is_zero};
use crate::error::Error;
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
    #[serde(skip_serializing_if = "is_zero")]
    margin: f64,
}

impl RigidBody {
    /// A body of this shape in its own frame, in metres, and the weights of its metric.
    pub fn new(shape: Polygon, weights: Weights) -> Self {
        Self { shape, weights, margin: 0.0 }
    }

    /// The same, to be planned for as if it were larger by this margin on all sides, in metres.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/margin`) if the margin is not a finite number from 0 to 1e6.
    pub fn with_margin(self, margin: f64) -> Result<Self, Error> {
        Ok(Self { margin: checked_margin(margin)?, ..self })
    }

    /// By how much it is planned for as larger, in metres.
    pub fn margin(&self) -> f64 {
        self.margin
    }
}

/// The weights of the metric w_t d_t + w_r d_r, of translation (metres) and rotation (radians).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Weights {
    /// The weight of a metre, greater than 0.
    pub translation: f64,
    /// The weight of a radian, greater than 0.
    pub rotation: f64,
}

impl Default for Weights {
    fn default() -> Self {
        Self { translation: 0.7, rotation: 0.3 }
    }
}

impl Weights {
    /// Both weights.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/metric/translation` or `/metric/rotation`) unless both lie within (0, 1e6].
    pub fn new(translation: f64, rotation: f64) -> Result<Self, Error> {
        for (name, weight) in [("translation", translation), ("rotation", rotation)] {
            check_positive(&format!("/metric/{name}"), "a weight", weight, LARGEST)?;
        }
        Ok(Self { translation, rotation })
    }
}
