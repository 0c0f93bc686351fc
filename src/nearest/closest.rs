//! The best candidates of a query so far.

use super::Neighbour;
use super::packs::LANES;
use crate::graph::VertexId;

/// What stands where no candidate does.
const NONE: Neighbour = Neighbour { distance: f64::INFINITY, vertex: VertexId(u32::MAX) };

/// Keeps the `k` first of the neighbours offered, in the order of [`Neighbour::is_before`].
pub(super) struct Closest<'a> {
    /// The candidates; where they are not kept sorted, room for more follows.
    found: &'a mut Vec<Neighbour>,
    /// How many candidates there are, where they are not kept sorted.
    len: usize,
    k: usize,
    /// Whether they are kept sorted, so that the limit is always the tightest; else the best are picked out now and then.
    is_sorted: bool,
    /// No neighbour farther than this is wanted.
    limit: f64,
}

impl<'a> Closest<'a> {
    /// The `k` closest of those no farther than `limit`, k at least 1; kept sorted or not, whichever is faster.
    pub fn new(found: &'a mut Vec<Neighbour>, k: usize, limit: f64, is_sorted: bool) -> Self {
        found.clear();
        Self { found, len: 0, k, is_sorted, limit }
    }

    /// All up to a distance.
    pub fn within(found: &'a mut Vec<Neighbour>, radius: f64) -> Self {
        Self::new(found, usize::MAX, radius, false)
    }

    /// No neighbour farther than this is wanted; at this distance ties are decided.
    #[inline(always)]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// Offers a pack of distances; those that are not numbers are passed over.
    #[inline(always)]
    pub fn offer(&mut self, distances: &[f64; LANES], vertices: &[VertexId; LANES]) {
        if !self.is_sorted {
            // Written whether wanted or not, and overwritten if not: which ones are wanted cannot be foreseen.
            if self.len + LANES > self.found.len() {
                self.make_room();
            }
            let room = &mut self.found[self.len..self.len + LANES];
            let mut wanted = 0;
            for lane in 0..LANES {
                room[wanted % LANES] = Neighbour { distance: distances[lane], vertex: vertices[lane] };
                wanted += usize::from(distances[lane] <= self.limit);
            }
            self.len += wanted;
            return;
        }
        let mut wanted = 0u32;
        for lane in 0..LANES {
            wanted |= u32::from(distances[lane] <= self.limit) << lane;
        }
        while wanted != 0 {
            let lane = wanted.trailing_zeros() as usize % LANES;
            wanted &= wanted - 1;
            self.keep(Neighbour { distance: distances[lane], vertex: vertices[lane] });
        }
    }

    /// Puts a neighbour in its place among those kept sorted.
    fn keep(&mut self, neighbour: Neighbour) {
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

    /// Makes room for a pack of candidates: more of it, up to twice what is kept, then by picking.
    #[cold]
    fn make_room(&mut self) {
        if self.len / 2 >= self.k {
            self.pick();
        }
        let room = (2 * self.len).max(64);
        if self.found.len() < self.len + LANES {
            self.found.resize(room.min(self.k.saturating_mul(2)).max(self.len) + LANES, NONE);
        }
    }

    /// Keeps the first `k` of more, in no order.
    fn pick(&mut self) {
        self.found[..self.len].select_nth_unstable_by_key(self.k - 1, Neighbour::key);
        self.len = self.k;
        self.limit = self.found[self.k - 1].distance;
    }

    /// Leaves what was found, sorted.
    pub fn finish(mut self) {
        if !self.is_sorted {
            if self.len > self.k {
                self.pick();
            }
            self.found.truncate(self.len);
            self.found.sort_unstable_by_key(Neighbour::key);
        }
    }
}
