//! Paths of a disc that keep away from obstacles: their costs by closed forms, beside a fine grid, and what is refused.

use crate::common::documents::{disc, disc_among, judged, rectangle, refuses};
use crate::common::{assert_valid, begin_with, cases, finish, options, requests};
use planarium::PlanningWorld;
use planarium::path::PathCost;
use planarium::random::{Random, Stream};
use planarium::run::inspect::Inspector;
use planarium::run::{HISTORY_WIDTH, Run, Status};
use planarium::scenario::Scenario;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use wasm_bindgen_test::wasm_bindgen_test;

const WEIGHT: f64 = 3.0;
const WITHIN: f64 = 1.5;

/// Every planner that goes on to cheaper paths, or takes the cheapest of what it has, with what it needs to come near the best:
/// on average to this share of it.
const PLANNERS: [(&str, &str, f64); 8] = [
    ("bit-star", "improve_iterations=8000", 1.02),
    ("rrt-star", "improve_iterations=600", 1.04),
    ("informed-rrt-star", "improve_iterations=600", 1.05),
    ("aorrtc", "improve_iterations=3000", 1.1),
    ("lazy-prm-star", "improve_iterations=8000", 1.02),
    ("fmt-star", "samples=1500", 1.05),
    ("prm", "samples=1500", 1.05),
    ("lazy-prm", "samples=1500", 1.05),
];

fn world(obstacles: &[String], ends: [[f64; 2]; 2]) -> Scenario {
    disc_among("[0, 0], [10, 10]", obstacles, 0.25, ends)
}

/// A run to its end, whose result the verifier accepts, and its cost.
fn cost(world: &Scenario, planner: &str, settings: &str) -> Option<(Box<dyn Run>, f64)> {
    let settings = format!("clearance_weight={WEIGHT} clearance_within={WITHIN} {settings}");
    let mut run = begin_with(world, planner, 1, &settings);
    run.record().expect("nothing is done yet");
    run.step(u64::MAX);
    let result = run.result();
    if result.path.is_empty() {
        return None;
    }
    assert_valid(world, &*run);
    let cost = result.cost.expect("a cost besides the length");
    assert_eq!([cost.weight, cost.within], [WEIGHT, WITHIN]);
    assert!(cost.value >= result.length);
    Some((run, cost.value))
}

#[wasm_bindgen_test(unsupported = test)]
fn costs_with_a_closed_form() {
    // Along a floor at a clearance of 0.75, half of what counts; away from it nothing is added.
    let floor = [rectangle([-1.0, -1.0], [11.0, 1.0])];
    for (height, added) in [(2.0, 0.5), (1.25, 1.0), (2.75, 0.0), (6.0, 0.0)] {
        let world = world(&floor, [[1.0, height + 1e-9], [9.0, height + 1e-9]]);
        let (_, cost) = cost(&world, "rrt", "").expect("a straight motion");
        assert!((cost - 8.0 * (1.0 + WEIGHT * added)).abs() < 1e-6, "{cost} at {height}");
    }
    // Straight up: the integral of 1 - c / within, in which every other piece is halved at its middle.
    let up = world(&floor, [[5.0, 1.25 + 1e-9], [5.0, 9.0]]);
    let (_, cost) = cost(&up, "rrt", "").expect("a straight motion");
    assert!((cost - (7.75 + WEIGHT * 0.5 * WITHIN)).abs() < 0.01, "{cost}");
}

