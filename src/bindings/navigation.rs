//! Navigation for JavaScript: policies that are trained, roadmaps of what they drive reliably, and their executions.

use super::arguments::{cursor, document_tree, fields, row, rows, size, text};
use super::clock::{Timed, stepped};
use super::digits;
use super::planner;
use super::records::{object, record};
use super::types::{
    ComparisonOptions, ExecutionOptions, GenerateNavigationOptions, JsDemonstrations, JsEdgeRollouts, JsExecutions,
    JsMethodSummaries, JsNavigationDocument, JsNavigationQueries, JsNumber, JsPolicyDocument, NavigationGeneratorName,
    NavigationInput, PolicyInput, PolicyPlannerOptions, Rows, Status, TrainingOptions,
};
use crate::error::{Code, Error};
use crate::navigation::{self, Drive, Executor, Outcome, Policy};
use crate::options::Options;
use crate::problem::Stepped;
use crate::robot::Part;
use serde::Serialize;
use std::cell::RefCell;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// A navigation task: a floor, a robot with a range sensor and noise, and queries. `Navigation.parse` and
/// `Navigation.generate` make it.
#[wasm_bindgen]
pub struct Navigation(navigation::Navigation);

/// A robot that has driven.
#[derive(Serialize, Tsify)]
pub struct Execution {
    /// How it ended: `collision` if the next arc was not proven free, `swing` if the load would have swung too far.
    #[tsify(type = "DriveOutcome")]
    outcome: Outcome,
    /// The length of the trace, in metres.
    length: f64,
    /// How long it took, in seconds.
    time: f64,
    /// The configurations after each time step, from the start on: x, y, theta, one after the other.
    trace: Vec<f64>,
    /// The displacement of the load at each of them: x, y, one after the other; empty for a robot without a load.
    swing: Vec<f64>,
}

impl Execution {
    fn new(drive: &Drive, time_step: f64) -> Self {
        let time = (drive.trace.len() - 1) as f64 * time_step;
        Self {
            outcome: drive.outcome,
            length: drive.length(),
            time,
            trace: drive.trace.iter().flatten().copied().collect(),
            swing: drive.swing.iter().flatten().copied().collect(),
        }
    }
}

/// A drive of a policy in training.
#[derive(Serialize, Tsify)]
pub struct Demonstration {
    /// The number of the floor: see `training.floor`.
    floor: usize,
    /// The position to reach.
    goal: [f64; 2],
    /// What the robot did.
    #[serde(flatten)]
    drive: Execution,
}

fn policy(input: &PolicyInput) -> Result<Policy, Error> {
    Policy::read(&document_tree(input, "a policy")?)
}

/// The positions of a path, two numbers each.
fn positions(path: &Rows) -> Result<Vec<[f64; 2]>, Error> {
    Ok(rows(path, 2, "path")?.chunks_exact(2).map(|q| [q[0], q[1]]).collect())
}

#[wasm_bindgen]
impl Navigation {
    /// Reads the document of a task: JSON text, or the document as an object.
    /// @throws {PlanariumError} with a JSON pointer: `invalid-json`, `unknown-field`, `out-of-range`, `start-in-collision`,
    /// `goal-in-collision`, ...
    pub fn parse(input: &NavigationInput) -> Result<Navigation, Error> {
        navigation::Navigation::read(&document_tree(input, "a navigation task")?).map(Self)
    }

    /// Generates a task from a seed; the same generator, options and seed give the same task. `navigationGenerators()` lists the
    /// generators and their options.
    /// @throws {PlanariumError} `unknown-generator`, `unknown-field`, `out-of-range`, `wrong-type`, `not-finite`
    pub fn generate(
        kind: &NavigationGeneratorName,
        options: Option<GenerateNavigationOptions>,
    ) -> Result<Navigation, Error> {
        navigation::generate_with(&text(kind, "kind")?, &fields(options)?.parameters()).map(Self)
    }

