//! What is a configuration of a robot, and what is not.

use crate::collision::{joint_space, placements, plane};
use crate::decimal::Decimal;
use crate::error::{Code, Error};
use crate::scenario::{LARGEST, Robot, Scenario};
use crate::space::{MAX_DIMENSION, Metric, Space, Torus};

/// The space that a scenario's robot moves in: of an arm with the given metric, which a body and a disc have of their own.
pub fn space_of<const N: usize>(scenario: &Scenario, metric: Metric) -> Torus<N> {
    let bounds = || scenario.world().bounds.expect("only an arm does without bounds");
    match scenario.robot() {
        Robot::Arm(arm) => joint_space(arm, metric),
        Robot::Disc(_) => plane(&bounds()),
        robot @ (Robot::RigidBody(_) | Robot::Car(_)) => {
            let (shape, weights) = robot.placed_shape().expect("both are placed");
            placements(shape, weights, &bounds())
        }
    }
}

/// The configurations of one robot: its number of finite entries up to 1e6 in size; those of an arm's joints that have limits
/// lie within them where that is asked. Places outside the world's bounds are configurations, in collision.
#[derive(Debug, Clone)]
pub struct Configurations {
    space: Torus<MAX_DIMENSION>,
    has_limits: bool,
}

impl Configurations {
    /// Those of the scenario's robot.
    pub fn of(scenario: &Scenario) -> Self {
        let has_limits = matches!(scenario.robot(), Robot::Arm(_));
        Self { space: space_of(scenario, Metric::Sum), has_limits }
    }

    /// How many numbers a configuration has.
    pub fn dimension(&self) -> usize {
        self.space.dimension()
    }

    /// Refuses what is no configuration.
    ///
    /// # Errors
    /// `wrong-dimension` with the pointer, `not-finite` and `out-of-range` with that of the entry.
    pub fn refuse(&self, q: &[f64], pointer: &str) -> Result<(), Error> {
        if q.len() != self.dimension() {
            let sentence = format!("a configuration of this robot has {} numbers, not {}", self.dimension(), q.len());
            return Err(Error::new(Code::WrongDimension, pointer, sentence));
        }
        for (i, &value) in q.iter().enumerate() {
            let pointer = || format!("{pointer}/{i}");
            if !value.is_finite() {
                let sentence = format!("a configuration holds finite numbers, not {}", Decimal(value));
                return Err(Error::new(Code::NotFinite, pointer(), sentence));
            }
            if value.abs() > LARGEST {
                let [most, value] = [LARGEST, value].map(Decimal);
                let sentence = format!("a configuration holds numbers within [-{most}, {most}], not {value}");
                return Err(Error::new(Code::OutOfRange, pointer(), sentence));
            }
        }
        Ok(())
    }

    /// Refuses what is no configuration, or lies outside the joint limits.
    ///
    /// # Errors
    /// Those of [`Configurations::refuse`], and `out-of-range` with the pointer of the entry.
    pub fn refuse_outside(&self, q: &[f64], pointer: &str) -> Result<(), Error> {
        self.refuse(q, pointer)?;
        if !self.has_limits {
            return Ok(());
        }
        for (i, angle) in q.iter().enumerate().filter(|(i, _)| !self.space.is_circle(*i)) {
            let [low, high] = self.space.range(i);
            if !(low..=high).contains(angle) {
                let [low, high, angle] = [low, high, *angle].map(Decimal);
                let sentence = format!("joint {i} must lie within its limits [{low}, {high}], not {angle}");
                return Err(Error::new(Code::OutOfRange, format!("{pointer}/{i}"), sentence));
            }
        }
        Ok(())
    }
}
