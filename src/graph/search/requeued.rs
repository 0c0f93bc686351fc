//! The bidirectional breadth-first search of a course report with its fault, to show what that costs.
//!
//! A vertex counts as explored once it is expanded, not once it is queued. So it is queued again for every edge that leads to it
//! meanwhile, and one that was explored is expanded again: more vertices are visited than there are. The search ends at the first
//! vertex that the other side has explored, so the path may have an edge more than the fewest.

use super::{Expansion, Goals, View, Walker};
use crate::graph::VertexId;

/// The most entries of the queues; the copies of a vertex may double with every level.
const MOST_ENTRIES: usize = 4_000_000;

/// Breadth-first search from both ends, a vertex of each in turn; costs and heuristic are ignored. It gives up after four million
/// entries of its queues.
#[derive(Debug, Clone)]
pub struct Requeued {
    /// From the start, then from the goal.
    sides: [Side; 2],
    /// Which side expands a vertex.
    turn: usize,
    path: Vec<VertexId>,
}

/// One of the two searches.
#[derive(Debug, Clone)]
struct Side {
    /// Every entry, with that which queued it, in this order; those before `next` are expanded. A root is its own parent.
    queue: Vec<(VertexId, u32)>,
    next: usize,
    explored: Vec<bool>,
}

impl Side {
    fn new(vertices: usize, roots: Goals) -> Self {
        let mut explored = vec![false; vertices];
        let roots = (roots.start.0..roots.end.0).map(VertexId);
        roots.clone().for_each(|root| explored[root.index()] = true);
        Self { queue: roots.enumerate().map(|(i, root)| (root, i as u32)).collect(), next: 0, explored }
    }

    /// The vertices from that of an entry to the root.
    fn to_root(&self, mut entry: usize) -> Vec<VertexId> {
        let mut path = vec![self.queue[entry].0];
        while self.queue[entry].1 as usize != entry {
            entry = self.queue[entry].1 as usize;
            path.push(self.queue[entry].0);
        }
        path
    }

    /// The first entry of a vertex that was explored: of those that wait, else of all.
    fn entry(&self, vertex: VertexId) -> usize {
        let is_it = |&(other, _): &(VertexId, u32)| other == vertex;
        let waiting = self.queue[self.next..].iter().position(is_it).map(|at| self.next + at);
        waiting.or_else(|| self.queue.iter().position(is_it)).expect("an explored vertex was queued")
    }
}

impl Requeued {
    /// A search among `vertices` vertices from `start` to any of the goals.
    pub fn new(vertices: usize, start: VertexId, goals: Goals) -> Self {
        let starts = start..VertexId(start.0 + 1);
        Self { sides: [starts, goals].map(|roots| Side::new(vertices, roots)), turn: 0, path: Vec::new() }
    }

    fn is_full(&self) -> bool {
        self.sides.iter().map(|side| side.queue.len()).sum::<usize>() > MOST_ENTRIES
    }
}

impl Walker for Requeued {
    fn step(&mut self, view: &View) -> Expansion {
        let is_full = self.is_full();
        let (turn, [first, second]) = (self.turn, &mut self.sides);
        let (ours, theirs) = if turn == 0 { (first, second) } else { (second, first) };
        if is_full || [&ours, &theirs].iter().any(|side| side.next == side.queue.len()) {
            return Expansion::Nothing;
        }
        let (entry, (vertex, _)) = (ours.next, ours.queue[ours.next]);
        ours.explored[vertex.index()] = true;
        if theirs.explored[vertex.index()] {
            let mut halves = [ours.to_root(entry), theirs.to_root(theirs.entry(vertex))];
            if turn == 1 {
                halves.reverse();
            }
            let [to_start, to_goal] = halves;
            self.path = to_start.into_iter().rev().chain(to_goal.into_iter().skip(1)).collect();
            return Expansion::Goal;
        }
        ours.next += 1;
        let neighbours = match turn {
            0 => view.adjacency.neighbours(vertex),
            _ => view.adjacency.predecessors(vertex),
        };
        let new = neighbours.iter().filter(|next| !ours.explored[next.index()]).map(|&next| (next, entry as u32));
        ours.queue.extend(new);
        self.turn = 1 - turn;
        Expansion::Vertex(vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        self.path.clone()
    }

    /// It gives up where its queues have grown too long.
    fn is_exhaustive(&self) -> bool {
        !self.is_full()
    }
}
