//! An index of vertices from which vertices can be removed.

use crate::graph::VertexId;
use crate::nearest::{Index, Nearest, Neighbour, Query};
use crate::space::Space;

/// Vertices of a graph. Removed ones stay in the underlying index, where queries skip them, until they are half of it;
/// then it is rebuilt. So a removal costs O(log n) amortized.
#[derive(Default)]
pub(super) struct RemovableIndex {
    index: Index,
    /// The vertices of the index, in the order of insertion.
    members: Vec<VertexId>,
    /// Whether the vertex of this number is in the index.
    is_in: Vec<bool>,
    len: usize,
}

impl RemovableIndex {
    /// How many vertices there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Removes a vertex of the index.
    pub fn remove<S: Space>(&mut self, space: &S, states: &[S::State], vertex: VertexId) {
        self.is_in[vertex.index()] = false;
        self.len -= 1;
        if 2 * self.len < self.members.len() {
            self.members.retain(|vertex| self.is_in[vertex.index()]);
            self.index = Index::default();
            for &vertex in &self.members {
                self.index.insert(space, vertex, &states[vertex.index()]);
            }
        }
    }

    /// Whether the vertex is in the index.
    pub fn contains(&self, vertex: VertexId) -> bool {
        self.is_in.get(vertex.index()) == Some(&true)
    }
}

impl<S: Space> Nearest<S> for RemovableIndex {
    fn insert(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        self.index.insert(space, vertex, state);
        self.members.push(vertex);
        self.is_in.resize(self.is_in.len().max(vertex.index() + 1), false);
        self.is_in[vertex.index()] = true;
        self.len += 1;
    }

    fn len(&self) -> usize {
        self.len
    }

    fn k_nearest(&self, query: Query<S>, k: usize, found: &mut Vec<Neighbour>) -> usize {
        let mut asked = k;
        loop {
            let visited = self.index.k_nearest(query, asked, found);
            let all = found.len();
            found.retain(|neighbour| self.contains(neighbour.vertex));
            found.truncate(k);
            if found.len() == k || all < asked {
                return visited;
            }
            asked *= 2;
        }
    }

    fn within(&self, query: Query<S>, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        let visited = self.index.within(query, radius, found);
        found.retain(|neighbour| self.contains(neighbour.vertex));
        visited
    }
}
