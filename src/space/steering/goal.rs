//! A goal in the frame of the start, and the shortest of the words that lead there.

use super::{Curve, Pose, Turn, wrap};
use std::f64::consts::{PI, TAU};

/// How far a curve may end from its goal, as a part of all lengths that are rounded, and in radians.
const SLACK: f64 = 1e-13;

/// A word must be shorter by more than this part, and than the effect of rounding, to be taken instead of an earlier one.
const TIE: f64 = 1e-12;

/// A goal relative to a start at (0, 0) with heading 0, in radii.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    x: f64,
    y: f64,
    /// In (-pi, pi].
    pub heading: f64,
    sin: f64,
    cos: f64,
    /// From the centre of the circle to the left of the start to that to the left of the goal.
    pub left: Between,
    /// The same to that to the right of the goal.
    pub right: Between,
    /// The largest effect of rounding, in radii.
    pub slack: f64,
    /// Whether left and right are exchanged.
    is_mirrored: bool,
}

/// A vector between the centres of two turning circles, in radii: its parts, its length and its angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Between {
    pub x: f64,
    pub y: f64,
    pub length: f64,
    pub angle: f64,
}

impl Between {
    fn new(x: f64, y: f64) -> Self {
        Self { x, y, length: (x * x + y * y).sqrt(), angle: libm::atan2(y, x) }
    }

    /// The length of a straight line between the circles if they are passed on opposite sides: the other leg of a right
    /// triangle with a leg of 2; not a number if they overlap.
    pub fn inner(&self) -> f64 {
        (self.length * self.length - 4.0).sqrt()
    }
}

impl Goal {
    /// The pose `to` relative to `from`.
    pub fn new(from: Pose, to: Pose, radius: f64) -> Self {
        let (sin, cos) = libm::sincos(from.heading);
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let (x, y) = ((cos * dx + sin * dy) / radius, (cos * dy - sin * dx) / radius);
        let heading = wrap(to.heading - from.heading);
        let largest = [from.x, from.y, to.x, to.y].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let slack = SLACK * (1.0 + (x * x + y * y).sqrt() + largest / radius);
        Self::seen(x, y, heading, libm::sincos(heading), slack, false)
    }

    fn seen(x: f64, y: f64, heading: f64, (sin, cos): (f64, f64), slack: f64, is_mirrored: bool) -> Self {
        let (left, right) = (Between::new(x - sin, y - 1.0 + cos), Between::new(x + sin, y - 1.0 - cos));
        Self { x, y, heading, sin, cos, left, right, slack, is_mirrored }
    }

    /// The goal in a mirror.
    pub fn mirrored(&self) -> Self {
        Self::seen(self.x, -self.y, -self.heading, (-self.sin, self.cos), self.slack, !self.is_mirrored)
    }

    /// The words of at most two segments that lead there but for rounding, with unwrapped angles; fewer segments first. The
    /// straight line, which is its own mirror image, is listed once.
    fn short_words(&self) -> [Option<[(Turn, f64); 2]>; 5] {
        use Turn::{Left, Right, Straight};
        let Self { slack, heading, sin, cos, left, right, .. } = *self;
        let is_straight = !self.is_mirrored && self.y.abs() <= slack && heading.abs() <= SLACK;
        let (along, across) = (left.x * cos + left.y * sin, left.y * cos - left.x * sin);
        let turn = right.angle + 0.5 * PI;
        [
            is_straight.then_some([(Straight, self.x), (Straight, 0.0)]),
            (left.length <= slack).then_some([(Left, heading), (Straight, 0.0)]),
            (across.abs() <= slack).then_some([(Left, heading), (Straight, along)]),
            (left.y.abs() <= slack).then_some([(Straight, left.x), (Left, heading)]),
            ((right.length - 2.0).abs() <= slack).then_some([(Left, turn), (Right, turn - heading)]),
        ]
    }

    /// Whether the curve of radius 1 ends here.
    fn is_end_of(&self, curve: &Curve) -> bool {
        let end = curve.end(Pose { x: 0.0, y: 0.0, heading: 0.0 });
        let (x, y) = (end.x - self.x, end.y - self.y);
        // False if it is not a number.
        (x * x + y * y).sqrt() <= 2.0 * self.slack && wrap(end.heading - self.heading).abs() <= 2.0 * SLACK
    }
}

/// The shortest of the words offered, in radii.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shortest {
    best: Option<(Goal, Curve)>,
    /// A word is taken only if it is shorter than this.
    limit: f64,
    /// Whether every word is driven before it is taken.
    is_careful: bool,
}

impl Shortest {
    /// The shortest of the words to one goal that `offer_all` offers, in metres; `None` if none leads there. The shortest
    /// alone is driven; if it does not end at the goal, which rounding hardly ever causes, all are.
    pub fn find(radius: f64, offer_all: impl Fn(&mut Self)) -> Option<Curve> {
        for is_careful in [false, true] {
            let mut shortest = Self { best: None, limit: f64::INFINITY, is_careful };
            offer_all(&mut shortest);
            let (goal, curve) = shortest.best?;
            if is_careful || goal.is_end_of(&curve) {
                return Some(if goal.is_mirrored { curve.mirrored() } else { curve }.scaled(radius));
            }
        }
        None
    }

    /// Takes a word to the goal if it is shorter, and leads there.
    pub fn offer(&mut self, goal: &Goal, segments: &[(Turn, f64)]) {
        let length = segments.iter().fold(0.0, |sum, (_, length)| sum + length.abs());
        // A word that does not exist has a length that is not a number, for which this is false.
        if length < self.limit {
            let curve = Curve::new(1.0, segments);
            if !self.is_careful || goal.is_end_of(&curve) {
                self.best = Some((*goal, curve));
                self.limit = length - goal.slack - TIE * (1.0 + length);
            }
        }
    }
}

/// Passes the words of at most two segments to a goal, seen as it is and in the mirror, to `offer`, fewer segments first.
pub(super) fn short_words(sides: &[Goal; 2], mut offer: impl FnMut(&Goal, [(Turn, f64); 2])) {
    let words = [sides[0].short_words(), sides[1].short_words()];
    for i in 0..words[0].len() {
        for (side, words) in sides.iter().zip(&words) {
            words[i].into_iter().for_each(|word| offer(side, word));
        }
    }
}

/// The angle in (-pi, pi] that differs by whole turns from one of a few turns.
pub(super) fn shorter(mut angle: f64) -> f64 {
    while angle > PI {
        angle -= TAU;
    }
    while angle <= -PI {
        angle += TAU;
    }
    angle + 0.0
}

/// The angle in [0, 2 pi) that differs by whole turns from one of a few turns.
pub(super) fn forwards(mut angle: f64) -> f64 {
    while angle >= TAU {
        angle -= TAU;
    }
    while angle < 0.0 {
        angle += TAU;
    }
    // A rounding error below 0 has become a whole turn.
    if angle >= TAU { 0.0 } else { angle + 0.0 }
}
