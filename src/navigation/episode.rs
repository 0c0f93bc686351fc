//! Random short tasks on a floor: from a configuration to a position not far away.

use super::floor::Floor;
use crate::geometry::{Aabb, Point};
use crate::random::Random;
use std::f64::consts::PI;

/// Starts and goals have this much room beyond the disc in which the robot turns on the spot, in metres.
const MARGIN: f64 = 0.1;

/// Goals are at least this far away, in metres.
const NEAREST: f64 = 0.5;

/// The most draws of a configuration.
const DRAWS: u32 = 10_000;

/// A configuration drawn uniformly from those with room to turn on the spot; `None` if none is found.
pub(super) fn configuration(floor: &Floor, random: &mut Random) -> Option<[f64; 3]> {
    let Aabb { min, max } = *floor.bounds();
    (0..DRAWS).find_map(|_| {
        let x = min.x + random.uniform() * (max.x - min.x);
        let y = min.y + random.uniform() * (max.y - min.y);
        let heading = PI * (1.0 - 2.0 * random.uniform());
        floor.has_room(Point::new(x, y), MARGIN).then_some([x, y, heading])
    })
}

/// A configuration, and a position within `farthest` metres of it, drawn uniformly from those with room.
pub(super) fn draw(floor: &Floor, farthest: f64, random: &mut Random) -> Option<([f64; 3], [f64; 2])> {
    let from = configuration(floor, random)?;
    (0..DRAWS).find_map(|_| {
        let [x, y] = [from[0], from[1]].map(|x| x + farthest * (1.0 - 2.0 * random.uniform()));
        let squared = (x - from[0]) * (x - from[0]) + (y - from[1]) * (y - from[1]);
        let is_near = squared <= farthest * farthest && squared >= NEAREST * NEAREST;
        (is_near && floor.has_room(Point::new(x, y), MARGIN)).then_some((from, [x, y]))
    })
}
