//! Distances between points, segments and filled polygons, in metres: rounded, by a few units in the last place of the
//! largest coordinate.

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

/// The squared distance between the two segments, in square metres; 0 if they cross. O(1).
///
/// Segments that do not cross are nearest at an end of one of them. A crossing that rounding hides leaves an end within
/// rounding of the other segment, so the result is then off by no more than rounding.
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

/// The distance between the two segments, in metres; 0 if they cross. O(1).
pub fn distance_segment_segment(s: &Segment, t: &Segment) -> f64 {
    distance_squared_segment_segment(s, t).sqrt()
}
