//! A start or a goal in collision: the error names the nearest free configuration, and the option `free_ends` moves it there, which
//! results and the verifier say.

use crate::common::documents::{disc, judged, named, rectangle, rectangular, refuses};
use crate::common::requests;
use crate::common::requests::start_problem;
use crate::common::{arm_of, assert_valid, begin_with, car_and_wall, disc_and_wall, finish, options, parse, seeds};
use planarium::path::{ResultDocument, Verdict, verify};
use planarium::random::{Random, Stream};
use planarium::run::inspect::Inspector;
use planarium::run::{CoordinateDescription, CustomProblem, Free, Request, SpaceDescription, Status, Value};
use planarium::scenario::{Scenario, generate::generate};
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// The world with another start, goal, or both.
fn with_ends(world: &Scenario, start: Option<&[f64]>, goal: Option<&[f64]>) -> Scenario {
    let mut document = json!(world);
    for (what, q) in [("start", start), ("goal", goal)] {
        if let Some(q) = q {
            document["queries"][0][what] = json!(q);
        }
    }
    parse(&document.to_string())
}

/// The nearest free configuration that the refusal of a run names.
fn named_nearest(world: &Scenario, planner: &str, code: &str) -> Option<Vec<f64>> {
    let error = requests::start(world, &options(planner, 1, "")).err().expect("an end is in collision");
    assert_eq!(error.code().as_str(), code, "{error}");
    let nearest = error.nearest();
    let is_told = error.message().contains("the nearest free configuration found is")
        && error.message().ends_with(" away in the metric of the space");
    assert_eq!(is_told, nearest.is_some(), "{error}");
    nearest
}

