//! The approximate index: a forest of random-projection trees, for dimensions so high that an exact index has to
//! examine most states.
//!
//! Dasgupta and Freund 2008, "Random projection trees and low dimensional manifolds": each tree halves the states recursively at
//! the median of their projections on a random direction, here that between two of the states. States are embedded in a Euclidean
//! space, circles as (cos, sin), each coordinate by its weight in the metric. A query takes leaves from all trees, those nearest
//! beyond the planes first, until it has collected enough candidates; the metric itself ranks these. So neighbours have their
//! true distances, but some of the nearest may be missed: see [`recall`].

use super::packs::weight;
use super::{Nearest, Neighbour, Query};
use crate::geometry::sort_numbers;
use crate::graph::{Ordered, VertexId};
use crate::random::below;
use crate::space::Space;
use rand::SeedableRng;
use rand_xoshiro::SplitMix64;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A tree is rebuilt in part if it is deeper than twice the least depth by more than this. Random states are far from that.
const SPARE_DEPTH: usize = 16;

/// Construction and query parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForestParameters {
    /// How many trees, at least 1. Building and memory grow with them; recall too.
    pub trees: usize,
    /// How many states fill a leaf, at least 2.
    pub leaf: usize,
    /// How many states a query examines, at least, and never fewer than it is to find; recall and time grow with them.
    pub candidates: usize,
}

impl Default for ForestParameters {
    /// On 10,000 uniform states of the 6-torus with the sum metric these find, on average, at least 8 of the 10 nearest, and
    /// in up to four dimensions at least 9.8. An exact index is faster in up to about six dimensions.
    fn default() -> Self {
        Self { trees: 8, leaf: 32, candidates: 400 }
    }
}

/// The share of the exact neighbours that was found, whatever distance was found for them; 1 if there are none. O(k^2)
/// for k of each.
pub fn recall(found: &[Neighbour], exact: &[Neighbour]) -> f64 {
    let hits = exact.iter().filter(|one| found.iter().any(|other| other.vertex == one.vertex)).count();
    if exact.is_empty() { 1.0 } else { hits as f64 / exact.len() as f64 }
}

/// A node of a tree.
#[derive(Debug, Clone)]
enum Node {
    /// A plane: those whose projection on the direction is at least the threshold are in the second child.
    Branch { direction: Vec<f64>, threshold: f64, children: [u32; 2] },
    /// States, by their indices in the forest.
    Leaf(Vec<u32>),
}

/// A forest that grows. Insertion mostly costs O(trees log n), a query O(candidates + trees log n). States that come in order, or
/// repeatedly the same, would make a tree deep and slow: a subtree too deep for its size is rebuilt (Galperin and Rivest 1993,
/// "Scapegoat trees"), which costs O(trees log^2 n) per insertion on average. For each state it stores its embedding and about
/// trees (4 + 8 embedded dimension / leaf) bytes.
#[derive(Debug, Clone)]
pub struct Forest {
    parameters: ForestParameters,
    /// Draws the directions of the planes.
    generator: SplitMix64,
    vertices: Vec<VertexId>,
    /// The embedded states, one after the other, so that each is embedded once.
    points: Vec<f64>,
    /// The first node of each is its root.
    trees: Vec<Vec<Node>>,
    /// Of each tree the nodes that are not in use.
    spare: Vec<Vec<u32>>,
}

impl Forest {
    /// An empty forest. Its planes follow from the key alone: draw it from the stream
    /// [`Projections`](crate::random::Stream::Projections).
    ///
    /// # Panics
    /// If there is no tree, or leaves hold fewer than two.
    pub fn new(parameters: ForestParameters, key: u64) -> Self {
        assert!(parameters.trees >= 1 && parameters.leaf >= 2, "a forest has a tree, and leaves of two, at least");
        let generator = SplitMix64::seed_from_u64(key);
        let trees = vec![vec![Node::Leaf(Vec::new())]; parameters.trees];
        let spare = vec![Vec::new(); parameters.trees];
        Self { parameters, generator, vertices: Vec::new(), points: Vec::new(), trees, spare }
    }

