//! `planarium plan`: drives a run in short slices, with a clock.

use crate::arguments::Plan;
use crate::progress::Progress;
use crate::{Answer, files, roadmap};
use planarium::Error;
use planarium::error::Code;
use planarium::path::ResultDocument;
use planarium::run::{self, Options, Phase, Run, Status, Value};
use planarium::scenario::Scenario;
use std::time::{Duration, Instant};

/// How long a slice of iterations should take: short against the limit of time.
const SLICE: Duration = Duration::from_micros(500);

/// The most iterations of a slice: few against the phases of a planner, enough that the clock costs nothing.
const MOST: u64 = 16;

/// Plans, prints the result; yes where it is solved.
pub fn plan(arguments: &Plan) -> Answer {
    if arguments.file == "-" && arguments.roadmap.as_deref() == Some("-") {
        let sentence = "scenario and roadmap cannot both come from standard input";
        return Err(Error::new(Code::Usage, "", sentence));
    }
    let scenario = Scenario::parse(&files::read(&arguments.file)?)?;
    let kept = arguments.roadmap.as_deref().map(roadmap::read).transpose()?;
    let options = options(arguments);
    let mut run = match &kept {
        Some(document) => run::resume(&scenario, &options, document)?,
        None => run::start(&scenario, &options)?,
    };
    if arguments.save_roadmap.is_some() && run.roadmap().is_none() {
        let sentence = format!("{} builds no roadmap that could be saved", options.planner_for(&scenario));
        return Err(Error::new(Code::Unsupported, "", sentence));
    }
    let result = drive(run.as_mut(), arguments.max_seconds);
    // Before the result: on standard output an error stands alone.
    if let (Some(name), Some(document)) = (&arguments.save_roadmap, run.roadmap()) {
        roadmap::write(&document, name, arguments.roadmap_format)?;
    }
    files::write(&result.to_json(), arguments.out.as_deref())?;
    files::say(&summary(&result));
    Ok(result.status == Status::Solved)
}

fn options(arguments: &Plan) -> Options {
    let set = arguments.set.iter().map(|(key, value)| (key.clone(), Value::from_text(value)));
    let most = arguments.max_iterations.map(|most| ("max_iterations".to_owned(), Value::Number(most as f64)));
    Options {
        planner: arguments.planner.clone(),
        query: arguments.query.clone(),
        seed: arguments.seed,
        parameters: set.chain(most).collect(),
    }
}

/// Steps until the run ends or the time is up, and measures: the search of the graph and the shortening of the path apart
/// from the growth. A phase may end within a slice, so each time is right to a slice.
fn drive(run: &mut dyn Run, max_seconds: Option<f64>) -> ResultDocument {
    let mut progress = Progress::new(run);
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
        progress.show(run);
    }
    progress.finish();
    // A path that is only being improved is a path.
    run.finish();
    let mut result = run.result();
    (result.stats.build_seconds, result.stats.search_seconds) = (build.as_secs_f64(), search.as_secs_f64());
    result
}

/// How many iterations to do next, after so many took that long.
fn next_slice(iterations: u64, took: Duration) -> u64 {
    let longer = if took * 2 <= SLICE { iterations * 2 } else { iterations };
    let fitting = if took > SLICE { iterations / 2 } else { longer };
    fitting.clamp(1, MOST)
}

fn summary(result: &ResultDocument) -> String {
    let stats = &result.stats;
    let seconds = stats.build_seconds + stats.search_seconds;
    let found = match result.status {
        Status::Solved => format!("solved: {} waypoints, length {:.4}", result.path.len(), result.length),
        Status::Exhausted => "exhausted: no path found".to_owned(),
        Status::Running => "running: the time is up, no path found yet".to_owned(),
    };
    format!("{found}; {} iterations, {} vertices, {seconds:.3} s", stats.iterations, stats.vertices)
}
