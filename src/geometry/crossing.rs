//! Whether the edges of a closed chain meet anywhere but at common corners: a sweep, decided exactly.
//!
//! Shamos and Hoey 1976, "Geometric intersection problems": a line sweeps the plane from left to right; the edges that it
//! meets are stored in order from bottom to top, and two edges are compared once they become neighbours. Corners on one
//! vertical line are swept from bottom to top, which is the same as to tilt the line a little; so vertical edges need no
//! care. Every decision is an orientation of given points, so all are exact.

use super::blocks::Blocks;
use super::{Point, Segment, intersects_segment_segment, orientation, sort_numbers};
use std::cmp::Ordering;

/// A pair of edges, by their first vertices, that touch, cross or overlap beyond a common corner; `None` if the chain
/// bounds a simple polygon. Neighbouring vertices must differ, and not all may lie on one line. O(n log n) predicates.
pub(super) fn find_crossing(vertices: &[Point]) -> Option<(usize, usize)> {
    let n = vertices.len();
    if let Some(corner) = (0..n).find(|&i| folds_back(vertices, i)) {
        return Some(in_order((corner + n - 1) % n, corner));
    }
    let mut sweep = Sweep { vertices, edges: Blocks::default() };
    let mut order: Vec<u32> = (0..n as u32).collect();
    sort_numbers(&mut order, &|i, j| left_to_right(vertices[i], vertices[j]).then(i.cmp(&j)));
    let mut before = None;
    for vertex in order {
        let same = before.filter(|&before: &u32| vertices[before as usize] == vertices[vertex as usize]);
        if let Some((i, j)) = same.map(|before| (before, vertex)).or_else(|| sweep.pass(vertex)) {
            return Some(in_order(i as usize, j as usize));
        }
        before = Some(vertex);
    }
    None
}

/// The order in which the sweep meets points.
pub(super) fn left_to_right(p: Point, q: Point) -> Ordering {
    p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
}

fn in_order(i: usize, j: usize) -> (usize, usize) {
    (i.min(j), i.max(j))
}

/// Whether the two edges at a corner overlap beyond it.
fn folds_back(vertices: &[Point], corner: usize) -> bool {
    let n = vertices.len();
    let (before, at, after) = (vertices[(corner + n - 1) % n], vertices[corner], vertices[(corner + 1) % n]);
    // On one line the corner lies between its neighbours, or both lie on the same side of it.
    orientation(before, at, after) == 0.0 && left_to_right(before, at) == left_to_right(after, at)
}

/// The edges that the sweeping line meets, from bottom to top.
struct Sweep<'a> {
    vertices: &'a [Point],
    edges: Blocks,
}

impl Sweep<'_> {
    /// Moves the line over a vertex: edges that end there leave, edges that begin there enter. Returns a pair that
    /// meets, if one is found.
    fn pass(&mut self, vertex: u32) -> Option<(u32, u32)> {
        let (n, p) = (self.vertices.len() as u32, self.vertices[vertex as usize]);
        let at_vertex = [(vertex + n - 1) % n, vertex];
        let mut at = self.edges.first_without(|e| self.side(e, p) > 0.0);
        let below = self.edges.before(at);
        while let Some(e) = self.edges.get(at).filter(|&e| self.side(e, p) == 0.0) {
            if !at_vertex.contains(&e) {
                return Some((e, vertex));
            }
            at = self.edges.remove(at);
        }
        let above = self.edges.get(at);
        let mut begin: Vec<u32> = at_vertex.into_iter().filter(|&e| self.ends(e).0 == p).collect();
        if begin.len() == 2 && orientation(p, self.ends(begin[0]).1, self.ends(begin[1]).1) < 0.0 {
            begin.swap(0, 1);
        }
        self.edges.insert(at, &begin);
        let neighbours = match begin[..] {
            [] => [(below, above), (None, None)],
            [first, ..] => [(below, Some(first)), (begin.last().copied(), above)],
        };
        neighbours.into_iter().find_map(|(low, high)| {
            let (low, high) = (low?, high?);
            self.meet(low, high).then_some((low, high))
        })
    }

    /// The ends of an edge, left one first.
    fn ends(&self, edge: u32) -> (Point, Point) {
        let (a, b) = (self.vertices[edge as usize], self.vertices[(edge as usize + 1) % self.vertices.len()]);
        if left_to_right(a, b).is_le() { (a, b) } else { (b, a) }
    }

    /// Positive if the point lies above the edge, negative below, zero on its line.
    fn side(&self, edge: u32, p: Point) -> f64 {
        let (left, right) = self.ends(edge);
        orientation(left, right, p)
    }

    /// Whether two edges meet beyond a common corner. Those with a common corner do not, since no corner folds back.
    fn meet(&self, i: u32, j: u32) -> bool {
        let n = self.vertices.len() as u32;
        let segment = |e| {
            let (a, b) = self.ends(e);
            Segment::new(a, b)
        };
        (i + 1) % n != j && (j + 1) % n != i && intersects_segment_segment(&segment(i), &segment(j))
    }
}
