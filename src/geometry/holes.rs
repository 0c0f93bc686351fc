//! A polygon with holes: what lies in it, and how far it is from others.

use super::box_tree::MOST_WITHOUT;
use super::ring_tree::RingTree;
use super::rings::{HoleFault, find_fault};
use super::{Aabb, Placed, Point, Polygon, Segment, Wall};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use std::cell::Cell;
use std::sync::{Arc, OnceLock};

/// A closed, filled polygon without the insides of its holes: their borders belong to it. Holes lie in the outline and
/// outside each other; rings may touch in single points.
#[derive(Debug, Clone)]
pub struct PolygonWithHoles {
    outline: Polygon,
    holes: Vec<Polygon>,
    /// Of the holes, built by the first query; clones share it.
    tree: OnceLock<Arc<RingTree>>,
}

/// Polygons are equal if their rings are, in order.
impl PartialEq for PolygonWithHoles {
    fn eq(&self, other: &Self) -> bool {
        (&self.outline, &self.holes) == (&other.outline, &other.holes)
    }
}

/// As a polygon of a document: the outline counter-clockwise, the holes clockwise.
impl Serialize for PolygonWithHoles {
    fn serialize<S: Serializer>(&self, target: S) -> Result<S::Ok, S::Error> {
        let clockwise = |hole: &Polygon| hole.vertices().iter().rev().copied().collect();
        let holes: Vec<Vec<Point>> = self.holes.iter().map(clockwise).collect();
        let mut polygon = target.serialize_struct("polygon", 3)?;
        polygon.serialize_field("type", "polygon")?;
        polygon.serialize_field("vertices", self.outline.vertices())?;
        polygon.serialize_field("holes", &holes)?;
        polygon.end()
    }
}

impl PolygonWithHoles {
    /// The outline without the insides of the holes.
    ///
    /// # Errors
    /// The [`HoleFault`] if a hole is not within the outline, is within another one, or if rings cross or share more than
    /// single points. Decided exactly.
    ///
    /// # Complexity
    /// O(n log n) predicates for n vertices in all.
    pub fn new(outline: Polygon, holes: Vec<Polygon>) -> Result<Self, HoleFault> {
        let rings: Vec<&Polygon> = std::iter::once(&outline).chain(&holes).collect();
        match find_fault(&rings) {
            Some(fault) => Err(fault),
            None => Ok(Self { outline, holes, tree: OnceLock::new() }),
        }
    }

    /// The border on the outside, counter-clockwise.
    pub fn outline(&self) -> &Polygon {
        &self.outline
    }

    /// The holes, each as the polygon that it would fill, counter-clockwise.
    pub fn holes(&self) -> &[Polygon] {
        &self.holes
    }

    /// The outline, then the holes.
    pub fn rings(&self) -> impl Iterator<Item = &Polygon> + Clone {
        std::iter::once(&self.outline).chain(&self.holes)
    }

