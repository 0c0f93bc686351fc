//! A fleet: a world, and several robots in it, each with a start and a goal. The types that its document is read into, and the
//! rules that they cannot express.

use super::FORMAT;
use super::motion::{Footprint, Pose, reach};
use crate::error::{Code, Error, Number, quoted};
use crate::geometry::Aabb;
use crate::json::{self, objects, one_format};
use crate::problem::naming_nearest;
use crate::robot::Part;
use crate::scenario::document;
use crate::scenario::number::{AngleOrCoordinate, Positive};
use crate::scenario::validate::{Names, check_name, checked_configuration, checked_robot, checked_world, note_name};
use crate::scenario::{Goal, Obstacle, Parts, Query, Robot, Scenario, World};
use crate::space::MotionSpace;
use crate::world::{Derived, PlanningWorld, SMALL};
use serde::Serialize;
use serde_json::Value;
use std::sync::Arc;

/// The most robots of a fleet.
pub const MAX_ROBOTS: usize = 1000;

/// The finest checker is wanted where no motion is proven.
const ANY_TOLERANCE: f64 = 1e-4;

objects! {
    /// Several robots that share a floor, each with a start and a goal. Lengths in metres, angles in radians, counter-clockwise,
    /// y up, speeds in metres per second.
    #[cfg_attr(feature = "schema", schemars(title = "Planarium fleet"))]
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "FleetDocument"))]
    pub(super) struct Document {
        /// The format of the document.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "\"planarium-fleet-1\""))]
        format: Format,
        /// The name, used in results.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        name: String,
        /// The title for people.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        title: Option<String>,
        /// The bounds, which are required, and obstacles.
        world: document::World,
        /// The robots; names are distinct.
        #[cfg_attr(feature = "schema", schemars(length(min = 1, max = 1000)))]
        #[cfg_attr(target_arch = "wasm32", tsify(type = "FleetRobotDocument[]"))]
        robots: Vec<Member>,
    }

    /// A robot of a fleet, with its start and its goal.
    #[cfg_attr(feature = "schema", schemars(rename = "FleetRobot"))]
    #[cfg_attr(target_arch = "wasm32", tsify(rename = "FleetRobotDocument"))]
    struct Member {
        /// The name, distinct within the fleet.
        #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
        name: String,
        /// The robot: a disc or a rigid body.
        robot: document::Robot,
        /// The speed that no point of the robot exceeds, in metres per second; 1 by default.
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        speed: Option<Positive>,
        /// Where it stands until it leaves.
        #[cfg_attr(feature = "schema", schemars(length(min = 2, max = 3)))]
        start: Vec<AngleOrCoordinate>,
        /// Where it stands from its arrival on.
        #[cfg_attr(feature = "schema", schemars(length(min = 2, max = 3)))]
        goal: Vec<AngleOrCoordinate>,
    }
}

one_format!(enum Format = "planarium-fleet-1");

/// The JSON Schema (draft 2020-12) of the documents that [`Fleet::parse`] accepts.
#[cfg(feature = "schema")]
pub fn schema() -> Value {
    crate::scenario::schema_of::<Document>()
}

/// A checked fleet: a world, and robots that share its floor. Clones share all of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fleet(Arc<Content>);

/// The content of a fleet, as its document has it.
#[derive(Debug, PartialEq, Serialize)]
#[serde(tag = "format", rename = "planarium-fleet-1")]
struct Content {
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    world: World,
    robots: Vec<FleetRobot>,
    #[serde(skip)]
    prepared: Derived<Prepared>,
}

/// A fleet prepared for planning.
struct Prepared {
    /// Of every robot, the index of its world: equal robots share one.
    kinds: Vec<usize>,
    /// One of every kind; all share what is prepared of the obstacles.
    worlds: Vec<PlanningWorld>,
    /// Of every robot.
    footprints: Vec<Footprint>,
    slack: f64,
}

