//! Lazy roadmaps: edges are candidates, which are proven when the best path wants them, and not before.
//!
//! Bohlin and Kavraki 2000, "Path planning using lazy PRM"; Hauser 2015, "Lazy collision checking in asymptotically-optimal
//! motion planning". The search goes on where it was when a candidate is refused (`graph/search/lifelong.rs`).

use super::candidates::{Candidates, counts_edges, estimate};
use super::growth::{GOAL, Growth, START};
use super::roadmap::{Build, QueryResult, Roadmap};
use super::{Phase, Planner, Status};
use crate::graph::search::{Edge, EdgeState, Expansion, Lifelong};
use crate::graph::{EventKind, MAX_RECORDS, VertexId};
use crate::nearest::Direction;
use crate::problem::Problem;
use crate::space::Space;

/// One step of the search of a lazy roadmap.
enum Step {
    /// It expanded this vertex.
    Expanded(VertexId),
    /// It tried an edge of the best path.
    Tried,
    /// All edges of the best path are proven.
    Solved,
    /// There is no path.
    Nothing,
}

impl<S: Space> Roadmap<S> {
    /// The same roadmap, which has no edges yet, as a lazy one.
    #[must_use]
    pub(super) fn lazily(mut self, space: &S) -> Self {
        let search = Lifelong::new(!space.is_symmetric(), START, self.goals.clone());
        let mut candidates = Candidates { search, unchecked: Vec::new() };
        for vertex in (0..self.len() as u32).map(VertexId) {
            candidates.add_vertex(estimate(space, &self.growth.graph, self.rules, &self.goals, vertex));
        }
        self.candidates = Some(candidates);
        self
    }

    fn candidates_mut(&mut self) -> &mut Candidates {
        self.candidates.as_mut().expect("the roadmap is lazy")
    }

    /// The cost of the best path of a lazy roadmap that was searched; infinite if it has none.
    pub(super) fn best_cost(&self) -> f64 {
        self.candidates.as_ref().map_or(f64::INFINITY, |candidates| candidates.search.cost())
    }

    /// What an edge costs if it is free.
    pub(super) fn cost(&self, problem: &Problem<S>, [from, to]: [VertexId; 2]) -> f64 {
        let [a, b] = [from, to].map(|end| self.growth.graph.state(end));
        if counts_edges(self.rules) { 1.0 } else { problem.cost(a, b) }
    }

    /// Adds an edge of a lazy roadmap; one that is proven is an edge of the graph.
    pub(super) fn add_edge(&mut self, edge: Edge) {
        self.growth.counters.unchecked_edges += u64::from(edge.state == EdgeState::Assumed);
        if edge.state == EdgeState::Proven {
            self.growth.graph.add_edge(0, edge.ends[0], edge.ends[1]);
        }
        self.candidates_mut().search.add_edge(edge);
    }

    /// Adds a candidate, unless there is that edge.
    pub(super) fn add_candidate(&mut self, problem: &Problem<S>, ends: [VertexId; 2]) {
        let space = problem.space();
        let search = &self.candidates_mut().search;
        let is_same = |edge: u32| {
            let [from, to] = search.edges()[edge as usize].ends;
            [from, to] == ends || (space.is_symmetric() && [to, from] == ends)
        };
        let mut looked = 1;
        let is_there = search.edges_at(ends[0]).inspect(|_| looked += 1).any(is_same);
        self.growth.looked += looked;
        if !is_there {
            self.add_edge(Edge { ends, cost: self.cost(problem, ends), state: EdgeState::Assumed });
        }
    }

    /// Settles a candidate: a free one with its surcharge.
    fn settle(&mut self, iteration: u32, edge: u32, surcharge: Option<f64>) {
        let candidates = self.candidates_mut();
        let [from, to] = candidates.search.edges()[edge as usize].ends;
        candidates.search.settle(edge, surcharge);
        self.growth.counters.unchecked_edges -= 1;
        self.add_tried(iteration, from, to, surcharge.is_some());
    }

