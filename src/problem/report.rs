//! What a run reports: its status, its phase, and the work done, as counts that are the same on every platform and the
//! seconds that a caller measured.

use crate::json::not_negative;
use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};

/// The status of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Status {
    /// More iterations may help.
    Running,
    /// A path was found.
    Solved,
    /// No path, for a [`Reason`].
    Exhausted,
    /// The collision checker of a custom robot has failed: see [`Validity::failure`](super::Validity::failure).
    Failed,
}

impl Status {
    /// The status as it is printed: `running`, `solved`, `exhausted` or `failed`.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}

/// Why a run has ended without a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Reason {
    /// `max_iterations` were made.
    IterationLimit,
    /// `max_work` was spent.
    WorkLimit,
    /// `stop_evaluations` were made.
    EvaluationLimit,
    /// The tree has as many `vertices` as it was to have.
    VertexLimit,
    /// There is no room for more vertices, edges and events (`graph::MAX_RECORDS`).
    GraphFull,
    /// The roadmap or the samples are complete and do not connect start and goal. Others might.
    NotConnected,
    /// No vertex of the tree may be extended any more.
    NothingToExtend,
    /// The search of the roadmap, one that is faulty, has ended without a path. There may be one.
    SearchFailed,
}

impl Reason {
    /// Every reason.
    pub const ALL: &[Reason] = Reason::VARIANTS;

    /// The reason as it is printed, such as `iteration-limit`.
    pub fn as_str(self) -> &'static str {
        self.into()
    }

    /// The reason in words, with the number that it depends on: the limit; for [`Reason::NotConnected`] and
    /// [`Reason::SearchFailed`] the vertices; for [`Reason::NothingToExtend`] none. With a path, the reason why the run has ended
    /// before it had done all that was asked.
    pub fn sentence(self, number: u64, has_path: bool) -> String {
        let n = grouped(number);
        match (self, has_path) {
            (Self::IterationLimit, false) => format!("gave up after {n} iterations without a path (max_iterations)"),
            (Self::IterationLimit, true) => format!("stopped early: no gain in {n} iterations (max_iterations)"),
            (Self::WorkLimit, false) => format!("gave up after {n} units of work without a path (max_work)"),
            (Self::WorkLimit, true) => format!("stopped early: no gain in {n} units of work (max_work)"),
            (Self::EvaluationLimit, _) => {
                format!("gave up after {n} clearance evaluations without a path (stop_evaluations)")
            }
            (Self::VertexLimit, _) => format!("gave up with a tree of {n} vertices without a path (vertices)"),
            (Self::GraphFull, _) => {
                let ended = if has_path { "stopped early" } else { "gave up" };
                format!("{ended}: there is no room for more than {n} vertices, edges and events")
            }
            (Self::NotConnected, _) => format!("start and goal are not connected in this roadmap of {n} vertices"),
            (Self::NothingToExtend, _) => "gave up: no vertex of the tree may be extended again".to_owned(),
            (Self::SearchFailed, _) => {
                format!("the search ended without a path; it is faulty, and this roadmap of {n} vertices may have one")
            }
        }
    }
}

/// A number with commas between groups of three digits.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The phase of a run. Its number is its index in [`Phase::ALL`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Phase {
    /// Samples are drawn and become vertices.
    Sampling,
    /// Vertices are connected to their neighbours.
    Connecting,
    /// Samples become guards of a visibility roadmap, or links between them.
    Guarding,
    /// The roadmap is searched.
    Searching,
    /// A tree grows, or two.
    Growing,
    /// A path was found and gets shorter.
    Improving,
    /// The run has ended.
    Done,
}

impl Phase {
    /// Every phase, in the order of their numbers.
    pub const ALL: &[Phase] = Phase::VARIANTS;

    /// The name of the phase, the same everywhere.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}

/// The work of one planning run. Counts are part of what a seed decides; seconds are not.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Stats {
    /// Iterations of the planner, and attempts at improving its path.
    pub iterations: u64,
    /// Vertices of the graph.
    pub vertices: u64,
    /// Edges of the graph, including the edges of a tree that rewiring has replaced.
    pub edges: u64,
    /// Configurations tested for collision.
    pub configuration_checks: u64,
    /// Samples drawn in vain: in collision, or none was found where the sampler looks.
    #[serde(default)] // Absent in results written before they were counted.
    pub rejected_samples: u64,
    /// Motions tested for collision.
    pub motion_checks: u64,
    /// Candidate edges of a lazy roadmap that no path has wanted, so that they were neither proven nor refused.
    #[serde(default)] // Absent in results written before there were any.
    pub unchecked_edges: u64,
    /// Queries of the nearest-neighbour index.
    pub nearest_queries: u64,
    /// Vertices that the search of the graph expanded.
    pub visited: u64,
    /// Those that it expanded again, since it had found a way to them that is cheaper by more than rounding; with a consistent
    /// heuristic none.
    #[serde(default)] // Absent in results written before they were counted.
    pub reopened: u64,
    /// Samples that were the goal, or one of the goals.
    #[serde(default)] // Absent in results written before they were counted.
    pub goal_samples: u64,
    /// Evaluations of the clearance of a part.
    pub clearance_evaluations: u64,
    /// Motions refused because their proof had spent its budget of evaluations.
    #[serde(default)] // Absent in results written before proofs had budgets.
    pub unproven_motions: u64,
    /// The work of all of these: a weighted sum, in units of about a microsecond on one core. `max_work` limits it.
    #[serde(default)] // Absent in results written before it was counted.
    pub work: u64,
    /// Seconds spent on growing the graph; 0 if not measured: the core reads no clock.
    #[serde(deserialize_with = "not_negative")]
    pub build_seconds: f64,
    /// Seconds spent on searching the graph and shortening the path; 0 if not measured.
    #[serde(deserialize_with = "not_negative")]
    pub search_seconds: f64,
}
