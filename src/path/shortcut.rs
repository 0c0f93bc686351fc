//! Shortcutting: random detours of a path replaced by straight motions that are proven free.
//!
//! Geraerts and Overmars 2007, "Creating high-quality paths for motion planning".

use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::space::Space;
use crate::validity::Validity;

/// A path being shortened, one attempt at a time.
#[derive(Debug, Clone)]
pub struct Shortcut<S: Space> {
    path: Vec<S::State>,
    random: Random,
    motion_checks: u64,
}

impl<S: Space> Shortcut<S> {
    /// Starts from a proven path.
    pub fn new(path: Vec<S::State>, seed: u64) -> Self {
        Self { path, random: Random::new(seed, Stream::Shortcut), motion_checks: 0 }
    }

    /// Draws two places along the path and replaces what lies between by a straight motion, where that is shorter and the
    /// new motions are proven free: at most three motion checks. Answers whether the path became shorter. O(path).
    pub fn attempt<V: Validity<S::State>>(&mut self, problem: &Problem<S, V>) -> bool {
        let space = problem.space();
        let total = super::length(space, &self.path);
        let [first, second] = [0, 1].map(|_| self.random.uniform() * total);
        let (Some(from), Some(to)) = (self.place(space, first.min(second)), self.place(space, first.max(second)))
        else {
            return false;
        };
        if from.edge == to.edge {
            return false;
        }
        let (before, after) = (self.path[from.edge], self.path[to.edge + 1]);
        let detour = [&[from.state], &self.path[from.edge + 1..=to.edge], &[to.state]].concat();
        if space.distance(&from.state, &to.state) >= super::length(space, &detour) {
            return false;
        }
        // The pieces of the cut edges are proven anew: rounding may move them by a bit off the edges.
        for (a, b) in [(before, from.state), (from.state, to.state), (to.state, after)] {
            self.motion_checks += 1;
            if !problem.validity().is_motion_free(&a, &b) {
                return false;
            }
        }
        let mut path = self.path[..=from.edge].to_vec();
        for state in [from.state, to.state].into_iter().chain(self.path[to.edge + 1..].iter().copied()) {
            if path.last() != Some(&state) {
                path.push(state);
            }
        }
        let is_shorter = super::length(space, &path) < total;
        if is_shorter {
            self.path = path;
        }
        is_shorter
    }

    /// The path as it is now.
    pub fn path(&self) -> &[S::State] {
        &self.path
    }

    /// How many motions were checked so far.
    pub fn motion_checks(&self) -> u64 {
        self.motion_checks
    }

    /// The place at the given distance along the path.
    fn place(&self, space: &S, along: f64) -> Option<Place<S::State>> {
        let mut left = along;
        for (edge, pair) in self.path.windows(2).enumerate() {
            let distance = space.distance(&pair[0], &pair[1]);
            if left <= distance && distance > 0.0 {
                let state = space.interpolate(&pair[0], &pair[1], left / distance);
                return Some(Place { edge, state });
            }
            left -= distance;
        }
        None
    }
}

/// A place on a path: which edge, and the state there.
#[derive(Debug, Clone, Copy)]
struct Place<S> {
    edge: usize,
    state: S,
}
