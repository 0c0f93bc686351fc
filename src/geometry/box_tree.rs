//! Items in sequence, each near the one before, in a tree of boxes: a leaf is the box around [`LEAF`] of them, every other
//! node the box around its two children.
//!
//! The edges of a chain are in the sequence of the chain. Few have no tree: there it is faster to compare all.

use super::Aabb;
use std::ops::Range;

/// The number of items of a leaf.
pub(crate) const LEAF: usize = 4;

/// There is a tree if there are more items than this.
pub(super) const MOST_WITHOUT: usize = 16;

/// The greatest number of nodes that wait in a traversal that visits the children of one node before its sibling: one a
/// level, and one.
pub(super) const DEPTH: usize = 40;

/// The boxes of all nodes.
#[derive(Debug, Clone)]
pub(crate) struct BoxTree {
    /// The leaves in the order of their items, then the nodes above them, and so on up to the root.
    boxes: Vec<Aabb>,
    /// The index of the first box of each level.
    levels: Vec<u32>,
    items: u32,
}

/// A node: its level, 0 for leaves, and its number on it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Node {
    level: u32,
    number: u32,
}

impl Node {
    /// Any node, to fill an array.
    pub const ANY: Self = Self { level: 0, number: 0 };
}

impl BoxTree {
    /// The tree of this number of items; `around` is the box around a range of them. O(n).
    pub fn new(items: usize, around: impl Fn(Range<usize>) -> Aabb) -> Self {
        let leaf = |first: usize| around(first..(first + LEAF).min(items));
        let mut boxes: Vec<Aabb> = (0..items).step_by(LEAF).map(leaf).collect();
        let mut levels = vec![0];
        let mut first = 0;
        while boxes.len() - first > 1 {
            let above: Vec<Aabb> =
                boxes[first..].chunks(2).map(|pair| pair[1..].iter().fold(pair[0], |a, b| a.union(b))).collect();
            first = boxes.len();
            levels.push(first as u32);
            boxes.extend(above);
        }
        Self { boxes, levels, items: items as u32 }
    }

    /// The node above all others.
    pub fn root(&self) -> Node {
        Node { level: self.levels.len() as u32 - 1, number: 0 }
    }

    /// The box around the items of a node.
    pub fn aabb(&self, node: Node) -> &Aabb {
        &self.boxes[(self.levels[node.level as usize] + node.number) as usize]
    }

    /// The items of a node.
    pub fn items(&self, node: Node) -> Range<usize> {
        let size = LEAF << node.level;
        let first = size * node.number as usize;
        first..(first + size).min(self.items as usize)
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
