//! The append-only graph that planners grow and viewers follow, and the searches on it.
//!
//! Vertices, edges and events are only appended, each with the iteration that created it; a viewer reads those since
//! its cursor, so the cost of a frame depends on the growth, not on the size of the graph.

mod adjacency;
mod cost_tree;
mod ordered;
pub mod search;
mod tree;
mod union_find;

pub use adjacency::Adjacency;
pub use cost_tree::CostTree;
pub use ordered::Ordered;
pub use tree::Tree;
pub use union_find::UnionFind;

use crate::fingerprint::Fingerprint;
use crate::problem::Motion;
use crate::space::Space;
use strum::{IntoStaticStr, VariantArray};

/// The number of a vertex, from 0 in the order of creation; never reused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(pub u32);

impl VertexId {
    /// The number as an index.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The kind of an event; viewers see its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[non_exhaustive]
pub enum EventKind {
    /// A sample in collision was rejected; the state is the sample.
    #[strum(serialize = "rejected")]
    SampleRejected = 0,
    /// A motion could not be proven free: from the vertex to the state (of the other vertex, if there is one), or, in a tree
    /// that grows against the direction of its motions, from the state to the vertex.
    #[strum(serialize = "refused")]
    EdgeRefused = 1,
    /// The search expanded the vertex.
    #[strum(serialize = "expanded")]
    VertexExpanded = 2,
    /// A solution was found at the vertex.
    #[strum(serialize = "solved")]
    SolutionFound = 3,
    /// A free sample was discarded: it connects to nothing, or to nothing new; the state is the sample.
    #[strum(serialize = "discarded")]
    SampleDiscarded = 4,
    /// The vertex became a guard of a visibility roadmap.
    #[strum(serialize = "guard")]
    GuardAdded = 5,
    /// The vertex and the edge to it were removed from the tree, as others are better. Its number is not reused.
    #[strum(serialize = "removed")]
    VertexRemoved = 6,
    /// The vertex of a tree has another parent; `other` is the former one. The last edge to a vertex of a tree is its edge.
    #[strum(serialize = "rewired")]
    ParentChanged = 7,
}

impl EventKind {
    /// Every kind, in the order of the numbers.
    pub const ALL: &[EventKind] = EventKind::VARIANTS;

    /// The name of the kind, the same everywhere.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
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

/// How many vertices, edges and recorded events a graph holds in all before a run of a planner ends as exhausted: as many as fit
/// into the 4 GB of a WebAssembly module, with the index of neighbours and the spare capacity of growing lists.
pub const MAX_RECORDS: usize = 15_000_000;

/// The room of a list with any items.
const FEW: usize = 16;

/// Makes room for `more` items in a list that may become long: a full one doubles while it is short, and then grows by a
/// sixteenth, so that little of a large one is spare.
pub(crate) fn make_room<T>(list: &mut Vec<T>, more: usize) {
    if list.capacity() - list.len() < more {
        let part = if list.len() < 1 << 16 { list.len() } else { list.len() / 16 };
        list.reserve_exact(part.max(more).max(FEW));
    }
}

/// Appends to a list that may become long.
pub(crate) fn append<T>(list: &mut Vec<T>, item: T) {
    make_room(list, 1);
    list.push(item);
}

/// Vertices, edges and events in the order of their creation.
#[derive(Debug, Clone)]
pub struct Graph<S: Space> {
    states: Vec<S::State>,
    vertex_births: Vec<u32>,
    edges: Vec<[VertexId; 2]>,
    edge_births: Vec<u32>,
    motions: Vec<Motion>,
    events: Vec<Event<S::State>>,
}

impl<S: Space> Default for Graph<S> {
    fn default() -> Self {
        Self {
            states: Vec::new(),
            vertex_births: Vec::new(),
            edges: Vec::new(),
            edge_births: Vec::new(),
            motions: Vec::new(),
            events: Vec::new(),
        }
    }
}

impl<S: Space> Graph<S> {
    /// Adds a vertex created in the given iteration.
    #[inline]
    pub fn add_vertex(&mut self, iteration: u32, state: S::State) -> VertexId {
        let id = VertexId(u32::try_from(self.states.len()).expect("fewer than 2^32 vertices"));
        append(&mut self.states, state);
        append(&mut self.vertex_births, iteration);
        id
    }

    /// Adds an edge created in the given iteration; in a tree from parent to child.
    #[inline]
    pub fn add_edge(&mut self, iteration: u32, from: VertexId, to: VertexId) {
        append(&mut self.edges, [from, to]);
        append(&mut self.edge_births, iteration);
    }

    /// Adds an edge of a tree with the controlled motion along it: edge v - 1 leads to vertex v. Either all edges of a graph
    /// have motions, or none.
    pub fn add_driven_edge(&mut self, iteration: u32, from: VertexId, to: VertexId, motion: Motion) {
        debug_assert_eq!(self.motions.len(), self.edges.len(), "an edge of this graph is not driven");
        debug_assert_eq!(to.index(), self.edges.len() + 1, "a vertex of this tree has no edge");
        self.add_edge(iteration, from, to);
        self.motions.push(motion);
    }

    /// Adds an event.
    pub fn add_event(&mut self, event: Event<S::State>) {
        append(&mut self.events, event);
    }

    /// Whether there are [`MAX_RECORDS`] vertices, edges and recorded events, or more. O(1).
    pub fn is_full(&self) -> bool {
        self.states.len() + self.edges.len() + self.events.len() >= MAX_RECORDS
    }

    /// The states of the vertices.
    pub fn states(&self) -> &[S::State] {
        &self.states
    }

    /// The state of one vertex.
    #[inline]
    pub fn state(&self, vertex: VertexId) -> &S::State {
        &self.states[vertex.index()]
    }

    /// The edges.
    pub fn edges(&self) -> &[[VertexId; 2]] {
        &self.edges
    }

    /// The controlled motion along each edge; empty for graphs without controls.
    pub fn motions(&self) -> &[Motion] {
        &self.motions
    }

    /// The events.
    pub fn events(&self) -> &[Event<S::State>] {
        &self.events
    }

    /// 64-bit FNV-1a over the little-endian bytes of everything in the order of its creation: all vertices (coordinates, birth),
    /// then all edges (both ends, birth), then the controlled motions along them, if any (speed, steering, duration), then all
    /// events. O(size).
    pub fn fingerprint(&self, space: &S) -> u64 {
        let mut hash = Fingerprint::default();
        for (state, &birth) in self.states.iter().zip(&self.vertex_births) {
            hash.numbers(space.coordinates(state));
            hash.integer(u64::from(birth));
        }
        for (&[from, to], &birth) in self.edges.iter().zip(&self.edge_births) {
            [from.0, to.0, birth].into_iter().for_each(|id| hash.integer(u64::from(id)));
        }
        for Motion { control, duration } in &self.motions {
            hash.numbers(&[control.speed, control.steering, *duration]);
        }
        for event in &self.events {
            hash.integer(event.kind as u64);
            hash.integer(u64::from(event.iteration));
            [event.vertex, event.other]
                .into_iter()
                .for_each(|id| hash.integer(id.map_or(u64::MAX, |id| u64::from(id.0))));
            hash.numbers(space.coordinates(&event.state));
        }
        hash.value()
    }
}
