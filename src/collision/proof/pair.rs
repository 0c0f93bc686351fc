//! A convex part of the robot and a convex obstacle: are they apart on a whole interval, do they touch in its middle?

use super::moving_point::{BOTH, Halves, MovingPoint, Plane};
use crate::collision::Obstacles;
use crate::collision::obstacles::Face;
use crate::geometry::{Aabb, Disc, Point, Vector};
use crate::space::Lanes;

/// Instead of the index of a direction: no direction to try first.
pub(in crate::collision) const NO_HINT: u32 = u32::MAX;

/// The number of directions that [`find_direction`] tries.
const DIRECTIONS: u32 = 8;

/// The result of a test of a pair on an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::collision) enum Separation {
    /// Apart on the whole interval.
    Apart,
    /// Apart in the middle.
    Open,
    /// Touching in the middle.
    Touching,
    /// Inconclusive: within the slack of contact, or no direction applies.
    Unknown,
}

/// A convex part of the robot in the middles of both halves of an interval: a polygon, or a segment. A link's radius is
/// left to the margins of the tests.
pub(in crate::collision) trait Part {
    /// The corners, counter-clockwise.
    fn corners(&self) -> impl Iterator<Item = MovingPoint> + Clone;

    /// The number of directions of its own that the part offers to separate it from a polygon. The normals of its sides
    /// come first.
    fn directions(&self) -> usize;

    /// The number of its sides.
    fn sides(&self) -> usize;

    /// One of them, with the polygon's support and the distance of the part ahead of it.
    fn direction(&self, i: usize, faces: &[Face]) -> Direction;

    /// The vector from `p` to the nearest point of the part in the middle of a half; zero where `p` is inside.
    fn offset_from(&self, half: usize, p: Point) -> Vector;

    /// The same in the middles of both halves.
    #[inline(always)]
    fn offsets_from(&self, p: Point) -> Plane<Halves> {
        let (a, b) = (self.offset_from(0, p), self.offset_from(1, p));
        Plane { x: Halves::new([a.x, b.x]), y: Halves::new([a.y, b.y]) }
    }

    /// Boxes that hold the part on each half: the least x and y, then the largest.
    #[inline(always)]
    fn swept_boxes(&self) -> [Plane<Halves>; 2] {
        let far = Halves::splat(f64::INFINITY);
        let (mut min, mut max) = (Plane { x: far, y: far }, Plane { x: -far, y: -far });
        for corner in self.corners() {
            let [low, high] = corner.swept_box();
            min = Plane { x: min.x.lesser(low.x), y: min.y.lesser(low.y) };
            max = Plane { x: max.x.greater(high.x), y: max.y.greater(high.y) };
        }
        [min, max]
    }

    /// How far the part is ahead of the line n.x = `support` in the middle.
    #[inline(always)]
    fn ahead(&self, n: Plane<Halves>, support: Halves) -> Halves {
        let mut least = Halves::splat(f64::INFINITY);
        for corner in self.corners() {
            least = least.lesser(n.dot(corner.position) - support);
        }
        least
    }

    /// The halves on which the part stays ahead of the line n.x = `support` by more than `margin`.
    #[inline(always)]
    fn stays_ahead(&self, n: Plane<Halves>, support: Halves, margin: f64) -> u32 {
        let mut stays = BOTH;
        for corner in self.corners() {
            stays &= ((n.dot(corner.position) - support) - corner.retreat(n)).above(Halves::splat(margin));
        }
        stays
    }
}

/// A unit vector from an obstacle towards a part, the obstacle's support in it, and how far the part is ahead of that.
pub(in crate::collision) struct Direction {
    pub n: Plane<Halves>,
    pub support: Halves,
    pub ahead: Halves,
}

/// The result of [`separate_from_polygon`] or [`separate_from_disc`].
pub(in crate::collision) struct Separated {
    /// The halves on which the two are apart.
    pub apart: u32,
    /// How far apart they are in the middles, along the best direction; and the indices of these directions.
    ahead: Halves,
    hints: Halves,
}

