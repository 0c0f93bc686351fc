//! What all roadmap planners share: vertices with their neighbours, edges that are proven before they are added, and
//! questions asked again and again. In a space that is not symmetric an edge leads from its first vertex to its second only.

use super::query::{Query, SearchRules};
use super::{Counters, Phase, Status};
use crate::graph::search::{Expansion, Goals};
use crate::graph::{Event, EventKind, Graph, VertexId};
use crate::nearest::{Index, Nearest, Neighbour, Way};
use crate::problem::Problem;
use crate::sampling::{Known, Sample, Sampler};
use crate::space::Space;

/// The start is vertex 0.
pub(super) const START: VertexId = VertexId(0);
/// The goal is vertex 1; where there are several, they are the vertices from 1 on.
pub(super) const GOAL: VertexId = VertexId(1);

/// To which other vertices a vertex is joined, where the motion is free: its `k` nearest of those within `radius`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Connection {
    /// How many at most.
    pub k: usize,
    /// How far away at most, in the metric of the space; infinite where only the number counts.
    pub radius: f64,
}

/// A roadmap, complete or still growing.
#[derive(Debug, Clone)]
pub struct Roadmap<S: Space> {
    pub(super) graph: Graph<S>,
    /// How many goals there are.
    goals: u32,
    nearest: Index<S>,
    connection: Connection,
    rules: SearchRules,
    pub(super) counters: Counters,
}

impl<S: Space> Roadmap<S> {
    /// A roadmap of the start and the goals alone.
    pub fn new(problem: &Problem<S>, connection: Connection, rules: SearchRules) -> Self {
        let (graph, nearest, counters) = (Graph::default(), Index::new(), Counters::default());
        let goals = problem.goals().len() as u32;
        let mut roadmap = Self { graph, goals, nearest, connection, rules, counters };
        for state in std::iter::once(problem.start()).chain(problem.goals()) {
            roadmap.add_vertex(problem.space(), 0, *state);
        }
        roadmap
    }

    /// To which vertices a vertex is joined.
    pub fn connection(&self) -> Connection {
        self.connection
    }

    /// All that has grown so far.
    pub fn graph(&self) -> &Graph<S> {
        &self.graph
    }

    pub(super) fn add_vertex(&mut self, space: &S, iteration: u32, state: S::State) -> VertexId {
        let vertex = self.graph.add_vertex(iteration, state);
        self.nearest.insert(space, vertex, state);
        vertex
    }

    /// The vertices that a state is to be joined to by motions of the given way, nearest first, and one more where `spare` is set.
    pub(super) fn neighbours(
        &mut self,
        space: &S,
        way: Way,
        state: &S::State,
        spare: bool,
        found: &mut Vec<Neighbour>,
    ) {
        self.counters.nearest_queries += 1;
        let Connection { k, radius } = self.connection;
        let k = k + usize::from(spare);
        if k >= self.nearest.len() && radius < f64::INFINITY {
            self.nearest.within_by(space, way, state, radius, found);
        } else {
            self.nearest.k_nearest_by(space, way, state, k, found);
            found.truncate(found.partition_point(|neighbour| neighbour.distance <= radius));
        }
    }

    /// Whether the motion is proven free, counted.
    pub(super) fn is_motion_free(&mut self, problem: &Problem<S>, a: &S::State, b: &S::State) -> bool {
        self.counters.motion_checks += 1;
        problem.validity().is_motion_free(a, b)
    }

    /// Joins two vertices where the motion from the one to the other is proven free; else says so.
    pub(super) fn try_edge(&mut self, problem: &Problem<S>, iteration: u32, from: VertexId, to: VertexId) {
        let (origin, target) = (*self.graph.state(from), *self.graph.state(to));
        if self.is_motion_free(problem, &origin, &target) {
            self.graph.add_edge(iteration, from, to);
        } else {
            let event =
                Event { kind: EventKind::EdgeRefused, iteration, vertex: Some(from), other: Some(to), state: target };
            self.graph.add_event(event);
        }
    }

    /// The next sample where it is free; else notes that it is not.
    pub(super) fn draw(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        sampler: &mut dyn Sampler<S>,
    ) -> Option<S::State> {
        let checks = &mut self.counters.configuration_checks;
        let Sample { state, known } = sampler.draw(problem, checks);
        let is_free = match known {
            Known::Free => true,
            Known::Useless => false,
            Known::Nothing => {
                *checks += 1;
                problem.validity().is_free(&state)
            }
        };
        if !is_free {
            self.turn_away(EventKind::SampleRejected, iteration, state);
        }
        is_free.then_some(state)
    }

    /// Notes a sample that does not become a vertex.
    pub(super) fn turn_away(&mut self, kind: EventKind, iteration: u32, state: S::State) {
        self.graph.add_event(Event { kind, iteration, vertex: None, other: None, state });
    }

