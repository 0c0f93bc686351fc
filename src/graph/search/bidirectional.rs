//! Bidirectional breadth-first search, by whole levels (Pohl 1969, "Bi-directional and heuristic search in path problems").
//!
//! One search from the start and one from the goals; the one with the smaller frontier expands all of it before the other
//! may go on. When they meet, the level is finished and the shortest of the paths found is returned: until then the two sides
//! share no edge, so no path can be shorter, and the path has as few edges as that of breadth-first search.

use super::{Expansion, Goals, View, Walker};
use crate::graph::{Tree, VertexId};

/// Breadth-first search from both ends; costs and heuristic are ignored. O(v + e).
#[derive(Debug, Clone)]
pub struct Bidirectional {
    /// From the start, then from the goal.
    sides: [Side; 2],
    /// Which side expands its level.
    turn: usize,
    /// The fewest edges of a path found, and the two adjacent vertices at which its sides meet: the start's, the goal's.
    meeting: Option<(u32, [VertexId; 2])>,
}

/// One of the two searches.
#[derive(Debug, Clone)]
struct Side {
    tree: Tree,
    /// Edges from the root, for vertices reached.
    depths: Vec<u32>,
    level: Vec<VertexId>,
    /// How many of the level are expanded.
    done: usize,
    next_level: Vec<VertexId>,
}

impl Side {
    fn new(vertices: usize, roots: Goals) -> Self {
        let (mut tree, depths) = (Tree::with_room(vertices), vec![0; vertices]);
        let level: Vec<VertexId> = (roots.start.0..roots.end.0).map(VertexId).collect();
        level.iter().for_each(|&root| tree.add_root(root));
        Self { tree, depths, level, done: 0, next_level: Vec::new() }
    }
}

impl Bidirectional {
    /// A search among `vertices` vertices from `start` to any of the goals.
    pub fn new(vertices: usize, start: VertexId, goals: Goals) -> Self {
        let meeting = goals.contains(&start).then_some((0, [start, start]));
        let starts = start..VertexId(start.0 + 1);
        Self { sides: [starts, goals].map(|roots| Side::new(vertices, roots)), turn: 0, meeting }
    }

    /// Begins the next level on the side with the smaller frontier; the start's if they are equal.
    fn turn_over(&mut self) {
        let side = &mut self.sides[self.turn];
        side.level = std::mem::take(&mut side.next_level);
        side.done = 0;
        self.turn = usize::from(self.sides[1].level.len() < self.sides[0].level.len());
    }
}

impl Walker for Bidirectional {
    fn step(&mut self, view: &View) -> Expansion {
        if self.sides[self.turn].done == self.sides[self.turn].level.len() {
            if self.sides[self.turn].level.is_empty() {
                return Expansion::Nothing;
            }
            self.turn_over();
        }
        if self.meeting.is_some() && self.sides[self.turn].done == 0 {
            return Expansion::Goal;
        }
        let [ours, theirs] = match &mut self.sides {
            [a, b] if self.turn == 0 => [a, b],
            [a, b] => [b, a],
        };
        let Some(&vertex) = ours.level.get(ours.done) else { return Expansion::Nothing };
        ours.done += 1;
        let depth = ours.depths[vertex.index()];
        // The goal's side follows edges backwards.
        let neighbours = match self.turn {
            0 => view.adjacency.neighbours(vertex),
            _ => view.adjacency.predecessors(vertex),
        };
        for &next in neighbours {
            let i = next.index();
            if theirs.tree.contains(next) {
                let edges = depth + 1 + theirs.depths[i];
                if self.meeting.is_none_or(|(fewest, _)| edges < fewest) {
                    let bridge = if self.turn == 0 { [vertex, next] } else { [next, vertex] };
                    self.meeting = Some((edges, bridge));
                }
            }
            if !ours.tree.contains(next) {
                ours.tree.add(next, vertex);
                ours.depths[i] = depth + 1;
                ours.next_level.push(next);
            }
        }
        Expansion::Vertex(vertex)
    }

    fn path(&self) -> Vec<VertexId> {
        let Some((edges, [from, to])) = self.meeting else { return Vec::new() };
        let mut path = self.sides[0].tree.from_root(from);
        if edges > 0 {
            path.extend(self.sides[1].tree.to_root(to));
        }
        path
    }
}
