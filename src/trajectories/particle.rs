//! A particle with constant speed and constant turn rate.

use crate::error::{Code, Error, Number};
use crate::geometry::{Point, arc_pose};
use strum::VariantArray;

/// How far a particle may turn over its duration, in radians, and how large its heading may be: rounding stays below the slack.
pub const MOST_TURNING: f64 = 100.0;

/// The largest coordinate, travel, speed, turn rate and duration of a particle, in metres, radians and seconds.
const LARGEST: f64 = 1e6;

/// How a particle moves.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr, strum::VariantNames, strum::VariantArray,
)]
#[strum(serialize_all = "kebab-case")]
pub enum Model {
    /// x' = v cos theta, y' = v sin theta, theta' = w: a circular arc, straight where w is 0.
    Arc,
    /// p(t) = p(0) + v t (cos(theta + w t), sin(theta + w t)): a spiral of Archimedes about its start. A rule met in place of
    /// the arc where the heading of the moment is taken for that of the whole way.
    Spiral,
}

impl Model {
    /// Every model, in the order of their numbers.
    pub const ALL: &[Model] = Model::VARIANTS;

    /// The name of the model, the same everywhere.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}

/// A particle: where it starts, how it moves, for how long.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    /// How it moves.
    pub model: Model,
    /// Where it starts, in metres.
    pub start: Point,
    /// Its first heading, in radians.
    pub theta: f64,
    /// Its speed, in metres a second; at least 0.
    pub speed: f64,
    /// Its turn rate, in radians a second, counter-clockwise.
    pub turn_rate: f64,
    /// How long it moves, in seconds; at least 0.
    pub duration: f64,
}

impl Particle {
    /// Refuses what is out of range: coordinates, turn rates, speeds, durations and speed x duration up to a million, speed
    /// and duration not negative, the heading and turn rate x duration up to [`MOST_TURNING`] radians.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with the pointer `/x`, `/y`, `/theta`, `/v`, `/w` or `/duration`.
    pub fn check(&self) -> Result<(), Error> {
        let Self { start, theta, speed, turn_rate, duration, .. } = *self;
        let ranges = [
            ("x", start.x, -LARGEST, LARGEST),
            ("y", start.y, -LARGEST, LARGEST),
            ("theta", theta, -MOST_TURNING, MOST_TURNING),
            ("v", speed, 0.0, LARGEST),
            ("w", turn_rate, -LARGEST, LARGEST),
            ("duration", duration, 0.0, LARGEST),
        ];
        for (name, value, min, max) in ranges {
            if !(min..=max).contains(&value) {
                let code = if value.is_finite() { Code::OutOfRange } else { Code::NotFinite };
                let [min, max, value] = [min, max, value].map(Number);
                let sentence = format!("{name} must lie within [{min}, {max}], not {value}");
                return Err(Error::new(code, format!("/{name}"), sentence));
            }
        }
        let too_long = |what: &str, value: f64, most: f64| {
            let sentence = format!("{what} x duration must be at most {}, not {}", Number(most), Number(value));
            Err(Error::new(Code::OutOfRange, "/duration", sentence))
        };
        let (travel, turn) = (speed * duration, turn_rate.abs() * duration);
        if travel > LARGEST {
            return too_long("v", travel, LARGEST);
        }
        if turn > MOST_TURNING {
            return too_long("|w|", turn, MOST_TURNING);
        }
        Ok(())
    }

    /// Where it is at `time` seconds. Exact but for rounding: the arc is a chord, written so that nothing cancels where the
    /// turn is small.
    #[inline(never)]
    pub fn place(&self, time: f64) -> Point {
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

    /// How far it is from its start at most, in metres.
    pub(super) fn travel(&self) -> f64 {
        self.speed * self.duration
    }

    /// The largest coordinate plus the travel, in metres: what the slack is measured by.
    pub(super) fn scale(&self) -> f64 {
        self.start.x.abs().max(self.start.y.abs()) + self.travel()
    }

    /// Whether it moves along a straight line, or not at all.
    pub(super) fn is_straight(&self) -> bool {
        self.turn_rate == 0.0 || self.travel() == 0.0
    }

    /// A bound on its acceleration up to `time`, in metres a second squared: v |w| on the arc. On the spiral the derivative of
    /// v e + v t w e' is 2 v w e' - v t w^2 e, with e and e' unit vectors at right angles; its length is below the sum.
    pub(super) fn acceleration(&self, time: f64) -> f64 {
        let turn_rate = self.turn_rate.abs();
        let bend = self.speed * turn_rate;
        match self.model {
            Model::Arc => bend,
            Model::Spiral => bend * (2.0 + turn_rate * time),
        }
    }

    /// A bound on its speed at all times, in metres a second.
    pub(super) fn fastest(&self) -> f64 {
        match self.model {
            Model::Arc => self.speed,
            Model::Spiral => self.speed * (1.0 + self.turn_rate.abs() * self.duration),
        }
    }
}
