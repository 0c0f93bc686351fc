//! A tree in which a vertex may get another parent, and every vertex knows the cost of its path from the root.

use super::{Tree, VertexId};

/// A tree with the cost of the path to each vertex: the sum of the costs of its edges, added from the root on, to the bit.
#[derive(Debug, Clone, Default)]
pub struct CostTree {
    tree: Tree,
    /// By vertex: the cost of its path; infinite outside of the tree.
    costs: Vec<f64>,
    /// By vertex: the cost of the edge from its parent.
    edges: Vec<f64>,
    children: Vec<Vec<VertexId>>,
}

impl CostTree {
    /// The tree that is only this root.
    pub fn of(root: VertexId) -> Self {
        let mut tree = Self::default();
        tree.make_room(root);
        tree.tree.add_root(root);
        tree.costs[root.index()] = 0.0;
        tree
    }

    fn make_room(&mut self, vertex: VertexId) {
        let len = self.costs.len().max(vertex.index() + 1);
        self.costs.resize(len, f64::INFINITY);
        self.edges.resize(len, 0.0);
        self.children.resize(len, Vec::new());
    }

    /// The parents.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The cost of the path to a vertex; infinite if the vertex is not in the tree.
    pub fn cost(&self, vertex: VertexId) -> f64 {
        self.costs.get(vertex.index()).copied().unwrap_or(f64::INFINITY)
    }

    /// Whether no vertex has this one as its parent. O(1).
    pub fn is_leaf(&self, vertex: VertexId) -> bool {
        self.children.get(vertex.index()).is_none_or(Vec::is_empty)
    }

    /// Removes a vertex without children; returns its parent, `None` if it was not in the tree. O(children of the parent).
    ///
    /// # Panics
    /// In debug builds, if the vertex has children.
    pub fn remove(&mut self, vertex: VertexId) -> Option<VertexId> {
        debug_assert!(self.is_leaf(vertex), "its children would have no parent");
        let parent = self.parent(vertex)?;
        self.children[parent.index()].retain(|&child| child != vertex);
        self.costs[vertex.index()] = f64::INFINITY;
        self.tree.remove(vertex);
        Some(parent)
    }

    /// The parent of a vertex; `None` of the root and outside of the tree.
    fn parent(&self, vertex: VertexId) -> Option<VertexId> {
        self.tree.contains(vertex).then(|| self.tree.parent(vertex)).flatten()
    }

    /// Puts a vertex below a parent by an edge of this cost, from which the costs of all its descendants follow. Returns the
    /// former parent of a vertex that was in the tree. O(children of the former parent + descendants).
    ///
    /// # Panics
    /// In debug builds, if the vertex costs no less below this parent: then the parent might be among its descendants.
    pub fn attach(&mut self, vertex: VertexId, parent: VertexId, edge: f64) -> Option<VertexId> {
        debug_assert!(self.cost(parent) + edge < self.cost(vertex), "a vertex gets no worse parent");
        self.make_room(vertex);
        let former = self.parent(vertex);
        if let Some(former) = former {
            self.children[former.index()].retain(|&child| child != vertex);
        }
        self.tree.add(vertex, parent);
        self.edges[vertex.index()] = edge;
        self.children[parent.index()].push(vertex);
        let mut changed = vec![vertex];
        while let Some(at) = changed.pop() {
            let parent = self.tree.parent(at).expect("the root's cost never changes");
            self.costs[at.index()] = self.costs[parent.index()] + self.edges[at.index()];
            changed.extend_from_slice(&self.children[at.index()]);
        }
        former
    }
}
