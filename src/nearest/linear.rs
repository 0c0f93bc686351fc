//! The linear scan: computes the distance to every state. Exact, and the fastest for few states.

use super::closest::{Closest, Collector, guess};
use super::packs::{LANES, Packed, Packs, measure};
use super::{Nearest, Neighbour, Query};
use crate::graph::VertexId;
use crate::space::Space;

/// Up to this many neighbours stay sorted; a guess does not pay for so few.
const SORTED: usize = 4;

/// Among up to this many states the nearest is found by exact distances alone.
const FEW: usize = 16;

/// How many packs are scanned at a time.
const BLOCK: usize = 64 / LANES;

/// All states in one list, stored by columns. A query costs O(n).
#[derive(Debug, Clone, Default)]
pub struct LinearScan {
    packs: Packs,
    len: usize,
}

impl LinearScan {
    /// The nearest of a few states; `None` if there are none, or too many for exact distances alone.
    pub(super) fn nearest_of_few<S: Space>(&self, query: Query<S>) -> Option<Neighbour> {
        if self.len > FEW {
            return None;
        }
        let measure = measure(query, false);
        let mut nearest: Option<Neighbour> = None;
        for at in 0..self.len {
            let vertex = self.packs.vertices(at / LANES)[at % LANES];
            let distance = measure(vertex);
            // Vertices come in the order of their numbers.
            if nearest.is_none_or(|nearest| distance < nearest.distance) {
                nearest = Some(Neighbour { distance, vertex });
            }
        }
        nearest
    }

    /// The states, to be copied into another index.
    pub(super) fn packs(&self) -> &Packs {
        &self.packs
    }

    fn scan<S: Space>(&self, space: &S, query: &Packed, mut closest: Closest<impl Fn(VertexId) -> f64>) {
        // First the distances to a block of packs, without branches, then the selection: two loops are faster than one.
        let mut distances = [[0.0; LANES]; BLOCK];
        let packs = self.packs.len();
        for first in (0..packs).step_by(BLOCK) {
            let block = first..packs.min(first + BLOCK);
            for (distances, pack) in distances.iter_mut().zip(block.clone()) {
                *distances = self.packs.distances(space, query, pack);
            }
            closest.offer(&distances[..block.len()], |pack, lane| self.packs.vertices(first + pack)[lane]);
        }
        closest.finish();
    }
}

impl<S: Space> Nearest<S> for LinearScan {
    fn insert(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        let (pack, at) = (self.len / LANES, self.len % LANES);
        if self.len == 0 {
            self.packs.start(space, state);
        }
        if at == 0 {
            self.packs.add();
        }
        let single = self.packs.admit(space, state);
        self.packs.set(pack, at, vertex, &single);
        self.len += 1;
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
        let measure = measure(query, false);
        self.scan(query.space, &packed, Closest::new(&packed, found, k, guess, k <= SORTED, measure));
        if guess < f64::INFINITY && found.len() < k.min(self.len) {
            self.scan(query.space, &packed, Closest::new(&packed, found, k, f64::INFINITY, k <= SORTED, measure));
        }
        self.len
    }

    fn within(&self, query: Query<S>, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        let packed = self.packs.query(query.space, query.from);
        let measure = measure(query, false);
        self.scan(query.space, &packed, Closest::all(&packed, found, radius, true, measure));
        self.len
    }
}
