//! Robots of one's own: a space told as a product of circles, intervals and lines, and what is free told by a function.
//!
//! The function evaluates configurations in batches, as rows of coordinates. There are two kinds ([`Free`]): a lower bound on
//! clearance, by which motions are proven ([`ClearanceValidity`]); or only whether a configuration is free, and then motions are sampled
//! ([`Sampled`]), and the result document says so.

use super::factory::run_info;
use super::questions::configuration;
use super::runner::{RunInfo, Runner};
use super::{Options, Run};
use crate::error::{Code, Error, Number};
use crate::options::{Choice, out_of_range};
use crate::planner::{ByControls, EdgeCheck, EdgeOptions, Limits, PlannerOptions, default_planner};
use crate::problem::{ClearanceValidity, Evaluate, Problem, Sampled, Samples, Validity};
use crate::random::check_seed;
use crate::scenario::LARGEST;
use crate::space::{Coordinate, MAX_DIMENSION, Metric, MetricKind, MotionSpace, ProductSpace, Space};
use crate::world::SMALL;
use serde::Deserialize;
use std::rc::Rc;

/// The default resolution of sampled motions, as a fraction of the largest distance in the space.
const DEFAULT_RESOLUTION: f64 = 0.01;

/// The weights, reaches and resolutions that are read.
const SIZES: std::ops::RangeInclusive<f64> = 1e-6..=LARGEST;

/// The kind of a coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum CoordinateKind {
    /// An angle in (-pi, pi] that wraps.
    Circle,
    /// A number between two limits.
    Interval,
    /// A number without limits (but within 1e6 where it is given); samples are drawn between two numbers.
    Line,
}

/// A coordinate of a space: `low` and `high` are the limits of an interval, or the range that samples of a line are drawn from.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoordinateDescription {
    /// The kind.
    pub kind: CoordinateKind,
    /// The lower limit, at least -1e6; `None` for a circle.
    pub low: Option<f64>,
    /// The upper limit, more than `low`, at most 1e6; `None` for a circle.
    pub high: Option<f64>,
    /// By what differences are multiplied in the metric, 1e-6 to 1e6; 1 by default.
    pub weight: Option<f64>,
}

impl CoordinateDescription {
    /// An angle that wraps, in radians.
    pub fn circle() -> Self {
        Self { kind: CoordinateKind::Circle, low: None, high: None, weight: None }
    }

    /// A number between two limits.
    pub fn interval(low: f64, high: f64) -> Self {
        Self { kind: CoordinateKind::Interval, low: Some(low), high: Some(high), weight: None }
    }

    /// A number without limits, drawn between two numbers.
    pub fn line(low: f64, high: f64) -> Self {
        Self { kind: CoordinateKind::Line, ..Self::interval(low, high) }
    }

    /// The same with a weight.
    #[must_use]
    pub fn weighted(self, weight: f64) -> Self {
        Self { weight: Some(weight), ..self }
    }

    /// The coordinate and its weight.
    fn read(&self, pointer: &str) -> Result<(Coordinate, f64), Error> {
        let [low, high] = [("low", self.low), ("high", self.high)].map(|(name, limit)| {
            let pointer = format!("{pointer}/{name}");
            match (self.kind, limit) {
                (CoordinateKind::Circle, None) => Ok(0.0),
                (CoordinateKind::Circle, Some(_)) => {
                    Err(Error::new(Code::UnknownField, pointer, format!("a circle has no {name}")))
                }
                (_, None) => {
                    Err(Error::new(Code::MissingField, pointer, format!("the range of a coordinate needs {name}")))
                }
                (_, Some(limit)) => within(limit, -LARGEST..=LARGEST, name, pointer),
            }
        });
        let (low, high) = (low?, high?);
        if self.kind != CoordinateKind::Circle && low >= high {
            let sentence = format!("high must be greater than low {}, not {}", Number(low), Number(high));
            return Err(Error::new(Code::OutOfRange, format!("{pointer}/high"), sentence));
        }
        let weight = within(self.weight.unwrap_or(1.0), SIZES, "weight", format!("{pointer}/weight"))?;
        let coordinate = match self.kind {
            CoordinateKind::Circle => Coordinate::Circle,
            CoordinateKind::Interval => Coordinate::Interval { low, high },
            CoordinateKind::Line => Coordinate::Line { low, high },
        };
        Ok((coordinate, weight))
    }
}

