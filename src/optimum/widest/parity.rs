//! On which side of the segment from start to goal a curve passes: crossings modulo 2.

use crate::geometry::{Point, orientation};

/// The segment from the start to the goal, whose crossings are counted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    pub start: Point,
    pub goal: Point,
}

impl Way {
    /// Whether the segment from `p` to `q` crosses the way. Exact, and half-open: a point on the line through start and goal
    /// counts as on its left, so that the crossings of a chain of segments are those of a curve. The ends of the way must not be
    /// on the segment.
    pub fn is_crossed(&self, p: Point, q: Point) -> bool {
        let is_left = |x: Point| orientation(self.start, self.goal, x) >= 0.0;
        is_left(p) != is_left(q) && (orientation(p, q, self.start) > 0.0) != (orientation(p, q, self.goal) > 0.0)
    }
}

/// Connected places, and the parity of the crossings on the way from one to another: disjoint sets (Galler and Fischer 1964, "An
/// improved equivalence algorithm"), merged by size, in which each member has its parity to a parent.
#[derive(Debug)]
pub(super) struct Parities {
    parents: Vec<u32>,
    sizes: Vec<u32>,
    /// Whether the way to the parent crosses an odd number of times.
    odd: Vec<bool>,
}

impl Parities {
    /// This many places, of which none are connected.
    pub fn new(count: usize) -> Self {
        Self { parents: (0..count as u32).collect(), sizes: vec![1; count], odd: vec![false; count] }
    }

    /// The representative of a set, and the parity of the way to it. Nearly constant time.
    fn find(&mut self, i: u32) -> (u32, bool) {
        let (mut at, mut is_odd) = (i as usize, false);
        while self.parents[at] as usize != at {
            let parent = self.parents[at] as usize;
            // Past the parent, to its own: the root is its own parent, by an even way.
            self.odd[at] ^= self.odd[parent];
            self.parents[at] = self.parents[parent];
            is_odd ^= self.odd[at];
            at = self.parents[at] as usize;
        }
        (at as u32, is_odd)
    }

    /// Connects two places by a way of this parity; false if it closes a curve that crosses an odd number of times.
    pub fn join(&mut self, [a, b]: [u32; 2], is_odd: bool) -> bool {
        let ((a, odd_a), (b, odd_b)) = (self.find(a), self.find(b));
        let is_odd = is_odd ^ odd_a ^ odd_b;
        if a == b {
            return !is_odd;
        }
        let (small, large) = if self.sizes[a as usize] < self.sizes[b as usize] { (a, b) } else { (b, a) };
        self.parents[small as usize] = large;
        self.odd[small as usize] = is_odd;
        self.sizes[large as usize] += self.sizes[small as usize];
        true
    }
}
