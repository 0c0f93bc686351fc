//! A* (Hart, Nilsson and Raphael 1968, "A formal basis for the heuristic determination of minimum cost paths").

use crate::graph::{Adjacency, VertexId};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// What one step of the search did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expansion {
    /// The vertex was expanded; the search goes on.
    Vertex(VertexId),
    /// The goal came out of the frontier: its path is the cheapest.
    Goal,
    /// The frontier is empty: the goal cannot be reached.
    Nothing,
}

/// A* from one vertex to another. A vertex is expanded again where a cheaper way to it turns up, so the path found is the
/// cheapest for every admissible heuristic, consistent or not. O((v + e) log e) for a consistent one.
#[derive(Debug, Clone)]
pub struct AStar {
    goal: VertexId,
    cost: Vec<f64>,
    parent: Vec<Option<VertexId>>,
    frontier: BinaryHeap<Open>,
}

/// An entry of the frontier: a vertex as it was reached at one cost.
#[derive(Debug, Clone, Copy)]
struct Open {
    estimate: f64,
    cost: f64,
    vertex: VertexId,
}

impl AStar {
    /// A search among `vertices` vertices from `start` to `goal`; `estimate` is the heuristic at the start.
    pub fn new(vertices: usize, start: VertexId, goal: VertexId, estimate: f64) -> Self {
        let mut cost = vec![f64::INFINITY; vertices];
        cost[start.index()] = 0.0;
        let frontier = BinaryHeap::from([Open { estimate, cost: 0.0, vertex: start }]);
        Self { goal, cost, parent: vec![None; vertices], frontier }
    }

    /// Takes the most promising vertex from the frontier and expands it. `weight` is the cost of an edge, at least 0;
    /// `heuristic` never exceeds the true cost from a vertex to the goal.
    pub fn step(
        &mut self,
        adjacency: &Adjacency,
        weight: impl Fn(VertexId, VertexId) -> f64,
        heuristic: impl Fn(VertexId) -> f64,
    ) -> Expansion {
        let open = loop {
            match self.frontier.pop() {
                None => return Expansion::Nothing,
                // Entries that a cheaper way has overtaken are passed over.
                Some(open) if open.cost > self.cost[open.vertex.index()] => {}
                Some(open) => break open,
            }
        };
        if open.vertex == self.goal {
            return Expansion::Goal;
        }
        for &next in adjacency.neighbours(open.vertex) {
            let cost = open.cost + weight(open.vertex, next);
            if cost < self.cost[next.index()] {
                self.cost[next.index()] = cost;
                self.parent[next.index()] = Some(open.vertex);
                self.frontier.push(Open { estimate: cost + heuristic(next), cost, vertex: next });
            }
        }
        Expansion::Vertex(open.vertex)
    }

    /// The cost of the cheapest way to the vertex found so far; infinite where it was not reached.
    pub fn cost(&self, vertex: VertexId) -> f64 {
        self.cost[vertex.index()]
    }

    /// The way to the goal from the start, both included, once the goal was reached.
    pub fn path(&self) -> Vec<VertexId> {
        let mut path = vec![self.goal];
        while let Some(parent) = self.parent[path[path.len() - 1].index()] {
            path.push(parent);
        }
        path.reverse();
        path
    }
}

// The heap's largest entry is the one to take first: the smallest estimate, then the larger cost (nearer to the goal),
// then the lower vertex number.
impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_estimate = other.estimate.total_cmp(&self.estimate);
        by_estimate.then(self.cost.total_cmp(&other.cost)).then(other.vertex.cmp(&self.vertex))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Open {}
