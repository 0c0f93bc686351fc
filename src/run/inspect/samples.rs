//! Random configurations.

use super::Inspector;
use crate::error::{Code, Error, Number};
use crate::random::{MAX_SEED, Random, Stream};
use crate::space::Space;

/// The most configurations that are drawn at once.
pub const MAX_SAMPLES: u64 = 1_000_000;

/// The number of draws in a row in collision after which the search for a free configuration ends.
const PATIENCE: u32 = 100_000;

impl Inspector {
    /// Rows of `n` configurations drawn uniformly from the space of the robot, all of them or only those that are free: the
    /// same that a planner of this seed draws with its uniform sampler. O(n) draws and, if they must be free, as many
    /// checks as it takes.
    ///
    /// # Errors
    /// `out-of-range` for more than [`MAX_SAMPLES`] or another seed than 0 to 2^53 - 1; `unsupported` if 100,000 draws in a
    /// row are in collision.
    pub fn samples(&self, n: u64, seed: u64, is_free: bool) -> Result<Vec<f64>, Error> {
        for (pointer, given, most) in [("/n", n, MAX_SAMPLES), ("/seed", seed, MAX_SEED)] {
            if given > most {
                let [given, most] = [given, most].map(|count| Number(count as f64));
                let sentence = format!("{} lies within [0, {most}], not {given}", &pointer[1..]);
                return Err(Error::new(Code::OutOfRange, pointer, sentence));
            }
        }
        let mut random = Random::new(seed, Stream::Samples);
        let mut rows = Vec::with_capacity(n as usize * self.dimension());
        let mut refused = 0;
        while rows.len() < n as usize * self.dimension() {
            let state = self.space().sample(&mut random);
            if !is_free || self.validity.is_free(&state) {
                rows.extend_from_slice(self.space().coordinates(&state));
                refused = 0;
                continue;
            }
            refused += 1;
            if refused == PATIENCE {
                let sentence = format!("of {PATIENCE} configurations drawn in a row, none is free");
                return Err(Error::new(Code::Unsupported, "/free", sentence));
            }
        }
        Ok(rows)
    }
}
