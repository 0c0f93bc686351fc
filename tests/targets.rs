//! Queries with a target of the end effector: a path may end at any configuration that reaches it, for every planner.

use crate::common::documents::{self, arm, disc, judged};
use crate::common::requests::{resume, start};
use crate::common::{arm_and_wall, arm_of, assert_valid, begin_with, finish, options, parse, seeds};
use planarium::geometry::Point;
use planarium::run::inspect::Inspector;
use planarium::run::{Run, Status};
use planarium::scenario::Scenario;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// Planners with settings that solve small worlds.
const PLANNERS: &[(&str, &str)] = &[
    ("rrt-connect", ""),
    ("rrt", "goal_bias=0.1"),
    ("rrt", "goal_every=4 extend=until-obstacle"),
    ("prm", "samples=300 k=10"),
    ("prm", "samples=300 k=10 search=bidirectional"),
    ("prm", "samples=300 k=10 search=breadth-first insertion=one-by-one"),
    ("prm-star", "samples=300"),
    ("visibility-prm", ""),
];

/// The world whose first query has this target instead of its goal or target.
fn reaching(world: &Scenario, target: &str) -> Scenario {
    let mut document = json!(world);
    document["queries"][0].as_object_mut().expect("a query").remove("goal");
    document["queries"][0]["target"] = serde_json::from_str(target).expect("a target");
    parse(&document.to_string())
}

