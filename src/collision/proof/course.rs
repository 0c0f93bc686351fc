//! Where a body is in the middle of a stretch of its motion, and how far its points can get from there.
//!
//! Let c be the place of the origin of the body's frame in the middle of a stretch of half-length h (fractions of the motion),
//! r the place of a point of the body as seen from there, w the turn over the whole motion, and J the turn by a right angle. The
//! point is at c + r and moves with velocity v = c' + w J r; its acceleration is -a with a = w^2 r - c''. On a straight
//! motion c' is constant and the third derivative of the point is no longer than |w|^3 |r|; on an arc of length s in direction
//! e, c' = s e, c'' = s w J e, and it is no longer than w^2 (|s| + |w| |r|). With K the larger of the two for all points, for
//! every unit direction n, by Taylor's theorem, n falls behind by no more than h |n.v| + h^2/2 max(n.a, 0) + h^3/6 K on the
//! whole stretch. Every point of a convex piece is a fixed mix of its corners: what holds for these holds for the piece.

use super::rotation::{turned, unit, unit_and_sinc};
use crate::collision::BodyMotion;
use crate::geometry::{Aabb, Point, Vector};

/// A body that turns by more radians than this over half a stretch may be held better by how far it reaches.
const FAST: f64 = 0.7;

/// A way no longer than this, in metres, has no direction: squares may underflow.
const SHORTEST: f64 = 1e-150;

/// A motion of a body of some reach, made ready for stretches of it.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct Course {
    from: Point,
    /// The direction of the body's x axis at the start.
    heading: Vector,
    /// The way of a straight motion.
    way: Vector,
    /// Its direction; along the body's x axis for an arc.
    direction: Option<Vector>,
    /// The length s of an arc, negative backwards.
    arc: f64,
    /// w.
    turn: f64,
    /// K / 6.
    third: f64,
    /// How far any point can travel, at most: the same bound as the proof by distances has.
    pub travel: f64,
    reach: f64,
}

/// The body in the middle of a stretch.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct Middle {
    /// c.
    pub place: Vector,
    /// The direction of the body's x axis.
    pub heading: Vector,
    /// h c'.
    go: Vector,
    /// h w.
    turn: f64,
    /// h^2 / 4 times w^2, and times -c'': max(x, 0) is (x + |x|) / 2.
    bend: f64,
    drift: Vector,
    /// h^3 / 6 times K.
    rest: f64,
}

