//! Shortcutting: random detours of a path replaced by straight motions that are proven free.
//!
//! Geraerts and Overmars 2007, "Creating high-quality paths for motion planning".

use super::improve::{is_free, replaced, two_places};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::Space;

/// Draws two places along the path and replaces what lies between by a straight motion, where that is shorter and the new
/// motions are proven free: at most three motion checks. O(path).
pub(super) fn shortcut<S: Space>(
    problem: &Problem<S>,
    path: &mut Vec<S::State>,
    random: &mut Random,
    checks: &mut u64,
) {
    let space = problem.space();
    let Some([from, to]) = two_places(space, path, random) else { return };
    let (before, after) = (path[from.edge], path[to.edge + 1]);
    let detour = [&[from.state], &path[from.edge + 1..=to.edge], &[to.state]].concat();
    if space.distance(&from.state, &to.state) >= super::length(space, &detour) {
        return;
    }
    // The pieces of the cut edges are proven anew: rounding may move them by a bit off the edges.
    if !is_free(problem, &[before, from.state, to.state, after], checks) {
        return;
    }
    let new = replaced::<S>(path, [from, to], &[]);
    if super::length(space, &new) < super::length(space, path) {
        *path = new;
    }
}
