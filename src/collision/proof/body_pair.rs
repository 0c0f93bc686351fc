//! A convex piece of a body and a convex obstacle: are they apart on a whole stretch, do they touch in its middle?

use super::Answer;
use super::body_shape::Corner;
use super::course::{Middle, left_of};
use super::pair::{NO_HINT, nearest_point};
use super::rotation::turned;
use crate::collision::Obstacles;
use crate::collision::obstacles::Face;
use crate::geometry::{Disc, Point, Vector};

/// A piece of a body in the middle of a stretch: its corners in the body's frame, and as seen from the frame's origin but
/// along the axes of the world.
#[derive(Clone, Copy)]
pub(in crate::collision) struct Piece<'a> {
    pub middle: &'a Middle,
    pub corners: &'a [Corner],
    pub places: &'a [Vector],
}

impl Piece<'_> {
    /// Whether the whole piece stays ahead of the line n.x = `support` by more than `margin`.
    #[inline(always)]
    fn stays_ahead(&self, n: Vector, support: f64, margin: f64) -> bool {
        self.middle.stays_ahead(n, support, margin, self.places)
    }

    /// How far the piece is ahead of the line n.x = `support` in the middle.
    #[inline(always)]
    fn ahead(&self, n: Vector, support: f64) -> f64 {
        let mut least = f64::INFINITY;
        for r in self.places {
            let along = n.x * r.x + n.y * r.y;
            least = if along < least { along } else { least };
        }
        (n.x * self.middle.place.x + n.y * self.middle.place.y) - support + least
    }

    /// The normal of the piece's own face, turned inwards: from an obstacle before the face towards the piece; and the
    /// obstacle's support in that direction.
    #[inline(always)]
    fn towards(&self, corner: &Corner, faces: &[Face]) -> (Vector, f64) {
        let n = -turned(corner.normal, self.middle.heading);
        (n, support(n, faces))
    }

    /// Tries the outward normals of the polygon's faces, those of the piece, and both directions across that of motion, `hint` first
    /// where there is one. `Unknown` where none separates the two by `margin` in the middle; `Touching` only where none would
    /// separate them even if they overlapped by `slack`. With the answer comes the next hint: the direction that separates
    /// them best in the middle.
    #[inline(always)]
    pub fn separate_from_polygon(
        &self,
        faces: &[Face],
        direction: Option<Vector>,
        hint: u32,
        margin: f64,
        slack: f64,
    ) -> (Answer, u32) {
        if hint != NO_HINT {
            let (n, support) = self.hinted(faces, direction, hint as usize);
            if self.stays_ahead(n, support, margin) {
                return (Answer::Apart, hint);
            }
        }
        let mut best = (f64::NEG_INFINITY, NO_HINT);
        for (i, face) in faces.iter().enumerate() {
            let ahead = self.ahead(face.normal, face.support);
            if ahead > best.0 {
                best = (ahead, i as u32);
            }
            if ahead > margin && self.stays_ahead(face.normal, face.support, margin) {
                return (Answer::Apart, hint);
            }
        }
        let (x, y) = (self.middle.place.x, self.middle.place.y);
        for (i, corner) in self.corners.iter().enumerate() {
            let (n, support) = self.towards(corner, faces);
            let ahead = (n.x * x + n.y * y) - corner.support - support;
            if ahead > best.0 {
                best = (ahead, (faces.len() + i) as u32);
            }
            if ahead > margin && self.stays_ahead(n, support, margin) {
                return (Answer::Apart, hint);
            }
        }
        if best.0 > -slack
            && let Some(direction) = direction
        {
            let n = left_of(direction);
            for (i, n) in [n, -n].into_iter().enumerate() {
                let support = support(n, faces);
                let ahead = self.ahead(n, support);
                if ahead > margin && self.stays_ahead(n, support, margin) {
                    return (Answer::Apart, hint);
                }
                if ahead > best.0 {
                    best = (ahead, (faces.len() + self.corners.len() + i) as u32);
                }
            }
        }
        let answer = if best.0 > margin {
            Answer::Open
        } else if best.0 > -slack {
            Answer::Unknown
        } else {
            Answer::Touching
        };
        (answer, best.1)
    }

    /// For a piece at rest: whether it is apart from the obstacle by more than `margin`, or nearer than that by more than `slack`;
    /// `Open` and `Unknown` where the directions at hand do not tell.
    #[inline]
    pub fn separate_at_rest(&self, obstacles: &Obstacles, obstacle: usize, margin: f64, slack: f64) -> Answer {
        if let Some(disc) = obstacles.disc(obstacle) {
            let (answer, clearance) = self.separate_from_disc(disc, margin);
            return if (clearance - margin).abs() <= slack { Answer::Unknown } else { answer };
        }
        self.separate_from_polygon(obstacles.faces(obstacle), None, NO_HINT, margin, slack).0
    }

    /// The direction of a hint, and the polygon's support in it.
    #[inline(always)]
    fn hinted(&self, faces: &[Face], direction: Option<Vector>, hint: usize) -> (Vector, f64) {
        if let Some(face) = faces.get(hint) {
            return (face.normal, face.support);
        }
        if let Some(corner) = self.corners.get(hint - faces.len()) {
            return self.towards(corner, faces);
        }
        let n = left_of(direction.unwrap_or_default());
        let n = if hint == faces.len() + self.corners.len() { n } else { -n };
        (n, support(n, faces))
    }

    /// Tries the direction between the nearest points of piece and polygon, which have a separating line; with the answer comes
    /// their distance.
    pub fn separate_corners(&self, faces: &[Face], margin: f64) -> (Answer, f64) {
        let mut nearest = (f64::INFINITY, Vector::zeros());
        let mut offer = |to: Vector| {
            let squared = to.norm_squared();
            if squared < nearest.0 {
                nearest = (squared, to);
            }
        };
        let at = |i: usize| Point::from(self.middle.place + self.places[i]);
        for i in 0..self.places.len() {
            let (a, b) = (at(i), at(if i + 1 == self.places.len() { 0 } else { i + 1 }));
            for (k, face) in faces.iter().enumerate() {
                let next = faces[if k + 1 == faces.len() { 0 } else { k + 1 }].corner;
                offer(nearest_point(face.corner, a, b) - face.corner);
                offer(a - nearest_point(a, face.corner, next));
            }
        }
        let distance = nearest.0.sqrt();
        if distance <= margin {
            return (Answer::Touching, distance);
        }
        let n = nearest.1 / distance;
        let is_apart = self.stays_ahead(n, support(n, faces), margin);
        (if is_apart { Answer::Apart } else { Answer::Open }, distance)
    }

    /// Tries the direction from the disc's centre to the nearest point of the piece; with the answer comes their distance, negative
    /// where the centre is inside the piece or the nearest point inside the disc.
    #[inline]
    pub fn separate_from_disc(&self, disc: &Disc, margin: f64) -> (Answer, f64) {
        let (x, y) = (self.middle.heading.x, self.middle.heading.y);
        let from = disc.center.coords - self.middle.place;
        let center = Vector::new(x * from.x + y * from.y, x * from.y - y * from.x);
        // The nearest point lies on the face that the centre is farthest before, where the centre is beside that one.
        let mut before = (f64::NEG_INFINITY, 0);
        for (i, corner) in self.corners.iter().enumerate() {
            let distance = corner.normal.dot(&center) - corner.support;
            if distance > before.0 {
                before = (distance, i);
            }
        }
        if before.0 <= 0.0 {
            return (Answer::Touching, before.0 - disc.radius);
        }
        let at = |i: usize| self.corners[if i == self.corners.len() { 0 } else { i }].at;
        let (corner, next) = (&self.corners[before.1], at(before.1 + 1));
        let along = left_of(corner.normal);
        let (mut to, mut distance) = (corner.normal, before.0);
        if along.dot(&(center - corner.at)) < 0.0 || along.dot(&(center - next)) > 0.0 {
            // All faces are asked: where two are in one line, or all but, rounding tells which of them is found.
            let mut least = f64::INFINITY;
            for i in 0..self.corners.len() {
                let nearest = nearest_point(Point::from(center), Point::from(at(i)), Point::from(at(i + 1)));
                let beyond = center - nearest.coords;
                if beyond.norm_squared() < least {
                    (to, least) = (beyond, beyond.norm_squared());
                }
            }
            distance = least.sqrt();
            to /= distance;
        }
        let clearance = distance - disc.radius;
        if clearance <= margin {
            return (Answer::Touching, clearance);
        }
        let n = -turned(to, self.middle.heading);
        let support = n.dot(&disc.center.coords) + disc.radius;
        (if self.stays_ahead(n, support, margin) { Answer::Apart } else { Answer::Open }, clearance)
    }
}

/// How far the polygon reaches in direction `n`.
#[inline(always)]
fn support(n: Vector, faces: &[Face]) -> f64 {
    let mut most = f64::NEG_INFINITY;
    for face in faces {
        let along = n.x * face.corner.x + n.y * face.corner.y;
        most = if along > most { along } else { most };
    }
    most
}
