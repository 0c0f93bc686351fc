//! `planarium train`, `navigate` and `compare`: a policy trained, paths along edges that it drives reliably, and how these do
//! beside others.

use crate::arguments::{Answer, Given, threads};
use crate::files;
use crate::kind::Kind;
use crate::output::Destination;
use crate::plan;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use planarium::Error;
use planarium::error::Code;
use planarium::json;
use planarium::navigation::{
    self, Comparison, ComparisonOptions, Method, MethodOverall, MethodSummary, Navigation, Policy, TrainingOptions,
};
use planarium::options::Options as _;
use planarium::problem::{Status, Stepped};
use planarium::run::Request;
use serde::Serialize;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
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

    #[command(flatten)]
    destination: Destination,
}

/// Trains a policy and prints it.
pub fn train(arguments: &Train) -> Answer {
    let (_, out) = arguments.destination.beside(arguments.file.as_deref(), Kind::POLICY)?;
    let task = match &arguments.file {
        Some(file) => Navigation::parse(&files::read(file)?)?,
        None => navigation::generate_with("furnished", &[])?,
    };
    let threads = arguments.threads.unwrap_or_else(cores);
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
Options are those of the planner, and rollouts, least_share, reliability and longest_edge.
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

    #[command(flatten)]
    destination: Destination,
}

/// Plans, executes and prints the result; true if there is a path.
pub fn navigate(arguments: &Navigate) -> Answer {
    let (_, out) = arguments.destination.beside([&*arguments.file, &*arguments.policy], Kind::NAVIGATION_PLAN)?;
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
`planarium list` describes the options. Intervals have a confidence of 95 %. With several floors they are over the floors, with one
floor over the runs, and with one run over the executions.

Examples:
  planarium compare rooms.json --policy policy.json --seed 1
  planarium compare rooms.json --policy policy.json --set queries=50 --set trials=10 --set margin=0.15
  planarium compare rooms-*.json --policy policy.json --runs 3")]
pub struct Compare {
    /// The navigation tasks, JSON files, each with a floor; - reads one from standard input
    #[arg(required = true)]
    files: Vec<String>,

    /// The policy, a JSON file; - reads it from standard input
    #[arg(long, value_name = "FILE")]
    policy: String,

    #[command(flatten)]
    given: Given,

    /// How often each floor is compared, every time with queries, roadmaps and noise of another seed, from `--seed` on
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=1000))]
    runs: u64,

    /// The threads to use; the result is the same with any number [default: one per core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    threads: Option<NonZeroUsize>,

    #[command(flatten)]
    destination: Destination,
}

/// What `compare` writes.
#[derive(Serialize)]
struct Compared {
    /// Of every floor and run.
    comparisons: Vec<ComparedFloor>,
    /// Over all of them.
    methods: Vec<MethodOverall>,
}

/// A comparison on one floor.
#[derive(Serialize)]
struct ComparedFloor {
    task: String,
    seed: u64,
    methods: Vec<MethodSummary>,
}

/// Compares ways to drive and prints how each did.
pub fn compare(arguments: &Compare) -> Answer {
    let Compare { files, policy, given, runs, .. } = arguments;
    let read = files.iter().chain([policy]).map(String::as_str);
    let (_, out) = arguments.destination.beside(read, Kind::COMPARISON)?;
    if files.iter().chain([policy]).filter(|file| *file == "-").count() > 1 {
        return Err(Error::new(Code::Usage, "", "only one file can come from standard input").into());
    }
    let policy = Policy::parse(&files::read(policy)?)?;
    let tasks: Vec<Navigation> =
        files.iter().map(|file| Navigation::parse(&files::read(file)?)).collect::<Result<_, _>>()?;
    let options = ComparisonOptions::read(&given.set)?;
    let begun = Instant::now();
    let wanted: Vec<(&Navigation, u64)> =
        tasks.iter().flat_map(|task| (0..*runs).map(move |run| (task, given.seed.saturating_add(run)))).collect();
    let comparisons = in_threads(arguments.threads.unwrap_or_else(cores), &wanted, |&(task, seed)| {
        let mut comparison = Comparison::new(task, &policy, &options, seed)?;
        comparison.step(u64::MAX);
        Ok(ComparedFloor { task: task.name().to_owned(), seed, methods: comparison.summary() })
    })?;
    let of_floors = comparisons.chunks(if tasks.len() > 1 { *runs as usize } else { 1 });
    let groups: Vec<Vec<Vec<MethodSummary>>> =
        of_floors.map(|group| group.iter().map(|one| one.methods.clone()).collect()).collect();
    let methods = navigation::overall(&groups);
    let compared = Compared { comparisons, methods };
    out.write(&json::to_string(&compared))?;
    say_compared(&compared, tasks.len(), groups.len());
    let executions: u64 = compared.comparisons.iter().flat_map(|one| &one.methods).map(|one| one.reached.n).sum();
    files::say(&format!("{executions} executions, {:.1} s", begun.elapsed().as_secs_f64()));
    Ok(true)
}

/// A line for every method: over the executions of one comparison, or over several.
fn say_compared(Compared { comparisons, methods }: &Compared, floors: usize, groups: usize) {
    let percent = |value: Option<f64>| 100.0 * value.unwrap_or(0.0);
    for (i, all) in methods.iter().enumerate() {
        let name = match all.method {
            Method::Policy => "policy alone",
            Method::Straight => "straight edges, no rays",
            Method::StraightMargin => "straight edges with a margin, no rays",
            Method::StraightPolicy => "straight edges, policy",
            Method::StraightMarginPolicy => "straight edges with a margin, policy",
            _ => "PRM-RL",
        };
        let one = &comparisons[0].methods[i];
        let (reached, low, high, more) = match groups {
            1 => {
                let mut failures = format!(", {:.1} % in collision", percent(one.collisions.share));
                if comparisons[0].methods.iter().any(|one| one.swings.count > 0) {
                    failures += &format!(", {:.1} % with too much swing", percent(one.swings.share));
                }
                (one.reached.share, one.reached.low, one.reached.high, failures)
            }
            _ => {
                let what = if floors > 1 { "floors" } else { "runs" };
                let least = format!(" over {groups} {what}, at least {:.1} %", 100.0 * all.least);
                (all.reached.mean, all.reached.low, all.reached.high, least)
            }
        };
        files::say(&format!(
            "{name:<37} {:>5.1} % reached [{:.1}, {:.1}]{more}, {:.1} % of the queries have a path",
            percent(reached),
            percent(low),
            percent(high),
            percent(all.planned.mean)
        ));
    }
}

fn cores() -> NonZeroUsize {
    std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN)
}

/// Calls with each item, on several threads; the results are in the order of the items.
///
/// # Errors
/// That of the first item which has one.
fn in_threads<T: Sync, R: Send>(
    threads: NonZeroUsize,
    items: &[T],
    call: impl Fn(&T) -> Result<R, Error> + Sync,
) -> Result<Vec<R>, Error> {
    let (next, results) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..threads.get().min(items.len()) {
            scope.spawn(|| {
                while let Some((i, item)) =
                    Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|i| Some((i, items.get(i)?)))
                {
                    let result = call(item);
                    results.lock().unwrap_or_else(PoisonError::into_inner).push((i, result));
                }
            });
        }
    });
    let mut results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.sort_by_key(|(i, _)| *i);
    results.into_iter().map(|(_, result)| result).collect()
}
