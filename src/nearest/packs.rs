//! States by columns, in packs, so that the distances to a pack are computed by vector instructions.

use crate::graph::VertexId;
use crate::space::{Space, gap};
use wide::f64x8;

/// How many states a pack holds.
pub(super) const LANES: usize = 8;

/// Packs of states and their vertices. An empty lane holds NaN, whose distance to everything is NaN.
#[derive(Debug, Clone, Default)]
pub(super) struct Packs {
    pub dimension: usize,
    /// `dimension` rows per pack.
    rows: Vec<[f64; LANES]>,
    vertices: Vec<[VertexId; LANES]>,
}

impl Packs {
    /// Adds an empty pack.
    pub fn add(&mut self) -> u32 {
        self.rows.resize(self.rows.len() + self.dimension, [f64::NAN; LANES]);
        self.vertices.push([VertexId(u32::MAX); LANES]);
        (self.vertices.len() - 1) as u32
    }

    /// How many packs there are.
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// The rows of a pack, one per coordinate.
    #[inline]
    pub fn rows(&self, pack: usize) -> &[[f64; LANES]] {
        &self.rows[pack * self.dimension..][..self.dimension]
    }

    /// The vertices of a pack.
    #[inline]
    pub fn vertices(&self, pack: usize) -> &[VertexId; LANES] {
        &self.vertices[pack]
    }

    /// Fills a lane.
    pub fn set(&mut self, pack: usize, lane: usize, vertex: VertexId, coordinates: impl Iterator<Item = f64>) {
        let rows = &mut self.rows[pack * self.dimension..][..self.dimension];
        for (row, x) in rows.iter_mut().zip(coordinates) {
            row[lane] = x;
        }
        self.vertices[pack][lane] = vertex;
    }

    /// Empties a pack.
    pub fn clear(&mut self, pack: usize) {
        self.rows[pack * self.dimension..][..self.dimension].fill([f64::NAN; LANES]);
    }

    /// The distances from a state, given by its numbers, to the states of a pack, to the bit those of [`Space::distance`]; not
    /// numbers in empty lanes. O(dimension).
    #[inline(always)]
    pub fn distances<S: Space>(&self, space: &S, from: &[f64], pack: usize) -> [f64; LANES] {
        let rows = self.rows(pack);
        let distances = space.norm(|i| gap(f64x8::splat(from[i]), f64x8::new(rows[i]), f64x8::splat(space.period(i))));
        distances.to_array()
    }
}
