//! The queries: names, starts and goals.

use super::LARGEST;
use super::world::read_point;
use crate::error::{Code, Error, quoted};
use crate::json::Names;
use crate::robot::Target;
use crate::scenario::reader::Reader;
use crate::scenario::{Goal, GoalTolerance, Query, Robot};

/// Reads `queries` for the robot.
pub(super) fn read(queries: &Reader, robot: &Robot) -> Result<Vec<Query>, Error> {
    let (mut read, mut names) = (Vec::<Query>::new(), Names::default());
    for item in queries.items()? {
        let fields = item.object()?;
        let is_placed = robot.placed_shape().is_some();
        let known = match robot {
            _ if is_placed => &["name", "start", "goal", "goal_tolerance"][..],
            Robot::Arm(_) => &["name", "start", "goal", "target"],
            _ => &["name", "start", "goal"],
        };
        fields.only(known).map_err(|error| explain(error, robot))?;
        let name = fields.required("name")?;
        if names.has(name.name()?, &|i| &read[i as usize].name) {
            let sentence = format!("another query is named {}, too", quoted(name.name()?));
            return Err(name.error(Code::DuplicateName, sentence));
        }
        let start = read_configuration(&fields.required("start")?, robot)?;
        let goal = match (fields.optional("goal"), fields.optional("target")) {
            (_, None) => Goal::Configuration(read_configuration(&fields.required("goal")?, robot)?),
            (None, Some(target)) => Goal::Target(read_target(&target)?),
            (Some(_), Some(target)) => {
                return Err(target.error(Code::UnknownField, "a query has a goal or a target, not both"));
            }
        };
        let goal_tolerance = fields.optional("goal_tolerance").map(|region| read_tolerance(&region)).transpose()?;
        read.push(Query { name: name.name()?.to_owned(), start, goal, goal_tolerance });
        names.add(&|i| &read[i as usize].name);
    }
    Ok(read)
}

/// Says why a field that the contract has for other robots is not known here.
fn explain(error: Error, robot: &Robot) -> Error {
    let sentence = if error.pointer().ends_with("/goal_tolerance") {
        let robot = if matches!(robot, Robot::Arm(_)) { "an arm" } else { "a disc" };
        format!("goal_tolerance is for rigid bodies and cars; {robot} reaches its goal exactly")
    } else if error.pointer().ends_with("/target") {
        "a target is for the end effector of an arm; other robots have a goal".to_owned()
    } else {
        return error;
    };
    Error::new(error.code(), error.pointer(), sentence)
}

/// Reads where the end effector is to be.
fn read_target(target: &Reader) -> Result<Target, Error> {
    let fields = target.object()?;
    fields.only(&["point", "orientation"])?;
    let point = read_point(&fields.required("point")?)?;
    let angle = |angle: Reader| angle.number_within("an angle", -LARGEST, LARGEST);
    Ok(Target { point, orientation: fields.optional("orientation").map(angle).transpose()? })
}

/// Reads a region about the goal.
fn read_tolerance(region: &Reader) -> Result<GoalTolerance, Error> {
    let fields = region.object()?;
    fields.only(&["translation", "rotation"])?;
    let within = |name: &str| fields.required(name)?.number_within("a tolerance of the goal", 0.0, LARGEST);
    Ok(GoalTolerance { translation: within("translation")?, rotation: within("rotation")? })
}

/// Reads a configuration of the robot: coordinates within 1e6 metres, angles within the joint's limits or, without limits,
/// within 1e6 radians.
fn read_configuration(configuration: &Reader, robot: &Robot) -> Result<Vec<f64>, Error> {
    let items = configuration.items()?;
    if items.len() != robot.dimension() {
        let sentence = format!("a configuration of this robot has {} entries, not {}", robot.dimension(), items.len());
        return Err(configuration.error(Code::WrongDimension, sentence));
    }
    let entry = |(i, item): (usize, Reader)| match robot {
        Robot::RigidBody(_) | Robot::Car(_) if i == 2 => item.number_within("an angle", -LARGEST, LARGEST),
        Robot::Disc(_) | Robot::RigidBody(_) | Robot::Car(_) => item.number_within("a coordinate", -LARGEST, LARGEST),
        Robot::Arm(arm) => match arm.joint_limits() {
            Some(limits) => {
                item.number_within(&format!("the angle of joint {i}, by its limits,"), limits[i][0], limits[i][1])
            }
            None => item.number_within("an angle", -LARGEST, LARGEST),
        },
    };
    items.enumerate().map(entry).collect()
}
