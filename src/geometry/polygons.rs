//! Whether closed, filled polygons meet points, segments and each other, exactly, and how far they are from these.

use super::{Aabb, Placed, Point, Polygon, Segment};

impl Polygon {
    /// Whether the point lies inside or on the border; exact. O(log n) if the border is as usual, O(n) if most of it
    /// winds around the point.
    pub fn contains(&self, p: Point) -> bool {
        self.aabb().contains(p) && Placed::resting(self).contains(p)
    }

    /// Whether the point lies inside, not on the border; exact. As [`Polygon::contains`].
    pub fn contains_inside(&self, p: Point) -> bool {
        self.aabb().contains(p) && Placed::resting(self).is_inside(p, &mut 0) == Some(true)
    }

    /// Calls `visit` with every edge whose box meets the given one, and the number of the corner that it starts from,
    /// in order, until it returns true; returns whether it did. O(log n + edges visited) if the border is as usual.
    pub fn any_edge_near(&self, near: &Aabb, mut visit: impl FnMut(usize, &Segment) -> bool) -> bool {
        let visit = |i: usize, edge: &Segment| edge.aabb().intersects(near) && visit(i, edge);
        Placed::resting(self).any_edge(|aabb| aabb.intersects(near), visit)
    }
}

/// Whether the closed segment shares a point with the closed, filled polygon; exact. O(log n), and O(1) for each edge
/// near the segment.
pub fn intersects_segment_polygon(s: &Segment, polygon: &Polygon) -> bool {
    s.aabb().intersects(polygon.aabb()) && Placed::resting(polygon).intersects_segment(s)
}

/// Whether the closed, filled polygons share a point; exact. O(log n), and O(1) for each pair of edges near each other;
/// O(n m) if neither has more than 16 corners.
pub fn intersects_polygon_polygon(a: &Polygon, b: &Polygon) -> bool {
    a.aabb().intersects(b.aabb()) && Placed::resting(a).intersects(&Placed::resting(b))
}

/// The distance from the point to the closed, filled polygon, in metres; 0 inside and on the border. O(log n) if the
/// border is as usual, O(n) if most of it is equally near.
pub fn distance_point_polygon(p: Point, polygon: &Polygon) -> f64 {
    Placed::resting(polygon).distance_to_point(p, f64::INFINITY, &mut 0)
}

/// The distance from the point to the border of the polygon, in metres; inside, the depth below the border as a
/// negative number. As [`distance_point_polygon`].
pub fn signed_distance_point_polygon(p: Point, polygon: &Polygon) -> f64 {
    let distance = Placed::resting(polygon).distance_to_border(p, f64::INFINITY, &mut 0);
    if polygon.contains(p) { -distance } else { distance }
}

/// The distance from the segment to the closed, filled polygon, in metres; 0 if they share a point. As
/// [`distance_point_polygon`], and O(1) for each edge beside the segment.
pub fn distance_segment_polygon(s: &Segment, polygon: &Polygon) -> f64 {
    Placed::resting(polygon).distance_to_segment(s, f64::INFINITY, &mut 0)
}

/// The distance between the two closed, filled polygons, in metres; 0 if they share a point. As
/// [`distance_point_polygon`], for each edge that is near the other polygon; O(n m) if neither has more than 16
/// corners.
pub fn distance_polygon_polygon(a: &Polygon, b: &Polygon) -> f64 {
    Placed::resting(a).distance(&Placed::resting(b), f64::INFINITY, &mut 0)
}
