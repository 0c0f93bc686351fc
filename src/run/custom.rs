//! Custom robots: a space, described as a product of circles, intervals and lines, and a function that decides what is free.
//!
//! The function evaluates configurations in batches, as rows of coordinates. There are two kinds ([`Free`]): a lower bound on
//! clearance, by which motions are proven ([`ClearanceValidity`]); or only whether a configuration is free, and then motions are
//! sampled ([`Sampled`]), and the result document says so.

use super::description::{SIZES, SpaceDescription};
use super::info::RunInfo;
use super::launch::Launch;
use super::questions::configuration;
use super::storage::{RoadmapDocument, RoadmapMetric, fingerprint_of_space};
use super::suitable::{OWN, at_resolution, check_use};
use super::{Options, Run};
use crate::error::{Code, Error, within};
use crate::path::LengthMeasure;
use crate::planner::{EdgeCheck, EdgeOptions, PlannerOptions};
use crate::problem::{ClearanceValidity, Evaluate, MaybeSend, MaybeSync, Problem, Sampled, Samples, Validity};
use crate::random::check_seed;
use crate::scenario::LARGEST;
use crate::space::{MAX_DIMENSION, MotionSpace, Space};
use crate::world::SMALL;
use std::sync::Arc;

/// The default resolution of sampled motions, as a fraction of the largest distance in the space.
const DEFAULT_RESOLUTION: f64 = 0.01;

/// What is free. A function is given any number of configurations as rows of coordinates, one after another, and writes one
/// number, or one answer, for each. Whatever error it returns, such as one with [`Code::CallbackFailed`], begins no run, or ends
/// it as `Failed`: see [`Run::failure`].
#[derive(Clone)]
#[non_exhaustive]
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
        /// The largest distance of neighbouring samples, in the metric, 1e-6 to 1e6; by default a hundredth of the largest
        /// distance in the space.
        resolution: Option<f64>,
    },
}

impl Free {
    /// By lower bounds on clearance in the metric of the space: 0 or less in collision, infinity where nothing is near. That a
    /// bound is too large cannot be noticed.
    pub fn by_clearance(
        clearance: impl Fn(&[f64], &mut [f64]) -> Result<(), Error> + MaybeSend + MaybeSync + 'static,
    ) -> Self {
        Self::Clearance { clearance: Arc::new(clearance), reach: None }
    }

    /// By lower bounds on clearance in the workspace.
    pub fn by_reach(
        reach: &[f64],
        clearance: impl Fn(&[f64], &mut [f64]) -> Result<(), Error> + MaybeSend + MaybeSync + 'static,
    ) -> Self {
        Self::Clearance { clearance: Arc::new(clearance), reach: Some(reach.to_vec()) }
    }

    /// By samples, at the default resolution if it is `None`.
    pub fn by_samples(
        resolution: Option<f64>,
        is_free: impl Fn(&[f64], &mut [bool]) -> Result<(), Error> + MaybeSend + MaybeSync + 'static,
    ) -> Self {
        let margin = move |rows: &[f64], margins: &mut [f64]| {
            let mut free = vec![false; margins.len()];
            is_free(rows, &mut free)?;
            let margin = |free| if free { f64::INFINITY } else { f64::NEG_INFINITY };
            margins.iter_mut().zip(free).for_each(|(to, free)| *to = margin(free));
            Ok(())
        };
        Self::Samples { margin: Arc::new(margin), resolution }
    }
}

/// A planning problem of a custom robot: see [`start_problem`].
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
                    within(format!("/reach/{i}"), "a reach", reach, 0.0..=LARGEST)?;
                }
            }
            Free::Samples { resolution: Some(resolution), .. } => {
                within("/resolution", "resolution", *resolution, SIZES)?;
            }
            Free::Clearance { reach: None, .. } | Free::Samples { resolution: None, .. } => {}
        }
        Ok(Self { space, free, start: start.to_vec(), goals: goals.to_vec() })
    }

    /// How many numbers a configuration has.
    pub fn dimension(&self) -> usize {
        self.space.coordinates.len()
    }

    /// The configuration a fraction `t` in [0, 1] along the motion from `a` to `b`: coordinates change evenly, circles the short
    /// way round.
    ///
    /// # Errors
    /// `wrong-dimension`, `not-finite` or `out-of-range`, with the pointer `/a`, `/b` or `/t`.
    pub fn interpolate(&self, a: &[f64], b: &[f64], t: f64) -> Result<Vec<f64>, Error> {
        let space: MotionSpace<MAX_DIMENSION> = self.space.read()?;
        let [a, b] =
            [configuration(&space, a, "configuration", "/a")?, configuration(&space, b, "configuration", "/b")?];
        let t = within("/t", "t", t, 0.0..=1.0)?;
        Ok(space.coordinates(&space.interpolate(&a, &b, t)).to_vec())
    }

    pub(super) fn space(&self) -> &SpaceDescription {
        &self.space
    }

    /// Whether motions are sampled at a resolution.
    pub(super) fn is_sampled(&self) -> bool {
        matches!(self.free, Free::Samples { .. })
    }
}

