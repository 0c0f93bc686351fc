//! The options of a run.

use super::Value;
use crate::error::Error;
use crate::planner::{Improving, PlannerKind, PlannerOptions, RrtConnectOptions, RrtControlOptions};
use crate::robot::Car;
use crate::scenario::{Robot, Scenario};

/// How many shortcuts are tried on the path of a planner that was not named.
const SHORTCUTS: f64 = 200.0;

/// Planner, query, seed and parameters of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The id of the planner; by default the one that built the roadmap to continue with, or `rrt-connect`, and its path is then
    /// shortened (`reduce=true`, `shortcut=200`), unless these options are given. A car that curves do not lead everywhere has
    /// `rrt-control`.
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
        match (&self.planner, scenario.robot()) {
            (Some(planner), _) => planner,
            (None, Robot::Car(car)) if !follows_curves(car) => RrtControlOptions::INFO.id,
            _ => self.planner_for_own(),
        }
    }

    /// The same for a robot that no scenario describes.
    pub(super) fn planner_for_own(&self) -> &str {
        self.planner.as_deref().unwrap_or(RrtConnectOptions::INFO.id)
    }

    /// The planner with the parameters given. If it was not named, its path is shortened: raw paths of trees are long.
    ///
    /// # Errors
    /// As [`PlannerOptions::read`].
    pub(super) fn read(&self, planner: PlannerOptions) -> Result<PlannerOptions, Error> {
        let mut parameters = self.parameters.clone();
        if self.planner.is_none() && planner.group::<Improving>().is_some() {
            for (name, value) in [("reduce", Value::Boolean(true)), ("shortcut", Value::Number(SHORTCUTS))] {
                if parameters.iter().all(|(given, _)| given != name) {
                    parameters.push((name.to_owned(), value));
                }
            }
        }
        planner.read(&parameters)
    }
}

/// The turning radii of steered cars, in metres: far beyond all worlds on either side. Outside, lengths and durations of curves might
/// overflow.
pub(super) const TURNING_RADII: std::ops::RangeInclusive<f64> = 1e-9..=1e9;
/// The least allowed top speed of a steered car, in metres per second, for the same reason.
pub(super) const SLOWEST: f64 = 1e-9;

/// Whether curves lead a car everywhere: it steers to both sides, and fast enough.
fn follows_curves(car: &Car) -> bool {
    let [backward, forward] = car.speed();
    let used = if backward < 0.0 { forward.min(-backward) } else { forward };
    used >= SLOWEST && car.turning_radius().is_some_and(|(radius, _)| TURNING_RADII.contains(&radius))
}
