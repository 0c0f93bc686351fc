//! A lattice without a last point: multiples of one direction with irrational coordinates, modulo 1 (Richtmyer 1951, "The
//! evaluation of definite integrals, and a quasi-Monte-Carlo method based on the properties of algebraic numbers"; LaValle
//! 2006, "Planning Algorithms", section 5.2.4), shifted by the seed.
//!
//! The direction is (1/g, 1/g^2, ...), g the root above 1 of x^(d+1) = x + 1: for d = 1 the golden ratio.

use super::shifted::Shifted;
use super::{Known, Sample, Sampler};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::{MAX_DIMENSION, Space};

/// Samples as even as a grid's, at any number of them.
#[derive(Debug, Clone)]
pub struct Lattice {
    places: Shifted,
    direction: [f64; MAX_DIMENSION],
}

impl Lattice {
    /// A lattice in `dimension` coordinates with a shift drawn from the stream.
    pub fn new(dimension: usize, random: Random) -> Self {
        let g = root(dimension);
        let mut power = 1.0;
        let direction = std::array::from_fn(|_| {
            power /= g;
            power
        });
        Self { places: Shifted::new(random), direction }
    }
}

impl<S: Space> Sampler<S> for Lattice {
    fn draw(&mut self, problem: &Problem<S>, _: &mut u64) -> Sample<S::State> {
        let place = self.places.next(|i, n| {
            let along = self.direction[i] * n as f64;
            along - libm::floor(along)
        });
        Sample { state: problem.space().at(&place), known: Known::Nothing }
    }
}

/// The root above 1 of x^(d+1) = x + 1, by fixed-point iteration, which contracts by at least a third a round.
fn root(dimension: usize) -> f64 {
    let mut g = 2.0;
    for _ in 0..64 {
        g = libm::pow(1.0 + g, 1.0 / (dimension + 1) as f64);
    }
    g
}
