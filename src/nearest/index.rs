//! The exact index that planners use: about as fast as the faster of linear scan and kd-tree at any size.

use super::{KdTree, LinearScan, Nearest, Neighbour, Neighbourhood, Query};
use crate::graph::VertexId;
use crate::space::Space;

/// The scan's copy of the states is dropped above this size; only a very large k would still favour it.
const MOST_SCANNED: usize = 8192;

/// A tree is built above this size; the crossover is never below it.
const FEWEST_IN_TREE: usize = 60;

/// A linear scan for few states and a kd-tree for many. Which one runs depends only on the number of states, neighbours and
/// dimensions; both return the same bits. If the norm of the space is only a lower bound on distances, the tree finds
/// candidates by the norm and ranks them by their distance.
#[derive(Debug, Clone, Default)]
pub struct Index {
    /// Empty if the norm is only a lower bound.
    scan: LinearScan,
    tree: KdTree,
    len: usize,
}

impl Index {
    /// The nearest vertex, and how many vertices were visited; `None` if the index is empty.
    pub fn nearest_counted<S: Space>(&self, query: Query<S>) -> Option<(Neighbour, usize)> {
        // Empty if the norm is only a lower bound.
        if let Some(nearest) = self.scan.nearest_of_few(query) {
            return Some((nearest, self.len));
        }
        let mut found = Vec::with_capacity(2);
        let visited = self.k_nearest(query, 1, &mut found);
        found.pop().map(|nearest| (nearest, visited))
    }

    /// The vertices of a neighbourhood into `found`, in any order: those within a radius are not sorted, which takes a good part
    /// of such a query. Returns how many vertices were visited. Pass another list to other queries: they guess distances by the
    /// last neighbour of their list.
    pub fn find_in_any_order<S: Space>(
        &self,
        query: Query<S>,
        neighbourhood: Neighbourhood,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        match neighbourhood {
            Neighbourhood::Within(radius) => self.all_within(query, radius, false, found),
            _ => self.find(query, neighbourhood, found),
        }
    }

    /// Every vertex no farther than `radius`: nearest first, or in any order. Returns how many vertices were visited.
    fn all_within<S: Space>(
        &self,
        query: Query<S>,
        radius: f64,
        sorts_result: bool,
        found: &mut Vec<Neighbour>,
    ) -> usize {
        let Query { space, states, direction, from } = query;
        if space.is_norm_exact() {
            return match self.len <= Self::crossover(space, 1) {
                true => self.scan.within(query, radius, found),
                false => self.tree.all_within(query, radius, sorts_result, found),
            };
        }
        let visited = self.tree.all_within(query, radius, false, found);
        for candidate in &mut *found {
            let other = &states[candidate.vertex.index()];
            candidate.distance = direction.distance_within(space, from, other, radius);
        }
        found.retain(|neighbour| neighbour.distance <= radius);
        if sorts_result {
            Neighbour::sort(found);
        }
        visited
    }

    /// The number of states up to which a scan finds `k` neighbours faster than the tree: linear fits to the figures of the
    /// benchmark `nearest`.
    fn crossover<S: Space>(space: &S, k: usize) -> usize {
        let (few, each) = match space.dimension() {
            0..=2 => (60, 3),
            3 => (60, 17),
            4 => (250, 45),
            5 => (700, 110),
            _ => (1400, 250),
        };
        (few + each * k.min(MOST_SCANNED)).min(MOST_SCANNED)
    }
}

impl<S: Space> Nearest<S> for Index {
    fn insert(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        self.len += 1;
        if !space.is_norm_exact() {
            return self.tree.insert(space, vertex, state);
        }
        if self.len > FEWEST_IN_TREE {
            if Nearest::<S>::is_empty(&self.tree) {
                self.tree = KdTree::of(self.scan.packs(), FEWEST_IN_TREE);
            }
            self.tree.insert(space, vertex, state);
        }
        if self.len > MOST_SCANNED {
            self.scan = LinearScan::default();
        } else {
            self.scan.insert(space, vertex, state);
        }
    }

    fn len(&self) -> usize {
        self.len
    }

    fn nearest(&self, query: Query<S>) -> Option<Neighbour> {
        self.nearest_counted(query).map(|(nearest, _)| nearest)
    }

    fn k_nearest(&self, query: Query<S>, k: usize, found: &mut Vec<Neighbour>) -> usize {
        let Query { space, states, direction, from } = query;
        if !space.is_norm_exact() {
            let distance =
                |vertex: VertexId, most| direction.distance_within(space, from, &states[vertex.index()], most);
            self.tree.k_nearest_ranked(query, k, found, distance)
        } else if self.len <= Self::crossover(space, k) {
            self.scan.k_nearest(query, k, found)
        } else {
            self.tree.k_nearest(query, k, found)
        }
    }

    fn within(&self, query: Query<S>, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        self.all_within(query, radius, true, found)
    }
}
