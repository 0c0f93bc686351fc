//! The two lengths that every verdict depends on: the slack that covers rounding, and the tolerance at which a proof
//! gives up.

/// Slack and tolerance of one problem, in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// The slack: a clearance counts only as far as it exceeds this. 1e-12 of the largest coordinate plus the reach.
    pub eta: f64,
    /// An interval that is not proven apart from an obstacle when its bound on travel is below this counts as hit.
    pub tau: f64,
    /// The same for the bounds of the world.
    pub bounds_tau: f64,
}

/// The least slack, in metres: squares of longer lengths do not underflow.
const SMALLEST: f64 = 1e-150;

/// The least tolerance, in multiples of `eta`.
const FEWEST_ETAS: f64 = 10.0;

impl Tolerance {
    /// The slack for a world whose largest coordinate plus the robot's reach is `scale` metres, with the coarsest tolerance,
    /// `wanted` metres.
    pub fn new(scale: f64, wanted: f64) -> Self {
        let eta = (1e-12 * scale).max(SMALLEST);
        let tau = wanted.max(FEWEST_ETAS * eta);
        Self { eta, tau, bounds_tau: tau }
    }

    /// The same with the finest tolerance that the slack allows.
    #[must_use]
    pub fn finest(self) -> Self {
        let finest = FEWEST_ETAS * self.eta;
        Self { tau: finest, bounds_tau: finest, ..self }
    }

    /// The same, no coarser than half the clearance of the start and half that of the goal, so that both can be left;
    /// likewise for their depths within the bounds. A depth of 0 is contact, from which a turn or slide may be refused.
    #[must_use]
    pub fn fitted(self, clearances: [f64; 2], depths: [f64; 2]) -> Self {
        let finer =
            |tau: f64, room: f64| if room > 0.0 { tau.min(room / 2.0).max(FEWEST_ETAS * self.eta) } else { tau };
        let tau = clearances.into_iter().fold(self.tau, finer);
        Self { tau, bounds_tau: depths.into_iter().fold(self.bounds_tau, finer), ..self }
    }
}
