//! The sparse graph: a greedy spanner of the dense roadmap, with the guards as nodes.
//!
//! Althoefer's greedy spanner (Althofer, Das, Dobkin, Joseph and Soares 1993, "On sparse spanners of weighted graphs") takes
//! pairs in the order of their distances, and joins those that the graph so far makes a detour for. Here the distance of two
//! nodes is that in the dense roadmap (Marble and Bekris 2013, "Asymptotically near-optimal planning with probabilistic roadmap
//! spanners"):
//!
//! ```text
//! for each pair of nodes, nearest in the roadmap first:
//!     if the way over the graph is at most t times their distance: next pair
//!     if the straight way is free: add it as an edge
//!     else add the way over the roadmap, straightened; its corners are nodes from now on
//! ```
//!
//! Afterwards the way between any two nodes is at most t times that over the roadmap.

use super::MAX_NODES;
use super::dense::Dense;
use super::ground::Ground;
use crate::error::{Code, Error};
use crate::graph::Ordered;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What rounding adds to the length of a way, relative to it.
pub(super) const ROUNDED: f64 = 1e-12;

/// The graph while it grows.
pub(super) struct Spanner<'a> {
    pub ground: &'a Ground,
    pub dense: &'a Dense,
    /// The largest detour.
    pub detour: f64,
    /// The vertex of the roadmap that each node is.
    pub nodes: Vec<u32>,
    /// The neighbours of each node, with the lengths of the edges.
    pub neighbours: Vec<Vec<(u32, f64)>>,
    /// The length of the shortest way between two nodes over the graph.
    pub ways: Vec<Vec<f64>>,
    /// The distance of two nodes: the way over the roadmap, or the straight one where that was tried and is free.
    pub distances: Vec<Vec<f64>>,
    open: BinaryHeap<Reverse<(Ordered, u32, u32)>>,
}

impl<'a> Spanner<'a> {
    /// The spanner of these vertices of the roadmap, and those that their connection needs. O(p log p) for p pairs of nodes,
    /// O(p) for each edge, and a search of the roadmap for each node.
    ///
    /// # Errors
    /// `too-large` for more than [`MAX_NODES`] nodes.
    pub fn new(ground: &'a Ground, dense: &'a Dense, detour: f64, vertices: &[u32]) -> Result<Self, Error> {
        let (nodes, neighbours, ways, distances) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let open = BinaryHeap::new();
        if vertices.len() > MAX_NODES {
            return Err(too_many());
        }
        let mut spanner = Self { ground, dense, detour, nodes, neighbours, ways, distances, open };
        for &vertex in vertices {
            spanner.add_node(vertex)?;
        }
        while let Some(Reverse((_, a, b))) = spanner.open.pop() {
            spanner.connect(a, b)?;
        }
        Ok(spanner)
    }

    /// The number of a vertex as a node, which it becomes if it was none.
    fn add_node(&mut self, vertex: u32) -> Result<u32, Error> {
        if let Some(node) = self.nodes.iter().position(|known| *known == vertex) {
            return Ok(node as u32);
        }
        let node = self.nodes.len() as u32;
        if node as usize >= MAX_NODES {
            return Err(too_many());
        }
        let reached = self.dense.reach(vertex, None);
        let row: Vec<f64> = self.nodes.iter().map(|known| reached.lengths[*known as usize]).collect();
        for (other, &distance) in row.iter().enumerate() {
            self.distances[other].push(distance);
            self.ways[other].push(f64::INFINITY);
            if distance < f64::INFINITY {
                self.open.push(Reverse((Ordered::new(distance), other as u32, node)));
            }
        }
        self.distances.push([row, vec![0.0]].concat());
        self.ways.push([vec![f64::INFINITY; node as usize], vec![0.0]].concat());
        self.neighbours.push(Vec::new());
        self.nodes.push(vertex);
        Ok(node)
    }

