//! Lifelong planning A*: a best-first search that goes on where it was when edges come and go, instead of beginning again.
//!
//! Koenig, Likhachev and Furcy 2004, "Lifelong planning A*". Edges are assumed to be there until they are refused, as in Dellin
//! and Srinivasa 2016, "A unifying formalism for shortest path problems with expensive edge evaluations via lazy best-first
//! search over paths with edge selectors": the caller tries the assumed edges of the best path, one after the other.

use super::{Expansion, Goals};
use crate::graph::{Ordered, VertexId, append};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What is known about an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeState {
    /// Nothing: the search assumes that it is there.
    Assumed,
    /// It is there.
    Proven,
    /// It is not.
    Refused,
}

/// An edge, in both directions unless the search is directed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Its ends, in the order in which it was added.
    pub ends: [VertexId; 2],
    /// Its cost, at least 0.
    pub cost: f64,
    /// What is known about it.
    pub state: EdgeState,
}

/// The cost of a path: its length, then the number of its edges, so that no edge is for nothing.
type Cost = (f64, u32);

/// The cost of what cannot be reached.
const UNREACHED: Cost = (f64::INFINITY, u32::MAX);

/// A path is the best if every other one is estimated to be longer than this many times its length: estimates are rounded.
const LONGER: f64 = 1.0 + 1e-9;

/// The end of a list of edges.
const NONE: u32 = u32::MAX;

/// A vertex as the search knows it.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// The cost of the path to it when it was last expanded: g.
    cost: Cost,
    /// The least cost through a vertex before it: rhs. The vertex waits to be expanded while the two differ.
    ahead: Cost,
    /// An estimate of the cost from it to the goal, which no edge lowers by more than its own cost.
    estimate: f64,
    /// The first of the half edges that lead out of it, and of those that lead into it; one list if edges have no direction.
    first: [u32; 2],
}

/// An entry of the frontier, smallest first: estimate of the whole path, cost, vertex.
type Key = (Ordered, Ordered, u32, VertexId);

/// The search from one vertex to the cheapest of the goals. Half edge 2 e + i of edge e leads from its end i to the other.
#[derive(Debug, Clone)]
pub struct Lifelong {
    is_directed: bool,
    start: VertexId,
    goals: Goals,
    nodes: Vec<Node>,
    edges: Vec<Edge>,
    /// For every half edge the next one in the list of its vertex.
    next: Vec<u32>,
    frontier: BinaryHeap<Reverse<Key>>,
    /// The edges of the best path, from the start on, and its vertices.
    path: (Vec<u32>, Vec<VertexId>),
    /// How many half edges were looked at.
    looked: u64,
}

/// A cost and an edge more.
fn plus((length, edges): Cost, cost: f64) -> Cost {
    (length + cost, edges.saturating_add(1))
}

