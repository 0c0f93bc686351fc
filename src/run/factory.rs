//! From a scenario and options to a run: where the names of robots become types.

use super::goals::goals;
use super::runner::{Runner, Ticket};
use super::{Options, Run};
use super::{choices, resume};
use crate::collision::{
    ArmValidity, BodyCollision, BodyValidity, DiscValidity, Driving, Integration, Sampled, joint_space, placements,
    plane,
};
use crate::control::Dynamics;
use crate::decimal::Decimal;
use crate::error::{Code, Error};
use crate::kept::{RoadmapDocument, curve_metric, fingerprint, placement_metric};
use crate::path::Wanted;
use crate::planner::{Connection, Parameters, PlannerInfo, planner_info};
use crate::problem::{Estimate, GoalRegion, Problem};
use crate::robot::{Arm, Car, DiscRobot, Weights};
use crate::scenario::{GoalTolerance, Robot, Scenario};
use crate::space::{MAX_DIMENSION, Metric, MotionSpace, Space, Torus};
use crate::steering::Steering;
use crate::validity::Validity;
use std::rc::Rc;

/// The smaller size of states: most robots have no more coordinates. In WebAssembly one size serves all, which costs a tenth
/// of the speed and saves a tenth of the module.
const SMALL: usize = if cfg!(target_arch = "wasm32") { MAX_DIMENSION } else { 4 };

/// The turning radii of steered cars, in metres: wide of all worlds on either side. Beyond, lengths and durations of curves might
/// overflow.
const TURNING_RADII: std::ops::RangeInclusive<f64> = 1e-9..=1e9;
/// The slowest that a steered car may be at its fastest, in metres a second, for the same reason.
const SLOWEST: f64 = 1e-9;

/// Begins a run.
///
/// # Errors
/// `unknown-planner`, `unknown-query`, `unknown-parameter`, and the errors of parameter values, with a pointer into the
/// options; `start-in-collision` or `goal-in-collision` with a pointer into the scenario.
pub fn start(scenario: &Scenario, options: &Options) -> Result<Box<dyn Run>, Error> {
    let info = planner_info(options.planner_for(scenario))?;
    options.check_seed()?;
    launch(scenario, options, info, Parameters::resolve(info.parameters, &options.parameters)?, None)
}

/// Begins a run of a planner, from nothing or with a roadmap that was kept.
pub(super) fn launch(
    scenario: &Scenario,
    options: &Options,
    info: &'static PlannerInfo,
    parameters: Parameters,
    kept: Option<&RoadmapDocument>,
) -> Result<Box<dyn Run>, Error> {
    let (place, query) = options.find_query(scenario)?;
    info.check_robot(scenario.robot().kind())?;
    let has = |name: &str| parameters.has(name);
    // What is driven ends near its goal, never there.
    if has("duration_steps") && query.goal_tolerance.is_none() {
        let pointer = format!("/queries/{place}/goal_tolerance");
        return Err(Error::new(
            Code::MissingField,
            pointer,
            format!("{} needs a goal_tolerance in the query", info.id),
        ));
    }
    let ticket = Ticket {
        scenario: scenario.name().to_owned(),
        query: query.name.clone(),
        planner: info.id,
        seed: options.seed,
        max_iterations: parameters.integer("max_iterations") as u32,
        wanted: if has("reduce") { wanted(&parameters) } else { Wanted::default() },
        is_sampled: parameters.text("edge_check") == Some("sampled"),
        is_steered: has("steering"),
        is_euler: has("integration") && parameters.text("integration") == Some("euler"),
    };
    if has("steering")
        && !matches!(scenario.robot(), Robot::Car(_))
        && let Some(word) = parameters.text("steering")
    {
        let sentence = format!("only a car is steered: \"{word}\" is not for this robot");
        return Err(Error::new(Code::OutOfRange, "/steering", sentence));
    }
    let launch = Launch {
        scenario,
        parameters,
        ticket,
        kept,
        steering: None,
        start: &query.start,
        goals: goals(scenario, query, place, options.seed)?,
        goal_tolerance: query.goal_tolerance,
    };
    // Entries past the dimension are 0 and change no bit: two sizes at most serve every robot.
    let run = match scenario.robot() {
        Robot::Arm(arm) if arm.links().len() <= SMALL => launch.arm::<SMALL>(arm),
        Robot::Arm(arm) => launch.arm::<MAX_DIMENSION>(arm),
        Robot::Disc(disc) => launch.disc(disc),
        robot @ (Robot::RigidBody(_) | Robot::Car(_)) => launch.placed(robot),
    };
    let in_query = |error: &Error| matches!(error.code(), Code::StartInCollision | Code::GoalInCollision);
    run.map_err(|error| if in_query(&error) { error.under(&format!("/queries/{place}")) } else { error })
}

