//! Partial shortcuts: between two places of a path one coordinate goes straight, the others as before. They take out the
//! needless motion of one joint where all joints together cannot go straight.
//!
//! Geraerts and Overmars 2007, "Creating high-quality paths for motion planning".

use super::improve::{is_free, replaced, two_places};
use crate::problem::Problem;
use crate::random::Random;
use crate::space::{MAX_DIMENSION, Space};

/// Draws two places along the path and a coordinate, and straightens it between them, where the path becomes shorter and all
/// of its new motions are proven free: as many motion checks as there are edges between the places. O(path).
pub(super) fn partial_shortcut<S: Space>(
    problem: &Problem<S>,
    path: &mut Vec<S::State>,
    random: &mut Random,
    checks: &mut u64,
) {
    let space = problem.space();
    let places = two_places(space, path, random);
    let coordinate = random.below(space.dimension() as u64) as usize;
    let Some([from, to]) = places else { return };
    let detour = [&[from.state], &path[from.edge + 1..=to.edge], &[to.state]].concat();
    let whole = super::length(space, &detour);
    let mut along = 0.0;
    let mut between = Vec::with_capacity(detour.len());
    for pair in detour[..detour.len() - 1].windows(2) {
        along += space.distance(&pair[0], &pair[1]);
        let straight = space.interpolate(&from.state, &to.state, (along / whole).min(1.0));
        between.push(with_coordinate(space, &pair[1], coordinate, &straight));
    }
    let new = replaced::<S>(path, [from, to], &between);
    if super::length(space, &new) >= super::length(space, path) {
        return;
    }
    let (before, after) = (path[from.edge], path[to.edge + 1]);
    let changed = [&[before, from.state], between.as_slice(), &[to.state, after]].concat();
    if is_free(problem, &changed, checks) {
        *path = new;
    }
}

/// The state with one coordinate of another.
fn with_coordinate<S: Space>(space: &S, state: &S::State, coordinate: usize, other: &S::State) -> S::State {
    let mut coordinates = [0.0; MAX_DIMENSION];
    let coordinates = &mut coordinates[..space.dimension()];
    coordinates.copy_from_slice(space.coordinates(state));
    coordinates[coordinate] = space.coordinates(other)[coordinate];
    space.state(coordinates)
}
