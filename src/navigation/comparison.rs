//! Ways to drive far, compared on the same floor with the same queries: the policy alone, straight edges of a roadmap that are
//! proven free, with and without a margin, and PRM-RL. Straight edges are driven twice, by a controller that does not use its
//! rays and by the policy: what PRM-RL gains over the latter is due to its edges alone.
//!
//! An iteration is one of a roadmap's planner, or one execution. Queries are drawn from the seed; every execution has noise of
//! its own.

use super::document::{Navigation, NavigationQuery};
use super::episode;
use super::execution::Executor;
use super::outcome::Outcome;
use super::policy::Policy;
use super::roadmap::{self, RolloutOptions};
use super::rollout::Drive;
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::options::Options as _;
use crate::problem::{Status, Stepped};
use crate::random::{Random, Stream, check_seed};
use crate::run::{self, LazyPrmOptions, Options, PlannerOptions, PrmOptions, Run};
use crate::statistics::{Mean, Share, mean, resampled, share};
use crate::world::PlanningWorld;
use serde::Serialize;

crate::options! {
    /// What is compared.
    pub struct ComparisonOptions for &[];
    /// Number of queries, drawn from the seed.
    queries: usize = 20, in 1.0..=1000.0, "Queries";
    /// Number of executions of each query by each method.
    trials: u64 = 5, in 1.0..=1000.0, "Trials";
    /// Starts and goals are at least this far apart.
    least_distance: f64 = 10.0, in 0.0..=1000.0, "Least distance", unit "m";
    /// Number of free samples of a roadmap.
    samples: usize = 2500, in 0.0..=100_000.0, "Samples";
    /// Number of neighbours that a vertex is connected to.
    k: usize = 20, in 1.0..=100.0, "Neighbours";
    /// By what the robot is larger while straight edges with a margin are proven: room for errors of the driver.
    margin: f64 = 0.1, in 0.0..=1.0, "Margin", unit "m";
    /// When an edge is driven reliably.
    rollouts: RolloutOptions;
}

/// The way a query is driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Method {
    /// The policy drives to the goal, without a plan.
    Policy,
    /// A roadmap of straight edges, proven free, tracked by a controller that does not use its rays.
    Straight,
    /// The same with edges that are proven for a larger robot.
    StraightMargin,
    /// A roadmap of straight edges, proven free, driven by the policy.
    StraightPolicy,
    /// The same with edges that are proven for a larger robot.
    StraightMarginPolicy,
    /// A roadmap of edges that the policy drives reliably, driven by it.
    PrmRl,
}

impl Method {
    /// All, in the order in which they are tried.
    pub const ALL: [Method; 6] = [
        Method::Policy,
        Method::Straight,
        Method::StraightMargin,
        Method::StraightPolicy,
        Method::StraightMarginPolicy,
        Method::PrmRl,
    ];

    /// The index of its roadmap, if it has one: of straight edges, of those with a margin, of learned edges.
    fn roadmap(self) -> Option<usize> {
        match self {
            Method::Policy => None,
            Method::Straight | Method::StraightPolicy => Some(0),
            Method::StraightMargin | Method::StraightMarginPolicy => Some(1),
            Method::PrmRl => Some(2),
        }
    }

    /// Whether the policy drives.
    fn is_by_policy(self) -> bool {
        !matches!(self, Method::Straight | Method::StraightMargin)
    }
}

/// One execution.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null, rename = "ComparedExecution"))]
pub struct Execution {
    /// The query, by its number.
    pub query: usize,
    /// The method.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "NavigationMethod"))]
    pub method: Method,
    /// How it ended; `None` if the roadmap has no path.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "DriveOutcome | null"))]
    pub outcome: Option<Outcome>,
    /// The length of the trace, in metres; 0 without a path.
    pub length: f64,
    /// How long it took, in seconds; 0 without a path.
    pub time: f64,
}

/// How a method did.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MethodSummary {
    /// The method.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "NavigationMethod"))]
    pub method: Method,
    /// The executions that reached the goal.
    pub reached: Share,
    /// Those that ended in a collision.
    pub collisions: Share,
    /// Those in which the load swung too far; of a robot without a load none.
    pub swings: Share,
    /// The queries for which the roadmap has a path; all of them for the policy alone.
    pub planned: Share,
    /// The lengths of executions that reached the goal, in metres.
    pub length: Mean,
    /// Their times, in seconds.
    pub time: Mean,
}

