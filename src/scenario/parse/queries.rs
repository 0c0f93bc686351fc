//! The queries: names, starts and goals.

use super::LARGEST;
use crate::error::{Code, Error, quoted};
use crate::json::Names;
use crate::scenario::reader::Reader;
use crate::scenario::{GoalTolerance, Query, Robot};

/// Reads `queries` for the robot.
pub(super) fn read(queries: &Reader, robot: &Robot) -> Result<Vec<Query>, Error> {
    let (mut read, mut names) = (Vec::<Query>::new(), Names::default());
    for item in queries.items()? {
        let fields = item.object()?;
        let is_placed = robot.placed_shape().is_some();
        let known =
            if is_placed { &["name", "start", "goal", "goal_tolerance"][..] } else { &["name", "start", "goal"] };
        fields.only(known).map_err(|error| explain_tolerance(error, robot))?;
        let name = fields.required("name")?;
        if names.has(name.name()?, &|i| &read[i as usize].name) {
            let sentence = format!("another query is named {}, too", quoted(name.name()?));
            return Err(name.error(Code::DuplicateName, sentence));
        }
        let start = read_configuration(&fields.required("start")?, robot)?;
        let goal = read_configuration(&fields.required("goal")?, robot)?;
        let goal_tolerance = fields.optional("goal_tolerance").map(|region| read_tolerance(&region)).transpose()?;
        read.push(Query { name: name.name()?.to_owned(), start, goal, goal_tolerance });
        names.add(&|i| &read[i as usize].name);
    }
    Ok(read)
}

/// Says why a tolerance of the goal, which the contract has for other robots, is not known here.
fn explain_tolerance(error: Error, robot: &Robot) -> Error {
    if !error.pointer().ends_with("/goal_tolerance") {
        return error;
    }
    let robot = if matches!(robot, Robot::Arm(_)) { "an arm" } else { "a disc" };
    let sentence = format!("goal_tolerance is for rigid bodies and cars; {robot} reaches its goal exactly");
    Error::new(error.code(), error.pointer(), sentence)
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