    /// Tries a candidate. If one of its ends is in collision, all candidates at it are refused.
    fn try_candidate(&mut self, problem: &Problem<S>, iteration: u32, edge: u32) {
        let ends = self.candidates_mut().search.edges()[edge as usize].ends;
        let states = ends.map(|end| self.growth.state(end));
        for (end, state) in ends.into_iter().zip(&states) {
            if !self.candidates_mut().unchecked[end.index()] {
                continue;
            }
            self.growth.counters.configuration_checks += 1;
            if !problem.validity().is_free(state) {
                let search = &self.candidates_mut().search;
                let is_open = |edge: &u32| search.edges()[*edge as usize].state == EdgeState::Assumed;
                let open: Vec<u32> = search.edges_at(end).filter(is_open).collect();
                return open.into_iter().for_each(|edge| self.settle(iteration, edge, None));
            }
            self.candidates_mut().unchecked[end.index()] = false;
        }
        let is_free = self.growth.is_motion_free(problem, &states[0], &states[1]);
        let surcharge = is_free.then(|| problem.validity().surcharge(&states[0], &states[1]));
        self.settle(iteration, edge, surcharge);
    }

    /// Expands a vertex, or tries an edge of the best path.
    fn step(&mut self, problem: &Problem<S>, iteration: u32) -> Step {
        let search = &mut self.candidates_mut().search;
        let before = search.looked();
        let expansion = search.step();
        let looked = search.looked() - before;
        self.growth.looked += looked;
        let search = &mut self.candidates_mut().search;
        match expansion {
            Expansion::Vertex(vertex) => {
                self.growth.counters.visited += 1;
                Step::Expanded(vertex)
            }
            Expansion::Nothing => Step::Nothing,
            Expansion::Goal => match search.first_assumed() {
                Some(edge) => {
                    self.try_candidate(problem, iteration, edge);
                    Step::Tried
                }
                None => Step::Solved,
            },
        }
    }

    /// Queries a lazy roadmap: see [`Roadmap::query`]. Edges are proven in a copy of the roadmap, which replaces it if it is to
    /// be kept.
    pub(super) fn query_lazily(
        &mut self,
        problem: &Problem<S>,
        ends: [S::State; 2],
        added_in: Option<u32>,
    ) -> QueryResult<S::State> {
        let (space, iteration) = (problem.space(), added_in.unwrap_or_default());
        let mut roadmap = self.clone();
        let records_events = std::mem::take(&mut roadmap.growth.records_events);
        let [start, goal] = [0, 1].map(|i| VertexId((self.len() + i) as u32));
        let mut edges = vec![[start, goal]];
        let directions = [Direction::Out, if space.is_symmetric() { Direction::Out } else { Direction::In }];
        let mut found = Vec::new();
        for ((end, vertex), direction) in ends.iter().zip([start, goal]).zip(directions) {
            roadmap.neighbours(space, direction, end, false, &mut found);
            edges.extend(found.iter().map(|neighbour| direction.ends(vertex, neighbour.vertex)));
        }
        for end in ends {
            roadmap.add_vertex(space, iteration, end);
        }
        edges.into_iter().for_each(|ends| roadmap.add_candidate(problem, ends));
        let goals = goal..VertexId(goal.0 + 1);
        let (graph, rules) = (&roadmap.growth.graph, roadmap.rules);
        let estimate = |vertex| estimate(space, graph, rules, &goals, vertex);
        let candidates = roadmap.candidates.as_mut().expect("the roadmap is lazy");
        candidates.search.restart(start, goals.clone(), estimate);
        let before = self.growth.counters.visited;
        let path = loop {
            match roadmap.step(problem, iteration) {
                Step::Expanded(_) | Step::Tried => {}
                Step::Nothing => break Vec::new(),
                Step::Solved => {
                    roadmap.growth.counters.visited += 1;
                    let path = roadmap.candidates_mut().search.path().to_vec();
                    break path.into_iter().map(|vertex| roadmap.growth.state(vertex)).collect();
                }
            }
        };
        let visited = roadmap.growth.counters.visited - before;
        roadmap.growth.records_events = records_events;
        let unchecked_edges = self.growth.counters.unchecked_edges;
        self.growth.counters = roadmap.growth.counters;
        if added_in.is_some() {
            *self = roadmap;
        } else {
            self.growth.counters.unchecked_edges = unchecked_edges;
        }
        QueryResult { path, visited, is_exhaustive: true }
    }
}

