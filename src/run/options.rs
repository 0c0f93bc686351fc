//! The options of a run.

use crate::planner::{EdgeOptions, Improving, PlannerOptions, RrtConnectOptions, RrtControlOptions};
use crate::robot::Car;
use crate::scenario::Robot;

/// How many shortcuts are tried on the path of a planner that was not named.
const SHORTCUTS: u64 = 200;

/// Planner, query and seed of a run. The path of a planner that is named is improved only if its options say so
/// (`edges.improving`: see [`Improving`]).
///
/// # Example
/// ```
/// use planarium::run::{Options, PrmOptions};
///
/// let prm = PrmOptions { samples: Some(700), k: Some(30), ..PrmOptions::default() };
/// let options = Options { seed: 7, ..Options::new(prm) };
/// assert_eq!(options.planner, Some(prm.into()));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The planner with its options; by default the one that built the roadmap to continue with, or [`default_planner`]; for
    /// learned edges lazy PRM.
    pub planner: Option<PlannerOptions>,
    /// The name of the query; by default the first of the scenario.
    pub query: Option<String>,
    /// The seed, up to 2^53 - 1.
    pub seed: u64,
    /// Whether events are recorded, as by default. Without them a run takes less memory, viewers see no events, and the
    /// fingerprint covers none; graph, path and counts are the same.
    pub events: bool,
}

/// The default planner and query, seed 0, with events.
impl Default for Options {
    fn default() -> Self {
        Self { planner: None, query: None, seed: 0, events: true }
    }
}

impl Options {
    /// A planner with its options; the rest by default.
    pub fn new(planner: impl Into<PlannerOptions>) -> Self {
        Self { planner: Some(planner.into()), ..Self::default() }
    }

    /// The planner: that which suits the robot if none is named. `None` is a custom robot.
    pub(super) fn planner_for(&self, robot: Option<&Robot>) -> PlannerOptions {
        self.planner.unwrap_or_else(|| default_planner(robot))
    }
}

impl From<&Options> for Options {
    fn from(options: &Options) -> Self {
        options.clone()
    }
}

impl<P: Into<PlannerOptions>> From<P> for Options {
    fn from(planner: P) -> Self {
        Self::new(planner)
    }
}

/// The planner for a robot if none is named, or with `None` for a custom robot: RRT-Connect, whose path is then shortened
/// (`reduce`, 200 shortcuts), as raw paths of trees are long. A car that curves do not lead everywhere has RRT by controls.
pub fn default_planner(robot: Option<&Robot>) -> PlannerOptions {
    let by_controls = |car: &Car| !follows_curves(car);
    if matches!(robot, Some(Robot::Car(car)) if by_controls(car)) {
        return RrtControlOptions::default().into();
    }
    let improving = Improving { reduce: true, shortcut: SHORTCUTS, ..Improving::default() };
    let edges = EdgeOptions { improving, ..EdgeOptions::default() };
    RrtConnectOptions { edges, ..RrtConnectOptions::default() }.into()
}

/// The turning radii of steered cars, in metres: far beyond all worlds on either side. Outside, lengths and durations of curves
/// might overflow.
pub(super) const TURNING_RADII: std::ops::RangeInclusive<f64> = 1e-9..=1e9;
/// The least allowed top speed of a steered car, in metres per second, for the same reason.
pub(super) const SLOWEST: f64 = 1e-9;

/// Whether curves lead a car everywhere: it steers to both sides, and fast enough.
fn follows_curves(car: &Car) -> bool {
    let [backward, forward] = car.speed();
    let used = if backward < 0.0 { forward.min(-backward) } else { forward };
    used >= SLOWEST && car.turning_radius().is_some_and(|(radius, _)| TURNING_RADII.contains(&radius))
}
