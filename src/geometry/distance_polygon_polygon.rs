//! Distance between two filled polygons.

use super::{Polygon, distance_squared_segment_segment};

/// The distance between the two closed, filled polygons, in metres; 0 where they share a point. O(n m).
///
/// Polygons that share a point either have borders that meet, or one holds all of the other, and so its first vertex.
pub fn distance_polygon_polygon(a: &Polygon, b: &Polygon) -> f64 {
    if a.contains(b.vertices()[0]) || b.contains(a.vertices()[0]) {
        return 0.0;
    }
    let to_border = |s| b.edges().map(|t| distance_squared_segment_segment(&s, &t)).fold(f64::INFINITY, f64::min);
    a.edges().map(to_border).fold(f64::INFINITY, f64::min).sqrt()
}
