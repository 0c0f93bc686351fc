//! A chain or a polygon at a pose: what lies in it, and how far it is from others. Its corners and the boxes of its tree are
//! placed one by one, as far as a query needs them.

use super::box_tree::{BoxTree, DEPTH, LEAF, Node};
use super::chain::Chain;
use super::{
    Aabb, Point, Polygon, Segment, Vector, distance_squared_point_segment, distance_squared_segment_segment,
    intersects_segment_segment, orientation,
};
use std::cell::Cell;
use std::ops::Range;

/// The part of its coordinates by which the box of a placed node is grown: it covers the rounding of the corners and of
/// itself.
const ROUNDING: f64 = 1e-14;

/// A polygon where it is, or turned about the origin and then moved.
#[derive(Debug, Clone, Copy)]
pub struct Placed<'a> {
    chain: &'a Chain,
    pose: Option<Pose>,
}

#[derive(Debug, Clone, Copy)]
struct Pose {
    x: f64,
    y: f64,
    sin: f64,
    cos: f64,
}

impl Pose {
    fn place(&self, p: Point) -> Point {
        let Self { x, y, sin, cos } = self;
        Point::new(x + (cos * p.x - sin * p.y), y + (sin * p.x + cos * p.y))
    }
}

impl<'a> Placed<'a> {
    /// The polygon where it is. O(1).
    pub fn resting(polygon: &'a Polygon) -> Self {
        Self::of_chain(polygon.border())
    }

    /// The polygon at the pose (x, y, theta): its corners have the same bits as those of [`Polygon::placed`]. O(1).
    pub fn new(polygon: &'a Polygon, [x, y, theta]: [f64; 3]) -> Self {
        let (sin, cos) = libm::sincos(theta);
        Self { chain: polygon.border(), pose: Some(Pose { x, y, sin, cos }) }
    }

    /// A chain where it is: what it encloses is filled for those queries that say so. O(1).
    pub(super) fn of_chain(chain: &'a Chain) -> Self {
        Self { chain, pose: None }
    }

    /// A box around it.
    pub(super) fn aabb(&self) -> Aabb {
        self.around(self.chain.aabb())
    }

    /// Corner `i`.
    pub(crate) fn corner(&self, i: usize) -> Point {
        let corner = self.chain.points()[i];
        self.pose.map_or(corner, |pose| pose.place(corner))
    }

    /// The edge from corner `i`.
    fn edge(&self, i: usize) -> Segment {
        let next = if i + 1 == self.chain.points().len() { 0 } else { i + 1 };
        Segment::new(self.corner(i), self.corner(next))
    }

    /// A box around the placed content of a box.
    fn around(&self, aabb: &Aabb) -> Aabb {
        let Some(pose) = self.pose else { return *aabb };
        let center = aabb.min + 0.5 * (aabb.max - aabb.min);
        let half = aabb.max - center;
        let at = pose.place(center);
        let (sin, cos) = (pose.sin.abs(), pose.cos.abs());
        let grown = ROUNDING * (pose.x.abs() + pose.y.abs() + center.x.abs() + center.y.abs() + half.x + half.y);
        let half = Vector::new(cos * half.x + sin * half.y + grown, sin * half.x + cos * half.y + grown);
        Aabb { min: at - half, max: at + half }
    }

    /// Whether the point lies inside or on the border; exact for the rounded corners. O(log n) if few boxes of the tree
    /// hold the point.
    pub fn contains(&self, p: Point) -> bool {
        self.contains_counted(p, &mut 0)
    }

    /// The same; `work` is increased by the number of boxes and edges compared.
    fn contains_counted(&self, p: Point, work: &mut u64) -> bool {
        self.is_inside(p, work).unwrap_or(true)
    }

    /// Whether the point lies inside; `None` on the border.
    pub(super) fn is_inside(&self, p: Point, work: &mut u64) -> Option<bool> {
        match self.chain.tree() {
            Some(tree) => self.crossings(tree, tree.root(), p, work),
            None => self.crossings_of(0..self.chain.count(), p, work),
        }
    }

