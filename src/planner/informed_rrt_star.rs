//! Informed RRT*: once there is a path, only samples that can shorten it are taken.
//!
//! Gammell, Srinivasa and Barfoot 2014, "Informed RRT*: optimal sampling-based path planning focused via direct sampling of an
//! admissible ellipsoidal heuristic". A sample can shorten the path if the distance from the start to it and on to the goal is
//! less than the length of the path: in the plane an ellipse, and a set that is as easily tested in every other metric. Gammell,
//! Barfoot and Srinivasa 2018, "Informed sampling for asymptotically optimal path planning", also discard vertices that are no
//! longer of use.

use super::Planner;
use super::info::{DIRECT, END_NEAR, Grows, IMPROVE, Mark, NONE_FOUND, PlannerInfo, PlannerKind, line};
use super::rrt_star::{ARRIVE, PARENT, REWIRE, RrtStar, RrtStarOptions, STEER};
use crate::error::Error;
use crate::problem::Problem;
use crate::space::Space;

crate::options! {
    /// Options of Informed RRT*.
    pub struct InformedRrtStarOptions for crate::options::ALL;
    /// Those of RRT*.
    tree: RrtStarOptions;
}

impl PlannerKind for InformedRrtStarOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "informed-rrt-star",
        title: "Informed RRT*",
        summary: "An RRT* that, once it has a path, takes only samples that can shorten it.",
        guarantee: "Asymptotically near-optimal, as RRT*; it approaches the shortest path sooner the less of the space can matter.",
        grows: Grows::Tree,
        presets: &[],
        pseudocode: &[
            DIRECT,
            line(0, "T ← {start}; repeat:", &[]),
            line(1, "q ← a random configuration, or the goal", &[Mark::Growing, Mark::Improving]),
            NONE_FOUND,
            line(1, "while start – q – goal is as long as the path:", &[]),
            line(2, "draw another q, 100 at most", &[Mark::Discarded]),
            STEER,
            PARENT,
            REWIRE,
            ARRIVE,
            IMPROVE,
            END_NEAR,
        ],
    };

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        Ok(Box::new(RrtStar::new(problem, &self.tree, seed, true)?))
    }
}