/// The best path so far.
struct Best {
    path: Vec<VertexId>,
    cost: f64,
}

/// A planner that builds a lazy roadmap and searches it. An iteration is one of the builder, expands one vertex, or tries one
/// edge.
pub(super) struct LazyPlanner<S: Space> {
    roadmap: Roadmap<S>,
    builder: Box<dyn Build<S>>,
    /// Whether the roadmap is to be searched as it is; else the builder goes on.
    is_searching: bool,
    /// Whether the builder goes on after each search; else the first one decides.
    improves: bool,
    best: Option<Best>,
    status: Status,
}

impl<S: Space> LazyPlanner<S> {
    /// A planner of a lazy roadmap; if it is complete, it is only searched.
    pub fn new(roadmap: Roadmap<S>, builder: Box<dyn Build<S>>, is_complete: bool, improves: bool) -> Self {
        let (is_searching, best, status) = (is_complete, None, Status::Running);
        Self { roadmap, builder, is_searching, improves, best, status }
    }

    /// Does one step of the search; returns whether there was something to do.
    fn search(&mut self, problem: &Problem<S>, iteration: u32) -> bool {
        let step = self.roadmap.step(problem, iteration);
        let Roadmap { growth, candidates, .. } = &mut self.roadmap;
        match step {
            Step::Tried => {}
            Step::Expanded(vertex) => {
                growth.add_event(EventKind::VertexExpanded, iteration, Some(vertex), None, growth.state(vertex));
            }
            Step::Solved => {
                let search = &candidates.as_ref().expect("the roadmap is lazy").search;
                let cost = search.cost();
                if self.best.as_ref().is_some_and(|best| best.cost <= cost) {
                    return false;
                }
                let path = search.path().to_vec();
                let goal = path.last().copied().unwrap_or(GOAL);
                growth.counters.visited += 1;
                growth.add_event(EventKind::SolutionFound, iteration, Some(goal), None, growth.state(goal));
                self.best = Some(Best { path, cost });
                if !self.improves {
                    self.status = Status::Solved;
                }
            }
            Step::Nothing => {
                if !self.improves && !self.builder.grow(&mut self.roadmap, problem.space().dimension()) {
                    self.status = Status::Exhausted;
                }
                return self.status == Status::Exhausted;
            }
        }
        true
    }
}

impl<S: Space> Planner<S> for LazyPlanner<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if !(self.is_searching && self.search(problem, iteration)) {
            self.is_searching = self.builder.build(&mut self.roadmap, problem, iteration);
            if self.is_searching && !self.improves {
                self.roadmap.connect_ends(problem, iteration);
            }
        }
        self.status
    }

    fn phase(&self) -> Phase {
        match &self.best {
            _ if self.status != Status::Running => Phase::Done,
            Some(_) => Phase::Improving,
            None if self.is_searching => Phase::Searching,
            None => self.builder.phase(&self.roadmap),
        }
    }

    fn growth(&self) -> &Growth<S> {
        &self.roadmap.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.roadmap.growth
    }

    fn is_full(&self) -> bool {
        let candidates = self.roadmap.candidates.as_ref().map_or(0, |candidates| candidates.search.edges().len());
        self.graph().is_full() || candidates >= MAX_RECORDS
    }

    fn cost(&self) -> f64 {
        self.best.as_ref().filter(|_| self.improves).map_or(f64::INFINITY, |best| best.cost)
    }

    fn path(&self) -> Vec<VertexId> {
        self.best.as_ref().map_or(Vec::new(), |best| best.path.clone())
    }

    fn roadmap(&self) -> Option<&Roadmap<S>> {
        Some(&self.roadmap)
    }

    fn roadmap_mut(&mut self) -> Option<&mut Roadmap<S>> {
        Some(&mut self.roadmap)
    }
}
