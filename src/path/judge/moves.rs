//! The motions between the waypoints of a path, and their proofs.

use super::PathPlace;
use super::placed::{PlacedRobot, RobotShape, State};
use crate::collision::{BodyCollision, BodyMotion, LONGEST_TURN};
use crate::geometry::{arc_length, arc_pose};
use crate::problem::Validity;
use crate::robot::Arm;
use crate::scenario::Robot;
use crate::space::{MAX_DIMENSION, MotionSpace, ProductSpace, Space};
use crate::world::{Checker, PlanningWorld};

/// The tolerance is the finest; this coarsest one does not count.
const TOLERANCE: f64 = 1e-4;

/// A part of the path along which all coordinates, or the speed and the turn of a body, have constant rates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Move {
    edge: usize,
    /// The fractions of the edge at which it begins and ends.
    share: [f64; 2],
    from: State,
    rates: Rates,
}

#[derive(Debug, Clone, Copy)]
enum Rates {
    /// The change of each coordinate.
    Straight(State),
    /// The way along the body's own axis, in metres, and the turn.
    Arc { length: f64, turn: f64 },
}

impl Move {
    /// The configuration at `t` in [0, 1]; angles are not wrapped.
    pub fn at(&self, t: f64) -> State {
        let mut at = self.from;
        match self.rates {
            Rates::Straight(delta) => at.iter_mut().zip(delta).for_each(|(x, d)| *x += t * d),
            Rates::Arc { length, turn } => {
                let [x, y, theta] = arc_pose([at[0], at[1], at[2]], length, turn, t);
                (at[0], at[1], at[2]) = (x, y, theta);
            }
        }
        at
    }

    /// The part from `low` to `high`.
    pub fn part(&self, low: f64, high: f64) -> Self {
        let rates = match self.rates {
            Rates::Straight(delta) => Rates::Straight(delta.map(|d| d * (high - low))),
            Rates::Arc { length, turn } => Rates::Arc { length: length * (high - low), turn: turn * (high - low) },
        };
        Self { from: self.at(low), rates, share: [self.fraction(low), self.fraction(high)], ..*self }
    }

    /// The fraction of the edge.
    fn fraction(&self, t: f64) -> f64 {
        let [low, high] = self.share;
        if t == 1.0 { high } else { low + t * (high - low) }
    }

    /// The place of the path at `t`.
    pub fn place(&self, t: f64, dimension: usize) -> PathPlace {
        PathPlace { edge: self.edge, fraction: self.fraction(t), configuration: self.at(t)[..dimension].to_vec() }
    }

    /// The motion of a body.
    fn of_body(&self) -> BodyMotion {
        let from = [self.from[0], self.from[1], self.from[2]];
        match self.rates {
            Rates::Straight(delta) => BodyMotion::Straight { from, delta: [delta[0], delta[1], delta[2]] },
            Rates::Arc { length, turn } => BodyMotion::Arc { from, speed: length, turn_rate: turn, duration: 1.0 },
        }
    }
}

/// The proofs of a robot.
enum Proofs {
    Body(Box<BodyCollision>),
    /// Of a robot whose motions are straight.
    Straight(Box<dyn Validity<State>>),
}

/// A path as motions of its robot.
pub(super) struct Moves {
    space: ProductSpace<MAX_DIMENSION>,
    /// The waypoints, angles of circles wrapped.
    states: Vec<State>,
    arcs: bool,
    arm: Option<Arm>,
    shape: RobotShape,
    proofs: Proofs,
    slack: f64,
}

impl Moves {
    /// The path, of at least one configuration of the robot.
    pub fn new(world: &PlanningWorld, path: &[Vec<f64>], arcs: bool) -> Self {
        let space = world.default_space();
        let checker = world.checker(&MotionSpace::new(space.clone()), TOLERANCE).finest();
        let slack = checker.tolerance().eta;
        let proofs = match checker {
            Checker::Body(body, _) => Proofs::Body(Box::new(body)),
            other => Proofs::Straight(other.validity()),
        };
        let states = path.iter().map(|q| space.state(q)).collect();
        let arm = if let Robot::Arm(arm) = world.robot() { Some(arm.clone()) } else { None };
        Self { space, states, arcs, arm, shape: RobotShape::of(world.robot()), proofs, slack }
    }

    /// The number of numbers of a configuration.
    pub fn dimension(&self) -> usize {
        self.space.dimension()
    }

    /// What covers rounding, in metres.
    pub fn slack(&self) -> f64 {
        self.slack
    }

    /// The number of edges; one waypoint is an edge of rest.
    pub fn edges(&self) -> usize {
        (self.states.len() - 1).max(1)
    }

