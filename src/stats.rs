//! What a run has counted.

use serde::Serialize;

/// Counts of one run. The seconds are filled in by whoever holds a clock; the core reads none.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Stats {
    /// Iterations made.
    pub iterations: u64,
    /// Vertices of the graph.
    pub vertices: u64,
    /// Edges of the graph.
    pub edges: u64,
    /// Configurations checked on their own.
    pub configuration_checks: u64,
    /// Motions checked.
    pub motion_checks: u64,
    /// Nearest-neighbour queries.
    pub nearest_queries: u64,
    /// Vertices expanded by a search.
    pub visited: u64,
    /// Clearances of one part of the robot from one obstacle evaluated.
    pub clearance_evaluations: u64,
    /// Seconds spent growing.
    pub build_seconds: f64,
    /// Seconds spent searching and shortening.
    pub search_seconds: f64,
}
