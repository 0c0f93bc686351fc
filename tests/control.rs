//! Planning by controls: motions are free, end at their vertices, and obey the settings.

use crate::common::documents::judged;
use crate::common::driven::{car, distance, driven, edges, is_in_region, steps, vertices_of, with_goal};
use crate::common::{DRIVEN, assert_valid, begin_with, car_and_wall, car_shut_in, finish, parse, seeds};
use planarium::path::{Leg, Verdict, verify_legs};
use planarium::problem::Motion;
use planarium::run::Status;
use planarium::space::wrap;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn every_edge_is_free_and_leads_to_its_vertex_bit_by_bit() {
    let mut judged = 0;
    for world in [car_and_wall(0.1), car_and_wall(1e-6)] {
        let car = car(&world);
        for (planner, settings) in DRIVEN {
            for seed in 0..seeds(2) {
                let run = finish(begin_with(&world, planner, seed, settings));
                let vertices = vertices_of(&*run);
                for (i, edge) in edges(&*run).iter().enumerate() {
                    assert!(edge.to == i + 1 && edge.from <= i, "a tree, in the order of its growth");
                    let [slow, fast] = car.speed();
                    let [right, left] = car.steering();
                    assert!((slow..=fast).contains(&edge.speed) && (right..=left).contains(&edge.steering), "{edge:?}");
                    let end = driven(car, vertices[edge.from], edge, steps(car, edge));
                    assert_eq!(end.map(f64::to_bits), vertices[edge.to].map(f64::to_bits), "{planner} {settings}");
                    // Every leg is judged by dense samples, as a path is: some of many are enough.
                    if i % 29 == 0 || i + 1 == run.edge_count() {
                        let turn = car.turn_rate(edge.speed, edge.steering) * edge.duration;
                        let leg = Leg::arc(&vertices[edge.from], edge.speed * edge.duration, turn);
                        let verdict = verify_legs(world.world(), car.shape(), &[leg]);
                        assert!(matches!(verdict, Verdict::Valid { .. }), "{planner} {settings}: {verdict:?}");
                        judged += 1;
                    }
                }
            }
        }
    }
    assert!(judged > 100, "only {judged}");
}

