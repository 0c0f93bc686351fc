//! The document that a run ends with: the query, the path, its length, the work, and a fingerprint of the growth.

use crate::error::{Code, Error};
use crate::json;
use crate::problem::{Motion, Reason, Stats, Status};
use crate::scenario::{Robot, Scenario};
use crate::space::MetricKind;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};

/// What the length of a path is the sum of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum LengthMeasure {
    /// Metres: of a disc along its path; of a car driven, forwards or in reverse.
    Metres,
    /// The turns of all joints of an arm, in radians: the metric `sum`.
    SumOfJoints,
    /// The roots of the sums of the squares of turns of joints, in radians: the metrics `euclidean` and `naive`.
    EuclideanOfJoints,
    /// Metres and radians of a rigid body, weighted by its `metric`.
    Weighted,
    /// Distances in the metric of the space of a custom robot.
    Space,
}

impl LengthMeasure {
    /// That of paths of a robot that is planned for with this metric.
    pub(crate) fn of(robot: &Robot, metric: Option<MetricKind>) -> Self {
        match robot {
            Robot::Disc(_) | Robot::Car(_) => Self::Metres,
            Robot::RigidBody(_) => Self::Weighted,
            Robot::Arm(_) if matches!(metric, None | Some(MetricKind::Sum)) => Self::SumOfJoints,
            Robot::Arm(_) => Self::EuclideanOfJoints,
        }
    }
}

/// The result of a plan, in the order and under the names of its JSON form. Numbers are written with the fewest digits
/// that parse back to the same bits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ResultDocument {
    /// The name of the scenario.
    pub scenario: String,
    /// The name of the query.
    pub query: String,
    /// The id of the planner.
    pub planner: String,
    /// The seed, at most 2^53 - 1.
    pub seed: u64,
    /// The status at the end of the run.
    pub status: Status,
    /// Why the run has ended without a path, or with one before it had done what its options ask for; else absent, and in results
    /// written before reasons were given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Reason"))]
    pub reason: Option<Reason>,
    /// The reason in words, with the limit that it is about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explanation: Option<String>,
    /// The waypoints, one configuration each, from the start to the goal; empty unless solved.
    pub path: Vec<Vec<f64>>,
    /// Of a car, the motion from each waypoint to the next along an exact arc: one fewer than there are waypoints.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motions: Option<Vec<Motion>>,
    /// Of every waypoint but the first and the last, how its corner may be rounded: the fractions of the edges to it and from it
    /// that its blend replaces, at most 1/2 each; 0 where the corner stays. The blend of a corner b between a and c is the
    /// parabola with the Bezier control points b + before (a - b), b, b + after (c - b). It is proven free, as the path with its
    /// corners is. Absent if no corner was to be rounded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[before: number, after: number][]"))]
    pub blends: Option<Vec<[f64; 2]>>,
    /// `euler` if motions were computed by Euler's steps: the path is an illustration, not proven. Absent if they are exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"euler\""))]
    pub integration: Option<String>,
    /// The length of the path, by the measure that planners minimise; 0 without one.
    #[serde(deserialize_with = "json::not_negative")]
    pub length: f64,
    /// What the length measures. Absent in results written before it was named, and for a robot in a custom type of space.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"metres\" | \"sum-of-joints\" | \"euclidean-of-joints\" | \"weighted\" | \"space\"")
    )]
    pub length_measure: Option<LengthMeasure>,
    /// The length along the blends, at most `length`. Absent without them.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "json::some_not_negative")]
    pub blended_length: Option<f64>,
    /// Of a path by controls, the sum of the distances between its waypoints in the `metric` of the car, metres and radians
    /// weighted, by which course reports compare paths. No planner minimises it. Absent for others.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "json::some_not_negative")]
    pub chord_length: Option<f64>,
    /// What was minimised, if that is not the length alone: `length`, and what nearness to obstacles adds. Absent if it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cost: Option<PathCost>,
    /// By how much the robot was planned for as larger on all sides, in metres. Absent if it has no margin.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "json::some_not_negative")]
    pub margin: Option<f64>,
    /// The work done.
    pub stats: Stats,
    /// A hash over every vertex, edge and event; 16 lower-case hex digits in JSON.
    #[serde(with = "json::hex")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "string"))]
    pub fingerprint: u64,
    /// `sampled` if edges were checked only at samples, `none` if only vertices were, `joint-lines` if only straight lines of
    /// joints were, `rollouts` if a learned policy drove them: the path is not proven. Absent if it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"sampled\" | \"none\" | \"joint-lines\" | \"rollouts\""))]
    pub edge_check: Option<String>,
    /// The estimated share of the free space that a visibility roadmap covers; absent for other planners, and if a stored
    /// roadmap was continued.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "share")]
    pub coverage: Option<f64>,
    /// The configuration from which was planned in place of the query's start: that is in collision, and the option `free_ends`
    /// has moved it to the nearest free configuration that was found. Absent if the start was not moved.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moved_start: Option<Vec<f64>>,
    /// The same of the goal; of a problem with several goals, of the one that the path ends at.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moved_goal: Option<Vec<f64>>,
    /// The approximate solution of an RRT that found no path; absent otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub approximate: Option<Approximate>,
}

