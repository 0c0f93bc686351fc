//! Nearest neighbours among states.
//!
//! Ties go to the lower vertex number, so every exact index gives the same answer, to the bit. Planners use [`Index`], which
//! is a [`LinearScan`] of few states and a [`KdTree`] of many; [`Forest`] is approximate, for many dimensions. Scan, tree and
//! forest need a space whose norm is its distance; [`Index`] serves all, and distances in either [`Way`].

mod closest;
mod forest;
mod index;
mod kd_tree;
mod linear;
mod packs;
mod ranked;

pub use forest::{Forest, ForestParameters, recall};
pub use index::Index;
pub use kd_tree::KdTree;
pub use linear::LinearScan;
pub use ranked::Way;

use crate::graph::VertexId;
use crate::space::Space;

/// A neighbour and its distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Neighbour {
    /// The distance in the metric of the space.
    pub distance: f64,
    /// The vertex.
    pub vertex: VertexId,
}

impl Neighbour {
    /// Whether this neighbour comes before the other: by distance, then by vertex number.
    #[inline]
    pub fn is_before(&self, other: &Self) -> bool {
        self.distance < other.distance || (self.distance == other.distance && self.vertex < other.vertex)
    }

    /// A number that orders as [`is_before`](Self::is_before): the bits of distances that are not negative order as they do.
    #[inline]
    fn key(&self) -> u128 {
        (u128::from(self.distance.to_bits()) << 32) | u128::from(self.vertex.0)
    }
}

/// An index of states that grows.
pub trait Nearest<S: Space> {
    /// Adds a vertex; numbers must increase.
    fn insert(&mut self, space: &S, vertex: VertexId, state: S::State);

    /// How many vertices the index holds.
    fn len(&self) -> usize;

    /// Whether the index is empty.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The vertex nearest to `state`; `None` where the index is empty.
    fn nearest(&self, space: &S, state: &S::State) -> Option<Neighbour>;

    /// The `k` vertices nearest to `state` (all, where there are fewer), nearest first, into `found`. Answers how many vertices it
    /// visited: whose distances, or where those are dearer the bounds on them, it looked at.
    fn k_nearest(&self, space: &S, state: &S::State, k: usize, found: &mut Vec<Neighbour>) -> usize;

    /// Every vertex no farther from `state` than `radius`, nearest first, into `found`. Answers how many vertices it visited.
    fn within(&self, space: &S, state: &S::State, radius: f64, found: &mut Vec<Neighbour>) -> usize;
}
