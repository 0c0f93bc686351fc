//! From a document to a checked scenario: the rules that types cannot express. The first one violated is the error.

use super::document::{self, Document};
use super::number::{AngleOrCoordinate, NonNegative};
use super::obstacle::{checked_obstacle, checked_polygon, point};
use super::{
    FORMAT, Goal, GoalTolerance, MAX_OBSTACLES, MAX_VERTICES, MapFrame, Obstacle, Parts, Query, Robot, Scenario, World,
};
use crate::error::{Code, Error, Number, quoted};
use crate::geometry::{Aabb, Polygon, Segment};
use crate::json;
use crate::robot::{Arm, Car, DiscRobot, Joint, RigidBody, Target, Weights};
use serde::de::DeserializeOwned;
use serde_json::Value;

/// The default step of integration, in seconds.
const INTEGRATION_STEP: f64 = 0.01;

impl Scenario {
    /// Reads a scenario from JSON text.
    ///
    /// # Errors
    /// The first rule that is violated: a stable code, a sentence with the offending value, and its JSON pointer; for a
    /// missing field, that of the field. Codes: those of [`json::parse`],
    /// `unknown-format`, `unknown-field`, `missing-field`, `wrong-type`, `unknown-type`, `out-of-range`,
    /// `wrong-dimension`, `degenerate-polygon`, `degenerate-wall`, `duplicate-name`, `base-in-collision` and `too-large`.
    /// A start or a goal in collision is not an error here but when a run starts.
    ///
    /// # Complexity
    /// O(n log n) in the length of the text.
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::read(&json::parse(text)?)
    }

    /// A scenario of values: the same rules hold as for documents, and the same normal form is made of them.
    ///
    /// # Errors
    /// Those of [`Scenario::parse`], with the pointer that the value has in the document, such as `missing-field` for a world
    /// without bounds; `not-finite`. None is about the text.
    ///
    /// # Complexity
    /// As for a document of the size of the scenario.
    ///
    /// # Example
    /// An arm of two links, 0.8 m long, beside a disc:
    ///
    /// ```
    /// use planarium::geometry::{Aabb, Point};
    /// use planarium::robot::Arm;
    /// use planarium::run::{self, PrmOptions, Status};
    /// use planarium::scenario::{Obstacle, Query, Scenario, World};
    ///
    /// let arm = Arm::new(Point::new(1.0, 1.0), vec![0.5, 0.3], 0.02, None)?;
    /// let bounds = Aabb::of(Point::new(0.0, 0.0), Point::new(2.0, 2.0));
    /// let world = World::new(Some(bounds), [Obstacle::disc(Point::new(1.5, 1.4), 0.1)]);
    /// let query = Query::new("over", [0.0, 0.0], [1.6, 0.5]);
    /// let scenario = Scenario::new("bench", world, arm, [query])?;
    ///
    /// let prm = PrmOptions { samples: Some(300), ..PrmOptions::default() };
    /// let mut run = run::start(&scenario, prm)?;
    /// assert_eq!(run.step(100_000), Status::Solved);
    /// assert!(run.length() >= 2.1);
    /// # Ok::<(), planarium::Error>(())
    /// ```
    pub fn new(
        name: impl Into<String>,
        world: World,
        robot: impl Into<Robot>,
        queries: impl IntoIterator<Item = Query>,
    ) -> Result<Self, Error> {
        let (name, robot, queries) = (name.into(), robot.into(), queries.into_iter().collect());
        Self::read(&json::finite_tree(&Parts::new(name, None, world, robot, queries))?)
    }

    /// Reads a scenario from a tree of JSON values.
    ///
    /// # Errors
    /// Those of [`Scenario::parse`], except about the text.
    pub fn read(tree: &Value) -> Result<Self, Error> {
        let Document { format: document::Format::One, name, title, frame, world, robot, queries } =
            json::read_document(tree, FORMAT)?;
        check_name(&name, "/name")?;
        let world = checked_world(world)?;
        let robot = checked_robot(robot)?;
        if world.bounds.is_none() && !matches!(robot, Robot::Arm(_)) {
            let sentence = "the field \"bounds\" is missing; it is optional only for an arm";
            return Err(Error::new(Code::MissingField, "/world/bounds", sentence));
        }
        check_base(&world, &robot)?;
        let queries = checked_queries(queries, &robot)?;
        let frame = frame.map_or_else(MapFrame::default, MapFrame::of);
        Ok(Parts { name, title, frame, world, robot, queries }.into())
    }
}

