//! The linear scan: looks at every state. Simple, exact, the oracle of every other index, and fastest for few states.

use super::closest::Closest;
use super::packs::{LANES, Packs};
use super::{Nearest, Neighbour};
use crate::graph::VertexId;
use crate::space::Space;
use std::marker::PhantomData;

/// All states in one list, by columns. A query costs O(n).
#[derive(Debug, Clone)]
pub struct LinearScan<S: Space> {
    packs: Packs,
    len: usize,
    space: PhantomData<S>,
}

impl<S: Space> LinearScan<S> {
    /// An empty index.
    pub fn new() -> Self {
        Self { packs: Packs::default(), len: 0, space: PhantomData }
    }

    fn scan(&self, space: &S, from: &[f64], closest: &mut Closest) {
        for pack in 0..self.packs.len() {
            closest.offer(&self.packs.distances(space, from, pack), self.packs.vertices(pack));
        }
    }
}

impl<S: Space> Default for LinearScan<S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Space> Nearest<S> for LinearScan<S> {
    fn insert(&mut self, space: &S, vertex: VertexId, state: S::State) {
        let (pack, lane) = (self.len / LANES, self.len % LANES);
        if lane == 0 {
            self.packs.dimension = space.dimension();
            self.packs.add();
        }
        self.packs.set(pack, lane, vertex, space.coordinates(&state).iter().copied());
        self.len += 1;
    }

    fn len(&self) -> usize {
        self.len
    }

    fn nearest(&self, space: &S, state: &S::State) -> Option<Neighbour> {
        let mut found = Vec::with_capacity(1);
        self.k_nearest(space, state, 1, &mut found);
        found.pop()
    }

    fn k_nearest(&self, space: &S, state: &S::State, k: usize, found: &mut Vec<Neighbour>) {
        let mut closest = Closest::new(found, k);
        if k > 0 {
            self.scan(space, space.coordinates(state), &mut closest);
        }
        closest.finish();
    }

    fn within(&self, space: &S, state: &S::State, radius: f64, found: &mut Vec<Neighbour>) {
        let mut closest = Closest::within(found, radius);
        self.scan(space, space.coordinates(state), &mut closest);
        closest.finish();
    }
}
