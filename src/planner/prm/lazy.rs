//! Lazy PRM: the vertices and the neighbours of PRM, but an edge is proven only when the best path wants it.
//!
//! Bohlin and Kavraki 2000, "Path planning using lazy PRM". Unlike there, samples are checked when they are drawn: the vertices
//! are those of PRM, and so is the length of the path. Where there is no path, no vertices are added; lazy PRM* does that.

use super::batch::{Batch, Growing};
use super::{DEFAULT_K, DEFAULT_SAMPLES, check_motions, needed_by_batch};
use crate::error::Error;
use crate::nearest::Neighbourhood;
use crate::planner::Planner;
use crate::planner::groups::{EdgeOptions, Sampling};
use crate::planner::info::{END, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, PseudocodeLine, line};
use crate::planner::lazy::LazyPlanner;
use crate::planner::query::Searching;
use crate::planner::roadmap::{BEGIN, KEEP, Roadmap, SAMPLE};
use crate::problem::Problem;
use crate::space::Space;

crate::options! {
    /// Options of lazy PRM.
    pub struct LazyPrmOptions for crate::options::ALL;
    /// Number of free samples: more find narrower passages and shorter paths but take longer.
    samples: Option<usize>, in 0.0..=250_000.0, "Samples", else "2000, and twice as many again while there is no path";
    /// Each vertex has candidate edges to its k nearest neighbours: too few leave gaps, more shorten paths.
    k: usize = DEFAULT_K, in 1.0..=1000.0, "Neighbours";
    /// Where samples come from.
    sampling: Sampling;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

/// Lines of pseudo-code that lazy planners share.
pub(super) const BEST: PseudocodeLine = line(0, "the best path of G ∪ E from start to goal:", &[Mark::Searching]);
pub(super) const EXPAND: PseudocodeLine = line(1, "go on with the search of lifelong A*", &[Mark::Expanded]);
pub(super) const PROVE: PseudocodeLine = line(1, "if its next edge is free: add that edge to G", &[Mark::Edge]);
pub(super) const REFUSE: PseudocodeLine = line(1, "else: remove it from E", &[Mark::Refused]);

impl PlannerKind for LazyPrmOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "lazy-prm",
        title: "Lazy PRM",
        summary: "A PRM that proves an edge only when the best path wants it, and searches on where one is refused.",
        guarantee: "Finds a path as short as that of PRM with as many samples and neighbours, or none where PRM does not.",
        grows: Grows::Roadmap,
        presets: &[],
        pseudocode: &[
            BEGIN,
            SAMPLE,
            line(1, "if q collides: next sample", &[Mark::Rejected]),
            KEEP,
            line(0, "E ← motions between nearest neighbours", &[Mark::Connecting]),
            BEST,
            EXPAND,
            PROVE,
            REFUSE,
            line(1, "until all its edges are in G", &[Mark::Solved]),
            IMPROVE,
            END,
        ],
    };

    fn needed(&self) -> Option<[u64; 2]> {
        needed_by_batch(self.samples)
    }

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let sampler = self.sampling.sampler(problem.space(), seed);
        let samples = self.samples.unwrap_or(DEFAULT_SAMPLES);
        check_motions(samples, self.k)?;
        let connection = Neighbourhood::Nearest(self.k);
        let mut roadmap = Roadmap::new(problem, connection, Searching::default()).lazily(problem.space());
        roadmap.is_direct = self.edges.direct;
        let builder = Batch::new(&roadmap, samples, self.samples.is_none().then_some(Growing(None)), sampler);
        Ok(Box::new(LazyPlanner::new(roadmap, Box::new(builder), false, false)))
    }
}
