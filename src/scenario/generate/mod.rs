//! Scenarios generated from a seed: the same options give the same document on every platform.

mod bug_trap;
mod forest;
mod free;
mod gap;
mod maze;
mod robots;
mod scattered;

pub use bug_trap::{BugTrapOptions, BugTrapStart, Turn};
pub use forest::ForestOptions;
pub use gap::GapOptions;
pub use maze::{Difficulty, MazeOptions, MazeRobot};
pub use robots::RobotChoice;
pub use scattered::{ClutterOptions, DiscsOptions, Placement};

use super::{Goal, Obstacle, Parts, Query, Robot, Scenario, World};
use crate::error::{Code, Error, quoted};
use crate::geometry::{Aabb, Point};
use crate::options::{Info, Options, Value, out_of_range};
use crate::random::MAX_SEED;
use serde_json::Value as Json;

/// A generator, by the type of its options.
pub trait Generator: Options {
    /// Makes the scenario, with one query.
    ///
    /// # Errors
    /// `out-of-range` or `not-finite` with the pointer of the option; `out-of-range` at `/count` (`/seed` of a forest) if
    /// the obstacles do not fit within 10,000 draws, and at `/radius` or `/width` if the robot does not fit.
    fn generate(&self) -> Result<Scenario, Error>;
}

/// The range of a seed.
const SEEDS: crate::options::Range = 0.0..=MAX_SEED as f64;

/// Declares the generators: the id, the title, the summary and the options of each.
macro_rules! generators {
    ($($id:literal, $title:literal, $summary:literal => $Options:ty;)*) => {
        /// The generators with their options.
        pub fn generators() -> Vec<Info> {
            vec![$(Info { id: $id, title: $title, summary: $summary, options: <$Options>::table() }),*]
        }

        /// Generates a scenario by the generator's id, with options given by name: those of [`generators`] and `seed`; the rest
        /// take their defaults.
        ///
        /// # Errors
        /// `unknown-generator`; and, with the pointer `/name`, `unknown-field`, `duplicate-field`, `wrong-type`, `unknown-type`,
        /// `not-finite`, `out-of-range`.
        pub fn generate_with(id: &str, options: &[(String, Value)]) -> Result<Scenario, Error> {
            match id {
                $($id => read::<$Options>(options)?.generate(),)*
                _ => {
                    let sentence = format!("there is no generator {}; there are {}", quoted(id), [$($id),*].join(", "));
                    Err(Error::new(Code::UnknownGenerator, "", sentence))
                }
            }
        }
    };
}

generators! {
    "forest", "Forest", "An arm of unit links among equal triangles on a grid." => ForestOptions;
    "clutter", "Clutter", "Convex polygons scattered over a box, for a robot that crosses it or an arm in its middle." => ClutterOptions;
    "discs", "Discs", "Discs scattered over a box, for a robot that crosses it or an arm in its middle." => DiscsOptions;
    "maze", "Maze", "A maze of walls for a disc, a body or a car, from corner to corner; there is always a path." => MazeOptions;
    "gap", "Gap", "A wall across a box with one gap, for a robot that goes through it or an arm that reaches through it." => GapOptions;
    "bug-trap", "Bug trap", "A disc in a round pocket whose mouth is turned inwards." => BugTrapOptions;
}

/// The same with the options as an object (`{}` for all defaults).
///
/// # Errors
/// Those of [`generate_with`], and `wrong-type` if the options are not an object.
pub fn generate(id: &str, options: &Json) -> Result<Scenario, Error> {
    generate_with(id, &given(options)?)
}

/// The options of an object by name.
///
/// # Errors
/// `wrong-type` if it is not an object.
pub(crate) fn given(options: &Json) -> Result<Vec<(String, Value)>, Error> {
    let Json::Object(fields) = options else {
        return Err(Error::new(Code::WrongType, "", "options must be an object"));
    };
    Ok(fields.iter().map(|(name, value)| (name.clone(), Value::from(value))).collect())
}

/// Reads options given by name.
fn read<O: Options>(given: &[(String, Value)]) -> Result<O, Error> {
    let read = O::read(given).map_err(|error| match (error.code(), error.pointer()) {
        // A robot is a type, as in a scenario.
        (Code::OutOfRange, "/robot") => Error::new(Code::UnknownType, "/robot", error.message()),
        (Code::UnknownParameter, pointer) => Error::new(Code::UnknownField, pointer, error.message()),
        _ => error,
    })?;
    if O::has("robot") {
        robots::check_given(given)?;
    }
    Ok(read)
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
    Parts { name, title: Some(title), world, robot, queries: vec![query] }.into()
}

/// A query without a goal region.
fn query(name: &str, start: Vec<f64>, goal: Vec<f64>) -> Query {
    Query { name: name.to_owned(), start, goal: Goal::Configuration(goal), goal_tolerance: None }
}