    /// The embedded state of an index.
    fn point(&self, member: u32) -> &[f64] {
        let width = self.points.len() / self.vertices.len();
        &self.points[member as usize * width..][..width]
    }

    /// Halves a leaf of one tree; returns its children.
    fn split(&mut self, tree: usize, node: usize, mut members: Vec<u32>) -> [u32; 2] {
        let pair = [0; 2].map(|_| members[below(&mut self.generator, members.len() as u64) as usize]);
        let [a, b] = pair.map(|member| self.point(member));
        let direction: Vec<f64> = a.iter().zip(b).map(|(a, b)| b - a).collect();
        let along = |&member: &u32| projection(&direction, self.point(member));
        let projections: Vec<f64> = members.iter().map(along).collect();
        let mut order: Vec<u32> = (0..members.len() as u32).collect();
        sort_numbers(&mut order, &|a, b| projections[a].total_cmp(&projections[b]).then(members[a].cmp(&members[b])));
        let middle = order.len() / 2;
        let threshold = projections[order[middle] as usize];
        members = order.iter().map(|&at| members[at as usize]).collect();
        let second = members.split_off(middle);
        let children = [members, second].map(|members| self.leaf(tree, members));
        self.trees[tree][node] = Node::Branch { direction, threshold, children };
        children
    }

    /// A new leaf of one tree.
    fn leaf(&mut self, tree: usize, members: Vec<u32>) -> u32 {
        let nodes = &mut self.trees[tree];
        if let Some(node) = self.spare[tree].pop() {
            nodes[node as usize] = Node::Leaf(members);
            return node;
        }
        nodes.push(Node::Leaf(members));
        nodes.len() as u32 - 1
    }

    /// The largest depth of a tree of this number of states: more than twice the least.
    fn deepest(&self, states: usize) -> usize {
        let leaves = states as f64 / self.parameters.leaf as f64;
        SPARE_DEPTH + libm::ceil(2.0 * libm::log2(leaves.max(1.0))) as usize
    }

    /// Rebuilds the lowest subtree on the path from the root to a leaf that is too deep for its size. At least the whole tree is.
    fn even_out(&mut self, tree: usize, path: &[u32]) {
        let (mut members, mut free) = (Vec::new(), Vec::new());
        for (depth, &top) in (1..).zip(path.iter().rev()) {
            let mut open = vec![top];
            while let Some(node) = open.pop() {
                // The previous subtree, further down, is empty by now.
                match std::mem::replace(&mut self.trees[tree][node as usize], Node::Leaf(Vec::new())) {
                    Node::Leaf(mut some) => members.append(&mut some),
                    Node::Branch { children, .. } => open.extend(children),
                }
                if node != top {
                    free.push(node);
                }
            }
            if depth > self.deepest(members.len()) {
                self.spare[tree].append(&mut free);
                sort_numbers(&mut members, &|i, j| i.cmp(&j));
                return self.build(tree, top, members);
            }
        }
    }

    /// Halves a leaf of these members recursively.
    fn build(&mut self, tree: usize, leaf: u32, members: Vec<u32>) {
        let mut open = vec![(leaf, members)];
        while let Some((leaf, members)) = open.pop() {
            if members.len() <= self.parameters.leaf {
                self.trees[tree][leaf as usize] = Node::Leaf(members);
                continue;
            }
            for child in self.split(tree, leaf as usize, members) {
                if let Node::Leaf(members) = &mut self.trees[tree][child as usize] {
                    open.push((child, std::mem::take(members)));
                }
            }
        }
    }

    /// The depth of the deepest leaf, in nodes: O(log n), in whatever order states come and however
    /// many of them are the same. Takes O(nodes).
    pub fn depth(&self) -> usize {
        let mut deepest = 0;
        for nodes in &self.trees {
            let mut open = vec![(0, 1)];
            while let Some((node, depth)) = open.pop() {
                deepest = deepest.max(depth);
                if let Node::Branch { children, .. } = &nodes[node as usize] {
                    open.extend(children.map(|child| (child, depth + 1)));
                }
            }
        }
        deepest
    }

