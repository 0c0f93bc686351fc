//! The A* of a course report with its fault, to show what that costs.
//!
//! A cheaper way to a vertex that waits lowers its cost, but the vertex keeps its place in the frontier and its first parent.
//! Vertices are then expanded too late, and the path leads along the first ways, so it may be longer than the shortest one, and
//! than the cost at the goal.

use super::{Expansion, Goals, View, Walker};
use crate::graph::{Ordered, Tree, VertexId};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Best-first search that never moves a vertex in its frontier. It finds a path wherever there is one. O((v + e) log v).
#[derive(Debug, Clone)]
pub struct Stale {
    goals: Goals,
    reached: Option<VertexId>,
    cost: Vec<f64>,
    closed: Vec<bool>,
    tree: Tree,
    /// The estimate that a vertex was first added with: the smallest is expanded first, then the lower vertex number.
    frontier: BinaryHeap<(Reverse<Ordered>, Reverse<VertexId>)>,
}

impl Stale {
    /// A search among `vertices` vertices from `start` to any of the goals.
    pub fn new(vertices: usize, start: VertexId, goals: Goals) -> Self {
        let (mut cost, mut tree) = (vec![f64::INFINITY; vertices], Tree::with_room(vertices));
        cost[start.index()] = 0.0;
        tree.add_root(start);
        let frontier = BinaryHeap::from([(Reverse(Ordered::ZERO), Reverse(start))]);
        Self { goals, reached: None, cost, closed: vec![false; vertices], tree, frontier }
    }
}

impl Walker for Stale {
    fn step(&mut self, view: &View) -> Expansion {
        let Some((_, Reverse(vertex))) = self.frontier.pop() else { return Expansion::Nothing };
        if self.goals.contains(&vertex) {
            self.reached = Some(vertex);
            return Expansion::Goal;
        }
        self.closed[vertex.index()] = true;
        for &next in view.adjacency.neighbours(vertex) {
            let cost = self.cost[vertex.index()] + (view.cost)(vertex, next);
            let known = self.cost[next.index()];
            if self.closed[next.index()] || cost >= known {
                continue;
            }
            self.cost[next.index()] = cost;
            if known == f64::INFINITY {
                self.tree.add(next, vertex);
                self.frontier.push((Reverse(Ordered::new(cost + (view.heuristic)(next))), Reverse(next)));
            }
        }
        Expansion::Vertex(vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        self.reached.map_or(Vec::new(), |goal| self.tree.from_root(goal))
    }
}
