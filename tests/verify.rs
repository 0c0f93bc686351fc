//! The independent judge of paths: hand-made paths, valid and not. Ends of motions are odd, so that no sample falls exactly on an
//! obstacle.

use crate::common::documents::{self, arm, disc, judged, limited_arm, polygon, rectangle, refuses};
use planarium::path::{ResultDocument, verify};
use planarium::scenario::Scenario;
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// A scenario with one query, "q".
fn scenario(bounds: &str, obstacles: &[String], robot: &str, ends: [&[f64]; 2]) -> Scenario {
    let query = format!(r#""start": {:?}, "goal": {:?}"#, ends[0], ends[1]);
    documents::scenario(bounds, &obstacles.join(","), robot, &query)
}

fn robot_disc(radius: f64) -> String {
    format!(r#"{{"type": "disc", "radius": {radius:?}}}"#)
}

fn result(path: &[&[f64]], length: f64) -> ResultDocument {
    documents::result("s", &format!("{path:?}"), None, length)
}

/// Angles in the shorter direction, summed over joints; plain differences for limited joints and points need their own.
fn circle_length(path: &[&[f64]]) -> f64 {
    let short = |a: f64, b: f64| (b - a - TAU * ((b - a) / TAU).round()).abs();
    path.windows(2).flat_map(|e| e[0].iter().zip(e[1]).map(move |(a, b)| short(*a, *b))).sum()
}

fn straight_length(path: &[&[f64]]) -> f64 {
    let gap = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (b - a) * (b - a)).sum::<f64>().sqrt();
    path.windows(2).map(|e| gap(e[0], e[1])).sum()
}

/// The clearance of a path, or why it is invalid.
type Verdict = Result<f64, String>;

/// The verdict on a path from its first to its last waypoint.
fn judge_in(bounds: &str, obstacles: &[String], robot: &str, path: &[&[f64]], length: f64) -> Verdict {
    judged(&scenario(bounds, obstacles, robot, [path[0], path[path.len() - 1]]), &result(path, length))
}

fn judge_arm(obstacles: &[String], robot: &str, path: &[&[f64]]) -> Verdict {
    judge_in("", obstacles, robot, path, circle_length(path))
}

const ROOM: &str = "[-4, -4], [4, 4]";

fn judge_disc(obstacles: &[String], radius: f64, path: &[&[f64]]) -> Verdict {
    judge_in(ROOM, obstacles, &robot_disc(radius), path, straight_length(path))
}

/// The clearance of a path that must be valid.
#[track_caller]
fn clearance(verdict: Verdict) -> f64 {
    verdict.unwrap_or_else(|why| panic!("refused: {why}"))
}

/// Checks that a path is invalid, and that all the words are in the reason.
#[track_caller]
fn refused(verdict: Verdict, words: &[&str]) {
    let why = verdict.expect_err("it is accepted");
    assert!(words.iter().all(|word| why.contains(word)), "{why:?} does not contain {words:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_wall_is_not_crossed_however_thin() {
    for thickness in [0.5, 1e-3, 1e-6, 1e-9, 1e-12] {
        let far = disc([3.0, 3.0], 0.1);
        let across = rectangle([0.7, -thickness / 2.0], [0.9, thickness / 2.0]);
        for radius in [0.0, 0.05] {
            let both = [far.clone(), across.clone()];
            let sweep: &[&[f64]] = &[&[-1.0], &[-0.9], &[1.0137]];
            refused(judge_arm(&both, &arm(&[1.0], radius), sweep), &["edge 1", "link 1", "obstacle 1"]);
            let sweep: &[&[f64]] = &[&[-1.0, 0.1, -0.1], &[1.0371, 0.0213, 0.0]];
            let verdict = judge_arm(&both[1..], &arm(&[0.3, 0.3, 0.4], radius), sweep);
            refused(verdict, &["edge 0", "link 3", "obstacle 0"]);
            let path: &[&[f64]] = &[&[-1.0, -1.0], &[0.8, -1.0], &[0.81, 1.0]];
            refused(judge_disc(&both, radius, path), &["edge 1", "obstacle 1"]);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_speck_between_two_samples_is_found() {
    for size in [1e-3, 1e-6, 1e-9] {
        let speck = polygon(&[[0.7123, 0.0], [0.7123 + size, 0.0], [0.7123, size]]);
        for obstacle in [[speck], [disc([0.7123, 0.0], size)]] {
            refused(judge_arm(&obstacle, &arm(&[1.0], 0.0), &[&[-1.0], &[0.7713]]), &["link 1", "obstacle 0"]);
            refused(judge_disc(&obstacle, 0.0, &[&[0.7123, -1.0], &[0.7123, 1.0]]), &["edge 0", "obstacle 0"]);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn touching_a_corner_is_collision_and_passing_it_is_not() {
    let corner = |x: f64| polygon(&[[x, 0.0], [2.0, -1.0], [2.0, 1.0]]);
    let sweep: &[&[f64]] = &[&[-0.5], &[0.6137]];
    // The tip comes to (1, 0), or a hair short of the corner there.
    for x in [0.9, 1.0 - 1e-9, 1.0, 1.0 + 1e-14] {
        refused(judge_arm(&[corner(x)], &arm(&[1.0], 0.0), sweep), &["edge 0", "link 1", "obstacle 0"]);
    }
    for gap in [1e-10, 1e-8, 1e-6, 1e-3] {
        let seen = clearance(judge_arm(&[corner(1.0 + gap)], &arm(&[1.0], 0.0), sweep));
        // Half the motion between two samples, at most, is added to the true one.
        assert!((0.9 * gap..gap + 1e-3).contains(&seen), "clearance {seen} past a gap of {gap}");
    }
    let thick = arm(&[1.0], 0.125);
    refused(judge_arm(&[corner(1.125)], &thick, sweep), &["link 1", "obstacle 0"]);
    clearance(judge_arm(&[corner(1.125 + 1e-9)], &thick, sweep));

    // A point along the diagonal of a corner at (1, 1): exact to the last bit.
    let diagonal: &[&[f64]] = &[&[-1.0, -1.0], &[2.0, 2.0]];
    let below = |y: f64| polygon(&[[1.0, y], [1.0, 0.0], [1.5, 0.5]]);
    refused(judge_disc(&[below(1.0)], 0.0, diagonal), &["edge 0 touches obstacle 0"]);
    clearance(judge_disc(&[below(1.0 - f64::EPSILON)], 0.0, diagonal));
    // And along an edge, or ending on one.
    refused(judge_disc(&[rectangle([0.0, -1.0], [1.0, 0.0])], 0.0, &[&[-1.0, 0.0], &[2.0, 0.0]]), &["obstacle 0"]);
    refused(judge_disc(&[rectangle([0.0, -1.0], [1.0, 0.0])], 0.0, &[&[0.5, 1.0], &[0.5, 0.0]]), &["its last end"]);
    // A disc that slides along a wall touches it; a nanometre away it does not.
    let slide = |y: f64| judge_disc(&[rectangle([0.0, -1.0], [1.0, 0.0])], 0.25, &[&[-1.0, y], &[2.0, y]]);
    refused(slide(0.25), &["obstacle 0"]);
    clearance(slide(0.25 + 1e-9));
    refused(judge_disc(&[disc([0.0, 0.0], 0.5)], 0.25, &[&[-1.0, 0.75], &[1.0, 0.75]]), &["obstacle 0"]);
    clearance(judge_disc(&[disc([0.0, 0.0], 0.5)], 0.25, &[&[-1.0, 0.75 + 1e-9], &[1.0, 0.75 + 1e-9]]));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tip_may_slide_along_a_wall_but_not_on_it() {
    // With two links of one length and q1 = -2 q0 the tip moves along the x axis.
    let slide: &[&[f64]] = &[&[0.3, -0.6], &[1.2, -2.4]];
    let wall = |top: f64| [rectangle([0.5, -1.0], [3.0, top])];
    refused(judge_arm(&wall(0.0), &arm(&[1.0, 1.0], 0.0), slide), &["link 2", "obstacle 0"]);
    for gap in [1e-11, 1e-9, 1e-6] {
        let seen = clearance(judge_arm(&wall(-gap), &arm(&[1.0, 1.0], 0.0), slide));
        assert!((0.5 * gap..2.0 * gap).contains(&seen), "clearance {seen} above a gap of {gap}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn bounds_may_be_touched_but_not_left() {
    let path: &[&[f64]] = &[&[-0.5], &[0.6137]];
    let judge = |x: f64, radius: f64| {
        judge_in(&format!("[-1, -1], [{x:?}, 1]"), &[], &arm(&[1.0], radius), path, circle_length(path))
    };
    refused(judge(0.99, 0.0), &["edge 0", "link 1", "leaves the bounds"]);
    refused(judge(1.0 - 1e-10, 0.0), &["leaves the bounds"]);
    assert_eq!(clearance(judge(1.0, 0.0)), f64::INFINITY, "nothing but bounds: the tip touches them at its farthest");
    refused(judge(1.0, 0.1), &["leaves the bounds"]);
    clearance(judge(1.1, 0.1));

    let judge = |x: f64, radius: f64| judge_disc(&[], radius, &[&[0.0, 0.0], &[x, 1.0], &[0.0, 2.0]]);
    clearance(judge(4.0, 0.0));
    clearance(judge(3.5, 0.5));
    refused(judge(4.0 + 1e-15, 0.0), &["waypoint 1 leaves the bounds"]);
    refused(judge(3.5 + 1e-9, 0.5), &["waypoint 1 leaves the bounds"]);
}

#[wasm_bindgen_test(unsupported = test)]
fn limited_joints_neither_leave_their_limits_nor_wrap() {
    let robot = limited_arm(&[1.0], 0.0, &[[-3.0, 3.0]]);
    let judge = |obstacles: &[String], path: &[&[f64]]| judge_in("", obstacles, &robot, path, straight_length(path));
    let (right, left) = ([disc([0.9, 0.0], 0.05)], [disc([-0.9, 0.0], 0.05)]);
    clearance(judge(&left, &[&[-3.0], &[3.0]]));
    refused(judge(&right, &[&[-3.0], &[3.0]]), &["link 1", "obstacle 0"]);
    refused(judge(&left, &[&[-3.0], &[3.0 + 1e-12], &[2.0]]), &["waypoint 1", "limits of joint 0"]);
    // The same two ends with a circle for a joint: in the other direction.
    let circle = arm(&[1.0], 0.0);
    clearance(judge_arm(&right, &circle, &[&[-3.0], &[3.0]]));
    refused(judge_arm(&left, &circle, &[&[-3.0], &[3.0]]), &["link 1", "obstacle 0"]);
    // Several turns of a limited joint are several turns.
    let winding = limited_arm(&[1.0], 0.0, &[[-100.0, 100.0]]);
    let path: &[&[f64]] = &[&[-PI / 2.0], &[TAU + PI / 2.0]];
    refused(judge_in("", &left, &winding, path, straight_length(path)), &["link 1", "obstacle 0"]);
    let path: &[&[f64]] = &[&[-99.0], &[99.0]];
    clearance(judge_in("", &[disc([1.2, 0.0], 0.1)], &winding, path, straight_length(path)));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_longer_direction_needs_waypoints() {
    let robot = arm(&[1.0], 0.0);
    let behind = [disc([-0.9, 0.0], 0.05)];
    let scenario = scenario("", &behind, &robot, [&[-2.0], &[2.0]]);
    let judge = |path: &[&[f64]], length: f64| judged(&scenario, &result(path, length));
    refused(judge(&[&[-2.0], &[2.0]], TAU - 4.0), &["link 1", "obstacle 0"]);
    clearance(judge(&[&[-2.0], &[0.0], &[2.0]], 4.0));
    refused(judge(&[&[-2.0], &[0.0], &[2.0]], TAU - 4.0), &["length"]);
    refused(judge(&[&[-2.0], &[-2.0 + PI], &[2.0]], 4.0), &["edge 0", "joint 0", "ambiguous"]);
    clearance(judge(&[&[-2.0], &[-2.0 + 3.0], &[2.0]], 4.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn angles_count_in_any_number_of_turns() {
    let near = [disc([0.0, -0.9], 0.05)];
    let scenario = scenario("", &near, &arm(&[0.5, 0.5], 0.01), [&[0.5 + 3.0 * TAU, 0.1], &[1.5, -0.2 - TAU]]);
    let judge = |path: &[&[f64]]| judged(&scenario, &result(path, 1.3));
    let plain = judge(&[&[0.5, 0.1], &[1.5, -0.2]]);
    let turned = judge(&[&[0.5 - TAU, 0.1 + 50.0 * TAU], &[1.5 + 1000.0 * TAU, -0.2]]);
    assert!((clearance(plain) - clearance(turned)).abs() < 1e-10);
}

#[wasm_bindgen_test(unsupported = test)]
fn start_goal_and_length_must_be_those_of_the_query() {
    let robot = arm(&[1.0, 1.0], 0.0);
    let scenario = scenario("", &[], &robot, [&[0.1, 0.2], &[1.1, 0.4]]);
    let judge = |path: &[&[f64]], length: f64| judged(&scenario, &result(path, length));
    assert_eq!(clearance(judge(&[&[0.1, 0.2], &[1.1, 0.4]], 1.2)), f64::INFINITY);
    clearance(judge(&[&[0.1, 0.2], &[1.1, 0.4]], f64::sqrt(1.04)));
    clearance(judge(&[&[0.1, 0.2 + 9e-10], &[1.1, 0.4]], 1.2 - 9e-10));
    refused(judge(&[&[0.1, 0.2 + 2e-9], &[1.1, 0.4]], 1.2), &["starts", "coordinate 1"]);
    refused(judge(&[&[0.1, 0.2], &[1.1 - 2e-9, 0.4]], 1.2), &["ends", "coordinate 0"]);
    refused(judge(&[&[1.1, 0.4], &[0.1, 0.2]], 1.2), &["starts"]);
    refused(judge(&[&[0.1, 0.2]], 0.0), &["ends"]);
    for wrong in [0.0, 1.2 + 1e-8, 1.2 - 1e-8, 1.1, 1e300] {
        refused(judge(&[&[0.1, 0.2], &[1.1, 0.4]], wrong), &["length"]);
    }
    let disc_path: &[&[f64]] = &[&[0.0, 0.0], &[3.0, 4.0 - 1.0]];
    refused(judge_in(ROOM, &[], &robot_disc(0.1), disc_path, 6.0), &["length", "6", "4.24"]);
}

#[wasm_bindgen_test(unsupported = test)]
fn malformed_paths_are_refused_by_name() {
    let scenario = scenario("", &[], &arm(&[1.0, 1.0], 0.0), [&[0.0, 0.0], &[1.0, 0.0]]);
    let judge = |document: &ResultDocument| judged(&scenario, document);
    let good = result(&[&[0.0, 0.0], &[1.0, 0.0]], 1.0);
    clearance(judge(&good));
    let with_path = |path: Vec<Vec<f64>>| ResultDocument { path, ..good.clone() };
    refused(judge(&with_path(vec![])), &["empty"]);
    refused(judge(&with_path(vec![vec![0.0, 0.0], vec![1.0]])), &["waypoint 1 has 1 numbers", "has 2"]);
    refused(judge(&with_path(vec![vec![0.0; 3], vec![1.0, 0.0]])), &["waypoint 0 has 3 numbers"]);
    for bad in [f64::NAN, f64::INFINITY] {
        refused(judge(&with_path(vec![vec![0.0, 0.0], vec![bad, 0.0], vec![1.0, 0.0]])), &["waypoint 1 contains"]);
        refused(judge(&ResultDocument { length: bad, ..good.clone() }), &["length"]);
    }
    for status in ["running", "exhausted"] {
        let text = good.to_json().replace("\"solved\"", &format!("{status:?}"));
        refused(judge(&ResultDocument::parse(&text).expect("a result")), &[status]);
    }
    for (other, code, pointer) in [
        (ResultDocument { scenario: "t".into(), ..good.clone() }, "invalid-result", "/scenario"),
        (ResultDocument { query: "r".into(), ..good }, "unknown-query", "/query"),
    ] {
        refuses(verify(&scenario, &other), code, pointer);
    }
}

/// A result says nothing that no result can say, of its robot or of a run that is solved.
#[wasm_bindgen_test(unsupported = test)]
fn every_claim_of_a_result_is_compared() {
    let path: &[&[f64]] = &[&[0.0, 0.0], &[1.0, 0.0]];
    let scenario = scenario(ROOM, &[], &robot_disc(0.1), [path[0], path[1]]);
    let good = result(path, 1.0);
    clearance(judged(&scenario, &good));
    let refused_with = |change: &dyn Fn(&mut ResultDocument), word: &str| {
        let mut changed = good.clone();
        change(&mut changed);
        refused(judged(&scenario, &changed), &[word]);
    };
    refused_with(&|r| r.motions = Some(Vec::new()), "motions");
    refused_with(&|r| r.integration = Some("euler".into()), "integration");
    refused_with(&|r| r.chord_length = Some(1.0), "chord_length");
    refused_with(&|r| r.blended_length = Some(0.9), "blended length");
    refused_with(&|r| r.edge_check = Some("proven".into()), "edge check");
    refused_with(&|r| r.coverage = Some(1.5), "coverage");
    for length in [f64::NAN, f64::INFINITY, -1.0] {
        refused_with(&|r| r.length = length, "length");
        refused_with(&|r| r.blended_length = Some(length), "blended_length");
    }
    let approximate = planarium::path::Approximate { path: vec![vec![0.0; 2]], motions: None, goal_distance: 1.0 };
    refused_with(&|r| r.approximate = Some(approximate.clone()), "approximate");
    for word in ["sampled", "none", "joint-lines", "rollouts"] {
        clearance(judged(&scenario, &ResultDocument { edge_check: Some(word.into()), ..good.clone() }));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn concave_obstacles_keep_their_pockets() {
    // A cup, open at the top, from (-1, -1) to (1, 1), with walls of a fifth.
    let cup = [-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, 0.8, 1.0, 0.8, -0.8, -0.8, -0.8, -0.8, 1.0, -1.0, 1.0];
    let cup = [polygon(cup.as_chunks().0)];
    clearance(judge_disc(&cup, 0.3, &[&[0.0, 3.0], &[0.0, 0.0], &[0.4, 0.0]]));
    refused(judge_disc(&cup, 0.0, &[&[0.0, 0.0], &[2.0, 0.0]]), &["edge 0", "obstacle 0"]);
    refused(judge_disc(&cup, 0.3, &[&[0.0, 0.0], &[0.6, 0.0]]), &["edge 0", "obstacle 0"]);
    refused(judge_disc(&cup, 0.0, &[&[0.9, 0.0], &[0.9, 0.1]]), &["both its ends"]);

    // An arm with its base in the cup, its tip over the rim.
    let robot = arm(&[1.5, 0.5], 0.05);
    clearance(judge_arm(&cup, &robot, &[&[1.2, 0.0], &[1.9, -1.0]]));
    refused(judge_arm(&cup, &robot, &[&[1.2, 0.0], &[0.9, 0.0], &[1.2, 0.0]]), &["edge 0", "link 1", "obstacle 0"]);
    refused(judge_arm(&cup, &robot, &[&[1.2, -2.5], &[1.2, 0.0]]), &["edge 0", "link 2", "obstacle 0"]);
    // A link wholly inside of an obstacle crosses no edge of it.
    let block = [rectangle([0.9, -3.0], [6.0, 3.0])];
    refused(judge_arm(&block, &arm(&[1.0, 1.0], 0.0), &[&[0.0, 0.0], &[0.01, 0.0]]), &["obstacle 0"]);
    refused(judge_arm(&[disc([2.0, 0.0], 0.9)], &arm(&[1.0, 0.5], 0.0), &[&[0.0, 0.0]]), &["link 2", "obstacle 0"]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_reported_clearance_is_the_distance() {
    let walls = [rectangle([2.5, -1.0], [3.0, 1.0]), disc([0.0, 3.0], 0.4)];
    let seen = clearance(judge_disc(&walls, 0.25, &[&[0.0, 0.0], &[2.0, 0.0], &[0.0, 0.0]]));
    assert!((seen - 0.25).abs() < 1e-12, "{seen}");
    let seen = clearance(judge_arm(&walls, &arm(&[1.0, 1.0], 0.125), &[&[0.0, 0.0], &[PI / 2.0, 0.0]]));
    assert!((seen - 0.375).abs() < 1e-5, "{seen}");
    let seen = clearance(judge_arm(&walls, &arm(&[1.0, 1.0], 0.125), &[&[PI / 2.0, 0.0]]));
    assert!((seen - 0.475).abs() < 1e-12, "{seen}");
}

#[wasm_bindgen_test(unsupported = test)]
fn large_and_far_worlds_are_judged_alike() {
    // The same scene, moved far away and made large: slack grows with the coordinates, verdicts stay.
    for (shift, scale) in [(0.0, 1.0), (1e5, 1.0), (0.0, 1e5), (0.0, 1e-3)] {
        let at = |x: f64, y: f64| [shift + x * scale, shift + y * scale];
        let robot = format!(r#"{{"type": "arm", "base": {:?}, "links": [{scale:?}]}}"#, at(0.0, 0.0));
        let path: &[&[f64]] = &[&[-1.0], &[1.0]];
        let wall = |x: f64| [rectangle(at(x, -0.1), at(2.0, 0.1))];
        refused(judge_arm(&wall(0.999), &robot, path), &["link 1", "obstacle 0"]);
        clearance(judge_arm(&wall(1.001), &robot, path));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn results_are_written_and_read_back_to_the_bit() {
    let mut document = result(&[&[0.1, -2.2250738585072014e-308], &[1.0 / 3.0, 5e-324]], 0.1 + 0.2);
    document.stats.iterations = (1 << 53) - 1;
    document.stats.build_seconds = 1e-9;
    document.seed = (1 << 53) - 1;
    let text = document.to_json();
    let again = ResultDocument::parse(&text).expect("what is written is read");
    assert_eq!(again, document);
    assert_eq!(again.to_json(), text);
    let bits = |d: &ResultDocument| d.path.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&again), bits(&document));
    let order = ["scenario", "query", "planner", "seed", "status", "path", "length", "stats", "fingerprint"];
    let places: Vec<_> = order.iter().map(|name| text.find(&format!("\"{name}\":")).expect("every field")).collect();
    assert!(places.is_sorted(), "fields in the order of the contract: {text}");
    assert!(text.ends_with(r#""fingerprint":"0123456789abcdef"}"#), "{text}");
}

#[wasm_bindgen_test(unsupported = test)]
fn malformed_results_are_refused_with_a_pointer() {
    let good = result(&[&[0.0, 0.0], &[1.0, 0.0]], 1.0).to_json();
    let cases = [
        ("\"seed\":1", "\"seed\":-1", "out-of-range", "/seed"),
        ("\"seed\":1", "\"seed\":1.5", "out-of-range", "/seed"),
        ("\"seed\":1", "\"seed\":9007199254740992", "out-of-range", "/seed"),
        ("\"seed\":1,", "", "missing-field", "/seed"),
        ("\"seed\":1,", "\"seed\":1,\"seed\":2,", "duplicate-field", "/seed"),
        ("\"seed\":1", "\"seed\":1,\"a/b~\":0", "unknown-field", "/a~1b~0"),
        ("\"solved\"", "\"done\"", "invalid-result", "/status"),
        ("[1,0]", "[1,\"0\"]", "wrong-type", "/path/1/1"),
        ("[1,0]", "[1,null]", "wrong-type", "/path/1/1"),
        ("[1,0]", "7", "wrong-type", "/path/1"),
        ("[1,0]", "[1,1e999]", "invalid-json", "/path/1/1"),
        ("\"length\":1,", "\"length\":-1,", "out-of-range", "/length"),
        ("\"visited\":0", "\"visited\":-3", "out-of-range", "/stats/visited"),
        ("\"visited\":0", "\"visits\":0", "unknown-field", "/stats/visits"),
        ("\"build_seconds\":0", "\"build_seconds\":-1", "out-of-range", "/stats/build_seconds"),
        ("0123456789abcdef", "0123456789ABCDEF", "invalid-result", "/fingerprint"),
        ("0123456789abcdef", "+123456789abcdef", "invalid-result", "/fingerprint"),
        ("0123456789abcdef", "123", "invalid-result", "/fingerprint"),
        ("{\"scenario\"", "[\"scenario\"", "invalid-json", ""),
        ("cdef\"}", "cdef\"}}", "invalid-json", ""),
        ("cdef\"}", "cdef\"", "invalid-json", ""),
    ];
    for (from, to, code, pointer) in cases {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from} occurs");
        let message = refuses(ResultDocument::parse(&text), code, pointer);
        assert!(message.len() > 20, "{message}");
    }
}
