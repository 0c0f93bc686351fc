//! From a scenario and options to a run: names of robots and options become types.

use super::goals::goals;
use super::options::{SLOWEST, TURNING_RADII};
use super::reopen::{Changes, Kept};
use super::runner::{Reopen, RunInfo, Runner};
use super::{Options, Run};
use crate::collision::{Integration, JointLines};
use crate::error::{Code, Error, Number};
use crate::nearest::Neighbourhood;
use crate::options::Choice;
use crate::path::{LengthMeasure, Wanted};
use crate::planner::{
    self, ByControls, EdgeCheck, EdgeOptions, IntegrationKind, Limits, Overgrowth, Planner, PlannerOptions, Searching,
    Termination,
};
use crate::problem::{Estimate, GoalRegion, Problem, Sampled, Samples, Validity};
use crate::random::check_seed;
use crate::robot::{Arm, Car, Weights};
use crate::run::storage::{RoadmapDocument, RoadmapMetric, checked_states, fingerprint};
use crate::scenario::{GoalTolerance, Query, Robot, Scenario};
use crate::space::steering::Steering;
use crate::space::{MAX_DIMENSION, MetricKind, MotionSpace, ProductSpace, Space};
use crate::world::{PlanningWorld, SMALL};

/// Begins a run. The scenario may be given as it is, or prepared as a [`PlanningWorld`] that several runs share.
///
/// # Errors
/// `unknown-planner`, `unknown-query`, `unknown-parameter`, and the errors of parameter values, with a pointer into the
/// options; `start-in-collision` or `goal-in-collision` with a pointer into the scenario.
pub fn start(scenario: impl Into<PlanningWorld>, options: &Options) -> Result<Box<dyn Run>, Error> {
    let world = scenario.into();
    let planner = PlannerOptions::of(options.planner_for(world.scenario()))?;
    check_seed(options.seed)?;
    launch(&world, options, options.read(planner)?, None)
}

/// Begins a run of a planner on a problem that no scenario describes, in any [`Space`]. The result document names no scenario
/// and no query, and the planner `custom`. Improving the path draws from `seed`; the planner has generators of its own. A planner that
/// goes on to shorter paths ends as `termination` says.
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
    Box::new(Runner::new(problem, planner, info, None, None))
}

/// Begins a run of a planner on a problem whose motions are rolled out: neither proven nor sampled. `names` are those of the world and of
/// the query, for results.
pub(crate) fn start_learned<S: Space + 'static>(
    problem: Problem<S>,
    planner: PlannerOptions,
    seed: u64,
    [scenario, query]: [&str; 2],
) -> Result<Box<dyn Run>, Error> {
    let (scenario, query) = (scenario.to_owned(), query.to_owned());
    let measure = Some(LengthMeasure::Metres);
    let info = RunInfo { scenario, query, measure, is_learned: true, ..run_info(&planner, seed) };
    let planner = planner.begin(&problem, seed)?;
    Ok(Box::new(Runner::new(problem, planner, info, None, None)))
}

/// Begins a run of a planner, from nothing or with a saved roadmap.
pub(super) fn launch(
    world: &PlanningWorld,
    options: &Options,
    planner: PlannerOptions,
    saved: Option<&RoadmapDocument>,
) -> Result<Box<dyn Run>, Error> {
    let launch = Launch::new(world, options, planner, saved)?;
    if world.robot().dimension() <= SMALL { launch.run::<SMALL>(None) } else { launch.run::<MAX_DIMENSION>(None) }
}

/// Everything that a run is made from.
struct Launch<'a> {
    world: &'a PlanningWorld,
    options: &'a Options,
    planner: PlannerOptions,
    /// The options of its edges, if they are not controlled motions.
    edges: Option<EdgeOptions>,
    /// The metric that was requested.
    metric: Option<MetricKind>,
    info: RunInfo,
    /// The roadmap to continue with.
    saved: Option<&'a RoadmapDocument>,
    /// The query, and its index in the scenario.
    query: (usize, &'a Query),
    /// The goals, any of which may be reached: at least one; several only for arms.
    goals: Vec<Vec<f64>>,
}

