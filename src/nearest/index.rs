//! The exact index that planners use: about as fast as the faster of linear scan and kd-tree at any size.

use super::{Direction, KdTree, LinearScan, Nearest, Neighbour};
use crate::graph::VertexId;
use crate::space::Space;

/// The scan's copy of the states is dropped above this size; only a very large k would still favour it.
const MOST_SCANNED: usize = 8192;

/// A tree is built above this size; the crossover is never below it.
const FEWEST_IN_TREE: usize = 60;

/// A linear scan for few states and a kd-tree for many. Which one runs depends only on the number of states, neighbours and
/// dimensions; both return the same bits. If the norm of the space is only a lower bound on distances, candidates are
/// found by the norm and ranked by their distance. The methods of [`Nearest`] are about motions to the state ([`Direction::In`]);
/// the methods ending in `_by` take the direction.
#[derive(Debug, Clone, Default)]
pub struct Index {
    /// Empty if the norm is only a lower bound.
    scan: LinearScan,
    tree: KdTree,
    len: usize,
}

impl Index {
    /// The vertex nearest to `state` by motions in the given direction; `None` if the index is empty.
    pub fn nearest_by<S: Space>(
        &self,
        space: &S,
        states: &[S::State],
        direction: Direction,
        state: &S::State,
    ) -> Option<Neighbour> {
        if space.is_norm_exact() && self.len <= Self::crossover(space, 1) {
            return self.scan.nearest(space, states, state);
        }
        let mut found = Vec::with_capacity(2);
        self.k_nearest_by(space, states, direction, state, 1, &mut found);
        found.pop()
    }

    /// The `k` vertices nearest to `state` by motions in the given direction (all, if there are fewer), nearest first, into `found`.
    pub fn k_nearest_by<S: Space>(
        &self,
        space: &S,
        states: &[S::State],
        direction: Direction,
        state: &S::State,
        k: usize,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        if !space.is_norm_exact() {
            self.rank(space, states, direction, state, k, found)
        } else if self.len <= Self::crossover(space, k) {
            self.scan.k_nearest(space, states, state, k, found)
        } else {
            self.tree.k_nearest(space, states, state, k, found)
        }
    }

    /// Every vertex no farther from `state` than `radius` by motions in the given direction, nearest first, into `found`.
    pub fn within_by<S: Space>(
        &self,
        space: &S,
        states: &[S::State],
        direction: Direction,
        state: &S::State,
        radius: f64,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        if space.is_norm_exact() && self.len <= Self::crossover(space, 1) {
            return self.scan.within(space, states, state, radius, found);
        }
        let visited = self.tree.within(space, states, state, radius, found);
        if !space.is_norm_exact() {
            found.iter_mut().for_each(|candidate| *candidate = measured(space, states, direction, state, candidate));
            found.retain(|neighbour| neighbour.distance <= radius);
            found.sort_unstable_by_key(Neighbour::key);
        }
        visited
    }

    /// The `k` nearest if the norm is a lower bound: takes candidates by their bounds, in batches that grow, and ranks them
    /// by their distances until every bound left exceeds the worst distance found. The result is that of a plain scan, ties by
    /// vertex number; how many distances are computed depends on how tight the bound is.
    fn rank<S: Space>(
        &self,
        space: &S,
        states: &[S::State],
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
        let (mut wanted, mut ranked) = (k.saturating_mul(2).saturating_add(6), 0);
        while ranked < self.len {
            visited = self.tree.k_nearest(space, states, state, wanted, &mut candidates);
            for candidate in &candidates[ranked..] {
                if found.len() == k && candidate.distance > found[k - 1].distance {
                    return visited;
                }
                let neighbour = measured(space, states, direction, state, candidate);
                if found.len() == k {
                    if !neighbour.is_before(&found[k - 1]) {
                        continue;
                    }
                    found.pop();
                }
                let at = found.iter().rposition(|other| other.is_before(&neighbour)).map_or(0, |i| i + 1);
                found.insert(at, neighbour);
            }
            ranked = candidates.len();
            wanted = wanted.saturating_mul(2);
        }
        visited
    }

    /// The number of states up to which a scan finds `k` neighbours faster than the tree: linear fits to the figures of the
    /// benchmark `nearest`.
    fn crossover<S: Space>(space: &S, k: usize) -> usize {
        let (few, each) = match space.dimension() {
            0..=2 => (60, 3),
            3 => (100, 17),
            4 => (250, 45),
            5 => (700, 110),
            _ => (1400, 250),
        };
        (few + each * k.min(MOST_SCANNED)).min(MOST_SCANNED)
    }
}

/// The neighbour of a candidate found by the norm.
fn measured<S: Space>(
    space: &S,
    states: &[S::State],
    direction: Direction,
    state: &S::State,
    candidate: &Neighbour,
) -> Neighbour {
    let distance = direction.distance(space, state, &states[candidate.vertex.index()]);
    Neighbour { distance, vertex: candidate.vertex }
}

impl<S: Space> Nearest<S> for Index {
    fn insert(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        self.len += 1;
        if !space.is_norm_exact() {
            return self.tree.insert(space, vertex, state);
        }
        if self.len > FEWEST_IN_TREE {
            if Nearest::<S>::is_empty(&self.tree) {
                self.tree = KdTree::of(self.scan.packs(), FEWEST_IN_TREE);
            }
            self.tree.insert(space, vertex, state);
        }
        if self.len > MOST_SCANNED {
            self.scan = LinearScan::default();
        } else {
            self.scan.insert(space, vertex, state);
        }
    }

    fn len(&self) -> usize {
        self.len
    }

    fn nearest(&self, space: &S, states: &[S::State], from: &S::State) -> Option<Neighbour> {
        self.nearest_by(space, states, Direction::In, from)
    }

    fn k_nearest(
        &self,
        space: &S,
        states: &[S::State],
        from: &S::State,
        k: usize,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        self.k_nearest_by(space, states, Direction::In, from, k, found)
    }

    fn within(
        &self,
        space: &S,
        states: &[S::State],
        from: &S::State,
        radius: f64,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        self.within_by(space, states, Direction::In, from, radius, found)
    }
}
