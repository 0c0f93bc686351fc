//! The launch of a run, whatever its robot: what all runs need once their space, their checker and their ends are known.

use super::Run;
use super::info::{EmptyRoadmap, Reopen, RunInfo};
use super::runner::Runner;
use super::storage::{RoadmapDocument, checked_states};
use crate::error::Error;
use crate::nearest::Neighbourhood;
use crate::planner::{self, Planner, PlannerOptions, Searching};
use crate::problem::{Problem, Validity};
use crate::space::Space;

/// Makes the planner of a run, at its beginning, from the problem and the seed.
pub(super) type Begin<'a, S> = dyn FnOnce(&Problem<S>, u64) -> Result<Box<dyn Planner<S>>, Error> + 'a;

/// What a run is made from, but for its planner.
pub(super) struct Launch<S: Space> {
    pub problem: Problem<S>,
    pub info: RunInfo,
    /// Makes the document of a roadmap without its vertices, its edges and how they were chosen; `None` if a roadmap of this run
    /// cannot be saved.
    pub roadmap: Option<EmptyRoadmap>,
    /// `None` if no scenario describes the problem.
    pub reopen: Option<Reopen<S>>,
}

impl<S: Space + 'static> Launch<S> {
    /// A problem without a document, which no other run continues.
    pub fn new(problem: Problem<S>, info: RunInfo) -> Self {
        Self { problem, info, roadmap: None, reopen: None }
    }

    /// The run of a planner that `begin` makes.
    ///
    /// # Errors
    /// Those of `begin`.
    pub fn run(
        self,
        begin: impl FnOnce(&Problem<S>, u64) -> Result<Box<dyn Planner<S>>, Error>,
    ) -> Result<Box<dyn Run>, Error> {
        let planner = begin(&self.problem, self.info.seed)?;
        Ok(self.with(planner))
    }

    /// The run of a planner at its beginning.
    pub fn with(self, planner: Box<dyn Planner<S>>) -> Box<dyn Run> {
        Box::new(Runner::new(self.problem, planner, self.info, self.roadmap, self.reopen))
    }

    /// The run on a saved roadmap, of which all is checked by `finest`: it is searched for one path.
    ///
    /// # Errors
    /// `invalid-roadmap`, and the failure of the checker.
    pub fn resume(
        mut self,
        document: &RoadmapDocument,
        finest: &dyn Validity<S::State>,
        planner: &PlannerOptions,
    ) -> Result<Box<dyn Run>, Error> {
        (self.info.termination, self.info.is_finite) = (None, true);
        self.run(|problem, _| {
            let states = checked_states(problem.space(), finest, document);
            // What is not evaluated is not free either: the failure is the reason.
            let states = finest.failure().map_or(states, Err)?;
            let connection = Neighbourhood::of(document.k as usize, document.radius);
            let searching = planner.group::<Searching>();
            let rules = searching.copied().unwrap_or_default();
            // A planner without a choice of searches is a lazy one.
            Ok(planner::resume(problem, connection, rules, &states, &document.edges, searching.is_none()))
        })
    }
}
