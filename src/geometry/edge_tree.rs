//! The edges of a polygon in a tree of boxes.
//!
//! Edges that follow each other along the border are near each other, so the tree follows the border: a leaf is the box
//! around [`LEAF`] edges in sequence, every other node the box around its two children. A polygon of few corners has
//! none: there it is faster to compare all edges.

use super::{Aabb, Point};
use std::ops::Range;

/// The number of edges of a leaf.
pub(super) const LEAF: usize = 4;

/// A polygon has a tree if it has more corners than this.
pub(super) const MOST_WITHOUT: usize = 16;

/// The greatest number of nodes that wait in a traversal that visits the children of one node before its sibling: one a
/// level, and one.
pub(super) const DEPTH: usize = 40;

/// The boxes of all nodes.
#[derive(Debug, Clone)]
pub(super) struct EdgeTree {
    /// The leaves in the order of their edges, then the nodes above them, and so on up to the root.
    boxes: Vec<Aabb>,
    /// The index of the first box of each level.
    levels: Vec<u32>,
    edges: u32,
}

/// A node: its level, 0 for leaves, and its number on it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    level: u32,
    number: u32,
}

impl Node {
    /// Any node, to fill an array.
    pub const ANY: Self = Self { level: 0, number: 0 };
}

impl EdgeTree {
    /// The tree of a closed chain of corners. O(n).
    pub fn new(corners: &[Point]) -> Self {
        let n = corners.len();
        let leaf = |first: usize| {
            let all = (first..=(first + LEAF).min(n)).map(|i| corners[if i == n { 0 } else { i }]);
            Aabb::around(all).expect("a leaf has an edge")
        };
        let mut boxes: Vec<Aabb> = (0..n).step_by(LEAF).map(leaf).collect();
        let mut levels = vec![0];
        let mut first = 0;
        while boxes.len() - first > 1 {
            let above: Vec<Aabb> =
                boxes[first..].chunks(2).map(|pair| pair[1..].iter().fold(pair[0], |a, b| a.union(b))).collect();
            first = boxes.len();
            levels.push(first as u32);
            boxes.extend(above);
        }
        Self { boxes, levels, edges: n as u32 }
    }

    /// The node above all others.
    pub fn root(&self) -> Node {
        Node { level: self.levels.len() as u32 - 1, number: 0 }
    }

    /// The box around the edges of a node.
    pub fn aabb(&self, node: Node) -> &Aabb {
        &self.boxes[(self.levels[node.level as usize] + node.number) as usize]
    }

    /// The edges of a node, by the numbers of the corners that they start from.
    pub fn edges(&self, node: Node) -> Range<usize> {
        let size = LEAF << node.level;
        let first = size * node.number as usize;
        first..(first + size).min(self.edges as usize)
    }

    /// The children of a node, of which the second may be missing; `None` for a leaf.
    pub fn children(&self, node: Node) -> Option<(Node, Option<Node>)> {
        let level = node.level.checked_sub(1)?;
        let child = |number: u32| Node { level, number };
        let count = self.levels[level as usize + 1] - self.levels[level as usize];
        let second = 2 * node.number + 1;
        Some((child(2 * node.number), (second < count).then(|| child(second))))
    }
}
