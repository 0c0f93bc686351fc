//! The places of one particle, for whoever draws it or asks what a motion is.

use super::options::{number, row};
use super::particle::{Model, Particle};
use crate::decimal::Decimal;
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::parameters::{Fallback, Kind, ParameterInfo, Parameters, Value};
use std::f64::consts::FRAC_PI_4;

/// What is told of a particle.
const PARTICLE: &[ParameterInfo] = &[
    row("model", "Motion", Kind::Choice(&["arc", "spiral"]), "", Fallback::Text("arc"), "How it moves."),
    number("x", "x", [-1e6, 1e6, 0.0], "m", "Where it starts."),
    number("y", "y", [-1e6, 1e6, 0.0], "m", "Where it starts."),
    number("theta", "Heading", [-100.0, 100.0, 0.0], "rad", "Its first heading."),
    number("v", "Speed", [0.0, 1e6, 1.0], "m/s", "Its speed."),
    number("w", "Turn rate", [-1e6, 1e6, FRAC_PI_4], "rad/s", "Its turn rate, counter-clockwise."),
];

/// The longest time asked for, in seconds.
const LONGEST: f64 = 1e6;

/// The places, x and y each, of a particle at these times, in seconds. The particle is told by `model` ("arc" or "spiral"), `x`,
/// `y`, `theta`, `v` and `w`; defaults are 0, but 1 m/s and pi / 4 rad/s.
///
/// # Errors
/// `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name` or `/times/i`.
pub fn particle_points(given: &[(String, Value)], times: &[f64]) -> Result<Vec<f64>, Error> {
    let parameters = Parameters::resolve(PARTICLE, given)?;
    let number = |name: &str| parameters.number(name).expect("every default is a number") + 0.0;
    let particle = Particle {
        model: if parameters.text("model") == Some("spiral") { Model::Spiral } else { Model::Arc },
        start: Point::new(number("x"), number("y")),
        theta: number("theta"),
        speed: number("v"),
        turn_rate: number("w"),
        duration: 0.0,
    };
    let mut points = Vec::with_capacity(2 * times.len());
    for (i, &time) in times.iter().enumerate() {
        if !(0.0..=LONGEST).contains(&time) {
            let code = if time.is_finite() { Code::OutOfRange } else { Code::NotFinite };
            let [most, time] = [LONGEST, time].map(Decimal);
            let sentence = format!("a time must lie within [0, {most}] seconds, not {time}");
            return Err(Error::new(code, format!("/times/{i}"), sentence));
        }
        let place = particle.place(time);
        points.extend([place.x + 0.0, place.y + 0.0]);
    }
    Ok(points)
}
