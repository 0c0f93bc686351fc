//! A roadmap whose edges a policy drives reliably: PRM-RL (Faust et al. 2018, "PRM-RL: Long-range robotic navigation tasks by
//! combining reinforcement learning and sampling-based planning"; Francis et al. 2020, "Long-range indoor navigation with
//! PRM-RL").
//!
//! Vertices are positions at which the robot can turn on the spot. Two are connected if rollouts of the policy between them, with
//! noise, from random headings and from anywhere within the goal tolerance of the first, reach the second often enough, in both
//! directions. Nothing of that is proven: the result says `rollouts`. Planners see it as a [`Validity`] of the plane, so each of
//! those without controls serves; `lazy-prm` rolls out only the edges that the best path wants.

use super::document::{Navigation, NavigationQuery};
use super::execution::check_finite;
use super::outcome::Outcome;
use super::policy::Policy;
use super::rollout::{Controller, Simulation, State, generator};
use crate::collision::DiscValidity;
use crate::error::{Code, Error};
use crate::options::Options as _;
use crate::planner::{LazyPrmOptions, PlannerOptions};
use crate::problem::{Contact, Problem, Validity};
use crate::random::{Random, Stream, check_seed};
use crate::robot::{DiscRobot, plane};
use crate::run::{self, Options, Request, Run};
use crate::space::{MotionSpace, Space};
use std::cell::Cell;
use std::f64::consts::PI;

/// The size of states: coordinates past the second are 0.
const SIZE: usize = crate::world::SMALL;

crate::options! {
    /// When a policy drives reliably enough from one vertex to another.
    pub struct RolloutOptions for &[];
    /// Number of rollouts in each direction.
    rollouts: u32 = 20, in 1.0..=1000.0, "Rollouts";
    /// The share of rollouts, in each direction, that must reach the other vertex.
    least_share: Option<f64>, in 0.0..=1.0, "Least share", else "0.6 where reliability counts, else 0.95";
    /// How long a detour is worth a path that succeeds e times as often; 0 takes the shortest path of reliable edges.
    reliability: Option<f64>, in 0.0..=1e4, "Reliability", unit "m", else "100 m for lazy planners, else 0";
    /// The longest edges that are tried.
    longest_edge: f64 = 3.0, in 0.1..=1000.0, "Longest edge", unit "m";
}

impl RolloutOptions {
    /// The reliability under a planner: only lazy ones know what an edge costs besides its length.
    ///
    /// # Errors
    /// `unsupported` (pointer `/reliability`) for a planner that is not lazy, unless it is 0.
    fn reliability_of(&self, planner: &PlannerOptions) -> Result<f64, Error> {
        let is_lazy = matches!(planner, PlannerOptions::LazyPrm(_) | PlannerOptions::LazyPrmStar(_));
        match self.reliability {
            Some(given) if given > 0.0 && !is_lazy => {
                let id = planner.id();
                let sentence =
                    format!("{id} goes by the lengths of edges; reliability is for lazy-prm and lazy-prm-star");
                Err(Error::new(Code::Unsupported, "/reliability", sentence))
            }
            given => Ok(given.unwrap_or(if is_lazy { 100.0 } else { 0.0 })),
        }
    }
}

/// Rollouts along an edge that have reached its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EdgeRollouts {
    /// The rollouts in each direction.
    pub of: u32,
    /// Those from the first end to the second that have reached it.
    pub forward: u32,
    /// Those back.
    pub backward: u32,
}

/// What makes an edge: rollouts of a policy on a floor, that depend on a seed and the ends of the edge alone.
pub(super) struct Rollouts {
    simulation: Simulation,
    controller: Controller,
    options: RolloutOptions,
    seed: u64,
    /// Time steps that were driven.
    steps: Cell<u64>,
    /// Of the last edge that was found reliable, the rollouts that reached its end, in the worse direction.
    least: Cell<u32>,
}

impl Rollouts {
    pub(super) fn new(task: &Navigation, policy: &Policy, options: RolloutOptions, seed: u64) -> Result<Self, Error> {
        let simulation = Simulation::new(task);
        let controller = Controller::new(Some(policy), task.robot())?;
        Ok(Self { simulation, controller, options, seed, steps: Cell::new(0), least: Cell::new(0) })
    }

