//! A run as it is requested by names.

use super::options::default_planner;
use super::storage::RoadmapDocument;
use super::suitable::at_resolution;
use super::{CustomProblem, Options, Value, resume};
use crate::error::Error;
use crate::planner::PlannerOptions;
use crate::scenario::{Robot, Scenario};

/// Options of a run by names, as a command line, a document or a page has them. One of its methods reads
/// them, or for learned edges [`navigation::read_options`](crate::navigation::read_options).
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// The id of the planner; by default as in [`Options`].
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
        self.read(default_planner(Some(robot)))
    }

    /// The options for [`start_problem`](super::start_problem).
    ///
    /// # Errors
    /// Those of [`PlannerOptions::read`]; `unsupported` for options of edges of a problem whose motions are sampled.
    pub fn for_problem(&self, problem: &CustomProblem) -> Result<Options, Error> {
        let options = self.read(default_planner(None))?;
        let is_about_edges = |name: &str| name == "edge_check" || name == "edge_samples";
        if problem.is_sampled() && self.parameters.iter().any(|(name, _)| is_about_edges(name)) {
            return Err(at_resolution());
        }
        Ok(options)
    }

    /// The options for [`resume`](super::resume()) with this roadmap. Parameters that the document holds (`metric`, `steering`,
    /// `k`, `radius`, `edge_check`, `edge_samples`, `tolerance`) may be given again.
    ///
    /// # Errors
    /// `other-scenario` and `invalid-roadmap`; those of [`PlannerOptions::read`]; `out-of-range` if another planner or another
    /// value of what the document holds is given, `unsupported` for parameters of a growth that is over.
    pub fn for_roadmap(&self, scenario: &Scenario, document: &RoadmapDocument) -> Result<Options, Error> {
        resume::check_scenario(scenario, document)?;
        self.continued(document)
    }

    /// The options for [`resume_problem`](super::resume_problem) with this roadmap, as [`Request::for_roadmap`].
    ///
    /// # Errors
    /// As [`Request::for_roadmap`].
    pub fn for_roadmap_of(&self, problem: &CustomProblem, document: &RoadmapDocument) -> Result<Options, Error> {
        resume::check_problem(problem, document)?;
        self.continued(document)
    }

    fn continued(&self, document: &RoadmapDocument) -> Result<Options, Error> {
        let planner = resume::settings(self.planner.as_deref(), &self.parameters, document)?;
        Ok(self.with(planner))
    }

    /// The options with the planner that is named, else `default`, and with the parameters given.
    pub(crate) fn read(&self, default: PlannerOptions) -> Result<Options, Error> {
        let planner = self.planner.as_deref().map_or(Ok(default), PlannerOptions::of)?;
        planner.updated(&self.parameters).map(|planner| self.with(planner))
    }

    /// The options with a planner.
    fn with(&self, planner: PlannerOptions) -> Options {
        Options { planner: Some(planner), query: self.query.clone(), seed: self.seed, events: self.events }
    }
}
