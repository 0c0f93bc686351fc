//! A path being improved, one attempt at a time: first vertices that can be left out, then shortcuts, then shortcuts of one
//! coordinate alone. Every new motion is checked like an edge; the path never gets longer, and can be taken at any time.

use super::partial_shortcut::partial_shortcut;
use super::reduce::Reduction;
use super::shortcut::shortcut;
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::space::Space;

/// What is to be done to a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wanted {
    /// Whether vertices are left out where the path can do without.
    pub reduce: bool,
    /// How many shortcuts are tried.
    pub shortcuts: u64,
    /// How many shortcuts of one coordinate are tried.
    pub partial_shortcuts: u64,
}

/// A path being improved.
#[derive(Debug, Clone)]
pub struct Improvement<S: Space> {
    path: Vec<S::State>,
    random: Random,
    reduction: Option<Reduction>,
    left: Wanted,
    attempts: u64,
    motion_checks: u64,
}

impl<S: Space> Improvement<S> {
    /// Starts from a proven path.
    pub fn new(path: Vec<S::State>, wanted: Wanted, seed: u64) -> Self {
        let random = Random::new(seed, Stream::Shortcut);
        let reduction = wanted.reduce.then(|| Reduction::new(path.len()));
        Self { path, random, reduction, left: wanted, attempts: 0, motion_checks: 0 }
    }

    /// Whether all that was wanted is done.
    pub fn is_done(&self) -> bool {
        self.reduction.as_ref().is_none_or(Reduction::is_done)
            && self.left.shortcuts == 0
            && self.left.partial_shortcuts == 0
    }

    /// Makes one attempt. O(path) and as many motion checks at most.
    pub fn attempt(&mut self, problem: &Problem<S>) {
        self.attempts += 1;
        if let Some(reduction) = self.reduction.as_mut().filter(|reduction| !reduction.is_done()) {
            reduction.attempt(problem, &mut self.path, &mut self.motion_checks);
        } else if self.left.shortcuts > 0 {
            self.left.shortcuts -= 1;
            shortcut(problem, &mut self.path, &mut self.random, &mut self.motion_checks);
        } else if self.left.partial_shortcuts > 0 {
            self.left.partial_shortcuts -= 1;
            partial_shortcut(problem, &mut self.path, &mut self.random, &mut self.motion_checks);
        }
    }

    /// The path as it is now.
    pub fn path(&self) -> &[S::State] {
        &self.path
    }

    /// How many attempts were made.
    pub fn attempts(&self) -> u64 {
        self.attempts
    }

    /// How many motions were checked.
    pub fn motion_checks(&self) -> u64 {
        self.motion_checks
    }
}

/// Whether all motions from state to state are free, counted.
pub(super) fn is_free<S: Space>(problem: &Problem<S>, states: &[S::State], checks: &mut u64) -> bool {
    states.windows(2).all(|pair| {
        *checks += 1;
        problem.validity().is_motion_free(&pair[0], &pair[1])
    })
}

/// A place on a path: which edge, and the state there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<S> {
    pub edge: usize,
    pub state: S,
}

/// Two places drawn uniformly along the path, in its direction, on different edges; `None` where they are not.
pub(super) fn two_places<S: Space>(space: &S, path: &[S::State], random: &mut Random) -> Option<[Place<S::State>; 2]> {
    let total = super::length(space, path);
    let [first, second] = [0, 1].map(|_| random.uniform() * total);
    let (from, to) = (place(space, path, first.min(second))?, place(space, path, first.max(second))?);
    (from.edge != to.edge).then_some([from, to])
}

/// The place at the given distance along the path.
fn place<S: Space>(space: &S, path: &[S::State], along: f64) -> Option<Place<S::State>> {
    let mut left = along;
    for (edge, pair) in path.windows(2).enumerate() {
        let distance = space.distance(&pair[0], &pair[1]);
        if left <= distance && distance > 0.0 {
            let state = space.interpolate(&pair[0], &pair[1], left / distance);
            return Some(Place { edge, state });
        }
        left -= distance;
    }
    None
}

/// The path with all between two places replaced by other states, none twice in a row.
pub(super) fn replaced<S: Space>(
    path: &[S::State],
    [from, to]: [Place<S::State>; 2],
    between: &[S::State],
) -> Vec<S::State> {
    let mut new = path[..=from.edge].to_vec();
    let middle = std::iter::once(from.state).chain(between.iter().copied()).chain(std::iter::once(to.state));
    for state in middle.chain(path[to.edge + 1..].iter().copied()) {
        if new.last() != Some(&state) {
            new.push(state);
        }
    }
    new
}
