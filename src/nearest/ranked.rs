//! Nearest neighbours where the norm only bounds distances from below, and where distances may have a direction.

use super::{KdTree, Nearest, Neighbour};
use crate::graph::VertexId;
use crate::space::Space;

/// The direction of the motions between a state and its neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From the neighbours to the state.
    In,
    /// From the state to the neighbours.
    Out,
}

impl Direction {
    /// The directions to be told apart in a space: in a symmetric one both are the same.
    pub fn all<S: Space>(space: &S) -> &'static [Self] {
        if space.is_symmetric() { &[Direction::Out] } else { &[Direction::Out, Direction::In] }
    }

    /// The two ends of a motion between a state and a neighbour, from and to.
    #[inline]
    pub fn ends<T>(self, state: T, neighbour: T) -> [T; 2] {
        match self {
            Direction::In => [neighbour, state],
            Direction::Out => [state, neighbour],
        }
    }

    /// The distance between a state and a neighbour of it, in this direction.
    #[inline]
    pub fn distance<S: Space>(self, space: &S, state: &S::State, neighbour: &S::State) -> f64 {
        let [from, to] = self.ends(state, neighbour);
        space.distance(from, to)
    }
}

/// A kd-tree of bounds beside the states themselves. A query takes candidates by their bounds, batches of them that grow, and
/// ranks them by their distances, until no bound is left that does not exceed the worst distance kept. So the answers are
/// those of a plain scan, ties by vertex number; how many distances are computed depends on how tight the bound is.
#[derive(Debug, Clone)]
pub(super) struct Ranked<S: Space> {
    /// Holds the states under their places in `entries`.
    bounds: KdTree<S>,
    entries: Vec<(VertexId, S::State)>,
}

impl<S: Space> Ranked<S> {
    /// An empty index.
    pub fn new() -> Self {
        Self { bounds: KdTree::new(), entries: Vec::new() }
    }

    /// Adds a vertex; numbers must increase.
    pub fn insert(&mut self, space: &S, vertex: VertexId, state: S::State) {
        self.bounds.insert(space, VertexId(self.entries.len() as u32), state);
        self.entries.push((vertex, state));
    }

    /// The neighbour that a candidate is.
    fn neighbour(&self, space: &S, direction: Direction, state: &S::State, candidate: &Neighbour) -> Neighbour {
        let (vertex, other) = &self.entries[candidate.vertex.index()];
        Neighbour { distance: direction.distance(space, state, other), vertex: *vertex }
    }

    /// The `k` vertices nearest to the state, nearest first, into `found`.
    pub fn k_nearest(
        &self,
        space: &S,
        direction: Direction,
        state: &S::State,
        k: usize,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        found.clear();
        if k == 0 {
            return 0;
        }
        let (mut candidates, mut visited) = (Vec::new(), 0);
        let (mut asked, mut ranked) = (k.saturating_mul(2).saturating_add(6), 0);
        while ranked < self.entries.len() {
            visited = self.bounds.k_nearest(space, state, asked, &mut candidates);
            for candidate in &candidates[ranked..] {
                if found.len() == k && candidate.distance > found[k - 1].distance {
                    return visited;
                }
                let neighbour = self.neighbour(space, direction, state, candidate);
                if found.len() == k {
                    if !neighbour.is_before(&found[k - 1]) {
                        continue;
                    }
                    found.pop();
                }
                let at = found.iter().rposition(|kept| kept.is_before(&neighbour)).map_or(0, |i| i + 1);
                found.insert(at, neighbour);
            }
            ranked = candidates.len();
            asked = asked.saturating_mul(2);
        }
        visited
    }

    /// Every vertex no farther from the state than `radius`, nearest first, into `found`.
    pub fn within(
        &self,
        space: &S,
        direction: Direction,
        state: &S::State,
        radius: f64,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        let visited = self.bounds.within(space, state, radius, found);
        found.iter_mut().for_each(|candidate| *candidate = self.neighbour(space, direction, state, candidate));
        found.retain(|neighbour| neighbour.distance <= radius);
        found.sort_unstable_by_key(Neighbour::key);
        visited
    }
}
