//! Triangulation of a simple polygon by ear clipping.

use super::{Aabb, Point, Polygon, orientation, select_number};

/// Triangles between vertices of the polygon that cover it without overlap: three indices each, counter-clockwise, two fewer
/// than there are vertices, none flat. Decided exactly.
///
/// An ear is a corner whose triangle with its neighbours lies in the polygon and contains no further vertex; every simple
/// polygon of more than three vertices has two (Meisters 1975, "Polygons have ears"). Corners on straight edges are no
/// ears but are vertices like any other, so that a cut never passes through one.
///
/// # Complexity
/// At most 3 n corners are tested, each against a tree of the n vertices: O(n log n) while few boxes of the tree meet the
/// triangle of a corner, O(n^2) box tests at worst.
pub fn triangles(polygon: &Polygon) -> Vec<[u32; 3]> {
    let vertices = polygon.vertices();
    let n = vertices.len() as u32;
    // The neighbours of each vertex among those that are left.
    let mut before: Vec<u32> = (0..n).map(|i| (i + n - 1) % n).collect();
    let mut after: Vec<u32> = (0..n).map(|i| (i + 1) % n).collect();
    let corner = |before: &[u32], after: &[u32], i: u32| [before[i as usize], i, after[i as usize]];
    let is_convex = |ear: [u32; 3]| {
        let [a, b, c] = ear.map(|v| vertices[v as usize]);
        orientation(a, b, c) > 0.0
    };
    // If a triangle at a corner contains vertices, the farthest of them from its base sees a half-plane of the inside: it is not
    // convex. Corners only become more convex as ears are cut off, and what is cut off lies in no later ear. So it is enough
    // to check the vertices that are not convex at the beginning.
    let concave = Tree::new((0..n).filter(|&i| !is_convex(corner(&before, &after, i))).map(|i| vertices[i as usize]));
    // Corners that may be ears. A corner that is not an ear cannot become one until a neighbour is cut off.
    let mut candidates = Candidates::all(n);
    let mut triangles = Vec::with_capacity(vertices.len() - 2);
    let mut at = 0;
    while triangles.len() + 3 < vertices.len() {
        // Continuing after the last ear, instead of at the start, avoids a fan of slivers.
        let tip = candidates.take_from(at).or_else(|| candidates.take_from(0)).expect("a simple polygon has ears");
        let ear @ [a, _, c] = corner(&before, &after, tip);
        if is_convex(ear) && !concave.meets(ear.map(|v| vertices[v as usize])) {
            triangles.push(ear);
            (after[a as usize], before[c as usize]) = (c, a);
            candidates.add(a);
            candidates.add(c);
            at = after[c as usize];
        }
    }
    let mut last = corner(&before, &after, at);
    last.sort_unstable();
    triangles.push(last);
    triangles
}

/// A set of numbers: a bit for each, on the next level one for each word that is not zero, and so on up to one word.
struct Candidates(Vec<Vec<u64>>);

impl Candidates {
    /// The numbers below `n`.
    fn all(n: u32) -> Self {
        let mut levels = Vec::new();
        let mut count = n as usize;
        loop {
            let mut words = vec![u64::MAX; count.div_ceil(64)];
            if let Some(last) = words.last_mut().filter(|_| !count.is_multiple_of(64)) {
                *last = (1 << (count % 64)) - 1;
            }
            count = words.len();
            levels.push(words);
            if count <= 1 {
                return Self(levels);
            }
        }
    }

    fn add(&mut self, number: u32) {
        let mut at = number as usize;
        for words in &mut self.0 {
            words[at / 64] |= 1 << (at % 64);
            at /= 64;
        }
    }

    /// Takes the first number that is not below another out of the set. O(log n).
    fn take_from(&mut self, number: u32) -> Option<u32> {
        let mut at = number as usize;
        // Up to the first level whose word has a bit at that place or after it.
        let found = self.0.iter().enumerate().find_map(|(level, words)| {
            let bits = words.get(at / 64)? & (u64::MAX << (at % 64));
            let first = at / 64 * 64 + bits.trailing_zeros() as usize;
            // The word of this place is below it: the next level begins after that word.
            at = at / 64 + 1;
            (bits != 0).then_some((level, first))
        });
        let (level, mut at) = found?;
        for words in self.0[..level].iter().rev() {
            at = at * 64 + words[at].trailing_zeros() as usize;
        }
        let taken = at as u32;
        for words in &mut self.0 {
            words[at / 64] &= !(1 << (at % 64));
            if words[at / 64] != 0 {
                break;
            }
            at /= 64;
        }
        Some(taken)
    }
}

/// Points in a balanced tree: the median of a range splits it, along the longer side of its box.
struct Tree {
    points: Vec<Point>,
    /// The box around the range that each point splits.
    boxes: Vec<Aabb>,
}

impl Tree {
    /// O(n log n).
    fn new(points: impl Iterator<Item = Point>) -> Self {
        let points: Vec<Point> = points.collect();
        let mut boxes: Vec<Aabb> = points.iter().map(|&p| Aabb::of(p, p)).collect();
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        split(&mut order, &points, &mut boxes);
        Self { points: order.into_iter().map(|i| points[i as usize]).collect(), boxes }
    }

    /// Whether a point other than the corners lies in the closed, counter-clockwise triangle.
    fn meets(&self, triangle: [Point; 3]) -> bool {
        let [a, b, c] = triangle;
        let around = Aabb::of(a, b).union(&Aabb::of(b, c));
        let sides = [(a, b), (b, c), (c, a)];
        let holds = |p: Point| around.contains(p) && sides.iter().all(|&(a, b)| orientation(a, b, p) >= 0.0);
        // A box lies outside if its corner that is farthest to the left of a side is on the right of it.
        let may_meet = |aabb: &Aabb| {
            let corner = |a: Point, b: Point| {
                let x = if a.y > b.y { aabb.max.x } else { aabb.min.x };
                Point::new(x, if b.x > a.x { aabb.max.y } else { aabb.min.y })
            };
            aabb.intersects(&around) && sides.iter().all(|&(a, b)| orientation(a, b, corner(a, b)) >= 0.0)
        };
        let mut ranges = Vec::new();
        ranges.push(0..self.points.len());
        while let Some(range) = ranges.pop() {
            let middle = range.start + range.len() / 2;
            if range.is_empty() || !may_meet(&self.boxes[middle]) {
                continue;
            }
            if holds(self.points[middle]) && !triangle.contains(&self.points[middle]) {
                return true;
            }
            ranges.extend([range.start..middle, middle + 1..range.end]);
        }
        false
    }
}

/// Orders the numbers of points as a tree, and stores the box of every range.
fn split(order: &mut [u32], points: &[Point], boxes: &mut [Aabb]) {
    let Some(aabb) = Aabb::around(order.iter().map(|&i| points[i as usize])) else { return };
    let is_wide = aabb.max.x - aabb.min.x > aabb.max.y - aabb.min.y;
    let middle = order.len() / 2;
    let along = |i: usize| if is_wide { points[i].x } else { points[i].y };
    select_number(order, middle, &|i, j| along(i).total_cmp(&along(j)).then(i.cmp(&j)));
    boxes[middle] = aabb;
    let (low, high) = order.split_at_mut(middle);
    let (low_boxes, high_boxes) = boxes.split_at_mut(middle);
    split(low, points, low_boxes);
    split(&mut high[1..], points, &mut high_boxes[1..]);
}
