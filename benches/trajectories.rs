//! Many trajectories: microseconds per accepted one against the number of accepted ones, with the grid and without, in the fastest
//! of several runs.
//!
//! `cargo bench --bench trajectories`; a run pinned to one core is quieter.

use planarium::options::Choice;
use planarium::problem::Stepped;
use planarium::trajectories::{IndexKind, Model, Trajectories, TrajectoryOptions};
use std::time::Instant;

/// Runs for each entry of a table.
const RUNS: usize = 15;

fn main() {
    println!("1000 trajectories, defaults: milliseconds in all\n\n| motion | grid | none | tried |\n|---|---|---|---|");
    for model in [Model::Arc, Model::Spiral] {
        let [(with, tries), (without, _)] =
            [IndexKind::Grid, IndexKind::None].map(|index| growth(model, index, &[1000])[0]);
        // Milliseconds for a thousand are microseconds for one.
        println!("| {} | {with:.2} | {without:.2} | {:.0} |", model.word(), 1000.0 * tries);
    }
    println!("\nMicroseconds per accepted trajectory, arcs, the fastest of {RUNS} runs; tries per accepted\n");
    println!("| accepted | grid | none | tries |\n|---|---|---|---|");
    let ends = [100, 250, 500, 1000, 1500, 2000];
    let [with, without] = [IndexKind::Grid, IndexKind::None].map(|index| growth(Model::Arc, index, &ends));
    for (i, end) in ends.iter().enumerate() {
        println!("| to {end} | {:.2} | {:.2} | {:.2} |", with[i].0, without[i].0, with[i].1);
    }
}

/// Microseconds, those of the fastest run, and tries per accepted trajectory, between each of these counts and the one before.
fn growth(model: Model, index: IndexKind, ends: &[usize]) -> Vec<(f64, f64)> {
    let options = TrajectoryOptions { model, index, count: ends[ends.len() - 1], ..TrajectoryOptions::default() };
    let mut rows = vec![(f64::MAX, 0.0); ends.len()];
    for _ in 0..RUNS {
        let mut trajectories = Trajectories::new(&options, 0).expect("options");
        let mut from = 0;
        for (row, &end) in rows.iter_mut().zip(ends) {
            let (began, before) = (Instant::now(), trajectories.tally().iterations);
            while trajectories.accepted().len() < end {
                trajectories.step(1);
            }
            let (microseconds, accepted) = (began.elapsed().as_secs_f64() * 1e6, (end - from) as f64);
            let tries = (trajectories.tally().iterations - before) as f64 / accepted;
            *row = (row.0.min(microseconds / accepted), tries);
            from = end;
        }
    }
    rows
}
