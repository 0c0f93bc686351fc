//! The independent verifier of trajectories.
//!
//! It walks along the path of the result by itself and compares every piece with the edge, the blend or the motion that it is to
//! follow. Along each span between two knots a coordinate is a polynomial of the time; its velocity and its acceleration are
//! computed from the coefficients, at many times of the span, and where they are greatest. A robot that drives along its heading
//! is never to move in another direction. None of that uses the code that made or proved the trajectory; an arc is integrated
//! numerically.

mod follow;
mod span;

use self::follow::follows;
use self::span::KnotSpan;
use super::limits::{CarLimits, CoordinateLimits, DifferentialLimits, Limits, PlaneLimits};
use super::trajectory::Trajectory;
use crate::error::{Code, Error};
use crate::path::ResultDocument;
use crate::robot::Car;
use crate::scenario::{Robot, Scenario};
use serde_json::Value;

/// How far positions may be off, relative to the coordinates if these are larger than a metre or a radian; velocities, relative
/// to the fastest of the trajectory; and limits, relative to them.
const PLACED: f64 = 1e-8;
const LED: f64 = 1e-7;
const WITHIN: f64 = 1e-9;

/// The verdict on a trajectory.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "the trajectory may be invalid"]
pub enum Verdict {
    /// It follows the path of the result from rest to rest, without a jump of position or velocity, and within its limits.
    Valid {
        /// The duration, in seconds.
        duration: f64,
        /// The number of times that were examined.
        samples: u64,
        /// The largest share of its limit that a speed has.
        speed: f64,
        /// The largest share of its limit that an acceleration has.
        acceleration: f64,
    },
    /// It is refused.
    Invalid {
        /// The reason, naming the piece, counted from 0.
        why: String,
    },
}

impl Verdict {
    /// Whether the trajectory is valid.
    pub fn is_valid(&self) -> bool {
        matches!(self, Self::Valid { .. })
    }
}

/// Verifies a trajectory against the result whose path it follows. That this path is valid is for
/// [`path::verify`](crate::path::verify()) to decide.
///
/// # Errors
/// `invalid-result` (pointer `/scenario` or `/query`) if scenario, result and trajectory do not belong together. Everything else
/// that is wrong is a [`Verdict::Invalid`].
///
/// # Complexity
/// O(knots), some microseconds each.
pub fn verify(scenario: &Scenario, result: &ResultDocument, trajectory: &Trajectory) -> Result<Verdict, Error> {
    let names = [("scenario", trajectory.scenario(), &result.scenario), ("query", trajectory.query(), &result.query)];
    for (what, own, other) in names {
        if own != other {
            let sentence = format!("the trajectory is of {what} {own:?}, the result of {other:?}");
            return Err(Error::new(Code::InvalidResult, format!("/{what}"), sentence));
        }
    }
    result.check_scenario(scenario)?;
    Ok(match examine(scenario.robot(), result, trajectory) {
        Ok(Examined { samples, speed, acceleration }) => {
            Verdict::Valid { duration: trajectory.duration(), samples, speed, acceleration }
        }
        Err(why) => Verdict::Invalid { why },
    })
}

/// Reads the document of a trajectory and verifies it: what is wrong with its pieces is a verdict, too.
///
/// # Errors
/// Those of [`Trajectory::read`], but for `invalid-result` about the pieces, and those of [`verify`].
pub fn verify_document(scenario: &Scenario, result: &ResultDocument, tree: &Value) -> Result<Verdict, Error> {
    match Trajectory::read(tree, scenario) {
        Err(error) if error.code() == Code::InvalidResult && error.pointer().starts_with("/pieces") => {
            Ok(Verdict::Invalid { why: error.to_string() })
        }
        trajectory => verify(scenario, result, &trajectory?),
    }
}

/// What was found.
#[derive(Default)]
struct Examined {
    samples: u64,
    speed: f64,
    acceleration: f64,
}

