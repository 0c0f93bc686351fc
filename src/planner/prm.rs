//! k-PRM: the probabilistic roadmap whose vertices are joined to their k nearest neighbours.
//!
//! Kavraki, Svestka, Latombe and Overmars 1996, "Probabilistic roadmaps for path planning in high-dimensional configuration
//! spaces"; LaValle 2006, "Planning Algorithms", section 5.6. In batch: first all samples, then all edges, every pair
//! tried once, then one search. Start and goal are the first two vertices.

use super::{Counters, Planner, Status};
use crate::graph::search::{AStar, Expansion};
use crate::graph::{Adjacency, Event, EventKind, Graph, VertexId};
use crate::nearest::{LinearScan, Nearest, Neighbour};
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::space::Space;
use crate::validity::Validity;

/// The start is vertex 0.
const START: VertexId = VertexId(0);
/// The goal is vertex 1.
const GOAL: VertexId = VertexId(1);

/// The planner. An iteration tries one sample, connects one vertex to its neighbours, or expands one vertex in the search.
#[derive(Debug, Clone)]
pub struct Prm<S: Space> {
    samples: usize,
    k: usize,
    random: Random,
    graph: Graph<S>,
    nearest: LinearScan<S>,
    /// For every vertex already connected its k-th neighbour, and so which later vertices it has tried.
    farthest: Vec<Neighbour>,
    neighbours: Vec<Neighbour>,
    phase: Phase,
    counters: Counters,
}

#[derive(Debug, Clone)]
enum Phase {
    Sampling,
    Connecting { next: VertexId },
    Searching { adjacency: Adjacency, search: AStar },
    Done { path: Vec<VertexId> },
}

impl<S: Space> Prm<S> {
    /// A roadmap of `samples` free samples, each joined to its `k` nearest neighbours, k at least 1.
    pub fn new<V: Validity<S::State>>(problem: &Problem<S, V>, samples: usize, k: usize, seed: u64) -> Self {
        let mut prm = Self {
            samples,
            k,
            random: Random::new(seed, Stream::Samples),
            graph: Graph::default(),
            nearest: LinearScan::new(),
            farthest: Vec::new(),
            neighbours: Vec::new(),
            phase: Phase::Sampling,
            counters: Counters::default(),
        };
        prm.add_vertex(problem.space(), 0, *problem.start());
        prm.add_vertex(problem.space(), 0, *problem.goal());
        prm.finish_sampling();
        prm
    }

    fn add_vertex(&mut self, space: &S, iteration: u32, state: S::State) {
        let vertex = self.graph.add_vertex(iteration, state);
        self.nearest.insert(space, vertex, state);
    }

    /// Goes on to connecting once there are enough samples.
    fn finish_sampling(&mut self) {
        if self.graph.states().len() == self.samples + 2 {
            self.phase = Phase::Connecting { next: START };
        }
    }

    /// Tries one sample.
    fn sample<V: Validity<S::State>>(&mut self, problem: &Problem<S, V>, iteration: u32) {
        let state = problem.space().sample(&mut self.random);
        self.counters.configuration_checks += 1;
        if problem.validity().is_free(&state) {
            self.add_vertex(problem.space(), iteration, state);
            self.finish_sampling();
        } else {
            let kind = EventKind::SampleRejected;
            self.graph.add_event(Event { kind, iteration, vertex: None, other: None, state });
        }
    }

    /// Tries the motions from one vertex to its k nearest neighbours, but for pairs that were tried from the other side.
    fn connect<V: Validity<S::State>>(&mut self, problem: &Problem<S, V>, iteration: u32, vertex: VertexId) {
        let state = *self.graph.state(vertex);
        self.counters.nearest_queries += 1;
        self.nearest.k_nearest(problem.space(), &state, self.k + 1, &mut self.neighbours);
        match self.neighbours.iter().position(|neighbour| neighbour.vertex == vertex) {
            Some(own) => drop(self.neighbours.remove(own)),
            None => self.neighbours.truncate(self.k),
        }
        let farthest = self.neighbours.last().copied().unwrap_or(Neighbour { distance: 0.0, vertex });
        self.farthest.push(farthest);
        for neighbour in &self.neighbours {
            let other = neighbour.vertex;
            let back = Neighbour { distance: neighbour.distance, vertex };
            // A vertex connected earlier has tried all up to its farthest neighbour.
            if other < vertex && !self.farthest[other.index()].is_before(&back) {
                continue;
            }
            self.counters.motion_checks += 1;
            let target = *self.graph.state(other);
            if problem.validity().is_motion_free(&state, &target) {
                self.graph.add_edge(iteration, vertex, other);
            } else {
                let kind = EventKind::EdgeRefused;
                self.graph.add_event(Event {
                    kind,
                    iteration,
                    vertex: Some(vertex),
                    other: Some(other),
                    state: target,
                });
            }
        }
    }

    /// Begins the search for the cheapest path on the finished roadmap.
    fn begin_search(&self, space: &S) -> Phase {
        let vertices = self.graph.states().len();
        let estimate = space.distance(self.graph.state(START), self.graph.state(GOAL));
        Phase::Searching {
            adjacency: Adjacency::new(vertices, self.graph.edges()),
            search: AStar::new(vertices, START, GOAL, estimate),
        }
    }
}

impl<S: Space> Planner<S> for Prm<S> {
    fn iterate<V: Validity<S::State>>(&mut self, problem: &Problem<S, V>, iteration: u32) -> Status {
        match &mut self.phase {
            Phase::Sampling => self.sample(problem, iteration),
            Phase::Connecting { next } => {
                let vertex = *next;
                *next = VertexId(vertex.0 + 1);
                let is_last = next.index() == self.graph.states().len();
                self.connect(problem, iteration, vertex);
                if is_last {
                    self.phase = self.begin_search(problem.space());
                }
            }
            Phase::Searching { adjacency, search } => {
                let (space, graph) = (problem.space(), &self.graph);
                let distance = |a: VertexId, b: VertexId| space.distance(graph.state(a), graph.state(b));
                let (vertex, kind, path) = match search.step(adjacency, distance, |v| distance(v, GOAL)) {
                    Expansion::Vertex(vertex) => (vertex, EventKind::VertexExpanded, None),
                    Expansion::Goal => (GOAL, EventKind::SolutionFound, Some(search.path())),
                    Expansion::Nothing => {
                        self.phase = Phase::Done { path: Vec::new() };
                        return Status::Exhausted;
                    }
                };
                self.counters.visited += 1;
                let state = *self.graph.state(vertex);
                self.graph.add_event(Event { kind, iteration, vertex: Some(vertex), other: None, state });
                if let Some(path) = path {
                    self.phase = Phase::Done { path };
                    return Status::Solved;
                }
            }
            Phase::Done { path } => return if path.is_empty() { Status::Exhausted } else { Status::Solved },
        }
        Status::Running
    }

    fn phase(&self) -> &'static str {
        match self.phase {
            Phase::Sampling => "sampling",
            Phase::Connecting { .. } => "connecting",
            Phase::Searching { .. } => "searching",
            Phase::Done { .. } => "done",
        }
    }

    fn graph(&self) -> &Graph<S> {
        &self.graph
    }

    fn path(&self) -> Vec<VertexId> {
        if let Phase::Done { path } = &self.phase { path.clone() } else { Vec::new() }
    }

    fn counters(&self) -> Counters {
        self.counters
    }
}