    /// Begins to train a policy for this task's robot, on generated floors.
    /// @throws {PlanariumError} `unknown-parameter`, `out-of-range`, `wrong-type`, `not-finite`
    pub fn training(&self, options: Option<TrainingOptions>) -> Result<Training, Error> {
        let mut fields = fields(options)?;
        let seed = fields.take("seed")?.unwrap_or(0);
        let training = navigation::Training::new(&self.0, &Options::read(&fields.parameters())?, seed)?;
        let time_step = self.0.robot().time_step();
        Ok(Training(RefCell::new(Timed::new(training)), time_step))
    }

    /// Starts a planner whose edges are those that a policy drives reliably, by default `lazy-prm`; its results say `rollouts`.
    /// Vertices are positions: x and y.
    /// @throws {PlanariumError} `unknown-planner`, `unknown-query`, `unknown-parameter`, `out-of-range`, `wrong-type`;
    /// `unsupported` for planners by controls, and for a policy that senses in another way; `start-in-collision` if the robot
    /// cannot turn at the start
    pub fn planner(
        &self,
        policy_document: &PolicyInput,
        options: Option<PolicyPlannerOptions>,
    ) -> Result<planner::Planner, Error> {
        let (rollouts, options) = navigation::read_options(&fields(options)?.request()?)?;
        let policy = policy(policy_document)?;
        navigation::start(&self.0, &policy, &rollouts, &options).map(planner::Planner::new)
    }

    /// Starts a planner whose edges are straight and proven free for the disc in which the robot turns on the spot, by default
    /// `prm`: what a controller without a policy tracks. `margin` makes the disc larger, in metres.
    /// @throws {PlanariumError} as `planner`
    #[wasm_bindgen(js_name = straightPlanner)]
    pub fn straight_planner(&self, options: Option<PolicyPlannerOptions>) -> Result<planner::Planner, Error> {
        let mut fields = fields(options)?;
        let margin = fields.take("margin")?.unwrap_or(0.0);
        let mut request = fields.request()?;
        request.planner.get_or_insert_with(|| "prm".to_owned());
        let scenario = self.0.disc_scenario(margin)?;
        let options = request.for_robot(scenario.robot())?;
        crate::run::start(&scenario, &options).map(planner::Planner::new)
    }

    /// The rollouts along each step of a path of positions, as `planner` counts them with the same options.
    /// @throws {PlanariumError} `wrong-dimension`, `not-finite`, `unknown-parameter`, `out-of-range`, `unsupported`
    #[wasm_bindgen(js_name = edgeRollouts)]
    pub fn edge_rollouts(
        &self,
        policy_document: &PolicyInput,
        path: &Rows,
        options: Option<PolicyPlannerOptions>,
    ) -> Result<JsEdgeRollouts, Error> {
        let (rollouts, options) = navigation::read_options(&fields(options)?.request()?)?;
        let (policy, path) = (policy(policy_document)?, positions(path)?);
        let edges = navigation::edge_rollouts(&self.0, &policy, &rollouts, options.seed, &path)?;
        Ok(object(&edges).unchecked_into())
    }

    /// Drives along a path of positions with noise, from the start of a query: under a policy or, without one, under a controller
    /// that turns towards the next position and drives there. `trial` stands for one draw of all noise.
    /// @throws {PlanariumError} `unknown-query`, `out-of-range`, `wrong-dimension`, `not-finite`, `unsupported`, `unknown-field`
    pub fn execute(&self, path: &Rows, options: Option<ExecutionOptions>) -> Result<Ts<Execution>, Error> {
        let mut fields = fields(options)?;
        let policy = fields.take::<serde_json::Value>("policy")?;
        let policy = match policy {
            Some(serde_json::Value::String(text)) => {
                Some(Policy::parse(&text).map_err(|error| error.under("/policy"))?)
            }
            Some(tree) => Some(Policy::read(&tree).map_err(|error| error.under("/policy"))?),
            None => None,
        };
        let query: Option<String> = fields.take("query")?;
        let (seed, trial) = (fields.take("seed")?.unwrap_or(0), fields.take("trial")?.unwrap_or(0));
        fields.finish("policy, query, seed, trial")?;
        let (_, query) = self.0.find_query(query.as_deref())?;
        let drive = Executor::new(&self.0, policy.as_ref())?.drive(query.start, &positions(path)?, seed, trial)?;
        Ok(record(&Execution::new(&drive, self.0.robot().time_step())))
    }

