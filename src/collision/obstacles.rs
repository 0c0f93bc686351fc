//! The obstacles of a world, prepared for queries: boxes in front of exact shapes.

use crate::geometry::{Aabb, Boxes, Disc, Point, Polygon, Segment, Vector};
use crate::scenario::Obstacle;
use std::sync::Arc;

/// The most corners of a convex piece: all sides of two pieces are tried to separate them.
pub(super) const MOST_CORNERS: usize = 24;

/// Obstacles with their boxes, which only exclude obstacles that are certainly apart; they decide no distance.
#[derive(Clone)]
pub struct Obstacles {
    pub(super) shapes: Arc<[Obstacle]>,
    boxes: Vec<Aabb>,
    prepared: Boxes,
    /// The faces of all small convex cores, those of each obstacle in its range.
    faces: Vec<Face>,
    cores: Vec<Core>,
    /// Whether an obstacle is a polygon with holes.
    has_holes: bool,
}

/// The convex core of an obstacle: a convex polygon, or the segment of a wall that has only one.
#[derive(Debug, Clone, Copy)]
struct Core {
    /// The range of its faces: those of a segment are its two sides.
    first: u32,
    end: u32,
    /// All within this distance of the core is the obstacle, in metres.
    radius: f64,
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
        let mut cores = Vec::with_capacity(shapes.len());
        for shape in shapes.iter() {
            let (first, mut radius) = (faces.len() as u32, 0.0);
            match shape {
                Obstacle::Polygon(polygon) if polygon.is_convex() && polygon.vertices().len() <= MOST_CORNERS => {
                    faces.extend(faces_of(polygon));
                }
                Obstacle::Wall(wall) if wall.points().len() == 2 => {
                    radius = wall.radius();
                    faces.extend(sides_of(wall.points()));
                }
                _ => {}
            }
            cores.push(Core { first, end: faces.len() as u32, radius });
        }
        let has_holes = shapes.iter().any(|shape| matches!(shape, Obstacle::PolygonWithHoles(_)));
        Self { prepared: Boxes::new(&boxes), shapes, boxes, faces, cores, has_holes }
    }

    /// The faces of the core of obstacle `i` if it is a convex polygon of at most [`MOST_CORNERS`] or a wall of one segment;
    /// else none.
    #[inline(always)]
    pub(super) fn faces(&self, i: usize) -> &[Face] {
        let Core { first, end, .. } = self.cores[i];
        &self.faces[first as usize..end as usize]
    }

    /// How far a wall of one segment, obstacle `i`, reaches beyond its core; 0 for any other.
    #[inline(always)]
    pub(super) fn radius(&self, i: usize) -> f64 {
        self.cores[i].radius
    }

    /// Whether an obstacle is a polygon with holes.
    #[inline(always)]
    pub(super) fn has_holes(&self) -> bool {
        self.has_holes
    }

    /// Whether the point lies in a polygon with holes, not in one of these.
    pub(super) fn is_in_polygon_with_holes(&self, p: Point) -> bool {
        let contains = |i: usize| matches!(&self.shapes[i], Obstacle::PolygonWithHoles(polygon) if polygon.contains(p));
        self.any_near(&Aabb { min: p, max: p }, contains)
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

    /// Whether a point that moves along the segment touches obstacle `i`: exact for polygons and for walls without width;
    /// within the slack `eta` for discs and other walls, whose boundary no double can hit exactly.
    pub fn touches_point(&self, i: usize, segment: &Segment, eta: f64) -> bool {
        self.shapes[i].meets_segment(segment).unwrap_or_else(|| self.distance(i, segment) <= eta)
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
        let normal = edge.normal();
        Face { normal, support: polygon.support(normal), corner: edge.a }
    })
}

/// Both sides of a segment: without an inside, it is a polygon of two corners.
fn sides_of(ends: &[Point]) -> impl Iterator<Item = Face> {
    let edge = Segment::new(ends[0], ends[1]);
    [edge, Segment::new(edge.b, edge.a)].into_iter().map(move |side| {
        let normal = side.normal();
        let support = normal.dot(&edge.a.coords).max(normal.dot(&edge.b.coords));
        Face { normal, support, corner: side.a }
    })
}
