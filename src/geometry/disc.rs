//! A closed disc.

use super::{Aabb, Point};
use serde::Serialize;

/// A closed, filled disc.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "type", rename = "disc")]
pub struct Disc {
    /// The centre, in metres.
    pub center: Point,
    /// The radius, in metres, at least 0.
    pub radius: f64,
}

impl Disc {
    /// The smallest box around the disc.
    pub fn aabb(&self) -> Aabb {
        Aabb { min: self.center, max: self.center }.grown(self.radius)
    }
}
