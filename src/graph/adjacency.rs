//! Who is joined to whom: compressed rows over the edges of a graph.

use super::VertexId;

/// The neighbours of every vertex of an undirected graph, in the order of the edges.
#[derive(Debug, Clone, Default)]
pub struct Adjacency {
    /// Row v is `targets[starts[v]..starts[v + 1]]`.
    starts: Vec<u32>,
    targets: Vec<VertexId>,
}

impl Adjacency {
    /// The neighbours along the given edges, in both directions, among `vertices` vertices. O(vertices + edges).
    pub fn new(vertices: usize, edges: &[[VertexId; 2]]) -> Self {
        Self::joining(vertices, edges, &[])
    }

    /// The same along two lists of edges.
    pub fn joining(vertices: usize, edges: &[[VertexId; 2]], more: &[[VertexId; 2]]) -> Self {
        let edges = [edges, more];
        let mut starts = vec![0u32; vertices + 1];
        for id in edges.into_iter().flatten().flatten() {
            starts[id.index() + 1] += 1;
        }
        for v in 0..vertices {
            starts[v + 1] += starts[v];
        }
        let mut free = starts.clone();
        let mut targets = vec![VertexId(0); starts[vertices] as usize];
        for &[a, b] in edges.into_iter().flatten() {
            for (from, to) in [(a, b), (b, a)] {
                let at = &mut free[from.index()];
                targets[*at as usize] = to;
                *at += 1;
            }
        }
        Self { starts, targets }
    }

    /// The neighbours of the vertex.
    pub fn neighbours(&self, vertex: VertexId) -> &[VertexId] {
        &self.targets[self.starts[vertex.index()] as usize..self.starts[vertex.index() + 1] as usize]
    }
}
