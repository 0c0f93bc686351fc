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
    /// The same world, motions tested at `samples` configurations; at their far end alone if that is 0 or 1.
    pub fn new(space: S, proven: Box<dyn Validity<S::State>>, samples: u32) -> Self {
        Self { space, proven, samples: samples.max(1) }
    }
}

impl<S: Space> Validity<S::State> for Sampled<S> {
    fn is_free(&self, state: &S::State) -> bool {
        self.proven.is_free(state)
    }

    /// Coarse steps first, finer ones between them, so that wide obstacles are found early.
    fn is_motion_free(&self, a: &S::State, b: &S::State) -> bool {
        let is_free = |i| self.proven.is_free(&self.space.interpolate(a, b, f64::from(i) / f64::from(self.samples)));
        let Some(highest) = self.samples.checked_ilog2() else { return true };
        // The odd multiples of each power of two: every number from 1 on once. The start is not tested.
        (0..=highest).rev().all(|level| (1 << level..=self.samples).step_by(2 << level).all(is_free))
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
