//! What a run has done so far, as counts that are the same on every platform, and the seconds that a caller measured.

use crate::json::not_negative;
use serde::{Deserialize, Serialize};

/// The work of one planning run. Counts are part of what a seed decides; seconds are not.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stats {
    /// Iterations made, as the planner counts them.
    pub iterations: u64,
    /// Vertices of the graph.
    pub vertices: u64,
    /// Edges of the graph.
    pub edges: u64,
    /// Configurations tested for collision.
    pub configuration_checks: u64,
    /// Motions tested for collision.
    pub motion_checks: u64,
    /// Questions asked of the nearest-neighbour index.
    pub nearest_queries: u64,
    /// Vertices that the search of the graph expanded.
    pub visited: u64,
    /// Times the clearance of a part has been evaluated.
    pub clearance_evaluations: u64,
    /// Motions refused because their proof had spent its budget of evaluations.
    #[serde(default)] // Absent in results written before proofs had budgets.
    pub unproven_motions: u64,
    /// Seconds spent on growing the graph; 0 where nobody measured: the core reads no clock.
    #[serde(deserialize_with = "not_negative")]
    pub build_seconds: f64,
    /// Seconds spent on searching the graph and shortening the path; 0 where nobody measured.
    #[serde(deserialize_with = "not_negative")]
    pub search_seconds: f64,
}
