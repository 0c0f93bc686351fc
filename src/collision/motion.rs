//! Motions of a body: straight ones of its placement, and circular arcs.

use crate::geometry::arc_pose;
use std::f64::consts::{PI, TAU};

/// No straight motion turns an angle by this or more, in radians: the short way round is ambiguous.
pub const LONGEST_TURN: f64 = PI - 1e-9;

/// No arc that is driven turns by more than this, in radians: after more turns, rounding changes its end by more than the
/// slack covers.
pub const LONGEST_DRIVE: f64 = 1e3;

/// An arc that turns by more, in radians, repeats itself; a little more than a whole turn.
const ONE_TURN: f64 = TAU + 1e-9;

/// In how many parts a motion is looked at where boxes around them are enough.
const PARTS: u32 = 4;

/// The middle of each part of a motion, as a fraction of it, and half of the part: no point moves farther from where it is in
/// that middle than this share of the way that it can travel on the motion at constant rates.
pub(super) fn parts_of_motion() -> impl Iterator<Item = (f64, f64)> {
    let half = 0.5 / f64::from(PARTS);
    (0..PARTS).map(move |part| (f64::from(2 * part + 1) * half, half))
}

/// A motion of a body. A placement is (x, y, theta): metres, and radians counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BodyMotion {
    /// All three coordinates change at constant rates, by `delta` in all.
    Straight {
        /// The placement at the start.
        from: [f64; 3],
        /// The change of each coordinate; the angle may turn the long way round.
        delta: [f64; 3],
    },
    /// The body moves along its own x axis and turns, both at constant rates: a circular arc, as wheels draw it.
    Arc {
        /// The placement at the start.
        from: [f64; 3],
        /// The speed along the body's x axis, in metres a second; backward if negative.
        speed: f64,
        /// The turn rate, in radians a second; to the right if negative.
        turn_rate: f64,
        /// How long it lasts, in seconds.
        duration: f64,
    },
}

impl BodyMotion {
    /// The placement at the start.
    pub fn from(&self) -> [f64; 3] {
        match *self {
            Self::Straight { from, .. } | Self::Arc { from, .. } => from,
        }
    }

    /// The placement at fraction `t` of the motion, in [0, 1]. The angle is not wrapped.
    pub fn at(&self, t: f64) -> [f64; 3] {
        match *self {
            Self::Straight { from, delta } => [0, 1, 2].map(|i| from[i] + t * delta[i]),
            Self::Arc { from, speed, turn_rate, duration } => arc_pose(from, speed, turn_rate, t * duration),
        }
    }

    /// The length of the path of the origin of the body's frame, in metres, and the turn of the body, in radians; neither is
    /// negative.
    pub(super) fn extent(&self) -> (f64, f64) {
        match *self {
            Self::Straight { delta: [x, y, theta], .. } => ((x * x + y * y).sqrt(), theta.abs()),
            Self::Arc { speed, turn_rate, duration, .. } => ((speed * duration).abs(), (turn_rate * duration).abs()),
        }
    }

    /// The first part of the motion, `part` of it in [0, 1].
    fn first(&self, part: f64) -> Self {
        match *self {
            Self::Straight { from, delta } => Self::Straight { from, delta: delta.map(|d| d * part) },
            Self::Arc { from, speed, turn_rate, duration } => {
                Self::Arc { from, speed, turn_rate, duration: duration * part }
            }
        }
    }

    /// The longest part of the motion that can be free if none longer than `longest` metres can, and its fraction of the
    /// whole. An arc of several turns passes the same placements again and again: its first turn decides.
    pub(super) fn decisive_part(&self, longest: f64) -> (Self, f64) {
        let (path, turn) = self.extent();
        let mut part = 1.0;
        if turn > ONE_TURN && matches!(self, Self::Arc { .. }) {
            part = ONE_TURN / turn;
        }
        if path * part > longest {
            part = longest / path;
        }
        if part < 1.0 { (self.first(part), part) } else { (*self, 1.0) }
    }
}
