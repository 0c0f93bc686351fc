//! Scenarios made by seed: the same options give the same document on every platform. One file a generator.

mod bug_trap;
mod clutter;
mod discs;
mod forest;
mod free;
mod gap;
mod maze;
mod robots;

pub use bug_trap::{BugTrapOptions, BugTrapStart, Turn, bug_trap};
pub use clutter::{ClutterOptions, clutter};
pub use discs::{DiscsOptions, Placement, discs};
pub use forest::{ForestOptions, forest};
pub use gap::{GapOptions, gap};
pub use maze::{Difficulty, MazeOptions, maze};
pub use robots::RobotChoice;

use super::Scenario;
use crate::error::{Code, Error, quoted};
use crate::options::{OptionInfo, Options, Value, out_of_range};
use crate::random::MAX_SEED;
use serde_json::Value as Json;

/// What there is to know about a generator.
#[derive(Debug, Clone, PartialEq)]
pub struct GeneratorInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
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
    /// The name for people.
    const TITLE: &'static str;
    /// What it makes, in one sentence.
    const SUMMARY: &'static str;

    /// Makes the scenario.
    ///
    /// # Errors
    /// `out-of-range` or `not-finite` with the pointer of the option.
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
            let sentence = format!("nothing named {} is generated; there are {known}", quoted(kind));
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
    let read = O::read_or(&given, Code::UnknownField).map_err(|error| match (error.code(), error.pointer()) {
        // Robots are types, as in a scenario.
        (Code::OutOfRange, "/robot") => Error::new(Code::UnknownType, "/robot", error.message()),
        _ => error,
    })?;
    if O::has("robot") {
        robots::check_given(&given)?;
    }
    Ok(read)
}

/// The error of a generator that found no place for its obstacles.
fn no_place(option: &str, placed: usize, wanted: usize, draws: u32) -> Error {
    out_of_range(option, format!("only {placed} of {wanted} obstacles found a place in {draws} draws"))
}
