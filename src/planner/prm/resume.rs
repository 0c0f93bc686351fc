//! An existing roadmap is searched again: start and goals are connected to it, and nothing else grows.

use super::connect::Connect;
use crate::graph::VertexId;
use crate::planner::groups::Searching;
use crate::planner::roadmap::{Build, Connection, Roadmap, RoadmapPlanner};
use crate::planner::{Phase, Planner};
use crate::problem::Problem;
use crate::space::Space;

/// Connects the ends that the roadmap does not have yet, one an iteration.
struct Resumed {
    /// The ends left to connect, the next one last.
    left: Vec<VertexId>,
    connect: Connect,
}

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
    let left: Vec<VertexId> = ends.iter().rev().copied().filter(|end| !is_kept[end.index()]).collect();
    let is_complete = left.is_empty();
    let builder = Resumed { left, connect: Connect::default() };
    Box::new(RoadmapPlanner::new(problem, roadmap, builder, is_complete))
}

impl<S: Space> Build<S> for Resumed {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        if let Some(vertex) = self.left.pop() {
            self.connect.join(roadmap, problem, iteration, vertex);
        }
        self.left.is_empty()
    }

    fn phase(&self, _: &Roadmap<S>) -> Phase {
        Phase::Connecting
    }
}