    /// The parts of the robot at a configuration.
    pub fn placed(&self, q: &State) -> PlacedRobot {
        self.shape.placed(q)
    }

    /// The ends of an edge.
    fn ends(&self, edge: usize) -> [&State; 2] {
        [&self.states[edge], &self.states[(edge + 1).min(self.states.len() - 1)]]
    }

    /// The robot at rest where an edge begins.
    pub fn rest(&self, edge: usize) -> Move {
        let rates = Rates::Straight([0.0; MAX_DIMENSION]);
        Move { edge, share: [0.0; 2], from: self.states[edge], rates }
    }

    /// The coordinate whose shorter direction is ambiguous.
    pub fn half_turn(&self, edge: usize) -> Option<usize> {
        let [a, b] = self.ends(edge);
        let delta = self.space.difference(a, b);
        (0..self.dimension()).find(|&i| self.space.is_circle(i) && delta[i].abs() >= LONGEST_TURN)
    }

    /// The joint that first leaves its limits on an edge, and the fraction from which it does.
    pub fn limit(&self, edge: usize) -> Option<(usize, f64)> {
        let joints = self.arm.as_ref()?.joint_types();
        let [a, b] = self.ends(edge);
        let left = joints.iter().enumerate().filter_map(|(i, joint)| {
            let [low, high] = joint.range()?;
            let beyond = |x: f64| x < low || x > high;
            match () {
                () if beyond(a[i]) => Some((i, 0.0)),
                () if beyond(b[i]) => {
                    let end = if b[i] < low { low } else { high };
                    Some((i, ((end - a[i]) / (b[i] - a[i])).clamp(0.0, 1.0)))
                }
                () => None,
            }
        });
        left.reduce(|first, next| if next.1 < first.1 { next } else { first })
    }

    /// The moves of an edge: one, or an arc and what is left to the waypoint.
    pub fn of_edge(&self, edge: usize) -> impl Iterator<Item = Move> + use<> {
        let [a, b] = self.ends(edge);
        let delta = self.space.difference(a, b);
        let straight = Move { edge, share: [0.0, 1.0], from: *a, rates: Rates::Straight(delta) };
        let [first, second] = if self.arcs { self.arc(straight, delta) } else { [Some(straight), None] };
        first.into_iter().chain(second)
    }

    /// The arc along a straight leg, and what is left, unless that is less than half the slack.
    fn arc(&self, straight: Move, delta: State) -> [Option<Move>; 2] {
        let (sin, cos) = libm::sincos(straight.from[2] + 0.5 * delta[2]);
        let chord = delta[0] * cos + delta[1] * sin;
        let length = arc_length(chord, delta[2]);
        let arc = Move { rates: Rates::Arc { length, turn: delta[2] }, ..straight };
        let (reached, wanted) = (arc.at(1.0), straight.at(1.0));
        let mut left = [0.0; MAX_DIMENSION];
        (left[0], left[1]) = (wanted[0] - reached[0], wanted[1] - reached[1]);
        let aside = libm::hypot(left[0], left[1]);
        if aside <= 0.5 * self.slack {
            return [Some(arc), None];
        }
        let share = length.abs() / (length.abs() + aside);
        let rest = Move { share: [share, 1.0], from: reached, rates: Rates::Straight(left), ..straight };
        [Some(Move { share: [0.0, share], ..arc }), Some(rest)]
    }

    /// The farthest that a point of the robot travels on a leg, in metres: at most in proportion on a part of it.
    pub fn travel(&self, leg: &Move) -> f64 {
        let (along, turn) = match &leg.rates {
            Rates::Straight(delta) => {
                if let Some(arm) = &self.arm {
                    return arm.travel(&delta[..self.dimension()])[arm.links().len() - 1];
                }
                (libm::hypot(delta[0], delta[1]), delta[2])
            }
            Rates::Arc { length, turn } => (length.abs(), *turn),
        };
        along + turn.abs() * self.shape.reach()
    }

    /// Where a leg can first not be proven free, all before it proven; `None` if it is free.
    pub fn first_hit(&self, leg: &Move) -> Option<f64> {
        match &self.proofs {
            Proofs::Body(body) => {
                let motion = leg.of_body();
                if body.is_motion_free(&motion) { None } else { body.first_hit(&motion) }
            }
            Proofs::Straight(validity) => {
                let [a, b] = [0.0, 1.0].map(|t| self.space.state(&leg.at(t)));
                if validity.is_motion_free(&a, &b) { None } else { validity.first_hit(&a, &b) }
            }
        }
    }
}
