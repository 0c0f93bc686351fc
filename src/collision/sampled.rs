//! Motions looked at in a fixed number of places, as many planners do: kept by name, to show what it misses.

use crate::space::Space;
use crate::validity::{Contact, Validity};

/// What is free, but a motion counts as free when it is free in so many evenly spaced places, its far end included. Unproven:
/// what lies between the places is not seen.
pub struct Sampled<S: Space> {
    space: S,
    proven: Box<dyn Validity<S::State>>,
    places: u32,
}

impl<S: Space> Sampled<S> {
    /// The same world, motions looked at in `places` places, at least 1.
    pub fn new(space: S, proven: Box<dyn Validity<S::State>>, places: u32) -> Self {
        Self { space, proven, places }
    }

    /// Whether the motion is free in place `i`, from 1.
    fn is_free_at(&self, a: &S::State, b: &S::State, i: u32) -> bool {
        let t = f64::from(i) / f64::from(self.places);
        self.proven.is_free(&self.space.interpolate(a, b, t))
    }
}

impl<S: Space> Validity<S::State> for Sampled<S> {
    fn is_free(&self, state: &S::State) -> bool {
        self.proven.is_free(state)
    }

    /// Looks at the places in their order along the motion.
    fn is_motion_free(&self, a: &S::State, b: &S::State) -> bool {
        (1..=self.places).all(|i| self.is_free_at(a, b, i))
    }

    /// The last place before the first one in collision.
    fn first_hit(&self, a: &S::State, b: &S::State) -> Option<f64> {
        let hit = (1..=self.places).find(|&i| !self.is_free_at(a, b, i));
        hit.map(|i| f64::from(i - 1) / f64::from(self.places))
    }

    fn contacts(&self, state: &S::State) -> Vec<Contact> {
        self.proven.contacts(state)
    }

    fn clearance_evaluations(&self) -> u64 {
        self.proven.clearance_evaluations()
    }
}