/// What is to be done to a path.
fn wanted(parameters: &Parameters) -> Wanted {
    Wanted {
        reduce: parameters.is_on("reduce"),
        shortcuts: parameters.integer("shortcut"),
        partial_shortcuts: parameters.integer("partial_shortcut"),
    }
}

/// All that a run is made from.
struct Launch<'a> {
    scenario: &'a Scenario,
    parameters: Parameters,
    ticket: Ticket,
    /// The roadmap to go on with.
    kept: Option<&'a RoadmapDocument>,
    /// How a car is steered, and its turning radius.
    steering: Option<(Steering, f64)>,
    start: &'a [f64],
    /// The configurations to reach any one of, one at least; several only of arms.
    goals: Vec<Vec<f64>>,
    goal_tolerance: Option<GoalTolerance>,
}

/// What a problem has beside space, validity and ends.
struct Extras<S> {
    end_effector: Estimate<S>,
    goal_region: Option<GoalRegion<S>>,
    dynamics: Option<Box<dyn Dynamics<S>>>,
    other_goals: Vec<S>,
}

impl<S> Extras<S> {
    /// Nothing but the estimate.
    fn of(end_effector: Estimate<S>) -> Self {
        Self { end_effector, goal_region: None, dynamics: None, other_goals: Vec::new() }
    }

    fn added_to<P: Space<State = S>>(self, mut problem: Problem<P>) -> Problem<P> {
        problem = problem.with_end_effector(self.end_effector).with_other_goals(self.other_goals);
        if let Some(region) = self.goal_region {
            problem = problem.with_goal_region(region);
        }
        if let Some(dynamics) = self.dynamics {
            problem = problem.with_dynamics(dynamics);
        }
        problem
    }
}