/// J.
#[inline(always)]
pub(super) fn left_of(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

impl Course {
    /// Of a body that reaches so far from the origin of its frame; `heading` is its direction at the start.
    #[inline(always)]
    pub fn new(motion: &BodyMotion, reach: f64, heading: Vector) -> Self {
        let (path, turned) = motion.extent();
        let [x, y, _] = motion.from();
        let still = Self {
            from: Point::new(x, y),
            heading,
            way: Vector::zeros(),
            direction: None,
            arc: 0.0,
            turn: 0.0,
            third: 0.0,
            travel: path + turned * reach,
            reach,
        };
        match *motion {
            BodyMotion::Straight { delta: [x, y, turn], .. } => {
                let way = Vector::new(x, y);
                let direction = (path > SHORTEST).then(|| way / path);
                Self { way, direction, turn, third: turn * turn * turned * reach / 6.0, ..still }
            }
            BodyMotion::Arc { speed, turn_rate, duration, .. } => {
                let turn = turn_rate * duration;
                Self { arc: speed * duration, turn, third: turn * turn * still.travel / 6.0, ..still }
            }
        }
    }

    /// The middle of the stretch around fraction `t`, of half-length `h`.
    #[inline(always)]
    pub fn middle(&self, t: f64, h: f64) -> Middle {
        let turn = h * self.turn;
        let rest = h * h * h * self.third;
        let bend = 0.25 * turn * turn;
        if self.arc == 0.0 {
            let heading = turned(self.heading, unit(self.turn * t));
            let place = self.from.coords + self.way * t;
            return Middle { place, heading, go: self.way * h, turn, bend, drift: Vector::zeros(), rest };
        }
        // A chord leads there, in the direction that the body has on half the way.
        let (half_turn, sinc) = unit_and_sinc(0.5 * self.turn * t);
        let along = turned(self.heading, half_turn);
        let heading = turned(along, half_turn);
        let place = self.from.coords + along * (self.arc * t * sinc);
        let go = heading * (self.arc * h);
        Middle { place, heading, go, turn, bend, drift: left_of(go) * (-0.25 * turn), rest }
    }

    /// The direction in which the origin of the frame moves in the middle, where it moves.
    #[inline(always)]
    pub fn direction(&self, middle: &Middle) -> Option<Vector> {
        if self.arc == 0.0 { self.direction } else { Some(middle.heading) }
    }

    /// A box that holds the points on the whole stretch of half-length `h`; they are given as seen from the frame's origin.
    #[inline(always)]
    pub fn swept_box(&self, middle: &Middle, h: f64, points: &[Vector]) -> Aabb {
        let swept = middle.swept_box(points);
        if middle.turn.abs() > FAST { self.held(swept, middle, h) } else { swept }
    }

    /// The part of the box within reach of where the frame's origin can be.
    #[cold]
    fn held(&self, swept: Aabb, middle: &Middle, h: f64) -> Aabb {
        let within = |swept: Aabb, place: Vector, x: f64, y: f64| {
            let by = Vector::new(x + self.reach, y + self.reach);
            Aabb { min: swept.min.sup(&Point::from(place - by)), max: swept.max.inf(&Point::from(place + by)) }
        };
        if self.arc == 0.0 {
            return within(swept, middle.place, middle.go.x.abs(), middle.go.y.abs());
        }
        let path = self.arc.abs() * h;
        let swept = within(swept, middle.place, path, path);
        let radius = self.arc / self.turn;
        within(swept, middle.place + left_of(middle.heading) * radius, radius.abs(), radius.abs())
    }
}

impl Middle {
    /// A body at rest.
    pub fn at_rest(place: Vector, heading: Vector) -> Self {
        let zero = Vector::zeros();
        Self { place, heading, go: zero, turn: 0.0, bend: 0.0, drift: zero, rest: 0.0 }
    }

    /// Whether all points, given as seen from the frame's origin, stay ahead of the line n.x = `support` by more than `margin`.
    #[inline(always)]
    pub fn stays_ahead(&self, n: Vector, support: f64, margin: f64, points: &[Vector]) -> bool {
        let ahead = (n.x * self.place.x + n.y * self.place.y) - support;
        let go = n.x * self.go.x + n.y * self.go.y;
        let drift = n.x * self.drift.x + n.y * self.drift.y;
        let needed = margin + self.rest;
        let mut stays = true;
        for r in points {
            let along = n.x * r.x + n.y * r.y;
            let swing = self.turn * (n.y * r.x - n.x * r.y);
            let bend = self.bend * along + drift;
            stays &= (ahead + along) - (go + swing).abs() - (bend + bend.abs()) > needed;
        }
        stays
    }

    /// A box that holds the points on the whole stretch.
    #[inline(always)]
    pub fn swept_box(&self, points: &[Vector]) -> Aabb {
        let (mut low_x, mut low_y) = (f64::INFINITY, f64::INFINITY);
        let (mut high_x, mut high_y) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        for r in points {
            let (shift_x, shift_y) = ((self.go.x - self.turn * r.y).abs(), (self.go.y + self.turn * r.x).abs());
            let (bend_x, bend_y) = (self.bend * r.x + self.drift.x, self.bend * r.y + self.drift.y);
            // Falling below costs the part of a that points up, rising above the part that points down.
            let x = r.x - shift_x - (bend_x.abs() + bend_x);
            let y = r.y - shift_y - (bend_y.abs() + bend_y);
            low_x = if x < low_x { x } else { low_x };
            low_y = if y < low_y { y } else { low_y };
            let x = r.x + shift_x + (bend_x.abs() - bend_x);
            let y = r.y + shift_y + (bend_y.abs() - bend_y);
            high_x = if x > high_x { x } else { high_x };
            high_y = if y > high_y { y } else { high_y };
        }
        let (x, y, rest) = (self.place.x, self.place.y, self.rest);
        Aabb {
            min: Point::new(x + (low_x - rest), y + (low_y - rest)),
            max: Point::new(x + (high_x + rest), y + (high_y + rest)),
        }
    }
}
