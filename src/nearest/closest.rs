//! The best candidates of a query so far.

use super::Neighbour;
use super::packs::LANES;
use crate::graph::VertexId;
use wide::f64x8;

/// Collects the first `k` of the neighbours offered, in the order of [`Neighbour::is_before`].
pub(super) struct Closest<'a> {
    found: &'a mut Vec<Neighbour>,
    k: usize,
    /// Whether they are always sorted, so that the limit is tight; else the best are selected from time to time.
    is_sorted: bool,
    /// Neighbours farther than this are ignored.
    limit: f64,
}

impl<'a> Closest<'a> {
    /// The `k` closest of those no farther than `limit`, k at least 1; sorted or not, whichever is faster.
    pub fn new(found: &'a mut Vec<Neighbour>, k: usize, limit: f64, is_sorted: bool) -> Self {
        found.clear();
        Self { found, k, is_sorted, limit }
    }

    /// All up to a distance.
    pub fn within(found: &'a mut Vec<Neighbour>, radius: f64) -> Self {
        Self::new(found, usize::MAX, radius, false)
    }

    /// Neighbours farther than this are ignored; at exactly this distance ties are decided.
    #[inline(always)]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// Offers the states of up to eight packs with their distances; NaN distances are ignored.
    #[inline(always)]
    pub fn offer(&mut self, distances: &[[f64; LANES]], vertex: impl Fn(usize, usize) -> VertexId) {
        // First a bit mask of the states within the limit, without unpredictable branches; then those few states.
        let mut wanted = 0u64;
        for (pack, distances) in distances.iter().enumerate() {
            let lanes = f64x8::new(*distances).simd_le(f64x8::splat(self.limit)).to_bitmask();
            wanted |= u64::from(lanes) << (pack * LANES);
        }
        while wanted != 0 {
            let at = wanted.trailing_zeros() as usize;
            wanted &= wanted - 1;
            let (pack, lane) = (at / LANES, at % LANES);
            let neighbour = Neighbour { distance: distances[pack][lane], vertex: vertex(pack, lane) };
            if self.is_sorted {
                self.sort_in(neighbour);
            } else {
                self.found.push(neighbour);
            }
        }
        if !self.is_sorted && self.found.len() / 2 >= self.k {
            self.pick();
        }
    }

    /// Inserts a neighbour among sorted ones.
    fn sort_in(&mut self, neighbour: Neighbour) {
        if self.found.len() == self.k {
            if !neighbour.is_before(&self.found[self.k - 1]) {
                return;
            }
            self.found.pop();
        }
        let at = self.found.iter().rposition(|other| other.is_before(&neighbour)).map_or(0, |i| i + 1);
        self.found.insert(at, neighbour);
        if self.found.len() == self.k {
            self.limit = self.found[self.k - 1].distance;
        }
    }

    /// Selects the first `k`, in no order. O(1) amortized per candidate, as it runs at twice `k`.
    fn pick(&mut self) {
        self.found.select_nth_unstable_by_key(self.k - 1, Neighbour::key);
        self.found.truncate(self.k);
        self.limit = self.found[self.k - 1].distance;
    }

    /// Sorts the neighbours found.
    pub fn finish(mut self) {
        if !self.is_sorted {
            if self.found.len() > self.k {
                self.pick();
            }
            self.found.sort_unstable_by_key(Neighbour::key);
        }
    }
}
