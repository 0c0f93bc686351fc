//! What a run is asked to do.

use super::target::Target;
use crate::error::{Code, Error};
use crate::options::Value;
use crate::random::MAX_SEED;
use crate::robot::Arm;
use crate::scenario::{Robot, Scenario};

/// Target, method, start, seed and parameters of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct SolverOptions {
    /// Where the tip is to go.
    pub target: Target,
    /// The id of the method; damped least squares where there is none.
    pub method: Option<String>,
    /// Where the first search starts: where there is none at the start of the scenario's first query, and without a query with
    /// all joints at 0 or as near to it as the limits allow.
    pub start: Option<Vec<f64>>,
    /// The seed of the other starts, up to 2^53 - 1.
    pub seed: u64,
    /// Parameters by name; the rest take their defaults.
    pub parameters: Vec<(String, Value)>,
}

impl SolverOptions {
    /// All defaults, for a target.
    pub fn to(target: Target) -> Self {
        Self { target, method: None, start: None, seed: 0, parameters: Vec::new() }
    }

    /// Refuses a seed that JavaScript could not hold.
    pub(super) fn check_seed(&self) -> Result<(), Error> {
        if self.seed <= MAX_SEED {
            return Ok(());
        }
        let sentence = format!("a seed lies within [0, {MAX_SEED}], not {}", self.seed);
        Err(Error::new(Code::OutOfRange, "/seed", sentence))
    }
}

/// The arm of the scenario.
///
/// # Errors
/// `unsupported` where the robot is no arm.
pub fn arm_of(scenario: &Scenario) -> Result<&Arm, Error> {
    match scenario.robot() {
        Robot::Arm(arm) => Ok(arm),
        other => {
            let sentence = format!("only an arm reaches for a target; this robot is of type {}", other.kind());
            Err(Error::new(Code::Unsupported, "", sentence))
        }
    }
}
