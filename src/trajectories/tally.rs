//! What was looked at on the way.

use serde::Serialize;

/// Counts of work, the same on every platform. Those but the first depend on the index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Tally {
    /// Trajectories tried.
    pub iterations: u64,
    /// Pairs of boxes around whole trajectories that were compared.
    pub boxes: u64,
    /// Pairs of trajectories that were tested themselves.
    pub pairs: u64,
    /// Pairs of stretches looked at where trajectories were halved.
    pub stretches: u64,
}
