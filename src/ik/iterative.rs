//! The interface of the iterative methods, Newton's method and damped least squares.

use super::kinematics::Singular;
use super::task::{Linear, Task};
use crate::robot::MAX_LINKS;

/// A step from one configuration to a better one.
pub(super) trait Method {
    /// The next configuration, within the limits to the bit; `None` if the method finds no step from `q`.
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]>;

    /// Forgets everything learned since the last start.
    fn begin(&mut self) {}

    /// A start is given up if the error does not fall by this factor, less than 1, within this many updates.
    fn patience(&self) -> (u32, f64) {
        (10, 0.9)
    }
}

/// Newton-Raphson: each update solves the linear model for the full displacement to the target, with the least rotation of the
/// joints, scaled down until no joint turns by more than half a radian. Quadratic near a solution that is not singular; far away
/// it may cycle, and needs another start. O(links) per update.
///
/// Source: Whitney 1969, "Resolved motion rate control of manipulators and human prostheses"; the pseudo-inverse by singular
/// values after Klein and Huang 1983, "Review of pseudoinverse control for use with kinematically redundant manipulators".
pub(super) struct Newton;

impl Newton {
    /// The most that a joint moves in one update, in its unit.
    const LARGEST: f64 = 0.5;

    /// Directions in which the tip moves less than this fraction of the reach per radian are omitted.
    const SINGULAR: f64 = 1e-8;
}

impl Method for Newton {
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]> {
        let least = Self::SINGULAR * task.reach;
        let next = rotate(task, q, task.linear(q), Self::LARGEST, &|model| {
            Singular::of(model)
                .solve(&model.vector, &|square| if square > least * least { square } else { f64::INFINITY })
        });
        (next != *q).then_some(next)
    }
}

/// Damped least squares: an update minimises |error - J turn|^2 + damping |turn|^2. The damping is a multiple of the squared
/// error: it vanishes towards the target, and the method ends like Newton's, also near singular configurations. The multiple
/// grows while an update would move the tip away, so the error falls with every update. O(links) per try.
///
/// Sources: Wampler 1986, "Manipulator inverse kinematic solutions based on vector formulations and damped least-squares
/// methods"; Nakamura and Hanafusa 1986, "Inverse kinematic solutions with singularity robustness for robot manipulator
/// control"; the damping after Sugihara 2011, "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method".
pub(super) struct DampedLeastSquares {
    damping: f64,
}

impl DampedLeastSquares {
    /// The most that a joint moves in one update, in its unit.
    const LARGEST: f64 = 1.0;

    /// The initial damping and the least, fractions of the squared error, and the factor by which it changes.
    const DAMPING: [f64; 3] = [1e-2, 1e-6, 10.0];

    /// The most tries of an update with more damping.
    const TRIES: usize = 12;

    pub fn new() -> Self {
        Self { damping: Self::DAMPING[0] }
    }
}

impl Method for DampedLeastSquares {
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]> {
        let (model, before) = (task.linear(q), task.deviation(q).square());
        let [_, least, factor] = Self::DAMPING;
        for _ in 0..Self::TRIES {
            let damping = self.damping * before;
            let next = rotate(task, q, model.clone(), Self::LARGEST, &|model| {
                // Without damping and movement nothing is turned: 0 / infinity.
                let divisor = |square: f64| if square + damping > 0.0 { square + damping } else { f64::INFINITY };
                Singular::of(model).solve(&model.vector, &divisor)
            });
            if task.deviation(&next).square() < before {
                self.damping = (self.damping / factor).max(least);
                return Some(next);
            }
            self.damping *= factor;
        }
        self.begin();
        None
    }

    fn begin(&mut self) {
        *self = Self::new();
    }
}

/// The configuration after the rotation that `solve` finds for the linear model, no joint turned by more than `largest`. A joint
/// that would leave its limits stops at the limit, its effect on the tip is subtracted, and the others are solved for again: a
/// joint at its limit never blocks those that can still move.
///
/// Source: the clamping of joints in Baerlocher and Boulic 2004, "An inverse kinematics architecture enforcing an arbitrary
/// number of strict priority levels".
#[inline(never)]
fn rotate(
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
            let [low, high] = joints.ranges[i];
            let wanted = q[i] + turn[i] * joints.unit(i);
            next[i] = joints.hold(i, wanted);
            if !joints.is_circle(i) && !(low..=high).contains(&wanted) {
                (is_fixed[i], is_within) = (true, false);
            }
        }
        if is_within {
            break;
        }
        // The model is reduced to the joints that are still free.
        for i in (0..joints.count).filter(|&i| is_fixed[i]) {
            for row in 0..model.rows {
                model.vector[row] -= model.jacobian[row][i] * ((next[i] - q[i]) / joints.unit(i));
                model.jacobian[row][i] = 0.0;
            }
        }
    }
    next
}

/// The largest movement of a joint, in its unit.
#[inline(never)]
pub(super) fn widest(turn: &[f64; MAX_LINKS]) -> f64 {
    turn.iter().fold(0.0, |most: f64, angle| most.max(angle.abs()))
}
