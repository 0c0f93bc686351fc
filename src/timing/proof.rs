//! The proof of a trajectory: in closed form, for every time and not at samples.
//!
//! Between two knots u grows with a constant second derivative r, so that x, the square of its rate, is linear in u. A coordinate
//! has the velocity q' sqrt(x) and the acceleration q' r + q'' x, with q' linear in u and q'' constant. So the acceleration is
//! linear in u, and its norm largest at an end; the square of the speed is a cubic, and largest at an end or where it is level.

use super::curve::{Curve, norm};
use super::differential::is_driven;
use super::limits::{Bound, Limits};
use super::profile::Knot;
use super::trajectory::{Piece, Trajectory, lasting};
use crate::error::Error;

/// How much a limit may be exceeded: the rounding of a document.
const EXCESS: f64 = 1e-9;

/// How far positions may jump between pieces, relative to the coordinates, and velocities, relative to the fastest ones there.
const APART: f64 = 1e-8;

/// How far the rate at a knot may differ from that to which the phase before leads, relative to the greatest one of the piece.
const LED: f64 = 1e-9;

/// The largest share of its limit that any speed has, and any acceleration.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Shares {
    pub speed: f64,
    pub acceleration: f64,
}

impl Shares {
    /// By how much the time has to be stretched to be within all limits.
    pub fn stretch(&self) -> f64 {
        self.speed.max(self.acceleration.sqrt())
    }

    fn with(&mut self, other: Self) {
        self.speed = self.speed.max(other.speed);
        self.acceleration = self.acceleration.max(other.acceleration);
    }
}

/// The shares of all pieces. O(knots).
pub(super) fn shares(limits: &Limits, pieces: &[Piece]) -> Shares {
    let mut shares = Shares::default();
    for piece in pieces {
        let bounds = limits.bounds(&piece.curve);
        for knots in piece.knots.windows(2) {
            shares.with(match piece.curve {
                Curve::Arc { length, turn, .. } => along(limits, length, turn, knots),
                _ => between(&bounds, knots),
            });
        }
    }
    shares
}

/// The squares of the rates at the ends of a phase: by its second derivative, or as the second knot has it, if that is more.
fn squares([from, to]: [&Knot; 2]) -> [f64; 2] {
    let x = from[1] * from[1];
    [x, (to[1] * to[1]).max(x + 2.0 * from[2] * (to[0] - from[0]))]
}

fn between(bounds: &[Bound], knots: &[Knot]) -> Shares {
    let [from, to] = [&knots[0], &knots[1]];
    let x = squares([from, to]);
    let mut shares = Shares::default();
    for bound in bounds {
        let speed = bound.speed_share([[from[0], x[0]], [to[0], x[1]]]).sqrt();
        let ends = [(from[0], x[0]), (to[0], x[1])].map(|(u, x)| bound.acceleration_share(u, x, from[2]));
        shares.with(Shares { speed, acceleration: ends[0].max(ends[1]) });
    }
    shares
}

/// On an arc all is largest where it is fastest.
fn along(limits: &Limits, length: f64, turn: f64, knots: &[Knot]) -> Shares {
    let Limits::Car(limits) = limits else { return Shares { speed: f64::INFINITY, acceleration: f64::INFINITY } };
    let [x, y] = squares([&knots[0], &knots[1]]);
    let most = x.max(y);
    let across = limits.lateral_acceleration.map_or(0.0, |limit| (length * turn).abs() * most / limit);
    let acceleration = (length * knots[0][2]).abs() / limits.acceleration;
    Shares { speed: length.abs() * most.sqrt() / limits.speed, acceleration: acceleration.max(across) }
}

