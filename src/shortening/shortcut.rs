//! Shortcuts: random detours of a path replaced by straight motions that are proven free and cost less. Partial shortcuts:
//! between two positions of a path one coordinate goes straight, the others as before. This removes needless motion of one joint
//! if all joints together cannot go straight.
//!
//! Geraerts and Overmars 2007, "Creating high-quality paths for motion planning".

use super::is_free;
use crate::problem::Problem;
use crate::random::Random;
use crate::space::{MAX_DIMENSION, Space};

/// Draws two positions along the path and replaces the part between them by a straight motion, if that is cheaper and the new
/// motions are proven free: at most three motion checks. O(path).
pub(super) fn shortcut<S: Space>(
    problem: &Problem<S>,
    path: &mut Vec<S::State>,
    random: &mut Random,
    checks: &mut u64,
) {
    let space = problem.space();
    let Some([from, to]) = two_positions(space, path, random) else { return };
    let (before, after) = (path[from.edge], path[to.edge + 1]);
    let detour = [&[from.state], &path[from.edge + 1..=to.edge], &[to.state]].concat();
    if problem.cost(&from.state, &to.state) >= problem.path_cost(&detour) {
        return;
    }
    // The pieces of the cut edges are proven again: rounding may move them by a bit off the edges.
    if !is_free(problem, &[before, from.state, to.state, after], checks) {
        return;
    }
    let new = replaced::<S>(path, [from, to], &[]);
    if problem.path_cost(&new) < problem.path_cost(path) {
        *path = new;
    }
}

/// Draws two positions along the path and a coordinate, and straightens it between them, if the path becomes cheaper and
/// all of its new motions are proven free: as many motion checks as there are edges between the positions. O(path).
pub(super) fn partial_shortcut<S: Space>(
    problem: &Problem<S>,
    path: &mut Vec<S::State>,
    random: &mut Random,
    checks: &mut u64,
) {
    let space = problem.space();
    let positions = two_positions(space, path, random);
    let coordinate = random.below(space.dimension() as u64) as usize;
    let Some([from, to]) = positions else { return };
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
    if problem.path_cost(&new) >= problem.path_cost(path) {
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

/// A position on a path: the index of an edge, and the state on it.
#[derive(Debug, Clone, Copy)]
struct Position<S> {
    edge: usize,
    state: S,
}

/// Two positions drawn uniformly along the path, in its direction; `None` if they are on the same edge.
fn two_positions<S: Space>(space: &S, path: &[S::State], random: &mut Random) -> Option<[Position<S::State>; 2]> {
    let total = super::length(space, path);
    let [first, second] = [0, 1].map(|_| random.uniform() * total);
    let (from, to) = (position(space, path, first.min(second))?, position(space, path, first.max(second))?);
    (from.edge != to.edge).then_some([from, to])
}

/// The position at the given distance along the path.
fn position<S: Space>(space: &S, path: &[S::State], along: f64) -> Option<Position<S::State>> {
    let mut left = along;
    for (edge, pair) in path.windows(2).enumerate() {
        let distance = space.distance(&pair[0], &pair[1]);
        if left <= distance && distance > 0.0 {
            let state = space.interpolate(&pair[0], &pair[1], left / distance);
            return Some(Position { edge, state });
        }
        left -= distance;
    }
    None
}

/// The path with the part between two positions replaced by other states, without repeated states.
fn replaced<S: Space>(path: &[S::State], [from, to]: [Position<S::State>; 2], between: &[S::State]) -> Vec<S::State> {
    let mut new = path[..=from.edge].to_vec();
    let middle = std::iter::once(from.state).chain(between.iter().copied()).chain(std::iter::once(to.state));
    for state in middle.chain(path[to.edge + 1..].iter().copied()) {
        if new.last() != Some(&state) {
            new.push(state);
        }
    }
    new
}
