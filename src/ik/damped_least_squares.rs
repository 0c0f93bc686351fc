//! Damped least squares: Newton's method that slows down where the arm is nearly singular.

use super::method::{Method, turned};
use super::singular::Singular;
use super::task::Task;
use crate::robot::MAX_LINKS;

/// The most that a joint turns in one update, in radians.
const LARGEST_TURN: f64 = 1.0;

/// The damping to begin with, the least, and by how much it changes: fractions of the squared error.
const DAMPING: [f64; 3] = [1e-2, 1e-6, 10.0];

/// How often an update is tried with more damping.
const TRIES: usize = 12;

/// Damped least squares: an update minimises |error - J turn|^2 + damping |turn|^2. The damping is a multiple of the squared
/// error, so that it vanishes towards the target and the method ends like Newton's, also where the arm is singular; the
/// multiple grows where an update would take the tip farther away, so the error falls with every update. O(links) a try.
///
/// Sources: Wampler 1986, "Manipulator inverse kinematic solutions based on vector formulations and damped least-squares
/// methods"; Nakamura and Hanafusa 1986, "Inverse kinematic solutions with singularity robustness for robot manipulator
/// control"; the damping after Sugihara 2011, "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method".
pub(super) struct DampedLeastSquares {
    damping: f64,
}

impl DampedLeastSquares {
    pub fn new() -> Self {
        Self { damping: DAMPING[0] }
    }
}

impl Method for DampedLeastSquares {
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]> {
        let (model, before) = (task.linear(q), task.deviation(q).square());
        for _ in 0..TRIES {
            let damping = self.damping * before;
            let next = turned(task, q, model.clone(), LARGEST_TURN, &|model| {
                // Where there is neither damping nor movement, nothing is turned: 0 / infinity.
                let divisor = |square: f64| if square + damping > 0.0 { square + damping } else { f64::INFINITY };
                Singular::of(model).solve(&model.vector, &divisor)
            });
            if task.deviation(&next).square() < before {
                self.damping = (self.damping / DAMPING[2]).max(DAMPING[1]);
                return Some(next);
            }
            self.damping *= DAMPING[2];
        }
        self.damping = DAMPING[0];
        None
    }

    fn begin(&mut self) {
        self.damping = DAMPING[0];
    }

    fn patience(&self) -> u32 {
        10
    }

    fn progress(&self) -> f64 {
        0.9
    }
}
