//! A particle with constant speed and constant turn rate, and its positions over time.

use crate::error::{Code, Error, Number};
use crate::geometry::{Point, arc_pose};
use crate::options::{Options, Value};
use std::f64::consts::FRAC_PI_4;

/// The largest turn of a particle over its duration, and its largest heading, in radians: rounding stays below the slack.
pub const MOST_TURNING: f64 = 100.0;

/// The largest travel and time of a particle, in metres and seconds.
const LARGEST: f64 = 1e6;

crate::choice! {
    /// How a particle moves.
    pub enum Model {
        /// x' = v cos theta, y' = v sin theta, theta' = w: a circular arc, straight if w is 0.
        Arc,
        /// p(t) = p(0) + v t (cos(theta + w t), sin(theta + w t)): a spiral of Archimedes about its start. It results if the
        /// current heading is mistaken for the direction of the whole motion.
        Spiral,
    }
}

/// A particle: its start, its motion and its duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    /// The rule of its motion.
    pub model: Model,
    /// Its start, in metres.
    pub start: Point,
    /// Its first heading, in radians.
    pub theta: f64,
    /// Its speed, in metres per second; at least 0.
    pub speed: f64,
    /// Its turn rate, in radians per second, counter-clockwise.
    pub turn_rate: f64,
    /// The duration of its motion, in seconds; at least 0.
    pub duration: f64,
}

impl Particle {
    /// Checks the ranges: coordinates, turn rates, speeds, durations and speed x duration up to a million, speed
    /// and duration not negative, the heading and turn rate x duration up to [`MOST_TURNING`] radians.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with the pointer `/x`, `/y`, `/theta`, `/v`, `/w` or `/duration`.
    pub fn check(&self) -> Result<(), Error> {
        let Self { model, start, theta, speed, turn_rate, duration } = *self;
        ParticleOptions { model, x: start.x, y: start.y, theta, v: speed, w: turn_rate }.check()?;
        check_time(duration, "/duration")?;
        for (what, rate, most) in [("v", speed, LARGEST), ("|w|", turn_rate.abs(), MOST_TURNING)] {
            if rate * duration > most {
                let [most, value] = [most, rate * duration].map(Number);
                let sentence = format!("{what} x duration must be at most {most}, not {value}");
                return Err(Error::new(Code::OutOfRange, "/duration", sentence));
            }
        }
        Ok(())
    }

    /// Its position at `time` seconds. Exact except for rounding: the arc is computed by its chord, and nothing cancels if the
    /// turn is small.
    #[inline(never)]
    pub fn position(&self, time: f64) -> Point {
        let Self { start, theta, speed, turn_rate, .. } = *self;
        match self.model {
            Model::Arc => {
                let [x, y, _] = arc_pose([start.x, start.y, theta], speed, turn_rate, time);
                Point::new(x, y)
            }
            Model::Spiral => {
                let (sin, cos) = libm::sincos(theta + turn_rate * time);
                let away = speed * time;
                Point::new(start.x + away * cos, start.y + away * sin)
            }
        }
    }

    /// Its six numbers: x, y, theta, v, w, duration.
    pub fn numbers(&self) -> [f64; 6] {
        [self.start.x, self.start.y, self.theta, self.speed, self.turn_rate, self.duration]
    }

    /// The length of its motion, in metres.
    pub(super) fn travel(&self) -> f64 {
        self.speed * self.duration
    }

    /// The largest coordinate plus the travel, in metres: the slack is relative to it.
    pub(super) fn scale(&self) -> f64 {
        self.start.x.abs().max(self.start.y.abs()) + self.travel()
    }

    /// Whether it moves along a straight line, or not at all.
    pub(super) fn is_straight(&self) -> bool {
        self.turn_rate == 0.0 || self.travel() == 0.0
    }

    /// A bound on its acceleration up to `time`, in metres per second squared: v |w| on the arc. On the spiral the derivative of
    /// v e + v t w e' is 2 v w e' - v t w^2 e, with e and e' unit vectors at right angles; its length is below the sum.
    pub(super) fn acceleration(&self, time: f64) -> f64 {
        let turn_rate = self.turn_rate.abs();
        let bend = self.speed * turn_rate;
        match self.model {
            Model::Arc => bend,
            Model::Spiral => bend * (2.0 + turn_rate * time),
        }
    }

    /// A bound on its speed at all times, in metres per second.
    pub(super) fn fastest(&self) -> f64 {
        match self.model {
            Model::Arc => self.speed,
            Model::Spiral => self.speed * (1.0 + self.turn_rate.abs() * self.duration),
        }
    }
}

crate::options! {
    /// A particle.
    pub struct ParticleOptions for &[];
    /// The rule of its motion.
    model: Model = Model::Arc, "Motion";
    /// Its start.
    x: f64 = 0.0, in -1e6..=1e6, "x", unit "m";
    /// Its start.
    y: f64 = 0.0, in -1e6..=1e6, "y", unit "m";
    /// Its first heading.
    theta: f64 = 0.0, in -100.0..=100.0, "Heading", unit "rad";
    /// Its speed.
    v: f64 = 1.0, in 0.0..=1e6, "Speed", unit "m/s";
    /// Its turn rate, counter-clockwise.
    w: f64 = FRAC_PI_4, in -1e6..=1e6, "Turn rate", unit "rad/s";
}

/// The positions (x, y) of a particle at these times, in seconds. The particle is given by `model` ("arc" or "spiral"), `x`,
/// `y`, `theta`, `v` and `w`; see [`ParticleOptions`] for the defaults.
///
/// # Errors
/// `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name` or `/times/i`.
pub fn particle_points(given: &[(String, Value)], times: &[f64]) -> Result<Vec<f64>, Error> {
    let ParticleOptions { model, x, y, theta, v, w } = Options::read(given)?;
    let particle = Particle { model, start: Point::new(x, y), theta, speed: v, turn_rate: w, duration: 0.0 };
    let mut points = Vec::with_capacity(2 * times.len());
    for (i, &time) in times.iter().enumerate() {
        check_time(time, &format!("/times/{i}"))?;
        let position = particle.position(time);
        points.extend([position.x + 0.0, position.y + 0.0]);
    }
    Ok(points)
}

fn check_time(time: f64, pointer: &str) -> Result<(), Error> {
    if (0.0..=LARGEST).contains(&time) {
        return Ok(());
    }
    let code = if time.is_finite() { Code::OutOfRange } else { Code::NotFinite };
    Err(Error::new(code, pointer, format!("a time must lie within [0, {LARGEST}] seconds, not {}", Number(time))))
}
