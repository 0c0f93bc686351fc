//! The weights of translation and rotation in the metric of SE(2).

use super::range::{LARGEST, check_positive};
use crate::error::Error;
use serde::Serialize;

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
