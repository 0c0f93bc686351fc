//! What a run has done so far, as counts that are the same on every platform, and the seconds that a caller measured.

use crate::json::Node;

/// The work of one planning run. Counts are part of what a seed decides; seconds are not.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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
    /// Seconds spent on growing the graph; 0 where nobody measured: the core reads no clock.
    pub build_seconds: f64,
    /// Seconds spent on searching the graph and shortening the path; 0 where nobody measured.
    pub search_seconds: f64,
}

impl Stats {
    /// The counts and times as a tree.
    pub fn to_node(&self) -> Node {
        let count = |count: u64| Some(Node::Number(count as f64));
        Node::object(vec![
            ("iterations", count(self.iterations)),
            ("vertices", count(self.vertices)),
            ("edges", count(self.edges)),
            ("configuration_checks", count(self.configuration_checks)),
            ("motion_checks", count(self.motion_checks)),
            ("nearest_queries", count(self.nearest_queries)),
            ("visited", count(self.visited)),
            ("clearance_evaluations", count(self.clearance_evaluations)),
            ("build_seconds", Some(Node::Number(self.build_seconds))),
            ("search_seconds", Some(Node::Number(self.search_seconds))),
        ])
    }
}
