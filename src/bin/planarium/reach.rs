//! `planarium reach`: inverse kinematics.

use crate::arguments::Reach as Arguments;
use crate::output::{Kind, Outputs};
use crate::{Answer, files};
use planarium::ik::{Solver, SolverOptions, Target};
use planarium::run::{Status, Value};

/// Runs to the end and prints the result; true if the target is reached.
pub fn reach(arguments: &Arguments) -> Answer {
    let out = Outputs::beside([&*arguments.file], arguments.force).add(arguments.out.as_deref(), Kind::REACH)?;
    let scenario = files::scenario(&arguments.file, None)?;
    let solutions = arguments.solutions.map(|most| Value::Number(most as f64));
    let options = SolverOptions {
        target: Target { point: arguments.target.into(), orientation: arguments.orientation },
        method: arguments.method.clone(),
        start: arguments.start.clone().map(|start| start.0),
        seed: arguments.given.seed,
        parameters: arguments.given.parameters("solutions", solutions),
    };
    let mut run = Solver::new(&scenario, &options)?;
    run.step(u64::MAX);
    let result = run.result();
    out.write(&result.to_json())?;
    let (verdict, stats, found) = (result.verdict.as_str(), result.stats, result.solutions.len());
    files::say(&format!("{verdict}: {found} solutions; {} iterations, {} restarts", stats.iterations, stats.restarts));
    Ok(result.status == Status::Solved)
}