impl<'a> Launch<'a> {
    fn new(
        world: &'a PlanningWorld,
        options: &'a Options,
        planner: PlannerOptions,
        saved: Option<&'a RoadmapDocument>,
    ) -> Result<Self, Error> {
        let scenario = world.scenario();
        let (index, query) = scenario.find_query(options.query.as_deref())?;
        planner.check_robot(scenario.robot().kind())?;
        // A path of controlled motions ends near its goal, never exactly there.
        let driving = planner.group::<ByControls>();
        if driving.is_some() && query.goal_tolerance.is_none() {
            let pointer = format!("/queries/{index}/goal_tolerance");
            return Err(Error::new(
                Code::MissingField,
                pointer,
                format!("{} needs a goal_tolerance in the query", planner.id()),
            ));
        }
        let edges = planner.group::<EdgeOptions>().copied();
        let info = RunInfo {
            scenario: scenario.name().to_owned(),
            query: query.name.clone(),
            ..run_info(&planner, options.seed)
        };
        if !matches!(scenario.robot(), Robot::Car(_))
            && let Some(steering) = edges.and_then(|edges| edges.steering)
        {
            let word = steering.word();
            let sentence = format!("only a car is steered: \"{word}\" is not for this robot");
            return Err(Error::new(Code::OutOfRange, "/steering", sentence));
        }
        if info.edge_check == EdgeCheck::JointLines && !matches!(scenario.robot(), Robot::Arm(_)) {
            let kind = scenario.robot().kind();
            let sentence = format!("only an arm has joints: \"joint-lines\" is not for the robot {kind}");
            return Err(Error::new(Code::OutOfRange, "/edge_check", sentence));
        }
        if info.wanted.blend > 0.0
            && (info.edge_check != EdgeCheck::Proven || matches!(scenario.robot(), Robot::Car(_)))
        {
            let sentence = "corners are rounded only between straight, proven motions: not those of a car, nor with another edge_check";
            return Err(Error::new(Code::Unsupported, "/blend", sentence));
        }
        let metric = edges.and_then(|edges| edges.measuring.metric);
        let info = RunInfo { measure: Some(LengthMeasure::of(scenario.robot(), metric)), ..info };
        let goals = goals(world, query, index, options.seed)?;
        Ok(Self { world, options, planner, edges, metric, info, saved, query: (index, query), goals })
    }

    /// The run over states of `N` numbers, with a roadmap of another world if one is kept.
    fn run<const N: usize>(mut self, kept: Option<Kept<MotionSpace<N>>>) -> Result<Box<dyn Run>, Error> {
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
            move || world.checker(&space, tolerance)
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

        let checked = {
            let (world, space) = (self.world.clone(), space.clone());
            let (check, samples) = (self.info.edge_check, self.edges.and_then(|edges| edges.samples()));
            move |proven: Box<dyn Validity<_>>| -> Box<dyn Validity<_>> {
                match (check, world.robot()) {
                    (EdgeCheck::Sampled | EdgeCheck::None, _) => {
                        Box::new(Sampled::new(space.clone(), proven, Samples::Count(samples.unwrap_or(0))))
                    }
                    (EdgeCheck::JointLines, Robot::Arm(arm)) => {
                        Box::new(JointLines::new(arm, space.product().clone(), world.collision().clone(), proven))
                    }
                    (EdgeCheck::Proven | EdgeCheck::JointLines, _) => proven,
                }
            }
        };
        let measure = space.clone();
        let end_effector: Estimate<_> = match robot {
            Robot::Arm(arm) => from_end_effector(arm, matches!(self.metric, None | Some(MetricKind::Sum))),
            _ => Box::new(move |a, b| measure.distance(a, b)),
        };
        let in_query = |error: Error| match error.code() {
            Code::StartInCollision | Code::GoalInCollision => error.under(&format!("/queries/{index}")),
            _ => error,
        };
        let mut problem = Problem::new(space.clone(), checked(validity), start, goals[0]).map_err(in_query)?;
        problem.add_goals(&goals[1..]);
        problem.end_effector = Some(end_effector);
        problem.goal_region = query
            .goal_tolerance
            .zip(robot.placed_shape())
            .map(|(region, (_, weights))| goal_region(product, goals[0], weights, region));
        problem.dynamics = dynamics;
        problem.records_events = self.options.events;

        let seed = self.info.seed;
        // A roadmap that is continued is searched for one path.
        let termination = self.info.termination.filter(|_| kept.is_none() && self.saved.is_none());
        let planner = match (kept, self.saved) {
            (Some(Kept { roadmap, changes: Changes { added, removed }, tolerance: before }), _) => {
                let may_meet = checker().may_meet();
                // A proof counts with a smaller slack, a refusal with the same tolerance.
                let is_rougher = tolerance.eta > before.eta;
                let is_other = (before.tau, before.bounds_tau) != (tolerance.tau, tolerance.bounds_tau);
                planner::reopen(&problem, roadmap, &|a, b| is_rougher || may_meet(a, b, &added), &|a, b| {
                    is_other || may_meet(a, b, &removed)
                })
            }
            (None, Some(document)) => {
                let states = checked_states(&space, &*checked(checker().finest().validity()), document)?;
                let connection = Neighbourhood::of(document.k as usize, document.radius);
                let searching = self.planner.group::<Searching>();
                let rules = searching.copied().unwrap_or_default();
                // A planner without a choice of searches is a lazy one.
                planner::resume(&problem, connection, rules, &states, &document.edges, searching.is_none())
            }
            (None, None) => self.planner.begin(&problem, seed)?,
        };
        let connection = planner.roadmap().map(|roadmap| roadmap.connection);
        let roadmap = connection.map(|connection| self.empty_document(&space, connection));
        #[cfg(feature = "parallel")]
        {
            problem.checkers = Some(Box::new(move || checked(fitted().validity())));
        }
        let reopen: Reopen<_> = {
            let (before, options, planner) = (self.world.clone(), self.options.clone(), self.planner);
            Box::new(move |world, roadmap| {
                let changes = Changes::between(before.scenario(), world.scenario())?;
                Launch::new(world, &options, planner, None)?.run(Some(Kept { roadmap, changes, tolerance }))
            })
        };
        let is_finite = self.info.is_finite || self.saved.is_some();
        let info = RunInfo { termination, is_finite, ..self.info };
        Ok(Box::new(Runner::new(problem, planner, info, roadmap, Some(reopen))))
    }

