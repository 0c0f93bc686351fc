//! A drive in JavaScript's hands.

use super::convert::{count, cursor, throw};
use crate::driving::{Drive, Key, Press};
use crate::error::{Code, Error};
use crate::problem::Touched;
use wasm_bindgen::prelude::*;

/// A car under a driver's hand. Arrays handed out are copies and stay valid.
#[wasm_bindgen]
pub struct RawDrive {
    drive: Drive,
}

impl RawDrive {
    pub(super) fn new(drive: Drive) -> Self {
        Self { drive }
    }
}

/// What stopped a car: an obstacle by its number, -1 for the bounds, -2 where it would only have come too near; -3 where it was
/// not stopped.
pub(super) fn told(blocked: Option<Option<Touched>>) -> f64 {
    match blocked {
        Some(Some(Touched::Obstacle(i))) => i as f64,
        Some(Some(Touched::Bounds)) => -1.0,
        Some(None) => -2.0,
        None => -3.0,
    }
}

#[wasm_bindgen]
impl RawDrive {
    /// Presses the key of that number.
    pub fn press(&mut self, key: u8) -> Result<(), JsValue> {
        self.drive.press(key_of(f64::from(key), "/key").map_err(throw)?).map_err(throw)
    }

    /// Lets steps go by.
    pub fn tick(&mut self, n: f64) -> Result<(), JsValue> {
        count(n, "n").and_then(|n| self.drive.tick(n)).map_err(throw)
    }

    /// How things stand: x, y, theta, v, phi, steps, what stopped it, rows of the trace, keys recorded.
    pub fn state(&self) -> Vec<f64> {
        let [x, y, theta] = self.drive.pose();
        let control = self.drive.control();
        let (rows, keys) = (self.drive.trace().len() as f64, self.drive.record().len() as f64);
        let steps = self.drive.steps() as f64;
        vec![x, y, theta, control.speed, control.steering, steps, told(self.drive.blocked()), rows, keys]
    }

    /// The length of a step, in seconds.
    pub fn step(&self) -> f64 {
        self.drive.step()
    }

    /// The trace from row `row` on, x, y, theta each.
    pub fn trace_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        let trace = self.drive.trace();
        Ok(trace[cursor(row, trace.len())?..].concat())
    }

    /// The keys pressed: rows of step and number of the key.
    pub fn record(&self) -> Vec<f64> {
        self.drive.record().iter().flat_map(|press| [press.step as f64, f64::from(press.key as u8)]).collect()
    }

    /// Begins anew and drives as recorded, in rows of step and number of the key, until `steps` have gone by.
    pub fn replay(&mut self, record: &[f64], steps: f64) -> Result<(), JsValue> {
        let press = |(i, row): (usize, &[f64])| {
            let key = key_of(row[1], &format!("/record/{i}/key"))?;
            Ok(Press { step: count(row[0], "step").map_err(|error| error.under(&format!("/record/{i}")))?, key })
        };
        let record: Result<Vec<Press>, Error> = record.chunks_exact(2).enumerate().map(press).collect();
        let record = record.map_err(throw)?;
        count(steps, "steps").and_then(|steps| self.drive.replay(&record, steps)).map_err(throw)
    }
}

fn key_of(number: f64, pointer: &str) -> Result<Key, Error> {
    let named = Key::from_repr(number as u8).filter(|&key| f64::from(key as u8) == number);
    named.ok_or_else(|| Error::new(Code::OutOfRange, pointer, "there is no such key"))
}
