//! An arm that follows a hand: it arrives, it does not jump, it comes back from being stretched, it keeps its limits.

use crate::common::arms::{arm, configuration, deviation, is_within};
use crate::common::cases;
use planarium::geometry::Point;
use planarium::ik::{Target, follow, nearest_reachable, orientation};
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::space::angular_distance;
use std::f64::consts::TAU;
use wasm_bindgen_test::wasm_bindgen_test;

fn at(point: Point) -> Target {
    Target { point, orientation: None }
}

fn free(links: &[f64]) -> Arm {
    Arm::new(Point::origin(), links.to_vec(), 0.0, None).expect("an arm")
}

/// The largest turn of a joint.
fn turn(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(&a, &b)| angular_distance(a, b)).fold(0.0, f64::max)
}

/// Drags the tip along a path, a function of a time from 0 to 1, in so many steps; the largest turn of a joint in one step, the
/// largest distance from the target, and the last configuration.
fn drag(arm: &Arm, start: &[f64], steps: u32, path: &dyn Fn(f64) -> Point) -> (f64, f64, Vec<f64>) {
    let (mut q, mut widest, mut farthest) = (start.to_vec(), 0.0, 0.0);
    for step in 1..=steps {
        let moved = follow(arm, &q, at(path(f64::from(step) / f64::from(steps)))).expect("an arm");
        let next = moved.configuration[..q.len()].to_vec();
        widest = f64::max(widest, turn(&q, &next));
        farthest = f64::max(farthest, moved.distance);
        q = next;
    }
    (widest, farthest, q)
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
        let target = Target { point: arm.end_effector(&goal), orientation: is_oriented.then(|| orientation(&goal)) };
        let moved = follow(&arm, &q, target).expect("an arm");
        let [distance, turned] = deviation(&arm, &moved.configuration[..links], &target);
        assert_eq!(moved.is_reached, moved.distance <= 1e-9 * arm.reach() && moved.turn <= 1e-9);
        assert!((distance - moved.distance).abs() < 1e-13 && (turned - moved.turn).abs() < 1e-13, "case {case}");
        assert!(is_within(&arm, &moved.configuration));
        if !moved.is_reached {
            missed.push((case, links, is_oriented, moved.distance, moved.turn));
        }
    }
    println!("missed {} {missed:?}", missed.len());
    assert!(missed.len() * 200 <= cases(10_000), "{missed:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn beyond_its_reach_it_stretches_towards_the_hand_and_comes_back() {
    let mut random = Random::new(32, Stream::Samples);
    let mut worst = 0.0;
    for case in 0..cases(2000) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, false);
        let q = configuration(&mut random, &arm);
        let (sin, cos) = (TAU * random.uniform()).sin_cos();
        let along = |r: f64| at(arm.base() + planarium::geometry::Vector::new(cos, sin) * r * arm.reach());
        let out = follow(&arm, &q, along(1.0 + random.uniform())).expect("an arm");
        let gap = nearest_reachable(&arm, along(1.5)).expect("a target").distance - 0.5 * arm.reach();
        assert!(gap.abs() < 1e-12);
        let rim = arm.base() + planarium::geometry::Vector::new(cos, sin) * arm.reach();
        worst = f64::max(worst, (out.point - rim).norm() / arm.reach());
        assert!(!out.is_reached && out.manipulability < 1e-3 * arm.reach() * arm.reach());
        // Straight to a rounding, and straight to the bit.
        let mut straight = vec![0.0; links];
        straight[0] = sin.atan2(cos);
        for from in [&out.configuration[..links], &straight] {
            let back = follow(&arm, from, along(0.9)).expect("an arm");
            assert!(
                back.is_reached || links == 2 && arm.links()[0] > 20.0 * arm.links()[1],
                "case {case}: {}",
                back.distance
            );
        }
    }
    println!("worst {worst:e}");
    assert!(worst < 1e-5, "{worst:e}");
}

