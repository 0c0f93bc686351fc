//! When two robots touch along their trajectories, interval by interval between rows of either, for the verifier.
//!
//! The times of an interval are those since its begin, as a fraction of it, so that late times round no motion.
//! Relative to each other the centres move along a segment; while the discs around the robots are apart, so are they,
//! and discs are done. Bodies advance from the front: from a time at which they are a distance apart to the one before
//! which they cannot meet, and so on (conservative advancement: Mirtich 1996, "Impulse-based dynamic simulation of
//! rigid body systems").

use super::motion::{Motion, Pose, reach};
use super::trajectory::Trajectory;
use crate::geometry::{Point, Polygon, Vector, distance_point_segment, intersects_polygon_polygon, sort_stably, wrap};
use crate::scenario::Robot;
use serde::Serialize;

/// While bodies are in conflict, their distance is evaluated at least this number of times in each interval.
const LOOKS: f64 = 64.0;

/// The distances of bodies that a plan may take, however short it is, and how many more for each of its rows.
const MOST_DISTANCES: u64 = 200_000;
const MOST_PER_ROW: u64 = 2_000;

/// Two robots that touch for a while.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null, rename = "FleetConflict"))]
pub struct Conflict {
    /// The robots, by their indices, the lower first.
    pub robots: [usize; 2],
    /// When they come into contact, in seconds.
    pub from: f64,
    /// A time at which they are apart again; `None` if they never are.
    pub to: Option<f64>,
    /// Where they are at first: x, y, theta of each; theta of a disc is 0.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[[number, number, number], [number, number, number]]"))]
    pub places: [Pose; 2],
}

/// The conflicts of all pairs of trajectories, in the order of their times, and the number of distances evaluated.
///
/// # Complexity
/// O(pairs x their rows), and of bodies as many distances as the constants allow: what is undecided then counts as
/// conflict.
pub(super) fn found(robots: &[&Robot], trajectories: &[Trajectory], slack: f64) -> (Vec<Conflict>, u64) {
    let rows: usize = trajectories.iter().map(|trajectory| trajectory.times().len()).sum();
    let mut search =
        Search { slack, looks: 0, left: MOST_DISTANCES + MOST_PER_ROW * rows as u64, conflicts: Vec::new() };
    let outer: Vec<Outline> = robots.iter().map(|robot| Outline::of(robot)).collect();
    for second in 1..robots.len() {
        for first in 0..second {
            let pair = [first, second];
            let [one, other] = pair.map(|i| trajectories[i].around());
            let reach = outer[first].radius + outer[second].radius + 2.0 * slack;
            let is_apart =
                (0..2).any(|axis| (one.min[axis] - other.max[axis]).max(other.min[axis] - one.max[axis]) > reach);
            if is_apart {
                search.looks += 1;
                continue;
            }
            search.pair(&Pair {
                indices: pair,
                robots: pair.map(|i| robots[i]),
                outlines: pair.map(|i| outer[i]),
                trajectories: pair.map(|i| &trajectories[i]),
            });
        }
    }
    sort_stably(&mut search.conflicts, |a, b| a.from.total_cmp(&b.from).then(a.robots.cmp(&b.robots)));
    (search.conflicts, search.looks)
}

/// The disc around a robot, and whether it is more than the robot.
#[derive(Clone, Copy)]
struct Outline {
    radius: f64,
    is_body: bool,
}

impl Outline {
    fn of(robot: &Robot) -> Self {
        match robot {
            Robot::Disc(disc) => Self { radius: disc.radius(), is_body: false },
            other => {
                let reach = other.placed_shape().map_or(0.0, |(shape, _)| shape.reach());
                Self { radius: reach, is_body: true }
            }
        }
    }
}