impl Prepared {
    fn new(name: &str, world: &World, robots: &[FleetRobot]) -> Self {
        let mut worlds: Vec<PlanningWorld> = Vec::new();
        let kind = |member: &FleetRobot| {
            let known = worlds.iter().position(|world| world.scenario().robot() == &member.robot);
            known.unwrap_or_else(|| {
                let scenario = member.scenario(name, world);
                worlds.push(match worlds.first() {
                    Some(first) => PlanningWorld::sharing(scenario, first.collision()),
                    None => PlanningWorld::new(scenario),
                });
                worlds.len() - 1
            })
        };
        let kinds: Vec<usize> = robots.iter().map(kind).collect();
        // Equal robots share what is prepared of them.
        let of_kinds: Vec<Footprint> = worlds.iter().map(|world| Footprint::of(world.robot())).collect();
        let footprints = kinds.iter().map(|&kind| of_kinds[kind].clone()).collect();
        Self { kinds, worlds, footprints, slack: slack(world, robots) }
    }
}

/// The slack: contact closer than this is conflict, in metres. 1e-12 of the largest coordinate plus the reach of the largest
/// robot.
fn slack(world: &World, robots: &[FleetRobot]) -> f64 {
    let boxes = world.obstacles.iter().map(Obstacle::aabb).chain(world.bounds);
    let corners = boxes.flat_map(|aabb| [aabb.min, aabb.max]);
    let largest = corners.map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
    let reach = robots.iter().map(|member| reach(&member.robot)).fold(0.0, f64::max);
    1e-12 * (largest + reach)
}

/// A robot of a fleet.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FleetRobot {
    /// The name, distinct within the fleet.
    pub name: String,
    /// A disc or a rigid body.
    pub robot: Robot,
    /// The speed that no point of the robot exceeds, in metres per second.
    pub speed: f64,
    /// Where it stands until it leaves: x, y, and theta of a body.
    pub start: Vec<f64>,
    /// Where it stands from its arrival on.
    pub goal: Vec<f64>,
}

/// A fleet as its document has it.
#[derive(Serialize)]
struct Values {
    format: &'static str,
    name: String,
    world: World,
    robots: Vec<FleetRobot>,
}

impl FleetRobot {
    /// A robot, its greatest speed in metres per second, and where it stands at first and at last.
    pub fn new(
        name: impl Into<String>,
        robot: impl Into<Robot>,
        speed: f64,
        start: impl Into<Vec<f64>>,
        goal: impl Into<Vec<f64>>,
    ) -> Self {
        Self { name: name.into(), robot: robot.into(), speed, start: start.into(), goal: goal.into() }
    }

    /// The parts of the robot at a configuration.
    pub fn footprint(&self, q: &[f64]) -> Vec<Part> {
        self.robot.footprint(q)
    }

    /// The scenario of this robot alone.
    fn scenario(&self, fleet: &str, world: &World) -> Scenario {
        let Self { name, robot, start, goal, .. } = self.clone();
        let queries = vec![Query { name, start, goal: Goal::Configuration(goal), goal_tolerance: None }];
        Parts::new(fleet.to_owned(), None, world.clone(), robot, queries).into()
    }
}

