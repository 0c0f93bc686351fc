//! A drive for JavaScript.

use super::arguments::{choice, count, records};
use super::records::{DriveState, record};
use super::types::{JsKey, JsNumber, KeyPresses};
use crate::Error;
use crate::driving::{self, Key, Press};
use strum::VariantArray;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// A car that starts at rest and is driven by keys; `scenario.drive` makes it. Time passes in steps of fixed length
/// (`stepSeconds`), so the same keys at the same steps lead to the same pose, bit for bit. Each step is an exact arc that is
/// proven free before it is made; if it is not, the car stops and reports the obstruction.
#[wasm_bindgen]
pub struct Drive(pub(super) driving::Drive);

#[wasm_bindgen]
impl Drive {
    /// Presses a key, and records it: `faster` and `slower` change v by 0.1 m/s, `left` and `right` turn the front wheels by
    /// pi / 12 to that side, within the limits of the car; `keep` changes nothing.
    /// @throws {PlanariumError} `out-of-range` for another word; `too-large` after a million keys
    pub fn press(&mut self, key: &JsKey) -> Result<(), Error> {
        let words: Vec<&str> = Key::VARIANTS.iter().map(|&key| key.into()).collect();
        self.0.press(Key::VARIANTS[choice(key, "key", &words)?])
    }

    /// Advances by `n` steps, at most 1,000,000. A step that cannot be proven free is not made: v becomes 0, and `blocked` says
    /// why.
    /// @throws {PlanariumError} `out-of-range`; `too-large` after a million steps in motion: start another drive
    pub fn tick(&mut self, n: &JsNumber) -> Result<Ts<DriveState>, Error> {
        self.0.tick(count(n, "n")?)?;
        Ok(self.state())
    }

    /// Restarts and drives as recorded until `steps` steps are made: the same bits again. Keys are in the order of their steps;
    /// later ones are not pressed.
    /// @throws {PlanariumError} `wrong-type`, `out-of-range` with a pointer below `/record`, or of `steps`
    pub fn replay(&mut self, record: &KeyPresses, steps: &JsNumber) -> Result<Ts<DriveState>, Error> {
        let record: Vec<Press> = records(record, "record")?;
        self.0.replay(&record, count(steps, "steps")?)?;
        Ok(self.state())
    }
}

members! { Drive(self): wasm_bindgen(getter);
    /// The pose, the control, and what stopped the car.
    state: Ts<DriveState> = record(&DriveState::from(&self.0));
    /// The length of a step, in seconds: the `integration_step` of the scenario's car.
    stepSeconds: f64 = self.0.step();
}

members! { Drive(self): wasm_bindgen;
    /// The keys pressed so far, which `replay` takes.
    record: Vec<Ts<Press>> = self.0.record().iter().map(record).collect();
}

tables! { Drive(self, row)
    /// The trace from row `row` (0 to `state.traceCount`) on: the start, and the pose after each step that moved the car, in rows
    /// of x, y, theta. A copy.
    traceSince: Vec<f64> = self.0.trace().len() => self.0.trace()[row..].concat();
}
