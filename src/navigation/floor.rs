//! The floor of a task, prepared for driving: which arcs are free, and what rays meet.

use super::navigator::Navigator;
use super::outcome::Outcome;
use super::sensor::{Fan, Sensor};
use crate::collision::{BodyCollision, BodyMotion, CollisionWorld, Obstacles, largest_coordinate};
use crate::error::{Code, Error};
use crate::geometry::{Aabb, Disc, Point, Segment, Vector, distance_point_segment, distance_segment_segment};
use crate::problem::naming_nearest;
use crate::robot::{Cargo, CargoState, Footprint, Round, plane};
use crate::scenario::Obstacle;
use crate::space::{ProductSpace, Space};
use std::cell::RefCell;
use std::sync::Arc;

/// The slack of proofs, as a fraction of the largest coordinate plus the reach.
const SLACK: f64 = 1e-12;

/// An arc whose clearance is too small to be proven is halved until its half is shorter than this, in metres; then it is a
/// collision.
const SHORTEST: f64 = 1e-4;

/// The most clearances that the proof of one arc of a disc computes; an arc that needs more is a collision.
const BUDGET: u32 = 10_000;

/// The wanted tolerance of the proofs of a polygon, as a fraction of the longer side of the bounds.
const TOLERANCE: f64 = 1e-5;

/// Of a world: obstacles and bounds, and the robot's shape among them.
pub(super) struct Floor {
    obstacles: Arc<Obstacles>,
    bounds: Aabb,
    /// The radius in which the robot turns on the spot.
    reach: f64,
    slack: f64,
    shape: Shape,
    near: RefCell<Near>,
}

#[allow(clippy::large_enum_variant, reason = "there is one per floor")]
enum Shape {
    Disc,
    Polygon(BodyCollision),
}

/// The edges, discs and segments of walls that may be near the robot, gathered again for each time step.
#[derive(Default)]
struct Near {
    /// What is on their left is obstacle.
    edges: Vec<Segment>,
    discs: Vec<Disc>,
    /// With half their width.
    walls: Vec<(Segment, f64)>,
}

impl Near {
    fn gather(&mut self, obstacles: &Obstacles, around: &Aabb) {
        self.edges.clear();
        self.discs.clear();
        self.walls.clear();
        obstacles.any_near(around, |i| {
            match obstacles.shape(i) {
                Obstacle::Disc(disc) => self.discs.push(*disc),
                Obstacle::Polygon(polygon) => {
                    polygon.any_edge_near(around, |_, edge| {
                        self.edges.push(*edge);
                        false
                    });
                }
                Obstacle::PolygonWithHoles(polygon) => {
                    for (k, ring) in polygon.rings().enumerate() {
                        ring.any_edge_near(around, |_, edge| {
                            self.edges.push(if k == 0 { *edge } else { Segment::new(edge.b, edge.a) });
                            false
                        });
                    }
                }
                Obstacle::Wall(wall) => {
                    wall.any_segment_near(&around.grown(wall.radius()), |segment| {
                        self.walls.push((*segment, wall.radius()));
                        false
                    });
                }
            }
            false
        });
    }

    /// The distance from a point outside all obstacles to the nearest one.
    fn distance(&self, p: Point) -> f64 {
        let edges = self.edges.iter().map(|edge| distance_point_segment(p, edge));
        let discs = self.discs.iter().map(|disc| (p - disc.center).norm() - disc.radius);
        let walls = self.walls.iter().map(|(segment, radius)| distance_point_segment(p, segment) - radius);
        edges.chain(discs).chain(walls).fold(f64::INFINITY, f64::min)
    }

    /// The distance from a segment, of which a point is outside all obstacles, to the nearest one; 0 or less if it meets one.
    fn distance_from(&self, s: &Segment) -> f64 {
        let edges = self.edges.iter().map(|edge| distance_segment_segment(s, edge));
        let discs = self.discs.iter().map(|disc| distance_point_segment(disc.center, s) - disc.radius);
        let walls = self.walls.iter().map(|(segment, radius)| distance_segment_segment(s, segment) - radius);
        edges.chain(discs).chain(walls).fold(f64::INFINITY, f64::min)
    }

