//! Where the tip of an arm is, how it moves with the joints, and how well.

use super::singular::Singular;
use super::target::Target;
use super::task::Task;
use crate::robot::{Arm, MAX_LINKS};
use crate::space::wrap;

/// The absolute angle of the last link at `q`, in (-pi, pi].
pub fn orientation(q: &[f64]) -> f64 {
    wrap(q.iter().sum())
}

/// The Jacobian of the tip's place at `q` (as many angles as links, in radians): how x and y move with each joint, in metres a
/// radian. Two rows; entries past the last link are 0. O(links).
pub fn jacobian(arm: &Arm, q: &[f64]) -> [[f64; MAX_LINKS]; 2] {
    let [x, y, _] = linear(arm, q).jacobian;
    [x, y]
}

/// The singular values of the Jacobian of the tip's place at `q`, the larger first, in metres a radian.
pub fn singular_values(arm: &Arm, q: &[f64]) -> [f64; 2] {
    let [large, small, _] = Singular::of(&linear(arm, q)).values();
    [large, small]
}

/// The manipulability of the arm's tip at `q`: the square root of det(J J^T), the product of the singular values of the
/// Jacobian, in square metres; 0 where the arm is singular, and always for an arm of one link. O(links).
///
/// Source: Yoshikawa 1985, "Manipulability of robotic mechanisms".
pub fn manipulability(arm: &Arm, q: &[f64]) -> f64 {
    let [large, small] = singular_values(arm, q);
    large * small
}

fn linear(arm: &Arm, q: &[f64]) -> super::task::Linear {
    let mut angles = [0.0; MAX_LINKS];
    angles[..arm.links().len()].copy_from_slice(q);
    Task::new(arm, &Target { point: arm.base(), orientation: None }).linear(&angles)
}