    /// Whether the ray to the right from the point crosses an odd number of the node's edges; `None` if the point is on
    /// one.
    fn crossings(&self, tree: &BoxTree, node: Node, p: Point, work: &mut u64) -> Option<bool> {
        *work += 1;
        let around = self.around(tree.aabb(node));
        if around.max.x < p.x || around.max.y < p.y || around.min.y > p.y {
            return Some(false);
        }
        let edges = tree.items(node);
        if around.min.x > p.x {
            // All edges are to the right: their chain crosses the ray as often, modulo 2, as the line between its ends.
            let end = if edges.end == self.chain.points().len() { 0 } else { edges.end };
            return Some((self.corner(edges.start).y > p.y) != (self.corner(end).y > p.y));
        }
        let Some((first, second)) = tree.children(node) else { return self.crossings_of(edges, p, work) };
        let odd = self.crossings(tree, first, p, work)?;
        match second {
            Some(second) => Some(odd != self.crossings(tree, second, p, work)?),
            None => Some(odd),
        }
    }

    /// The same of a range of edges.
    fn crossings_of(&self, edges: Range<usize>, p: Point, work: &mut u64) -> Option<bool> {
        *work += edges.len() as u64;
        let mut odd = false;
        for i in edges {
            let edge @ Segment { a, b } = self.edge(i);
            if a.y.min(b.y) > p.y || a.y.max(b.y) < p.y {
                continue;
            }
            let side = orientation(a, b, p);
            if side == 0.0 && edge.aabb().contains(p) {
                return None;
            }
            odd ^= (a.y > p.y) != (b.y > p.y) && (side > 0.0) == (b.y > a.y);
        }
        Some(odd)
    }

    /// The distance from the point, 0 inside and on the border; if it is `most` or more, that distance or infinity. In
    /// metres. `work` is increased by the number of boxes and edges compared.
    pub fn distance_to_point(&self, p: Point, most: f64, work: &mut u64) -> f64 {
        *work += 1;
        if self.is_beyond(&Aabb { min: p, max: p }, most) {
            return f64::INFINITY;
        }
        if self.contains_counted(p, work) { 0.0 } else { self.distance_to_border(p, most, work) }
    }

    /// The distance from the point to the border; if it is `most` or more, that distance or infinity. In metres.
    pub fn distance_to_border(&self, p: Point, most: f64, work: &mut u64) -> f64 {
        let bound = |aabb: &Aabb| aabb.gap_squared(&Aabb { min: p, max: p });
        self.least(most * most, bound, |edge| distance_squared_point_segment(p, edge), work).sqrt()
    }

    /// The distance from the segment, 0 if they share a point; if it is `most` or more, that distance or infinity. In
    /// metres.
    pub fn distance_to_segment(&self, s: &Segment, most: f64, work: &mut u64) -> f64 {
        *work += 1;
        if self.is_beyond(&s.aabb(), most) {
            return f64::INFINITY;
        }
        if self.contains_counted(s.a, work) { 0.0 } else { self.border_to_segment(s, most, work) }
    }

    /// The distance from the segment to the border; if it is `most` or more, that distance or infinity. In metres.
    pub(super) fn border_to_segment(&self, s: &Segment, most: f64, work: &mut u64) -> f64 {
        let (around, along) = (s.aabb(), s.b - s.a);
        let length = along.norm();
        let bound = |aabb: &Aabb| {
            // By the boxes, or by the line of the segment: the first alone does not exclude what is beside a slanted
            // segment.
            let half = 0.5 * (aabb.max - aabb.min);
            let off = along.perp(&(aabb.min + half - s.a)).abs() - (along.x.abs() * half.y + along.y.abs() * half.x);
            let aside = if off > 0.0 { off / length } else { 0.0 };
            aabb.gap_squared(&around).max(aside * aside)
        };
        self.least(most * most, bound, |edge| distance_squared_segment_segment(s, edge), work).sqrt()
    }

    /// Whether the box around the polygon is at least `most` from another one.
    fn is_beyond(&self, other: &Aabb, most: f64) -> bool {
        most < f64::INFINITY && self.aabb().gap_squared(other) >= most * most
    }

