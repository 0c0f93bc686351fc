//! A link and an obstacle: are they apart on a whole stretch, do they touch in its middle?

use super::joint::MovingJoint;
use crate::collision::Obstacles;
use crate::collision::obstacles::Face;
use crate::geometry::{Disc, Point, Vector};

/// In place of a face: none in particular.
pub(super) const NO_HINT: u32 = u32::MAX;

/// What is known about a pair on a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::collision) enum Answer {
    /// Apart on the whole stretch.
    Apart,
    /// Not touching in the middle.
    Open,
    /// Touching in the middle.
    Touching,
    /// None of these could be told.
    Unknown,
}

/// A link in the middle of a stretch: both ends and the unit vector along it.
#[derive(Clone, Copy)]
pub(in crate::collision) struct Link<'a> {
    pub ends: [&'a MovingJoint; 2],
    pub along: Vector,
}

impl Link<'_> {
    /// Whether the link, ahead by `ahead` of something in direction `n`, is ahead by more than `margin` on the whole stretch.
    #[inline(always)]
    fn stays_ahead(&self, n: Vector, ahead: [f64; 2], margin: f64) -> bool {
        (ahead[0] - self.ends[0].fall(n) > margin) & (ahead[1] - self.ends[1].fall(n) > margin)
    }

    /// How far the ends are ahead of the line n.x = `support`.
    #[inline(always)]
    fn ahead(&self, n: Vector, support: f64) -> [f64; 2] {
        [self.ends[0].along(n) - support, self.ends[1].along(n) - support]
    }

    /// How far the polygon's corners are to the left of the link's line: the least and the most.
    #[inline(always)]
    fn sides(&self, faces: &[Face]) -> (f64, f64) {
        let across = Vector::new(-self.along.y, self.along.x);
        let line = self.ends[0].along(across);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for face in faces {
            let side = across.x * face.corner.x + across.y * face.corner.y - line;
            if side < low {
                low = side;
            }
            if side > high {
                high = side;
            }
        }
        (low, high)
    }

    /// Tries the outward normals of the polygon's faces and the normal of the link as separating directions, face `hint`
    /// first where there is one. `Unknown` where none separates the two by `margin` in the middle; `Touching` only where none
    /// would separate them even if they overlapped by `slack`. With the answer comes the next hint: the face that separates
    /// them best in the middle.
    #[inline(always)]
    pub fn separate_from_polygon(&self, faces: &[Face], hint: u32, margin: f64, slack: f64) -> (Answer, u32) {
        if let Some(face) = faces.get(hint as usize)
            && self.stays_ahead(face.normal, self.ahead(face.normal, face.support), margin)
        {
            return (Answer::Apart, hint);
        }
        let mut answer = Answer::Touching;
        let mut best = (margin, u32::MAX);
        for (i, face) in faces.iter().enumerate() {
            let ahead = self.ahead(face.normal, face.support);
            if (ahead[0] > -slack) & (ahead[1] > -slack) {
                let least = if ahead[0] < ahead[1] { ahead[0] } else { ahead[1] };
                if least > best.0 {
                    best = (least, i as u32);
                }
                if least > margin {
                    if self.stays_ahead(face.normal, ahead, margin) {
                        return (Answer::Apart, hint);
                    }
                    answer = Answer::Open;
                } else if answer == Answer::Touching {
                    answer = Answer::Unknown;
                }
            }
        }
        let (low, high) = self.sides(faces);
        let left = Vector::new(-self.along.y, self.along.x);
        let (n, ahead) = if low > -slack { (-left, low) } else { (left, -high) };
        if ahead > -slack {
            if ahead > margin {
                if self.stays_ahead(n, [ahead, ahead], margin) {
                    return (Answer::Apart, hint);
                }
                answer = Answer::Open;
            } else if answer == Answer::Touching {
                answer = Answer::Unknown;
            }
        }
        (answer, best.1)
    }

    /// For a link at rest: whether it is apart from the obstacle by more than `margin`, or nearer than that by more than
    /// `slack`; `Open` and `Unknown` where the directions at hand do not tell.
    #[inline]
    pub fn separate_at_rest(&self, obstacles: &Obstacles, obstacle: usize, margin: f64, slack: f64) -> Answer {
        let faces = obstacles.faces(obstacle);
        if !faces.is_empty() {
            return self.separate_from_polygon(faces, NO_HINT, margin, slack).0;
        }
        obstacles.disc(obstacle).map_or(Answer::Unknown, |disc| self.separate_from_disc(disc, margin, 2.0 * slack))
    }

    /// Tries the direction between the nearest points of link and polygon, which have a separating line. `margin` holds the
    /// slack; what is nearer to it than half the slack is `Unknown`.
    #[inline]
    pub fn separate_corners(&self, faces: &[Face], margin: f64, slack: f64) -> Answer {
        let [a, b] = self.ends.map(MovingJoint::place);
        let mut nearest = (f64::INFINITY, Vector::zeros());
        let mut offer = |to: Vector| {
            let squared = to.norm_squared();
            if squared < nearest.0 {
                nearest = (squared, to);
            }
        };
        for (i, face) in faces.iter().enumerate() {
            offer(nearest_point(face.corner, a, b) - face.corner);
            let next = faces[if i + 1 == faces.len() { 0 } else { i + 1 }].corner;
            offer(a - nearest_point(a, face.corner, next));
            offer(b - nearest_point(b, face.corner, next));
        }
        let distance = nearest.0.sqrt();
        if distance <= margin - 0.5 * slack {
            return Answer::Touching;
        }
        let n = nearest.1 / distance;
        let mut support = f64::NEG_INFINITY;
        for face in faces {
            let corner = n.x * face.corner.x + n.y * face.corner.y;
            if corner > support {
                support = corner;
            }
        }
        if self.stays_ahead(n, self.ahead(n, support), margin) {
            return Answer::Apart;
        }
        if distance > margin + 0.5 * slack { Answer::Open } else { Answer::Unknown }
    }

    /// Tries the direction from the disc's centre to the nearest point of the link.
    #[inline]
    pub fn separate_from_disc(&self, disc: &Disc, margin: f64, slack: f64) -> Answer {
        let [a, b] = self.ends.map(MovingJoint::place);
        let to = nearest_point(disc.center, a, b) - disc.center;
        let distance = to.norm();
        if distance - disc.radius <= margin - 0.5 * slack {
            return Answer::Touching;
        }
        let n = to / distance;
        let support = n.x * disc.center.x + n.y * disc.center.y + disc.radius;
        if self.stays_ahead(n, self.ahead(n, support), margin) {
            return Answer::Apart;
        }
        if distance - disc.radius > margin + 0.5 * slack { Answer::Open } else { Answer::Unknown }
    }
}

/// The point of the segment from `a` to `b` nearest to `p`.
#[inline(always)]
pub(super) fn nearest_point(p: Point, a: Point, b: Point) -> Point {
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