impl Separated {
    /// Tries direction `i`. Returns whether the two are apart on both halves.
    #[inline(always)]
    fn offer(&mut self, part: &impl Part, i: usize, direction: Direction, margin: f64) -> bool {
        let Direction { n, support, ahead } = direction;
        self.hints = ahead.simd_gt(self.ahead).bitselect(Halves::splat(i as f64), self.hints);
        self.ahead = self.ahead.greater(ahead);
        if ahead.above(Halves::splat(margin)) & !self.apart != 0 {
            self.apart |= part.stays_ahead(n, support, margin);
        }
        self.apart == BOTH
    }

    /// The separation on a half, and the next hint: the direction that separates the two best in its middle. `Unknown` if
    /// none separates them by `margin` there; `Touching` only if none would separate them even if they overlapped by `slack`.
    #[inline(always)]
    pub fn on(&self, half: usize, margin: f64, slack: f64) -> (Separation, u32) {
        let ahead = self.ahead.to_array()[half];
        let answer = if self.apart >> half & 1 != 0 {
            Separation::Apart
        } else if ahead > margin {
            Separation::Open
        } else if ahead > -slack {
            Separation::Unknown
        } else {
            Separation::Touching
        };
        (answer, self.hints.to_array()[half] as u32)
    }
}

/// Tries the normals of the polygon's faces and the part's own directions, `hint` first if there is one, until the two are
/// apart on both halves.
#[inline(always)]
pub(in crate::collision) fn separate_from_polygon(
    part: &impl Part,
    faces: &[Face],
    hint: u32,
    margin: f64,
    slack: f64,
) -> Separated {
    let mut all = Separated { apart: 0, ahead: Halves::splat(f64::NEG_INFINITY), hints: Halves::splat(0.0) };
    if hint != NO_HINT {
        let (n, support) = match faces.get(hint as usize) {
            Some(face) => (Plane::splat(face.normal), Halves::splat(face.support)),
            None => {
                let own = part.direction(hint as usize - faces.len(), faces);
                (own.n, own.support)
            }
        };
        all.apart = part.stays_ahead(n, support, margin);
        if all.apart == BOTH {
            return all;
        }
    }
    for (i, face) in faces.iter().enumerate() {
        let (n, support) = (Plane::splat(face.normal), Halves::splat(face.support));
        if all.offer(part, i, Direction { n, support, ahead: part.ahead(n, support) }, margin) {
            return all;
        }
    }
    for i in 0..part.directions() {
        // Where no side of either separates the two, nothing does.
        if i == part.sides() && all.ahead.above(Halves::splat(-slack)) == 0 {
            break;
        }
        if all.offer(part, faces.len() + i, part.direction(i, faces), margin) {
            break;
        }
    }
    all
}

/// Tries the directions from the centre of the disc to the nearest points of the part. There are no hints.
#[inline(always)]
pub(in crate::collision) fn separate_from_disc(part: &impl Part, disc: &Disc, margin: f64) -> Separated {
    let (towards, radius) = (part.offsets_from(disc.center), Halves::splat(disc.radius));
    let length = towards.dot(towards).sqrt();
    // Not numbers if the centre is in the part: then no line keeps the two apart.
    let n = towards * (Halves::splat(1.0) / length);
    let apart = part.stays_ahead(n, n.dot(Plane::splat(disc.center.coords)) + radius, margin);
    Separated { apart, ahead: length - radius, hints: Halves::splat(f64::from(NO_HINT)) }
}

/// The vector from the obstacle to the part in the middle of a half, between their nearest points, and their distance; for a
/// polygon and a part that do not overlap. The distance is negative if the nearest point is inside a disc, and no more than 0 if
/// a disc's centre is inside the part.
pub(in crate::collision) fn offset(
    part: &impl Part,
    half: usize,
    obstacles: &Obstacles,
    obstacle: usize,
) -> (Vector, f64) {
    if let Some(disc) = obstacles.disc(obstacle) {
        let to = part.offset_from(half, disc.center);
        return (to, to.norm() - disc.radius);
    }
    let faces = obstacles.faces(obstacle);
    let mut nearest = (f64::INFINITY, Vector::zeros());
    let mut offer = |to: Vector| {
        let squared = to.norm_squared();
        if squared < nearest.0 {
            nearest = (squared, to);
        }
    };
    for (a, b) in part.corners().zip(part.corners().cycle().skip(1)) {
        let (a, b) = (a.place(half), b.place(half));
        for (k, face) in faces.iter().enumerate() {
            let next = faces[if k + 1 == faces.len() { 0 } else { k + 1 }].corner;
            offer(nearest_point(face.corner, a, b) - face.corner);
            offer(a - nearest_point(a, face.corner, next));
        }
    }
    (nearest.1, nearest.0.sqrt())
}

