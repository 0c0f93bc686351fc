//! Rings that bound regions as they are: simple ones that do not meet. What they fill is found without a rounding.

use super::FillRule;
use crate::error::{Code, FormatError};
use planarium::geometry::{Aabb, Point, Polygon, Segment, intersects_segment_segment, orientation};

/// The most pairs of edges that are compared for one area.
const MOST_PAIRS: usize = 300_000_000;

/// The most places where the edges of one area may meet.
const MOST_MEETINGS: usize = 200_000;

/// The most rings of an area whose nesting is found by comparing all pairs.
const MOST_RINGS: usize = 10_000;

/// A polygon with holes.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    pub outline: Vec<Point>,
    pub holes: Vec<Vec<Point>>,
}

/// The ring without repeated points; `None` if it has no area.
pub fn distinct(ring: &[Point]) -> Option<Vec<Point>> {
    let mut points = ring.to_vec();
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    let [a, b, rest @ ..] = &points[..] else { return None };
    rest.iter().any(|&p| orientation(*a, *b, p) != 0.0).then_some(points)
}

/// The edges of a ring.
fn edges(ring: &[Point]) -> impl Iterator<Item = Segment> + '_ {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| Segment::new(a, b))
}

/// How often edges of rings meet anywhere but at the corner that neighbours share.
///
/// # Errors
/// `world-too-large` if that is too often to be mended
///
/// # Complexity
/// O(n log n) and the pairs of edges whose extents in x overlap.
pub fn meetings(rings: &[Vec<Point>]) -> Result<usize, FormatError> {
    struct Edge {
        segment: Segment,
        aabb: Aabb,
        ring: usize,
        number: usize,
    }
    let edge = |ring, (number, segment): (usize, Segment)| Edge { aabb: segment.aabb(), segment, ring, number };
    let mut all: Vec<Edge> = Vec::with_capacity(rings.iter().map(Vec::len).sum());
    for (i, ring) in rings.iter().enumerate() {
        all.extend(edges(ring).enumerate().map(|numbered| edge(i, numbered)));
    }
    all.sort_by(|a, b| a.aabb.min.x.total_cmp(&b.aabb.min.x));
    let are_neighbours = |a: &Edge, b: &Edge| {
        let n = rings[a.ring].len();
        a.ring == b.ring && ((a.number + 1) % n == b.number || (b.number + 1) % n == a.number)
    };
    let (mut open, mut pairs, mut count): (Vec<&Edge>, usize, usize) = (Vec::new(), 0, 0);
    for edge in &all {
        pairs += open.len();
        open.retain(|other| other.aabb.max.x >= edge.aabb.min.x);
        for other in open.iter().filter(|other| other.aabb.intersects(&edge.aabb)) {
            let meets = if are_neighbours(edge, other) {
                folds_back(&edge.segment, &other.segment)
            } else {
                intersects_segment_segment(&edge.segment, &other.segment)
            };
            count += usize::from(meets);
        }
        open.push(edge);
        if count > MOST_MEETINGS || pairs > MOST_PAIRS {
            let sentence = format!("an area of {} corners crosses itself too often to be mended", all.len());
            return Err(FormatError::new(Code::WorldTooLarge, sentence));
        }
    }
    Ok(count)
}

/// Whether two edges with a common end overlap beyond it.
fn folds_back(a: &Segment, b: &Segment) -> bool {
    let (shared, p, q) = match () {
        () if a.b == b.a => (a.b, a.a, b.b),
        () if a.a == b.b => (a.a, a.b, b.a),
        () => return true,
    };
    orientation(p, shared, q) == 0.0 && (p - shared).dot(&(q - shared)) > 0.0
}

/// The regions that rings bound that do not meet; with a frame, what they leave of it. `None` if a ring is not simple, or
/// there are too many.
///
/// # Complexity
/// O(rings² + rings × log corners).
pub fn nested(rings: &[Vec<Point>], rule: FillRule, frame: Option<Aabb>) -> Option<Vec<Region>> {
    if rings.len() > MOST_RINGS {
        return None;
    }
    let polygons: Vec<Polygon> = rings.iter().map(|ring| Polygon::new(ring).ok()).collect::<Option<_>>()?;
    let directions: Vec<i64> = rings.iter().map(|ring| direction(ring)).collect();
    let around: Vec<Vec<usize>> = (0..rings.len())
        .map(|i| (0..rings.len()).filter(|&j| j != i && polygons[j].contains(rings[i][0])).collect())
        .collect();
    let is_filled = |winding: i64| rule.fills(winding) != frame.is_some();
    // Of each ring: what is filled outside of it and inside.
    let sides: Vec<[bool; 2]> = (0..rings.len())
        .map(|i| {
            let outside: i64 = around[i].iter().map(|&j| directions[j]).sum();
            [is_filled(outside), is_filled(outside + directions[i])]
        })
        .collect();
    let mut regions: Vec<Region> = Vec::new();
    if let Some(Aabb { min, max }) = frame {
        let outline = vec![min, Point::new(max.x, min.y), max, Point::new(min.x, max.y)];
        regions.push(Region { outline, holes: Vec::new() });
    }
    let mut number = vec![0; rings.len()];
    for i in (0..rings.len()).filter(|&i| sides[i] == [false, true]) {
        number[i] = regions.len();
        regions.push(Region { outline: rings[i].clone(), holes: Vec::new() });
    }
    for i in (0..rings.len()).filter(|&i| sides[i] == [true, false]) {
        let borders = around[i].iter().copied().filter(|&j| sides[j][0] != sides[j][1]);
        let outline = borders.max_by_key(|&j| around[j].len()).map_or(0, |j| number[j]);
        regions[outline].holes.push(rings[i].clone());
    }
    Some(regions)
}

/// 1 for a simple ring that runs counter-clockwise, else -1: read exactly at its lowest, then leftmost corner.
pub fn direction(ring: &[Point]) -> i64 {
    let n = ring.len();
    let lower = |&i: &usize, &j: &usize| ring[i].y.total_cmp(&ring[j].y).then(ring[i].x.total_cmp(&ring[j].x));
    let Some(i) = (0..n).min_by(lower) else { return 1 };
    if orientation(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) > 0.0 { 1 } else { -1 }
}
