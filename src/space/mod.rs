//! Configuration spaces: metric, interpolation, sampling. One file a space; laws that hold on each are tests.
//!
//! A state is a small `Copy` value in canonical form: finite, angles of circle joints in (-pi, pi], never -0. Arrays of
//! `N` numbers serve every dimension up to `N`: entries past [`Space::dimension`] are 0 and add exactly nothing.

mod angle;
mod gap;
mod motion;
mod torus;

pub use angle::{angular_distance, unwind, wrap};
pub use gap::{gap, gap_to_interval};
pub use motion::MotionSpace;
pub use torus::{Joint, Metric, Torus};

use crate::random::Random;
use crate::steering::Curve;

/// The most numbers that a configuration has.
pub const MAX_DIMENSION: usize = 8;

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

    /// The distance from `a` to `b`: 0 for equal states, never longer than a way round, but for rounding, and symmetric where
    /// [`Space::is_symmetric`] says so.
    fn distance(&self, a: &Self::State, b: &Self::State) -> f64;

    /// The state a fraction `t` in [0, 1] along the motion from `a` to `b`; exactly `a` at 0 and `b` at 1.
    fn interpolate(&self, a: &Self::State, b: &Self::State, t: f64) -> Self::State;

    /// The state at a place of the unit cube [0, 1)^dimension: a place drawn uniformly gives a state drawn uniformly.
    ///
    /// # Panics
    /// Where there are fewer numbers than `dimension`.
    fn at(&self, place: &[f64]) -> Self::State;

    /// A state drawn uniformly.
    fn sample(&self, random: &mut Random) -> Self::State {
        let mut place = [0.0; MAX_DIMENSION];
        let place = &mut place[..self.dimension()];
        place.iter_mut().for_each(|unit| *unit = random.uniform());
        self.at(place)
    }

    /// Whether the state lies within the limits of the space.
    fn contains(&self, state: &Self::State) -> bool;

    /// The largest distance between two states.
    fn extent(&self) -> f64;

    /// The largest turn of a circle joint between the two states, in radians; 0 without circle joints.
    fn turn(&self, a: &Self::State, b: &Self::State) -> f64;

    /// The largest turn of any joint whose angles mean the same a whole turn later, in radians: what bounds the steps of
    /// an emitted path, which is driven the short way round. [`Space::turn`] but where a circle was cut open.
    fn sweep(&self, a: &Self::State, b: &Self::State) -> f64 {
        self.turn(a, b)
    }

    /// What a whole turn of coordinate `i` measures: 2 pi on a circle, infinity where nothing wraps.
    fn period(&self, i: usize) -> f64;

    /// The metric as a function of the coordinates' gaps, for `L` pairs of states at once: `gap(i)` gives those of coordinate
    /// `i`. With [`gap()`] between the numbers of two states it is their `distance`, to the bit, or, where
    /// [`Space::is_norm_exact`] says no, never above it in either direction; it must not fall where a gap grows, in floating point too, which holds for what is made of sums, products and roots of numbers that are not negative.
    /// So with [`gap_to_interval`] it is a lower bound on the distance to every state in a box. O(`L` dimension).
    fn norm<const L: usize>(&self, gap: impl FnMut(usize) -> [f64; L]) -> [f64; L];

    /// Whether all motions can be made back, and `distance` is symmetric, to the bit. Where not, `distance(a, b)` and all
    /// motions are directed from `a` to `b`.
    #[inline]
    fn is_symmetric(&self) -> bool {
        true
    }

    /// Whether [`Space::norm`] is the distance, and not only a lower bound.
    #[inline]
    fn is_norm_exact(&self) -> bool {
        true
    }

    /// The curve that the motion from `a` to `b` follows, in spaces of steered motions; `None` where motions are straight in the
    /// coordinates. It ends at `b` but for rounding: see [`steering`](crate::steering).
    fn curve(&self, a: &Self::State, b: &Self::State) -> Option<Curve> {
        let _ = (a, b);
        None
    }
}