pub(crate) fn check_name(name: &str, pointer: &str) -> Result<(), Error> {
    if name.is_empty() { Err(Error::new(Code::OutOfRange, pointer, "a name must not be empty")) } else { Ok(()) }
}

pub(crate) fn checked_world(world: document::World) -> Result<World, Error> {
    let bounds = world.bounds.map(checked_bounds).transpose()?;
    let count = world.obstacles.len();
    if count > MAX_OBSTACLES {
        let sentence = format!("there are {count} obstacles; at most {MAX_OBSTACLES} are allowed");
        return Err(Error::new(Code::TooLarge, "/world/obstacles", sentence));
    }
    let mut vertices_left = MAX_VERTICES;
    let checked = |(i, obstacle)| {
        checked_obstacle(obstacle, &mut vertices_left).map_err(|error| error.under(&format!("/world/obstacles/{i}")))
    };
    Ok(World { bounds, obstacles: world.obstacles.into_iter().enumerate().map(checked).collect::<Result<_, _>>()? })
}

fn checked_bounds(bounds: document::Bounds) -> Result<Aabb, Error> {
    let (min, max) = (point(bounds.min), point(bounds.max));
    for (axis, low, high) in [("x", min.x, max.x), ("y", min.y, max.y)] {
        if low >= high {
            let [low, high] = [low, high].map(Number);
            let sentence = format!("in {axis} the bounds run from {low} to {high}; min must be less than max");
            return Err(Error::new(Code::OutOfRange, "/world/bounds", sentence));
        }
    }
    Ok(Aabb { min, max })
}

fn checked_joints(joints: &[Value]) -> Result<Vec<Joint>, Error> {
    let joint = |(i, joint): (usize, &Value)| {
        let pointer = format!("/joints/{i}");
        Ok(match joint {
            Value::String(word) if word == "revolute" => Joint::CIRCLE,
            Value::String(word) => {
                let word = quoted(word);
                let sentence = format!("a joint is \"revolute\" or an object with a type, not the string {word}");
                return Err(Error::new(Code::UnknownType, pointer, sentence));
            }
            object => match read_under(object, &pointer)? {
                document::Joint::Revolute(document::Revolute { limits }) => {
                    Joint::Revolute { limits: limits.map(|limits| limits.map(|limit| limit.0)) }
                }
                document::Joint::Prismatic(document::Prismatic { range, angle }) => {
                    Joint::Prismatic { range: range.map(|end| end.0), angle: angle.0 }
                }
            },
        })
    };
    joints.iter().enumerate().map(joint).collect()
}

pub(crate) fn checked_robot(robot: document::Robot) -> Result<Robot, Error> {
    let margin = match &robot {
        document::Robot::Arm(arm) => arm.margin.0,
        document::Robot::Disc(disc) => disc.margin.0,
        document::Robot::RigidBody(body) => body.margin.0,
        document::Robot::Car(car) => car.margin.0,
    };
    let made = match robot {
        document::Robot::Arm(arm) => {
            let links = arm.links.iter().map(|length| length.0).collect();
            let limits = arm.joint_limits.map(|limits| limits.iter().map(|pair| pair.map(|limit| limit.0)).collect());
            let (base, radius) = (point(arm.base), arm.radius.0);
            match (arm.joints, limits) {
                (None, limits) => Arm::new(base, links, radius, limits).map(Robot::Arm),
                (Some(joints), None) => checked_joints(&joints)
                    .and_then(|joints| Arm::with_joints(base, links, radius, joints).map(Robot::Arm)),
                (Some(_), Some(_)) => {
                    let sentence = "the limits of an arm with joints stand in these, as \"limits\" of each";
                    Err(Error::new(Code::UnknownField, "/joint_limits", sentence))
                }
            }
        }
        document::Robot::Disc(disc) => DiscRobot::new(disc.radius.0).map(Robot::Disc),
        document::Robot::RigidBody(body) => checked_shape(&body.shape)
            .and_then(|shape| Ok(Robot::RigidBody(RigidBody::new(shape, checked_weights(body.metric)?)))),
        document::Robot::Car(car) => checked_shape(&car.shape).and_then(|shape| {
            let [speed, steering] = [car.speed.map(|speed| speed.0), car.steering.map(|angle| angle.0)];
            let step = car.integration_step.map_or(INTEGRATION_STEP, |step| step.0);
            Car::new(shape, car.wheelbase.0, speed, steering, step, checked_weights(car.metric)?).map(Robot::Car)
        }),
    };
    made.and_then(|robot| robot.with_margin(margin)).map_err(|error| error.under("/robot"))
}