    /// The distance along a ray, of unit direction, to the first edge, disc or wall that it meets; `range` if it meets none
    /// before.
    fn cast(&self, from: Point, direction: Vector, range: f64) -> f64 {
        let mut least = range;
        let edge = |least: f64, edge: &Segment| {
            let (along, to) = (edge.b - edge.a, edge.a - from);
            let cross = direction.perp(&along);
            // With a positive cross product the ray leaves what is on the left.
            if cross >= 0.0 {
                return least;
            }
            let (t, s) = (to.perp(&along) / cross, to.perp(&direction) / cross);
            if t >= 0.0 && t < least && (0.0..=1.0).contains(&s) { t } else { least }
        };
        let disc = |least: f64, center: Point, radius: f64| {
            let to = center - from;
            let (middle, off) = (to.dot(&direction), to.perp(&direction));
            let squared = radius * radius - off * off;
            if squared >= 0.0 && middle >= 0.0 { least.min((middle - squared.sqrt()).max(0.0)) } else { least }
        };
        for one in &self.edges {
            least = edge(least, one);
        }
        for one in &self.discs {
            least = disc(least, one.center, one.radius);
        }
        for &(Segment { a, b }, radius) in &self.walls {
            let aside = radius * Segment::new(a, b).normal();
            least = edge(least, &Segment::new(a + aside, b + aside));
            least = edge(least, &Segment::new(b - aside, a - aside));
            if radius > 0.0 {
                least = disc(disc(least, a, radius), b, radius);
            }
        }
        least
    }
}

impl Floor {
    /// Prepares a robot in a world with these bounds.
    pub(super) fn new(bounds: &Aabb, world: &CollisionWorld, robot: &Navigator) -> Self {
        let (obstacles, bounds) = (world.obstacles(), *bounds);
        let reach = robot.reach();
        let slack = SLACK * (obstacles.largest_coordinate().max(largest_coordinate(&bounds)) + reach);
        let shape = match robot {
            Navigator::DifferentialDrive(robot) => match robot.drive.shape() {
                Footprint::Disc(Round { .. }) => Shape::Disc,
                Footprint::Polygon(polygon) => Shape::Polygon(BodyCollision::new(polygon, world.clone(), TOLERANCE)),
            },
            Navigator::Cargo(_) => Shape::Disc,
        };
        Self { obstacles, bounds, reach, slack, shape, near: RefCell::default() }
    }

    /// The bounds of the floor.
    pub(super) fn bounds(&self) -> &Aabb {
        &self.bounds
    }

    /// The distance from a position to the nearest obstacle or to the bounds, in metres; 0 or less inside one or outside the
    /// bounds.
    pub(super) fn distance(&self, p: Point) -> f64 {
        self.obstacles.clearance(&Segment::new(p, p)).min(self.bounds.depth(p))
    }

    /// Whether the robot can turn on the spot at a position, with this margin in metres.
    pub(super) fn has_room(&self, p: Point, margin: f64) -> bool {
        self.distance(p) - self.reach > margin + self.slack
    }

    /// Whether the robot is free at a configuration.
    pub(super) fn is_free(&self, q: [f64; 3]) -> bool {
        match &self.shape {
            Shape::Disc => self.has_room(Point::new(q[0], q[1]), 0.0),
            Shape::Polygon(body) => body.is_free(&q),
        }
    }

    /// Refuses a query whose start is in collision, or at whose goal the robot cannot turn on the spot.
    pub(super) fn check(&self, start: [f64; 3], goal: [f64; 2]) -> Result<(), Error> {
        if !self.is_free(start) {
            return Err(self.start_in_collision(start));
        }
        let [x, y] = goal;
        if !self.has_room(Point::new(x, y), 0.0) {
            let sentence = format!("at the goal {:?} the robot cannot turn on the spot without a collision", goal);
            let error = Error::new(Code::GoalInCollision, "/goal", sentence);
            let has_room = |q: &[f64; 2]| self.has_room(Point::new(q[0], q[1]), 0.0);
            return Err(naming_nearest(error, &plane(&self.bounds), &has_room, &goal));
        }
        Ok(())
    }

    /// The error of a start in collision, with the nearest free one: a radian counts as a metre.
    pub(super) fn start_in_collision(&self, start: [f64; 3]) -> Error {
        let sentence = format!("the start {start:?} is in collision");
        let error = Error::new(Code::StartInCollision, "/start", sentence);
        let Aabb { min, max } = self.bounds;
        let space = ProductSpace::of_placements([min.x, min.y], [max.x, max.y], 1.0, 1.0);
        naming_nearest(error, &space, &|&q| self.is_free(q), &space.state(&start))
    }

    /// Whether the arc of a control is proven free, both ends included: an arc that comes too close to an obstacle to be proven
    /// is not.
    pub(super) fn is_arc_free(&self, from: [f64; 3], [speed, turn_rate]: [f64; 2], duration: f64) -> bool {
        let arc = BodyMotion::Arc { from, speed, turn_rate, duration };
        match &self.shape {
            Shape::Disc => {
                let length = (speed * duration).abs();
                let around =
                    Segment::new(point(from), point(from)).aabb().grown(length + self.reach + 2.0 * self.slack);
                let near = &mut *self.near.borrow_mut();
                near.gather(&self.obstacles, &around);
                self.is_part_free(near, &arc, [0.0, 1.0], length, &mut BUDGET.clone())
            }
            Shape::Polygon(body) => body.is_motion_free(&arc),
        }
    }

