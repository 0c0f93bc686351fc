//! Whether a segment and a filled polygon share a point, exactly.

use super::{Polygon, Segment, intersects_segment_segment};

/// Whether the closed segment shares a point with the closed, filled polygon; exact. O(vertices).
pub fn intersects_segment_polygon(s: &Segment, polygon: &Polygon) -> bool {
    s.aabb().intersects(polygon.aabb())
        && (polygon.contains(s.a) || polygon.edges().any(|edge| intersects_segment_segment(s, &edge)))
}
