//! A circular arc as a set of points: which directions from its centre it holds, and how far a point is from it.

use super::particle::Particle;
use crate::geometry::{Point, Vector};
use std::f64::consts::{FRAC_PI_2, PI};

/// A closed circular arc, at most the whole circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arc {
    pub center: Point,
    pub radius: f64,
    pub start: Point,
    pub end: Point,
    /// The direction from the centre to the middle of the arc.
    middle: Vector,
    /// The arc holds the directions within this of the middle, as the square of a chord of the unit circle, where it is at
    /// most half the circle; else those that are at least this far from the opposite of the middle. So the chord is never
    /// near a diameter, where it would tell directions badly.
    chord_squared: f64,
    extent: Extent,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Extent {
    AtMostHalf,
    MoreThanHalf,
    Whole,
}

impl Arc {
    /// The arc of a particle that moves and turns. The centre is off by a few units in the last place of the largest
    /// coordinate plus the radius; the ends are those of the motion.
    pub fn of(particle: &Particle) -> Self {
        let Particle { start, theta, speed, turn_rate, duration, .. } = *particle;
        let left = if turn_rate < 0.0 { -1.0 } else { 1.0 };
        let (radius, turn) = (speed / turn_rate.abs(), turn_rate * duration);
        let (sin, cos) = libm::sincos(theta);
        let center = start + Vector::new(-sin, cos) * (left * radius);
        let (sin, cos) = libm::sincos(theta + 0.5 * turn - left * FRAC_PI_2);
        let size = turn.abs();
        let (extent, chord) = if size >= 2.0 * PI {
            (Extent::Whole, 0.0)
        } else if size <= PI {
            (Extent::AtMostHalf, 2.0 * libm::sin(0.25 * size))
        } else {
            (Extent::MoreThanHalf, 2.0 * libm::sin(0.25 * (2.0 * PI - size)))
        };
        let end = particle.place(duration);
        Self { center, radius, start, end, middle: Vector::new(cos, sin), chord_squared: chord * chord, extent }
    }

    /// Whether the arc has a point in this direction, a unit vector, from its centre.
    pub fn holds(&self, direction: Vector) -> bool {
        match self.extent {
            Extent::AtMostHalf => (direction - self.middle).norm_squared() <= self.chord_squared,
            Extent::MoreThanHalf => (direction + self.middle).norm_squared() >= self.chord_squared,
            Extent::Whole => true,
        }
    }

    /// The distance from the point to the arc, in metres: along the ray from the centre where the arc has a point on it,
    /// otherwise to the nearer end.
    pub fn distance(&self, p: Point) -> f64 {
        let from_center = p - self.center;
        let away = from_center.norm();
        // In the centre itself every point of the arc is equally far.
        if away == 0.0 || self.holds(from_center / away) {
            return (away - self.radius).abs();
        }
        (p - self.start).norm().min((p - self.end).norm())
    }
}
