//! Time against one quantity at a time, and how fast it grows.

use planarium::fleet::{FleetPlanner, Generator, HallOptions, PbsOptions};
use planarium::geometry::Point;
use planarium::graph::VertexId;
use planarium::nearest::{Index, LinearScan, Nearest, Query};
use planarium::problem::Stepped;
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::run::{Options, Phase, PlannerOptions, Run, Status, Value, start};
use planarium::scenario::{Scenario, generate::generate};
use planarium::space::{Coordinate, Metric, ProductSpace, Space};
use serde::{Deserialize, Serialize};
use serde_json::{Value as Json, json};
use std::hint::black_box;
use std::time::Instant;

/// The seed of all runs.
const SEED: u64 = 1;

/// Samples if another quantity grows.
const SAMPLES: u64 = 2000;

/// Neighbours if another quantity grows.
const K: u64 = 15;

/// The most repetitions of a measurement, of which the fastest counts: the least disturbed one.
const REPETITIONS: usize = 7;

/// Seconds after which a measurement is not repeated.
const ENOUGH: f64 = 2.0;

/// Queries to an index that are timed together.
const QUERIES: usize = 1000;

/// Iterations between two readings of the clock.
const SLICE: u64 = 32;

/// Sizes of roadmaps, trees and indexes.
const SIZES: [u64; 7] = [1000, 3000, 10_000, 30_000, 100_000, 300_000, 1_000_000];

/// Time against a quantity.
#[derive(Serialize, Deserialize)]
pub struct Curve {
    /// What grows, as the label of an axis.
    pub quantity: String,
    pub name: String,
    pub points: Vec<Measured>,
}

/// A point of a curve.
#[derive(Serialize, Deserialize)]
pub struct Measured {
    pub x: u64,
    pub seconds: f64,
    /// Motions tested, of a planner.
    pub motions: Option<u64>,
}

impl Curve {
    fn new(quantity: &str, name: &str, points: Vec<Measured>) -> Self {
        Self { quantity: quantity.to_owned(), name: name.to_owned(), points }
    }

    /// The slope of the line that fits best through the logarithms: e if the time grows like x^e.
    pub fn exponent(&self) -> f64 {
        let logs: Vec<(f64, f64)> = self.points.iter().map(|p| ((p.x as f64).ln(), p.seconds.ln())).collect();
        let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / logs.len() as f64;
        let (x, y) = (mean(|p| p.0), mean(|p| p.1));
        let products = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>();
        products / logs.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>()
    }
}

/// Measures all curves; those of a quantity follow one another.
pub fn curves(is_quick: bool) -> Vec<Curve> {
    let most = if is_quick { 3000 } else { 1_000_000 };
    let sizes: Vec<u64> = SIZES.into_iter().filter(|&n| n <= most).collect();
    let counts = [10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000];
    let counts: Vec<u64> = counts.into_iter().filter(|&n| n <= most / 10).collect();
    let robots: Vec<u64> = [10, 20, 50, 100, 200].into_iter().filter(|&n| n <= most / 100).collect();
    [roadmaps(&sizes), trees(&sizes), queries(&sizes), obstacles(&counts), neighbours(), links(), fleets(&robots)]
        .into_iter()
        .flatten()
        .collect()
}

/// A k-PRM and the search in it, and PRM*.
fn roadmaps(sizes: &[u64]) -> Vec<Curve> {
    let quantity = "samples of a roadmap (3 links)";
    let world = forest(3);
    let (mut built, mut searched) = (Vec::new(), Vec::new());
    for &x in sizes {
        let [mut build, mut search] = [f64::INFINITY; 2];
        let run = fastest(|| {
            let began = Instant::now();
            let mut run = prm(&world, x, K);
            while run.phase() != Phase::Searching && run.step(SLICE) == Status::Running {}
            let half = began.elapsed().as_secs_f64();
            while run.step(u64::MAX) == Status::Running {}
            build = build.min(half);
            search = search.min(began.elapsed().as_secs_f64() - half);
            run
        });
        let motions = Some(run.1.stats().motion_checks);
        built.push(Measured { x, seconds: build, motions });
        searched.push(Measured { x, seconds: search, motions: None });
    }
    // A tenth of the samples: its neighbours grow with their number.
    let star = sizes
        .iter()
        .filter(|&&n| n <= 100_000)
        .map(|&x| whole(x, || begin(&world, "prm-star", SEED, &[("samples", x)])));
    vec![
        Curve::new(quantity, "k-PRM, k = 15", built),
        Curve::new(quantity, "PRM*", star.collect()),
        Curve::new(quantity, "search in the k-PRM (A*)", searched),
    ]
}

