//! Which vertices of a directed graph can reach each other (Tarjan 1972, "Depth-first search and linear graph algorithms").

use super::{Adjacency, VertexId};

/// A vertex that no search has come to yet.
const UNSEEN: u32 = u32::MAX;

/// For every vertex the number of its strong component: two vertices have the same where each can be reached from the other.
/// Components are numbered from 0 in the order of their lowest vertices. O(vertices + edges), without recursion.
pub fn strong_components(adjacency: &Adjacency) -> Vec<u32> {
    let n = adjacency.vertices();
    let mut components =
        Tarjan { order: vec![UNSEEN; n], low: vec![0; n], roots: vec![UNSEEN; n], open: Vec::new(), seen: 0 };
    for vertex in 0..n as u32 {
        if components.order[vertex as usize] == UNSEEN {
            components.search(adjacency, vertex);
        }
    }
    // The vertices of a component name one of them; the first to name it gives it its number.
    let mut numbers = vec![UNSEEN; n];
    let mut count = 0;
    let number = |root: u32| {
        let number = &mut numbers[root as usize];
        if *number == UNSEEN {
            *number = count;
            count += 1;
        }
        *number
    };
    components.roots.into_iter().map(number).collect()
}

/// The search at work.
struct Tarjan {
    /// When each vertex was seen.
    order: Vec<u32>,
    /// The earliest that is known to be reached from each among the open ones.
    low: Vec<u32>,
    /// Of vertices whose component is complete, its first vertex.
    roots: Vec<u32>,
    /// Vertices whose component is not complete, in the order in which they were seen.
    open: Vec<u32>,
    seen: u32,
}

impl Tarjan {
    fn enter(&mut self, vertex: u32) {
        (self.order[vertex as usize], self.low[vertex as usize]) = (self.seen, self.seen);
        self.seen += 1;
        self.open.push(vertex);
    }

    /// Sees all that can be reached from a vertex and completes its components.
    fn search(&mut self, adjacency: &Adjacency, from: u32) {
        self.enter(from);
        // The way down: each vertex and how many of its neighbours are done.
        let mut way = vec![(from, 0)];
        while let Some((vertex, done)) = way.last_mut() {
            let at = *vertex as usize;
            if let Some(&VertexId(next)) = adjacency.neighbours(VertexId(*vertex)).get(*done) {
                *done += 1;
                if self.order[next as usize] == UNSEEN {
                    self.enter(next);
                    way.push((next, 0));
                } else if self.roots[next as usize] == UNSEEN {
                    self.low[at] = self.low[at].min(self.order[next as usize]);
                }
                continue;
            }
            let root = *vertex;
            way.pop();
            if let Some(&(parent, _)) = way.last() {
                self.low[parent as usize] = self.low[parent as usize].min(self.low[at]);
            }
            if self.low[at] == self.order[at] {
                while let Some(vertex) = self.open.pop() {
                    self.roots[vertex as usize] = root;
                    if vertex == root {
                        break;
                    }
                }
            }
        }
    }
}
