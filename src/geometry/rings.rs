//! Whether simple rings are the outline and the holes of a polygon: a sweep, decided exactly.
//!
//! As in [`crossing`](super::crossing), a line sweeps the plane from left to right, tilted a little, and edges are compared
//! once they become neighbours. Here rings may touch: all that meets at one point is taken together there. The edges of each
//! ring through the point must then lie on one side of those of every other. Of the edge below the first corner of a ring it is
//! known on which side the inside of its own ring is, and so which ring encloses the new one.

use super::blocks::Blocks;
use super::crossing::left_to_right;
use super::{Point, Polygon, orientation, sort_numbers};

/// The reason why rings are not the holes of a polygon. Ring 0 is the outline, ring i + 1 is hole i.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum HoleFault {
    /// These two rings cross, or share more than single points.
    Crossing(usize, usize),
    /// This ring lies outside the outline.
    Outside(usize),
    /// The first ring lies within the second, which is a hole.
    Nested(usize, usize),
}

/// The first fault of the rings, of which the first is the outline: crossings from left to right, then rings in order. O(n
/// log n) predicates.
pub(super) fn find_fault(rings: &[&Polygon]) -> Option<HoleFault> {
    let mut sweep = Sweep::new(rings);
    let mut order: Vec<u32> = (0..sweep.points.len() as u32).collect();
    sort_numbers(&mut order, &|i, j| left_to_right(sweep.points[i], sweep.points[j]).then(i.cmp(&j)));
    let mut rest = &order[..];
    while let Some(&first) = rest.first() {
        let p = sweep.points[first as usize];
        let (here, after) =
            rest.split_at(rest.partition_point(|&v| left_to_right(sweep.points[v as usize], p).is_le()));
        if let Err([i, j]) = sweep.pass(p, here) {
            return Some(HoleFault::Crossing(i.min(j) as usize, i.max(j) as usize));
        }
        rest = after;
    }
    sweep.around.iter().enumerate().skip(1).find_map(|(ring, around)| match around {
        Some(0) => None,
        Some(other) => Some(HoleFault::Nested(ring, *other as usize)),
        None => Some(HoleFault::Outside(ring)),
    })
}

/// Vertices are numbered ring by ring, and edges by the vertices that they start from.
struct Sweep {
    points: Vec<Point>,
    /// Of each vertex: its ring, and the vertices before and after it.
    ring: Vec<u32>,
    before: Vec<u32>,
    after: Vec<u32>,
    /// The edges that the line meets, from bottom to top.
    edges: Blocks,
    /// Of each ring: its leftmost vertex, and the ring that directly encloses it.
    leftmost: Vec<u32>,
    around: Vec<Option<u32>>,
}

/// Two rings that cross or share more than single points.
type Crossing = [u32; 2];

impl Sweep {
    fn new(rings: &[&Polygon]) -> Self {
        let points: Vec<Point> = rings.iter().flat_map(|ring| ring.vertices()).copied().collect();
        let [mut ring, mut before, mut after, mut leftmost] = [const { Vec::new() }; 4];
        for (number, polygon) in rings.iter().enumerate() {
            let (first, n) = (ring.len() as u32, polygon.vertices().len() as u32);
            ring.extend((0..n).map(|_| number as u32));
            before.extend((0..n).map(|i| first + (i + n - 1) % n));
            after.extend((0..n).map(|i| first + (i + 1) % n));
            let order = |&i: &u32, &j: &u32| left_to_right(points[i as usize], points[j as usize]);
            leftmost.extend((first..first + n).min_by(order));
        }
        Self { points, ring, before, after, edges: Blocks::default(), leftmost, around: vec![None; rings.len()] }
    }

    /// Moves the line over a point and the vertices there: edges that end there leave, edges that begin there enter.
    fn pass(&mut self, p: Point, vertices: &[u32]) -> Result<(), Crossing> {
        let mut at = self.edges.first_without(|e| self.side(e, p) > 0.0);
        let below = self.edges.before(at);
        let mut through = Vec::new();
        while let Some(e) = self.edges.get(at).filter(|&e| self.side(e, p) == 0.0) {
            through.push(e);
            at = self.edges.remove(at);
        }
        let above = self.edges.get(at);
        // What goes on to the right, from bottom to top.
        let at_vertices = vertices.iter().flat_map(|&v| [self.before[v as usize], v]);
        let mut right: Vec<u32> = at_vertices.filter(|&e| self.ends(e)[0] == p).collect();
        right.extend(through.iter().filter(|&&e| self.ends(e)[1] != p));
        let turn = |a: u32, b: u32| orientation(p, self.ends(a)[1], self.ends(b)[1]);
        sort_numbers(&mut right, &|a, b| 0.0_f64.total_cmp(&(turn(a as u32, b as u32) + 0.0)));
        if let Some(pair) = right.windows(2).find(|pair| turn(pair[0], pair[1]) == 0.0) {
            return Err([self.ring_of(pair[0]), self.ring_of(pair[1])]);
        }
        self.check_sides(right.iter().chain(through.iter().rev()))?;
        self.edges.insert(at, &right);
        let mut last = below;
        for &edge in &right {
            // The lower edge at the leftmost vertex of a ring is the one that leaves it.
            let ring = self.ring_of(edge) as usize;
            if self.leftmost[ring] == edge {
                self.around[ring] = last.and_then(|last| self.above(last));
            }
            last = Some(edge);
        }
        for (low, high) in [(below, right.first().copied().or(above)), (last, above)] {
            if let (Some(low), Some(high)) = (low, high)
                && self.cross(low, high)
            {
                return Err([self.ring_of(low), self.ring_of(high)]);
            }
        }
        Ok(())
    }

    /// An error if the edges at a point, in order around it, are not those of rings that only touch there: two edges of each
    /// ring, both on one side of those of any other.
    fn check_sides<'a>(&self, around: impl Iterator<Item = &'a u32>) -> Result<(), Crossing> {
        let mut open: Vec<u32> = Vec::new();
        for &edge in around {
            let ring = self.ring_of(edge);
            match open.last() {
                Some(&last) if last == ring => {
                    open.pop();
                }
                Some(&last) if open.contains(&ring) => return Err([last, ring]),
                _ => open.push(ring),
            }
        }
        Ok(())
    }

    fn ring_of(&self, edge: u32) -> u32 {
        self.ring[edge as usize]
    }

    /// The ring that directly encloses what is above an edge: that of the edge itself if it leads to the right, since rings are
    /// counter-clockwise.
    fn above(&self, edge: u32) -> Option<u32> {
        let ring = self.ring_of(edge);
        if self.ends(edge)[0] == self.points[edge as usize] { Some(ring) } else { self.around[ring as usize] }
    }

    /// The ends of an edge, left one first.
    fn ends(&self, edge: u32) -> [Point; 2] {
        let (a, b) = (self.points[edge as usize], self.points[self.after[edge as usize] as usize]);
        if left_to_right(a, b).is_le() { [a, b] } else { [b, a] }
    }

    /// Positive if the point lies above the edge, negative below, zero on its line.
    fn side(&self, edge: u32, p: Point) -> f64 {
        let [left, right] = self.ends(edge);
        orientation(left, right, p)
    }

    /// Whether two edges cross inside both. Those that touch are looked at where they do.
    fn cross(&self, i: u32, j: u32) -> bool {
        let is_between = |e: u32, other: u32| {
            let [a, b] = self.ends(other);
            let (a, b) = (self.side(e, a), self.side(e, b));
            (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)
        };
        is_between(i, j) && is_between(j, i)
    }
}
