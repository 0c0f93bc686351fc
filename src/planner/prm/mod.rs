//! The probabilistic roadmap: k-PRM, PRM with a radius, and PRM*, which is k-PRM with a k that grows with the samples.
//!
//! Kavraki, Svestka, Latombe and Overmars 1996, "Probabilistic roadmaps for path planning in high-dimensional configuration
//! spaces"; LaValle 2006, "Planning Algorithms", section 5.6. The start is the first vertex, the goal the second; if there are
//! several goals, they follow it.
//!
//! If motions have a direction, so have edges (Svestka and Overmars 1997, "Motion planning for carlike robots using a
//! probabilistic learning approach"): a vertex is connected to the nearest that it leads to and to the nearest that lead to it.

#[cfg(feature = "parallel")]
mod ahead;
mod batch;
mod connect;
mod lazy;
mod lazy_star;
mod one_by_one;
mod star;

pub use batch::{reopen, resume};
pub use lazy::LazyPrmOptions;
pub use lazy_star::LazyPrmStarOptions;
pub use star::{NeighbourRule, PrmStarOptions, logarithmic_k, prm_star_k};

use super::Planner;
use super::groups::{EdgeOptions, Sampling};
use super::info::{END, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, Preset, line};
use super::neighbours::{Neighbouring, Neighbours};
use super::query::Searching;
use super::roadmap::{BEGIN, EXPAND, JOIN, KEEP, REFUSE, Roadmap, SAMPLE, SEARCH};
use crate::error::Error;
use crate::nearest::Neighbourhood;
use crate::options::out_of_range;
use crate::problem::Problem;
use crate::space::Space;
use batch::{Batch, Growing};
use one_by_one::OneByOne;

/// The number of samples to begin with if none is given.
const DEFAULT_SAMPLES: usize = 2000;
/// The number of neighbours if neither it nor a radius is given.
const DEFAULT_K: usize = 15;
/// The most motions that a roadmap may try: it stores the result of each.
const MOST_MOTIONS: u64 = 20_000_000;

crate::choice! {
    /// When samples are connected to their neighbours.
    pub enum Insertion {
        /// First all samples, then all edges, every pair tried once.
        Batch,
        /// Each sample at once, to its neighbours among those before it.
        OneByOne,
    }
}