/// The least cost over a grid of this many lines a side, whose vertices are connected to 32 others.
fn on_grid(world: &Scenario, lines: usize, [start, goal]: [[usize; 2]; 2]) -> f64 {
    let inspector = Inspector::new(world);
    let step = 10.0 / (lines - 1) as f64;
    let at = |i: usize| [(i % lines) as f64 * step, (i / lines) as f64 * step];
    let density = |i: usize| {
        let clearance = inspector.clearance(&at(i)).ok().flatten();
        clearance.map_or(f64::INFINITY, |found| 1.0 + WEIGHT * (1.0 - found.distance / WITHIN).max(0.0))
    };
    let densities: Vec<f64> = (0..lines * lines).map(density).collect();
    let coprime = |a: i32, b: i32| (1..=a.abs().max(b.abs())).filter(|k| a % k == 0 && b % k == 0).max() == Some(1);
    let moves: Vec<[i32; 2]> =
        (-4..=4).flat_map(|x| (-4..=4).map(move |y| [x, y])).filter(|&[x, y]| coprime(x, y)).collect();
    let mut costs = vec![f64::INFINITY; lines * lines];
    let mut open = BinaryHeap::from([(Reverse(0), start[0] + start[1] * lines)]);
    costs[start[0] + start[1] * lines] = 0.0;
    // Costs are not negative, so their bits have their order.
    while let Some((Reverse(bits), from)) = open.pop() {
        if bits > costs[from].to_bits() {
            continue;
        }
        if from == goal[0] + goal[1] * lines {
            break;
        }
        for [x, y] in &moves {
            let to = [(from % lines) as i32 + x, (from / lines) as i32 + y];
            if to.iter().any(|&c| c < 0 || c >= lines as i32) {
                continue;
            }
            let (to, length) = (to[0] as usize + to[1] as usize * lines, step * f64::from(x * x + y * y).sqrt());
            let cost = costs[from] + 0.5 * length * (densities[from] + densities[to]);
            if cost < costs[to] && inspector.first_hit(&at(from), &at(to)).is_ok_and(|hit| hit.is_none()) {
                costs[to] = cost;
                open.push((Reverse(cost.to_bits()), to));
            }
        }
    }
    costs[goal[0] + goal[1] * lines]
}

#[wasm_bindgen_test(unsupported = test)]
fn planners_come_near_the_best_path_of_a_fine_grid() {
    const LINES: usize = 101;
    const LEAST: f64 = 0.97;
    let (mut compared, mut sums) = (0, [0.0; PLANNERS.len()]);
    for seed in 0..cases(100) as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        let mut place = || [0, 1].map(|_| 1.0 + 8.0 * random.uniform());
        let mut obstacles: Vec<String> = (0..4).map(|_| disc(place(), 0.7)).collect();
        obstacles.extend((0..4).map(|_| {
            let [x, y] = place();
            rectangle([x - 0.4, y - 1.0], [x + 0.4, y + 1.0])
        }));
        let world = world(&obstacles, [[0.5, 0.5], [9.5, 9.5]]);
        // An end may be in collision.
        if requests::start(&world, &options("rrt-connect", 1, "")).is_err() {
            continue;
        }
        let mut least = on_grid(&world, LINES, [[5, 5], [95, 95]]);
        // No path, or one through a gap between the lines of the grid.
        if least == f64::INFINITY {
            continue;
        }
        for (i, (planner, settings, _)) in PLANNERS.into_iter().enumerate() {
            let found = cost(&world, planner, settings);
            let (run, cost) = found.unwrap_or_else(|| panic!("seed {seed}: {planner} found no path"));
            if cost <= LEAST * least {
                // A passage between the lines of the grid.
                least = on_grid(&world, 4 * LINES - 3, [[20, 20], [380, 380]]);
            }
            assert!(cost > LEAST * least, "seed {seed}: {planner} {cost}, on the grid {least}");
            sums[i] += cost / least;
            let history = run.history_since(0);
            let costs: Vec<f64> = history.chunks(HISTORY_WIDTH).map(|row| row[HISTORY_WIDTH - 1]).collect();
            assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "{planner}: the cost never rises");
            assert!((costs[costs.len() - 1] - cost).abs() < 1e-9, "{planner}: the last cost is that of the path");
        }
        compared += 1;
    }
    for ((planner, _, most), sum) in PLANNERS.iter().zip(sums) {
        let mean = sum / compared as f64;
        println!("{planner} {mean}");
        assert!(mean < *most, "{planner}: {mean} of the grid's on average");
    }
    assert!(compared * 2 > cases(100), "{compared} worlds");
}