    /// The edges of all rings, each ring counter-clockwise.
    pub fn edges(&self) -> impl Iterator<Item = Segment> + '_ {
        self.rings().flat_map(Polygon::edges)
    }

    /// The edges of all rings as walls without width.
    pub(crate) fn border(&self) -> impl Iterator<Item = Wall> + '_ {
        self.edges().map(|edge| Wall::line(&edge))
    }

    /// The smallest box around the polygon.
    pub fn aabb(&self) -> &Aabb {
        self.outline.aabb()
    }

    /// Whether the point lies in the polygon or on its border: not inside a hole. Exact. As [`Polygon::contains`] for the outline
    /// and the holes whose boxes hold the point, which are found in O(log n).
    pub fn contains(&self, p: Point) -> bool {
        let at = Aabb { min: p, max: p };
        self.outline.contains(p) && !self.any_hole_near(&at, |hole| hole.contains_inside(p))
    }

    /// Whether the closed segment shares a point with the polygon; exact.
    pub fn intersects_segment(&self, s: &Segment) -> bool {
        let around = s.aabb();
        self.aabb().intersects(&around)
            && (self.contains(s.a) || self.any_ring_near(&around, |ring| Placed::resting(ring).border_meets_segment(s)))
    }

    /// The distance from the segment, 0 if they share a point; if it is `most` or more, that distance or infinity. In
    /// metres.
    pub fn distance_to_segment(&self, s: &Segment, most: f64) -> f64 {
        if self.contains(s.a) {
            return 0.0;
        }
        self.least(most, &s.aabb(), |ring, most| ring.border_to_segment(s, most, &mut 0))
    }

    /// The distance from the polygon, 0 if they share a point; if it is `most` or more, that distance or infinity. In
    /// metres.
    ///
    /// If they share a point, then borders meet, or all of the other one lies in this one, or a ring lies in the other.
    pub fn distance_to_polygon(&self, other: &Placed, most: f64) -> f64 {
        let is_inside = |ring: &Polygon| other.contains(ring.vertices()[0]);
        if self.contains(other.corner(0)) || self.any_ring_near(&other.aabb(), is_inside) {
            return 0.0;
        }
        self.least(most, &other.aabb(), |ring, most| ring.border_to_border(other, most, &mut 0))
    }

    /// The distance from the point to the border, in metres; inside, the depth below it as a negative number. A point in
    /// a hole is outside.
    pub fn signed_distance_to_point(&self, p: Point) -> f64 {
        let around = Aabb { min: p, max: p };
        let distance = self.least(f64::INFINITY, &around, |ring, most| ring.distance_to_border(p, most, &mut 0));
        if self.contains(p) { -distance } else { distance }
    }

    /// Calls `visit` with every edge of a ring whose box meets the given one, until it returns true; returns whether it did.
    pub(crate) fn any_edge_near(&self, near: &Aabb, mut visit: impl FnMut(&Segment) -> bool) -> bool {
        self.any_ring_near(near, |ring| ring.any_edge_near(near, |_, edge| visit(edge)))
    }

    /// Calls `visit` with every ring whose box meets the given one, the outline first, until it returns true; returns whether it
    /// did.
    fn any_ring_near(&self, near: &Aabb, mut visit: impl FnMut(&Polygon) -> bool) -> bool {
        (self.aabb().intersects(near) && visit(&self.outline)) || self.any_hole_near(near, visit)
    }

    /// The same of the holes.
    fn any_hole_near(&self, near: &Aabb, visit: impl FnMut(&Polygon) -> bool) -> bool {
        let apart = |aabb: &Aabb| if aabb.intersects(near) { 0.0 } else { f64::INFINITY };
        self.any_hole(&Cell::new(0.0), apart, visit)
    }

    /// Calls `visit` with every hole of whose box the `bound` is at most the limit, which may fall meanwhile, until it returns
    /// true; returns whether it did. The bound of a box is no more than that of any in it.
    fn any_hole(
        &self,
        limit: &Cell<f64>,
        bound: impl Fn(&Aabb) -> f64,
        mut visit: impl FnMut(&Polygon) -> bool,
    ) -> bool {
        let mut visit = |i: usize| bound(self.holes[i].aabb()) <= limit.get() && visit(&self.holes[i]);
        if self.holes.len() <= MOST_WITHOUT {
            return (0..self.holes.len()).any(visit);
        }
        let tree = self.tree.get_or_init(|| Arc::new(RingTree::new(&self.holes)));
        tree.any(limit, &bound, &mut visit)
    }

    /// The least `distance` of all rings from what is in the box, each asked for one below that of those before; if it is `most`
    /// or more, that or infinity.
    fn least(&self, most: f64, around: &Aabb, distance: impl Fn(&Placed, f64) -> f64) -> f64 {
        let (least, limit) = (Cell::new(f64::INFINITY), Cell::new(most * most));
        let bound = |aabb: &Aabb| aabb.gap_squared(around);
        let look = |ring: &Polygon| {
            let found = distance(&Placed::resting(ring), most.min(least.get())).min(least.get());
            least.set(found);
            limit.set(limit.get().min(found * found));
            false
        };
        if bound(self.aabb()) <= limit.get() {
            look(&self.outline);
        }
        self.any_hole(&limit, bound, look);
        least.get()
    }
}