/// Proves that a trajectory goes forward from rest to rest, without a jump of position or velocity, and within its limits. Of a
/// car the speed along the path is continuous; its turn rate jumps with the curvature. With differential limits, also that the
/// robot never moves sideways or backward. O(knots).
///
/// # Errors
/// `invalid-result` with the pointer of the piece
pub(super) fn check(trajectory: &Trajectory) -> Result<(), Error> {
    let Trajectory { pieces, limits, .. } = trajectory;
    for (i, piece) in pieces.iter().enumerate() {
        check_knots(&piece.knots, &format!("/pieces/{i}/knots"))?;
    }
    let invalid = |i: usize, sentence: &str| Err(Trajectory::invalid(format!("/pieces/{i}"), sentence));
    if matches!(limits, Limits::Differential(_))
        && let Some(i) = pieces.iter().position(|piece| !is_driven(&piece.curve))
    {
        return invalid(i, "the robot neither drives along its heading nor turns on the spot");
    }
    let mut place = trajectory.start.clone();
    // The velocity there, and the fastest one near it.
    let mut velocity = (vec![0.0; place.len()], 0.0);
    for (i, piece) in pieces.iter().enumerate() {
        let ends = [&piece.knots[0], &piece.knots[piece.knots.len() - 1]];
        let [begin, end] = [piece.curve.jet(0.0), piece.curve.jet(1.0)];
        let speed = |k: usize| piece.curve.fastest() * ends[k][1];
        let size = place.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        if !is_near(&place, &begin[0], APART * size) {
            return invalid(i, "the piece begins elsewhere than the one before ends");
        }
        let entry = moving(&piece.curve, &begin[1], ends[0][1]);
        if !is_near(&velocity.0, &entry, APART * speed(0).max(velocity.1)) {
            return invalid(i, "the piece begins with another velocity than the one before ends with");
        }
        velocity = (moving(&piece.curve, &end[1], ends[1][1]), speed(1));
        place = end[0].clone();
    }
    if norm(&velocity.0) > 0.0 {
        return invalid(pieces.len() - 1, "it does not end at rest");
    }
    let Shares { speed, acceleration } = shares(limits, pieces);
    for (what, share) in [("speed", speed), ("acceleration", acceleration)] {
        if share.is_nan() || share > 1.0 + EXCESS {
            return Err(Trajectory::invalid("/pieces", format!("the {what} is {share} of its limit")));
        }
    }
    Ok(())
}

/// The velocity that has to be continuous.
fn moving(curve: &Curve, slope: &[f64], rate: f64) -> Vec<f64> {
    let along = if matches!(curve, Curve::Arc { .. }) { &slope[..2] } else { slope };
    let mut velocity: Vec<f64> = along.iter().map(|slope| slope * rate).collect();
    velocity.resize(slope.len(), 0.0);
    velocity
}

fn is_near(a: &[f64], b: &[f64], most: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= most)
}

/// The knots of a piece go from 0 to 1, and each follows from the one before.
fn check_knots(knots: &[Knot], pointer: &str) -> Result<(), Error> {
    let invalid = |sentence: &str| Err(Trajectory::invalid(pointer, sentence));
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else { return invalid("the piece has no knots") };
    if first[0] != 0.0 || last[0] != 1.0 || last[2] != 0.0 {
        return invalid("the knots begin with 0, and end with 1 and no second derivative");
    }
    let fastest = knots.iter().fold(0.0, |most: f64, knot| most.max(knot[1] * knot[1]));
    for (from, to) in knots.iter().zip(&knots[1..]) {
        let time = lasting(from, to);
        if !(from[0] < to[0] && from[1] >= 0.0 && to[1] >= 0.0 && time > 0.0 && time < f64::INFINITY) {
            return invalid("the fraction grows from knot to knot, with rates that are not negative");
        }
        let led = from[1] * from[1] + 2.0 * from[2] * (to[0] - from[0]);
        let off = (led - to[1] * to[1]).abs();
        if off.is_nan() || off > LED * fastest {
            return invalid("the second derivative at a knot does not lead to the rate at the next");
        }
    }
    Ok(())
}
