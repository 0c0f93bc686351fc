//! `planarium sweep`: the trials of an experiment on several threads, in files that can be continued.

mod ompl_log;
mod rows;
mod shard;

use crate::arguments::{Answer, threads};
use crate::files;
use crate::kind::Kind;
use crate::output::Outputs;
use crate::progress::{REDRAW, next_slice, progress_target};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use planarium::Error;
use planarium::experiment::{Baseline, Experiment, Summary, Trials};
use planarium::json;
use planarium::run::Phase;
use rows::{Format, Row, Rows, Writer};
use serde_json::Value;
use shard::Shard;
use std::collections::{BTreeMap, HashMap};
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError, mpsc};
use std::thread::{self, available_parallelism};
use std::time::Instant;

#[derive(Args)]
#[command(after_help = "\
Every trial has a row, in the order of trials; the times of runs.csv are in runs.times.csv. Rows are the same with any number of
threads, and the files of shards 1/N to N/N, one after another, are the file of one run. A sweep that was stopped, by whatever
means, goes on after its last complete row when it is started again. Prints the statistics of all rows as JSON.
Exit codes: 0 all trials have rows, solved or not; 2 the input is wrong, or the file has rows of another experiment.

Examples:
  planarium sweep experiment.json --out runs.csv
  planarium sweep experiment.json --out part2.csv --shard 2/8 --threads 4
  planarium sweep experiment.json --out runs.csv --ompl-log runs.log
  planarium sweep experiment.json --out runs.csv --baseline \"prm (k=4)\"")]
pub struct Arguments {
    /// The experiment, a JSON file; - reads it from standard input
    file: String,

    /// The file of rows; it is continued if it exists
    #[arg(long, value_name = "FILE")]
    out: String,

    /// The format of rows
    #[arg(long, value_name = "FORMAT", value_enum, default_value_t = Format::Csv)]
    format: Format,

    /// Run only part I of N equal parts, from 1
    #[arg(long, value_name = "I/N", value_parser = Shard::parse)]
    shard: Option<Shard>,

    /// The threads to use; the rows are the same with any number [default: one per core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    threads: Option<NonZeroUsize>,

    /// Write all rows to this file as a log of OMPL's benchmarks
    #[arg(long, value_name = "FILE")]
    ompl_log: Option<String>,

    /// The setting that all others are compared with, as comparisons name it, such as "prm (k=4)" [default: the first
    /// of the first planner]
    #[arg(long, value_name = "NAME")]
    baseline: Option<String>,

    /// Compare all settings with each other
    #[arg(long, conflicts_with = "baseline")]
    all_pairs: bool,

    /// Replace files that contain something else; rows of this experiment are continued all the same
    #[arg(long)]
    force: bool,
}

/// How many trials, for each thread, may be ahead of the next row that is written.
const AHEAD: u64 = 256;

/// The line of a trial and its seconds, or why it could not be run.
type Finished = Result<(Vec<u8>, [f64; 2]), Error>;

/// Runs the trials that have no row yet, and prints the statistics of all rows.
pub fn sweep(arguments: &Arguments) -> Answer {
    let (document, inputs) = document(&arguments.file)?;
    let experiment = Arc::new(Experiment::read(&document)?);
    let baseline = match &arguments.baseline {
        Some(name) => experiment.baseline(name)?,
        None if arguments.all_pairs => Baseline::AllPairs,
        None => Baseline::First,
    };
    let rows = Rows::new(&experiment, &arguments.out, arguments.format, arguments.shard.unwrap_or_default());
    let mut outputs = Outputs::beside(inputs.iter().map(String::as_str), arguments.force);
    for name in rows.names() {
        outputs.claim_apart_from_standard_output(name)?;
    }
    let log = arguments.ompl_log.as_deref().map(|name| outputs.add(Some(name), Kind::OMPL_LOG)).transpose()?;
    let (next, writer) = rows.resume(arguments.force)?;
    let begun = Instant::now();
    run(&experiment, &rows, next, writer, arguments.threads)?;
    let (made, seconds) = (rows.trials.end - next, begun.elapsed().as_secs_f64());
    if let Some(log) = log {
        ompl_log::write(&experiment, &rows, seconds, &log)?;
    }
    files::print(&summary(&experiment, &rows, baseline)?)?;
    let kept = next - rows.trials.start;
    files::say(&format!("{made} trials in {seconds:.3} s, {:.1} a second; {kept} were there", made as f64 / seconds));
    Ok(true)
}

