//! The lists of numbers that are configurations of a robot.

use super::PlanningWorld;
use crate::error::{Code, Error, Number};
use crate::robot::{Arm, joint_space};
use crate::scenario::{LARGEST, Robot};
use crate::space::{MAX_DIMENSION, Metric, ProductSpace, Space};

/// The configurations of one robot: its number of finite entries up to 1e6 in size; those of an arm's joints that have limits
/// lie within them on request. Positions outside the world's bounds are configurations in collision.
#[derive(Debug, Clone)]
pub struct Configurations {
    space: ProductSpace<MAX_DIMENSION>,
    has_limits: bool,
}

impl Configurations {
    /// Those of the scenario's robot.
    pub fn of(world: &PlanningWorld) -> Self {
        Self { space: world.default_space(), has_limits: matches!(world.robot(), Robot::Arm(_)) }
    }

    /// Those of an arm.
    pub fn of_arm(arm: &Arm) -> Self {
        Self { space: joint_space(arm, Metric::Sum), has_limits: true }
    }

    /// The robot's space with its default metric.
    pub fn space(&self) -> &ProductSpace<MAX_DIMENSION> {
        &self.space
    }

    /// The number of coordinates of a configuration.
    pub fn dimension(&self) -> usize {
        self.space.dimension()
    }

    /// Returns an error if `q` is not a configuration.
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
                let sentence = format!("a configuration holds finite numbers, not {}", Number(value));
                return Err(Error::new(Code::NotFinite, pointer(), sentence));
            }
            if value.abs() > LARGEST {
                let [most, value] = [LARGEST, value].map(Number);
                let sentence = format!("a configuration holds numbers within [-{most}, {most}], not {value}");
                return Err(Error::new(Code::OutOfRange, pointer(), sentence));
            }
        }
        Ok(())
    }

    /// Returns an error if `q` is not a configuration, or lies outside the joint limits.
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
                let [low, high, angle] = [low, high, *angle].map(Number);
                let sentence = format!("joint {i} must lie within its limits [{low}, {high}], not {angle}");
                return Err(Error::new(Code::OutOfRange, format!("{pointer}/{i}"), sentence));
            }
        }
        Ok(())
    }
}
