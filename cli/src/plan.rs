//! `planarium plan`: drives a run in short slices, with a clock.

use crate::arguments::{Answer, Given, threads};
use crate::files;
use crate::kind::Kind;
use crate::output::{Destination, Output, Outputs};
use crate::progress::{REDRAW, next_slice, progress_target};
use crate::world::{self, WorldOptions};
use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use planarium::Error;
use planarium::PlanningWorld;
use planarium::error::Code;
use planarium::path::ResultDocument;
use planarium::run::storage::RoadmapDocument;
use planarium::run::{self, Limits, Phase, Request, Run, Status, Value};
use std::num::NonZeroUsize;
use std::path::Path;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

#[derive(Args)]
#[command(after_help = "\
Exit codes: 0 solved; 1 exhausted, or still running when the time was up; 2 the input is wrong.

Examples:
  planarium plan arm.json
  planarium plan arm.json --query report --planner prm --set samples=700 --set k=30 --seed 7
  planarium generate clutter --seed 3 | planarium plan - --set shortcut=200 --max-seconds 2
  planarium plan arm.json --planner prm --save-roadmap arm.roadmap
  planarium plan arm.json --roadmap arm.roadmap --query another")]
pub struct Arguments {
    /// The scenario, a JSON file, or a map (see `planarium import`); - reads it from standard input
    file: String,

    /// The query, by name [default: the first of the scenario]
    #[arg(long, value_name = "NAME")]
    query: Option<String>,

    /// The planner, by id; see `planarium list` [default: rrt-connect; for a car that cannot turn to both sides
    /// rrt-control; with a roadmap the one that built it]
    #[arg(long, value_name = "ID")]
    planner: Option<String>,

    /// Without --planner: the path as the planner found it; else it is made shorter (reduce, 200 shortcuts)
    #[arg(long, conflicts_with_all = ["planner", "roadmap"])]
    raw: bool,

    #[command(flatten)]
    given: Given,

    /// The most iterations; the same as --set max_iterations=N
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    max_iterations: Option<u64>,

    /// Stop after this many seconds with status "running"; the result contains the iterations made
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = seconds)]
    max_seconds: Option<f64>,

    /// The threads to use; the result is the same with any number [default: one per core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    threads: Option<NonZeroUsize>,

    /// Continue with a roadmap saved for the same world and robot, which is proven again, instead of building one; - reads it
    /// from standard input
    #[arg(long, value_name = "FILE")]
    roadmap: Option<String>,

    /// Save the roadmap when the run ends (of planners that build one: their names contain "prm")
    #[arg(long, value_name = "FILE")]
    save_roadmap: Option<String>,

    /// The format of the saved roadmap [default: json for FILE.json, graphml for FILE.graphml, else binary]; graphml is for other
    /// programs
    #[arg(long, value_name = "FORMAT", requires = "save_roadmap")]
    roadmap_format: Option<RoadmapFormat>,

    #[command(flatten)]
    destination: Destination,

    #[command(flatten)]
    world: WorldOptions,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum RoadmapFormat {
    Json,
    Binary,
    Graphml,
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds.is_finite() && seconds >= 0.0 => Ok(seconds),
        _ => Err("seconds are a number, 0 or more".to_owned()),
    }
}

/// Plans and prints the result; true if it is solved.
pub fn plan(arguments: &Arguments) -> Answer {
    let saved = arguments.roadmap.as_deref();
    let Destination { out, force } = &arguments.destination;
    let mut outputs = Outputs::beside([Some(&*arguments.file), saved].into_iter().flatten(), *force);
    let roadmap = arguments.save_roadmap.as_deref().map(|name| outputs.add(Some(name), Kind::ROADMAP)).transpose()?;
    let out = outputs.add(out.as_deref(), Kind::PLAN)?;
    let other = saved.map(|name| ("roadmap", name));
    let scenario = world::scenario(&arguments.file, other, &arguments.world, &outputs)?;
    let most = arguments.max_iterations.map(|most| Value::Number(most as f64));
    // The path of a planner that is named is improved by its options alone.
    let raw = || run::default_planner(Some(scenario.robot())).id().to_owned();
    let request = Request {
        planner: arguments.planner.clone().or_else(|| arguments.raw.then(raw)),
        query: arguments.query.clone(),
        seed: arguments.given.seed,
        parameters: arguments.given.parameters("max_iterations", most),
        // The fingerprint of a result covers them.
        events: true,
    };
    let mut run = match saved {
        Some(name) => {
            let document = RoadmapDocument::read(&files::read_bytes(name)?)?;
            run::resume(&scenario, &request.for_roadmap(&scenario, &document)?, &document)?
        }
        None => run::start(&scenario, &request.for_robot(scenario.robot())?)?,
    };
    if arguments.save_roadmap.is_some() && run.roadmap().is_none() {
        let sentence = format!("{} builds no roadmap that could be saved", run.result().planner);
        return Err(Error::new(Code::Unsupported, "", sentence).into());
    }
    run.set_threads(arguments.threads.or_else(|| available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN));
    let result = drive(run.as_mut(), arguments.max_seconds);
    // Before the result: standard output contains either a result or an error.
    if let (Some(name), Some(output), Some(document)) = (&arguments.save_roadmap, roadmap, run.roadmap()) {
        write_roadmap(&document, name, &output, arguments.roadmap_format)?;
    }
    out.write(&result.to_json())?;
    files::say(&summary(&result));
    if let (Status::Exhausted, Some(why)) = (result.status, PlanningWorld::new(scenario).without_width()) {
        files::say(&why);
    }
    Ok(result.status == Status::Solved)
}

