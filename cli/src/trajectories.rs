//! `planarium trajectories`: many trajectories that do not cross, with the time that each took.

use crate::arguments::{Answer, Given};
use crate::files;
use crate::kind::Kind;
use crate::output::{Output, Outputs};
use clap::Args;
use planarium::options::Options as _;
use planarium::problem::{Status, Stepped};
use planarium::trajectories::{Trajectories, TrajectoriesResult, TrajectoryOptions};
use planarium::{Error, json};
use serde::Serialize;
use std::fmt::Write;
use std::time::Instant;

/// The width of the moving average.
const WINDOW: usize = 20;

/// The names of the columns of the table.
const COLUMNS: &str = "x,y,theta,v,w,duration,tries,microseconds,average_of_20\n";

#[derive(Args)]
#[command(after_help = "\
`planarium list` describes the options. The CSV has a row for every accepted trajectory: x, y, theta, v, w,
duration, how many were tried for it, the microseconds that took, and their moving average over 20.
Exit codes: 0 the requested number is accepted; 1 not; 2 the input is wrong.

Examples:
  planarium trajectories
  planarium trajectories --set model=spiral --set count=500 --seed 3 --csv trajectories.csv")]
pub struct Arguments {
    #[command(flatten)]
    given: Given,

    /// Write a row for every accepted trajectory to this file
    #[arg(long, value_name = "FILE")]
    csv: Option<String>,

    /// Replace files that contain something else
    #[arg(long)]
    force: bool,
}

/// The printed document.
#[derive(Serialize)]
struct Timed {
    #[serde(flatten)]
    result: TrajectoriesResult,
    seconds: f64,
}

/// Tries trajectories until all are accepted or the iterations are spent, and prints counts and seconds.
pub fn trajectories(arguments: &Arguments) -> Answer {
    let mut outputs = Outputs::beside([], arguments.force);
    let table = arguments.csv.as_deref().map(|name| outputs.add(Some(name), Kind::table(COLUMNS))).transpose()?;
    let mut trajectories = Trajectories::new(&TrajectoryOptions::read(&arguments.given.set)?, arguments.given.seed)?;
    let mut microseconds = Vec::new();
    let begun = Instant::now();
    let mut last = begun;
    while trajectories.status() == Status::Running {
        trajectories.step(1);
        if trajectories.accepted().len() > microseconds.len() {
            let now = Instant::now();
            microseconds.push((now - last).as_secs_f64() * 1e6);
            last = now;
        }
    }
    let seconds = begun.elapsed().as_secs_f64();
    if let Some(table) = table {
        write_rows(&trajectories, &microseconds, &table)?;
    }
    files::print(&json::to_string(&Timed { result: trajectories.result(), seconds }))?;
    Ok(trajectories.status() == Status::Solved)
}

/// Writes a row for every accepted trajectory; the average begins with the twentieth.
fn write_rows(trajectories: &Trajectories, microseconds: &[f64], table: &Output) -> Result<(), Error> {
    let mut text = String::from(COLUMNS);
    for (i, (particle, tries)) in trajectories.accepted().zip(trajectories.tries()).enumerate() {
        for number in particle.numbers() {
            let _ = write!(text, "{number},");
        }
        let _ = write!(text, "{tries},{:.3},", microseconds[i]);
        if let Some(first) = (i + 1).checked_sub(WINDOW) {
            let window = &microseconds[first..=i];
            let _ = write!(text, "{:.3}", window.iter().sum::<f64>() / WINDOW as f64);
        }
        text.push('\n');
    }
    table.write_bytes(text.as_bytes())
}