    /// Of the rollouts from one position to another, how many reach it; `None` as soon as fewer than `least` can.
    fn reached(&self, a: [f64; 2], b: [f64; 2], least: u32) -> Option<u32> {
        let distance = ((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])).sqrt();
        let patience = self.simulation.patience(distance);
        let ends = [a[0], a[1], b[0], b[1]].map(f64::to_bits);
        let mut random = generator(self.seed, Stream::Rollouts, &ends);
        let mut reached = 0;
        for i in 0..self.options.rollouts {
            let from = self.start(a, &mut random);
            let progress = self.simulation.drive(&self.controller, from, b, patience, &mut random, |_| {});
            self.steps.set(self.steps.get() + u64::from(progress.steps));
            reached += u32::from(progress.outcome == Outcome::Reached);
            if reached + (self.options.rollouts - 1 - i) < least {
                return None;
            }
        }
        Some(reached)
    }

    /// A state in which a robot that has reached a position may be: within the goal tolerance and free, with any heading.
    fn start(&self, [x, y]: [f64; 2], random: &mut Random) -> State {
        let tolerance = self.simulation.task().goal_tolerance();
        let heading = PI * (1.0 - 2.0 * random.uniform());
        for _ in 0..100 {
            let [dx, dy] = [(); 2].map(|()| tolerance * (1.0 - 2.0 * random.uniform()));
            let pose = [x + dx, y + dy, heading];
            let is_near = dx * dx + dy * dy <= tolerance * tolerance;
            if is_near
                && self.simulation.floor.is_free(pose)
                && let Some(state) = self.simulation.draw_state(pose, random)
            {
                return state;
            }
        }
        State::at_rest([x, y, heading])
    }

    /// Whether enough rollouts succeed in both directions.
    fn is_reliable(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let RolloutOptions { rollouts, longest_edge, .. } = self.options;
        let least_share = self.options.least_share.unwrap_or(if self.reliability() > 0.0 { 0.6 } else { 0.95 });
        let is_enough = |count: &u32| f64::from(*count) / f64::from(rollouts) >= least_share;
        let least = (0..rollouts).find(is_enough).unwrap_or(rollouts);
        let squared = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
        if squared > longest_edge * longest_edge {
            return false;
        }
        let reached = self.reached(a, b, least).and_then(|there| Some(there.min(self.reached(b, a, least)?)));
        self.least.set(reached.unwrap_or(0));
        reached.is_some()
    }

    /// What the edge that was found reliable last costs besides its length: the logarithm of its share of successes, as those of
    /// the edges of a path multiply.
    fn surcharge(&self) -> f64 {
        if self.reliability() == 0.0 {
            return 0.0;
        }
        // An edge that never succeeds is one only if the least share is 0.
        let share = f64::from(self.least.get().max(1)) / f64::from(self.options.rollouts);
        self.reliability() * f64::max(0.0, -libm::log(share))
    }

    fn reliability(&self) -> f64 {
        self.options.reliability.unwrap_or(0.0)
    }

    /// All rollouts along an edge.
    pub(super) fn along(&self, a: [f64; 2], b: [f64; 2]) -> EdgeRollouts {
        let [forward, backward] = [(a, b), (b, a)].map(|(a, b)| self.reached(a, b, 0).unwrap_or(0));
        EdgeRollouts { of: self.options.rollouts, forward, backward }
    }
}

/// Configurations are free where the robot can turn on the spot, motions if the policy drives them reliably.
struct RolloutValidity {
    turning: DiscValidity,
    rollouts: Rollouts,
}

fn position(q: &[f64; SIZE]) -> [f64; 2] {
    [q[0], q[1]]
}

impl Validity<[f64; SIZE]> for RolloutValidity {
    fn contacts(&self, q: &[f64; SIZE]) -> Vec<Contact> {
        self.turning.contacts(q)
    }

    fn part_name(&self, _part: usize) -> String {
        "the robot".into()
    }

    fn is_free(&self, q: &[f64; SIZE]) -> bool {
        self.turning.is_free(q)
    }

    fn is_motion_free(&self, a: &[f64; SIZE], b: &[f64; SIZE]) -> bool {
        // The ends may be new, as those of a shortcut are: on an edge that is rolled out not every position is free.
        self.turning.is_free(a) && self.turning.is_free(b) && self.rollouts.is_reliable(position(a), position(b))
    }