fn checked_shape(document::Shape::Polygon(polygon): &document::Shape) -> Result<Polygon, Error> {
    checked_polygon(polygon, &mut { MAX_VERTICES }).map_err(|error| error.under("/shape"))
}

fn checked_weights(metric: Option<document::Metric>) -> Result<Weights, Error> {
    metric.map_or(Ok(Weights::default()), |metric| Weights::new(metric.translation.0, metric.rotation.0))
}

fn checked_queries(queries: Vec<document::Query>, robot: &Robot) -> Result<Vec<Query>, Error> {
    let (mut checked, mut names) = (Vec::with_capacity(queries.len()), Names::new());
    for (i, query) in queries.into_iter().enumerate() {
        let query = checked_query(query, robot).map_err(|error| error.under(&format!("/queries/{i}")))?;
        note_name(&mut names, &query.name, "query", &format!("/queries/{i}/name"))?;
        checked.push(query);
    }
    Ok(checked)
}

/// Names that were met. It is the map of the JSON reader, which is linked in any case.
pub(crate) type Names = serde_json::Map<String, Value>;

/// Adds a name to those of other queries or robots, from which it must differ.
pub(crate) fn note_name(names: &mut Names, name: &str, what: &str, pointer: &str) -> Result<(), Error> {
    if names.insert(name.to_owned(), Value::Null).is_none() {
        return Ok(());
    }
    let sentence = format!("another {what} has the name {}, too", quoted(name));
    Err(Error::new(Code::DuplicateName, pointer, sentence))
}

fn checked_query(query: document::Query, robot: &Robot) -> Result<Query, Error> {
    let unknown = |field: &str, sentence: String| Err(Error::new(Code::UnknownField, format!("/{field}"), sentence));
    if query.target.is_some() && !matches!(robot, Robot::Arm(_)) {
        return unknown("target", "a target is for the end effector of an arm; other robots have a goal".to_owned());
    }
    if query.goal_tolerance.is_some() && query.target.is_some() {
        return unknown("goal_tolerance", "a target is reached exactly; a goal may have a tolerance".to_owned());
    }
    check_name(&query.name, "/name")?;
    let start = checked_configuration(&query.start, "/start", robot)?;
    let goal = match (query.goal, query.target) {
        (Some(goal), None) => Goal::Configuration(checked_configuration(&goal, "/goal", robot)?),
        (None, Some(target)) => {
            let document::Target { point: at, orientation } = read_under(&target, "/target")?;
            Goal::Target(Target { point: point(at), orientation: orientation.map(|angle| angle.0) })
        }
        (Some(_), Some(_)) => return unknown("target", "a query has a goal or a target, not both".to_owned()),
        (None, None) => {
            return Err(Error::new(Code::MissingField, "/goal", "the field \"goal\" or \"target\" is missing"));
        }
    };
    let goal_tolerance = query.goal_tolerance.map(|value| checked_region(&value, robot)).transpose()?;
    Ok(Query { name: query.name, start, goal, goal_tolerance })
}

