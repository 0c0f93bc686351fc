//! Many trajectories: microseconds per accepted one against the number of accepted ones, with the grid and without; the fastest of
//! a few runs, since other work on the machine only adds time.
//!
//! `cargo bench --bench trajectories`; a run pinned to one core is quieter.

use planarium::options::Value;
use planarium::problem::Status;
use planarium::trajectories::Trajectories;
use std::time::Instant;

/// Runs for each entry of a table.
const RUNS: usize = 15;

fn main() {
    println!("1000 trajectories, defaults: milliseconds in all\n\n| motion | grid | none | tried |\n|---|---|---|---|");
    for model in ["arc", "spiral"] {
        let [with, without] = ["grid", "none"].map(|index| fastest(|| total(&options(model, index, 1000.0))));
        let mut done = Trajectories::new(&options(model, "grid", 1000.0), 0).expect("options");
        done.step(u64::MAX);
        println!("| {model} | {with:.2} | {without:.2} | {} |", done.tally().iterations);
    }
    println!("\nMicroseconds per accepted trajectory, arcs, the fastest of {RUNS} runs; tries per accepted\n");
    println!("| accepted | grid | none | tries |\n|---|---|---|---|");
    let ends = [100, 250, 500, 1000, 1500, 2000];
    let [with, without] = ["grid", "none"].map(|index| growth(index, &ends));
    for (i, end) in ends.iter().enumerate() {
        println!("| to {end} | {:.2} | {:.2} | {:.2} |", with[i].0, without[i].0, with[i].1);
    }
}

fn options(model: &str, index: &str, count: f64) -> Vec<(String, Value)> {
    let word = |name: &str, word: &str| (name.to_owned(), Value::Text(word.to_owned()));
    vec![word("model", model), word("index", index), ("count".to_owned(), Value::Number(count))]
}

/// Milliseconds of a whole run.
fn total(options: &[(String, Value)]) -> f64 {
    let begun = Instant::now();
    let mut trajectories = Trajectories::new(options, 0).expect("options");
    assert_eq!(trajectories.step(u64::MAX), Status::Solved);
    begun.elapsed().as_secs_f64() * 1e3
}

/// Microseconds and tries per accepted trajectory between each of these counts and the one before.
fn growth(index: &str, ends: &[usize]) -> Vec<(f64, f64)> {
    let mut times = vec![Vec::new(); ends.len()];
    let mut tries = vec![0.0; ends.len()];
    for _ in 0..RUNS {
        let most = *ends.last().expect("an end") as f64;
        let mut trajectories = Trajectories::new(&options("arc", index, most), 0).expect("options");
        let mut from = 0;
        for (i, &end) in ends.iter().enumerate() {
            let (begun, before) = (Instant::now(), trajectories.tally().iterations);
            while trajectories.accepted_count() < end {
                trajectories.step(1);
            }
            let accepted = (end - from) as f64;
            times[i].push(begun.elapsed().as_secs_f64() * 1e6 / accepted);
            tries[i] = (trajectories.tally().iterations - before) as f64 / accepted;
            from = end;
        }
    }
    times.into_iter().zip(tries).map(|(times, tries)| (least(&times), tries)).collect()
}

fn fastest(mut measure: impl FnMut() -> f64) -> f64 {
    least(&(0..RUNS).map(|_| measure()).collect::<Vec<_>>())
}

fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::MAX, f64::min)
}