/// The world whose target is the tip at the goal of its first query, and that tip.
pub fn reaching_tip(plain: &Scenario) -> (Scenario, Point) {
    let tip = Inspector::new(plain).end_effector(plain.queries()[0].configuration().unwrap()).unwrap();
    (reaching(plain, &format!(r#"{{"point": [{:?}, {:?}]}}"#, tip.x, tip.y)), tip)
}

/// Checks that a run has solved the world, and that its path ends with the tip there.
#[track_caller]
fn assert_ends_at(world: &Scenario, run: &dyn Run, tip: Point) {
    assert_valid(world, run);
    let path = run.path();
    let end = Inspector::new(world).end_effector(&path[path.len() - 1]).unwrap();
    assert!((end.x - tip.x).abs() <= 2e-9 && (end.y - tip.y).abs() <= 2e-9, "{end} is not {tip}");
}

/// The goals of a run to a target: the vertices after the start before its first iteration, which no edge reaches yet.
fn goals(plain: &Scenario, target: [f64; 2]) -> (Scenario, Vec<Vec<f64>>) {
    let world = reaching(plain, &format!(r#"{{"point": {target:?}}}"#));
    let run = begin_with(&world, "rrt", 1, "");
    let inspector = Inspector::new(&world);
    let rows = run.vertex_rows(0);
    let goals: Vec<Vec<f64>> = rows.chunks(run.dimension()).skip(1).map(<[f64]>::to_vec).collect();
    for goal in &goals {
        let tip = inspector.end_effector(goal).unwrap();
        assert!((tip.x - target[0]).abs() <= 1e-9 && (tip.y - target[1]).abs() <= 1e-9, "{goal:?}");
        assert!(inspector.check(goal).unwrap().is_empty(), "a goal is free");
    }
    (world, goals)
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_ends_where_the_end_effector_is_at_the_target() {
    for (links, is_limited) in [(2, false), (3, false), (4, true), (6, false)] {
        let (world, tip) = reaching_tip(&arm_of(links, is_limited, 0.02));
        for &(planner, settings) in PLANNERS {
            for seed in 0..seeds(4) {
                let run = finish(begin_with(&world, planner, seed, settings));
                if run.status() == Status::Solved {
                    assert_ends_at(&world, &*run, tip);
                } else {
                    let may_fail = planner == "visibility-prm" || links > 4;
                    assert!(may_fail, "{planner} {settings}, {links} links, seed {seed}");
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_orientation_is_kept() {
    let plain = arm_of(3, false, 0.02);
    let tip = Inspector::new(&plain).end_effector(plain.queries()[0].configuration().unwrap()).unwrap();
    let wanted: f64 = plain.queries()[0].configuration().unwrap().iter().sum();
    let target = format!(r#"{{"point": [{:?}, {:?}], "orientation": {wanted:?}}}"#, tip.x, tip.y);
    let world = reaching(&plain, &target);
    for planner in ["rrt-connect", "prm"] {
        let run = finish(begin_with(&world, planner, 1, ""));
        assert_eq!(run.status(), Status::Solved, "{planner}");
        let path = run.path();
        let angle: f64 = path[path.len() - 1].iter().sum();
        let turns = (angle - wanted) / std::f64::consts::TAU;
        assert!((turns - libm::rint(turns)).abs() < 1e-9, "{planner}: {angle} is not {wanted}");
        assert_ends_at(&world, &*run, tip);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_free_elbow_is_found() {
    // The tip is reached with the elbow on either side; a disc blocks the side of the given goal.
    let query = r#""start": [-1.5, 0], "goal": [0.3, -1]"#;
    let plain = documents::scenario("", &disc([1.0, 0.73], 0.1), &arm(&[1.0, 1.0], 0.0), query);
    // One elbow is in collision; both are free.
    for (target, count) in [([1.5, 0.6], 1), ([-0.6, -1.5], 2)] {
        let (world, goals) = goals(&plain, target);
        assert_eq!(goals.len(), count);
        for planner in ["rrt-connect", "rrt", "prm", "prm-star"] {
            let run = finish(begin_with(&world, planner, 3, ""));
            assert_eq!(run.status(), Status::Solved, "{planner}");
            assert_valid(&world, &*run);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_redundant_arm_has_several_goals_and_all_are_roots() {
    let (_, found) = goals(&arm_of(4, false, 0.0), [-0.8, 0.3]);
    assert!(found.len() >= 3, "{} goals", found.len());
    for a in 0..found.len() {
        for b in a + 1..found.len() {
            let apart = found[a].iter().zip(&found[b]).map(|(a, b)| planarium::space::angular_distance(*a, *b));
            assert!(apart.fold(0.0, f64::max) > 0.1, "goals {a} and {b} are one");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_unreachable_target_is_refused_with_the_nearest_point() {
    // Links of 1 and 0.8; the last target lies within the wall.
    for (target, code, words) in [
        (r#"{"point": [3, 0]}"#, "target-unreachable", ["1.8", "1.2"]),
        (r#"{"point": [0, 0.1]}"#, "target-unreachable", ["0.2", ""]),
        (r#"{"point": [1.2, 0]}"#, "goal-in-collision", ["obstacle 0", ""]),
    ] {
        let error = start(reaching(&arm_and_wall(0.1), target), &options("prm", 1, "")).err().expect(target);
        assert_eq!((error.code().as_str(), error.pointer()), (code, "/queries/0/target"));
        assert!(words.iter().all(|word| error.message().contains(word)), "{error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_saved_roadmap_is_queried_for_a_target() {
    let plain = arm_of(3, false, 0.02);
    let (world, tip) = reaching_tip(&plain);
    let settings = "samples=300 k=10";
    for built in [&plain, &world] {
        let run = finish(begin_with(built, "prm", 2, settings));
        let saved = run.roadmap().expect("a roadmap");
        let again = finish(resume(&world, &options("prm", 2, ""), &saved).unwrap_or_else(|error| panic!("{error}")));
        assert_eq!(again.status(), Status::Solved);
        assert_ends_at(&world, &*again, tip);
    }
}

/// Whether the path of a world's solved run is accepted for another target.
fn is_accepted_for(world: &Scenario, target: &str) -> bool {
    let run = finish(begin_with(world, "rrt-connect", 1, ""));
    assert_valid(world, &*run);
    judged(&reaching(world, target), &run.result()).is_ok()
}

#[wasm_bindgen_test(unsupported = test)]
fn the_end_of_a_path_is_judged_by_the_size_of_the_arm() {
    let arm = |base: f64, link: f64, target: &str| {
        let robot = documents::with(&arm(&[link; 3], 0.0), "[0, 0]", &format!("[{base:?}, 0]"));
        documents::scenario("", "", &robot, &format!(r#""start": [0.1, 0.1, 0.1], "target": {target}"#))
    };
    // An arm of a third of a micrometre.
    let small = arm(0.0, 1e-7, r#"{"point": [0.0, 2e-7]}"#);
    assert!(!is_accepted_for(&small, r#"{"point": [0.0, 2.01e-7]}"#), "a nanometre is much for it");
    let error = start(arm(0.0, 1e-7, r#"{"point": [0.0, 3.005e-7]}"#), &options("rrt-connect", 1, ""));
    assert_eq!(error.err().map(|error| error.code().as_str()), Some("target-unreachable"));
    // Far from the origin a millionth of a metre is rounding, a ten thousandth is not.
    let far = arm(1e6 - 8.0, 1.0, r#"{"point": [999994, 0.5]}"#);
    assert!(!is_accepted_for(&far, r#"{"point": [999994, 0.5001]}"#));
    // Whole turns of an orientation are nothing, a ten thousandth of a radian on top of many is something.
    let turned = |more: f64| format!(r#"{{"point": [1.5, 0.5], "orientation": {:?}}}"#, 0.25 + more);
    let wound = arm(0.0, 1.0, &turned(150_000.0 * std::f64::consts::TAU));
    assert!(is_accepted_for(&wound, &turned(-7.0 * std::f64::consts::TAU)));
    assert!(!is_accepted_for(&wound, &turned(150_000.0 * std::f64::consts::TAU + 1e-4)));
}

#[wasm_bindgen_test(unsupported = test)]
fn joints_that_can_hardly_move_keep_no_target_out_of_reach() {
    // The third joint has a range of two billionths of a radian, which random starts once failed to solve.
    let limits = [[-1.0471975511965976, 0.5235987755982988], [0.5, 1.0], [-1e-9, 1e-9], [0.0, 9.42477796076938]];
    let robot = documents::limited_arm(&[1.0, 0.5, 1.0, 2.0], 0.0, &limits);
    let query = r#""start": [0, 0.75, 0, 1], "goal": [0.5235987755982988, 1, 1e-9, 7.592182246175334]"#;
    let (world, _) = reaching_tip(&documents::scenario("", "", &robot, query));
    for seed in 0..seeds(10) {
        let run = finish(begin_with(&world, "rrt-connect", seed, ""));
        assert_valid(&world, &*run);
    }
}
