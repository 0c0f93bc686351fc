//! A navigation task: a floor, a robot with a range sensor and noise, and queries. The types that its document is read into, and
//! the rules that they cannot express.

use super::FORMAT;
use super::floor::Floor;
use super::navigator::{Navigator, RobotDocument};
use super::sensor::Fan;
use crate::collision::CollisionWorld;
use crate::error::{Code, Error, within};
use crate::geometry::Aabb;
use crate::json::{self, objects, one_format};
use crate::robot::Part;
use crate::scenario::document::World as WorldDocument;
use crate::scenario::number::{AngleOrCoordinate, Coordinate, Positive};
use crate::scenario::validate::{Names, check_name, checked_world, note_name};
use crate::scenario::{Goal, Parts, Query, Robot, Scenario, World, find_query};
use crate::world::Derived;
use serde::Serialize;
use serde_json::Value;
use std::sync::Arc;

/// The default distance from a goal at which it is reached, in metres.
pub(super) const GOAL_TOLERANCE: f64 = 0.3;

objects! {
    /// A navigation task: a floor, a robot that senses distances, and queries. Lengths in metres, angles in radians,
    /// counter-clockwise, y up, times in seconds.
    #[cfg_attr(feature = "schema", schemars(title = "Planarium navigation task"))]
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "NavigationDocument"))]
    pub(super) struct Document {
        /// The format of the document.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "\"planarium-navigation-1\""))]
        format: Format,
        /// The name, used in results.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        name: String,
        /// The title for people.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        title: Option<String>,
        /// The bounds, which are required, and obstacles.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "World"))]
        world: WorldDocument,
        /// The robot.
        #[cfg_attr(
            target_arch = "wasm32",
            tsify(
                type = "({ type: \"differential_drive\" } & DifferentialDriveDocument) | ({ type: \"cargo\" } & CargoDocument)"
            )
        )]
        robot: RobotDocument,
        /// A goal is reached at this distance from it; 0.3 by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        goal_tolerance: Option<Positive>,
        /// The queries; names are distinct.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "NavigationQueryDocument[]"))]
        queries: Vec<QueryDocument>,
    }

    /// One query.
    #[cfg_attr(feature = "schema", schemars(rename = "NavigationQuery"))]
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "NavigationQueryDocument"))]
    pub(super) struct QueryDocument {
        /// The name, distinct within the task.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        name: String,
        /// The configuration to start from: x, y, theta. A carrier of cargo starts at rest, and turns its sensor to the goal.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number, number]"))]
        start: [AngleOrCoordinate; 3],
        /// The position to reach, with any heading.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number]"))]
        goal: [Coordinate; 2],
    }
}

one_format!(enum Format = "planarium-navigation-1");

/// A checked navigation task. Clones share all of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Navigation(Arc<Content>);

/// The content of a task, as its document has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "format", rename = "planarium-navigation-1")]
struct Content {
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    world: World,
    robot: Navigator,
    goal_tolerance: f64,
    queries: Vec<NavigationQuery>,
    #[serde(skip)]
    collision: Derived<CollisionWorld>,
}

/// A query: from a configuration to a position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NavigationQuery {
    /// The name, distinct within the task.
    pub name: String,
    /// The configuration to start from: x, y, theta. A carrier of cargo starts at rest, and turns its sensor to the goal.
    pub start: [f64; 3],
    /// The position to reach, with any heading.
    pub goal: [f64; 2],
}

/// The JSON Schema (draft 2020-12) of the documents that [`Navigation::parse`] accepts.
#[cfg(feature = "schema")]
pub fn schema() -> Value {
    crate::scenario::schema_of::<Document>()
}

