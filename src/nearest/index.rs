//! The exact index that planners use: about as fast as the faster of linear scan and kd-tree at any size.

use super::ranked::Ranked;
use super::{Direction, KdTree, LinearScan, Nearest, Neighbour};
use crate::graph::VertexId;
use crate::space::Space;

/// Whether the scan is used. Without vector instructions it is no faster than the tree, so WebAssembly does without it.
const SCANS: bool = !cfg!(target_arch = "wasm32");

/// The scan's copy of the states is dropped above this size; only a very large k would still favour it.
const MOST_SCANNED: usize = 8192;

/// A linear scan for few states and a kd-tree for many. Which one runs depends only on the number of states, neighbours and
/// dimensions; both return the same bits. Where the norm of the space is only a lower bound on distances, candidates are
/// found by the norm and ranked by their distance. The methods of [`Nearest`] are about motions to the state ([`Direction::In`]);
/// the methods ending in `_by` take the direction.
#[derive(Debug, Clone)]
pub struct Index<S: Space> {
    scan: LinearScan<S>,
    tree: KdTree<S>,
    /// All states, where the norm is only a lower bound; `scan` and `tree` are then empty.
    ranked: Ranked<S>,
    len: usize,
}

impl<S: Space> Index<S> {
    /// An empty index.
    pub fn new() -> Self {
        Self { scan: LinearScan::new(), tree: KdTree::new(), ranked: Ranked::new(), len: 0 }
    }

    /// The vertex nearest to `state` by motions in the given direction; `None` where the index is empty.
    pub fn nearest_by(&self, space: &S, direction: Direction, state: &S::State) -> Option<Neighbour> {
        if space.is_norm_exact() {
            return self.nearest(space, state);
        }
        let mut found = Vec::with_capacity(1);
        self.ranked.k_nearest(space, direction, state, 1, &mut found);
        found.pop()
    }

    /// The `k` vertices nearest to `state` by motions in the given direction (all, where there are fewer), nearest first, into `found`.
    pub fn k_nearest_by(
        &self,
        space: &S,
        direction: Direction,
        state: &S::State,
        k: usize,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        if space.is_norm_exact() {
            self.k_nearest(space, state, k, found)
        } else {
            self.ranked.k_nearest(space, direction, state, k, found)
        }
    }

    /// Every vertex no farther from `state` than `radius` by motions in the given direction, nearest first, into `found`.
    pub fn within_by(
        &self,
        space: &S,
        direction: Direction,
        state: &S::State,
        radius: f64,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        if space.is_norm_exact() {
            self.within(space, state, radius, found)
        } else {
            self.ranked.within(space, direction, state, radius, found)
        }
    }

    /// The number of states up to which a scan finds `k` neighbours faster than the tree: linear fits to the figures of the
    /// benchmark `nearest`.
    fn crossover(space: &S, k: usize) -> usize {
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

impl<S: Space> Default for Index<S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Space> Nearest<S> for Index<S> {
    fn insert(&mut self, space: &S, vertex: VertexId, state: S::State) {
        self.len += 1;
        if !space.is_norm_exact() {
            return self.ranked.insert(space, vertex, state);
        }
        self.tree.insert(space, vertex, state);
        if SCANS && self.len <= MOST_SCANNED {
            self.scan.insert(space, vertex, state);
        } else if !self.scan.is_empty() {
            self.scan = LinearScan::new();
        }
    }

    fn len(&self) -> usize {
        self.len
    }

    fn nearest(&self, space: &S, state: &S::State) -> Option<Neighbour> {
        if !space.is_norm_exact() {
            return self.nearest_by(space, Direction::In, state);
        }
        if SCANS && self.len <= Self::crossover(space, 1) {
            self.scan.nearest(space, state)
        } else {
            self.tree.nearest(space, state)
        }
    }

    fn k_nearest(&self, space: &S, state: &S::State, k: usize, found: &mut Vec<Neighbour>) -> usize {
        if !space.is_norm_exact() {
            return self.k_nearest_by(space, Direction::In, state, k, found);
        }
        if SCANS && self.len <= Self::crossover(space, k) {
            self.scan.k_nearest(space, state, k, found)
        } else {
            self.tree.k_nearest(space, state, k, found)
        }
    }

    fn within(&self, space: &S, state: &S::State, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        if !space.is_norm_exact() {
            return self.within_by(space, Direction::In, state, radius, found);
        }
        if SCANS && self.len <= Self::crossover(space, 1) {
            self.scan.within(space, state, radius, found)
        } else {
            self.tree.within(space, state, radius, found)
        }
    }
}
