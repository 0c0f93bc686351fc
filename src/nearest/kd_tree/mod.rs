//! The kd-tree: states halved recursively, each part in its tight bounding box, so that a query skips boxes that are too far.
//!
//! Bentley 1975, "Multidimensional binary search trees used for associative searching"; with buckets as leaves;
//! unbalanced subtrees are rebuilt (Galperin and Rivest 1993, "Scapegoat trees"). Circles need no copies of the states and
//! no second query: boxes are intervals of plain numbers, and [`gap_to_interval`] takes the shorter direction round.
//!
//! Results equal the linear scan's bit for bit. The bound of a box is the metric's own expression on gaps that are, in
//! floating point, no wider than those to any state inside; rounded sums, products and roots keep that order, so the bound
//! never exceeds a distance. Boxes are pruned only if the bound is *greater* than the worst distance found, so every tie
//! is seen and decided by the vertex number. The shape of the tree changes the time but never the result.

mod grow;

use super::closest::Closest;
use super::packs::{LANES, Packs};
use super::{Nearest, Neighbour};
use crate::graph::VertexId;
use crate::space::{Space, gap_to_interval};
use wide::f64x2;

/// The packs of a full leaf.
const LEAF_PACKS: usize = 32 / LANES;

/// How many states fill a leaf.
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
    split: f64,
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

/// On one axis, the lowest numbers in the two children of a branch, then the highest.
type Sides = [[f64; 2]; 2];

/// A kd-tree that grows. A query costs about O(log n + k) in low dimensions; n insertions cost O(n log n) in random
/// order, O(n log^2 n) in any order. In addition to its coordinates a state takes about 12 bytes if leaves are full, and up
/// to 30 just after they were split.
#[derive(Debug, Clone, Default)]
pub struct KdTree {
    packs: Packs,
    leaves: Vec<Leaf>,
    branches: Vec<Branch>,
    /// `dimension` per branch.
    boxes: Vec<Sides>,
    root: Node,
    len: usize,
    /// The weight of each coordinate in the metric.
    weights: Vec<f64>,
    /// Freed slots, to be reused.
    free_packs: Vec<u32>,
    free_leaves: Vec<u32>,
    free_branches: Vec<u32>,
}

impl KdTree {
    /// Lower bounds on the distances from a state, given by its numbers, to the states of a branch's two children.
    #[inline(always)]
    fn bounds<S: Space>(&self, space: &S, from: &[f64], branch: usize) -> [f64; 2] {
        let sides = &self.boxes[branch * from.len()..][..from.len()];
        space
            .norm(|i| {
                let [low, high] = sides[i].map(f64x2::new);
                gap_to_interval(f64x2::splat(from[i]), low, high, f64x2::splat(space.period(i)))
            })
            .to_array()
    }

    /// Offers the states that may be among the nearest, nearest boxes first. Returns how many were visited.
    fn search<S: Space>(&self, space: &S, from: &[f64], closest: &mut Closest) -> usize {
        let mut visited = 0;
        if self.len == 0 {
            return visited;
        }
        let mut waiting = [(0.0, Node(0)); MAX_DEPTH];
        let mut waits = 0;
        let mut distances = [[0.0; LANES]; LEAF_PACKS];
        let mut node = self.root;
        loop {
            while !node.is_leaf() {
                let bounds = self.bounds(space, from, node.index());
                let children = self.branches[node.index()].children;
                let near = usize::from(bounds[1] < bounds[0]);
                if bounds[1 - near] <= closest.limit() {
                    waiting[waits] = (bounds[1 - near], children[1 - near]);
                    waits += 1;
                }
                node = children[near];
            }
            let leaf = &self.leaves[node.index()];
            visited += leaf.len as usize;
            let packs = &leaf.packs[..(leaf.len as usize).div_ceil(LANES)];
            for (distances, &pack) in distances.iter_mut().zip(packs) {
                *distances = self.packs.distances(space, from, pack as usize);
            }
            let vertex = |pack: usize, lane: usize| self.packs.vertices(packs[pack] as usize)[lane];
            closest.offer(&distances[..packs.len()], vertex);
            node = loop {
                if waits == 0 {
                    return visited;
                }
                waits -= 1;
                let (bound, node) = waiting[waits];
                if bound <= closest.limit() {
                    break node;
                }
            };
        }
    }
}

impl<S: Space> Nearest<S> for KdTree {
    fn insert(&mut self, space: &S, vertex: VertexId, state: S::State) {
        let coordinates = space.coordinates(&state);
        if self.len == 0 {
            let weight = |i| space.norm(|j| f64::from(u8::from(i == j)));
            self.start((0..space.dimension()).map(weight).collect());
        }
        self.grow(vertex, coordinates);
    }

    fn len(&self) -> usize {
        self.len
    }

    fn k_nearest(&self, space: &S, state: &S::State, k: usize, found: &mut Vec<Neighbour>) -> usize {
        let mut closest = Closest::new(found, k, f64::INFINITY, k <= SORTED);
        let visited = if k > 0 { self.search(space, space.coordinates(state), &mut closest) } else { 0 };
        closest.finish();
        visited
    }

    fn within(&self, space: &S, state: &S::State, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        let mut closest = Closest::within(found, radius);
        let visited = self.search(space, space.coordinates(state), &mut closest);
        closest.finish();
        visited
    }
}
