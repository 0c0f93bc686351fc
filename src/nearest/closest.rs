//! The best candidates of a query so far.

use super::Neighbour;
use crate::graph::VertexId;

/// Up to this many neighbours are kept sorted; of more, the best are picked out now and then.
const SORTED: usize = 16;

/// Keeps the `k` first of the neighbours offered, in the order of [`Neighbour::is_before`].
pub(super) struct Closest<'a> {
    found: &'a mut Vec<Neighbour>,
    k: usize,
    /// No neighbour farther than this is wanted.
    limit: f64,
}

impl<'a> Closest<'a> {
    /// Of all, the `k` closest, at least 1.
    pub fn new(found: &'a mut Vec<Neighbour>, k: usize) -> Self {
        found.clear();
        Self { found, k, limit: f64::INFINITY }
    }

    /// All up to a distance.
    pub fn within(found: &'a mut Vec<Neighbour>, radius: f64) -> Self {
        found.clear();
        Self { found, k: usize::MAX, limit: radius }
    }

    /// No neighbour farther than this is wanted; at this distance ties are decided.
    #[inline(always)]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// Offers a pack of distances; those that are not numbers are passed over.
    #[inline(always)]
    pub fn offer<const L: usize>(&mut self, distances: &[f64; L], vertices: &[VertexId; L]) {
        let mut wanted = 0u32;
        for lane in 0..L {
            wanted |= u32::from(distances[lane] <= self.limit) << lane;
        }
        while wanted != 0 {
            let lane = wanted.trailing_zeros() as usize % L;
            wanted &= wanted - 1;
            self.keep(Neighbour { distance: distances[lane], vertex: vertices[lane] });
        }
    }

    fn keep(&mut self, neighbour: Neighbour) {
        if self.k > SORTED {
            self.found.push(neighbour);
            // Picking k out of twice as many costs a step a candidate.
            if self.found.len() / 2 >= self.k {
                self.pick();
            }
            return;
        }
        if self.found.len() == self.k {
            if !neighbour.is_before(&self.found[self.k - 1]) {
                return;
            }
            self.found.pop();
        }
        let at = self.found.iter().rposition(|kept| kept.is_before(&neighbour)).map_or(0, |i| i + 1);
        self.found.insert(at, neighbour);
        if self.found.len() == self.k {
            self.limit = self.found[self.k - 1].distance;
        }
    }

    /// Keeps the first `k` of more, in no order.
    fn pick(&mut self) {
        self.found.select_nth_unstable_by_key(self.k - 1, Neighbour::key);
        self.found.truncate(self.k);
        self.limit = self.found[self.k - 1].distance;
    }

    /// Sorts what was found.
    pub fn finish(mut self) {
        if self.k > SORTED {
            if self.found.len() > self.k {
                self.pick();
            }
            self.found.sort_unstable_by_key(Neighbour::key);
        }
    }
}