    /// The least `squared` of all edges; if it is `most` or more, that or infinity. `bound` is no more than that of any
    /// edge in a box.
    fn least(&self, most: f64, bound: impl Fn(&Aabb) -> f64, squared: impl Fn(&Segment) -> f64, work: &mut u64) -> f64 {
        let n = self.chain.count();
        let Some(tree) = self.chain.tree() else {
            *work += n as u64;
            return (0..n).map(|i| squared(&self.edge(i))).fold(f64::INFINITY, f64::min);
        };
        let (mut least, mut limit) = (f64::INFINITY, most);
        let mut stack = [(0.0, Node::ANY); DEPTH];
        stack[0].1 = tree.root();
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let (bounded, node) = stack[waiting];
            if bounded >= limit {
                continue;
            }
            let Some((first, second)) = tree.children(node) else {
                *work += LEAF as u64;
                least = tree.items(node).map(|i| squared(&self.edge(i))).fold(least, f64::min);
                limit = limit.min(least);
                continue;
            };
            *work += 2;
            let of = |node: Node| (bound(&self.around(tree.aabb(node))), node);
            let (mut near, mut far) = (of(first), second.map(of));
            if let Some(other) = &mut far
                && other.0 < near.0
            {
                std::mem::swap(other, &mut near);
            }
            // The last is taken first.
            for child in far.into_iter().chain([near]) {
                if child.0 < limit {
                    stack[waiting] = child;
                    waiting += 1;
                }
            }
        }
        least
    }

    /// The distance from another polygon, 0 if they share a point; if it is `most` or more, that distance or infinity.
    /// In metres. `work` is increased by the number of comparisons, of boxes and of edges.
    ///
    /// Polygons that share a point either have borders that meet, or one contains all of the other, and so its first
    /// corner.
    pub fn distance(&self, other: &Placed, most: f64, work: &mut u64) -> f64 {
        *work += 1;
        if self.is_beyond(&other.aabb(), most) {
            return f64::INFINITY;
        }
        if self.contains_counted(other.corner(0), work) || other.contains_counted(self.corner(0), work) {
            return 0.0;
        }
        self.border_to_border(other, most, work)
    }

    /// The distance between the borders; if it is `most` or more, that distance or infinity. In metres.
    pub(super) fn border_to_border(&self, other: &Placed, most: f64, work: &mut u64) -> f64 {
        let [n, m] = [self, other].map(|placed| placed.chain.count());
        if self.chain.tree().is_none() && other.chain.tree().is_none() {
            *work += (n * m) as u64;
            let edges: Vec<Segment> = (0..m).map(|i| other.edge(i)).collect();
            let squared = |i| {
                let edge = self.edge(i);
                edges.iter().map(|t| distance_squared_segment_segment(&edge, t)).fold(f64::INFINITY, f64::min)
            };
            return (0..n).map(squared).fold(f64::INFINITY, f64::min).sqrt();
        }
        let least = Cell::new(most * most);
        let mut found = f64::INFINITY;
        self.any_pair(other, &least, Aabb::gap_squared, work, |s, t| {
            let squared = distance_squared_segment_segment(s, t);
            if squared < found {
                found = squared;
                least.set(least.get().min(squared));
            }
            squared == 0.0
        });
        found.sqrt()
    }

    /// Calls `visit` with pairs of edges, one of each polygon, until it returns true; returns whether it did. Pairs are
    /// left out whose boxes have a greater `bound` than `limit`; it decreases with the boxes.
    pub(super) fn any_pair(
        &self,
        other: &Placed,
        limit: &Cell<f64>,
        bound: impl Fn(&Aabb, &Aabb) -> f64,
        work: &mut u64,
        mut visit: impl FnMut(&Segment, &Segment) -> bool,
    ) -> bool {
        let [own, their] = [self, other].map(Part::all);
        let mut stack = Vec::with_capacity(2 * DEPTH);
        stack.push((bound(&own.around, &their.around), own, their));
        let mut edges = Vec::new();
        while let Some((bounded, own, their)) = stack.pop() {
            if bounded > limit.get() {
                continue;
            }
            let [first, second] = [own.children(self), their.children(other)];
            // The larger box is divided; or the one that can be.
            let is_larger = own.around.longer_side() >= their.around.longer_side();
            let pairs = match (first, second) {
                (Some(parts), theirs) if is_larger || theirs.is_none() => {
                    parts.map(|part| part.map(|part| (part, their)))
                }
                (_, Some(parts)) => parts.map(|part| part.map(|part| (own, part))),
                _ => {
                    edges.clear();
                    edges.extend(their.edges(other).map(|i| other.edge(i)));
                    for i in own.edges(self) {
                        let edge = self.edge(i);
                        *work += edges.len() as u64;
                        if edges.iter().any(|t| visit(&edge, t)) {
                            return true;
                        }
                    }
                    continue;
                }
            };
            let mut pairs = pairs.map(|pair| pair.map(|(own, their)| (bound(&own.around, &their.around), own, their)));
            *work += 2;
            if let [Some(a), Some(b)] = &pairs
                && a.0 < b.0
            {
                pairs.swap(0, 1);
            }
            stack.extend(pairs.into_iter().flatten());
        }
        false
    }

    /// Calls `visit` with the edges of all leaves that may meet what is sought, in order, until it returns true;
    /// returns whether it did. `may_meet` tells so of a box, and is true of every box around another one of which it
    /// is.
    pub(super) fn any_edge(
        &self,
        may_meet: impl Fn(&Aabb) -> bool,
        mut visit: impl FnMut(usize, &Segment) -> bool,
    ) -> bool {
        let mut visit_all = |edges: Range<usize>| edges.into_iter().any(|i| visit(i, &self.edge(i)));
        let Some(tree) = self.chain.tree() else { return visit_all(0..self.chain.count()) };
        let mut stack = [Node::ANY; DEPTH];
        stack[0] = tree.root();
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let node = stack[waiting];
            if !may_meet(&self.around(tree.aabb(node))) {
                continue;
            }
            let Some((first, second)) = tree.children(node) else {
                if visit_all(tree.items(node)) {
                    return true;
                }
                continue;
            };
            for child in second.into_iter().chain([first]) {
                stack[waiting] = child;
                waiting += 1;
            }
        }
        false
    }

    /// Whether the closed segment shares a point with the polygon; exact for the rounded corners.
    pub(super) fn intersects_segment(&self, s: &Segment) -> bool {
        self.contains(s.a) || self.border_meets_segment(s)
    }

    /// Whether the closed segment shares a point with the border; exact for the rounded corners.
    pub(super) fn border_meets_segment(&self, s: &Segment) -> bool {
        let around = s.aabb();
        let meets_line = |aabb: &Aabb| {
            // The corners that are farthest to the left and to the right of the line.
            let (left, right) = (s.a.y > s.b.y, s.b.x > s.a.x);
            let corner = |x: bool, y: bool| {
                Point::new(if x { aabb.max.x } else { aabb.min.x }, if y { aabb.max.y } else { aabb.min.y })
            };
            orientation(s.a, s.b, corner(left, right)) >= 0.0 && orientation(s.a, s.b, corner(!left, !right)) <= 0.0
        };
        self.any_edge(
            |aabb| aabb.intersects(&around) && meets_line(aabb),
            |_, edge| intersects_segment_segment(s, edge),
        )
    }

    /// Whether the polygons share a point; exact for the rounded corners.
    pub(super) fn intersects(&self, other: &Placed) -> bool {
        let apart = |a: &Aabb, b: &Aabb| if a.intersects(b) { 0.0 } else { f64::INFINITY };
        self.contains(other.corner(0))
            || other.contains(self.corner(0))
            || self.any_pair(other, &Cell::new(0.0), apart, &mut 0, intersects_segment_segment)
    }
}

/// A node of a polygon's tree, or all edges of a polygon without one.
#[derive(Debug, Clone, Copy)]
struct Part {
    node: Option<Node>,
    around: Aabb,
}

impl Part {
    fn all(placed: &Placed) -> Self {
        let node = placed.chain.tree().map(BoxTree::root);
        Self { node, around: placed.aabb() }
    }

    fn children(&self, placed: &Placed) -> Option<[Option<Self>; 2]> {
        let tree = placed.chain.tree()?;
        let (first, second) = tree.children(self.node?)?;
        let part = |node: Node| Self { node: Some(node), around: placed.around(tree.aabb(node)) };
        Some([Some(part(first)), second.map(part)])
    }

    fn edges(&self, placed: &Placed) -> Range<usize> {
        match (self.node, placed.chain.tree()) {
            (Some(node), Some(tree)) => tree.items(node),
            _ => 0..placed.chain.count(),
        }
    }
}