/// Begins a run on a problem of a custom robot. Every planner without controls serves
/// it. The result document names no scenario and no query. Planning uses one thread. If the function that decides what is free
/// fails, the run ends with its error: see [`Run::failure`].
///
/// [`path::verify`](crate::path::verify()) is for scenarios; check such a path by your function along
/// [`CustomProblem::interpolate`]. A roadmap can be queried again, and saved: [`resume_problem`](super::resume_problem) continues
/// with it.
///
/// # Errors
/// `not-finite` and `out-of-range` for values of options; `unsupported` and `out-of-range` for planners by controls and for
/// options of other robots; `start-in-collision`, or `goal-in-collision` with the pointer `/goals/i`; the error of the function.
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
pub fn start_problem(problem: &CustomProblem, options: impl Into<Options>) -> Result<Box<dyn Run>, Error> {
    let options = options.into();
    let planner = options.planner_for(None);
    check_seed(options.seed)?;
    planner.check()?;
    launch_problem(problem, &options, None)
}

/// Begins a run of a planner, from nothing or with a saved roadmap of the same space.
pub(super) fn launch_problem(
    problem: &CustomProblem,
    options: &Options,
    saved: Option<&RoadmapDocument>,
) -> Result<Box<dyn Run>, Error> {
    let unsupported = |pointer: &str, sentence: &str| Err(Error::new(Code::Unsupported, pointer, sentence));
    let planner = options.planner_for(None);
    check_use(&planner, OWN)?;
    if options.query.is_some() {
        return unsupported("/query", "a custom problem has no queries by name");
    }
    let edges = planner.group::<EdgeOptions>().copied().unwrap_or_default();
    let mut info = RunInfo { measure: Some(LengthMeasure::Space), ..RunInfo::of(&planner, options.seed) };
    if problem.is_sampled() {
        let standard = EdgeOptions::default();
        if (edges.edge_check, edges.edge_samples) != (standard.edge_check, standard.edge_samples) {
            return Err(at_resolution());
        }
        info.edge_check = EdgeCheck::Sampled;
    }
    match problem.dimension() {
        ..=SMALL => begin::<SMALL>(problem, options, planner, edges, info, saved),
        _ => begin::<MAX_DIMENSION>(problem, options, planner, edges, info, saved),
    }
}

/// The run over states of `N` numbers.
fn begin<const N: usize>(
    problem: &CustomProblem,
    options: &Options,
    planner: PlannerOptions,
    edges: EdgeOptions,
    mut info: RunInfo,
    saved: Option<&RoadmapDocument>,
) -> Result<Box<dyn Run>, Error> {
    let space: MotionSpace<N> = problem.space.read()?;
    let mut start = space.state(&problem.start);
    let mut goals: Vec<_> = problem.goals.iter().map(|goal| space.state(goal)).collect();
    let points = |tolerance: f64| {
        let (evaluate, reach) = match &problem.free {
            Free::Clearance { clearance, reach } => (clearance, reach.as_deref()),
            Free::Samples { margin, .. } => (margin, None),
        };
        ClearanceValidity::new(space.clone(), Arc::clone(evaluate), reach, tolerance)
    };
    let checked = |points: ClearanceValidity<_>| -> Box<dyn Validity<_>> {
        let samples = match (&problem.free, edges.edge_check) {
            (Free::Samples { resolution, .. }, _) => {
                Samples::Spacing(resolution.unwrap_or(DEFAULT_RESOLUTION * space.extent()))
            }
            (Free::Clearance { .. }, EdgeCheck::Proven | EdgeCheck::JointLines) => return Box::new(points),
            (Free::Clearance { .. }, EdgeCheck::Sampled | EdgeCheck::None) => {
                Samples::Count(edges.samples().unwrap_or(0))
            }
        };
        Box::new(Sampled::new(space.clone(), Box::new(points), samples))
    };
    let tolerance = edges.limits.tolerance;
    if let Some(most) = edges.limits.free_ends {
        info.move_ends(&space, &points(tolerance), &mut start, &mut goals, most);
    }
    let fitted = match problem.is_sampled() {
        true => points(tolerance),
        false => points(tolerance).fitted(&[&[start], &goals[..]].concat()),
    };
    let at_goal = |i: usize| {
        move |error: Error| match error.code() {
            Code::GoalInCollision => error.at(format!("/goals/{i}")),
            _ => error,
        }
    };
    let mut stated = Problem::new(space.clone(), checked(fitted), start, goals[0]).map_err(at_goal(0))?;
    for (i, goal) in goals.iter().enumerate().skip(1) {
        stated.check_ends(&start, goal).map_err(at_goal(i))?;
    }
    stated.add_goals(&goals[1..]);
    let measure = space.clone();
    stated.end_effector = Some(Box::new(move |a, b| measure.distance(a, b)));
    stated.records_events = options.events;
    let described = problem.space.in_full();
    let circles: Vec<bool> = (0..space.dimension()).map(|i| space.product().is_circle(i)).collect();
    let edge_samples = edges.samples().filter(|_| !problem.is_sampled());
    let (planner_id, edge_check) = (info.planner, info.edge_check);
    let roadmap = Box::new(move || RoadmapDocument {
        scenario: String::new(),
        fingerprint: fingerprint_of_space(&described),
        circles: circles.clone(),
        planner: planner_id.to_owned(),
        metric: RoadmapMetric::Space(described.clone()),
        k: 0,
        radius: f64::INFINITY,
        edge_check,
        edge_samples,
        tolerance,
        vertices: Vec::new(),
        edges: Vec::new(),
    });
    let launch = Launch { roadmap: Some(roadmap), ..Launch::new(stated, info) };
    match saved {
        None => launch.run(|problem, seed| planner.begin(problem, seed)),
        // What was proven with any tolerance is proven with the finest.
        Some(document) => launch.resume(document, &*checked(points(0.0)), &planner),
    }
}
