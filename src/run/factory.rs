//! From a scenario and options to a run: names of robots and options become types.

use super::goals::goals;
use super::info::{EmptyRoadmap, Reopen, RunInfo};
use super::launch::{Begin, Launch};
use super::options::{SLOWEST, TURNING_RADII};
use super::reopen::{Changes, Kept};
use super::suitable::check_use;
use super::{Options, Run};
use crate::collision::{Integration, JointLines, KeepAway};
use crate::error::{Code, Error, Number};
use crate::options::out_of_range;
use crate::path::{LengthMeasure, Wanted};
use crate::planner::{EdgeCheck, EdgeOptions, KeepingAway, Limits, Planner, PlannerOptions, Termination};
use crate::problem::{Estimate, GoalRegion, Problem, Sampled, Samples, Validity};
use crate::random::check_seed;
use crate::robot::{Arm, Car, Weights};
use crate::run::storage::{RoadmapDocument, RoadmapMetric, fingerprint};
use crate::scenario::{GoalTolerance, Query, Robot};
use crate::space::steering::Steering;
use crate::space::{MAX_DIMENSION, MetricKind, MotionSpace, ProductSpace, Space};
use crate::world::{PlanningWorld, SMALL};

/// The clearance from which nothing is added to lengths, if none is given, as a fraction of the world's longer side.
const DEFAULT_WITHIN: f64 = 0.05;

/// Begins a run, with options or a planner's alone. The scenario may be given as it is, or prepared as a [`PlanningWorld`] that
/// several runs share.
///
/// # Errors
/// `unknown-query`; `not-finite` and `out-of-range` for values of options, `unsupported` and `out-of-range` for options of other
/// robots, with a pointer into the options; `start-in-collision` or `goal-in-collision` with a pointer into the scenario.
///
/// # Example
/// ```
/// use planarium::run::{self, PrmOptions, Status};
/// use planarium::worlds::generate;
///
/// let scenario = generate("maze", &serde_json::json!({}))?;
/// let mut run = run::start(&scenario, PrmOptions { samples: Some(700), ..PrmOptions::default() })?;
/// assert_eq!(run.step(u64::MAX), Status::Solved);
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn start(scenario: impl Into<PlanningWorld>, options: impl Into<Options>) -> Result<Box<dyn Run>, Error> {
    let (world, options) = (scenario.into(), options.into());
    check_seed(options.seed)?;
    options.planner_for(Some(world.robot())).check()?;
    launch(&world, options, None)
}

/// Begins a run of a planner on a problem that no scenario describes, in any [`Space`]. The result document names no scenario and
/// no query, and the planner `custom`. Improving the path draws from `seed`; the planner has generators of its own. A planner
/// that goes on to shorter paths ends as `termination` says.
///
/// # Example
/// RRT-Connect in the unit square, around a disc, by samples of motions:
///
/// ```
/// use planarium::path::Wanted;
/// use planarium::planner::{Limits, PlannerOptions, RrtConnectOptions};
/// use planarium::problem::{Contact, Problem, Touched, Validity};
/// use planarium::run::{Status, start_on};
/// use planarium::space::ProductSpace;
///
/// struct Disc;
///
/// impl Validity<[f64; 2]> for Disc {
///     fn contacts(&self, [x, y]: &[f64; 2]) -> Vec<Contact> {
///         let is_free = (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) > 0.04;
///         if is_free { Vec::new() } else { vec![Contact { part: 0, with: Touched::Obstacle(0) }] }
///     }
///
///     fn is_motion_free(&self, a: &[f64; 2], b: &[f64; 2]) -> bool {
///         let at = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
///         (0..=100).all(|i| self.is_free(&at(f64::from(i) / 100.0)))
///     }
/// }
///
/// let space = ProductSpace::of_box(&[0.0, 0.0], &[1.0, 1.0]);
/// let problem = Problem::new(space, Box::new(Disc), [0.1, 0.1], [0.9, 0.9])?;
/// let planner = PlannerOptions::from(RrtConnectOptions::default()).begin(&problem, 7)?;
/// let mut run = start_on(problem, planner, Limits::default(), None, Wanted::default(), 7);
/// assert_eq!(run.step(u64::MAX), Status::Solved);
/// assert!(run.length() > 1.13);
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn start_on<S: Space + 'static>(
    problem: Problem<S>,
    planner: Box<dyn Planner<S>>,
    limits: Limits,
    termination: Option<Termination>,
    improvement: Wanted,
    seed: u64,
) -> Box<dyn Run> {
    let wanted = improvement;
    let info = RunInfo { planner: "custom", seed, limits, wanted, termination, ..RunInfo::default() };
    Launch::new(problem, info).with(planner)
}

