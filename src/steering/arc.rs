//! Where a car is after driving with a constant turn of the wheel.

use super::{Pose, wrap};

/// The pose after `length` signed metres, negative in reverse, of a motion of constant `curvature` in 1/m, positive to the
/// left. O(1).
///
/// A chord of the circle is as long as the arc times sinc of half the turn, and points half the turn to the side. Written
/// so, nothing cancels where the turn is small, and a straight line is no special case.
pub fn advance(from: Pose, curvature: f64, length: f64) -> Pose {
    let half = 0.5 * curvature * length;
    let chord = length * sinc(half);
    let (sin, cos) = libm::sincos(from.heading + half);
    Pose { x: from.x + chord * cos + 0.0, y: from.y + chord * sin + 0.0, heading: wrap(from.heading + 2.0 * half) }
}

/// sin(x) / x, and 1 at 0.
fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::sin(x) / x }
}
