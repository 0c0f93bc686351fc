//! Verification of results for JavaScript.

use super::arguments::document_tree;
use super::records::record;
use super::scenario::Scenario;
use super::types::ResultInput;
use crate::Error;
use crate::path::{self, ResultDocument, Verdict};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// The verdict on a result, found without the planner's code.
#[derive(Default, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct PathVerification {
    /// Whether the path leads from start to goal, clear of everything.
    valid: bool,
    /// The reason if it is not valid, with waypoint or edge and obstacle, counted from 0, and the link, counted from 1.
    why: Option<String>,
    /// The number of waypoints of a valid path.
    waypoints: Option<usize>,
    /// How many placements of the robot were examined; of a disc, swept segments.
    looks: Option<u64>,
    /// The smallest distance to an obstacle that was found, in metres; null without obstacles. Of a disc it is the true one.
    clearance: Option<f64>,
    /// Whether a valid path begins where the start of the query was moved to, as that is in collision.
    moved_start: bool,
    /// The same of the goal.
    moved_goal: bool,
}

impl From<Verdict> for PathVerification {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Invalid { why } => Self { why: Some(why), ..Self::default() },
            Verdict::Valid { waypoints, samples, clearance, moved_start, moved_goal } => Self {
                valid: true,
                waypoints: Some(waypoints),
                looks: Some(samples),
                clearance: Some(clearance).filter(|clearance| clearance.is_finite()),
                moved_start,
                moved_goal,
                ..Self::default()
            },
        }
    }
}

#[wasm_bindgen]
impl Scenario {
    /// Verifies a result of a planner, stored or at hand, without the planner's code: by dense samples and exact tests.
    /// @throws {PlanariumError} `invalid-result` if the result belongs to another scenario or is malformed, `unknown-query`;
    /// `invalid-json`, `unknown-field`, `missing-field`, `wrong-type`, `out-of-range`. A path that is not valid is a verdict.
    pub fn verify(&self, result: &ResultInput) -> Result<Ts<PathVerification>, Error> {
        path::verify(self.scenario(), &read_result(result)?).map(|verdict| record(&verdict.into()))
    }
}

/// A result, stored or at hand.
pub(super) fn read_result(result: &ResultInput) -> Result<ResultDocument, Error> {
    ResultDocument::read(&document_tree(result, "a result")?)
}
