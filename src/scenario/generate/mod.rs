//! Scenarios generated from a seed: the same options give the same document on every platform.

mod bug_trap;
mod forest;
mod free;
mod gap;
mod maze;
mod robots;
mod scattered;

pub use crate::generators::Generator;
pub use bug_trap::{BugTrapOptions, BugTrapStart, Turn};
pub use forest::ForestOptions;
pub use gap::GapOptions;
pub use maze::{Difficulty, MazeOptions, MazeRobot};
pub use robots::RobotChoice;
pub use scattered::{ClutterOptions, DiscsOptions, Placement};

use super::{Goal, Obstacle, Parts, Query, Robot, Scenario, World};
use crate::error::Error;
use crate::generators::{self, SEEDS, generators};
use crate::geometry::{Aabb, Point};
use crate::options::{Value, out_of_range};

generators! {
    Scenario, generators:
    ForestOptions => "forest", "Forest", "An arm of unit links among equal triangles on a grid.";
    ClutterOptions => "clutter", "Clutter", "Convex polygons scattered over a box, for a robot that crosses it or an arm in its middle.";
    DiscsOptions => "discs", "Discs", "Discs scattered over a box, for a robot that crosses it or an arm in its middle.";
    MazeOptions => "maze", "Maze", "A maze of walls for a disc, a body or a car, from corner to corner; there is always a path.";
    GapOptions => "gap", "Gap", "A wall across a box with one gap, for a robot that goes through it or an arm that reaches through it.";
    BugTrapOptions => "bug-trap", "Bug trap", "A disc in a round pocket whose mouth is turned inwards.";
}

/// As [`generate_with`]; a refusal of an unknown option names `others` as known.
pub(crate) fn generate_among(
    id: &str,
    options: &[(String, Value)],
    others: &[&'static str],
) -> Result<Scenario, Error> {
    generators::generate(MAKERS, id, options, others)
}

/// The most draws that a generator makes for all of its obstacles.
const DRAWS: u32 = 10_000;

/// Places `count` obstacles one after another. `draw` receives those already placed, and returns `None` if the one that it draws
/// does not fit. If too few fit, the error names the option.
fn scatter<T>(option: &str, count: usize, mut draw: impl FnMut(&[T]) -> Option<T>) -> Result<Vec<T>, Error> {
    let mut placed = Vec::with_capacity(count);
    for _ in 0..DRAWS {
        if placed.len() == count {
            break;
        }
        placed.extend(draw(&placed));
    }
    if placed.len() < count {
        let sentence = format!("only {} of {count} obstacles could be placed in {DRAWS} draws", placed.len());
        return Err(out_of_range(option, sentence));
    }
    Ok(placed)
}

/// A scenario in a square box with its lower left corner at the origin.
fn in_box(
    name: String,
    title: String,
    side: f64,
    obstacles: impl IntoIterator<Item = Obstacle>,
    robot: Robot,
    query: Query,
) -> Scenario {
    let bounds = Some(Aabb { min: Point::origin(), max: Point::new(side, side) });
    let world = World { bounds, obstacles: obstacles.into_iter().collect() };
    Parts::new(name, Some(title), world, robot, vec![query]).into()
}

/// A query without a goal region.
fn query(name: &str, start: Vec<f64>, goal: Vec<f64>) -> Query {
    Query { name: name.to_owned(), start, goal: Goal::Configuration(goal), goal_tolerance: None }
}
