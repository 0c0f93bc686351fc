//! The kd-tree: states halved recursively, each part in its tight bounding box, so that a query skips boxes that are too far.
//!
//! Bentley 1975, "Multidimensional binary search trees used for associative searching"; with buckets as leaves; unbalanced
//! subtrees are rebuilt (Galperin and Rivest 1993, "Scapegoat trees"). Circles need no copies of the states and no second query:
//! boxes are intervals of plain numbers, and [`gap_to_interval`](crate::space::gap_to_interval) takes the shorter direction
//! round.
//!
//! Results equal the linear scan's bit for bit. States, splits and boxes are in single precision. The bound of a box is the
//! metric's own expression on gaps that are, in floating point, no wider than those to any state inside; rounded sums, products
//! and roots keep that order, so the bound never exceeds an approximate distance. Boxes are pruned only if the bound is *greater*
//! than that of any candidate (see `packs.rs`), so every tie is seen and decided by the exact distance and the vertex number. The
//! shape of the tree changes the time but never the result.

mod grow;

use super::closest::{Closest, Collector, Ranked, guess};
use super::packs::{LANES, Packed, Packs, measure};
use super::{Nearest, Neighbour, Query};
use crate::graph::VertexId;
use crate::space::Space;

/// The packs of a full leaf.
const LEAF_PACKS: usize = 48 / LANES;

/// How many states fill a leaf: with fewer the nearest is found faster, with more the thirty nearest, in less memory.
const LEAF: usize = LEAF_PACKS * LANES;

/// Up to this many neighbours stay sorted: more than in a scan, as a tight limit here prunes whole leaves.
const SORTED: usize = 16;

/// The greatest depth: a tree that would grow deeper is rebuilt.
const MAX_DEPTH: usize = 64;

/// The number of a branch, or of a leaf with the highest bit set.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Node(u32);

impl Node {
    const LEAF_BIT: u32 = 1 << 31;

    fn leaf(index: usize) -> Self {
        Self(index as u32 | Self::LEAF_BIT)
    }

    #[inline(always)]
    fn is_leaf(self) -> bool {
        self.0 & Self::LEAF_BIT != 0
    }

    #[inline(always)]
    fn index(self) -> usize {
        (self.0 & !Self::LEAF_BIT) as usize
    }
}

/// An inner node. A new state goes to the second child if its coordinate on the axis is at least the split value.
#[derive(Debug, Clone, Copy)]
struct Branch {
    split: f32,
    axis: u32,
    children: [Node; 2],
    /// How many states each child holds.
    counts: [u32; 2],
}

#[derive(Debug, Clone, Copy)]
struct Leaf {
    packs: [u32; LEAF_PACKS],
    len: u32,
}

/// On one axis, the lowest numbers in the two children of a branch, then the highest, negated.
type Sides = [f32; 4];

/// A kd-tree that grows. A query costs about O(log n + k) in low dimensions; n insertions cost O(n log n) in random
/// order, O(n log^2 n) in any order. In addition to its coordinates, 4 bytes each, a state takes
/// about 10 bytes in four dimensions: its number, and its share of the boxes and of what is spare in leaves.
#[derive(Debug, Clone, Default)]
pub struct KdTree {
    packs: Packs,
    leaves: Vec<Leaf>,
    branches: Vec<Branch>,
    /// `dimension` per branch.
    boxes: Vec<Sides>,
    root: Node,
    len: usize,
    /// Freed slots, to be reused.
    free_packs: Vec<u32>,
    free_leaves: Vec<u32>,
    free_branches: Vec<u32>,
}

impl KdTree {
    /// An empty tree that knows nothing of circles: it takes angles as plain numbers from -pi to pi, so it misses
    /// neighbours across that seam. Faulty, for comparison. Its neighbours and their distances are those of a scan by
    /// the same metric without wrap-around, bit for bit: those of the default tree in a space without circles. It costs
    /// as much as that tree, and ranks by [`Space::norm`] alone.
    pub fn unwrapped() -> Self {
        let mut tree = Self::default();
        tree.packs.is_unwrapped = true;
        tree
    }

