//! Rays that are tangent to a circle, or leave a point: intervals of them, and what they pass.

use super::circles::{Circle, Turn};
use crate::geometry::{Disc, Point, Segment, Vector};

/// By how much an interval of rays is wider on either side than found, in radians: what covers rounding.
pub(super) const SLACK: f64 = 1e-12;

/// How far before its beginning, in radii, a ray may cross a side for rounding.
const NEARLY: f64 = 1e-6;

/// The outermost rays of an interval: left normals of length 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rays {
    pub left: Vector,
    pub right: Vector,
}

impl Rays {
    /// Those that leave a circle with a turn between two angles.
    pub fn from_arc(turn: Turn, angles: [f64; 2]) -> Self {
        let [right, left] = angles.map(|angle| {
            let (sin, cos) = libm::sincos(angle);
            -turn.sign() * Vector::new(cos, sin)
        });
        Self { left, right }
    }

    /// Is the normal that of a ray between them, or nearly? They are less than half a turn apart.
    pub fn contain(&self, normal: &Vector) -> bool {
        self.right.perp(normal) >= -SLACK
            && normal.perp(&self.left) >= -SLACK
            && (self.right.dot(normal) >= -SLACK || self.left.dot(normal) >= -SLACK)
    }

    /// The normal of the ray in the middle.
    pub fn middle(&self) -> Vector {
        (self.left + self.right).normalize()
    }
}

/// Rays that leave a part of an arc.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source {
    pub root: u32,
    pub circle: Circle,
    pub turn: Turn,
    /// A point that the path has passed when it leaves, and the length of the path to there.
    pub point: Point,
    pub length: f64,
}

impl Source {
    /// A point from which a path begins.
    pub fn at(point: Point) -> Self {
        Self { root: 0, circle: Circle::point(point), turn: Turn::Left, point, length: 0.0 }
    }

    /// The signed distance of the circle's centre to the left of its rays.
    pub fn offset(&self) -> f64 {
        self.turn.sign() * self.circle.disc.radius
    }

    /// The rays of an interval that have a point on one side: 1 is the left, -1 the right.
    fn beside(&self, rays: &Rays, point: Point, side: f64) -> Option<Rays> {
        let at = point - self.circle.disc.center;
        let [left, right] = [rays.left, rays.right].map(|normal| side * (normal.dot(&at) + self.offset()));
        let [near, far] = if side > 0.0 { [left, right] } else { [right, left] };
        if near >= 0.0 {
            // If it is not on this side of all rays, it is behind them.
            return Some(*rays);
        }
        if far < 0.0 {
            return None;
        }
        // The outermost ray goes through the point, unless this is in the circle.
        let limit = outermost(&at, -self.offset());
        Some(limit.map_or(*rays, |limit| {
            if side > 0.0 { Rays { left: limit, ..*rays } } else { Rays { right: limit, ..*rays } }
        }))
    }

    /// The rays of an interval that go through the open part of a side, which is seen from the right to the left.
    pub fn through(&self, rays: &Rays, [right, left]: [Point; 2]) -> Option<Rays> {
        self.beside(rays, left, 1.0).and_then(|rays| self.beside(&rays, right, -1.0))
    }

    /// Whether a ray of an interval may touch a disc on its left, and on its right; false is certain.
    pub fn may_touch(&self, rays: &Rays, disc: &Disc) -> [bool; 2] {
        let at = disc.center - self.circle.disc.center;
        let both = [rays.left, rays.right];
        if both.iter().any(|normal| along(normal).dot(&at) < 0.0) {
            return [true; 2];
        }
        // What is ahead of all rays is the higher the farther a ray is to the right.
        let [low, high] = both.map(|normal| normal.dot(&at) + self.offset());
        let slack = SLACK * (at.x.abs() + at.y.abs());
        [disc.radius, -disc.radius].map(|height| low - slack <= height && height <= high + slack)
    }

    /// Does the ray cross the side after the point where it begins, or nearly there?
    pub fn crosses(&self, normal: &Vector, side: &Segment) -> bool {
        let (across, at) = (side.b - side.a, side.a - self.circle.disc.center);
        // In two terms, of which the first is exactly 0 if an end of the side is the centre.
        let part = (across.perp(&at) + self.offset() * across.perp(normal)) / across.perp(&along(normal));
        part >= -NEARLY * self.circle.disc.radius
    }
}

/// The direction of a ray.
fn along(normal: &Vector) -> Vector {
    Vector::new(normal.y, -normal.x)
}

/// The unit vector to the left of another one whose product with it is a height; `None` if there is none.
pub(super) fn outermost(between: &Vector, height: f64) -> Option<Vector> {
    let distance = between.norm();
    if height.abs() >= distance {
        return None;
    }
    let (cos, unit) = (height / distance, between / distance);
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    Some(cos * unit + sin * Vector::new(-unit.y, unit.x))
}
