//! A disc that translates; a point if its radius is 0.

use super::Part;
use super::range::check_range;
use crate::error::Error;
use crate::geometry::Point;
use serde::Serialize;

/// A disc robot. A configuration is the centre (x, y), in metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiscRobot {
    radius: f64,
}

impl DiscRobot {
    /// A disc of the given radius in metres, 0 for a point.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/radius`) if the radius is not a finite number from 0 to 1e6.
    pub fn new(radius: f64) -> Result<Self, Error> {
        check_range("/radius", "a radius", radius, 0.0)?;
        Ok(Self { radius: radius + 0.0 })
    }

    /// The radius, in metres.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The parts of the robot at `q`.
    ///
    /// # Panics
    /// If `q` has fewer than two entries.
    pub fn footprint(&self, q: &[f64]) -> Vec<Part> {
        vec![Part::Disc { center: Point::new(q[0], q[1]), radius: self.radius }]
    }
}
