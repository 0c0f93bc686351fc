//! Gradient descent on the squared error, with a line search.

use super::iterative::{Method, widest};
use super::task::{Linear, Task};
use crate::robot::MAX_LINKS;

/// The most that a joint moves in one update, in its unit.
const LARGEST: f64 = 1.0;

/// The fraction of the decrease predicted by the gradient that an update must achieve (Armijo 1966, "Minimization of functions
/// having Lipschitz continuous first partial derivatives").
const PROMISED: f64 = 1e-4;

/// The number of squared errors that a new one is compared with.
const REMEMBERED: usize = 8;

/// The most halvings of a step.
const HALVINGS: usize = 40;

/// The first step is this fraction of the optimal one of the linear model.
const RELAXED: f64 = 0.8;

/// Gradient descent: the joints turn against the gradient of half the squared error. A joint at a limit that it would leave
/// stands still, the others are clamped to theirs. The step length follows from the curvature along the last step (Barzilai and
/// Borwein 1988, "Two-point step size gradient methods"), halved until the squared error is sufficiently below the largest of the
/// last eight (Grippo, Lampariello and Lucidi 1986, "A nonmonotone line search technique for Newton's method"): the error may
/// rise for a while, which takes it through narrow valleys many times faster than a monotone decrease. Linear, and slow if the
/// problem is badly conditioned. O(links) per trial step.
#[derive(Default)]
pub(super) struct GradientDescent {
    /// The last squared errors, and their number.
    squares: [f64; REMEMBERED],
    count: usize,
    /// The previous configuration and the descent direction there.
    last: Option<([f64; MAX_LINKS], [f64; MAX_LINKS])>,
}

impl Method for GradientDescent {
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]> {
        let (model, before, joints) = (task.linear(q), task.deviation(q).square(), &task.joints);
        let mut downhill = [0.0; MAX_LINKS];
        for i in 0..joints.count {
            downhill[i] = (0..model.rows).map(|row| model.jacobian[row][i] * model.vector[row]).sum();
            let [low, high] = joints.ranges[i];
            if !joints.is_circle(i) && (downhill[i] < 0.0 && q[i] <= low || downhill[i] > 0.0 && q[i] >= high) {
                downhill[i] = 0.0;
            }
        }
        let learned = self.last.and_then(|last| learned_step(task, q, &downhill, &last));
        let mut step = learned.or_else(|| best_step(&model, &downhill))?.min(LARGEST / widest(&downhill));
        self.squares[self.count % REMEMBERED] = before;
        self.count += 1;
        let largest = self.squares.iter().take(self.count).fold(0.0, |most: f64, square| most.max(*square));
        for _ in 0..HALVINGS {
            let mut next = [0.0; MAX_LINKS];
            let mut promised = 0.0;
            for i in 0..joints.count {
                next[i] = joints.hold(i, q[i] + step * downhill[i] * joints.unit(i));
                promised += downhill[i] * joints.turn(i, q[i], next[i]);
            }
            let after = task.deviation(&next).square();
            if promised > 0.0 && after <= largest - 2.0 * PROMISED * promised {
                self.last = Some((*q, downhill));
                return Some(next);
            }
            step /= 2.0;
        }
        None
    }

    fn begin(&mut self) {
        (self.last, self.count) = (None, 0);
    }

    fn patience(&self) -> (u32, f64) {
        (60, 0.97)
    }
}

/// The best step downhill for the linear model, shortened a little; `None` if nothing moves.
#[inline(never)]
fn best_step(model: &Linear, downhill: &[f64; MAX_LINKS]) -> Option<f64> {
    let moved = |row: usize| -> f64 { (0..MAX_LINKS).map(|i| model.jacobian[row][i] * downhill[i]).sum() };
    let change: f64 = (0..model.rows).map(|row| moved(row) * moved(row)).sum();
    let steepness: f64 = downhill.iter().map(|angle| angle * angle).sum();
    (change > 0.0).then(|| RELAXED * steepness / change)
}

/// The step that fits the change of the descent direction since the last configuration; `None` if the curvature is not positive.
#[inline(never)]
fn learned_step(
    task: &Task,
    q: &[f64; MAX_LINKS],
    downhill: &[f64; MAX_LINKS],
    last: &([f64; MAX_LINKS], [f64; MAX_LINKS]),
) -> Option<f64> {
    let (mut turned, mut curved) = (0.0, 0.0);
    for i in 0..task.joints.count {
        let turn = task.joints.turn(i, last.0[i], q[i]);
        turned += turn * turn;
        curved += turn * (last.1[i] - downhill[i]);
    }
    (turned > 0.0 && curved > 0.0).then(|| turned / curved)
}
