//! Distance between a segment and a filled polygon.

use super::{Polygon, Segment, distance_squared_segment_segment};

/// The distance from the segment to the closed, filled polygon, in metres; 0 where they share a point. O(vertices).
pub fn distance_segment_polygon(s: &Segment, polygon: &Polygon) -> f64 {
    if polygon.contains(s.a) {
        return 0.0;
    }
    polygon.edges().map(|edge| distance_squared_segment_segment(s, &edge)).fold(f64::INFINITY, f64::min).sqrt()
}
