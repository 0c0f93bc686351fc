//! `planarium train`, `navigate` and `compare`: a policy trained, paths along edges that it drives reliably, and how these do beside others.

use crate::output::{Kind, Outputs};
use crate::{Answer, arguments, files, plan};
use indicatif::{ProgressBar, ProgressStyle};
use planarium::Error;
use planarium::error::Code;
use planarium::json;
use planarium::navigation::{self, Comparison, Method, Navigation, Policy};
use planarium::problem::Status;
use planarium::run::Request;
use std::num::NonZeroUsize;
use std::time::Instant;

/// How far the goals are on which a policy is assessed, in metres.
const GOALS_WITHIN: f64 = 5.0;

/// The number of goals.
const TRIALS: u64 = 1000;

/// Trains a policy and prints it.
pub fn train(arguments: &arguments::Train) -> Answer {
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
    let training = navigation::train(&task, &arguments.given.set, arguments.given.seed, threads, |training| {
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

/// Plans, executes and prints the result; true if there is a path.
pub fn navigate(arguments: &arguments::Navigate) -> Answer {
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

/// Compares three ways to drive and prints how each did.
pub fn compare(arguments: &arguments::Compare) -> Answer {
    let mut outputs = Outputs::beside([&*arguments.file, &*arguments.policy], arguments.force);
    let out = outputs.add(arguments.out.as_deref(), Kind::COMPARISON)?;
    let (task, policy) = inputs(&arguments.file, &arguments.policy)?;
    let begun = Instant::now();
    let mut comparison = Comparison::new(&task, &policy, &arguments.given.set, arguments.given.seed)?;
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
