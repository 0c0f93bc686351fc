//! The best candidates of a query so far.

use super::Neighbour;
use super::packs::{LANES, Packed};
use crate::graph::VertexId;
use wide::f32x8;

/// How many candidates that are as near as the k-th may be added to sorted ones before they are measured.
const TIES: usize = 16;

/// What a search of the tree offers states to.
pub(super) trait Collector {
    /// States whose approximate distance is greater are ignored.
    fn bar(&self) -> f32;

    /// Offers the states of up to eight packs with their approximate distances; NaN distances are ignored.
    fn offer(&mut self, distances: &[[f32; LANES]], vertex: impl Fn(usize, usize) -> VertexId);

    /// Computes what is left to compute, and sorts what was found if that is wanted.
    fn finish(self);
}

/// A guess of the distance within which the `k` nearest lie, from what another query found: about as far, and a quarter. Infinite
/// if that query found fewer, or if there are so few to find that a guess does not pay.
pub(super) fn guess(found: &[Neighbour], k: usize, few: usize) -> f64 {
    match found.last() {
        // A roadmap removes the state itself from what it finds.
        Some(last) if k > few && found.len() + 1 >= k => 1.25 * last.distance,
        _ => f64::INFINITY,
    }
}

/// A bit for each state of up to eight packs: whether its distance is at most the bar. Without unpredictable branches.
#[inline(always)]
fn up_to(bar: f32, distances: &[[f32; LANES]]) -> u64 {
    let lanes = |pack: &[f32; LANES]| u64::from(f32x8::new(*pack).simd_le(f32x8::splat(bar)).to_bitmask());
    distances.iter().enumerate().fold(0, |wanted, (pack, distances)| wanted | lanes(distances) << (pack * LANES))
}

/// Collects the first `k` of the neighbours offered, in the order of [`Neighbour::is_before`]. Until [`finish`](Self::finish),
/// distances are approximate, and candidates that may be as near as the k-th are stored as well.
pub(super) struct Closest<'a, M> {
    query: &'a Packed,
    found: &'a mut Vec<Neighbour>,
    k: usize,
    /// Neighbours farther than this are ignored.
    limit: f64,
    /// Whether candidates are always sorted, so that the bar is tight; else the best are selected from time to time.
    is_sorted: bool,
    /// Whether what is found is sorted at the end.
    sorts_result: bool,
    /// Approximate distances greater than this are ignored.
    bar: f32,
    /// The exact distance of a vertex.
    measure: M,
}

impl<'a, M: Fn(VertexId) -> f64> Closest<'a, M> {
    /// The `k` closest of those no farther than `limit`, k at least 1; sorted or not, whichever is faster.
    pub fn new(
        query: &'a Packed,
        found: &'a mut Vec<Neighbour>,
        k: usize,
        limit: f64,
        is_sorted: bool,
        measure: M,
    ) -> Self {
        found.clear();
        Self { query, found, k, limit, is_sorted, sorts_result: true, bar: query.bar(limit), measure }
    }

