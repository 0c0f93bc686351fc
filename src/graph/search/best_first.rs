//! Best-first searches: A* (Hart, Nilsson and Raphael 1968, "A formal basis for the heuristic determination of minimum cost
//! paths"), and Dijkstra's, which is A* with the heuristic 0 (Dijkstra 1959, "A note on two problems in connexion with graphs").

use super::{Expansion, Goals, View, Walker};
use crate::graph::{Tree, VertexId};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A* from one vertex to the cheapest of the goals. A vertex is reopened if a cheaper path to it is found, so the path is the
/// cheapest for every admissible heuristic, consistent or not. O((v + e) log e) for a consistent one.
#[derive(Debug, Clone)]
pub struct BestFirst {
    goals: Goals,
    /// The goal that was reached.
    reached: Option<VertexId>,
    cost: Vec<f64>,
    tree: Tree,
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
        let (mut cost, mut tree) = (vec![f64::INFINITY; vertices], Tree::with_room(vertices));
        cost[start.index()] = 0.0;
        tree.add_root(start);
        // Alone in the frontier, the start needs no estimate.
        let frontier = BinaryHeap::from([Open { estimate: 0.0, cost: 0.0, vertex: start }]);
        Self { goals, reached: None, cost, tree, frontier }
    }

    /// The cost of the cheapest path to the vertex found so far; infinite if it was not reached.
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
                // Entries that a cheaper path has made stale are skipped.
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
                self.tree.add(next, open.vertex);
                self.frontier.push(Open { estimate: cost + (view.heuristic)(next), cost, vertex: next });
            }
        }
        Expansion::Vertex(open.vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        self.reached.map_or(Vec::new(), |goal| self.tree.from_root(goal))
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
