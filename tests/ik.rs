//! Inverse kinematics. Runs: the Jacobian against differences; every reachable target is reached, within limits; slices, distinct
//! and free solutions, refusals. An arm that follows a target: it arrives, does not jump, recovers from being stretched, and stays
//! within its limits.

use crate::common::arms::{
    arm, at, configuration, deviation, free, is_within, limited, reachable, scenario, solve, target_of,
};
use crate::common::{cases, disc_and_wall};
use planarium::Error;
use planarium::geometry::{Point, Vector};
use planarium::ik::{
    Followed, Solver, SolverOptions, Target, Verdict, follow, jacobian, manipulability, methods, nearest_reachable,
    orientation, singular_values,
};
use planarium::problem::Touched;
use planarium::random::{MAX_SEED, Random, Stream};
use planarium::robot::Arm;
use planarium::run::{Status, Value};
use planarium::space::angular_distance;
use std::f64::consts::TAU;
use wasm_bindgen_test::wasm_bindgen_test;

fn options(target: Target, method: &str, parameters: &[(&str, f64)]) -> SolverOptions {
    let parameters = parameters.iter().map(|&(name, value)| (name.to_owned(), Value::Number(value))).collect();
    SolverOptions { method: Some(method.to_owned()), parameters, ..SolverOptions::to(target) }
}

/// The methods that go from one configuration to the next.
const ITERATIVE: [&str; 3] = ["newton", "damped-least-squares", "gradient-descent"];

