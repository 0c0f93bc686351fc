//! Joints in the middle of a stretch of motion, and how far they can get from there.
//!
//! Let p, v and -a be place, velocity and acceleration of a joint in the middle of a stretch of half-length h, where a is
//! the sum of L_j w_j^2 e_j over the links before it (e_j the unit vector along link j, w_j its absolute rate). Its third
//! derivative is at most W = sum of L_j |w_j|^3, so for every unit direction n, by Taylor's theorem,
//! n.p(t) >= n.p - h |n.v| - h^2/2 max(n.a, 0) - h^3/6 W on the whole stretch. Every point of a link is a fixed mix of its
//! two ends, so what holds for both ends holds for the link.

use crate::geometry::{Aabb, Point, Vector};

/// A joint in the middle of a stretch of half-length h.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Joint {
    /// p.
    pub x: f64,
    pub y: f64,
    /// h v.
    pub go_x: f64,
    pub go_y: f64,
    /// h^2 / 4 times a: max(x, 0) is (x + |x|) / 2.
    pub bend_x: f64,
    pub bend_y: f64,
    /// h^3 / 6 times W.
    pub rest: f64,
}

impl Joint {
    /// The joint that does not move.
    pub fn base(at: Point) -> Self {
        Self { x: at.x, y: at.y, ..Self::default() }
    }

    /// The outer end of a link behind this joint: its unit vector, its length, its absolute turn over h, and L |w h|^3 / 6
    /// summed up to it.
    #[inline(always)]
    pub fn next(&self, along: Vector, length: f64, turn: f64, rest: f64) -> Self {
        let (x, y) = (along.x * length, along.y * length);
        let (swing_x, swing_y) = (x * turn, y * turn);
        let bend = 0.25 * turn;
        Self {
            x: self.x + x,
            y: self.y + y,
            go_x: self.go_x - swing_y,
            go_y: self.go_y + swing_x,
            bend_x: self.bend_x + swing_x * bend,
            bend_y: self.bend_y + swing_y * bend,
            rest,
        }
    }

    pub fn place(&self) -> Point {
        Point::new(self.x, self.y)
    }

    /// How far the joint is along the unit direction `n`.
    #[inline(always)]
    pub fn along(&self, n: Vector) -> f64 {
        n.x * self.x + n.y * self.y
    }

    /// How far the joint can fall behind its middle in the unit direction `n`.
    #[inline(always)]
    pub fn fall(&self, n: Vector) -> f64 {
        let bend = n.x * self.bend_x + n.y * self.bend_y;
        (n.x * self.go_x + n.y * self.go_y).abs() + (bend + bend.abs()) + self.rest
    }

    /// A box that holds the joint on the whole stretch.
    #[inline(always)]
    pub fn swept_box(&self) -> Aabb {
        let (shift_x, shift_y) = (self.go_x.abs() + self.rest, self.go_y.abs() + self.rest);
        let (bend_x, bend_y) = (self.bend_x.abs(), self.bend_y.abs());
        // Falling below costs the part of a that points up, rising above the part that points down.
        Aabb {
            min: Point::new(self.x - (shift_x + (bend_x + self.bend_x)), self.y - (shift_y + (bend_y + self.bend_y))),
            max: Point::new(self.x + (shift_x + (bend_x - self.bend_x)), self.y + (shift_y + (bend_y - self.bend_y))),
        }
    }
}
