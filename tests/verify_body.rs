//! The independent judge of bodies' paths: against the proof, against dense samples, and by hand.

use crate::common::bodies::*;
use crate::common::{documents, seeds};
use planarium::collision::{BodyCollision, BodyMotion};
use planarium::geometry::{Disc, Polygon};
use planarium::path::{Leg, Verdict, verify_legs};
use planarium::random::{Random, Stream};
use planarium::scenario::{Obstacle, Scenario, World};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// The same motion as a leg of a path; `None` if a straight one turns in the longer direction, or an arc so often that it takes a
/// million samples.
fn leg(motion: &BodyMotion) -> Option<Leg> {
    match *motion {
        BodyMotion::Straight { from, delta } => {
            (delta[2].abs() < PI).then(|| Leg::straight(&from, &[0, 1, 2].map(|i| from[i] + delta[i])))
        }
        BodyMotion::Arc { from, speed, turn_rate, duration } => {
            let turn = turn_rate * duration;
            (turn.abs() < 40.0).then(|| Leg::arc(&from, speed * duration, turn))
        }
    }
}

fn is_valid(world: &World, body: &Polygon, leg: Leg) -> bool {
    matches!(verify_legs(world, body, &[leg]), Verdict::Valid { .. })
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_proven_is_judged_valid_and_what_touches_is_not() {
    let mut random = Random::new(11, Stream::Samples);
    let (mut proven, mut valid, mut touching) = (0, 0, 0);
    for number in 0..seeds(60) {
        let (body, world, scale) = random_world(&mut random);
        let collision = BodyCollision::new(&body, &world, 1e-4);
        for _ in 0..30 {
            let from = random_placement(&mut random, scale);
            let motion = random_motion(&mut random, from, scale);
            let Some(leg) = leg(&motion) else { continue };
            for i in 0..=10 {
                let ([x, y, theta], q) = (leg.at(f64::from(i) / 10.0), motion.at(f64::from(i) / 10.0));
                assert!((x - q[0]).abs().max((y - q[1]).abs()) < 1e-9 * scale, "world {number}: {motion:?}");
                let (sin, cos) = libm::sincos(theta - q[2]);
                assert!(sin.abs() < 1e-10 && cos > 0.0, "world {number}: {motion:?}");
            }
            let samples = (0..=300).map(|i| motion.at(f64::from(i) / 300.0));
            let is_hit = samples.clone().any(|q| touches(&body, &world, &q) || collision.depth(&q) < -1e-9 * scale);
            let verdict = verify_legs(&world, &body, &[leg]);
            let is_valid = matches!(verdict, Verdict::Valid { .. });
            let is_proven = collision.is_motion_free(&motion);
            assert!(is_valid || !is_proven, "world {number}: {motion:?} is proven, but {verdict:?}");
            assert!(!is_valid || !is_hit, "world {number}: {motion:?} touches, but is judged valid");
            proven += u32::from(is_proven);
            valid += u32::from(is_valid);
            touching += u32::from(is_hit);
        }
    }
    let least = seeds(60) as u32;
    assert!(proven > 2 * least && touching > 5 * least, "{proven} proven, {valid} valid, {touching} touching");
    assert!(valid - proven <= proven / 20, "{proven} proven, {valid} valid");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_reported_clearance_is_the_distance() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let obstacle = Obstacle::Polygon(rectangle([1.9, 1.0], [2.1, 2.0]));
    let world = world([0.0, 0.0], [4.0, 4.0], vec![obstacle]);
    let reported = |leg: Leg| match verify_legs(&world, &body, &[leg]) {
        Verdict::Valid { clearance, samples, waypoints: 1, .. } if samples > 100 => clearance,
        other => panic!("{other:?}"),
    };
    assert!((reported(Leg::straight(&[0.5, 0.75, 0.0], &[3.4, 0.75, 0.0])) - 0.15).abs() < 1e-12);
    // Half a circle of radius 1.2 about (2, 1.5): the body's inner side is nearest to the corners above.
    let found = reported(Leg::arc(&[3.2, 1.5, FRAC_PI_2], 1.2 * PI, PI));
    assert!((found - (1.1 - libm::sqrt(0.01 + 0.25))).abs() < 1e-5, "{found}");
}

#[wasm_bindgen_test(unsupported = test)]
fn nothing_is_missed_between_two_samples() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    for size in [1e-2, 1e-4, 1e-6] {
        let speck = |x: f64, y: f64| {
            let obstacle = Obstacle::Polygon(rectangle([x, y], [x + size, y + size]));
            world([0.0, 0.0], [4.0, 4.0], vec![obstacle])
        };
        // A corner passes just by it or just over it while the body turns: corners describe a circle about (2, 2).
        let reach = libm::sqrt(0.05);
        for (gap, is_free) in [(1e-7, true), (-1e-7, false)] {
            let world = speck(2.0 + reach + gap, 2.0);
            let motions = [
                Leg::straight(&[2.0, 2.0, 0.0], &[2.0, 2.0, 3.0]),
                Leg::straight(&[2.0, 2.0, 1.0], &[2.0, 2.0, -1.0]),
                Leg::arc(&[2.0, 2.0, 0.0], 0.0, 3.0),
                Leg::arc(&[2.0, 2.0, 0.0], 0.0, -300.0),
            ];
            for leg in motions {
                assert_eq!(is_valid(&world, &body, leg), is_free, "{gap} from a speck of {size}: {leg:?}");
            }
            // The upper side passes under it.
            let leg = Leg::straight(&[1.0, 1.9 - gap, 0.0], &[3.0003, 1.9 - gap, 0.0]);
            assert_eq!(is_valid(&speck(2.0, 2.0), &body, leg), is_free, "{gap} under a speck of {size}");
        }
        // Contained wholly from the start on; and met later.
        assert!(!is_valid(&speck(1.0, 1.0), &body, Leg::straight(&[1.0, 1.0, 0.0], &[1.0, 1.0, 0.0])));
        assert!(!is_valid(&speck(2.0, 2.0), &body, Leg::arc(&[1.0, 2.0, 0.0], 2.0, 1e-3)));
    }
    let disc = Obstacle::Disc(Disc { center: p(1.0, 1.0), radius: 0.01 });
    let with_disc = world([0.0, 0.0], [4.0, 4.0], vec![disc]);
    assert!(!is_valid(&with_disc, &body, Leg::straight(&[1.0, 1.0, 0.0], &[1.0, 1.0, 0.5])), "a disc inside");
    let block = Obstacle::Polygon(rectangle([0.0, 0.0], [2.0, 2.0]));
    let with_block = world([0.0, 0.0], [4.0, 4.0], vec![block]);
    assert!(!is_valid(&with_block, &body, Leg::straight(&[1.0, 1.0, 0.0], &[1.0, 1.0, 0.5])), "inside a block");
}

