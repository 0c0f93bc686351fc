//! `planarium plan`: drives a run in short slices, with a clock.

use crate::arguments::{Plan, RoadmapFormat};
use crate::output::{Kind, Output, Outputs};
use crate::{Answer, files};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use planarium::Error;
use planarium::PlanningWorld;
use planarium::error::Code;
use planarium::path::ResultDocument;
use planarium::run::storage::RoadmapDocument;
use planarium::run::{self, Limits, Phase, Request, Run, Status, Value};
use std::io::{IsTerminal, stderr};
use std::num::NonZeroUsize;
use std::path::Path;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

/// The target duration of a slice of iterations: short compared with the time limit.
const SLICE: Duration = Duration::from_micros(500);

/// The most iterations of a slice: few compared with the phases of a planner, enough to make the cost of the clock negligible.
const MOST: u64 = 16;

/// The time between two updates of the progress bar.
pub const REDRAW: Duration = Duration::from_millis(100);

/// Plans and prints the result; true if it is solved.
pub fn plan(arguments: &Plan) -> Answer {
    let saved = arguments.roadmap.as_deref();
    let mut outputs = Outputs::beside([Some(&*arguments.file), saved].into_iter().flatten(), arguments.force);
    let roadmap = arguments.save_roadmap.as_deref().map(|name| outputs.add(Some(name), Kind::ROADMAP)).transpose()?;
    let out = outputs.add(arguments.out.as_deref(), Kind::PLAN)?;
    let scenario = files::scenario(&arguments.file, saved.map(|name| ("roadmap", name)))?;
    let most = arguments.max_iterations.map(|most| Value::Number(most as f64));
    let request = Request {
        planner: arguments.planner.clone(),
        query: arguments.query.clone(),
        seed: arguments.given.seed,
        parameters: arguments.given.parameters("max_iterations", most),
        // The fingerprint of a result covers them.
        events: true,
    };
    let mut run = match saved {
        Some(name) => {
            let document = RoadmapDocument::read(&files::read_bytes(name)?)?;
            run::resume(&scenario, &request.for_roadmap(&document)?, &document)?
        }
        None => run::start(&scenario, &request.for_robot(scenario.robot())?)?,
    };
    if arguments.save_roadmap.is_some() && run.roadmap().is_none() {
        let sentence = format!("{} builds no roadmap that could be saved", run.result().planner);
        return Err(Error::new(Code::Unsupported, "", sentence));
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

/// The iterations of the next slice, after this many took this long.
pub fn next_slice(iterations: u64, took: Duration) -> u64 {
    let longer = if took * 2 <= SLICE { iterations * 2 } else { iterations };
    let fitting = if took > SLICE { iterations / 2 } else { longer };
    fitting.clamp(1, MOST)
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

/// Standard error, if that is a terminal.
pub fn progress_target() -> ProgressDrawTarget {
    if stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() }
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
