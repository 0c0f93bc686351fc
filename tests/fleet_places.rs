//! Robots that exchange places, and robots that stand where others want to pass: the planner that is chosen by default makes them step
//! aside. Plans are judged by the verifier and by a dense look; where there is none, the reason says what is known.

use crate::common::{cases, deep, sliced};
use crate::fleet::{assert_free, planned};
use planarium::certificate::{Options, Subdivision, Verdict};
use planarium::fleet::{Fleet, FleetOptions, FleetPlanner, FleetReason, generate};
use planarium::options::Value;
use planarium::problem::{Status, Stepped};
use planarium::random::{Random, Stream};
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

fn by_default(fleet: &Fleet, parameters: &[(&str, f64)]) -> FleetPlanner {
    let given: Vec<_> = parameters.iter().map(|(name, value)| ((*name).to_owned(), Value::Number(*value))).collect();
    let options = FleetOptions::default().with(None, &given).expect("options of PBS");
    let mut planner = FleetPlanner::new(fleet, &options).expect("options of the default planner");
    planner.step(u64::MAX);
    planner
}

fn document(size: [f64; 2], obstacles: &Json, robots: &Json) -> Json {
    json!({ "format": "planarium-fleet-1", "name": "places", "robots": robots,
        "world": { "bounds": { "min": [0, 0], "max": size }, "obstacles": obstacles } })
}

fn disc(name: &str, radius: f64, start: [f64; 2], goal: [f64; 2]) -> Json {
    json!({ "name": name, "robot": { "type": "disc", "radius": radius }, "start": start, "goal": goal })
}