    /// Begins to compare three ways to drive long ways on this floor: the policy alone, straight edges, and PRM-RL.
    /// @throws {PlanariumError} `unknown-parameter`, `out-of-range`, `wrong-type`, `not-finite`, `unsupported`
    pub fn comparison(
        &self,
        policy_document: &PolicyInput,
        options: Option<ComparisonOptions>,
    ) -> Result<NavigationComparison, Error> {
        let mut fields = fields(options)?;
        let seed = fields.take("seed")?.unwrap_or(0);
        let policy = policy(policy_document)?;
        let comparison = navigation::Comparison::new(&self.0, &policy, &Options::read(&fields.parameters())?, seed)?;
        Ok(NavigationComparison(RefCell::new(Timed::new(comparison))))
    }

    /// The distance that each ray of the sensor measures at a pose (x, y, theta), from right to left, in metres and without
    /// noise. A copy.
    /// @throws {PlanariumError} `wrong-dimension`, `not-finite`, `wrong-type`
    pub fn sense(&self, pose: &Rows) -> Result<Vec<f64>, Error> {
        let pose = row(pose, 3, "pose")?;
        Ok(self.0.sense([pose[0], pose[1], pose[2]]))
    }

    /// The part of the robot at a pose (x, y, theta), to draw; of a carrier of cargo without its load.
    /// @throws {PlanariumError} `wrong-dimension`, `not-finite`, `wrong-type`
    pub fn footprint(&self, pose: &Rows) -> Result<Ts<Part>, Error> {
        let pose = row(pose, 3, "pose")?;
        Ok(record(&self.0.footprint([pose[0], pose[1], pose[2]])))
    }
}

members! { Navigation(self): wasm_bindgen(getter);
    /// The name.
    name: String = self.0.name().to_owned();
    /// The title for people; the name if there is none.
    title: String = self.0.title().to_owned();
}

members! { Navigation(self): wasm_bindgen;
    /// The normalised document; `JSON.stringify(task)` writes it.
    toJSON: JsNavigationDocument = object(&self.0).unchecked_into();
}

/// The training of a policy by an evolution strategy, which is stepped; an iteration is one candidate of a generation. How
/// iterations are divided into steps does not change the result. Workers can share a generation: each has a training of its own
/// with the same options, evaluates some candidates by `returnsOf`, and all of them `advance` with all returns.
#[wasm_bindgen]
pub struct Training(RefCell<Timed<navigation::Training>>, f64);

stepped!(Training);

#[wasm_bindgen]
impl Training {
    /// The returns of candidates `first` to `end` - 1 of the present generation, and the share of tasks that each has solved:
    /// rows of two numbers. The training is unchanged. A copy.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`
    #[wasm_bindgen(js_name = returnsOf)]
    pub fn returns_of(&self, first: &JsNumber, end: &JsNumber) -> Result<Vec<f64>, Error> {
        let training = &self.0.borrow().run;
        let (first, end) = (size(first, "first")?, size(end, "end")?);
        for (name, value, most) in [("end", end, training.candidates()), ("first", first, end)] {
            if value > most {
                let sentence = format!("\"{name}\" must lie within [0, {most}], not {value}");
                return Err(Error::new(Code::OutOfRange, format!("/{name}"), sentence));
            }
        }
        Ok(training.returns_of(first..end).into_iter().flatten().collect())
    }

    /// Ends the present generation with the returns of all of its candidates, in their order.
    /// @throws {PlanariumError} `out-of-range` if there are fewer or more; `wrong-dimension`, `not-finite`, `wrong-type`
    pub fn advance(&self, returns: &Rows) -> Result<Status, Error> {
        let returns: Vec<[f64; 2]> = rows(returns, 2, "returns")?.chunks_exact(2).map(|row| [row[0], row[1]]).collect();
        self.0.borrow_mut().run.advance(&returns).map(Into::into)
    }

