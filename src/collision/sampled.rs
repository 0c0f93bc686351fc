//! Motions tested at a fixed number of configurations, as many planners do, to show what that misses.

use crate::problem::{Contact, Validity};
use crate::space::Space;

/// A collision checker for which a motion is free if a number of evenly spaced configurations of it are, its far end
/// included. This proves nothing: whatever lies between them is missed.
pub struct Sampled<S: Space> {
    space: S,
    proven: Box<dyn Validity<S::State>>,
    samples: u32,
}

impl<S: Space> Sampled<S> {
    /// The same world, motions tested at `samples` configurations, at least 1.
    pub fn new(space: S, proven: Box<dyn Validity<S::State>>, samples: u32) -> Self {
        Self { space, proven, samples }
    }
}

impl<S: Space> Validity<S::State> for Sampled<S> {
    fn is_free(&self, state: &S::State) -> bool {
        self.proven.is_free(state)
    }

    /// Coarse steps first, finer ones between them, so that wide obstacles are found early.
    fn is_motion_free(&self, a: &S::State, b: &S::State) -> bool {
        are_samples_free(self.samples, |t| self.proven.is_free(&self.space.interpolate(a, b, t)))
    }

    /// The last configuration tested before the first one in collision.
    fn first_hit(&self, a: &S::State, b: &S::State) -> Option<f64> {
        let at = |i: u32| f64::from(i) / f64::from(self.samples);
        let hit = (1..=self.samples).find(|&i| !self.proven.is_free(&self.space.interpolate(a, b, at(i))));
        hit.map(|i| at(i - 1))
    }

    fn contacts(&self, state: &S::State) -> Vec<Contact> {
        self.proven.contacts(state)
    }

    fn clearance_evaluations(&self) -> u64 {
        self.proven.clearance_evaluations()
    }

    fn unproven_motions(&self) -> u64 {
        self.proven.unproven_motions()
    }
}

/// Whether the fractions i / `samples` of a motion are all free, i from 1 to `samples`. The start is not tested.
/// Coarse steps first, finer ones between them, so that wide obstacles are found early.
pub(super) fn are_samples_free(samples: u32, is_free: impl Fn(f64) -> bool) -> bool {
    let Some(highest) = samples.checked_ilog2() else { return true };
    (0..=highest).rev().all(|level| {
        // The odd multiples of each power of two: every number once.
        let mut fractions = (1 << level..=samples).step_by(2 << level);
        fractions.all(|i| is_free(f64::from(i) / f64::from(samples)))
    })
}
