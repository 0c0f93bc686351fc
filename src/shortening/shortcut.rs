//! Shortcuts: random detours of a path replaced by straight motions that are proven free and cost less. Partial shortcuts:
//! between two positions of a path one coordinate goes straight, the others as before. This removes needless motion of one joint
//! if all joints together cannot go straight.
//!
//! Geraerts and Overmars 2007, "Creating high-quality paths for motion planning".

use super::is_free;
use super::priced::Priced;
use crate::problem::Problem;
use crate::random::Random;
use crate::space::{MAX_DIMENSION, Space};

/// Draws two positions along the path and replaces the part between them by a straight motion, if that is cheaper and the new
/// motions are proven free: at most three motion checks. O(path).
pub(super) fn shortcut<S: Space>(problem: &Problem<S>, path: &mut Priced<S>, random: &mut Random, checks: &mut u64) {
    let states = path.states();
    let Some([from, to]) = two_positions(problem.space(), path, random) else { return };
    let (before, after) = (states[from.edge], states[to.edge + 1]);
    let ends = [problem.cost(&from.state, &states[from.edge + 1]), problem.cost(&states[to.edge], &to.state)];
    if problem.cost(&from.state, &to.state) >= path.motions().cost_between(ends, from.edge + 1..to.edge) {
        return;
    }
    // The pieces of the cut edges are proven again: rounding may move them by a bit off the edges.
    if !is_free(problem, &[before, from.state, to.state, after], checks) {
        return;
    }
    let new = path.changed(problem, replaced::<S>(states, [from, to], &[]));
    if new.motions().cost() < path.motions().cost() {
        *path = new;
    }
}

/// Draws two positions along the path and a coordinate, and straightens it between them, if the path becomes cheaper and
/// all of its new motions are proven free: as many motion checks as there are edges between the positions. O(path).
pub(super) fn partial_shortcut<S: Space>(
    problem: &Problem<S>,
    path: &mut Priced<S>,
    random: &mut Random,
    checks: &mut u64,
) {
    let (space, states) = (problem.space(), path.states());
    let positions = two_positions(space, path, random);
    let coordinate = random.below(space.dimension() as u64) as usize;
    let Some([from, to]) = positions else { return };
    let corners = &states[from.edge + 1..=to.edge];
    let mut lengths = vec![space.distance(&from.state, &corners[0])];
    lengths.extend(&path.motions().lengths()[from.edge + 1..to.edge]);
    let whole = lengths.iter().sum::<f64>() + space.distance(&states[to.edge], &to.state);
    let mut along = 0.0;
    let mut between = Vec::with_capacity(corners.len());
    for (corner, length) in corners.iter().zip(lengths) {
        along += length;
        let straight = space.interpolate(&from.state, &to.state, (along / whole).min(1.0));
        between.push(with_coordinate(space, corner, coordinate, &straight));
    }
    let new = path.changed(problem, replaced::<S>(states, [from, to], &between));
    if new.motions().cost() >= path.motions().cost() {
        return;
    }
    let (before, after) = (states[from.edge], states[to.edge + 1]);
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
fn two_positions<S: Space>(space: &S, path: &Priced<S>, random: &mut Random) -> Option<[Position<S::State>; 2]> {
    let total = path.motions().length();
    let [first, second] = [0, 1].map(|_| random.uniform() * total);
    let [from, to] = [path.motions().at(first.min(second))?, path.motions().at(first.max(second))?];
    let position = |(edge, share): (usize, f64)| {
        let [a, b] = [0, 1].map(|i| &path.states()[edge + i]);
        Position { edge, state: space.interpolate(a, b, share) }
    };
    (from.0 != to.0).then(|| [position(from), position(to)])
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
