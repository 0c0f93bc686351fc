//! The options of a run: typed for Rust, or requested by names.

use super::factory::follows_curves;
use super::storage::RoadmapDocument;
use super::{CustomProblem, Value, resume};
use crate::error::{Code, Error};
use crate::options::{Change, Single, is_for, refusal};
use crate::planner::{
    EdgeCheck, EdgeOptions, Improving, PlannerOptions, RrtConnectOptions, RrtControlOptions, planners,
};
use crate::robot::Car;
use crate::scenario::Robot;

/// How many shortcuts are tried on the path of a planner that was not named.
const SHORTCUTS: u64 = 200;

/// Planner, query and seed of a run.
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
    /// The planner with its options; by default the one that built the roadmap to continue with, or [`default_planner`].
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

    /// The planner: that which suits the robot if none is named. `None` is a robot of your own.
    pub(super) fn planner_for(&self, robot: Option<&Robot>) -> PlannerOptions {
        self.planner.unwrap_or_else(|| default_planner(robot))
    }
}

impl<P: Into<PlannerOptions>> From<P> for Options {
    fn from(planner: P) -> Self {
        Self::new(planner)
    }
}

/// The planner for a robot if none is named, or with `None` for a robot of your own: RRT-Connect, whose path is then shortened
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

/// Options of a run by names, as a command line, a document or a page has them. One of its methods reads them.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// The id of the planner; that of [`default_planner`] if there is none.
    pub planner: Option<String>,
    /// As in [`Options`].
    pub query: Option<String>,
    /// As in [`Options`].
    pub seed: u64,
    /// Parameters of the planner by name; the rest have their defaults.
    pub parameters: Vec<(String, Value)>,
    /// As in [`Options`].
    pub events: bool,
}

/// The default planner and query, seed 0, default parameters, with events.
impl Default for Request {
    fn default() -> Self {
        Self { planner: None, query: None, seed: 0, parameters: Vec::new(), events: true }
    }
}

impl Request {
    /// The options for [`start`](super::start), for this robot.
    ///
    /// # Errors
    /// Those of [`PlannerOptions::read`].
    pub fn for_robot(&self, robot: &Robot) -> Result<Options, Error> {
        self.read(self.planner_or(default_planner(Some(robot)))?)
    }

    /// The options for [`start_problem`](super::start_problem).
    ///
    /// # Errors
    /// Those of [`PlannerOptions::read`]; `unsupported` for options of edges of a problem whose motions are sampled.
    pub fn for_problem(&self, problem: &CustomProblem) -> Result<Options, Error> {
        let options = self.read(self.planner_or(default_planner(None))?)?;
        let is_about_edges = |name: &str| name == "edge_check" || name == "edge_samples";
        if problem.is_sampled() && self.parameters.iter().any(|(name, _)| is_about_edges(name)) {
            return Err(at_resolution());
        }
        Ok(options)
    }

    /// The options for [`resume`](super::resume()) and [`resume_problem`](super::resume_problem) with this roadmap. Parameters that the document holds (`metric`,
    /// `steering`, `k`, `radius`, `edge_check`, `edge_samples`, `tolerance`) may be given again.
    ///
    /// # Errors
    /// Those of [`PlannerOptions::read`]; `invalid-roadmap`; `out-of-range` if another planner or another value of what the document holds
    /// is given, `unsupported` for parameters of a growth that is over.
    pub fn for_roadmap(&self, document: &RoadmapDocument) -> Result<Options, Error> {
        document.check()?;
        let planner = resume::settings(self.planner.as_deref(), &self.parameters, document)?;
        Ok(self.with(planner))
    }

    /// The planner with this id; `default` if there is none.
    fn planner_or(&self, default: PlannerOptions) -> Result<PlannerOptions, Error> {
        self.planner.as_deref().map_or(Ok(default), PlannerOptions::of)
    }

    /// The planner with the parameters given.
    fn read(&self, planner: PlannerOptions) -> Result<Options, Error> {
        planner.updated(&self.parameters).map(|planner| self.with(planner))
    }

    /// The options with a planner.
    pub(crate) fn with(&self, planner: PlannerOptions) -> Options {
        Options { planner: Some(planner), query: self.query.clone(), seed: self.seed, events: self.events }
    }
}

/// The refusal of options about edges that are sampled at the resolution of a problem.
pub(super) fn at_resolution() -> Error {
    Error::new(Code::Unsupported, "/edge_check", "edges are sampled at the resolution of the problem")
}

/// The robot of a [`CustomProblem`], where robots are named by their types.
pub(crate) const OWN: &str = "own";

/// The robot whose motions are rolled out under a learned policy, likewise.
pub(crate) const LEARNED: &str = "learned";

/// Options of checking that rollouts do not have; nor are ends moved, as the start has a heading and the robot turns at the goal.
const NOT_LEARNED: [&str; 3] = ["edge_check", "edge_samples", "free_ends"];

/// A robot by its type, in words.
fn whose(robot: &str) -> String {
    match robot {
        OWN => "a robot of your own".to_owned(),
        LEARNED => "learned edges, which are checked by rollouts in the plane".to_owned(),
        kind => format!("the robot {kind}"),
    }
}

/// Refuses a planner that is not for a robot of this type, and options that are not, unless they have their defaults: the one place that
/// enforces what the tables of options say.
///
/// # Errors
/// `unsupported` for a planner (pointer `/algorithm`), `out-of-range` or `unsupported` with the pointer of the option.
pub(crate) fn check_use(planner: &PlannerOptions, robot: &str) -> Result<(), Error> {
    let whose = whose(robot);
    if !planner.is_for(robot) {
        let fitting: Vec<&str> =
            planners().into_iter().filter(|other| other.is_for(robot)).map(|other| other.id()).collect();
        let (id, own, fitting) = (planner.id(), planner.robots().join(", "), fitting.join(", "));
        let sentence = format!("{id} plans for robots of type {own}, not for {whose}; planners for it are {fitting}");
        return Err(Error::new(Code::Unsupported, "/algorithm", sentence));
    }
    check_options(&planner.changes(), planner.group::<EdgeOptions>(), robot)
}

/// The same for options that differ from their defaults, among them those of edges.
pub(super) fn check_options(changes: &[Change], edges: Option<&EdgeOptions>, robot: &str) -> Result<(), Error> {
    let whose = whose(robot);
    for Change { name, robots, value } in changes {
        let is_of_joints = *name == "edge_check" && *value == EdgeCheck::JointLines.to_value();
        let robots = if is_of_joints { &["arm"] } else { *robots };
        if !is_for(robots, robot) || robot == LEARNED && NOT_LEARNED.contains(name) {
            let code = if robot == LEARNED || *name == "blend" { Code::Unsupported } else { Code::OutOfRange };
            let sentence = match is_for(robots, robot) {
                true => format!("{name} is not for {whose}"),
                false => format!("{name} = {value} is for robots of type {}, not for {whose}", robots.join(", ")),
            };
            return Err(refusal(code, name, sentence));
        }
    }
    if edges.is_some_and(|edges| edges.improving.blend > 0.0 && edges.edge_check != EdgeCheck::Proven) {
        let sentence = "corners are rounded only between proven motions, not with another edge_check";
        return Err(Error::new(Code::Unsupported, "/blend", sentence));
    }
    Ok(())
}
