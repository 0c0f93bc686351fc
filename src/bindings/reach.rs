//! Inverse kinematics in JavaScript's hands.

use super::convert::{count, cursor, record, throw};
use crate::geometry::Point;
use crate::ik::{Followed, Nearest, Solver, Target};
use wasm_bindgen::prelude::*;

/// A run of inverse kinematics. Arrays handed out are copies and stay valid.
#[wasm_bindgen]
pub struct RawReach {
    reach: Solver,
}

impl RawReach {
    pub(super) fn new(reach: Solver) -> Self {
        Self { reach }
    }
}

#[wasm_bindgen]
impl RawReach {
    /// Does at most `iterations` iterations; answers how many it did.
    pub fn advance(&mut self, iterations: f64) -> Result<f64, JsValue> {
        let before = self.reach.iterations();
        self.reach.step(count(iterations, "n").map_err(throw)?);
        Ok((self.reach.iterations() - before) as f64)
    }

    /// 0 where the run goes on, 1 where it is solved, 2 where it is exhausted.
    pub fn status(&self) -> u8 {
        self.reach.status() as u8
    }

    /// How things stand: error, manipulability, iterations, restarts, rows of iterates, of solutions, of those rejected.
    pub fn state(&self) -> Vec<f64> {
        let reach = &self.reach;
        let rows = [reach.iterates().len(), reach.solutions().len(), reach.rejected().len()].map(|rows| rows as f64);
        let mut state =
            vec![reach.error(), reach.manipulability(), reach.iterations() as f64, f64::from(reach.restarts())];
        state.extend(rows);
        state
    }

    /// Where the run is.
    pub fn configuration(&self) -> Vec<f64> {
        self.reach.configuration()[..self.reach.dimension()].to_vec()
    }

    /// The iterates from row `row` on: restart, error, configuration each.
    pub fn iterates_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        let iterates = &self.reach.iterates()[cursor(row, self.reach.iterates().len())?..];
        let mut numbers = Vec::with_capacity(iterates.len() * (2 + self.reach.dimension()));
        for iterate in iterates {
            numbers.extend([f64::from(iterate.restart), iterate.error]);
            numbers.extend(&iterate.configuration[..self.reach.dimension()]);
        }
        Ok(numbers)
    }

    /// The solutions from row `row` on.
    pub fn solutions_since(&self, row: f64) -> Result<Vec<f64>, JsValue> {
        let solutions = &self.reach.solutions()[cursor(row, self.reach.solutions().len())?..];
        Ok(solutions.iter().flat_map(|q| &q[..self.reach.dimension()]).copied().collect())
    }

    /// What has come of the run.
    pub fn verdict(&self) -> JsValue {
        record(&self.reach.verdict_document())
    }

    /// The result document.
    pub fn result(&self) -> JsValue {
        record(&self.reach.result())
    }

    /// 16 hexadecimal digits over every iterate and solution.
    pub fn fingerprint(&self) -> String {
        format!("{:016x}", self.reach.fingerprint())
    }
}

/// A target from an array of x and y, and the orientation where there is one.
pub(super) fn target(point: &[f64], orientation: Option<f64>) -> Target {
    let at = |i: usize| point.get(i).copied().unwrap_or(f64::NAN);
    Target { point: Point::new(at(0), at(1)), orientation }
}

/// Where an arm is that has followed: x, y, distance, turn, 1 where the target is reached, manipulability, configuration.
pub(super) fn followed(arm: &Followed, dimension: usize) -> Vec<f64> {
    let is_reached = f64::from(u8::from(arm.is_reached));
    let mut numbers = vec![arm.point.x, arm.point.y, arm.distance, arm.turn, is_reached, arm.manipulability];
    numbers.extend(&arm.configuration[..dimension]);
    numbers
}

/// How near an arm can come: x, y, distance, turn, configuration.
pub(super) fn near(nearest: &Nearest, dimension: usize) -> Vec<f64> {
    let mut numbers = vec![nearest.point.x, nearest.point.y, nearest.distance, nearest.turn];
    numbers.extend(&nearest.configuration[..dimension]);
    numbers
}
