//! The robot.

use super::world::read_point;
use crate::error::{Code, Error, quoted};
use crate::robot::{Arm, DiscRobot};
use crate::scenario::Robot;
use crate::scenario::reader::Reader;

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
        known @ ("rigid_body" | "car") => {
            let sentence = format!("the robot is a {known}; so far paths are planned for arms and discs");
            return Err(kind.error(Code::Unsupported, sentence));
        }
        other => {
            let sentence = format!("there is no robot of type {}; there are arm and disc", quoted(other));
            return Err(kind.error(Code::UnknownType, sentence));
        }
    };
    made.map_err(|error| error.under(&robot.pointer()))
}

fn read_limits(limits: &Reader) -> Result<Vec<[f64; 2]>, Error> {
    let pair = |item: Reader| {
        let [low, high] = item.tuple("a pair of limits")?;
        Ok([low.number()?, high.number()?])
    };
    limits.items()?.map(pair).collect()
}
