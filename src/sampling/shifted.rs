//! A sequence of points in the unit cube, shifted by the seed (Cranley and Patterson 1976, "Randomization of number
//! theoretic methods for multiple integration"): each seed has its own samples, all equally even.

use crate::random::Random;
use crate::space::MAX_DIMENSION;

/// The shift and the number of points drawn.
#[derive(Debug, Clone)]
pub(super) struct Shifted {
    shift: [f64; MAX_DIMENSION],
    taken: u64,
}

impl Shifted {
    /// A shift drawn from the stream.
    pub fn new(mut random: Random) -> Self {
        Self { shift: std::array::from_fn(|_| random.uniform()), taken: 0 }
    }

    /// The next point: `term` gives the coordinate in [0, 1) of axis i at number n, from 1.
    pub fn next(&mut self, term: impl Fn(usize, u64) -> f64) -> [f64; MAX_DIMENSION] {
        self.taken += 1;
        std::array::from_fn(|i| {
            let moved = term(i, self.taken) + self.shift[i];
            if moved >= 1.0 { moved - 1.0 } else { moved }
        })
    }
}
