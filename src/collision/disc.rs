//! Collision of a translating disc: a point by exact predicates, a disc by one distance a motion and obstacle. No motion
//! is left unproven: [`HALVINGS`] + 1 such tests an obstacle find a first hit.

use super::obstacles::largest_coordinate;
use super::{CollisionWorld, KeepAway, Obstacles, Tolerance, blend};
use crate::geometry::{Aabb, Point, Segment, Vector};
use crate::problem::{Contact, Touched, Validity};
use crate::robot::DiscRobot;
use std::cell::Cell;
use std::sync::Arc;

/// The number of halvings of a motion to find its first hit: to 2^-40 of its length.
const HALVINGS: u32 = 40;

/// The part of its coordinates by which the strip about a segment is wider, for rounding.
const ROUNDING: f64 = 1e-14;

/// The collision checker of a disc.
pub struct DiscValidity {
    /// With the margin.
    radius: f64,
    obstacles: Arc<Obstacles>,
    bounds: Option<Aabb>,
    tolerance: Tolerance,
    /// `None` if motions cost no more than their length.
    keep_away: Option<KeepAway>,
    evaluations: Cell<u64>,
}

impl DiscValidity {
    /// The disc in the world.
    pub fn new(robot: &DiscRobot, world: impl Into<CollisionWorld>) -> Self {
        let world = world.into();
        let obstacles = world.obstacles();
        let bounds = world.bounds().map_or(0.0, largest_coordinate);
        let scale = obstacles.largest_coordinate().max(bounds) + robot.kept_radius();
        let tolerance = Tolerance::new(scale, 0.0);
        Self {
            radius: robot.kept_radius(),
            obstacles,
            bounds: world.bounds().copied(),
            tolerance,
            keep_away: None,
            evaluations: Cell::new(0),
        }
    }

    /// The same, whose motions cost more near obstacles.
    #[must_use]
    pub(crate) fn keeping_away(self, keep_away: Option<KeepAway>) -> Self {
        Self { keep_away, ..self }
    }

    /// The clearance of the disc at a point; `most` or more if it is no smaller than that.
    fn clearance(&self, center: Point, most: f64) -> f64 {
        let (at, reach) = (Segment::new(center, center), self.radius + most);
        let mut least = reach;
        self.obstacles.any_near(&at.aabb().grown(reach), |i| {
            self.evaluations.set(self.evaluations.get() + 1);
            least = least.min(self.obstacles.distance_within(i, &at, least));
            false
        });
        if least < reach { least - self.radius } else { most }
    }

    /// The slack of its tests, with the finest tolerance.
    pub fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    /// Whether the disc may touch something in one of the boxes on the motion from `a` to `b`.
    pub fn may_meet(&self, a: &[f64], b: &[f64], boxes: &[Aabb]) -> bool {
        let near = self.near(&segment(a, b), self.radius);
        boxes.iter().any(|one| one.intersects(&near))
    }

    /// Whether a disc of this radius touches obstacle `i` while its centre moves along the segment.
    fn touches(&self, i: usize, swept: &Segment, radius: f64) -> bool {
        if radius == 0.0 {
            self.obstacles.touches_point(i, swept, self.tolerance.eta)
        } else {
            self.obstacles.distance_within(i, swept, radius + 2.0 * self.tolerance.eta) - radius <= self.tolerance.eta
        }
    }

    /// A box outside which nothing touches the disc while its centre moves along the segment.
    fn near(&self, swept: &Segment, radius: f64) -> Aabb {
        swept.aabb().grown(radius + self.tolerance.eta)
    }

    /// Whether the disc lies within the bounds, or touches them from within.
    fn is_inside(&self, center: Point) -> bool {
        let eta = if self.radius == 0.0 { 0.0 } else { self.tolerance.eta };
        self.bounds.as_ref().is_none_or(|bounds| bounds.depth(center) - self.radius >= -eta)
    }

    /// Whether the disc stays free while its centre moves along the segment. Bounds are convex: both ends inside suffice.
    fn is_swept_free(&self, swept: &Segment) -> bool {
        self.is_inside(swept.a) && self.is_inside(swept.b) && self.is_clear(swept, self.radius)
    }

