//! Whether closed segments and closed, filled polygons share a point: exact (Shewchuk's adaptive predicates).

use super::{Polygon, Segment, orientation};

/// Whether the closed segments share a point; exact, degenerate segments included. O(1).
pub fn intersects_segment_segment(s: &Segment, t: &Segment) -> bool {
    if !s.aabb().intersects(&t.aabb()) {
        return false;
    }
    let (t_a, t_b) = (orientation(s.a, s.b, t.a), orientation(s.a, s.b, t.b));
    let (s_a, s_b) = (orientation(t.a, t.b, s.a), orientation(t.a, t.b, s.b));
    let apart = |x: f64, y: f64| (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0);
    // With overlapping boxes, collinear segments overlap; otherwise each must straddle (or touch) the other's line.
    !apart(t_a, t_b) && !apart(s_a, s_b)
}

/// Whether the closed segment shares a point with the closed, filled polygon; exact. O(vertices).
pub fn intersects_segment_polygon(s: &Segment, polygon: &Polygon) -> bool {
    s.aabb().intersects(polygon.aabb())
        && (polygon.contains(s.a) || polygon.edges().any(|edge| intersects_segment_segment(s, &edge)))
}

/// Whether the closed, filled polygons share a point; exact. O(n m).
pub fn intersects_polygon_polygon(a: &Polygon, b: &Polygon) -> bool {
    a.aabb().intersects(b.aabb())
        && (a.contains(b.vertices()[0])
            || b.contains(a.vertices()[0])
            || a.edges().any(|s| b.edges().any(|t| intersects_segment_segment(&s, &t))))
}