impl Fleet {
    /// Reads a fleet from JSON text.
    ///
    /// # Errors
    /// The first rule that is violated, with the JSON pointer of the offending value: the codes of [`Scenario::parse`];
    /// `unsupported` for a robot that is neither a disc nor a rigid body, or has a margin; `start-in-collision` and
    /// `goal-in-collision` if a start or a goal touches an obstacle, leaves the bounds, or touches the start or the goal of an
    /// earlier robot; `too-large` for more than 1000 robots.
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::read(&json::parse(text)?)
    }

    /// Reads a fleet from a tree of JSON values.
    ///
    /// # Errors
    /// Those of [`Fleet::parse`], except about the text.
    pub fn read(tree: &Value) -> Result<Self, Error> {
        let Document { format: Format::One, name, title, world, robots } = json::read_document(tree, FORMAT)?;
        check_name(&name, "/name")?;
        let world = checked_world(world)?;
        if world.bounds.is_none() {
            return Err(Error::new(Code::MissingField, "/world/bounds", "the field \"bounds\" is missing"));
        }
        if robots.is_empty() {
            return Err(Error::new(Code::OutOfRange, "/robots", "a fleet has at least one robot"));
        }
        if robots.len() > MAX_ROBOTS {
            let sentence = format!("there are {} robots; at most {MAX_ROBOTS} are allowed", robots.len());
            return Err(Error::new(Code::TooLarge, "/robots", sentence));
        }
        let mut names = Names::new();
        let mut checked = Vec::with_capacity(robots.len());
        for (i, member) in robots.into_iter().enumerate() {
            let member = checked_member(member).map_err(|error| error.under(&format!("/robots/{i}")))?;
            note_name(&mut names, &member.name, "robot", &format!("/robots/{i}/name"))?;
            checked.push(member);
        }
        Self::of(name, title, world, checked)
    }

    /// A fleet of values: the same rules hold as for documents.
    ///
    /// # Errors
    /// Those of [`Fleet::parse`], with the pointer that the value has in the document; `not-finite`. None is about the text.
    ///
    /// # Example
    /// Two discs that exchange places:
    ///
    /// ```
    /// use planarium::fleet::{self, Fleet, FleetPlanner, FleetRobot, PbsOptions};
    /// use planarium::geometry::{Aabb, Point};
    /// use planarium::problem::{Status, Stepped};
    /// use planarium::robot::DiscRobot;
    /// use planarium::scenario::World;
    ///
    /// let world = World::new(Some(Aabb::of(Point::new(0.0, 0.0), Point::new(4.0, 2.0))), []);
    /// let disc = DiscRobot::new(0.3)?;
    /// let robots = [
    ///     FleetRobot::new("left", disc.clone(), 1.0, [0.5, 1.0], [3.5, 1.0]),
    ///     FleetRobot::new("right", disc, 1.0, [3.5, 1.0], [0.5, 1.0]),
    /// ];
    /// let fleet = Fleet::new("exchange", world, robots)?;
    /// let mut planner = FleetPlanner::new(&fleet, PbsOptions::default())?;
    /// assert_eq!(planner.step(u64::MAX), Status::Solved);
    /// assert!(fleet::verify(&fleet, &planner.result())?.is_valid());
    /// # Ok::<(), planarium::Error>(())
    /// ```
    pub fn new(
        name: impl Into<String>,
        world: World,
        robots: impl IntoIterator<Item = FleetRobot>,
    ) -> Result<Self, Error> {
        let robots: Vec<FleetRobot> = robots.into_iter().collect();
        Self::read(&json::finite_tree(&Values { format: FORMAT, name: name.into(), world, robots })?)
    }

    /// The fleet of these robots, whose starts and goals are checked.
    ///
    /// # Errors
    /// `start-in-collision` and `goal-in-collision`.
    pub(super) fn of(
        name: String,
        title: Option<String>,
        world: World,
        robots: Vec<FleetRobot>,
    ) -> Result<Self, Error> {
        let prepared = Derived(Prepared::new(&name, &world, &robots));
        let fleet = Self(Arc::new(Content { name, title, world, robots, prepared }));
        fleet.check_ends()?;
        Ok(fleet)
    }

    /// Refuses starts and goals in collision, with an obstacle or with one another.
    fn check_ends(&self) -> Result<(), Error> {
        let Prepared { kinds, worlds, footprints, slack } = &*self.0.prepared;
        let prepared = |world: &PlanningWorld| {
            let space = MotionSpace::new(world.default_space());
            (world.checker::<SMALL>(&space, ANY_TOLERANCE).validity(), space)
        };
        let prepared: Vec<_> = worlds.iter().map(prepared).collect();
        for (i, member) in self.robots().iter().enumerate() {
            let (checker, space) = &prepared[kinds[i]];
            for (what, code, q) in
                [("start", Code::StartInCollision, &member.start), ("goal", Code::GoalInCollision, &member.goal)]
            {
                let ends = |other: &FleetRobot| pose(if what == "start" { &other.start } else { &other.goal });
                let touches =
                    |at: Pose, j: usize| footprints[i].is_within(at, &footprints[j], ends(&self.robots()[j]), *slack);
                let refuse = |why: String| {
                    let sentence = format!("the {what} {q:?} of {} is in collision: {why}", quoted(&member.name));
                    let error = Error::new(code, format!("/robots/{i}/{what}"), sentence);
                    let is_free = |state: &[f64; SMALL]| {
                        let at = pose(&state[..q.len()]);
                        checker.is_free(state) && (0..self.robots().len()).all(|j| j == i || !touches(at, j))
                    };
                    Err(naming_nearest(error, space, &is_free, &state(q)))
                };
                if let Some(why) = checker.collision(&state(q)) {
                    return refuse(why);
                }
                let at = pose(q);
                if let Some(j) = (0..i).find(|&j| touches(at, j)) {
                    return refuse(format!("it touches the {what} of {}", quoted(&self.robots()[j].name)));
                }
            }
        }
        Ok(())
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

    /// The bounds of the world.
    pub fn bounds(&self) -> &Aabb {
        self.0.world.bounds.as_ref().expect("a fleet has bounds")
    }

    /// The robots in the order of the document.
    pub fn robots(&self) -> &[FleetRobot] {
        &self.0.robots
    }

    /// The robot of that name, by its index.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.robots().iter().position(|member| member.name == name)
    }

    /// The scenario of one robot alone, whose query has the robot's name.
    ///
    /// # Panics
    /// If there is no such robot.
    pub fn scenario(&self, robot: usize) -> Scenario {
        self.robots()[robot].scenario(self.name(), self.world())
    }

    /// The normalised document as text, on one line: it reads back as an equal fleet.
    pub fn to_json_string(&self) -> String {
        json::to_string(self)
    }

    /// Contact closer than this is conflict, in metres.
    pub(super) fn slack(&self) -> f64 {
        self.0.prepared.slack
    }

    /// The worlds, one of every kind of robot.
    pub(super) fn worlds(&self) -> &[PlanningWorld] {
        &self.0.prepared.worlds
    }

    /// Of every robot, the index of its world.
    pub(super) fn kinds(&self) -> &[usize] {
        &self.0.prepared.kinds
    }

    /// Of every robot, what it covers.
    pub(super) fn footprints(&self) -> &[Footprint] {
        &self.0.prepared.footprints
    }
}

