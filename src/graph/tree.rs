//! Trees among the vertices of a graph.

use super::VertexId;

/// A tree or a forest among the vertices of a graph, by the parent of each vertex that belongs to it.
#[derive(Debug, Clone, Default)]
pub struct Tree {
    /// A root is its own parent.
    parents: Vec<u32>,
}

/// The parent of a vertex that is in no tree.
const NONE: u32 = u32::MAX;

impl Tree {
    /// An empty forest among this number of vertices.
    pub fn with_room(vertices: usize) -> Self {
        Self { parents: vec![NONE; vertices] }
    }

    /// Adds a root.
    pub fn add_root(&mut self, root: VertexId) {
        self.add(root, root);
    }

    /// Adds a vertex below its parent.
    #[inline]
    pub fn add(&mut self, vertex: VertexId, parent: VertexId) {
        if self.parents.len() <= vertex.index() {
            self.parents.resize(vertex.index() + 1, NONE);
        }
        self.parents[vertex.index()] = parent.0;
    }

    /// Removes a vertex, which has no children.
    pub(super) fn remove(&mut self, vertex: VertexId) {
        self.parents[vertex.index()] = NONE;
    }

    /// Whether the vertex belongs to it.
    #[inline]
    pub fn contains(&self, vertex: VertexId) -> bool {
        self.parents.get(vertex.index()).is_some_and(|&parent| parent != NONE)
    }

    /// The parent of a vertex; `None` of a root.
    pub fn parent(&self, vertex: VertexId) -> Option<VertexId> {
        let parent = VertexId(self.parents[vertex.index()]);
        (parent != vertex).then_some(parent)
    }

    /// The vertices from this one to its root, both included.
    pub fn to_root(&self, vertex: VertexId) -> Vec<VertexId> {
        std::iter::successors(Some(vertex), |&at| self.parent(at)).collect()
    }

    /// The vertices from its root to this one, both included.
    pub fn from_root(&self, vertex: VertexId) -> Vec<VertexId> {
        let mut path = self.to_root(vertex);
        path.reverse();
        path
    }
}