#[wasm_bindgen_test(unsupported = test)]
fn robots_on_a_ring_exchange_places() {
    let count = cases(100);
    for case in 0..count {
        let robots = 2 + case * 11 / count;
        let shape = ["disc", "disc", "rectangle"][case % 3];
        let options = json!({ "count": robots, "exchange": true, "shape": shape, "seed": case });
        let planner = by_default(&generate("ring", &options).expect("a ring"), &[]);
        assert_eq!(planner.status(), Status::Solved, "{options}");
        assert_free(&planner, &format!("{options}"));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_planner_by_default_takes_the_first_order_that_works() {
    let fleet = generate("crossroads", &json!({})).expect("crossroads");
    let (planner, ordered) = (by_default(&fleet, &[]), planned(&fleet, "prioritized", 0));
    assert_eq!(planner.result().planner, "pbs");
    for robot in 0..fleet.robots().len() {
        assert_eq!(planner.trajectory(robot), ordered.trajectory(robot));
    }
    assert!(planner.iterations() <= ordered.iterations() + 3 * fleet.robots().len() as u64, "it costs no more");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_robot_that_stands_at_its_goal_steps_aside_and_comes_back() {
    // A corridor with a bay in the middle, where "b" stands already.
    let walls = json!([
        { "type": "polygon", "vertices": [[0, 1], [3, 1], [3, 2.2], [0, 2.2]] },
        { "type": "polygon", "vertices": [[5, 1], [8, 1], [8, 2.2], [5, 2.2]] }
    ]);
    let robots = json!([disc("a", 0.4, [0.6, 0.5], [7.4, 0.5]), disc("b", 0.4, [4.0, 0.5], [4.0, 0.5])]);
    let fleet = Fleet::read(&document([8.0, 2.2], &walls, &robots)).expect("a fleet");
    assert_eq!(planned(&fleet, "prioritized", 0).reason(), Some(FleetReason::NoOrder));
    let planner = by_default(&fleet, &[]);
    assert_eq!(planner.status(), Status::Solved);
    assert_free(&planner, "a bay");
    let aside = planner.trajectory(1).expect("a plan").poses().iter().map(|pose| pose[1]).fold(0.0, f64::max);
    assert!(aside > 1.0, "it went into the bay, not only to {aside}");
}

#[wasm_bindgen_test(unsupported = test)]
fn four_robots_pass_in_a_corridor_with_one_bay() {
    // Two pairs that meet: joint moves only.
    let walls = json!([
        { "type": "polygon", "vertices": [[0, 1], [4, 1], [4, 3], [0, 3]] },
        { "type": "polygon", "vertices": [[6, 1], [10, 1], [10, 3], [6, 3]] }
    ]);
    let robots = json!([
        disc("a", 0.35, [1.6, 0.5], [9.4, 0.5]),
        disc("b", 0.35, [0.6, 0.5], [8.4, 0.5]),
        disc("c", 0.35, [8.4, 0.5], [0.6, 0.5]),
        disc("d", 0.35, [9.4, 0.5], [1.6, 0.5])
    ]);
    let fleet = Fleet::read(&document([10.0, 3.0], &walls, &robots)).expect("a fleet");
    let begin = || FleetPlanner::new(&fleet, FleetOptions::default()).expect("a planner");
    let planner = sliced("two pairs", begin, FleetPlanner::result);
    assert_eq!(planner.status(), Status::Solved);
    assert_free(&planner, "two pairs");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_roadmap_that_is_too_thin_grows_and_says_so_where_it_may_not() {
    // A comb: one way through, around every tooth.
    let tooth = |i: usize| {
        let (x, low) = (1.0 + i as f64, if i.is_multiple_of(2) { 0.0 } else { 0.9 });
        json!({ "type": "polygon", "vertices": [[x, low], [x + 0.2, low], [x + 0.2, low + 5.1], [x, low + 5.1]] })
    };
    let teeth = json!((0..8).map(tooth).collect::<Vec<_>>());
    let robots = json!([disc("a", 0.3, [0.5, 0.5], [9.5, 0.5])]);
    let fleet = Fleet::read(&document([10.0, 6.0], &teeth, &robots)).expect("a fleet");
    let grown = by_default(&fleet, &[("samples", 20.0)]);
    assert_eq!(grown.status(), Status::Solved);
    assert!(grown.stats().vertices > 22);
    let thin = by_default(&fleet, &[("samples", 20.0), ("most_samples", 20.0)]);
    assert_eq!(thin.reason(), Some(FleetReason::NotConnected));
    assert_eq!(thin.blocked().map(|blocked| (blocked.robot, blocked.by)), Some((0, vec![])));
    assert_eq!(thin.stats().vertices, 22);
    let stopped = by_default(&fleet, &[("max_iterations", 10.0)]);
    assert_eq!(stopped.reason(), Some(FleetReason::IterationLimit));
    let text = stopped.result().to_json();
    assert!(text.contains(r#""status":"exhausted","reason":"iteration-limit""#), "{text}");
    assert_eq!(grown.result().reason, None);
}

/// A fleet whose robots go to each other's starts, on a floor with obstacles; `None` if they could not be placed.
fn exchange(seed: u64) -> Option<Fleet> {
    let mut random = Random::new(seed, Stream::Samples);
    let mut draw = |low: f64, high: f64| low + random.uniform() * (high - low);
    let (count, size) = (draw(2.0, 9.0) as usize, [draw(6.0, 12.0), draw(6.0, 12.0)]);
    let obstacles: Vec<Json> = (0..draw(0.0, 8.0) as usize)
        .map(|i| {
            let (x, y, reach) = (draw(0.0, size[0]), draw(0.0, size[1]), draw(0.2, 1.2));
            match i % 3 {
                0 => json!({ "type": "disc", "center": [x, y], "radius": reach }),
                1 => json!({ "type": "polygon", "vertices": [[x, y], [x + reach, y + 0.2], [x + 0.3, y + reach]] }),
                _ => {
                    let (long, wide) = (2.0 * reach, 0.3 * reach);
                    json!({ "type": "polygon", "vertices": [[x, y], [x + long, y], [x + long, y + wide], [x, y + wide]] })
                }
            }
        })
        .collect();
    let mixed = draw(0.0, 3.0) as usize;
    let robots: Vec<(Json, bool, f64)> = (0..count)
        .map(|i| {
            let radius = if mixed == 0 { 0.4 } else { draw(0.2, 0.6) };
            let is_body = mixed == 1 && i % 2 == 0;
            let (long, wide) = (radius, draw(0.3, 0.6) * radius);
            let vertices = [[-long, -wide], [0.8 * long, -wide], [0.8 * long, wide], [-0.5 * long, 1.2 * wide]];
            let robot = if is_body {
                json!({ "type": "rigid_body", "shape": { "type": "polygon", "vertices": vertices } })
            } else {
                json!({ "type": "disc", "radius": radius })
            };
            (robot, is_body, draw(0.5, 2.0))
        })
        .collect();
    let shift = 1 + draw(0.0, count as f64 - 1.0) as usize;
    let how = draw(0.0, 3.0) as usize;
    for _ in 0..300 {
        let mut places: Vec<[f64; 3]> = Vec::new();
        for _ in 0..100 * count {
            let at = [draw(0.6, size[0] - 0.6), draw(0.6, size[1] - 0.6), draw(-3.0, 3.0)];
            let is_far = |other: &[f64; 3]| (0..2).map(|i| (at[i] - other[i]) * (at[i] - other[i])).sum::<f64>() > 1.5;
            if places.len() < count && places.iter().all(is_far) {
                places.push(at);
            }
        }
        if places.len() < count {
            return None;
        }
        let goal = |i: usize| match how {
            // A rotation, swaps of neighbours, or all the other way round.
            0 => (i + shift) % count,
            1 if (i ^ 1) < count => i ^ 1,
            1 => i,
            _ => count - 1 - i,
        };
        let robots: Vec<Json> = (0..count)
            .map(|i| {
                let (robot, is_body, speed) = &robots[i];
                let place = |at: [f64; 3]| if *is_body { json!(at) } else { json!(at[..2]) };
                json!({ "name": format!("{i}"), "robot": robot, "speed": speed, "start": place(places[i]), "goal": place(places[goal(i)]) })
            })
            .collect();
        if let Ok(fleet) = Fleet::read(&document(size, &json!(obstacles), &json!(robots))) {
            return Some(fleet);
        }
    }
    None
}

/// Whether a robot alone is proven to have no way: a certificate that the disc about its origin has none that it contains.
fn is_proven_stuck(fleet: &Fleet, robot: usize) -> bool {
    let document: Json = serde_json::from_str(&fleet.to_json_string()).expect("its own document");
    let mut alone = document["robots"][robot].clone();
    let vertices = alone["robot"]["shape"]["vertices"].as_array().cloned().unwrap_or_default();
    if !vertices.is_empty() {
        let corner =
            |i: usize| [0, 1].map(|axis: usize| vertices[i % vertices.len()][axis].as_f64().expect("a number"));
        // The origin is inside, and the body convex: the distances of the lines through its sides.
        let from_side = |i: usize| {
            let ([ax, ay], [bx, by]) = (corner(i), corner(i + 1));
            (ax * by - ay * bx).abs() / ((bx - ax) * (bx - ax) + (by - ay) * (by - ay)).sqrt()
        };
        let radius = (0..vertices.len()).map(from_side).fold(f64::INFINITY, f64::min);
        alone["robot"] = json!({ "type": "disc", "radius": radius });
        for end in ["start", "goal"] {
            alone[end] = json!([alone[end][0], alone[end][1]]);
        }
    }
    let mut document = document;
    document["robots"] = json!([alone]);
    let disc = Fleet::read(&document).expect("the disc is inside of the robot");
    let Ok(mut cells) = Subdivision::new(disc.scenario(0), &Options::default()) else { return false };
    cells.step(u64::MAX);
    cells.verdict() == Some(Verdict::Infeasible)
}

#[wasm_bindgen_test(unsupported = test)]
fn robots_on_random_floors_exchange_places_or_one_is_proven_to_have_no_way() {
    let all = if deep() { 600 } else { cases(60) as u64 };
    let (mut solved, mut proven) = (0, 0);
    for seed in 0..all {
        let Some(fleet) = exchange(seed) else { continue };
        let planner = by_default(&fleet, &[]);
        if planner.status() == Status::Solved {
            assert_free(&planner, &format!("seed {seed}"));
            solved += 1;
            continue;
        }
        let is_stuck = (0..fleet.robots().len()).any(|robot| is_proven_stuck(&fleet, robot));
        assert!(is_stuck, "seed {seed}: {:?}, {:?}\n{}", planner.reason(), planner.blocked(), fleet.to_json_string());
        proven += 1;
    }
    assert!(solved > 3 * all / 4, "{solved} of {all} are solved, {proven} proven to have no plan");
}
