//! The dense roadmap that a route graph is measured by: free places in a low-discrepancy order, each joined to many that are
//! near.
//!
//! Halton 1960, "On the efficiency of certain quasi-random sequences of points in evaluating multi-dimensional integrals",
//! moved by a random vector (Cranley and Patterson 1976, "Randomization of number theoretic methods for multiple integration").
//! Each place is joined to the 2 e ln n nearest of those before it (Karaman and Frazzoli 2011, "Sampling-based algorithms for
//! optimal motion planning": PRM*). At last come connectors: more places, of which those are kept that join parts which are not
//! joined yet (Simeon, Laumond and Nissoux 2000, "Visibility-based probabilistic roadmaps for motion planning").

use super::RouteGraphOptions;
use super::ground::{Ground, State};
use crate::graph::{Ordered, UnionFind, VertexId};
use crate::nearest::{Index, Nearest, Neighbour, Query};
use crate::random::{Random, Stream};
use crate::sampling::radical_inverse;
use crate::space::Space;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::E;

/// The most places that are drawn for each free one that is wanted.
const DRAWS: u64 = 1000;

/// No vertex, as the predecessor of one.
const NONE: u32 = u32::MAX;

/// The dense roadmap.
pub(super) struct Dense {
    states: Vec<State>,
    neighbours: Vec<Vec<(u32, f64)>>,
    parts: UnionFind,
    index: Index,
}

/// A vertex from which others are reached.
pub(super) struct Reached {
    /// The length of the way to each vertex, in metres; infinite if there is none, or if a nearer goal has ended the search.
    pub lengths: Vec<f64>,
    before: Vec<u32>,
}

impl Reached {
    /// The vertices of the way to one that was reached, from the first on.
    pub fn way_to(&self, vertex: u32) -> Vec<u32> {
        let mut way = vec![vertex];
        let mut at = self.before[vertex as usize];
        while at != NONE {
            way.push(at);
            at = self.before[at as usize];
        }
        way.reverse();
        way
    }
}

impl Dense {
    /// The roadmap of a number of free places, and of connectors among as many more. O(n log n) nearest neighbours and proofs.
    pub fn build(ground: &Ground, options: &RouteGraphOptions) -> Self {
        let mut dense =
            Self { states: Vec::new(), neighbours: Vec::new(), parts: UnionFind::default(), index: Index::default() };
        let wanted = options.samples as usize;
        let k = libm::ceil(2.0 * E * libm::log(wanted as f64 + 1.0)) as usize;
        let mut random = Random::new(options.seed, Stream::Samples);
        let shift = [(); 2].map(|()| random.uniform());
        let (mut number, mut left) = (0, DRAWS * wanted as u64);
        let mut next = || {
            while left > 0 {
                left -= 1;
                number += 1;
                let place = halton(ground, shift, number);
                if ground.is_place_free(&place) {
                    return Some(place);
                }
            }
            None
        };
        while dense.states.len() < wanted
            && let Some(place) = next()
        {
            dense.add(ground, place, k);
        }
        for _ in 0..wanted {
            let Some(place) = next() else { break };
            dense.connect_parts(ground, place, k);
        }
        dense
    }

    /// Adds a place that is joined to those of the `k` nearest that it sees.
    fn add(&mut self, ground: &Ground, place: State, k: usize) {
        let near = self.near(ground, &place, k);
        let seen = near.into_iter().filter(|one| ground.is_way_free(&place, &self.states[one.vertex.index()]));
        let seen: Vec<Neighbour> = seen.collect();
        self.insert(ground, place, &seen);
    }

    /// Adds a place if it joins several parts of the roadmap: to the nearest vertex that it sees of each.
    fn connect_parts(&mut self, ground: &Ground, place: State, k: usize) {
        let near = self.near(ground, &place, k);
        let parts: Vec<usize> = near.iter().map(|one| self.parts.find(one.vertex.index())).collect();
        if parts.iter().all(|part| *part == parts[0]) {
            return;
        }
        let (mut seen, mut known) = (Vec::new(), Vec::new());
        for (one, part) in near.into_iter().zip(parts) {
            if !known.contains(&part) && ground.is_way_free(&place, &self.states[one.vertex.index()]) {
                known.push(part);
                seen.push(one);
            }
        }
        if seen.len() > 1 {
            self.insert(ground, place, &seen);
        }
    }

    fn near(&self, ground: &Ground, place: &State, k: usize) -> Vec<Neighbour> {
        let mut found = Vec::new();
        self.index.k_nearest(Query::to(&ground.space, &self.states, place), k, &mut found);
        found
    }

    fn insert(&mut self, ground: &Ground, place: State, seen: &[Neighbour]) {
        let vertex = self.states.len() as u32;
        self.states.push(place);
        self.neighbours.push(Vec::new());
        self.parts.add();
        self.index.insert(&ground.space, VertexId(vertex), &place);
        for one in seen {
            self.neighbours[vertex as usize].push((one.vertex.0, one.distance));
            self.neighbours[one.vertex.index()].push((vertex, one.distance));
            self.parts.join(vertex as usize, one.vertex.index());
        }
    }

    /// The places of the vertices.
    pub fn states(&self) -> &[State] {
        &self.states
    }

    /// How many others a vertex is joined to.
    pub fn degree(&self, vertex: u32) -> usize {
        self.neighbours[vertex as usize].len()
    }

    /// The shortest ways from a vertex to all others, or until a goal is reached: Dijkstra's algorithm, O(e log n) for e edges.
    pub fn reach(&self, from: u32, goal: Option<u32>) -> Reached {
        shortest_ways(&self.neighbours, from, goal)
    }
}

/// The shortest ways from a vertex of a graph, given by the neighbours of each vertex and the lengths of the ways there.
pub(super) fn shortest_ways(neighbours: &[Vec<(u32, f64)>], from: u32, goal: Option<u32>) -> Reached {
    let mut lengths = vec![f64::INFINITY; neighbours.len()];
    let mut before = vec![NONE; neighbours.len()];
    lengths[from as usize] = 0.0;
    let mut open = BinaryHeap::from([Reverse((Ordered::ZERO, from))]);
    while let Some(Reverse((length, vertex))) = open.pop() {
        let length = length.value();
        if goal == Some(vertex) {
            break;
        }
        if length > lengths[vertex as usize] {
            continue;
        }
        for &(next, way) in &neighbours[vertex as usize] {
            if length + way < lengths[next as usize] {
                lengths[next as usize] = length + way;
                before[next as usize] = vertex;
                open.push(Reverse((Ordered::new(length + way), next)));
            }
        }
    }
    Reached { lengths, before }
}

/// The place of this number in the sequence, within the bounds.
fn halton(ground: &Ground, shift: [f64; 2], number: u64) -> State {
    let bounds = ground.bounds();
    let at = |axis: usize, base: u64| {
        let part = radical_inverse(base, number) + shift[axis];
        let part = if part < 1.0 { part } else { part - 1.0 };
        bounds.min[axis] + part * (bounds.max[axis] - bounds.min[axis])
    };
    ground.space.state(&[at(0, 2), at(1, 3)])
}