    /// The vertices of the goals.
    pub(super) fn goals(&self) -> Goals {
        GOAL..VertexId(GOAL.0 + self.goals)
    }

    /// The search from the start to a goal on the roadmap as it is.
    pub(super) fn begin_search(&self, space: &S) -> Ending {
        Ending::Searching(Query::new(space, &self.graph, &[], &[], START, self.goals(), self.rules))
    }

    /// Expands one vertex of the search.
    fn search(&mut self, problem: &Problem<S>, iteration: u32, query: &mut Query) -> Expansion {
        let expansion = query.step(problem, &self.graph, &[]);
        let (kind, vertex) = match expansion {
            Expansion::Vertex(vertex) => (EventKind::VertexExpanded, vertex),
            Expansion::Goal => (EventKind::SolutionFound, query.path().last().copied().unwrap_or(GOAL)),
            Expansion::Nothing => return expansion,
        };
        self.counters.visited += 1;
        let state = *self.graph.state(vertex);
        self.graph.add_event(Event { kind, iteration, vertex: Some(vertex), other: None, state });
        expansion
    }

    /// Answers another question: joins start and goal to the roadmap, where motions are proven free, and searches it. The
    /// roadmap stays as it was unless the two are to be kept; then they are its last two vertices, born in `iteration`.
    /// O(e log e) for e edges.
    pub fn answer(&mut self, problem: &Problem<S>, ends: [S::State; 2], keep: Option<u32>) -> Answer<S::State> {
        let space = problem.space();
        let count = self.graph.states().len() as u32;
        let [start, goal] = [VertexId(count), VertexId(count + 1)];
        let (mut joined, mut found) = (Vec::new(), Vec::new());
        // Out of the start, and into the goal where that makes a difference.
        let ways = [Way::Out, if space.is_symmetric() { Way::Out } else { Way::In }];
        for ((end, vertex), way) in ends.iter().zip([start, goal]).zip(ways) {
            self.neighbours(space, way, end, false, &mut found);
            for neighbour in &found {
                let other = *self.graph.state(neighbour.vertex);
                let [from, to] = way.ends(end, &other);
                if self.is_motion_free(problem, from, to) {
                    joined.push(way.ends(vertex, neighbour.vertex));
                }
            }
        }
        if self.is_motion_free(problem, &ends[0], &ends[1]) {
            joined.push([start, goal]);
        }
        let mut query = Query::new(space, &self.graph, &joined, &ends, start, goal..VertexId(count + 2), self.rules);
        let mut visited = 0;
        let path = loop {
            match query.step(problem, &self.graph, &ends) {
                Expansion::Vertex(_) => visited += 1,
                Expansion::Nothing => break Vec::new(),
                Expansion::Goal => {
                    visited += 1;
                    break query.path().iter().map(|&v| *state(&self.graph, &ends, v)).collect();
                }
            }
        };
        self.counters.visited += visited;
        if let Some(iteration) = keep {
            for end in ends {
                self.add_vertex(space, iteration, end);
            }
            joined.into_iter().for_each(|[from, to]| self.graph.add_edge(iteration, from, to));
        }
        Answer { path, visited }
    }
}

/// The end of every roadmap planner: the search for a path, and what it came to.
pub(super) enum Ending {
    /// The search goes on.
    Searching(Query),
    /// The path from start to goal; empty where there is none.
    Done(Vec<VertexId>),
}

impl Ending {
    /// Expands one vertex, or says again what the search came to.
    pub fn step<S: Space>(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> Status {
        if let Ending::Searching(query) = self {
            match roadmap.search(problem, iteration, query) {
                Expansion::Vertex(_) => return Status::Running,
                Expansion::Goal => *self = Ending::Done(query.path()),
                Expansion::Nothing => *self = Ending::Done(Vec::new()),
            }
        }
        if self.path().is_empty() { Status::Exhausted } else { Status::Solved }
    }

    /// The path; empty while there is none.
    pub fn path(&self) -> &[VertexId] {
        if let Ending::Done(path) = self { path } else { &[] }
    }

    /// What the planner is busy with.
    pub fn phase(&self) -> Phase {
        if matches!(self, Ending::Searching(_)) { Phase::Searching } else { Phase::Done }
    }
}

/// The answer of a roadmap to a question.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer<S> {
    /// The states from start to goal; empty where the roadmap knows no way.
    pub path: Vec<S>,
    /// How many vertices the search expanded.
    pub visited: u64,
}

/// The state of a vertex of the graph, or of those numbered after them.
pub(super) fn state<'a, S: Space>(graph: &'a Graph<S>, more: &'a [S::State], vertex: VertexId) -> &'a S::State {
    let count = graph.states().len();
    if vertex.index() < count { graph.state(vertex) } else { &more[vertex.index() - count] }
}
