//! The outcome of a run, as values and in JSON.

use super::nearest::Nearest;
use super::task::Task;
use crate::json;
use crate::problem::{Contact, Status};
use serde::{Serialize, Serializer};
use strum::IntoStaticStr;

/// The outcome of a run. In JSON: `verdict`, the word of [`Verdict::as_str`]; `reason` and `nearest` of a target out of reach,
/// else null; and `touching`, the contacts of the first solution if all are in collision, else null.
#[derive(Debug, Clone, PartialEq, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Verdict {
    /// A solution was found.
    Reached,
    /// Only solutions in collision were found.
    InCollision {
        /// Every touching pair at the first of them.
        contacts: Vec<Contact>,
    },
    /// No configuration reaches the target.
    OutOfReach {
        /// The reason.
        reason: Reason,
        /// How near the arm can come.
        nearest: Nearest,
    },
    /// The target can be reached, and the run continues. With a prismatic joint: it is not known whether it can.
    Running,
    /// The target can be reached, but the budget is spent without a solution. With a prismatic joint: nothing was found, and it
    /// is not known whether there is anything to find.
    NotFound,
}

/// Why a target is out of reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Reason {
    /// It is farther from the base than the stretched arm.
    TooFar,
    /// It is nearer to the base than the folded arm.
    TooNear,
    /// The joint limits keep the tip away.
    Limits,
    /// The joint limits do not allow the wanted orientation anywhere.
    Orientation,
}

impl Verdict {
    /// The verdict on a task without any solution of which nothing else is known.
    pub(super) fn open(status: Status) -> Self {
        if status == Status::Running { Verdict::Running } else { Verdict::NotFound }
    }

    /// The verdict on a task without any solution, by how near the arm can come.
    pub(super) fn of(task: &Task, nearest: Nearest, tolerance: f64, status: Status) -> Self {
        if nearest.distance <= tolerance && nearest.turn <= tolerance {
            return Self::open(status);
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

/// The verdict as it is written in JSON.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "ReachVerdict", missing_as_null))]
struct VerdictDocument<'a> {
    /// `reached`; `in-collision` if the target is reached in collision only; `out-of-reach` if no configuration reaches it;
    /// `running`, or `not-found` once the budget is spent, if one does that has not been found, or if a joint is prismatic: then
    /// it is not known whether one does.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = r#""reached" | "in-collision" | "out-of-reach" | "running" | "not-found""#)
    )]
    verdict: &'static str,
    /// Why it is out of reach; null otherwise.
    #[cfg_attr(target_arch = "wasm32", tsify(type = r#""too-far" | "too-near" | "limits" | "orientation" | null"#))]
    reason: Option<Reason>,
    /// How near the arm can come to a target out of reach; null otherwise.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "{ configuration: number[]; point: Point; distance: number; turn: number } | null")
    )]
    nearest: Option<&'a Nearest>,
    /// What touches what at the first solution in collision; null unless that is the verdict.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Touching[] | null"))]
    touching: Option<&'a [Contact]>,
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut document = VerdictDocument { verdict: self.as_str(), reason: None, nearest: None, touching: None };
        match self {
            Verdict::OutOfReach { reason, nearest } => {
                document = VerdictDocument { reason: Some(*reason), nearest: Some(nearest), ..document }
            }
            Verdict::InCollision { contacts } => document.touching = Some(contacts),
            Verdict::Reached | Verdict::Running | Verdict::NotFound => (),
        }
        document.serialize(serializer)
    }
}

/// A configuration that reaches the target but is in collision.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Rejected {
    /// The joint angles, in radians.
    pub configuration: Vec<f64>,
    /// The links and the obstacles that they touch; in JSON `touching`.
    #[serde(rename = "touching")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Touching[]"))]
    pub contacts: Vec<Contact>,
}

/// The result document of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "ReachResult", missing_as_null))]
pub struct SolverResult {
    /// The name of the scenario.
    pub scenario: String,
    /// The id of the method.
    pub method: &'static str,
    /// The target of the tip, in metres.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
    pub target: [f64; 2],
    /// The wanted angle of the last link, in radians, if any.
    pub orientation: Option<f64>,
    /// The seed.
    pub seed: u64,
    /// The status at the end.
    pub status: Status,
    /// The configurations that reach the target, in radians.
    pub solutions: Vec<Vec<f64>>,
    /// Those in collision, if only free ones were wanted.
    pub rejected: Vec<Rejected>,
    /// The outcome.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "ReachVerdict"))]
    pub verdict: Verdict,
    /// How far from the target the tip may end, in metres.
    pub tolerance: f64,
    /// The work done.
    pub stats: SolverStats,
    /// A hash over every iterate and solution.
    #[serde(with = "json::hex")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "string"))]
    pub fingerprint: u64,
}

/// The work of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SolverStats {
    /// Iterations made.
    pub iterations: u64,
    /// Starts drawn, besides the first.
    pub restarts: u32,
    /// Solutions tested for collision.
    pub configuration_checks: u64,
}

impl SolverResult {
    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        json::to_string(self)
    }
}
