//! A rigid body or a car: the edges of its outline. An obstacle gets inside only across them; so the start of each leg is
//! checked for obstacles inside, and all of it for contact.
//!
//! With w the turn and s the length of an arc along a leg, no point accelerates by more than |w| (|s| + |w| r), r the distance of
//! the farthest vertex from the origin of the body's frame; on a straight leg by no more than w^2 r; on a blend, w its greatest
//! turn rate, by no more than that, the acceleration of the origin, and r times that of the turn.

use super::blend::Quadratic;
use super::moving::{Checker, Moving, Stretch};
use super::{Examined, PLACEMENT, Scale, difference};
use crate::geometry::{Polygon, arc_pose};
use crate::scenario::World;
use std::f64::consts::{PI, TAU};

/// A little more than a whole turn, in radians.
const ONE_TURN: f64 = TAU + 1e-9;

/// A part of a body's path from a start: at constant rates, or with rates that change at a constant rate.
#[derive(Debug, Clone, Copy)]
pub struct Leg {
    /// (x, y, theta), in metres and radians.
    from: [f64; 3],
    /// The displacement of the origin in a straight line.
    line: [f64; 2],
    /// The distance along the body's own x axis.
    arc: f64,
    /// The turn.
    turn: f64,
    /// What t^2 is multiplied with: 0 at constant rates.
    bend: [f64; 3],
}

impl Leg {
    /// From one placement straight to another, turning in the shorter direction.
    ///
    /// # Panics
    /// If either has fewer than three entries.
    pub fn straight(a: &[f64], b: &[f64]) -> Self {
        let step = difference(&PLACEMENT, a, b);
        Self { from: placement(a), line: [step[0], step[1]], arc: 0.0, turn: step[2], bend: [0.0; 3] }
    }

    /// From a placement along an arc of this length, in metres, backward if negative, while turning by `turn` radians.
    ///
    /// # Panics
    /// If `from` has fewer than three entries.
    pub fn arc(from: &[f64], length: f64, turn: f64) -> Self {
        Self { from: placement(from), line: [0.0; 2], arc: length, turn, bend: [0.0; 3] }
    }

    /// Along a blend.
    pub(super) fn blend(motion: &Quadratic) -> Self {
        let [from, rate, bend] = [&motion.from, &motion.rate, &motion.bend].map(|v| [v[0], v[1], v[2]]);
        Self { from, line: [rate[0], rate[1]], arc: 0.0, turn: rate[2], bend }
    }

    /// The placement at `t` in [0, 1]; the angle is not wrapped.
    pub fn at(&self, t: f64) -> [f64; 3] {
        let ([x, y, theta], turn) = (self.from, t * self.turn);
        if self.arc == 0.0 {
            let [bend_x, bend_y, bend_turn] = self.bend.map(|bend| t * t * bend);
            return [x + t * self.line[0] + bend_x, y + t * self.line[1] + bend_y, theta + turn + bend_turn];
        }
        if turn.abs() <= PI {
            return arc_pose(self.from, self.arc, self.turn, t);
        }
        // Whole turns cancel: only the rest counts, which is rounded less.
        arc_pose(self.from, self.arc / self.turn, 1.0, libm::remainder(turn, TAU))
    }

    /// The part of the leg that decides about all of it: an arc of several turns repeats its placements.
    fn first_turn(&self) -> Self {
        let turn = self.turn.abs();
        if turn <= ONE_TURN {
            return *self;
        }
        let part = ONE_TURN / turn;
        Self { arc: self.arc * part, turn: self.turn * part, ..*self }
    }

    /// The greatest speed of the origin.
    fn speed(&self) -> f64 {
        let ([x, y], [bend_x, bend_y, _]) = (self.line, self.bend);
        length(x, y).max(length(x + 2.0 * bend_x, y + 2.0 * bend_y)) + self.arc.abs()
    }

    /// The greatest turn rate.
    fn turn_rate(&self) -> f64 {
        self.turn.abs().max((self.turn + 2.0 * self.bend[2]).abs())
    }
}

fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// (x, y, theta) without whole turns.
fn placement(q: &[f64]) -> [f64; 3] {
    [q[0], q[1], difference(&PLACEMENT, &[0.0; 3], q)[2]]
}

/// Examines every leg of a body of this shape, larger by a margin on all sides, each leg with its name.
pub(super) fn check(
    world: &World,
    (shape, margin): (&Polygon, f64),
    legs: impl IntoIterator<Item = (Stretch, Leg)>,
    scale: &Scale,
) -> Result<Examined, String> {
    let mut checker = Checker::new(world, scale);
    let reach = shape.reach();
    for (stretch, leg) in legs {
        let leg = leg.first_turn();
        // The vertices, the first repeated at the end.
        let points = |t: f64| {
            let mut points = shape.placed(leg.at(t)).vertices().to_vec();
            points.push(points[0]);
            points
        };
        let turn = leg.turn_rate();
        let count = shape.vertices().len() + 1;
        let travel = vec![leg.speed() + turn * reach; count];
        let [bend_x, bend_y, bend_turn] = leg.bend;
        let bent = 2.0 * (length(bend_x, bend_y) + bend_turn.abs() * reach);
        let bulge = vec![(turn * (leg.arc.abs() + turn * reach) + bent) / 8.0; count];
        let body = Some(shape.placed(leg.at(0.0)));
        let part_name = |_| "the body".into();
        let robot =
            Moving { stretch, points: &points, travel: &travel, bulge: &bulge, radius: margin, body, part_name };
        checker.check_start(&robot)?;
        checker.check_edge(&robot)?;
    }
    Ok(checker.examined)
}
