//! `planarium train`, `navigate` and `compare`: a policy trained, paths along edges that it drives reliably, and how these do
//! beside others.

use crate::arguments::{Answer, Given, threads};
use crate::files;
use crate::kind::Kind;
use crate::output::Outputs;
use crate::plan;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use planarium::Error;
use planarium::error::Code;
use planarium::json;
use planarium::navigation::{self, Comparison, ComparisonOptions, Method, Navigation, Policy, TrainingOptions};
use planarium::options::Options as _;
use planarium::problem::{Status, Stepped};
use planarium::run::Request;
use std::num::NonZeroUsize;
use std::time::Instant;

/// How far the goals are on which a policy is assessed, in metres.
const GOALS_WITHIN: f64 = 5.0;

/// The number of goals.
const TRIALS: u64 = 1000;

#[derive(Args)]
#[command(after_help = "\
`planarium list` describes the options. The same seed gives the same policy, with any number of threads.

Examples:
  planarium train --seed 1 --out policy.json
  planarium train rooms.json --set generations=100 --set hidden=24 --seed 2 --out policy.json")]
pub struct Train {
    /// A navigation task, whose robot is trained; - reads it from standard input [default: a disc of radius 0.25 m]
    file: Option<String>,

    #[command(flatten)]
    given: Given,

    /// The threads to use; the result is the same with any number [default: one per core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    threads: Option<NonZeroUsize>,

    /// Write the policy to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    force: bool,
}

/// Trains a policy and prints it.
pub fn train(arguments: &Train) -> Answer {
    let out =
        Outputs::beside(arguments.file.as_deref(), arguments.force).add(arguments.out.as_deref(), Kind::POLICY)?;
    let task = match &arguments.file {
        Some(file) => Navigation::parse(&files::read(file)?)?,
        None => navigation::generate_with("furnished", &[])?,
    };
    let cores = std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let threads = arguments.threads.unwrap_or(cores);
    let begun = Instant::now();
    let bar = ProgressBar::new(0);
    if let Ok(style) = ProgressStyle::with_template("generation {pos} of {len}, {msg} {bar:30} {eta} left") {
        bar.set_style(style);
    }
    let options = TrainingOptions::read(&arguments.given.set)?;
    let training = navigation::train(&task, &options, arguments.given.seed, threads, |training| {
        bar.set_length(training.generations());
        bar.set_position(training.generation());
        if let Some(last) = training.history().last() {
            bar.set_message(format!("{:.0} % of the tasks solved", 100.0 * last.reached));
        }
        true
    })?;
    bar.finish_and_clear();
    let (policy, seconds) = (training.policy(), begun.elapsed().as_secs_f64());
    out.write(&policy.to_json_string())?;
    let assessed = navigation::assess(&task, &policy, GOALS_WITHIN, TRIALS, arguments.given.seed)?;
    let percent = |value: Option<f64>| 100.0 * value.unwrap_or(0.0);
    files::say(&format!(
        "{} generations in {seconds:.1} s, fingerprint {:016x}; on fresh floors {:.1} % of {} random goals within {GOALS_WITHIN} m are \
         reached [{:.1}, {:.1}]",
        training.generation(),
        training.fingerprint(),
        percent(assessed.share),
        assessed.n,
        percent(assessed.low),
        percent(assessed.high)
    ));
    Ok(true)
}

fn inputs(task: &str, policy: &str) -> Result<(Navigation, Policy), Error> {
    if task == "-" && policy == "-" {
        return Err(Error::new(Code::Usage, "", "task and policy cannot both come from standard input"));
    }
    Ok((Navigation::parse(&files::read(task)?)?, Policy::parse(&files::read(policy)?)?))
}

#[derive(Args)]
#[command(after_help = "\
Options are those of the planner, and rollouts, least_share and longest_edge.
Nothing is proven: the result has for each edge how many rollouts reached its end.
Exit codes: 0 solved; 1 no path; 2 the input is wrong.

Examples:
  planarium generate rooms --seed 1 --out rooms.json
  planarium navigate rooms.json --policy policy.json --set samples=800 --set k=20
  planarium navigate rooms.json --policy policy.json --planner lazy-prm --set samples=800 --set k=20 --trials 100")]
