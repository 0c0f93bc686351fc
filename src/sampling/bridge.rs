//! The bridge test (Hsu, Jiang, Reif and Sun 2003, "The bridge test for sampling narrow passages with probabilistic roadmap
//! planners"): free samples between obstacles.

use super::{Known, Sample, Sampler, is_free, near};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// Returns the midpoint of two nearby samples in collision, if it is free.
#[derive(Debug, Clone)]
pub struct BridgeTest {
    random: Random,
    deviation: f64,
}

impl BridgeTest {
    /// The second sample is normally distributed about the first, every coordinate by `deviation` (radians or metres).
    pub fn new(random: Random, deviation: f64) -> Self {
        Self { random, deviation }
    }
}

impl<S: Space> Sampler<S> for BridgeTest {
    fn draw(&mut self, problem: &Problem<S>, checks: &mut u64) -> Sample<S::State> {
        let space = problem.space();
        let first = space.sample(&mut self.random);
        let useless = Sample { state: first, known: Known::Useless };
        let Some(second) = near(space, &first, self.deviation, &mut self.random) else { return useless };
        if is_free(problem, &first, checks) || is_free(problem, &second, checks) {
            return useless;
        }
        let middle = space.interpolate(&first, &second, 0.5);
        let known = if is_free(problem, &middle, checks) { Known::Free } else { Known::Useless };
        Sample { state: middle, known }
    }
}
