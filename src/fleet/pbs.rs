//! The planner that is chosen if none is named: searches take turns on roadmaps that grow while none of them finds a plan.
//!
//! - Orders of priorities among robots that stand at their starts until they have planned (`prioritized.rs`) are fast where one
//!   works.
//! - The tree of priorities (`priority_tree.rs`) finds who gives way to whom where robots must make room before they plan.
//! - Two or three robots are planned for as one, too (`composite.rs`): that needs no roadmap.
//! - Joint moves (`moves.rs`) find what no priorities can, as where two robots have to make way for each other.
//!
//! So a plan takes a few times as long as the search takes that finds it first. Plans other than by priorities are refined
//! (`refinement.rs`).

use super::composite::{Composite, CompositeOptions};
use super::document::Fleet;
use super::moves::Moves;
use super::prioritized::{Orders, default_samples, roadmap_stats, roadmaps};
use super::priority_tree::{Ground, PriorityTree};
use super::refinement::{Refined, Refinement};
use super::result::{Blocked, FleetReason, FleetStats};
use super::roadmap::Roadmap;
use super::trajectory::Trajectory;
use super::turns::{Search, Searches};
use crate::error::Error;
use crate::problem::Status;
use std::sync::Arc;

/// How many orders of priorities are tried after the first.
const RESTARTS: u32 = 20;
/// After how many iterations the planner gives up, and how many more for each robot.
const ITERATIONS: [u64; 2] = [5_000_000, 200_000];
/// The roadmaps grow after this number of rounds: mostly they are dense enough.
const ROUNDS: u32 = 3;
/// How often the robots of a plan try to arrive earlier if nothing else is given and the plan is not one of priorities.
const REFINEMENTS: u32 = 3;
/// The most distances to goals that are kept, of all robots; of more, those of a robot are computed whenever it plans.
const MOST_DISTANCES: usize = 4_000_000;

crate::options! {
    /// Options of priority-based search.
    pub struct PbsOptions for &[];
    /// Number of free samples of each roadmap at first: more find narrower passages and shorter ways but take longer.
    samples: Option<usize>, in 0.0..=100_000.0, "Samples", else "400, and 20 more for each robot";
    /// Roadmaps grow up to this number of samples, twice as many each time, while no plan is found.
    most_samples: usize = 20_000, in 0.0..=100_000.0, "Most samples";
    /// Each vertex is connected to its k nearest neighbours.
    k: usize = 15, in 1.0..=100.0, "Neighbours";
    /// How many times the robots of a plan try, one after another, to arrive earlier.
    refinements: Option<u32>, in 0.0..=1000.0, "Refinements", else "0 for a plan by priorities, else 3";
    /// Number of iterations after which the planner gives up.
    max_iterations: Option<u64>, in 1.0..=1e12, "Most iterations", else "5,000,000, and 200,000 more for each robot";
}

impl PbsOptions {
    /// The number of iterations after which the planner gives up on a fleet.
    pub(super) fn most_iterations(&self, fleet: &Fleet) -> u64 {
        self.max_iterations.unwrap_or(ITERATIONS[0] + ITERATIONS[1] * fleet.kinds().len() as u64)
    }
}

/// What the planner is doing.
enum Stage {
    /// Roadmaps are built or grown.
    Roadmaps,
    /// Distances to goals are computed, for one robot after another.
    Distances,
    Searches,
    Refinement(Box<Refinement>),
}

/// The planner. An iteration is one of a roadmap or of a search.
pub(super) struct Pbs {
    roadmaps: Vec<Roadmap>,
    distances: Vec<Arc<[f64]>>,
    stage: Stage,
    searches: Searches,
    round: u32,
    k: usize,
    most_samples: usize,
    refinements: Option<u32>,
    seed: u64,
    stats: FleetStats,
    trajectories: Vec<Arc<Trajectory>>,
    /// The first robot whose start and goal its roadmap, when it was complete last, does not connect.
    unconnected: Option<usize>,
    blocked: Option<Blocked>,
    reason: Option<FleetReason>,
}

impl Pbs {
    pub fn new(fleet: &Fleet, options: &PbsOptions, seed: u64) -> Result<Self, Error> {
        let samples = options.samples.unwrap_or_else(|| default_samples(fleet));
        Ok(Self {
            roadmaps: roadmaps(fleet, samples, options.k, seed)?,
            distances: Vec::new(),
            stage: Stage::Roadmaps,
            searches: Searches::default(),
            round: 0,
            k: options.k,
            most_samples: options.most_samples,
            refinements: options.refinements,
            seed,
            stats: FleetStats::default(),
            trajectories: Vec::new(),
            unconnected: None,
            blocked: None,
            reason: None,
        })
    }

    pub fn iterate(&mut self, fleet: &Fleet) -> Status {
        match &mut self.stage {
            Stage::Roadmaps => {
                match self.roadmaps.iter_mut().find(|roadmap| !roadmap.is_built()) {
                    Some(roadmap) => roadmap.iterate(),
                    None => {
                        self.distances.clear();
                        (self.stage, self.unconnected) = (Stage::Distances, None);
                    }
                }
                Status::Running
            }
            Stage::Distances if self.distances.len() < fleet.kinds().len() => {
                self.measure(fleet);
                Status::Running
            }
            Stage::Distances => {
                let Some(robot) = self.unconnected else {
                    self.begin_searches(fleet, true);
                    return Status::Running;
                };
                if self.grow(fleet) {
                    return Status::Running;
                }
                self.give_up(FleetReason::NotConnected, Some(Blocked { robot, by: Vec::new() }))
            }
            Stage::Searches => self.search(fleet),
            Stage::Refinement(refinement) => {
                let ground = Ground { fleet, roadmaps: &self.roadmaps, distances: &self.distances };
                match refinement.iterate(&ground, &mut self.stats) {
                    Refined::NotYet => Status::Running,
                    Refined::Plan => {
                        self.trajectories = std::mem::take(&mut refinement.trajectories);
                        Status::Solved
                    }
                    Refined::Refused => {
                        self.stage = Stage::Searches;
                        Status::Running
                    }
                }
            }
        }
    }

