//! Breadth-first search: the path of the fewest edges (Moore 1959, "The shortest path through a maze").

use super::{Expansion, Goals, View, Walker};
use crate::graph::{Tree, VertexId};

/// Breadth-first search from one vertex to the nearest of the goals; costs and heuristic are ignored. O(v + e).
#[derive(Debug, Clone)]
pub struct BreadthFirst {
    goals: Goals,
    tree: Tree,
    /// Every vertex reached, in that order; those before `next` are expanded.
    queue: Vec<VertexId>,
    next: usize,
}

impl BreadthFirst {
    /// A search among `vertices` vertices from `start` to any of the goals.
    pub fn new(vertices: usize, start: VertexId, goals: Goals) -> Self {
        let mut tree = Tree::with_room(vertices);
        tree.add_root(start);
        Self { goals, tree, queue: vec![start], next: 0 }
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
            if !self.tree.contains(next) {
                self.tree.add(next, vertex);
                self.queue.push(next);
            }
        }
        Expansion::Vertex(vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        let goal = self.queue.get(self.next).filter(|vertex| self.goals.contains(vertex));
        goal.map_or(Vec::new(), |&goal| self.tree.from_root(goal))
    }
}