pub struct Navigate {
    /// The navigation task, a JSON file; - reads it from standard input
    file: String,

    /// The policy, a JSON file; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    policy: String,

    /// The query, by name [default: the first of the task]
    #[arg(long, value_name = "NAME")]
    query: Option<String>,

    /// The planner, by id; see `planarium list` [default: lazy-prm]
    #[arg(long, value_name = "ID")]
    planner: Option<String>,

    #[command(flatten)]
    given: Given,

    /// How many times the path is executed with noise
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u64).range(..=100_000))]
    trials: u64,

    /// Write the result to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    force: bool,
}

/// Plans, executes and prints the result; true if there is a path.
pub fn navigate(arguments: &Navigate) -> Answer {
    let mut outputs = Outputs::beside([&*arguments.file, &*arguments.policy], arguments.force);
    let out = outputs.add(arguments.out.as_deref(), Kind::NAVIGATION_PLAN)?;
    let (task, policy) = inputs(&arguments.file, &arguments.policy)?;
    let (rollouts, options) = navigation::read_options(&Request {
        planner: arguments.planner.clone(),
        query: arguments.query.clone(),
        seed: arguments.given.seed,
        parameters: arguments.given.set.clone(),
        ..Request::default()
    })?;
    let begun = Instant::now();
    let result = navigation::navigate(&task, &policy, &rollouts, &options, arguments.trials)?;
    out.write(&result.to_json())?;
    let (edges, seconds) = (result.rollouts.len(), begun.elapsed().as_secs_f64());
    let reached = format!("{} of {} executions reached the goal", result.reached.count, result.reached.n);
    files::say(&match result.plan.status {
        Status::Solved => format!("solved: {edges} edges, {:.2} m; {reached}; {seconds:.3} s", result.plan.length),
        Status::Exhausted => format!("{}; {seconds:.3} s", plan::exhausted(&result.plan)),
        status => format!("{}: no path yet; {seconds:.3} s", status.as_str()),
    });
    Ok(result.plan.status == Status::Solved)
}

#[derive(Args)]
#[command(after_help = "\
`planarium list` describes the options. Intervals have a confidence of 95 %.

Examples:
  planarium compare rooms.json --policy policy.json --seed 1
  planarium compare rooms.json --policy policy.json --set queries=50 --set trials=10 --set margin=0.15")]
pub struct Compare {
    /// The navigation task, a JSON file; - reads it from standard input
    file: String,

    /// The policy, a JSON file; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    policy: String,

    #[command(flatten)]
    given: Given,

    /// Write the summary to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    force: bool,
}

/// Compares three ways to drive and prints how each did.
pub fn compare(arguments: &Compare) -> Answer {
    let mut outputs = Outputs::beside([&*arguments.file, &*arguments.policy], arguments.force);
    let out = outputs.add(arguments.out.as_deref(), Kind::COMPARISON)?;
    let (task, policy) = inputs(&arguments.file, &arguments.policy)?;
    let begun = Instant::now();
    let options = ComparisonOptions::read(&arguments.given.set)?;
    let mut comparison = Comparison::new(&task, &policy, &options, arguments.given.seed)?;
    comparison.step(u64::MAX);
    let summary = comparison.summary();
    out.write(&json::to_string(&summary))?;
    for one in &summary {
        let name = match one.method {
            Method::Policy => "policy alone",
            Method::Straight => "straight edges",
            _ => "PRM-RL",
        };
        let percent = |value: Option<f64>| 100.0 * value.unwrap_or(0.0);
        files::say(&format!(
            "{name:<14} {:>5.1} % reached [{:.1}, {:.1}], {:.1} % in collision, {:.1} % of the queries have a path",
            percent(one.reached.share),
            percent(one.reached.low),
            percent(one.reached.high),
            percent(one.collisions.share),
            percent(one.planned.share)
        ));
    }
    files::say(&format!("{} executions, {:.1} s", comparison.executions().len(), begun.elapsed().as_secs_f64()));
    Ok(true)
}
