//! The region between two positions of a link: the convex hull of four points.
//!
//! No hull is built. Every point of the hull of four points lies in a triangle of three of them, and every edge of the
//! hull is one of their six connections; so tests against the triangles and the connections are tests against the hull.

use super::near::{Near, Shape, gap};
use crate::geometry::{Aabb, Point, Segment, distance_point_segment, distance_squared_segment_segment, orientation};

/// The hull of the two ends of a link at two moments.
pub(super) struct Swept {
    corners: [Point; 4],
    connections: [Segment; 6],
    aabb: Aabb,
}

impl Swept {
    /// The hull of two segments.
    pub(super) fn new(before: &Segment, after: &Segment) -> Self {
        let [a, b, c, d] = [before.a, before.b, after.a, after.b];
        let connections = [(a, b), (c, d), (a, c), (b, d), (a, d), (b, c)].map(|(p, q)| Segment::new(p, q));
        Self { corners: [a, b, c, d], connections, aabb: before.aabb().union(&after.aabb()) }
    }

    /// Whether the obstacle comes within `reach` of the hull. The first segment of the hull must lie outside of a
    /// polygon: then the hull meets the polygon only if it meets its border.
    pub(super) fn comes_within(&self, reach: f64, near: &Near) -> bool {
        match &near.shape {
            Shape::Disc(disc) => {
                let far = reach + disc.radius;
                gap(&self.aabb, &disc.aabb()) <= reach
                    && (self.connections.iter().any(|s| distance_point_segment(disc.center, s) <= far)
                        || self.contains(disc.center))
            }
            Shape::Polygon(_, edges) => edges.iter().any(|edge| {
                gap(&self.aabb, &edge.aabb()) <= reach
                    && (self.connections.iter().any(|s| distance_squared_segment_segment(s, edge) <= reach * reach)
                        || self.contains(edge.a))
            }),
        }
    }

    /// Whether the point lies in one of the four triangles; exact. Flat triangles hold only points of the connections.
    fn contains(&self, p: Point) -> bool {
        let [a, b, c, d] = self.corners;
        self.aabb.contains(p)
            && [[a, b, c], [a, b, d], [a, c, d], [b, c, d]].into_iter().any(|[a, b, c]| {
                let sides = [orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)];
                orientation(a, b, c) != 0.0
                    && (sides.iter().all(|&side| side >= 0.0) || sides.iter().all(|&side| side <= 0.0))
            })
    }
}
