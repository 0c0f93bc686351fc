//! Configuration spaces: metric, interpolation, sampling. One file a space; laws that hold on each are tests.
//!
//! A state is a small `Copy` value in canonical form: finite, angles of circle joints in (-pi, pi], never -0. Arrays of
//! `N` numbers serve every dimension up to `N`: entries past [`Space::dimension`] are 0 and add exactly nothing.

mod angle;
mod euclidean;
mod torus;

pub use angle::{angular_distance, wrap};
pub use euclidean::Euclidean;
pub use torus::{Joint, Metric, Torus};

use crate::random::Random;

/// A configuration space.
pub trait Space {
    /// A configuration in canonical form.
    type State: Copy + std::fmt::Debug + PartialEq;

    /// How many numbers a configuration has.
    fn dimension(&self) -> usize;

    /// The configuration's numbers: `dimension` of them.
    fn coordinates<'a>(&self, state: &'a Self::State) -> &'a [f64];

    /// The canonical state of the given finite numbers, angles in any number of turns.
    ///
    /// # Panics
    /// Where there are fewer numbers than `dimension`.
    fn state(&self, coordinates: &[f64]) -> Self::State;

    /// The distance between two states: symmetric, 0 for equal ones, and never longer than a way round.
    fn distance(&self, a: &Self::State, b: &Self::State) -> f64;

    /// The state a fraction `t` in [0, 1] along the motion from `a` to `b`; exactly `a` at 0 and `b` at 1.
    fn interpolate(&self, a: &Self::State, b: &Self::State, t: f64) -> Self::State;

    /// A state drawn uniformly.
    fn sample(&self, random: &mut Random) -> Self::State;

    /// Whether the state lies within the limits of the space.
    fn contains(&self, state: &Self::State) -> bool;

    /// The largest distance between two states.
    fn extent(&self) -> f64;

    /// The largest turn of a circle joint between the two states, in radians; 0 without circle joints.
    fn turn(&self, a: &Self::State, b: &Self::State) -> f64;
}
