//! Which nodes see which places: guards, as visibility PRM chooses them, and what is left covered if a node is removed.
//!
//! Simeon, Laumond and Nissoux 2000, "Visibility-based probabilistic roadmaps for motion planning".

use super::dense::Dense;
use super::ground::{Ground, State};
use crate::geometry::sort_stably;

/// Vertices of the roadmap that together see all others by a straight way no longer than a leg. Vertices with many neighbours
/// come first: what is around them is open. O(n g) distances for g guards, and some proofs for each vertex.
pub(super) fn guards(ground: &Ground, dense: &Dense, leg: f64) -> Vec<u32> {
    let mut order: Vec<u32> = (0..dense.states().len() as u32).collect();
    sort_stably(&mut order, |a, b| dense.degree(*b).cmp(&dense.degree(*a)));
    let (mut guards, mut places): (Vec<u32>, Vec<State>) = (Vec::new(), Vec::new());
    for vertex in order {
        let place = dense.states()[vertex as usize];
        if nearest_seen(ground, &places, &place, leg).is_none() {
            guards.push(vertex);
            places.push(place);
        }
    }
    guards
}

/// The nearest of some places that is seen from one by a straight way no longer than a leg: its number. O(places), and a proof
/// for each that is nearer.
pub(super) fn nearest_seen(ground: &Ground, places: &[State], from: &State, leg: f64) -> Option<usize> {
    let distances = places.iter().map(|place| ground.distance(from, place)).enumerate();
    let mut near: Vec<(usize, f64)> = distances.filter(|(_, distance)| *distance <= leg).collect();
    sort_stably(&mut near, |a, b| a.1.total_cmp(&b.1));
    near.into_iter().map(|(i, _)| i).find(|&i| ground.is_way_free(from, &places[i]))
}

/// The vertices of the roadmap that each node sees.
pub(super) struct Cover {
    seen: Vec<Vec<u32>>,
    /// How many nodes see each vertex.
    counts: Vec<u32>,
}

impl Cover {
    /// What nodes, given as vertices of the roadmap, see within a leg. O(nodes n) distances, and a proof for each pair within a
    /// leg.
    pub fn new(ground: &Ground, dense: &Dense, nodes: &[u32], leg: f64) -> Self {
        let states = dense.states();
        let sees = |node: u32, vertex: u32| {
            let [a, b] = [node, vertex].map(|i| &states[i as usize]);
            node == vertex || (ground.distance(a, b) <= leg && ground.is_way_free(a, b))
        };
        let all = 0..states.len() as u32;
        let seen: Vec<Vec<u32>> =
            nodes.iter().map(|&node| all.clone().filter(|&vertex| sees(node, vertex)).collect()).collect();
        let mut counts = vec![0; states.len()];
        for &vertex in seen.iter().flatten() {
            counts[vertex as usize] += 1;
        }
        Self { seen, counts }
    }

    /// Whether other nodes see all that a node sees.
    pub fn is_needless(&self, node: usize) -> bool {
        self.seen[node].iter().all(|&vertex| self.counts[vertex as usize] > 1)
    }

    /// Removes a node.
    pub fn remove(&mut self, node: usize) {
        for vertex in self.seen[node].drain(..) {
            self.counts[vertex as usize] -= 1;
        }
    }
}
