//! The best candidates of a query so far.

use super::Neighbour;
use super::packs::{LANES, Query};
use crate::graph::VertexId;
use wide::f32x8;

/// How many candidates that are as near as the k-th may be added to sorted ones before they are measured.
const TIES: usize = 16;

/// Collects the first `k` of the neighbours offered, in the order of [`Neighbour::is_before`]. Until [`finish`](Self::finish),
/// distances are approximate, and candidates that cannot be told from the k-th are stored as well.
pub(super) struct Closest<'a, M> {
    query: &'a Query,
    found: &'a mut Vec<Neighbour>,
    k: usize,
    /// Neighbours farther than this are ignored.
    limit: f64,
    /// Whether candidates are always sorted, so that the bar is tight; else the best are selected from time to time.
    is_sorted: bool,
    /// Approximate distances greater than this are ignored.
    bar: f32,
    /// The exact distance of a vertex.
    measure: M,
}

impl<'a, M: Fn(VertexId) -> f64> Closest<'a, M> {
    /// The `k` closest of those no farther than `limit`, k at least 1; sorted or not, whichever is faster.
    pub fn new(
        query: &'a Query,
        found: &'a mut Vec<Neighbour>,
        k: usize,
        limit: f64,
        is_sorted: bool,
        measure: M,
    ) -> Self {
        found.clear();
        Self { query, found, k, limit, is_sorted, bar: query.bar(limit), measure }
    }

    /// Vertices whose approximate distance is greater are ignored.
    #[inline(always)]
    pub fn bar(&self) -> f32 {
        self.bar
    }

    /// Offers the states of up to eight packs with their approximate distances; NaN distances are ignored.
    #[inline(always)]
    pub fn offer(&mut self, distances: &[[f32; LANES]], vertex: impl Fn(usize, usize) -> VertexId) {
        // First a bit mask of the states up to the bar, without unpredictable branches; then those few states.
        let mut wanted = 0u64;
        for (pack, distances) in distances.iter().enumerate() {
            let lanes = f32x8::new(*distances).simd_le(f32x8::splat(self.bar)).to_bitmask();
            wanted |= u64::from(lanes) << (pack * LANES);
        }
        while wanted != 0 {
            let at = wanted.trailing_zeros() as usize;
            wanted &= wanted - 1;
            let (pack, lane) = (at / LANES, at % LANES);
            // The gap of two states a whole turn apart may round to less than 0.
            let distance = distances[pack][lane].max(0.0);
            if !self.is_sorted {
                self.found.push(Neighbour { distance: f64::from(distance), vertex: vertex(pack, lane) });
            } else if distance <= self.bar {
                self.sort_in(Neighbour { distance: f64::from(distance), vertex: vertex(pack, lane) });
            }
        }
        if !self.is_sorted && self.found.len() / 2 >= self.k {
            self.pick();
            if self.found.len() - self.k > self.k / 2 {
                self.measure();
            }
        }
    }

    /// Inserts a candidate among sorted ones.
    fn sort_in(&mut self, candidate: Neighbour) {
        let at = self.found.iter().rposition(|other| other.distance <= candidate.distance).map_or(0, |i| i + 1);
        self.found.insert(at, candidate);
        if self.found.len() < self.k {
            return;
        }
        self.lower_bar();
        let bar = f64::from(self.bar);
        while self.found.last().is_some_and(|last| last.distance > bar) {
            self.found.pop();
        }
        if self.found.len() > self.k + TIES {
            self.measure();
        }
    }

    /// Lowers the bar to that of the k-th candidate.
    fn lower_bar(&mut self) {
        let bar = self.query.bar(self.found[self.k - 1].distance);
        if bar < self.bar {
            self.bar = bar;
        }
    }

    /// Selects those that may be among the first `k`, in no order. O(1) amortized per candidate, as it runs at twice `k`.
    fn pick(&mut self) {
        self.found.select_nth_unstable_by_key(self.k - 1, |candidate| candidate.distance.to_bits());
        self.lower_bar();
        let bar = f64::from(self.bar);
        self.found.retain(|candidate| candidate.distance <= bar);
    }

    /// Selects the first `k` by their exact distances.
    fn measure(&mut self) {
        self.found.iter_mut().for_each(|candidate| candidate.distance = (self.measure)(candidate.vertex));
        self.found.retain(|candidate| candidate.distance <= self.limit);
        Neighbour::first(self.found, self.k);
        if self.found.len() == self.k {
            self.lower_bar();
        }
    }

    /// Computes the exact distances of the neighbours and sorts them.
    pub fn finish(mut self) {
        if !self.is_sorted && self.found.len() > self.k {
            self.pick();
        }
        self.measure();
    }
}
