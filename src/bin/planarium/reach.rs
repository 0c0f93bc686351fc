//! `planarium reach`: inverse kinematics.

use crate::arguments::Reach as Arguments;
use crate::{Answer, files};
use planarium::geometry::Point;
use planarium::ik::{Solver, SolverOptions, Target};
use planarium::run::{Status, Value};
use planarium::scenario::Scenario;

/// Searches to the end and prints the result; yes where the target is reached.
pub fn reach(arguments: &Arguments) -> Answer {
    let scenario = Scenario::parse(&files::read(&arguments.file)?)?;
    let set = arguments.set.iter().map(|(key, value)| (key.clone(), Value::from_text(value)));
    let solutions = arguments.solutions.map(|most| ("solutions".to_owned(), Value::Number(most as f64)));
    let [x, y] = arguments.target;
    let options = SolverOptions {
        target: Target { point: Point::new(x, y), orientation: arguments.orientation },
        method: arguments.method.clone(),
        start: arguments.start.clone().map(|start| start.0),
        seed: arguments.seed,
        parameters: set.chain(solutions).collect(),
    };
    let mut run = Solver::new(&scenario, &options)?;
    run.step(u64::MAX);
    files::write(&run.result().to_json(), arguments.out.as_deref())?;
    let (found, verdict) = (run.solutions().len(), run.explain());
    files::say(&format!(
        "{}: {found} solutions; {} iterations, {} restarts",
        verdict.as_str(),
        run.iterations(),
        run.restarts()
    ));
    Ok(run.status() == Status::Solved)
}