/// Random arms, half of them with limits, a third of those of three links and more with an orientation.
#[wasm_bindgen_test(unsupported = test)]
fn every_iterative_method_reaches_what_can_be_reached() {
    for (method, tolerance) in ITERATIVE.into_iter().zip([1e-9, 1e-9, 1e-4]) {
        let cases = cases(10_000) as u64;
        let mut random = Random::new(20, Stream::Samples);
        let mut failed = Vec::new();
        for case in 0..cases {
            let links = 2 + (case % 7) as usize;
            let arm = arm(&mut random, links, case % 2 == 0);
            let is_oriented = links >= 3 && random.below(3) == 0;
            let target = reachable(&mut random, &arm, is_oriented);
            let run = solve(&scenario(&arm, ""), &SolverOptions { seed: case, ..options(target, method, &[]) });
            for iterate in run.iterates() {
                assert!(is_within(&arm, &iterate.configuration), "case {case}: {:?}", iterate.configuration);
            }
            if run.status() == Status::Solved {
                let error = deviation(&arm, &run.solutions()[0], &target);
                assert!(error.iter().all(|&error| error <= tolerance + 1e-14), "case {case}: {error:?}");
                assert_eq!(run.explain(), Verdict::Reached);
            } else {
                assert_eq!(run.explain(), Verdict::NotFound, "case {case}: {arm:?} {target:?}");
                failed.push(case);
            }
        }
        assert!(failed.len() as u64 * 1000 <= cases, "{method} failed {} of {cases}: {failed:?}", failed.len());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_jacobian_agrees_with_differences() {
    let mut random = Random::new(40, Stream::Samples);
    for case in 0..200 {
        let arm = arm(&mut random, 1 + case % 8, false);
        let q = configuration(&mut random, &arm);
        let rows = jacobian(&arm, &q);
        for i in 0..q.len() {
            let tip = |by: f64| {
                let mut moved = q.clone();
                moved[i] += by;
                arm.end_effector(&moved)
            };
            let slope = (tip(1e-6) - tip(-1e-6)) / 2e-6;
            assert!((slope.x - rows[0][i]).abs() < 1e-8 && (slope.y - rows[1][i]).abs() < 1e-8, "case {case}");
        }
        assert!(angular_distance(orientation(&q), q.iter().sum()) < 1e-14);
        // The determinant of J times its transpose, and the squares of its singular values.
        let product = |a: usize, b: usize| -> f64 { (0..8).map(|i| rows[a][i] * rows[b][i]).sum() };
        let determinant = product(0, 0) * product(1, 1) - product(0, 1) * product(0, 1);
        let [large, small] = singular_values(&arm, &q);
        assert!(large >= small && small >= 0.0);
        assert!((manipulability(&arm, &q) - determinant.max(0.0).sqrt()).abs() < 1e-7 * (1.0 + determinant.abs()));
        assert!((large * large + small * small - product(0, 0) - product(1, 1)).abs() < 1e-12 * large * large);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn manipulability_of_two_links_is_their_lengths_times_the_sine_of_the_elbow() {
    let arm = free(&[1.0, 0.8]);
    for elbow in [0.0, 1e-9, 0.3, 1.5, -2.0, 3.0] {
        let wanted = 0.8 * f64::sin(elbow).abs();
        assert!((manipulability(&arm, &[0.4, elbow]) - wanted).abs() <= 1e-15 * (1.0 + wanted / 1e-3), "{elbow}");
    }
    assert_eq!(manipulability(&free(&[1.0]), &[0.3]), 0.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn slices_change_nothing() {
    let scenario = scenario(&free(&[1.0, 0.8, 0.5, 0.4]), r#"{ "type": "disc", "center": [0.7, 0.9], "radius": 0.3 }"#);
    for method in ITERATIVE {
        let mut options = options(at(0.9, 0.3), method, &[("solutions", 5.0), ("max_iterations", 700.0)]);
        options.parameters.push(("free_only".to_owned(), Value::Boolean(true)));
        options.seed = 3;
        let whole = solve(&scenario, &options);
        for slice in [1, 7] {
            let mut run = Solver::new(&scenario, &options).expect("a run");
            while run.step(slice) == Status::Running {}
            assert_eq!(run.fingerprint(), whole.fingerprint(), "{method} in slices of {slice}");
            assert_eq!((run.iterations(), run.restarts()), (whole.iterations(), whole.restarts()));
        }
        assert_eq!(whole.iterates().len() as u64, whole.iterations() + 1);
        options.seed = 4;
        assert_ne!(solve(&scenario, &options).fingerprint(), whole.fingerprint());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn solutions_are_distinct_and_as_many_as_there_are() {
    let two = scenario(&free(&[1.0, 0.8]), "");
    for method in ITERATIVE {
        let run = solve(&two, &options(at(1.0, 0.6), method, &[("solutions", 9.0), ("separation", 0.01)]));
        assert_eq!((run.status(), run.solutions().len()), (Status::Solved, 2), "{method}");
        assert_eq!(run.restarts(), 200, "it has searched for more");
        let five = solve(&scenario(&free(&[0.5; 5]), ""), &options(at(1.0, 0.6), method, &[("solutions", 12.0)]));
        let found = five.solutions();
        assert_eq!(found.len(), 12, "{method}");
        for (i, a) in found.iter().enumerate() {
            for b in &found[..i] {
                assert!(a.iter().zip(b).any(|(&a, &b)| angular_distance(a, b) > 0.5), "{method}");
            }
        }
    }
    let nothing = solve(&two, &options(at(1.0, 0.6), "newton", &[("max_iterations", 0.0)]));
    assert_eq!((nothing.status(), nothing.iterations(), nothing.explain()), (Status::Exhausted, 0, Verdict::NotFound));
    let mut here = options(at(1.8, 0.0), "newton", &[]);
    here.start = Some(vec![0.0, 0.0]);
    let here = Solver::new(&two, &here).expect("a run");
    assert_eq!((here.status(), here.iterations()), (Status::Solved, 0));
}

#[wasm_bindgen_test(unsupported = test)]
fn solutions_in_collision_are_listed_apart() {
    // The elbow to the left touches the disc, the elbow to the right is free; with the second disc neither is.
    let one = r#"{ "type": "disc", "center": [0.3, 1.0], "radius": 0.2 }"#;
    let both = r#"{ "type": "disc", "center": [0.3, 1.0], "radius": 0.2 }, { "type": "disc", "center": [1.0, -0.2], "radius": 0.3 }"#;
    for method in ["closed-form", "newton", "damped-least-squares", "gradient-descent"] {
        let mut wanted = options(at(1.0, 0.9), method, &[("solutions", 2.0)]);
        let all = solve(&scenario(&free(&[0.9, 0.9]), one), &wanted);
        assert_eq!(
            (all.solutions().len(), all.rejected().len(), all.stats().configuration_checks),
            (2, 0, 0),
            "{method}"
        );
        wanted.parameters.push(("free_only".to_owned(), Value::Boolean(true)));
        let some = solve(&scenario(&free(&[0.9, 0.9]), one), &wanted);
        let counts = (some.solutions().len(), some.rejected().len(), some.explain());
        assert_eq!(counts, (1, 1, Verdict::Reached), "{method}");
        assert!(some.solutions()[0][1] > 0.0 && some.rejected()[0].configuration[1] < 0.0, "{method}");
        let none = solve(&scenario(&free(&[0.9, 0.9]), both), &wanted);
        assert_eq!((none.status(), none.rejected().len()), (Status::Exhausted, 2), "{method}");
        let Verdict::InCollision { contacts } = none.explain() else { panic!("{:?}", none.explain()) };
        assert!(contacts.iter().all(|one| matches!(one.with, Touched::Obstacle(_))));
    }
}

#[track_caller]
fn refuses<T>(given: Result<T, Error>, code: &str, pointer: &str) {
    let error = given.err().expect("it is refused");
    assert_eq!((error.code().as_str(), error.pointer()), (code, pointer), "{}", error.message());
    assert!(error.message().len() > 10);
}

#[wasm_bindgen_test(unsupported = test)]
fn bad_input_is_refused_with_code_and_pointer() {
    let limited = limited(&[1.0, 0.8], &[[-1.0, 1.0], [0.1, 2.0]]);
    let scene = scenario(&limited, "");
    let refused = |change: &dyn Fn(&mut SolverOptions), code: &str, pointer: &str| {
        let mut options = SolverOptions::to(at(1.0, 0.5));
        change(&mut options);
        refuses(Solver::new(&scene, &options), code, pointer);
    };
    refused(&|o| o.target.point.x = f64::NAN, "not-finite", "/target/0");
    refused(&|o| o.target.point.y = f64::INFINITY, "not-finite", "/target/1");
    refused(&|o| o.target.point.y = -1.1e6, "out-of-range", "/target/1");
    refused(&|o| o.target.orientation = Some(f64::NAN), "not-finite", "/orientation");
    refused(&|o| o.target.orientation = Some(2e6), "out-of-range", "/orientation");
    refused(&|o| o.method = Some("magic".into()), "out-of-range", "/method");
    refused(&|o| o.seed = MAX_SEED + 1, "out-of-range", "/seed");
    refused(&|o| o.start = Some(vec![0.0]), "wrong-dimension", "/start");
    refused(&|o| o.start = Some(vec![0.0, f64::NAN]), "not-finite", "/start/1");
    refused(&|o| o.start = Some(vec![0.0, 0.0]), "out-of-range", "/start/1");
    refused(&|o| o.start = Some(vec![-1.0000001, 0.5]), "out-of-range", "/start/0");
    let parameter =
        |name: &'static str, value: Value| move |o: &mut SolverOptions| o.parameters.push((name.into(), value.clone()));
    refused(&parameter("tolerance", Value::Number(0.0)), "out-of-range", "/tolerance");
    refused(&parameter("solutions", Value::Number(1.5)), "out-of-range", "/solutions");
    refused(&parameter("free_only", Value::Number(1.0)), "wrong-type", "/free_only");
    refused(&parameter("speed", Value::Number(1.0)), "unknown-parameter", "/speed");
    refused(&parameter("max_iterations", Value::Number(f64::NAN)), "not-finite", "/max_iterations");
    // Options that the closed form does not have, and arms that it cannot solve.
    refuses(
        Solver::new(&scene, &options(at(1.0, 0.5), "closed-form", &[("restarts", 3.0)])),
        "unknown-parameter",
        "/restarts",
    );
    let three = scenario(&free(&[1.0, 1.0, 1.0]), "");
    refuses(Solver::new(&three, &options(at(1.0, 0.5), "closed-form", &[])), "unsupported", "/method");
    let turned = Target { orientation: Some(0.0), ..at(0.5, 0.0) };
    refuses(Solver::new(&scenario(&free(&[1.0]), ""), &SolverOptions::to(turned)), "unsupported", "/orientation");
    refuses(nearest_reachable(&free(&[1.0]), turned), "unsupported", "/orientation");
    refuses(nearest_reachable(&limited, at(f64::NAN, 0.0)), "not-finite", "/target/0");
    refuses(follow(&limited, &[0.0], at(1.0, 0.0)), "wrong-dimension", "/q");
    refuses(follow(&limited, &[0.0, 0.0], at(1.0, 0.0)), "out-of-range", "/q/1");
    refuses(follow(&limited, &[f64::NAN, 0.5], at(1.0, 0.0)), "not-finite", "/q/0");
    refuses(follow(&free(&[1.0, 1.0]), &[2e6, 0.5], at(1.0, 0.0)), "out-of-range", "/q/0");
    refuses(Solver::new(&disc_and_wall(0.1, 0.1), &SolverOptions::to(at(0.5, 0.5))), "unsupported", "");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_largest_and_the_smallest_arms_reach_too() {
    for scale in [1e-6, 1e-3, 1.0, 1e3, 1e5] {
        let arm =
            Arm::new(Point::new(scale, -scale), vec![scale, 0.8 * scale, 0.5 * scale], 0.0, None).expect("an arm");
        let goal = target_of(&arm, &[0.4, 0.9, -0.7], false);
        for method in ITERATIVE {
            let run = solve(&scenario(&arm, ""), &options(goal, method, &[]));
            assert_eq!(run.status(), Status::Solved, "{method} at {scale}");
            let [distance, _] = deviation(&arm, &run.solutions()[0], &goal);
            assert!(distance <= run.tolerance() + 1e-15 * scale, "{method} at {scale}");
        }
        assert!(follow(&arm, &[0.0, 0.1, 0.1], goal).expect("it follows").is_reached);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_lists_every_method() {
    let ids: Vec<&str> = methods().iter().map(|info| info.id).collect();
    assert_eq!(ids, ["closed-form", "newton", "damped-least-squares", "gradient-descent"]);
    for info in methods() {
        assert!(info.title.len() > 3 && info.summary.ends_with('.'));
        assert!(info.parameters.iter().all(|row| row.robots == ["arm"] && row.meaning.ends_with('.')));
    }
}

/// The arm after it has followed the target.
fn followed(arm: &Arm, q: &[f64], target: Target) -> Followed {
    follow(arm, q, target).expect("a configuration and a target in range")
}

/// The largest rotation of a joint.
fn turn(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(&a, &b)| angular_distance(a, b)).fold(0.0, f64::max)
}

/// Drags the tip along a path, a function of a time from 0 to 1, in so many steps; the largest rotation of a joint in one step.
fn drag(arm: &Arm, start: &[f64], steps: u32, path: &dyn Fn(f64) -> Target) -> f64 {
    let (mut q, mut widest) = (start.to_vec(), 0.0);
    for step in 1..=steps {
        let next = followed(arm, &q, path(f64::from(step) / f64::from(steps))).configuration;
        widest = f64::max(widest, turn(&q, &next));
        q = next;
    }
    widest
}

#[wasm_bindgen_test(unsupported = test)]
fn the_tip_arrives_wherever_a_free_arm_can_reach() {
    let mut random = Random::new(31, Stream::Samples);
    let mut missed = Vec::new();
    for case in 0..cases(10_000) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, false);
        let [q, goal] = [configuration(&mut random, &arm), configuration(&mut random, &arm)];
        let is_oriented = links >= 4 && case % 3 == 0;
        let target = target_of(&arm, &goal, is_oriented);
        let moved = followed(&arm, &q, target);
        let [distance, turned] = deviation(&arm, &moved.configuration, &target);
        assert_eq!(moved.is_reached, moved.distance <= 1e-9 * arm.reach() && moved.turn <= 1e-9);
        assert!((distance - moved.distance).abs() < 1e-13 && (turned - moved.turn).abs() < 1e-13, "case {case}");
        assert!(is_within(&arm, &moved.configuration));
        if !moved.is_reached {
            missed.push((case, links, is_oriented, moved.distance, moved.turn));
        }
    }
    assert!(missed.len() * 200 <= cases(10_000), "{missed:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn beyond_its_reach_it_stretches_towards_the_target_and_recovers() {
    let mut random = Random::new(32, Stream::Samples);
    let mut worst = 0.0;
    for case in 0..cases(2000) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, false);
        let q = configuration(&mut random, &arm);
        let (sin, cos) = (TAU * random.uniform()).sin_cos();
        let along = |r: f64| {
            let point = arm.base() + Vector::new(cos, sin) * r * arm.reach();
            Target { point, orientation: None }
        };
        let out = followed(&arm, &q, along(1.0 + random.uniform()));
        let gap = nearest_reachable(&arm, along(1.5)).expect("a target").distance - 0.5 * arm.reach();
        assert!(gap.abs() < 1e-12);
        worst = f64::max(worst, (out.point - along(1.0).point).norm() / arm.reach());
        assert!(!out.is_reached && out.manipulability < 1e-3 * arm.reach() * arm.reach());
        // Straight to a rounding, and straight to the bit.
        let mut straight = vec![0.0; links];
        straight[0] = sin.atan2(cos);
        for from in [&out.configuration, &straight] {
            let back = followed(&arm, from, along(0.9));
            let is_hard = links == 2 && arm.links()[0] > 20.0 * arm.links()[1];
            assert!(back.is_reached || is_hard, "case {case}: {}", back.distance);
        }
    }
    assert!(worst < 1e-5, "{worst:e}");
}

#[wasm_bindgen_test(unsupported = test)]
fn small_steps_of_the_target_make_small_rotations_also_near_singular_configurations() {
    let arm = free(&[1.0, 0.8, 0.6]);
    let two = free(&[1.0, 0.8]);
    // Across the workspace, past the base at some distance, and out beyond the rim and in again.
    let across = |t: f64| at(-1.5 + 3.0 * t, 0.9);
    let out_and_in = |t: f64| at(0.6 + 2.4 * (1.0 - (2.0 * t - 1.0).abs()), 0.3);
    let along_the_rim = |t: f64| at(3.0 * (TAU * t).cos(), 3.0 * (TAU * t).sin());
    let paths: [&dyn Fn(f64) -> Target; 3] = [&across, &out_and_in, &along_the_rim];
    for (number, path) in paths.into_iter().enumerate() {
        for arm in [&arm, &two] {
            let links = arm.links().len();
            let start = followed(arm, &[0.3, 0.9, 0.5][..links], path(0.0)).configuration;
            let widest = [64, 256, 1024, 4096].map(|steps| drag(arm, &start, steps, path));
            // A quarter of the step turns the joints at most a little more than half as far: the square root, at the rim.
            for pair in widest[1..].windows(2) {
                assert!(pair[1] < 0.62 * pair[0], "path {number}, {links} links: {widest:?}");
            }
            assert!(widest[3] < 0.08);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_fixed_target_does_not_move_the_arm() {
    let mut random = Random::new(33, Stream::Samples);
    for case in 0..cases(1000) {
        let arm = arm(&mut random, 2 + case % 7, case % 2 == 0);
        let q = configuration(&mut random, &arm);
        let once = followed(&arm, &q, target_of(&arm, &q, false));
        assert!(turn(&once.configuration, &q) < 1e-12 && once.is_reached, "case {case}");
        // The same for any fixed target.
        let goal = at(3.0 * random.uniform(), 3.0 * random.uniform());
        let mut last = followed(&arm, &q, goal);
        for _ in 0..20 {
            last = followed(&arm, &last.configuration, goal);
        }
        let again = followed(&arm, &last.configuration, goal);
        let moved = turn(&again.configuration, &last.configuration);
        assert!(moved < 1e-3, "case {case}: {moved}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_hold_and_a_target_that_moves_along_reachable_points_is_reached() {
    let mut random = Random::new(34, Stream::Samples);
    let (mut missed, mut total) = (0, 0);
    for case in 0..cases(600) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, true);
        let ends = [configuration(&mut random, &arm), configuration(&mut random, &arm)];
        let between = |t: f64| (0..links).map(|i| ends[0][i] + t * (ends[1][i] - ends[0][i])).collect::<Vec<f64>>();
        let mut q = ends[0].clone();
        for step in 1..=100 {
            let goal = target_of(&arm, &between(f64::from(step) / 100.0), false);
            let moved = followed(&arm, &q, goal);
            assert!(is_within(&arm, &moved.configuration));
            assert!(moved.distance <= (arm.end_effector(&q) - goal.point).norm() + 1e-12, "it never moves away");
            total += 1;
            missed += u32::from(!moved.is_reached);
            q = moved.configuration;
        }
    }
    assert!(missed * 20 <= total, "missed {missed} of {total}");
}
