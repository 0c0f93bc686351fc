//! States by columns, in packs, in single precision: half the memory and twice the lanes of a vector. Their distances only
//! select candidates; the exact distances of these follow from the states themselves.
//!
//! # The error bound
//! Let u = 2^-24. On axis i let x and q be the coordinates of a state and of the query relative to the origin (the first state of
//! the index), m the largest |x| in the index, and p the period, or 0 on a line.
//!
//! - Rounding x and q costs at most u |x| and u |q|, and their difference another u (|x| + |q|), but for products of u. So the
//!   gap on a line is wrong by at most 2 u (m + |q|).
//! - On a circle, rounding p and subtracting cost at most u p each, and the lesser of two numbers is no more wrong
//!   than either. So with e = 2^-22 (m + |q| + p), twice as much as needed, every gap is wrong by less than e.
//! - The norm is subadditive and grows with each gap, so errors of the gaps change it by at most E, the norm of all e.
//! - Rounding the weights, the sums, products and roots changes the result by at most 12 u of it in eight dimensions, and the
//!   same in double precision much less: a factor of at most 1 + 2^-20.
//! - A square that underflows is wrong by less than 2^-149, its root by less than 2^-74: 2^-60 is added to every e.
//! - Nothing overflows if m + |q| + p and the weights are at most 2^60, and no weight underflows if it is 0 or at least 2^-60.
//!   Otherwise E is infinite, every state has the distance 0 here, and every state is a candidate.
//!
//! So a distance d and its approximation a satisfy a <= (d + E)(1 + 2^-20) and d <= (a + E)(1 + 2^-20). If k states have been
//! seen whose numbers, exact or not, are at most s, the k nearest have exact distances of at most (s + E)(1 + 2^-20), and
//! approximations below s (1 + 2^-18) + 3 E: see [`Packed::bar`]. The tests compare all results with exact ones.

use super::Query;
use crate::graph::{VertexId, append, make_room};
use crate::space::{MAX_DIMENSION, Space, gap, gap_to_interval};
use wide::{f32x4, f32x8};

/// How many states a pack holds.
pub(super) const LANES: usize = 8;

/// The largest number that is computed with: 2^60.
const MOST: f64 = (1u64 << 60) as f64;

/// The coordinates of a state relative to the origin, in single precision.
pub(super) type Single = [f32; MAX_DIMENSION];

/// Packs of states and their vertices. An empty lane holds NaN, whose distance to everything is NaN.
#[derive(Debug, Clone, Default)]
pub(super) struct Packs {
    pub dimension: usize,
    origin: [f64; MAX_DIMENSION],
    /// The largest distance of a state from the origin, on each axis.
    reach: [f64; MAX_DIMENSION],
    /// The weight of each coordinate in the metric.
    pub weights: [f64; MAX_DIMENSION],
    /// Whether nothing wraps: circles are intervals of plain numbers.
    pub is_unwrapped: bool,
    /// `dimension` rows per pack.
    rows: Vec<[f32; LANES]>,
    vertices: Vec<[VertexId; LANES]>,
}

/// The state of a query, relative to the origin.
pub(super) struct Packed {
    from: Single,
    periods: Single,
    /// Each coordinate twice, then twice negative.
    signed: [f32x4; MAX_DIMENSION],
    /// Three times the bound E on the error of an approximate distance.
    slack: f64,
}

impl Packed {
    /// No state nearer than `distance`, or one of the k nearest if k are at `distance`, exactly or approximately, has a
    /// greater approximate distance.
    #[inline(always)]
    pub fn bar(&self, distance: f64) -> f32 {
        const FACTOR: f64 = 1.0 + 1.0 / (1u64 << 18) as f64;
        ((distance * FACTOR + self.slack) as f32).next_up()
    }

    /// Whether distances in single precision say anything.
    #[inline(always)]
    fn is_usable(&self) -> bool {
        self.slack < f64::INFINITY
    }

    /// Lower bounds on the approximate distances to all states in each of two boxes, given per axis by their two lowest numbers,
    /// then their two highest, negated.
    #[inline(always)]
    pub fn bounds<S: Space>(&self, space: &S, sides: &[[f32; 4]]) -> [f32; 2] {
        if !self.is_usable() {
            return [0.0; 2];
        }
        let norm = space.norm(|i| {
            let outside = f32x4::new(sides[i]) - self.signed[i];
            let [a, b, c, d] = outside.to_array();
            let other = f32x4::new([c, d, a, b]);
            gap_to_interval(outside, other, f32x4::splat(self.periods[i]))
        });
        let [first, second, ..] = norm.to_array();
        [first, second]
    }
}

impl Packs {
    /// Sets up the packs for states of a space, of which this is the first.
    pub fn start<S: Space>(&mut self, space: &S, state: &S::State) {
        self.dimension = space.dimension();
        self.origin[..self.dimension].copy_from_slice(space.coordinates(state));
        for i in 0..self.dimension {
            self.weights[i] = weight(space, i);
        }
    }

    /// The coordinates of a state relative to the origin.
    fn relative<'a, S: Space>(&'a self, space: &S, state: &'a S::State) -> impl Iterator<Item = f64> + 'a {
        space.coordinates(state).iter().zip(&self.origin).map(|(x, origin)| x - origin)
    }

