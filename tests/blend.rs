//! Blends: corners of a path rounded by parabolas, each proven free or left as it was.

use crate::common::bodies::clearance;
use crate::common::documents::{CAR, arm, disc, judged, refuses, scenario};
use crate::common::{
    arm_and_wall, arm_of, assert_valid, begin_with, cases, disc_and_wall, finish, parse, seeds, thick_arm_and_wall,
};
use planarium::collision::{ArmValidity, BodyCollision, BodyValidity, DiscValidity};
use planarium::path::{ResultDocument, verify};
use planarium::problem::Validity;
use planarium::random::{Random, Stream};
use planarium::robot::{MAX_LINKS, Part, joint_space, placements, plane};
use planarium::run::Status;
use planarium::scenario::generate::generate;
use planarium::scenario::{Robot, Scenario};
use planarium::space::{Metric, MotionSpace, ProductSpace, Space};
use serde_json::json;
use std::f64::consts::TAU;
use std::sync::Arc;
use wasm_bindgen_test::wasm_bindgen_test;

fn forest(links: usize, seed: u64) -> Scenario {
    generate("forest", &json!({ "links": links, "seed": seed })).expect("a forest")
}

fn body(seed: u64) -> Scenario {
    generate("clutter", &json!({ "robot": "rigid_body", "seed": seed })).expect("clutter")
}

fn worlds() -> Vec<Scenario> {
    let mut worlds = vec![arm_and_wall(1e-3), thick_arm_and_wall(0.1), arm_of(3, true, 0.05), arm_of(6, false, 0.0)];
    worlds.extend([disc_and_wall(0.3, 0.5), disc_and_wall(0.0, 1e-6), forest(3, 4), body(5), body(6)]);
    worlds
}

/// The step from `a` to `b`, angles on circles the short way round.
fn step(robot: &Robot, a: &[f64], b: &[f64]) -> Vec<f64> {
    let is_circle = |i: usize| match robot {
        Robot::Arm(arm) => arm.joint_limits().is_none(),
        Robot::Disc(_) => false,
        _ => i == 2,
    };
    let step = |i: usize| if is_circle(i) { libm::remainder(b[i] - a[i], TAU) } else { b[i] - a[i] };
    (0..a.len()).map(step).collect()
}

fn between(a: &[f64], b: &[f64], t: f64) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + t * (b - a)).collect()
}

/// The control points of the blend of waypoint i + 1, and its shares; angles are not wrapped.
fn blend(robot: &Robot, result: &ResultDocument, i: usize) -> ([Vec<f64>; 3], [f64; 2]) {
    let (corner, shares) = (&result.path[i + 1], result.blends.as_ref().expect("blends")[i]);
    let end = |to: usize, share: f64| {
        let step = step(robot, corner, &result.path[to]);
        corner.iter().zip(step).map(|(at, step)| at + share * step).collect()
    };
    ([end(i, shares[0]), corner.clone(), end(i + 2, shares[1])], shares)
}

/// By de Casteljau's algorithm.
fn along([from, corner, to]: &[Vec<f64>; 3], u: f64) -> Vec<f64> {
    between(&between(from, corner, u), &between(corner, to, u), u)
}

/// How far parts of a robot lie within the bounds; less than 0 outside.
fn depth(parts: &[Part], scenario: &Scenario) -> f64 {
    let Some(bounds) = scenario.world().bounds else { return f64::INFINITY };
    let depth = |part: &Part| match part {
        Part::Capsule { a, b, radius } => bounds.depth(*a).min(bounds.depth(*b)) - radius,
        Part::Disc { center, radius } => bounds.depth(*center) - radius,
        Part::Polygon { vertices } => vertices.iter().map(|&v| bounds.depth(v)).fold(f64::INFINITY, f64::min),
    };
    parts.iter().map(depth).fold(f64::INFINITY, f64::min)
}

