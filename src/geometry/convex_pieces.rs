//! Convex pieces of a simple polygon.

use super::{Point, Polygon, orientation, triangles};

/// Convex polygons that cover the polygon exactly and overlap in borders alone, with no other corners than its own: the polygon
/// itself where it is convex, else at most four times as few as there can be. Decided exactly. O(n^2), after triangulation.
///
/// Hertel and Mehlhorn 1983, "Fast triangulation of simple polygons": of a triangulation, every cut is taken out whose removal
/// leaves both its ends convex.
pub fn convex_pieces(polygon: &Polygon) -> Vec<Polygon> {
    if polygon.is_convex() {
        return vec![polygon.clone()];
    }
    let vertices = polygon.vertices();
    let mut pieces: Vec<Vec<u32>> = triangles(polygon).into_iter().map(Vec::from).collect();
    let mut at = 0;
    while at < pieces.len() {
        let merged = (at + 1..pieces.len()).find_map(|j| Some((j, merge(vertices, &pieces[at], &pieces[j])?)));
        if let Some((j, piece)) = merged {
            pieces[at] = piece;
            pieces.remove(j);
        } else {
            at += 1;
        }
    }
    pieces.iter().map(|piece| strictly_convex(vertices, piece)).collect()
}

/// Both pieces as one where they share a cut and are convex together.
fn merge(vertices: &[Point], a: &[u32], b: &[u32]) -> Option<Vec<u32>> {
    for i in 0..a.len() {
        let (from, to) = (a[i], a[(i + 1) % a.len()]);
        let Some(j) = b.iter().position(|&v| v == to) else { continue };
        if b[(j + 1) % b.len()] != from {
            continue;
        }
        // Round the first from the end of the cut to its start, on round the second and back.
        let first = (1..=a.len()).map(|k| a[(i + k) % a.len()]);
        let second = (2..b.len()).map(|k| b[(j + k) % b.len()]);
        let merged: Vec<u32> = first.chain(second).collect();
        let n = merged.len();
        let turns_left = |k: usize| {
            let [p, q, r] = [(k + n - 1) % n, k, (k + 1) % n].map(|k| vertices[merged[k] as usize]);
            orientation(p, q, r) >= 0.0
        };
        return (turns_left(0) && turns_left(a.len() - 1)).then_some(merged);
    }
    None
}

/// The piece without its corners on straight edges.
fn strictly_convex(vertices: &[Point], piece: &[u32]) -> Polygon {
    let n = piece.len();
    let at = |k: usize| vertices[piece[k % n] as usize];
    let corners = (0..n).filter(|&k| orientation(at(k + n - 1), at(k), at(k + 1)) > 0.0).map(at);
    Polygon::of_convex_piece(corners.collect())
}
