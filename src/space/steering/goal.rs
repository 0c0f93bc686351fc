//! A goal in the frame of the start, and the shortest of the words that lead there.

use super::{Curve, Pose, Turn, wrap};
use std::f64::consts::{PI, TAU};

/// How far a curve may end from its goal, as a part of all lengths that are rounded, and in radians.
const SLACK: f64 = 1e-13;

/// A word must be shorter by more than this part, and than the effect of rounding, to be taken instead of an earlier one.
const TIE: f64 = 1e-12;

/// How far rounding may lift a lower bound above the length of a word, at most, as a part of it and in radii: cosines are
/// rounded by a few 1e-16, so angles from them by the root of that.
const ROUNDING: f64 = 1e-6;

/// An angle by its cosine and its sine; not numbers if it is undefined.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unit {
    pub cos: f64,
    pub sin: f64,
}

impl Unit {
    /// The sum of two angles.
    pub fn plus(self, other: Self) -> Self {
        Self { cos: self.cos * other.cos - self.sin * other.sin, sin: self.sin * other.cos + self.cos * other.sin }
    }

    /// The difference of two angles.
    pub fn minus(self, other: Self) -> Self {
        self.plus(Self { sin: -other.sin, ..other })
    }

    /// The angle half a turn on.
    pub fn opposite(self) -> Self {
        self.scaled(-1.0)
    }

    /// The angle a quarter of a turn on.
    pub fn next_quarter(self) -> Self {
        Self { cos: -self.sin, sin: self.cos }
    }

    /// Both parts times a number.
    pub fn scaled(self, factor: f64) -> Self {
        Self { cos: self.cos * factor, sin: self.sin * factor }
    }

    /// A lower bound on the angle by the shorter way: acos(1 - z) is sqrt(2 z) (1 + z / 12 + 3 z^2 / 160 + 5 z^3 / 896 + ...)
    /// with no negative term. 0.3 % below at a quarter of a turn, 18 % at a half.
    pub fn least(self) -> f64 {
        let z = (1.0 - self.cos).max(0.0);
        (z + z).sqrt() * (1.0 + z * (1.0 / 12.0 + z * (3.0 / 160.0 + z * (5.0 / 896.0))))
    }

    /// A lower bound on the angle forwards, in [0, 2 pi).
    pub fn least_forwards(self) -> f64 {
        // What rounding may have put below 0 counts as 0.
        if self.sin < -ROUNDING { PI + self.opposite().least() } else { self.least() }
    }
}

/// A goal relative to a start at (0, 0) with heading 0, in radii.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    x: f64,
    y: f64,
    /// In (-pi, pi].
    pub heading: f64,
    /// The same.
    pub facing: Unit,
    /// From the centre of the circle to the left of the start to that to the left of the goal.
    pub left: Between,
    /// The same to that to the right of the goal.
    pub right: Between,
    /// The largest effect of rounding, in radii.
    pub slack: f64,
    /// Whether left and right are exchanged.
    is_mirrored: bool,
}

/// A vector between the centres of two turning circles, in radii: its parts, its length and its direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Between {
    pub x: f64,
    pub y: f64,
    pub length: f64,
    pub direction: Unit,
}

impl Between {
    fn new(x: f64, y: f64) -> Self {
        let length = (x * x + y * y).sqrt();
        Self { x, y, length, direction: Unit { cos: x / length, sin: y / length } }
    }

    /// The angle of the vector.
    pub fn angle(&self) -> f64 {
        libm::atan2(self.y, self.x)
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
        let (sin, cos) = libm::sincos(heading);
        Self::seen(x, y, heading, Unit { cos, sin }, slack, false)
    }

    fn seen(x: f64, y: f64, heading: f64, facing: Unit, slack: f64, is_mirrored: bool) -> Self {
        let Unit { cos, sin } = facing;
        let (left, right) = (Between::new(x - sin, y - 1.0 + cos), Between::new(x + sin, y - 1.0 - cos));
        Self { x, y, heading, facing, left, right, slack, is_mirrored }
    }

    /// The goal in a mirror.
    pub fn mirrored(&self) -> Self {
        Self::seen(
            self.x,
            -self.y,
            -self.heading,
            Unit { sin: -self.facing.sin, ..self.facing },
            self.slack,
            !self.is_mirrored,
        )
    }

    /// A lower bound on the length of every curve that leads there, in reverse or not, in radii: the distance, the turn, and what
    /// the goal is aside takes. After a length s of L the heading is within s of 0 and within L - s of the goal's, h, so its sine
    /// is at most the lesser of s and |h| + L - s, and the car is aside by at most the integral, ((L + |h|)^2 - 2 h^2) / 4. The
    /// same holds for the start seen from the goal. A curve may end aside of its goal by rounding, which costs the root of that.
    fn least(&self) -> f64 {
        let Unit { cos, sin } = self.facing;
        let aside = self.y.abs().max((self.y * cos - self.x * sin).abs()) - 4.0 * self.slack;
        let turn = self.heading.abs();
        self.distance().max(turn).max((4.0 * aside.max(0.0) + 2.0 * turn * turn).sqrt() - turn)
    }

    /// The distance, in radii.
    fn distance(&self) -> f64 {
        (self.x * self.x + self.y * self.y).sqrt()
    }

