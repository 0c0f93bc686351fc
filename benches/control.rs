//! Planning by controls: the cars of generated worlds. Milliseconds to a path, motions tried, lengths.
//!
//! `cargo bench --bench control` prints a table for the defaults and the presets; `-- "rrt-control blossom=3" "sst"` one for these
//! settings; `-- --scenarios FILE...` before them takes other worlds. A run pinned to one core is quieter.

use planarium::planner::{PlannerKind, RrtControlOptions};
use planarium::run::{Options, Status, Value, start};
use planarium::scenario::{Scenario, generate::generate};
use serde_json::json;
use std::time::Instant;

/// Seeds for each world.
const SEEDS: u64 = 20;

/// Worlds of each generator.
const WORLDS: u64 = 4;

/// The most iterations of a run.
const MOST: u64 = 20_000;

fn main() {
    let mut arguments: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let mut worlds = Vec::new();
    if arguments.first().is_some_and(|word| word == "--scenarios") {
        arguments.remove(0);
        while arguments.first().is_some_and(|word| word.ends_with(".json")) {
            let text = std::fs::read_to_string(arguments.remove(0)).expect("a file");
            worlds.push(Scenario::parse(&text).expect("a scenario"));
        }
    } else {
        for kind in ["clutter", "discs", "gap"] {
            let world = |seed| generate(kind, &json!({ "robot": "car", "seed": seed })).expect("a world");
            worlds.extend((0..WORLDS).map(world));
        }
    }
    if arguments.is_empty() {
        arguments = ["rrt-control", "sst"].map(str::to_owned).to_vec();
        for preset in RrtControlOptions::INFO.presets {
            arguments.push(format!("rrt-control {}", preset.settings));
        }
    }
    println!("| settings | solved | ms: median | 95 % | mean | motions: median | 95 % | length |");
    println!("|---|---|---|---|---|---|---|---|");
    for line in arguments {
        let (mut times, mut motions, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        for world in &worlds {
            for query in world.queries() {
                for seed in 0..SEEDS {
                    let options = options(&line, &query.name, seed);
                    let began = Instant::now();
                    let mut run = start(world, &options).unwrap_or_else(|error| panic!("{error}"));
                    run.step(MOST);
                    times.push(began.elapsed().as_secs_f64() * 1e3);
                    motions.push(run.stats().motion_checks as f64);
                    if run.status() == Status::Solved {
                        lengths.push(run.length());
                    }
                }
            }
        }
        let (runs, solved, mean) = (times.len(), lengths.len(), times.iter().sum::<f64>() / times.len() as f64);
        let [(half, most), (few, many), (length, _)] =
            [&mut times, &mut motions, &mut lengths].map(|values| quantiles(values));
        println!("| {line} | {solved} of {runs} | {half:.2} | {most:.2} | {mean:.2} | {few} | {many} | {length:.2} |");
    }
}

/// The median and the 95th percentile.
fn quantiles(values: &mut [f64]) -> (f64, f64) {
    values.sort_by(f64::total_cmp);
    let at = |part: f64| values.get(((values.len() as f64 - 1.0) * part) as usize).copied().unwrap_or(f64::NAN);
    (at(0.5), at(0.95))
}

/// Planner and settings in a line.
fn options(line: &str, query: &str, seed: u64) -> Options {
    let mut words = line.split_whitespace();
    let planner = words.next().map(str::to_owned);
    let parameters = words.map(|word| {
        let (name, value) = word.split_once('=').expect("name=value");
        (name.to_owned(), Value::from_text(value))
    });
    Options { planner, query: Some(query.to_owned()), seed, parameters: parameters.collect() }
}
