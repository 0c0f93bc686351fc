//! The position of an arm's tip, how it moves with the joints, and how well.

use super::task::{Linear, Task};
use crate::robot::{Arm, MAX_LINKS, Target};
use crate::space::wrap;
use nalgebra::{Const, SMatrix, SVD, Vector3};

/// The absolute angle of the last link at `q`, in (-pi, pi].
pub fn orientation(arm: &Arm, q: &[f64]) -> f64 {
    wrap(arm.last_angle(q))
}

/// The Jacobian of the tip's position at `q` (as many coordinates as links): how x and y move with each joint, in metres per
/// radian, or per metre of a prismatic joint. Two rows; entries past the last link are 0. O(links).
pub fn jacobian(arm: &Arm, q: &[f64]) -> [[f64; MAX_LINKS]; 2] {
    let [x, y, _] = linear(arm, q).jacobian;
    [x, y]
}

/// The speed of the tip at `q` where the coordinates change at these rates, in metres per second. O(links).
pub fn tip_speed(arm: &Arm, q: &[f64], rates: &[f64]) -> f64 {
    let [x, y] = jacobian(arm, q).map(|row| row.iter().zip(rates).map(|(entry, rate)| entry * rate).sum::<f64>());
    libm::hypot(x, y)
}

/// The singular values of the Jacobian of the tip's position at `q`, the larger first, in metres per radian, a metre of a
/// prismatic joint counted as a radian.
pub fn singular_values(arm: &Arm, q: &[f64]) -> [f64; 2] {
    let [large, small, _] = Singular::of(&linear(arm, q)).0.singular_values.into();
    [large, small]
}

/// The manipulability of the arm's tip at `q`: the square root of det(J J^T), the product of the singular values of the
/// Jacobian, in square metres; 0 if the arm is singular, and always for an arm of one link. O(links).
///
/// Source: Yoshikawa 1985, "Manipulability of robotic mechanisms".
pub fn manipulability(arm: &Arm, q: &[f64]) -> f64 {
    let [large, small] = singular_values(arm, q);
    large * small
}

fn linear(arm: &Arm, q: &[f64]) -> Linear {
    let mut angles = [0.0; MAX_LINKS];
    angles[..arm.links().len()].copy_from_slice(q);
    let task = Task::new(arm, &Target { point: arm.base(), orientation: None });
    let mut model = task.linear(&angles);
    for i in 0..arm.links().len() {
        model.jacobian.iter_mut().for_each(|row| row[i] /= task.joints.unit(i));
    }
    model
}

/// The singular value decomposition of a Jacobian of three rows, the third 0 without a wanted orientation (Golub and Kahan 1965,
/// "Calculating the singular values and pseudo-inverse of a matrix").
pub(super) struct Singular(SVD<f64, Const<3>, Const<MAX_LINKS>>);

impl Singular {
    /// Decomposes the matrix of a linear model.
    #[inline(never)]
    pub fn of(model: &Linear) -> Self {
        Self(SMatrix::<f64, 3, MAX_LINKS>::from_fn(|row, column| model.jacobian[row][column]).svd(true, true))
    }

    /// The rotation of the joints that best brings about the change `vector`: the sum over k of
    /// s_k (u_k . vector) / weigh(s_k^2) v_k. `weigh` maps the square of a singular value to the divisor; infinity omits the
    /// direction.
    #[inline(never)]
    pub fn solve(&self, vector: &[f64; 3], weigh: &dyn Fn(f64) -> f64) -> [f64; MAX_LINKS] {
        let (Some(left), Some(right)) = (&self.0.u, &self.0.v_t) else { return [0.0; MAX_LINKS] };
        let along = left.tr_mul(&Vector3::from(*vector));
        let shares = along.zip_map(&self.0.singular_values, |along, value| along * value / weigh(value * value));
        right.tr_mul(&shares).into()
    }
}