    fn surcharge(&self, _: &[f64; SIZE], _: &[f64; SIZE]) -> f64 {
        self.rollouts.surcharge()
    }

    /// Each time step proves an arc.
    fn clearance_evaluations(&self) -> u64 {
        Validity::<[f64; SIZE]>::clearance_evaluations(&self.turning) + self.rollouts.steps.get()
    }

    /// A time step: its rays, and the policy.
    fn evaluation_nanoseconds(&self) -> u64 {
        1500
    }
}

/// The options of [`start`] by names: parameters are those of the planner, `lazy-prm` by default, and of [`RolloutOptions`].
///
/// # Errors
/// Those of [`PlannerOptions::read`].
pub fn read_options(request: &Request) -> Result<(RolloutOptions, Options), Error> {
    let parameters = request.parameters.iter().cloned();
    let (own, parameters): (Vec<_>, Vec<_>) = parameters.partition(|(name, _)| RolloutOptions::has(name));
    let rollouts = RolloutOptions::read(&own)?;
    Ok((rollouts, Request { parameters, ..request.clone() }.read(default_planner())?))
}

/// The planner if none is named.
fn default_planner() -> PlannerOptions {
    LazyPrmOptions::default().into()
}

/// Begins a run that builds a roadmap of edges which the policy drives reliably, or grows a tree of them, by lazy PRM if no
/// planner is named. The path is of positions, with the query's start and goal as its ends.
///
/// # Errors
/// `unknown-query`, and the errors of parameter values; `unsupported` for planners by controls, for options about other edges,
/// for a reliability of a planner that is not lazy (pointer `/reliability`), for a policy of another robot (`/policy/robot`),
/// and for one that senses in another way (`/policy/sensor`); `start-in-collision` if the robot cannot turn on the spot at the
/// start.
pub fn start(
    task: &Navigation,
    policy: &Policy,
    rollouts: &RolloutOptions,
    options: &Options,
) -> Result<Box<dyn Run>, Error> {
    let (index, query) = task.find_query(options.query.as_deref())?;
    start_between(task, policy, rollouts, options, query).map_err(|error| match error.code() {
        Code::StartInCollision | Code::GoalInCollision => error.under(&format!("/queries/{index}")),
        _ => error,
    })
}

/// The rollouts along each step of a path of positions, as a run with the same policy, options and seed counts them, but all of
/// them.
///
/// # Errors
/// Those of [`start`] about the policy, its options and the seed; `not-finite` with the pointer `/path/i`.
pub fn edge_rollouts(
    task: &Navigation,
    policy: &Policy,
    rollouts: &RolloutOptions,
    seed: u64,
    path: &[[f64; 2]],
) -> Result<Vec<EdgeRollouts>, Error> {
    check_seed(seed)?;
    rollouts.check()?;
    for (i, position) in path.iter().enumerate() {
        check_finite(position, &format!("/path/{i}"))?;
    }
    let rollouts = Rollouts::new(task, policy, *rollouts, seed)?;
    Ok(path.windows(2).map(|ends| rollouts.along(ends[0], ends[1])).collect())
}

fn start_between(
    task: &Navigation,
    policy: &Policy,
    rollouts: &RolloutOptions,
    options: &Options,
    query: &NavigationQuery,
) -> Result<Box<dyn Run>, Error> {
    check_seed(options.seed)?;
    rollouts.check()?;
    let planner = options.planner.unwrap_or_else(default_planner);
    planner.check()?;
    run::check_use(&planner, run::LEARNED)?;
    let rollouts = RolloutOptions { reliability: Some(rollouts.reliability_of(&planner)?), ..*rollouts };
    let space: MotionSpace<SIZE> = MotionSpace::new(plane(task.bounds()));
    let disc = DiscRobot::new(task.robot().reach())?;
    let validity = RolloutValidity {
        turning: DiscValidity::new(&disc, task.collision().clone()),
        rollouts: Rollouts::new(task, policy, rollouts, options.seed)?,
    };
    let [start, goal] = [&query.start[..2], &query.goal[..]].map(|q| space.state(q));
    let mut problem = Problem::new(space.clone(), Box::new(validity), start, goal)?;
    problem.end_effector = Some(Box::new(move |a, b| space.distance(a, b)));
    problem.records_events = options.events;
    run::start_learned(problem, planner, options.seed, [task.name(), &query.name])
}
