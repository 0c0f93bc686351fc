//! Prioritized planning: the robots plan one after the other, each around the trajectories of those before it.
//!
//! Erdmann and Lozano-Perez 1987, "On multiple moving objects". Each robot is searched for by safe intervals along the roadmap of
//! its kind, among the trajectories of those before it and the starts of those after it, which stand there until they have
//! planned: so every robot may leave as late as it likes. If one finds no way, the order fails, though another one might not:
//! then the run ends, or begins again in an order in which each has a way while the others stand (`sequence.rs`). If none is
//! found, that robot plans first (Andreychuk and Yakovlev 2018, "Two techniques that enhance the performance of multi-robot
//! prioritized path planning"). Whether a robot finds a way depends on those before it, in their order, and on nothing else: an
//! order that begins like one that has failed is not tried again.

use super::document::Fleet;
use super::priority_tree::{Ground, standing};
use super::result::{Blocked, FleetReason, FleetStats};
use super::roadmap::Roadmap;
use super::safe_intervals::{Expansion, Search};
use super::sequence::{Sequence, Sequenced};
use super::trajectory::Trajectory;
use crate::error::Error;
use crate::planner::{EdgeOptions, PrmOptions};
use crate::problem::Status;
use crate::random::{Random, Stream};
use std::collections::BTreeSet;
use std::sync::Arc;

/// How many draws of an order that has not failed are made.
const DRAWS: u32 = 1000;

/// How many other orders are tried if none is given.
const DEFAULT_RESTARTS: u32 = 20;

crate::options! {
    /// Options of prioritized planning.
    pub struct PrioritizedOptions for &[];
    /// Number of free samples of each roadmap: more find narrower passages and shorter ways but take longer.
    samples: Option<usize>, in 0.0..=100_000.0, "Samples", else "400, and 20 more for each robot";
    /// Each vertex is connected to its k nearest neighbours.
    k: usize = 15, in 1.0..=100.0, "Neighbours";
    /// How many other orders are tried if one fails: first one in which each robot has a way while the others stand; if none is
    /// found, the robot that finds no way plans first; if that order has failed too, one is drawn.
    restarts: Option<u32>, in 0.0..=10_000.0, "Restarts", else "20, or 0 if an order is given";
    /// Number of iterations after which the planner gives up.
    max_iterations: u64 = 10_000_000, in 1.0..=1e12, "Most iterations";
}

/// The planner. An iteration is a sample or a vertex connected of a roadmap, or an expansion of the search of one robot.
pub(super) struct Prioritized {
    roadmaps: Vec<Roadmap>,
    orders: Orders,
    stats: FleetStats,
}

impl Prioritized {
    pub fn new(
        fleet: &Fleet,
        options: &PrioritizedOptions,
        order: Vec<usize>,
        seed: u64,
        is_given: bool,
    ) -> Result<Self, Error> {
        let samples = options.samples.unwrap_or_else(|| default_samples(fleet));
        let roadmaps = roadmaps(fleet, samples, options.k, seed)?;
        let most_restarts = options.restarts.unwrap_or(if is_given { 0 } else { DEFAULT_RESTARTS });
        let orders = Orders::new(fleet, order, seed, most_restarts);
        Ok(Self { roadmaps, orders, stats: FleetStats::default() })
    }

    pub fn iterate(&mut self, fleet: &Fleet) -> Status {
        if let Some(roadmap) = self.roadmaps.iter_mut().find(|roadmap| !roadmap.is_built()) {
            roadmap.iterate();
            return Status::Running;
        }
        let ground = Ground { fleet, roadmaps: &self.roadmaps, distances: &[] };
        self.orders.iterate(&ground, &mut self.stats)
    }

    pub fn roadmaps(&self) -> &[Roadmap] {
        &self.roadmaps
    }

    pub fn orders(&self) -> &Orders {
        &self.orders
    }

    pub fn stats(&self) -> FleetStats {
        roadmap_stats(&self.roadmaps, self.stats)
    }
}

