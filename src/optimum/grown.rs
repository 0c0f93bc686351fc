//! The world as the centre of a disc sees it: obstacles that are larger by its radius.
//!
//! # Rounding
//! The infimum is the length of a path that touches obstacles, and between two obstacles that touch each other there is no way.
//! So all is computed for a disc that is larger by [`LARGER`] of the slack of a proof, and whatever comes nearer to an obstacle
//! by less than [`ROUNDING`] of that still counts as free. By the envelope theorem the length of a shortest path grows with the
//! radius of an arc at the rate of its angle, so with arcs measured at their true radius the error is of second order.

use super::circles::{Circle, angle_of, crossings_disc, crossings_line};
use crate::collision::{Obstacles, Tolerance, largest_coordinate};
use crate::error::{Code, Error, Number};
use crate::geometry::{Aabb, Disc, Point, Segment, Vector, orientation};
use crate::scenario::{Obstacle, World};
use std::f64::consts::TAU;
use std::sync::Arc;

/// How much larger the disc is, in slacks of a proof.
const LARGER: f64 = 1.0 / 16.0;

/// The part of it that covers rounding: some 70 units in the last place of the largest coordinate.
const ROUNDING: f64 = 0.25;

/// By how much less of a circle counts as covered at either end, in radians: what covers rounding.
const COVERED: f64 = 1e-9;

/// The world as the centre of the disc sees it.
pub(super) struct Grown {
    pub shapes: Arc<[Obstacle]>,
    obstacles: Obstacles,
    pub bounds: Aabb,
    radius: f64,
    /// How much larger than its radius the disc is, in metres.
    pub larger: f64,
}

impl Grown {
    /// The world for a disc of a radius, in metres. O(n log n).
    pub fn new(world: &World, bounds: Aabb, radius: f64) -> Self {
        let larger = larger(world, &bounds, radius);
        let shapes = Arc::clone(&world.obstacles);
        Self { obstacles: Obstacles::new(Arc::clone(&shapes)), shapes, bounds, radius, larger }
    }

    /// The radius of the disc with what it is larger.
    pub fn radius(&self) -> f64 {
        self.radius + self.larger
    }

    /// Less than any distance from an obstacle at which the centre is free.
    pub fn kept_out(&self) -> f64 {
        self.radius + (1.0 - 2.0 * ROUNDING) * self.larger
    }

    /// Refuses ends that are not free.
    ///
    /// # Errors
    /// `start-in-collision`, `goal-in-collision`.
    pub fn check(&self, [start, goal]: [Point; 2]) -> Result<(), Error> {
        for (what, at, code) in [("start", start, Code::StartInCollision), ("goal", goal, Code::GoalInCollision)] {
            if !self.is_free(&Segment::new(at, at)) {
                let [x, y] = [at.x, at.y].map(Number);
                let sentence = match self.radius {
                    0.0 => format!("the {what} [{x}, {y}] is in an obstacle, on its border, or outside the bounds"),
                    least => {
                        let least = Number(least);
                        format!("the {what} [{x}, {y}] is nearer to an obstacle or the bounds than {least} m")
                    }
                };
                return Err(Error::new(code, format!("/{what}"), sentence));
            }
        }
        Ok(())
    }

    /// Whether the centre may move along the segment. Bounds are convex: both ends within them suffice.
    pub fn is_free(&self, segment: &Segment) -> bool {
        let radius = self.radius();
        let rounding = ROUNDING * self.larger;
        let is_within = |p: Point| self.bounds.depth(p) >= self.radius - rounding;
        let touches = |i| self.obstacles.distance_within(i, segment, radius) < radius - rounding;
        is_within(segment.a) && is_within(segment.b) && !self.obstacles.any_near(&segment.aabb().grown(radius), touches)
    }

    /// The circles at the convex corners of all polygons, at all points of walls and around all discs.
    pub fn circles(&self) -> Vec<Circle> {
        let radius = self.radius();
        let mut circles = Vec::new();
        for shape in self.shapes.iter() {
            match shape {
                Obstacle::Disc(disc) => {
                    let disc = Disc { radius: disc.radius + radius, ..*disc };
                    circles.push(Circle { disc, normals: None });
                }
                Obstacle::Polygon(polygon) => circles.extend(corners(polygon.edges().collect(), radius)),
                Obstacle::PolygonWithHoles(polygon) => {
                    circles.extend(corners(polygon.outline().edges().collect(), radius));
                    // The polygon is on the other side of the border of a hole.
                    for hole in polygon.holes() {
                        let reversed = |edge: Segment| Segment::new(edge.b, edge.a);
                        let mut edges: Vec<Segment> = hole.edges().map(reversed).collect();
                        edges.reverse();
                        circles.extend(corners(edges, radius));
                    }
                }
                Obstacle::Wall(wall) => {
                    let radius = radius + wall.radius();
                    let circle = |&center: &Point| Circle { disc: Disc { center, radius }, normals: None };
                    circles.extend(wall.points().iter().map(circle));
                }
            }
        }
        circles
    }

