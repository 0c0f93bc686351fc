//! Scenarios made by seed: the same options give the same document on every platform. One file a generator.

mod bug_trap;
mod catalogue;
mod clutter;
mod discs;
mod forest;
mod free;
mod gap;
mod maze;
mod options;
mod robots;

pub use bug_trap::{BugTrapOptions, BugTrapStart, Turn, bug_trap};
pub use catalogue::catalogue;
pub use clutter::{ClutterOptions, clutter};
pub use discs::{DiscsOptions, Placement, discs};
pub use forest::{ForestOptions, forest};
pub use gap::{GapOptions, gap};
pub use maze::{Difficulty, MazeOptions, maze};
pub use options::{GeneratorInfo, OptionInfo, OptionKind};
pub use robots::RobotChoice;

use super::{Node, Scenario};
use crate::error::{Code, Error, quoted};

/// The generators with their options: the one table that help texts, documents and controls are made from. Every generator
/// takes `seed` as well, a whole number from 0 (default) to 2^53 - 1.
pub const GENERATORS: &[GeneratorInfo] =
    &[forest::INFO, clutter::INFO, discs::INFO, maze::INFO, gap::INFO, bug_trap::INFO];

/// Generates a scenario by the generator's name; `options` is an object whose fields are those of [`GENERATORS`] and `seed`
/// (`{}` for all defaults).
///
/// # Errors
/// `unknown-generator`; and, with a pointer into the options, `unknown-field`, `wrong-type`, `unknown-type`, `not-finite`,
/// `out-of-range`.
pub fn generate(kind: &str, options: &Node) -> Result<Scenario, Error> {
    match kind {
        "forest" => forest(&ForestOptions::from_node(options)?),
        "clutter" => clutter(&ClutterOptions::from_node(options)?),
        "discs" => discs(&DiscsOptions::from_node(options)?),
        "maze" => maze(&MazeOptions::from_node(options)?),
        "gap" => gap(&GapOptions::from_node(options)?),
        "bug-trap" => bug_trap(&BugTrapOptions::from_node(options)?),
        other => {
            let known: Vec<&str> = GENERATORS.iter().map(|info| info.id).collect();
            let sentence = format!("nothing named {} is generated; there are {}", quoted(other), known.join(", "));
            Err(Error::new(Code::UnknownGenerator, "", sentence))
        }
    }
}

/// The error of a generator that found no place for its obstacles.
fn no_place(option: &str, placed: usize, wanted: usize, draws: u32) -> Error {
    options::refused(option, format!("only {placed} of {wanted} obstacles found a place in {draws} draws"))
}
