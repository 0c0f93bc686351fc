//! The gap: a wall across the world with one opening, the narrow passage of the textbooks, for a robot that goes through it or
//! an arm that reaches through it.
//!
//! A disc has a path exactly where the gap is wider than the disc (by more than 1e-9 m, to be safe from rounding); where it
//! is not, the title says so. The arm is at its goal stretched through the gap and bent behind it, at its start folded up in
//! front of it. That a path exists is not promised: arms of three links and more mostly find the way in, two links often
//! cannot.

use super::free::{SOME, polygon};
use super::options::{GeneratorInfo, Given, OptionInfo, OptionKind, refused};
use super::robots::{LINKS, RADIUS, ROBOT, RobotChoice, SIDE};
use crate::decimal::Decimal;
use crate::error::Error;
use crate::geometry::{Aabb, Point};
use crate::random::{Random, Stream};
use crate::robot::{Arm, DiscRobot};
use crate::scenario::reader::Reader;
use crate::scenario::{Goal, Node, Obstacle, Query, Robot, Scenario, World};
use std::f64::consts::{FRAC_PI_2, PI};

/// The sum of an arm's links, in metres.
const REACH: f64 = 0.9;

/// How far an arm's base is from the middle of the gap, in metres.
const DISTANCE: f64 = 0.5;

/// How much wider than an arm the gap is at least, in metres.
const PLAY: f64 = 0.01;

/// The row of the generator.
pub(super) const INFO: GeneratorInfo = GeneratorInfo {
    id: "gap",
    title: "Gap",
    summary: "A wall across a box with one gap, for a robot that goes through it or an arm that reaches through it.",
    options: &[
        ROBOT,
        OptionInfo { kind: OptionKind::Integer { min: 2.0, max: 8.0, default: 4.0 }, ..LINKS },
        RADIUS,
        OptionInfo {
            name: "width",
            title: "Width of the gap",
            kind: OptionKind::Number { min: 0.0, max: 1.0, default: 0.2 },
            unit: "m",
            meaning: "How wide the gap is; a disc passes where it is more than twice its radius.",
        },
        OptionInfo {
            name: "thickness",
            title: "Thickness of the wall",
            kind: OptionKind::Number { min: 0.005, max: 0.5, default: 0.1 },
            unit: "m",
            meaning: "How thick the wall is, so how long the passage.",
        },
    ],
};

/// Which gap to make. As a document: `robot` ("disc", "arm", "rigid_body" or "car"), `links` (arms only, default 4), and the rest by name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapOptions {
    /// The robot (default: a disc); an arm has 2 to 8 links, as one link alone never gets into the gap.
    pub robot: RobotChoice,
    /// The robot's radius in metres: 0 to 0.1 (default 0.03).
    pub radius: f64,
    /// How wide the gap is, in metres: 0 to 1 (default 0.2); for an arm at least 0.01 more than twice its radius.
    pub width: f64,
    /// How thick the wall is, in metres: 0.005 to 0.5 (default 0.1).
    pub thickness: f64,
    /// The seed: 0 (default) to 2^53 - 1.
    pub seed: u64,
}

impl Default for GapOptions {
    fn default() -> Self {
        Self { robot: RobotChoice::Disc, radius: 0.03, width: 0.2, thickness: 0.1, seed: 0 }
    }
}

impl GapOptions {
    /// Reads the options by their names; all may be left out.
    pub(super) fn from_node(options: &Node) -> Result<Self, Error> {
        let root = Reader::root(options);
        let given = Given::read(&INFO, &root)?;
        Ok(Self {
            robot: RobotChoice::read(&given)?,
            radius: given.number("radius")?,
            width: given.number("width")?,
            thickness: given.number("thickness")?,
            seed: given.seed()?,
        })
    }

    fn check(&self) -> Result<(), Error> {
        let Self { robot, radius, width, thickness, seed } = *self;
        let mut values = vec![("radius", radius), ("width", width), ("thickness", thickness)];
        values.extend(robot.links());
        INFO.check(seed, &values)?;
        if matches!(robot, RobotChoice::Arm(_)) && width - 2.0 * radius < PLAY - SOME {
            let [radius, play, width] = [radius, PLAY, width].map(Decimal);
            let sentence = format!(
                "an arm of radius {radius} needs a gap wider than twice that by {play}, else it is never at its goal; {width} is less"
            );
            return Err(refused("width", sentence));
        }
        Ok(())
    }
}

