//! What is stepped: the law of slices, once for all.

use super::{Phase, Status};
use crate::error::Error;

/// A value that makes one iteration at a time. Slices do not change its result: 1000 calls of `step(1)` give the same as one of
/// `step(1000)`.
pub trait Stepped {
    /// Makes one iteration. Called only while the status is `Running`.
    fn iterate(&mut self);

    /// The status.
    fn status(&self) -> Status;

    /// Iterations made so far.
    fn iterations(&self) -> u64;

    /// The present phase, of those that have several.
    fn phase(&self) -> Phase {
        Phase::Growing
    }

    /// The error that it has ended with.
    fn failure(&self) -> Option<Error> {
        None
    }

    /// Makes at most `iterations` iterations, and none once the status is no longer `Running`.
    fn step(&mut self, iterations: u64) -> Status {
        let mut left = iterations;
        while left > 0 && self.status() == Status::Running {
            self.iterate();
            left -= 1;
        }
        self.status()
    }
}
