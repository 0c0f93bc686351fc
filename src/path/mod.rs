//! Paths: length, splitting, proven improvements, blends of corners, and the independent verifier.

mod blend;
mod improve;
mod reduce;
mod result;
mod shortcut;
mod verify;

pub use blend::{Blending, blend_saving};
pub use improve::{Improvement, Wanted};
pub use result::{Approximate, ResultDocument};
pub use verify::{Leg, Verdict, verify, verify_legs};

use crate::space::Space;

/// The most that one step of a resulting path turns a circle joint, in radians: well below the half turn at which the shorter
/// direction becomes ambiguous.
pub const LONGEST_TURN: f64 = 3.0;

/// The length of a path: the sum of the space's distances between its states.
pub fn length<S: Space>(space: &S, path: &[S::State]) -> f64 {
    // The sum of nothing is -0.
    path.windows(2).map(|pair| space.distance(&pair[0], &pair[1])).sum::<f64>() + 0.0
}

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