/// The number of samples of each roadmap if none is given.
pub(super) fn default_samples(fleet: &Fleet) -> usize {
    400 + 20 * fleet.kinds().len()
}

/// The roadmap of every kind of robot, before its first sample.
pub(super) fn roadmaps(fleet: &Fleet, samples: usize, k: usize, seed: u64) -> Result<Vec<Roadmap>, Error> {
    // A roadmap tries the motions from each start straight to its goal itself.
    let edges = EdgeOptions { direct: false, ..EdgeOptions::default() };
    let prm = PrmOptions { samples: Some(samples), k: Some(k), edges, ..PrmOptions::default() };
    let roadmap = |(kind, world)| {
        let robots = (0..fleet.kinds().len()).filter(|&robot| fleet.kinds()[robot] == kind).collect();
        Roadmap::new(fleet, world, robots, &prm, seed)
    };
    fleet.worlds().iter().enumerate().map(roadmap).collect()
}

/// The work on roadmaps, added to that of searches.
pub(super) fn roadmap_stats(roadmaps: &[Roadmap], searches: FleetStats) -> FleetStats {
    FleetStats {
        vertices: roadmaps.iter().map(|roadmap| roadmap.vertex_count() as u64).sum(),
        edges: roadmaps.iter().map(|roadmap| roadmap.edge_count() as u64).sum(),
        motion_checks: roadmaps.iter().map(Roadmap::motion_checks).sum::<u64>() + searches.motion_checks,
        ..searches
    }
}

/// One order of priorities after another, on roadmaps that are complete.
pub(super) struct Orders {
    order: Vec<usize>,
    /// How many robots of the order have planned.
    planned: usize,
    /// Of every robot: its trajectory, or its stand at the start.
    trajectories: Vec<Arc<Trajectory>>,
    search: Option<Search>,
    /// The next order, after one that has failed.
    next: Option<Sequence>,
    /// Who found no way last.
    blocked: Option<Blocked>,
    /// The beginnings of orders whose last robot finds no way.
    failed: BTreeSet<Vec<usize>>,
    reason: Option<FleetReason>,
    all: Vec<usize>,
    random: Random,
    restarts: u32,
    most_restarts: u32,
}

impl Orders {
    pub fn new(fleet: &Fleet, order: Vec<usize>, seed: u64, most_restarts: u32) -> Self {
        Self {
            all: (0..order.len()).collect(),
            order,
            planned: 0,
            trajectories: standing(fleet),
            search: None,
            next: None,
            blocked: None,
            failed: BTreeSet::new(),
            reason: None,
            random: Random::new(seed, Stream::Priorities),
            restarts: 0,
            most_restarts,
        }
    }

    /// One expansion of the search of one robot.
    pub fn iterate(&mut self, ground: &Ground, stats: &mut FleetStats) -> Status {
        if let Some(sequence) = self.next.take() {
            return self.take_next(sequence, ground, stats);
        }
        let robot = self.order[self.planned];
        let scene = ground.scene(robot, &self.trajectories, &self.all);
        let search = self.search.get_or_insert_with(|| ground.search(&scene));
        match search.step(&scene, &mut stats.pair_checks) {
            Expansion::Vertex => stats.expanded += 1,
            Expansion::Part => {}
            Expansion::Found(trajectory) => {
                self.trajectories[robot] = Arc::new(trajectory);
                self.planned += 1;
                self.search = None;
                if self.planned == self.order.len() {
                    return Status::Solved;
                }
            }
            Expansion::Nothing(by) => {
                self.search = None;
                let reason = self.fail(by.is_none());
                let by = by.unwrap_or_default();
                self.blocked = Some(Blocked { robot, by: by.clone() });
                if let Some(reason) = reason {
                    return self.give_up(reason);
                }
                let mut sequence = Sequence::new(ground.fleet, self.blocked_first());
                if self.planned == 0 {
                    sequence.first_has_failed(by);
                }
                self.next = Some(sequence);
            }
        }
        Status::Running
    }

