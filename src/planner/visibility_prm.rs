//! Visibility PRM: few vertices, each a guard or a connector of guards.
//!
//! Simeon, Laumond and Nissoux 2000, "Visibility-based probabilistic roadmaps for motion planning". A free sample that no
//! guard sees becomes a guard; one that guards of several components see connects them; any other is discarded. After
//! m samples in a row that made no guard the free space is covered but for an estimated share of 1/m. Visibility
//! has to be mutual: the space must be symmetric.

use super::groups::{EdgeOptions, Sampling};
use super::growth::START;
use super::info::{END, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, line};
use super::query::Searching;
use super::roadmap::{Build, EXPAND, Roadmap, RoadmapPlanner, SEARCH};
use super::{Phase, Planner};
use crate::error::Error;
use crate::graph::{EventKind, UnionFind, VertexId};
use crate::nearest::Neighbourhood;
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// More guards than there ever are: guards are few, and the ends of later queries are connected to all that see them.
const MOST_GUARDS: usize = 1_000_000;

/// The most motions that an iteration tries.
const MOST_MOTIONS: usize = 256;

/// The number of samples in a row without a new guard if none is given.
const DEFAULT_FAILURES: u32 = 400;

/// If the number of failures in a row is not given, a roadmap that connects start and goal is complete after this many
/// times as many samples: in a space of many small parts new guards turn up for a long time.
const ENOUGH: u32 = 10;

crate::options! {
    /// Options of the visibility PRM.
    pub struct VisibilityPrmOptions for crate::options::ALL;
    /// Number of samples in a row without a new guard before sampling stops: more cover more of the free space.
    failures: Option<u32>, in 1.0..=1e6, "Most failures", else "400, and twice as many while there is no path; after ten times as many samples a path is enough";
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
        let connection = Neighbourhood::Nearest(MOST_GUARDS);
        let mut roadmap = Roadmap::new(problem, connection, self.searching);
        let mut guarding = Guarding {
            sampler: self.sampling.sampler(problem.space(), seed),
            sample: None,
            guards: Vec::new(),
            components: UnionFind::default(),
            most_failures: self.failures.unwrap_or(DEFAULT_FAILURES),
            grows: self.failures.is_none(),
            failures: 0,
            samples: 0,
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

/// A sample that is tested against the guards.
struct Tested<S> {
    state: S,
    /// The iteration in which it was drawn.
    drawn: u32,
    /// How many guards it was tested against.
    guards: usize,
    /// The first guard of every component that sees it.
    visible: Vec<VertexId>,
}

/// Builds the roadmap. An iteration tries one sample against every guard, or goes on with one that has more to be tested against.
/// Start and goals are the first guards.
struct Guarding<S: Space> {
    /// The sample that is not done yet.
    sample: Option<Tested<S::State>>,
    sampler: Box<dyn Sampler<S>>,
    guards: Vec<VertexId>,
    components: UnionFind,
    /// The number of samples in a row without a new guard after which the roadmap is complete.
    most_failures: u32,
    /// Whether there are twice as many where start and goal are not connected.
    grows: bool,
    failures: u32,
    /// The number of free samples.
    samples: u32,
    /// The last iteration that drew a sample visible from each component.
    seen: Vec<u32>,
}

impl<S: Space> Guarding<S> {
    fn add_guard(&mut self, roadmap: &mut Roadmap<S>, iteration: u32, vertex: VertexId) {
        let state = roadmap.growth.state(vertex);
        roadmap.growth.add_event(EventKind::GuardAdded, iteration, Some(vertex), None, state);
        self.guards.push(vertex);
    }

    /// Whether start and a goal are connected after enough samples.
    fn is_enough(&mut self, roadmap: &Roadmap<S>) -> bool {
        let start = self.components.find(START.index());
        self.samples >= self.most_failures.saturating_mul(ENOUGH)
            && (roadmap.goals.start.0..roadmap.goals.end.0).any(|goal| self.components.find(goal as usize) == start)
    }

    /// Adds a component for the next vertex.
    fn add_component(&mut self) {
        self.components.add();
        self.seen.push(0);
    }
}

impl<S: Space> Build<S> for Guarding<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        let mut sample = match self.sample.take() {
            Some(sample) => sample,
            None => {
                let drawn = roadmap.growth.draw_free(problem, iteration, &mut *self.sampler);
                let Some(state) = drawn else { return false };
                Tested { state, drawn: iteration, guards: 0, visible: Vec::new() }
            }
        };
        let mut left = MOST_MOTIONS;
        for &guard in &self.guards[sample.guards..] {
            let component = self.components.find(guard.index());
            if self.seen[component] != sample.drawn {
                if left == 0 {
                    self.sample = Some(sample);
                    return false;
                }
                left -= 1;
                let there = roadmap.growth.state(guard);
                if roadmap.growth.is_motion_free(problem, &sample.state, &there) {
                    self.seen[component] = sample.drawn;
                    sample.visible.push(guard);
                }
            }
            sample.guards += 1;
        }
        self.samples = self.samples.saturating_add(1);
        roadmap.growth.looked += self.guards.len() as u64;
        let Tested { state, visible, .. } = sample;
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
        self.failures >= self.most_failures || (self.grows && self.is_enough(roadmap))
    }

    fn grow(&mut self, _: &mut Roadmap<S>, _: usize) -> bool {
        if self.grows {
            self.most_failures = self.most_failures.saturating_mul(2);
        }
        self.grows
    }

    fn phase(&self, _: &Roadmap<S>) -> Phase {
        Phase::Guarding
    }

    fn coverage(&self) -> Option<f64> {
        Some(1.0 - 1.0 / f64::from(self.failures.max(1)))
    }
}
