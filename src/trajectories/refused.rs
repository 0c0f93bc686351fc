//! A trajectory that was tried and refused.

use super::particle::Particle;
use crate::geometry::Point;

/// A trajectory that crosses an earlier one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refused {
    /// What was tried.
    pub particle: Particle,
    /// The first of the accepted trajectories that it crosses, by its number from 0.
    pub other: u32,
    /// Where it crosses it, or comes too close; one such place.
    pub place: Point,
}

impl Refused {
    /// Nine numbers: x, y, theta, v, w, duration, the number of the other, and the place.
    pub fn numbers(&self) -> [f64; 9] {
        let [x, y, theta, v, w, duration] = self.particle.numbers();
        [x, y, theta, v, w, duration, f64::from(self.other), self.place.x, self.place.y]
    }
}
