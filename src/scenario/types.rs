//! A checked scenario and its parts.

use super::{MapFrame, Obstacle};
use crate::error::{Code, Error, quoted};
use crate::geometry::{Aabb, Polygon};
use crate::json;
use crate::robot::{Arm, Car, DiscRobot, Part, RigidBody, Target, Weights};
use serde::Serialize;
use std::sync::Arc;

/// A checked scenario: a world, a robot in it, and named queries. Clones share all of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scenario(pub(super) Arc<Parts>);

/// The parts of a scenario, as its document has them.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "format", rename = "planarium-scenario-1")]
pub(crate) struct Parts {
    pub(crate) name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) title: Option<String>,
    #[serde(skip_serializing_if = "MapFrame::is_identity")]
    pub(crate) frame: MapFrame,
    pub(crate) world: World,
    pub(crate) robot: Robot,
    pub(crate) queries: Vec<Query>,
}

impl Parts {
    /// Those of a scenario that comes from no map.
    pub(crate) fn new(name: String, title: Option<String>, world: World, robot: Robot, queries: Vec<Query>) -> Self {
        Self { name, title, frame: MapFrame::default(), world, robot, queries }
    }
}

impl From<Parts> for Scenario {
    fn from(parts: Parts) -> Self {
        Self(Arc::new(parts))
    }
}

impl Scenario {
    /// The name, used in results.
    pub fn name(&self) -> &str {
        &self.0.name
    }

    /// The title for people; the name if there is none.
    pub fn title(&self) -> &str {
        self.0.title.as_deref().unwrap_or(self.name())
    }

    /// The way to the coordinates of the map that the world was read from.
    pub fn frame(&self) -> &MapFrame {
        &self.0.frame
    }

    /// The same scenario as one that was read from a map with this frame.
    #[must_use]
    pub fn in_frame(self, frame: MapFrame) -> Self {
        Parts { frame, ..Arc::unwrap_or_clone(self.0) }.into()
    }

    /// Bounds and obstacles.
    pub fn world(&self) -> &World {
        &self.0.world
    }

    /// The robot.
    pub fn robot(&self) -> &Robot {
        &self.0.robot
    }

    /// The queries in the order of the document; names are distinct.
    pub fn queries(&self) -> &[Query] {
        &self.0.queries
    }

    /// The query of that name, or the first, and its index.
    ///
    /// # Errors
    /// `unknown-query`, pointer `/query`, naming those that exist.
    pub fn find_query(&self, name: Option<&str>) -> Result<(usize, &Query), Error> {
        let i = find_query("scenario", self.queries().iter().map(|query| &*query.name), name)?;
        Ok((i, &self.queries()[i]))
    }

    /// The normalised document as text, on one line: fields in a fixed order, defaults written out, polygons
    /// open, counter-clockwise, their holes clockwise, and without repeated vertices. It reads back as an equal scenario; equal
    /// scenarios give equal text, on every platform.
    pub fn to_json_string(&self) -> String {
        json::to_string(self)
    }
}

/// The index of the query of that name, or of the first, among those of a document.
///
/// # Errors
/// `unknown-query`, pointer `/query`, naming those that exist.
pub(crate) fn find_query<'a>(
    document: &str,
    names: impl Iterator<Item = &'a str> + Clone,
    name: Option<&str>,
) -> Result<usize, Error> {
    names.clone().position(|known| name.is_none_or(|name| known == name)).ok_or_else(|| {
        let known: Vec<String> = names.map(quoted).collect();
        let sentence = match name {
            Some(name) => {
                format!("unknown query {}; the queries of this {document} are [{}]", quoted(name), known.join(", "))
            }
            None => format!("this {document} has no query"),
        };
        Error::new(Code::UnknownQuery, "/query", sentence)
    })
}

/// The bounds and obstacles. Lengths in metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct World {
    /// The closed box that the whole robot stays in; absent for an arm only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bounds: Option<Aabb>,
    /// Closed obstacles; clones share them.
    pub obstacles: Arc<[Obstacle]>,
}

impl World {
    /// The obstacles within bounds; only an arm needs none.
    pub fn new(bounds: Option<Aabb>, obstacles: impl IntoIterator<Item = Obstacle>) -> Self {
        Self { bounds, obstacles: obstacles.into_iter().collect() }
    }
}

/// The robot of a scenario.
#[derive(Debug, Clone, PartialEq, Serialize, strum::IntoStaticStr)]
#[serde(tag = "type", rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
#[non_exhaustive]
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

/// Each type of robot is a [`Robot`].
macro_rules! robots {
    ($($Variant:ident($Type:ty)),*) => { $(
        impl From<$Type> for Robot {
            fn from(robot: $Type) -> Self {
                Self::$Variant(robot)
            }
        }
    )* };
}

