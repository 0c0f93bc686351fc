//! An index of configurations in JavaScript's hands.

use super::convert::{count, throw};
use crate::run::neighbours::{Answer, Neighbours};
use wasm_bindgen::prelude::*;

/// An index of configurations. Arrays handed out are copies and stay valid.
#[wasm_bindgen]
pub struct RawNeighbours {
    index: Box<dyn Neighbours>,
}

impl RawNeighbours {
    pub(super) fn new(index: Box<dyn Neighbours>) -> Self {
        Self { index }
    }
}

/// How many were visited, and then number and distance of each neighbour.
fn told(answer: &Answer) -> Vec<f64> {
    let mut numbers = Vec::with_capacity(1 + 2 * answer.neighbours.len());
    numbers.push(answer.visited as f64);
    for neighbour in &answer.neighbours {
        numbers.extend([f64::from(neighbour.vertex.0), neighbour.distance]);
    }
    numbers
}

#[wasm_bindgen]
impl RawNeighbours {
    /// Adds rows of configurations.
    pub fn add(&mut self, rows: &[f64]) -> Result<(), JsValue> {
        self.index.add(rows).map_err(throw)
    }

    /// How many configurations there are.
    pub fn size(&self) -> usize {
        self.index.len()
    }

    /// The k nearest to `q`: visited, and number and distance of each.
    pub fn nearest(&self, q: &[f64], k: f64) -> Result<Vec<f64>, JsValue> {
        let k = count(k, "k").map_err(throw)?;
        // More than this machine can count are more than there are, too.
        let k = usize::try_from(k).unwrap_or(usize::MAX);
        self.index.k_nearest(q, k).map(|answer| told(&answer)).map_err(throw)
    }

    /// Those within a radius of `q`, in the same form.
    pub fn within(&self, q: &[f64], radius: f64) -> Result<Vec<f64>, JsValue> {
        self.index.within(q, radius).map(|answer| told(&answer)).map_err(throw)
    }
}
