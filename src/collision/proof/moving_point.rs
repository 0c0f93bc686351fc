//! A point of the robot in the middle of an interval of motion, and how far it can get from there.
//!
//! Let p, v and -a be position, velocity and acceleration of the point in the middle of an interval of half-length h, and W a
//! bound on the length of its third derivative. By Taylor's theorem, for every unit vector n,
//!
//! n.p(t) >= n.p - h |n.v| - h^2/2 max(n.a, 0) - h^3/6 W on the whole interval.
//!
//! Every point of a convex part is a fixed convex combination of its corners, so a bound that holds for the corners holds for
//! the part.

use crate::geometry::{Aabb, Point, Vector};

/// A point in the middle of an interval of half-length h.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::collision) struct MovingPoint {
    /// p.
    pub position: Vector,
    /// h v.
    pub velocity: Vector,
    /// h^2/4 a; h^2/2 max(x, 0) is then x + |x|.
    pub acceleration: Vector,
    /// h^3/6 W.
    pub remainder: f64,
}

impl MovingPoint {
    /// A point that does not move.
    pub fn at_rest(at: Point) -> Self {
        Self { position: at.coords, ..Self::default() }
    }

    pub fn place(&self) -> Point {
        Point::from(self.position)
    }

    /// How far the point can retreat from its position in the unit direction `n`.
    #[inline(always)]
    pub fn retreat(&self, n: Vector) -> f64 {
        let acceleration = dot(n, self.acceleration);
        dot(n, self.velocity).abs() + (acceleration + acceleration.abs()) + self.remainder
    }

    /// The point that far back: of all that the bound allows, the least in the direction `n`.
    #[inline(always)]
    pub fn rearmost(&self, n: Vector) -> Vector {
        let velocity = if dot(n, self.velocity) > 0.0 { self.velocity } else { -self.velocity };
        let acceleration = if dot(n, self.acceleration) > 0.0 { self.acceleration * 2.0 } else { Vector::zeros() };
        self.position - velocity - acceleration - n * self.remainder
    }

    /// A box that holds the point on the whole interval.
    #[inline(always)]
    pub fn swept_box(&self) -> Aabb {
        let range = |p: f64, velocity: f64, acceleration: f64| {
            let shift = velocity.abs() + self.remainder;
            let bend = acceleration.abs();
            // Retreat takes the part of a that points forward, advance the part that points back.
            [p - (shift + (bend + acceleration)), p + (shift + (bend - acceleration))]
        };
        let [min_x, max_x] = range(self.position.x, self.velocity.x, self.acceleration.x);
        let [min_y, max_y] = range(self.position.y, self.velocity.y, self.acceleration.y);
        Aabb { min: Point::new(min_x, min_y), max: Point::new(max_x, max_y) }
    }
}

/// The scalar product, always in this order of operations.
#[inline(always)]
pub(in crate::collision) fn dot(a: Vector, b: Vector) -> f64 {
    a.x * b.x + a.y * b.y
}

/// The vector turned by a right angle to the left.
#[inline(always)]
pub(in crate::collision) fn left_of(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}
