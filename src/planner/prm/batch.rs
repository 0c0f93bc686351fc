//! First all samples, then all edges, each pair of vertices once.

use crate::graph::VertexId;
use crate::nearest::{Direction, Neighbour};
use crate::planner::groups::Searching;
use crate::planner::roadmap::{Build, Connection, Roadmap, RoadmapPlanner};
use crate::planner::{Phase, Planner};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// Draws samples until the roadmap has enough vertices, then connects one vertex after another to its neighbours. An iteration
/// tries one sample or connects one vertex.
pub(super) struct Batch<S: Space> {
    /// The number of vertices to have before any is connected, and the sampler; `None` for a roadmap that has them.
    samples: Option<(usize, Box<dyn Sampler<S>>)>,
    /// The vertices to connect.
    left: Box<dyn ExactSizeIterator<Item = VertexId>>,
    connect: Connect,
}

impl<S: Space> Batch<S> {
    /// A planner at its beginning.
    pub fn planner(
        problem: &Problem<S>,
        roadmap: Roadmap<S>,
        samples: usize,
        sampler: Box<dyn Sampler<S>>,
    ) -> RoadmapPlanner<S, Self> {
        let vertices = samples + roadmap.len();
        let left = Box::new((0..vertices as u32).map(VertexId));
        let builder = Self { samples: Some((vertices, sampler)), left, connect: Connect::default() };
        RoadmapPlanner::new(problem, roadmap, builder, false)
    }
}

impl<S: Space> Build<S> for Batch<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        if let Some((vertices, sampler)) = &mut self.samples
            && roadmap.len() < *vertices
        {
            if let Some(state) = roadmap.growth.draw_free(problem, iteration, &mut **sampler) {
                roadmap.add_vertex(problem.space(), iteration, state);
            }
            return false;
        }
        if let Some(vertex) = self.left.next() {
            self.connect.connect(roadmap, problem, iteration, vertex);
        }
        self.left.len() == 0
    }

    fn phase(&self, roadmap: &Roadmap<S>) -> Phase {
        let is_sampling = self.samples.as_ref().is_some_and(|(vertices, _)| roadmap.len() < *vertices);
        if is_sampling { Phase::Sampling } else { Phase::Connecting }
    }
}

/// Which motions a vertex has tried from its side.
#[derive(Debug, Clone, Copy)]
enum Tried {
    /// None.
    Nothing,
    /// Those to its k nearest, of which this is the farthest.
    UpTo(Neighbour),
    /// Those to all within the radius.
    WithinRadius,
}

impl Tried {
    /// Whether the motion to this neighbour, which lies within the radius, is among them.
    fn includes(self, neighbour: &Neighbour) -> bool {
        match self {
            Tried::Nothing => false,
            Tried::UpTo(farthest) => !farthest.is_before(neighbour),
            Tried::WithinRadius => true,
        }
    }
}

/// The motions that the vertices connected so far have tried.
#[derive(Debug, Default)]
struct Connect {
    /// By the number of the vertex: out of it, and, if motions have a direction, into it.
    tried: [Vec<Tried>; 2],
    neighbours: Vec<Neighbour>,
}

impl Connect {
    /// Tries the motions between a vertex and its neighbours, except those that were tried from the other side. Vertices come in
    /// the order of their numbers; some may be omitted.
    fn connect<S: Space>(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32, vertex: VertexId) {
        for &direction in Direction::all(problem.space()) {
            let Connection { k, .. } = roadmap.connection;
            let state = roadmap.growth.state(vertex);
            // One more than k, since the vertex itself is among them.
            roadmap.neighbours(problem.space(), direction, &state, true, &mut self.neighbours);
            match self.neighbours.iter().position(|neighbour| neighbour.vertex == vertex) {
                Some(own) => drop(self.neighbours.remove(own)),
                None => self.neighbours.truncate(k),
            }
            let tried = match self.neighbours.last() {
                Some(&last) if self.neighbours.len() == k => Tried::UpTo(last),
                _ => Tried::WithinRadius,
            };
            // A motion out of one vertex leads into the other.
            let (own, others) = match direction {
                _ if problem.space().is_symmetric() => (0, 0),
                Direction::Out => (0, 1),
                Direction::In => (1, 0),
            };
            self.tried[own].resize(vertex.index(), Tried::Nothing);
            self.tried[own].push(tried);
            for neighbour in &self.neighbours {
                let other = neighbour.vertex;
                let back = Neighbour { distance: neighbour.distance, vertex };
                let tried = self.tried[others].get(other.index()).copied().unwrap_or(Tried::Nothing);
                if other < vertex && tried.includes(&back) {
                    continue;
                }
                let [from, to] = direction.ends(vertex, other);
                roadmap.try_edge(problem, iteration, from, to);
            }
        }
    }
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
    // The ends that are not vertices of the saved roadmap.
    let mut left: Vec<VertexId> = (0..roadmap.len() as u32).map(VertexId).collect();
    let mut vertices = Vec::with_capacity(states.len());
    for state in states {
        vertices.push(match left.iter().position(|&end| roadmap.graph().state(end) == state) {
            Some(i) => left.remove(i),
            None => roadmap.add_vertex(problem.space(), 0, *state),
        });
    }
    for edge in edges {
        let [from, to] = edge.map(|vertex| vertices[vertex as usize]);
        roadmap.growth.graph.add_edge(0, from, to);
    }
    let is_complete = left.is_empty();
    let builder = Batch { samples: None, left: Box::new(left.into_iter()), connect: Connect::default() };
    Box::new(RoadmapPlanner::new(problem, roadmap, builder, is_complete))
}