/// A space as a product of coordinates.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpaceDescription {
    /// The coordinates, 1 to 8.
    pub coordinates: Vec<CoordinateDescription>,
    /// How their weighted differences combine; `euclidean` by default.
    pub metric: Option<MetricKind>,
}

impl SpaceDescription {
    fn read<const N: usize>(&self) -> Result<MotionSpace<N>, Error> {
        let count = self.coordinates.len();
        if !(1..=MAX_DIMENSION).contains(&count) {
            let sentence = format!("a space has 1 to {MAX_DIMENSION} coordinates, not {count}");
            return Err(Error::new(Code::OutOfRange, "/space/coordinates", sentence));
        }
        let read = |(i, one): (usize, &CoordinateDescription)| one.read(&format!("/space/coordinates/{i}"));
        let (coordinates, weights): (Vec<_>, Vec<_>) =
            self.coordinates.iter().enumerate().map(read).collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        let product = |metric| ProductSpace::new(&coordinates, metric).weighted(&weights);
        Ok(MotionSpace::new(match self.metric.unwrap_or(MetricKind::Euclidean) {
            MetricKind::Sum => product(Metric::Sum),
            MetricKind::Euclidean => product(Metric::Euclidean),
            MetricKind::Naive => product(Metric::Euclidean).cut_open(),
        }))
    }
}

/// Refuses a number outside its range.
fn within(value: f64, range: std::ops::RangeInclusive<f64>, name: &str, pointer: String) -> Result<f64, Error> {
    if range.contains(&value) {
        return Ok(value);
    }
    let code = if value.is_finite() { Code::OutOfRange } else { Code::NotFinite };
    let [low, high, value] = [*range.start(), *range.end(), value].map(Number);
    Err(Error::new(code, pointer, format!("{name} must lie within [{low}, {high}], not {value}")))
}

/// What is free.
#[derive(Clone)]
pub enum Free {
    /// By a lower bound on the clearance of each configuration: motions are proven.
    Clearance {
        /// Writes the bounds: 0 or less in collision.
        clearance: Evaluate,
        /// How far any point of the robot moves at most per unit of each coordinate, 0 to 1e6, if clearances are distances in the
        /// workspace; `None` if they are distances in the metric of the space.
        reach: Option<Vec<f64>>,
    },
    /// By whether each configuration is free: motions are sampled, and nothing is proven.
    Samples {
        /// Writes an infinite number for a configuration that is free, a negative one for one in collision.
        margin: Evaluate,
        /// The largest distance of neighbouring samples, in the metric, 1e-6 to 1e6; by default a hundredth of the largest distance in the
        /// space.
        resolution: Option<f64>,
    },
}

impl Free {
    /// By lower bounds on clearance in the metric of the space.
    pub fn by_clearance(clearance: impl Fn(&[f64], &mut [f64]) -> Result<(), Error> + 'static) -> Self {
        Self::Clearance { clearance: Rc::new(clearance), reach: None }
    }

    /// By lower bounds on clearance in the workspace.
    pub fn by_reach(reach: &[f64], clearance: impl Fn(&[f64], &mut [f64]) -> Result<(), Error> + 'static) -> Self {
        Self::Clearance { clearance: Rc::new(clearance), reach: Some(reach.to_vec()) }
    }

    /// By samples, at the default resolution if it is `None`.
    pub fn by_samples(
        resolution: Option<f64>,
        is_free: impl Fn(&[f64], &mut [bool]) -> Result<(), Error> + 'static,
    ) -> Self {
        let margin = move |rows: &[f64], margins: &mut [f64]| {
            let mut free = vec![false; margins.len()];
            is_free(rows, &mut free)?;
            let margin = |free| if free { f64::INFINITY } else { f64::NEG_INFINITY };
            margins.iter_mut().zip(free).for_each(|(to, free)| *to = margin(free));
            Ok(())
        };
        Self::Samples { margin: Rc::new(margin), resolution }
    }
}

