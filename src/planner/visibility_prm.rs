//! Visibility PRM: few vertices, each a guard of what it sees or a link between guards.
//!
//! Simeon, Laumond and Nissoux 2000, "Visibility-based probabilistic roadmaps for motion planning". A free sample that no
//! guard sees becomes a guard; one that guards of several components see links them; any other is thrown away. After
//! m samples in a row that made no guard the free space is covered but for an estimated share of 1/m. What sees must be seen: the
//! space has to be symmetric.

use super::query::SearchRules;
use super::roadmap::{Connection, Ending, Roadmap, START};
use super::{Counters, Phase, Planner, Status};
use crate::graph::{Event, EventKind, Graph, UnionFind, VertexId};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// The planner. An iteration tries one sample against every guard, or expands one vertex in the search. Start and goals are
/// the first guards.
pub struct VisibilityPrm<S: Space> {
    roadmap: Roadmap<S>,
    sampler: Box<dyn Sampler<S>>,
    guards: Vec<VertexId>,
    components: UnionFind,
    /// After how many samples in a row without a new guard the roadmap is complete.
    most_failures: u32,
    failures: u32,
    /// For every component whether this sample has seen it, by the iteration that did.
    seen: Vec<u32>,
    stage: Stage,
}

enum Stage {
    Guarding,
    Ending(Ending),
}

impl<S: Space> VisibilityPrm<S> {
    /// A planner at its beginning, which gives up on new guards after `most_failures` samples, at least 1. Questions asked
    /// later are joined as `connection` says.
    ///
    /// # Panics
    /// Where the space is not symmetric.
    pub fn new(
        problem: &Problem<S>,
        most_failures: u32,
        connection: Connection,
        rules: SearchRules,
        sampler: Box<dyn Sampler<S>>,
    ) -> Self {
        assert!(problem.space().is_symmetric(), "guards see only where motions can be made back");
        let mut planner = Self {
            roadmap: Roadmap::new(problem, connection, rules),
            sampler,
            guards: Vec::new(),
            components: UnionFind::default(),
            most_failures,
            failures: 0,
            seen: Vec::new(),
            stage: Stage::Guarding,
        };
        let goals = planner.roadmap.goals();
        for end in 0..goals.end.0 {
            planner.components.add();
            planner.seen.push(0);
            planner.guard(0, VertexId(end));
        }
        for goal in goals.start.0..goals.end.0 {
            let edges = planner.roadmap.graph.edges().len();
            planner.roadmap.try_edge(problem, 0, START, VertexId(goal));
            if planner.roadmap.graph.edges().len() > edges {
                planner.components.join(START.index(), goal as usize);
            }
        }
        planner
    }

    fn guard(&mut self, iteration: u32, vertex: VertexId) {
        let state = *self.roadmap.graph.state(vertex);
        let kind = EventKind::GuardAdded;
        self.roadmap.graph.add_event(Event { kind, iteration, vertex: Some(vertex), other: None, state });
        self.guards.push(vertex);
    }

    /// Adds a vertex as a component of its own.
    fn add_vertex(&mut self, space: &S, iteration: u32, state: S::State) -> VertexId {
        self.components.add();
        self.seen.push(0);
        self.roadmap.add_vertex(space, iteration, state)
    }

    /// Tries one sample.
    fn sample(&mut self, problem: &Problem<S>, iteration: u32) {
        let Some(state) = self.roadmap.draw(problem, iteration, &mut *self.sampler) else { return };
        let seen = self.visible_guards(problem, iteration, &state);
        match seen.as_slice() {
            [] => {
                let vertex = self.add_vertex(problem.space(), iteration, state);
                self.guard(iteration, vertex);
                self.failures = 0;
                return;
            }
            [_] => self.roadmap.turn_away(EventKind::SampleDiscarded, iteration, state),
            guards => {
                let vertex = self.add_vertex(problem.space(), iteration, state);
                for &guard in guards {
                    self.roadmap.graph.add_edge(iteration, vertex, guard);
                    self.components.join(vertex.index(), guard.index());
                }
            }
        }
        self.failures += 1;
        if self.failures >= self.most_failures {
            self.stage = Stage::Ending(self.roadmap.begin_search(problem.space()));
        }
    }

    /// Of every component the first guard that sees the state.
    fn visible_guards(&mut self, problem: &Problem<S>, iteration: u32, state: &S::State) -> Vec<VertexId> {
        let mut visible = Vec::new();
        for i in 0..self.guards.len() {
            let guard = self.guards[i];
            let component = self.components.find(guard.index());
            if self.seen[component] == iteration {
                continue;
            }
            let there = *self.roadmap.graph.state(guard);
            if self.roadmap.is_motion_free(problem, state, &there) {
                self.seen[component] = iteration;
                visible.push(guard);
            }
        }
        visible
    }
}

impl<S: Space> Planner<S> for VisibilityPrm<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        match &mut self.stage {
            Stage::Guarding => self.sample(problem, iteration),
            Stage::Ending(ending) => return ending.step(&mut self.roadmap, problem, iteration),
        }
        Status::Running
    }

    fn phase(&self) -> Phase {
        match self.stage {
            Stage::Guarding => Phase::Guarding,
            Stage::Ending(ref ending) => ending.phase(),
        }
    }

    fn graph(&self) -> &Graph<S> {
        &self.roadmap.graph
    }

    fn path(&self) -> Vec<VertexId> {
        if let Stage::Ending(ending) = &self.stage { ending.path().to_vec() } else { Vec::new() }
    }

    fn counters(&self) -> Counters {
        self.roadmap.counters
    }

    fn coverage(&self) -> Option<f64> {
        Some(1.0 - 1.0 / f64::from(self.failures.max(1)))
    }

    fn connection(&self) -> Option<Connection> {
        Some(self.roadmap.connection())
    }

    fn roadmap(&mut self) -> Option<&mut Roadmap<S>> {
        Some(&mut self.roadmap)
    }
}
