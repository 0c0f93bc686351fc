//! Rings that are apart from each other in a tree of boxes.

use super::box_tree::{BoxTree, DEPTH, LEAF, Node};
use super::{Aabb, Polygon, arrange};
use std::cell::Cell;
use std::ops::Range;

/// The numbers of rings, so that neighbours are adjacent, and the boxes around them.
#[derive(Debug)]
pub(super) struct RingTree {
    order: Vec<u32>,
    tree: BoxTree,
}

impl RingTree {
    /// O(n log n) for n rings.
    pub fn new(rings: &[Polygon]) -> Self {
        let boxes: Vec<Aabb> = rings.iter().map(|ring| *ring.aabb()).collect();
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        arrange(&mut order, &boxes, LEAF);
        let around = |items: Range<usize>| {
            let all = order[items].iter().map(|&i| boxes[i as usize]);
            all.reduce(|a, b| a.union(&b)).expect("a leaf has a ring")
        };
        let tree = BoxTree::new(order.len(), around);
        Self { order, tree }
    }

    /// Calls `visit` with the rings of every leaf of which the `bound` is at most the limit, nearer ones first, until it returns
    /// true; returns whether it did.
    pub fn any(&self, limit: &Cell<f64>, bound: &dyn Fn(&Aabb) -> f64, visit: &mut dyn FnMut(usize) -> bool) -> bool {
        let mut stack = [(0.0, Node::ANY); DEPTH];
        stack[0].1 = self.tree.root();
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let (bounded, node) = stack[waiting];
            if bounded > limit.get() {
                continue;
            }
            let Some((first, second)) = self.tree.children(node) else {
                if self.order[self.tree.items(node)].iter().any(|&i| visit(i as usize)) {
                    return true;
                }
                continue;
            };
            let of = |node: Node| (bound(self.tree.aabb(node)), node);
            let (mut near, mut far) = (of(first), second.map(of));
            if let Some(other) = &mut far
                && other.0 < near.0
            {
                std::mem::swap(other, &mut near);
            }
            // The last is taken first.
            for child in far.into_iter().chain([near]) {
                stack[waiting] = child;
                waiting += 1;
            }
        }
        false
    }
}
