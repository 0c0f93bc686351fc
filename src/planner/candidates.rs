//! The edges of a lazy roadmap, which are not proven yet, and what their search estimates.

use super::query::{Algorithm, Cost, Searching};
use crate::graph::search::{Goals, Lifelong};
use crate::graph::{Graph, VertexId};
use crate::space::Space;

/// The edges of a lazy roadmap, and their search.
#[derive(Debug, Clone)]
pub(super) struct Candidates {
    pub search: Lifelong,
    /// By vertex: whether it has to be checked before an edge at it is.
    pub unchecked: Vec<bool>,
}

impl Candidates {
    /// Adds the next vertex, which is free.
    pub fn add_vertex(&mut self, estimate: f64) {
        self.search.add_vertex(estimate);
        self.unchecked.push(false);
    }
}

/// Whether paths are as long as they have edges.
pub(super) fn counts_edges(rules: Searching) -> bool {
    rules.cost == Cost::Hops || !matches!(rules.search, Algorithm::AStar | Algorithm::Dijkstra | Algorithm::AStarStale)
}

/// An estimate of the cost from a vertex to the nearest of the goals that are there, which never exceeds it.
pub(super) fn estimate<S: Space>(
    space: &S,
    graph: &Graph<S>,
    rules: Searching,
    goals: &Goals,
    vertex: VertexId,
) -> f64 {
    let there = goals.start.0..goals.end.0.min(graph.states().len() as u32);
    let distance = |goal: u32| space.distance(graph.state(vertex), graph.state(VertexId(goal)));
    if counts_edges(rules) || there.is_empty() { 0.0 } else { there.map(distance).fold(f64::INFINITY, f64::min) }
}