impl Navigation {
    /// Reads a task from JSON text.
    ///
    /// # Errors
    /// The first rule that is violated, with the JSON pointer of the offending value: the codes of [`Scenario::parse`];
    /// `start-in-collision` if the robot touches an obstacle at a start or leaves the bounds, and `goal-in-collision` if it
    /// cannot turn on the spot at a goal.
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::read(&json::parse(text)?)
    }

    /// Reads a task from a tree of JSON values.
    ///
    /// # Errors
    /// Those of [`Navigation::parse`], except about the text.
    pub fn read(tree: &Value) -> Result<Self, Error> {
        let Document { format: Format::One, name, title, world, robot, goal_tolerance, queries } =
            json::read_document(tree, FORMAT)?;
        check_name(&name, "/name")?;
        let world = checked_world(world)?;
        let robot = robot.checked().map_err(|error| error.under("/robot"))?;
        let tolerance = goal_tolerance.map_or(GOAL_TOLERANCE, |tolerance| tolerance.0);
        let mut names = Names::new();
        let mut checked = Vec::with_capacity(queries.len());
        for (i, QueryDocument { name, start, goal }) in queries.into_iter().enumerate() {
            let pointer = format!("/queries/{i}/name");
            check_name(&name, &pointer)?;
            note_name(&mut names, &name, "query", &pointer)?;
            checked.push(NavigationQuery { name, start: start.map(|x| x.0), goal: goal.map(|x| x.0) });
        }
        Self::new(name, title, world, robot, tolerance, checked)
    }

    /// The task of these parts, whose starts and goals are checked.
    ///
    /// # Errors
    /// `missing-field` without bounds, `start-in-collision` and `goal-in-collision`.
    pub(super) fn new(
        name: String,
        title: Option<String>,
        world: World,
        robot: Navigator,
        goal_tolerance: f64,
        queries: Vec<NavigationQuery>,
    ) -> Result<Self, Error> {
        if world.bounds.is_none() {
            return Err(Error::new(Code::MissingField, "/world/bounds", "the field \"bounds\" is missing"));
        }
        let collision = Derived(CollisionWorld::from(&world));
        Self::checked(Content { name, title, world, robot, goal_tolerance, queries, collision })
    }

    fn checked(content: Content) -> Result<Self, Error> {
        let task = Self(Arc::new(content));
        let floor = task.floor();
        for (i, query) in task.queries().iter().enumerate() {
            floor.check(query.start, query.goal).map_err(|error| error.under(&format!("/queries/{i}")))?;
        }
        Ok(task)
    }

    /// The same floor and robot with other queries.
    ///
    /// # Errors
    /// `start-in-collision` and `goal-in-collision`, with a pointer into `/queries`.
    pub fn with_queries(&self, queries: Vec<NavigationQuery>) -> Result<Self, Error> {
        Self::checked(Content { queries, ..Content::clone(&self.0) })
    }

    /// The same floor for the robot of another task, without queries.
    pub(super) fn for_robot_of(&self, other: &Navigation) -> Self {
        let (robot, goal_tolerance) = (other.robot().clone(), other.goal_tolerance());
        Self(Arc::new(Content { title: None, robot, goal_tolerance, queries: Vec::new(), ..Content::clone(&self.0) }))
    }

    /// The obstacles and bounds, prepared.
    pub(super) fn collision(&self) -> &CollisionWorld {
        &self.0.collision
    }

    /// The floor, prepared for the robot.
    pub(super) fn floor(&self) -> Floor {
        Floor::new(self.bounds(), self.collision(), self.robot())
    }

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

    /// The bounds of the floor.
    pub fn bounds(&self) -> &Aabb {
        self.0.world.bounds.as_ref().expect("a task has bounds")
    }

    /// The robot.
    pub fn robot(&self) -> &Navigator {
        &self.0.robot
    }

    /// The distance from a goal at which it is reached, in metres.
    pub fn goal_tolerance(&self) -> f64 {
        self.0.goal_tolerance
    }

    /// The queries in the order of the document.
    pub fn queries(&self) -> &[NavigationQuery] {
        &self.0.queries
    }

    /// The query of that name, or the first, and its index.
    ///
    /// # Errors
    /// `unknown-query`, pointer `/query`, naming those that exist.
    pub fn find_query(&self, name: Option<&str>) -> Result<(usize, &NavigationQuery), Error> {
        let i = find_query("task", self.queries().iter().map(|query| &*query.name), name)?;
        Ok((i, &self.queries()[i]))
    }

    /// The scenario of a disc in which the robot turns on the spot: its queries are those of the task without headings. Straight
    /// motions of the disc can be driven, turning between them. The disc is larger than the robot by a margin, in metres.
    ///
    /// # Errors
    /// `out-of-range` or `not-finite` for a margin that is not a number from 0 to 1e6.
    pub fn disc_scenario(&self, margin: f64) -> Result<Scenario, Error> {
        let query = |query: &NavigationQuery| Query {
            name: query.name.clone(),
            start: query.start[..2].to_vec(),
            goal: Goal::Configuration(query.goal.to_vec()),
            goal_tolerance: None,
        };
        within("/margin", "a margin", margin, 0.0..=1e6)?;
        let robot = Robot::Disc(crate::robot::DiscRobot::new(self.robot().reach() + margin)?);
        let queries = self.queries().iter().map(query).collect();
        Ok(Parts::new(self.name().to_owned(), None, self.world().clone(), robot, queries).into())
    }

    /// The distance that each ray of the sensor measures at a configuration, from right to left, in metres and without noise.
    /// O(obstacles).
    pub fn sense(&self, q: [f64; 3]) -> Vec<f64> {
        let sensor = self.robot().sensor();
        let mut distances = vec![0.0; sensor.rays];
        self.floor().sense(q, sensor, &Fan::new(sensor), &mut distances);
        distances
    }

    /// The part of the robot at a configuration; of a carrier of cargo without its load.
    pub fn footprint(&self, q: [f64; 3]) -> Part {
        self.robot().footprint(q)
    }

    /// The normalised document as text, on one line: it reads back as an equal task.
    pub fn to_json_string(&self) -> String {
        json::to_string(self)
    }
}
