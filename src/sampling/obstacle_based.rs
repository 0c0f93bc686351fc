//! Obstacle-based sampling (Amato and Wu 1996, "A randomized roadmap method for path and manipulation planning"): free
//! samples on the surface of the obstacles of the configuration space.

use super::{Known, Sample, Sampler, is_free};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// How often the motion across the surface is halved: to a 1024th of it.
const HALVINGS: usize = 10;

/// Bisects between a sample in collision and a free one, and returns the last free configuration.
#[derive(Debug, Clone)]
pub struct ObstacleBased(Random);

impl ObstacleBased {
    /// Samples drawn from a stream.
    pub fn new(random: Random) -> Self {
        Self(random)
    }
}

impl<S: Space> Sampler<S> for ObstacleBased {
    fn draw(&mut self, problem: &Problem<S>, checks: &mut u64) -> Sample<S::State> {
        let space = problem.space();
        let ends = [0, 1].map(|_| space.sample(&mut self.0));
        let (mut hit, mut free) = match ends.map(|state| is_free(problem, &state, checks)) {
            [true, false] => (ends[1], ends[0]),
            [false, true] => (ends[0], ends[1]),
            _ => return Sample { state: ends[0], known: Known::Useless },
        };
        for _ in 0..HALVINGS {
            let middle = space.interpolate(&hit, &free, 0.5);
            if is_free(problem, &middle, checks) {
                free = middle;
            } else {
                hit = middle;
            }
        }
        Sample { state: free, known: Known::Free }
    }
}
