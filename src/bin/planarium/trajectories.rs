//! `planarium trajectories`: many trajectories that do not cross, with the time that each took.

use crate::{Answer, arguments, files};
use planarium::problem::Status;
use planarium::trajectories::{Trajectories, TrajectoriesResult};
use planarium::{Error, json};
use serde::Serialize;
use std::fmt::Write;
use std::time::Instant;

/// The width of the moving average.
const WINDOW: usize = 20;

/// The printed document.
#[derive(Serialize)]
struct Timed {
    #[serde(flatten)]
    result: TrajectoriesResult,
    seconds: f64,
}

/// Tries trajectories until all are accepted or the iterations are spent, and prints counts and seconds.
pub fn trajectories(arguments: &arguments::Trajectories) -> Answer {
    let mut trajectories = Trajectories::new(&arguments.given.set, arguments.given.seed)?;
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
    if let Some(name) = &arguments.csv {
        write_rows(&trajectories, &microseconds, name)?;
    }
    files::print(&json::to_string(&Timed { result: trajectories.result(), seconds }))?;
    Ok(trajectories.status() == Status::Solved)
}

/// Writes a row for every accepted trajectory; the average begins with the twentieth.
fn write_rows(trajectories: &Trajectories, microseconds: &[f64], name: &str) -> Result<(), Error> {
    let mut text = String::from("x,y,theta,v,w,duration,tries,microseconds,average_of_20\n");
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
    files::write_bytes(text.as_bytes(), name)
}