/// A goal region with the bounds that the robot has.
fn checked_region(value: &Value, robot: &Robot) -> Result<GoalTolerance, Error> {
    let document::GoalTolerance { translation, rotation } = read_under(value, "/goal_tolerance")?;
    let [slides, turns] = match robot {
        Robot::RigidBody(_) | Robot::Car(_) => [true; 2],
        Robot::Disc(_) => [true, false],
        Robot::Arm(arm) => {
            [true, false].map(|is_slide| arm.joint_types().iter().any(|joint| joint.is_prismatic() == is_slide))
        }
    };
    let bound = |name: &str, given: Option<NonNegative>, is_there: bool| {
        let pointer = format!("/goal_tolerance/{name}");
        match (given.map(|bound| bound.0), is_there) {
            (Some(bound), true) => Ok(bound),
            (None, true) => {
                Err(Error::new(Code::MissingField, pointer, format!("the field {} is missing", quoted(name))))
            }
            (None | Some(0.0), false) => Ok(0.0),
            (Some(_), false) => {
                let sentence = format!("this robot has no coordinate for a {name} other than 0");
                Err(Error::new(Code::OutOfRange, pointer, sentence))
            }
        }
    };
    Ok(GoalTolerance {
        translation: bound("translation", translation, slides)?,
        rotation: bound("rotation", rotation, turns)?,
    })
}

fn read_under<T: DeserializeOwned>(value: &Value, pointer: &str) -> Result<T, Error> {
    json::read(value).map_err(|error| error.under(pointer))
}

/// A configuration of the robot, within the joint limits if there are any.
pub(crate) fn checked_configuration(
    configuration: &[AngleOrCoordinate],
    pointer: &str,
    robot: &Robot,
) -> Result<Vec<f64>, Error> {
    let q: Vec<f64> = configuration.iter().map(|entry| entry.0).collect();
    if q.len() != robot.dimension() {
        let sentence = format!("a configuration of this robot has {} entries, not {}", robot.dimension(), q.len());
        return Err(Error::new(Code::WrongDimension, pointer, sentence));
    }
    if let Robot::Arm(arm) = robot {
        for (i, (at, joint)) in q.iter().zip(arm.joint_types()).enumerate() {
            if let Some([low, high]) = joint.range().filter(|[low, high]| !(*low..=*high).contains(at)) {
                let [low, high, at] = [low, high, *at].map(Number);
                let (what, range) = if joint.is_prismatic() { ("coordinate", "range") } else { ("angle", "limits") };
                let sentence =
                    format!("the {what} of joint {i} must be within its {range}, from {low} to {high}, not {at}");
                return Err(Error::new(Code::OutOfRange, format!("{pointer}/{i}"), sentence));
            }
        }
    }
    Ok(q)
}

/// Returns an error if an obstacle is within the arm's radius and margin of its base, or the disc of that radius about the base
/// is not within the bounds: the base never moves, so every configuration would be in collision. Contact with an obstacle is
/// collision, contact with the bounds is not; both up to the slack of 1e-12 times the largest coordinate plus the reach.
fn check_base(world: &World, robot: &Robot) -> Result<(), Error> {
    let Robot::Arm(arm) = robot else { return Ok(()) };
    let (base, radius, slack) = (arm.base(), arm.kept_radius(), slack(world, arm));
    let what = if arm.margin() > 0.0 { "radius and margin" } else { "radius" };
    for (i, obstacle) in world.obstacles.iter().enumerate() {
        let distance = obstacle.distance_to_segment(&Segment::new(base, base));
        if distance <= radius + slack {
            let [x, y, radius, distance] = [base.x, base.y, radius, distance].map(Number);
            let sentence =
                format!("obstacle {i} is {distance} from the arm's base [{x}, {y}], within its {what} of {radius}");
            return Err(Error::new(Code::BaseInCollision, format!("/world/obstacles/{i}"), sentence));
        }
    }
    if world.bounds.is_some_and(|bounds| bounds.depth(base) - radius < -slack) {
        let [x, y, radius] = [base.x, base.y, radius].map(Number);
        let sentence = format!("the arm's base [{x}, {y}] with its {what} of {radius} is not within the bounds");
        return Err(Error::new(Code::BaseInCollision, "/robot/base", sentence));
    }
    Ok(())
}

/// 1e-12 of the largest coordinate plus the arm's reach, in metres.
fn slack(world: &World, arm: &Arm) -> f64 {
    let boxes = world.obstacles.iter().map(Obstacle::aabb).chain(world.bounds);
    let corners = boxes.flat_map(|aabb| [aabb.min, aabb.max]).chain([arm.base()]);
    let largest = corners.map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
    1e-12 * (largest + arm.reach() + arm.kept_radius())
}
