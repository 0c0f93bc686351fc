//! Two robots that move at constant rates: whether they are apart all the time, and when they may not be.
//!
//! The motion of one disc relative to another is straight and at a constant rate, so their least distance is that of a point from
//! a segment, and they are too close between the two roots of a quadratic. Bodies are compared by the discs around them first,
//! then by the proof by halving: in the middle of an interval of time the distance is known, and a bound on how far the two can
//! move relative to each other until either end (Schwarzer, Saha and Latombe 2005, "Adaptive dynamic collision checking for
//! single and multiple articulated robots in complex environments").

use crate::geometry::{Aabb, Placed, Point, Polygon, Segment, distance_point_segment, wrap};
use crate::scenario::Robot;
use std::sync::Arc;

/// x, y in metres and theta in radians; theta of a disc is 0.
pub type Pose = [f64; 3];

/// The most distances of bodies that one proof evaluates.
const MOST_DISTANCES: u32 = 1 << 12;

/// The most comparisons of edges, and of boxes around edges, after which one proof begins no other distance.
const MOST_WORK: u64 = 1 << 18;

/// A distance is computed if it is no more than what is asked for, and by this part of it more, which covers rounding.
const BEYOND: f64 = 1e-9;

/// An interval whose bound on relative motion is below this many slacks is refused.
const FEWEST_SLACKS: f64 = 10.0;

/// Robots are apart if there are more than this number of slacks of a planner between the boxes of what they cover: that is more
/// than the margin of their proof, with what rounding of times can move them.
pub(super) const CLEAR: f64 = 4.0;

/// Rounding of the time t moves a robot of speed v by less than this times v t.
const ROUNDED: f64 = 1e-15;

/// In how many parts the time is cut in which the discs around two bodies meet, to find when the bodies do.
const PARTS: u32 = 32;

/// What a robot covers, prepared for distances to other robots.
#[derive(Debug, Clone)]
pub(super) struct Footprint {
    /// `None` of a disc; clones share it.
    body: Option<Arc<Polygon>>,
    radius: f64,
}

/// The radius of a disc, or of the disc about the origin of a body's frame that contains the body.
///
/// # Panics
/// If the robot is neither.
pub(super) fn reach(robot: &Robot) -> f64 {
    match robot {
        Robot::Disc(disc) => disc.radius(),
        other => other.placed_shape().expect("a robot of a fleet is a disc or a body").0.reach(),
    }
}

impl Footprint {
    /// The footprint of a disc or a body.
    pub fn of(robot: &Robot) -> Self {
        Self { body: robot.placed_shape().map(|(shape, _)| Arc::new(shape.clone())), radius: reach(robot) }
    }

    /// The radius of the disc, or of the disc about the origin of a body's frame that contains the body.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Whether the robot is a body.
    pub fn is_body(&self) -> bool {
        self.body.is_some()
    }

    /// How far a point of the robot moves at most per radian.
    pub fn reach(&self) -> f64 {
        if self.is_body() { self.radius } else { 0.0 }
    }

    /// Whether another robot is no farther than `most` metres, which is at least 0.
    pub fn is_within(&self, at: Pose, other: &Footprint, there: Pose, most: f64) -> bool {
        self.distance_within(at, other, there, most, &mut 0) <= most
    }

    /// The distance from another robot, in metres; 0 or less if they touch; if it is more than `most`, which is at
    /// least 0, that distance or infinity. `work` is increased by the number of comparisons of edges and of boxes
    /// around edges.
    fn distance_within(&self, at: Pose, other: &Footprint, there: Pose, most: f64, work: &mut u64) -> f64 {
        let [center, other_center] = [at, there].map(|[x, y, _]| Point::new(x, y));
        let apart = (center - other_center).norm() - self.radius - other.radius;
        let most = most * (1.0 + BEYOND);
        *work += 1;
        match (&self.body, &other.body) {
            (None, None) => apart,
            _ if apart > most => f64::INFINITY,
            (Some(body), None) => {
                Placed::new(body, at).distance_to_point(other_center, (most + other.radius) * (1.0 + BEYOND), work)
                    - other.radius
            }
            (None, Some(body)) => {
                Placed::new(body, there).distance_to_point(center, (most + self.radius) * (1.0 + BEYOND), work)
                    - self.radius
            }
            (Some(one), Some(two)) => Placed::new(one, at).distance(&Placed::new(two, there), most, work),
        }
    }

