//! What the iterative methods share: one update of the joints, with limits held.

use super::task::{Linear, Task};
use crate::robot::MAX_LINKS;

/// A way to go from one configuration to a better one.
pub(super) trait Method {
    /// The next configuration, within the limits to the bit; `None` where the method finds no way on from `q`.
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]>;

    /// Forgets what was learned on the way from the last start.
    fn begin(&mut self) {}

    /// After how many updates without the error falling by [`Method::progress`] a start is given up.
    fn patience(&self) -> u32;

    /// The factor by which the error has to fall within the patience, less than 1.
    fn progress(&self) -> f64;
}

/// The configuration after the turn that `solve` finds for the linear model, no joint turned by more than `largest`. A joint
/// that would leave its limits goes to the limit and stays there, what it does for the tip is taken off, and the others are
/// solved for again: so a joint at its limit never holds up those that can still move.
///
/// Source: the clamping of joints in Baerlocher and Boulic 2004, "An inverse kinematics architecture enforcing an arbitrary
/// number of strict priority levels".
#[inline(never)]
pub(super) fn turned(
    task: &Task,
    q: &[f64; MAX_LINKS],
    mut model: Linear,
    largest: f64,
    solve: &dyn Fn(&Linear) -> [f64; MAX_LINKS],
) -> [f64; MAX_LINKS] {
    let joints = &task.joints;
    let (mut next, mut is_fixed) = (*q, [false; MAX_LINKS]);
    for _ in 0..joints.count {
        let mut turn = solve(&model);
        let widest = widest(&turn);
        if widest > largest {
            turn.iter_mut().for_each(|angle| *angle *= largest / widest);
        }
        let mut is_within = true;
        for i in 0..joints.count {
            if is_fixed[i] {
                continue;
            }
            let [low, high] = joints.range(i);
            next[i] = joints.hold(i, q[i] + turn[i]);
            if !joints.is_circle() && !(low..=high).contains(&(q[i] + turn[i])) {
                (is_fixed[i], is_within) = (true, false);
            }
        }
        if is_within {
            break;
        }
        // The model is made anew from what is left, since joints that were not held are still free.
        for i in (0..joints.count).filter(|&i| is_fixed[i]) {
            for row in 0..model.rows {
                model.vector[row] -= model.jacobian[row][i] * (next[i] - q[i]);
                model.jacobian[row][i] = 0.0;
            }
        }
    }
    next
}

/// The largest turn of a joint, in radians.
#[inline(never)]
pub(super) fn widest(turn: &[f64; MAX_LINKS]) -> f64 {
    turn.iter().fold(0.0, |most: f64, angle| most.max(angle.abs()))
}
