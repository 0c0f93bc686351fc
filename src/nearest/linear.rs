//! The linear scan: computes the distance to every state. Exact, and the fastest for few states.

use super::closest::{Closest, Collector};
use super::packs::{LANES, Packs, Query, measure};
use super::{Nearest, Neighbour};
use crate::graph::VertexId;
use crate::space::Space;

/// Up to this many neighbours stay sorted; a guess does not pay for so few.
const SORTED: usize = 4;

/// Among up to this many states the nearest is found by exact distances alone.
const FEW: usize = 32;

/// How many packs are scanned at a time.
const BLOCK: usize = 64 / LANES;

/// The number of distances that a guess is based on.
const SAMPLE: usize = 64;

/// All states in one list, stored by columns. A query costs O(n).
#[derive(Debug, Clone, Default)]
pub struct LinearScan {
    packs: Packs,
    len: usize,
}

impl LinearScan {
    /// The nearest of a few states; `None` if there are none, or too many for exact distances alone.
    pub(super) fn nearest_of_few<S: Space>(
        &self,
        space: &S,
        states: &[S::State],
        from: &S::State,
    ) -> Option<Neighbour> {
        if self.len > FEW {
            return None;
        }
        let measure = measure(space, states, from);
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

    fn scan<S: Space>(&self, space: &S, query: &Query, mut closest: Closest<impl Fn(VertexId) -> f64>) {
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

    /// A distance within which probably at least `k` states lie, and not many more: a quantile of the distances to the first
    /// states. Infinite if there are too few states for a guess to pay.
    fn guess<S: Space>(&self, space: &S, query: &Query, k: usize) -> f64 {
        if k <= SORTED || self.len < 4 * SAMPLE || self.len / 8 < k {
            return f64::INFINITY;
        }
        let mut sample = [0.0; SAMPLE];
        for (pack, sample) in sample.chunks_exact_mut(LANES).enumerate() {
            sample.copy_from_slice(&self.packs.distances(space, query, pack));
        }
        // The expected number of the k nearest among the sample, plus two and a half standard deviations.
        let mean = (k * SAMPLE) as f64 / self.len as f64;
        let rank = (mean + 2.5 * mean.sqrt()) as usize + 1;
        let rank = rank.min(SAMPLE - 1);
        // Insertion sort of the `rank + 1` smallest.
        for at in 1..SAMPLE {
            let value = sample[at];
            let mut to = at;
            if at > rank {
                if value >= sample[rank] {
                    continue;
                }
                to = rank;
            }
            while to > 0 && sample[to - 1] > value {
                sample[to] = sample[to - 1];
                to -= 1;
            }
            sample[to] = value;
        }
        f64::from(sample[rank])
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

    fn k_nearest(
        &self,
        space: &S,
        states: &[S::State],
        from: &S::State,
        k: usize,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        found.clear();
        if k == 0 {
            return 0;
        }
        let query = self.packs.query(space, from);
        let measure = measure(space, states, from);
        let guess = self.guess(space, &query, k);
        self.scan(space, &query, Closest::new(&query, found, k, guess, k <= SORTED, measure));
        if found.len() < k.min(self.len) {
            self.scan(space, &query, Closest::new(&query, found, k, f64::INFINITY, k <= SORTED, measure));
        }
        self.len
    }

    fn within(
        &self,
        space: &S,
        states: &[S::State],
        from: &S::State,
        radius: f64,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        let query = self.packs.query(space, from);
        let measure = measure(space, states, from);
        self.scan(space, &query, Closest::new(&query, found, usize::MAX, radius, false, measure));
        self.len
    }
}