/// A planning problem of a robot of one's own: see [`start_problem`].
#[derive(Clone)]
pub struct CustomProblem {
    space: SpaceDescription,
    free: Free,
    start: Vec<f64>,
    goals: Vec<Vec<f64>>,
}

impl CustomProblem {
    /// The problem of moving from `start` to one of `goals`. What is free is not evaluated yet.
    ///
    /// # Errors
    /// With the pointer of the offending value, in `/space`, `/start`, `/goals`, `/reach` or `/resolution`: `wrong-dimension`,
    /// `not-finite`, `out-of-range`, `missing-field`, `unknown-field`.
    pub fn new(space: SpaceDescription, free: Free, start: &[f64], goals: &[Vec<f64>]) -> Result<Self, Error> {
        let states: MotionSpace<MAX_DIMENSION> = space.read()?;
        configuration(&states, start, "start", "/start")?;
        if goals.is_empty() {
            return Err(Error::new(Code::OutOfRange, "/goals", "there must be at least one goal"));
        }
        for (i, goal) in goals.iter().enumerate() {
            configuration(&states, goal, "goal", &format!("/goals/{i}"))?;
        }
        match &free {
            Free::Clearance { reach: Some(reach), .. } => {
                if reach.len() != states.dimension() {
                    let sentence = format!("reach must have {} numbers, not {}", states.dimension(), reach.len());
                    return Err(Error::new(Code::WrongDimension, "/reach", sentence));
                }
                for (i, &reach) in reach.iter().enumerate() {
                    within(reach, 0.0..=LARGEST, "a reach", format!("/reach/{i}"))?;
                }
            }
            Free::Samples { resolution: Some(resolution), .. } => {
                within(*resolution, SIZES, "resolution", "/resolution".to_owned())?;
            }
            Free::Clearance { reach: None, .. } | Free::Samples { resolution: None, .. } => {}
        }
        Ok(Self { space, free, start: start.to_vec(), goals: goals.to_vec() })
    }

    /// How many numbers a configuration has.
    pub fn dimension(&self) -> usize {
        self.space.coordinates.len()
    }
}

/// Begins a run on a problem of a robot of one's own, by a planner and its options by name. Every planner without controls serves it. The
/// result document names no scenario and no query. Planning uses one thread. If the function that tells what is free fails, the run
/// ends with its error: see [`Run::failure`].
///
/// A roadmap can be queried again, but not saved: no document describes what it was built in.
///
/// # Errors
/// `unknown-planner`, `unknown-parameter`, and the errors of parameter values; `unsupported` for planners by controls and for options of
/// other robots; `start-in-collision`, or `goal-in-collision` with the pointer `/goals/i`; the error of the function.
///
/// # Example
/// A point in the plane, around a disc:
///
/// ```
/// use planarium::run::{self, CoordinateDescription, CustomProblem, Free, Options, SpaceDescription, Status};
///
/// let side = CoordinateDescription::interval(-2.0, 2.0);
/// let space = SpaceDescription { coordinates: vec![side, side], metric: None };
/// let free = Free::by_clearance(|rows, clearances| {
///     for (q, clearance) in rows.chunks(2).zip(clearances) {
///         *clearance = (q[0] * q[0] + q[1] * q[1]).sqrt() - 1.0;
///     }
///     Ok(())
/// });
/// let problem = CustomProblem::new(space, free, &[-1.5, 0.0], &[vec![1.5, 0.0]])?;
/// let mut run = run::start_problem(&problem, &Options { seed: 1, ..Options::default() })?;
/// assert_eq!(run.step(10_000), Status::Solved);
/// assert!(run.length() > 3.0);
/// # Ok::<(), planarium::Error>(())
/// ```
pub fn start_problem(problem: &CustomProblem, options: &Options) -> Result<Box<dyn Run>, Error> {
    let planner = PlannerOptions::of(options.planner.as_deref().unwrap_or(default_planner("")))?;
    check_seed(options.seed)?;
    let planner = planner.read(&options.parameters)?;
    let unsupported = |pointer: &str, sentence: &str| Err(Error::new(Code::Unsupported, pointer, sentence));
    if planner.group::<ByControls>().is_some() {
        let sentence = format!("{} plans for cars, not for robots of one's own", planner.info().id);
        return unsupported("/algorithm", &sentence);
    }
    if options.query.is_some() {
        return unsupported("/query", "a problem of one's own has no queries by name");
    }
    let edges = planner.group::<EdgeOptions>().copied().unwrap_or_default();
    if edges.measuring.metric.is_some() {
        return Err(out_of_range("metric", "the metric is that of the problem's space"));
    }
    if let Some(steering) = edges.steering {
        let sentence = format!("only a car is steered: \"{}\" is not for this robot", steering.word());
        return Err(out_of_range("steering", sentence));
    }
    if edges.edge_check == EdgeCheck::JointLines {
        return Err(out_of_range("edge_check", "\"joint-lines\" is for arms among polygons and discs"));
    }
    let is_given = |name: &str| options.parameters.iter().any(|(given, _)| given == name);
    let mut info = run_info(&planner, options.seed);
    if matches!(problem.free, Free::Samples { .. }) {
        if is_given("edge_check") || is_given("edge_samples") {
            return unsupported("/edge_check", "edges are sampled at the resolution of the problem");
        }
        info.edge_check = EdgeCheck::Sampled;
    }
    if info.wanted.blend > 0.0 {
        return unsupported("/blend", "corners are rounded only for the robots of scenarios");
    }
    match problem.dimension() {
        ..=SMALL => begin::<SMALL>(problem, options, planner, edges, info),
        _ => begin::<MAX_DIMENSION>(problem, options, planner, edges, info),
    }
}

