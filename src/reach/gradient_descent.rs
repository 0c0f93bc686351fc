//! Gradient descent on the squared error, with a line search.

use super::method::Method;
use super::task::Task;
use crate::robot::MAX_LINKS;

/// The most that a joint turns in one update, in radians.
const LARGEST_TURN: f64 = 1.0;

/// The part of the fall promised by the gradient that an update must bring (Armijo 1966, "Minimization of functions having
/// Lipschitz continuous first partial derivatives").
const PROMISED: f64 = 1e-4;

/// How often a step is halved.
const HALVINGS: usize = 40;

/// The first step is this part of the one that the linear model holds for best: always the whole of it would go to and fro.
const RELAXED: f64 = 0.8;

/// Gradient descent: the joints turn against the gradient of half the squared error. A joint at a limit that would be left
/// stands still, the others are held within theirs. Linear, and slow where one direction is much harder to move in than
/// another. O(links) a trial step.
pub(super) struct GradientDescent;

impl Method for GradientDescent {
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]> {
        let (model, before, joints) = (task.linear(q), task.deviation(q).square(), &task.joints);
        let mut downhill = [0.0; MAX_LINKS];
        let mut steepness = 0.0;
        for i in 0..joints.count {
            downhill[i] = (0..model.rows).map(|row| model.jacobian[row][i] * model.vector[row]).sum();
            let [low, high] = joints.range(i);
            if !joints.is_circle() && (downhill[i] < 0.0 && q[i] <= low || downhill[i] > 0.0 && q[i] >= high) {
                downhill[i] = 0.0;
            }
            steepness += downhill[i] * downhill[i];
        }
        let moved = |row: usize| -> f64 { (0..joints.count).map(|i| model.jacobian[row][i] * downhill[i]).sum() };
        let change: f64 = (0..model.rows).map(|row| moved(row) * moved(row)).sum();
        let widest = downhill.iter().fold(0.0, |most: f64, angle| most.max(angle.abs()));
        if change == 0.0 || widest == 0.0 {
            return None;
        }
        let mut step = (RELAXED * steepness / change).min(LARGEST_TURN / widest);
        for _ in 0..HALVINGS {
            let mut next = [0.0; MAX_LINKS];
            let mut promised = 0.0;
            for i in 0..joints.count {
                next[i] = joints.hold(i, q[i] + step * downhill[i]);
                let turn = if joints.is_circle() { step * downhill[i] } else { next[i] - q[i] };
                promised += downhill[i] * turn;
            }
            let after = task.deviation(&next).square();
            if after < before && before - after >= 2.0 * PROMISED * promised {
                return Some(next);
            }
            step /= 2.0;
        }
        None
    }

    fn patience(&self) -> u32 {
        60
    }

    fn progress(&self) -> f64 {
        0.97
    }
}
