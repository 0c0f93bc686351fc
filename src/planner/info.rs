//! The declaration of a planner, on the type of its options.

use super::Planner;
use crate::error::Error;
use crate::options::{Options, Value};
use crate::problem::Problem;
use crate::space::Space;
use strum::{IntoStaticStr, VariantArray};

/// What a planner grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Grows {
    /// A roadmap of start, goals and samples, which can be saved and queried again.
    Roadmap,
    /// A tree from the start.
    Tree,
    /// A tree from the start and one from each goal.
    Trees,
}

/// A kind of planner, as its file declares it. The implementing type holds its options.
pub trait PlannerKind: Options {
    /// Its description.
    const INFO: PlannerInfo;
    /// Whether every motion must be possible in both directions.
    const NEEDS_SYMMETRY: bool = false;

    /// The samples that were asked for, and the iterations that drawing, connecting and searching them takes at least; `None` if
    /// the planner decides how many it draws.
    fn needed(&self) -> Option<[u64; 2]> {
        None
    }

    /// The planner at its beginning.
    ///
    /// # Errors
    /// `out-of-range`, with the pointer of the option, if options do not fit the space or each other.
    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error>;
}

/// The description of a planner, for help and documents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlannerInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it does, in a sentence.
    pub summary: &'static str,
    /// What is known about its results, in a sentence.
    pub guarantee: &'static str,
    /// What it grows.
    pub grows: Grows,
    /// Named settings.
    pub presets: &'static [Preset],
    /// Its pseudo-code.
    pub pseudocode: &'static [PseudocodeLine],
}

/// Named settings of a planner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Preset {
    /// The id, in kebab-case, distinct within the planner.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// Options as on the command line, `name=value` separated by spaces; all others have their defaults.
    pub settings: &'static str,
}

impl Preset {
    /// The settings as values of options.
    pub fn parameters(&self) -> Vec<(String, Value)> {
        let settings = self.settings.split(' ').filter_map(|setting| setting.split_once('='));
        settings.map(|(name, value)| (name.to_owned(), Value::from_text(value))).collect()
    }
}

/// What highlights a line of pseudo-code: the phase at the beginning of an iteration, what it added, its events, and `Done`
/// if the run has ended with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Mark {
    /// The iteration began in [`Phase::Sampling`](super::Phase::Sampling).
    Sampling,
    /// It began in [`Phase::Connecting`](super::Phase::Connecting).
    Connecting,
    /// It began in [`Phase::Guarding`](super::Phase::Guarding).
    Guarding,
    /// It began in [`Phase::Searching`](super::Phase::Searching).
    Searching,
    /// It began in [`Phase::Growing`](super::Phase::Growing).
    Growing,
    /// It began in [`Phase::Improving`](super::Phase::Improving).
    Improving,
    /// The run has ended with it.
    Done,
    /// A vertex was added.
    Vertex,
    /// An edge was added.
    Edge,
    /// A sample was rejected: it is in collision, or the sampler found none.
    Rejected,
    /// A motion could not be proven free.
    Refused,
    /// The search expanded a vertex.
    Expanded,
    /// A solution was found.
    Solved,
    /// A free sample was discarded.
    Discarded,
    /// A vertex became a guard.
    Guard,
    /// A vertex was removed from the tree.
    Removed,
    /// A vertex of the tree got another parent.
    Rewired,
}

/// One line of pseudo-code. It is highlighted if one of its marks is among those of an iteration; each iteration highlights a
/// line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PseudocodeLine {
    /// The line, of 46 characters at most.
    pub text: &'static str,
    /// The depth of its indentation, from 0.
    pub indent: u8,
    /// What highlights it; empty for a line that only introduces others.
    pub lit_by: &'static [Mark],
}

/// A line of pseudo-code.
pub(super) const fn line(indent: u8, text: &'static str, lit_by: &'static [Mark]) -> PseudocodeLine {
    PseudocodeLine { text, indent, lit_by }
}

/// The line of planners that try the straight motion first.
pub(super) const DIRECT: PseudocodeLine = line(0, "if the motion start – goal is free: return it", &[]);
/// The line for a sampler that finds nothing.
pub(super) const NONE_FOUND: PseudocodeLine = line(1, "if the sampler finds none: try again", &[Mark::Rejected]);
/// The line of planners whose path may be improved.
pub(super) const IMPROVE: PseudocodeLine = line(0, "shorten the path, if requested", &[Mark::Improving]);
/// The last line of planners without an approximate path.
pub(super) const END: PseudocodeLine = line(0, "return the path, or that there is none", &[Mark::Done]);
/// The last line of planners with one.
pub(super) const END_NEAR: PseudocodeLine = line(0, "return the path, or the closest approach", &[Mark::Done]);
