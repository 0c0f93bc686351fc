//! Best-first searches: A* (Hart, Nilsson and Raphael 1968, "A formal basis for the heuristic determination of minimum cost
//! paths"), and Dijkstra's, which is A* with the heuristic 0 (Dijkstra 1959, "A note on two problems in connexion with graphs").

use super::{Expansion, Goals, UNREACHED, View, Walker, to_root};
use crate::graph::VertexId;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A* from one vertex to the cheapest of others. A vertex is expanded again where a cheaper way to it turns up, so the path found is the
/// cheapest for every admissible heuristic, consistent or not. O((v + e) log e) for a consistent one.
#[derive(Debug, Clone)]
pub struct BestFirst {
    goals: Goals,
    /// The goal that was reached.
    reached: Option<VertexId>,
    cost: Vec<f64>,
    parents: Vec<u32>,
    frontier: BinaryHeap<Open>,
}

/// An entry of the frontier: a vertex as it was reached at one cost.
#[derive(Debug, Clone, Copy)]
struct Open {
    estimate: f64,
    cost: f64,
    vertex: VertexId,
}

impl BestFirst {
    /// A search among `vertices` vertices from `start` to any of the goals.
    pub fn new(vertices: usize, start: VertexId, goals: Goals) -> Self {
        let (mut cost, mut parents) = (vec![f64::INFINITY; vertices], vec![UNREACHED; vertices]);
        (cost[start.index()], parents[start.index()]) = (0.0, start.0);
        // Alone in the frontier, the start needs no estimate.
        let frontier = BinaryHeap::from([Open { estimate: 0.0, cost: 0.0, vertex: start }]);
        Self { goals, reached: None, cost, parents, frontier }
    }

    /// The cost of the cheapest way to the vertex found so far; infinite where it was not reached.
    pub fn cost(&self, vertex: VertexId) -> f64 {
        self.cost[vertex.index()]
    }
}

impl Walker for BestFirst {
    /// Takes the most promising vertex from the frontier and expands it.
    fn step(&mut self, view: &View) -> Expansion {
        let open = loop {
            match self.frontier.pop() {
                None => return Expansion::Nothing,
                // Entries that a cheaper way has overtaken are passed over.
                Some(open) if open.cost > self.cost[open.vertex.index()] => {}
                Some(open) => break open,
            }
        };
        if self.goals.contains(&open.vertex) {
            self.reached = Some(open.vertex);
            return Expansion::Goal;
        }
        for &next in view.adjacency.neighbours(open.vertex) {
            let cost = open.cost + (view.cost)(open.vertex, next);
            if cost < self.cost[next.index()] {
                self.cost[next.index()] = cost;
                self.parents[next.index()] = open.vertex.0;
                self.frontier.push(Open { estimate: cost + (view.heuristic)(next), cost, vertex: next });
            }
        }
        Expansion::Vertex(open.vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        let Some(goal) = self.reached else { return Vec::new() };
        let mut path = to_root(&self.parents, goal);
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