    /// All that are no farther than `limit`; sorted at the end, or in any order.
    pub fn all(query: &'a Packed, found: &'a mut Vec<Neighbour>, limit: f64, sorts_result: bool, measure: M) -> Self {
        Self { sorts_result, ..Self::new(query, found, usize::MAX, limit, false, measure) }
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

    /// Lowers the bar to that of the nearest state offered, if only one is wanted.
    #[inline(always)]
    fn lower_to_nearest(&mut self, distances: &[[f32; LANES]]) {
        let mut least = f32x8::splat(self.bar);
        for &pack in distances {
            let pack = f32x8::new(pack);
            least = pack.simd_lt(least).select(pack, least);
        }
        let least = least.to_array().into_iter().fold(self.bar, f32::min);
        if least < self.bar {
            self.bar = self.bar.min(self.query.bar(f64::from(least)));
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
        // Not a closure, of which each type of measure would have its own.
        fn distance(candidate: &Neighbour) -> u64 {
            candidate.distance.to_bits()
        }
        self.found.select_nth_unstable_by_key(self.k - 1, distance);
        self.lower_bar();
        let bar = f64::from(self.bar);
        self.found.retain(|candidate| candidate.distance <= bar);
    }

    /// Selects the first `k` by their exact distances.
    fn measure(&mut self) {
        self.found.iter_mut().for_each(|candidate| candidate.distance = (self.measure)(candidate.vertex));
        self.found.retain(|candidate| candidate.distance <= self.limit);
        if self.sorts_result {
            Neighbour::first(self.found, self.k);
        }
        if self.found.len() == self.k {
            self.lower_bar();
        }
    }
}

impl<M: Fn(VertexId) -> f64> Collector for Closest<'_, M> {
    #[inline(always)]
    fn bar(&self) -> f32 {
        self.bar
    }

    #[inline(always)]
    fn offer(&mut self, distances: &[[f32; LANES]], vertex: impl Fn(usize, usize) -> VertexId) {
        if self.k == 1 {
            self.lower_to_nearest(distances);
        }
        let mut wanted = up_to(self.bar, distances);
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

    fn finish(mut self) {
        if !self.is_sorted && self.found.len() > self.k {
            self.pick();
        }
        self.measure();
    }
}

/// Collects the first `k` of the neighbours offered, in the order of [`Neighbour::is_before`], if what is offered are lower
/// bounds on distances: those up to the worst distance found are measured at once.
pub(super) struct Ranked<'a, M> {
    query: &'a Packed,
    found: &'a mut Vec<Neighbour>,
    k: usize,
    bar: f32,
    /// The distance of a vertex if it is at most a number; else any number greater than that.
    distance: M,
    /// Vertices that are ignored, in order: they have been measured.
    measured: Vec<VertexId>,
}

impl<'a, M: Fn(VertexId, f64) -> f64> Ranked<'a, M> {
    /// The first `k`, at least 1, of candidates with their lower bounds, the lowest first, and of what is offered later.
    pub fn new(
        query: &'a Packed,
        candidates: &[Neighbour],
        found: &'a mut Vec<Neighbour>,
        k: usize,
        distance: M,
    ) -> Self {
        found.clear();
        let mut measured: Vec<VertexId> = candidates.iter().map(|candidate| candidate.vertex).collect();
        measured.sort_unstable();
        let mut ranked = Self { query, found, k, bar: f32::INFINITY, distance, measured };
        for candidate in candidates {
            if candidate.distance > ranked.worst() {
                // So is every other.
                ranked.bar = f32::NEG_INFINITY;
                break;
            }
            ranked.rank(candidate.vertex);
        }
        ranked
    }

    /// The distance of the k-th neighbour; infinity if there are fewer.
    fn worst(&self) -> f64 {
        self.found.get(self.k - 1).map_or(f64::INFINITY, |worst| worst.distance)
    }

    /// Measures a vertex and inserts it among the first `k` if it is one of them.
    fn rank(&mut self, vertex: VertexId) {
        let neighbour = Neighbour { distance: (self.distance)(vertex, self.worst()), vertex };
        if self.found.len() == self.k {
            if !neighbour.is_before(&self.found[self.k - 1]) {
                return;
            }
            self.found.pop();
        }
        let at = self.found.iter().rposition(|other| other.is_before(&neighbour)).map_or(0, |i| i + 1);
        self.found.insert(at, neighbour);
        self.bar = self.query.bar(self.worst());
    }
}

impl<M: Fn(VertexId, f64) -> f64> Collector for Ranked<'_, M> {
    #[inline(always)]
    fn bar(&self) -> f32 {
        self.bar
    }

    fn offer(&mut self, distances: &[[f32; LANES]], vertex: impl Fn(usize, usize) -> VertexId) {
        let mut wanted = up_to(self.bar, distances);
        while wanted != 0 {
            let at = wanted.trailing_zeros() as usize;
            wanted &= wanted - 1;
            let (pack, lane) = (at / LANES, at % LANES);
            let vertex = vertex(pack, lane);
            if distances[pack][lane] <= self.bar && self.measured.binary_search(&vertex).is_err() {
                self.rank(vertex);
            }
        }
    }

    fn finish(self) {}
}
