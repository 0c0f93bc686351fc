//! A robot placed at a configuration, and what of the obstacles is nearest to it.

use crate::collision::Obstacles;
use crate::geometry::{Aabb, Point, Polygon, Segment};
use crate::robot::{Arm, MAX_LINKS};
use crate::scenario::{Obstacle, Robot};
use crate::space::MAX_DIMENSION;

/// A configuration, padded with zeros.
pub(super) type State = [f64; MAX_DIMENSION];

/// What a robot consists of.
pub(super) enum RobotShape {
    /// Links of this radius.
    Arm(Arm),
    /// A disc of this radius.
    Disc(f64),
    /// A polygon and all within a margin.
    Body(Polygon, f64),
}

impl RobotShape {
    pub fn of(robot: &Robot) -> Self {
        match robot {
            Robot::Arm(arm) => Self::Arm(arm.clone()),
            Robot::Disc(disc) => Self::Disc(disc.kept_radius()),
            Robot::RigidBody(body) => Self::Body(body.shape.clone(), body.margin()),
            Robot::Car(car) => Self::Body(car.shape().clone(), car.margin()),
        }
    }

    /// How far a body reaches from the origin of its frame, in metres; 0 of others.
    pub fn reach(&self) -> f64 {
        if let Self::Body(shape, _) = self { shape.reach() } else { 0.0 }
    }

    pub fn placed(&self, q: &State) -> PlacedRobot {
        match self {
            Self::Arm(arm) => {
                PlacedRobot::Chain { points: arm.joints(q), links: arm.links().len(), radius: arm.kept_radius() }
            }
            Self::Disc(radius) => {
                PlacedRobot::Chain { points: [Point::new(q[0], q[1]); MAX_LINKS + 1], links: 1, radius: *radius }
            }
            Self::Body(shape, margin) => PlacedRobot::Body { shape: shape.placed([q[0], q[1], q[2]]), margin: *margin },
        }
    }
}

/// The parts of a robot in the world.
pub(super) enum PlacedRobot {
    /// All within a radius of the segments between neighbours among the first points.
    Chain { points: [Point; MAX_LINKS + 1], links: usize, radius: f64 },
    /// A polygon and all within a margin.
    Body { shape: Polygon, margin: f64 },
}

/// A part of a robot and an obstacle near it.
pub(super) struct Near {
    /// The distance between them, in metres; 0 or less if they share a point.
    pub distance: f64,
    pub part: usize,
    pub obstacle: usize,
}

impl PlacedRobot {
    /// How far the robot reaches beyond its points.
    pub fn radius(&self) -> f64 {
        match self {
            Self::Chain { radius, .. } => *radius,
            Self::Body { margin, .. } => *margin,
        }
    }

    /// The number of parts.
    fn parts(&self) -> usize {
        if let Self::Chain { links, .. } = self { *links } else { 1 }
    }

    /// The corners of all parts, each with its part.
    pub fn points(&self) -> impl Iterator<Item = (usize, Point)> {
        let points = match self {
            Self::Chain { points, links, .. } => &points[..=*links],
            Self::Body { shape, .. } => shape.vertices(),
        };
        let is_chain = matches!(self, Self::Chain { .. });
        points.iter().enumerate().map(move |(i, p)| (if is_chain { i.saturating_sub(1) } else { 0 }, *p))
    }

    /// The axis of a link.
    fn link(points: &[Point], part: usize) -> Segment {
        Segment::new(points[part], points[part + 1])
    }

    /// The box around a part without its radius.
    fn aabb(&self, part: usize) -> Aabb {
        match self {
            Self::Chain { points, .. } => Self::link(points, part).aabb(),
            Self::Body { shape, .. } => *shape.aabb(),
        }
    }

    /// The distance from a part to an obstacle; if it is `most` or more, that or more.
    fn distance(&self, part: usize, obstacle: &Obstacle, most: f64) -> f64 {
        let radius = self.radius();
        let distance = match self {
            Self::Chain { points, .. } => obstacle.distance_to_segment_within(&Self::link(points, part), most + radius),
            Self::Body { shape, .. } => obstacle.distance_to_polygon_within(shape, most + radius),
        };
        distance - radius
    }

    /// What is nearest, if it is nearer than `most`.
    pub fn nearest(&self, obstacles: &Obstacles, most: f64) -> Option<Near> {
        let (mut least, mut found) = (most, None);
        for part in 0..self.parts() {
            let own = self.aabb(part);
            obstacles.any_near(&own.grown(least + self.radius()), |obstacle| {
                let beyond = least + self.radius();
                if own.gap_squared(obstacles.aabb(obstacle)) > beyond * beyond {
                    return false;
                }
                let distance = self.distance(part, obstacles.shape(obstacle), least);
                if distance < least {
                    least = distance;
                    found = Some(Near { distance, part, obstacle });
                }
                false
            });
        }
        found
    }

    /// The point of an obstacle that is nearest to a part, on the border of the obstacle.
    pub fn nearest_point(&self, part: usize, obstacle: &Obstacle) -> Point {
        let own: Vec<Segment> = match self {
            Self::Chain { points, .. } => vec![Self::link(points, part)],
            Self::Body { shape, .. } => shape.edges().collect(),
        };
        let (mut nearest, mut radius) = ((f64::INFINITY, own[0].a, own[0].a), obstacle.edge_radius());
        let mut compare = |theirs: &Segment| {
            for (distance, mine, other) in own.iter().map(|own| closest(own, theirs)) {
                if distance < nearest.0 {
                    nearest = (distance, mine, other);
                }
            }
            false
        };
        if let Obstacle::Disc(disc) = obstacle {
            radius = disc.radius;
            compare(&Segment::new(disc.center, disc.center));
        } else {
            obstacle.any_edge_near(&obstacle.aabb(), &mut compare);
        }
        let (distance, mine, other) = nearest;
        if distance <= radius { mine } else { other + (mine - other) * (radius / distance) }
    }
}

/// The distance of two segments and their nearest points; where they cross, the crossing.
fn closest(s: &Segment, t: &Segment) -> (f64, Point, Point) {
    let (u, v, w) = (s.b - s.a, t.b - t.a, t.a - s.a);
    let cross = u.perp(&v);
    if cross != 0.0 {
        let [along, across] = [w.perp(&v) / cross, w.perp(&u) / cross];
        if (0.0..=1.0).contains(&along) && (0.0..=1.0).contains(&across) {
            let at = s.a + u * along;
            return (0.0, at, at);
        }
    }
    let on_t = [s.a, s.b].map(|p| (p, project(p, t)));
    let on_s = [t.a, t.b].map(|p| (project(p, s), p));
    let pairs = on_t.into_iter().chain(on_s).map(|(a, b)| ((b - a).norm(), a, b));
    pairs.reduce(|a, b| if b.0 < a.0 { b } else { a }).unwrap_or((0.0, s.a, t.a))
}

/// The point of a segment that is nearest to a point.
fn project(p: Point, s: &Segment) -> Point {
    let along = s.b - s.a;
    let length_squared = along.norm_squared();
    if length_squared == 0.0 {
        return s.a;
    }
    s.a + along * ((p - s.a).dot(&along) / length_squared).clamp(0.0, 1.0)
}
