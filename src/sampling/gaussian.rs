//! The Gaussian sampler (Boor, Overmars and van der Stappen 1999, "The Gaussian sampling strategy for probabilistic roadmap
//! planners"): free samples near obstacles.

use super::{Known, Sample, Sampler, is_free, near};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// Draws two nearby samples and returns the free one if the other is in collision.
#[derive(Debug, Clone)]
pub struct Gaussian {
    random: Random,
    deviation: f64,
}

impl Gaussian {
    /// The second sample is normally distributed about the first, every coordinate by `deviation` (radians or metres).
    pub fn new(random: Random, deviation: f64) -> Self {
        Self { random, deviation }
    }
}

impl<S: Space> Sampler<S> for Gaussian {
    fn draw(&mut self, problem: &Problem<S>, checks: &mut u64) -> Sample<S::State> {
        let first = problem.space().sample(&mut self.random);
        let Some(second) = near(problem.space(), &first, self.deviation, &mut self.random) else {
            return Sample { state: first, known: Known::Useless };
        };
        let free = [&first, &second].map(|state| is_free(problem, state, checks));
        match free {
            [true, false] => Sample { state: first, known: Known::Free },
            [false, true] => Sample { state: second, known: Known::Free },
            _ => Sample { state: first, known: Known::Useless },
        }
    }
}