/// The run over states of `N` numbers.
fn begin<const N: usize>(
    problem: &CustomProblem,
    options: &Options,
    planner: PlannerOptions,
    edges: EdgeOptions,
    info: RunInfo,
) -> Result<Box<dyn Run>, Error> {
    let space: MotionSpace<N> = problem.space.read()?;
    let start = space.state(&problem.start);
    let goals: Vec<_> = problem.goals.iter().map(|goal| space.state(goal)).collect();
    let Limits { tolerance, .. } = edges.limits;
    let validity = |evaluate: &Evaluate, reach: Option<&[f64]>| {
        ClearanceValidity::new(space.clone(), Rc::clone(evaluate), reach, tolerance)
    };
    let sampled = |points: ClearanceValidity<_>, samples| -> Box<dyn Validity<_>> {
        Box::new(Sampled::new(space.clone(), Box::new(points), samples))
    };
    let validity = match &problem.free {
        Free::Clearance { clearance, reach } => {
            let proven = validity(clearance, reach.as_deref()).fitted(&[&[start], &goals[..]].concat());
            match edges.edge_check {
                EdgeCheck::Proven | EdgeCheck::JointLines => Box::new(proven),
                EdgeCheck::Sampled | EdgeCheck::None => sampled(proven, Samples::Count(edges.samples().unwrap_or(0))),
            }
        }
        Free::Samples { margin, resolution } => {
            let spacing = resolution.unwrap_or(DEFAULT_RESOLUTION * space.extent());
            sampled(validity(margin, None), Samples::Spacing(spacing))
        }
    };
    let at_goal = |i: usize| {
        move |error: Error| match error.code() {
            Code::GoalInCollision => Error::new(error.code(), format!("/goals/{i}"), error.message()),
            _ => error,
        }
    };
    let mut stated = Problem::new(space.clone(), validity, start, goals[0]).map_err(at_goal(0))?;
    for (i, goal) in goals.iter().enumerate().skip(1) {
        stated.check_ends(&start, goal).map_err(at_goal(i))?;
    }
    stated.add_goals(&goals[1..]);
    let measure = space;
    stated.end_effector = Some(Box::new(move |a, b| measure.distance(a, b)));
    stated.records_events = options.events;
    let planner = planner.begin(&stated, info.seed)?;
    Ok(Box::new(Runner::new(stated, planner, info, None, None)))
}
