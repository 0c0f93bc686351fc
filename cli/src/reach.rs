//! `planarium reach`: inverse kinematics.

use crate::arguments::{Answer, Given, coordinate};
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use clap::Args;
use planarium::ik::{MethodOptions, Solver, SolverOptions, Target};
use planarium::problem::Stepped;
use planarium::run::{Status, Value};

#[derive(Args)]
#[command(after_help = "\
If the target is out of reach, the result contains the reason and the nearest point that can be reached.
Exit codes: 0 reached; 1 not reached; 2 the input is wrong.

Examples:
  planarium reach arm.json --target 1.2,0.4
  planarium reach arm.json --target 1.2,0.4 --orientation 0.5 --method newton --seed 3
  planarium reach arm.json --target=-0.5,1 --solutions 4 --set free_only=true")]
pub struct Arguments {
    /// The scenario, a JSON file; - reads it from standard input
    file: String,

    /// The target of the tip, in metres
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = point)]
    target: [f64; 2],

    /// The absolute angle of the last link, in radians [default: any]
    #[arg(long, value_name = "PHI", allow_negative_numbers = true)]
    orientation: Option<f64>,

    /// The method, by id; see `planarium list` [default: damped-least-squares]
    #[arg(long, value_name = "ID")]
    method: Option<String>,

    /// The joint angles of the start, in radians [default: the start of the first query, else 0 as far as limits allow]
    #[arg(long, value_name = "Q1,Q2,..", allow_hyphen_values = true, value_parser = angles)]
    start: Option<Angles>,

    #[command(flatten)]
    given: Given,

    /// The number of distinct solutions to search for; the same as --set solutions=N
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    solutions: Option<u64>,

    #[command(flatten)]
    destination: Destination,
}

/// The angles of a configuration, in one argument.
#[derive(Clone)]
struct Angles(Vec<f64>);

fn angles(text: &str) -> Result<Angles, String> {
    text.split(',').map(coordinate).collect::<Result<_, _>>().map(Angles)
}

fn point(text: &str) -> Result<[f64; 2], String> {
    angles(text)?.0.try_into().map_err(|_| "a point reads X,Y".to_owned())
}

/// Runs to the end and prints the result; true if the target is reached.
pub fn reach(arguments: &Arguments) -> Answer {
    let (_, out) = arguments.destination.beside([&*arguments.file], Kind::REACH)?;
    let scenario = files::scenario(&arguments.file, None)?;
    let solutions = arguments.solutions.map(|most| Value::Number(most as f64));
    let options = SolverOptions {
        target: Target { point: arguments.target.into(), orientation: arguments.orientation },
        method: MethodOptions::read(arguments.method.as_deref(), &arguments.given.parameters("solutions", solutions))?,
        start: arguments.start.clone().map(|start| start.0),
        seed: arguments.given.seed,
    };
    let mut run = Solver::new(&scenario, &options)?;
    run.step(u64::MAX);
    let result = run.result();
    out.write(&result.to_json())?;
    let (verdict, stats, found) = (result.verdict.as_str(), result.stats, result.solutions.len());
    files::say(&format!("{verdict}: {found} solutions; {} iterations, {} restarts", stats.iterations, stats.restarts));
    Ok(result.status == Status::Solved)
}
