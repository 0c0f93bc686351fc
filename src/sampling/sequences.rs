//! Low-dispersion sequences in the unit cube, shifted by the seed (Cranley and Patterson 1976, "Randomization of number
//! theoretic methods for multiple integration"): each seed has its own samples, all equally even.

use super::{Known, Sample, Sampler};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::{MAX_DIMENSION, Space};

/// A sequence of samples: `term` gives the coordinate in [0, 1) of axis i at number n, from 1.
#[derive(Debug, Clone)]
pub struct Sequence<F> {
    term: F,
    shift: [f64; MAX_DIMENSION],
    drawn: u64,
}

impl<F: Fn(usize, u64) -> f64> Sequence<F> {
    /// The sequence with a shift drawn from the stream.
    fn new(mut random: Random, term: F) -> Self {
        Self { term, shift: std::array::from_fn(|_| random.uniform()), drawn: 0 }
    }
}

impl<S: Space, F: Fn(usize, u64) -> f64 + Send> Sampler<S> for Sequence<F> {
    fn draw(&mut self, problem: &Problem<S>, _: &mut u64) -> Sample<S::State> {
        self.drawn += 1;
        let point: [f64; MAX_DIMENSION] = std::array::from_fn(|i| {
            let moved = (self.term)(i, self.drawn) + self.shift[i];
            if moved >= 1.0 { moved - 1.0 } else { moved }
        });
        Sample { state: problem.space().at(&point), known: Known::Nothing }
    }

    fn is_blind(&self) -> bool {
        true
    }
}

/// The base of every coordinate: the first primes.
const BASES: [u64; MAX_DIMENSION] = [2, 3, 5, 7, 11, 13, 17, 19];

/// The Halton sequence (Halton 1960, "On the efficiency of certain quasi-random sequences of points in evaluating
/// multi-dimensional integrals"; LaValle 2006, "Planning Algorithms", section 5.2.3): coordinate i is the radical inverse in
/// the i-th prime.
pub fn halton(random: Random) -> Sequence<impl Fn(usize, u64) -> f64> {
    Sequence::new(random, |i, n| radical_inverse(BASES[i], n))
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

/// A lattice without a last point: multiples of one direction with irrational coordinates, modulo 1 (Richtmyer 1951, "The
/// evaluation of definite integrals, and a quasi-Monte-Carlo method based on the properties of algebraic numbers"; LaValle
/// 2006, "Planning Algorithms", section 5.2.4). The direction is (1/g, 1/g^2, ...), g the root above 1 of x^(d+1) = x + 1
/// for d coordinates: for d = 1 the golden ratio.
pub fn lattice(dimension: usize, random: Random) -> Sequence<impl Fn(usize, u64) -> f64> {
    let g = root(dimension);
    let mut power = 1.0;
    let direction: [f64; MAX_DIMENSION] = std::array::from_fn(|_| {
        power /= g;
        power
    });
    Sequence::new(random, move |i, n| {
        let along = direction[i] * n as f64;
        along - libm::floor(along)
    })
}

/// The root above 1 of x^(d+1) = x + 1, by fixed-point iteration, which contracts by at least a third per round.
fn root(dimension: usize) -> f64 {
    (0..64).fold(2.0, |g, _| libm::pow(1.0 + g, 1.0 / (dimension + 1) as f64))
}
