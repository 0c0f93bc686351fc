//! Visibility PRM: few vertices, each a guard or a connector of guards.
//!
//! Simeon, Laumond and Nissoux 2000, "Visibility-based probabilistic roadmaps for motion planning". A free sample that no
//! guard sees becomes a guard; one that guards of several components see connects them; any other is discarded. After
//! m samples in a row that made no guard the free space is covered but for an estimated share of 1/m. Visibility
//! has to be mutual: the space must be symmetric.

use super::groups::{EdgeOptions, Sampling, Searching};
use super::growth::START;
use super::info::{END, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, line};
use super::roadmap::{Build, Connection, EXPAND, Roadmap, RoadmapPlanner, SEARCH};
use super::{Phase, Planner};
use crate::error::Error;
use crate::graph::{EventKind, UnionFind, VertexId};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// More guards than there ever are: guards are few, and the ends of later queries are connected to all that see them.
const MOST_GUARDS: usize = 1_000_000;

crate::options! {
    /// Options of the visibility PRM.
    pub struct VisibilityPrmOptions for crate::options::ALL;
    /// Number of samples in a row without a new guard before sampling stops: more cover more of the free space.
    failures: u32 = 400, in 1.0..=1e6, "Most failures";
    /// Where samples come from.
    sampling: Sampling;
    /// How the roadmap is searched.
    searching: Searching;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for VisibilityPrmOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "visibility-prm",
        title: "Visibility PRM",
        summary: "Keeps few samples: guards, which no other guard sees, and connectors between guards.",
        guarantee: "None for a run; after m failures in a row an estimated 1 - 1/m of the free space is covered.",
        grows: Grows::Roadmap,
        presets: &[],
        pseudocode: &[
            // A resumed roadmap connects the two to its guards.
            line(0, "G ← start and goal, connected if that is free", &[Mark::Connecting]),
            line(0, "until m samples in a row make no guard:", &[]),
            line(1, "q ← a random configuration", &[Mark::Guarding]),
            line(1, "if q collides: next sample", &[Mark::Rejected]),
            line(1, "which parts of G have a guard that sees q?", &[Mark::Vertex, Mark::Discarded]),
            line(2, "none: add q, as a guard", &[Mark::Guard]),
            line(2, "one: discard q", &[Mark::Discarded]),
            line(2, "several: add q, and an edge to each of them", &[Mark::Edge]),
            SEARCH,
            EXPAND,
            IMPROVE,
            END,
        ],
    };
    const NEEDS_SYMMETRY: bool = true;

    /// # Panics
    /// If the space is not symmetric.
    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        assert!(problem.space().is_symmetric(), "visibility PRM requires a symmetric space");
        let connection = Connection { k: MOST_GUARDS, radius: f64::INFINITY };
        let mut roadmap = Roadmap::new(problem, connection, self.searching);
        let mut guarding = Guarding {
            sampler: self.sampling.sampler(problem.space(), seed),
            guards: Vec::new(),
            components: UnionFind::default(),
            most_failures: self.failures,
            failures: 0,
            seen: Vec::new(),
        };
        let goals = roadmap.goals.clone();
        for end in 0..goals.end.0 {
            guarding.add_component();
            guarding.add_guard(&mut roadmap, 0, VertexId(end));
        }
        for goal in goals.start.0..goals.end.0 {
            if roadmap.try_edge(problem, 0, START, VertexId(goal)) {
                guarding.components.join(START.index(), goal as usize);
            }
        }
        Ok(Box::new(RoadmapPlanner::new(problem, roadmap, guarding, false)))
    }
}

/// Builds the roadmap. An iteration tries one sample against every guard. Start and goals are the first guards.
struct Guarding<S: Space> {
    sampler: Box<dyn Sampler<S>>,
    guards: Vec<VertexId>,
    components: UnionFind,
    /// The number of samples in a row without a new guard after which the roadmap is complete.
    most_failures: u32,
    failures: u32,
    /// The last iteration whose sample was visible from each component.
    seen: Vec<u32>,
}

impl<S: Space> Guarding<S> {
    fn add_guard(&mut self, roadmap: &mut Roadmap<S>, iteration: u32, vertex: VertexId) {
        let state = roadmap.growth.state(vertex);
        roadmap.growth.add_event(EventKind::GuardAdded, iteration, Some(vertex), None, state);
        self.guards.push(vertex);
    }

    /// Adds a component for the next vertex.
    fn add_component(&mut self) {
        self.components.add();
        self.seen.push(0);
    }
}

impl<S: Space> Build<S> for Guarding<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        let Some(state) = roadmap.growth.draw_free(problem, iteration, &mut *self.sampler) else { return false };
        // The first guard of every component that sees the state.
        let mut visible = Vec::new();
        for &guard in &self.guards {
            let component = self.components.find(guard.index());
            let there = roadmap.growth.state(guard);
            if self.seen[component] != iteration && roadmap.growth.is_motion_free(problem, &state, &there) {
                self.seen[component] = iteration;
                visible.push(guard);
            }
        }
        match visible.as_slice() {
            [] => {
                self.add_component();
                let vertex = roadmap.add_vertex(problem.space(), iteration, state);
                self.add_guard(roadmap, iteration, vertex);
                self.failures = 0;
                return false;
            }
            [_] => roadmap.growth.reject(EventKind::SampleDiscarded, iteration, state),
            guards => {
                self.add_component();
                let vertex = roadmap.add_vertex(problem.space(), iteration, state);
                for &guard in guards {
                    roadmap.growth.graph.add_edge(iteration, vertex, guard);
                    self.components.join(vertex.index(), guard.index());
                }
            }
        }
        self.failures += 1;
        self.failures >= self.most_failures
    }

    fn phase(&self, _: &Roadmap<S>) -> Phase {
        Phase::Guarding
    }

    fn coverage(&self) -> Option<f64> {
        Some(1.0 - 1.0 / f64::from(self.failures.max(1)))
    }
}
