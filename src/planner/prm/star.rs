//! PRM*: a k-PRM whose k grows with the number of samples, so that its path approaches the shortest.
//!
//! Karaman and Frazzoli 2011, "Sampling-based algorithms for optimal motion planning".

use super::batch::{Batch, Growing};
use super::{DEFAULT_SAMPLES, check_motions, needed_by_batch};
use crate::error::Error;
use crate::nearest::Neighbourhood;
use crate::planner::Planner;
use crate::planner::groups::{EdgeOptions, Sampling};
use crate::planner::info::{END, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, Preset, line};
use crate::planner::query::Searching;
use crate::planner::roadmap::{BEGIN, EXPAND, JOIN, KEEP, REFUSE, Roadmap, SAMPLE, SEARCH};
use crate::problem::Problem;
use crate::space::Space;

crate::choice! {
    /// How many neighbours a vertex has.
    pub enum NeighbourRule {
        /// [`prm_star_k`].
        KaramanFrazzoli,
        /// [`logarithmic_k`].
        LogN,
    }
}

crate::options! {
    /// Options of PRM*.
    pub struct PrmStarOptions for crate::options::ALL;
    /// Number of free samples: more find narrower passages and shorter paths but take longer.
    samples: Option<usize>, in 0.0..=250_000.0, "Samples", else "2000, and twice as many again while there is no path";
    /// Neighbours for n vertices in d dimensions: e (1 + 1/d) ln n for near-optimal paths, or ln n for speed.
    k_rule: NeighbourRule = NeighbourRule::KaramanFrazzoli, "Neighbour rule";
    /// Where samples come from.
    sampling: Sampling;
    /// How the roadmap is searched.
    searching: Searching;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

/// The k of PRM* for a finished batch of `vertices` vertices: the least whole number above e (1 + 1/d) ln n.
pub fn prm_star_k(vertices: usize, dimension: usize) -> usize {
    let factor = std::f64::consts::E * (1.0 + 1.0 / dimension as f64);
    libm::floor(factor * libm::log(vertices as f64)) as usize + 1
}

/// The k of a course report for as many vertices: ln n, rounded up.
pub fn logarithmic_k(vertices: usize) -> usize {
    (libm::ceil(libm::log(vertices as f64)) as usize).max(1)
}

impl PlannerKind for PrmStarOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "prm-star",
        title: "PRM*",
        summary: "A PRM with enough neighbours, more as samples grow, for the path to approach the shortest.",
        guarantee: "Asymptotically optimal by its first rule: with more samples the path approaches the shortest.",
        grows: Grows::Roadmap,
        presets: &[Preset { id: "log-n", title: "1000 samples, k = ln n", settings: "samples=1000 k_rule=log-n" }],
        pseudocode: &[
            BEGIN,
            SAMPLE,
            line(1, "if q collides: next sample", &[Mark::Rejected]),
            KEEP,
            line(0, "k ← e (1 + 1/d) ln n, or by the rule chosen", &[]),
            line(0, "for q of G, for p of its k nearest:", &[Mark::Connecting]),
            JOIN,
            REFUSE,
            SEARCH,
            EXPAND,
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
        let rule: fn(usize, usize) -> usize = match self.k_rule {
            NeighbourRule::KaramanFrazzoli => prm_star_k,
            NeighbourRule::LogN => |vertices, _| logarithmic_k(vertices),
        };
        let k = rule(samples + 2, problem.space().dimension());
        check_motions(samples, k)?;
        let growing = self.samples.is_none().then_some(Growing(Some(rule)));
        let mut roadmap = Roadmap::new(problem, Neighbourhood::Nearest(k), self.searching);
        roadmap.is_direct = self.edges.direct;
        Ok(Box::new(Batch::planner(problem, roadmap, samples, growing, sampler)))
    }
}
