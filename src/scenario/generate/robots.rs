//! The robots that generators put into their worlds: a disc, an arm, a rigid body or a car.
//!
//! Body and car are the rectangle of the course reports, 0.2 m by 0.1 m, and the car has their wheelbase and limits.

use super::free::polygon;
use super::query;
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::options::{Value, out_of_range, refusal};
use crate::robot::{Arm, Car, DiscRobot, Joint, RigidBody, Weights};
use crate::scenario::{GoalTolerance, Query, Robot};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

crate::choice! {
    /// The robot of a generated world.
    pub enum RobotChoice {
        /// A disc.
        Disc,
        /// An arm of equal links.
        Arm,
        /// A rectangle that translates and turns.
        #[strum(serialize = "rigid_body")]
        RigidBody,
        /// The same rectangle on wheels.
        Car,
    }
}

/// The side of the box that most worlds are, in metres.
pub(super) const SIDE: f64 = 2.0;

/// The reach of an arm from the middle of the box, in metres: it stays inside with the largest radius.
const REACH: f64 = 0.8;

impl RobotChoice {
    /// With an article, as in a scenario's name (`disc`, `3r`, `rrp`, `body` or `car`) and as in its title; of an arm the outer
    /// links slide.
    pub(super) fn words(self, links: usize, sliding: usize) -> [String; 3] {
        match self {
            RobotChoice::Disc => ["a disc", "disc", "Disc"].map(str::to_owned),
            RobotChoice::Arm if sliding > 0 => {
                let chain = "r".repeat(links.saturating_sub(sliding)) + &"p".repeat(sliding);
                ["an arm".to_owned(), chain.clone(), format!("{} arm", chain.to_ascii_uppercase())]
            }
            RobotChoice::Arm => ["an arm".to_owned(), format!("{links}r"), format!("{links}R arm")],
            RobotChoice::RigidBody => ["a rigid body", "body", "Rigid body"].map(str::to_owned),
            RobotChoice::Car => ["a car", "car", "Car"].map(str::to_owned),
        }
    }

    /// The car; the rigid body for any other.
    pub(super) fn placed(self) -> Result<Robot, Error> {
        self.rectangle(0.1)
    }

    /// The same, half as long as given, in metres, half as wide as long, and with a wheelbase of its length.
    pub(super) fn rectangle(self, x: f64) -> Result<Robot, Error> {
        let y = x / 2.0;
        let shape = polygon(&[(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Point::new(x, y)));
        let weights = Weights::default();
        if self != RobotChoice::Car {
            return Ok(Robot::RigidBody(RigidBody::new(shape, weights)));
        }
        let (wheelbase, speed, steering, step) = (2.0 * x, [-0.5, 0.5], [-FRAC_PI_4, FRAC_PI_4], 0.01);
        Ok(Robot::Car(Car::new(shape, wheelbase, speed, steering, step, weights)?))
    }

    /// The goal region, if the robot has one.
    pub(super) fn goal_tolerance(self) -> Option<GoalTolerance> {
        (self == RobotChoice::Car).then_some(GoalTolerance { translation: 0.1, rotation: 0.5 })
    }

    /// The robot in the box, and a query across it: a disc, a body or a car between opposite corners, an
    /// arm in the middle from one side to the other. Its outer links slide from a quarter of their length to all of it.
    pub(super) fn across(self, links: usize, sliding: usize, radius: f64) -> Result<(Robot, Query), Error> {
        let (robot, start, goal) = match self {
            RobotChoice::Disc => (Robot::Disc(DiscRobot::new(radius)?), vec![0.2, 0.2], vec![SIDE - 0.2, SIDE - 0.2]),
            RobotChoice::Arm => {
                let base = Point::new(SIDE / 2.0, SIDE / 2.0);
                let (length, turning) = (REACH / links as f64, links.saturating_sub(sliding));
                if sliding > 0 && turning == 0 {
                    let sentence = format!("sliding must be less than the number of links, {links}, not {sliding}");
                    return Err(out_of_range("sliding", sentence));
                }
                let slide = Joint::Prismatic { range: [0.0, 0.75 * length], angle: 0.0 };
                let lengths = (0..links).map(|i| if i < turning { length } else { 0.25 * length }).collect();
                let joints = (0..links).map(|i| if i < turning { Joint::CIRCLE } else { slide }).collect();
                let arm = Arm::with_joints(base, lengths, radius, joints)?;
                let bent = |first: f64, rest: f64, out: f64| {
                    let at = |i: usize| if i >= turning { out * length } else { [first, rest][usize::from(i > 0)] };
                    (0..links).map(at).collect()
                };
                (Robot::Arm(arm), bent(0.5, 0.3, 0.5), bent(-2.6, -0.3, 0.5))
            }
            RobotChoice::RigidBody | RobotChoice::Car => {
                let turn = if self == RobotChoice::Car { 0.0 } else { FRAC_PI_2 };
                (self.placed()?, vec![0.25, 0.25, 0.0], vec![SIDE - 0.25, SIDE - 0.25, turn])
            }
        };
        Ok((robot, Query { goal_tolerance: self.goal_tolerance(), ..query("across", start, goal) }))
    }
}

/// Refuses options that the chosen robot does not have: links belong to an arm, a radius to an arm or a disc.
pub(super) fn check_given(given: &[(String, Value)]) -> Result<(), Error> {
    let robot = given.iter().find_map(|(name, value)| match value {
        Value::Text(word) if name == "robot" => word.parse().ok(),
        _ => None,
    });
    let robot = robot.unwrap_or(RobotChoice::Disc);
    let [article, ..] = robot.words(0, 0);
    let is_given = |option: &str| given.iter().any(|(name, _)| name == option);
    if let Some(option) = ["links", "sliding"].into_iter().find(|option| is_given(option))
        && robot != RobotChoice::Arm
    {
        let sentence = format!("{article} has no links; give \"robot\": \"arm\" for an arm");
        return Err(refusal(Code::UnknownField, option, sentence));
    }
    if is_given("radius") && matches!(robot, RobotChoice::RigidBody | RobotChoice::Car) {
        let sentence = format!("{article} has no radius: it is a rectangle");
        return Err(refusal(Code::UnknownField, "radius", sentence));
    }
    Ok(())
}
