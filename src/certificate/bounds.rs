//! Bounds on the clearance of a robot over a cell.
//!
//! **From above.** A point p of the robot stays within the hull of its places at the four corners of the cell, grown by a bulge:
//! half the square of half a side times the greatest second derivative of p, summed over both coordinates (the error of bilinear
//! interpolation). The signed distance from a convex obstacle (negative inside: the depth below the border) is a convex function,
//! so it is greatest at one of the four places, but for the bulge. That bounds the clearance for each p; the least over a link is
//! searched for. A concave obstacle is tried piece by piece, and as a whole by the signed distance at the centre of the cell plus
//! the farthest that p is from there.
//!
//! **From below.** By the distance of a link from an obstacle at the centre of the cell, less the farthest that any of its points
//! is from its place there: a turn by d moves p by 2 sin(d / 2) times its distance from the joint, a prismatic joint that slides
//! by d moves it by d, or on the sliding link itself by the fraction of d at which p lies. The places change linearly with d.

use super::cell::{Cell, Square};
use crate::collision::{Obstacles, Tolerance, largest_coordinate};
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Point, Segment, Vector, convex_pieces, signed_distance_point_polygon, sort_numbers};
use crate::problem::Touched;
use crate::robot::Arm;
use crate::scenario::{Obstacle, Robot};
use crate::world::{Configurations, PlanningWorld};
use std::f64::consts::PI;
use std::sync::Arc;

/// How many parts of a link have their ends tried at first, and how often the range about the best of these points is halved.
const PARTS: u32 = 8;
const HALVINGS: u32 = 12;

/// Why the clearance is bounded from above at every configuration of a cell: a point of the robot stays near an obstacle, or
/// outside the bounds of the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Witness {
    pub part: usize,
    /// Where the point is on the axis of the part, from 0 to 1.
    pub along: f64,
    pub with: Touched,
}

/// Bounds on the clearance over a cell, in metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    /// The clearance is nowhere less; negative infinity if the robot may leave the bounds of the world.
    pub least: f64,
    /// The clearance is nowhere greater; negative infinity if the robot is not within the bounds of the world anywhere.
    pub most: f64,
    /// Why it is nowhere greater; `None` if `most` is positive infinity.
    pub witness: Option<Witness>,
}

/// A part of the robot in a cell.
struct Part {
    /// Its axis at the centre and at the corners of the cell.
    axis: Segment,
    corners: [Segment; 4],
    /// A point is no farther from its place at the centre than the sum of a constant, of a factor of its distance from the base
    /// there, and of one of the fraction of it along the axis.
    shift: f64,
    turn: f64,
    swing: f64,
    /// The bulge is the sum of a factor of the greatest distance from the base, and of one of the fraction along the axis.
    bulges: [f64; 2],
}

/// A robot whose configurations have two coordinates, in its world.
pub(super) struct Clearances {
    /// `None` for a disc.
    arm: Option<Arm>,
    radius: f64,
    obstacles: Arc<Obstacles>,
    /// The convex pieces of each obstacle, or of its border; `None` if it is convex itself.
    pieces: Vec<Option<Obstacles>>,
    bounds: Option<Aabb>,
    pub square: Square,
    /// The slack: it covers rounding, and an obstacle nearer than this is touched.
    pub eta: f64,
}

impl Clearances {
    /// # Errors
    /// `unsupported` if a configuration of the robot does not have two coordinates.
    pub fn new(world: &PlanningWorld) -> Result<Self, Error> {
        let (arm, radius, square) = match world.robot() {
            Robot::Arm(arm) if arm.links().len() == 2 => {
                let configurations = Configurations::of(world);
                let space = configurations.space();
                let ends = |end: usize| [0, 1].map(|joint| space.range(joint)[end]);
                let wraps = [0, 1].map(|joint| space.is_circle(joint));
                (Some(arm.clone()), arm.kept_radius(), Square { low: ends(0), high: ends(1), wraps })
            }
            Robot::Disc(disc) => {
                // The centre keeps the radius away from the bounds.
                let inside = world.bounds().grown(-disc.kept_radius());
                // In a world as wide as the disc the range is a point, and rounding may exchange its ends.
                let ends = [[inside.min.x, inside.max.x], [inside.min.y, inside.max.y]];
                let (low, high) = (ends.map(|[a, b]| a.min(b)), ends.map(|[a, b]| a.max(b)));
                (None, disc.kept_radius(), Square { low, high, wraps: [false; 2] })
            }
            robot => {
                let (kind, dimension) = (robot.kind(), robot.dimension());
                let sentence = format!(
                    "certificates are for an arm of two links and for a disc, not for a robot of type {kind} with {dimension} coordinates"
                );
                return Err(Error::new(Code::Unsupported, "/robot", sentence));
            }
        };
        let obstacles = world.collision().obstacles();
        let bounds = world.scenario().world().bounds;
        let base = arm.as_ref().map(|arm| Aabb::of(arm.base(), arm.base()));
        let boxes = bounds.iter().chain(&base).map(largest_coordinate);
        let reach = radius + arm.as_ref().map_or(0.0, Arm::reach);
        let eta = Tolerance::new(boxes.fold(obstacles.largest_coordinate(), f64::max) + reach, 0.0).eta;
        let pieces = (0..obstacles.len()).map(|i| pieces_of(obstacles.shape(i))).collect();
        // The square of a disc has the bounds in it.
        let bounds = bounds.filter(|_| arm.is_some());
        Ok(Self { arm, radius, obstacles, pieces, bounds, square, eta })
    }

