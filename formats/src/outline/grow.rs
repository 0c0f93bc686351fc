//! Rings of curves grown to polygons that contain what the curves bound: where the inside is on the side of the chord,
//! the chord gives way to the hull of the control points.

use super::curve::hull;
use crate::vector::{FillRule, direction};
use planarium::geometry::{Point, Polygon, Segment, intersects_segment_segment, orientation};

/// The most rings of an area whose sides are found by comparing all pairs.
const MAX_RINGS: usize = 2_000;

/// The most pairs of edges that are compared.
const MAX_PAIRS: usize = 100_000_000;

/// A path as chords.
#[derive(Debug, Clone, Default)]
pub struct Flat {
    pub points: Vec<Point>,
    /// The control points between each point and the next; none for lines.
    pub inner: Vec<Vec<Point>>,
    /// The farthest that a curve is from its chords.
    pub error: f64,
}

/// A chord of a ring, and the hull of its curve, counter-clockwise; none if it is a line.
struct Piece {
    from: Point,
    to: Point,
    hull: Vec<Point>,
}

/// The rings of an area that contains the one that the paths fill. `None` if their sides are not clear: the hulls of
/// curves meet each other or other lines, so that the curves may cross where the chords do not.
pub fn grown(flats: &[Flat], rule: FillRule) -> Option<Vec<Vec<Point>>> {
    let all: Vec<Vec<Piece>> = flats.iter().map(pieces).collect();
    let chords: Vec<Vec<Point>> = all.iter().map(|ring| ring.iter().map(|piece| piece.from).collect()).collect();
    if flats.len() > MAX_RINGS || !are_apart(&all) {
        return None;
    }
    let polygons: Vec<Polygon> = chords.iter().map(|ring| Polygon::new(ring).ok()).collect::<Option<_>>()?;
    let directions: Vec<i64> = chords.iter().map(|ring| direction(ring)).collect();
    let side = |i: usize| {
        let p = chords[i][0];
        let encloses = |&j: &usize| j != i && polygons[j].contains(p);
        let outside: i64 = (0..all.len()).filter(encloses).map(|j| directions[j]).sum();
        match [rule.fills(outside), rule.fills(outside + directions[i])] {
            [false, true] => replaced(&all[i], directions[i] > 0),
            [true, false] => replaced(&all[i], directions[i] < 0),
            // Both sides are filled, or none.
            _ => Some(chords[i].clone()),
        }
    };
    (0..all.len()).map(side).collect()
}

/// The pieces of a ring that have a length or a hull.
fn pieces(flat: &Flat) -> Vec<Piece> {
    let mut pieces = Vec::with_capacity(flat.points.len());
    let ends = flat.points.iter().zip(flat.points.iter().cycle().skip(1));
    for (i, (&from, &to)) in ends.enumerate() {
        let inner = flat.inner.get(i).map_or(&[][..], Vec::as_slice);
        let hull = hull(&mut [inner, &[from, to]].concat());
        if from != to || !hull.is_empty() {
            pieces.push(Piece { from, to, hull });
        }
    }
    pieces
}

/// Whether pieces meet at the ends that neighbours share only.
///
/// # Complexity
/// O(n log n) and the pairs of edges whose extents in x overlap.
fn are_apart(rings: &[Vec<Piece>]) -> bool {
    struct Edge {
        segment: Segment,
        low: f64,
        high: f64,
        ring: usize,
        number: usize,
    }
    let mut edges = Vec::new();
    for (ring, pieces) in rings.iter().enumerate() {
        for (number, piece) in pieces.iter().enumerate() {
            let next = &pieces[(number + 1) % pieces.len()];
            // What goes on within a hull may cross the curve.
            if pieces.len() < 2 || enters(&piece.hull, next, piece.to) || enters(&next.hull, piece, piece.to) {
                return false;
            }
            let corners = if piece.hull.is_empty() { &[piece.from, piece.to][..] } else { &piece.hull };
            let closing = corners.len() > 2;
            for (i, &a) in corners.iter().enumerate().take(if closing { corners.len() } else { 1 }) {
                let b = corners[(i + 1) % corners.len()];
                let segment = Segment::new(a, b);
                edges.push(Edge { segment, low: a.x.min(b.x), high: a.x.max(b.x), ring, number });
            }
        }
    }
    edges.sort_by(|a, b| a.low.total_cmp(&b.low));
    let (mut open, mut pairs): (Vec<&Edge>, usize) = (Vec::new(), 0);
    for edge in &edges {
        pairs += open.len();
        if pairs > MAX_PAIRS {
            return false;
        }
        open.retain(|other| other.high >= edge.low);
        let meets = open.iter().any(|other| {
            if (edge.ring, edge.number) == (other.ring, other.number) {
                return false;
            }
            let count = rings[edge.ring].len();
            let follows = |a: usize, b: usize| (a + 1) % count == b;
            let (a, b) = (edge.number, other.number);
            let shared = match edge.ring == other.ring {
                true if follows(a, b) && touches(&edge.segment, &other.segment, rings[edge.ring][a].to) => true,
                true => follows(b, a) && touches(&edge.segment, &other.segment, rings[edge.ring][b].to),
                false => false,
            };
            !shared && intersects_segment_segment(&edge.segment, &other.segment)
        });
        if meets {
            return false;
        }
        open.push(edge);
    }
    true
}

/// Whether two edges have this end and nothing else in common.
fn touches(s: &Segment, t: &Segment, end: Point) -> bool {
    let other = |segment: &Segment| match () {
        () if segment.a == end => Some(segment.b),
        () if segment.b == end => Some(segment.a),
        () => None,
    };
    let (Some(p), Some(q)) = (other(s), other(t)) else { return false };
    orientation(p, end, q) != 0.0 || (p - end).dot(&(q - end)) < 0.0
}

/// Whether a piece has points within a hull, other than the end that they share.
fn enters(hull: &[Point], piece: &Piece, shared: Point) -> bool {
    let is_inside = |p: Point| {
        let next = hull.iter().cycle().skip(1);
        !hull.is_empty() && hull.iter().zip(next).all(|(&a, &b)| orientation(a, b, p) > 0.0)
    };
    piece.hull.iter().chain([&piece.from, &piece.to]).any(|&p| p != shared && is_inside(p))
}

/// The ring with the right or the left half of each hull instead of the chord.
fn replaced(ring: &[Piece], right: bool) -> Option<Vec<Point>> {
    let mut points = Vec::with_capacity(ring.len());
    for Piece { from, to, hull } in ring {
        points.push(*from);
        if hull.is_empty() {
            continue;
        }
        let place = |p: &Point| hull.iter().position(|other| other == p);
        let (n, start, end) = (hull.len(), place(from)?, place(to)?);
        let step = if right { 1 } else { n - 1 };
        let mut at = (start + step) % n;
        while at != end {
            points.push(hull[at]);
            at = (at + step) % n;
        }
    }
    Some(points)
}
