//! An index of configurations for JavaScript.

use super::convert::size;
use crate::Error;
use crate::run::neighbours::{NearestResult, Neighbours};
use wasm_bindgen::prelude::*;

/// An index of configurations.
#[wasm_bindgen]
pub struct RawNeighbours(pub(super) Box<dyn Neighbours>);

/// The number of visited configurations, then index and distance of each neighbour.
fn numbers(result: NearestResult) -> Vec<f64> {
    let rows = result.neighbours.iter().flat_map(|neighbour| [f64::from(neighbour.vertex.0), neighbour.distance]);
    std::iter::once(result.visited as f64).chain(rows).collect()
}

#[wasm_bindgen]
impl RawNeighbours {
    /// Adds rows of configurations.
    pub fn add(&mut self, rows: &[f64]) -> Result<(), Error> {
        self.0.add(rows)
    }

    pub fn size(&self) -> usize {
        self.0.len()
    }

    /// The k nearest to `q`: visited, then index and distance of each.
    pub fn nearest(&self, q: &[f64], k: f64) -> Result<Vec<f64>, Error> {
        self.0.k_nearest(q, size(k, "k")?).map(numbers)
    }

    /// Those within a radius of `q`, in the same form.
    pub fn within(&self, q: &[f64], radius: f64) -> Result<Vec<f64>, Error> {
        self.0.within(q, radius).map(numbers)
    }
}