    /// Bounds over the cell. Obstacles farther than `near` metres from the robot all over the cell do not count.
    pub fn over(&self, cell: &Cell, near: f64) -> Bounds {
        let mut bounds = Bounds { least: f64::INFINITY, most: f64::INFINITY, witness: None };
        for (i, part) in self.parts(cell).iter().enumerate() {
            // A sum of convex functions is greatest at an end.
            let travel = self.travel(part, 0.0).max(self.travel(part, 1.0));
            if self.depth(part, f64::max) + self.bulge(part, 1.0) < -self.eta {
                let witness = Some(Witness { part: i, along: 1.0, with: Touched::Bounds });
                return Bounds { least: f64::NEG_INFINITY, most: f64::NEG_INFINITY, witness };
            }
            // Contact with the bounds is allowed.
            if self.depth(part, f64::min) - self.bulge(part, 1.0) < -0.5 * self.eta {
                bounds.least = f64::NEG_INFINITY;
            }
            let around = part.axis.aabb().grown(self.radius + travel + near + self.eta);
            self.obstacles.any_near(&around, |obstacle| {
                let distance = self.obstacles.distance(obstacle, &part.axis) - self.radius;
                bounds.least = bounds.least.min(distance - travel);
                if distance < bounds.most {
                    let (along, most) = self.nearest(part, obstacle);
                    if most < bounds.most {
                        bounds.most = most;
                        bounds.witness = Some(Witness { part: i, along, with: Touched::Obstacle(obstacle) });
                    }
                }
                false
            });
        }
        bounds
    }

    /// The parts of the robot in a cell.
    fn parts(&self, cell: &Cell) -> Vec<Part> {
        let [center, half] = self.square.place(cell);
        let at = |[x, y]: [f64; 2]| [center[0] + x * half[0], center[1] + y * half[1]];
        let corners = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]].map(at);
        let Some(arm) = &self.arm else {
            let point = |[x, y]: [f64; 2]| Segment::new(Point::new(x, y), Point::new(x, y));
            let shift = Vector::from(half).norm();
            let corners = corners.map(point);
            return vec![Part { axis: point(center), corners, shift, turn: 0.0, swing: 0.0, bulges: [0.0; 2] }];
        };
        let (joints, corners) = (arm.joints(&center), corners.map(|q| arm.joints(&q)));
        let turns = half.map(|half| 2.0 * libm::sin(0.5 * half.min(PI)));
        let bulges = half.map(|half| 0.5 * half * half);
        let slides = [0, 1].map(|i: usize| arm.joint_types()[i].is_prismatic());
        let part = |link: usize| {
            let axis = |joints: &[Point]| Segment::new(joints[link], joints[link + 1]);
            let mut part = Part {
                axis: axis(&joints),
                corners: corners.map(|joints| axis(&joints)),
                shift: 0.0,
                turn: 0.0,
                swing: 0.0,
                bulges: [0.0; 2],
            };
            // The first joint turns all about the base, or shifts the second link.
            match (slides[0], link) {
                (false, _) => (part.turn, part.bulges[0]) = (turns[0], bulges[0]),
                (true, 0) => part.swing = half[0],
                (true, _) => part.shift = half[0],
            }
            // The first link has no motion of its own beside that.
            if link == 1 {
                let own = arm.links()[1];
                (part.swing, part.bulges[1]) =
                    if slides[1] { (half[1], 0.0) } else { (own * turns[1], own * bulges[1]) };
            }
            part
        };
        vec![part(0), part(1)]
    }

    /// The farthest that a point of the part is from its place at the centre.
    fn travel(&self, part: &Part, along: f64) -> f64 {
        part.shift + part.turn * self.base_distance(part, along) + part.swing * along
    }

    /// How far a point of the part can leave the hull of its places at the corners.
    fn bulge(&self, part: &Part, along: f64) -> f64 {
        part.bulges[0] * (self.base_distance(part, along) + part.swing * along) + part.bulges[1] * along
    }

    /// The distance of a point of the part from the base, at the centre.
    fn base_distance(&self, part: &Part, along: f64) -> f64 {
        self.arm.as_ref().map_or(0.0, |arm| (point(&part.axis, along) - arm.base()).norm())
    }

    /// How deep the outer end of the part is within the bounds at all corners of the cell, by the side of the bounds that it is
    /// least deep within: at the corner where it is least deep, or deepest, by the function. Elsewhere in the cell it differs by
    /// the bulge at most.
    fn depth(&self, part: &Part, of_two: fn(f64, f64) -> f64) -> f64 {
        let Some(Aabb { min, max }) = &self.bounds else { return f64::INFINITY };
        let sides: [&dyn Fn(Point) -> f64; 4] =
            [&|p| p.x - min.x, &|p| max.x - p.x, &|p| p.y - min.y, &|p| max.y - p.y];
        let depth = |side: &&dyn Fn(Point) -> f64| {
            part.corners.iter().map(|axis| side(axis.b)).reduce(of_two).unwrap_or(f64::INFINITY)
        };
        sides.iter().map(depth).fold(f64::INFINITY, f64::min) - self.radius
    }

    /// The point of the part that stays nearest to an obstacle all over the cell, as a fraction of the axis, and a bound on its
    /// distance less the radius; for a concave obstacle a point that is not always the nearest.
    fn nearest(&self, part: &Part, obstacle: usize) -> (f64, f64) {
        let by_corners = |along: f64, shape: &Obstacle| {
            let distances = part.corners.iter().map(|axis| signed_distance(point(axis, along), shape));
            distances.fold(f64::NEG_INFINITY, f64::max) + self.bulge(part, along) - self.radius
        };
        let by_center = |along: f64, shape: &Obstacle| {
            signed_distance(point(&part.axis, along), shape) + self.travel(part, along) - self.radius
        };
        let (shape, is_disc) = (self.obstacles.shape(obstacle), self.arm.is_none());
        let Some(pieces) = &self.pieces[obstacle] else {
            return least(is_disc, |along| by_corners(along, shape));
        };
        let mut best = least(is_disc, |along| by_center(along, shape));
        // A bound by a piece is no less than the distance of any corner's axis from its box.
        let around = part.corners.map(|axis| axis.aabb());
        let reach = |best: f64| (best + self.radius).max(0.0) + self.eta;
        let mut near = Vec::new();
        pieces.any_near(&around[0].grown(reach(best.1)), |piece| {
            near.push(piece as u32);
            false
        });
        sort_numbers(&mut near, &|i, j| i.cmp(&j));
        for piece in near.into_iter().map(|piece| piece as usize) {
            let is_near = |axis: &Aabb| axis.gap_squared(pieces.aabb(piece)) <= reach(best.1) * reach(best.1);
            if around.iter().all(is_near) {
                let found = least(is_disc, |along| by_corners(along, pieces.shape(piece)));
                best = if found.1 < best.1 { found } else { best };
            }
        }
        best
    }
}