#[wasm_bindgen_test(unsupported = test)]
fn bounds_may_be_touched_but_not_left() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let world = world([0.0, 0.0], [4.0, 4.0], vec![]);
    assert!(is_valid(&world, &body, Leg::straight(&[0.2, 0.1, 0.0], &[3.8, 0.1, 0.0])), "along the lower bound");
    assert!(is_valid(&world, &body, Leg::arc(&[0.2, 3.9, 0.0], 3.6, 0.0)), "along the upper bound");
    assert!(!is_valid(&world, &body, Leg::straight(&[0.2, 0.1, 0.0], &[3.8, 0.0999, 0.0])), "through it");
    // Turning next to a bound: a corner sticks out in between alone.
    let reach = libm::sqrt(0.05);
    for (gap, is_inside) in [(1e-6, true), (-1e-6, false)] {
        let leg = Leg::straight(&[2.0, reach + gap, 0.0], &[2.0, reach + gap, -3.0]);
        assert_eq!(is_valid(&world, &body, leg), is_inside, "{gap} from the lower bound");
        // A circle whose outermost corner passes the bound.
        let radius = libm::sqrt((2.0 - gap) * (2.0 - gap) - 0.04) - 0.1;
        let leg = Leg::arc(&[2.0 + radius, 2.0, FRAC_PI_2], 20.0 * PI * radius, 20.0 * PI);
        assert_eq!(is_valid(&world, &body, leg), is_inside, "ten times around, {gap} from the bounds");
    }
}

fn scenario(goal_tolerance: &str) -> Scenario {
    let metric = r#""metric": {"translation": 0.5, "rotation": 0.25}"#;
    let robot = documents::rectangular("rigid_body", 0.2, 0.1, metric);
    let query = format!(r#""start": [1, 2, 3], "goal": [3, 2, -3] {goal_tolerance}"#);
    documents::scenario("[0, 0], [4, 4]", &documents::disc([2.0, 1.0], 0.5), &robot, &query)
}

fn judged(scenario: &Scenario, path: &[[f64; 3]], length: f64) -> Result<(), String> {
    documents::judged(scenario, &documents::result("s", &format!("{path:?}"), None, length)).map(drop)
}

#[wasm_bindgen_test(unsupported = test)]
fn a_path_of_a_rigid_body_is_judged_as_a_whole() {
    let exact = scenario("");
    let (start, goal) = ([1.0, 2.0, 3.0], [3.0, 2.0, -3.0]);
    let turn = TAU - 6.0;
    let length = 0.5 * 2.0 + 0.25 * turn;
    assert_eq!(judged(&exact, &[start, goal], length), Ok(()), "in the shorter direction");
    assert_eq!(judged(&exact, &[start, [2.0, 2.0, -PI], goal], 1.0 + 0.25 * turn), Ok(()));
    assert_eq!(judged(&exact, &[[1.0, 2.0, 3.0 - TAU], goal], length), Ok(()), "angles count in any number of turns");
    let refused = |scenario: &Scenario, path: &[[f64; 3]], length: f64, why: &str| {
        let reported = judged(scenario, path, length).expect_err(why);
        assert!(reported.contains(why), "{reported:?} does not contain {why:?}");
    };
    refused(&exact, &[start, goal], length + 1e-6, "the length is given");
    refused(&exact, &[start, [3.0, 2.0, -2.9]], length, "not at the goal");
    refused(&exact, &[[1.1, 2.0, 3.0], goal], length, "not at the start");
    refused(&exact, &[start, [2.0, 1.0, 3.0], goal], length, "edge 0, the body touches obstacle 0");
    refused(&exact, &[start, [0.1, 2.0, 3.0], goal], length, "edge 0, the body leaves the bounds");
    refused(&exact, &[start, [2.0, 2.0, 3.0 - PI], goal], length, "edge 0 turns the body by 3.14");
    let region = scenario(r#", "goal_tolerance": {"translation": 0.1, "rotation": 0.2}"#);
    let near = 0.5 * libm::sqrt(1.95 * 1.95 + 0.08 * 0.08) + 0.25 * (turn + 0.1);
    assert_eq!(judged(&region, &[start, [2.95, 2.08, -2.9]], near), Ok(()));
    refused(&region, &[start, [2.9, 2.1, -3.0]], length, "from the goal");
    refused(&region, &[start, [3.0, 2.0, -2.7]], length, "from the goal");
    refused(&region, &[[1.05, 2.0, 3.0], goal], length, "not at the start");
}
