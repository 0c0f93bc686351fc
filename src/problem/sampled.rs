//! Motions tested at a number of configurations, as many planners do, to show what that misses; and for robots of which nothing
//! is known but whether a configuration is free.

use super::{Contact, Validity};
use crate::error::Error;
use crate::space::Space;
use std::cell::{Cell, RefCell};

/// The most configurations at which one motion is tested; a motion that needs more is refused, and counted.
const MOST: f64 = 16_384.0;

/// How many configurations of a motion are tested.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Samples {
    /// This number of checks; the far end alone if it is 0 or 1.
    Count(u32),
    /// As many as it takes for neighbours to be no farther apart than this, in the metric of the space; greater than 0.
    Spacing(f64),
}

/// A collision checker for which a motion is free if a number of evenly spaced configurations of it are, its far end
/// included. This proves nothing: whatever lies between them is missed.
pub struct Sampled<S: Space> {
    space: S,
    points: Box<dyn Validity<S::State>>,
    samples: Samples,
    /// The samples of a motion that are tested at once, which motions reuse.
    states: RefCell<Vec<S::State>>,
    too_long: Cell<u64>,
}

impl<S: Space> Sampled<S> {
    /// The checker that tests configurations by another one.
    pub fn new(space: S, points: Box<dyn Validity<S::State>>, samples: Samples) -> Self {
        Self { space, points, samples, states: RefCell::default(), too_long: Cell::default() }
    }

    /// The number of configurations to test on a motion, at least 1; `None` if that is too many.
    fn count(&self, a: &S::State, b: &S::State) -> Option<u32> {
        let count = match self.samples {
            Samples::Count(count) => f64::from(count),
            Samples::Spacing(spacing) => libm::ceil(self.space.distance(a, b) / spacing),
        };
        if count > MOST {
            self.too_long.set(self.too_long.get() + 1);
            return None;
        }
        Some((count as u32).max(1))
    }

    fn at(&self, a: &S::State, b: &S::State, i: u32, count: u32) -> S::State {
        self.space.interpolate(a, b, f64::from(i) / f64::from(count))
    }
}

impl<S: Space> Validity<S::State> for Sampled<S> {
    fn is_free(&self, state: &S::State) -> bool {
        self.points.is_free(state)
    }

    /// Coarse steps first, finer ones between them, so that wide obstacles are found early.
    fn is_motion_free(&self, a: &S::State, b: &S::State) -> bool {
        let Some(count) = self.count(a, b) else { return false };
        // The odd multiples of each power of two: every number from 1 on once. The start is not tested.
        let mut states = self.states.take();
        let is_free = (0..=count.ilog2()).rev().all(|level| {
            states.clear();
            // An iterator by steps costs more than the states.
            let mut i = 1 << level;
            while i <= count {
                states.push(self.at(a, b, i, count));
                i += 2 << level;
            }
            self.points.are_free(&states)
        });
        self.states.replace(states);
        is_free
    }

    /// The last configuration tested before the first one in collision.
    fn first_hit(&self, a: &S::State, b: &S::State) -> Option<f64> {
        let Some(count) = self.count(a, b) else { return Some(0.0) };
        let hit = (1..=count).find(|&i| !self.points.is_free(&self.at(a, b, i, count)));
        hit.map(|i| f64::from(i - 1) / f64::from(count))
    }

    fn contacts(&self, state: &S::State) -> Vec<Contact> {
        self.points.contacts(state)
    }

    fn nearness_cost(&self, a: &S::State, b: &S::State) -> f64 {
        self.points.nearness_cost(a, b)
    }

    fn are_free(&self, states: &[S::State]) -> bool {
        self.points.are_free(states)
    }

    fn part_name(&self, part: usize) -> String {
        self.points.part_name(part)
    }

    fn collision(&self, state: &S::State) -> Option<String> {
        self.points.collision(state)
    }

    fn failure(&self) -> Option<Error> {
        self.points.failure()
    }

    fn evaluation_nanoseconds(&self) -> u64 {
        self.points.evaluation_nanoseconds()
    }

    fn clearance_evaluations(&self) -> u64 {
        self.points.clearance_evaluations()
    }

    fn unproven_motions(&self) -> u64 {
        self.points.unproven_motions() + self.too_long.get()
    }
}
