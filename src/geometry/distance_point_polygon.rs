//! Distance between a point and a filled polygon.

use super::{Point, Polygon, distance_squared_point_segment};

/// The distance from the point to the closed, filled polygon, in metres; 0 inside and on the border. O(vertices).
pub fn distance_point_polygon(p: Point, polygon: &Polygon) -> f64 {
    if polygon.contains(p) {
        return 0.0;
    }
    polygon.edges().map(|edge| distance_squared_point_segment(p, &edge)).fold(f64::INFINITY, f64::min).sqrt()
}
