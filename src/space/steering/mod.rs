//! Steering: the shortest curves of cars that cannot turn on the spot.
//!
//! A car has a pose and a turning radius. [`dubins()`] finds the shortest curve of one that only drives forwards,
//! [`reeds_shepp()`] of one that may also reverse. Lengths are metres, angles radians, counter-clockwise.
//!
//! # How curves are found, and what holds for them
//! The goal is seen from the start, in radii. Every word (a sequence of turns) has a closed solution; the candidates are driven
//! before one is taken, and one that misses the goal is dropped. A curve that is returned ends within 2e-13 (radius + distance +
//! largest coordinate) of the goal and within 2e-13 of its heading. Words of one and two segments have to fit that closely only:
//! rounding of a pose on a curve adds neither a loop nor a change of gear. Of curves as long as each other, to 1e-12, the first
//! in the order of the words is taken. There is always a curve: one turn, a straight line and another turn lead to every pose.
//!
//! Before a word is solved, its length is bounded from below without trigonometric functions, from the cosines of its
//! angles. A word whose bound exceeds the shortest length so far, or a limit that the caller gives
//! ([`Steering::length_within`]), is not solved. This changes no bit.

mod curve;
mod dubins;
mod goal;
mod reeds_shepp;

pub use crate::geometry::wrap;
pub use curve::{Curve, MAX_SEGMENTS};
pub use dubins::dubins;
pub use reeds_shepp::reeds_shepp;

use crate::geometry::arc_pose;

/// The position and heading of a car.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// In metres.
    pub x: f64,
    /// In metres.
    pub y: f64,
    /// In radians from the x axis.
    pub heading: f64,
}

/// The pose after `length` signed metres, negative in reverse, of a motion of constant `curvature` in 1/m, positive to the
/// left: that of [`arc_pose`] at a metre a second, in canonical form. O(1).
pub fn advance(from: Pose, curvature: f64, length: f64) -> Pose {
    let [x, y, heading] = arc_pose([from.x, from.y, from.heading], 1.0, curvature, length);
    Pose { x: x + 0.0, y: y + 0.0, heading: wrap(heading) }
}

/// The curves of a car from pose to pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr, strum::VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Steering {
    /// Forwards only.
    Dubins,
    /// Forwards and in reverse.
    ReedsShepp,
}

impl Steering {
    /// The shortest curve from one pose to another for a turning radius in metres, greater than 0.
    pub fn shortest(self, from: Pose, to: Pose, radius: f64) -> Curve {
        match self {
            Steering::Dubins => dubins(from, to, radius),
            Steering::ReedsShepp => reeds_shepp(from, to, radius),
        }
    }

    /// The length of the [`shortest`](Self::shortest) curve, to the bit, if it is at most `most` metres; else any number greater
    /// than `most`, found the faster the less `most` is.
    pub fn length_within(self, from: Pose, to: Pose, radius: f64, most: f64) -> f64 {
        let curve = match self {
            Steering::Dubins => dubins::within(from, to, radius, most),
            Steering::ReedsShepp => reeds_shepp::within(from, to, radius, most),
        };
        curve.map_or(f64::INFINITY, |curve| curve.length())
    }

    /// Whether every curve can be driven in reverse.
    #[inline]
    pub fn is_symmetric(self) -> bool {
        self == Steering::ReedsShepp
    }
}

/// The turn of a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// An arc to the left of a car that drives forwards.
    Left,
    /// A straight line.
    Straight,
    /// An arc to the right of a car that drives forwards.
    Right,
}

impl Turn {
    /// The same seen in a mirror.
    #[must_use]
    pub fn mirrored(self) -> Self {
        match self {
            Turn::Left => Turn::Right,
            Turn::Straight => Turn::Straight,
            Turn::Right => Turn::Left,
        }
    }
}

/// A piece of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The direction in which the wheel is turned.
    pub turn: Turn,
    /// How far, in metres; negative in reverse.
    pub length: f64,
}
