//! The placement of a body in the middle of an interval of its motion, and bounds on how far its points can move from it.
//!
//! Let c be the position of the origin of the body's frame in the middle of an interval of half-length h (fractions of
//! the motion), r a point of the body as seen from there, w the turn over the whole motion, and J the rotation by a right
//! angle. The point is at c + r and moves with velocity v = c' + w J r; its acceleration is -a with a = w^2 r - c''. On a
//! straight motion c' is constant and the third derivative of the point is no longer than |w|^3 |r|; on an arc of length
//! s in direction e, c' = s e, c'' = s w J e, and it is no longer than w^2 (|s| + |w| |r|). The larger of the two for all
//! points is the W of `moving_point.rs`.

use super::moving_point::{MovingPoint, dot, left_of};
use super::rotation::{rotate, unit, unit_and_sinc};
use crate::collision::BodyMotion;
use crate::geometry::{Aabb, Point, Vector};

/// Where a body turns by more radians than this over half an interval, its reach may bound it better.
const FAST: f64 = 0.7;

/// A displacement no longer than this, in metres, has no direction: squares may underflow.
const SHORTEST: f64 = 1e-150;

/// What bounds a motion of a body of some reach on every interval.
#[derive(Default)]
pub(in crate::collision) struct MotionBound {
    from: Vector,
    /// The direction of the body's x axis at the start.
    heading: Vector,
    /// The displacement of a straight motion, and its direction.
    displacement: Vector,
    direction: Option<Vector>,
    /// The length s of an arc, negative backwards.
    arc: f64,
    /// w.
    turn: f64,
    /// W / 6.
    third: f64,
    /// How far any point can travel, at most: the bound of first order.
    pub travel: f64,
    reach: f64,
}

/// The body in the middle of an interval.
#[derive(Clone, Copy)]
pub(in crate::collision) struct Middle {
    /// c.
    pub position: Vector,
    /// The direction of the body's x axis.
    pub heading: Vector,
    /// The direction in which c moves, if it does.
    pub direction: Option<Vector>,
    /// h c'.
    velocity: Vector,
    /// h w.
    turn: f64,
    /// h^2/4 times w^2, and times -c''.
    centripetal: f64,
    drift: Vector,
    /// h^3/6 W.
    remainder: f64,
}

impl MotionBound {
    /// Of a body that reaches so far from the origin of its frame; `heading` is its direction at the start.
    #[inline(always)]
    pub fn new(motion: &BodyMotion, reach: f64, heading: Vector) -> Self {
        let (path, turned) = motion.extent();
        let [x, y, _] = motion.from();
        let travel = path + turned * reach;
        let still = Self { from: Vector::new(x, y), heading, travel, reach, ..Self::default() };
        match *motion {
            BodyMotion::Straight { delta: [x, y, turn], .. } => {
                let displacement = Vector::new(x, y);
                let direction = (path > SHORTEST).then(|| displacement / path);
                Self { displacement, direction, turn, third: turn * turn * turned * reach / 6.0, ..still }
            }
            BodyMotion::Arc { speed, turn_rate, duration, .. } => {
                let turn = turn_rate * duration;
                Self { arc: speed * duration, turn, third: turn * turn * travel / 6.0, ..still }
            }
        }
    }

    /// The middle of the interval around fraction `t`, of half-length `h`.
    #[inline(always)]
    pub fn middle(&self, t: f64, h: f64) -> Middle {
        let turn = h * self.turn;
        let remainder = h * h * h * self.third;
        let centripetal = 0.25 * turn * turn;
        if self.arc == 0.0 {
            let heading = rotate(self.heading, unit(self.turn * t));
            let position = self.from + self.displacement * t;
            let (velocity, direction, drift) = (self.displacement * h, self.direction, Vector::zeros());
            return Middle { position, heading, direction, velocity, turn, centripetal, drift, remainder };
        }
        // A chord leads there, in the direction that the body has half way.
        let (half_turn, sinc) = unit_and_sinc(0.5 * self.turn * t);
        let along = rotate(self.heading, half_turn);
        let heading = rotate(along, half_turn);
        let position = self.from + along * (self.arc * t * sinc);
        let velocity = heading * (self.arc * h);
        let drift = left_of(velocity) * (-0.25 * turn);
        Middle { position, heading, direction: Some(heading), velocity, turn, centripetal, drift, remainder }
    }

    /// A box that holds the points on the whole interval of half-length `h`.
    #[inline(always)]
    pub fn swept_box(&self, middle: &Middle, h: f64, points: &[Vector]) -> Aabb {
        let mut swept = middle.point(points[0]).swept_box();
        for &point in &points[1..] {
            let b = middle.point(point).swept_box();
            swept.min.x = if b.min.x < swept.min.x { b.min.x } else { swept.min.x };
            swept.min.y = if b.min.y < swept.min.y { b.min.y } else { swept.min.y };
            swept.max.x = if b.max.x > swept.max.x { b.max.x } else { swept.max.x };
            swept.max.y = if b.max.y > swept.max.y { b.max.y } else { swept.max.y };
        }
        if middle.turn.abs() > FAST { self.restricted(swept, middle, h) } else { swept }
    }

    /// The part of the box within reach of where the frame's origin can be.
    #[cold]
    fn restricted(&self, swept: Aabb, middle: &Middle, h: f64) -> Aabb {
        let within = |swept: Aabb, center: Vector, x: f64, y: f64| {
            let by = Vector::new(x + self.reach, y + self.reach);
            Aabb { min: swept.min.sup(&Point::from(center - by)), max: swept.max.inf(&Point::from(center + by)) }
        };
        if self.arc == 0.0 {
            return within(swept, middle.position, middle.velocity.x.abs(), middle.velocity.y.abs());
        }
        let path = self.arc.abs() * h;
        let swept = within(swept, middle.position, path, path);
        let radius = self.arc / self.turn;
        within(swept, middle.position + left_of(middle.heading) * radius, radius.abs(), radius.abs())
    }
}

impl Middle {
    /// A body at rest.
    pub fn at_rest(position: Vector, heading: Vector) -> Self {
        let (direction, zero) = (None, Vector::zeros());
        Self { position, heading, direction, velocity: zero, turn: 0.0, centripetal: 0.0, drift: zero, remainder: 0.0 }
    }

    /// A point of the body, given as seen from c.
    #[inline(always)]
    pub fn point(&self, r: Vector) -> MovingPoint {
        MovingPoint {
            position: self.position + r,
            velocity: self.velocity + left_of(r) * self.turn,
            acceleration: r * self.centripetal + self.drift,
            remainder: self.remainder,
        }
    }

    /// Whether these points, as seen from c, stay ahead of the line n.x = `support` by more than `margin` on the whole
    /// interval: [`MovingPoint::retreat`] of each, with the terms that they share computed once.
    #[inline(always)]
    pub fn stays_ahead(&self, n: Vector, support: f64, margin: f64, points: &[Vector]) -> bool {
        let (ahead, needed) = (dot(n, self.position) - support, margin + self.remainder);
        let (velocity, drift) = (dot(n, self.velocity), dot(n, self.drift));
        let mut stays = true;
        for &r in points {
            let along = dot(n, r);
            let swing = self.turn * dot(n, left_of(r));
            let acceleration = self.centripetal * along + drift;
            stays &= (ahead + along) - (velocity + swing).abs() - (acceleration + acceleration.abs()) > needed;
        }
        stays
    }
}
