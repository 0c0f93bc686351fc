//! A moving body, for the driver of the proof: convex pieces on a straight motion or an arc.
//!
//! **Slack.** S is the largest coordinate plus the reach; the slack is 1e-12 S. Nothing is accumulated along a motion: every
//! middle is computed from the start. The heading there is the product of that at the start and of the turn since, each off by
//! 1.4e-14 (see `rotation.rs`) and by roundings of angles of 7 radians at most, 1e-15; on an arc, half of the turn is taken
//! twice: 4.5e-14 in all, and that times S for every corner. A displacement is off by roundings, 4e-16 times its length, which
//! is 9 S at most; a chord besides by its direction, 3e-14 times its length, and by the sine of half its turn, 1.4e-14 times the
//! diameter of the arc. As long as all before has been within the bounds, chords are no longer than 3 S; and where more than 0.4
//! radians of half a turn are behind, so that the sine is not from the bare series, the diameter is at most 3 S / sin 0.4 = 7.8
//! S: 2.1e-13 S in all. A normal of the body is of unit length to 4.5e-14, its terms sum to no more than 2 S where a test passes:
//! 9e-14 S. With no cancelling terms in W, each of the roughly 30 roundings of a test costs less than 8 S times 2^-53: 3e-14 S.
//! Together that is below 4e-13 S.

use super::driver::{Interval, Moving};
use super::motion_bound::{Middle, MotionBound};
use super::moving_point::{Halves, MovingPoint, Plane, around};
use super::pair::{Direction, Part, nearest_point, polygon_support};
use super::rotation::unit;
use crate::collision::BodyMotion;
use crate::collision::obstacles::MOST_CORNERS;
use crate::collision::obstacles::{Face, faces_of};
use crate::geometry::{Aabb, Point, Polygon, Vector, small_convex_pieces};
use crate::space::Lanes;
use std::ops::Range;

/// A body and its motion.
pub(in crate::collision) struct MovingBody {
    /// The faces of all convex pieces in the body's own frame, piece by piece, each counter-clockwise; and the range of each.
    faces: Vec<Face>,
    ranges: Vec<(u32, u32)>,
    /// The distance from the origin of the frame to the farthest corner, in metres.
    reach: f64,
    eta: f64,
    /// By how much the body is grown, and the slack.
    margin: f64,
    /// The angle last begun from, and its unit vector: roadmaps try many motions from one placement.
    from: f64,
    heading: Vector,
    bound: MotionBound,
    /// The body in the middles of both halves of the interval under test, and its corners as seen from the origin of its
    /// frame; half the length of a half.
    middle: Middle,
    corners: Vec<Plane<Halves>>,
    half: f64,
}

impl MovingBody {
    /// The body, cut into convex pieces, with this slack. O(n log n).
    pub fn new(body: &Polygon, eta: f64) -> Self {
        let (mut faces, mut ranges) = (Vec::new(), Vec::new());
        for piece in small_convex_pieces(body, MOST_CORNERS) {
            let first = faces.len() as u32;
            faces.extend(faces_of(&piece));
            ranges.push((first, faces.len() as u32));
        }
        Self {
            faces,
            ranges,
            reach: body.reach(),
            eta,
            margin: eta,
            from: 0.0,
            heading: Vector::x(),
            bound: MotionBound::default(),
            middle: Middle::at_rest(Vector::zeros(), Vector::x()),
            corners: Vec::new(),
            half: 0.0,
        }
    }

    /// Grows the body by this distance, in all directions.
    pub fn grow(&mut self, by: f64) {
        self.margin = by + self.eta;
    }

    /// Begins a motion.
    #[inline(always)]
    pub fn begin(&mut self, motion: &BodyMotion) {
        let [_, _, theta] = motion.from();
        if self.from != theta {
            (self.from, self.heading) = (theta, heading(theta));
        }
        self.bound = MotionBound::new(motion, self.reach, self.heading);
    }

    /// Places the body at rest.
    #[inline(always)]
    pub fn rest(&mut self, [x, y, theta]: [f64; 3]) {
        self.half = 0.0;
        self.set(Middle::at_rest(Vector::new(x, y), heading(theta)), self.ranges.len());
    }

    /// The range of a piece's faces among those of all.
    #[inline(always)]
    fn range(&self, piece: usize) -> Range<usize> {
        let (first, end) = self.ranges[piece];
        first as usize..end as usize
    }

    /// Places the first `pieces` pieces.
    #[inline(always)]
    fn set(&mut self, middle: Middle, pieces: usize) {
        self.middle = middle;
        self.corners.clear();
        let faces = &self.faces[..self.ranges[pieces - 1].1 as usize];
        self.corners.extend(faces.iter().map(|face| Plane::splat(face.corner.coords).rotated(middle.heading)));
    }
}

impl Moving for MovingBody {
    type State = ();
    type Part<'a> = Piece<'a>;

    #[inline(always)]
    fn parts(&self) -> usize {
        self.ranges.len()
    }

    #[inline(always)]
    fn place(&mut self, interval: &Interval, (): &(), parts: usize) {
        self.half = 0.5 * interval.half;
        let middles = Halves::new([interval.middle - self.half, interval.middle + self.half]);
        self.set(self.bound.middle(middles, self.half), parts);
    }

