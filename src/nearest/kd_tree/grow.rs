//! Growing the kd-tree: insertion, splitting of leaves, rebuilding of unbalanced subtrees.

use super::{Branch, KdTree, LANES, LEAF, LEAF_PACKS, Leaf, MAX_DEPTH, Node, Sides};
use crate::graph::{VertexId, append, make_room};

/// States of a subtree that is rebuilt.
struct Entries {
    dimension: usize,
    numbers: Vec<f32>,
    vertices: Vec<VertexId>,
}

impl Entries {
    fn coordinates(&self, entry: u32) -> &[f32] {
        &self.numbers[entry as usize * self.dimension..][..self.dimension]
    }

    /// The lowest and the highest number on an axis.
    fn range(&self, entries: &[u32], axis: usize) -> [f32; 2] {
        let numbers = entries.iter().map(|&entry| self.numbers[entry as usize * self.dimension + axis]);
        numbers.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    }
}

impl KdTree {
    /// Adds a state. O(log n) but for rebuilding, which costs O(log^2 n) per state over time.
    pub(super) fn grow(&mut self, vertex: VertexId, coordinates: &[f32]) {
        let mut node = self.root;
        let mut parent = None;
        let mut lopsided = None;
        let mut depth = 0;
        while !node.is_leaf() {
            let dimension = coordinates.len();
            let branch = &mut self.branches[node.index()];
            let side = usize::from(coordinates[branch.axis as usize] >= branch.split);
            branch.counts[side] += 1;
            let ([a, b], sum) = (branch.counts, branch.counts[0] + branch.counts[1]);
            if lopsided.is_none() && u64::from(a.max(b)) * 10 > u64::from(sum) * 7 + 10 * LEAF as u64 {
                lopsided = Some((parent, node));
            }
            let next = branch.children[side];
            for (sides, &x) in self.boxes[node.index() * dimension..][..dimension].iter_mut().zip(coordinates) {
                sides[side] = sides[side].min(x);
                sides[2 + side] = sides[2 + side].min(-x);
            }
            parent = Some((node, side));
            node = next;
            depth += 1;
        }
        self.len += 1;
        let len = self.leaves[node.index()].len as usize;
        if len < LEAF {
            self.fill(node.index(), vertex, coordinates);
        } else {
            // A split makes the path to these states one branch longer.
            if depth + 1 >= MAX_DEPTH {
                lopsided = Some((None, self.root));
            }
            lopsided = lopsided.or(Some((parent, node)));
        }
        if let Some((parent, node)) = lopsided {
            let extra = (len == LEAF).then_some((vertex, coordinates));
            let new = self.rebuild(node, extra);
            match parent {
                Some((branch, side)) => self.branches[branch.index()].children[side] = new,
                None => self.root = new,
            }
        }
    }

    /// Adds a state to a leaf that is not full.
    fn fill(&mut self, leaf: usize, vertex: VertexId, coordinates: &[f32]) {
        let at = self.leaves[leaf].len as usize;
        if at.is_multiple_of(LANES) {
            self.leaves[leaf].packs[at / LANES] = match self.free_packs.pop() {
                Some(pack) => pack,
                None => self.packs.add(),
            };
        }
        let pack = self.leaves[leaf].packs[at / LANES] as usize;
        self.packs.set(pack, at % LANES, vertex, coordinates);
        self.leaves[leaf].len += 1;
    }

    /// Rebuilds the subtree under a node, balanced, with one more state if one is given. O(m log m) for m states.
    fn rebuild(&mut self, node: Node, extra: Option<(VertexId, &[f32])>) -> Node {
        let mut entries = Entries { dimension: self.packs.dimension, numbers: Vec::new(), vertices: Vec::new() };
        self.take(node, &mut entries);
        if let Some((vertex, coordinates)) = extra {
            entries.numbers.extend_from_slice(coordinates);
            entries.vertices.push(vertex);
        }
        let mut order: Vec<u32> = (0..entries.vertices.len() as u32).collect();
        self.build(&entries, &mut order)
    }

    /// Collects the states of a subtree and frees its nodes.
    fn take(&mut self, node: Node, entries: &mut Entries) {
        if !node.is_leaf() {
            self.free_branches.push(node.0);
            for child in self.branches[node.index()].children {
                self.take(child, entries);
            }
            return;
        }
        let Leaf { packs, len } = self.leaves[node.index()];
        self.free_leaves.push(node.index() as u32);
        for at in 0..len as usize {
            let pack = packs[at / LANES] as usize;
            entries.numbers.extend(self.packs.rows(pack).iter().map(|row| row[at % LANES]));
            entries.vertices.push(self.packs.vertices(pack)[at % LANES]);
        }
        for &pack in &packs[..(len as usize).div_ceil(LANES)] {
            self.packs.clear(pack as usize);
            self.free_packs.push(pack);
        }
    }

    /// Builds a tree of the given entries, split at the median of the widest axis until they fit a leaf.
    fn build(&mut self, entries: &Entries, order: &mut [u32]) -> Node {
        if order.len() <= LEAF {
            return self.build_leaf(entries, order);
        }
        let dimension = entries.dimension;
        let mut widest = (0, f64::NEG_INFINITY);
        for axis in 0..dimension {
            let [low, high] = entries.range(order, axis);
            let width = f64::from(high - low) * self.packs.weights[axis];
            if width > widest.1 {
                widest = (axis, width);
            }
        }
        let axis = widest.0;
        // Whole packs to the first half; ties by vertex, so that the shape depends only on the states.
        let middle = (order.len() / 2).next_multiple_of(LANES);
        let number = |entry: u32| entries.numbers[entry as usize * dimension + axis];
        order.select_nth_unstable_by(middle, |&a, &b| {
            number(a).total_cmp(&number(b)).then(entries.vertices[a as usize].cmp(&entries.vertices[b as usize]))
        });
        let at = order[middle];
        let (first, second) = order.split_at_mut(middle);
        let counts = [first.len() as u32, second.len() as u32];
        let index = match self.free_branches.pop() {
            Some(index) => index as usize,
            None => {
                make_room(&mut self.boxes, dimension);
                append(&mut self.branches, Branch { split: 0.0, axis: 0, children: [Node(0); 2], counts });
                self.boxes.resize(self.branches.len() * dimension, Sides::default());
                self.branches.len() - 1
            }
        };
        for axis in 0..dimension {
            let (a, b) = (entries.range(first, axis), entries.range(second, axis));
            self.boxes[index * dimension + axis] = [a[0], b[0], -a[1], -b[1]];
        }
        let children = [self.build(entries, first), self.build(entries, second)];
        self.branches[index] = Branch { split: number(at), axis: axis as u32, children, counts };
        Node(index as u32)
    }

    fn build_leaf(&mut self, entries: &Entries, order: &[u32]) -> Node {
        let leaf = Leaf { packs: [0; LEAF_PACKS], len: 0 };
        let index = match self.free_leaves.pop() {
            Some(index) => {
                self.leaves[index as usize] = leaf;
                index as usize
            }
            None => {
                append(&mut self.leaves, leaf);
                self.leaves.len() - 1
            }
        };
        for &entry in order {
            self.fill(index, entries.vertices[entry as usize], entries.coordinates(entry));
        }
        Node::leaf(index)
    }
}
