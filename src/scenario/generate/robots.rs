//! The robots that generators put into their worlds: a disc or an arm.

use super::options::{Given, OptionInfo, OptionKind};
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::robot::{Arm, DiscRobot, MAX_LINKS, Part};
use crate::scenario::{Query, Robot};

/// The robot of a generated world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RobotChoice {
    /// A disc.
    Disc,
    /// An arm of so many equal links.
    Arm(usize),
}

/// The side of the box that most worlds are, in metres.
pub(super) const SIDE: f64 = 2.0;

/// How far an arm reaches from the middle of the box, in metres; with the largest radius it stays inside.
const REACH: f64 = 0.8;

/// The row of the option `robot`.
pub(super) const ROBOT: OptionInfo = OptionInfo {
    name: "robot",
    title: "Robot",
    kind: OptionKind::Choice(&["disc", "arm"]),
    unit: "",
    meaning: "What moves.",
};

/// The row of the option `links`.
pub(super) const LINKS: OptionInfo = OptionInfo {
    name: "links",
    title: "Links",
    kind: OptionKind::Integer { min: 1.0, max: MAX_LINKS as f64, default: 2.0 },
    unit: "",
    meaning: "How many links the arm has; not for a disc.",
};

/// The row of the option `radius`.
pub(super) const RADIUS: OptionInfo = OptionInfo {
    name: "radius",
    title: "Radius of the robot",
    kind: OptionKind::Number { min: 0.0, max: 0.1, default: 0.03 },
    unit: "m",
    meaning: "The radius of the disc, or half the width of the arm's links.",
};

/// The same row where only a disc moves.
pub(super) const DISC_RADIUS: OptionInfo = OptionInfo { meaning: "The radius of the disc.", ..RADIUS };

impl RobotChoice {
    /// Reads `robot` and, for an arm only, `links`.
    pub(super) fn read(given: &Given) -> Result<Self, Error> {
        if given.choice("robot")? == 1 {
            return Ok(RobotChoice::Arm(given.integer("links")?));
        }
        match given.field("links") {
            Some(links) => {
                Err(links.error(Code::UnknownField, "a disc has no links; say \"robot\": \"arm\" for an arm"))
            }
            None => Ok(RobotChoice::Disc),
        }
    }

    /// The value of `links` to be checked: none for a disc.
    pub(super) fn links(self) -> Option<(&'static str, f64)> {
        match self {
            RobotChoice::Disc => None,
            RobotChoice::Arm(links) => Some(("links", links as f64)),
        }
    }

    /// What a scenario's name calls it: `disc` or `3r`.
    pub(super) fn id(self) -> String {
        match self {
            RobotChoice::Disc => "disc".to_owned(),
            RobotChoice::Arm(links) => format!("{links}r"),
        }
    }

    /// What a scenario's title calls it.
    pub(super) fn title(self) -> String {
        match self {
            RobotChoice::Disc => "Disc".to_owned(),
            RobotChoice::Arm(links) => format!("{links}R arm"),
        }
    }

    /// The robot in the box, and from where to where it shall go across: a disc between opposite corners, an arm in the
    /// middle from one side to the other.
    pub(super) fn across(self, radius: f64) -> Result<(Robot, Query), Error> {
        let (robot, start, goal) = match self {
            RobotChoice::Disc => (Robot::Disc(DiscRobot::new(radius)?), vec![0.2, 0.2], vec![SIDE - 0.2, SIDE - 0.2]),
            RobotChoice::Arm(links) => {
                let base = Point::new(SIDE / 2.0, SIDE / 2.0);
                let arm = Arm::new(base, vec![REACH / links as f64; links], radius, None)?;
                let bent = |first: f64, rest: f64| (0..links).map(|i| if i == 0 { first } else { rest }).collect();
                (Robot::Arm(arm), bent(0.5, 0.3), bent(-2.6, -0.3))
            }
        };
        Ok((robot, Query { name: "across".to_owned(), start, goal, goal_tolerance: None }))
    }
}

/// The parts of the robot at the start and at the goal, which obstacles keep clear of.
pub(super) fn parts_at_ends(robot: &Robot, query: &Query) -> Vec<Part> {
    [&query.start, &query.goal].map(|q| robot.footprint(q)).concat()
}