/// A box that holds the part on a half.
pub(in crate::collision) fn swept_box(part: &impl Part, half: usize) -> Aabb {
    let [min, max] = part.swept_boxes().map(|bound| Point::from(bound.half(half)));
    Aabb { min, max }
}

/// Whether some direction separates the two by more than `margin` on the whole half: that of the vector `towards` from the
/// obstacle to the part; with `all`, the best there is.
///
/// The region that the bound on motion allows a part to reach is convex, and so is its difference from the obstacle: the
/// direction sought leads from the origin to the nearest point of that difference. It is found as by Gilbert, Johnson and
/// Keerthi 1988, "A fast procedure for computing the distance between complex objects in three-dimensional space".
pub(in crate::collision) fn find_direction(
    part: &impl Part,
    half: usize,
    obstacles: &Obstacles,
    obstacle: usize,
    mut towards: Vector,
    margin: f64,
    all: bool,
) -> bool {
    let (faces, disc) = (obstacles.faces(obstacle), obstacles.disc(obstacle));
    // The nearest segment so far, of points of the difference.
    let mut segment = None;
    for _ in 0..if all { DIRECTIONS } else { 1 } {
        let length = towards.norm();
        if length <= margin {
            return false;
        }
        let n = towards / length;
        let (support, foremost) = support(n, faces, disc);
        let mut rearmost = (f64::INFINITY, Vector::zeros());
        for corner in part.corners() {
            let point = corner.rearmost(half, n);
            let along = n.dot(&point);
            rearmost = if along < rearmost.0 { (along, point) } else { rearmost };
        }
        if rearmost.0 - support > margin {
            return true;
        }
        let new = rearmost.1 - foremost;
        let (a, b) = segment.unwrap_or((new, new));
        let nearest = |end: Vector| nearest_point(Point::origin(), Point::from(end), Point::from(new)).coords;
        let (from_a, from_b) = (nearest(a), nearest(b));
        let is_a = from_a.norm_squared() < from_b.norm_squared();
        (towards, segment) = if is_a { (from_a, Some((a, new))) } else { (from_b, Some((b, new))) };
    }
    false
}

/// How far the obstacle reaches in the unit direction `n`, and the point where it does.
fn support(n: Vector, faces: &[Face], disc: Option<&Disc>) -> (f64, Vector) {
    if let Some(disc) = disc {
        return (n.dot(&disc.center.coords) + disc.radius, disc.center.coords + n * disc.radius);
    }
    let mut most = (f64::NEG_INFINITY, Vector::zeros());
    for face in faces {
        let along = n.dot(&face.corner.coords);
        most = if along > most.0 { (along, face.corner.coords) } else { most };
    }
    most
}

/// How far the polygon reaches in the unit direction `n`.
#[inline(always)]
pub(in crate::collision) fn polygon_support(n: Plane<Halves>, faces: &[Face]) -> Halves {
    let mut most = Halves::splat(f64::NEG_INFINITY);
    for face in faces {
        most = most.greater(n.dot(Plane::splat(face.corner.coords)));
    }
    most
}

/// The point of the segment from `a` to `b` nearest to `p`.
#[inline(always)]
pub(in crate::collision) fn nearest_point(p: Point, a: Point, b: Point) -> Point {
    let along = b - a;
    let (to, length_squared) = ((p - a).dot(&along), along.norm_squared());
    if to >= length_squared {
        b
    } else if to > 0.0 {
        a + along * (to / length_squared)
    } else {
        a
    }
}
