//! Newton's method with the pseudo-inverse of the Jacobian, for arms with fewer, as many or more joints than needed.

use super::method::{Method, turned};
use super::singular::Singular;
use super::task::Task;
use crate::robot::MAX_LINKS;

/// The most that a joint turns in one update, in radians.
const LARGEST_TURN: f64 = 0.5;

/// Directions in which the tip moves less than this fraction of the reach a radian are left out.
const SINGULAR: f64 = 1e-8;

/// Newton-Raphson: each update solves the linear model for the whole way to the target, with the least turn of the joints
/// that does, and goes that way but turns no joint by more than half a radian. Quadratic near a solution that is not
/// singular; far away it may well go round in circles, and then another start has to help. O(links) an update.
///
/// Source: Whitney 1969, "Resolved motion rate control of manipulators and human prostheses"; the pseudo-inverse by singular
/// values after Klein and Huang 1983, "Review of pseudoinverse control for use with kinematically redundant manipulators".
pub(super) struct Newton;

impl Method for Newton {
    fn update(&mut self, task: &Task, q: &[f64; MAX_LINKS]) -> Option<[f64; MAX_LINKS]> {
        let least = SINGULAR * task.reach;
        let next = turned(task, q, task.linear(q), LARGEST_TURN, &|model| {
            Singular::of(model)
                .solve(&model.vector, &|square| if square > least * least { square } else { f64::INFINITY })
        });
        (next != *q).then_some(next)
    }

    fn patience(&self) -> u32 {
        10
    }

    fn progress(&self) -> f64 {
        0.9
    }
}
