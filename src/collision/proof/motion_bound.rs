//! The placement of a body in the middles of both halves of an interval of its motion, and bounds on how far its points can
//! move from it.
//!
//! Let c be the position of the origin of the body's frame in the middle of a half of half-length h (fractions of
//! the motion), r a point of the body as seen from there, w the turn over the whole motion, and J the rotation by a right
//! angle. The point is at c + r and moves with velocity v = c' + w J r; its acceleration is -a with a = w^2 r - c''. On a
//! straight motion c' is constant and the third derivative of the point is no longer than |w|^3 |r|; on an arc of length
//! s in direction e, c' = s e, c'' = s w J e, and it is no longer than w^2 (|s| + |w| |r|). The larger of the two for all
//! points is the W of `moving_point.rs`.

use super::moving_point::{BOTH, Halves, MovingPoint, Plane};
use super::rotation::unit;
use crate::collision::BodyMotion;
use crate::geometry::{Aabb, Point, Vector};
use crate::space::Lanes;

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

/// The body in the middles of both halves of an interval.
#[derive(Clone, Copy)]
pub(in crate::collision) struct Middle {
    /// c.
    pub position: Plane<Halves>,
    /// The direction of the body's x axis.
    pub heading: Plane<Halves>,
    /// The direction in which c moves, if it does.
    pub direction: Option<Plane<Halves>>,
    /// h c'.
    velocity: Plane<Halves>,
    /// h w.
    turn: f64,
    /// h^2/4 times w^2, and times -c''.
    centripetal: f64,
    drift: Plane<Halves>,
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

    /// The middles, at fractions `t`, of halves of half-length `h`.
    #[inline(always)]
    pub fn middle(&self, t: Halves, h: f64) -> Middle {
        let turn = h * self.turn;
        let remainder = h * h * h * self.third;
        let centripetal = 0.25 * turn * turn;
        let (from, start) = (Plane::splat(self.from), Plane::splat(self.heading));
        if self.arc == 0.0 {
            let heading = start.rotated(unit(Halves::splat(self.turn) * t));
            let position = from + Plane::splat(self.displacement) * t;
            let (velocity, direction) = (Plane::splat(self.displacement * h), self.direction.map(Plane::splat));
            return Middle { position, heading, direction, velocity, turn, centripetal, drift: Plane::ZERO, remainder };
        }
        // A chord leads there, in the direction that the body has half way.
        let half_turned = Halves::splat(0.5 * self.turn) * t;
        let half_turn = unit(half_turned);
        // A small sine is a product with the angle, off by a rounding or two: so is the quotient.
        let sinc = half_turned.simd_eq(Halves::splat(0.0)).bitselect(Halves::splat(1.0), half_turn.y / half_turned);
        let along = start.rotated(half_turn);
        let heading = along.rotated(half_turn);
        let position = from + along * (Halves::splat(self.arc) * t * sinc);
        let velocity = heading * Halves::splat(self.arc * h);
        let drift = velocity.left() * Halves::splat(-0.25 * turn);
        Middle { position, heading, direction: Some(heading), velocity, turn, centripetal, drift, remainder }
    }

    /// The part of a box that holds points on both halves, of half-length `h`, within reach of where the frame's origin can
    /// be; the box itself where the body turns little.
    #[inline(always)]
    pub fn restricted(&self, swept: Aabb, middle: &Middle, h: f64) -> Aabb {
        if middle.turn.abs() <= FAST {
            return swept;
        }
        let reached = self.reached(middle, 0, h).union(&self.reached(middle, 1, h));
        Aabb { min: swept.min.sup(&reached.min), max: swept.max.inf(&reached.max) }
    }

    /// A box around all that the body can reach on a half.
    #[cold]
    fn reached(&self, middle: &Middle, half: usize, h: f64) -> Aabb {
        let within = |center: Vector, x: f64, y: f64| {
            let by = Vector::new(x + self.reach, y + self.reach);
            Aabb { min: Point::from(center - by), max: Point::from(center + by) }
        };
        let position = middle.position.half(half);
        if self.arc == 0.0 {
            let velocity = middle.velocity.half(half);
            return within(position, velocity.x.abs(), velocity.y.abs());
        }
        let path = self.arc.abs() * h;
        let along = within(position, path, path);
        let radius = self.arc / self.turn;
        let circle = within(position + middle.heading.left().half(half) * radius, radius.abs(), radius.abs());
        Aabb { min: along.min.sup(&circle.min), max: along.max.inf(&circle.max) }
    }
}

impl Middle {
    /// A body at rest.
    pub fn at_rest(position: Vector, heading: Vector) -> Self {
        let (position, heading, zero) = (Plane::splat(position), Plane::splat(heading), Plane::ZERO);
        Self {
            position,
            heading,
            direction: None,
            velocity: zero,
            turn: 0.0,
            centripetal: 0.0,
            drift: zero,
            remainder: 0.0,
        }
    }

    /// A point of the body, given as seen from c.
    #[inline(always)]
    pub fn point(&self, r: Plane<Halves>) -> MovingPoint {
        MovingPoint {
            position: self.position + r,
            velocity: self.velocity + r.left() * Halves::splat(self.turn),
            acceleration: r * Halves::splat(self.centripetal) + self.drift,
            remainder: self.remainder,
        }
    }

    /// The halves on which these points, as seen from c, stay ahead of the line n.x = `support` by more than `margin`:
    /// [`MovingPoint::retreat`] of each, with the terms that they share computed once.
    #[inline(always)]
    pub fn stays_ahead(&self, n: Plane<Halves>, support: Halves, margin: f64, points: &[Plane<Halves>]) -> u32 {
        let (ahead, needed) = (n.dot(self.position) - support, Halves::splat(margin + self.remainder));
        let (velocity, drift) = (n.dot(self.velocity), n.dot(self.drift));
        let (turn, centripetal) = (Halves::splat(self.turn), Halves::splat(self.centripetal));
        let mut stays = BOTH;
        for &r in points {
            let along = n.dot(r);
            let swing = turn * n.dot(r.left());
            let acceleration = centripetal * along + drift;
            let retreat = (velocity + swing).abs() + (acceleration + acceleration.abs());
            stays &= ((ahead + along) - retreat).above(needed);
        }
        stays
    }
}
