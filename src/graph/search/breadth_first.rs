//! Breadth-first search: the path of the fewest edges (Moore 1959, "The shortest path through a maze").

use super::{Expansion, UNREACHED, View, Walker, to_root};
use crate::graph::VertexId;

/// Breadth-first search from one vertex to another; costs and heuristic are not looked at. O(v + e).
#[derive(Debug, Clone)]
pub struct BreadthFirst {
    goal: VertexId,
    parents: Vec<u32>,
    /// Every vertex reached, in that order; those before `next` are expanded.
    queue: Vec<VertexId>,
    next: usize,
}

impl BreadthFirst {
    /// A search among `vertices` vertices from `start` to `goal`.
    pub fn new(vertices: usize, start: VertexId, goal: VertexId) -> Self {
        let mut parents = vec![UNREACHED; vertices];
        parents[start.index()] = start.0;
        Self { goal, parents, queue: vec![start], next: 0 }
    }
}

impl Walker for BreadthFirst {
    fn step(&mut self, view: &View) -> Expansion {
        let Some(&vertex) = self.queue.get(self.next) else { return Expansion::Nothing };
        if vertex == self.goal {
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
        let mut path = to_root(&self.parents, self.goal);
        path.reverse();
        path
    }
}