impl Launch<'_> {
    fn arm<const N: usize>(self, arm: &Arm) -> Result<Box<dyn Run>, Error> {
        let (metric, is_naive) = match self.parameters.text("metric") {
            Some("euclidean") => (Metric::Euclidean, false),
            Some("naive") => (Metric::Euclidean, true),
            _ => (Metric::Sum, false),
        };
        let space: Torus<N> = joint_space(arm, metric);
        let space = if is_naive { space.cut_open() } else { space };
        let start = space.state(self.start);
        let goals: Vec<_> = self.goals.iter().map(|q| space.state(q)).collect();
        let validity = || ArmValidity::new(arm, space.clone(), self.scenario.world(), self.tolerance());
        let proven = Box::new(goals.iter().fold(validity(), |validity, goal| validity.fitted(&start, goal)));
        let finest = self.kept.map(|_| -> Box<dyn Validity<_>> { Box::new(validity().finest()) });
        let estimate = from_end_effector(arm, metric);
        self.plan(
            MotionSpace::new(space),
            proven,
            finest,
            [start, goals[0]],
            Extras { other_goals: goals[1..].to_vec(), ..Extras::of(Box::new(move |a, b| estimate(a, b))) },
        )
    }

    fn placed(mut self, robot: &Robot) -> Result<Box<dyn Run>, Error> {
        if let Some(word) = self.parameters.text("metric") {
            let sentence = format!("the metric of a body is its scenario's, not \"{word}\"");
            return Err(Error::new(Code::OutOfRange, "/metric", sentence));
        }
        let (shape, weights) = robot.placed_shape().expect("a body has a shape");
        let world = self.scenario.world();
        let torus: Torus<SMALL> = placements(shape, weights, &world.bounds.expect("a body has bounds"));
        let space = match robot {
            Robot::Car(car) if self.ticket.is_steered => self.steered(car, torus.clone())?,
            _ => MotionSpace::new(torus.clone()),
        };
        self.steering = space.steering();
        let ends = self.ends().map(|q| space.state(q));
        let collision = || BodyCollision::new(shape, world, self.tolerance());
        let [start, goal] = ends.map(|q| [q[0], q[1], q[2]]);
        let fitted = Rc::new(collision().fitted(&start, &goal));
        let validity = |collision| -> Box<dyn Validity<_>> { Box::new(BodyValidity::new(space.clone(), collision)) };
        let proven = validity(Rc::clone(&fitted));
        let finest = self.kept.map(|_| validity(Rc::new(collision().finest())));
        let measure = space.clone();
        let end_effector: Estimate<_> = Box::new(move |a, b| measure.distance(a, b));
        let goal_region = self.goal_tolerance.map(|region| goal_region(torus.clone(), ends[1], weights, region));
        let dynamics = if let Robot::Car(car) = robot {
            let integration = if self.ticket.is_euler { Integration::Euler } else { Integration::Exact };
            Some(Box::new(Driving::new(car, space.clone(), fitted, integration)) as Box<dyn Dynamics<_>>)
        } else {
            None
        };
        self.plan(space, proven, finest, ends, Extras { end_effector, goal_region, dynamics, other_goals: Vec::new() })
    }

    /// The space of a car that follows the curves wanted.
    fn steered<const N: usize>(&self, car: &Car, torus: Torus<N>) -> Result<MotionSpace<N>, Error> {
        let unsupported = |sentence: &str| Error::new(Code::Unsupported, "/steering", sentence);
        let Some((radius, _)) = car.turning_radius() else {
            return Err(unsupported("the car cannot steer both ways, so that no curve leads everywhere"));
        };
        if !TURNING_RADII.contains(&radius) {
            let [low, high] = [*TURNING_RADII.start(), *TURNING_RADII.end()].map(Decimal);
            let radius = Decimal(radius);
            return Err(unsupported(&format!(
                "a car's turning radius must lie within [{low}, {high}] m for curves, not {radius}"
            )));
        }
        let [backward, forward] = car.speed();
        let steering = match self.parameters.text("steering") {
            Some("dubins") => Steering::Dubins,
            Some(_) => Steering::ReedsShepp,
            None if backward < 0.0 => Steering::ReedsShepp,
            None => Steering::Dubins,
        };
        if forward <= 0.0 || (steering == Steering::ReedsShepp && backward >= 0.0) {
            return Err(unsupported(
                "the car's speeds do not admit these curves: dubins goes forwards, reeds-shepp both ways",
            ));
        }
        let used = if steering == Steering::Dubins { forward } else { forward.min(-backward) };
        if used < SLOWEST {
            let [used, slowest] = [used, SLOWEST].map(Decimal);
            return Err(unsupported(&format!("curves are driven at {slowest} m/s at least, not {used}")));
        }
        if steering == Steering::Dubins && self.ticket.planner == "visibility-prm" {
            return Err(unsupported(
                "visibility is mutual, and a car on dubins curves cannot drive back; take reeds-shepp",
            ));
        }
        Ok(MotionSpace::steered(torus, steering, radius))
    }

    fn disc(self, disc: &DiscRobot) -> Result<Box<dyn Run>, Error> {
        if let Some(word @ ("sum" | "naive")) = self.parameters.text("metric") {
            let sentence = format!("the metric of a disc is always euclidean, not \"{word}\"");
            return Err(Error::new(Code::OutOfRange, "/metric", sentence));
        }
        let world = self.scenario.world();
        let bounds = world.bounds.expect("a disc has bounds");
        let space: Torus<SMALL> = plane(&bounds);
        let ends = self.ends().map(|q| space.state(q));
        let measure = space.clone();
        let proven = Box::new(DiscValidity::new(disc, world));
        let finest = self.kept.map(|_| -> Box<dyn Validity<_>> { Box::new(DiscValidity::new(disc, world)) });
        self.plan(
            MotionSpace::new(space),
            proven,
            finest,
            ends,
            Extras::of(Box::new(move |a, b| measure.distance(a, b))),
        )
    }

    /// Start and goal, of robots that have one goal.
    fn ends(&self) -> [&[f64]; 2] {
        [self.start, &self.goals[0]]
    }

    /// The wanted tolerance, as a fraction of the world's longer side.
    fn tolerance(&self) -> f64 {
        self.parameters.number("tolerance").expect("the tolerance has a fixed default")
    }

    /// The run in this space; `finest` proves again what is in the roadmap to go on with.
    fn plan<S: Space + Clone + 'static>(
        self,
        space: S,
        proven: Box<dyn Validity<S::State>>,
        finest: Option<Box<dyn Validity<S::State>>>,
        [start, goal]: [S::State; 2],
        extras: Extras<S::State>,
    ) -> Result<Box<dyn Run>, Error> {
        let places = self.ticket.is_sampled.then(|| self.parameters.integer("edge_samples") as u32);
        let checked = |proven: Box<dyn Validity<S::State>>| -> Box<dyn Validity<S::State>> {
            match places {
                Some(places) => Box::new(Sampled::new(space.clone(), proven, places)),
                None => proven,
            }
        };
        let problem = extras.added_to(Problem::new(space.clone(), checked(proven), start, goal)?);
        let seed = self.ticket.seed;
        let planner = match self.kept.zip(finest) {
            Some((document, finest)) => {
                let states = resume::prove(&space, &*checked(finest), document)?;
                choices::resumed(&self.parameters, &problem, seed, document, &states)
            }
            None => choices::planner(self.ticket.planner, &self.parameters, &problem, seed)?,
        };
        let circles = (0..space.dimension()).map(|i| space.period(i).is_finite()).collect();
        let kept = planner.connection().map(|connection| self.empty_document(connection, circles, places));
        Ok(Box::new(Runner::new(problem, planner, self.ticket, kept)))
    }

    /// How the roadmap of this run will be kept, without vertices and edges.
    fn empty_document(&self, connection: Connection, circles: Vec<bool>, edge_samples: Option<u32>) -> RoadmapDocument {
        let default = match (self.scenario.robot(), self.steering) {
            (_, Some((steering, radius))) => curve_metric(steering, radius),
            (Robot::Arm(_), None) => "sum".to_owned(),
            (robot, None) => only_metric(robot),
        };
        RoadmapDocument {
            scenario: self.scenario.name().to_owned(),
            fingerprint: fingerprint(self.scenario),
            circles,
            planner: self.ticket.planner.to_owned(),
            metric: self.parameters.text("metric").map_or(default, str::to_owned),
            k: connection.k as u32,
            radius: connection.radius,
            edge_samples,
            tolerance: self.tolerance(),
            vertices: Vec::new(),
            edges: Vec::new(),
        }
    }
}

