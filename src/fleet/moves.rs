//! Joint moves over roadmaps of their own, which have few vertices: long edges take robots far in few moves.
//!
//! Joint search (`joint.rs`) and walks (`walks.rs`) take turns. If neither finds a plan, the roadmaps grow to twice as many
//! vertices; after some rounds others are begun, by another seed, and every search gets twice as long. Roadmaps grow at once
//! where they do not connect a start to its goal.

use super::joint::Joint;
use super::prioritized::roadmaps;
use super::priority_tree::Ground;
use super::result::FleetStats;
use super::roadmap::Roadmap;
use super::trajectory::Trajectory;
use super::walks::Walks;
use crate::error::Error;
use crate::problem::Status;
use std::sync::Arc;

/// The samples of a roadmap at first, and as many more for each robot.
const SAMPLES: [usize; 2] = [30, 5];
/// The number of rounds in which the roadmaps grow.
const ROUNDS: u32 = 5;
/// The iterations of a search in the first rounds, and as many more for each robot.
const ITERATIONS: [u64; 2] = [10_000, 5_000];
/// Distances in joint search count up to this much more than they are, a multiple of it each time that roadmaps are begun.
const NOISE: f64 = 0.25;
/// The most distances to goals that are kept, of all robots; a fleet that has more is too large for joint moves.
const MOST_DISTANCES: usize = 8_000_000;

/// The searches. An iteration is one of a roadmap or of a search.
pub(super) struct Moves {
    roadmaps: Vec<Roadmap>,
    distances: Vec<Arc<[f64]>>,
    is_connected: bool,
    k: usize,
    most_samples: usize,
    seed: u64,
    round: u32,
    searches: Option<(Joint, Walks)>,
    is_walking: bool,
    /// The iterations left of the search whose turn it is.
    left: u64,
    solution: Vec<Arc<Trajectory>>,
}

impl Moves {
    pub fn new(k: usize, most_samples: usize, seed: u64) -> Self {
        Self {
            roadmaps: Vec::new(),
            distances: Vec::new(),
            is_connected: true,
            k,
            most_samples,
            seed,
            round: 0,
            searches: None,
            is_walking: false,
            left: 0,
            solution: Vec::new(),
        }
    }

    /// `Exhausted` if the fleet is too large, or if no roadmap connects every start to its goal.
    pub fn iterate(&mut self, around: &Ground, stats: &mut FleetStats) -> Status {
        let fleet = around.fleet;
        if self.roadmaps.is_empty() {
            return self.begin_roadmaps(around).map_or(Status::Exhausted, |()| Status::Running);
        }
        if let Some(roadmap) = self.roadmaps.iter_mut().find(|roadmap| !roadmap.is_built()) {
            let before = roadmap.motion_checks();
            roadmap.iterate();
            stats.motion_checks += roadmap.motion_checks() - before;
            return Status::Running;
        }
        if self.distances.len() < fleet.kinds().len() {
            let robot = self.distances.len();
            let roadmap = &self.roadmaps[fleet.kinds()[robot]];
            if roadmap.vertex_count() * fleet.kinds().len() > MOST_DISTANCES {
                return Status::Exhausted;
            }
            let [start, goal] = roadmap.ends(robot);
            let distances = roadmap.distances_to(goal);
            self.is_connected &= distances[start as usize] < f64::INFINITY;
            self.distances.push(distances.into());
            return Status::Running;
        }
        if !self.is_connected {
            return if self.grow() { Status::Running } else { Status::Exhausted };
        }
        let ground = Ground { fleet, roadmaps: &self.roadmaps, distances: &self.distances };
        let Some((joint, walks)) = &mut self.searches else {
            let (seed, noise) = (self.seed.wrapping_add(u64::from(self.round)), f64::from(self.round / ROUNDS));
            self.searches = Some((Joint::new(&ground, seed, NOISE * noise), Walks::new(&ground, seed)));
            (self.is_walking, self.left) = (false, self.iterations(&ground));
            return Status::Running;
        };
        let status = if self.is_walking { walks.iterate(&ground, stats) } else { joint.iterate(&ground, stats) };
        if status == Status::Solved {
            self.solution = if self.is_walking { walks.take_solution() } else { joint.take_solution() };
            return Status::Solved;
        }
        self.left -= 1;
        if status == Status::Running && self.left > 0 {
            return Status::Running;
        }
        self.left = self.iterations(&ground);
        if self.is_walking {
            self.searches = None;
            self.round += 1;
            if self.round.is_multiple_of(ROUNDS) || !self.grow() {
                self.roadmaps.clear();
            }
        }
        self.is_walking = !self.is_walking;
        Status::Running
    }

    /// The iterations of a search in this round.
    fn iterations(&self, ground: &Ground) -> u64 {
        (ITERATIONS[0] + ITERATIONS[1] * ground.fleet.kinds().len() as u64) << (self.round / ROUNDS).min(20)
    }

    /// Begins other roadmaps.
    fn begin_roadmaps(&mut self, around: &Ground) -> Result<(), Error> {
        let samples = (SAMPLES[0] + SAMPLES[1] * around.fleet.kinds().len()).min(self.most_samples);
        let seed = self.seed.wrapping_add(u64::from(self.round));
        self.roadmaps = roadmaps(around.fleet, samples, self.k, seed)?;
        self.distances.clear();
        self.is_connected = true;
        Ok(())
    }

    /// Begins to grow the roadmaps to twice as many vertices; false if one has as many as it may.
    fn grow(&mut self) -> bool {
        let most = self.most_samples;
        if self.roadmaps.iter().any(|roadmap| roadmap.vertex_count() >= most + roadmap.end_count()) {
            return false;
        }
        for roadmap in &mut self.roadmaps {
            roadmap.grow_to((2 * roadmap.vertex_count()).min(most + roadmap.end_count()));
        }
        self.distances.clear();
        self.is_connected = true;
        true
    }

    /// The trajectories of all robots, once solved.
    pub fn take_solution(&mut self) -> Vec<Arc<Trajectory>> {
        std::mem::take(&mut self.solution)
    }
}
