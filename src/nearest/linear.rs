//! The linear scan: looks at every state. Simple, exact, the oracle of every other index, and fastest for few states.

use super::{Nearest, Neighbour};
use crate::graph::VertexId;
use crate::space::Space;

/// All states in one list. A query costs O(n), for k neighbours O(n + k m) where m states enter the list on the way.
#[derive(Debug, Clone)]
pub struct LinearScan<S: Space> {
    vertices: Vec<VertexId>,
    states: Vec<S::State>,
}

impl<S: Space> LinearScan<S> {
    /// An empty index.
    pub fn new() -> Self {
        Self { vertices: Vec::new(), states: Vec::new() }
    }
}

impl<S: Space> Default for LinearScan<S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Space> Nearest<S> for LinearScan<S> {
    fn insert(&mut self, _: &S, vertex: VertexId, state: S::State) {
        debug_assert!(self.vertices.last().is_none_or(|&last| last < vertex), "vertex numbers increase");
        self.vertices.push(vertex);
        self.states.push(state);
    }

    fn len(&self) -> usize {
        self.vertices.len()
    }

    fn nearest(&self, space: &S, state: &S::State) -> Option<Neighbour> {
        // The first of equals is the one with the lowest number: states are stored in the order of their numbers.
        let mut best = (f64::INFINITY, usize::MAX);
        for (i, candidate) in self.states.iter().enumerate() {
            let distance = space.distance(state, candidate);
            if distance < best.0 {
                best = (distance, i);
            }
        }
        self.vertices.get(best.1).map(|&vertex| Neighbour { distance: best.0, vertex })
    }

    fn k_nearest(&self, space: &S, state: &S::State, k: usize, found: &mut Vec<Neighbour>) {
        found.clear();
        if k == 0 {
            return;
        }
        let mut farthest = f64::INFINITY;
        for (candidate, &vertex) in self.states.iter().zip(&self.vertices) {
            let distance = space.distance(state, candidate);
            if distance < farthest {
                if found.len() == k {
                    found.pop();
                }
                let at = found.iter().rposition(|kept| kept.distance <= distance).map_or(0, |i| i + 1);
                found.insert(at, Neighbour { distance, vertex });
                if found.len() == k {
                    farthest = found[k - 1].distance;
                }
            }
        }
    }
}
