//! Whether closed segments and closed, filled polygons share a point: exact (Shewchuk's adaptive predicates).

use super::{Placed, Polygon, Segment, orientation};

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