/// The cost of a path of a disc that keeps away from obstacles: each metre at a clearance of c metres costs an extra
/// `weight` * max(0, 1 - c / `within`). Bounds do not count.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PathCost {
    /// The length and what is added to it, in metres, to `weight` / 64 of the length at worst.
    #[serde(deserialize_with = "json::not_negative")]
    pub value: f64,
    /// The extra cost per metre at contact, in metres.
    #[serde(deserialize_with = "json::not_negative")]
    pub weight: f64,
    /// The clearance from which nothing is added, in metres.
    #[serde(deserialize_with = "json::not_negative")]
    pub within: f64,
}

/// An approximate solution: the path to the vertex nearest to the goal. It does not reach the goal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Approximate {
    /// The waypoints from the start on.
    pub path: Vec<Vec<f64>>,
    /// Of a car, the motion from each to the next.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motions: Option<Vec<Motion>>,
    /// The distance from its end to the goal in the metric by which the planner takes the nearest vertex. That is the measure of
    /// [`ResultDocument::length`], except by controls: there metres and radians are weighted by the `metric` of the car.
    #[serde(deserialize_with = "json::not_negative")]
    pub goal_distance: f64,
}

impl ResultDocument {
    /// Reads a result document.
    ///
    /// # Errors
    /// With the pointer of the offending value: the codes of [`json::parse`], `unknown-field`, `missing-field`,
    /// `wrong-type`, `not-finite`, `out-of-range` (a seed or a count above 2^53 - 1 or with a fraction, a negative length or
    /// time), and `invalid-result` for a malformed status or fingerprint. Whether the path is valid is decided by
    /// [`verify`](crate::path::verify).
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::read(&json::parse(text)?)
    }

    /// Reads a result document that was parsed.
    ///
    /// # Errors
    /// Those of [`parse`](Self::parse), but for those of [`json::parse`].
    pub fn read(document: &serde_json::Value) -> Result<Self, Error> {
        json::read(document).map_err(|error| match error.pointer() {
            "/status" | "/fingerprint" if error.code() == Code::OutOfRange => {
                Error::new(Code::InvalidResult, error.pointer(), error.message())
            }
            _ => error,
        })
    }

    /// Refuses a scenario that the result does not belong to.
    ///
    /// # Errors
    /// `invalid-result` (pointer `/scenario`)
    pub(crate) fn check_scenario(&self, scenario: &Scenario) -> Result<(), Error> {
        if self.scenario == scenario.name() {
            return Ok(());
        }
        let sentence = format!("the result belongs to scenario {:?}, not to {:?}", self.scenario, scenario.name());
        Err(Error::new(Code::InvalidResult, "/scenario", sentence))
    }

    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        json::to_string(self)
    }
}

/// Reads a share, from 0 to 1.
fn share<'de, D: Deserializer<'de>>(source: D) -> Result<Option<f64>, D::Error> {
    let share = f64::deserialize(source)?;
    if (0.0..=1.0).contains(&share) {
        return Ok(Some(share));
    }
    Err(D::Error::custom(format!("a share must lie within [0, 1], not {share}")))
}