struct Pair<'a> {
    indices: [usize; 2],
    robots: [&'a Robot; 2],
    outlines: [Outline; 2],
    trajectories: [&'a Trajectory; 2],
}

/// The motions of two robots during an interval in which both are straight.
struct Interval {
    begin: f64,
    /// Seconds; infinite if both stand forever.
    duration: f64,
    from: [Pose; 2],
    /// The change of each coordinate until the end.
    delta: [Pose; 2],
}

impl Interval {
    /// What two motions have in common.
    fn of(motions: &[Motion; 2]) -> Self {
        let (begin, end) = (motions[0].begin.max(motions[1].begin), motions[0].end.min(motions[1].end));
        let (mut from, mut delta) = ([[0.0; 3]; 2], [[0.0; 3]; 2]);
        for (i, motion) in motions.iter().enumerate() {
            let whole = motion.end - motion.begin;
            let part = |time: f64| if whole > 0.0 && whole < f64::INFINITY { time / whole } else { 0.0 };
            let [passed, length] = [begin - motion.begin, end - begin].map(part);
            from[i] = [0, 1, 2].map(|k| motion.from[k] + passed * motion.delta[k]);
            delta[i] = [0, 1, 2].map(|k| length * motion.delta[k]);
        }
        Self { begin, duration: end - begin, from, delta }
    }

    /// The poses at a fraction of the interval.
    fn at(&self, part: f64) -> [Pose; 2] {
        [0, 1].map(|i| {
            let [x, y, theta] = [0, 1, 2].map(|k| self.from[i][k] + part * self.delta[i][k]);
            [x, y, wrap(theta)]
        })
    }

    fn time(&self, part: f64) -> f64 {
        if part > 0.0 { self.begin + part * self.duration } else { self.begin }
    }

    /// The fractions between which the centres are within a distance of each other; `None` if they never are.
    fn while_within(&self, most: f64) -> Option<[f64; 2]> {
        let apart = |of: &[Pose; 2]| Vector::new(of[1][0] - of[0][0], of[1][1] - of[0][1]);
        let (start, way) = (apart(&self.from), apart(&self.delta));
        let length = way.norm();
        if length == 0.0 {
            return (start.norm() <= most).then_some([0.0, 1.0]);
        }
        // The foot of the perpendicular, in metres along the way, and its length.
        let unit = way / length;
        let (foot, height) = (-start.dot(&unit), (start.x * unit.y - start.y * unit.x).abs());
        let beyond = foot - foot.clamp(0.0, length);
        if (height * height + beyond * beyond).sqrt() > most {
            return None;
        }
        let half = ((most - height).max(0.0) * (most + height)).sqrt();
        Some([(foot - half) / length, (foot + half) / length].map(|part| part.clamp(0.0, 1.0)))
    }
}

/// What has been found so far.
struct Search {
    /// At this distance or less robots touch, in metres.
    slack: f64,
    looks: u64,
    /// How many more distances of bodies may be evaluated.
    left: u64,
    conflicts: Vec<Conflict>,
}

impl Search {
    /// Finds the conflicts of two robots.
    fn pair(&mut self, pair: &Pair) {
        let mut rows = [0, 0];
        let mut touching = None;
        loop {
            let motions = [0, 1].map(|i| pair.trajectories[i].motion(rows[i]));
            let interval = Interval::of(&motions);
            if interval.duration > 0.0 {
                let goes_on = self.interval(pair, &interval, &mut touching);
                if !goes_on || interval.duration == f64::INFINITY {
                    break;
                }
            }
            let end = motions[0].end.min(motions[1].end);
            for i in 0..2 {
                rows[i] += usize::from(motions[i].end <= end);
            }
        }
        self.end(pair, &mut touching, None);
    }

    /// Finds the conflicts during an interval; false if no more distances may be evaluated.
    fn interval(&mut self, pair: &Pair, interval: &Interval, touching: &mut Option<(f64, [Pose; 2])>) -> bool {
        self.looks += 1;
        let reach = pair.outlines[0].radius + pair.outlines[1].radius + self.slack;
        let Some([first, last]) = interval.while_within(reach) else {
            self.end(pair, touching, Some(interval.begin));
            return true;
        };
        if first > 0.0 {
            self.end(pair, touching, Some(interval.begin));
        }
        let goes_on = if pair.outlines.iter().any(|outline| outline.is_body) {
            self.advance(pair, interval, [first, last], touching)
        } else {
            touching.get_or_insert_with(|| (interval.time(first), interval.at(first)));
            true
        };
        if goes_on && last < 1.0 {
            self.end(pair, touching, Some(interval.time(last)));
        }
        goes_on
    }

    /// Advances two bodies from one fraction of an interval to another.
    fn advance(
        &mut self,
        pair: &Pair,
        interval: &Interval,
        [first, last]: [f64; 2],
        touching: &mut Option<(f64, [Pose; 2])>,
    ) -> bool {
        let rate = pair.rate(interval);
        let mut part = first;
        loop {
            let places = interval.at(part);
            if self.left == 0 {
                touching.get_or_insert((interval.time(part), places));
                return false;
            }
            (self.left, self.looks) = (self.left - 1, self.looks + 1);
            let room = distance(pair.robots, places) - self.slack;
            // Apart, they cannot meet before; closer than the fraction can tell, they touch.
            let next = part + room.abs() / rate;
            let is_touching = room <= 0.0 || (next <= part && part < last);
            if is_touching {
                touching.get_or_insert((interval.time(part), places));
            } else {
                self.end(pair, touching, Some(interval.time(part)));
            }
            if part >= last || rate == 0.0 {
                return true;
            }
            // Touching, they are evaluated often; so they are if nothing moves.
            let next = if is_touching { next.max(part + (last - first).max(1e-9) / LOOKS) } else { next };
            part = next.min(last);
        }
    }

    /// Ends a conflict, if there is one.
    fn end(&mut self, pair: &Pair, touching: &mut Option<(f64, [Pose; 2])>, to: Option<f64>) {
        if let Some((from, places)) = touching.take() {
            self.conflicts.push(Conflict { robots: pair.indices, from, to, places });
        }
    }
}

impl Pair<'_> {
    /// How much the distance can change at most during a whole interval, in metres.
    fn rate(&self, interval: &Interval) -> f64 {
        let [one, other] = interval.delta;
        let (x, y) = (one[0] - other[0], one[1] - other[1]);
        let turning = |i: usize| {
            if self.outlines[i].is_body { self.outlines[i].radius * interval.delta[i][2].abs() } else { 0.0 }
        };
        (x * x + y * y).sqrt() + turning(0) + turning(1)
    }
}

