//! What a scenario holds, once it has been checked.

use crate::geometry::{Aabb, Disc, Polygon};
use crate::json;
use crate::robot::{Arm, Car, DiscRobot, Part, RigidBody, Target, Weights};
use serde::Serialize;

/// A checked scenario: a world, a robot in it, and named queries.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "format", rename = "planarium-scenario-1")]
pub struct Scenario {
    pub(super) name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
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

    /// The normalised document as text, on one line: fields in the order of the contract, defaults written out, polygons open,
    /// counter-clockwise and without repeated vertices. It reads back as an equal scenario; equal scenarios give equal text, on
    /// every platform.
    pub fn to_json_string(&self) -> String {
        json::to_string(self)
    }
}

/// Where the robot moves. Lengths in metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct World {
    /// The closed box that the whole robot stays in; absent for an arm only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bounds: Option<Aabb>,
    /// Closed, filled obstacles.
    pub obstacles: Vec<Obstacle>,
}

/// A closed, filled obstacle.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
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
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Robot {
    /// A planar arm.
    Arm(Arm),
    /// A translating disc or point.
    Disc(DiscRobot),
    /// A polygon that translates and turns.
    RigidBody(RigidBody),
    /// A car.
    Car(Car),
}

impl Robot {
    /// How many numbers a configuration has.
    pub fn dimension(&self) -> usize {
        match self {
            Robot::Arm(arm) => arm.links().len(),
            Robot::Disc(_) => 2,
            Robot::RigidBody(_) | Robot::Car(_) => 3,
        }
    }

    /// The word for its type in documents.
    pub fn kind(&self) -> &'static str {
        match self {
            Robot::Arm(_) => "arm",
            Robot::Disc(_) => "disc",
            Robot::RigidBody(_) => "rigid_body",
            Robot::Car(_) => "car",
        }
    }

    /// The parts of the robot at `q`.
    ///
    /// # Panics
    /// Where `q` has fewer entries than [`Robot::dimension`].
    pub fn footprint(&self, q: &[f64]) -> Vec<Part> {
        match self {
            Robot::Arm(arm) => arm.footprint(q),
            Robot::Disc(disc) => disc.footprint(q),
            Robot::RigidBody(body) => body.footprint(q),
            Robot::Car(car) => car.footprint(q),
        }
    }

    /// The shape in its own frame and the weights of the metric, of a robot that is placed by (x, y, theta).
    pub fn placed_shape(&self) -> Option<(&Polygon, Weights)> {
        match self {
            Robot::Arm(_) | Robot::Disc(_) => None,
            Robot::RigidBody(body) => Some((body.shape(), body.weights())),
            Robot::Car(car) => Some((car.shape(), car.weights())),
        }
    }
}

/// One question: from where to where.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Query {
    /// The name, distinct within the scenario.
    pub name: String,
    /// The configuration to start from, as written (angles of circle joints in any number of turns).
    pub start: Vec<f64>,
    /// What is to be reached.
    #[serde(flatten)]
    pub goal: Goal,
    /// How near to it is near enough, of bodies and cars; exactly there where it is absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub goal_tolerance: Option<GoalTolerance>,
}

/// What a query asks for.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Goal {
    /// A configuration, as written.
    #[serde(rename = "goal")]
    Configuration(Vec<f64>),
    /// Any configuration of an arm whose end effector is there.
    #[serde(rename = "target")]
    Target(Target),
}

impl Query {
    /// The configurations that the query names: the start, and the goal unless it is a target.
    pub fn ends(&self) -> impl Iterator<Item = &[f64]> {
        std::iter::once(&self.start[..]).chain(self.configuration())
    }

    /// The configuration to reach; `None` where any will do that reaches a target.
    pub fn configuration(&self) -> Option<&[f64]> {
        match &self.goal {
            Goal::Configuration(goal) => Some(goal),
            Goal::Target(_) => None,
        }
    }
}

/// A goal region about a configuration (x, y, theta): both must hold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GoalTolerance {
    /// How far away at most, in metres.
    pub translation: f64,
    /// Turned by how much at most, the short way round, in radians.
    pub rotation: f64,
}
