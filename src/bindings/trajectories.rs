//! Many trajectories in JavaScript's hands.

use super::convert::{count, cursor, record, settings, throw};
use crate::problem::Status;
use crate::trajectories::{self, Trajectories};
use wasm_bindgen::prelude::*;

/// Trajectories that do not cross, stepped from outside. Arrays handed out are copies and stay valid.
#[wasm_bindgen]
pub struct RawTrajectories {
    trajectories: Trajectories,
}

#[wasm_bindgen]
impl RawTrajectories {
    /// Begins, with options.
    pub fn begin(options: JsValue) -> Result<RawTrajectories, JsValue> {
        let begun = settings(options).and_then(|(given, seed)| Trajectories::new(&given, seed));
        begun.map(|trajectories| Self { trajectories }).map_err(throw)
    }

    /// Does at most `n` iterations.
    pub fn advance(&mut self, n: f64) -> Result<(), JsValue> {
        self.trajectories.step(count(n, "n").map_err(throw)?);
        Ok(())
    }

    /// 0 while it goes on, 1 once all are accepted, 2 where the iterations are spent before.
    pub fn status(&self) -> u8 {
        match self.trajectories.status() {
            Status::Running => 0,
            Status::Solved => 1,
            Status::Exhausted => 2,
        }
    }

    /// Iterations made, how many are accepted, how many refused.
    pub fn counts(&self) -> Vec<f64> {
        let done = &self.trajectories;
        vec![done.tally().iterations as f64, done.accepted_count() as f64, done.refused_count() as f64]
    }

    /// The accepted ones from row `row` on, six numbers each.
    pub fn accepted_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        let from = cursor(row, self.trajectories.accepted_count())?;
        Ok(self.trajectories.accepted_since(from).flat_map(|particle| particle.numbers()).collect())
    }

    /// The refused ones from row `row` on, nine numbers each.
    pub fn refused_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        let from = cursor(row, self.trajectories.refused_count())?;
        Ok(self.trajectories.refused_since(from).iter().flat_map(|refused| refused.numbers()).collect())
    }

    /// Of every accepted one: how many were tried for it.
    pub fn tries(&self) -> Vec<u32> {
        self.trajectories.tries().to_vec()
    }

    /// The result document.
    pub fn result(&self) -> JsValue {
        record(&self.trajectories.result())
    }

    /// 16 hexadecimal digits over all that was tried.
    pub fn fingerprint(&self) -> String {
        format!("{:016x}", self.trajectories.fingerprint())
    }
}

/// The places of one particle, at these times.
#[wasm_bindgen]
pub fn particle_points(particle: JsValue, times: &[f64]) -> Result<Vec<f64>, JsValue> {
    settings(particle).and_then(|(given, _)| trajectories::particle_points(&given, times)).map_err(throw)
}
