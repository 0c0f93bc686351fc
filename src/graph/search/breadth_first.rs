//! Breadth-first search: the path of the fewest edges (Moore 1959, "The shortest path through a maze").

use super::{Expansion, Goals, UNREACHED, View, Walker, to_root};
use crate::graph::VertexId;

/// Breadth-first search from one vertex to the nearest of others; costs and heuristic are not looked at. O(v + e).
#[derive(Debug, Clone)]
pub struct BreadthFirst {
    goals: Goals,
    parents: Vec<u32>,
    /// Every vertex reached, in that order; those before `next` are expanded.
    queue: Vec<VertexId>,
    next: usize,
}

impl BreadthFirst {
    /// A search among `vertices` vertices from `start` to any of the goals.
    pub fn new(vertices: usize, start: VertexId, goals: Goals) -> Self {
        let mut parents = vec![UNREACHED; vertices];
        parents[start.index()] = start.0;
        Self { goals, parents, queue: vec![start], next: 0 }
    }
}

impl Walker for BreadthFirst {
    fn step(&mut self, view: &View) -> Expansion {
        let Some(&vertex) = self.queue.get(self.next) else { return Expansion::Nothing };
        if self.goals.contains(&vertex) {
            return Expansion::Goal;
        }
        self.next += 1;
        for &next in view.adjacency.neighbours(vertex) {
            if self.parents[next.index()] == UNREACHED {
                self.parents[next.index()] = vertex.0;
                self.queue.push(next);
            }
        }
        Expansion::Vertex(vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        let Some(&goal) = self.queue.get(self.next).filter(|vertex| self.goals.contains(vertex)) else {
            return Vec::new();
        };
        let mut path = to_root(&self.parents, goal);
        path.reverse();
        path
    }
}
