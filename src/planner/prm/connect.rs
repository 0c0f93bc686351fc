//! Vertices connected to their neighbours one after another, each pair once.

use crate::graph::VertexId;
use crate::nearest::{Direction, Neighbour};
use crate::planner::roadmap::Roadmap;
use crate::problem::Problem;
use crate::space::Space;

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
#[derive(Debug)]
pub(super) struct Connect {
    /// The first vertex of the present batch: earlier ones have tried no motions to its vertices.
    pub first: VertexId,
    /// By the number of the vertex: out of it, and, if motions have a direction, into it.
    tried: [Vec<Tried>; 2],
    neighbours: Vec<Neighbour>,
}

impl Default for Connect {
    fn default() -> Self {
        Self { first: VertexId(0), tried: Default::default(), neighbours: Vec::new() }
    }
}

impl Connect {
    /// Tries the motions between a vertex and its neighbours, except those that were tried from the other side. Vertices come in
    /// the order of their numbers; some may be omitted.
    pub fn connect<S: Space>(
        &mut self,
        roadmap: &mut Roadmap<S>,
        problem: &Problem<S>,
        iteration: u32,
        vertex: VertexId,
    ) {
        for &direction in Direction::all(problem.space()) {
            roadmap.growth.counters.nearest_queries += 1;
            let (tried, visited) = candidates(roadmap, problem.space(), direction, vertex, &mut self.neighbours);
            roadmap.growth.note_visited(problem.space(), visited);
            self.note(problem.space(), direction, vertex, tried);
            for neighbour in &self.neighbours {
                if !self.has_tried(problem.space(), direction, vertex, neighbour) {
                    let [from, to] = direction.ends(vertex, neighbour.vertex);
                    roadmap.growth.looked += 1;
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
        (self.first..vertex).contains(&other)
            && tried.is_some_and(|tried| tried.includes(&Neighbour { distance, vertex }))
    }
}

/// The list of a vertex's own motions in a direction, and that of the same motions from the other side: a motion out of one
/// vertex leads into the other.
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
) -> (Tried, usize) {
    let k = roadmap.connection.k();
    let state = roadmap.growth.state(vertex);
    // One more than k, since the vertex itself is among them.
    let visited = roadmap.find_neighbours(space, direction, &state, true, found);
    match found.iter().position(|neighbour| neighbour.vertex == vertex) {
        Some(own) => drop(found.remove(own)),
        None => found.truncate(k),
    }
    let tried = match found.last() {
        _ if !roadmap.is_exact() => Tried::These(found.iter().map(|neighbour| neighbour.vertex).collect()),
        Some(&last) if found.len() == k => Tried::UpTo(last),
        _ => Tried::WithinRadius,
    };
    (tried, visited)
}
