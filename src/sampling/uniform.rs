//! Uniform samples.

use super::{Known, Sample, Sampler};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// The uniform distribution over the space.
#[derive(Debug, Clone)]
pub struct Uniform(Random);

impl Uniform {
    /// Samples drawn from a stream.
    pub fn new(random: Random) -> Self {
        Self(random)
    }
}

impl<S: Space> Sampler<S> for Uniform {
    fn draw(&mut self, problem: &Problem<S>, _: &mut u64) -> Sample<S::State> {
        Sample { state: problem.space().sample(&mut self.0), known: Known::Nothing }
    }
}
