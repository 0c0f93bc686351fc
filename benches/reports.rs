//! The roadmaps of the course reports and RRT-Connect on generated triangle forests: milliseconds, medians.
//!
//! `cargo bench --bench reports` prints a table. A run pinned to one core is quieter.

use planarium::run::{Options, Status, Value, start};
use planarium::scenario::{Scenario, generate::generate};
use serde_json::json;
use std::time::Instant;

/// Forests for each number of links.
const FORESTS: u64 = 5;

/// Roadmaps for each forest.
const REPEATS: u64 = 7;

fn main() {
    println!("| planner | arm | median ms | quartiles | solved | motions | edges or vertices |");
    println!("|---|---|---|---|---|---|---|");
    for links in [2u64, 3, 4] {
        let forest = |seed| generate("forest", &json!({ "links": links, "seed": seed })).expect("a forest");
        let forests: Vec<Scenario> = (0..FORESTS).map(forest).collect();
        let samples = (300 * links - 200) as f64;
        row("k-PRM", "prm", &forests, REPEATS, &[("samples", samples), ("k", 30.0)]);
        row("RRT-Connect", "rrt-connect", &forests, 100, &[]);
    }
}

/// Runs the planner on every forest, so often, and prints their row.
fn row(name: &str, planner: &str, forests: &[Scenario], repeats: u64, parameters: &[(&str, f64)]) {
    let parameters: Vec<_> = parameters.iter().map(|&(name, value)| (name.to_owned(), Value::Number(value))).collect();
    let (mut solved, mut columns) = (0, [(); 3].map(|()| Vec::new()));
    for world in forests {
        for seed in 0..repeats {
            let options =
                Options { planner: Some(planner.to_owned()), query: None, seed, parameters: parameters.clone() };
            let began = Instant::now();
            let mut run = start(world, &options).expect("a forest leaves start and goal free");
            // A search for a path that does not exist would only measure the budget.
            run.step(20_000);
            let seconds = began.elapsed().as_secs_f64();
            let (stats, is_solved) = (run.stats(), run.status() == Status::Solved);
            solved += usize::from(is_solved);
            // Unsolved single queries measure the budget; unsolved roadmaps are built all the same.
            if planner == "prm" || is_solved {
                let size = if planner == "prm" { stats.edges } else { stats.vertices };
                let numbers = [seconds * 1e3, stats.motion_checks as f64, size as f64];
                columns.iter_mut().zip(numbers).for_each(|(column, number)| column.push(number));
            }
        }
    }
    columns.iter_mut().for_each(|column| column.sort_by(f64::total_cmp));
    let at = |column: usize, part: f64| columns[column][((columns[column].len() - 1) as f64 * part).round() as usize];
    let ([low, median, high], [motions, size]) =
        ([0.25, 0.5, 0.75].map(|part| at(0, part)), [1, 2].map(|i| at(i, 0.5)));
    let (links, runs) = (forests[0].robot().dimension(), forests.len() as u64 * repeats);
    println!("| {name} | {links}R | {median:.4} | {low:.4} to {high:.4} | {solved} of {runs} | {motions} | {size} |");
}
