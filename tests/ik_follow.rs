//! An arm that follows a target: it arrives, does not jump, recovers from being stretched, and stays within its limits.

use crate::common::arms::{arm, at, configuration, deviation, free, is_within, target_of};
use crate::common::cases;
use planarium::geometry::Vector;
use planarium::ik::{Followed, Target, follow, nearest_reachable};
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::space::angular_distance;
use std::f64::consts::TAU;
use wasm_bindgen_test::wasm_bindgen_test;

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