/// A comparison: a value that is stepped. How its iterations are divided into steps does not change its result.
pub struct Comparison {
    options: ComparisonOptions,
    seed: u64,
    time_step: f64,
    queries: Vec<NavigationQuery>,
    /// Of straight edges, of those with a margin, and of PRM-RL.
    roadmaps: [Box<dyn Run>; 3],
    /// Of the controller that does not use its rays, and of the policy.
    executors: [Executor; 2],
    /// The paths of the present query, by roadmap; empty if there is none.
    paths: [Vec<[f64; 2]>; 3],
    executions: Vec<Execution>,
    iterations: u64,
}

/// An iteration is one of a roadmap, or an execution.
impl Stepped for Comparison {
    fn iterate(&mut self) {
        self.iterations += 1;
        match self.roadmaps.iter_mut().find(|roadmap| roadmap.status() == Status::Running) {
            Some(roadmap) => {
                roadmap.step(1);
            }
            None => self.execute(),
        }
    }

    /// `Running` until all executions are made, then `Solved`.
    fn status(&self) -> Status {
        if self.executions.len() < self.count() { Status::Running } else { Status::Solved }
    }

    fn iterations(&self) -> u64 {
        self.iterations
    }
}

impl Comparison {
    /// Begins, with a seed, 0 to 2^53 - 1.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with the pointer of the option;
    /// `out-of-range` at `/least_distance` if the floor has no two positions so far apart, with room for the margin; at
    /// `/robot/shape` if it has no room for the robot; `unsupported` for a policy of another robot, or that senses in another
    /// way.
    pub fn new(task: &Navigation, policy: &Policy, options: &ComparisonOptions, seed: u64) -> Result<Self, Error> {
        options.check()?;
        check_seed(seed)?;
        let queries = draw_queries(task, options, seed)?;
        let task = task.with_queries(queries.clone())?;
        let ComparisonOptions { samples, k, rollouts, .. } = *options;
        let prm = PrmOptions {
            samples: Some(samples),
            k: Some(k),
            radius: Some(rollouts.longest_edge),
            ..PrmOptions::default()
        };
        let lazy_prm = LazyPrmOptions { samples: Some(samples), k, ..LazyPrmOptions::default() };
        let of = |planner: PlannerOptions| Options { seed, events: false, ..Options::new(planner) };
        let straight = |margin| {
            let grown = PlanningWorld::sharing(task.disc_scenario(margin)?, task.collision());
            run::start(&grown, of(prm.into()))
        };
        let [straight, with_margin] = [straight(0.0)?, straight(options.margin)?];
        let learned = roadmap::start(&task, policy, &rollouts, &of(lazy_prm.into()))?;
        Ok(Self {
            options: *options,
            seed,
            time_step: task.robot().time_step(),
            queries,
            roadmaps: [straight, with_margin, learned],
            executors: [Executor::new(&task, None)?, Executor::new(&task, Some(policy))?],
            paths: Default::default(),
            executions: Vec::new(),
            iterations: 0,
        })
    }

    /// The number of executions of the whole comparison.
    pub fn count(&self) -> usize {
        self.queries.len() * Method::ALL.len() * self.options.trials as usize
    }

    /// The queries.
    pub fn queries(&self) -> &[NavigationQuery] {
        &self.queries
    }

    /// The executions made so far: all methods of a query before the next query.
    pub fn executions(&self) -> &[Execution] {
        &self.executions
    }

    /// The next execution.
    fn execute(&mut self) {
        let (trials, number) = (self.options.trials as usize, self.executions.len());
        let (query, method) = (number / (Method::ALL.len() * trials), number / trials % Method::ALL.len());
        let method = Method::ALL[method];
        let NavigationQuery { start, goal, .. } = self.queries[query];
        let ends = [[start[0], start[1]], goal];
        if number.is_multiple_of(Method::ALL.len() * trials) {
            // Queries have room for all robots, so that each roadmap can be asked.
            self.paths = self.roadmaps.each_mut().map(|roadmap| {
                let asked = roadmap.query(&ends[0], &ends[1], false);
                asked.map_or_else(|_| Vec::new(), |result| result.path.iter().map(|q| [q[0], q[1]]).collect())
            });
        }
        let path = method.roadmap().map_or(&ends[..], |roadmap| &self.paths[roadmap]);
        let executor = &self.executors[usize::from(method.is_by_policy())];
        let drive = executor.drive(start, path, self.seed, number as u64).ok();
        self.executions.push(Execution {
            query,
            method,
            outcome: drive.as_ref().map(|drive| drive.outcome),
            length: drive.as_ref().map_or(0.0, Drive::length),
            time: drive.map_or(0.0, |drive| (drive.trace.len() - 1) as f64 * self.time_step),
        });
    }