impl Lifelong {
    /// A search without vertices.
    pub fn new(is_directed: bool, start: VertexId, goals: Goals) -> Self {
        let (nodes, edges, next) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            is_directed,
            start,
            goals,
            nodes,
            edges,
            next,
            frontier: BinaryHeap::new(),
            path: Default::default(),
            looked: 0,
        }
    }

    /// Starts a search between other vertices, with other estimates. O(v).
    pub fn restart(&mut self, start: VertexId, goals: Goals, estimate: impl Fn(VertexId) -> f64) {
        (self.start, self.goals, self.path) = (start, goals, Default::default());
        self.frontier.clear();
        for (vertex, node) in (0..).map(VertexId).zip(&mut self.nodes) {
            (node.cost, node.ahead, node.estimate) = (UNREACHED, UNREACHED, estimate(vertex));
        }
        self.offer(start, (0.0, 0));
    }

    /// Adds the next vertex.
    pub fn add_vertex(&mut self, estimate: f64) {
        let vertex = VertexId(self.nodes.len() as u32);
        append(&mut self.nodes, Node { cost: UNREACHED, ahead: UNREACHED, estimate, first: [NONE; 2] });
        if vertex == self.start {
            self.offer(vertex, (0.0, 0));
        }
    }

    /// Adds an edge.
    pub fn add_edge(&mut self, edge: Edge) {
        let number = self.edges.len() as u32;
        append(&mut self.edges, edge);
        for (i, end) in edge.ends.into_iter().enumerate() {
            let list = self.list(i);
            let first = &mut self.nodes[end.index()].first[list];
            append(&mut self.next, std::mem::replace(first, 2 * number + i as u32));
        }
        if edge.state != EdgeState::Refused {
            self.directions().for_each(|i| self.offer_along(2 * number + i));
        }
    }

    /// How many edges the search has looked at so far: a measure of its work.
    pub fn looked(&self) -> u64 {
        self.looked
    }

    /// All edges, in the order in which they were added.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The edges at a vertex.
    pub fn edges_at(&self, vertex: VertexId) -> impl Iterator<Item = u32> {
        let lists = if self.is_directed { 0..2 } else { 0..1 };
        lists.flat_map(move |list| self.half_edges(vertex, list)).map(|half| half / 2)
    }

    /// Notes that an assumed edge is proven, and by how much it costs more than was assumed, 0 or more; `None` refuses it.
    pub fn settle(&mut self, edge: u32, surcharge: Option<f64>) {
        if surcharge == Some(0.0) {
            self.edges[edge as usize].state = EdgeState::Proven;
            return;
        }
        let costs: Vec<Cost> = self.directions().map(|i| self.cost_along(2 * edge + i)).collect();
        let Edge { state, cost, .. } = &mut self.edges[edge as usize];
        *state = if surcharge.is_some() { EdgeState::Proven } else { EdgeState::Refused };
        *cost += surcharge.unwrap_or(0.0);
        for (i, cost) in self.directions().zip(costs) {
            self.withdraw(self.end(2 * edge + i), cost);
        }
    }

    /// Expands one vertex, or returns that the best path is known, or that there is none. After either, edges may be added and
    /// settled, and the search goes on.
    pub fn step(&mut self) -> Expansion {
        let next = loop {
            match self.frontier.peek() {
                Some(&Reverse(key)) if self.key(key.3) != Some(key) => drop(self.frontier.pop()),
                next => break next.map(|&Reverse(key)| key),
            }
        };
        if self.is_over(next) && self.find_path() {
            return Expansion::Goal;
        }
        let Some((.., vertex)) = next else { return Expansion::Nothing };
        self.frontier.pop();
        let Node { cost, ahead, .. } = &mut self.nodes[vertex.index()];
        // A vertex that has lost its path is out of reach at first, with all that is reached through it.
        let former = std::mem::replace(cost, if *ahead < *cost { *ahead } else { UNREACHED });
        let mut next = self.half_edges(vertex, 0).next();
        while let Some(half) = next {
            self.looked += 1;
            self.withdraw(self.end(half), plus(former, self.edges[half as usize / 2].cost));
            self.offer_along(half);
            next = self.half_edges_from(self.next[half as usize]).next();
        }
        self.wait(vertex);
        Expansion::Vertex(vertex)
    }

    /// The vertices of the best path, once a step has returned `Goal`.
    pub fn path(&self) -> &[VertexId] {
        &self.path.1
    }

    /// The length of the shortest path, once a step has returned `Goal` or `Nothing`; infinite if there is none.
    pub fn cost(&self) -> f64 {
        self.nodes[self.goal().index()].ahead.0
    }

    /// The first edge of that path that is assumed; `None` if all are proven.
    pub fn first_assumed(&self) -> Option<u32> {
        self.path.0.iter().copied().find(|&edge| self.edges[edge as usize].state == EdgeState::Assumed)
    }

    /// The directions in which an edge leads: its half edges out of a vertex.
    fn directions(&self) -> std::ops::Range<u32> {
        if self.is_directed { 0..1 } else { 0..2 }
    }

    /// The list of a vertex that half edge i of an edge is in: out of it, or into it if that is another one.
    fn list(&self, i: usize) -> usize {
        if self.is_directed { i } else { 0 }
    }

    /// The vertex that a half edge leads to.
    fn end(&self, half: u32) -> VertexId {
        self.edges[half as usize / 2].ends[1 - half as usize % 2]
    }

    /// The half edges of a list of a vertex whose edges are not refused.
    fn half_edges(&self, vertex: VertexId, list: usize) -> impl Iterator<Item = u32> {
        self.half_edges_from(self.nodes[vertex.index()].first[list])
    }

    /// Those of the rest of a list, from this half edge on.
    fn half_edges_from(&self, first: u32) -> impl Iterator<Item = u32> {
        let next = |half: u32| (half != NONE).then_some(half);
        let all = std::iter::successors(next(first), move |&half| next(self.next[half as usize]));
        all.filter(|&half| self.edges[half as usize / 2].state != EdgeState::Refused)
    }

    /// The cost of the path that leads along a half edge.
    fn cost_along(&self, half: u32) -> Cost {
        let Edge { ends, cost, .. } = self.edges[half as usize / 2];
        plus(self.nodes[ends[half as usize % 2].index()].cost, cost)
    }

    /// Offers the path along a half edge to the vertex that it leads to.
    fn offer_along(&mut self, half: u32) {
        self.offer(self.end(half), self.cost_along(half));
    }

    fn offer(&mut self, vertex: VertexId, cost: Cost) {
        if cost < self.nodes[vertex.index()].ahead {
            self.nodes[vertex.index()].ahead = cost;
            self.wait(vertex);
        }
    }

    /// Withdraws a path of this cost from a vertex, which may have another.
    fn withdraw(&mut self, vertex: VertexId, cost: Cost) {
        if vertex == self.start || cost != self.nodes[vertex.index()].ahead || cost >= UNREACHED {
            return;
        }
        let (before, looked) = self.before(vertex);
        self.looked += looked;
        self.nodes[vertex.index()].ahead = before.map_or(UNREACHED, |(cost, ..)| cost);
        self.wait(vertex);
    }

    /// The cheapest way to a vertex: its cost, the vertex before, the edge; and how many edges lead to it. Ties go to the lower
    /// vertex.
    fn before(&self, vertex: VertexId) -> (Option<(Cost, VertexId, u32)>, u64) {
        let mut looked = 0;
        let into = self.half_edges(vertex, self.list(1)).map(|half| {
            looked += 1;
            // The same edge in the direction towards the vertex.
            let back = half ^ 1;
            (self.cost_along(back), self.end(half), half / 2)
        });
        let reached = into.filter(|(cost, ..)| cost.0 < f64::INFINITY);
        (reached.min_by(|a, b| a.partial_cmp(b).expect("costs are numbers")), looked)
    }

    /// The key of a vertex that waits to be expanded; `None` if it does not.
    fn key(&self, vertex: VertexId) -> Option<Key> {
        let Node { cost, ahead, estimate, .. } = self.nodes[vertex.index()];
        let (length, edges) = if ahead < cost { ahead } else { cost };
        (cost != ahead).then(|| (Ordered::new(length + estimate), Ordered::new(length), edges, vertex))
    }

    /// Puts a vertex into the frontier, if it waits to be expanded.
    fn wait(&mut self, vertex: VertexId) {
        self.frontier.extend(self.key(vertex).map(Reverse));
    }

    /// The goal that is reached most cheaply.
    fn goal(&self) -> VertexId {
        let goals = (self.goals.start.0..self.goals.end.0).map(VertexId);
        let cost = |goal: &VertexId| self.nodes[goal.index()].ahead.0;
        goals.min_by(|a, b| cost(a).total_cmp(&cost(b))).expect("a search has a goal")
    }

    /// Whether nothing in the frontier, of which this is the next, can lead to a shorter path.
    fn is_over(&self, next: Option<Key>) -> bool {
        let length = self.cost();
        length < f64::INFINITY && next.is_none_or(|(estimate, ..)| estimate.value() > LONGER * length)
    }

    /// Finds the path to the goal; false if a vertex on it still waits to be expanded.
    fn find_path(&mut self) -> bool {
        let mut vertex = self.goal();
        let (mut edges, mut vertices) = (Vec::new(), vec![vertex]);
        // Every cost is that of the vertex before it and an edge more: they fall.
        while self.key(vertex).is_none() {
            let (way, looked) = if vertex == self.start { (None, 0) } else { self.before(vertex) };
            self.looked += looked;
            let Some((_, before, edge)) = way else {
                edges.reverse();
                vertices.reverse();
                self.path = (edges, vertices);
                return true;
            };
            edges.push(edge);
            vertices.push(before);
            vertex = before;
        }
        false
    }
}
