//! What happened besides growth: samples rejected, edges refused, vertices expanded or removed, solutions found.

use super::VertexId;

/// The kind of an event; viewers see its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// A sample in collision was rejected; the state is the sample.
    SampleRejected = 0,
    /// A motion could not be proven free: from the vertex to the state (of the other vertex, if there is one), or, in a tree
    /// that grows against the direction of its motions, from the state to the vertex.
    EdgeRefused = 1,
    /// The search expanded the vertex.
    VertexExpanded = 2,
    /// A solution was found at the vertex.
    SolutionFound = 3,
    /// A free sample was discarded: it connects to nothing, or to nothing new; the state is the sample.
    SampleDiscarded = 4,
    /// The vertex became a guard of a visibility roadmap.
    GuardAdded = 5,
    /// The vertex and the edge to it were removed from the tree, as others are better. Its number is not reused.
    VertexRemoved = 6,
}

/// One event.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event<S> {
    /// What happened.
    pub kind: EventKind,
    /// In which iteration, from 1.
    pub iteration: u32,
    /// The vertex concerned, if any.
    pub vertex: Option<VertexId>,
    /// The other vertex of an edge.
    pub other: Option<VertexId>,
    /// The configuration concerned: the sample, the target of the edge, the state of the vertex.
    pub state: S,
}