    #[inline(always)]
    fn state(&self, _: usize) {}

    #[inline(always)]
    fn part(&self, part: usize) -> Piece<'_> {
        let range = self.range(part);
        Piece {
            middle: &self.middle,
            direction: self.middle.direction,
            faces: &self.faces[range.clone()],
            corners: &self.corners[range],
        }
    }

    #[inline(always)]
    fn swept_box(&self, part: usize) -> Aabb {
        let swept = around(self.part(part).swept_boxes());
        self.bound.restricted(swept, &self.middle, self.half).grown(self.margin)
    }

    #[inline(always)]
    fn depth(&self, part: usize, half: usize, bounds: &Aabb) -> f64 {
        let corners = &self.corners[self.range(part)];
        let depth = |&r: &Plane<Halves>| bounds.depth(Point::from((self.middle.position + r).half(half)));
        corners.iter().map(depth).fold(f64::INFINITY, f64::min) - (self.margin - self.eta)
    }

    #[inline(always)]
    fn travel(&self, _: usize) -> f64 {
        self.bound.travel
    }

    #[inline(always)]
    fn margin(&self) -> f64 {
        self.margin
    }
}

/// The unit vector in the direction of an angle.
#[inline(always)]
fn heading(angle: f64) -> Vector {
    let Plane { x, y } = unit(angle);
    Vector::new(x, y)
}

/// A convex piece of a body: its corners and faces, these in the body's frame.
pub(in crate::collision) struct Piece<'a> {
    middle: &'a Middle,
    /// The direction of motion, if it moves.
    direction: Option<Plane<Halves>>,
    faces: &'a [Face],
    corners: &'a [Plane<Halves>],
}

impl Part for Piece<'_> {
    #[inline(always)]
    fn corners(&self) -> impl Iterator<Item = MovingPoint> + Clone {
        self.corners.iter().map(|&r| self.middle.point(r))
    }

    #[inline(always)]
    fn ahead(&self, n: Plane<Halves>, support: Halves) -> Halves {
        let mut least = Halves::splat(f64::INFINITY);
        for &r in self.corners {
            least = least.lesser(n.dot(r));
        }
        (n.dot(self.middle.position) - support) + least
    }

    #[inline(always)]
    fn stays_ahead(&self, n: Plane<Halves>, support: Halves, margin: f64) -> u32 {
        self.middle.stays_ahead(n, support, margin, self.corners)
    }

    #[inline(always)]
    fn directions(&self) -> usize {
        self.sides() + if self.direction.is_some() { 2 } else { 0 }
    }

    #[inline(always)]
    fn sides(&self) -> usize {
        self.faces.len()
    }

    /// The normals of the piece's faces, turned inwards; then both directions across that of motion.
    #[inline(always)]
    fn direction(&self, i: usize, faces: &[Face]) -> Direction {
        if let Some(face) = self.faces.get(i) {
            let n = -Plane::splat(face.normal).rotated(self.middle.heading);
            let support = polygon_support(n, faces);
            let ahead = n.dot(self.middle.position) - Halves::splat(face.support) - support;
            return Direction { n, support, ahead };
        }
        let n = self.direction.unwrap_or(Plane::ZERO).left();
        let n = if i == self.faces.len() { n } else { -n };
        let support = polygon_support(n, faces);
        Direction { n, support, ahead: self.ahead(n, support) }
    }

    #[inline]
    fn offset_from(&self, half: usize, p: Point) -> Vector {
        let heading = self.middle.heading.half(half);
        let (x, y) = (heading.x, heading.y);
        let from = p.coords - self.middle.position.half(half);
        let center = Vector::new(x * from.x + y * from.y, x * from.y - y * from.x);
        // The nearest point lies on the face that the point is farthest in front of, if it is beside that one.
        let mut before = (f64::NEG_INFINITY, 0);
        for (i, face) in self.faces.iter().enumerate() {
            let distance = face.normal.dot(&center) - face.support;
            if distance > before.0 {
                before = (distance, i);
            }
        }
        if before.0 <= 0.0 {
            return Vector::zeros();
        }
        let at = |i: usize| self.faces[if i == self.faces.len() { 0 } else { i }].corner.coords;
        let (face, next) = (&self.faces[before.1], at(before.1 + 1));
        let along = Vector::new(-face.normal.y, face.normal.x);
        let mut to = face.normal * before.0;
        if along.dot(&(center - face.corner.coords)) < 0.0 || along.dot(&(center - next)) > 0.0 {
            // All faces are tried: if two are in one line, or nearly, rounding decides which of them is found.
            let mut least = f64::INFINITY;
            for i in 0..self.faces.len() {
                let nearest = nearest_point(Point::from(center), Point::from(at(i)), Point::from(at(i + 1)));
                let beyond = center - nearest.coords;
                if beyond.norm_squared() < least {
                    (to, least) = (beyond, beyond.norm_squared());
                }
            }
        }
        -Vector::new(to.x * x - to.y * y, to.y * x + to.x * y)
    }
}
