//! The index that planners use: exact, and for any number of states about as fast as the faster of scan and tree.

use super::ranked::Ranked;
use super::{KdTree, LinearScan, Nearest, Neighbour, Way};
use crate::graph::VertexId;
use crate::space::Space;

/// Whether a scan ever pays: without vectors it takes as long as the tree where there are few states, and WebAssembly is the
/// smaller for going without.
const SCANS: bool = !cfg!(target_arch = "wasm32");

/// Beyond so many states the scan's copy of them is given up: only for a great many neighbours would it still win.
const MOST_SCANNED: usize = 8192;

/// The states of a scan while it can win, and of a kd-tree from where that can. Which one answers depends on the numbers of
/// states, neighbours and dimensions alone, and their answers are equal to the bit. Where the norm of the space is only a bound
/// on distances, states are looked up by it and ranked by their distances. The questions of [`Nearest`] are about motions to the
/// state ([`Way::In`]); which way, others may say.
#[derive(Debug, Clone)]
pub struct Index<S: Space> {
    scan: LinearScan<S>,
    tree: KdTree<S>,
    /// All states, where the norm is only a bound; the other two are empty then.
    ranked: Ranked<S>,
    len: usize,
}

impl<S: Space> Index<S> {
    /// An empty index.
    pub fn new() -> Self {
        Self { scan: LinearScan::new(), tree: KdTree::new(), ranked: Ranked::new(), len: 0 }
    }

    /// The vertex nearest to `state` by motions of the given way; `None` where the index is empty.
    pub fn nearest_by(&self, space: &S, way: Way, state: &S::State) -> Option<Neighbour> {
        if space.is_norm_exact() {
            return self.nearest(space, state);
        }
        let mut found = Vec::with_capacity(1);
        self.ranked.k_nearest(space, way, state, 1, &mut found);
        found.pop()
    }

    /// The `k` vertices nearest to `state` by motions of the given way (all, where there are fewer), nearest first, into `found`.
    pub fn k_nearest_by(&self, space: &S, way: Way, state: &S::State, k: usize, found: &mut Vec<Neighbour>) -> usize {
        if space.is_norm_exact() {
            self.k_nearest(space, state, k, found)
        } else {
            self.ranked.k_nearest(space, way, state, k, found)
        }
    }

    /// Every vertex no farther from `state` than `radius` by motions of the given way, nearest first, into `found`.
    pub fn within_by(&self, space: &S, way: Way, state: &S::State, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        if space.is_norm_exact() {
            self.within(space, state, radius, found)
        } else {
            self.ranked.within(space, way, state, radius, found)
        }
    }

    /// Up to how many states a scan finds `k` neighbours faster than the tree: straight lines through what the benchmark
    /// `nearest` measures.
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
            return self.nearest_by(space, Way::In, state);
        }
        if SCANS && self.len <= Self::crossover(space, 1) {
            self.scan.nearest(space, state)
        } else {
            self.tree.nearest(space, state)
        }
    }

    fn k_nearest(&self, space: &S, state: &S::State, k: usize, found: &mut Vec<Neighbour>) -> usize {
        if !space.is_norm_exact() {
            return self.k_nearest_by(space, Way::In, state, k, found);
        }
        if SCANS && self.len <= Self::crossover(space, k) {
            self.scan.k_nearest(space, state, k, found)
        } else {
            self.tree.k_nearest(space, state, k, found)
        }
    }

    fn within(&self, space: &S, state: &S::State, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        if !space.is_norm_exact() {
            return self.within_by(space, Way::In, state, radius, found);
        }
        if SCANS && self.len <= Self::crossover(space, 1) {
            self.scan.within(space, state, radius, found)
        } else {
            self.tree.within(space, state, radius, found)
        }
    }
}