#[wasm_bindgen_test(unsupported = test)]
fn shortcuts_do_not_raise_the_cost() {
    let obstacles = [rectangle([4.0, 2.0], [6.0, 8.0])];
    let world = world(&obstacles, [[1.0, 5.0], [9.0, 5.0]]);
    let (_, raw) = cost(&world, "rrt-connect", "").expect("a path");
    let (_, cut) = cost(&world, "rrt-connect", "reduce=true shortcut=300 partial_shortcut=100").expect("a path");
    assert!(cut < raw, "{cut} of {raw}");
    // Lengths alone lead past the corners.
    let run = finish(begin_with(&world, "rrt-connect", 1, "reduce=true shortcut=300"));
    assert!(run.result().cost.is_none() && run.length() < cut);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_cannot_keep_away_is_refused() {
    let world = world(&[disc([5.0, 5.0], 1.0)], [[1.0, 5.0], [9.0, 5.0]]);
    let start = |settings: &str| requests::start(&world, &options("rrt-star", 1, settings));
    refuses(start("clearance_weight=2 clearance_within=0.004"), "out-of-range", "/clearance_within");
    refuses(start("clearance_weight=-1"), "out-of-range", "/clearance_weight");
    refuses(start("clearance_weight=2 blend=0.5"), "unsupported", "/blend");
    let arm = crate::common::arm_and_wall(0.1);
    let start = requests::start(&arm, &options("rrt-star", 1, "clearance_weight=2"));
    refuses(start, "out-of-range", "/clearance_weight");
}

#[wasm_bindgen_test(unsupported = test)]
fn what_viewers_ask_is_not_counted() {
    let world = world(&[rectangle([4.0, 2.0], [6.0, 8.0])], [[1.0, 5.0], [9.0, 5.0]]);
    for (planner, settings) in [("bit-star", "improve_iterations=300 shortcut=20"), ("prm", "samples=200 shortcut=20")]
    {
        let settings = format!("clearance_weight=2 {settings}");
        let mut run = begin_with(&world, planner, 1, &settings);
        run.record().expect("nothing is done yet");
        while run.status() == Status::Running {
            run.step(7);
            assert!(run.length() >= 0.0 && run.result().cost.is_some());
        }
        let alone = finish(begin_with(&world, planner, 1, &settings));
        assert_eq!(run.stats(), alone.stats(), "{planner}");
        assert_eq!(run.result().to_json(), alone.result().to_json(), "{planner}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_straight_motion_past_something_is_no_cheapest_path() {
    let floor = [rectangle([-1.0, -1.0], [11.0, 1.0])];
    let world = world(&floor, [[1.0, 1.3], [9.0, 1.3]]);
    let (_, straight) = cost(&world, "rrt", "").expect("a straight motion");
    for (planner, settings, _) in PLANNERS {
        let (_, cost) = cost(&world, planner, settings).expect("a path");
        assert!(cost < 0.8 * straight, "{planner}: {cost} of {straight}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn saved_and_reopened_roadmaps_are_searched_by_cost() {
    let world = world(&[rectangle([4.0, 2.0], [6.0, 8.0])], [[1.0, 5.0], [9.0, 5.0]]);
    let weighted = format!("clearance_weight={WEIGHT} clearance_within={WITHIN}");
    for planner in ["prm", "lazy-prm"] {
        let (run, expected) = cost(&world, planner, "samples=400").expect("a path");
        let plain = finish(begin_with(&world, planner, 1, "samples=400"));
        // The weight does not change what is saved.
        let saved = plain.roadmap().expect("a roadmap");
        let resumed = requests::resume(&world, &options(planner, 1, &weighted), &saved).expect("it fits");
        let mut all = vec![finish(resumed)];
        if planner == "lazy-prm" {
            all.push(finish(run.reopen(&PlanningWorld::new(world.clone())).expect("the same world")));
        }
        for again in all {
            assert_valid(&world, &*again);
            let cost = again.result().cost.expect("a cost besides the length").value;
            assert!((cost - expected).abs() < 1e-9, "{planner}: {cost}, {expected} before");
        }
        let resumed = requests::resume(&world, &options(planner, 1, ""), &run.roadmap().expect("a roadmap"));
        let short = finish(resumed.expect("it fits"));
        assert!(short.result().cost.is_none() && (short.length() - plain.length()).abs() < 1e-9, "{planner}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_wrong_cost_is_not_verified() {
    let world = world(&[rectangle([4.0, 2.0], [6.0, 8.0])], [[1.0, 5.0], [9.0, 5.0]]);
    let (run, _) = cost(&world, "rrt-star", "improve_iterations=200").expect("a path");
    let right = run.result();
    let change = |change: &dyn Fn(&mut PathCost)| {
        let mut result = right.clone();
        change(result.cost.as_mut().expect("a cost"));
        judged(&world, &result)
    };
    assert!(change(&|_| {}).is_ok());
    let wrong: [&dyn Fn(&mut PathCost); 7] = [
        &|cost| cost.value *= 1.1,
        &|cost| cost.value *= 0.9,
        &|cost| cost.weight *= 2.0,
        &|cost| cost.weight = 1e308,
        &|cost| cost.within *= 2.0,
        &|cost| cost.within = 1e-9,
        &|cost| cost.value = right.length * 0.99,
    ];
    assert!(wrong.into_iter().all(|wrong| change(wrong).is_err()));
}
