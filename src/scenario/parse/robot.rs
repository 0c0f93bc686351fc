//! The robot.

use super::MAX_VERTICES;
use super::world::{read_point, read_polygon};
use crate::error::{Code, Error, quoted};
use crate::geometry::Polygon;
use crate::robot::{Arm, Car, DiscRobot, RigidBody, Weights};
use crate::scenario::Robot;
use crate::scenario::reader::{Fields, Reader};

/// The step of integration where none is given, in seconds.
const INTEGRATION_STEP: f64 = 0.01;

/// Reads `robot`. The ranges of lengths, radii and limits are the robots' own.
pub(super) fn read(robot: &Reader) -> Result<Robot, Error> {
    let fields = robot.object()?;
    let kind = fields.required("type")?;
    let made = match kind.string()? {
        "arm" => {
            fields.only(&["type", "base", "links", "radius", "joint_limits"])?;
            let base = read_point(&fields.required("base")?)?;
            let links = fields.required("links")?.numbers()?;
            let radius = fields.optional("radius").map_or(Ok(0.0), |radius| radius.number())?;
            let joint_limits = fields.optional("joint_limits").map(|limits| read_limits(&limits)).transpose()?;
            Arm::new(base, links, radius, joint_limits).map(Robot::Arm)
        }
        "disc" => {
            fields.only(&["type", "radius"])?;
            DiscRobot::new(fields.required("radius")?.number()?).map(Robot::Disc)
        }
        "rigid_body" => {
            fields.only(&["type", "shape", "metric"])?;
            let shape = read_shape(&fields.required("shape")?)?;
            Ok(Robot::RigidBody(RigidBody::new(shape, read_weights(robot, &fields)?)))
        }
        "car" => {
            fields.only(&["type", "shape", "wheelbase", "speed", "steering", "integration_step", "metric"])?;
            let shape = read_shape(&fields.required("shape")?)?;
            let wheelbase = fields.required("wheelbase")?.number()?;
            let [speed, steering] = ["speed", "steering"].map(|name| read_pair(&fields.required(name)?));
            let step = fields.optional("integration_step").map_or(Ok(INTEGRATION_STEP), |step| step.number())?;
            Car::new(shape, wheelbase, speed?, steering?, step, read_weights(robot, &fields)?).map(Robot::Car)
        }
        other => {
            let sentence =
                format!("there is no robot of type {}; there are arm, disc, rigid_body and car", quoted(other));
            return Err(kind.error(Code::UnknownType, sentence));
        }
    };
    made.map_err(|error| error.under(&robot.pointer()))
}

fn read_limits(limits: &Reader) -> Result<Vec<[f64; 2]>, Error> {
    limits.items()?.map(|item| read_pair(&item)).collect()
}

fn read_pair(pair: &Reader) -> Result<[f64; 2], Error> {
    let [low, high] = pair.tuple("a pair of limits")?;
    Ok([low.number()?, high.number()?])
}

/// Reads the shape of a body: a polygon in its own frame.
fn read_shape(shape: &Reader) -> Result<Polygon, Error> {
    let fields = shape.object()?;
    let kind = fields.required("type")?;
    if kind.string()? != "polygon" {
        let sentence = format!("there is no shape of type {}; there is polygon", quoted(kind.string()?));
        return Err(kind.error(Code::UnknownType, sentence));
    }
    fields.only(&["type", "vertices"])?;
    let mut vertices_left = MAX_VERTICES;
    read_polygon(&fields.required("vertices")?, &mut vertices_left)
}

/// Reads the weights of the metric, where they are given.
fn read_weights(robot: &Reader, fields: &Fields) -> Result<Weights, Error> {
    let Some(metric) = fields.optional("metric") else { return Ok(Weights::default()) };
    let fields = metric.object()?;
    fields.only(&["translation", "rotation"])?;
    Weights::new(fields.required("translation")?.number()?, fields.required("rotation")?.number()?)
        .map_err(|error| error.under(&robot.pointer()))
}
