//! Paths and edges as they are emitted: waypoints, of a car the motions between them, and what its edges look like.

use crate::control::Motion;
use crate::graph::{Graph, VertexId};
use crate::path;
use crate::planner::Planner;
use crate::problem::Problem;
use crate::space::Space;
use crate::steering::Pose;

/// How finely curves are traced: a piece turns by so much at most, in radians.
const BEND: f64 = 0.2;

/// How many steps of integration a piece of a driven edge has.
const STEPS: u32 = 10;

/// A path from waypoint to waypoint.
#[derive(Debug, Clone)]
pub(super) struct Way<S> {
    pub states: Vec<S>,
    /// Of a car, from each waypoint to the next.
    pub motions: Option<Vec<Motion>>,
}

impl<S> Way<S> {
    /// No path.
    pub fn nowhere(is_driven: bool) -> Self {
        Self { states: Vec::new(), motions: is_driven.then(Vec::new) }
    }
}

/// The path through states of a space whose own motions lead from one to the next: curves by their segments, and straight
/// motions cut where they turn too far.
pub(super) fn through<S: Space>(problem: &Problem<S>, states: &[S::State]) -> Way<S::State> {
    let Some(dynamics) = problem.dynamics() else {
        return Way { states: path::split(problem.space(), states), motions: None };
    };
    let (mut waypoints, mut motions) = (states.first().copied().into_iter().collect::<Vec<_>>(), Vec::new());
    for pair in states.windows(2) {
        for (motion, end) in dynamics.steer(&pair[0], &pair[1]) {
            motions.push(motion);
            waypoints.push(end);
        }
    }
    Way { states: waypoints, motions: Some(motions) }
}

/// The path along the edges of a tree that is driven.
pub(super) fn driven<S: Space>(graph: &Graph<S>, vertices: &[VertexId]) -> Way<S::State> {
    let motions = vertices.iter().skip(1).map(|vertex| graph.motions()[vertex.index() - 1]).collect();
    Way { states: vertices.iter().map(|&vertex| *graph.state(vertex)).collect(), motions: Some(motions) }
}

/// The length of a path: of a car along its motions, else in the metric of the space.
pub(super) fn length<S: Space>(problem: &Problem<S>, way: &Way<S::State>) -> f64 {
    match problem.dynamics().zip(way.motions.as_ref()) {
        Some((dynamics, motions)) => motions.iter().map(|&motion| dynamics.length(motion)).sum::<f64>() + 0.0,
        None => path::length(problem.space(), &way.states),
    }
}

/// The motions of an edge.
pub(super) fn motions<S: Space>(problem: &Problem<S>, graph: &Graph<S>, edge: usize) -> Vec<Motion> {
    if let Some(&motion) = graph.motions().get(edge) {
        return vec![motion];
    }
    let [from, to] = graph.edges()[edge].map(|vertex| graph.state(vertex));
    problem
        .dynamics()
        .map(|dynamics| dynamics.steer(from, to))
        .unwrap_or_default()
        .into_iter()
        .map(|(motion, _)| motion)
        .collect()
}

/// States along an edge that is not straight, both ends included, close enough to be joined by straight lines; none along one
/// that is.
pub(super) fn trace<S: Space>(problem: &Problem<S>, graph: &Graph<S>, edge: usize) -> Vec<S::State> {
    let space = problem.space();
    let [from, to] = graph.edges()[edge].map(|vertex| *graph.state(vertex));
    let mut states = vec![from];
    if let Some((&Motion { control, duration }, dynamics)) = graph.motions().get(edge).zip(problem.dynamics()) {
        let steps = libm::round(duration / dynamics.step()) as u32;
        states.extend((1..steps.div_ceil(STEPS)).map(|piece| dynamics.drive(&from, control, piece * STEPS)));
    } else if let Some(curve) = space.curve(&from, &to) {
        let [x, y, heading] = [0, 1, 2].map(|i| space.coordinates(&from)[i]);
        let (mut before, mut places) = (0.0, Vec::new());
        for segment in curve.segments() {
            let length = segment.length.abs();
            let pieces = libm::ceil(length * curve.curvature(segment.turn).abs() / BEND).max(1.0) as u32;
            places.extend((0..pieces).map(|piece| before + length * f64::from(piece) / f64::from(pieces)));
            before += length;
        }
        states.extend(places.into_iter().skip(1).map(|along| {
            let at = curve.at(Pose { x, y, heading }, along);
            space.state(&[at.x, at.y, at.heading])
        }));
    } else {
        return Vec::new();
    }
    states.push(to);
    states
}

/// The path of the planner, as it found it; nowhere until then.
pub(super) fn found<S: Space>(problem: &Problem<S>, planner: &dyn Planner<S>, vertices: &[VertexId]) -> Way<S::State> {
    let graph = planner.graph();
    if !graph.motions().is_empty() {
        return driven(graph, vertices);
    }
    through(problem, &vertices.iter().map(|&vertex| *graph.state(vertex)).collect::<Vec<_>>())
}