    /// How each method did so far. Confidence intervals are of 95 %.
    pub fn summary(&self) -> Vec<MethodSummary> {
        let summary = |method: Method| {
            let own: Vec<&Execution> = self.executions.iter().filter(|execution| execution.method == method).collect();
            let is = |wanted: Option<Outcome>| {
                let sample: Vec<f64> = own.iter().map(|execution| f64::from(execution.outcome == wanted)).collect();
                share(&sample)
            };
            let reached = |value: fn(&Execution) -> f64| {
                let sample = own.iter().filter(|execution| execution.outcome == Some(Outcome::Reached));
                mean(&sample.map(|execution| value(execution)).collect::<Vec<_>>())
            };
            let firsts = own.iter().step_by(self.options.trials as usize);
            MethodSummary {
                method,
                reached: is(Some(Outcome::Reached)),
                collisions: is(Some(Outcome::Collision)),
                swings: is(Some(Outcome::Swing)),
                planned: share(&firsts.map(|execution| f64::from(execution.outcome.is_some())).collect::<Vec<_>>()),
                length: reached(|execution| execution.length),
                time: reached(|execution| execution.time),
            }
        };
        Method::ALL.map(summary).to_vec()
    }
}

/// How a method did in several comparisons.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodOverall {
    /// The method.
    pub method: Method,
    /// The share of executions that reached the goal, a value for each group of comparisons, with an interval over the groups.
    pub reached: Mean,
    /// The least of these shares.
    pub least: f64,
    /// The share of queries for which the roadmap has a path.
    pub planned: Mean,
}

/// The methods over groups of comparisons, such as those on one floor, each given by its summaries. Executions on one floor, or
/// along one roadmap, are alike: so intervals are over groups, not over executions.
pub fn overall(groups: &[Vec<Vec<MethodSummary>>]) -> Vec<MethodOverall> {
    let of = |method: Method| {
        let shares = |share: fn(&MethodSummary) -> Share| -> Vec<f64> {
            let own = |group: &Vec<Vec<MethodSummary>>| {
                let all = group.iter().flatten().filter(|summary| summary.method == method);
                mean(&all.map(|summary| share(summary).share.unwrap_or(f64::NAN)).collect::<Vec<_>>()).mean
            };
            groups.iter().map(|group| own(group).unwrap_or(f64::NAN)).collect()
        };
        let reached = shares(|summary| summary.reached);
        MethodOverall {
            method,
            reached: resampled(&reached),
            least: reached.iter().copied().fold(f64::NAN, f64::min),
            planned: resampled(&shares(|summary| summary.planned)),
        }
    };
    Method::ALL.map(of).to_vec()
}

/// Queries between configurations that are far apart.
fn draw_queries(task: &Navigation, options: &ComparisonOptions, seed: u64) -> Result<Vec<NavigationQuery>, Error> {
    let floor = task.floor();
    let no_room = || Error::new(Code::OutOfRange, "/robot/shape", "the floor has no room for the robot");
    let mut random = Random::new(seed, Stream::Tasks);
    let mut queries = Vec::with_capacity(options.queries);
    for _ in 0..10_000 {
        let ends = [(); 2].map(|()| episode::configuration(&floor, &mut random));
        let [Some(start), Some([x, y, _])] = ends else { return Err(no_room()) };
        let squared = (x - start[0]) * (x - start[0]) + (y - start[1]) * (y - start[1]);
        let has_room =
            [[start[0], start[1]], [x, y]].iter().all(|[x, y]| floor.has_room(Point::new(*x, *y), options.margin));
        if has_room && squared >= options.least_distance * options.least_distance {
            queries.push(NavigationQuery { name: format!("{}", queries.len() + 1), start, goal: [x, y] });
        }
        if queries.len() == options.queries {
            return Ok(queries);
        }
    }
    let sentence = format!("the floor has too few pairs of positions that are {} m apart", options.least_distance);
    Err(Error::new(Code::OutOfRange, "/least_distance", sentence))
}
