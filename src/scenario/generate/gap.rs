//! The gap: a wall across the world with one opening, a narrow passage, for a robot that moves or an arm that reaches through.
//!
//! A disc has a path exactly if the gap is wider than the disc (by more than 1e-9 m, to be safe from rounding); if it is not,
//! the title says so. At its goal the arm is stretched through the gap and bent behind it, at its start folded up in front of
//! it. A path need not exist: by default arms mostly have one, but two links often do not through a gap narrower than 0.4 m.

use super::free::{SOME, polygon};
use super::robots::{RobotChoice, SIDE, check_given};
use super::{Generator, SEEDS, in_box, query};
use crate::error::Error;
use crate::geometry::Point;
use crate::options::{Value, out_of_range};
use crate::random::{Random, Stream};
use crate::robot::{Arm, DiscRobot};
use crate::scenario::{Obstacle, Query, Robot, Scenario};
use std::f64::consts::{FRAC_PI_2, PI};

/// The sum of an arm's links, in metres.
const REACH: f64 = 0.9;

/// The distance of an arm's base from the middle of the gap, in metres.
const DISTANCE: f64 = 0.5;

/// The least difference between the widths of the gap and of an arm, in metres.
const PLAY: f64 = 0.01;

crate::options! {
    /// Which gap to make.
    pub struct GapOptions for &[];
    /// The kind of robot.
    robot: RobotChoice = RobotChoice::Disc, "Robot";
    /// Number of links; arms only.
    links: usize = 4, in 2.0..=8.0, "Links";
    /// The radius of the disc, or half the width of the arm's links; not for a body or a car.
    radius: f64 = 0.03, in 0.0..=0.1, "Radius of the robot", unit "m";
    /// The width of the gap; a disc passes if it is more than twice its radius.
    width: Option<f64>, in 0.0..=1.0, "Width of the gap", unit "m", else "0.2 m; 0.4 m for an arm of two links";
    /// The thickness of the wall, which is the length of the passage.
    thickness: f64 = 0.1, in 0.005..=0.5, "Thickness of the wall", unit "m";
    /// The seed: 0 (default) to 2^53 - 1.
    seed: u64 = 0, in SEEDS;
}

impl Generator for GapOptions {
    type Made = Scenario;

    fn check_given(given: &[(String, Value)]) -> Result<(), Error> {
        check_given(given)
    }

    /// With the query "through". The seed places the gap along the wall, start and goal.
    fn make(&self) -> Result<Scenario, Error> {
        let Self { robot: choice, links, radius, thickness, seed, .. } = *self;
        let width = self.width();
        if choice == RobotChoice::Arm && width - 2.0 * radius < PLAY - SOME {
            let sentence = format!(
                "an arm of radius {radius} reaches its goal only through a gap wider than twice that by {PLAY}; {width} is less"
            );
            return Err(out_of_range("width", sentence));
        }
        let mut random = Random::new(seed, Stream::Scenario);
        // The least length of the wall on either side; an arm needs more of the box to fold up.
        let left = if choice == RobotChoice::Arm { 0.5 - width / 2.0 } else { 0.1 };
        let low = width / 2.0 + left.max(0.1);
        let middle = low + random.uniform() * (SIDE - 2.0 * low);
        let (robot, start, goal) = match choice {
            RobotChoice::Disc => {
                let mut place = |left: f64| vec![left + 0.3 * random.uniform(), 0.15 + (SIDE - 0.3) * random.uniform()];
                let (start, goal) = (place(0.15), place(SIDE - 0.45));
                (Robot::Disc(DiscRobot::new(radius)?), start, goal)
            }
            RobotChoice::Arm => reach_through(self, middle, &mut random)?,
            RobotChoice::RigidBody | RobotChoice::Car => {
                // A body reaches 0.12 m from its origin.
                let mut place = |left: f64| {
                    let (x, y) = (left + 0.25 * random.uniform(), 0.2 + (SIDE - 0.4) * random.uniform());
                    vec![x, y, PI * (2.0 * random.uniform() - 1.0)]
                };
                let (start, goal) = (place(0.2), place(SIDE - 0.45));
                (choice.placed()?, start, goal)
            }
        };
        let [_, id, title] = choice.words(links, 0);
        let title = match choice {
            RobotChoice::Disc if width <= 2.0 * radius => {
                format!("Disc of radius {radius} m at a gap of {width} m, too narrow for it: no path, seed {seed}")
            }
            RobotChoice::Disc => format!("Disc of radius {radius} m through a gap of {width} m, seed {seed}"),
            RobotChoice::Arm => format!("{title} reaching through a gap of {width} m, seed {seed}"),
            _ => format!("{title} through a gap of {width} m, seed {seed}"),
        };
        let wall = |low: f64, high: f64| {
            let (left, right) = ((SIDE - thickness) / 2.0, (SIDE + thickness) / 2.0);
            let corners = [(left, low), (right, low), (right, high), (left, high)].map(|(x, y)| Point::new(x, y));
            Obstacle::Polygon(polygon(&corners))
        };
        let walls = [wall(0.0, middle - width / 2.0), wall(middle + width / 2.0, SIDE)];
        let query = Query { goal_tolerance: choice.goal_tolerance(), ..query("through", start, goal) };
        Ok(in_box(format!("gap-{id}-{seed}"), title, SIDE, walls, robot, query))
    }
}

impl GapOptions {
    /// The width of the gap: two links hardly reach through a narrow one.
    fn width(&self) -> f64 {
        self.width.unwrap_or(if self.robot == RobotChoice::Arm && self.links == 2 { 0.4 } else { 0.2 })
    }
}

/// An arm before a gap at height `middle`, its start and its goal.
fn reach_through(options: &GapOptions, middle: f64, random: &mut Random) -> Result<(Robot, Vec<f64>, Vec<f64>), Error> {
    let GapOptions { links, radius, thickness, .. } = *options;
    let width = options.width();
    // A line through the middle of the gap, at an angle a to the level, keeps w/2 cos a - t/2 sin a from the wall. With
    // cos a >= 1 - a^2 / 2, sin a <= a and a <= 0.5 at least half of the play on either side is left up to this angle.
    let steepest = ((width / 2.0 - radius) / (thickness + width / 4.0)).min(0.5);
    let aim = steepest * (2.0 * random.uniform() - 1.0);
    let (sin, cos) = libm::sincos(aim);
    let base = Point::new(SIDE / 2.0 - DISTANCE * cos, middle - DISTANCE * sin);
    let length = REACH / links as f64;
    let arm = Arm::new(base, vec![length; links], radius, None)?;

    // Folded up (or down, if there is more of the box there) with no link leaning towards the wall.
    let turn = if base.y <= SIDE / 2.0 { 1.0 } else { -1.0 };
    let leaning: Vec<f64> = (0..links).map(|_| turn * (FRAC_PI_2 + 0.3 * random.uniform())).collect();
    // Straight through the gap, then bent to one side, but never back towards the wall.
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