/// The distance between two robots, in metres; 0 or less if they touch. By their outlines as placed, edge by edge: a thin
/// outline may cross itself by a rounding there.
fn distance(robots: [&Robot; 2], places: [Pose; 2]) -> f64 {
    let shape = |i: usize| robots[i].placed_shape().map(|(shape, _)| shape.placed(places[i]));
    let center = |i: usize| Point::new(places[i][0], places[i][1]);
    match (shape(0), shape(1)) {
        (None, None) => (center(0) - center(1)).norm() - reach(robots[0]) - reach(robots[1]),
        (Some(body), None) => from_body(center(1), &body) - reach(robots[1]),
        (None, Some(body)) => from_body(center(0), &body) - reach(robots[0]),
        (Some(a), Some(b)) => {
            if intersects_polygon_polygon(&a, &b) {
                return 0.0;
            }
            let least = |from: &Polygon, to: &Polygon| {
                from.vertices().iter().map(|&corner| from_border(corner, to)).fold(f64::INFINITY, f64::min)
            };
            least(&a, &b).min(least(&b, &a))
        }
    }
}

/// The distance of a point from a body, 0 inside.
fn from_body(point: Point, body: &Polygon) -> f64 {
    if body.contains(point) { 0.0 } else { from_border(point, body) }
}

/// The distance of a point from the border of a polygon.
fn from_border(point: Point, polygon: &Polygon) -> f64 {
    polygon.edges().map(|edge| distance_point_segment(point, &edge)).fold(f64::INFINITY, f64::min)
}
