//! A point of the robot in the middle of an interval of motion, and how far it can get from there.
//!
//! Let p, v and -a be position, velocity and acceleration of the point in the middle of an interval of half-length h, and W a
//! bound on the length of its third derivative. By Taylor's theorem, for every unit vector n,
//!
//! n.p(t) >= n.p - h |n.v| - h^2/2 max(n.a, 0) - h^3/6 W on the whole interval.
//!
//! Every point of a convex part is a fixed convex combination of its corners, so a bound that holds for the corners holds for
//! the part.
//!
//! Numbers are computed for both halves of an interval at once, the front half in the first lane of [`Halves`].

use crate::geometry::{Aabb, Point, Vector};
use crate::space::Lanes;
use std::ops::{Add, Mul, Neg, Sub};
use wide::f64x2;

/// A number for each half of an interval, the front one first.
pub(in crate::collision) type Halves = f64x2;

/// A bit for each half.
pub(in crate::collision) const BOTH: u32 = 0b11;

/// A vector of the plane, or one in each lane.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct Plane<T> {
    pub x: T,
    pub y: T,
}

impl<T: Lanes> Plane<T> {
    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(v: Vector) -> Self {
        Self { x: T::splat(v.x), y: T::splat(v.y) }
    }

    /// The scalar product, always in this order of operations.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y
    }

    /// The vector turned by a right angle to the left.
    #[inline(always)]
    pub fn left(self) -> Self {
        Self { x: T::splat(0.0) - self.y, y: self.x }
    }

    /// The vector turned by the angle of the unit vector `by`.
    #[inline(always)]
    pub fn rotated(self, by: Self) -> Self {
        Self { x: self.x * by.x - self.y * by.y, y: self.y * by.x + self.x * by.y }
    }
}

impl Plane<Halves> {
    pub const ZERO: Self = Self { x: Halves::ZERO, y: Halves::ZERO };

    /// The vector of one half.
    #[inline(always)]
    pub fn half(&self, half: usize) -> Vector {
        Vector::new(self.x.to_array()[half], self.y.to_array()[half])
    }
}

impl<T: Lanes> Add for Plane<T> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<T: Lanes> Sub for Plane<T> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<T: Lanes> Mul<T> for Plane<T> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

impl<T: Lanes> Neg for Plane<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: T::splat(0.0) - self.x, y: T::splat(0.0) - self.y }
    }
}

/// A point in the middle of each half of an interval; h is half the length of such a half.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct MovingPoint {
    /// p.
    pub position: Plane<Halves>,
    /// h v.
    pub velocity: Plane<Halves>,
    /// h^2/4 a; h^2/2 max(x, 0) is then x + |x|.
    pub acceleration: Plane<Halves>,
    /// h^3/6 W, of both halves.
    pub remainder: f64,
}

impl MovingPoint {
    /// A point that does not move.
    #[inline(always)]
    pub fn at_rest(position: Plane<Halves>) -> Self {
        Self { position, velocity: Plane::ZERO, acceleration: Plane::ZERO, remainder: 0.0 }
    }

    /// Where it is in the middle of a half.
    pub fn place(&self, half: usize) -> Point {
        Point::from(self.position.half(half))
    }

    /// How far the point can retreat from its position in the unit direction `n`.
    #[inline(always)]
    pub fn retreat(&self, n: Plane<Halves>) -> Halves {
        let acceleration = n.dot(self.acceleration);
        n.dot(self.velocity).abs() + (acceleration + acceleration.abs()) + Halves::splat(self.remainder)
    }

    /// Boxes that hold the point on each half: the least x and y, then the largest.
    #[inline(always)]
    pub fn swept_box(&self) -> [Plane<Halves>; 2] {
        let [min_x, max_x] = self.range(self.position.x, self.velocity.x, self.acceleration.x);
        let [min_y, max_y] = self.range(self.position.y, self.velocity.y, self.acceleration.y);
        [Plane { x: min_x, y: min_y }, Plane { x: max_x, y: max_y }]
    }

    /// The least and the largest coordinate on one axis.
    #[inline(always)]
    fn range(&self, p: Halves, velocity: Halves, acceleration: Halves) -> [Halves; 2] {
        let shift = velocity.abs() + Halves::splat(self.remainder);
        let bend = acceleration.abs();
        // Retreat takes the part of a that points forward, advance the part that points back.
        [p - (shift + (bend + acceleration)), p + (shift + (bend - acceleration))]
    }

    /// Of all positions that the bound allows on a half, the least in the direction `n`, as a unit vector.
    pub fn rearmost(&self, half: usize, n: Vector) -> Vector {
        let [position, velocity, acceleration] =
            [self.position, self.velocity, self.acceleration].map(|v| v.half(half));
        let velocity = if n.dot(&velocity) > 0.0 { velocity } else { -velocity };
        let acceleration = if n.dot(&acceleration) > 0.0 { acceleration * 2.0 } else { Vector::zeros() };
        position - velocity - acceleration - n * self.remainder
    }
}

/// The box around both halves' boxes.
#[inline(always)]
pub(in crate::collision) fn around([min, max]: [Plane<Halves>; 2]) -> Aabb {
    let [front, back] = Halves::transpose([min.x, min.y]);
    let min = front.lesser(back).to_array();
    let [front, back] = Halves::transpose([max.x, max.y]);
    let max = front.greater(back).to_array();
    Aabb { min: min.into(), max: max.into() }
}
