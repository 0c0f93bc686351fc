//! Distance between a point and a segment.

use super::{Point, Segment};

/// The squared distance from the point to the nearest point of the segment, in square metres. O(1).
pub fn distance_squared_point_segment(p: Point, s: &Segment) -> f64 {
    let along = s.b - s.a;
    let to = p - s.a;
    let projection = to.dot(&along);
    let length_squared = along.norm_squared();
    if projection <= 0.0 {
        return to.norm_squared();
    }
    if projection >= length_squared {
        return (p - s.b).norm_squared();
    }
    let across = along.perp(&to);
    across * across / length_squared
}

/// The distance from the point to the nearest point of the segment, in metres. O(1).
pub fn distance_point_segment(p: Point, s: &Segment) -> f64 {
    distance_squared_point_segment(p, s).sqrt()
}
