//! The limits of a trajectory, and what they say about a piece of its path.

use super::curve::Curve;
use crate::error::{Code, Error, within};
use crate::json::by_type;
use crate::robot::Car;
use crate::scenario::Robot;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// The least and the greatest limit, in any unit.
const RANGE: RangeInclusive<f64> = 1e-6..=1e9;

/// How fast a robot may move and accelerate. Every limit lies within [1e-6, 1e9].
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Limits {
    /// Of every coordinate by itself: for arms, discs and bodies.
    Coordinates(CoordinateLimits),
    /// Of a disc or a body in the plane, in any direction.
    Plane(PlaneLimits),
    /// Of a car along its path.
    Car(CarLimits),
    /// Of a disc that drives along its heading and turns on the spot: a round robot with two driven wheels.
    Differential(DifferentialLimits),
}

by_type!(Limits { "coordinates" => Coordinates, "plane" => Plane, "car" => Car, "differential" => Differential });

/// Limits of every coordinate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoordinateLimits {
    /// The greatest speed of each coordinate, in radians or metres per second.
    pub speed: Vec<f64>,
    /// The greatest acceleration of each coordinate, in radians or metres per second squared.
    pub acceleration: Vec<f64>,
}

/// Limits of the reference point of a disc or a body, and of the turn of a body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneLimits {
    /// The greatest length of the velocity, in metres per second.
    pub speed: f64,
    /// The greatest length of the acceleration, in metres per second squared.
    pub acceleration: f64,
    /// Of a body, the greatest turn rate, in radians per second.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_rate: Option<f64>,
    /// Of a body, the greatest acceleration of the turn, in radians per second squared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn_acceleration: Option<f64>,
}

/// Limits of a car. It never drives faster than its own range of speeds allows, whatever they are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CarLimits {
    /// The greatest speed in either direction, in metres per second.
    pub speed: f64,
    /// The greatest acceleration along the path, in metres per second squared.
    pub acceleration: f64,
    /// The greatest acceleration across the path, the square of the speed times the curvature, in metres per second squared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_acceleration: Option<f64>,
}

/// Limits of a disc that drives straight edges forward, and turns on the spot in between. Its trajectory has the configuration
/// (x, y, heading), and begins with the heading of the first edge.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DifferentialLimits {
    /// The greatest speed, in metres per second.
    pub speed: f64,
    /// The greatest acceleration along the path, in metres per second squared.
    pub acceleration: f64,
    /// The greatest turn rate, in radians per second.
    pub turn_rate: f64,
    /// The greatest acceleration of a turn, in radians per second squared.
    pub turn_acceleration: f64,
}

impl Limits {
    /// Whether they are limits of this robot.
    ///
    /// # Errors
    /// With pointers below `/limits`: `unsupported` for limits of another robot, or of the turn of a disc; `missing-field` if
    /// those of the turn of a body are missing; `wrong-dimension` unless there is one for each coordinate; `out-of-range` or
    /// `not-finite` for one outside [1e-6, 1e9].
    pub fn check(&self, robot: &Robot) -> Result<(), Error> {
        let is_car = matches!(robot, Robot::Car(_));
        match self {
            Self::Coordinates(limits) if !is_car => {
                limits.check("speed", &limits.speed, robot.dimension())?;
                limits.check("acceleration", &limits.acceleration, robot.dimension())
            }
            Self::Plane(limits) if matches!(robot, Robot::Disc(_) | Robot::RigidBody(_)) => {
                let PlaneLimits { speed, acceleration, turn_rate, turn_acceleration } = *limits;
                check("speed", speed)?;
                check("acceleration", acceleration)?;
                for (name, limit) in [("turn_rate", turn_rate), ("turn_acceleration", turn_acceleration)] {
                    match (limit, robot) {
                        (Some(limit), Robot::RigidBody(_)) => check(name, limit)?,
                        (None, Robot::RigidBody(_)) => {
                            let sentence = format!("a body turns: the limits need a \"{name}\"");
                            return Err(Error::new(Code::MissingField, format!("/limits/{name}"), sentence));
                        }
                        (Some(_), _) => {
                            let sentence = "a disc does not turn, unless its limits are differential".to_owned();
                            return Err(Error::new(Code::Unsupported, format!("/limits/{name}"), sentence));
                        }
                        (None, _) => {}
                    }
                }
                Ok(())
            }
            Self::Car(limits) if is_car => {
                check("speed", limits.speed)?;
                check("acceleration", limits.acceleration)?;
                limits.lateral_acceleration.map_or(Ok(()), |limit| check("lateral_acceleration", limit))
            }
            Self::Differential(limits) if matches!(robot, Robot::Disc(_)) => {
                let DifferentialLimits { speed, acceleration, turn_rate, turn_acceleration } = *limits;
                check("speed", speed)?;
                check("acceleration", acceleration)?;
                check("turn_rate", turn_rate)?;
                check("turn_acceleration", turn_acceleration)
            }
            _ => {
                let sentence = format!("the robot {} has other limits than these", robot.kind());
                Err(Error::new(Code::Unsupported, "/limits", sentence))
            }
        }
    }

    /// The number of coordinates of a trajectory of this robot: one more than its own for a disc that turns.
    pub(super) fn dimension(&self, robot: &Robot) -> usize {
        robot.dimension() + usize::from(matches!(self, Self::Differential(_)))
    }

