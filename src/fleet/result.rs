//! The document that a planner of a fleet ends with, and the reasons and counts in it.

use crate::error::Error;
use crate::json;
use crate::problem::Status;
use serde::{Deserialize, Serialize};

/// Why there is no plan. Nothing here says that there is none: another roadmap, or more iterations, may find one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum FleetReason {
    /// The iterations are spent.
    IterationLimit,
    /// The roadmap of a robot is complete, and does not connect its start and its goal.
    NotConnected,
    /// On these roadmaps every order of priorities fails, and whatever else the planner tries.
    NoOrder,
    /// As many orders of priorities as were to be tried fail; there are others.
    OrderLimit,
    /// There is no memory for more vertices.
    GraphFull,
    /// The plan found lasts so long that a robot moves farther than the slack of the fleet between a time and the next
    /// larger double, as where a fast robot waits for a very slow one. It is refused.
    TooLate,
}

/// The robot that found no way, and who is in its way.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Blocked {
    /// The robot, by its index.
    pub robot: usize,
    /// The robots that were in its way wherever it could go on, by their indices; none if its roadmap has no way even without
    /// them.
    pub by: Vec<usize>,
}

/// The work done, the same on every platform.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FleetStats {
    /// Iterations of the planner.
    pub iterations: u64,
    /// Vertices of all roadmaps or trees.
    pub vertices: u64,
    /// Edges of all roadmaps or trees.
    pub edges: u64,
    /// Vertices with a safe interval that were expanded.
    pub expanded: u64,
    /// Motions tested for collision with obstacles.
    pub motion_checks: u64,
    /// Motions of two robots that were compared.
    pub pair_checks: u64,
    /// Orders of priorities tried after the first; of `pbs`, the branches of its tree as well.
    pub restarts: u64,
}

/// The trajectory of one robot in a document.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RobotTrajectory {
    /// The name of the robot.
    pub name: String,
    /// The time of every row, in seconds; the first is 0.
    pub times: Vec<f64>,
    /// Where the robot is at these times; between them it moves at constant rates, angles the short way round, or stands. It
    /// stands at the last forever.
    pub path: Vec<Vec<f64>>,
}

/// The robot that found no way, in a document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(rename = "FleetBlocked"))]
pub struct BlockedNames {
    /// The name of the robot.
    pub robot: String,
    /// The names of those that were in its way; none if its roadmap has no way even without them.
    pub by: Vec<String>,
}

/// The result of a planner of a fleet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FleetResult {
    /// The name of the fleet.
    pub fleet: String,
    /// The id of the planner.
    pub planner: String,
    /// The seed, at most 2^53 - 1.
    pub seed: u64,
    /// The status at the end of the run.
    pub status: Status,
    /// Why there is no plan; absent unless the status is `exhausted`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub reason: Option<FleetReason>,
    /// The robots in the order of their priorities; absent of other planners.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub order: Option<Vec<String>>,
    /// The trajectories of the robots that have planned, in the order of the fleet: of all if the status is `solved`.
    pub robots: Vec<RobotTrajectory>,
    /// When the last robot arrives, in seconds; 0 unless solved.
    #[serde(deserialize_with = "json::not_negative")]
    pub makespan: f64,
    /// The sum of the arrivals of all robots, in seconds; 0 unless solved.
    #[serde(deserialize_with = "json::not_negative")]
    pub sum_of_costs: f64,
    /// How long robots stand before they arrive, all together, in seconds; 0 unless solved.
    #[serde(deserialize_with = "json::not_negative")]
    pub waits: f64,
    /// The robot that found no way last; absent if none is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "FleetBlocked"))]
    pub blocked: Option<BlockedNames>,
    /// The work done.
    pub stats: FleetStats,
    /// A hash over all roadmaps or trees and all trajectories; 16 lower-case hex digits in JSON.
    #[serde(with = "json::hex")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "string"))]
    pub fingerprint: u64,
}

impl FleetResult {
    /// Reads a result.
    ///
    /// # Errors
    /// The codes of [`json::parse`], and with the pointer of the offending value `unknown-field`, `missing-field`, `wrong-type`,
    /// `out-of-range`.
    pub fn parse(text: &str) -> Result<Self, Error> {
        json::read(&json::parse(text)?)
    }

    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        json::to_string(self)
    }
}