robots!(Arm(Arm), Disc(DiscRobot), RigidBody(RigidBody), Car(Car));

impl Robot {
    /// The number of coordinates of a configuration.
    pub fn dimension(&self) -> usize {
        match self {
            Robot::Arm(arm) => arm.links().len(),
            Robot::Disc(_) => 2,
            Robot::RigidBody(_) | Robot::Car(_) => 3,
        }
    }

    /// Which coordinates of a configuration are circles.
    pub(crate) fn circles(&self) -> Vec<bool> {
        match self {
            Robot::Arm(arm) => arm.circles(),
            Robot::Disc(_) => vec![false; 2],
            Robot::RigidBody(_) | Robot::Car(_) => vec![false, false, true],
        }
    }

    /// The word for its type in documents.
    pub fn kind(&self) -> &'static str {
        self.into()
    }

    /// By how much the robot is planned for as larger on all sides, in metres.
    pub fn margin(&self) -> f64 {
        match self {
            Robot::Arm(arm) => arm.margin(),
            Robot::Disc(disc) => disc.margin(),
            Robot::RigidBody(body) => body.margin(),
            Robot::Car(car) => car.margin(),
        }
    }

    /// The same, to be planned for as if it were larger by this margin on all sides, in metres.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range` (pointer `/margin`) if the margin is not a finite number from 0 to 1e6.
    pub fn with_margin(self, margin: f64) -> Result<Self, Error> {
        Ok(match self {
            Robot::Arm(arm) => Robot::Arm(arm.with_margin(margin)?),
            Robot::Disc(disc) => Robot::Disc(disc.with_margin(margin)?),
            Robot::RigidBody(body) => Robot::RigidBody(body.with_margin(margin)?),
            Robot::Car(car) => Robot::Car(car.with_margin(margin)?),
        })
    }

    /// The parts of the robot at `q`, without its margin.
    ///
    /// # Panics
    /// If `q` has fewer entries than [`Robot::dimension`].
    pub fn footprint(&self, q: &[f64]) -> Vec<Part> {
        match self {
            Robot::Arm(arm) => arm.footprint(q),
            Robot::Disc(disc) => disc.footprint(q),
            Robot::RigidBody(_) | Robot::Car(_) => {
                let (shape, _) = self.placed_shape().expect("bodies and cars have a shape");
                vec![Part::Polygon { vertices: shape.placed([q[0], q[1], q[2]]).vertices().to_vec() }]
            }
        }
    }

    /// The shape in its own frame and the weights of the metric, of a robot whose configuration is (x, y, theta).
    pub fn placed_shape(&self) -> Option<(&Polygon, Weights)> {
        match self {
            Robot::Arm(_) | Robot::Disc(_) => None,
            Robot::RigidBody(body) => Some((&body.shape, body.weights)),
            Robot::Car(car) => Some((car.shape(), car.weights())),
        }
    }
}

/// A query: a start, and a goal or a target.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Query {
    /// The name, distinct within the scenario.
    pub name: String,
    /// The configuration to start from, as written (angles of circle joints in any number of turns).
    pub start: Vec<f64>,
    /// The goal or the target.
    #[serde(flatten)]
    pub goal: Goal,
    /// The goal region; the goal must be reached exactly if it is absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub goal_tolerance: Option<GoalTolerance>,
}

/// The goal of a query.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub enum Goal {
    /// A configuration, as written.
    #[serde(rename = "goal")]
    Configuration(Vec<f64>),
    /// Any configuration of an arm whose end effector is at the target.
    #[serde(rename = "target")]
    Target(Target),
}

impl Query {
    /// A query from one configuration to another.
    pub fn new(name: impl Into<String>, start: impl Into<Vec<f64>>, goal: impl Into<Vec<f64>>) -> Self {
        let goal = Goal::Configuration(goal.into());
        Self { name: name.into(), start: start.into(), goal, goal_tolerance: None }
    }

    /// The configurations that the query names: the start, and the goal unless it is a target.
    pub fn ends(&self) -> impl Iterator<Item = &[f64]> {
        std::iter::once(&self.start[..]).chain(self.configuration())
    }

    /// The configuration to reach; `None` if the goal is a target.
    pub fn configuration(&self) -> Option<&[f64]> {
        match &self.goal {
            Goal::Configuration(goal) => Some(goal),
            Goal::Target(_) => None,
        }
    }
}

/// A goal region: both bounds must hold. Of a disc the rotation is 0, of an arm without prismatic joints the translation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GoalTolerance {
    /// The largest distance, in metres; of an arm the farthest that each prismatic joint may be from its goal.
    pub translation: f64,
    /// The largest turn, in the shorter direction, in radians; of an arm the most that each revolute joint may be from its goal.
    pub rotation: f64,
}
