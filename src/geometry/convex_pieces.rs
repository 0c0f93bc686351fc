//! Convex pieces of a simple polygon.

use super::{Point, Polygon, orientation, sort_numbers, triangles};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Convex polygons that cover the polygon exactly and overlap in borders alone, with no other corners than its own: the
/// polygon itself if it is convex, else at most four times as few as there can be. Decided exactly. O(n log n), after
/// triangulation.
///
/// Hertel and Mehlhorn 1983, "Fast triangulation of simple polygons": of a triangulation, every cut is removed whose removal
/// leaves both its ends convex. Pieces absorb triangles one after the other, each the first that it can: one that it cannot
/// absorb once it never can, since its angles only grow.
pub fn convex_pieces(polygon: &Polygon) -> Vec<Polygon> {
    if polygon.is_convex() {
        return vec![polygon.clone()];
    }
    let cuts = Cuts::new(triangles(polygon), polygon.vertices().len());
    let mut is_taken = vec![false; cuts.triangles.len()];
    let mut pieces = Vec::new();
    for first in 0..cuts.triangles.len() {
        if !is_taken[first] {
            let piece = grown(polygon.vertices(), &cuts, first, &mut is_taken);
            pieces.push(strictly_convex(polygon.vertices(), &piece));
        }
    }
    pieces
}

/// The same, cut further until no piece has more than `most` corners: at least 3. O(n log n).
///
/// A piece with more is cut by chords into pieces along its border, and what is left in the middle likewise.
pub fn small_convex_pieces(polygon: &Polygon, most: usize) -> Vec<Polygon> {
    let mut pieces = Vec::new();
    for piece in convex_pieces(polygon) {
        if piece.vertices().len() <= most {
            pieces.push(piece);
            continue;
        }
        let corners: Vec<u32> = (0..piece.vertices().len() as u32).collect();
        let mut left = strictly_convex(piece.vertices(), &corners).vertices().to_vec();
        while left.len() > most {
            let (n, mut kept) = (left.len(), Vec::new());
            for first in (0..n).step_by(most - 1) {
                let end = (first + most - 1).min(n);
                let along: Vec<Point> = (first..=end).map(|i| left[i % n]).collect();
                kept.push(left[first]);
                if along.len() > 2 {
                    pieces.push(Polygon::of(along, true));
                }
            }
            left = kept;
        }
        if left.len() > 2 {
            pieces.push(Polygon::of(left, true));
        }
    }
    pieces
}

/// Triangles and their sides, numbered from 3 times the triangle on.
struct Cuts {
    triangles: Vec<[u32; 3]>,
    /// The sides by the vertices that they lead from, and of these by the vertices that they lead to.
    order: Vec<u32>,
    /// Where in this order the sides from each vertex begin, and at last its length.
    starts: Vec<u32>,
}

impl Cuts {
    /// O(n) for n vertices, but for the order of the sides from one vertex.
    fn new(triangles: Vec<[u32; 3]>, vertices: usize) -> Self {
        let mut starts = vec![0; vertices + 1];
        triangles.as_flattened().iter().for_each(|&from| starts[from as usize + 1] += 1);
        (0..vertices).for_each(|v| starts[v + 1] += starts[v]);
        let mut order = vec![0; 3 * triangles.len()];
        let mut next = starts.clone();
        for (number, &from) in triangles.as_flattened().iter().enumerate() {
            let at = &mut next[from as usize];
            order[*at as usize] = number as u32;
            *at += 1;
        }
        let cuts = Self { triangles, order: Vec::new(), starts };
        for ends in cuts.starts.windows(2) {
            let from_one = &mut order[ends[0] as usize..ends[1] as usize];
            sort_numbers(from_one, &|a, b| cuts.leads_to(a as u32).cmp(&cuts.leads_to(b as u32)));
        }
        Self { order, ..cuts }
    }

    /// The vertex that a side leads to, the triangle on its left.
    fn leads_to(&self, number: u32) -> u32 {
        let (triangle, from) = (&self.triangles[number as usize / 3], number as usize % 3);
        triangle[(from + 1) % 3]
    }

    /// The triangle on the right of the side.
    fn across(&self, from: u32, to: u32) -> Option<u32> {
        let [first, end] = [to, to + 1].map(|v| self.starts[v as usize] as usize);
        let sides = &self.order[first..end];
        let at = sides.partition_point(|&number| self.leads_to(number) < from);
        sides.get(at).filter(|&&number| self.leads_to(number) == from).map(|number| number / 3)
    }
}

/// The piece that the triangle grows to by absorbing later ones.
fn grown(vertices: &[Point], cuts: &Cuts, first: usize, is_taken: &mut [bool]) -> Vec<u32> {
    // A ring of corners, in the order in which they were added: the vertex, the corner before and the corner after.
    let mut ring: Vec<(u32, usize, usize)> =
        cuts.triangles[first].into_iter().zip([(2, 1), (0, 2), (1, 0)]).map(|(v, (p, n))| (v, p, n)).collect();
    let mut start = 0;
    // Triangles across a side, and the corner that the side starts from.
    let mut open = BinaryHeap::new();
    let turns_left = |a: u32, b: u32, c: u32| {
        let [a, b, c] = [a, b, c].map(|v| vertices[v as usize]);
        orientation(a, b, c) >= 0.0
    };
    let offer = |open: &mut BinaryHeap<Reverse<(u32, usize)>>, ring: &[(u32, usize, usize)], at: usize| {
        let (from, _, next) = ring[at];
        open.extend(cuts.across(from, ring[next].0).filter(|&other| other as usize > first).map(|t| Reverse((t, at))));
    };
    (0..3).for_each(|at| offer(&mut open, &ring, at));
    while let Some(Reverse((triangle, at))) = open.pop() {
        let (from, before, next) = ring[at];
        let (to, _, after) = ring[next];
        let Some(tip) = cuts.triangles[triangle as usize].into_iter().find(|&v| v != from && v != to) else { continue };
        if is_taken[triangle as usize] || !turns_left(ring[before].0, from, tip) || !turns_left(tip, to, ring[after].0)
        {
            continue;
        }
        is_taken[triangle as usize] = true;
        let new = ring.len();
        ring.push((tip, at, next));
        (ring[at].2, ring[next].1) = (new, new);
        start = next;
        [at, new].into_iter().for_each(|at| offer(&mut open, &ring, at));
    }
    std::iter::successors(Some(start), |&at| Some(ring[at].2)).take(ring.len()).map(|at| ring[at].0).collect()
}

/// The piece without its corners on straight edges.
fn strictly_convex(vertices: &[Point], piece: &[u32]) -> Polygon {
    let n = piece.len();
    let at = |k: usize| vertices[piece[k % n] as usize];
    let corners = (0..n).filter(|&k| orientation(at(k + n - 1), at(k), at(k + 1)) > 0.0).map(at);
    Polygon::of(corners.collect(), true)
}
