//! The places of one particle, for whoever draws it or asks what a motion is.

use super::particle::{Model, Particle};
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::options::{Options, Value};
use std::f64::consts::FRAC_PI_4;

crate::options! {
    /// A particle.
    pub struct ParticleOptions for &[];
    /// How it moves.
    model: Model = Model::Arc, "Motion";
    /// Where it starts.
    x: f64 = 0.0, in -1e6..=1e6, "x", unit "m";
    /// Where it starts.
    y: f64 = 0.0, in -1e6..=1e6, "y", unit "m";
    /// Its first heading.
    theta: f64 = 0.0, in -100.0..=100.0, "Heading", unit "rad";
    /// Its speed.
    v: f64 = 1.0, in 0.0..=1e6, "Speed", unit "m/s";
    /// Its turn rate, counter-clockwise.
    w: f64 = FRAC_PI_4, in -1e6..=1e6, "Turn rate", unit "rad/s";
}

/// The longest time asked for, in seconds.
const LONGEST: f64 = 1e6;

/// The places, x and y each, of a particle at these times, in seconds. The particle is told by `model` ("arc" or "spiral"), `x`,
/// `y`, `theta`, `v` and `w`; defaults are 0, but 1 m/s and pi / 4 rad/s.
///
/// # Errors
/// `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name` or `/times/i`.
pub fn particle_points(given: &[(String, Value)], times: &[f64]) -> Result<Vec<f64>, Error> {
    let ParticleOptions { model, x, y, theta, v, w } = Options::read(given)?;
    let particle = Particle { model, start: Point::new(x, y), theta, speed: v, turn_rate: w, duration: 0.0 };
    let mut points = Vec::with_capacity(2 * times.len());
    for (i, &time) in times.iter().enumerate() {
        if !(0.0..=LONGEST).contains(&time) {
            let code = if time.is_finite() { Code::OutOfRange } else { Code::NotFinite };
            let sentence = format!("a time must lie within [0, {LONGEST}] seconds, not {time}");
            return Err(Error::new(code, format!("/times/{i}"), sentence));
        }
        let place = particle.place(time);
        points.extend([place.x + 0.0, place.y + 0.0]);
    }
    Ok(points)
}