    /// How far the farthest point moves at most on the straight motion between two poses, in metres: its duration at a speed of 1
    /// m/s.
    pub fn travel(&self, from: Pose, to: Pose) -> f64 {
        let [x, y, turn] = difference(from, to);
        (x * x + y * y).sqrt() + self.reach() * turn.abs()
    }
}

/// The change of each coordinate, the angle the short way round.
pub(super) fn difference(from: Pose, to: Pose) -> Pose {
    [to[0] - from[0], to[1] - from[1], wrap(to[2] - from[2])]
}

/// A straight motion at constant rates, or a stand, during an interval of time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion {
    /// Seconds; `end` is infinite for a stand without end.
    pub begin: f64,
    pub end: f64,
    pub from: Pose,
    /// The change of each coordinate until `end`; 0 for a stand.
    pub delta: Pose,
}

impl Motion {
    /// The motion between two poses.
    pub fn new([begin, end]: [f64; 2], from: Pose, to: Pose) -> Self {
        Self { begin, end, from, delta: difference(from, to) }
    }

    /// The stand at a pose.
    pub fn standing([begin, end]: [f64; 2], at: Pose) -> Self {
        Self { begin, end, from: at, delta: [0.0; 3] }
    }

    /// The pose at a time between `begin` and `end`.
    #[inline]
    pub fn at(&self, time: f64) -> Pose {
        let duration = self.end - self.begin;
        let part = if duration > 0.0 { ((time - self.begin) / duration).min(1.0) } else { 0.0 };
        let ([x, y, theta], [dx, dy, turn]) = (self.from, self.delta);
        [x + part * dx, y + part * dy, theta + part * turn]
    }

    /// A box that contains all that a robot covers in this motion: that of the positions, and around it the radius.
    pub fn covered(&self, robot: &Footprint) -> Aabb {
        let [x, y, _] = self.from;
        Aabb::of(Point::new(x, y), Point::new(x + self.delta[0], y + self.delta[1])).grown(robot.radius)
    }

    /// The velocity: metres and radians per second.
    #[inline]
    pub fn rates(&self) -> Pose {
        let duration = self.end - self.begin;
        let [x, y, turn] = self.delta;
        if duration > 0.0 { [x / duration, y / duration, turn / duration] } else { [0.0; 3] }
    }
}

