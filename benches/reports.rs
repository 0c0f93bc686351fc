//! The roadmaps of the course reports and RRT-Connect on generated triangle forests: milliseconds, medians.
//!
//! `cargo bench --bench reports` prints a table; `-- --json` the same as JSON. A run pinned to one core is quieter.

use planarium::run::{Options, Run, Status, Value, start};
use planarium::scenario::Scenario;
use std::time::Instant;

/// Forests for each number of links.
const FORESTS: u64 = 5;

/// Roadmaps for each forest.
const REPEATS: u64 = 7;

fn main() {
    println!("| planner | arm | median ms | quartiles | solved | motions | edges or vertices |");
    println!("|---|---|---|---|---|---|---|");
    for links in [2u64, 3, 4] {
        let forests: Vec<Scenario> = (0..FORESTS).map(|seed| forest(links, seed)).collect();
        let samples = (300 * links - 200) as f64;
        let roadmap = [("samples", samples), ("k", 30.0)];
        let runs = forests.iter().flat_map(|world| (0..REPEATS).map(move |seed| time(world, "prm", seed, &roadmap)));
        row("k-PRM", links, runs.collect());
        let runs = forests.iter().flat_map(|world| (0..100).map(move |seed| time(world, "rrt-connect", seed, &[])));
        row("RRT-Connect", links, runs.collect());
    }
}

/// Seconds to the end of one run, whether it was solved, and its counts.
struct Timing {
    seconds: f64,
    is_solved: bool,
    motions: u64,
    size: u64,
}

fn time(world: &Scenario, planner: &str, seed: u64, parameters: &[(&str, f64)]) -> Timing {
    let parameters = parameters.iter().map(|&(name, value)| (name.to_owned(), Value::Number(value))).collect();
    let options = Options { planner: Some(planner.to_owned()), query: None, seed, parameters };
    let began = Instant::now();
    let mut run: Box<dyn Run> = start(world, &options).expect("a forest leaves start and goal free");
    // A search for a path that does not exist would only measure the budget.
    run.step(20_000);
    let seconds = began.elapsed().as_secs_f64();
    let stats = run.stats();
    let size = if planner == "prm" { stats.edges } else { stats.vertices };
    Timing { seconds, is_solved: run.status() == Status::Solved, motions: stats.motion_checks, size }
}

fn row(planner: &str, links: u64, runs: Vec<Timing>) {
    // Unsolved single queries measure the budget; unsolved roadmaps are built all the same.
    let kept: Vec<&Timing> = runs.iter().filter(|run| planner == "k-PRM" || run.is_solved).collect();
    let of = |what: fn(&Timing) -> f64| -> Vec<f64> {
        let mut values: Vec<f64> = kept.iter().map(|run| what(run)).collect();
        values.sort_by(f64::total_cmp);
        values
    };
    let at = |values: &[f64], part: f64| values[((values.len() - 1) as f64 * part).round() as usize];
    let (seconds, motions, size) =
        (of(|run| run.seconds * 1e3), of(|run| run.motions as f64), of(|run| run.size as f64));
    println!(
        "| {planner} | {links}R | {:.4} | {:.4} to {:.4} | {} of {} | {} | {} |",
        at(&seconds, 0.5),
        at(&seconds, 0.25),
        at(&seconds, 0.75),
        runs.iter().filter(|run| run.is_solved).count(),
        runs.len(),
        at(&motions, 0.5),
        at(&size, 0.5)
    );
}

fn forest(links: u64, seed: u64) -> Scenario {
    let options = serde_json::json!({ "links": links, "seed": seed });
    planarium::scenario::generate::generate("forest", &options).expect("a forest can be generated")
}
