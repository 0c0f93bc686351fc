//! Planners, one file per algorithm, all behind one small trait; each file declares the planner's options and pseudo-code, too.
//!
//! A planner sees a space and its free states, never a robot or an obstacle. It owns its graph and its generator, so
//! stepping in slices of any size gives the same result.

mod aorrtc;
mod best_tree;
mod bit_star;
mod candidates;
mod direct;
mod driven_tree;
mod fmt_star;
mod groups;
mod growth;
mod info;
mod informed_rrt_star;
mod lazy;
mod near;
mod neighbours;
mod prm;
mod query;
mod registry;
mod removable_index;
mod roadmap;
mod rrt;
mod rrt_connect;
mod rrt_control;
mod rrt_star;
mod sst;
mod stride;
mod visibility_prm;

pub use aorrtc::AorrtcOptions;
pub use bit_star::BitStarOptions;
pub use driven_tree::{Blocked, ByControls, Durations, GoalTest, IntegrationKind};
pub use fmt_star::FmtStarOptions;
pub use groups::{
    DEFAULT_TOLERANCE, EdgeCheck, EdgeOptions, GoalBias, Improving, KeepingAway, Limits, MetricOptions, Overgrowth,
    SamplerKind, Sampling, StopWhen, Termination,
};
pub use growth::Growth;
pub use info::{Grows, Mark, PlannerInfo, PlannerKind, Preset, PseudocodeLine};
pub use informed_rrt_star::InformedRrtStarOptions;
pub use near::{NearRule, Nearness};
pub use neighbours::{NeighbourIndex, NeighbourMetric, Neighbouring};
pub use prm::{
    Insertion, LazyPrmOptions, LazyPrmStarOptions, NeighbourRule, PrmOptions, PrmStarOptions, logarithmic_k,
    prm_star_k, reopen, resume,
};
pub use query::{Algorithm, Cost, Heuristic, Searching};
pub use registry::{PlannerOptions, planners};
pub use roadmap::{QueryResult, Roadmap};
pub use rrt::{Extend, RrtOptions};
pub use rrt_connect::RrtConnectOptions;
pub use rrt_control::{Controls, Origin, RrtControlOptions};
pub use rrt_star::{Rewiring, RrtStarOptions};
pub use sst::SstOptions;
pub use visibility_prm::VisibilityPrmOptions;

pub use crate::problem::{Phase, Reason, Status};

use crate::graph::{Graph, VertexId};
use crate::problem::{MaybeSend, Problem};
use crate::space::Space;

/// A planner over a space: a value that is stepped.
///
/// The start is its first vertex, added in iteration 0. [`path`](Planner::path) leads from it to a goal, by vertices that edges
/// join. [`Status::Solved`] with a path ends the planner's part of a run.
pub trait Planner<S: Space>: MaybeSend {
    /// Does one iteration, number `iteration` (from 1): a sample tried, a vertex connected, a vertex expanded, with a bounded
    /// number of motion checks. Called only while the status is `Running`.
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status;

    /// The present phase: by default, that of a tree that grows until there is a path, and may then improve it.
    fn phase(&self) -> Phase {
        match self.path().is_empty() {
            _ if self.cost() < f64::INFINITY => Phase::Improving,
            true => Phase::Growing,
            false => Phase::Done,
        }
    }

    /// The cost of the path of a planner that goes on to cheaper ones as long as it is stepped; it falls whenever the path
    /// changes. Infinite without a path, and for planners whose first path stays. O(1).
    fn cost(&self) -> f64 {
        f64::INFINITY
    }

    /// The graph and the counters so far.
    fn growth(&self) -> &Growth<S>;

    /// The same, to be changed.
    fn growth_mut(&mut self) -> &mut Growth<S>;

    /// The graph so far.
    fn graph(&self) -> &Graph<S> {
        &self.growth().graph
    }

    /// Whether there is no room for more. O(1).
    fn is_full(&self) -> bool {
        self.graph().is_full()
    }

    /// Why an iteration has returned [`Status::Exhausted`]; by default [`Reason::NotConnected`], which is about roadmaps.
    fn reason(&self) -> Reason {
        Reason::NotConnected
    }

    /// The vertices of the path from start to goal; empty until solved. A run panics if it is empty once the planner has returned
    /// [`Status::Solved`].
    fn path(&self) -> Vec<VertexId>;

    /// The vertices of the path from the start to the vertex nearest to the goal, for planners that have one; else empty.
    fn approximate_path(&self) -> Vec<VertexId> {
        Vec::new()
    }

    /// The estimated share of the free space that the roadmap covers, for planners that estimate it.
    fn coverage(&self) -> Option<f64> {
        None
    }

    /// The roadmap, for planners that build one.
    fn roadmap(&self) -> Option<&Roadmap<S>> {
        None
    }

    /// The same, to be queried again.
    fn roadmap_mut(&mut self) -> Option<&mut Roadmap<S>> {
        None
    }
}
