//! The launch of a run, whatever its robot: what all runs need once their space, their checker and their ends are known.

use super::Run;
use super::resume::checked_states;
use super::runner::Runner;
use super::storage::RoadmapDocument;
use crate::error::Error;
use crate::path::{LengthMeasure, Wanted};
use crate::planner::{
    self, ByControls, Connection, EdgeCheck, EdgeOptions, IntegrationKind, Limits, Overgrowth, Planner, PlannerOptions,
    Roadmap, Searching, Termination,
};
use crate::problem::{Problem, Validity, nearest_free};
use crate::space::Space;
use crate::world::PlanningWorld;

/// The names and numbers that a run copies into its result.
#[derive(Debug, Clone, Default)]
pub(super) struct RunInfo {
    pub scenario: String,
    pub query: String,
    pub planner: &'static str,
    pub seed: u64,
    pub limits: Limits,
    /// Whether the planner ends by itself, with a number of samples that was given.
    pub is_finite: bool,
    /// The vertices that a tree is to have.
    pub vertices: Option<u32>,
    pub wanted: Wanted,
    /// When a planner that goes on to shorter paths is to end; `None` for others.
    pub termination: Option<Termination>,
    pub edge_check: EdgeCheck,
    /// What lengths measure; `None` if that is not known.
    pub measure: Option<LengthMeasure>,
    /// The start, if it was moved out of a collision, and the goals that were.
    pub moved_start: Option<Vec<f64>>,
    pub moved_goals: Vec<Vec<f64>>,
    /// Whether motions are rolled out under a learned policy.
    pub is_learned: bool,
    /// Whether motions are those of controls.
    pub is_driven: bool,
    /// Whether motions are integrated by Euler steps.
    pub is_euler: bool,
}

impl RunInfo {
    /// What a run copies from the options of its planner.
    pub fn of(planner: &PlannerOptions, seed: u64) -> Self {
        let edges = planner.group::<EdgeOptions>().map_or_else(Self::default, Self::of_edges);
        let driving = planner.group::<ByControls>();
        Self {
            planner: planner.id(),
            seed,
            limits: planner.group::<Limits>().copied().unwrap_or_default(),
            is_finite: planner.needed().is_some(),
            vertices: planner.group::<Overgrowth>().and_then(|growth| growth.vertices),
            termination: planner.group::<Termination>().copied(),
            is_driven: driving.is_some(),
            is_euler: driving.is_some_and(|by| by.integration == IntegrationKind::Euler),
            ..edges
        }
    }

    /// What it copies from the options of edges.
    pub fn of_edges(&EdgeOptions { improving, edge_check, limits, .. }: &EdgeOptions) -> Self {
        let wanted = Wanted {
            reduce: improving.reduce,
            shortcuts: improving.shortcut,
            partial_shortcuts: improving.partial_shortcut,
            blend: improving.blend,
        };
        Self { wanted, edge_check, limits, ..Self::default() }
    }

    /// Moves a start and goals in collision to the nearest free states that are found, at most so far, and notes which were. Those without
    /// one stay as they are, to be refused.
    pub fn move_ends<S: Space>(
        &mut self,
        space: &S,
        validity: &dyn Validity<S::State>,
        start: &mut S::State,
        goals: &mut [S::State],
        most: f64,
    ) {
        let nearest = |state: &S::State| {
            let is_free = |q: &S::State| validity.is_free(q);
            if is_free(state) { None } else { nearest_free(space, &is_free, state, most).map(|(moved, _)| moved) }
        };
        if let Some(moved) = nearest(start) {
            *start = moved;
            self.moved_start = Some(space.coordinates(start).to_vec());
        }
        for goal in goals {
            if let Some(moved) = nearest(goal) {
                *goal = moved;
                self.moved_goals.push(space.coordinates(goal).to_vec());
            }
        }
    }
}

/// Begins a run in another world with a roadmap of this one.
pub(super) type Reopen<S> = Box<dyn Fn(&PlanningWorld, &Roadmap<S>) -> Result<Box<dyn Run>, Error> + Send>;

/// Makes the planner of a run, at its beginning, from the problem and the seed.
pub(super) type Begin<'a, S> = dyn FnOnce(&Problem<S>, u64) -> Result<Box<dyn Planner<S>>, Error> + 'a;

/// What a run is made from, but for its planner.
pub(super) struct Launch<S: Space> {
    pub problem: Problem<S>,
    pub info: RunInfo,
    /// The document of a roadmap without its vertices, its edges and how they were chosen; `None` if a roadmap of this run cannot be saved.
    pub roadmap: Option<RoadmapDocument>,
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
        let connection = planner.roadmap().map(|roadmap| roadmap.connection);
        let with = |(document, connection): (RoadmapDocument, Connection)| RoadmapDocument {
            k: connection.k as u32,
            radius: connection.radius,
            ..document
        };
        let roadmap = self.roadmap.zip(connection).map(with);
        Box::new(Runner::new(self.problem, planner, self.info, roadmap, self.reopen))
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
            let connection = Connection { k: document.k as usize, radius: document.radius };
            let searching = planner.group::<Searching>();
            let rules = searching.copied().unwrap_or_default();
            // A planner without a choice of searches is a lazy one.
            Ok(planner::resume(problem, connection, rules, &states, &document.edges, searching.is_none()))
        })
    }
}
