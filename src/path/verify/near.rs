//! The obstacles near a moving link, and of polygons the edges, that can matter during an interval of motion.

use crate::geometry::{
    Aabb, Disc, Polygon, Segment, distance_point_segment, distance_segment_polygon, distance_segment_segment,
};
use crate::scenario::Obstacle;

/// An obstacle near a link.
pub(super) struct Near<'a> {
    /// The index of the obstacle in the world.
    pub index: usize,
    pub shape: Shape<'a>,
}

pub(super) enum Shape<'a> {
    Disc(Disc),
    /// The whole polygon, to decide whether it contains a point, and those of its edges that are near.
    Polygon(&'a Polygon, Vec<Segment>),
}

/// The obstacles within `reach` of the box.
pub(super) fn near<'a>(obstacles: &'a [Obstacle], around: &Aabb, reach: f64) -> Vec<Near<'a>> {
    let is_near = |other: &Aabb| gap(around, other) <= reach;
    let mut found = Vec::new();
    for (index, obstacle) in obstacles.iter().enumerate() {
        if is_near(&obstacle.aabb()) {
            let shape = match obstacle {
                Obstacle::Disc(disc) => Shape::Disc(*disc),
                Obstacle::Polygon(polygon) => {
                    Shape::Polygon(polygon, polygon.edges().filter(|edge| is_near(&edge.aabb())).collect())
                }
            };
            found.push(Near { index, shape });
        }
    }
    found
}

impl Near<'_> {
    /// The distance from the segment to the obstacle, in metres; 0 inside.
    pub(super) fn distance(&self, s: &Segment) -> f64 {
        match &self.shape {
            Shape::Disc(disc) => distance_to_disc(s, disc),
            Shape::Polygon(polygon, _) if polygon.contains(s.a) => 0.0,
            Shape::Polygon(_, edges) => {
                edges.iter().map(|edge| distance_segment_segment(s, edge)).fold(f64::INFINITY, f64::min)
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

/// The distance from the segment to the whole obstacle, in metres; 0 inside.
pub(super) fn distance_segment_obstacle(s: &Segment, obstacle: &Obstacle) -> f64 {
    match obstacle {
        Obstacle::Disc(disc) => distance_to_disc(s, disc),
        Obstacle::Polygon(polygon) => distance_segment_polygon(s, polygon),
    }
}

fn distance_to_disc(s: &Segment, disc: &Disc) -> f64 {
    (distance_point_segment(disc.center, s) - disc.radius).max(0.0)
}