    /// Computes the distances of the next robot, and whether it can reach its goal.
    fn measure(&mut self, fleet: &Fleet) {
        let robot = self.distances.len();
        let roadmap = &self.roadmaps[fleet.kinds()[robot]];
        let [start, goal] = roadmap.ends(robot);
        let distances = roadmap.distances_to(goal);
        if distances[start as usize] == f64::INFINITY {
            self.unconnected.get_or_insert(robot);
        }
        let is_kept = fleet.kinds().len() * roadmap.vertex_count() <= MOST_DISTANCES;
        self.distances.push(if is_kept { distances.into() } else { Arc::new([]) });
    }

    /// Begins a round of searches; those by priorities begin again where roadmaps have grown.
    fn begin_searches(&mut self, fleet: &Fleet, have_grown: bool) {
        let left = &mut self.searches.left;
        let is_first = self.round == 0;
        if have_grown {
            left.retain(|search| matches!(search, Search::Composite(_) | Search::Moves(_)));
            let order = (0..fleet.kinds().len()).collect();
            left.insert(0, Search::Orders(Box::new(Orders::new(fleet, order, self.seed, RESTARTS))));
            left.insert(1, Search::Tree(Box::new(PriorityTree::new(fleet))));
        }
        if is_first && let Ok(composite) = Composite::new(fleet, &CompositeOptions::default(), self.seed) {
            left.push(Search::Composite(Box::new(composite)));
        }
        if is_first && fleet.kinds().len() > 1 {
            left.push(Search::Moves(Box::new(Moves::new(self.k, self.most_samples, self.seed))));
        }
        self.searches.turn = 0;
        self.searches.turns = (left.len() as u64) << self.round.min(30);
        self.searches.iterations = self.searches.of_a_turn(fleet);
        self.stage = Stage::Searches;
    }

    /// One iteration of the search whose turn it is.
    fn search(&mut self, fleet: &Fleet) -> Status {
        let ground = Ground { fleet, roadmaps: &self.roadmaps, distances: &self.distances };
        let searches = &mut self.searches;
        let Some(search) = searches.left.get_mut(searches.turn) else {
            self.round += 1;
            if !self.round.is_multiple_of(ROUNDS) || !self.grow(fleet) {
                self.begin_searches(fleet, false);
                if self.searches.left.is_empty() {
                    return self.give_up(FleetReason::OrderLimit, self.blocked.clone());
                }
            }
            return Status::Running;
        };
        let status = search.iterate(&ground, &mut self.stats);
        searches.iterations -= 1;
        if status == Status::Solved {
            let is_ordered = matches!(search, Search::Orders(_) | Search::Tree(_));
            let rounds = self.refinements.unwrap_or(if is_ordered { 0 } else { REFINEMENTS });
            self.stage = Stage::Refinement(Box::new(Refinement::new(search.take_solution(), rounds)));
        }
        if status != Status::Running || searches.iterations == 0 {
            self.blocked = search.blocked().cloned().or(self.blocked.take());
            searches.go_on(fleet, status != Status::Running);
        }
        Status::Running
    }

    /// Begins to grow the roadmaps that do not connect a start and a goal, or all; false if they have as many samples as they
    /// may.
    fn grow(&mut self, fleet: &Fleet) -> bool {
        let is_unconnected = |robot: &usize| {
            let [start, goal] = self.roadmaps[fleet.kinds()[*robot]].ends(*robot);
            self.roadmaps[fleet.kinds()[*robot]].distances_to(goal)[start as usize] == f64::INFINITY
        };
        let kind = self.unconnected.filter(is_unconnected).map(|robot| fleet.kinds()[robot]);
        let mut has_grown = false;
        for (number, roadmap) in self.roadmaps.iter_mut().enumerate() {
            let (count, most) = (roadmap.vertex_count(), self.most_samples + roadmap.end_count());
            if count < most && kind.is_none_or(|kind| kind == number) {
                roadmap.grow_to((2 * count).min(most));
                has_grown = true;
            }
        }
        if has_grown {
            self.stage = Stage::Roadmaps;
        }
        has_grown
    }

    fn give_up(&mut self, reason: FleetReason, blocked: Option<Blocked>) -> Status {
        (self.reason, self.blocked) = (Some(reason), blocked);
        Status::Exhausted
    }

    pub fn roadmaps(&self) -> &[Roadmap] {
        &self.roadmaps
    }

    /// The trajectory of a robot, once there is a plan.
    pub fn trajectory(&self, robot: usize) -> Option<&Trajectory> {
        self.trajectories.get(robot).map(|trajectory| &**trajectory)
    }

    pub fn planned(&self) -> usize {
        self.trajectories.len()
    }

    /// The robot whose roadmap does not connect its start and goal; else the one that found no way last.
    pub fn blocked(&self) -> Option<Blocked> {
        let alone = self.unconnected.map(|robot| Blocked { robot, by: Vec::new() });
        alone.or_else(|| self.blocked.clone())
    }

    pub fn reason(&self) -> Option<FleetReason> {
        self.reason.or(self.unconnected.map(|_| FleetReason::NotConnected))
    }

    pub fn stats(&self) -> FleetStats {
        roadmap_stats(&self.roadmaps, self.stats)
    }
}
