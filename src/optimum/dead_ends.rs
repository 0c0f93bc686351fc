//! What of a navigation mesh no shortest path enters, and which parts of it no path joins.

use super::arcs::Arcs;
use super::mesh::Mesh;

/// Triangles that are not in a dead end.
const OPEN: u32 = u32::MAX;

/// The dead ends of a mesh: triangles with one way out, and those that have one way out without them.
///
/// A path that enters and leaves a triangle by the same side turns in between. If the triangle has no arc around which it may
/// turn, nor have those behind it, only paths that begin or end there enter.
pub(super) struct DeadEnds {
    /// Of each triangle of a dead end the next one on the way out; itself if there is none.
    out: Vec<u32>,
    /// The triangle that stands for all that are joined to it.
    group: Vec<u32>,
}

impl DeadEnds {
    /// Finds them. O(n) for n triangles.
    pub fn new(mesh: &Mesh, arcs: &Arcs) -> Self {
        let beyond = |triangle: u32| {
            mesh.sides(triangle).into_iter().filter_map(|side| mesh.across(side)).map(|(side, _)| side.triangle())
        };
        let mut ends = Self { out: vec![OPEN; mesh.len() as usize], group: vec![OPEN; mesh.len() as usize] };
        for first in 0..mesh.len() {
            let mut at = first;
            // On from one to the next, for which one way less is left.
            while !ends.is_closed(at) && arcs.parts_in(at).next().is_none() {
                let mut ways = beyond(at).filter(|&triangle| !ends.is_closed(triangle));
                let (way, other) = (ways.next(), ways.next());
                if other.is_some() {
                    break;
                }
                drop(ways);
                ends.out[at as usize] = way.unwrap_or(at);
                match way {
                    Some(way) => at = way,
                    None => break,
                }
            }
        }
        for first in 0..mesh.len() {
            let mut open = vec![first];
            while let Some(triangle) = open.pop() {
                if ends.group[triangle as usize] == OPEN {
                    ends.group[triangle as usize] = first;
                    open.extend(beyond(triangle));
                }
            }
        }
        ends
    }

    /// Is the triangle in a dead end?
    pub fn is_closed(&self, triangle: u32) -> bool {
        self.out[triangle as usize] != OPEN
    }

    /// May a path join the two triangles? If not, there is none.
    pub fn are_joined(&self, triangles: [u32; 2]) -> bool {
        let [a, b] = triangles.map(|triangle| self.group[triangle as usize]);
        a == b
    }

    /// The triangles of the dead end in which this one is, from there on the way out.
    pub fn out_of(&self, triangle: u32) -> impl Iterator<Item = u32> + '_ {
        let next = |triangle: &u32| {
            Some(self.out[*triangle as usize]).filter(|next| next != triangle && self.is_closed(*next))
        };
        std::iter::successors(Some(triangle).filter(|&triangle| self.is_closed(triangle)), next)
    }
}
