//! The common part of all roadmap planners: vertices with their neighbours, edges that are proven before they are added, and
//! repeated queries. In a space that is not symmetric an edge leads from its first vertex to its second only.
//!
//! The edges of a lazy roadmap are candidates until a path wants them: see `lazy.rs`.

use super::candidates::{Candidates, estimate};
use super::growth::{GOAL, Growth, START};
use super::info::{Mark, PseudocodeLine, line};
use super::neighbours::Neighbours;
use super::query::{Query, Searching, state};
use super::{Phase, Planner, Reason, Status};
use crate::graph::search::{Expansion, Goals};
use crate::graph::{EventKind, Graph, MAX_RECORDS, VertexId, append};
use crate::nearest::{self, Direction, Neighbour, Neighbourhood};
use crate::problem::{MaybeSend, Problem};
use crate::space::Space;

/// A roadmap, complete or still growing.
#[derive(Debug, Clone)]
pub struct Roadmap<S: Space> {
    pub(super) growth: Growth<S>,
    /// The vertices of the goals.
    pub(super) goals: Goals,
    nearest: Neighbours,
    /// The neighbours that a vertex is connected to if the motion is free.
    pub connection: Neighbourhood,
    pub(super) rules: Searching,
    /// The edges of a lazy roadmap; `None` if edges are proven as soon as they are wanted by the builder.
    pub(super) candidates: Option<Candidates>,
    /// The motions that were refused, of a roadmap that is not lazy.
    pub(super) refused: Vec<[VertexId; 2]>,
    /// Whether the straight motions from start to goals are edges, however many nearer neighbours there are.
    pub(super) is_direct: bool,
}

impl<S: Space> Roadmap<S> {
    /// A roadmap of the start and the goals alone.
    pub fn new(problem: &Problem<S>, connection: Neighbourhood, rules: Searching) -> Self {
        Self::with(problem, connection, rules, Neighbours::default())
    }

    /// The same with an index of its own, which is empty.
    pub(super) fn with(problem: &Problem<S>, connection: Neighbourhood, rules: Searching, nearest: Neighbours) -> Self {
        let goals = GOAL..VertexId(GOAL.0 + problem.goals().len() as u32);
        let (growth, candidates, refused) = (Growth::new(problem), None, Vec::new());
        let mut roadmap = Self { growth, goals, nearest, connection, rules, candidates, refused, is_direct: true };
        for state in std::iter::once(problem.start()).chain(problem.goals()) {
            roadmap.add_vertex(problem.space(), 0, *state);
        }
        roadmap
    }

    /// The graph so far.
    pub fn graph(&self) -> &Graph<S> {
        &self.growth.graph
    }

    /// Whether a vertex has to be checked before an edge at it is.
    pub fn is_unchecked(&self, vertex: usize) -> bool {
        self.candidates.as_ref().is_some_and(|candidates| candidates.unchecked[vertex])
    }

    /// How many vertices there are.
    pub(super) fn len(&self) -> usize {
        self.growth.graph.states().len()
    }

    pub(super) fn add_vertex(&mut self, space: &S, iteration: u32, state: S::State) -> VertexId {
        let vertex = self.growth.graph.add_vertex(iteration, state);
        self.nearest.insert(space, vertex, &state);
        if let Some(candidates) = &mut self.candidates {
            candidates.add_vertex(estimate(space, &self.growth.graph, self.rules, &self.goals, vertex));
        }
        vertex
    }

    /// The neighbours that a state is to be connected to by motions in the given direction, nearest first, and one more if
    /// `spare`.
    pub(super) fn neighbours(
        &mut self,
        space: &S,
        direction: Direction,
        state: &S::State,
        spare: bool,
        found: &mut Vec<Neighbour>,
    ) {
        self.growth.counters.nearest_queries += 1;
        let visited = self.find_neighbours(space, direction, state, spare, found);
        self.growth.note_visited(space, visited);
        self.growth.looked += found.len() as u64;
    }

    /// The same, not counted. Returns how many vertices were visited.
    pub(super) fn find_neighbours(
        &self,
        space: &S,
        direction: Direction,
        state: &S::State,
        spare: bool,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        let wanted = self.connection.with_k(self.connection.k().saturating_add(usize::from(spare)));
        let query = nearest::Query { space, states: self.growth.graph.states(), direction, from: state };
        self.nearest.find(query, wanted, found)
    }

    /// Whether no neighbour is missed.
    pub(super) fn is_exact(&self) -> bool {
        self.nearest.is_exact()
    }

    /// Connects two vertices if the motion from the one to the other is proven free; else adds an event. Returns whether it is.
    /// In a lazy roadmap the edge becomes a candidate.
    pub(super) fn try_edge(&mut self, problem: &Problem<S>, iteration: u32, from: VertexId, to: VertexId) -> bool {
        if self.candidates.is_some() {
            self.add_candidate(problem, [from, to]);
            return false;
        }
        let (origin, target) = (self.growth.state(from), self.growth.state(to));
        let is_free = self.growth.is_motion_free(problem, &origin, &target);
        self.add_tried(iteration, from, to, is_free);
        is_free
    }

