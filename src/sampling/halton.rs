//! The Halton sequence (Halton 1960, "On the efficiency of certain quasi-random sequences of points in evaluating
//! multi-dimensional integrals"; LaValle 2006, "Planning Algorithms", section 5.2.3), shifted by the seed.

use super::shifted::Shifted;
use super::{Known, Sample, Sampler};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::{MAX_DIMENSION, Space};

/// The base of every coordinate: the first primes.
const BASES: [u64; MAX_DIMENSION] = [2, 3, 5, 7, 11, 13, 17, 19];

/// Samples that leave no large gap: coordinate i is the radical inverse in the i-th prime.
#[derive(Debug, Clone)]
pub struct Halton(Shifted);

impl Halton {
    /// The sequence with a shift drawn from the stream.
    pub fn new(random: Random) -> Self {
        Self(Shifted::new(random))
    }
}

impl<S: Space> Sampler<S> for Halton {
    fn draw(&mut self, problem: &Problem<S>, _: &mut u64) -> Sample<S::State> {
        let place = self.0.next(|i, n| radical_inverse(BASES[i], n));
        Sample { state: problem.space().at(&place), known: Known::Nothing }
    }
}

/// The digits of `n` in the base, mirrored at the point: a number in [0, 1). O(log n).
///
/// ```
/// use planarium::sampling::radical_inverse;
/// assert_eq!([1, 2, 3, 4].map(|n| radical_inverse(2, n)), [0.5, 0.25, 0.75, 0.125]);
/// ```
pub fn radical_inverse(base: u64, n: u64) -> f64 {
    let (mut rest, mut scale, mut inverse) = (n, 1.0, 0.0);
    while rest > 0 {
        scale /= base as f64;
        inverse += scale * (rest % base) as f64;
        rest /= base;
    }
    // Rounding may carry a long string of largest digits up to 1.
    if inverse < 1.0 { inverse } else { 1.0f64.next_down() }
}