    /// Intervals of angles at which a circle is not free, by corners, points of walls and discs within a reach of its centre
    /// along both axes.
    pub fn covered(&self, circle: &Disc, reach: f64) -> Vec<[f64; 2]> {
        let near = Disc { radius: reach, ..*circle }.aabb();
        let mut found = Vec::new();
        self.obstacles.any_near(&near, |i| {
            if let Obstacle::Disc(disc) = &self.shapes[i] {
                found.extend(covered_by(circle, &Disc { radius: disc.radius + self.kept_out(), ..*disc }));
            }
            let radius = self.kept_out() + self.shapes[i].edge_radius();
            self.shapes[i].any_edge_near(&near, |edge| {
                found.extend(
                    [edge.a, edge.b].into_iter().filter_map(|center| covered_by(circle, &Disc { center, radius })),
                );
                false
            });
            false
        });
        found
    }

    /// The angles at which a circle may become free or blocked, in any order.
    pub fn crossings(&self, circle: &Disc) -> Vec<f64> {
        let mut found = Vec::new();
        for (axis, sides) in [
            (Vector::x(), [self.bounds.min.x, self.bounds.max.x]),
            (Vector::y(), [self.bounds.min.y, self.bounds.max.y]),
        ] {
            let center = axis.dot(&circle.center.coords);
            crossings_line(circle, &axis, sides[0] + self.radius - center, &mut found);
            crossings_line(circle, &axis, sides[1] - self.radius - center, &mut found);
        }
        let radius = self.radius();
        let near = circle.aabb().grown(radius);
        self.obstacles.any_near(&near, |i| {
            match &self.shapes[i] {
                Obstacle::Disc(disc) => {
                    let disc = Disc { radius: disc.radius + radius, ..*disc };
                    crossings_disc(circle, &disc, &mut found);
                }
                shape => {
                    let beyond = shape.edge_radius();
                    shape.any_edge_near(&near.grown(beyond), |edge| {
                        crossings_edge(circle, edge, radius + beyond, &mut found);
                        false
                    });
                }
            }
            false
        });
        found
    }
}

/// How much larger a disc is taken, in metres.
pub(super) fn larger(world: &World, bounds: &Aabb, radius: f64) -> f64 {
    let largest = world.obstacles.iter().map(|obstacle| largest_coordinate(&obstacle.aabb()));
    LARGER * Tolerance::new(largest.fold(largest_coordinate(bounds), f64::max) + radius, 0.0).eta
}

/// The circles at the convex corners of a closed chain of edges, with the inside on their left.
fn corners(edges: Vec<Segment>, radius: f64) -> Vec<Circle> {
    let before = edges.iter().cycle().skip(edges.len() - 1);
    let corners = before.zip(&edges).filter(|(to, from)| orientation(to.a, from.a, from.b) > 0.0);
    let circle = |(to, from): (&Segment, &Segment)| Circle {
        disc: Disc { center: from.a, radius },
        normals: Some([to.normal(), from.normal()]),
    };
    corners.map(circle).collect()
}

/// The angles at which the circle is inside a disc: an interval that is a little less.
fn covered_by(circle: &Disc, disc: &Disc) -> Option<[f64; 2]> {
    let between = disc.center - circle.center;
    let distance = between.norm();
    let (r, s) = (circle.radius, disc.radius);
    if distance + r < s {
        return Some([0.0, TAU]);
    }
    let cos = ((r - s) * (r + s) + distance * distance) / (2.0 * r * distance);
    // Without a crossing, and with coincident centres, nothing is known.
    (cos.abs() < 1.0)
        .then(|| {
            let (middle, half) = (angle_of(&between), libm::acos(cos) - COVERED);
            [middle - half, middle + half]
        })
        .filter(|[from, to]| from < to)
}

/// The angles at which the circle may cross the border of all within a distance of an edge.
fn crossings_edge(circle: &Disc, edge: &Segment, radius: f64, found: &mut Vec<f64>) {
    crossings_disc(circle, &Disc { center: edge.a, radius }, found);
    crossings_disc(circle, &Disc { center: edge.b, radius }, found);
    let normal = edge.normal();
    // Relative to the centre, which may be the nearer end: then nothing is rounded.
    let [a, b] = [edge.a - circle.center, edge.b - circle.center];
    let height = normal.dot(if a.norm_squared() < b.norm_squared() { &a } else { &b });
    crossings_line(circle, &normal, height + radius, found);
    crossings_line(circle, &normal, height - radius, found);
}