    /// Adds a vertex to a roadmap that is not lazy, and connects it to its neighbours by motions that are proven free. O(k)
    /// motions.
    pub fn extend(&mut self, problem: &Problem<S>, iteration: u32, state: S::State) {
        let (mut all, mut found) = (Vec::new(), Vec::new());
        for &direction in Direction::all(problem.space()) {
            self.neighbours(problem.space(), direction, &state, false, &mut found);
            all.extend(found.iter().map(|neighbour| (direction, neighbour.vertex)));
        }
        let vertex = self.add_vertex(problem.space(), iteration, state);
        for (direction, other) in all {
            let [from, to] = direction.ends(vertex, other);
            self.try_edge(problem, iteration, from, to);
        }
    }

    /// Connects two vertices of a roadmap that is not lazy if the motion from the one to the other is proven free.
    pub fn join(&mut self, problem: &Problem<S>, iteration: u32, from: VertexId, to: VertexId) {
        self.try_edge(problem, iteration, from, to);
    }

    /// Adds the edge from the one vertex to the other if that motion is free, else the event that it is not.
    pub(super) fn add_tried(&mut self, iteration: u32, from: VertexId, to: VertexId, is_free: bool) {
        if is_free {
            self.growth.graph.add_edge(iteration, from, to);
            return;
        }
        let target = self.growth.state(to);
        self.growth.add_event(EventKind::EdgeRefused, iteration, Some(from), Some(to), target);
        if self.candidates.is_none() {
            append(&mut self.refused, [from, to]);
        }
    }

    /// Tries the straight motions from the start to the goals that were not tried yet, as wanted. O(edges).
    pub(super) fn connect_ends(&mut self, problem: &Problem<S>, iteration: u32) {
        if !self.is_direct {
            return;
        }
        for goal in self.goals.start.0..self.goals.end.0 {
            let ends = [START, VertexId(goal)];
            let is_same = |[from, to]: &[VertexId; 2]| {
                [*from, *to] == ends || (problem.space().is_symmetric() && [*to, *from] == ends)
            };
            if !self.growth.graph.edges().iter().chain(&self.refused).any(is_same) {
                self.try_edge(problem, iteration, START, VertexId(goal));
            }
        }
    }

    /// The search from the start to a goal on the roadmap as it is.
    fn begin_search(&self, space: &S) -> Query {
        Query::new(space, &self.growth.graph, &[], &[], START, self.goals.clone(), self.rules)
    }

    /// Queries the roadmap again: connects start and goal to the roadmap by motions that are proven free, and searches it. The
    /// roadmap is unchanged unless `added_in` is an iteration; then the two become its last vertices, created in it.
    /// O(e log e) for e edges.
    pub fn query(&mut self, problem: &Problem<S>, ends: [S::State; 2], added_in: Option<u32>) -> QueryResult<S::State> {
        if self.candidates.is_some() {
            return self.query_lazily(problem, ends, added_in);
        }
        let space = problem.space();
        let count = self.len() as u32;
        let [start, goal] = [VertexId(count), VertexId(count + 1)];
        let (mut added, mut found) = (Vec::new(), Vec::new());
        // Out of the start, and into the goal if that makes a difference.
        let directions = [Direction::Out, if space.is_symmetric() { Direction::Out } else { Direction::In }];
        for ((end, vertex), direction) in ends.iter().zip([start, goal]).zip(directions) {
            self.neighbours(space, direction, end, false, &mut found);
            for neighbour in &found {
                let other = self.growth.state(neighbour.vertex);
                let [from, to] = direction.ends(end, &other);
                if self.growth.is_motion_free(problem, from, to) {
                    added.push(direction.ends(vertex, neighbour.vertex));
                }
            }
        }
        if self.growth.is_motion_free(problem, &ends[0], &ends[1]) {
            added.push([start, goal]);
        }
        let mut query =
            Query::new(space, &self.growth.graph, &added, &ends, start, goal..VertexId(count + 2), self.rules);
        let (mut visited, mut is_exhaustive) = (0, true);
        let path = loop {
            match query.step(problem, &self.growth.graph, &ends) {
                Expansion::Vertex(_) => visited += 1,
                Expansion::Nothing => {
                    is_exhaustive = query.is_exhaustive();
                    break Vec::new();
                }
                Expansion::Goal => {
                    visited += 1;
                    break query.path().iter().map(|&v| *state(&self.growth.graph, &ends, v)).collect();
                }
            }
        };
        self.growth.counters.visited += visited;
        self.growth.counters.reopened += query.reopened();
        if let Some(iteration) = added_in {
            for end in ends {
                self.add_vertex(space, iteration, end);
            }
            added.into_iter().for_each(|[from, to]| self.growth.graph.add_edge(iteration, from, to));
        }
        QueryResult { path, visited, is_exhaustive }
    }
}

/// How a roadmap grows: the difference between the planners that build one.
pub(super) trait Build<S: Space>: MaybeSend {
    /// Does one iteration; returns whether the roadmap is complete.
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool;