    /// Goes on making the next order. Once it is complete, its first robot plans next; if none can be made, one is drawn.
    fn take_next(&mut self, mut sequence: Sequence, ground: &Ground, stats: &mut FleetStats) -> Status {
        let order = match sequence.iterate(ground, &self.all, stats) {
            Sequenced::NotYet => {
                self.next = Some(sequence);
                return Status::Running;
            }
            Sequenced::Order(order) if !self.has_failed(&order) => Some(order),
            Sequenced::Order(_) | Sequenced::Stuck => self.draw(),
            Sequenced::Never => None,
            Sequenced::Unconnected(robot) => {
                self.blocked = Some(Blocked { robot, by: Vec::new() });
                return self.give_up(FleetReason::NotConnected);
            }
        };
        let Some(order) = order else { return self.give_up(FleetReason::NoOrder) };
        (self.order, self.planned, self.trajectories) = (order, 0, standing(ground.fleet));
        self.restarts += 1;
        stats.restarts += 1;
        Status::Running
    }

    fn give_up(&mut self, reason: FleetReason) -> Status {
        self.reason = Some(reason);
        Status::Exhausted
    }

    /// The order with the robot first that found no way.
    fn blocked_first(&self) -> Vec<usize> {
        let mut order = self.order.clone();
        order[..=self.planned].rotate_right(1);
        order
    }

    /// Notes that the order has failed; if no other one is to be tried, the reason.
    fn fail(&mut self, is_alone: bool) -> Option<FleetReason> {
        let failed = self.order[..=self.planned].to_vec();
        self.failed.insert(failed);
        if is_alone {
            return Some(FleetReason::NotConnected);
        }
        if self.restarts == self.most_restarts {
            return Some(if self.have_all_failed(&mut Vec::new()) {
                FleetReason::NoOrder
            } else {
                FleetReason::OrderLimit
            });
        }
        None
    }

    /// Another order: with the robot first that found no way, or drawn; `None` if all have failed.
    fn draw(&mut self) -> Option<Vec<usize>> {
        let mut order = self.blocked_first();
        for _ in 0..DRAWS {
            if !self.has_failed(&order) {
                return Some(order);
            }
            for i in (1..order.len()).rev() {
                order.swap(i, self.random.below(i as u64 + 1) as usize);
            }
        }
        if self.have_all_failed(&mut Vec::new()) {
            return None;
        }
        // Few orders are left: the first of them.
        order.clear();
        while order.len() < self.all.len() {
            let next = self.all.iter().copied().find(|robot| {
                let mut beginning = order.clone();
                beginning.push(*robot);
                !order.contains(robot) && !self.have_all_failed(&mut beginning)
            });
            order.push(next.expect("an order that has not failed"));
        }
        Some(order)
    }

    /// Whether an order begins like one that has failed.
    fn has_failed(&self, order: &[usize]) -> bool {
        (1..=order.len()).any(|count| self.failed.contains(&order[..count]))
    }

    /// Whether every order that begins with these robots has failed.
    fn have_all_failed(&self, beginning: &mut Vec<usize>) -> bool {
        if self.failed.contains(&beginning[..]) {
            return true;
        }
        let longer = self.failed.range(beginning.clone()..).next();
        if !longer.is_some_and(|failed| failed.starts_with(beginning)) {
            return false;
        }
        self.all.iter().all(|robot| {
            if beginning.contains(robot) {
                return true;
            }
            beginning.push(*robot);
            let have_failed = self.have_all_failed(beginning);
            beginning.pop();
            have_failed
        })
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
        self.order[..self.planned].contains(&robot).then(|| &*self.trajectories[robot])
    }

    /// The trajectories of all robots, once solved.
    pub fn take_solution(&mut self) -> Vec<Arc<Trajectory>> {
        std::mem::take(&mut self.trajectories)
    }

    pub fn blocked(&self) -> Option<&Blocked> {
        self.blocked.as_ref()
    }

    pub fn reason(&self) -> Option<FleetReason> {
        self.reason
    }
}
