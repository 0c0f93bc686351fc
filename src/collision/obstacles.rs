//! The obstacles of a world, prepared for queries: boxes in front of exact shapes.

use super::boxes::Boxes;
use crate::geometry::{Aabb, Disc, Point, Polygon, Segment, Vector, intersects_segment_polygon};
use crate::scenario::Obstacle;
use std::sync::Arc;

/// Obstacles with their boxes, which only exclude obstacles that are certainly apart; they decide no distance.
#[derive(Clone)]
pub struct Obstacles {
    pub(super) shapes: Arc<[Obstacle]>,
    boxes: Vec<Aabb>,
    prepared: Boxes,
    /// The faces of all convex polygons, and the range of those of each obstacle.
    faces: Vec<Face>,
    ranges: Vec<(u32, u32)>,
}

/// One face of a convex polygon: its outward unit normal, the polygon's support in that direction, and the corner the face
/// starts from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Face {
    pub normal: Vector,
    pub support: f64,
    pub corner: Point,
}

impl Obstacles {
    /// Prepares the obstacles. O(n log n).
    pub fn new(shapes: impl Into<Arc<[Obstacle]>>) -> Self {
        let shapes = shapes.into();
        let boxes: Vec<Aabb> = shapes.iter().map(Obstacle::aabb).collect();
        let mut faces = Vec::new();
        let mut ranges = Vec::with_capacity(shapes.len());
        for shape in shapes.iter() {
            let first = faces.len() as u32;
            if let Obstacle::Polygon(polygon) = shape
                && polygon.is_convex()
            {
                faces.extend(faces_of(polygon));
            }
            ranges.push((first, faces.len() as u32));
        }
        Self { prepared: Boxes::new(&boxes), shapes, boxes, faces, ranges }
    }

    /// The faces of obstacle `i` if it is a convex polygon; else none.
    #[inline(always)]
    pub(super) fn faces(&self, i: usize) -> &[Face] {
        let (first, end) = self.ranges[i];
        &self.faces[first as usize..end as usize]
    }

    /// Obstacle `i` if it is a disc.
    pub(super) fn disc(&self, i: usize) -> Option<&Disc> {
        if let Obstacle::Disc(disc) = &self.shapes[i] { Some(disc) } else { None }
    }

    /// The number of obstacles.
    pub fn len(&self) -> usize {
        self.shapes.len()
    }

    /// Whether there are no obstacles.
    pub fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    /// Obstacle `i`.
    pub(crate) fn shape(&self, i: usize) -> &Obstacle {
        &self.shapes[i]
    }

    /// The box around obstacle `i`.
    pub fn aabb(&self, i: usize) -> &Aabb {
        &self.boxes[i]
    }

    /// Calls `visit` with the index of every obstacle whose box meets the given one, and rarely with one whose box only
    /// nearly touches it, until it returns true; returns whether it did. The order depends on the obstacles alone.
    #[inline(always)]
    pub fn any_near(&self, near: &Aabb, visit: impl FnMut(usize) -> bool) -> bool {
        self.prepared.any(near, visit)
    }

    /// The distance from the segment to obstacle `i`, in metres; 0 or less if they share a point.
    pub fn distance(&self, i: usize, segment: &Segment) -> f64 {
        self.shapes[i].distance_to_segment(segment)
    }

    /// The same; if it is `most` or more, that distance or infinity.
    pub fn distance_within(&self, i: usize, segment: &Segment, most: f64) -> f64 {
        self.shapes[i].distance_to_segment_within(segment, most)
    }

    /// Whether a point that moves along the segment touches obstacle `i`: exact for polygons; within the slack `eta` for
    /// discs, whose boundary no double can hit exactly.
    pub fn touches_point(&self, i: usize, segment: &Segment, eta: f64) -> bool {
        match &self.shapes[i] {
            Obstacle::Disc(_) => self.distance(i, segment) <= eta,
            Obstacle::Polygon(polygon) => intersects_segment_polygon(segment, polygon),
        }
    }

    /// The distance from the placed body to obstacle `i`, in metres; 0 or less if they share a point; if it is `most`
    /// or more, that distance or infinity.
    pub(super) fn distance_from(&self, body: &Polygon, i: usize, most: f64) -> f64 {
        self.shapes[i].distance_to_polygon_within(body, most)
    }

    /// The distance from the segment to the nearest obstacle, in metres; infinite without obstacles. O(n).
    pub fn clearance(&self, segment: &Segment) -> f64 {
        (0..self.len()).fold(f64::INFINITY, |least, i| least.min(self.distance_within(i, segment, least)))
    }

    /// The largest coordinate of any obstacle, in metres; 0 without obstacles.
    pub fn largest_coordinate(&self) -> f64 {
        self.boxes.iter().map(largest_coordinate).fold(0.0, f64::max)
    }
}

/// The largest coordinate of the box, in metres.
pub(crate) fn largest_coordinate(aabb: &Aabb) -> f64 {
    let of = |p: Point| p.x.abs().max(p.y.abs());
    of(aabb.min).max(of(aabb.max))
}

/// The least depth of the points within the bounds, in metres: negative if one is outside.
pub(super) fn depth(bounds: &Aabb, points: &[Point]) -> f64 {
    points.iter().map(|&p| bounds.depth(p)).fold(f64::INFINITY, f64::min)
}

/// The faces of a convex polygon. The support is the largest over all corners, so that no corner
/// is outside by the rounding of the normal.
pub(super) fn faces_of(polygon: &Polygon) -> impl Iterator<Item = Face> {
    polygon.edges().map(|edge| {
        // Scaled first: the squares of a very short edge would underflow, and its normal would not be of unit length.
        let edge_vector = edge.b - edge.a;
        let along = (edge_vector / edge_vector.amax()).normalize();
        let normal = Vector::new(along.y, -along.x);
        Face { normal, support: polygon.support(normal), corner: edge.a }
    })
}