    /// Begins to add as many vertices again to a complete roadmap that does not connect start and goal; returns whether it does.
    /// The default is that it has as many as were asked for.
    fn grow(&mut self, roadmap: &mut Roadmap<S>, dimension: usize) -> bool {
        let _ = (roadmap, dimension);
        false
    }

    /// The present phase.
    fn phase(&self, roadmap: &Roadmap<S>) -> Phase;

    /// The estimated share of the free space that the roadmap covers, if it is estimated.
    fn coverage(&self) -> Option<f64> {
        None
    }
}

/// A planner that builds a roadmap and then searches it. An iteration is one of the builder, or expands one vertex.
pub(super) struct RoadmapPlanner<S: Space, B> {
    roadmap: Roadmap<S>,
    builder: B,
    /// The search, while it is running.
    search: Option<Query>,
    /// The path from start to goal, once the search is over; empty if there is none.
    path: Option<Vec<VertexId>>,
    /// Whether there is no path if the last search has found none.
    is_exhaustive: bool,
}

impl<S: Space, B: Build<S>> RoadmapPlanner<S, B> {
    /// A planner that continues with a roadmap; if it is complete, it is only searched.
    pub fn new(problem: &Problem<S>, roadmap: Roadmap<S>, builder: B, is_complete: bool) -> Self {
        let search = is_complete.then(|| roadmap.begin_search(problem.space()));
        Self { roadmap, builder, search, path: None, is_exhaustive: true }
    }
}

impl<S: Space, B: Build<S>> Planner<S> for RoadmapPlanner<S, B> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        let Some(search) = &mut self.search else {
            if self.builder.build(&mut self.roadmap, problem, iteration) {
                self.roadmap.connect_ends(problem, iteration);
                self.search = Some(self.roadmap.begin_search(problem.space()));
            }
            return Status::Running;
        };
        let growth = &mut self.roadmap.growth;
        let (kind, vertex, status) = match search.step(problem, &growth.graph, &[]) {
            Expansion::Vertex(vertex) => (EventKind::VertexExpanded, vertex, Status::Running),
            Expansion::Goal => {
                growth.counters.reopened += search.reopened();
                let path = self.path.insert(search.path());
                (EventKind::SolutionFound, path.last().copied().unwrap_or(GOAL), Status::Solved)
            }
            Expansion::Nothing => {
                self.is_exhaustive = search.is_exhaustive();
                growth.counters.reopened += search.reopened();
                self.search = None;
                if self.builder.grow(&mut self.roadmap, problem.space().dimension()) {
                    return Status::Running;
                }
                self.path = Some(Vec::new());
                return Status::Exhausted;
            }
        };
        growth.counters.visited += 1;
        growth.add_event(kind, iteration, Some(vertex), None, growth.state(vertex));
        if status == Status::Solved {
            self.search = None;
        }
        status
    }

    fn phase(&self) -> Phase {
        match (&self.path, &self.search) {
            (Some(_), _) => Phase::Done,
            (None, Some(_)) => Phase::Searching,
            (None, None) => self.builder.phase(&self.roadmap),
        }
    }

    fn growth(&self) -> &Growth<S> {
        &self.roadmap.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.roadmap.growth
    }

    fn is_full(&self) -> bool {
        self.graph().is_full() || self.roadmap.refused.len() >= MAX_RECORDS
    }

    fn path(&self) -> Vec<VertexId> {
        self.path.clone().unwrap_or_default()
    }

    fn reason(&self) -> Reason {
        if self.is_exhaustive { Reason::NotConnected } else { Reason::SearchFailed }
    }

    fn coverage(&self) -> Option<f64> {
        self.builder.coverage()
    }

    fn roadmap(&self) -> Option<&Roadmap<S>> {
        Some(&self.roadmap)
    }

    fn roadmap_mut(&mut self) -> Option<&mut Roadmap<S>> {
        Some(&mut self.roadmap)
    }
}

/// The result of a query of a roadmap.
#[derive(Debug, Clone, PartialEq)]
pub struct QueryResult<S> {
    /// The states from start to goal; empty if the roadmap has no path.
    pub path: Vec<S>,
    /// How many vertices the search expanded.
    pub visited: u64,
    /// Whether the roadmap has no path if none was found; a faulty search may miss one.
    pub is_exhaustive: bool,
}

// Lines of pseudo-code that roadmap planners share.

pub(super) const BEGIN: PseudocodeLine = line(0, "G ← {start, goal}; until it has n samples:", &[]);
pub(super) const SAMPLE: PseudocodeLine = line(1, "q ← a random configuration", &[Mark::Sampling]);
pub(super) const KEEP: PseudocodeLine = line(1, "add q to G", &[Mark::Vertex]);
pub(super) const JOIN: PseudocodeLine = line(1, "if the motion q – p is free: add that edge", &[Mark::Edge]);
pub(super) const REFUSE: PseudocodeLine = line(1, "else: reject it", &[Mark::Refused]);
pub(super) const SEARCH: PseudocodeLine = line(0, "search G from start to goal:", &[Mark::Searching]);
pub(super) const EXPAND: PseudocodeLine = line(1, "expand the next open vertex", &[Mark::Expanded, Mark::Solved]);
