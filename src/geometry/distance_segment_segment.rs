//! Distance between two segments.

use super::{Segment, distance_squared_point_segment};

/// The squared distance between the two segments, in square metres; 0 where they cross. O(1).
///
/// Segments that do not cross are nearest at an end of one of them. A crossing that rounding hides leaves an end within
/// rounding of the other segment, so the answer is then off by no more than rounding.
pub fn distance_squared_segment_segment(s: &Segment, t: &Segment) -> f64 {
    let (u, v, w) = (s.b - s.a, t.b - t.a, t.a - s.a);
    let ends_of_t = (u.perp(&w), u.perp(&(t.b - s.a)));
    let ends_of_s = (-v.perp(&w), v.perp(&(s.b - t.a)));
    let opposite = |(x, y): (f64, f64)| (x < 0.0 && y > 0.0) || (x > 0.0 && y < 0.0);
    if opposite(ends_of_t) && opposite(ends_of_s) {
        return 0.0;
    }
    distance_squared_point_segment(s.a, t)
        .min(distance_squared_point_segment(s.b, t))
        .min(distance_squared_point_segment(t.a, s))
        .min(distance_squared_point_segment(t.b, s))
}

/// The distance between the two segments, in metres; 0 where they cross. O(1).
pub fn distance_segment_segment(s: &Segment, t: &Segment) -> f64 {
    distance_squared_segment_segment(s, t).sqrt()
}
