//! Bodies and cars at the limits of what is accepted: corners in one line, turning circles as wide as the world or as small as a
//! grain of dust, results that are wrong.

use crate::common::bodies::*;
use crate::common::documents::{self, arm, rectangular, refuses, scenario};
use crate::common::requests;
use crate::common::{assert_valid, begin_with, finish, options, parse, seeds};
use planarium::collision::{BodyCollision, BodyValidity};
use planarium::driving::{RolloutOptions, rollout};
use planarium::geometry::{Disc, Polygon};
use planarium::problem::{Control, Motion, Validity};
use planarium::random::{Random, Stream};
use planarium::robot::{Weights, placements};
use planarium::run::Status;
use planarium::run::storage::{RoadmapDocument, RoadmapMetric};
use planarium::scenario::{Obstacle, Scenario};
use planarium::space::MotionSpace;
use planarium::space::steering::{Pose, Steering};
use std::sync::Arc;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn corners_in_one_line_or_all_but_change_nothing() {
    let mut random = Random::new(6, Stream::Samples);
    let mut accepted = 0;
    for number in 0..seeds(30) {
        let around = [p(-1.0, -0.5), p(1.0, -0.5), p(1.0, 0.5), p(-1.0, 0.5)];
        let turn = if number % 2 == 0 { 0.0 } else { 6.0 * random.uniform() };
        let corner = |i: usize| around[i / 4] + (around[(i / 4 + 1) % 4] - around[i / 4]) * (0.25 * (i % 4) as f64);
        let corners = drawn(p(0.0, 0.0), turn, &std::array::from_fn::<_, 16, _>(|i| corner(i).into()));
        let hull: Vec<_> = corners.iter().copied().step_by(4).collect();
        let (Ok(body), Ok(plain)) = (Polygon::new(&corners), Polygon::new(&hull)) else { continue };
        let disc = |_| {
            let center = p(10.0 * random.uniform(), 10.0 * random.uniform());
            Obstacle::Disc(Disc { center, radius: 0.05 + 0.3 * random.uniform() })
        };
        let discs = (0..4).map(disc).collect();
        let world = world([0.0, 0.0], [10.0, 10.0], discs);
        let [collision, same] = [&body, &plain].map(|body| BodyCollision::new(body, &world, 1e-2));
        for _ in 0..400 {
            let from = [10.0 * random.uniform(), 10.0 * random.uniform(), 6.0 * random.uniform()];
            let motion = random_motion(&mut random, from, 1.0);
            if collision.is_motion_free(&motion) {
                accepted += 1;
                let is_touching = |i| !same.contacts(&motion.at(f64::from(i) / 400.0)).is_empty();
                assert!(!(0..=400).any(is_touching), "world {number}: {motion:?}");
            }
        }
    }
    assert!(accepted > 20 * seeds(30), "{accepted}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_curve_that_leads_nowhere_is_its_placement() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let block = Obstacle::Polygon(rectangle([1.5, 1.5], [2.5, 2.5]));
    let world = world([0.0, 0.0], [4.0, 4.0], vec![block]);
    let torus = placements::<4>(&body, Weights::default(), &world.bounds.expect("bounds"));
    for steering in [Steering::Dubins, Steering::ReedsShepp] {
        let space = MotionSpace::steered(torus.clone(), steering, 0.5);
        let validity = BodyValidity::new(space, Arc::new(BodyCollision::new(&body, &world, 1e-4)));
        for (q, is_free) in [([1.0, 1.0, 0.5, 0.0], true), ([2.0, 2.0, 0.5, 0.0], false), ([1.4, 2.0, 0.5, 0.0], false)]
        {
            assert_eq!(validity.is_motion_free(&q, &q), is_free, "{q:?}");
            assert_eq!(validity.first_hit(&q, &q), (!is_free).then_some(0.0), "{q:?}");
        }
    }
}

/// A car in an empty box of side 10.
fn car(wheelbase: &str, speed: &str, steering: &str, goal: &str) -> Scenario {
    let limits = format!(r#""wheelbase": {wheelbase}, "speed": {speed}, "steering": {steering}"#);
    let robot = rectangular("car", 0.2, 0.1, &limits);
    scenario("[0, 0], [10, 10]", "", &robot, &format!(r#""start": [1, 1, 0.3], "goal": {goal}"#))
}

#[wasm_bindgen_test(unsupported = test)]
fn whatever_the_turning_circle_what_is_solved_arrives() {
    let mut solved = 0;
    for (wheelbase, steering) in [
        ("1e-8", "[-1, 1]"),
        ("1e-4", "[-1, 1]"),
        ("1", "[-0.7, 0.7]"),
        ("100", "[-0.1, 0.1]"),
        ("1e6", "[-0.1, 0.1]"),
        ("1e6", "[-0.001, 0.001]"),
    ] {
        // All but straight ahead, and anywhere.
        for goal in ["[9, 3.47469006, 0.3]", "[9, 9, -2]"] {
            let scenario = car(wheelbase, "[-1, 1]", steering, goal);
            for planner in ["rrt", "rrt-connect"] {
                let mut run = begin_with(&scenario, planner, 1, "");
                if run.step(300) == Status::Solved {
                    solved += 1;
                    assert_valid(&scenario, &*run);
                }
            }
        }
    }
    assert!(solved >= 10, "{solved}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_reverse_gear_that_is_too_slow_is_no_matter_where_it_is_not_used() {
    let slow = car("1", "[-5e-324, 1]", "[-1, 1]", "[9, 9, -2]");
    assert!(requests::start(&slow, &options("rrt", 1, "steering=dubins")).is_ok());
}

#[wasm_bindgen_test(unsupported = test)]
fn curves_are_traced_as_finely_as_they_bend() {
    for wheelbase in ["1e-8", "1e-3", "0.3"] {
        let run = finish(begin_with(&car(wheelbase, "[-1, 1]", "[-1, 1]", "[9, 9, -2]"), "rrt", 1, ""));
        let traces = run.trace_rows(0);
        let rows: Vec<&[f64]> = traces.chunks(4).collect();
        assert!(rows.len() <= 170 * run.edge_count(), "{} rows for {} edges", rows.len(), run.edge_count());
        for pair in rows.windows(2).filter(|pair| pair[0][0] == pair[1][0]) {
            let turn = planarium::space::angular_distance(pair[0][3], pair[1][3]);
            assert!(turn <= 0.2 + 1e-9 && pair[0] != pair[1], "{pair:?}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_stored_roadmap_contains_the_steering_of_the_car() {
    let scenario = car("0.5", "[-1, 1]", "[-0.6, 0.6]", "[9, 9, -2]");
    for word in ["dubins", "reeds-shepp"] {
        let run = finish(begin_with(&scenario, "prm", 1, &format!("samples=60 k=6 steering={word}")));
        let document = run.roadmap().expect("a roadmap");
        assert!(document.metric.to_string().contains(word), "{}", document.metric);
        assert_eq!(document.is_directed(), word == "dubins");
        assert_eq!(document.to_graphml().contains("edgedefault=\"directed\""), word == "dubins");
        assert_eq!(RoadmapDocument::parse(&document.to_json()).expect("its own JSON"), document);
        // The same path, with and without the steering given again.
        for given in ["", &format!("steering={word}")] {
            let resumed = finish(requests::resume(&scenario, &options("prm", 1, given), &document).expect("it fits"));
            assert_eq!(resumed.path(), run.path());
            assert_eq!(resumed.roadmap().expect("a roadmap").edges, document.edges);
        }
        let other = if word == "dubins" { "reeds-shepp" } else { "dubins" };
        let error = requests::resume(&scenario, &options("prm", 1, &format!("steering={other}")), &document).err();
        assert_eq!(error.expect("refused").pointer(), "/steering");
        let metric = RoadmapMetric::Placement { translation: 0.7, rotation: 0.3 };
        let plain = RoadmapDocument { metric, ..document.clone() };
        refuses(requests::resume(&scenario, &options("prm", 1, ""), &plain), "invalid-roadmap", "/metric");
        // Lengths of edges are those of the space.
        let rows: Vec<&[f64]> = document.rows().collect();
        let steering = if word == "dubins" { Steering::Dubins } else { Steering::ReedsShepp };
        for &edge in &document.edges {
            let [a, b] = edge.map(|i| rows[i as usize]).map(|q| Pose { x: q[0], y: q[1], heading: q[2] });
            let length = steering.shortest(a, b, 0.5 / libm::tan(0.6)).length();
            assert!((document.length(edge) - length).abs() <= 1e-12 * length);
        }
    }
}

/// Why a solved result of this path is refused.
fn why(scenario: &Scenario, path: &str, motions: Option<&str>, length: f64) -> Option<String> {
    documents::judged(scenario, &documents::result(scenario.name(), path, motions, length)).err()
}

#[wasm_bindgen_test(unsupported = test)]
fn no_waypoint_has_an_angle_too_large_to_be_accurate() {
    // Through a slot that only a body fits that lies flat; at both ends it is upright.
    let [low, high] = [0.0, 1.2].map(|y| documents::rectangle([2.0, y], [4.0, y + 0.8]));
    let query = r#""start": [1, 1, 1.5], "goal": [5, 1, 1.5]"#;
    let body = rectangular("rigid_body", 0.4, 0.1, "");
    let scenario = scenario("[0, 0], [6, 2]", &format!("{low}, {high}"), &body, query);
    let upright = why(&scenario, "[[1, 1, 1.5], [5, 1, 1.5]]", None, 2.8);
    assert!(upright.expect("it does not fit").contains("obstacle"));
    // By its sine the angle lies flat; by the remainder of whole turns, as steps are measured, it is upright.
    let turns = |angle: f64| {
        let rest = |a: f64| libm::remainder(a, std::f64::consts::TAU);
        rest(rest(angle) - rest(1.5)).abs()
    };
    let angle = (0..100_000)
        .map(|i| 4e16 + 8.0 * f64::from(i))
        .find(|&angle| libm::sin(angle).abs() < 0.05 && turns(angle) < 0.2)
        .expect("such an angle");
    let length = 2.8 + 0.3 * 2.0 * turns(angle);
    let lying = why(&scenario, &format!("[[1, 1, 1.5], [1, 1, {angle:e}], [5, 1, 1.5]]"), None, length);
    assert!(lying.expect("it is refused").contains("waypoint 1 contains"));
}

#[wasm_bindgen_test(unsupported = test)]
fn no_step_of_a_car_leads_through_a_wall_and_many_turns_are_judged_at_once() {
    let wall = documents::rectangle([5.0, 0.0], [5.0000000001, 10.0]);
    let limits = r#""wheelbase": 1e-3, "speed": [-1, 1], "steering": [-1, 1]"#;
    let query = r#""start": [4.9999999997, 5, 0], "goal": [5.0000000005, 5, 0]"#;
    let scenario = scenario("[0, 0], [10, 10]", &wall, &rectangular("car", 1e-10, 1e-10, limits), query);
    let motion = |speed: f64, steering: f64, duration: f64| {
        format!(r#"{{ "control": [{speed:e}, {steering:e}], "duration": {duration:e} }}"#)
    };
    // It does not move, and the waypoint is as near as rounding might have it.
    let path = "[[4.9999999997, 5, 0], [5.0000000005, 5, 0]]";
    let why = |path, motions: &str, length| why(&scenario, path, Some(motions), length).expect("it is refused");
    let resting = motion(0.0, 0.0, 1.0);
    assert!(why(path, &format!("[{resting}]"), 0.0).contains("obstacle"));
    // A million and a trillion metres in circles: their ends cannot be computed, and they are not examined turn by turn.
    for metres in [1e6, 1e12, 1e300] {
        let length = 0.7 * metres + 0.3 * metres * libm::tan(1.0) / 1e-3;
        let motions = format!("[{}, {resting}]", motion(1.0, 1.0, metres));
        let path = "[[4.9999999997, 5, 0], [5.0002, 5, 0], [5.0000000005, 5, 0]]";
        assert!(why(path, &motions, length).contains("motion 0 turns by"));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_grain_of_dust_in_a_wide_world_is_judged_at_once() {
    let (disc, dust) = (documents::disc([5e5, 5e5], 10.0), rectangular("rigid_body", 1e-3, 1e-3, ""));
    let scenario = scenario("[0, 0], [1e6, 1e6]", &disc, &dust, r#""start": [1, 1, 0], "goal": [999999, 1, 0]"#);
    assert_valid(&scenario, &*finish(begin_with(&scenario, "rrt", 1, "")));
    let through = why(&scenario, "[[1, 1, 0], [999999, 999999, 0], [999999, 1, 0]]", None, 1e6);
    assert!(through.expect("it hits the disc").contains("obstacle"));
}

/// A car as fast as can be in an empty box of side 4, with more fields of the robot.
fn fast_car(more: &str, query: &str) -> Scenario {
    let limits = r#""wheelbase": 1, "speed": [-1e6, 1e6], "steering": [-0.7, 0.7], "integration_step": 10"#;
    scenario("[0, 0], [4, 4]", "", &rectangular("car", 0.2, 0.1, &format!("{limits}{more}")), query)
}

#[wasm_bindgen_test(unsupported = test)]
fn a_car_is_not_driven_in_more_turns_than_can_be_told_apart() {
    // Three million turns a step, a metre round; where they end is off by more than what the proof leaves to rounding.
    let scenario = fast_car("", r#""start": [2, 1, 0], "goal": [2, 1, 1]"#);
    let control = |speed: f64| Motion { control: Control { speed, steering: 0.7 }, duration: 10.0 };
    let driven = |speed: f64| {
        rollout(&scenario, &[2.0, 1.0, 0.0], control(speed), RolloutOptions::default()).expect("a car").poses.len()
    };
    assert_eq!([1.0, 50.0, 1e3, 1e6].map(driven), [2, 2, 1, 1]);
}

/// A document with one obstacle, and a body of this shape.
fn with_polygons(obstacle: &[[f64; 2]], shape: &[[f64; 2]]) -> String {
    let robot = format!(r#"{{"type": "rigid_body", "shape": {}}}"#, documents::polygon(shape));
    let query = r#""start": [5, 5, 0], "goal": [-5, -5, 1]"#;
    documents::text("tiny", "[-9, -9], [9, 9]", &documents::polygon(obstacle), &robot, query)
}

#[wasm_bindgen_test(unsupported = test)]
fn polygons_are_exact_down_to_a_limit() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    // As small as this it is exact; so are zeros, and coordinates of very different sizes.
    for small in [1e-140, 1e-100, 1e-17] {
        let small = [[0.0, 0.0], [small, -0.0], [1.0, 1.0], [0.0, small]];
        parse(&with_polygons(&small, &square));
        parse(&with_polygons(&square, &small));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn polygons_of_all_scales_are_refused_or_cut_up_exactly() {
    let mut random = Random::new(21, Stream::Samples);
    let (mut accepted, mut concave, mut planned) = (0, 0, 0);
    for number in 0..3000 {
        let smallest = [20, 145, 330, 600][random.below(4) as usize];
        let mut coordinate = || {
            let exponent = random.below(smallest) as f64 - smallest as f64 * if smallest == 600 { 0.5 } else { 1.0 };
            let magnitude = (1.0 + random.below(9) as f64) * libm::exp10(exponent);
            [0.0, -0.0, magnitude, -magnitude, 1.0, f64::NAN]
                [random.below(if smallest == 600 { 6 } else { 5 }) as usize]
        };
        let corners: Vec<[f64; 2]> = (0..3 + number % 4).map(|_| [coordinate(), coordinate()]).collect();
        let points: Vec<_> = corners.iter().map(|&[x, y]| p(x, y)).collect();
        let Ok(polygon) = Polygon::new(&points) else { continue };
        accepted += 1;
        let pieces = planarium::geometry::convex_pieces(&polygon);
        assert!(pieces.iter().all(|piece| piece.is_convex() && piece.vertices().len() > 2), "{polygon:?}");
        assert!(pieces.iter().all(|piece| Polygon::new(piece.vertices()).is_ok_and(|again| again == *piece)));
        concave += u32::from(!polygon.is_convex());
        let square = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.1]];
        for text in [with_polygons(&corners, &square), with_polygons(&square, &corners)] {
            let Ok(scenario) = Scenario::parse(&text) else { continue };
            let Ok(mut run) = requests::start(&scenario, &options("rrt-connect", number, "")) else { continue };
            run.step(3);
            planned += 1;
        }
    }
    assert!(accepted > 300 && concave > 10 && planned > 100, "{accepted}, {concave} concave, {planned} planned");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_judge_bounds_what_it_can_compute() {
    // A heading after 1e15 rad is off by a tenth of a radian.
    let metric = r#", "metric": { "translation": 1, "rotation": 1 }"#;
    let region = r#""goal_tolerance": { "translation": 4, "rotation": 4 }"#;
    let scenario = fast_car(metric, &format!(r#""start": [2, 1, 0], "goal": [2, 1, 0], {region}"#));
    let pace = libm::tan(0.7);
    let judged = |turn: f64| {
        let metres = turn / pace;
        let heading = libm::remainder(turn, std::f64::consts::TAU);
        let from = planarium::geometry::arc_pose([2.0, 1.0, 0.0], 1.0 / pace, 1.0, heading);
        let motions = format!(r#"[{{ "control": [1, 0.7], "duration": {metres:e} }}]"#);
        let path = format!("[[2, 1, 0], [{:?}, {:?}, {:?}]]", from[0], from[1], heading);
        why(&scenario, &path, Some(&motions), metres)
    };
    assert_eq!(judged(900.0), None);
    for turn in [1001.0, 1e9, 1e15] {
        assert!(judged(turn).expect("it cannot be judged").contains("motion 0 turns by"), "{turn}");
    }
    // With one waypoint this far away any length would be within rounding.
    let scenario = self::scenario("", "", &arm(&[1.0, 1.0], 0.0), r#""start": [0, 0], "goal": [1, 1]"#);
    for angle in [1e308, -1e16, 1.0000001e6] {
        let lying = why(&scenario, &format!("[[0, 0], [{angle:e}, 0], [1, 1]]"), None, 17.0);
        assert!(lying.expect("it is refused").contains("waypoint 1 contains"), "{angle}");
    }
}

/// A gigabyte: `PLANARIUM_DEEP=1` alone.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn a_run_without_end_ends_before_the_memory_does() {
    if std::env::var_os("PLANARIUM_DEEP").is_none() {
        return;
    }
    let block = documents::rectangle([0.01, 0.0], [9.99, 10.0]);
    let robot = r#"{ "type": "disc", "radius": 0.001 }"#;
    let scenario = scenario("[0, 0], [10, 10]", &block, robot, r#""start": [0.005, 5], "goal": [9.995, 5]"#);
    let mut run = requests::start(&scenario, &options("prm", 1, "max_iterations=4e9 samples=1e6")).expect("a run");
    assert_eq!(run.step(u64::MAX), Status::Exhausted);
    let records = run.vertex_count() + run.edge_count() + run.event_count();
    let most = planarium::graph::MAX_RECORDS;
    assert!((most..most + 1000).contains(&records), "{records}");
    assert_eq!(run.reason(), Some(planarium::run::Reason::GraphFull));
}