    /// Whether a disc of this radius touches no obstacle while its centre moves along the segment.
    fn is_clear(&self, swept: &Segment, radius: f64) -> bool {
        let mut evaluations = self.evaluations.get();
        let strip = Strip::around(swept, radius + 2.0 * self.tolerance.eta);
        let touches = self.obstacles.any_near(&self.near(swept, radius), |i| {
            // Boxes beside the strip count as well.
            evaluations += 1;
            !strip.is_beside(self.obstacles.aabb(i)) && self.touches(i, swept, radius)
        });
        self.evaluations.set(evaluations);
        !touches
    }
}

/// All within a distance of the line through a segment: most boxes that meet the box around a long motion are beside it.
struct Strip {
    /// The unit normal; not a number if the segment is a point.
    normal: Vector,
    /// Twice the scalar product of the normal and a point of the line.
    middle: f64,
    /// Twice the distance.
    width: f64,
}

impl Strip {
    /// The strip about the segment. The distance covers rounding in boxes. O(1).
    fn around(segment: &Segment, distance: f64) -> Self {
        let (normal, Segment { a, b }) = (segment.normal(), segment);
        let rounding = ROUNDING * (a.x.abs() + a.y.abs() + b.x.abs() + b.y.abs());
        Self { normal, middle: 2.0 * normal.dot(&a.coords), width: 2.0 * (distance + rounding) }
    }

    /// Whether all of the box is certainly outside. No box is beside a point, nor where numbers are not finite.
    fn is_beside(&self, Aabb { min, max }: &Aabb) -> bool {
        let Self { normal, middle, width } = self;
        let off = (normal.x * (min.x + max.x) + normal.y * (min.y + max.y) - middle).abs();
        let beyond = off - (normal.x.abs() * (max.x - min.x) + normal.y.abs() * (max.y - min.y));
        beyond > *width && beyond.is_finite()
    }
}

/// The segment between two configurations.
fn segment(a: &[f64], b: &[f64]) -> Segment {
    Segment::new(Point::new(a[0], a[1]), Point::new(b[0], b[1]))
}

/// The configuration a fraction `t` along the motion; exactly `b` at 1.
fn between(a: &[f64], b: &[f64], t: f64) -> [f64; 2] {
    if t == 1.0 { [b[0], b[1]] } else { [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])] }
}

/// States are padded to any number of coordinates; the first two are the centre's.
impl<const N: usize> Validity<[f64; N]> for DiscValidity {
    fn is_free(&self, q: &[f64; N]) -> bool {
        self.is_swept_free(&segment(q, q))
    }

    fn is_motion_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        self.is_swept_free(&segment(a, b))
    }

    fn first_hit(&self, a: &[f64; N], b: &[f64; N]) -> Option<f64> {
        if self.is_motion_free(a, b) {
            return None;
        }
        let (mut free, mut hit) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (free + hit);
            if self.is_swept_free(&segment(a, &between(a, b, middle))) {
                free = middle;
            } else {
                hit = middle;
            }
        }
        Some(free)
    }

    /// Bounds are convex: a blend is inside if its control points are.
    fn is_blend_free(&self, [from, corner, to]: &[[f64; N]; 3]) -> bool {
        let [before, after] = [from, to].map(|end| std::array::from_fn(|i| end[i] - corner[i]));
        [from, corner, to].iter().all(|q| self.is_inside(Point::new(q[0], q[1])))
            && blend::is_free(corner, &before, &after, |from, delta, aside| {
                let end = std::array::from_fn::<f64, N, _>(|i| from[i] + delta[i]);
                let off = Point::new(aside[0], aside[1]).coords.norm();
                self.is_clear(&segment(from, &end), self.radius + off)
            })
    }

    fn contacts(&self, q: &[f64; N]) -> Vec<Contact> {
        let (at, near) = (segment(q, q), self.near(&segment(q, q), self.radius));
        let obstacles = (0..self.obstacles.len()).filter(|&i| self.obstacles.aabb(i).intersects(&near));
        let touched = obstacles.filter(|&i| self.touches(i, &at, self.radius)).map(Touched::Obstacle);
        let leaves = (!self.is_inside(at.a)).then_some(Touched::Bounds);
        touched.chain(leaves).map(|with| Contact { part: 0, with }).collect()
    }

    fn part_name(&self, _part: usize) -> String {
        "the disc".into()
    }

    fn nearness_cost(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        let added = |keep: &KeepAway| keep.added(&segment(a, b), |point, most| self.clearance(point, most));
        self.keep_away.as_ref().map_or(0.0, added)
    }

    fn clearance_evaluations(&self) -> u64 {
        self.evaluations.get()
    }
}
