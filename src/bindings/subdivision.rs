//! Subdivisions for JavaScript.

use super::clock::{Timed, stepped};
use super::records::record;
use super::types::{JsVerdictOrNull, Status};
use crate::certificate::{self, Certificate};
use crate::problem::Stepped;
use std::cell::RefCell;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// A subdivision of the configurations of an arm of two links, or of a disc, that decides whether a path with more than a given
/// clearance exists; `scenario.certify` makes it. Each `step` divides some cells; how they are divided into steps does not change
/// the result. Cells are only ever appended, and read by cursors.
#[wasm_bindgen]
pub struct Subdivision(RefCell<Timed<certificate::Subdivision>>);

impl Subdivision {
    pub(super) fn new(subdivision: certificate::Subdivision) -> Self {
        Self(RefCell::new(Timed::new(subdivision)))
    }
}

stepped!(Subdivision);

members! { Subdivision(self): wasm_bindgen(getter);
    /// `solved` once it is decided, `exhausted` if it is not after as many cells as it may have.
    status: Status = self.0.borrow().run.status().into();
    /// The answer; null while it is running.
    verdict: JsVerdictOrNull = {
        let verdict = self.0.borrow().run.verdict();
        verdict.map_or(JsValue::NULL, |verdict| JsValue::from_str(verdict.into())).unchecked_into()
    };
    /// The number of cells, divided ones too.
    cellCount: usize = self.0.borrow().run.cell_count();
}

members! { Subdivision(self): wasm_bindgen;
    /// No path keeps more than this clearance, in metres, as far as is proven by now; undefined if nothing is.
    greatestClearance: Option<f64> = self.0.borrow().run.greatest_clearance();
    /// The certificate, the one that the command line prints: what is proven by now.
    certificate: Ts<Certificate> = record(&self.0.borrow().run.certificate());
}

tables! { Subdivision(self, row)
    /// The cells from row `row` (0 to `cellCount`) on, in rows of both coordinates of the centre, half of each side, and 0
    /// (mixed), 1 (free: every configuration keeps more than the clearance) or 2 (blocked: none does). Quarters come after the
    /// cell that they replace. A copy.
    cellsSince: Vec<f64> = self.cellCount() => {
        let subdivision = &self.0.borrow().run;
        let row_of = |([center, half], kind): ([[f64; 2]; 2], certificate::Kind)| {
            [center[0], center[1], half[0], half[1], f64::from(kind as u8)]
        };
        subdivision.cells_since(row).flat_map(row_of).collect()
    };
}
