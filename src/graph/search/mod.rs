//! Searches as walkers: a search holds its own marks and gets the graph at every step, so that it can be paused and
//! watched. Searches know no space: costs and heuristics are given.

mod best_first;
mod bidirectional;
mod breadth_first;
mod lifelong;
mod parents;
mod requeued;
mod stale;

pub use best_first::BestFirst;
pub use bidirectional::Bidirectional;
pub use breadth_first::BreadthFirst;
pub use lifelong::{Edge, EdgeState, Lifelong};
pub use parents::Parents;
pub use requeued::Requeued;
pub use stale::Stale;

use super::{Adjacency, VertexId};

/// The graph as a search sees it.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// The neighbours of every vertex.
    pub adjacency: &'a Adjacency,
    /// The cost of an edge between two neighbours, at least 0.
    pub cost: &'a dyn Fn(VertexId, VertexId) -> f64,
    /// An estimate of the cost from a vertex to the goal, at least 0.
    pub heuristic: &'a dyn Fn(VertexId) -> f64,
}

/// What one step of a search did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expansion {
    /// The vertex was expanded; the search continues.
    Vertex(VertexId),
    /// A path to the goal is known.
    Goal,
    /// Nothing is left to expand: the goal cannot be reached.
    Nothing,
}

/// A search from one vertex to another, one expansion per step.
pub trait Walker {
    /// Expands one vertex, or returns that the search is over.
    fn step(&mut self, view: &View) -> Expansion;

    /// The path from the start to the goal, both included, once a step has returned `Goal`.
    fn path(&self) -> Vec<VertexId>;

    /// Whether there is no path if a step has returned `Nothing`; a faulty search may miss one.
    fn is_exhaustive(&self) -> bool {
        true
    }

    /// How many of the vertices expanded had been expanded before, at a cost that was greater by more than rounding.
    fn reopened(&self) -> u64 {
        0
    }
}

/// The vertices that a search may end at: those from the first to before the last.
pub type Goals = std::ops::Range<VertexId>;
