//! Samplers that check for collisions: near, between and on obstacles.

use super::{Known, Sample, Sampler, is_free, near};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// The Gaussian sampler (Boor, Overmars and van der Stappen 1999, "The Gaussian sampling strategy for probabilistic roadmap
/// planners"): draws two nearby samples and returns the free one if the other is in collision.
#[derive(Debug, Clone)]
pub struct Gaussian {
    /// The stream of samples.
    pub random: Random,
    /// The standard deviation of the second sample from the first in every coordinate, in radians or metres.
    pub deviation: f64,
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

/// The bridge test (Hsu, Jiang, Reif and Sun 2003, "The bridge test for sampling narrow passages with probabilistic roadmap
/// planners"): returns the midpoint of two nearby samples in collision, if it is free.
#[derive(Debug, Clone)]
pub struct BridgeTest {
    /// The stream of samples.
    pub random: Random,
    /// The standard deviation of the second sample from the first in every coordinate, in radians or metres.
    pub deviation: f64,
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

/// How often the motion across the surface is halved: to a 1024th of it.
const HALVINGS: usize = 10;

/// Obstacle-based sampling (Amato and Wu 1996, "A randomized roadmap method for path and manipulation planning"): bisects
/// between a sample in collision and a free one, and returns the last free configuration.
#[derive(Debug, Clone)]
pub struct ObstacleBased(pub Random);

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
