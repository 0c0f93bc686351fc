//! An existing roadmap is searched again: start and goals are connected to it, and nothing else grows.

use super::batch::Batch;
use crate::graph::VertexId;
use crate::planner::Planner;
use crate::planner::groups::Searching;
use crate::planner::roadmap::{Connection, Roadmap};
use crate::problem::Problem;
use crate::space::Space;

/// A planner whose roadmap exists and is proven: it draws no samples, connects start and goals to their neighbours and searches. A
/// vertex of the roadmap that is the start or a goal becomes that end and keeps its edges; all others come after these
/// ends, in their order. O(states + edges), and the index of neighbours.
///
/// # Panics
/// If an edge names a vertex that does not exist.
pub fn resume<S: Space + 'static>(
    problem: &Problem<S>,
    connection: Connection,
    rules: Searching,
    states: &[S::State],
    edges: &[[u32; 2]],
) -> Box<dyn Planner<S>> {
    let mut roadmap = Roadmap::new(problem, connection, rules);
    let ends: Vec<VertexId> = (0..roadmap.len() as u32).map(VertexId).collect();
    let mut is_kept = vec![false; ends.len()];
    let mut vertices = Vec::with_capacity(states.len());
    for state in states {
        let is_new = |end: &VertexId| !is_kept[end.index()] && roadmap.graph().state(*end) == state;
        vertices.push(match ends.iter().copied().find(is_new) {
            Some(end) => {
                is_kept[end.index()] = true;
                end
            }
            None => roadmap.add_vertex(problem.space(), 0, *state),
        });
    }
    for edge in edges {
        let [from, to] = edge.map(|vertex| vertices[vertex as usize]);
        roadmap.growth.graph.add_edge(0, from, to);
    }
    let left = ends.into_iter().filter(|end| !is_kept[end.index()]).collect();
    Box::new(Batch::resumed(problem, roadmap, left))
}