/// Trees that never reach their goal: the time until they have a number of vertices.
fn trees(sizes: &[u64]) -> Vec<Curve> {
    let quantity = "vertices of a tree (3 links, a car)";
    let (arm, car) = (divided(), parted());
    let tree = |name, planner, world: &Scenario| {
        let mut points: Vec<Measured> =
            sizes.iter().map(|&x| Measured { x, seconds: f64::INFINITY, motions: None }).collect();
        fastest(|| {
            let began = Instant::now();
            let mut run = begin(world, planner, SEED, &[]);
            for point in &mut points {
                while (run.vertex_count() as u64) < point.x {
                    assert_eq!(run.step(SLICE), Status::Running, "the goal cannot be reached");
                }
                point.seconds = point.seconds.min(began.elapsed().as_secs_f64());
                point.motions = Some(run.stats().motion_checks);
            }
        });
        Curve::new(quantity, name, points)
    };
    vec![
        tree("RRT", "rrt", &arm),
        tree("RRT-Connect", "rrt-connect", &arm),
        tree("RRT by controls", "rrt-control", &car),
    ]
}

/// One query to an index of states on the 3-torus.
fn queries(sizes: &[u64]) -> Vec<Curve> {
    let quantity = "states in an index (3-torus)";
    let space = ProductSpace::<4>::new(&[Coordinate::Circle; 3], Metric::Sum);
    let mut random = Random::new(1, Stream::Samples);
    let mut states = |count: u64| -> Vec<_> { (0..count).map(|_| space.sample(&mut random)).collect() };
    let asked = states(QUERIES as u64);
    let mut curves =
        ["nearest", "15 nearest", "15 nearest by a scan"].map(|name| Curve::new(quantity, name, Vec::new()));
    for &x in sizes {
        let (mut index, mut scan) = (Index::default(), LinearScan::default());
        let states = states(x);
        for (i, state) in states.iter().enumerate() {
            index.insert(&space, VertexId(i as u32), state);
            scan.insert(&space, VertexId(i as u32), state);
        }
        let few = &asked[..(10_000_000 / x as usize).min(QUERIES)];
        let times = [
            each(&index, &space, &states, &asked, 1),
            each(&index, &space, &states, &asked, K as usize),
            each(&scan, &space, &states, few, K as usize),
        ];
        for (curve, seconds) in curves.iter_mut().zip(times) {
            curve.points.push(Measured { x, seconds, motions: None });
        }
    }
    curves.into()
}

/// Seconds per query.
fn each<S: Space>(index: &impl Nearest<S>, space: &S, states: &[S::State], asked: &[S::State], k: usize) -> f64 {
    let mut found = Vec::new();
    let (seconds, ()) = fastest(|| {
        for state in asked {
            index.k_nearest(Query::to(space, states, state), k, &mut found);
            black_box(&found);
        }
    });
    seconds / asked.len() as f64
}

/// A k-PRM, and what comes before it, among more and more obstacles.
fn obstacles(counts: &[u64]) -> Vec<Curve> {
    let quantity = "obstacles (3 links, 2000 samples)";
    let roadmap = counts.iter().map(|&x| {
        let world = gravel(x);
        whole(x, || prm(&world, SAMPLES, K))
    });
    let set_up = counts.iter().map(|&x| {
        let world = gravel(x);
        let (seconds, _) = fastest(|| prm(&world, SAMPLES, K));
        Measured { x, seconds, motions: None }
    });
    vec![Curve::new(quantity, "k-PRM, k = 15", roadmap.collect()), Curve::new(quantity, "its set-up", set_up.collect())]
}

fn neighbours() -> Vec<Curve> {
    let world = forest(3);
    let points = [2, 4, 8, 16, 32, 64, 128].map(|k| whole(k, || prm(&world, SAMPLES, k)));
    vec![Curve::new("neighbours k (3 links, 2000 samples)", "k-PRM", points.into())]
}

fn links() -> Vec<Curve> {
    let points = (2..=8).map(|links| {
        let world = forest(links);
        whole(links, || prm(&world, SAMPLES, K))
    });
    vec![Curve::new("links (2000 samples)", "k-PRM, k = 15", points.collect())]
}

/// A plan for discs that cross an open hall, 4 m² for each, with its roadmap.
fn fleets(counts: &[u64]) -> Vec<Curve> {
    let plan = |&x: &u64| {
        let hall = HallOptions { count: x as usize, seed: SEED, ..HallOptions::default() };
        let fleet = hall.generate().expect("a hall can be generated");
        let (seconds, ()) = fastest(|| {
            let mut planner = FleetPlanner::new(&fleet, PbsOptions::default()).expect("a planner of the fleet");
            assert_eq!(planner.step(u64::MAX), Status::Solved, "a hall of {x} robots has a plan");
        });
        Measured { x, seconds, motions: None }
    };
    vec![Curve::new("robots of a fleet (an open hall)", "a plan by pbs", counts.iter().map(plan).collect())]
}

