//! A custom planner for the robots of scenarios.

use super::Run;
use super::factory::{Setup, Source};
use super::info::RunInfo;
use super::suitable::check_options;
use crate::error::{Code, Error};
use crate::options::Options as _;
use crate::planner::{EdgeOptions, Planner, Termination};
use crate::problem::Problem;
use crate::random::check_seed;
use crate::space::MotionSpace;
use crate::world::PlanningWorld;

/// How a custom planner plans for the robot of a scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnPlanner {
    /// The id of the planner in results.
    pub id: &'static str,
    /// The name of the query; by default the first of the scenario.
    pub query: Option<String>,
    /// The seed, up to 2^53 - 1.
    pub seed: u64,
    /// Whether events are recorded.
    pub events: bool,
    /// How motions are checked and measured, the limits of the run, and how its path is improved. `direct` is of no effect: your
    /// planner decides whether it tries the straight motion.
    pub edges: EdgeOptions,
    /// When a planner that goes on to shorter paths ends; `None` if its first path stays.
    pub termination: Option<Termination>,
    /// Whether every motion must be possible in both directions: forward curves of a car are refused.
    pub needs_symmetry: bool,
}

/// The planner `custom`, for the first query, with seed 0 and events; its first path stays.
impl Default for OwnPlanner {
    fn default() -> Self {
        let (query, edges) = (None, EdgeOptions::default());
        Self { id: "custom", query, seed: 0, events: true, edges, termination: None, needs_symmetry: false }
    }
}

/// Begins a run of a custom planner for the robot of a scenario, in the space of its configurations: states are `N` numbers,
/// of which those beyond the robot's dimension are 0. With `N` = 4 it plans for discs, bodies, cars and arms of up to four links,
/// with [`MAX_DIMENSION`](crate::space::MAX_DIMENSION) for every robot. Everything but the planner is as for the planners of this
/// crate: motions are proven, limits hold, the path is improved, slices do not change the result. Its roadmap, if it builds one,
/// can be queried, but neither saved nor reopened.
///
/// # Errors
/// `unsupported` if a configuration has more than `N` numbers; those of [`start`](super::start) about the query, options and
/// ends; those of `begin`.
///
/// # Example
/// A planner that goes straight to the goal or, where that is not free, on to a sample:
///
/// ```
/// use planarium::graph::VertexId;
/// use planarium::planner::{Growth, Planner};
/// use planarium::problem::Problem;
/// use planarium::random::{Random, Stream};
/// use planarium::run::{self, OwnPlanner, Status};
/// use planarium::sampling::Uniform;
/// use planarium::space::{MotionSpace, Space};
/// use planarium::worlds::generate;
///
/// struct Walk<S: Space> {
///     growth: Growth<S>,
///     samples: Uniform,
///     walked: Vec<VertexId>,
///     is_over: bool,
/// }
///
/// impl<S: Space> Planner<S> for Walk<S> {
///     fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
///         let last = self.walked[self.walked.len() - 1];
///         let from = self.growth.state(last);
///         self.is_over = self.growth.is_motion_free(problem, &from, problem.goal());
///         let next = match self.is_over {
///             true => Some(*problem.goal()),
///             false => self.growth.draw_free(problem, iteration, &mut self.samples),
///         };
///         if let Some(next) = next
///             && (self.is_over || self.growth.is_motion_free(problem, &from, &next))
///         {
///             let vertex = self.growth.graph.add_vertex(iteration, next);
///             self.growth.graph.add_edge(iteration, last, vertex);
///             self.walked.push(vertex);
///         }
///         if self.is_over { Status::Solved } else { Status::Running }
///     }
///
///     fn growth(&self) -> &Growth<S> {
///         &self.growth
///     }
///
///     fn growth_mut(&mut self) -> &mut Growth<S> {
///         &mut self.growth
///     }
///
///     fn path(&self) -> Vec<VertexId> {
///         if self.is_over { self.walked.clone() } else { Vec::new() }
///     }
/// }
///
/// let scenario = generate("discs", &serde_json::json!({ "seed": 3 }))?;
/// let planner = OwnPlanner { id: "walk", seed: 7, ..OwnPlanner::default() };
/// let mut run = run::start_with(&scenario, &planner, |problem: &Problem<MotionSpace<4>>, seed| {
///     let mut growth = Growth::new(problem);
///     let walked = vec![growth.graph.add_vertex(0, *problem.start())];
///     let samples = Uniform(Random::new(seed, Stream::Samples));
///     Ok(Box::new(Walk { growth, samples, walked, is_over: false }))
/// })?;
/// assert_eq!(run.step(10_000), Status::Solved);
/// assert!(planarium::path::verify(&scenario, &run.result())?.is_valid());
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn start_with<const N: usize>(
    scenario: impl Into<PlanningWorld>,
    planner: &OwnPlanner,
    begin: impl FnOnce(&Problem<MotionSpace<N>>, u64) -> Result<Box<dyn Planner<MotionSpace<N>>>, Error>,
) -> Result<Box<dyn Run>, Error> {
    let world = scenario.into();
    let (dimension, kind) = (world.robot().dimension(), world.robot().kind());
    if dimension > N {
        let sentence = format!("a configuration of this robot has {dimension} numbers; the planner has {N}");
        return Err(Error::new(Code::Unsupported, "/robot", sentence));
    }
    check_seed(planner.seed)?;
    planner.edges.check()?;
    check_options(&planner.edges.changes(), Some(&planner.edges), kind)?;
    let termination = planner.termination.map(|termination| termination.check().map(|()| termination)).transpose()?;
    let info = RunInfo { planner: planner.id, seed: planner.seed, termination, ..RunInfo::of_edges(&planner.edges) };
    let query = world.scenario().find_query(planner.query.as_deref())?;
    let mut setup = Setup::new(&world, info, Some(planner.edges), query)?;
    (setup.events, setup.needs_symmetry) = (planner.events, planner.needs_symmetry);
    setup.run(Source::Own(Box::new(begin)))
}
