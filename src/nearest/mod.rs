//! Nearest neighbours among states.
//!
//! Ties go to the lower vertex number, so every exact index returns the same neighbours, bit for bit. Planners use [`Index`],
//! which is a [`LinearScan`] for few states and a [`KdTree`] for many; [`Forest`] is approximate, for high dimensions,
//! and [`KdTree::unwrapped`] is faulty, for comparison. Scan, tree and forest need a space whose norm is its distance;
//! [`Index`] serves all, and distances in either [`Direction`].

mod closest;
mod forest;
mod index;
mod kd_tree;
mod linear;
mod packs;

pub use forest::{Forest, ForestParameters, recall};
pub use index::Index;
pub use kd_tree::KdTree;
pub use linear::LinearScan;

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

    /// A key with the order of [`is_before`](Self::is_before): the bits of non-negative floats are ordered as their values.
    #[inline]
    fn key(&self) -> u128 {
        (u128::from(self.distance.to_bits()) << 32) | u128::from(self.vertex.0)
    }

    /// Sorts neighbours in the order of [`is_before`](Self::is_before).
    pub(crate) fn sort(neighbours: &mut [Self]) {
        neighbours.sort_unstable_by_key(Self::key);
    }

    /// Sorts neighbours and keeps the first `k`.
    fn first(neighbours: &mut Vec<Self>, k: usize) {
        if neighbours.len() / 2 > k {
            neighbours.select_nth_unstable_by_key(k, Self::key);
            neighbours.truncate(k);
        }
        Self::sort(neighbours);
        neighbours.truncate(k);
    }
}

/// The direction of the motions between a state and its neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From the neighbours to the state.
    In,
    /// From the state to the neighbours.
    Out,
}

impl Direction {
    /// The directions of a space: both are the same in a symmetric one.
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

    /// The same if it is at most `most`; else any number greater than `most`.
    #[inline]
    pub fn distance_within<S: Space>(self, space: &S, state: &S::State, neighbour: &S::State, most: f64) -> f64 {
        let [from, to] = self.ends(state, neighbour);
        space.distance_within(from, to, most)
    }
}

/// What is asked: the neighbours of a state, in a space.
#[derive(Debug)]
pub struct Query<'a, S: Space> {
    /// The space.
    pub space: &'a S,
    /// The state of every vertex, by its number.
    pub states: &'a [S::State],
    /// The direction of the motions to or from neighbours. Only [`Index`] and what is built on it use it: the spaces that the
    /// others serve are symmetric.
    pub direction: Direction,
    /// The state whose neighbours are sought.
    pub from: &'a S::State,
}

impl<S: Space> Clone for Query<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Space> Copy for Query<'_, S> {}

impl<'a, S: Space> Query<'a, S> {
    /// The neighbours from which motions lead to the state.
    pub fn to(space: &'a S, states: &'a [S::State], from: &'a S::State) -> Self {
        Self { space, states, direction: Direction::In, from }
    }
}

/// Which vertices are neighbours of a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Neighbourhood {
    /// As many of the nearest.
    Nearest(usize),
    /// All within this distance.
    Within(f64),
    /// The nearest of those within a distance.
    Both {
        /// The largest number of them.
        k: usize,
        /// The largest distance.
        radius: f64,
    },
}

impl Neighbourhood {
    /// The `k` nearest within a radius, which may be infinite.
    pub fn of(k: usize, radius: f64) -> Self {
        if radius < f64::INFINITY { Self::Both { k, radius } } else { Self::Nearest(k) }
    }

    /// The largest number of neighbours; `usize::MAX` if only the distance is limited.
    pub fn k(self) -> usize {
        match self {
            Self::Nearest(k) | Self::Both { k, .. } => k,
            Self::Within(_) => usize::MAX,
        }
    }

    /// The largest distance; infinite if only the number is limited.
    pub fn radius(self) -> f64 {
        match self {
            Self::Within(radius) | Self::Both { radius, .. } => radius,
            Self::Nearest(_) => f64::INFINITY,
        }
    }

    /// The same with another number of neighbours, if their number is limited.
    #[must_use]
    pub fn with_k(self, k: usize) -> Self {
        match self {
            Self::Nearest(_) => Self::Nearest(k),
            Self::Both { radius, .. } => Self::Both { k, radius },
            Self::Within(_) => self,
        }
    }
}

/// An index of states that grows. It stores no states: a query has the state of every vertex.
pub trait Nearest<S: Space> {
    /// Adds a vertex; numbers must increase.
    fn insert(&mut self, space: &S, vertex: VertexId, state: &S::State);

    /// How many vertices the index holds.
    fn len(&self) -> usize;

    /// Whether the index is empty.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The nearest vertex; `None` if the index is empty.
    fn nearest(&self, query: Query<S>) -> Option<Neighbour> {
        let mut found = Vec::with_capacity(2);
        self.k_nearest(query, 1, &mut found);
        found.pop()
    }

    /// The `k` nearest vertices (all, if there are fewer), nearest first, into `found`. Returns how many vertices were
    /// visited: those whose distance, or a lower bound on it if distances are expensive, was computed.
    fn k_nearest(&self, query: Query<S>, k: usize, found: &mut Vec<Neighbour>) -> usize;

    /// Every vertex no farther than `radius`, nearest first, into `found`. Returns how many vertices were visited.
    fn within(&self, query: Query<S>, radius: f64, found: &mut Vec<Neighbour>) -> usize;

    /// The vertices of a neighbourhood, nearest first, into `found`. Returns how many vertices were visited.
    fn find(&self, query: Query<S>, neighbourhood: Neighbourhood, found: &mut Vec<Neighbour>) -> usize {
        match neighbourhood {
            Neighbourhood::Nearest(k) => self.k_nearest(query, k, found),
            Neighbourhood::Within(radius) => self.within(query, radius, found),
            // No vertex is left out for its number, so the radius alone decides, and prunes more.
            Neighbourhood::Both { k, radius } if k >= query.states.len() => self.within(query, radius, found),
            Neighbourhood::Both { k, radius } => {
                let visited = self.k_nearest(query, k, found);
                found.truncate(found.partition_point(|neighbour| neighbour.distance <= radius));
                visited
            }
        }
    }
}