#[wasm_bindgen_test(unsupported = test)]
fn small_steps_of_the_hand_make_small_turns_also_near_singular_arms() {
    let arm = free(&[1.0, 0.8, 0.6]);
    let two = free(&[1.0, 0.8]);
    // Across the workspace, past the base at some distance, and out beyond the rim and in again.
    let across = |t: f64| Point::new(-1.5 + 3.0 * t, 0.9);
    let out_and_in = |t: f64| Point::new(0.6 + 2.4 * (1.0 - (2.0 * t - 1.0).abs()), 0.3);
    let along_the_rim = |t: f64| Point::new(3.0 * (TAU * t).cos(), 3.0 * (TAU * t).sin());
    let paths: [&dyn Fn(f64) -> Point; 3] = [&across, &out_and_in, &along_the_rim];
    for (number, path) in paths.into_iter().enumerate() {
        for arm in [&arm, &two] {
            let links = arm.links().len();
            let start = follow(arm, &[0.3, 0.9, 0.5][..links], at(path(0.0))).expect("an arm").configuration;
            let widest = [64, 256, 1024, 4096].map(|steps| drag(arm, &start[..links], steps, path).0);
            println!("path {number}, {links} links: {widest:?}");
            // A quarter of the step turns the joints at most a little more than half as far: the square root, at the rim.
            for pair in widest[1..].windows(2) {
                assert!(pair[1] < 0.62 * pair[0], "path {number}, {links} links: {widest:?}");
            }
            assert!(widest[3] < 0.08);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_hand_that_rests_leaves_the_arm_alone() {
    let mut random = Random::new(33, Stream::Samples);
    let mut creeping = Vec::new();
    for case in 0..cases(1000) {
        let arm = arm(&mut random, 2 + case % 7, case % 2 == 0);
        let q = configuration(&mut random, &arm);
        let links = q.len();
        let once = follow(&arm, &q, at(arm.end_effector(&q))).expect("an arm");
        assert!(turn(&once.configuration[..links], &q) < 1e-12 && once.is_reached, "case {case}");
        // The same wherever the hand rests.
        let goal = at(Point::new(3.0 * random.uniform(), 3.0 * random.uniform()));
        let mut last = follow(&arm, &q, goal).expect("an arm");
        for _ in 0..20 {
            last = follow(&arm, &last.configuration[..links], goal).expect("an arm");
        }
        let again = follow(&arm, &last.configuration[..links], goal).expect("an arm");
        let moved = turn(&again.configuration[..links], &last.configuration[..links]);
        creeping.push((moved, case));
    }
    creeping.sort_by(|a, b| b.0.total_cmp(&a.0));
    println!("{:?}", &creeping[..12]);
    assert!(creeping[0].0 < 1e-3, "{:?}", &creeping[..12]);
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_hold_and_what_the_arm_was_led_to_it_reaches() {
    let mut random = Random::new(34, Stream::Samples);
    let (mut missed, mut total, mut stuck) = (0, 0, 0);
    for case in 0..cases(600) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, true);
        let ends = [configuration(&mut random, &arm), configuration(&mut random, &arm)];
        let between = |t: f64| (0..links).map(|i| ends[0][i] + t * (ends[1][i] - ends[0][i])).collect::<Vec<f64>>();
        let mut q = ends[0].clone();
        for step in 1..=100 {
            let goal = at(arm.end_effector(&between(f64::from(step) / 100.0)));
            let moved = follow(&arm, &q, goal).expect("an arm");
            assert!(is_within(&arm, &moved.configuration));
            assert!(moved.distance <= (arm.end_effector(&q) - goal.point).norm() + 1e-12, "it never moves away");
            total += 1;
            missed += u32::from(!moved.is_reached);
            q = moved.configuration[..links].to_vec();
        }
        stuck += u32::from(!follow(&arm, &q, at(arm.end_effector(&ends[1]))).expect("an arm").is_reached);
    }
    println!("missed {missed} of {total}, {stuck} at the end");
    assert!(missed * 20 <= total, "missed {missed} of {total}");
}
