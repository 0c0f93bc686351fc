//! Whether two filled polygons share a point, exactly.

use super::{Polygon, intersects_segment_segment};

/// Whether the closed, filled polygons share a point; exact. O(n m).
pub fn intersects_polygon_polygon(a: &Polygon, b: &Polygon) -> bool {
    a.aabb().intersects(b.aabb())
        && (a.contains(b.vertices()[0])
            || b.contains(a.vertices()[0])
            || a.edges().any(|s| b.edges().any(|t| intersects_segment_segment(&s, &t))))
}