/// The placements within the tolerance of the goal.
fn goal_region<const N: usize>(
    space: Torus<N>,
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

/// The metric of a robot that has only one and is not steered, as a roadmap is kept with it.
pub(super) fn only_metric(robot: &Robot) -> String {
    match robot.placed_shape() {
        Some((_, weights)) => placement_metric(weights.translation, weights.rotation),
        None => "euclidean".to_owned(),
    }
}

/// How far apart two configurations of the arm are at least, from where the end effector is: joint j turns what lies beyond
/// it, which reaches r_j at most, so the end effector moves at most sum r_j |turn j|, which is at most r_1 times their sum,
/// and at most the root of sum r_j^2 times the root of the sum of their squares (Cauchy and Schwarz).
fn from_end_effector<const N: usize>(arm: &Arm, metric: Metric) -> impl Fn(&[f64; N], &[f64; N]) -> f64 + use<N> {
    let arm = arm.clone();
    let (mut reach, mut squares) = (0.0, 0.0);
    for length in arm.links().iter().rev() {
        reach += length;
        squares += reach * reach;
    }
    let furthest = if metric == Metric::Sum { reach } else { f64::sqrt(squares) };
    move |a, b| {
        let tip = |q: &[f64; N]| arm.end_effector(&q[..arm.links().len()]);
        (tip(a) - tip(b)).norm() / furthest
    }
}