    /// The document of this run's roadmap, without vertices and edges.
    fn empty_document<const N: usize>(&self, space: &MotionSpace<N>, connection: Neighbourhood) -> RoadmapDocument {
        let scenario: &Scenario = self.world.scenario();
        let robot = scenario.robot();
        let metric = match (self.metric, space.steering()) {
            (_, Some((steering, radius))) => RoadmapMetric::of_curves(steering, radius),
            (None | Some(MetricKind::Sum), None) if matches!(robot, Robot::Arm(_)) => RoadmapMetric::Sum,
            (Some(MetricKind::Naive), None) => RoadmapMetric::Naive,
            (None | Some(MetricKind::Sum | MetricKind::Euclidean), None) => only_metric(robot),
        };
        RoadmapDocument {
            scenario: scenario.name().to_owned(),
            fingerprint: fingerprint(scenario),
            circles: (0..space.dimension()).map(|i| space.product().is_circle(i)).collect(),
            planner: self.info.planner.to_owned(),
            metric,
            k: connection.k() as u32,
            radius: connection.radius(),
            edge_check: self.info.edge_check,
            edge_samples: self.edges.and_then(|edges| edges.samples()),
            tolerance: self.info.limits.tolerance,
            vertices: Vec::new(),
            edges: Vec::new(),
        }
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
        if steering == Steering::Dubins && self.planner.needs_symmetry() {
            let id = self.info.planner;
            return Err(unsupported(&format!(
                "{id} requires a symmetric space, which dubins curves are not; use steering = reeds-shepp"
            )));
        }
        Ok(MotionSpace::steered(product, steering, radius))
    }
}

/// What a run copies from the options of its planner.
pub(super) fn run_info(planner: &PlannerOptions, seed: u64) -> RunInfo {
    let edges = planner.group::<EdgeOptions>().copied();
    let driving = planner.group::<ByControls>();
    RunInfo {
        planner: planner.id(),
        seed,
        limits: planner.group::<Limits>().copied().unwrap_or_default(),
        is_finite: planner.needed().is_some(),
        vertices: planner.group::<Overgrowth>().and_then(|growth| growth.vertices),
        wanted: edges.map_or_else(Wanted::default, |EdgeOptions { improving, .. }| Wanted {
            reduce: improving.reduce,
            shortcuts: improving.shortcut,
            partial_shortcuts: improving.partial_shortcut,
            blend: improving.blend,
        }),
        termination: planner.group::<Termination>().copied(),
        edge_check: edges.map_or(EdgeCheck::Proven, |edges| edges.edge_check),
        is_driven: driving.is_some(),
        is_euler: driving.is_some_and(|by| by.integration == IntegrationKind::Euler),
        ..RunInfo::default()
    }
}

/// The placements within the tolerance of the goal.
fn goal_region<const N: usize>(
    space: ProductSpace<N>,
    goal: [f64; N],
    weights: Weights,
    GoalTolerance { translation, rotation }: GoalTolerance,
) -> GoalRegion<[f64; N]> {
    let reach = weights.translation * translation + weights.rotation * rotation;
    let contains = move |q: &[f64; N]| {
        let gap = space.difference(q, &goal);
        (gap[0] * gap[0] + gap[1] * gap[1]).sqrt() <= translation && gap[2].abs() <= rotation
    };
    GoalRegion { contains: Box::new(contains), reach }
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
/// and at most the root of sum r_j^2 times the root of the sum of their squares (Cauchy and Schwarz).
fn from_end_effector<const N: usize>(arm: &Arm, is_sum: bool) -> Estimate<[f64; N]> {
    let arm = arm.clone();
    let (mut reach, mut squares) = (0.0, 0.0);
    for length in arm.links().iter().rev() {
        reach += length;
        squares += reach * reach;
    }
    let furthest = if is_sum { reach } else { f64::sqrt(squares) };
    Box::new(move |a, b| {
        let tip = |q: &[f64; N]| arm.end_effector(&q[..arm.links().len()]);
        (tip(a) - tip(b)).norm() / furthest
    })
}