#[wasm_bindgen_test(unsupported = test)]
fn paths_end_in_the_region_and_the_judge_agrees() {
    let world = car_and_wall(0.1);
    for (planner, settings) in DRIVEN {
        let mut solved = 0;
        for seed in 0..seeds(10) {
            let run = finish(begin_with(&world, planner, seed, settings));
            let result = run.result();
            if run.status() != Status::Solved {
                assert!(run.path().is_empty() && result.motions == Some(Vec::new()));
                continue;
            }
            solved += 1;
            assert_valid(&world, &*run);
            let motions = result.motions.expect("a car has motions");
            assert_eq!(motions.len() + 1, result.path.len());
            let length = |Motion { control, duration }: &Motion| control.speed.abs() * duration;
            let sum = motions.iter().map(length).fold(0.0, |sum, length| sum + length);
            assert_eq!((result.length, run.length(), run.raw_path()), (sum, sum, run.path()));
            let last = &result.path[result.path.len() - 1];
            assert!(is_in_region(&world, [last[0], last[1], last[2]]));
        }
        assert!(solved * 10 >= seeds(10) * 7, "{planner} {settings}: {solved}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_goal_is_met_after_the_first_step_that_is_there() {
    let world = car_and_wall(0.1);
    let car = car(&world);
    for (planner, settings, is_along) in
        [("rrt-control", "", true), ("sst", "", true), ("rrt-control", "goal_test=ends", false)]
    {
        let mut passed_by = 0;
        for seed in 0..seeds(12) {
            let run = finish(begin_with(&world, planner, seed, settings));
            assert_eq!(run.status(), Status::Solved);
            let (vertices, edges) = (vertices_of(&*run), edges(&*run));
            for edge in &edges {
                let is_there = |steps: &u32| is_in_region(&world, driven(car, vertices[edge.from], edge, *steps));
                let first = (1..=steps(car, edge)).find(is_there);
                match first {
                    Some(first) if is_along => assert_eq!((edge.to, first), (edges.len(), steps(car, edge))),
                    Some(first) => passed_by += u32::from(first < steps(car, edge)),
                    None => assert!(edge.to < edges.len()),
                }
            }
        }
        assert_eq!(is_along, passed_by == 0, "at ends alone the goal is passed by now and then");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn six_controls_are_all_kept_and_vertices_grow_once() {
    let world = car_and_wall(0.1);
    let settings = "controls=reeds-shepp duration_steps=60 once=true goal_test=ends max_iterations=400";
    let mut run = begin_with(&world, "rrt-control", 2, settings);
    let (mut grown, mut most) = (std::collections::BTreeSet::new(), 0);
    while run.status() == Status::Running {
        let before = run.edge_count();
        run.step(1);
        let new = &edges(&*run)[before..];
        most = new.len().max(most);
        for edge in new {
            assert_eq!(edge.from, new[0].from, "all from one vertex");
            assert!([-0.5, 0.5].contains(&edge.speed) && [-0.75, 0.0, 0.75].contains(&edge.steering), "{edge:?}");
        }
        let mut controls: Vec<_> = new.iter().map(|edge| (edge.speed.to_bits(), edge.steering.to_bits())).collect();
        controls.dedup();
        assert_eq!(controls.len(), new.len());
        assert!(new.is_empty() || grown.insert(new[0].from), "vertex {} grows twice", new[0].from);
    }
    assert_eq!(most, 6);
    // Where every drive is refused, nothing is left to grow from after the first iteration.
    let mut document = json!(world);
    document["world"] = json!({ "bounds": { "min": [0, 0], "max": [0.9, 0.6] }, "obstacles": [] });
    document["queries"][0]["goal"] = json!([0.7, 0.3, 0]);
    let settings = "controls=reeds-shepp once=true blocked=refused duration_steps=250";
    let run = finish(begin_with(&parse(&document.to_string()), "rrt-control", 2, settings));
    assert_eq!((run.status(), run.vertex_count(), run.iterations()), (Status::Exhausted, 1, 2));
}

#[wasm_bindgen_test(unsupported = test)]
fn of_the_vertices_that_have_not_grown_the_nearest_does() {
    let world = car_shut_in(0.1);
    let goal = [0, 1, 2].map(|i| world.queries()[0].configuration().unwrap()[i]);
    // Always towards the goal, so that the sample is known.
    let settings = "controls=reeds-shepp duration_steps=40 once=true goal_bias=1 max_iterations=300";
    let mut run = begin_with(&world, "rrt-control", 1, settings);
    let mut has_grown = vec![false];
    while run.status() == Status::Running {
        let vertices = vertices_of(&*run);
        run.step(1);
        has_grown.resize(vertices.len(), false);
        let far = |&vertex: &usize| distance(vertices[vertex], goal);
        let open = (0..vertices.len()).filter(|&vertex| !has_grown[vertex]);
        let Some(nearest) = open.min_by(|a, b| far(a).total_cmp(&far(b)).then(a.cmp(b))) else { break };
        has_grown[nearest] = true;
        let new = &edges(&*run)[vertices.len() - 1..];
        assert!(new.iter().all(|edge| edge.from == nearest));
    }
    assert!(has_grown.iter().filter(|grown| **grown).count() > 200);
}

#[wasm_bindgen_test(unsupported = test)]
fn durations_keep_to_their_settings() {
    let world = car_shut_in(0.1);
    let car = car(&world);
    let lengths = |settings: &str| -> Vec<u32> {
        let run = finish(begin_with(&world, "rrt-control", 1, settings));
        edges(&*run).iter().map(|edge| steps(car, edge)).collect()
    };
    let range = |lengths: &[u32]| (*lengths.iter().min().unwrap(), *lengths.iter().max().unwrap());
    let refused = "max_iterations=300 blocked=refused";
    assert_eq!(range(&lengths(&format!("{refused} duration_steps=40"))), (40, 40));
    let drawn = lengths(&format!("{refused} duration_steps=40 shortest_steps=20"));
    assert_eq!(range(&drawn), (20, 40), "both ends are drawn");
    assert!(lengths("max_iterations=300 duration_steps=40").iter().any(|&steps| steps < 40), "some are cut");
    // By default as long as the fastest straight drive of 0.3 times the extent: 0.7 times 2 sqrt 2 and 0.3 pi, at 0.35 a second.
    let extent = 0.7 * 8f64.sqrt() + 0.3 * std::f64::consts::PI;
    let default = (0.3 * extent / (0.7 * 0.5 * 0.01)) as u32;
    assert_eq!((default, range(&lengths("max_iterations=300")).1), (250, 250));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_last_quarter_is_different() {
    let world = car_shut_in(0.1);
    let car = car(&world);
    let settings =
        "max_iterations=400 duration_steps=40 late_duration_steps=15 goal_every=10 late_goal_every=1 blocked=refused";
    let mut run = begin_with(&world, "rrt-control", 1, settings);
    while run.status() == Status::Running {
        let before = run.edge_count();
        run.step(1);
        let expected = if run.iterations() <= 300 { 40 } else { 15 };
        edges(&*run)[before..].iter().for_each(|edge| assert_eq!(steps(car, edge), expected));
    }
    // In the last quarter every sample is the goal, unless another value is given.
    let early = "max_iterations=400 duration_steps=40 late_duration_steps=15 goal_every=10 blocked=refused";
    assert_ne!(finish(begin_with(&world, "rrt-control", 1, early)).fingerprint(), run.fingerprint());
}

#[wasm_bindgen_test(unsupported = test)]
fn durations_shrink_near_the_goal() {
    let world = car_shut_in(0.1);
    let car = car(&world);
    // Towards a goal on this side of the wall, never reached: the region is a point.
    let goal = [0.5, 1.2, 0.5];
    let near = with_goal(&world, goal, true);
    let settings = "max_iterations=2000 goal_bias=0.3 blocked=refused duration_steps=100 near_goal_steps=30";
    let run = finish(begin_with(&near, "rrt-control", 1, settings));
    let vertices = vertices_of(&*run);
    let (mut shrunk, mut least) = (0, 0);
    for edge in edges(&*run) {
        let part = distance(vertices[edge.from], goal) / (0.7 * 0.5);
        let expected = if part < 1.0 { ((part * 100.0) as u32).max(30) } else { 100 };
        let steps = steps(car, &edge);
        assert!(steps.abs_diff(expected) <= 1, "{steps} {expected}");
        shrunk += u32::from((31..99).contains(&steps));
        least += u32::from(steps == 30);
    }
    assert!(shrunk > 0 && least > 0, "{shrunk} {least}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_car_that_is_shut_in_finds_no_path() {
    for (planner, settings) in DRIVEN {
        for thickness in [0.1, 1e-6] {
            let world = car_shut_in(thickness);
            for seed in 0..seeds(2) {
                let mut run = begin_with(&world, planner, seed, settings);
                assert_ne!(run.step(800), Status::Solved, "{planner} {settings}");
                assert!(vertices_of(&*run).iter().all(|[x, ..]| *x < 1.0));
                let record = run.result();
                if let Some(near) = record.approximate {
                    assert_eq!(near.motions.expect("a car has motions").len() + 1, near.path.len());
                }
            }
        }
    }
    let run = finish(begin_with(&car_shut_in(0.1), "sst", 1, "max_iterations=500"));
    let near = run.result().approximate.expect("the nearest miss");
    assert!(near.path.len() > 1 && near.goal_distance > 0.0 && near.path[0] == [0.4, 0.3, 0.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_in_the_region_is_a_path() {
    let world = with_goal(&car_and_wall(0.1), [0.45, 0.3, 0.25], false);
    for (planner, settings) in DRIVEN {
        let run = finish(begin_with(&world, planner, 1, settings));
        let result = run.result();
        assert_eq!((run.status(), run.iterations(), run.length()), (Status::Solved, 1, 0.0), "{planner}");
        assert_eq!((result.path.clone(), result.motions.clone()), (vec![vec![0.4, 0.3, 0.0]], Some(Vec::new())));
        assert_valid(&world, &*run);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_steps_are_named_and_not_valid() {
    let world = car_and_wall(0.1);
    let car = car(&world);
    let mut opened = 0.0f64;
    for (planner, settings) in [("rrt-control", "integration=euler"), ("sst", "integration=euler")] {
        let run = finish(begin_with(&world, planner, 1, settings));
        let result = run.result();
        assert_eq!((run.status(), result.integration.as_deref()), (Status::Solved, Some("euler")));
        let why = judged(&world, &result).expect_err("it is not judged valid");
        assert!(why.contains("euler"), "{why}");
        let vertices = vertices_of(&*run);
        for edge in edges(&*run) {
            let (mut state, steps) = (vertices[edge.from], steps(car, &edge));
            for _ in 0..steps {
                let along = edge.speed * car.integration_step();
                let turn = car.turn_rate(edge.speed, edge.steering) * car.integration_step();
                let [x, y, theta] = state;
                state = [x + along * libm::cos(theta), y + along * libm::sin(theta), theta + turn];
            }
            let [x, y, theta] = vertices[edge.to];
            assert!((state[0] - x).abs() < 1e-12 && (state[1] - y).abs() < 1e-12);
            assert!(wrap(state[2] - theta).abs() < 1e-9);
            let [u, v, _] = driven(car, vertices[edge.from], &edge, steps);
            opened = opened.max((u - x).abs()).max((v - y).abs());
        }
    }
    assert!(opened > 1e-4 && opened < 0.05, "near the arc, and off it: {opened}");
}