    /// Drives of the policy so far on `count` tasks, the same in every generation, to draw.
    /// @throws {PlanariumError} `out-of-range` for more than 1000, `wrong-type`, `not-finite`
    pub fn demonstrations(&self, count: &JsNumber) -> Result<JsDemonstrations, Error> {
        let count = cursor(count, 1000)?;
        let shown: Vec<Demonstration> = self
            .0
            .borrow()
            .run
            .demonstrations(count)
            .into_iter()
            .map(|(floor, goal, drive)| Demonstration { floor, goal, drive: Execution::new(&drive, self.1) })
            .collect();
        Ok(object(&shown).unchecked_into())
    }

    /// The task of a floor that the policy is trained on, by its number.
    /// @throws {PlanariumError} `out-of-range`, `wrong-type`, `not-finite`
    pub fn floor(&self, number: &JsNumber) -> Result<JsNavigationDocument, Error> {
        let training = &self.0.borrow().run;
        let number = size(number, "number")?;
        let Some(task) = training.floors().nth(number) else {
            let sentence = format!("there are {} floors, and none is number {number}", training.floors().len());
            return Err(Error::new(Code::OutOfRange, "/number", sentence));
        };
        Ok(object(task).unchecked_into())
    }
}

members! { Training(self): wasm_bindgen(getter);
    /// `running` until all generations are over, then `solved`.
    status: Status = self.0.borrow().run.status().into();
    /// The number of candidates evaluated so far.
    iterations: f64 = self.0.borrow().run.iterations() as f64;
    /// The number of candidates of a generation.
    candidates: usize = self.0.borrow().run.candidates();
    /// The number of generations that are over.
    generation: f64 = self.0.borrow().run.generation() as f64;
    /// The number of generations after which the training ends.
    generations: f64 = self.0.borrow().run.generations() as f64;
    /// The number of floors.
    floorCount: usize = self.0.borrow().run.floors().len();
    /// 16 hexadecimal digits over the weights after every generation.
    fingerprint: String = digits(self.0.borrow().run.fingerprint());
}

members! { Training(self): wasm_bindgen;
    /// The policy so far, as a document.
    policy: JsPolicyDocument = object(&self.0.borrow().run.policy()).unchecked_into();
}

tables! { Training(self, row)
    /// The generations from row `row` on, in rows of their mean return, the best return, and the share of tasks solved. A copy.
    historySince: Vec<f64> = self.0.borrow().run.history().len() => {
        self.0.borrow().run.history()[row..].iter().flat_map(|one| [one.mean, one.best, one.reached]).collect()
    };
}

/// A comparison of three ways to drive, which is stepped: an iteration is one of a roadmap's planner, or one execution.
#[wasm_bindgen]
pub struct NavigationComparison(RefCell<Timed<navigation::Comparison>>);

stepped!(NavigationComparison);

members! { NavigationComparison(self): wasm_bindgen(getter);
    /// `running` until all executions are made, then `solved`.
    status: Status = self.0.borrow().run.status().into();
    /// The number of iterations so far.
    iterations: f64 = self.0.borrow().run.iterations() as f64;
    /// The number of executions of the whole comparison.
    count: usize = self.0.borrow().run.count();
    /// The number of executions so far.
    executionCount: usize = self.0.borrow().run.executions().len();
}

members! { NavigationComparison(self): wasm_bindgen;
    /// How each method did so far, with intervals of 95 %.
    summary: JsMethodSummaries = object(&self.0.borrow().run.summary()).unchecked_into();
    /// The queries.
    queries: JsNavigationQueries = object(self.0.borrow().run.queries()).unchecked_into();
}

tables! { NavigationComparison(self, row)
    /// The executions from row `row` on. A copy.
    executionsSince: JsExecutions = self.0.borrow().run.executions().len() => {
        object(&self.0.borrow().run.executions()[row..]).unchecked_into()
    };
}
