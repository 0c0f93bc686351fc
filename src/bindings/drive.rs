//! A drive for JavaScript.

use super::convert::{count, cursor};
use crate::driving::{Drive, Key, Press};
use crate::error::{Code, Error};
use crate::problem::Touched;
use wasm_bindgen::prelude::*;

/// A car that is driven by keys.
#[wasm_bindgen]
pub struct RawDrive(pub(super) Drive);

/// The obstacle that stopped a car: its index, -1 for the bounds, -2 if the car would only have come too near; -3 if it was not
/// stopped.
pub(super) fn obstruction(blocked: Option<Option<Touched>>) -> f64 {
    match blocked {
        Some(Some(Touched::Obstacle(i))) => i as f64,
        Some(Some(Touched::Bounds)) => -1.0,
        Some(None) => -2.0,
        None => -3.0,
    }
}

fn key_of(number: f64, pointer: &str) -> Result<Key, Error> {
    let named = Key::from_repr(number as u8).filter(|&key| f64::from(key as u8) == number);
    named.ok_or_else(|| Error::new(Code::OutOfRange, pointer, "there is no such key"))
}

#[wasm_bindgen]
impl RawDrive {
    /// Presses the key of that number.
    pub fn press(&mut self, key: u8) -> Result<(), Error> {
        self.0.press(key_of(f64::from(key), "/key")?)
    }

    /// Advances by `n` steps.
    pub fn tick(&mut self, n: f64) -> Result<(), Error> {
        self.0.tick(count(n, "n")?)
    }

    /// The trace from row `row` on: x, y, theta each.
    pub fn trace_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        let trace = self.0.trace();
        Ok(trace[cursor(row, trace.len())?..].concat())
    }

    /// Restarts and drives as recorded, in rows of step and number of the key, until `steps` have passed.
    pub fn replay(&mut self, record: &[f64], steps: f64) -> Result<(), Error> {
        let press = |(i, row): (usize, &[f64])| {
            let key = key_of(row[1], &format!("/record/{i}/key"))?;
            Ok(Press { step: count(row[0], "step").map_err(|error| error.under(&format!("/record/{i}")))?, key })
        };
        let record: Result<Vec<Press>, Error> = record.chunks_exact(2).enumerate().map(press).collect();
        let record = record?;
        self.0.replay(&record, count(steps, "steps")?)
    }
}

getters! { RawDrive(self)
    /// x, y, theta, v, phi, steps, the obstruction, rows of the trace, keys recorded.
    state: Vec<f64> = {
        let ([x, y, theta], control) = (self.0.pose(), self.0.control());
        let [rows, keys] = [self.0.trace().len(), self.0.record().len()].map(|count| count as f64);
        let steps = self.0.steps() as f64;
        vec![x, y, theta, control.speed, control.steering, steps, obstruction(self.0.blocked()), rows, keys]
    };
    /// The length of a step, in seconds.
    step: f64 = self.0.step();
    /// The keys pressed: rows of step and number of the key.
    record: Vec<f64> = self.0.record().iter().flat_map(|press| [press.step as f64, f64::from(press.key as u8)]).collect();
}
