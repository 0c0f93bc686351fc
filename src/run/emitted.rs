//! Paths and edges as a run reports them: waypoints, for a car the motions between them, and the shape of curved edges.

use crate::graph::{Graph, VertexId};
use crate::path;
use crate::problem::{Motion, Problem};
use crate::space::Space;
use crate::space::steering::Pose;

/// The most that one piece of a traced curve turns, in radians.
const BEND: f64 = 0.2;

/// The integration steps of one piece of a controlled motion.
const STEPS: u32 = 10;

/// A path from waypoint to waypoint.
#[derive(Debug, Clone)]
pub(super) struct EmittedPath<S: Space> {
    pub states: Vec<S::State>,
    /// The length: along controlled motions that of the dynamics, else in the metric of the space, whose curves are measured
    /// whole. To the bit the cost that planners minimise, unless obstacles add to it.
    pub length: f64,
    /// The length and what the nearness of obstacles adds.
    pub cost: f64,
    /// Of a car, from each waypoint to the next.
    pub motions: Option<Vec<Motion>>,
    /// The shares of the blends of its inner waypoints; empty if none were tried.
    pub blends: Vec<[f64; 2]>,
}

impl<S: Space> EmittedPath<S> {
    /// The path through these states, if any: curves are split into their segments, straight motions if they turn too far.
    pub fn through(problem: &Problem<S>, states: &[S::State]) -> Self {
        let Some(dynamics) = &problem.dynamics else {
            return Self::cornered(problem, path::split(problem.space(), states), Vec::new());
        };
        let length = path::length(problem.space(), states);
        let (mut waypoints, mut motions) = (states.first().copied().into_iter().collect::<Vec<_>>(), Vec::new());
        for pair in states.windows(2) {
            for (motion, end) in dynamics.steer(&pair[0], &pair[1]) {
                motions.push(motion);
                waypoints.push(end);
            }
        }
        Self { states: waypoints, length, cost: length, motions: Some(motions), blends: Vec::new() }
    }

    /// The path of straight motions through these states, with these blends.
    pub fn cornered(problem: &Problem<S>, states: Vec<S::State>, blends: Vec<[f64; 2]>) -> Self {
        let (length, cost) = (path::length(problem.space(), &states), problem.path_cost(&states));
        Self { states, length, cost, motions: None, blends }
    }

    /// The path along these vertices of the planner's graph, as it was found.
    pub fn along(problem: &Problem<S>, graph: &Graph<S>, vertices: &[VertexId]) -> Self {
        let states: Vec<_> = vertices.iter().map(|&vertex| *graph.state(vertex)).collect();
        if graph.motions().is_empty() {
            return Self::through(problem, &states);
        }
        // Vertex i of a driven tree is the end of edge i - 1.
        let motions: Vec<_> = vertices.iter().skip(1).map(|vertex| graph.motions()[vertex.index() - 1]).collect();
        let length_of = |&motion: &Motion| problem.dynamics.as_ref().map_or(0.0, |dynamics| dynamics.length(motion));
        // The sum of nothing is -0.
        let length = motions.iter().map(length_of).sum::<f64>() + 0.0;
        Self { states, length, cost: length, motions: Some(motions), blends: Vec::new() }
    }
}

/// The motions of an edge.
pub(super) fn motions<S: Space>(problem: &Problem<S>, graph: &Graph<S>, edge: usize) -> Vec<Motion> {
    if let Some(&motion) = graph.motions().get(edge) {
        return vec![motion];
    }
    let [from, to] = graph.edges()[edge].map(|vertex| graph.state(vertex));
    let steered = problem.dynamics.as_ref().map(|dynamics| dynamics.steer(from, to)).unwrap_or_default();
    steered.into_iter().map(|(motion, _)| motion).collect()
}

/// States along a curved edge, both ends included, close enough to be connected by straight lines; empty for a straight edge.
pub(super) fn trace<S: Space>(problem: &Problem<S>, graph: &Graph<S>, edge: usize) -> Vec<S::State> {
    let space = problem.space();
    let [from, to] = graph.edges()[edge].map(|vertex| *graph.state(vertex));
    let mut states = vec![from];
    if let Some((&Motion { control, duration }, dynamics)) = graph.motions().get(edge).zip(problem.dynamics.as_ref()) {
        let steps = libm::round(duration / dynamics.step()) as u32;
        states.extend((1..steps.div_ceil(STEPS)).map(|piece| dynamics.drive(&from, control, piece * STEPS)));
    } else if let Some(curve) = space.curve(&from, &to) {
        let [x, y, heading] = [0, 1, 2].map(|i| space.coordinates(&from)[i]);
        let (mut before, mut distances) = (0.0, Vec::new());
        for segment in curve.segments() {
            let length = segment.length.abs();
            let pieces = libm::ceil(length * curve.curvature(segment.turn).abs() / BEND).max(1.0) as u32;
            distances.extend((0..pieces).map(|piece| before + length * f64::from(piece) / f64::from(pieces)));
            before += length;
        }
        states.extend(distances.into_iter().skip(1).map(|along| {
            let at = curve.at(Pose { x, y, heading }, along);
            space.state(&[at.x, at.y, at.heading])
        }));
    } else {
        return Vec::new();
    }
    states.push(to);
    states
}
