//! The seeded, portable generator: the same seed gives the same draws on every platform and in every version.
//!
//! Xoshiro256++ (Blackman and Vigna 2021, "Scrambled linear pseudorandom number generators"), seeded through SplitMix64.
//! Results must not change with the version of the crate rand, so [`Random::normal`] and [`below`] are written here: rand and
//! rand_distr draw other bits for them, and change their algorithms between versions.

use crate::error::{Code, Error};
use rand::{Rng, RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// The largest seed: 2^53 - 1, the largest integer that JavaScript holds exactly.
pub const MAX_SEED: u64 = (1 << 53) - 1;

/// Refuses a seed that JavaScript could not hold: `out-of-range`, pointer `/seed`.
pub(crate) fn check_seed(seed: u64) -> Result<(), Error> {
    if seed <= MAX_SEED {
        return Ok(());
    }
    Err(Error::new(Code::OutOfRange, "/seed", format!("a seed must lie within [0, {MAX_SEED}], not {seed}")))
}

/// The purpose of a stream of random numbers. Streams of one seed never overlap: each begins 2^192 draws after the last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stream {
    /// Samples of the configuration space.
    Samples = 0,
    /// Obstacles of a generated scenario.
    Scenario = 1,
    /// Which shortcuts of a path are tried.
    Shortcut = 2,
    /// When a tree grows towards the goal.
    Bias = 3,
    /// The planes of an approximate index.
    Projections = 4,
    /// Which controls are tried, and for how long.
    Controls = 5,
    /// Where a search for joint angles restarts.
    Starts = 6,
    /// Which trajectories of particles are tried.
    Particles = 7,
    /// Within which cost a sample is to be reached.
    Costs = 8,
    /// In which order robots of a fleet plan.
    Priorities = 9,
    /// Weights of a policy, and the changes that its training tries.
    Weights = 10,
    /// The tasks that a policy is trained and measured on.
    Tasks = 11,
    /// The noise of rollouts.
    Rollouts = 12,
    /// In which directions a free configuration is looked for.
    Ends = 13,
    /// The seeds of worlds that are drawn again until one is as required.
    Worlds = 14,
    /// The samples that the roadmaps of a fleet grow by where they are too thin.
    Growth = 15,
    /// The order in which joint moves of a fleet are tried.
    Moves = 16,
    /// Which values of a sample are drawn again, for an interval.
    Resamples = 17,
    /// The places on which the cover of a route graph is measured.
    Probes = 18,
}

/// A stream of random numbers.
#[derive(Debug, Clone)]
pub struct Random(Xoshiro256PlusPlus);

impl Random {
    /// The stream of `seed` for one purpose.
    pub fn new(seed: u64, stream: Stream) -> Self {
        let mut generator = Xoshiro256PlusPlus::seed_from_u64(seed);
        for _ in 0..stream as u32 {
            generator.long_jump();
        }
        Self(generator)
    }

    /// The next 64 random bits.
    #[inline]
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// A number from [0, 1), a multiple of 2^-53.
    #[inline]
    pub fn uniform(&mut self) -> f64 {
        self.0.random()
    }

    /// A number from the standard normal distribution (Marsaglia and Bray 1964, "A convenient method for generating normal
    /// variables"; the second number of a pair is dropped).
    pub fn normal(&mut self) -> f64 {
        loop {
            let (x, y) = (2.0 * self.uniform() - 1.0, 2.0 * self.uniform() - 1.0);
            let square = x * x + y * y;
            if square > 0.0 && square < 1.0 {
                return x * (-2.0 * libm::log(square) / square).sqrt();
            }
        }
    }

    /// An integer from 0 to `n` - 1: see [`below`].
    pub fn below(&mut self, n: u64) -> u64 {
        below(&mut self.0, n)
    }
}

/// An integer from 0 to `n` - 1, all equally likely (Lemire 2019, "Fast random integer generation in an interval"); 0 if `n`
/// is 0.
pub fn below(generator: &mut impl Rng, n: u64) -> u64 {
    let reject_below = n.wrapping_neg().checked_rem(n).unwrap_or(0);
    loop {
        let product = u128::from(generator.next_u64()) * u128::from(n);
        if product as u64 >= reject_below {
            return (product >> 64) as u64;
        }
    }
}

/// A fresh seed from the entropy of the operating system or the browser, from 0 to [`MAX_SEED`].
///
/// # Errors
/// `unsupported` if the platform has no source of entropy.
pub fn random_seed() -> Result<u64, Error> {
    let sentence = |error| format!("this platform gives no random bits: {error}");
    let bits = getrandom::u64().map_err(|error| Error::new(Code::Unsupported, "", sentence(error)))?;
    Ok(bits & MAX_SEED)
}