    /// Whether certainly every curve forwards is longer than `most` radii. After a length s of L the heading is within s of 0 and
    /// within L - s of the goal's, h, if L + |h| is less than a whole turn; so in the direction of the start a curve leads ahead
    /// by at least the integral of the cosine of the lesser of s and |h| + L - s, 2 sin((L + |h|) / 2) - sin |h|. The same holds
    /// in the direction of the goal. L is at least the distance and the turn; between two lengths the bound is least at one of
    /// them.
    pub fn is_behind(&self, most: f64) -> bool {
        let turn = self.heading.abs();
        // The first terms of the series, below the sine.
        let sine = |a: f64| {
            let z = a * a;
            a * (1.0 - z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0 * (1.0 - z / 72.0 * (1.0 - z / 110.0)))))
        };
        let least = |length: f64| 2.0 * sine(0.5 * (length + turn)) - self.facing.sin.abs();
        let ahead = self.x.min(self.x * self.facing.cos + self.y * self.facing.sin) + 4.0 * self.slack + ROUNDING;
        most + turn < TAU - ROUNDING && ahead < least(most) && ahead < least(self.distance().max(turn))
    }

    /// The words of at most two segments that lead there but for rounding, with unwrapped angles; fewer segments first. The
    /// straight line, which is its own mirror image, is listed once.
    fn short_words(&self) -> [Option<[(Turn, f64); 2]>; 5] {
        use Turn::{Left, Right, Straight};
        let Self { slack, heading, facing: Unit { cos, sin }, left, right, .. } = *self;
        let is_straight = !self.is_mirrored && self.y.abs() <= slack && heading.abs() <= SLACK;
        let (along, across) = (left.x * cos + left.y * sin, left.y * cos - left.x * sin);
        [
            is_straight.then_some([(Straight, self.x), (Straight, 0.0)]),
            (left.length <= slack).then_some([(Left, heading), (Straight, 0.0)]),
            (across.abs() <= slack).then_some([(Left, heading), (Straight, along)]),
            (left.y.abs() <= slack).then_some([(Straight, left.x), (Left, heading)]),
            ((right.length - 2.0).abs() <= slack).then(|| {
                let turn = right.angle() + 0.5 * PI;
                [(Left, turn), (Right, turn - heading)]
            }),
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
pub(super) struct Shortest<'a> {
    best: Option<(&'a Goal, Curve)>,
    /// A word is taken only if it is shorter than this.
    limit: f64,
    /// Whether every word is driven before it is taken.
    is_careful: bool,
}

impl Shortest<'_> {
    /// The shortest of the words to a goal that `offer_all` offers, in metres, given the goal as it is and in the mirror; `None`
    /// if none leads there. The shortest alone is driven; if it does not end at the goal, which rounding hardly ever causes, all
    /// are.
    ///
    /// If the shortest is longer than `most` metres, the result is `None` or any longer curve. Words well above are not taken.
    /// This changes no other result: there are fewer than 100 words, so somewhere in the 100 ties above `most` there is a gap of
    /// a tie between their lengths, and the first word below the gap is taken whatever was taken before it.
    pub fn find(
        goal: &Goal,
        radius: f64,
        most: f64,
        offer_all: impl for<'b> Fn(&'b [Goal; 2], &mut Shortest<'b>),
    ) -> Option<Curve> {
        let most = most / radius;
        let limit = most + 100.0 * (goal.slack + 10.0 * TIE * (1.0 + most));
        let nothing = Shortest { best: None, limit, is_careful: false };
        if !nothing.wants(goal.least()) {
            return None;
        }
        let sides = [*goal, goal.mirrored()];
        for mut shortest in [nothing, Shortest { limit: f64::INFINITY, is_careful: true, ..nothing }] {
            let is_careful = shortest.is_careful;
            offer_all(&sides, &mut shortest);
            let (goal, curve) = shortest.best?;
            if is_careful || goal.is_end_of(&curve) {
                return Some(if goal.is_mirrored { curve.mirrored() } else { curve }.scaled(radius));
            }
        }
        None
    }
}

impl<'a> Shortest<'a> {
    /// Whether a word may be taken whose length has this lower bound, but for rounding. Always if the bound is not a number.
    pub fn wants(&self, bound: f64) -> bool {
        let is_longer = bound - ROUNDING * (1.0 + bound) >= self.limit;
        !is_longer
    }

    /// Takes a word to the goal if it is shorter, and leads there.
    pub fn offer(&mut self, goal: &'a Goal, segments: &[(Turn, f64)]) {
        let length = segments.iter().fold(0.0, |sum, (_, length)| sum + length.abs());
        // A word that does not exist has a length that is not a number, for which this is false.
        if length < self.limit {
            let curve = Curve::new(1.0, segments);
            if !self.is_careful || goal.is_end_of(&curve) {
                self.best = Some((goal, curve));
                self.limit = length - goal.slack - TIE * (1.0 + length);
            }
        }
    }
}

/// Passes the words of at most two segments to a goal, seen as it is and in the mirror, to `offer`, fewer segments first.
pub(super) fn short_words<'a>(sides: &'a [Goal; 2], mut offer: impl FnMut(&'a Goal, [(Turn, f64); 2])) {
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
