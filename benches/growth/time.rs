//! Time of a k-PRM, from the scenario to the path, against one quantity at a time.

use planarium::geometry::Point;
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::run::{Options, Run, Status, Value, start};
use planarium::scenario::{Scenario, generate::generate};
use serde_json::{Value as Json, json};
use std::time::Instant;

/// Samples if another quantity grows.
const SAMPLES: u64 = 2000;

/// Neighbours if another quantity grows.
const K: u64 = 15;

/// A case of a table: the quantity that grows, a world with it, samples and neighbours.
struct Case {
    x: u64,
    world: Scenario,
    samples: u64,
    k: u64,
}

/// Prints the four tables.
pub fn print(is_quick: bool) {
    let case = |x| Case { x, world: forest(3), samples: SAMPLES, k: K };
    let most = if is_quick { 3000 } else { 100_000 };
    let samples = [1000, 3000, 10_000, 30_000, 100_000].into_iter().filter(|&n| n <= most);
    table(
        "samples",
        "3R forest, k = 15. A sample queries the kd-tree once, O(log n + k), and tries about 8.5 motions however many samples \
         there are; these get shorter, like n^(-1/3), and so cheaper to prove, which the deeper tree offsets.",
        samples.map(|n| Case { samples: n, ..case(n) }),
    );
    table(
        "k",
        "3R forest, n = 2000. Motions are linear in k, and farther neighbours are more expensive to prove, or refused early; \
         the fixed cost of sampling, the search and queries to the index keeps the exponent below 1.",
        [5, 10, 20, 40, 80].map(|k| Case { k, ..case(k) }).into_iter(),
    );
    table(
        "links",
        "Forests with four triangles per link, n = 2000, k = 15. A motion moves l links among 4 l triangles, which would be l^2 \
         without the boxes; and in more dimensions neighbours lie farther apart. Arrays have 2, 4 or 8 entries.",
        (1..=8).map(|links| Case { world: forest(links), ..case(links) }),
    );
    let most = if is_quick { 256 } else { 4096 };
    let counts = [4, 16, 64, 256, 1024, 4096].into_iter().filter(|&count| count <= most);
    table(
        "obstacles",
        "3R arm among equal triangles whose total width does not depend on their number, so that about as many samples are \
         free but more and more motions are not; n = 2000, k = 15. The steps from 256 on show the limit: linear, were every \
         obstacle examined for every motion.",
        counts.map(|count| Case { world: gravel(count), ..case(count) }),
    );
}

fn table(what: &str, sentence: &str, cases: impl Iterator<Item = Case>) {
    println!("\nk-PRM against {what}. {sentence}\n");
    println!(
        "| {what} | ms | us per motion | samples tried | motions | edges | status |\n|---|---|---|---|---|---|---|"
    );
    let mut points = Vec::new();
    for Case { x, world, samples, k } in cases {
        let mut times = Vec::new();
        let mut last = None;
        // Long runs are disturbed less, and repeating them is expensive.
        for seed in 0..if samples > 10_000 { 1 } else { 5 } {
            let began = Instant::now();
            let run = roadmap(&world, seed, samples, k);
            times.push(began.elapsed().as_secs_f64());
            last = Some((run.stats(), run.status()));
        }
        times.sort_by(f64::total_cmp);
        let (seconds, (stats, status)) = (times[times.len() / 2], last.expect("there was a run"));
        let each = seconds * 1e6 / stats.motion_checks as f64;
        let (milliseconds, tried) = (seconds * 1e3, stats.configuration_checks);
        println!(
            "| {x} | {milliseconds:.2} | {each:.2} | {tried} | {} | {} | {status:?} |",
            stats.motion_checks, stats.edges
        );
        points.push((x as f64, seconds));
    }
    println!("\nExponent: {:.2}.", exponent(&points));
}

/// A k-PRM at its end.
pub fn roadmap(world: &Scenario, seed: u64, samples: u64, k: u64) -> Box<dyn Run> {
    let parameters = [("samples", samples), ("k", k), ("max_iterations", 4_000_000_000)];
    let parameters = parameters.map(|(name, value)| (name.to_owned(), Value::Number(value as f64))).to_vec();
    let options = Options { planner: Some("prm".to_owned()), query: None, seed, parameters };
    let mut run = start(world, &options).expect("start and goal are free");
    while run.step(u64::MAX) == Status::Running {}
    run
}

/// The slope of the line that fits best through the logarithms.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let products = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>();
    products / logs.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>()
}

pub fn forest(links: u64) -> Scenario {
    generate("forest", &json!({ "links": links })).expect("a forest can be generated")
}

/// Equal triangles anywhere within the arm's reach except on the arm at start and goal. Their widths add up to 4 m, so that a link
/// meets about as many for any number.
fn gravel(count: u64) -> Scenario {
    let reach = 3.0;
    let size = 4.0 / count as f64;
    let (start, goal) = ([1.0, 0.5, 5.0], [4.0, 1.0, 1.0]);
    let arm = Arm::new(Point::origin(), vec![1.0; 3], 0.0, None).expect("an arm");
    // Points of the arm, a tenth of a link apart.
    let points = |q: &[f64]| {
        let joints = arm.joints(q);
        (0..=30).map(move |i| joints[i / 10].lerp(&joints[i / 10 + 1], (i % 10) as f64 / 10.0))
    };
    let clear: Vec<Point> = points(&start).chain(points(&goal)).collect();
    let mut random = Random::new(1, Stream::Scenario);
    let mut obstacles: Vec<Json> = Vec::new();
    while obstacles.len() < count as usize {
        let [x, y] = std::array::from_fn(|_| reach * (2.0 * random.uniform() - 1.0));
        if clear.iter().all(|p| (p.x - x).hypot(p.y - y) > size + 0.1) {
            let corners = [[x - size / 2.0, y - size / 2.0], [x + size / 2.0, y - size / 2.0], [x, y + size / 2.0]];
            obstacles.push(json!({ "type": "polygon", "vertices": corners }));
        }
    }
    let document = json!({
        "format": "planarium-scenario-1", "name": "gravel", "world": { "obstacles": obstacles },
        "robot": { "type": "arm", "base": [0, 0], "links": [1, 1, 1] },
        "queries": [{ "name": "across", "start": start, "goal": goal }],
    });
    Scenario::parse(&document.to_string()).expect("gravel is a scenario")
}