/// Two robots in motion at the same time.
pub(super) struct Pair<'a> {
    pub footprints: [&'a Footprint; 2],
    pub motions: [&'a Motion; 2],
    /// The slack of their world, in metres.
    pub slack: f64,
}

impl Pair<'_> {
    /// The time that both motions have in common; `None` if there is none. If both have no end, their first common moment.
    fn common(&self) -> Option<[f64; 2]> {
        let [a, b] = self.motions;
        let (begin, end) = (a.begin.max(b.begin), a.end.min(b.end));
        (begin <= end).then_some([begin, if end < f64::INFINITY { end } else { begin }])
    }

    /// The position of the second robot relative to the first.
    #[inline]
    fn offset(&self, time: f64) -> Point {
        let ([x, y, _], [other_x, other_y, _]) = (self.motions[0].at(time), self.motions[1].at(time));
        Point::new(other_x - x, other_y - y)
    }

    /// The distance up to which robots are in conflict: the slack, and what rounding of times can move them.
    fn margin(&self, until: f64) -> f64 {
        let speed = |motion: &Motion| {
            let [x, y, _] = motion.rates();
            x.abs() + y.abs()
        };
        self.slack + ROUNDED * until * (speed(self.motions[0]) + speed(self.motions[1]))
    }

    /// Whether the robots are proven apart during all of their common time, its ends included. Discs are refused if and only if
    /// they come closer than the slack.
    pub fn is_apart(&self) -> bool {
        self.is_apart_counted(&mut 0)
    }

    /// The same; `work` is increased by the number of comparisons. A proof that has done [`MOST_WORK`] is given up: it
    /// is bounded.
    pub fn is_apart_counted(&self, work: &mut u64) -> bool {
        *work += 1;
        let Some([begin, end]) = self.common() else { return true };
        let (margin, [a, b]) = (self.margin(end), self.footprints);
        let swept = Segment::new(self.offset(begin), self.offset(end));
        if distance_point_segment(Point::origin(), &swept) > a.radius + b.radius + margin {
            return true;
        }
        if !a.is_body() && !b.is_body() {
            return false;
        }
        self.is_apart_by_halving(begin, end, margin, work)
    }

    /// The proof by halving, the longest intervals first.
    fn is_apart_by_halving(&self, begin: f64, end: f64, margin: f64, work: &mut u64) -> bool {
        let most_work = *work + MOST_WORK;
        let [a, b] = self.footprints;
        let [rate, other] = self.motions.map(Motion::rates);
        let across = [other[0] - rate[0], other[1] - rate[1]];
        let fastest = (across[0] * across[0] + across[1] * across[1]).sqrt()
            + a.reach() * rate[2].abs()
            + b.reach() * other[2].abs();
        let mut open = std::collections::VecDeque::from([[begin, end]]);
        for _ in 0..MOST_DISTANCES {
            let Some([begin, end]) = open.pop_front() else { return true };
            if *work > most_work {
                return false;
            }
            let middle = 0.5 * (begin + end);
            let bound = fastest * 0.5 * (end - begin);
            // The discs around the bodies are cheaper, and mostly enough.
            if self.offset(middle).coords.norm() - a.radius - b.radius - bound > margin {
                continue;
            }
            let [at, there] = self.motions.map(|motion| motion.at(middle));
            let clearance = a.distance_within(at, b, there, bound + margin, work);
            if clearance <= margin {
                return false;
            }
            if clearance - bound <= margin {
                if bound < FEWEST_SLACKS * margin {
                    return false;
                }
                open.extend([[begin, middle], [middle, end]]);
            }
        }
        open.is_empty()
    }

    /// When the robots are not known to be apart: intervals of time in order, added to a list. The one of two discs is exact but
    /// for rounding. `is_apart` proves a pair of motions; its error ends the list.
    pub fn add_conflicts<E>(
        &self,
        found: &mut Vec<[f64; 2]>,
        mut is_apart: impl FnMut(&Pair) -> Result<bool, E>,
    ) -> Result<(), E> {
        let Some([begin, end]) = self.common() else { return Ok(()) };
        // Two stands: they conflict always or never.
        let is_standing = self.motions.iter().all(|motion| motion.end == f64::INFINITY);
        if is_standing {
            if !is_apart(self)? {
                found.push([begin, f64::INFINITY]);
            }
            return Ok(());
        }
        let Some([from, to]) = self.while_discs_meet(begin, end) else { return Ok(()) };
        if !self.footprints.iter().any(|footprint| footprint.is_body()) {
            found.push([from, to]);
            return Ok(());
        }
        let time = |i: u32| from + (to - from) * (f64::from(i) / f64::from(PARTS));
        for i in 0..PARTS {
            let part = [time(i), time(i + 1)];
            let motions = self.motions.map(|motion| Motion { begin: part[0], end: part[1], ..motion.during(part) });
            let pair = Pair { motions: [&motions[0], &motions[1]], ..*self };
            if !is_apart(&pair)? {
                found.push(part);
            }
        }
        Ok(())
    }

    /// When the discs around the robots are closer than the slack.
    fn while_discs_meet(&self, begin: f64, end: f64) -> Option<[f64; 2]> {
        let least = self.footprints[0].radius + self.footprints[1].radius + 2.0 * self.margin(end);
        let (from, to) = (self.offset(begin), self.offset(end));
        let (way, from) = (to - from, from.coords);
        // |from + s way| <= least, for s in [0, 1].
        let (square, half, rest) = (way.norm_squared(), from.dot(&way), from.norm_squared() - least * least);
        if square == 0.0 {
            return (rest <= 0.0).then_some([begin, end]);
        }
        let discriminant = half * half - square * rest;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let [first, last] = [(-half - root) / square, (-half + root) / square];
        let is_met = last >= 0.0 && first <= 1.0;
        is_met.then(|| [first.max(0.0), last.min(1.0)].map(|s| begin + s * (end - begin)))
    }
}

impl Motion {
    /// The part of the motion during an interval of time.
    fn during(&self, part: [f64; 2]) -> Self {
        let [from, to] = part.map(|time| self.at(time));
        Self { begin: part[0], end: part[1], from, delta: [0, 1, 2].map(|i| to[i] - from[i]) }
    }
}
