//! A straight segment between two points.

use super::{Aabb, Point};

/// A closed segment; both ends may coincide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// One end, in metres.
    pub a: Point,
    /// The other end, in metres.
    pub b: Point,
}

impl Segment {
    /// The segment between the two points.
    pub fn new(a: Point, b: Point) -> Self {
        Self { a, b }
    }

    /// The smallest box around the segment.
    pub fn aabb(&self) -> Aabb {
        Aabb::of(self.a, self.b)
    }
}
