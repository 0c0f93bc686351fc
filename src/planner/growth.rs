//! The part of every planner that is shown to viewers: its graph and its counters.

use crate::graph::{Event, EventKind, Graph, VertexId};
use crate::nearest::{Direction, Index, Neighbour, Query};
use crate::problem::{Problem, Stats};
use crate::sampling::{Known, Sample, Sampler};
use crate::space::Space;

/// The vertex that is the start.
pub(super) const START: VertexId = VertexId(0);
/// The first goal, where the goals are the vertices after the start.
pub(super) const GOAL: VertexId = VertexId(1);

/// The goals, with their vertices if these are the ones after the start.
pub(super) fn goals<S: Space>(problem: &Problem<S>) -> impl Iterator<Item = (VertexId, &S::State)> {
    (GOAL.0..).map(VertexId).zip(problem.goals())
}

/// How many samples are drawn until one lies on a path short enough.
const DRAWS: u32 = 100;

/// A graph that grows, with the work so far.
#[derive(Debug, Clone)]
pub struct Growth<S: Space> {
    /// Vertices, edges and events.
    pub graph: Graph<S>,
    /// The checks, queries and expansions so far, and the work of collision checkers other than the problem's; the run fills in
    /// the rest.
    pub counters: Stats,
    /// How many neighbours, edges of searches and entries of queues were looked at, as far as no counter has them.
    pub looked: u64,
    /// How many vertices queries have visited, and other distances were computed, where these are lengths of curves.
    pub visited: u64,
    pub(super) records_events: bool,
}

impl<S: Space> Growth<S> {
    /// An empty graph, whose events are recorded if the problem says so.
    pub fn new(problem: &Problem<S>) -> Self {
        Self {
            graph: Graph::default(),
            counters: Stats::default(),
            looked: 0,
            visited: 0,
            records_events: problem.records_events,
        }
    }

    /// The vertex of a tree that is nearest to the state by motions in the given direction: `In` for a tree that grows from the
    /// start.
    ///
    /// # Panics
    /// If the index is empty.
    pub fn nearest(&mut self, space: &S, index: &Index, direction: Direction, state: &S::State) -> Neighbour {
        self.counters.nearest_queries += 1;
        let query = Query { space, states: self.graph.states(), direction, from: state };
        let (nearest, visited) = index.nearest_counted(query).expect("a tree has a root");
        self.note_visited(space, visited);
        nearest
    }

    /// Notes how many vertices a query has visited.
    pub fn note_visited(&mut self, space: &S, visited: usize) {
        self.visited += if space.is_norm_exact() { 0 } else { visited as u64 };
    }

    /// The state of a vertex.
    pub fn state(&self, vertex: VertexId) -> S::State {
        *self.graph.state(vertex)
    }

    /// Adds an event about a vertex, an edge or a sample, if events are recorded.
    pub fn add_event(
        &mut self,
        kind: EventKind,
        iteration: u32,
        vertex: Option<VertexId>,
        other: Option<VertexId>,
        state: S::State,
    ) {
        if self.records_events {
            self.graph.add_event(Event { kind, iteration, vertex, other, state });
        }
    }

    /// Adds an event about a sample that becomes no vertex, and counts it if it is rejected.
    pub fn reject(&mut self, kind: EventKind, iteration: u32, state: S::State) {
        self.counters.rejected_samples += u64::from(kind == EventKind::SampleRejected);
        self.add_event(kind, iteration, None, None, state);
    }

    /// Draws a sample; `None`, with an event, if the sampler found none.
    pub fn draw(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        sampler: &mut dyn Sampler<S>,
    ) -> Option<Sample<S::State>> {
        let sample = sampler.draw(problem, &mut self.counters.configuration_checks);
        if sample.known == Known::Useless {
            self.reject(EventKind::SampleRejected, iteration, sample.state);
            return None;
        }
        Some(sample)
    }

    /// Draws a sample that is free; `None`, with an event, if the one drawn is not.
    pub fn draw_free(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        sampler: &mut dyn Sampler<S>,
    ) -> Option<S::State> {
        let sample = self.draw(problem, iteration, sampler)?;
        self.if_free(problem, iteration, sample)
    }

    /// The state of a sample if it is free; else `None`, with an event.
    pub fn if_free(&mut self, problem: &Problem<S>, iteration: u32, sample: Sample<S::State>) -> Option<S::State> {
        let Sample { state, known } = sample;
        if known == Known::Nothing {
            self.counters.configuration_checks += 1;
            if !problem.validity().is_free(&state) {
                self.reject(EventKind::SampleRejected, iteration, state);
                return None;
            }
        }
        Some(state)
    }

    /// The first of a few draws through which a path from start to goal may be shorter than `bound`; `None`, with an event, if
    /// there is none. A draw that finds nothing is the last.
    pub fn draw_within(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        bound: f64,
        mut draw: impl FnMut(&mut Self) -> Option<S::State>,
    ) -> Option<S::State> {
        let mut useless = None;
        for _ in 0..DRAWS {
            let target = draw(self)?;
            if bound == f64::INFINITY {
                return Some(target);
            }
            self.looked += 1;
            self.note_visited(problem.space(), 2);
            if problem.distances_through(&target).iter().sum::<f64>() < bound {
                return Some(target);
            }
            useless = Some(target);
        }
        self.reject(EventKind::SampleDiscarded, iteration, useless?);
        None
    }

    /// Whether the motion is proven free; counts the check.
    pub fn is_motion_free(&mut self, problem: &Problem<S>, from: &S::State, to: &S::State) -> bool {
        self.counters.motion_checks += 1;
        problem.validity().is_motion_free(from, to)
    }
}
