//! Queries with a target of the end effector: every planner may end at any configuration that reaches it.

use crate::common::{SAMPLERS, arm_and_wall, arm_of, begin_with, finish, options, parse, seeds};
use planarium::geometry::Point;
use planarium::path::{Verdict, verify};
use planarium::run::inspect::Inspector;
use planarium::run::{Run, Status, resume, start};
use planarium::scenario::Scenario;
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

/// The world with this target instead of the goal or target of its first query.
fn reaching(world: &Scenario, target: &str) -> Scenario {
    let mut document: serde_json::Value = serde_json::from_str(&world.to_json_string()).expect("a document");
    let query = document["queries"][0].as_object_mut().expect("a query");
    query.remove("goal");
    query.insert("target".to_owned(), serde_json::from_str(target).expect("a target"));
    parse(&document.to_string())
}

/// The world with a target where its goal takes the tip, which can be reached.
fn reaching_its_goal(world: &Scenario) -> (Scenario, Point) {
    let tip = Inspector::new(world).end_effector(world.queries()[0].configuration().unwrap()).unwrap();
    (reaching(world, &format!(r#"{{"point": [{:?}, {:?}]}}"#, tip.x, tip.y)), tip)
}

/// Where the end effector is at the end of a path, and how its last link is turned.
fn end(world: &Scenario, path: &[Vec<f64>]) -> ([f64; 2], f64) {
    let last = &path[path.len() - 1];
    let tip = Inspector::new(world).end_effector(last).unwrap();
    ([tip.x, tip.y], last.iter().sum())
}

fn is_valid(world: &Scenario, run: &dyn Run) -> bool {
    matches!(verify(world, &run.result()), Ok(Verdict::Valid { .. }))
}

/// The goals of a run: they are the vertices right after the start, without edges at first.
fn goals(world: &Scenario, target: [f64; 2]) -> Vec<Vec<f64>> {
    let run = begin_with(world, "rrt", 1, "");
    let inspector = Inspector::new(world);
    let rows = run.vertices_since(0);
    let goals: Vec<Vec<f64>> = rows.chunks(run.dimension()).skip(1).map(<[f64]>::to_vec).collect();
    for goal in &goals {
        let tip = inspector.end_effector(goal).unwrap();
        assert!((tip.x - target[0]).abs() <= 1e-9 && (tip.y - target[1]).abs() <= 1e-9, "{goal:?}");
        assert!(inspector.check(goal).unwrap().is_empty(), "a goal is free");
    }
    goals
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_ends_where_the_end_effector_is_at_the_target() {
    for (links, is_limited) in [(2, false), (3, false), (4, true), (6, false)] {
        let plain = arm_of(links, is_limited, 0.02);
        let (world, tip) = reaching_its_goal(&plain);
        for &(planner, settings) in PLANNERS {
            for seed in 0..seeds(4) {
                let run = finish(begin_with(&world, planner, seed, settings));
                let what = format!("{planner} {settings}, {links} links, seed {seed}");
                if run.status() != Status::Solved {
                    assert!(planner == "visibility-prm" || links > 4, "{what}");
                    continue;
                }
                let ([x, y], _) = end(&world, &run.path());
                assert!((x - tip.x).abs() <= 2e-9 && (y - tip.y).abs() <= 2e-9, "{what}: ({x}, {y})");
                assert!(is_valid(&world, run.as_ref()), "{what}: {:?}", verify(&world, &run.result()));
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
        let (_, angle) = end(&world, &run.path());
        let turns = (angle - wanted) / std::f64::consts::TAU;
        assert!((turns - libm::rint(turns)).abs() < 1e-9, "{planner}: {angle} is not {wanted}");
        assert!(is_valid(&world, run.as_ref()));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_way_that_is_free_is_found() {
    // Both elbows reach the tip; a disc lies in the way of the one that the given goal has.
    let plain = parse(
        r#"{ "format": "planarium-scenario-1", "name": "elbows",
            "world": { "obstacles": [ { "type": "disc", "center": [1, 0.73], "radius": 0.1 } ] },
            "robot": { "type": "arm", "base": [0, 0], "links": [1, 1] },
            "queries": [ { "name": "q", "start": [-1.5, 0], "goal": [0.3, -1] } ] }"#,
    );
    let both = reaching(&plain, r#"{"point": [1.5, 0.6]}"#);
    assert_eq!(goals(&both, [1.5, 0.6]).len(), 1, "one elbow is in collision");
    let far = reaching(&plain, r#"{"point": [-0.6, -1.5]}"#);
    assert_eq!(goals(&far, [-0.6, -1.5]).len(), 2, "both elbows are free");
    for planner in ["rrt-connect", "rrt", "prm", "prm-star"] {
        for world in [&both, &far] {
            let run = finish(begin_with(world, planner, 3, ""));
            assert_eq!(run.status(), Status::Solved, "{planner}");
            assert!(is_valid(world, run.as_ref()));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_spare_joint_has_more_ways_and_all_are_roots() {
    let world = reaching(&arm_of(4, false, 0.0), r#"{"point": [-0.8, 0.3]}"#);
    let found = goals(&world, [-0.8, 0.3]);
    assert!(found.len() >= 3, "{} goals", found.len());
    for a in 0..found.len() {
        for b in a + 1..found.len() {
            let apart = found[a].iter().zip(&found[b]).map(|(a, b)| planarium::space::angular_distance(*a, *b));
            assert!(apart.fold(0.0, f64::max) > 0.1, "goals {a} and {b} are one");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn slices_and_samplers_make_no_difference() {
    let plain = arm_and_wall(0.1);
    let (world, _) = reaching_its_goal(&plain);
    for &(planner, settings) in PLANNERS {
        for &sampler in SAMPLERS {
            let settings = format!("{settings} sampler={sampler} max_iterations=4000");
            let whole = finish(begin_with(&world, planner, 5, &settings));
            let mut run = begin_with(&world, planner, 5, &settings);
            while run.step(7) == Status::Running {}
            assert_eq!((run.fingerprint(), run.path()), (whole.fingerprint(), whole.path()), "{planner} {settings}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_cannot_be_reached_is_said_with_the_nearest_point() {
    let plain = arm_and_wall(0.1);
    let refusal = |target: &str| match start(&reaching(&plain, target), &options("prm", 1, "")) {
        Err(error) => (error.code().as_str(), error.pointer().to_owned(), error.to_string()),
        Ok(_) => panic!("{target} was accepted"),
    };
    let at = "/queries/0/target".to_owned();
    // Links of 1 and 0.8.
    let (code, pointer, sentence) = refusal(r#"{"point": [3, 0]}"#);
    assert_eq!((code, &pointer), ("target-unreachable", &at));
    assert!(sentence.contains("1.8") && sentence.contains("1.2"), "{sentence}");
    let (code, pointer, sentence) = refusal(r#"{"point": [0, 0.1]}"#);
    assert_eq!((code, &pointer), ("target-unreachable", &at));
    assert!(sentence.contains("0.2"), "{sentence}");
    // Within the wall.
    let (code, pointer, sentence) = refusal(r#"{"point": [1.2, 0]}"#);
    assert_eq!((code, &pointer), ("goal-in-collision", &at));
    assert!(sentence.contains("obstacle 0"), "{sentence}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_kept_roadmap_is_asked_for_a_target() {
    let plain = arm_of(3, false, 0.02);
    let (world, tip) = reaching_its_goal(&plain);
    let settings = "samples=300 k=10";
    for built in [&plain, &world] {
        let run = finish(begin_with(built, "prm", 2, settings));
        let kept = run.roadmap().expect("a roadmap");
        let again = finish(resume(&world, &options("prm", 2, ""), &kept).unwrap_or_else(|error| panic!("{error}")));
        assert_eq!(again.status(), Status::Solved);
        let ([x, y], _) = end(&world, &again.path());
        assert!((x - tip.x).abs() <= 2e-9 && (y - tip.y).abs() <= 2e-9);
        assert!(is_valid(&world, again.as_ref()));
    }
}

/// Whether the path of a world's solved run is accepted where its target is another one.
fn is_accepted_for(world: &Scenario, target: &str) -> bool {
    let run = finish(begin_with(world, "rrt-connect", 1, ""));
    assert!(is_valid(world, run.as_ref()), "{:?}", verify(world, &run.result()));
    is_valid(&reaching(world, target), run.as_ref())
}

#[wasm_bindgen_test(unsupported = test)]
fn the_end_of_a_path_is_judged_by_the_size_of_the_arm() {
    let arm = |base: f64, links: &str, target: &str| {
        parse(&format!(
            r#"{{ "format": "planarium-scenario-1", "name": "small", "world": {{ "obstacles": [] }},
                "robot": {{ "type": "arm", "base": [{base:?}, 0], "links": {links} }},
                "queries": [ {{ "name": "q", "start": [0.1, 0.1, 0.1], "target": {target} }} ] }}"#
        ))
    };
    // An arm of a third of a micrometre.
    let links = "[1e-7, 1e-7, 1e-7]";
    let small = arm(0.0, links, r#"{"point": [0.0, 2e-7]}"#);
    assert!(!is_accepted_for(&small, r#"{"point": [0.0, 2.01e-7]}"#), "a nanometre is much for it");
    let error = start(&arm(0.0, links, r#"{"point": [0.0, 3.005e-7]}"#), &options("rrt-connect", 1, ""));
    assert_eq!(error.err().map(|error| error.code().as_str()), Some("target-unreachable"));
    // Far from the origin a millionth of a metre is rounding, a ten thousandth is not.
    let far = arm(1e6 - 8.0, "[1, 1, 1]", r#"{"point": [999994, 0.5]}"#);
    assert!(!is_accepted_for(&far, r#"{"point": [999994, 0.5001]}"#));
    // Whole turns of an orientation are nothing, a ten thousandth of a radian on top of many is something.
    let turned = |more: f64| format!(r#"{{"point": [1.5, 0.5], "orientation": {:?}}}"#, 0.25 + more);
    let wound = arm(0.0, "[1, 1, 1]", &turned(150_000.0 * std::f64::consts::TAU));
    assert!(is_accepted_for(&wound, &turned(-7.0 * std::f64::consts::TAU)));
    assert!(!is_accepted_for(&wound, &turned(150_000.0 * std::f64::consts::TAU + 1e-4)));
}

#[wasm_bindgen_test(unsupported = test)]
fn joints_that_can_hardly_move_keep_no_target_out_of_reach() {
    // The third joint has a range of two billionths of a radian: random starts led nowhere.
    let world = parse(
        r#"{ "format": "planarium-scenario-1", "name": "stiff", "world": { "obstacles": [] },
            "robot": { "type": "arm", "base": [0, 0], "links": [1, 0.5, 1, 2],
                "joint_limits": [[-1.0471975511965976, 0.5235987755982988], [0.5, 1], [-1e-9, 1e-9], [0, 9.42477796076938]] },
            "queries": [ { "name": "q", "start": [0, 0.75, 0, 1], "goal": [0.5235987755982988, 1, 1e-9, 7.592182246175334] } ] }"#,
    );
    let (world, _) = reaching_its_goal(&world);
    for seed in 0..seeds(10) {
        let run = finish(begin_with(&world, "rrt-connect", seed, ""));
        assert!(is_valid(&world, run.as_ref()), "seed {seed}");
    }
}