#[wasm_bindgen_test(unsupported = test)]
fn blended_paths_are_free_at_every_look_and_shorter_by_what_they_say() {
    let (mut rounded, mut corners) = (0, 0);
    for world in &worlds() {
        for (seed, settings) in (0..seeds(8)).flat_map(|seed| [(seed, ""), (seed, "reduce=true shortcut=30")]).take(6) {
            let run = finish(begin_with(world, "rrt-connect", seed, &format!("{settings} blend=0.5")));
            if run.status() != Status::Solved {
                continue;
            }
            assert_valid(world, &*run);
            let result = run.result();
            let sharp = finish(begin_with(world, "rrt-connect", seed, settings));
            assert_eq!((&result.path, result.length), (&sharp.path(), sharp.length()), "corners stay in the path");
            let Some(shares) = &result.blends else { continue };
            let blended = result.blended_length.expect("a length");
            assert!(blended <= result.length, "{blended} of {}", result.length);
            for i in 0..shares.len() {
                let (points, [before, after]) = blend(world.robot(), &result, i);
                corners += 1;
                rounded += u32::from(before > 0.0);
                assert!(
                    (0.0..=0.5).contains(&before) && (0.0..=0.5).contains(&after) && (before > 0.0) == (after > 0.0)
                );
                let looks = cases(10_000);
                for look in 0..=looks {
                    let parts = world.robot().footprint(&along(&points, look as f64 / looks as f64));
                    let room = clearance(&parts, world.world()).min(depth(&parts, world) + 1e-9);
                    assert!(room > 0.0, "{} seed {seed}, blend {i} at {look}/{looks}: {room}", world.name());
                }
            }
        }
    }
    assert!(corners > 100 && rounded * 2 > corners, "{rounded} of {corners} corners are rounded");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_robot_at_constant_speed_never_changes_its_velocity_by_a_jump() {
    for world in &worlds() {
        let space = joints_of(world);
        let run = finish(begin_with(world, "rrt-connect", 3, "blend=0.5"));
        let result = run.result();
        for i in 0..result.blends.as_ref().map_or(0, Vec::len) {
            let (points, shares) = blend(world.robot(), &result, i);
            if shares[0] == 0.0 {
                continue;
            }
            let states = [0, 1, 2].map(|k| space.state(&result.path[i + k]));
            let edges = [space.distance(&states[0], &states[1]), space.distance(&states[1], &states[2])];
            let seconds = 2.0 * shares[0] * edges[0];
            assert!(
                (seconds - 2.0 * shares[1] * edges[1]).abs() < 1e-12,
                "it begins as far from the corner as it ends"
            );
            // Of a quadratic exact but for rounding, from values on one side alone.
            let slope = |at: f64, h: f64| {
                let [q0, q1, q2] = [0.0, 1.0, 2.0].map(|k| along(&points, at + k * h));
                (0..q0.len()).map(|j| (4.0 * q1[j] - 3.0 * q0[j] - q2[j]) / (2.0 * h * seconds)).collect::<Vec<f64>>()
            };
            for (velocity, k) in [(slope(0.0, 0.25), 0), (slope(1.0, -0.25), 1)] {
                let edge = step(world.robot(), &result.path[i + k], &result.path[i + k + 1]);
                for (velocity, edge) in velocity.iter().zip(&edge) {
                    assert!(
                        (velocity - edge / edges[k]).abs() < 1e-9 + 1e-14 / seconds,
                        "{}: {velocity}, {edge}",
                        world.name()
                    );
                }
            }
        }
    }
}

/// The space of the scenario's robot, with the metric of its planners.
fn joints_of(scenario: &Scenario) -> ProductSpace<MAX_LINKS> {
    match scenario.robot() {
        Robot::Arm(arm) => joint_space(arm, Metric::Sum),
        Robot::Disc(_) => plane(&scenario.world().bounds.expect("bounds")),
        Robot::RigidBody(body) => placements(&body.shape, body.weights, &scenario.world().bounds.expect("bounds")),
        _ => panic!("a car is steered"),
    }
}

fn validity_of(scenario: &Scenario) -> Box<dyn Validity<[f64; MAX_LINKS]>> {
    let (world, space) = (scenario.world(), joints_of(scenario));
    match scenario.robot() {
        Robot::Arm(arm) => Box::new(ArmValidity::new(arm, space, world, 1e-4)),
        Robot::Disc(disc) => Box::new(DiscValidity::new(disc, world)),
        Robot::RigidBody(body) => {
            Box::new(BodyValidity::new(MotionSpace::new(space), Arc::new(BodyCollision::new(&body.shape, world, 1e-4))))
        }
        _ => panic!("a car is steered"),
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_blend_that_touches_is_accepted_and_none_with_room_is_refused() {
    let [mut accepted, mut refused] = [0; 2];
    for world in &worlds() {
        let (space, validity) = (joints_of(world), validity_of(world));
        let mut random = Random::new(7, Stream::Samples);
        let size = world.world().bounds.map_or(4.0, |bounds| bounds.longer_side());
        for _ in 0..cases(600) {
            let corner = space.sample(&mut random);
            let end = |random: &mut Random| {
                let far = space.sample(random);
                let part = 0.4 * random.uniform() * random.uniform();
                space.interpolate(&corner, &far, part)
            };
            let states = [end(&mut random), corner, end(&mut random)];
            if !states.iter().all(|state| validity.is_free(state)) {
                continue;
            }
            let rows = states.map(|state| space.coordinates(&state).to_vec());
            let ends = [0, 2].map(|k| step(world.robot(), &rows[1], &rows[k]));
            let end = |k: usize| rows[1].iter().zip(&ends[k]).map(|(at, step)| at + step).collect();
            let points = [end(0), rows[1].clone(), end(1)];
            let room = (0..=200).map(|look| {
                let parts = world.robot().footprint(&along(&points, f64::from(look) / 200.0));
                clearance(&parts, world.world()).min(depth(&parts, world))
            });
            let room = room.fold(f64::INFINITY, f64::min);
            if validity.is_blend_free(&states) {
                assert!(room > -1e-9, "{}: {rows:?} touches by {room}", world.name());
                accepted += 1;
            } else {
                assert!(room < 1e-3 * size, "{}: {rows:?} is refused with {room} of room", world.name());
                refused += 1;
            }
        }
    }
    assert!(accepted > 20 && refused > 1, "{accepted} accepted, {refused} refused");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_corner_around_the_tip_of_a_wall_is_never_cut() {
    for thickness in [0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        // The wall ends at height 8. A blend that begins t to the left of the corner, and t below it, is (x - 5)^2 / 2t below its top,
        // which is t/2 below the corner.
        let world = disc_and_wall(0.0, thickness);
        let (validity, half) = (validity_of(&world), 0.5 * thickness);
        let blend = |t: f64, height: f64| {
            let place = |x: f64, y: f64| [x, y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            validity.is_blend_free(&[place(5.0 - t, height - t), place(5.0, height), place(5.0 + t, height - t)])
        };
        for t in [1.2, 2.0, 3.0].map(|t| t * half.max(0.1)) {
            let lowest = 8.0 + 0.5 * t + half * half / (2.0 * t);
            assert!(!blend(t, lowest - 1e-9), "{thickness} {t}: through the tip");
            assert!(blend(t, lowest + 1e-3 * t), "{thickness} {t}: past the tip");
        }
        for world in [arm_and_wall(thickness), thick_arm_and_wall(thickness), world, disc_and_wall(0.2, thickness)] {
            for seed in 0..seeds(40) / 4 {
                let run = finish(begin_with(&world, "rrt-connect", seed, "shortcut=30 blend=0.5"));
                if run.status() == Status::Solved {
                    assert_valid(&world, &*run);
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn corners_are_rounded_one_an_iteration() {
    let settings = "reduce=true shortcut=10 partial_shortcut=10 blend=0.4";
    for world in [forest(3, 4), body(5)] {
        let whole = finish(begin_with(&world, "rrt-connect", 2, settings));
        let corners = whole.result().blends.expect("blends").len() as u64;
        let sharp = finish(begin_with(&world, "rrt-connect", 2, &settings.replace("blend=0.4", "")));
        assert_eq!(whole.iterations(), sharp.iterations() + corners);
        assert_eq!(whole.fingerprint(), sharp.fingerprint());
        // A run that is ended early keeps the blends that it has.
        let mut early = begin_with(&world, "rrt-connect", 2, settings);
        early.step(sharp.iterations() + 1);
        assert_eq!((early.finish(), early.path()), (Status::Solved, whole.path()));
        let some = early.result().blends.expect("blends");
        assert_eq!(
            (some[0], some[1..].iter().all(|shares| *shares == [0.0; 2])),
            (whole.result().blends.expect("blends")[0], true)
        );
        assert_valid(&world, &*early);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_verifier_judges_blends_over_all_of_their_motion() {
    // Round a disc in the inside of a right angle: the blend of shares s passes (1 - s/2, s/2).
    let document = |robot: &str, obstacle: [f64; 2], radius: f64| {
        scenario("[-4, -4], [4, 4]", &disc(obstacle, radius), robot, r#""start": [-1, 0], "goal": [1, 2]"#)
    };
    let result = |share: f64, blended: Option<f64>| {
        let path = [[-1.0, 0.0], [1.0, 0.0], [1.0, 2.0]].map(Vec::from).to_vec();
        let text = crate::common::documents::result("s", "[]", None, 4.0);
        ResultDocument { path, blends: Some(vec![[share; 2]]), blended_length: blended, ..text }
    };
    let round = document(r#"{"type": "disc", "radius": 0.1}"#, [0.8, 0.2], 0.05);
    // There it is (0.2 - s/2) sqrt 2 from the centre of the disc, and must be 0.15: s is less than 0.188.
    for (share, free) in [(0.0, true), (0.1, true), (0.187, true), (0.189, false), (0.5, false)] {
        // The parabola in a right angle.
        let blended = 4.0 - 2.0 * share * (1.0 - libm::asinh(1.0) / 2.0f64.sqrt());
        let verdict = judged(&round, &result(share, Some(blended)));
        assert_eq!(verdict.is_ok(), free, "{share}: {verdict:?}");
        let why = verdict.err().unwrap_or_default();
        assert!(free || why.contains("the blend of waypoint 1") && why.contains("obstacle 0"), "{why}");
    }
    assert!(judged(&round, &result(0.1, Some(4.0))).is_err_and(|why| why.contains("blended length")));
    let limp = document(&arm(&[1.0, 1.0], 0.0), [3.9, 3.9], 0.01);
    assert!(judged(&limp, &result(0.5, None)).is_ok());

    let refused = |result: &ResultDocument, pointer: &str| refuses(verify(&round, result), "invalid-result", pointer);
    let good = result(0.25, None);
    refused(&ResultDocument { blends: Some(vec![]), ..good.clone() }, "/blends");
    refused(&ResultDocument { blends: Some(vec![[0.1; 2]; 2]), ..good.clone() }, "/blends");
    for bad in [-0.1, 0.51, f64::NAN] {
        refused(&ResultDocument { blends: Some(vec![[0.2, bad]]), ..good.clone() }, "/blends/0/1");
    }
    let car = parse(CAR);
    let driven = ResultDocument { scenario: "car".into(), query: "across".into(), ..good };
    refuses(verify(&car, &driven), "invalid-result", "/blends");
}
