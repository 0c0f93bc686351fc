//! The improvement of a path, one attempt at a time: first its vertices are reduced, then come shortcuts, then shortcuts of one
//! coordinate alone; at last its corners are rounded. Every new motion is checked like an edge; the path never costs more, and
//! is valid at any time.

mod blend;
mod priced;
mod reduce;
mod shortcut;

pub use blend::{Blending, blend_saving};

use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::space::Space;
use priced::Priced;
use reduce::Reduction;
use shortcut::{partial_shortcut, shortcut};

/// The most that one step of a resulting path turns a circle joint, in radians: well below the half turn at which the shorter
/// direction becomes ambiguous.
pub const LONGEST_TURN: f64 = 3.0;

/// The same path with steps that turn a joint by more than [`LONGEST_TURN`] cut into equal ones that do not.
pub fn split<S: Space>(space: &S, path: &[S::State]) -> Vec<S::State> {
    let mut split: Vec<S::State> = path.first().copied().into_iter().collect();
    for pair in path.windows(2) {
        let pieces = libm::ceil(space.sweep(&pair[0], &pair[1]) / LONGEST_TURN);
        for piece in 1..pieces as u32 {
            split.push(space.interpolate(&pair[0], &pair[1], f64::from(piece) / pieces));
        }
        split.push(pair[1]);
    }
    split
}

/// The improvements wanted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wanted {
    /// Whether vertices that the path does not need are removed.
    pub reduce: bool,
    /// The number of shortcuts to try.
    pub shortcuts: u64,
    /// The number of shortcuts of one coordinate to try.
    pub partial_shortcuts: u64,
    /// How far from a corner its blend may begin, as a fraction of the shorter edge at it; 0 for no blends, and no
    /// more than 1/2 counts.
    pub blend: f64,
}

/// A path that is being improved.
#[derive(Debug, Clone)]
pub struct Improvement<S: Space> {
    path: Priced<S>,
    random: Random,
    reduction: Option<Reduction>,
    left: Wanted,
    /// The blends, once the corners are final.
    blending: Option<Blending<S>>,
    /// The number of attempts made.
    pub attempts: u64,
    /// The number of motions checked.
    pub motion_checks: u64,
}

impl<S: Space> Improvement<S> {
    /// Starts from a proven path.
    pub fn new(path: Vec<S::State>, wanted: Wanted, seed: u64) -> Self {
        let random = Random::new(seed, Stream::Shortcut);
        let reduction = wanted.reduce.then(|| Reduction::new(path.len()));
        Self { path: Priced::new(path), random, reduction, left: wanted, blending: None, attempts: 0, motion_checks: 0 }
    }

    /// Whether all improvements wanted are done: a path without corners has none left.
    pub fn is_done(&self) -> bool {
        self.path().len() < 3
            || self.reduction.as_ref().is_none_or(Reduction::is_done)
                && self.left.shortcuts == 0
                && self.left.partial_shortcuts == 0
                && (self.left.blend == 0.0 || self.blending.as_ref().is_some_and(Blending::is_done))
    }

    /// Makes one attempt, always in the same problem. O(path) and as many motion checks at most.
    pub fn attempt(&mut self, problem: &Problem<S>) {
        self.attempts += 1;
        self.path.price(problem);
        if let Some(reduction) = self.reduction.as_mut().filter(|reduction| !reduction.is_done()) {
            reduction.attempt(problem, &mut self.path, &mut self.motion_checks);
        } else if self.left.shortcuts > 0 {
            self.left.shortcuts -= 1;
            shortcut(problem, &mut self.path, &mut self.random, &mut self.motion_checks);
        } else if self.left.partial_shortcuts > 0 {
            self.left.partial_shortcuts -= 1;
            partial_shortcut(problem, &mut self.path, &mut self.random, &mut self.motion_checks);
        } else {
            let blending = self.blending.get_or_insert_with(|| Blending::new(problem.space(), self.path.states()));
            blending.attempt(problem, self.left.blend, &mut self.motion_checks);
        }
    }

    /// The path with its blends; `None` before the first corner is tried.
    pub fn blending(&self) -> Option<&Blending<S>> {
        self.blending.as_ref()
    }

    /// The path as it is now, with its corners.
    pub fn path(&self) -> &[S::State] {
        self.path.states()
    }
}

/// Whether all motions from state to state are free, counted.
fn is_free<S: Space>(problem: &Problem<S>, states: &[S::State], checks: &mut u64) -> bool {
    states.windows(2).all(|pair| {
        *checks += 1;
        problem.validity().is_motion_free(&pair[0], &pair[1])
    })
}

/// The length of a path: the sum of the space's distances between its states.
pub fn length<S: Space>(space: &S, path: &[S::State]) -> f64 {
    // The sum of nothing is -0.
    path.windows(2).map(|pair| space.distance(&pair[0], &pair[1])).sum::<f64>() + 0.0
}
