//! Which turns between waypoints a car can drive.
//!
//! A car that drives from one waypoint to the next with a constant steering angle follows an arc. Its chord lies along the
//! heading in the middle of the turn. What the waypoints differ from that chord sideways, the car would have to slide. The
//! curvature is the turn divided by the length of the arc.

use crate::geometry::{arc_length, wrap};
use crate::robot::Car;
use serde::Serialize;

/// The most turns that are listed.
pub const MOST_TURNS: usize = 100;

/// What rounding may do, in metres and radians, relative to coordinates larger than a metre.
const ROUNDING: f64 = 1e-9;

/// The turns of a path between its waypoints that a car cannot drive.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Turns {
    /// How many there are.
    pub count: usize,
    /// The first of them, at most [`MOST_TURNS`].
    pub first: Vec<Turn>,
    /// The least radius among the turns of all edges, in metres; `None` of a straight path.
    pub least_radius: Option<f64>,
    /// The largest angle between the way and the heading in the middle of an edge, in radians, of edges longer than rounding.
    pub largest_slip: f64,
}

/// A turn that a car cannot drive.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Turn {
    /// The edge, by the index of the waypoint that it begins at, from 0.
    pub edge: usize,
    /// Why.
    pub fault: TurnFault,
    /// The radius of its arc, in metres: 0 on the spot. `None` if it is straight.
    pub radius: Option<f64>,
    /// The angle between the way and the heading in the middle, in radians from 0 to pi / 2.
    pub slip: f64,
}

/// Why a car cannot drive a turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum TurnFault {
    /// The car would slide sideways.
    Sideways,
    /// The turn is tighter than the steering allows.
    TooTight,
    /// The car would drive in a direction in which it has no speed.
    NoSpeed,
}

/// The turns of a path. O(n).
pub(super) fn of(car: &Car, path: &[Vec<f64>], tolerance: f64) -> Turns {
    let mut turns = Turns { count: 0, first: Vec::new(), least_radius: None, largest_slip: 0.0 };
    let [right, left] = car.steering().map(|angle| libm::tan(angle) / car.wheelbase());
    let [slowest, fastest] = car.speed();
    for (edge, ends) in path.windows(2).enumerate() {
        let (a, b) = (&ends[0], &ends[1]);
        let rounding = ROUNDING * [a, b].iter().flat_map(|q| &q[..2]).fold(1.0, |most: f64, x| most.max(x.abs()));
        let turn = wrap(wrap(b[2]) - wrap(a[2]));
        let (sin, cos) = libm::sincos(wrap(a[2]) + 0.5 * turn);
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        let [along, aside] = [x * cos + y * sin, y * cos - x * sin];
        let length = arc_length(along, turn);
        let is_turn = turn.abs() > ROUNDING;
        let is_moved = along.abs().max(aside.abs()) > rounding;
        let radius = is_turn.then(|| if is_moved { (length / turn).abs() } else { 0.0 });
        let slip = if is_moved { libm::atan2(aside.abs(), along.abs()) } else { 0.0 };
        turns.largest_slip = turns.largest_slip.max(slip);
        turns.least_radius = match (turns.least_radius, radius) {
            (Some(least), Some(radius)) => Some(least.min(radius)),
            (least, radius) => least.or(radius),
        };
        // The turns to either side that the arc allows.
        let [one, other] = [right, left].map(|curvature| curvature * length * (1.0 + tolerance));
        let is_steered = (one.min(other) - ROUNDING..=one.max(other) + ROUNDING).contains(&turn);
        let has_speed = if along > 0.0 { fastest > 0.0 } else { slowest < 0.0 };
        let fault = match () {
            () if aside.abs() > tolerance * libm::hypot(x, y) + rounding => TurnFault::Sideways,
            () if !is_steered => TurnFault::TooTight,
            () if along.abs() > rounding && !has_speed => TurnFault::NoSpeed,
            () => continue,
        };
        turns.count += 1;
        if turns.first.len() < MOST_TURNS {
            turns.first.push(Turn { edge, fault, radius, slip });
        }
    }
    turns
}
