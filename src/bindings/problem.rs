//! A problem of a custom robot, for JavaScript: a function of the caller decides what is free.

use super::arguments::{Fields, fields, finite, row, text_or_bytes};
use super::clock::Thrown;
use super::planner;
use super::types::{JsConfiguration, JsNumber, PlannerOptions, ProblemInput, ResumeOptions, RoadmapFile};
use crate::error::{Code, Error};
use crate::problem::Evaluate;
use crate::run::storage::RoadmapDocument;
use crate::run::{self, CustomProblem, Free, Request, Run, SpaceDescription};
use js_sys::Reflect;
use serde_json::Value as Json;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// A function of the caller's, wrapped by the package.
    #[derive(Clone)]
    type Function;

    /// Evaluates configurations: the addresses of rows and results in this memory, and how many there are of how many numbers.
    /// One crossing for a batch. Returns how the function has ended, as in `callback.js`: 0 after all results are written, 2 if
    /// it has thrown, 3 if a result is NaN.
    #[wasm_bindgen(method)]
    fn evaluate(this: &Function, rows: u32, results: u32, count: u32, dimension: u32) -> u32;

    /// What the function has thrown.
    #[wasm_bindgen(method, getter)]
    fn thrown(this: &Function) -> JsValue;
}

/// A planning problem of a custom robot: a space, described as a product of circles, intervals and lines, a start, goals,
/// and a function that decides what is free, for batches of configurations. By `clearance` edges are proven, by `isFree` they are
/// sampled, and the `edge_check` of results says so. Planners keep the functions until both they and the problem are freed.
#[wasm_bindgen]
pub struct Problem {
    space: SpaceDescription,
    start: Vec<f64>,
    goals: Vec<Vec<f64>>,
    /// Whether the description has a `goal`, not `goals`.
    has_one_goal: bool,
    function: Function,
    test: Test,
}

/// What the function computes.
#[derive(Clone)]
enum Test {
    Clearance { reach: Option<Vec<f64>> },
    Samples { resolution: Option<f64> },
}

#[wasm_bindgen]
impl Problem {
    /// Reads a problem. Its functions are not called yet.
    /// @throws {PlanariumError} with the pointer of the offending value: `missing-field`, `unknown-field`, `wrong-type`,
    /// `wrong-dimension`, `not-finite`, `out-of-range`
    #[wasm_bindgen(constructor)]
    pub fn new(problem: &ProblemInput) -> Result<Problem, Error> {
        let mut fields = fields(Some(problem))?;
        let space = fields.required("space", "{ coordinates, metric }")?;
        let start = fields.required("start", "a configuration")?;
        let (goal, goals) = (fields.take("goal")?, fields.take("goals")?);
        let has_one_goal = goals.is_none();
        let goals = match (goal, goals) {
            (Some(goal), None) => vec![goal],
            (None, Some(goals)) => goals,
            (None, None) => return Err(missing("goal", "a configuration; or goals, a list of them")),
            (Some(_), Some(_)) => return Err(twice("goals", "goal and goals are one and the same: give one of them")),
        };
        let functions = ["clearance", "isFree"].map(|name| function(problem, name));
        refuse_values(&mut fields)?;
        let (reach, resolution) = (fields.take("reach")?, fields.take("resolution")?);
        let (function, test) = match functions {
            [Some(clearance), None] if resolution.is_none() => (clearance, Test::Clearance { reach }),
            [None, Some(is_free)] if reach.is_none() => (is_free, Test::Samples { resolution }),
            [Some(_), None] => {
                return Err(useless("resolution", "resolution is for isFree: clearance proves whole motions"));
            }
            [None, Some(_)] => return Err(useless("reach", "reach is for clearance: isFree has no distances")),
            [None, None] => return Err(missing("clearance", "a function (rows, clearances); or isFree, (rows, free)")),
            [Some(_), Some(_)] => {
                return Err(twice("isFree", "give clearance or isFree, not both"));
            }
        };
        fields.finish("space, start, goal, goals, clearance, isFree, reach, resolution")?;
        let problem = Self { space, start, goals, has_one_goal, function, test };
        problem.custom(&Thrown::default()).map(|_| ()).map_err(|error| problem.at_goal(error))?;
        Ok(problem)
    }

    /// Starts a planner. It outlives the problem. Of the options, `tolerance` is a fraction of the largest distance in the space
    /// (by `reach`, of how far the robot can move); `metric`, `steering` and `blend` are for robots of scenarios.
    ///
    /// If a function throws, `step` throws the same, as does every later one, and the status is `failed`. A function may use
    /// other objects of the package, but not the planner that calls it.
    /// @throws {PlanariumError} `unknown-planner`, `unknown-parameter`, `out-of-range`, `wrong-type`; `unsupported` for planners
    /// by controls and options of other robots; `start-in-collision`, `goal-in-collision`; `not-finite` if a function has written
    /// no number; and what a function throws
    pub fn planner(&self, options: Option<PlannerOptions>) -> Result<planner::Planner, JsValue> {
        self.begin(options, |problem, request| run::start_problem(problem, &request.for_problem(problem)?))
    }

    /// Continues with a roadmap from `planner.roadmap("json")` or `planner.roadmap("binary")`, of this space: the function
    /// proves, or samples, all of it again, start and goals are connected to it, and it is searched. It does not grow. The
    /// function may be another one than that of the problem that it was built for, as long as all of it is free. Options are
    /// those of `scenario.resume`.
    /// @throws {PlanariumError} `other-scenario` if it belongs to another space (the pointer tells where it differs), or to a
    /// problem with `isFree` in place of `clearance` or the reverse; `invalid-roadmap` if it is damaged or not free;
    /// `out-of-range` and `unsupported` for options that contradict it; those of `planner`; and what a function throws
    pub fn resume(&self, roadmap: &RoadmapFile, options: Option<ResumeOptions>) -> Result<planner::Planner, JsValue> {
        let document = RoadmapDocument::read(&text_or_bytes(roadmap, "roadmap")?)?;
        self.begin(options, |problem, request| {
            run::resume_problem(problem, &request.for_roadmap_of(problem, &document)?, &document)
        })
    }

