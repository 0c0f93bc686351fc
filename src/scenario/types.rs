//! What a scenario holds, once it has been checked.

use crate::geometry::{Aabb, Disc, Polygon};
use crate::robot::{Arm, DiscRobot};

/// A checked scenario: a world, a robot in it, and named queries.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    pub(super) name: String,
    pub(super) title: Option<String>,
    pub(super) world: World,
    pub(super) robot: Robot,
    pub(super) queries: Vec<Query>,
}

impl Scenario {
    /// The name, used in results.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The title for people; the name where there is none.
    pub fn title(&self) -> &str {
        self.title.as_deref().unwrap_or(&self.name)
    }

    /// Bounds and obstacles.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// The robot.
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// The queries in the order of the document; names are distinct.
    pub fn queries(&self) -> &[Query] {
        &self.queries
    }
}

/// Where the robot moves. Lengths in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct World {
    /// The closed box that the whole robot stays in; absent for an arm only.
    pub bounds: Option<Aabb>,
    /// Closed, filled obstacles.
    pub obstacles: Vec<Obstacle>,
}

/// A closed, filled obstacle.
#[derive(Debug, Clone, PartialEq)]
pub enum Obstacle {
    /// A disc of positive radius.
    Disc(Disc),
    /// A simple polygon, convex or concave.
    Polygon(Polygon),
}

impl Obstacle {
    /// The smallest box around the obstacle.
    pub fn aabb(&self) -> Aabb {
        match self {
            Obstacle::Disc(disc) => disc.aabb(),
            Obstacle::Polygon(polygon) => *polygon.aabb(),
        }
    }
}

/// The robot of a scenario.
#[derive(Debug, Clone, PartialEq)]
pub enum Robot {
    /// A planar arm.
    Arm(Arm),
    /// A translating disc or point.
    Disc(DiscRobot),
}

impl Robot {
    /// How many numbers a configuration has.
    pub fn dimension(&self) -> usize {
        match self {
            Robot::Arm(arm) => arm.links().len(),
            Robot::Disc(_) => 2,
        }
    }
}

/// One question: from where to where.
#[derive(Debug, Clone, PartialEq)]
pub struct Query {
    /// The name, distinct within the scenario.
    pub name: String,
    /// The configuration to start from, as written (angles of circle joints in any number of turns).
    pub start: Vec<f64>,
    /// The configuration to reach, as written.
    pub goal: Vec<f64>,
}
