//! The neighbours of the vertices of a graph: compressed rows over its edges.

use super::VertexId;

/// The neighbours of every vertex of a graph, in the order of the edges.
#[derive(Debug, Clone, Default)]
pub struct Adjacency {
    successors: Rows,
    /// If edges have a direction, the vertices that lead to each; else they are the same.
    predecessors: Option<Rows>,
}

/// A list of vertices for every vertex: that of v is `targets[starts[v]..starts[v + 1]]`.
#[derive(Debug, Clone, Default)]
struct Rows {
    starts: Vec<u32>,
    targets: Vec<VertexId>,
}

impl Rows {
    /// Lists for every edge the vertex at one end under that at the other, for the given pairs of ends.
    fn new(vertices: usize, edges: [&[[VertexId; 2]]; 2], ends: &[[usize; 2]]) -> Self {
        let mut starts = vec![0u32; vertices + 1];
        for edge in edges.into_iter().flatten() {
            ends.iter().for_each(|&[from, _]| starts[edge[from].index() + 1] += 1);
        }
        for v in 0..vertices {
            starts[v + 1] += starts[v];
        }
        let mut free = starts.clone();
        let mut targets = vec![VertexId(0); starts[vertices] as usize];
        for edge in edges.into_iter().flatten() {
            for &[from, to] in ends {
                let at = &mut free[edge[from].index()];
                targets[*at as usize] = edge[to];
                *at += 1;
            }
        }
        Self { starts, targets }
    }

    fn of(&self, vertex: VertexId) -> &[VertexId] {
        &self.targets[self.starts[vertex.index()] as usize..self.starts[vertex.index() + 1] as usize]
    }
}

impl Adjacency {
    /// The neighbours along two lists of edges among `vertices` vertices: in both directions, or only from the first vertex
    /// of an edge to the second. O(vertices + edges).
    pub fn new(vertices: usize, edges: &[[VertexId; 2]], more: &[[VertexId; 2]], is_directed: bool) -> Self {
        let rows = |ends: &[_]| Rows::new(vertices, [edges, more], ends);
        if is_directed {
            Self { successors: rows(&[[0, 1]]), predecessors: Some(rows(&[[1, 0]])) }
        } else {
            Self { successors: rows(&[[0, 1], [1, 0]]), predecessors: None }
        }
    }

    /// The vertices that an edge leads to from this one.
    pub fn neighbours(&self, vertex: VertexId) -> &[VertexId] {
        self.successors.of(vertex)
    }

    /// The vertices from which an edge leads to this one.
    pub fn predecessors(&self, vertex: VertexId) -> &[VertexId] {
        self.predecessors.as_ref().unwrap_or(&self.successors).of(vertex)
    }
}