    /// The limits on a piece of a path: of each group of coordinates that has one.
    pub(super) fn bounds(&self, curve: &Curve) -> Vec<Bound> {
        let (rate, bend) = match curve {
            Curve::Straight { rate, .. } => (&rate[..], &[][..]),
            Curve::Parabola { rate, bend, .. } => (&rate[..], &bend[..]),
            // A car is limited along its path and across it: see `along`.
            Curve::Arc { .. } => return Vec::new(),
        };
        let at = |vector: &[f64], i: usize| vector.get(i).copied().unwrap_or(0.0);
        let bound = |[i, k]: [usize; 2], speed, acceleration| Bound {
            slope: [at(rate, i), at(rate, k)],
            second: [2.0 * at(bend, i), 2.0 * at(bend, k)],
            speed,
            acceleration,
        };
        const NONE: usize = usize::MAX;
        match self {
            Self::Coordinates(CoordinateLimits { speed, acceleration }) => {
                let limits = speed.iter().zip(acceleration).enumerate();
                limits.map(|(i, (&speed, &acceleration))| bound([i, NONE], speed, acceleration)).collect()
            }
            Self::Plane(PlaneLimits { speed, acceleration, turn_rate, turn_acceleration }) => {
                let turn = turn_rate.zip(*turn_acceleration).map(|(rate, most)| bound([2, NONE], rate, most));
                std::iter::once(bound([0, 1], *speed, *acceleration)).chain(turn).collect()
            }
            Self::Differential(DifferentialLimits { speed, acceleration, turn_rate, turn_acceleration }) => {
                vec![bound([0, 1], *speed, *acceleration), bound([2, NONE], *turn_rate, *turn_acceleration)]
            }
            Self::Car(_) => Vec::new(),
        }
    }

    /// The greatest first and second derivative of u by time on an arc of this length and turn, which a car's own speeds limit,
    /// too. Both are infinite for limits of other robots.
    pub(super) fn along(&self, length: f64, turn: f64, car: Option<&Car>) -> [f64; 2] {
        let Self::Car(limits) = self else { return [f64::INFINITY; 2] };
        let own = car.map_or(f64::INFINITY, |car| own_speed(car, length));
        let speed = limits.speed.min(own);
        let curve = (length / turn).abs();
        let across = limits.lateral_acceleration.map_or(f64::INFINITY, |most| (most * curve).sqrt());
        [speed.min(across) / length.abs(), limits.acceleration / length.abs()]
    }
}

/// The greatest speed of a car in the direction of a length: no less than 0.
pub(super) fn own_speed(car: &Car, length: f64) -> f64 {
    let [least, most] = car.speed();
    if length < 0.0 { (-least).max(0.0) } else { most.max(0.0) }
}

impl CoordinateLimits {
    fn check(&self, name: &str, limits: &[f64], dimension: usize) -> Result<(), Error> {
        if limits.len() != dimension {
            let sentence = format!("there are {dimension} coordinates, and {} limits of {name}", limits.len());
            return Err(Error::new(Code::WrongDimension, format!("/limits/{name}"), sentence));
        }
        limits.iter().enumerate().try_for_each(|(i, &limit)| check(&format!("{name}/{i}"), limit))
    }
}

fn check(name: &str, limit: f64) -> Result<(), Error> {
    within(format!("/limits/{name}"), "a limit", limit, RANGE).map(|_| ())
}

/// A limit on the norm of one or two coordinates along a piece of a path whose derivative is slope + u second.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bound {
    /// The derivative at u = 0.
    pub slope: [f64; 2],
    /// The second derivative.
    pub second: [f64; 2],
    /// The greatest speed.
    pub speed: f64,
    /// The greatest acceleration.
    pub acceleration: f64,
}

impl Bound {
    /// The derivative at u.
    pub fn at(&self, u: f64) -> [f64; 2] {
        [0, 1].map(|i| self.slope[i] + u * self.second[i])
    }

    /// The largest square of the speed, as a share of that of the limit, between the knots (u, x), x the square of the rate of u,
    /// which is linear between them. The square of the speed is a cubic: it is largest at an end, or where it is level.
    pub fn speed_share(&self, [from, to]: [[f64; 2]; 2]) -> f64 {
        let (start, end) = (self.at(from[0]), self.at(to[0]));
        let step = [0, 1].map(|i| end[i] - start[i]);
        // |q'|^2 = p + q s + r s^2 and x = from + rise s, s in [0, 1].
        let (p, q, r) = (dot(start, start), 2.0 * dot(start, step), dot(step, step));
        let rise = to[1] - from[1];
        let square = |s: f64| (p + s * (q + s * r)).max(0.0) * (from[1] + s * rise);
        let mut most = (p * from[1]).max(dot(end, end) * to[1]);
        // The derivative of the cubic: c + 2 b s + 3 a s^2.
        let (a, b, c) = (rise * r, from[1] * r + rise * q, from[1] * q + rise * p);
        let root = (b * b - 3.0 * a * c).max(0.0).sqrt();
        let sum = -(b + if b < 0.0 { -root } else { root });
        for s in [sum / (3.0 * a), c / sum] {
            if s > 0.0 && s < 1.0 {
                most = most.max(square(s));
            }
        }
        most / (self.speed * self.speed)
    }

    /// The acceleration at u as a share of the limit, x the square of the rate of u, and `rise` its second derivative.
    pub fn acceleration_share(&self, u: f64, x: f64, rise: f64) -> f64 {
        let slope = self.at(u);
        let acceleration = [0, 1].map(|i| slope[i] * rise + self.second[i] * x);
        dot(acceleration, acceleration).sqrt() / self.acceleration
    }
}

/// The scalar product.
pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