    /// Joins two nodes unless the way between them is short enough.
    fn connect(&mut self, a: u32, b: u32) -> Result<(), Error> {
        let straight = self.straight(a, b);
        if self.is_short(a, b, straight) {
            return Ok(());
        }
        if self.is_free(a, b) {
            self.add_edge(a, b);
            return Ok(());
        }
        if self.is_short(a, b, self.distances[a as usize][b as usize]) {
            return Ok(());
        }
        let [from, to] = [a, b].map(|node| self.nodes[node as usize]);
        let way = self.straightened(&self.dense.reach(from, Some(to)).way_to(to));
        let way = way.into_iter().map(|vertex| self.add_node(vertex)).collect::<Result<Vec<u32>, Error>>()?;
        for step in way.windows(2) {
            if !self.is_short(step[0], step[1], self.straight(step[0], step[1])) {
                self.add_edge(step[0], step[1]);
            }
        }
        Ok(())
    }

    /// The vertices of a way over the roadmap that a shorter way of straight motions needs: from each it goes on to the last
    /// that it sees. O(n^2) proofs.
    fn straightened(&self, way: &[u32]) -> Vec<u32> {
        let state = |i: usize| &self.dense.states()[way[i] as usize];
        let (mut kept, mut at) = (vec![way[0]], 0);
        while at + 1 < way.len() {
            let far = (at + 2..way.len()).rev().find(|&next| self.ground.is_way_free(state(at), state(next)));
            at = far.unwrap_or(at + 1);
            kept.push(way[at]);
        }
        kept
    }

    /// Whether the way between two nodes is at most as much longer than a distance as the detour allows.
    fn is_short(&self, a: u32, b: u32, distance: f64) -> bool {
        self.ways[a as usize][b as usize] <= self.longest(distance)
    }

    /// The longest way that is allowed for a distance.
    pub fn longest(&self, distance: f64) -> f64 {
        self.detour * distance * (1.0 + ROUNDED)
    }

    /// The straight distance of two nodes.
    pub fn straight(&self, a: u32, b: u32) -> f64 {
        let [a, b] = [a, b].map(|node| &self.dense.states()[self.nodes[node as usize] as usize]);
        self.ground.distance(a, b)
    }

    /// Whether the straight way between two nodes is proven free.
    pub fn is_free(&self, a: u32, b: u32) -> bool {
        let [a, b] = [a.min(b), a.max(b)].map(|node| &self.dense.states()[self.nodes[node as usize] as usize]);
        self.ground.is_way_free(a, b)
    }

    /// Adds an edge that is free, and shortens the ways that it shortens. O(nodes^2).
    pub fn add_edge(&mut self, a: u32, b: u32) {
        let length = self.straight(a, b);
        self.neighbours[a as usize].push((b, length));
        self.neighbours[b as usize].push((a, length));
        let (a, b) = (a as usize, b as usize);
        self.distances[a][b] = self.distances[a][b].min(length);
        self.distances[b][a] = self.distances[a][b];
        self.shorten(a, b, length);
    }

    /// Shortens the ways between all nodes that are shorter over an edge.
    pub fn shorten(&mut self, a: usize, b: usize, length: f64) {
        let [from_a, from_b] = [a, b].map(|node| self.ways[node].clone());
        for (row, (to_a, to_b)) in self.ways.iter_mut().zip(from_a.iter().zip(&from_b)) {
            // Ways that the edge does not shorten to its own ends are no shorter over it to others.
            for (near, far, beyond) in [(*to_a, *to_b, &from_b), (*to_b, *to_a, &from_a)] {
                if near + length < far {
                    for (way, rest) in row.iter_mut().zip(beyond) {
                        *way = way.min(near + length + rest);
                    }
                }
            }
        }
    }
}

/// The error for more nodes than a graph may have.
fn too_many() -> Error {
    let sentence = format!(
        "the route graph needs more than {MAX_NODES} nodes; longer legs, a larger detour and fewer samples need fewer"
    );
    Error::new(Code::TooLarge, "", sentence)
}