/// Steps until the run ends or the time is up, and measures the search of the graph and the shortening of the path apart from the
/// growth. A phase may end within a slice, so each time is accurate to a slice.
fn drive(run: &mut dyn Run, max_seconds: Option<f64>) -> ResultDocument {
    let (bar, mut drawn) = (progress_bar(run), Instant::now());
    let (mut build, mut search) = (Duration::ZERO, Duration::ZERO);
    let is_up = |spent: Duration| max_seconds.is_some_and(|most| spent.as_secs_f64() >= most);
    let begin = Instant::now();
    let mut iterations = 1;
    while run.status() == Status::Running && !is_up(begin.elapsed()) {
        let spent = if matches!(run.phase(), Phase::Searching | Phase::Improving) { &mut search } else { &mut build };
        let before = Instant::now();
        run.step(iterations);
        let took = before.elapsed();
        *spent += took;
        iterations = next_slice(iterations, took);
        if drawn.elapsed() >= REDRAW {
            drawn = Instant::now();
            bar.set_message(format!("{}, {} vertices", run.phase().as_str(), run.vertex_count()));
            bar.set_position(position(run, &bar));
        }
    }
    bar.finish_and_clear();
    // The time may be up while a path is being improved.
    run.finish();
    let mut result = run.result();
    (result.stats.build_seconds, result.stats.search_seconds) = (build.as_secs_f64(), search.as_secs_f64());
    result
}

fn summary(result: &ResultDocument) -> String {
    let stats = &result.stats;
    let seconds = stats.build_seconds + stats.search_seconds;
    let found = match result.status {
        Status::Solved => format!("solved: {} waypoints, length {:.4}", result.path.len(), result.length),
        Status::Exhausted => exhausted(result),
        Status::Failed => "failed: a configuration cannot be evaluated".to_owned(),
        Status::Running => "running: the time is up, no path found yet".to_owned(),
        other => other.as_str().to_owned(),
    };
    let early = match &result.explanation {
        Some(explanation) if result.status == Status::Solved => format!("; {explanation}"),
        _ => String::new(),
    };
    format!("{found}; {} iterations, {} vertices, {seconds:.3} s{early}", stats.iterations, stats.vertices)
}

/// Why a run has ended without a path.
pub fn exhausted(result: &ResultDocument) -> String {
    format!("exhausted: {}", result.explanation.as_deref().unwrap_or("no path found"))
}

/// Shows the work of the limit that is spent, or its iterations if only these are limited.
fn progress_bar(run: &dyn Run) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {human_pos}/{human_len} {prefix}  {elapsed}  {msg}")
        .expect("the template is well-formed");
    let (unit, most) = match run.limits() {
        Limits { max_work: None, max_iterations: Some(most), .. } => ("iterations", u64::from(most)),
        limits => ("work", limits.work()),
    };
    ProgressBar::with_draw_target(Some(most), progress_target()).with_style(style).with_prefix(unit)
}

/// Where the bar stands.
fn position(run: &dyn Run, bar: &ProgressBar) -> u64 {
    if bar.prefix() == "iterations" { run.iterations() } else { run.stats().work }
}

/// Writes a roadmap in the given format, or in that of the file's extension.
fn write_roadmap(
    document: &RoadmapDocument,
    name: &str,
    output: &Output,
    format: Option<RoadmapFormat>,
) -> Result<(), Error> {
    let extension = Path::new(name).extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let format = format.unwrap_or_else(|| match extension.to_ascii_lowercase().as_str() {
        "json" => RoadmapFormat::Json,
        "graphml" => RoadmapFormat::Graphml,
        _ => RoadmapFormat::Binary,
    });
    match format {
        RoadmapFormat::Json => output.write(&document.to_json()),
        RoadmapFormat::Binary => output.write_bytes(&document.to_bytes()),
        RoadmapFormat::Graphml => output.write_bytes(document.to_graphml().as_bytes()),
    }
}