/// Begins a run of a planner on a problem whose motions are rolled out: neither proven nor sampled. `names` are those of the
/// world and of the query, for results.
pub(crate) fn start_learned<S: Space + 'static>(
    problem: Problem<S>,
    planner: PlannerOptions,
    seed: u64,
    [scenario, query]: [&str; 2],
) -> Result<Box<dyn Run>, Error> {
    let (scenario, query) = (scenario.to_owned(), query.to_owned());
    let measure = Some(LengthMeasure::Metres);
    let info = RunInfo { scenario, query, measure, is_learned: true, ..RunInfo::of(&planner, seed) };
    let begun = planner.begin(&problem, seed)?;
    Ok(Launch::new(problem, info).with(begun))
}

/// Begins a run of a planner, from nothing or with a saved roadmap.
pub(super) fn launch(
    world: &PlanningWorld,
    options: Options,
    saved: Option<&RoadmapDocument>,
) -> Result<Box<dyn Run>, Error> {
    let setup = Setup::of(world, &options)?;
    let options = Box::new(options);
    if world.robot().dimension() <= SMALL {
        setup.run::<SMALL>(Source::Named(options, saved.map_or(Before::Nothing, Before::Saved)))
    } else {
        setup.run::<MAX_DIMENSION>(Source::Named(options, saved.map_or(Before::Nothing, Before::Saved)))
    }
}

