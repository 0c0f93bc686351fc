//! Scenarios made by seed: the same options give the same document on every platform.

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
pub use maze::{Difficulty, MazeOptions};
pub use robots::RobotChoice;
pub use scattered::{ClutterOptions, DiscsOptions, Placement};

use super::{Goal, Obstacle, Parts, Query, Robot, Scenario, World};
use crate::error::{Code, Error, quoted};
use crate::geometry::{Aabb, Point};
use crate::options::{OptionInfo, Options, Value, out_of_range};
use crate::random::MAX_SEED;
use serde_json::Value as Json;

/// The description of a generator.
#[derive(Debug, Clone, PartialEq)]
pub struct GeneratorInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The title for people.
    pub title: &'static str,
    /// What it makes, in one sentence.
    pub summary: &'static str,
    /// Its options. Every generator takes `seed` as well, a whole number from 0 (default) to 2^53 - 1.
    pub options: Vec<OptionInfo>,
}

/// A generator, by the type of its options.
pub trait Generator: Options {
    /// The id, in kebab-case, the same everywhere.
    const ID: &'static str;
    /// The title for people.
    const TITLE: &'static str;
    /// What it makes, in one sentence.
    const SUMMARY: &'static str;

    /// Makes the scenario, with one query.
    ///
    /// # Errors
    /// `out-of-range` or `not-finite` with the pointer of the option; `out-of-range` at `/count` (`/seed` of a forest) if
    /// the obstacles do not fit within 10,000 draws, and at `/radius` or `/width` if the robot does not fit.
    fn generate(&self) -> Result<Scenario, Error>;
}

/// The range of a seed.
const SEEDS: crate::options::Range = 0.0..=MAX_SEED as f64;

macro_rules! generators {
    ($($Options:ty),*) => {
        /// The generators with their options.
        pub fn generators() -> Vec<GeneratorInfo> {
            vec![$(GeneratorInfo {
                id: <$Options>::ID,
                title: <$Options>::TITLE,
                summary: <$Options>::SUMMARY,
                options: <$Options>::table(),
            }),*]
        }

        /// Generates a scenario by the generator's name; `options` is an object whose fields are those of [`generators`] and
        /// `seed` (`{}` for all defaults).
        ///
        /// # Errors
        /// `unknown-generator`; and, with a pointer into the options, `unknown-field`, `duplicate-field`, `wrong-type`,
        /// `unknown-type`, `not-finite`, `out-of-range`.
        pub fn generate(kind: &str, options: &Json) -> Result<Scenario, Error> {
            $(if kind == <$Options>::ID {
                return read::<$Options>(options)?.generate();
            })*
            let known = [$(<$Options>::ID),*].join(", ");
            let sentence = format!("there is no generator {}; there are {known}", quoted(kind));
            Err(Error::new(Code::UnknownGenerator, "", sentence))
        }
    };
}

generators!(ForestOptions, ClutterOptions, DiscsOptions, MazeOptions, GapOptions, BugTrapOptions);

/// Reads options from an object.
fn read<O: Options>(options: &Json) -> Result<O, Error> {
    let Json::Object(fields) = options else {
        return Err(Error::new(Code::WrongType, "", "options must be an object"));
    };
    let given: Vec<_> = fields.iter().map(|(name, value)| (name.clone(), Value::from(value))).collect();
    let read = O::read(&given).map_err(|error| match (error.code(), error.pointer()) {
        // Robots are types, as in a scenario.
        (Code::OutOfRange, "/robot") => Error::new(Code::UnknownType, "/robot", error.message()),
        (Code::UnknownParameter, pointer) => Error::new(Code::UnknownField, pointer, error.message()),
        _ => error,
    })?;
    if O::has("robot") {
        robots::check_given(&given)?;
    }
    Ok(read)
}

/// The most draws that a generator makes for all of its obstacles.
const DRAWS: u32 = 10_000;

/// Places `count` obstacles one after another. `draw` is given those already placed, and returns `None` if what it has
/// drawn does not fit; if too few fit, the error is that of the option.
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

/// A query that is to reach its goal exactly.
fn query(name: &str, start: Vec<f64>, goal: Vec<f64>) -> Query {
    Query { name: name.to_owned(), start, goal: Goal::Configuration(goal), goal_tolerance: None }
}
