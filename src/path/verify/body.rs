//! A rigid body or a car: the edges of its outline. An obstacle gets inside only across them; so that none is inside is asked where
//! each leg starts, and that none is touched all along it.
//!
//! With w the turn and s the length of an arc along a leg, no point accelerates by more than |w| (|s| + |w| r), r the distance of
//! the farthest vertex from the origin of the body's frame; on a straight leg by no more than w^2 r.

use super::moving::{Judge, Moving};
use super::{Scale, Seen, difference};
use crate::geometry::{Point, Polygon, arc_pose};
use crate::scenario::World;
use std::f64::consts::{PI, TAU};

/// A little more than a whole turn, in radians.
const ONE_TURN: f64 = TAU + 1e-9;

/// A part of a body's path that is driven without a break: where it starts, and how it goes on at constant rates.
#[derive(Debug, Clone, Copy)]
pub struct Leg {
    /// (x, y, theta), in metres and radians.
    from: [f64; 3],
    /// The way of the origin in a straight line.
    way: [f64; 2],
    /// The way along the body's own x axis.
    arc: f64,
    /// By how much it turns.
    turn: f64,
}

impl Leg {
    /// From one placement straight to another, the short way round.
    ///
    /// # Panics
    /// Where either has fewer than three entries.
    pub fn straight(a: &[f64], b: &[f64]) -> Self {
        let step = difference(2, a, b);
        Self { from: placement(a), way: [step[0], step[1]], arc: 0.0, turn: step[2] }
    }

    /// From a placement along an arc of so many metres, backward where negative, while turning by `turn` radians.
    ///
    /// # Panics
    /// Where `from` has fewer than three entries.
    pub fn arc(from: &[f64], length: f64, turn: f64) -> Self {
        Self { from: placement(from), way: [0.0; 2], arc: length, turn }
    }

    /// Where the leg has led at `t` in [0, 1]; the angle is not wrapped.
    pub fn at(&self, t: f64) -> [f64; 3] {
        let ([x, y, theta], turn) = (self.from, t * self.turn);
        if self.arc == 0.0 {
            return [x + t * self.way[0], y + t * self.way[1], theta + turn];
        }
        if turn.abs() <= PI {
            return arc_pose(self.from, self.arc, self.turn, t);
        }
        // Once around leads back: what counts is the rest, which is rounded less.
        arc_pose(self.from, self.arc / self.turn, 1.0, libm::remainder(turn, TAU))
    }

    /// As much of the leg as tells about all of it: an arc of several turns comes by the same places again and again.
    fn first_turn(&self) -> Self {
        let turn = self.turn.abs();
        if turn <= ONE_TURN {
            return *self;
        }
        let part = ONE_TURN / turn;
        Self { arc: self.arc * part, turn: self.turn * part, ..*self }
    }

    /// How far the origin goes.
    fn path(&self) -> f64 {
        let [x, y] = self.way;
        (x * x + y * y).sqrt() + self.arc.abs()
    }
}

/// (x, y, theta) without whole turns: how steps are measured is how orientations are read.
fn placement(q: &[f64]) -> [f64; 3] {
    [q[0], q[1], difference(2, &[0.0; 3], q)[2]]
}

/// Judges every leg of a body of this shape, each with its number.
pub(super) fn judge(
    world: &World,
    shape: &Polygon,
    legs: impl IntoIterator<Item = (usize, Leg)>,
    scale: &Scale,
) -> Result<Seen, String> {
    let mut judge = Judge::new(world, scale);
    for (index, leg) in legs {
        let outline = Outline { shape, leg: leg.first_turn(), index, reach: shape.reach() };
        judge.look_at_start(&outline)?;
        judge.follow(&outline)?;
    }
    Ok(judge.seen)
}

/// The outline of a body on its way along one leg.
struct Outline<'a> {
    shape: &'a Polygon,
    leg: Leg,
    index: usize,
    reach: f64,
}

impl Moving for Outline<'_> {
    fn edge(&self) -> usize {
        self.index
    }

    /// The vertices, the first once more at the end.
    fn points(&self, t: f64) -> Vec<Point> {
        let placed = self.shape.placed(self.leg.at(t));
        let mut points = placed.vertices().to_vec();
        points.push(points[0]);
        points
    }

    fn travel(&self, _: usize) -> f64 {
        self.leg.path() + self.leg.turn.abs() * self.reach
    }

    fn bulge(&self, _: usize) -> f64 {
        let turn = self.leg.turn.abs();
        turn * (self.leg.arc.abs() + turn * self.reach) / 8.0
    }

    fn radius(&self) -> f64 {
        0.0
    }

    fn name(&self, _: usize) -> String {
        "the body".into()
    }

    fn encloses(&self, p: Point) -> bool {
        self.shape.placed(self.leg.at(0.0)).contains(p)
    }
}