/// A checked robot of a fleet.
fn checked_member(member: Member) -> Result<FleetRobot, Error> {
    check_name(&member.name, "/name")?;
    let robot = checked_robot(member.robot)?;
    if !matches!(robot, Robot::Disc(_) | Robot::RigidBody(_)) {
        let sentence = format!("a robot of a fleet is a disc or a rigid body, not \"{}\"", robot.kind());
        return Err(Error::new(Code::Unsupported, "/robot/type", sentence));
    }
    if robot.margin() > 0.0 {
        let sentence = format!("a robot of a fleet has no margin; this one has {}", Number(robot.margin()));
        return Err(Error::new(Code::Unsupported, "/robot/margin", sentence));
    }
    let [start, goal] = [("/start", &member.start), ("/goal", &member.goal)]
        .map(|(pointer, q)| checked_configuration(q, pointer, &robot));
    let speed = member.speed.map_or(1.0, |speed| speed.0);
    Ok(FleetRobot { name: member.name, robot, speed, start: start?, goal: goal? })
}

/// A configuration as x, y, theta; of a disc theta is 0.
pub(super) fn pose(q: &[f64]) -> Pose {
    [q[0], q[1], q.get(2).copied().unwrap_or(0.0)]
}

/// A configuration as a state of the robot's own space, as it is written.
fn state(q: &[f64]) -> [f64; SMALL] {
    let [x, y, theta] = pose(q);
    [x, y, theta, 0.0]
}
