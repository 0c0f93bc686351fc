//! Connects a vertex to its neighbours, each pair of vertices once.

use crate::graph::VertexId;
use crate::nearest::{Direction, Neighbour};
use crate::planner::roadmap::{Connection, Roadmap};
use crate::problem::Problem;
use crate::space::Space;

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

/// What the vertices connected so far have tried.
#[derive(Debug, Default)]
pub(super) struct Connect {
    /// By the number of the vertex: out of it, and, if motions have a direction, into it.
    tried: [Vec<Tried>; 2],
    neighbours: Vec<Neighbour>,
}

impl Connect {
    /// Tries the motions between a vertex and its neighbours, except those that were tried from the other side. Vertices come in
    /// the order of their numbers; some may be left out.
    pub fn join<S: Space>(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32, vertex: VertexId) {
        for &way in Direction::all(problem.space()) {
            let Connection { k, .. } = roadmap.connection();
            let state = roadmap.growth.state(vertex);
            // One more than k, since the vertex itself is among them.
            roadmap.neighbours(problem.space(), way, &state, true, &mut self.neighbours);
            match self.neighbours.iter().position(|neighbour| neighbour.vertex == vertex) {
                Some(own) => drop(self.neighbours.remove(own)),
                None => self.neighbours.truncate(k),
            }
            let tried = match self.neighbours.last() {
                Some(&last) if self.neighbours.len() == k => Tried::UpTo(last),
                _ => Tried::WithinRadius,
            };
            // What leads out of the one leads into the other.
            let (own, others) = match way {
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
                let [from, to] = way.ends(vertex, other);
                roadmap.try_edge(problem, iteration, from, to);
            }
        }
    }
}
