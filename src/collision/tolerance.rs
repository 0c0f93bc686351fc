//! The two lengths every verdict depends on: the slack that covers rounding, and the tolerance at which a proof gives up.

/// Slack and tolerance of one problem, in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// The slack: a clearance counts only as far as it exceeds this. 1e-12 of the largest coordinate plus the reach.
    pub eta: f64,
    /// A stretch that is unproven when its bound on motion is below this counts as hit.
    pub tau: f64,
}

/// How many times `eta` the tolerance is at least.
const FEWEST_ETAS: f64 = 10.0;

impl Tolerance {
    /// The slack for a world whose largest coordinate plus the robot's reach is `scale` metres, with the coarsest tolerance,
    /// `wanted` metres.
    pub fn new(scale: f64, wanted: f64) -> Self {
        let eta = 1e-12 * scale;
        Self { eta, tau: wanted.max(FEWEST_ETAS * eta) }
    }

    /// The same, no coarser than half the clearance of the start and half that of the goal, so that both can be left.
    #[must_use]
    pub fn fitted(self, clearances: [f64; 2]) -> Self {
        let half = clearances[0].min(clearances[1]) / 2.0;
        Self { tau: self.tau.min(half).max(FEWEST_ETAS * self.eta), ..self }
    }
}