/// Convex shapes that cover the obstacle, or of a polygon with holes its border; `None` if it is convex itself.
fn pieces_of(obstacle: &Obstacle) -> Option<Obstacles> {
    match obstacle {
        Obstacle::Polygon(polygon) if !polygon.is_convex() => {
            let pieces: Vec<Obstacle> = convex_pieces(polygon).into_iter().map(Obstacle::Polygon).collect();
            Some(Obstacles::new(pieces))
        }
        Obstacle::PolygonWithHoles(polygon) => {
            Some(Obstacles::new(polygon.border().map(Obstacle::Wall).collect::<Vec<_>>()))
        }
        Obstacle::Wall(wall) if wall.points().len() > 2 => {
            Some(Obstacles::new(wall.pieces().map(Obstacle::Wall).collect::<Vec<_>>()))
        }
        Obstacle::Disc(_) | Obstacle::Polygon(_) | Obstacle::Wall(_) => None,
    }
}

/// The point at a fraction of the axis.
fn point(axis: &Segment, along: f64) -> Point {
    axis.a + (axis.b - axis.a) * along
}

/// Where in [0, 1] a function is least, and its value there: nearly for a convex one. At 0 if the function is constant.
fn least(is_constant: bool, value: impl Fn(f64) -> f64) -> (f64, f64) {
    let mut best = (0.0, value(0.0));
    let try_at = |along: f64, best: &mut (f64, f64)| {
        let found = (along, value(along));
        if (0.0..=1.0).contains(&along) && found.1 < best.1 {
            *best = found;
        }
    };
    if is_constant {
        return best;
    }
    let mut width = 1.0 / f64::from(PARTS);
    (1..=PARTS).for_each(|k| try_at(width * f64::from(k), &mut best));
    for _ in 0..HALVINGS {
        width *= 0.5;
        let middle = best.0;
        try_at(middle - width, &mut best);
        try_at(middle + width, &mut best);
    }
    best
}

/// The distance of a point from an obstacle; inside it, the depth below its border as a negative number.
fn signed_distance(p: Point, obstacle: &Obstacle) -> f64 {
    match obstacle {
        Obstacle::Disc(disc) => (p - disc.center).norm() - disc.radius,
        Obstacle::Polygon(polygon) => signed_distance_point_polygon(p, polygon),
        Obstacle::PolygonWithHoles(polygon) => polygon.signed_distance_to_point(p),
        Obstacle::Wall(wall) => wall.distance_to_segment(&Segment::new(p, p), f64::INFINITY),
    }
}