/// The planner of a run over states of `N` numbers.
pub(super) enum Source<'a, const N: usize> {
    /// One of this crate.
    Named(Box<Options>, Before<'a, N>),
    /// One of the caller.
    Own(Box<Begin<'a, MotionSpace<N>>>),
}

/// What was built before a run begins.
pub(super) enum Before<'a, const N: usize> {
    /// Start and goals only.
    Nothing,
    /// A saved roadmap.
    Saved(&'a RoadmapDocument),
    /// The roadmap of a run in another world.
    Kept(Kept<'a, MotionSpace<N>>),
}

/// A collision checker over states of `N` numbers.
type Checker<const N: usize> = Box<dyn Validity<[f64; N]>>;

/// A scenario's robot, one of its queries, and what is wanted of the run.
pub(super) struct Setup<'a> {
    world: &'a PlanningWorld,
    /// The options of its edges, if they are not controlled motions.
    edges: Option<EdgeOptions>,
    /// The metric that was requested.
    metric: Option<MetricKind>,
    info: RunInfo,
    pub events: bool,
    /// Whether every motion must be possible in both directions.
    pub needs_symmetry: bool,
    /// The query, and its index in the scenario.
    query: (usize, &'a Query),
    /// The goals, any of which may be reached: at least one; several only for arms.
    goals: Vec<Vec<f64>>,
}

impl<'a> Setup<'a> {
    /// For a planner of this crate.
    fn of(world: &'a PlanningWorld, options: &Options) -> Result<Self, Error> {
        let query = world.scenario().find_query(options.query.as_deref())?;
        let planner = options.planner_for(Some(world.robot()));
        check_use(&planner, world.robot().kind())?;
        let edges = planner.group::<EdgeOptions>().copied();
        let setup = Self::new(world, RunInfo::of(&planner, options.seed), edges, query)?;
        Ok(Self { events: options.events, needs_symmetry: planner.needs_symmetry(), ..setup })
    }

    /// For any planner.
    pub fn new(
        world: &'a PlanningWorld,
        info: RunInfo,
        edges: Option<EdgeOptions>,
        (index, query): (usize, &'a Query),
    ) -> Result<Self, Error> {
        let scenario = world.scenario();
        // A path of controlled motions ends near its goal, never exactly there.
        if info.is_driven && query.goal_tolerance.is_none() {
            let sentence = format!("{} needs a goal_tolerance in the query", info.planner);
            return Err(Error::new(Code::MissingField, format!("/queries/{index}/goal_tolerance"), sentence));
        }
        let metric = edges.and_then(|edges| edges.measuring.metric);
        let goals = goals(world, query, index, info.seed)?;
        let keep_away = edges.map_or(Ok(None), |edges| keep_away(world, edges.keeping_away))?;
        let info = RunInfo {
            keep_away,
            scenario: scenario.name().to_owned(),
            query: query.name.clone(),
            measure: Some(LengthMeasure::of(scenario.robot(), metric)),
            margin: scenario.robot().margin(),
            ..info
        };
        let query = (index, query);
        Ok(Self { world, edges, metric, info, events: true, needs_symmetry: false, query, goals })
    }

    /// The run over states of `N` numbers.
    pub fn run<const N: usize>(mut self, source: Source<'_, N>) -> Result<Box<dyn Run>, Error> {
        let robot = self.world.robot();
        let product: ProductSpace<N> = self.world.space(self.metric)?;
        let space = match robot {
            Robot::Car(car) => self.car_space(car, product.clone())?,
            Robot::Arm(_) | Robot::Disc(_) | Robot::RigidBody(_) => MotionSpace::new(product.clone()),
        };
        let (index, query) = self.query;
        let mut start = space.state(&query.start);
        let mut goals: Vec<_> = self.goals.iter().map(|q| space.state(q)).collect();
        let checker = {
            let (world, space, tolerance) = (self.world.clone(), space.clone(), self.info.limits.tolerance);
            let keep_away = self.info.keep_away;
            move || world.checker(&space, tolerance).keeping_away(keep_away)
        };
        if let Some(most) = self.info.limits.free_ends {
            self.info.move_ends(&space, &*checker().validity(), &mut start, &mut goals, most);
        }
        let fitted = {
            let (checker, goals) = (checker.clone(), goals.clone());
            move || goals.iter().fold(checker(), |checker, goal| checker.fitted(&start, goal))
        };
        let integration = if self.info.is_euler { Integration::Euler } else { Integration::Exact };
        let first = fitted();
        let tolerance = first.tolerance();
        let (validity, dynamics) = first.with_dynamics(robot, integration);
        let checked = self.edge_checker(&space);
        let in_query = |error: Error| match error.code() {
            Code::StartInCollision | Code::GoalInCollision => error.under(&format!("/queries/{index}")),
            _ => error,
        };
        let mut problem = Problem::new(space.clone(), checked(validity), start, goals[0]).map_err(in_query)?;
        problem.add_goals(&goals[1..]);
        problem.end_effector = Some(self.estimate(&space));
        problem.goal_region = query.goal_tolerance.map(|region| match (robot, robot.placed_shape()) {
            (_, Some((_, weights))) => placed_region(product, goals[0], weights, region),
            (Robot::Arm(arm), _) => joint_region(product, goals[0], arm, region),
            _ => placed_region(product, goals[0], Weights { translation: 1.0, rotation: 1.0 }, region),
        });
        problem.ends_in_region = robot.placed_shape().is_none();
        problem.dynamics = dynamics;
        problem.records_events = self.events;
        #[cfg(feature = "parallel")]
        {
            let checked = checked.clone();
            problem.checkers = Some(Box::new(move || checked(fitted().validity())));
        }
        let roadmap = Some(self.empty_roadmap(&space));
        let own = self.world.clone();
        let launch = Launch { problem, info: self.info, roadmap, reopen: None };
        let (options, before) = match source {
            // The id of its planner is not one that a saved roadmap can be continued by.
            Source::Own(begin) => return Launch { roadmap: None, ..launch }.run(begin),
            Source::Named(options, before) => (options, before),
        };
        let planner = options.planner_for(Some(robot));
        let reopen: Reopen<_> = Box::new(move |world, roadmap| {
            let changes = Changes::between(own.scenario(), world.scenario())?;
            let kept = Kept { roadmap, changes, tolerance };
            Setup::of(world, &options)?.run(Source::Named(options.clone(), Before::Kept(kept)))
        });
        let mut launch = Launch { reopen: Some(reopen), ..launch };
        match before {
            Before::Kept(kept) => {
                // It is searched for one path.
                launch.info.termination = None;
                launch.run(|problem, _| Ok(kept.reopened(problem, tolerance, &*checker().may_meet())))
            }
            Before::Saved(document) => launch.resume(document, &*checked(checker().finest().validity()), &planner),
            Before::Nothing => launch.run(|problem, seed| planner.begin(problem, seed)),
        }
    }

    /// Makes the checker of edges from that which proves motions.
    fn edge_checker<const N: usize>(
        &self,
        space: &MotionSpace<N>,
    ) -> impl Fn(Checker<N>) -> Checker<N> + Clone + use<N> {
        let (world, space) = (self.world.clone(), space.clone());
        let (check, samples) = (self.info.edge_check, self.edges.and_then(|edges| edges.samples()));
        move |proven| match (check, world.robot()) {
            (EdgeCheck::Sampled | EdgeCheck::None, _) => {
                Box::new(Sampled::new(space.clone(), proven, Samples::Count(samples.unwrap_or(0))))
            }
            (EdgeCheck::JointLines, Robot::Arm(arm)) => {
                Box::new(JointLines::new(arm, space.product().clone(), world.collision().clone(), proven))
            }
            (EdgeCheck::Proven | EdgeCheck::JointLines, _) => proven,
        }
    }

    /// A lower bound on distances, by where the end effector of an arm is.
    fn estimate<const N: usize>(&self, space: &MotionSpace<N>) -> Estimate<[f64; N]> {
        let space = space.clone();
        match self.world.robot() {
            Robot::Arm(arm) => from_end_effector(arm, matches!(self.metric, None | Some(MetricKind::Sum))),
            _ => Box::new(move |a, b| space.distance(a, b)),
        }
    }

    /// The maker of the document of this run's roadmap, without vertices, edges, and how they were chosen.
    fn empty_roadmap<const N: usize>(&self, space: &MotionSpace<N>) -> EmptyRoadmap {
        let robot = self.world.robot();
        let metric = match (self.metric, space.steering()) {
            (_, Some((steering, radius))) => RoadmapMetric::of_curves(steering, radius),
            (None | Some(MetricKind::Sum), None) if matches!(robot, Robot::Arm(_)) => RoadmapMetric::Sum,
            (Some(MetricKind::Naive), None) => RoadmapMetric::Naive,
            (None | Some(MetricKind::Sum | MetricKind::Euclidean), None) => only_metric(robot),
        };
        let circles: Vec<bool> = (0..space.dimension()).map(|i| space.product().is_circle(i)).collect();
        let edge_samples = self.edges.and_then(|edges| edges.samples());
        let (world, planner, edge_check) = (self.world.clone(), self.info.planner, self.info.edge_check);
        let tolerance = self.info.limits.tolerance;
        Box::new(move || RoadmapDocument {
            scenario: world.scenario().name().to_owned(),
            fingerprint: fingerprint(world.scenario()),
            circles: circles.clone(),
            planner: planner.to_owned(),
            metric: metric.clone(),
            k: 0,
            radius: f64::INFINITY,
            edge_check,
            edge_samples,
            tolerance,
            vertices: Vec::new(),
            edges: Vec::new(),
        })
    }

    /// The space of a car: along the named curves or those that its speeds allow, or straight for a planner by controls.
    fn car_space<const N: usize>(&self, car: &Car, product: ProductSpace<N>) -> Result<MotionSpace<N>, Error> {
        let Some(edges) = &self.edges else { return Ok(MotionSpace::new(product)) };
        let unsupported = |sentence: &str| Error::new(Code::Unsupported, "/steering", sentence);
        let Some((radius, _)) = car.turning_radius() else {
            return Err(unsupported(
                "the car cannot steer both left and right, so curves cannot reach every placement",
            ));
        };
        if !TURNING_RADII.contains(&radius) {
            let [low, high] = [*TURNING_RADII.start(), *TURNING_RADII.end()].map(Number);
            let radius = Number(radius);
            return Err(unsupported(&format!(
                "a car's turning radius must lie within [{low}, {high}] m for curves, not {radius}"
            )));
        }
        let [backward, forward] = car.speed();
        let default = if backward < 0.0 { Steering::ReedsShepp } else { Steering::Dubins };
        let steering = edges.steering.unwrap_or(default);
        if forward <= 0.0 || (steering == Steering::ReedsShepp && backward >= 0.0) {
            return Err(unsupported(
                "the car's speed range does not allow these curves: dubins needs a positive speed, reeds-shepp also a negative one",
            ));
        }
        let used = if steering == Steering::Dubins { forward } else { forward.min(-backward) };
        if used < SLOWEST {
            let [used, slowest] = [used, SLOWEST].map(Number);
            return Err(unsupported(&format!("curves need a speed of at least {slowest} m/s, not {used}")));
        }
        if steering == Steering::Dubins && self.needs_symmetry {
            let id = self.info.planner;
            return Err(unsupported(&format!(
                "{id} requires a symmetric space, which dubins curves are not; use steering = reeds-shepp"
            )));
        }
        Ok(MotionSpace::steered(product, steering, radius))
    }
}

/// The placements, or the centres of a disc, within the tolerance of the goal.
fn placed_region<const N: usize>(
    space: ProductSpace<N>,
    goal: [f64; N],
    weights: Weights,
    GoalTolerance { translation, rotation }: GoalTolerance,
) -> GoalRegion<[f64; N]> {
    let reach = weights.translation * translation + weights.rotation * rotation;
    let turns = space.dimension() > 2;
    let contains = move |q: &[f64; N]| {
        let gap = space.difference(q, &goal);
        let is_near = (gap[0] * gap[0] + gap[1] * gap[1]).sqrt() <= translation;
        is_near && (!turns || gap[2].abs() <= rotation)
    };
    GoalRegion { contains: Box::new(contains), reach }
}

/// The configurations of an arm of which each joint is within its tolerance of the goal.
fn joint_region<const N: usize>(
    space: ProductSpace<N>,
    goal: [f64; N],
    arm: &Arm,
    GoalTolerance { translation, rotation }: GoalTolerance,
) -> GoalRegion<[f64; N]> {
    let mut most = [0.0; N];
    for (most, joint) in most.iter_mut().zip(arm.joint_types()) {
        *most = if joint.is_prismatic() { translation } else { rotation };
    }
    // No farther in either metric than the sum of all.
    let reach = most.iter().sum();
    let contains =
        move |q: &[f64; N]| space.difference(q, &goal).iter().zip(&most).all(|(gap, most)| gap.abs() <= *most);
    GoalRegion { contains: Box::new(contains), reach }
}

/// How a disc keeps away from the obstacles of a world; `None` if only lengths count.
///
/// # Errors
/// `out-of-range`, pointer `/clearance_within`, below a 2048th of the world's longer side.
fn keep_away(world: &PlanningWorld, options: KeepingAway) -> Result<Option<KeepAway>, Error> {
    let KeepingAway { clearance_weight: weight, clearance_within } = options;
    if weight == 0.0 {
        return Ok(None);
    }
    let side = world.bounds().longer_side();
    let (within, least) = (clearance_within.unwrap_or(DEFAULT_WITHIN * side), KeepAway::LEAST * side);
    if within < least {
        let least = Number(least);
        let sentence =
            format!("clearance_within must be at least {least}, a 2048th of the world's longer side, not {within}");
        return Err(out_of_range("clearance_within", sentence));
    }
    Ok(Some(KeepAway { weight, within }))
}

/// The metric of a robot that has only one and is not steered, as roadmaps name it.
pub(super) fn only_metric(robot: &Robot) -> RoadmapMetric {
    match robot.placed_shape() {
        Some((_, Weights { translation, rotation })) => RoadmapMetric::Placement { translation, rotation },
        None => RoadmapMetric::Euclidean,
    }
}

/// A lower bound on the distance of two configurations of the arm from those of the end effector: joint j turns what lies beyond
/// it, which reaches r_j at most, so the end effector moves at most sum r_j |turn j|, which is at most r_1 times their sum,
/// and at most the root of sum r_j^2 times the root of the sum of their squares (Cauchy and Schwarz). A prismatic joint moves the
/// end effector by as much as it slides: its r_j is 1.
fn from_end_effector<const N: usize>(arm: &Arm, is_sum: bool) -> Estimate<[f64; N]> {
    let arm = arm.clone();
    let (mut reach, mut most, mut squares) = (0.0, 0.0, 0.0);
    for (length, joint) in arm.longest().zip(arm.joint_types()).rev() {
        reach += length;
        let factor = if joint.is_prismatic() { 1.0 } else { reach };
        most = f64::max(most, factor);
        squares += factor * factor;
    }
    let furthest = if is_sum { most } else { f64::sqrt(squares) };
    Box::new(move |a, b| {
        let tip = |q: &[f64; N]| arm.end_effector(&q[..arm.links().len()]);
        (tip(a) - tip(b)).norm() / furthest
    })
}