/// Makes a wall with a gap, with one query, "through". The seed places the gap along the wall, start and goal.
///
/// # Errors
/// `out-of-range` or `not-finite` with the pointer of the option; `out-of-range` at `/width` where an arm does not fit into
/// the gap.
pub fn gap(options: &GapOptions) -> Result<Scenario, Error> {
    options.check()?;
    let GapOptions { robot: choice, radius, width, thickness, seed } = *options;
    let mut random = Random::new(seed, Stream::Scenario);
    // So much of the wall is left on either side; an arm needs more room to fold up.
    let left = if matches!(choice, RobotChoice::Arm(_)) { 0.5 - width / 2.0 } else { 0.1 };
    let low = width / 2.0 + left.max(0.1);
    let middle = low + random.uniform() * (SIDE - 2.0 * low);
    let (robot, start, goal) = match choice {
        RobotChoice::Disc => {
            let mut place = |left: f64| vec![left + 0.3 * random.uniform(), 0.15 + (SIDE - 0.3) * random.uniform()];
            let (start, goal) = (place(0.15), place(SIDE - 0.45));
            (Robot::Disc(DiscRobot::new(radius)?), start, goal)
        }
        RobotChoice::Arm(links) => reach_through(options, links, middle, &mut random)?,
        RobotChoice::RigidBody | RobotChoice::Car => {
            // A body reaches 0.12 m from its origin.
            let mut place = |left: f64| {
                let (x, y) = (left + 0.25 * random.uniform(), 0.2 + (SIDE - 0.4) * random.uniform());
                vec![x, y, PI * (2.0 * random.uniform() - 1.0)]
            };
            let (start, goal) = (place(0.2), place(SIDE - 0.45));
            (choice.placed()?.unwrap_or_else(|| unreachable!("both are placed")), start, goal)
        }
    };
    let (disc, gap) = (Decimal(radius), Decimal(width));
    let what = match choice {
        RobotChoice::Disc if width <= 2.0 * radius => {
            format!("Disc of radius {disc} m at a gap of {gap} m, too narrow for it: no path")
        }
        RobotChoice::Disc => format!("Disc of radius {disc} m through a gap of {gap} m"),
        RobotChoice::Arm(links) => format!("{links}R arm reaching through a gap of {gap} m"),
        RobotChoice::RigidBody | RobotChoice::Car => format!("{} through a gap of {gap} m", choice.title()),
    };
    let wall = |low: f64, high: f64| {
        let (left, right) = ((SIDE - thickness) / 2.0, (SIDE + thickness) / 2.0);
        let corners = [(left, low), (right, low), (right, high), (left, high)].map(|(x, y)| Point::new(x, y));
        Obstacle::Polygon(polygon(&corners))
    };
    Ok(Scenario {
        name: format!("gap-{}-{seed}", choice.id()),
        title: Some(format!("{what}, seed {seed}")),
        world: World {
            bounds: Some(Aabb { min: Point::origin(), max: Point::new(SIDE, SIDE) }),
            obstacles: vec![wall(0.0, middle - width / 2.0), wall(middle + width / 2.0, SIDE)],
        },
        robot,
        queries: vec![Query {
            name: "through".to_owned(),
            start,
            goal: Goal::Configuration(goal),
            goal_tolerance: choice.goal_tolerance(),
        }],
    })
}

/// An arm before a gap at height `middle`, its start and its goal.
fn reach_through(
    options: &GapOptions,
    links: usize,
    middle: f64,
    random: &mut Random,
) -> Result<(Robot, Vec<f64>, Vec<f64>), Error> {
    let GapOptions { radius, width, thickness, .. } = *options;
    // A line through the middle of the gap, at an angle a to the level, keeps w/2 cos a - t/2 sin a from the wall. With
    // cos a >= 1 - a^2 / 2, sin a <= a and a <= 0.5 at least half of the play on either side is left up to this angle.
    let steepest = ((width / 2.0 - radius) / (thickness + width / 4.0)).min(0.5);
    let aim = steepest * (2.0 * random.uniform() - 1.0);
    let (sin, cos) = libm::sincos(aim);
    let base = Point::new(SIDE / 2.0 - DISTANCE * cos, middle - DISTANCE * sin);
    let length = REACH / links as f64;
    let arm = Arm::new(base, vec![length; links], radius, None)?;

    // Folded up (or down, where there is more room) with no link leaning towards the wall.
    let turn = if base.y <= SIDE / 2.0 { 1.0 } else { -1.0 };
    let leaning: Vec<f64> = (0..links).map(|_| turn * (FRAC_PI_2 + 0.3 * random.uniform())).collect();
    // Straight through the gap, then bent one way, though never back towards the wall.
    let bend = if random.below(2) == 0 { 1.0 } else { -1.0 };
    let behind = (SIDE + thickness) / 2.0 + radius + 0.01;
    let mut directions = vec![aim; links];
    for i in 1..links {
        if base.x + length * i as f64 * cos > behind {
            let direction = directions[i - 1] + bend * (0.3 + 0.3 * random.uniform());
            directions[i] = libm::fmax(-1.4, libm::fmin(direction, 1.4));
        }
    }
    Ok((Robot::Arm(arm), joint_angles(&leaning), joint_angles(&directions)))
}

/// The joint angles of links that point in the given directions.
fn joint_angles(directions: &[f64]) -> Vec<f64> {
    (0..directions.len()).map(|i| directions[i] - if i == 0 { 0.0 } else { directions[i - 1] }).collect()
}
