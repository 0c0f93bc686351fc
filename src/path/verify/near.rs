//! The obstacles near a moving link, and of polygons and walls the edges, that can matter during an interval of motion.

use crate::geometry::{
    Aabb, Point, Segment, distance_point_segment, distance_segment_segment, distance_squared_segment_segment,
    orientation,
};
use crate::scenario::Obstacle;

/// An obstacle near a link.
pub(super) struct Near<'a> {
    /// The index of the obstacle in the world.
    pub index: usize,
    pub obstacle: &'a Obstacle,
    /// Those edges of polygons, and segments of walls, that are near; and half the width of these.
    edges: Vec<Segment>,
    radius: f64,
}

/// The obstacles within `reach` of the box.
pub(super) fn near<'a>(obstacles: &'a [Obstacle], around: &Aabb, reach: f64) -> Vec<Near<'a>> {
    let is_near = |other: &Aabb| gap(around, other) <= reach;
    let found = obstacles.iter().enumerate().filter(|(_, obstacle)| is_near(&obstacle.aabb()));
    found
        .map(|(index, obstacle)| {
            let (mut edges, radius) = (Vec::new(), obstacle.edge_radius());
            let beyond = reach + radius;
            obstacle.any_edge_near(&around.grown(beyond), |edge| {
                if gap(around, &edge.aabb()) <= beyond {
                    edges.push(*edge);
                }
                false
            });
            Near { index, obstacle, edges, radius }
        })
        .collect()
}

impl Near<'_> {
    /// The distance from the segment to the obstacle, in metres; 0 or less inside.
    pub(super) fn distance(&self, s: &Segment) -> f64 {
        match self.obstacle {
            Obstacle::Disc(_) => self.obstacle.distance_to_segment(s),
            Obstacle::Polygon(polygon) if polygon.contains(s.a) => 0.0,
            Obstacle::PolygonWithHoles(polygon) if polygon.contains(s.a) => 0.0,
            Obstacle::Polygon(_) | Obstacle::PolygonWithHoles(_) | Obstacle::Wall(_) => {
                let distances = self.edges.iter().map(|edge| distance_segment_segment(s, edge));
                distances.fold(f64::INFINITY, f64::min) - self.radius
            }
        }
    }

    /// Whether the obstacle comes within `reach` of the region between two positions of a link: the convex hull of four
    /// points. At the first position the link must be outside of a polygon: then the hull meets the polygon only if it
    /// meets its border.
    ///
    /// Every point of the hull of four points lies in a triangle of three of them, and every edge of the hull is one of
    /// their six connections; so tests against the triangles and the connections are tests against the hull.
    pub(super) fn is_near_hull(&self, before: &Segment, after: &Segment, reach: f64) -> bool {
        let [a, b, c, d] = [before.a, before.b, after.a, after.b];
        let connections = [(a, b), (c, d), (a, c), (b, d), (a, d), (b, c)].map(|(p, q)| Segment::new(p, q));
        let around = before.aabb().union(&after.aabb());
        // Exact. Flat triangles contain only points of the connections.
        let holds = |p: Point| {
            around.contains(p)
                && [[a, b, c], [a, b, d], [a, c, d], [b, c, d]].into_iter().any(|[a, b, c]| {
                    let sides = [orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)];
                    orientation(a, b, c) != 0.0
                        && (sides.iter().all(|&side| side >= 0.0) || sides.iter().all(|&side| side <= 0.0))
                })
        };
        match self.obstacle {
            Obstacle::Disc(disc) => {
                let far = reach + disc.radius;
                gap(&around, &disc.aabb()) <= reach
                    && (connections.iter().any(|s| distance_point_segment(disc.center, s) <= far) || holds(disc.center))
            }
            Obstacle::Polygon(_) | Obstacle::PolygonWithHoles(_) | Obstacle::Wall(_) => {
                let far = reach + self.radius;
                self.edges.iter().any(|edge| {
                    gap(&around, &edge.aabb()) <= far
                        && (connections.iter().any(|s| distance_squared_segment_segment(s, edge) <= far * far)
                            || holds(edge.a))
                })
            }
        }
    }
}

/// The distance between two boxes along the axis on which they are farther apart: at most their distance; 0 if they overlap.
pub(super) fn gap(a: &Aabb, b: &Aabb) -> f64 {
    let x = (b.min.x - a.max.x).max(a.min.x - b.max.x);
    let y = (b.min.y - a.max.y).max(a.min.y - b.max.y);
    x.max(y).max(0.0)
}
