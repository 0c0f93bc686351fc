//! The singular values of the linear model of an arm, by nalgebra's decomposition (Golub and Kahan 1965, "Calculating the
//! singular values and pseudo-inverse of a matrix").

use super::task::Linear;
use crate::robot::MAX_LINKS;
use nalgebra::{Const, SMatrix, SVD, Vector3};

/// The decomposition of a Jacobian of three rows; the third is 0 if no orientation is wanted.
pub(super) struct Singular(SVD<f64, Const<3>, Const<MAX_LINKS>>);

impl Singular {
    /// Decomposes the matrix of a linear model. O(links) a round.
    #[inline(never)]
    pub fn of(model: &Linear) -> Self {
        Self(SMatrix::<f64, 3, MAX_LINKS>::from_fn(|row, column| model.jacobian[row][column]).svd(true, true))
    }

    /// The turn that best brings about the change `vector`: the sum over k of s_k (u_k . vector) / weigh(s_k^2) v_k, where
    /// `weigh` is given the square of each singular value and returns what to divide by; infinity leaves the direction out.
    #[inline(never)]
    pub fn solve(&self, vector: &[f64; 3], weigh: &dyn Fn(f64) -> f64) -> [f64; MAX_LINKS] {
        let (Some(left), Some(right)) = (&self.0.u, &self.0.v_t) else { return [0.0; MAX_LINKS] };
        let along = left.tr_mul(&Vector3::from(*vector));
        let shares = along.zip_map(&self.0.singular_values, |along, value| along * value / weigh(value * value));
        right.tr_mul(&shares).into()
    }

    /// The singular values, the largest first.
    pub fn values(&self) -> [f64; 3] {
        self.0.singular_values.into()
    }
}