/// The point of a run from its set-up to its end.
fn whole(x: u64, begin: impl Fn() -> Box<dyn Run>) -> Measured {
    let (seconds, run) = fastest(|| to_end(begin()));
    Measured { x, seconds, motions: Some(run.stats().motion_checks) }
}

/// The seconds of the fastest of several repetitions, and the last result.
fn fastest<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let (mut least, mut total) = (f64::INFINITY, 0.0);
    for repetition in 1.. {
        let began = Instant::now();
        let made = work();
        let seconds = began.elapsed().as_secs_f64();
        (least, total) = (seconds.min(least), total + seconds);
        if repetition == REPETITIONS || total > ENOUGH {
            return (least, made);
        }
    }
    unreachable!("the last repetition returns")
}

/// A run at its beginning.
fn begin(world: &Scenario, planner: &str, seed: u64, parameters: &[(&str, u64)]) -> Box<dyn Run> {
    let parameters = parameters.iter().chain(&[("max_iterations", 1_000_000_000)]);
    let parameters =
        parameters.map(|&(name, value)| (name.to_owned(), Value::Number(value as f64))).collect::<Vec<_>>();
    let planner = PlannerOptions::read(planner, &parameters).expect("options of the planner");
    start(world, &Options { seed, ..Options::new(planner) }).expect("start and goal are free")
}

fn prm(world: &Scenario, samples: u64, k: u64) -> Box<dyn Run> {
    begin(world, "prm", SEED, &[("samples", samples), ("k", k)])
}

fn to_end(mut run: Box<dyn Run>) -> Box<dyn Run> {
    while run.step(u64::MAX) == Status::Running {}
    run
}

/// A k-PRM at its end.
pub fn roadmap(world: &Scenario, seed: u64, samples: u64, k: u64) -> Box<dyn Run> {
    to_end(begin(world, "prm", seed, &[("samples", samples), ("k", k)]))
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
            obstacles.push(polygon(&[
                [x - size / 2.0, y - size / 2.0],
                [x + size / 2.0, y - size / 2.0],
                [x, y + size / 2.0],
            ]));
        }
    }
    arm_of_three(obstacles, &start, &goal)
}

/// An arm between two walls: its first link cannot pass them, so the goal below is out of reach.
fn divided() -> Scenario {
    let wall = |from: f64, to: f64| rectangle([from, -0.02], [to, 0.02]);
    let stones = [[-1.5, 1.2], [-0.7, 1.6], [1.4, 1.0]].map(|[x, y]| rectangle([x, y], [x + 0.3, y + 0.3]));
    let obstacles = [wall(-3.5, -0.2), wall(0.2, 3.5)].into_iter().chain(stones).collect();
    arm_of_three(obstacles, &[1.0, 0.5, 0.5], &[-1.0, -0.5, -0.5])
}

/// A car and its goal on two sides of a wall.
fn parted() -> Scenario {
    let stones = [[0.3, 1.0], [0.8, 0.3], [0.9, 1.4]].map(|[x, y]| rectangle([x, y], [x + 0.2, y + 0.2]));
    let obstacles: Vec<Json> = [rectangle([1.4, 0.0], [1.45, 2.0])].into_iter().chain(stones).collect();
    let document = json!({
        "format": "planarium-scenario-1", "name": "parted",
        "world": { "bounds": { "min": [0, 0], "max": [2, 2] }, "obstacles": obstacles },
        "robot": {
            "type": "car", "shape": rectangle([-0.1, -0.05], [0.1, 0.05]), "wheelbase": 0.2, "speed": [-0.5, 0.5],
            "steering": [-0.7, 0.7], "integration_step": 0.01,
        },
        "queries": [{
            "name": "across", "start": [0.25, 0.25, 0], "goal": [1.75, 1.75, 0],
            "goal_tolerance": { "translation": 0.1, "rotation": 0.5 },
        }],
    });
    Scenario::parse(&document.to_string()).expect("a scenario")
}

fn arm_of_three(obstacles: Vec<Json>, start: &[f64], goal: &[f64]) -> Scenario {
    let document = json!({
        "format": "planarium-scenario-1", "name": "arm", "world": { "obstacles": obstacles },
        "robot": { "type": "arm", "base": [0, 0], "links": [1, 1, 1] },
        "queries": [{ "name": "across", "start": start, "goal": goal }],
    });
    Scenario::parse(&document.to_string()).expect("a scenario")
}

fn rectangle([left, bottom]: [f64; 2], [right, top]: [f64; 2]) -> Json {
    polygon(&[[left, bottom], [right, bottom], [right, top], [left, top]])
}

fn polygon(vertices: &[[f64; 2]]) -> Json {
    json!({ "type": "polygon", "vertices": vertices })
}