crate::options! {
    /// Options of PRM.
    pub struct PrmOptions for crate::options::ALL;
    /// Number of free samples: more find narrower passages and shorter paths but take longer.
    samples: Option<usize>, in 0.0..=1e6, "Samples", else "2000, and twice as many again while there is no path";
    /// Each vertex is connected to its k nearest neighbours: too few leave gaps, more shorten paths but cost time.
    k: Option<usize>, in 1.0..=1000.0, "Neighbours",
        else "15, or all within the radius if one is given, for up to 4470 samples";
    /// Largest distance to a neighbour: a small radius leaves gaps, a large one connects more but takes longer.
    radius: Option<f64>, in 1e-6..=1e7, "Radius", unit "distance in the metric",
        else "none: only the number of neighbours is limited";
    /// Batch: sample first, then connect; one by one: connect each sample as it arrives.
    insertion: Insertion = Insertion::Batch, "Insertion";
    /// Discards samples that connect to nothing (one-by-one insertion only).
    discard: bool = false, "Discard unconnected";
    /// How neighbours are found.
    neighbouring: Neighbouring;
    /// Where samples come from.
    sampling: Sampling;
    /// How the roadmap is searched.
    searching: Searching;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for PrmOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "prm",
        title: "PRM",
        summary: "Samples free configurations, connects each to its nearest neighbours, and searches this roadmap for a path.",
        guarantee: "Probabilistically complete with a radius: more samples find any path that has clearance.",
        grows: Grows::Roadmap,
        presets: &[
            Preset { id: "thirty-nearest", title: "1000 samples, k = 30", settings: "samples=1000 k=30" },
            Preset { id: "thirty-nearest-400", title: "400 samples, k = 30", settings: "samples=400 k=30" },
            Preset { id: "thirty-nearest-700", title: "700 samples, k = 30", settings: "samples=700 k=30" },
            Preset {
                id: "twenty-points",
                title: "1000, k = 30, 20 points an edge",
                settings: "samples=1000 k=30 edge_check=sampled edge_samples=20 search=breadth-first",
            },
            Preset {
                id: "approximate",
                title: "1000, k = 30, naive neighbours",
                settings: "samples=1000 k=30 neighbour_metric=naive edge_check=sampled edge_samples=20 search=breadth-first",
            },
            Preset {
                id: "forest-naive",
                title: "Naive forest and heuristic",
                settings: "samples=1000 k=9 neighbour_index=forest neighbour_metric=naive heuristic=naive",
            },
            Preset {
                id: "hundred-three-nearest",
                title: "100 one by one, k = 3, Dijkstra",
                settings: "samples=100 k=3 insertion=one-by-one search=dijkstra",
            },
            Preset {
                id: "thousand-three-nearest",
                title: "1000 one by one, k = 3, Dijkstra",
                settings: "samples=1000 k=3 insertion=one-by-one search=dijkstra",
            },
            Preset {
                id: "unchecked-1000-4",
                title: "1000, k = 4, edges unchecked",
                settings: "samples=1000 k=4 edge_check=none direct=false",
            },
            Preset {
                id: "unchecked-2000-4",
                title: "2000, k = 4, edges unchecked",
                settings: "samples=2000 k=4 edge_check=none direct=false",
            },
            Preset {
                id: "unchecked-2000-6",
                title: "2000, k = 6, edges unchecked",
                settings: "samples=2000 k=6 edge_check=none direct=false",
            },
            Preset {
                id: "three-nearest",
                title: "500 connected, k = 3",
                settings: "samples=500 k=3 insertion=one-by-one discard=true",
            },
        ],
        pseudocode: &[
            BEGIN,
            SAMPLE,
            line(1, "if q collides, or is discarded: next sample", &[Mark::Rejected, Mark::Discarded]),
            KEEP,
            // Inserted one by one, samples get their edges at once.
            line(0, "for q of G, for p of its nearest neighbours:", &[Mark::Connecting, Mark::Edge, Mark::Refused]),
            JOIN,
            REFUSE,
            SEARCH,
            EXPAND,
            IMPROVE,
            END,
        ],
    };

    fn needed(&self) -> Option<[u64; 2]> {
        match self.insertion {
            Insertion::Batch => needed_by_batch(self.samples),
            Insertion::OneByOne => self.samples.map(|samples| [samples as u64, samples as u64 + 1]),
        }
    }

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let sampler = self.sampling.sampler(problem.space(), seed);
        let samples = self.samples.unwrap_or(DEFAULT_SAMPLES);
        // With a radius but no k, all within the radius are neighbours.
        let is_all = self.radius.is_some() && self.k.is_none();
        let k = self.k.unwrap_or(if is_all { samples + 2 } else { DEFAULT_K });
        check_motions(samples, k)?;
        let growing = self.samples.is_none().then_some(Growing(is_all.then_some(|vertices, _| vertices)));
        let connection = Neighbourhood::of(k, self.radius.unwrap_or(f64::INFINITY));
        let nearest = Neighbours::new(self.neighbouring, problem.space(), k, seed)?;
        let mut roadmap = Roadmap::with(problem, connection, self.searching, nearest);
        roadmap.is_direct = self.edges.direct;
        Ok(match self.insertion {
            Insertion::Batch if self.discard => {
                let sentence = "samples can be discarded only if insertion is \"one-by-one\", not \"batch\"";
                return Err(out_of_range("discard", sentence));
            }
            Insertion::Batch => Box::new(Batch::planner(problem, roadmap, samples, growing, sampler)),
            Insertion::OneByOne => {
                Box::new(OneByOne::planner(problem, roadmap, samples, growing, self.discard, sampler))
            }
        })
    }
}

/// The samples asked for, and the fewest iterations in which a batch draws each, connects each and both ends, and searches.
fn needed_by_batch(samples: Option<usize>) -> Option<[u64; 2]> {
    samples.map(|samples| [samples as u64, 2 * samples as u64 + 3])
}

/// Refuses roadmaps that would try too many motions.
fn check_motions(samples: usize, k: usize) -> Result<(), Error> {
    if samples as u64 * k as u64 <= MOST_MOTIONS {
        return Ok(());
    }
    Err(out_of_range(
        "samples",
        format!(
            "samples times k (all samples if there is a radius and no k) must be at most {MOST_MOTIONS}, not {samples} times {k}"
        ),
    ))
}
