//! Boxes, discs and segments.

use super::{Point, Vector};
use serde::Serialize;

/// A closed box with sides along the axes, in metres.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Aabb {
    /// The corner with the smallest coordinates.
    pub min: Point,
    /// The corner with the largest coordinates.
    pub max: Point,
}

impl Aabb {
    /// The smallest box around both points.
    pub fn of(a: Point, b: Point) -> Self {
        Self { min: Point::new(a.x.min(b.x), a.y.min(b.y)), max: Point::new(a.x.max(b.x), a.y.max(b.y)) }
    }

    /// The smallest box around all points; `None` without a point.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        points.into_iter().map(|p| Self { min: p, max: p }).reduce(|a, b| a.union(&b))
    }

    /// The smallest box around both boxes.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        Self {
            min: Point::new(self.min.x.min(other.min.x), self.min.y.min(other.min.y)),
            max: Point::new(self.max.x.max(other.max.x), self.max.y.max(other.max.y)),
        }
    }

    /// The box grown by `margin` metres on every side.
    #[must_use]
    pub fn grown(&self, margin: f64) -> Self {
        Self {
            min: Point::new(self.min.x - margin, self.min.y - margin),
            max: Point::new(self.max.x + margin, self.max.y + margin),
        }
    }

    /// Whether the boxes share a point.
    #[inline]
    pub fn intersects(&self, other: &Self) -> bool {
        self.min.x <= other.max.x && other.min.x <= self.max.x && self.min.y <= other.max.y && other.min.y <= self.max.y
    }

    /// Whether the point lies in the box or on its border.
    pub fn contains(&self, p: Point) -> bool {
        self.min.x <= p.x && p.x <= self.max.x && self.min.y <= p.y && p.y <= self.max.y
    }

    /// The squared distance between the boxes, in square metres; 0 if they share a point.
    #[inline]
    pub fn gap_squared(&self, other: &Self) -> f64 {
        let x = (other.min.x - self.max.x).max(self.min.x - other.max.x).max(0.0);
        let y = (other.min.y - self.max.y).max(self.min.y - other.max.y).max(0.0);
        x * x + y * y
    }

    /// How far the point is from the nearest side: positive inside, negative outside, in metres.
    pub fn depth(&self, p: Point) -> f64 {
        (p.x - self.min.x).min(self.max.x - p.x).min(p.y - self.min.y).min(self.max.y - p.y)
    }

    /// The longer side, in metres.
    pub fn longer_side(&self) -> f64 {
        (self.max.x - self.min.x).max(self.max.y - self.min.y)
    }
}

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

    /// The unit normal to the right; not a number if the ends are equal. Scaled first: the squares of a very short segment would
    /// underflow, and its normal would not be of unit length.
    pub(crate) fn normal(&self) -> Vector {
        let along = self.b - self.a;
        let along = (along / along.amax()).normalize();
        Vector::new(along.y, -along.x)
    }
}
