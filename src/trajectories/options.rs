//! The options of many trajectories.

use super::particle::{MOST_TURNING, Model};
use crate::error::Error;
use crate::options::{Options, out_of_range};
use std::f64::consts::PI;

crate::choice! {
    /// The earlier trajectories that a new one is tested against.
    pub enum IndexKind {
        /// Those that share a cell of a grid with it.
        Grid,
        /// All.
        None,
    }
}

crate::options! {
    /// Options of many trajectories.
    pub struct TrajectoryOptions for &[];
    /// How a particle moves: on a circular arc, or on the spiral whose points are v t away from the start in direction theta + w
    /// t.
    model: Model = Model::Arc, "Motion";
    /// Number of mutually non-crossing trajectories to find.
    count: usize = 1000, in 1.0..=100_000.0, "Trajectories";
    /// Starts lie in a square from minus this to this.
    half_side: f64 = 3.0, in 0.01..=10_000.0, "Half side", unit "m";
    /// First headings lie between minus this and this.
    spread: f64 = PI, in 0.0..=PI, "Spread", unit "rad";
    /// Minimum speed; at most the maximum.
    slowest: f64 = 0.0, in 0.0..=1000.0, "Slowest", unit "m/s";
    /// Maximum speed.
    fastest: f64 = 1.0, in 0.0..=1000.0, "Fastest", unit "m/s";
    /// Minimum turn rate, at most the maximum; negative turns right.
    least_turn_rate: f64 = -PI, in -1000.0..=1000.0, "Least turn rate", unit "rad/s";
    /// Maximum turn rate.
    greatest_turn_rate: f64 = PI, in -1000.0..=1000.0, "Greatest turn rate", unit "rad/s";
    /// How long every particle moves; no turn is longer than 100 radians.
    duration: f64 = 1.0, in 0.001..=1000.0, "Duration", unit "s";
    /// Grid: a new trajectory is tested against those that share a cell with it only. None: against all. The result is the same.
    index: IndexKind = IndexKind::Grid, "Index";
    /// After how many trajectories tried the search for more gives up.
    max_iterations: u64 = 100_000, in 1.0..=1_000_000.0, "Iterations at most";
}

impl TrajectoryOptions {
    /// Refuses values out of range, and those that do not go together.
    pub(super) fn check_all(&self) -> Result<(), Error> {
        self.check()?;
        let Self { slowest, fastest, least_turn_rate, greatest_turn_rate, duration, .. } = *self;
        let pairs = [
            ("slowest", slowest, "fastest", fastest),
            ("least_turn_rate", least_turn_rate, "greatest_turn_rate", greatest_turn_rate),
        ];
        for (name, low, greatest, high) in pairs {
            if low > high {
                return Err(out_of_range(name, format!("{name} must be at most {greatest}, {high}, not {low}")));
            }
        }
        let turn = least_turn_rate.abs().max(greatest_turn_rate.abs()) * duration;
        if turn > MOST_TURNING {
            let sentence = format!("the longest turn must be at most {MOST_TURNING} radians, not {turn}");
            return Err(out_of_range("duration", sentence));
        }
        Ok(())
    }
}
