//! Prioritized planning: the robots plan one after the other, each around the trajectories of those before it.
//!
//! Erdmann and Lozano-Perez 1987, "On multiple moving objects". Each robot is searched for by safe intervals along the roadmap of its
//! kind, among the trajectories of those before it and the starts of those after it, which stand there until they have planned: so
//! every robot may leave as late as it likes. If one finds no way, the order fails, though another one might not: then the run ends,
//! or begins again with that robot first (Andreychuk and Yakovlev 2018, "Two techniques that enhance the performance of multi-robot
//! prioritized path planning").

use super::Setup;
use super::roadmap::Roadmap;
use super::run::{Blocked, FleetStats};
use super::safe_intervals::{Expansion, Scene, Search};
use super::trajectory::Trajectory;
use crate::error::Error;
use crate::planner::PrmOptions;
use crate::problem::Status;
use crate::random::{Random, Stream};

/// The earliest departures graze the others: so many slacks are left between them, a hundred-millionth of the world's size.
const MARGIN: f64 = 1e4;

/// How many other orders are tried if none is given.
const DEFAULT_RESTARTS: u32 = 20;

crate::options! {
    /// Options of prioritized planning.
    pub struct PrioritizedOptions for &[];
    /// Number of free samples of each roadmap: more find narrower passages and shorter ways but take longer.
    samples: Option<usize>, in 0.0..=100_000.0, "Samples", else "400, and 20 more for each robot";
    /// Each vertex is connected to its k nearest neighbours.
    k: usize = 15, in 1.0..=100.0, "Neighbours";
    /// How often another order is tried if one fails: the robot that finds no way plans first, or if it did, the order is drawn at random.
    restarts: Option<u32>, in 0.0..=10_000.0, "Restarts", else "20, or 0 if an order is given";
    /// Number of iterations after which the planner gives up.
    max_iterations: u64 = 10_000_000, in 1.0..=1e12, "Most iterations";
}

/// The planner. An iteration is a sample or a vertex connected of a roadmap, or an expansion of the search of one robot.
pub(super) struct Prioritized {
    roadmaps: Vec<Roadmap>,
    order: Vec<usize>,
    /// How many robots of the order have planned.
    planned: usize,
    /// Of every robot: its trajectory, or its stand at the start.
    trajectories: Vec<Trajectory>,
    search: Option<Search>,
    blocked: Option<Blocked>,
    random: Random,
    restarts: u32,
    most_restarts: u32,
    stats: FleetStats,
}

impl Prioritized {
    pub fn new(
        setup: &Setup,
        options: &PrioritizedOptions,
        order: Vec<usize>,
        seed: u64,
        is_given: bool,
    ) -> Result<Self, Error> {
        let samples = options.samples.unwrap_or(400 + 20 * order.len());
        let prm = PrmOptions { samples: Some(samples), k: Some(options.k), ..PrmOptions::default() };
        let roadmap = |(kind, world)| {
            let robots = (0..setup.kinds.len()).filter(|&robot| setup.kinds[robot] == kind).collect();
            Roadmap::new(&setup.fleet, world, robots, &prm, seed)
        };
        Ok(Self {
            roadmaps: setup.worlds.iter().enumerate().map(roadmap).collect::<Result<_, _>>()?,
            order,
            planned: 0,
            trajectories: standing(setup),
            search: None,
            blocked: None,
            random: Random::new(seed, Stream::Priorities),
            restarts: 0,
            most_restarts: options.restarts.unwrap_or(if is_given { 0 } else { DEFAULT_RESTARTS }),
            stats: FleetStats::default(),
        })
    }

    pub fn iterate(&mut self, setup: &Setup) -> Status {
        if let Some(roadmap) = self.roadmaps.iter_mut().find(|roadmap| !roadmap.is_built()) {
            roadmap.iterate();
            return Status::Running;
        }
        let robot = self.order[self.planned];
        let scene = Scene {
            robot,
            speed: setup.fleet.robots()[robot].speed,
            roadmap: &self.roadmaps[setup.kinds[robot]],
            footprints: &setup.footprints,
            trajectories: &self.trajectories,
            slack: MARGIN * setup.slack,
        };
        let search = self.search.get_or_insert_with(|| Search::new(&scene));
        match search.step(&scene, &mut self.stats.pair_checks) {
            Expansion::Vertex => self.stats.expanded += 1,
            Expansion::Part => {}
            Expansion::Found(trajectory) => {
                self.trajectories[robot] = trajectory;
                self.planned += 1;
                self.search = None;
                if self.planned == self.order.len() {
                    return Status::Solved;
                }
            }
            Expansion::Nothing(by) => {
                self.search = None;
                if self.restarts == self.most_restarts {
                    self.blocked = Some(Blocked { robot, by });
                    return Status::Exhausted;
                }
                self.restart(setup);
            }
        }
        Status::Running
    }

    /// Begins again with the robot first that has found no way, or with an order drawn at random if it was first.
    fn restart(&mut self, setup: &Setup) {
        if self.planned > 0 {
            self.order[..=self.planned].rotate_right(1);
        } else {
            for i in (1..self.order.len()).rev() {
                self.order.swap(i, self.random.below(i as u64 + 1) as usize);
            }
        }
        self.restarts += 1;
        self.planned = 0;
        self.trajectories = standing(setup);
    }

    pub fn roadmaps(&self) -> &[Roadmap] {
        &self.roadmaps
    }

    /// The robots in the order in which they plan.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    pub fn planned(&self) -> usize {
        self.planned
    }

    /// The trajectory of a robot that has planned.
    pub fn trajectory(&self, robot: usize) -> Option<&Trajectory> {
        self.order[..self.planned].contains(&robot).then(|| &self.trajectories[robot])
    }

    pub fn blocked(&self) -> Option<&Blocked> {
        self.blocked.as_ref()
    }

    pub fn stats(&self) -> FleetStats {
        FleetStats {
            vertices: self.roadmaps.iter().map(|roadmap| roadmap.vertex_count() as u64).sum(),
            edges: self.roadmaps.iter().map(|roadmap| roadmap.edge_count() as u64).sum(),
            motion_checks: self.roadmaps.iter().map(Roadmap::motion_checks).sum(),
            restarts: u64::from(self.restarts),
            ..self.stats
        }
    }
}

/// Every robot at its start.
fn standing(setup: &Setup) -> Vec<Trajectory> {
    setup.fleet.robots().iter().map(|member| Trajectory::standing(super::document::pose(&member.start))).collect()
}