    /// The `k` nearest states if the norm of the space is a lower bound on their distances, into `found`: `distance` returns that
    /// of a vertex if it is at most a number, else any greater number. A few candidates are ranked by their bounds first, so that
    /// the search for all others begins with a low bar. Returns how many vertices were visited.
    pub(super) fn k_nearest_ranked<S: Space>(
        &self,
        query: Query<S>,
        k: usize,
        found: &mut Vec<Neighbour>,
        distance: impl Fn(VertexId, f64) -> f64,
    ) -> usize {
        let mut candidates = Vec::new();
        let few = k.saturating_mul(2).saturating_add(6);
        let visited = self.k_nearest(query, few, &mut candidates);
        found.clear();
        if k == 0 {
            return 0;
        }
        let packed = self.packs.query(query.space, query.from);
        let ranked = Ranked::new(&packed, &candidates, found, k, distance);
        if ranked.bar() < 0.0 || candidates.len() == self.len {
            return visited;
        }
        self.search(query.space, &packed, ranked)
    }

    /// Every vertex no farther than `radius`: nearest first, or in any order. Returns how many vertices were visited.
    pub(super) fn all_within<S: Space>(
        &self,
        query: Query<S>,
        radius: f64,
        sorts_result: bool,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        let packed = self.packs.query(query.space, query.from);
        let measure = measure(query, self.packs.is_unwrapped);
        self.search(query.space, &packed, Closest::all(&packed, found, radius, sorts_result, measure))
    }

    /// Offers the states that may be among the nearest, nearest boxes first. Returns how many were visited.
    fn search<S: Space>(&self, space: &S, query: &Packed, mut closest: impl Collector) -> usize {
        let mut visited = 0;
        if self.len == 0 {
            return visited;
        }
        let dimension = self.packs.dimension;
        let mut waiting = [(0.0, Node(0)); MAX_DEPTH];
        let mut waits = 0;
        let mut distances = [[0.0; LANES]; LEAF_PACKS];
        let mut node = self.root;
        loop {
            while !node.is_leaf() {
                let bounds = query.bounds(space, &self.boxes[node.index() * dimension..][..dimension]);
                let children = self.branches[node.index()].children;
                let near = usize::from(bounds[1] < bounds[0]);
                if bounds[1 - near] <= closest.bar() {
                    waiting[waits] = (bounds[1 - near], children[1 - near]);
                    waits += 1;
                }
                node = children[near];
            }
            let leaf = &self.leaves[node.index()];
            visited += leaf.len as usize;
            let packs = &leaf.packs[..(leaf.len as usize).div_ceil(LANES)];
            for (distances, &pack) in distances.iter_mut().zip(packs) {
                *distances = self.packs.distances(space, query, pack as usize);
            }
            let vertex = |pack: usize, lane: usize| self.packs.vertices(packs[pack] as usize)[lane];
            closest.offer(&distances[..packs.len()], vertex);
            node = loop {
                if waits == 0 {
                    closest.finish();
                    return visited;
                }
                waits -= 1;
                let (bound, node) = waiting[waits];
                if bound <= closest.bar() {
                    break node;
                }
            };
        }
    }

    /// The tree of states that are in packs already, `len` in all.
    pub(super) fn of(packs: &Packs, len: usize) -> Self {
        let mut tree = Self::default();
        tree.start(packs.emptied());
        for at in 0..len {
            let (vertex, single) = packs.entry(at / LANES, at % LANES);
            tree.grow(vertex, &single[..packs.dimension]);
        }
        tree
    }

    /// Begins with empty packs.
    fn start(&mut self, packs: Packs) {
        self.packs = packs;
        self.leaves.push(Leaf { packs: [0; LEAF_PACKS], len: 0 });
        self.root = Node::leaf(0);
    }
}

impl<S: Space> Nearest<S> for KdTree {
    fn insert(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        if self.len == 0 {
            let mut packs = std::mem::take(&mut self.packs);
            packs.start(space, state);
            self.start(packs);
        }
        let single = self.packs.admit(space, state);
        self.grow(vertex, &single[..space.dimension()]);
    }

    fn len(&self) -> usize {
        self.len
    }

    fn k_nearest(&self, query: Query<S>, k: usize, found: &mut Vec<Neighbour>) -> usize {
        let guess = guess(found, k, SORTED);
        found.clear();
        if k == 0 {
            return 0;
        }
        let packed = self.packs.query(query.space, query.from);
        let measure = measure(query, self.packs.is_unwrapped);
        let mut visited =
            self.search(query.space, &packed, Closest::new(&packed, found, k, guess, k <= SORTED, measure));
        if guess < f64::INFINITY && found.len() < k.min(self.len) {
            visited +=
                self.search(query.space, &packed, Closest::new(&packed, found, k, f64::INFINITY, k <= SORTED, measure));
        }
        visited
    }

    fn within(&self, query: Query<S>, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        self.all_within(query, radius, true, found)
    }
}
