//! Many trajectories for JavaScript.

use super::convert::{count, cursor, digits, record, split};
use crate::Error;
use crate::trajectories::{self, Trajectories};
use wasm_bindgen::prelude::*;

/// A run that adds trajectories that do not cross.
#[wasm_bindgen]
pub struct RawTrajectories(Trajectories);

#[wasm_bindgen]
impl RawTrajectories {
    /// Starts a run with options.
    pub fn begin(options: JsValue) -> Result<RawTrajectories, Error> {
        let (seed, given) = split(options, "seed")?;
        Trajectories::new(&given, seed.unwrap_or(0)).map(Self)
    }

    /// Does at most `n` iterations.
    pub fn advance(&mut self, n: f64) -> Result<(), Error> {
        self.0.step(count(n, "n")?);
        Ok(())
    }

    /// The accepted ones from row `row` on, six numbers each.
    pub fn accepted_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        let accepted = self.0.accepted();
        let from = cursor(row, accepted.len())?;
        Ok(accepted.skip(from).flat_map(|particle| particle.numbers()).collect())
    }

    /// The refused ones from row `row` on, nine numbers each.
    pub fn refused_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        let refused = self.0.refused();
        Ok(refused[cursor(row, refused.len())?..].iter().flat_map(|refused| refused.numbers()).collect())
    }
}

getters! { RawTrajectories(self)
    /// 0 while running, 1 once all are accepted, 2 if the iterations are spent before.
    status: u8 = self.0.status() as u8;
    /// Iterations made, the number of accepted and of refused ones.
    counts: Vec<f64> = vec![self.0.tally().iterations as f64, self.0.accepted().len() as f64, self.0.refused().len() as f64];
    /// How many were tried for each accepted one.
    tries: Vec<u32> = self.0.tries().to_vec();
    result: JsValue = record(&self.0.result());
    /// 16 hexadecimal digits over everything tried.
    fingerprint: String = digits(self.0.fingerprint());
}

/// The positions of one particle at these times.
#[wasm_bindgen]
pub fn particle_points(particle: JsValue, times: &[f64]) -> Result<Vec<f64>, Error> {
    trajectories::particle_points(&split::<u64>(particle, "seed")?.1, times)
}