#[wasm_bindgen_test(unsupported = test)]
fn a_disc_is_sent_out_by_the_shortest_way() {
    // A wall from x = 1 to 2 below y = 3, and a disc of radius 0.5 at (3, 2).
    let obstacles = [rectangle([1.0, 0.0], [2.0, 3.0]), disc([3.0, 2.0], 0.5)].join(",");
    let robot = r#"{ "type": "disc", "radius": 0.2 }"#;
    let world = named("walled", "[0, 0], [4, 4]", &obstacles, robot, r#""start": [0.5, 0.5], "goal": [3.5, 0.5]"#);
    // What is free ends 0.2 from each; the room that is left is no more than 1e-4 of the size of the world.
    let room = 1e-3;
    for (start, distance) in [
        ([1.1, 1.0], 0.3),                                  // out to the left, 0.1 deep
        ([1.5, 2.9], 0.3),                                  // out above
        ([3.0, 2.4], 0.3),                                  // out of the disc, away from its centre
        ([3.1, 2.0], 0.6),                                  // from deep inside
        ([0.8, 1.0], 0.0),                                  // in contact
        ([0.1, 0.5], 0.1),                                  // over the bounds
        ([0.05, 3.9], (0.15f64 * 0.15 + 0.1 * 0.1).sqrt()), // in a corner
    ] {
        let nearest = named_nearest(&with_ends(&world, Some(&start), None), "rrt", "start-in-collision").expect("one");
        let found = f64::hypot(nearest[0] - start[0], nearest[1] - start[1]);
        assert!(found >= distance - 1e-9 && found <= distance + room, "{start:?}: {nearest:?}, {found} not {distance}");
        assert!(Inspector::new(&world).check(&nearest).expect("a configuration").is_empty(), "{start:?}: {nearest:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn nothing_much_nearer_is_free() {
    let mut random = Random::new(5, Stream::Samples);
    let mut tried = 0;
    for (kind, robot) in [("clutter", "disc"), ("discs", "rigid_body"), ("clutter", "car"), ("clutter", "arm")] {
        for seed in 0..seeds(40) / 10 {
            let options = json!({ "robot": robot, "seed": seed, "count": 6 });
            let Ok(world) = generate(kind, &options) else { continue };
            let inspector = Inspector::new(&world);
            let own = &world.queries()[0].start;
            for _ in 0..6 {
                let q: Vec<f64> = own.iter().map(|x| x + 2.0 * random.normal()).collect();
                if inspector.check(&q).is_ok_and(|contacts| contacts.is_empty()) {
                    continue;
                }
                let world = with_ends(&world, Some(&q), None);
                let Some(nearest) = named_nearest(&world, "prm", "start-in-collision") else { continue };
                assert!(inspector.check(&nearest).expect("a configuration").is_empty(), "{kind} {robot} {q:?}");
                let distance = inspector.distance(&q, &nearest).expect("configurations");
                tried += 1;
                // Everything that is drawn well inside that distance is in collision.
                for _ in 0..200 {
                    let near: Vec<f64> = q.iter().map(|x| x + distance * random.normal()).collect();
                    let apart = inspector.distance(&q, &near).expect("configurations");
                    let is_free = inspector.check(&near).expect("a configuration").is_empty();
                    assert!(
                        !is_free || apart > 0.7 * distance,
                        "{kind} {robot} {seed} {q:?}: {near:?} is {apart} away, {nearest:?} {distance}"
                    );
                }
            }
        }
    }
    assert!(tried > 10, "{tried}");
}

/// Robots with ends in collision: a world, a planner with settings, and the ends that are moved.
fn moved_worlds() -> Vec<(Scenario, &'static str, &'static str, [bool; 2])> {
    let body = {
        let obstacles = rectangle([0.9, 0.0], [1.0, 1.5]);
        let query = r#""start": [0.85, 0.3, 0], "goal": [1.05, 0.3, 0.4]"#;
        named("body", "[0, 0], [2, 2]", &obstacles, &rectangular("rigid_body", 0.1, 0.05, ""), query)
    };
    vec![
        (with_ends(&disc_and_wall(0.3, 0.5), None, None), "rrt-connect", "", [false; 2]),
        (body.clone(), "rrt-connect", "", [true; 2]),
        (body, "prm", "samples=300", [true; 2]),
        (with_ends(&car_and_wall(0.1), Some(&[0.85, 0.3, 0.0]), None), "rrt", "", [true, false]),
        (with_ends(&car_and_wall(0.1), None, Some(&[1.05, 0.4, 0.0])), "rrt-control", "", [false, true]),
        (with_ends(&arm_of(2, false, 0.02), Some(&[1.49, 0.0]), None), "rrt-connect", "", [true, false]),
    ]
}

#[wasm_bindgen_test(unsupported = test)]
fn an_option_moves_ends_and_results_say_so() {
    for (world, planner, settings, moved) in moved_worlds() {
        let what = format!("{planner} in {}", world.name());
        if moved != [false; 2] {
            assert!(
                requests::start(&world, &options(planner, 1, settings)).is_err(),
                "{what}: refused without the option"
            );
        }
        let run = finish(begin_with(&world, planner, 1, &format!("{settings} free_ends=1")));
        assert_eq!(run.status(), Status::Solved, "{what}");
        assert_valid(&world, &*run);
        let result = run.result();
        assert_eq!([result.moved_start.is_some(), result.moved_goal.is_some()], moved, "{what}");
        assert_eq!(ResultDocument::parse(&result.to_json()).expect("its own text"), result);
        let Verdict::Valid { moved_start, moved_goal, .. } = verify(&world, &result).expect("its scenario") else {
            panic!("{what}: a valid path");
        };
        assert_eq!([moved_start, moved_goal], moved, "{what}");
        if let Some(start) = &result.moved_start {
            assert_eq!(&result.path[0], start, "{what}");
            // The same as the error names.
            assert_eq!(named_nearest(&world, planner, "start-in-collision").as_ref(), Some(start), "{what}");
        }
        // The verifier accepts another start or goal only if the result says so, and only for an end that is in collision.
        if moved != [false; 2] {
            let silent = ResultDocument { moved_start: None, moved_goal: None, ..result.clone() };
            assert!(judged(&world, &silent).is_err(), "{what}");
        }
        for (is_start, q) in [(true, &result.path[0]), (false, &result.path[result.path.len() - 1])] {
            if moved[usize::from(!is_start)] {
                continue;
            }
            let mut claimed = result.clone();
            *(if is_start { &mut claimed.moved_start } else { &mut claimed.moved_goal }) = Some(q.clone());
            assert!(judged(&world, &claimed).expect_err("a free end").contains("is free"), "{what}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_end_is_moved_farther_than_allowed() {
    let obstacles = rectangle([1.0, 0.0], [2.0, 3.0]);
    let robot = r#"{ "type": "disc", "radius": 0.2 }"#;
    let world = named("walled", "[0, 0], [4, 4]", &obstacles, robot, r#""start": [1.1, 1], "goal": [3.5, 0.5]"#);
    for (most, is_moved) in [(0.0, false), (0.29, false), (0.31, true), (0.300001, true)] {
        let started = requests::start(&world, &options("rrt-connect", 1, &format!("free_ends={most}")));
        if !is_moved {
            refuses(started.map(|_| ()), "start-in-collision", "/queries/0/start");
            continue;
        }
        let run = finish(started.unwrap_or_else(|error| panic!("{most}: {error}")));
        let start = run.result().moved_start.expect("it was moved");
        assert!(f64::hypot(start[0] - 1.1, start[1] - 1.0) <= most, "{most}: {start:?}");
        assert_valid(&world, &*run);
    }
    // Where nothing is free, nothing is named.
    let full = named(
        "full",
        "[0, 0], [4, 4]",
        &rectangle([-1.0, -1.0], [5.0, 5.0]),
        robot,
        r#""start": [1, 1], "goal": [3, 1]"#,
    );
    assert_eq!(named_nearest(&full, "rrt", "start-in-collision"), None);
}

#[wasm_bindgen_test(unsupported = test)]
fn ends_of_robots_of_ones_own_are_named_and_moved_too() {
    let side = CoordinateDescription::interval(-2.0, 2.0);
    let space = SpaceDescription { coordinates: vec![side, side], metric: None };
    let free = || {
        Free::by_clearance(|rows, clearances| {
            for (q, clearance) in rows.chunks(2).zip(clearances) {
                *clearance = (q[0] * q[0] + q[1] * q[1]).sqrt() - 1.0;
            }
            Ok(())
        })
    };
    let goals = [vec![1.5, 0.0], vec![0.0, 0.9]];
    let problem = CustomProblem::new(space, free(), &[-0.5, 0.0], &goals).expect("a problem");
    let error = start_problem(&problem, &Request::default()).err().expect("the start is in collision");
    let nearest = error.nearest().expect("one is found");
    assert!((nearest[0] + 1.0).abs() < 2e-3 && nearest[1].abs() < 0.05, "{error}");
    let parameters = vec![("free_ends".to_owned(), Value::Number(1.0))];
    let run = finish(start_problem(&problem, &Request { parameters, ..Request::default() }).expect("both are moved"));
    let result = run.result();
    assert_eq!((run.status(), result.moved_start.as_ref()), (Status::Solved, Some(&result.path[0])));
    let end = &result.path[result.path.len() - 1];
    assert!(run.goals().contains(end));
    assert_eq!(result.moved_goal.as_ref(), (end != &goals[0]).then_some(end));
}
