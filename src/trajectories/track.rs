//! A trajectory made ready to be tested against others: what shape it is, and boxes around its stretches.

use super::arc::Arc;
use super::particle::{Model, Particle};
use crate::geometry::{Aabb, Segment, Vector};

/// Arcs whose radius is at most this many times the scale of the world have a centre that can be computed with; beyond that
/// they are nearly straight and are halved instead.
const FARTHEST_CENTER: f64 = 64.0;

/// What a trajectory is, for the tests of crossing.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    /// A segment, perhaps a point, and the unit vector along it.
    Straight(Segment, Vector),
    /// A circular arc.
    Arc(Arc),
    /// Another curve, or an arc whose centre is too far away.
    Curve,
}

/// A trajectory made ready.
#[derive(Debug, Clone, Copy)]
pub(super) struct Track {
    pub particle: Particle,
    pub shape: Shape,
    /// Holds the whole trajectory.
    pub around: Aabb,
}

impl Track {
    /// Makes ready a trajectory in a world of that scale, in metres.
    #[inline(never)]
    pub fn new(particle: Particle, scale: f64) -> Self {
        let shape = if particle.is_straight() {
            let (sin, cos) = libm::sincos(particle.theta);
            let chord = Segment::new(particle.start, particle.place(particle.duration));
            Shape::Straight(chord, Vector::new(cos, sin))
        } else if particle.model == Model::Arc && particle.speed <= FARTHEST_CENTER * scale * particle.turn_rate.abs() {
            Shape::Arc(Arc::of(&particle))
        } else {
            Shape::Curve
        };
        let mut around = Aabb::of(particle.start, particle.start);
        let track = Self { particle, shape, around };
        // Eight stretches hold a turn closely.
        track.stretches(8, &mut |stretch| around = around.union(&stretch));
        Self { around, ..track }
    }

    /// Boxes that together hold the trajectory, one for each of so many stretches of equal duration. Rounding is not covered.
    pub fn stretches(&self, count: u32, each: &mut dyn FnMut(Aabb)) {
        let particle = &self.particle;
        let count = if particle.travel() == 0.0 { 1 } else { count };
        let length = particle.duration / f64::from(count);
        let departure = match self.shape {
            Shape::Straight(..) => 0.0,
            _ => particle.acceleration(particle.duration) * length * length / 8.0,
        };
        let mut from = particle.start;
        for i in 1..=count {
            let to = particle.place(particle.duration * (f64::from(i) / f64::from(count)));
            each(Aabb::of(from, to).grown(departure));
            from = to;
        }
    }
}
