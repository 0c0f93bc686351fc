//! An index of configurations for JavaScript.

use super::arguments::{configurations, not_negative, row, size};
use super::records::{NeighboursFound, record};
use super::types::{Configurations, JsConfiguration, JsNumber};
use crate::Error;
use crate::run::neighbours;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// An index of configurations, which finds the nearest of many; `scenario.neighbours` makes it. Configurations are
/// numbered from 0 in the order in which they are added; neighbours come nearest first, ties by number. A linear scan
/// and a kd-tree give equal results, bit for bit, in every metric; a forest may miss some of the nearest, and a kd-tree
/// without wrap-around misses those across pi.
#[wasm_bindgen]
pub struct Neighbours(pub(super) Box<dyn neighbours::Neighbours>);

#[wasm_bindgen]
impl Neighbours {
    /// Adds configurations, in one array one after the other or as an array of arrays: all of them, or none if one is refused.
    /// @throws {PlanariumError} `wrong-dimension`; `not-finite`, `out-of-range` (also outside joint limits) with a pointer of row
    /// and number, such as `/rows/2/0`; `too-large` beyond 1,000,000 configurations, or in a forest 10,000,000 divided by its
    /// trees
    pub fn add(&mut self, rows: &Configurations) -> Result<(), Error> {
        self.0.add(&configurations(rows, self.0.dimension(), "rows")?)
    }

    /// The `k` configurations nearest to `q`; all, if there are fewer.
    /// @throws {PlanariumError} `wrong-dimension`, `not-finite`, `out-of-range`
    pub fn nearest(&self, q: &JsConfiguration, k: &JsNumber) -> Result<Ts<NeighboursFound>, Error> {
        let q = row(q, self.0.dimension(), "q")?;
        self.0.k_nearest(&q, size(k, "k")?).map(|found| record(&NeighboursFound::from(found)))
    }

    /// The configurations no farther from `q` than `radius`, at least 0, in the unit of the metric; a forest finds those among
    /// its candidates.
    /// @throws {PlanariumError} `wrong-dimension`, `not-finite`, `out-of-range`
    pub fn within(&self, q: &JsConfiguration, radius: &JsNumber) -> Result<Ts<NeighboursFound>, Error> {
        let q = row(q, self.0.dimension(), "q")?;
        self.0.within(&q, not_negative(radius, "radius")?).map(|found| record(&NeighboursFound::from(found)))
    }
}

members! { Neighbours(self): wasm_bindgen(getter);
    /// The number of configurations.
    size: usize = self.0.len();
}
