//! Paths: length, splitting, proven shortcuts, and the independent judge.

mod shortcut;
mod verify;

pub use shortcut::Shortcut;
pub use verify::{Verdict, verify};

use crate::space::Space;

/// The most that one step of an emitted path turns a circle joint, in radians: well short of the half turn at which the
/// short way round becomes ambiguous.
pub const LONGEST_TURN: f64 = 3.0;

/// The length of a path: the sum of the space's distances between its states.
pub fn length<S: Space>(space: &S, path: &[S::State]) -> f64 {
    // The sum of nothing is -0.
    path.windows(2).map(|pair| space.distance(&pair[0], &pair[1])).sum::<f64>() + 0.0
}

/// The same path with steps that turn a circle joint by more than [`LONGEST_TURN`] halved.
pub fn split<S: Space>(space: &S, path: &[S::State]) -> Vec<S::State> {
    let mut split: Vec<S::State> = path.first().copied().into_iter().collect();
    for pair in path.windows(2) {
        if space.turn(&pair[0], &pair[1]) > LONGEST_TURN {
            split.push(space.interpolate(&pair[0], &pair[1], 0.5));
        }
        split.push(pair[1]);
    }
    split
}
