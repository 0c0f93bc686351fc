//! A trajectory prepared for tests against others: its shape, and boxes around its pieces.

use super::particle::{Model, Particle};
use crate::geometry::{Aabb, Point, Segment, Vector};
use std::f64::consts::{FRAC_PI_2, PI};

/// Arcs whose radius is at most this many times the scale of the world have a usable centre; beyond that they are nearly straight
/// and are halved instead.
const FARTHEST_CENTER: f64 = 64.0;

/// The shape of a trajectory, for the tests of crossing.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    /// A segment, perhaps a point, and the unit vector along it.
    Straight(Segment, Vector),
    /// A circular arc.
    Arc(Arc),
    /// Another curve, or an arc whose centre is too far away.
    Curve,
}

/// A prepared trajectory.
#[derive(Debug, Clone, Copy)]
pub(super) struct Track {
    pub particle: Particle,
    pub shape: Shape,
    /// Contains the whole trajectory.
    pub around: Aabb,
}

impl Track {
    /// Prepares a trajectory in a world of that scale, in metres.
    #[inline(never)]
    pub fn new(particle: Particle, scale: f64) -> Self {
        let shape = if particle.is_straight() {
            let (sin, cos) = libm::sincos(particle.theta);
            let chord = Segment::new(particle.start, particle.position(particle.duration));
            Shape::Straight(chord, Vector::new(cos, sin))
        } else if particle.model == Model::Arc && particle.speed <= FARTHEST_CENTER * scale * particle.turn_rate.abs() {
            Shape::Arc(Arc::of(&particle))
        } else {
            Shape::Curve
        };
        let mut around = Aabb::of(particle.start, particle.start);
        let track = Self { particle, shape, around };
        // Eight pieces enclose a turn closely.
        track.boxes(8, &mut |piece| around = around.union(&piece));
        Self { around, ..track }
    }

    /// Boxes that together contain the trajectory, one for each of `count` pieces of equal duration. Rounding is not covered.
    pub fn boxes(&self, count: u32, each: &mut dyn FnMut(Aabb)) {
        let particle = &self.particle;
        let count = if particle.travel() == 0.0 { 1 } else { count };
        let length = particle.duration / f64::from(count);
        let departure = match self.shape {
            Shape::Straight(..) => 0.0,
            _ => particle.acceleration(particle.duration) * length * length / 8.0,
        };
        let mut from = particle.start;
        for i in 1..=count {
            let to = particle.position(particle.duration * (f64::from(i) / f64::from(count)));
            each(Aabb::of(from, to).grown(departure));
            from = to;
        }
    }
}

/// A closed circular arc, at most the whole circle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arc {
    pub center: Point,
    pub radius: f64,
    pub start: Point,
    pub end: Point,
    /// The direction from the centre to the middle of the arc.
    middle: Vector,
    /// The arc contains the directions within this distance of the middle, as the square of a chord of the unit circle, if it is
    /// at most half the circle; else those at least this far from the opposite of the middle. So the chord is never near a
    /// diameter, which would separate directions badly.
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
    /// The arc of a particle that moves and turns. The centre has an error of a few units in the last place of the largest
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
        let end = particle.position(duration);
        Self { center, radius, start, end, middle: Vector::new(cos, sin), chord_squared: chord * chord, extent }
    }

    /// Whether the arc has a point in this direction, a unit vector, from its centre.
    pub fn contains(&self, direction: Vector) -> bool {
        match self.extent {
            Extent::AtMostHalf => (direction - self.middle).norm_squared() <= self.chord_squared,
            Extent::MoreThanHalf => (direction + self.middle).norm_squared() >= self.chord_squared,
            Extent::Whole => true,
        }
    }

    /// The distance from the point to the arc, in metres: along the ray from the centre if the arc has a point on it, otherwise
    /// to the nearer end.
    pub fn distance(&self, p: Point) -> f64 {
        let from_center = p - self.center;
        let away = from_center.norm();
        // From the centre itself every point of the arc is equally far.
        if away == 0.0 || self.contains(from_center / away) {
            return (away - self.radius).abs();
        }
        (p - self.start).norm().min((p - self.end).norm())
    }
}
