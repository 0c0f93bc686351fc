//! Angles in their canonical form.

use std::f64::consts::{PI, TAU};

/// The angle in (-pi, pi] that differs from the finite `angle` by whole turns. Exact for the double nearest to 2 pi.
pub fn wrap(angle: f64) -> f64 {
    let rest = libm::remainder(angle, TAU);
    if rest <= -PI { PI } else { rest + 0.0 }
}