    /// Whether a part of the arc of a disc is free, by its clearance at the middle, else by halves.
    fn is_part_free(&self, near: &Near, arc: &BodyMotion, [low, high]: [f64; 2], length: f64, left: &mut u32) -> bool {
        if *left == 0 {
            return false;
        }
        *left -= 1;
        let middle = 0.5 * (low + high);
        let p = point(arc.at(middle));
        let clearance = near.distance(p).min(self.bounds.depth(p)) - self.reach;
        let half = 0.5 * (high - low) * length;
        if clearance - half > self.slack {
            return true;
        }
        clearance > self.slack
            && half > SHORTEST
            && self.is_part_free(near, arc, [low, middle], length, left)
            && self.is_part_free(near, arc, [middle, high], length, left)
    }

    /// Whether the load is free in a state.
    pub(super) fn is_load_free(&self, cargo: &Cargo, state: &CargoState) -> bool {
        let [x, y] = load(state);
        self.distance(Point::new(x, y)) - cargo.limits().load_radius > self.slack
    }

    /// A carrier and its load after a time step under a commanded acceleration, if both are proven free on the way and the load
    /// stays within the limit of swing; else how that fails, by a collision if by both.
    ///
    /// Carrier and load are discs that move along curves, which stay within [`Cargo::carrier_bend`] and [`Cargo::bend`] of their
    /// chords. The load is where it is integrated to, and its displacement is compared with the limit after each step of
    /// integration.
    pub(super) fn carry(
        &self,
        cargo: &Cargo,
        from: &CargoState,
        acceleration: [f64; 2],
    ) -> Result<CargoState, Outcome> {
        let limits = cargo.limits();
        let (bend, slack) = (cargo.carrier_bend(), self.slack);
        let mut states = Vec::with_capacity(16);
        states.push(*from);
        cargo.drive(from, acceleration, |state| states.push(*state));
        let after = states[states.len() - 1];
        let load_bend = states[..states.len() - 1].iter().map(|state| cargo.bend(state)).fold(0.0, f64::max);
        let widest = states.iter().flat_map(|state| state.swing).fold(0.0, |widest: f64, x| widest.max(x.abs()));
        // What contains carrier and load while the load is within its limit.
        let reach = limits.radius.max(limits.swing_limit + limits.load_radius + load_bend);
        let way = segment(from.position, after.position);
        let near = &mut *self.near.borrow_mut();
        near.gather(&self.obstacles, &way.aabb().grown(2.0 * reach + 2.0 * widest + bend + 2.0 * slack));
        let clearance = |s: &Segment| {
            let depth = self.bounds.depth(s.a).min(self.bounds.depth(s.b));
            near.distance_from(s).min(depth)
        };
        let around = clearance(&way) - bend;
        if around - limits.radius <= slack {
            return Err(Outcome::Collision);
        }
        let is_within = cargo.is_within_limit(&after);
        let is_free = is_within && around - reach > slack
            || states.windows(2).all(|pair| {
                let chord = segment(load(&pair[0]), load(&pair[1]));
                clearance(&chord) - load_bend - limits.load_radius > slack
            });
        match (is_free, is_within) {
            (false, _) => Err(Outcome::Collision),
            (true, false) => Err(Outcome::Swing),
            (true, true) => Ok(after),
        }
    }

    /// Writes the distance that each ray of the sensor measures at a configuration, in metres, without noise; the range if it
    /// meets nothing before.
    pub(super) fn sense(&self, q: [f64; 3], sensor: &Sensor, fan: &Fan, distances: &mut [f64]) {
        let from = point(q);
        let around = Segment::new(from, from).aabb().grown(sensor.range);
        let near = &mut *self.near.borrow_mut();
        near.gather(&self.obstacles, &around);
        let (sin, cos) = libm::sincos(q[2]);
        for (distance, [c, s]) in distances.iter_mut().zip(&fan.0) {
            let direction = Vector::new(cos * c - sin * s, sin * c + cos * s);
            *distance = near.cast(from, direction, sensor.range.min(self.to_bounds(from, direction)));
        }
    }

    /// The distance along a ray from a position within the bounds to their sides.
    fn to_bounds(&self, from: Point, direction: Vector) -> f64 {
        let along = |from: f64, direction: f64, low: f64, high: f64| match direction {
            d if d > 0.0 => (high - from) / d,
            d if d < 0.0 => (low - from) / d,
            _ => f64::INFINITY,
        };
        let Aabb { min, max } = self.bounds;
        let (x, y) = (along(from.x, direction.x, min.x, max.x), along(from.y, direction.y, min.y, max.y));
        x.min(y).max(0.0)
    }
}

/// Where the load is.
fn load(state: &CargoState) -> [f64; 2] {
    [0, 1].map(|i| state.position[i] + state.swing[i])
}

fn segment([x, y]: [f64; 2], [u, w]: [f64; 2]) -> Segment {
    Segment::new(Point::new(x, y), Point::new(u, w))
}

fn point(q: [f64; 3]) -> Point {
    Point::new(q[0], q[1])
}
