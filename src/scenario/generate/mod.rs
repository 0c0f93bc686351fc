//! Scenarios made by seed: the same options give the same document on every platform. One file a generator.

mod clutter;
mod forest;
mod free;

pub use clutter::{ClutterOptions, ClutterRobot, clutter};
pub use forest::{ForestOptions, forest};

use super::reader::{Fields, Reader, quoted};
use super::{Node, Scenario};
use crate::error::{Code, Error};
use crate::random::MAX_SEED;

/// The names of the generators.
pub const GENERATORS: [&str; 2] = ["forest", "clutter"];

/// Generates a scenario by the generator's name; `options` is an object whose fields are those of [`ForestOptions`] or
/// [`ClutterOptions`] (`{}` for all defaults).
///
/// # Errors
/// `unknown-generator`; and, with a pointer into the options, `unknown-field`, `wrong-type`, `not-finite`, `out-of-range`.
pub fn generate(kind: &str, options: &Node) -> Result<Scenario, Error> {
    match kind {
        "forest" => forest(&ForestOptions::from_node(options)?),
        "clutter" => clutter(&ClutterOptions::from_node(options)?),
        other => {
            let sentence = format!("nothing named {} is generated; there are {}", quoted(other), GENERATORS.join(", "));
            Err(Error::new(Code::UnknownGenerator, "", sentence))
        }
    }
}

/// Reads a whole number from `low` to `high` where the field is there.
fn integer(fields: &Fields, name: &str, what: &str, [low, high]: [u64; 2], default: u64) -> Result<u64, Error> {
    fields.optional(name).map_or(Ok(default), |field: Reader| field.integer(what, low, high))
}

/// Reads the seed: from 0 to 2^53 - 1, 0 where it is not given.
fn seed(fields: &Fields) -> Result<u64, Error> {
    integer(fields, "seed", "the seed", [0, MAX_SEED], 0)
}

/// The error for an option that does not lie within [low, high].
fn out_of_range(option: &str, what: &str, low: impl ToString, high: impl ToString, value: impl ToString) -> Error {
    let (low, high, value) = (low.to_string(), high.to_string(), value.to_string());
    Error::new(Code::OutOfRange, format!("/{option}"), format!("{what} must lie within [{low}, {high}], not {value}"))
}

/// Refuses a seed above 2^53 - 1.
fn check_seed(seed: u64) -> Result<(), Error> {
    if seed > MAX_SEED {
        return Err(out_of_range("seed", "the seed", 0, MAX_SEED, seed));
    }
    Ok(())
}

/// The error of a generator that found no place for its obstacles.
fn no_place(option: &str, placed: usize, wanted: usize, draws: u32) -> Error {
    let sentence = format!("only {placed} of {wanted} obstacles found a place in {draws} draws");
    Error::new(Code::OutOfRange, format!("/{option}"), sentence)
}
