//! The result of a run, as it is written.

use crate::stats::Stats;
use serde::Serialize;

/// The result of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ResultDocument {
    /// The scenario's name.
    pub scenario: String,
    /// The query's name.
    pub query: String,
    /// The planner's id.
    pub planner: String,
    /// The seed.
    pub seed: u64,
    /// `running`, `solved` or `exhausted`.
    pub status: String,
    /// The configurations from start to goal; empty unless solved.
    pub path: Vec<Vec<f64>>,
    /// The length of the path in the metric of the space.
    pub length: f64,
    /// What was counted.
    pub stats: Stats,
    /// 16 hexadecimal digits over every vertex, edge and event.
    pub fingerprint: String,
}
