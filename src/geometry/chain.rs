//! Corners in sequence, open or closed, with a tree of their edges.

use super::box_tree::{BoxTree, MOST_WITHOUT};
use super::{Aabb, Point, Segment};
use serde::{Serialize, Serializer};
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// At least two points, each joined to the next, and the last to the first if the chain is closed.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    points: Vec<Point>,
    is_closed: bool,
    aabb: Aabb,
    /// Built by the first query; clones share it.
    tree: OnceLock<Arc<BoxTree>>,
}

/// Chains are equal if their points are, from the first on, and both are closed or both open.
impl PartialEq for Chain {
    fn eq(&self, other: &Self) -> bool {
        self.is_closed == other.is_closed && self.points == other.points
    }
}

/// As the list of its points.
impl Serialize for Chain {
    fn serialize<S: Serializer>(&self, target: S) -> Result<S::Ok, S::Error> {
        self.points.serialize(target)
    }
}

impl Chain {
    pub fn new(points: Vec<Point>, is_closed: bool) -> Self {
        let aabb = Aabb::around(points.iter().copied()).expect("a chain has points");
        Self { points, is_closed, aabb, tree: OnceLock::new() }
    }

    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The smallest box around all points.
    pub fn aabb(&self) -> &Aabb {
        &self.aabb
    }

    /// The number of edges.
    pub fn count(&self) -> usize {
        self.points.len() - usize::from(!self.is_closed)
    }

    /// The edges in order, the first from point 0.
    pub fn edges(&self) -> impl Iterator<Item = Segment> + '_ {
        let n = self.points.len();
        (0..self.count()).map(move |i| Segment::new(self.points[i], self.points[if i + 1 == n { 0 } else { i + 1 }]))
    }

    /// The tree of edges; `None` if there are so few that comparing all is faster.
    pub fn tree(&self) -> Option<&BoxTree> {
        let corner = |i: usize| self.points[if i == self.points.len() { 0 } else { i }];
        let around =
            |edges: Range<usize>| Aabb::around((edges.start..=edges.end).map(corner)).expect("a leaf has an edge");
        let build = || Arc::new(BoxTree::new(self.count(), around));
        (self.points.len() > MOST_WITHOUT).then(|| &**self.tree.get_or_init(build))
    }
}
