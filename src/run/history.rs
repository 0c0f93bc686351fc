//! What a run leaves behind of every iteration, for those who draw how it went.

use super::Phase;
use crate::problem::Stats;

/// Numbers of a row of [`Run::take_history`](super::Run::take_history): vertices, edges, events, phase (its number in
/// [`Phase::ALL`]), configuration checks, motion checks, clearance evaluations, and the length of the best path so far.
pub const HISTORY_WIDTH: usize = 8;

/// Rows of [`HISTORY_WIDTH`] numbers that nobody has taken yet.
#[derive(Debug, Default)]
pub(super) struct History {
    rows: Vec<f64>,
}

impl History {
    /// Adds what an iteration has led to; `cost` is infinite while there is no path.
    pub fn add(&mut self, stats: &Stats, events: usize, phase: Phase, cost: f64) {
        let row: [f64; HISTORY_WIDTH] = [
            stats.vertices as f64,
            stats.edges as f64,
            events as f64,
            f64::from(phase as u8),
            stats.configuration_checks as f64,
            stats.motion_checks as f64,
            stats.clearance_evaluations as f64,
            cost,
        ];
        self.rows.extend(row);
    }

    /// Hands over the rows and forgets them.
    pub fn take(&mut self) -> Vec<f64> {
        std::mem::take(&mut self.rows)
    }
}
