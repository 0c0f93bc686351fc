//! First all samples, then all edges, each pair of vertices once.

#[cfg(feature = "parallel")]
use super::ahead::Ahead;
use crate::graph::VertexId;
use crate::nearest::{Direction, Neighbour};
use crate::planner::groups::Searching;
use crate::planner::roadmap::{Build, Connection, Roadmap, RoadmapPlanner};
use crate::planner::{Phase, Planner};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// Draws samples until the roadmap has enough vertices, then connects one vertex after another to its neighbours. An iteration
/// tries one sample or connects one vertex. `ahead.rs` does the same on several threads.
pub(super) struct Batch<S: Space> {
    /// The number of vertices to have before any is connected, and the sampler; `None` for a roadmap that has them.
    samples: Option<(usize, Box<dyn Sampler<S>>)>,
    /// The vertices to connect.
    left: Box<dyn ExactSizeIterator<Item = VertexId>>,
    connect: Connect,
    #[cfg(feature = "parallel")]
    ahead: Ahead<S>,
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
        RoadmapPlanner::new(problem, roadmap, Self::new(Some((vertices, sampler)), left), false)
    }

    fn new(samples: Option<(usize, Box<dyn Sampler<S>>)>, left: Box<dyn ExactSizeIterator<Item = VertexId>>) -> Self {
        Self {
            samples,
            left,
            connect: Connect::default(),
            #[cfg(feature = "parallel")]
            ahead: Ahead::default(),
        }
    }
}

impl<S: Space> Build<S> for Batch<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        if let Some((vertices, sampler)) = &mut self.samples
            && roadmap.len() < *vertices
        {
            #[cfg(feature = "parallel")]
            if self.ahead.sample(roadmap, problem, iteration, &mut **sampler, *vertices - roadmap.len()) {
                return false;
            }
            if let Some(state) = roadmap.growth.draw_free(problem, iteration, &mut **sampler) {
                roadmap.add_vertex(problem.space(), iteration, state);
            }
            return false;
        }
        #[cfg(feature = "parallel")]
        if self.ahead.connect(roadmap, problem, iteration, &mut *self.left, &mut self.connect) {
            return self.left.len() == 0 && self.ahead.is_empty();
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
#[derive(Debug, Clone)]
pub(super) enum Tried {
    /// None.
    Nothing,
    /// Those to its k nearest, of which this is the farthest.
    UpTo(Neighbour),
    /// Those to all within the radius.
    WithinRadius,
    /// Those to these, which an approximate index found.
    These(Vec<VertexId>),
}

impl Tried {
    /// Whether the motion to this neighbour, which lies within the radius, is among them.
    fn includes(&self, neighbour: &Neighbour) -> bool {
        match self {
            Tried::Nothing => false,
            Tried::UpTo(farthest) => !farthest.is_before(neighbour),
            Tried::WithinRadius => true,
            Tried::These(vertices) => vertices.contains(&neighbour.vertex),
        }
    }
}

/// The motions that the vertices connected so far have tried.
#[derive(Debug, Default)]
pub(super) struct Connect {
    /// By the number of the vertex: out of it, and, if motions have a direction, into it.
    tried: [Vec<Tried>; 2],
    neighbours: Vec<Neighbour>,
}

impl Connect {
    /// Tries the motions between a vertex and its neighbours, except those that were tried from the other side. Vertices come in
    /// the order of their numbers; some may be omitted.
    fn connect<S: Space>(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32, vertex: VertexId) {
        for &direction in Direction::all(problem.space()) {
            roadmap.growth.counters.nearest_queries += 1;
            let tried = candidates(roadmap, problem.space(), direction, vertex, &mut self.neighbours);
            self.note(problem.space(), direction, vertex, tried);
            for neighbour in &self.neighbours {
                if !self.has_tried(problem.space(), direction, vertex, neighbour) {
                    let [from, to] = direction.ends(vertex, neighbour.vertex);
                    roadmap.try_edge(problem, iteration, from, to);
                }
            }
        }
    }

    /// Notes which motions a vertex tries. Vertices come in the order of their numbers; some may be omitted.
    pub fn note<S: Space>(&mut self, space: &S, direction: Direction, vertex: VertexId, tried: Tried) {
        let [own, _] = lists(space, direction);
        self.tried[own].resize(vertex.index(), Tried::Nothing);
        self.tried[own].push(tried);
    }

    /// Whether the neighbour of a vertex, being an earlier one, has tried the motion between them.
    pub fn has_tried<S: Space>(
        &self,
        space: &S,
        direction: Direction,
        vertex: VertexId,
        &Neighbour { distance, vertex: other }: &Neighbour,
    ) -> bool {
        let [_, others] = lists(space, direction);
        let tried = self.tried[others].get(other.index());
        other < vertex && tried.is_some_and(|tried| tried.includes(&Neighbour { distance, vertex }))
    }
}

/// The list of a vertex's own motions in a direction, and that of the same motions from the other side: a motion out of one vertex
/// leads into the other.
fn lists<S: Space>(space: &S, direction: Direction) -> [usize; 2] {
    match direction {
        _ if space.is_symmetric() => [0, 0],
        Direction::Out => [0, 1],
        Direction::In => [1, 0],
    }
}

/// The neighbours of a vertex, without itself, into `found`, and which motions these are.
pub(super) fn candidates<S: Space>(
    roadmap: &Roadmap<S>,
    space: &S,
    direction: Direction,
    vertex: VertexId,
    found: &mut Vec<Neighbour>,
) -> Tried {
    let Connection { k, .. } = roadmap.connection;
    let state = roadmap.growth.state(vertex);
    // One more than k, since the vertex itself is among them.
    roadmap.find_neighbours(space, direction, &state, true, found);
    match found.iter().position(|neighbour| neighbour.vertex == vertex) {
        Some(own) => drop(found.remove(own)),
        None => found.truncate(k),
    }
    match found.last() {
        _ if !roadmap.is_exact() => Tried::These(found.iter().map(|neighbour| neighbour.vertex).collect()),
        Some(&last) if found.len() == k => Tried::UpTo(last),
        _ => Tried::WithinRadius,
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
    let builder = Batch::new(None, Box::new(left.into_iter()));
    Box::new(RoadmapPlanner::new(problem, roadmap, builder, is_complete))
}
