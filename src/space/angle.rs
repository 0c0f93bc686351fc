//! Angles on the circle.

pub use crate::steering::wrap;

use std::f64::consts::{PI, TAU};

/// The angle in [0, 2 pi) that differs from the finite `angle` by whole turns, to a rounding.
pub fn unwind(angle: f64) -> f64 {
    let rest = libm::remainder(angle, TAU);
    if rest >= 0.0 { rest + 0.0 } else { (rest + TAU).min(TAU.next_down()) }
}

/// The distance between two angles the short way round, in [0, pi]; any finite angles, any number of turns.
///
/// ```
/// assert_eq!(planarium::space::angular_distance(1.0, 5.0), 2.2831853071795862);
/// ```
pub fn angular_distance(a: f64, b: f64) -> f64 {
    let gap = (wrap(a) - wrap(b)).abs();
    if gap > PI { TAU - gap } else { gap }
}
