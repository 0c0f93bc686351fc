//! What has come of a run, for people.

use super::nearest::Nearest;
use super::task::Task;
use crate::problem::{Contact, Status};
use serde::Serialize;
use strum::IntoStaticStr;

/// What has come of a run.
#[derive(Debug, Clone, PartialEq, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Verdict {
    /// A solution was found.
    Reached,
    /// Only solutions in collision were found; what touches what at the first of them.
    InCollision {
        /// Every touching pair.
        contacts: Vec<Contact>,
    },
    /// No configuration reaches the target.
    OutOfReach {
        /// Why not.
        reason: Reason,
        /// How near the arm can come.
        nearest: Nearest,
    },
    /// The target can be reached, and the run goes on.
    Running,
    /// The target can be reached, and the budget is spent without finding how.
    NotFound,
}

/// Why a target is out of reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, Serialize)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Reason {
    /// It is farther from the base than the stretched arm.
    TooFar,
    /// It is nearer to the base than the folded arm.
    TooNear,
    /// The joint limits keep the tip away.
    Limits,
    /// The joint limits allow the wanted orientation nowhere.
    Orientation,
}

impl Reason {
    /// The reason as it is printed, in kebab-case.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}

impl Verdict {
    /// The verdict on a task that nothing was found for, by how near the arm can come.
    pub(super) fn of(task: &Task, nearest: Nearest, tolerance: f64, status: Status) -> Self {
        if nearest.distance <= tolerance && nearest.turn <= tolerance {
            return if status == Status::Running { Verdict::Running } else { Verdict::NotFound };
        }
        let ([x, y], count) = task.wrist();
        let ([inner, outer], r) = (task.ring(count), (x * x + y * y).sqrt());
        let reason = if nearest.turn > tolerance {
            Reason::Orientation
        } else if r > outer {
            Reason::TooFar
        } else if r < inner {
            Reason::TooNear
        } else {
            Reason::Limits
        };
        Verdict::OutOfReach { reason, nearest }
    }

    /// The verdict as it is printed: `reached`, `in-collision`, `out-of-reach`, `running` or `not-found`.
    pub fn as_str(&self) -> &'static str {
        self.into()
    }
}
