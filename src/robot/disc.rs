//! A disc that translates; a point if its radius is 0.

use super::Part;
use super::range::{check_range, checked_margin, is_zero};
use crate::error::Error;
use crate::geometry::Point;
use serde::Serialize;

/// A disc robot. A configuration is the centre (x, y), in metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiscRobot {
    radius: f64,
    #[serde(skip_serializing_if = "is_zero")]
    margin: f64,
}

impl DiscRobot {
    /// A disc of the given radius in metres, 0 for a point.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/radius`) if the radius is not a finite number from 0 to 1e6.
    pub fn new(radius: f64) -> Result<Self, Error> {
        check_range("/radius", "a radius", radius, 0.0)?;
        Ok(Self { radius: radius + 0.0, margin: 0.0 })
    }

    /// The same, to be planned for as if it were larger by this margin on all sides, in metres.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/margin`) if the margin is not a finite number from 0 to 1e6.
    pub fn with_margin(self, margin: f64) -> Result<Self, Error> {
        Ok(Self { margin: checked_margin(margin)?, ..self })
    }

    /// The radius, in metres.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// By how much it is planned for as larger, in metres.
    pub fn margin(&self) -> f64 {
        self.margin
    }

    /// The distance from the centre that is kept free: radius and margin, in metres.
    pub fn kept_radius(&self) -> f64 {
        self.radius + self.margin
    }

    /// The parts of the robot at `q`.
    ///
    /// # Panics
    /// If `q` has fewer than two entries.
    pub fn footprint(&self, q: &[f64]) -> Vec<Part> {
        vec![Part::Disc { center: Point::new(q[0], q[1]), radius: self.radius }]
    }
}
