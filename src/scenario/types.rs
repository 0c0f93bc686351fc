//! A checked scenario and its parts.

use crate::error::{Code, Error, quoted};
use crate::geometry::{Aabb, Disc, Placed, Point, Polygon, Segment, distance_point_segment};
use crate::json;
use crate::robot::{Arm, Car, DiscRobot, Part, RigidBody, Target, Weights};
use serde::Serialize;
use std::sync::Arc;

/// A checked scenario: a world, a robot in it, and named queries. Clones share all of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scenario(pub(super) Arc<Parts>);

/// The parts of a scenario, as its document has them.
#[derive(Debug, PartialEq, Serialize)]
#[serde(tag = "format", rename = "planarium-scenario-1")]
pub(crate) struct Parts {
    pub(crate) name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) title: Option<String>,
    pub(crate) world: World,
    pub(crate) robot: Robot,
    pub(crate) queries: Vec<Query>,
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
    /// open, counter-clockwise and without repeated vertices. It reads back as an equal scenario; equal scenarios give
    /// equal text, on every platform.
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
    /// Closed, filled obstacles; clones share them.
    pub obstacles: Arc<[Obstacle]>,
}

impl World {
    /// The obstacles within bounds; only an arm needs none.
    pub fn new(bounds: Option<Aabb>, obstacles: impl IntoIterator<Item = Obstacle>) -> Self {
        Self { bounds, obstacles: obstacles.into_iter().collect() }
    }
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

impl From<Polygon> for Obstacle {
    fn from(polygon: Polygon) -> Self {
        Self::Polygon(polygon)
    }
}

impl Obstacle {
    /// A disc: centre and radius in metres.
    pub fn disc(center: Point, radius: f64) -> Self {
        Self::Disc(Disc { center, radius })
    }

    /// The smallest box around the obstacle.
    pub fn aabb(&self) -> Aabb {
        match self {
            Obstacle::Disc(disc) => disc.aabb(),
            Obstacle::Polygon(polygon) => *polygon.aabb(),
        }
    }

    /// The distance from the segment to the obstacle, in metres; 0 or less if they share a point.
    pub fn distance_to_segment(&self, segment: &Segment) -> f64 {
        self.distance_to_segment_within(segment, f64::INFINITY)
    }

    /// The same; if it is `most` or more, that distance or infinity.
    pub fn distance_to_segment_within(&self, segment: &Segment, most: f64) -> f64 {
        match self {
            Obstacle::Disc(disc) => distance_point_segment(disc.center, segment) - disc.radius,
            Obstacle::Polygon(polygon) => Placed::resting(polygon).distance_to_segment(segment, most, &mut 0),
        }
    }

    /// The distance from the polygon to the obstacle, in metres; 0 or less if they share a point.
    pub fn distance_to_polygon(&self, other: &Polygon) -> f64 {
        self.distance_to_polygon_within(other, f64::INFINITY)
    }

    /// The same; if it is `most` or more, that distance or infinity.
    pub fn distance_to_polygon_within(&self, other: &Polygon, most: f64) -> f64 {
        let other = Placed::resting(other);
        match self {
            Obstacle::Disc(disc) => other.distance_to_point(disc.center, most + disc.radius, &mut 0) - disc.radius,
            Obstacle::Polygon(polygon) => other.distance(&Placed::resting(polygon), most, &mut 0),
        }
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

    /// The word for its type in documents.
    pub fn kind(&self) -> &'static str {
        self.into()
    }

    /// The parts of the robot at `q`.
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