    /// Collects the states of leaves, nearest planes first, until there are `enough`.
    fn search<S: Space>(&self, query: Query<S>, enough: usize, found: &mut Vec<Neighbour>) {
        let Query { space, states, from, .. } = query;
        found.clear();
        let point = embedded(space, from);
        let mut seen = vec![0u64; self.vertices.len().div_ceil(64)];
        // By margin; ties by tree and node.
        let mut waiting: BinaryHeap<Reverse<(Ordered, u32, u32)>> = BinaryHeap::new();
        waiting.extend((0..self.trees.len() as u32).map(|tree| Reverse((Ordered::ZERO, tree, 0))));
        while let Some(Reverse((margin, tree, mut node))) = waiting.pop() {
            let members = loop {
                match &self.trees[tree as usize][node as usize] {
                    Node::Leaf(members) => break members,
                    Node::Branch { direction, threshold, children } => {
                        let beyond = projection(direction, &point) - threshold;
                        let side = usize::from(beyond >= 0.0);
                        let margin = margin.max(Ordered::new(beyond.abs()));
                        waiting.push(Reverse((margin, tree, children[1 - side])));
                        node = children[side];
                    }
                }
            };
            for &member in members {
                let (word, bit) = (member as usize / 64, 1 << (member % 64));
                if seen[word] & bit != 0 {
                    continue;
                }
                seen[word] |= bit;
                let vertex = self.vertices[member as usize];
                found.push(Neighbour { distance: space.distance(from, &states[vertex.index()]), vertex });
            }
            if found.len() >= enough {
                break;
            }
        }
    }
}

impl<S: Space> Nearest<S> for Forest {
    fn insert(&mut self, space: &S, vertex: VertexId, state: &S::State) {
        let member = self.vertices.len() as u32;
        self.vertices.push(vertex);
        let point = embedded(space, state);
        self.points.extend_from_slice(&point);
        let mut path = Vec::new();
        for tree in 0..self.trees.len() {
            let nodes = &mut self.trees[tree];
            let mut node = 0;
            path.clear();
            path.push(0);
            while let Node::Branch { direction, threshold, children } = &nodes[node] {
                let child = children[usize::from(projection(direction, &point) >= *threshold)];
                path.push(child);
                node = child as usize;
            }
            if let Node::Leaf(members) = &mut nodes[node] {
                members.push(member);
                if members.len() > self.parameters.leaf {
                    let members = std::mem::take(members);
                    self.split(tree, node, members);
                }
            }
            if path.len() > self.deepest(self.vertices.len()) {
                self.even_out(tree, &path);
            }
        }
    }

    fn len(&self) -> usize {
        self.vertices.len()
    }

    fn k_nearest(&self, query: Query<S>, k: usize, found: &mut Vec<Neighbour>) -> usize {
        found.clear();
        if k > 0 {
            self.search(query, self.parameters.candidates.max(k), found);
        }
        let visited = found.len();
        Neighbour::first(found, k);
        visited
    }

    fn within(&self, query: Query<S>, radius: f64, found: &mut Vec<Neighbour>) -> usize {
        self.search(query, self.parameters.candidates, found);
        let visited = found.len();
        found.retain(|neighbour| neighbour.distance <= radius);
        Neighbour::first(found, usize::MAX);
        visited
    }
}

/// A state as a point of a Euclidean space, circles as (cos, sin), each coordinate by its weight in the metric.
fn embedded<S: Space>(space: &S, state: &S::State) -> Vec<f64> {
    let mut point = Vec::with_capacity(2 * space.dimension());
    for (i, &x) in space.coordinates(state).iter().enumerate() {
        let weight = weight(space, i);
        let period = space.period(i);
        if period.is_finite() {
            // A circle of this radius has the circumference `period`.
            let radius = period / std::f64::consts::TAU;
            let (sin, cos) = libm::sincos(x / radius);
            point.extend([weight * radius * cos, weight * radius * sin]);
        } else {
            point.push(weight * x);
        }
    }
    point
}

fn projection(direction: &[f64], point: &[f64]) -> f64 {
    direction.iter().zip(point).fold(0.0, |sum, (a, b)| sum + a * b)
}
