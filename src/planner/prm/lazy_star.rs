//! Lazy PRM*: a lazy roadmap that grows sample by sample, and whose best path is proven again whenever it gets shorter.
//!
//! Hauser 2015, "Lazy collision checking in asymptotically-optimal motion planning". A sample has candidate edges to its k
//! nearest among the vertices before it, with the k of Karaman and Frazzoli 2011. Once there is a path, samples that cannot
//! shorten it are discarded (Gammell, Srinivasa and Barfoot 2014, "Informed RRT*").

use super::lazy::{BEST, EXPAND, PROVE, REFUSE};
use super::one_by_one::neighbours;
use super::prm_star_k;
use crate::error::Error;
use crate::graph::{EventKind, VertexId};
use crate::nearest::Neighbourhood;
use crate::planner::groups::{EdgeOptions, Sampling, Termination};
use crate::planner::growth::START;
use crate::planner::info::{END, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, line};
use crate::planner::lazy::LazyPlanner;
use crate::planner::query::Searching;
use crate::planner::roadmap::{Build, Roadmap};
use crate::planner::{Phase, Planner};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// How many samples an iteration draws until one may help.
const DRAWS: u32 = 10;

crate::options! {
    /// Options of lazy PRM*.
    pub struct LazyPrmStarOptions for crate::options::ALL;
    /// When it stops.
    termination: Termination;
    /// Where samples come from.
    sampling: Sampling;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for LazyPrmStarOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "lazy-prm-star",
        title: "Lazy PRM*",
        summary: "A lazy PRM that grows sample by sample, and proves the best path again whenever it gets shorter.",
        guarantee: "Asymptotically optimal: with more iterations the path approaches the shortest.",
        grows: Grows::Roadmap,
        presets: &[],
        pseudocode: &[
            line(0, "G ← {start, goal}, E ← {start – goal}; repeat:", &[]),
            line(1, "q ← a random configuration", &[Mark::Sampling, Mark::Improving]),
            line(1, "if it collides: next sample", &[Mark::Rejected]),
            line(1, "if start – q – goal is too long: likewise", &[Mark::Discarded]),
            line(1, "add q to G, motions to its k nearest to E", &[Mark::Vertex]),
            BEST,
            EXPAND,
            PROVE,
            REFUSE,
            line(1, "until all its edges are in G", &[Mark::Solved]),
            IMPROVE,
            END,
        ],
    };

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let space = problem.space();
        let connection = Neighbourhood::Nearest(prm_star_k(2, space.dimension()));
        let mut roadmap = Roadmap::new(problem, connection, Searching::default()).lazily(space);
        for goal in roadmap.goals.start.0..roadmap.goals.end.0 {
            roadmap.add_candidate(problem, [START, VertexId(goal)]);
        }
        let builder = Sampled { sampler: self.sampling.sampler(space, seed) };
        Ok(Box::new(LazyPlanner::new(roadmap, Box::new(builder), true, true)))
    }
}

/// Adds one sample at a time, which completes the roadmap until the next one.
struct Sampled<S: Space> {
    sampler: Box<dyn Sampler<S>>,
}

impl<S: Space> Sampled<S> {
    /// The next free sample that may shorten the path; `None`, with an event, if there is none among a few.
    fn sample(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> Option<S::State> {
        let bound = roadmap.best_cost();
        let mut useless = None;
        for _ in 0..DRAWS {
            let sample = roadmap.growth.draw(problem, iteration, &mut *self.sampler)?;
            roadmap.growth.looked += 1;
            roadmap.growth.note_visited(problem.space(), 2);
            if problem.distances_through(&sample.state).iter().sum::<f64>() < bound {
                return roadmap.growth.if_free(problem, iteration, sample);
            }
            useless = Some(sample.state);
        }
        roadmap.growth.reject(EventKind::SampleDiscarded, iteration, useless?);
        None
    }
}

impl<S: Space> Build<S> for Sampled<S> {
    fn build(&mut self, roadmap: &mut Roadmap<S>, problem: &Problem<S>, iteration: u32) -> bool {
        let Some(state) = self.sample(roadmap, problem, iteration) else { return false };
        roadmap.connection = Neighbourhood::Nearest(prm_star_k(roadmap.len() + 1, problem.space().dimension()));
        let neighbours = neighbours(roadmap, problem, &state);
        let vertex = roadmap.add_vertex(problem.space(), iteration, state);
        for (direction, other) in neighbours {
            let [from, to] = direction.ends(vertex, other);
            roadmap.try_edge(problem, iteration, from, to);
        }
        true
    }

    fn phase(&self, _: &Roadmap<S>) -> Phase {
        Phase::Sampling
    }
}
