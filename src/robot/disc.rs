//! A disc that translates; a point where its radius is 0.

use super::Part;
use crate::error::{Code, Error};
use crate::geometry::Point;

/// A disc robot. A configuration is the centre (x, y), in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct DiscRobot {
    radius: f64,
}

impl DiscRobot {
    /// A disc of the given radius in metres, 0 for a point.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/radius`) where the radius is not a finite number from 0 to 1e6.
    pub fn new(radius: f64) -> Result<Self, Error> {
        super::arm::check_radius(radius)?;
        Ok(Self { radius: radius + 0.0 })
    }

    /// The radius, in metres.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The parts of the robot at `q`.
    ///
    /// # Panics
    /// Where `q` has fewer than two entries.
    pub fn footprint(&self, q: &[f64]) -> Vec<Part> {
        vec![Part::Disc { center: Point::new(q[0], q[1]), radius: self.radius }]
    }
}

/// The error for a coordinate, length or radius that is not finite.
pub(super) fn not_finite(pointer: &str, what: &str, value: f64) -> Error {
    Error::new(Code::NotFinite, pointer, format!("{what} must be a finite number, not {value}"))
}