    /// The configuration at the fraction `t`, from 0 to 1, of the motion from `a` to `b`, as planners move: coordinates change
    /// evenly, circles the short way round. For drawing along a path.
    /// @throws {PlanariumError} `out-of-range`, `not-finite`, `wrong-dimension`, `wrong-type`
    pub fn interpolate(&self, a: &JsConfiguration, b: &JsConfiguration, t: &JsNumber) -> Result<Vec<f64>, Error> {
        let [a, b] = [row(a, self.dimension(), "a")?, row(b, self.dimension(), "b")?];
        self.custom(&Thrown::default())?.interpolate(&a, &b, finite(t, "t")?)
    }

    /// The degrees of freedom: the length of a configuration.
    #[wasm_bindgen(getter)]
    pub fn dimension(&self) -> usize {
        self.space.coordinates.len()
    }
}

impl Problem {
    /// Starts a planner.
    fn begin(
        &self,
        options: Option<impl AsRef<JsValue>>,
        begin: impl FnOnce(&CustomProblem, &Request) -> Result<Box<dyn Run>, Error>,
    ) -> Result<planner::Planner, JsValue> {
        let thrown = Thrown::default();
        let started = fields(options)
            .and_then(Fields::request)
            .and_then(|request| begin(&self.custom(&thrown)?, &request))
            .map_err(|error| thrown.or(self.at_goal(error)))?;
        Ok(planner::Planner::of(started, thrown))
    }

    /// The problem of one planner, which notes what its function throws.
    #[expect(clippy::arc_with_non_send_sync, reason = "a function of JavaScript stays on its thread")]
    fn custom(&self, thrown: &Thrown) -> Result<CustomProblem, Error> {
        let batches = Batches { function: self.function.clone(), dimension: self.dimension(), thrown: thrown.clone() };
        let free = match self.test.clone() {
            Test::Clearance { reach } => {
                let clearance: Evaluate = Arc::new(move |rows, results| batches.evaluate("clearance", rows, results));
                Free::Clearance { clearance, reach }
            }
            Test::Samples { resolution } => {
                let margin = move |rows: &[f64], results: &mut [f64]| {
                    batches.evaluate("isFree", rows, results)?;
                    for result in results {
                        *result = if *result == 0.0 { f64::NEG_INFINITY } else { f64::INFINITY };
                    }
                    Ok(())
                };
                Free::Samples { margin: Arc::new(margin), resolution }
            }
        };
        CustomProblem::new(self.space.clone(), free, &self.start, &self.goals)
    }

    /// The error with the pointer into the description.
    fn at_goal(&self, error: Error) -> Error {
        match error.pointer().strip_prefix("/goals/0") {
            Some(rest) if self.has_one_goal => {
                let pointer = format!("/goal{rest}");
                error.at(pointer)
            }
            _ => error,
        }
    }
}

/// A function of the description, which the package has put beside the copy of its fields.
fn function(problem: &JsValue, name: &str) -> Option<Function> {
    let functions = Reflect::get(problem, &"functions".into()).ok()?;
    let function = Reflect::get(&functions, &name.into()).ok()?;
    function.is_object().then(|| function.unchecked_into())
}

/// Refuses what should be a function and is a value.
fn refuse_values(fields: &mut Fields) -> Result<(), Error> {
    for (field, name) in [("clearance", "clearance"), ("is_free", "isFree")] {
        if let Some(value) = fields.take::<Json>(field)? {
            let sentence = format!("{name} must be a function, not {value}");
            return Err(Error::new(Code::WrongType, format!("/{name}"), sentence));
        }
    }
    Ok(())
}

fn missing(name: &str, meaning: &str) -> Error {
    Error::new(Code::MissingField, format!("/{name}"), format!("{name} is missing: {meaning}"))
}

fn twice(name: &str, sentence: &str) -> Error {
    Error::new(Code::DuplicateField, format!("/{name}"), sentence)
}

fn useless(name: &str, sentence: &str) -> Error {
    Error::new(Code::UnknownField, format!("/{name}"), sentence)
}

/// A function, as planners call it.
struct Batches {
    function: Function,
    dimension: usize,
    thrown: Thrown,
}

impl Batches {
    fn evaluate(&self, name: &str, rows: &[f64], results: &mut [f64]) -> Result<(), Error> {
        let (rows_at, results_at) = (rows.as_ptr() as u32, results.as_mut_ptr() as u32);
        match self.function.evaluate(rows_at, results_at, results.len() as u32, self.dimension as u32) {
            0 => {}
            2 => {
                self.thrown.note(self.function.thrown());
                let sentence = format!("{name} has thrown an exception");
                return Err(Error::new(Code::CallbackFailed, format!("/{name}"), sentence));
            }
            3 => {
                let i = results.iter().position(|result| result.is_nan()).unwrap_or_default();
                let q = &rows[i * self.dimension..][..self.dimension];
                let sentence =
                    format!("{name} must write a number for each configuration; for {q:?} it is NaN or none");
                return Err(Error::new(Code::NotFinite, format!("/{name}"), sentence));
            }
            _ => {
                let sentence = format!(
                    "{name} must write its results into its second argument before it returns, and return nothing"
                );
                return Err(Error::new(Code::WrongType, format!("/{name}"), sentence));
            }
        }
        Ok(())
    }
}
