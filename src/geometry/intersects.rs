//! Whether closed segments share a point: exact (Shewchuk's adaptive predicates).

use super::{Segment, orientation};

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
