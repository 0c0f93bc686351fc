//! Inverse kinematics for JavaScript.

use super::arguments::fields;
use super::clock::{Timed, stepped};
use super::digits;
use super::records::{object, record};
use super::scenario::Scenario;
use super::types::{JsVerdict, ReachOptions, Status};
use crate::Error;
use crate::geometry::Point;
use crate::ik::{MethodOptions, Solver, SolverOptions, SolverResult, Target};
use crate::problem::Stepped;
use std::cell::RefCell;
use tsify::Ts;
use wasm_bindgen::prelude::*;

/// A search for joint angles that bring the tip of an arm to a target; `scenario.reach` makes it. Each `step` makes some
/// iterations (an update of the joints, or the draw of a new start); how they are divided into steps does not change the result.
/// Iterates and solutions are only ever appended, and read by cursors.
#[wasm_bindgen]
pub struct Reach(RefCell<Timed<Solver>>);

#[wasm_bindgen]
impl Scenario {
    /// Starts a search for joint angles that bring the arm's tip to a target; `reachMethods()` lists the methods and their
    /// options. The run outlives the scenario.
    /// @throws {PlanariumError} `unsupported` for any robot but an arm, for an orientation of an arm of one link, and if there is
    /// no closed form; `missing-field` without a `target`; `out-of-range` for an unknown `method` and a `start` outside the
    /// limits; `unknown-parameter`, `wrong-dimension`, `wrong-type`, `not-finite`
    pub fn reach(&self, options: &ReachOptions) -> Result<Reach, Error> {
        let mut fields = fields(Some(options.clone()).filter(|options| !options.is_undefined()))?;
        let [x, y] = fields.required::<[f64; 2]>("target", "[x, y]")?;
        let method: Option<String> = fields.take("method")?;
        let options = SolverOptions {
            target: Target { point: Point::new(x, y), orientation: fields.take("orientation")? },
            start: fields.take("start")?,
            seed: fields.take("seed")?.unwrap_or(0),
            method: MethodOptions::read(method.as_deref(), &fields.parameters())?,
        };
        Solver::new(&self.world, &options).map(|solver| Reach(RefCell::new(Timed::new(solver))))
    }
}

stepped!(Reach);

members! { Reach(self): wasm_bindgen(getter);
    /// `solved` once as many distinct solutions are found as were requested, or any when the budget is spent.
    status: Status = self.0.borrow().run.status().into();
    /// The number of iterates.
    iterateCount: usize = self.0.borrow().run.iterates().len();
    /// The number of distinct solutions.
    solutionCount: usize = self.0.borrow().run.solutions().len();
    /// The number of configurations that reach the target in collision, with `freeOnly`; `result()` lists them.
    rejectedCount: usize = self.0.borrow().run.rejected().len();
    /// The number of iterations made so far.
    iterations: f64 = self.0.borrow().run.stats().iterations as f64;
    /// The number of starts drawn so far.
    restarts: u32 = self.0.borrow().run.stats().restarts;
    /// The error of the last iterate: metres of the point, or radians of the orientation, whichever is larger.
    error: f64 = self.0.borrow().run.error();
    /// Yoshikawa's manipulability at the last iterate, in square metres: 0 if the arm is singular.
    manipulability: f64 = self.0.borrow().run.manipulability();
}

members! { Reach(self): wasm_bindgen;
    /// The last iterate. A copy.
    configuration: Vec<f64> = {
        let solver = &self.0.borrow().run;
        solver.configuration()[..solver.dimension()].to_vec()
    };
    /// The outcome so far. If nothing has been found, this computes how near the arm can come: up to some milliseconds for eight
    /// links with limits.
    verdict: JsVerdict = object(&self.0.borrow().run.explain()).unchecked_into();
    /// The result document, the one that the command line prints.
    result: Ts<SolverResult> = record(&self.0.borrow().run.result());
    /// 16 hexadecimal digits over every iterate and solution.
    fingerprint: String = digits(self.0.borrow().run.fingerprint());
}

tables! { Reach(self, row)
    /// The iterates from row `row` (0 to `iterateCount`) on, the start and one after each iteration, in rows of restart (the
    /// number of starts drawn before), error, and configuration. A copy.
    iteratesSince: Vec<f64> = self.iterateCount() => {
        let solver = &self.0.borrow().run;
        let iterates = &solver.iterates()[row..];
        let mut numbers = Vec::with_capacity(iterates.len() * (2 + solver.dimension()));
        for iterate in iterates {
            numbers.extend([f64::from(iterate.restart), iterate.error]);
            numbers.extend(&iterate.configuration[..solver.dimension()]);
        }
        numbers
    };
    /// The distinct solutions from row `row` (0 to `solutionCount`) on, in the order in which they were found: configurations. A
    /// copy.
    solutionsSince: Vec<f64> = self.solutionCount() => self.0.borrow().run.solutions()[row..].concat();
}