fn examine(robot: &Robot, result: &ResultDocument, trajectory: &Trajectory) -> Result<Examined, String> {
    trajectory.limits().check(robot).map_err(|error| error.message().to_owned())?;
    follows(robot, result, trajectory)?;
    let mut examined = Examined::default();
    let mut clock = 0.0;
    // The last time, position and velocity of the span before.
    let mut before = (trajectory.configuration(0.0), vec![0.0; trajectory.dimension()]);
    let fastest = fastest(trajectory);
    for (i, piece) in trajectory.pieces().iter().enumerate() {
        for knots in piece.knots().windows(2) {
            let span = KnotSpan::new(piece, &knots[0], &knots[1]);
            let (mut worst, times) = (0.0_f64, span.times());
            for &time in &times {
                let [place, velocity, acceleration] = span.at(time);
                if time == 0.0 {
                    // The turn rate of a car jumps with the curvature of its path.
                    let count = if matches!(robot, Robot::Car(_)) { 2 } else { velocity.len() };
                    let size = largest(&place).max(1.0);
                    if !is_near(&place, &before.0, PLACED * size)
                        || !is_near(&velocity[..count], &before.1[..count], LED * fastest)
                    {
                        return Err(format!("piece {i}: position or velocity jumps at {clock} s"));
                    }
                }
                let state = trajectory.state(clock + time);
                let size = largest(&place).max(1.0) + fastest * clock * f64::EPSILON * 8.0;
                worst = worst.max(off(&state.configuration, &place) / size);
                examined.take(trajectory.limits(), robot, &velocity, &acceleration, i)?;
                before = (place, velocity);
            }
            if worst > PLACED {
                return Err(format!("piece {i}: the state at a time is {worst:e} off"));
            }
            clock += span.duration;
        }
    }
    if largest(&before.1) > LED * fastest || !is_rest(trajectory, 0.0) || !is_rest(trajectory, trajectory.duration()) {
        return Err("it does not begin and end at rest".into());
    }
    if (clock - trajectory.duration()).abs() > WITHIN * clock {
        return Err(format!("it lasts {clock} s, not {} s", trajectory.duration()));
    }
    Ok(examined)
}

fn is_rest(trajectory: &Trajectory, time: f64) -> bool {
    largest(&trajectory.velocity(time)) == 0.0
}

fn largest(vector: &[f64]) -> f64 {
    vector.iter().fold(0.0, |most, x| most.max(x.abs()))
}

fn off(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

fn is_near(a: &[f64], b: &[f64], most: f64) -> bool {
    off(a, b) <= most
}

/// The greatest speed of a coordinate at a knot.
fn fastest(trajectory: &Trajectory) -> f64 {
    let pieces = trajectory.pieces().iter().flat_map(|piece| piece.knots().windows(2).map(move |knots| (piece, knots)));
    let speeds = pieces.flat_map(|(piece, knots)| {
        let span = KnotSpan::new(piece, &knots[0], &knots[1]);
        [0.0, span.duration].map(|time| largest(&span.at(time)[1]))
    });
    speeds.fold(0.0, f64::max)
}

impl Examined {
    /// Compares a velocity and an acceleration with the limits.
    fn take(
        &mut self,
        limits: &Limits,
        robot: &Robot,
        velocity: &[f64],
        acceleration: &[f64],
        piece: usize,
    ) -> Result<(), String> {
        let length = |v: &[f64]| libm::hypot(v[0], v[1]);
        let [speed, rise] = match limits {
            Limits::Coordinates(CoordinateLimits { speed, acceleration: most }) => {
                let share = |values: &[f64], most: &[f64]| {
                    values.iter().zip(most).map(|(value, most)| value.abs() / most).fold(0.0, f64::max)
                };
                [share(velocity, speed), share(acceleration, most)]
            }
            Limits::Plane(PlaneLimits { speed, acceleration: most, turn_rate, turn_acceleration }) => {
                let turned = |value: &[f64], most: &Option<f64>| most.map_or(0.0, |most| value[2].abs() / most);
                [
                    (length(velocity) / speed).max(turned(velocity, turn_rate)),
                    (length(acceleration) / most).max(turned(acceleration, turn_acceleration)),
                ]
            }
            Limits::Differential(DifferentialLimits { speed, acceleration: most, turn_rate, turn_acceleration }) => [
                (length(velocity) / speed).max(velocity[2].abs() / turn_rate),
                (length(acceleration) / most).max(acceleration[2].abs() / turn_acceleration),
            ],
            Limits::Car(CarLimits { speed, acceleration: most, lateral_acceleration }) => {
                let own = if let Robot::Car(car) = robot { own_share(car, velocity[0]) } else { f64::INFINITY };
                let across = lateral_acceleration.map_or(0.0, |most| acceleration[1].abs() / most);
                [(velocity[0].abs() / speed).max(own), (acceleration[0].abs() / most).max(across)]
            }
        };
        self.samples += 1;
        for (what, share) in [("speed", speed), ("acceleration", rise)] {
            if share.is_nan() || share > 1.0 + WITHIN {
                return Err(format!("piece {piece}: a limit of {what} is exceeded: {share} of it"));
            }
        }
        (self.speed, self.acceleration) = (self.speed.max(speed), self.acceleration.max(rise));
        Ok(())
    }
}

/// A speed as a share of what the car can drive in that direction.
fn own_share(car: &Car, speed: f64) -> f64 {
    let [least, most] = car.speed();
    if speed == 0.0 { 0.0 } else { speed / if speed > 0.0 { most } else { least } }
}
