//! Inverse kinematics for JavaScript.

use super::convert::{count, cursor, digits, record};
use crate::Error;
use crate::geometry::Point;
use crate::ik::{Followed, Nearest, Solver, Target};
use wasm_bindgen::prelude::*;

/// A run of inverse kinematics.
#[wasm_bindgen]
pub struct RawReach(pub(super) Solver);

#[wasm_bindgen]
impl RawReach {
    /// Does at most `iterations` iterations; returns how many it did.
    pub fn advance(&mut self, iterations: f64) -> Result<f64, Error> {
        let before = self.0.stats().iterations;
        self.0.step(count(iterations, "n")?);
        Ok((self.0.stats().iterations - before) as f64)
    }

    /// The iterates from row `row` on: restart, error, configuration each.
    pub fn iterates_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        let iterates = &self.0.iterates()[cursor(row, self.0.iterates().len())?..];
        let mut numbers = Vec::with_capacity(iterates.len() * (2 + self.0.dimension()));
        for iterate in iterates {
            numbers.extend([f64::from(iterate.restart), iterate.error]);
            numbers.extend(&iterate.configuration[..self.0.dimension()]);
        }
        Ok(numbers)
    }

    /// The solutions from row `row` on.
    pub fn solutions_since(&self, row: f64) -> Result<Vec<f64>, Error> {
        Ok(self.0.solutions()[cursor(row, self.0.solutions().len())?..].concat())
    }
}

getters! { RawReach(self)
    /// 0 while running, 1 if solved, 2 if exhausted.
    status: u8 = self.0.status() as u8;
    /// Error, manipulability, iterations, restarts, the number of iterates, of solutions and of rejected configurations.
    state: Vec<f64> = {
        let rows = [self.0.iterates().len(), self.0.solutions().len(), self.0.rejected().len()];
        let stats = self.0.stats();
        let counts = [stats.iterations, u64::from(stats.restarts)].into_iter().chain(rows.map(|rows| rows as u64));
        [self.0.error(), self.0.manipulability()].into_iter().chain(counts.map(|count| count as f64)).collect()
    };
    configuration: Vec<f64> = self.0.configuration()[..self.0.dimension()].to_vec();
    verdict: JsValue = record(&self.0.explain());
    result: JsValue = record(&self.0.result());
    /// 16 hexadecimal digits over every iterate and solution.
    fingerprint: String = digits(self.0.fingerprint());
}

/// A target from an array of x and y, and the orientation, if any.
pub(super) fn target(point: &[f64], orientation: Option<f64>) -> Target {
    let at = |i: usize| point.get(i).copied().unwrap_or(f64::NAN);
    Target { point: Point::new(at(0), at(1)), orientation }
}

/// An arm that has followed a target: x, y, distance, turn, 1 if the target is reached, manipulability, configuration.
pub(super) fn followed(arm: Followed) -> Vec<f64> {
    let is_reached = f64::from(u8::from(arm.is_reached));
    let numbers = [arm.point.x, arm.point.y, arm.distance, arm.turn, is_reached, arm.manipulability];
    [&numbers[..], &arm.configuration].concat()
}

/// How near an arm can come: x, y, distance, turn, configuration.
pub(super) fn near(nearest: Nearest) -> Vec<f64> {
    let numbers = [nearest.point.x, nearest.point.y, nearest.distance, nearest.turn];
    [&numbers[..], &nearest.configuration].concat()
}
