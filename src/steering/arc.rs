//! Where a car is after driving with a constant turn of the wheel.

use super::{Pose, wrap};
use crate::geometry::arc_pose;

/// The pose after `length` signed metres, negative in reverse, of a motion of constant `curvature` in 1/m, positive to the
/// left: that of [`arc_pose`] at a metre a second, in canonical form. O(1).
pub fn advance(from: Pose, curvature: f64, length: f64) -> Pose {
    let [x, y, heading] = arc_pose([from.x, from.y, from.heading], 1.0, curvature, length);
    Pose { x: x + 0.0, y: y + 0.0, heading: wrap(heading) }
}
