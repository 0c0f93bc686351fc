//! Angles on the circle, and motion along circular arcs.

use std::f64::consts::{PI, TAU};

/// The angle in (-pi, pi] that differs from the finite `angle` by whole turns. Exact for the double nearest to 2 pi. O(1).
#[inline]
pub fn wrap(angle: f64) -> f64 {
    // The remainder of an angle in range is the angle.
    if -PI < angle && angle <= PI {
        return angle + 0.0;
    }
    let rest = libm::remainder(angle, TAU);
    if rest <= -PI { PI } else { rest + 0.0 }
}

/// The angle in [0, 2 pi) that differs from the finite `angle` by whole turns, to a rounding. O(1).
pub fn unwind(angle: f64) -> f64 {
    let rest = libm::remainder(angle, TAU);
    if rest >= 0.0 { rest + 0.0 } else { (rest + TAU).min(TAU.next_down()) }
}

/// The distance between two angles in the shorter direction, in [0, pi]; any finite angles, any number of turns. O(1).
///
/// ```
/// assert_eq!(planarium::geometry::angular_distance(1.0, 5.0), 2.2831853071795862);
/// ```
pub fn angular_distance(a: f64, b: f64) -> f64 {
    let gap = (wrap(a) - wrap(b)).abs();
    if gap > PI { TAU - gap } else { gap }
}

/// The pose of a body that has moved for `time` seconds from (x, y, theta) with constant speed along its own x axis, in
/// metres per second, and constant turn rate, in radians per second: exact except for rounding, straight motion and turning in
/// place included. Negative speeds and times move backwards. The angle is not wrapped. O(1).
///
/// The position is a chord of the arc away: with s = speed x time and a = turn rate x time, s sin(a / 2) / (a / 2) metres in
/// direction theta + a / 2. Nothing cancels if the turn is small.
pub fn arc_pose(from: [f64; 3], speed: f64, turn_rate: f64, time: f64) -> [f64; 3] {
    let [x, y, theta] = from;
    let turn = turn_rate * time;
    let half = 0.5 * turn;
    let shortening = if half == 0.0 { 1.0 } else { libm::sin(half) / half };
    let chord = speed * time * shortening;
    let (sin, cos) = libm::sincos(theta + half);
    [x + chord * cos, y + chord * sin, theta + turn]
}

/// The same by one step of Euler's explicit method: along the heading at the beginning, then turned. The error of a step grows
/// with the square of `time`.
pub fn euler_pose([x, y, theta]: [f64; 3], speed: f64, turn_rate: f64, time: f64) -> [f64; 3] {
    let along = speed * time;
    let (sin, cos) = libm::sincos(theta);
    [x + along * cos, y + along * sin, theta + turn_rate * time]
}

/// The length of the arc that turns by an angle over a chord, in metres and radians, negative for a negative chord: the way back
/// of [`arc_pose`]. O(1).
pub(crate) fn arc_length(chord: f64, turn: f64) -> f64 {
    let half = 0.5 * turn;
    if half == 0.0 { chord } else { chord * half / libm::sin(half) }
}
