//! The singular values of a matrix of two or three rows and up to eight columns, such as the Jacobian of a planar arm.
//!
//! One-sided Jacobi rotations (Hestenes 1958, "Inversion of matrices by biorthogonalization and related results"): pairs of
//! rows are turned until all are perpendicular. Small singular values come out as precise as large ones, which they do not
//! where the matrix is multiplied by its transpose first.

use super::task::Linear;
use crate::robot::MAX_LINKS;

/// The most rounds over all pairs of rows; three are enough for almost any matrix.
const ROUNDS: usize = 30;

/// Rows count as perpendicular once the cosine between them is no larger.
const PERPENDICULAR: f64 = 1e-15;

/// A decomposition: the matrix is the sum over k of the column `left[k]` times the row `rows[k]`.
pub(super) struct Singular {
    /// Orthonormal columns.
    pub left: [[f64; 3]; 3],
    /// Perpendicular rows; each is a singular value times a unit vector.
    pub rows: [[f64; MAX_LINKS]; 3],
    /// The squares of the singular values, not in order.
    pub squares: [f64; 3],
    /// How many there are: 2 or 3.
    pub count: usize,
}

impl Singular {
    /// Decomposes the matrix of a linear model. O(links) a round.
    #[inline(never)]
    pub fn of(model: &Linear) -> Self {
        let (mut rows, count) = (model.jacobian, model.rows);
        let mut left = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for _ in 0..ROUNDS {
            let mut is_done = true;
            for a in 0..count {
                for b in a + 1..count {
                    let (aa, bb, ab) = (dot(&rows[a], &rows[a]), dot(&rows[b], &rows[b]), dot(&rows[a], &rows[b]));
                    if ab.abs() <= PERPENDICULAR * (aa * bb).sqrt() {
                        continue;
                    }
                    is_done = false;
                    let slope = (bb - aa) / (2.0 * ab);
                    let tangent = (if slope < 0.0 { -1.0 } else { 1.0 }) / (slope.abs() + (1.0 + slope * slope).sqrt());
                    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
                    turn(&mut rows, a, b, cosine, cosine * tangent);
                    turn(&mut left, a, b, cosine, cosine * tangent);
                }
            }
            if is_done {
                break;
            }
        }
        let squares = [0, 1, 2].map(|k| if k < count { dot(&rows[k], &rows[k]) } else { 0.0 });
        Self { left, rows, squares, count }
    }

    /// The turn that best brings about the change `vector`: the sum over k of v_k (u_k . vector) / weigh(s_k^2) s_k, where
    /// `weigh` is given the square of each singular value and answers what to divide by; infinity leaves the direction out.
    #[inline(never)]
    pub fn solve(&self, vector: &[f64; 3], weigh: &dyn Fn(f64) -> f64) -> [f64; MAX_LINKS] {
        let mut turn = [0.0; MAX_LINKS];
        for k in 0..self.count {
            let along: f64 = (0..self.count).map(|row| self.left[k][row] * vector[row]).sum();
            let share = along / weigh(self.squares[k]);
            for (angle, entry) in turn.iter_mut().zip(&self.rows[k]) {
                *angle += share * entry;
            }
        }
        turn
    }

    /// The singular values, the largest first.
    pub fn values(&self) -> [f64; 3] {
        let mut values = self.squares.map(f64::sqrt);
        for _ in 0..2 {
            for k in 0..2 {
                if values[k] < values[k + 1] {
                    values.swap(k, k + 1);
                }
            }
        }
        values
    }
}

#[inline(never)]
fn dot(a: &[f64; MAX_LINKS], b: &[f64; MAX_LINKS]) -> f64 {
    let mut sum = 0.0;
    for i in 0..MAX_LINKS {
        sum += a[i] * b[i];
    }
    sum
}

/// Turns row `a` against row `b`, which comes later.
fn turn<const N: usize>(rows: &mut [[f64; N]; 3], a: usize, b: usize, cosine: f64, sine: f64) {
    let (before, after) = rows.split_at_mut(b);
    for (x, y) in before[a].iter_mut().zip(&mut after[0]) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
}