/// The document of an experiment, with the documents of scenarios in place of the names of their files, and the names
/// of all files.
fn document(name: &str) -> Result<(Value, Vec<String>), Error> {
    let mut names = vec![name.to_owned()];
    let mut document = json::parse(&files::read(name)?)?;
    let worlds = document.get_mut("worlds").and_then(Value::as_array_mut);
    for (i, world) in worlds.into_iter().flatten().enumerate() {
        if let Some(scenario) = world.get_mut("scenario")
            && let Value::String(file) = scenario
        {
            let under = |error: Error| error.under(&format!("/worlds/{i}/scenario"));
            let path = Path::new(name).parent().unwrap_or(Path::new("")).join(file);
            let path = path.to_string_lossy().into_owned();
            *scenario = files::read(&path).and_then(|text| json::parse(&text)).map_err(under)?;
            names.push(path);
        }
    }
    Ok((document, names))
}

/// Runs trials from `next` on. Threads take them in order; their rows wait until all before them are written.
fn run(
    experiment: &Arc<Experiment>,
    rows: &Rows,
    next: u64,
    mut writer: Writer,
    threads: Option<NonZeroUsize>,
) -> Result<(), Error> {
    let threads = threads.or_else(|| available_parallelism().ok()).map_or(1, |threads| threads.get() as u64);
    let (first, end) = (rows.trials.start, rows.trials.end);
    let bar = progress_bar(end - first);
    bar.set_position(next - first);
    bar.reset_eta();
    let (ask, asked) = mpsc::channel();
    let (done, finished) = mpsc::channel::<(u64, Finished)>();
    let asked = Mutex::new(asked);
    thread::scope(|scope| {
        for _ in 0..threads.min(end - next) {
            let (done, asked) = (done.clone(), &asked);
            scope.spawn(move || {
                let mut trials = Trials::new(experiment);
                // Until there is nothing left to do, or nobody who would write it.
                let take = || asked.lock().unwrap_or_else(PoisonError::into_inner).recv();
                while let Ok(number) = take()
                    && done.send((number, trial(&mut trials, rows, number))).is_ok()
                {}
            });
        }
        let ahead = end.min(next + AHEAD * threads);
        // Gone when this returns, so that the threads end.
        let ask = ask;
        drop(done);
        let request = |number: u64| ask.send(number).expect("threads wait for it");
        (next..ahead).for_each(request);
        let (mut waiting, mut flushed) = (BTreeMap::new(), Instant::now());
        for number in next..end {
            let ended = loop {
                if let Some(ended) = waiting.remove(&number) {
                    break ended;
                }
                let (other, ended) = finished.recv().expect("threads run until the channel closes");
                waiting.insert(other, ended);
            };
            match ended {
                Ok((line, seconds)) => writer.push(number, &line, seconds),
                Err(error) => return writer.flush().and(Err(error)),
            }
            if number + AHEAD * threads < end {
                request(number + AHEAD * threads);
            }
            if flushed.elapsed() >= REDRAW {
                flushed = Instant::now();
                writer.flush()?;
                bar.set_position(number + 1 - first);
            }
        }
        bar.finish_and_clear();
        writer.sync()
    })
}

/// Runs one trial, with a clock.
fn trial(trials: &mut Trials, rows: &Rows, number: u64) -> Finished {
    let mut run = trials.start(number)?;
    let (mut seconds, mut slice) = ([0.0; 2], 1);
    loop {
        let phase = run.phase();
        let is_search = matches!(phase, Phase::Searching | Phase::Improving);
        let before = Instant::now();
        let goes_on = run.step(slice);
        let took = before.elapsed();
        seconds[usize::from(is_search)] += took.as_secs_f64();
        if !goes_on {
            return Ok((rows.line(&run.row()?), seconds));
        }
        // The costs of phases differ, and a time counts for the phase in which a slice begins.
        slice = if run.phase() == phase { next_slice(slice, took) } else { 1 };
    }
}

/// The statistics of all rows, as JSON.
fn summary(experiment: &Experiment, rows: &Rows, baseline: Baseline) -> Result<String, Error> {
    let mut summary = Summary::new(experiment);
    let columns: HashMap<&str, usize> = rows.columns.iter().map(String::as_str).zip(0..).collect();
    rows.read(|Row { trial, cells, seconds: [build, search] }| {
        summary.add_row(trial, |name| match name {
            "build_seconds" => build.to_string(),
            "search_seconds" => search.to_string(),
            _ => columns.get(name).map_or(String::new(), |&i| cells[i].clone()),
        })
    })?;
    Ok(json::to_string(&summary.document_against(baseline)))
}

/// A progress bar on standard error, hidden unless that is a terminal.
fn progress_bar(trials: u64) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{bar:30} {human_pos}/{human_len} trials  {elapsed}, {eta} left  {per_sec}")
            .expect("the template is well-formed");
    ProgressBar::with_draw_target(Some(trials), progress_target()).with_style(style)
}
