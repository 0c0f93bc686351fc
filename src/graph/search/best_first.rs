//! Best-first searches: A* (Hart, Nilsson and Raphael 1968, "A formal basis for the heuristic determination of minimum cost
//! paths"), and Dijkstra's, which is A* with the heuristic 0 (Dijkstra 1959, "A note on two problems in connexion with graphs").

use super::{Expansion, Goals, View, Walker};
use crate::graph::{Ordered, Tree, VertexId};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Costs that differ by no more than this, as a part of them, are the same but for rounding.
const ROUNDED: f64 = 1e-12;

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
    /// The cost at which each vertex was expanded last; infinite if it was not.
    expanded: Vec<f64>,
    reopened: u64,
}

/// An entry of the frontier: estimate, cost and vertex. The largest is expanded first: the smallest estimate, then the larger
/// cost (nearer to the goal), then the lower vertex number.
type Open = (Reverse<Ordered>, Ordered, Reverse<VertexId>);

impl BestFirst {
    /// A search among `vertices` vertices from `start` to any of the goals.
    pub fn new(vertices: usize, start: VertexId, goals: Goals) -> Self {
        let (mut cost, mut tree) = (vec![f64::INFINITY; vertices], Tree::with_room(vertices));
        cost[start.index()] = 0.0;
        tree.add_root(start);
        // Alone in the frontier, the start needs no estimate.
        let frontier = BinaryHeap::from([(Reverse(Ordered::ZERO), Ordered::ZERO, Reverse(start))]);
        Self { goals, reached: None, cost, tree, frontier, expanded: vec![f64::INFINITY; vertices], reopened: 0 }
    }
}

impl Walker for BestFirst {
    /// Takes the most promising vertex from the frontier and expands it.
    fn step(&mut self, view: &View) -> Expansion {
        let (reached_at, vertex) = loop {
            let Some((_, cost, Reverse(vertex))) = self.frontier.pop() else { return Expansion::Nothing };
            let cost = cost.value();
            // Entries that a cheaper path has made stale are skipped.
            if cost <= self.cost[vertex.index()] {
                break (cost, vertex);
            }
        };
        if self.goals.contains(&vertex) {
            self.reached = Some(vertex);
            return Expansion::Goal;
        }
        let before = std::mem::replace(&mut self.expanded[vertex.index()], reached_at);
        // A path of the same length may be shorter by a rounding.
        self.reopened += u64::from(before < f64::INFINITY && reached_at < before * (1.0 - ROUNDED));
        for &next in view.adjacency.neighbours(vertex) {
            let cost = reached_at + (view.cost)(vertex, next);
            if cost < self.cost[next.index()] {
                self.cost[next.index()] = cost;
                self.tree.add(next, vertex);
                let estimate = cost + (view.heuristic)(next);
                self.frontier.push((Reverse(Ordered::new(estimate)), Ordered::new(cost), Reverse(next)));
            }
        }
        Expansion::Vertex(vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        self.reached.map_or(Vec::new(), |goal| self.tree.from_root(goal))
    }

    fn reopened(&self) -> u64 {
        self.reopened
    }
}
