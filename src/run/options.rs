//! The options of a run.

use super::Value;
use crate::planner::default_planner;
use crate::scenario::Scenario;

/// Planner, query, seed and parameters of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The id of the planner; by default that of [`default_planner`] for the robot, or the one that built the roadmap
    /// to continue with.
    pub planner: Option<String>,
    /// The name of the query; by default the first of the scenario.
    pub query: Option<String>,
    /// The seed, up to 2^53 - 1.
    pub seed: u64,
    /// Parameters by name; the rest take their defaults.
    pub parameters: Vec<(String, Value)>,
    /// Whether events are recorded, as by default. Without them a run takes less memory, viewers see no events, and the
    /// fingerprint covers none; graph, path and counts are the same.
    pub events: bool,
}

/// The default planner and query, seed 0, default parameters, with events.
impl Default for Options {
    fn default() -> Self {
        Self { planner: None, query: None, seed: 0, parameters: Vec::new(), events: true }
    }
}

impl Options {
    /// The id of the planner.
    pub fn planner_for(&self, scenario: &Scenario) -> &str {
        self.planner.as_deref().unwrap_or(default_planner(scenario.robot().kind()))
    }
}
