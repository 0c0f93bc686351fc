//! Limits as people give them: one number for all coordinates, or one for each.

use super::limits::{CarLimits, CoordinateLimits, DifferentialLimits, Limits, PlaneLimits};
use crate::error::{Code, Error};
use crate::scenario::Robot;

/// Limits by their names, as the command line and JavaScript take them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LimitOptions {
    /// The greatest speed: of every joint of an arm; in the plane, of a disc, a body or a car. Or of each coordinate by itself.
    pub speed: Vec<f64>,
    /// The greatest acceleration, of the same; of a car along its path.
    pub acceleration: Vec<f64>,
    /// Of a body, and of a disc that drives along its heading, the greatest turn rate, in radians per second.
    pub turn_rate: Option<f64>,
    /// Of the same, the greatest acceleration of the turn, in radians per second squared.
    pub turn_acceleration: Option<f64>,
    /// Of a car, the greatest acceleration across its path, in metres per second squared; any by default.
    pub lateral_acceleration: Option<f64>,
    /// Whether a disc drives along its heading and turns on the spot; it moves in any direction by default.
    pub differential: bool,
}

impl LimitOptions {
    /// The limits for a robot. One number for the speed and one for the acceleration are those in the plane, of a car those
    /// along its path, and of an arm those of all joints; lists are those of the coordinates in their order. A disc that drives
    /// along its heading has numbers alone, and needs those of its turn.
    ///
    /// # Errors
    /// `unsupported` with the pointer of a limit that the robot does not have, with these limits of speed; `wrong-dimension` and
    /// `missing-field` for those of a disc that drives along its heading; those of [`Limits::check`].
    pub fn limits(&self, robot: &Robot) -> Result<Limits, Error> {
        let &Self { ref speed, ref acceleration, turn_rate, turn_acceleration, lateral_acceleration, differential } =
            self;
        let is_car = matches!(robot, Robot::Car(_));
        let limits = match (&speed[..], &acceleration[..]) {
            _ if differential => {
                refuse(robot, "differential", (!matches!(robot, Robot::Disc(_))).then_some(()))?;
                refuse(robot, "lateral_acceleration", lateral_acceleration)?;
                Limits::Differential(DifferentialLimits {
                    speed: one("speed", speed)?,
                    acceleration: one("acceleration", acceleration)?,
                    turn_rate: one("turn_rate", turn_rate.as_slice())?,
                    turn_acceleration: one("turn_acceleration", turn_acceleration.as_slice())?,
                })
            }
            (&[speed], &[acceleration]) if is_car => {
                refuse(robot, "turn_rate", turn_rate)?;
                refuse(robot, "turn_acceleration", turn_acceleration)?;
                Limits::Car(CarLimits { speed, acceleration, lateral_acceleration })
            }
            (&[speed], &[acceleration]) if !matches!(robot, Robot::Arm(_)) => {
                refuse(robot, "lateral_acceleration", lateral_acceleration)?;
                Limits::Plane(PlaneLimits { speed, acceleration, turn_rate, turn_acceleration })
            }
            _ => {
                refuse(robot, "turn_rate", turn_rate)?;
                refuse(robot, "turn_acceleration", turn_acceleration)?;
                refuse(robot, "lateral_acceleration", lateral_acceleration)?;
                let each = |limits: &[f64]| match limits {
                    [limit] => vec![*limit; robot.dimension()],
                    limits => limits.to_vec(),
                };
                Limits::Coordinates(CoordinateLimits { speed: each(speed), acceleration: each(acceleration) })
            }
        };
        limits.check(robot)?;
        Ok(limits)
    }
}

/// The limit of a robot that drives along its heading.
fn one(name: &str, limits: &[f64]) -> Result<f64, Error> {
    let code = match limits {
        [limit] => return Ok(*limit),
        [] => Code::MissingField,
        _ => Code::WrongDimension,
    };
    let sentence = format!("a robot that drives along its heading has one limit \"{name}\", not {}", limits.len());
    Err(Error::new(code, format!("/limits/{name}"), sentence))
}

/// Refuses a limit that has no meaning here.
fn refuse<T>(robot: &Robot, name: &str, limit: Option<T>) -> Result<(), Error> {
    if limit.is_none() {
        return Ok(());
    }
    let sentence = format!("{name} is no limit of this robot ({}) with these limits of speed", robot.kind());
    Err(Error::new(Code::Unsupported, format!("/limits/{name}"), sentence))
}