    /// The coordinates of a new state.
    pub fn admit<S: Space>(&mut self, space: &S, state: &S::State) -> Single {
        let mut single = Single::default();
        let mut reach = self.reach;
        for ((x, single), reach) in self.relative(space, state).zip(&mut single).zip(&mut reach) {
            *single = x.clamp(-MOST, MOST) as f32;
            *reach = reach.max(x.abs());
        }
        self.reach = reach;
        single
    }

    /// A query about a state.
    pub fn query<S: Space>(&self, space: &S, state: &S::State) -> Packed {
        const UNIT: f64 = 1.0 / (1u64 << 22) as f64;
        let mut query = Packed {
            from: [0.0; MAX_DIMENSION],
            periods: [0.0; MAX_DIMENSION],
            signed: [f32x4::splat(0.0); MAX_DIMENSION],
            slack: 0.0,
        };
        let mut errors = [0.0; MAX_DIMENSION];
        let mut is_usable = true;
        for (i, x) in self.relative(space, state).enumerate() {
            let single = x.clamp(-MOST, MOST) as f32;
            query.from[i] = single;
            query.signed[i] = f32x4::new([single, single, -single, -single]);
            let period = period(space, i, self.is_unwrapped);
            query.periods[i] = period as f32;
            let size = self.reach[i] + x.abs() + if period < f64::INFINITY { period } else { 0.0 };
            errors[i] = UNIT * size + 1.0 / MOST;
            let weight = self.weights[i];
            is_usable &= size <= MOST && (weight == 0.0 || (1.0 / MOST..=MOST).contains(&weight));
        }
        query.slack = if is_usable { 3.0 * space.norm(|i| errors[i]) } else { f64::INFINITY };
        query
    }

    /// The same without any states.
    pub fn emptied(&self) -> Self {
        let Self { dimension, origin, reach, weights, is_unwrapped, .. } = *self;
        Self { dimension, origin, reach, weights, is_unwrapped, rows: Vec::new(), vertices: Vec::new() }
    }

    /// The vertex and the coordinates in a lane.
    pub fn entry(&self, pack: usize, lane: usize) -> (VertexId, Single) {
        let mut single = Single::default();
        for (x, row) in single.iter_mut().zip(self.rows(pack)) {
            *x = row[lane];
        }
        (self.vertices(pack)[lane], single)
    }

    /// Adds an empty pack.
    pub fn add(&mut self) -> u32 {
        make_room(&mut self.rows, self.dimension);
        self.rows.resize(self.rows.len() + self.dimension, [f32::NAN; LANES]);
        append(&mut self.vertices, [VertexId(u32::MAX); LANES]);
        (self.vertices.len() - 1) as u32
    }

    /// How many packs there are.
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// The rows of a pack, one per coordinate.
    #[inline]
    pub fn rows(&self, pack: usize) -> &[[f32; LANES]] {
        &self.rows[pack * self.dimension..][..self.dimension]
    }

    /// The vertices of a pack.
    #[inline]
    pub fn vertices(&self, pack: usize) -> &[VertexId; LANES] {
        &self.vertices[pack]
    }

    /// Fills a lane.
    pub fn set(&mut self, pack: usize, lane: usize, vertex: VertexId, coordinates: &[f32]) {
        let rows = &mut self.rows[pack * self.dimension..][..self.dimension];
        for (row, &x) in rows.iter_mut().zip(coordinates) {
            row[lane] = x;
        }
        self.vertices[pack][lane] = vertex;
    }

    /// Empties a pack.
    pub fn clear(&mut self, pack: usize) {
        self.rows[pack * self.dimension..][..self.dimension].fill([f32::NAN; LANES]);
    }

    /// The approximate distances from the state of a query to the states of a pack; not numbers in empty lanes. O(dimension).
    #[inline(always)]
    pub fn distances<S: Space>(&self, space: &S, query: &Packed, pack: usize) -> [f32; LANES] {
        let rows = self.rows(pack);
        if !query.is_usable() {
            return rows[0].map(|x| (0.0 * x).abs());
        }
        let splat = f32x8::splat;
        space.norm(|i| gap(splat(query.from[i]), f32x8::new(rows[i]), splat(query.periods[i]))).to_array()
    }
}

/// The weight of a coordinate in the metric.
pub(super) fn weight<S: Space>(space: &S, i: usize) -> f64 {
    space.norm(|j| f64::from(u8::from(i == j)))
}

/// The length of a whole turn of a coordinate; infinite if nothing wraps.
#[inline(always)]
fn period<S: Space>(space: &S, i: usize, is_unwrapped: bool) -> f64 {
    if is_unwrapped { f64::INFINITY } else { space.period(i) }
}

/// What measures a vertex: the number that [`Space::norm`] gives for it and a state in double precision, their distance or a
/// lower bound on it; without wrap-around if nothing wraps.
#[inline(always)]
pub(super) fn measure<S: Space>(query: Query<'_, S>, is_unwrapped: bool) -> impl Fn(VertexId) -> f64 + Copy {
    let Query { space, states, from, .. } = query;
    let from = space.coordinates(from);
    move |vertex| {
        let to = space.coordinates(&states[vertex.index()]);
        space.norm(|i| gap(from[i], to[i], period(space, i, is_unwrapped)))
    }
}
