//! The robots that generators put into their worlds: a disc, an arm, a rigid body or a car.
//!
//! Body and car are the rectangle of the course reports, 0.2 m by 0.1 m, and the car has their wheelbase and limits.

use super::free::polygon;
use super::options::{Given, OptionInfo, OptionKind};
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::robot::{Arm, Car, DiscRobot, MAX_LINKS, Part, RigidBody, Weights};
use crate::scenario::{Goal, GoalTolerance, Query, Robot};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// The robot of a generated world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RobotChoice {
    /// A disc.
    Disc,
    /// An arm of so many equal links.
    Arm(usize),
    /// A rectangle that translates and turns.
    RigidBody,
    /// The same rectangle on wheels.
    Car,
}

/// Half the length and half the width of a body, in metres.
const HALF: [f64; 2] = [0.1, 0.05];

/// The wheelbase of a car, in metres.
const WHEELBASE: f64 = 0.2;

/// How fast a car goes either way, in metres a second.
const FASTEST: f64 = 0.5;

/// How far it steers either way, in radians.
const STEEPEST: f64 = FRAC_PI_4;

/// Its step of integration, in seconds.
const STEP: f64 = 0.01;

/// How near to its goal a car must come.
const NEAR: GoalTolerance = GoalTolerance { translation: 0.1, rotation: 0.5 };

/// The side of the box that most worlds are, in metres.
pub(super) const SIDE: f64 = 2.0;

/// How far an arm reaches from the middle of the box, in metres; with the largest radius it stays inside.
const REACH: f64 = 0.8;

/// The row of the option `robot`.
pub(super) const ROBOT: OptionInfo = OptionInfo {
    name: "robot",
    title: "Robot",
    kind: OptionKind::Choice(&["disc", "arm", "rigid_body", "car"]),
    unit: "",
    meaning: "What moves.",
};

/// The row of the option `links`.
pub(super) const LINKS: OptionInfo = OptionInfo {
    name: "links",
    title: "Links",
    kind: OptionKind::Integer { min: 1.0, max: MAX_LINKS as f64, default: 2.0 },
    unit: "",
    meaning: "How many links the arm has; for an arm only.",
};

/// The row of the option `radius`.
pub(super) const RADIUS: OptionInfo = OptionInfo {
    name: "radius",
    title: "Radius of the robot",
    kind: OptionKind::Number { min: 0.0, max: 0.1, default: 0.03 },
    unit: "m",
    meaning: "The radius of the disc, or half the width of the arm's links; not for a body or a car.",
};

/// The same row where only a disc moves.
pub(super) const DISC_RADIUS: OptionInfo = OptionInfo { meaning: "The radius of the disc.", ..RADIUS };

impl RobotChoice {
    /// Reads `robot` and, for an arm only, `links`.
    pub(super) fn read(given: &Given) -> Result<Self, Error> {
        let choice = match given.choice("robot")? {
            0 => RobotChoice::Disc,
            1 => return Ok(RobotChoice::Arm(given.integer("links")?)),
            2 => RobotChoice::RigidBody,
            _ => RobotChoice::Car,
        };
        if let Some(links) = given.field("links") {
            let sentence = format!("{} has no links; say \"robot\": \"arm\" for an arm", choice.article());
            return Err(links.error(Code::UnknownField, sentence));
        }
        if let Some(radius) = given.field("radius").filter(|_| choice != RobotChoice::Disc) {
            let sentence = format!("{} has no radius: it is a rectangle of 0.2 m by 0.1 m", choice.article());
            return Err(radius.error(Code::UnknownField, sentence));
        }
        Ok(choice)
    }

    fn article(self) -> &'static str {
        match self {
            RobotChoice::Disc => "a disc",
            RobotChoice::Arm(_) => "an arm",
            RobotChoice::RigidBody => "a rigid body",
            RobotChoice::Car => "a car",
        }
    }

    /// The value of `links` to be checked: of an arm only.
    pub(super) fn links(self) -> Option<(&'static str, f64)> {
        if let RobotChoice::Arm(links) = self { Some(("links", links as f64)) } else { None }
    }

    /// What a scenario's name calls it: `disc`, `3r`, `body` or `car`.
    pub(super) fn id(self) -> String {
        match self {
            RobotChoice::Disc => "disc".to_owned(),
            RobotChoice::Arm(links) => format!("{links}r"),
            RobotChoice::RigidBody => "body".to_owned(),
            RobotChoice::Car => "car".to_owned(),
        }
    }

    /// What a scenario's title calls it.
    pub(super) fn title(self) -> String {
        match self {
            RobotChoice::Disc => "Disc".to_owned(),
            RobotChoice::Arm(links) => format!("{links}R arm"),
            RobotChoice::RigidBody => "Rigid body".to_owned(),
            RobotChoice::Car => "Car".to_owned(),
        }
    }

    /// The rectangle or the car that is placed by (x, y, theta); none else.
    pub(super) fn placed(self) -> Result<Option<Robot>, Error> {
        let [x, y] = HALF;
        let shape = || polygon(&[(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Point::new(x, y)));
        let weights = Weights::default();
        Ok(match self {
            RobotChoice::Disc | RobotChoice::Arm(_) => None,
            RobotChoice::RigidBody => Some(Robot::RigidBody(RigidBody::new(shape(), weights))),
            RobotChoice::Car => {
                let [speed, steering] = [FASTEST, STEEPEST].map(|most| [-most, most]);
                Some(Robot::Car(Car::new(shape(), WHEELBASE, speed, steering, STEP, weights)?))
            }
        })
    }

    /// How near to its goal it must come, where that is a region.
    pub(super) fn goal_tolerance(self) -> Option<GoalTolerance> {
        (self == RobotChoice::Car).then_some(NEAR)
    }

    /// The robot in the box, and from where to where it shall go across: a disc, a body or a car between opposite corners, an
    /// arm in the middle from one side to the other.
    pub(super) fn across(self, radius: f64) -> Result<(Robot, Query), Error> {
        let (robot, start, goal) = match self {
            RobotChoice::Disc => (Robot::Disc(DiscRobot::new(radius)?), vec![0.2, 0.2], vec![SIDE - 0.2, SIDE - 0.2]),
            RobotChoice::Arm(links) => {
                let base = Point::new(SIDE / 2.0, SIDE / 2.0);
                let arm = Arm::new(base, vec![REACH / links as f64; links], radius, None)?;
                let bent = |first: f64, rest: f64| (0..links).map(|i| if i == 0 { first } else { rest }).collect();
                (Robot::Arm(arm), bent(0.5, 0.3), bent(-2.6, -0.3))
            }
            RobotChoice::RigidBody | RobotChoice::Car => {
                let robot = self.placed()?.unwrap_or_else(|| unreachable!("both are placed"));
                let turn = if self == RobotChoice::Car { 0.0 } else { FRAC_PI_2 };
                (robot, vec![0.25, 0.25, 0.0], vec![SIDE - 0.25, SIDE - 0.25, turn])
            }
        };
        Ok((
            robot,
            Query {
                name: "across".to_owned(),
                start,
                goal: Goal::Configuration(goal),
                goal_tolerance: self.goal_tolerance(),
            },
        ))
    }
}

/// The parts of the robot at the start and at the goal, which obstacles keep clear of.
pub(super) fn parts_at_ends(robot: &Robot, query: &Query) -> Vec<Part> {
    query.ends().flat_map(|q| robot.footprint(q)).collect()
}
