//! Planners, one file an algorithm, all behind one small trait; and the table of their parameters and their pseudo-code.
//!
//! A planner sees a space and what is free in it, never a robot or an obstacle. It owns its graph and its generator, so
//! that stepping in any slices gives the same result.

mod active;
mod catalogue;
mod driven_tree;
mod presets;
mod prm;
mod pseudocode;
mod query;
mod roadmap;
mod rows;
mod rrt;
mod rrt_connect;
mod rrt_control;
mod sst;
mod table;
mod visibility_prm;

pub use catalogue::{DEFAULT_TOLERANCE, PlannerInfo, catalogue, default_planner, planner_info, planners};
pub use driven_tree::{Blocked, Durations, GoalTest};
pub use presets::Preset;
pub use prm::{Order, Prm, PrmOptions, logarithmic_k, prm_star_k};
pub use pseudocode::{Mark, PseudocodeLine};
pub use query::{Algorithm, Cost, Heuristic, SearchRules};
pub use roadmap::{Answer, Connection, Roadmap};
pub use rows::{METRIC, MOST_STEPS};
pub use rrt::{Extend, GoalBias, Rrt, RrtOptions};
pub use rrt_connect::RrtConnect;
pub use rrt_control::{Blossom, Late, Origin, RrtControl, RrtControlOptions};
pub use sst::{Sst, SstOptions};
pub use visibility_prm::VisibilityPrm;

pub use crate::parameters::{Fallback, Kind, ParameterInfo, Parameters, Value};
pub use crate::phase::Phase;
pub use crate::status::Status;

use crate::graph::{Graph, VertexId};
use crate::problem::Problem;
use crate::space::Space;

/// What a planner has asked so far.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counters {
    /// Configurations checked on their own.
    pub configuration_checks: u64,
    /// Motions checked.
    pub motion_checks: u64,
    /// Nearest-neighbour queries.
    pub nearest_queries: u64,
    /// Vertices expanded by a search.
    pub visited: u64,
}

/// A planner over a space: a value that is stepped.
pub trait Planner<S: Space> {
    /// Does one iteration, number `iteration` (from 1): a sample tried, a vertex connected, a vertex expanded, with a bounded
    /// number of motion checks. Called only while the status is `Running`.
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status;

    /// What the planner is busy with.
    fn phase(&self) -> Phase;

    /// All that has grown so far.
    fn graph(&self) -> &Graph<S>;

    /// The vertices of the path from start to goal, once solved; empty before.
    fn path(&self) -> Vec<VertexId>;

    /// What was asked so far.
    fn counters(&self) -> Counters;

    /// The vertices of the path from the start to the vertex nearest to the goal, of planners that have one; else empty.
    fn approximate_path(&self) -> Vec<VertexId> {
        Vec::new()
    }

    /// The estimated share of the free space that the roadmap covers, of planners that know.
    fn coverage(&self) -> Option<f64> {
        None
    }

    /// To which others a vertex is joined, of planners that build a roadmap.
    fn connection(&self) -> Option<Connection> {
        None
    }

    /// The roadmap, of planners that build one: it answers further questions.
    fn roadmap(&mut self) -> Option<&mut Roadmap<S>> {
        None
    }
}
