//! What a scenario document may contain, what is refused, with which code and pointer, and how it is written again.

use crate::common::documents::{ARM, BODY, CAR, DISC, pointers, reaching, refusal, refuses, with};
use crate::common::parse;
#[cfg(all(feature = "schema", not(target_arch = "wasm32")))]
use crate::schema::check as check_schema;
use planarium::geometry::{Aabb, Point};
use planarium::robot::{DiscRobot, Target, Weights};
use planarium::scenario::{
    FORMAT, Goal, GoalTolerance, LARGEST, MAX_OBSTACLES, MAX_VERTICES, Obstacle, Query, Robot, Scenario, World, polygon,
};
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

#[cfg(not(all(feature = "schema", not(target_arch = "wasm32"))))]
fn check_schema(_: &Value, _: bool) {}

/// Replacement for a piece of a document; the code, the pointer, and a part of the sentence that must come of it.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str);

/// A tolerance of a robot that has none.
const TOLERANCE: &str = r#""goal_tolerance": {}, "goal""#;

/// Checks that the parser refuses every change, and the schema too if it can: it judges each value for itself.
fn check_refusals(document: &str, in_schema: bool, cases: &[Case]) {
    Scenario::parse(document).expect("the document without a change is right");
    for &(piece, replacement, code, pointer, words) in cases {
        let text = with(document, piece, replacement);
        let message = refusal(&text, code, pointer);
        assert!(message.contains(words), "{piece} -> {replacement}: {words:?} is not in {message}");
        if code != "invalid-json" {
            check_schema(&serde_json::from_str(&text).unwrap(), !in_schema);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_document_becomes_a_scenario() {
    let robots = [ARM, DISC, BODY, CAR].map(|document| Scenario::parse(document).unwrap().robot().clone());
    let [Robot::Arm(arm), Robot::Disc(disc), Robot::RigidBody(body), Robot::Car(car)] = &robots else {
        panic!("an arm, a disc, a body and a car: {robots:?}")
    };
    assert_eq!((arm.links(), arm.radius(), arm.reach()), (&[1.0, 0.5][..], 0.05, 1.5));
    assert_eq!((arm.joint_limits(), disc.radius()), (Some(&[[-1.0, 1.0], [-2.0, 2.0]][..]), 0.1));
    assert_eq!((body.shape.vertices().len(), body.shape.is_convex()), (5, false));
    assert_eq!(body.weights, Weights { translation: 0.7, rotation: 0.3 });
    assert_eq!((car.wheelbase(), car.integration_step()), (0.2, 0.02));
    assert_eq!((car.speed(), car.steering()), ([-0.5, 0.5], [-0.75, 0.75]));
    assert_eq!(robots.each_ref().map(Robot::kind), ["arm", "disc", "rigid_body", "car"]);
    assert_eq!(robots.each_ref().map(Robot::dimension), [2, 2, 3, 3]);
    let scenario = Scenario::parse(BODY).unwrap();
    assert_eq!((scenario.name(), scenario.title(), scenario.world().obstacles.len()), ("body", "A body", 1));
    let query = &scenario.queries()[0];
    assert_eq!(query.configuration(), Some(&[1.8, 1.8, 7.0][..]), "angles are stored as they are written");
    assert_eq!(query.goal_tolerance, Some(GoalTolerance { translation: 0.1, rotation: 0.5 }));
}

#[wasm_bindgen_test(unsupported = test)]
fn every_field_is_optional_or_required_and_no_other_is_known() {
    let optional = |robot: &str, name: &str| match name {
        "title" | "metric" | "integration_step" | "goal_tolerance" | "orientation" | "joint_limits" => true,
        "bounds" => robot == "arm",
        _ => false,
    };
    for document in [ARM, DISC, BODY, CAR, &reaching()] {
        let tree: Value = serde_json::from_str(document).unwrap();
        let robot = tree["robot"]["type"].as_str().unwrap();
        for place in pointers(&tree).into_iter().filter(|place| tree.pointer(place).unwrap().is_object()) {
            let mut more = tree.clone();
            more.pointer_mut(&place).unwrap()["a/b~c"] = Value::from(1);
            check_schema(&more, false);
            let message = refusal(&more.to_string(), "unknown-field", &format!("{place}/a~1b~0c"));
            assert!(message.contains("a/b~c"), "{message}");
            for name in tree.pointer(&place).unwrap().as_object().unwrap().keys() {
                let mut less = tree.clone();
                less.pointer_mut(&place).unwrap().as_object_mut().unwrap().remove(name);
                let is_optional = optional(robot, name) || (robot, &*place, &**name) == ("arm", "/robot", "radius");
                // The schema, which has no conditions, lets every robot leave out what an arm may.
                check_schema(&less, is_optional || name == "bounds");
                if is_optional {
                    Scenario::parse(&less.to_string()).expect(name);
                    continue;
                }
                let name = if name == "target" { "goal" } else { name };
                let message = refusal(&less.to_string(), "missing-field", &format!("{place}/{name}"));
                assert!(message.contains(name), "{robot}: {message}");
            }
        }
    }
    let bounds = r#""bounds": {"min": [0, 0], "max": [2, 2]}, "#;
    check_refusals(DISC, false, &[(bounds, "", "missing-field", "/world/bounds", "optional only for an arm")]);
}

#[wasm_bindgen_test(unsupported = test)]
fn fields_that_are_left_out_have_defaults() {
    let bare = with(&with(ARM, r#", "radius": 0.05"#, ""), r#""title": "An arm","#, "");
    let scenario = Scenario::parse(&bare).unwrap();
    let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
    assert_eq!((arm.radius(), scenario.title()), (0.0, "arm"));
    let empty = r#"{"format": "planarium-scenario-1", "name": "n", "world": {"obstacles": []},
        "robot": {"type": "arm", "base": [0, 0], "links": [1]}, "queries": []}"#;
    assert!(Scenario::parse(empty).unwrap().queries().is_empty());
    let region = r#", "goal_tolerance": {"translation": 0.1, "rotation": 0.5}"#;
    let metric = r#",
            "metric": {"translation": 0.5, "rotation": 0.25}"#;
    assert_eq!(Scenario::parse(&with(BODY, region, "")).unwrap().queries()[0].goal_tolerance, None);
    let left_out = with(&with(&with(CAR, metric, ""), r#", "integration_step": 0.02"#, ""), region, "");
    let scenario = Scenario::parse(&left_out).unwrap();
    let Robot::Car(car) = scenario.robot() else { panic!("a car") };
    assert_eq!((car.weights(), car.integration_step()), (Weights::default(), 0.01));
    assert_eq!(scenario.queries()[0].goal_tolerance, None);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_the_contract_does_not_know_is_refused() {
    let cases = [
        ("planarium-scenario-1", "planarium-scenario-2", "unknown-format", "/format", "planarium-scenario-2"),
        (r#""bounds""#, r#""bound""#, "unknown-field", "/world/bound", "bound"),
        (r#""center""#, r#""centre""#, "unknown-field", "/world/obstacles/0/centre", "centre"),
        (r#""start""#, r#""from""#, "unknown-field", "/queries/0/from", "known are name, start, goal, target"),
        (r#""goal""#, TOLERANCE, "unknown-field", "/queries/0/goal_tolerance", "an arm reaches its goal exactly"),
        (r#""type": "disc""#, r#""type": "circle""#, "unknown-type", "/world/obstacles/0/type", "circle"),
        (r#""type": "arm""#, r#""type": "snake""#, "unknown-type", "/robot/type", "snake"),
        (r#""type": "arm""#, r#""type": "rigid_body""#, "unknown-field", "/robot/base", "shape, metric"),
        (r#""type": "arm""#, r#""type": "car""#, "unknown-field", "/robot/base", "wheelbase"),
    ];
    check_refusals(ARM, true, &cases);
    let cases = [
        (r#""radius": 0.1"#, r#""radius": 0.1, "base": [1, 1]"#, "unknown-field", "/robot/base", "base"),
        (r#""goal""#, TOLERANCE, "unknown-field", "/queries/0/goal_tolerance", "a disc reaches its goal exactly"),
    ];
    check_refusals(DISC, true, &cases);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_value_of_another_type_is_refused_and_named() {
    let cases = [
        (r#""planarium-scenario-1""#, "1", "wrong-type", "/format", "the number 1"),
        (r#""name": "arm""#, r#""name": null"#, "wrong-type", "/name", "null"),
        (r#""title": "An arm""#, r#""title": null"#, "wrong-type", "/title", "null"),
        (r#""world": {"#, r#""world": [], "z": {"#, "wrong-type", "/world", "an array of 0"),
        (r#"{"min": [-3, -3], "max": [3, 3]}"#, "null", "wrong-type", "/world/bounds", "null"),
        (r#"{"min": [-3, -3], "max": [3, 3]}"#, "[0, 1]", "wrong-type", "/world/bounds", "an array of 2"),
        (r#""min": [-3, -3]"#, r#""min": -3"#, "wrong-type", "/world/bounds/min", "the number -3"),
        ("[-3, -3]", r#"["-3", -3]"#, "wrong-type", "/world/bounds/min/0", r#"the string "-3""#),
        ("[2, 0]", "[2, true]", "wrong-type", "/world/obstacles/0/center/1", "true"),
        ("[[1, 1], [2, 1]", "[1, [2, 1]", "wrong-type", "/world/obstacles/1/vertices/0", "the number 1"),
        (r#""obstacles": ["#, r#""obstacles": {}, "z": ["#, "wrong-type", "/world/obstacles", "an object"),
        (r#""type": "arm""#, r#""type": {}"#, "wrong-type", "/robot/type", "an object"),
        ("[1, 0.5]", "1.5", "wrong-type", "/robot/links", "the number 1.5"),
        ("[1, 0.5]", "[1, null]", "wrong-type", "/robot/links/1", "null"),
        ("[[-1, 1], [-2, 2]]", "null", "wrong-type", "/robot/joint_limits", "null"),
        ("[[-1, 1], [-2, 2]]", "[-1, 1]", "wrong-type", "/robot/joint_limits/0", "the number -1"),
        (r#""queries": ["#, r#""queries": null, "z": ["#, "wrong-type", "/queries", "null"),
        (r#""first""#, "7", "wrong-type", "/queries/0/name", "the number 7"),
        (r#""start": [-1, 0]"#, r#""start": "home""#, "wrong-type", "/queries/0/start", r#"the string "home""#),
        (r#""goal": [1, 2]"#, r#""goal": [null, 2]"#, "wrong-type", "/queries/0/goal/0", "null"),
    ];
    check_refusals(ARM, true, &cases);
    for (document, words) in [("[]", "an array of 0"), ("3", "the number 3"), (r#""text""#, "the string")] {
        let message = refusal(document, "wrong-type", "");
        assert!(message.contains(words), "{message}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_number_outside_its_range_is_refused() {
    let out = "out-of-range";
    let cases = [
        (r#""name": "arm""#, r#""name": """#, out, "/name", "empty"),
        (r#""first""#, r#""""#, out, "/queries/0/name", "empty"),
        ("[3, 3]", "[3, 1000000.1]", out, "/world/bounds/max/1", "1000000.1"),
        ("[2, 0]", "[-1e7, 0]", out, "/world/obstacles/0/center/0", "-10000000"),
        (r#""radius": 0.25"#, r#""radius": 0"#, out, "/world/obstacles/0/radius", "greater than 0"),
        (r#""radius": 0.25"#, r#""radius": 1e7"#, out, "/world/obstacles/0/radius", "10000000"),
        (r#""radius": 0.25"#, r#""radius": -0.25"#, out, "/world/obstacles/0/radius", "-0.25"),
        ("[1.5, 1.25]", "[1.5, 2e6]", out, "/world/obstacles/1/vertices/3/1", "2000000"),
        (r#""base": [0, 0]"#, r#""base": [0, 1e300]"#, out, "/robot/base/1", "1000000"),
        ("[1, 0.5]", "[]", out, "/robot/links", "1 to 8 links, not 0"),
        ("[1, 0.5]", "[1, 1, 1, 1, 1, 1, 1, 1, 1]", out, "/robot/links", "1 to 8 links, not 9"),
        ("[1, 0.5]", "[1, 0]", out, "/robot/links/1", "greater than 0"),
        ("[1, 0.5]", "[1, -0.5]", out, "/robot/links/1", "-0.5"),
        (r#""radius": 0.05"#, r#""radius": -0.05"#, out, "/robot/radius", "-0.05"),
        ("[-2, 2]", "[-2, 101]", out, "/robot/joint_limits/1/1", "101"),
        ("[-2, 2]", "[-101, 2]", out, "/robot/joint_limits/1/0", "-101"),
    ];
    check_refusals(ARM, true, &cases);
    let cases = [
        (r#""radius": 0.1"#, r#""radius": -1"#, out, "/robot/radius", "-1"),
        ("[1.8, 1.8]", "[1.8, 1e6001]", "invalid-json", "/queries/0/goal/1", "1e6001"),
        ("[1.8, 1.8]", "[1.8, 1e7]", out, "/queries/0/goal/1", "10000000"),
    ];
    check_refusals(DISC, true, &cases);
    let free = with(ARM, r#", "joint_limits": [[-1, 1], [-2, 2]]"#, "");
    check_refusals(&free, true, &[("[-1, 0]", "[-1, 1000001]", out, "/queries/0/start/1", "1000001")]);
    Scenario::parse(&with(&free, "[-1, 0]", "[100, -1e6]")).expect("a circle joint takes any number of turns");
}

#[wasm_bindgen_test(unsupported = test)]
fn lists_of_another_length_are_refused() {
    let wrong = "wrong-dimension";
    let cases = [
        ("[-3, -3]", "[-3]", wrong, "/world/bounds/min", "2 entries, not 1"),
        ("[2, 0]", "[2, 0, 0]", wrong, "/world/obstacles/0/center", "2 entries, not 3"),
        ("[1.5, 1.25]", "[]", wrong, "/world/obstacles/1/vertices/3", "2 entries, not 0"),
        ("[[-1, 1], [-2, 2]]", "[]", wrong, "/robot/joint_limits", "2, not 0"),
        ("[-2, 2]", "[2]", wrong, "/robot/joint_limits/1", "2 entries, not 1"),
        ("[-2, 2]", "[-2, 0, 2]", wrong, "/robot/joint_limits/1", "2 entries, not 3"),
        (r#""start": [-1, 0]"#, r#""start": []"#, wrong, "/queries/0/start", "2 entries, not 0"),
    ];
    check_refusals(ARM, true, &cases);
}

#[wasm_bindgen_test(unsupported = test)]
fn values_that_contradict_each_other_are_refused() {
    let (wrong, out) = ("wrong-dimension", "out-of-range");
    let cases = [
        ("[3, 3]", "[3, -3]", out, "/world/bounds", "in y the bounds run from -3 to -3"),
        ("[3, 3]", "[-4, 3]", out, "/world/bounds", "in x the bounds run from -3 to -4"),
        ("[-2, 2]", "[2, 2]", out, "/robot/joint_limits/1", "less than"),
        ("[-2, 2]", "[3, 2]", out, "/robot/joint_limits/1", "the lower limit 3"),
        ("[[-1, 1], [-2, 2]]", "[[-1, 1]]", wrong, "/robot/joint_limits", "2, not 1"),
        (r#""start": [-1, 0]"#, r#""start": [-1]"#, wrong, "/queries/0/start", "2 entries, not 1"),
        (r#""start": [-1, 0]"#, r#""start": [-1.5, 0]"#, out, "/queries/0/start/0", "joint 0"),
        (r#""goal": [1, 2]"#, r#""goal": [1, 2, 3]"#, wrong, "/queries/0/goal", "2 entries, not 3"),
        // Limited joints do not wrap: 5.3 is -0.98 one turn on, but is not within [-1, 1].
        (r#""goal": [1, 2]"#, r#""goal": [5.3, 2]"#, out, "/queries/0/goal/0", "5.3"),
        (r#""second""#, r#""first""#, "duplicate-name", "/queries/1/name", r#""first""#),
    ];
    check_refusals(ARM, false, &cases);
    check_refusals(BODY, false, &[("[0.2, 0.2, 0]", "[0.2, 0.2]", wrong, "/queries/0/start", "3 entries, not 2")]);
    check_refusals(CAR, false, &[("[-0.5, 0.5]", "[0.5, 0.5]", out, "/robot/speed", "")]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_degenerate_polygon_is_refused() {
    let at = "/world/obstacles/1/vertices";
    let polygon = "[[1, 1], [2, 1], [2, 2], [1.5, 1.25], [1, 2]]";
    let bad = "degenerate-polygon";
    for few in ["[]", "[[1, 1], [2, 1]]"] {
        check_refusals(ARM, true, &[(polygon, few, bad, at, "three distinct")]);
    }
    let cases = [
        (polygon, "[[1, 1], [2, 1], [2, 1], [1, 1]]", bad, at, "three distinct"),
        (polygon, "[[1, 1], [2, 1], [3, 1]]", bad, at, "on one line"),
        (polygon, "[[1, 1], [2, 2], [2, 1], [1, 2]]", bad, at, "from vertex 0 and from vertex 2"),
        (polygon, "[[1, 1], [2, 1], [3, 1], [2, 1], [1, 2]]", bad, at, "touch or cross"),
    ];
    check_refusals(ARM, false, &cases);
}

#[wasm_bindgen_test(unsupported = test)]
fn nothing_may_touch_the_base_of_an_arm() {
    let arm = |base: &str, radius: &str, obstacle: &str, bounds: &str| {
        format!(
            r#"{{"format": "{FORMAT}", "name": "n", "world": {{{bounds} "obstacles": [
            {{"type": "disc", "center": [50, 50], "radius": 1}}, {obstacle}]}},
            "robot": {{"type": "arm", "base": {base}, "links": [1], "radius": {radius}}}, "queries": []}}"#
        )
    };
    let disc = r#"{"type": "disc", "center": [2, 0], "radius": 1}"#;
    let square = r#"{"type": "polygon", "vertices": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}"#;
    let bounds = r#""bounds": {"min": [-3, -3], "max": [60, 60]},"#;
    let at_obstacle = Some("/world/obstacles/1");
    for (base, radius, obstacle, bounds, touched) in [
        ("[2, 0.5]", "0", disc, "", at_obstacle),
        ("[1, 0]", "0", disc, "", at_obstacle),
        ("[0, 0]", "1", disc, "", at_obstacle),
        ("[0.9999999999999, 0]", "0", disc, "", at_obstacle),
        ("[0, 0]", "0", square, "", at_obstacle),
        ("[1, 0.5]", "0", square, "", at_obstacle),
        ("[1.25, 0.5]", "0.25", square, "", at_obstacle),
        ("[1, 1]", "0", square, "", at_obstacle),
        ("[0, 0]", "0.999999", disc, bounds, None),
        ("[1.250001, 0.5]", "0.25", square, bounds, None),
        ("[1, 1.000001]", "0", square, bounds, None),
        // The bounds may be touched, but not crossed.
        ("[-2.75, 5]", "0.25", disc, bounds, None),
        ("[-4, 5]", "0", disc, bounds, Some("/robot/base")),
        ("[-2.75, 5]", "0.2500001", disc, bounds, Some("/robot/base")),
        ("[5, 60.1]", "0", disc, bounds, Some("/robot/base")),
    ] {
        let error = Scenario::parse(&arm(base, radius, obstacle, bounds)).err();
        let found = error.as_ref().map(|error| (error.code().as_str(), error.pointer()));
        assert_eq!(found, touched.map(|pointer| ("base-in-collision", pointer)), "{base} {radius}: {error:?}");
        assert!(touched != at_obstacle || error.is_some_and(|error| error.message().contains("obstacle 1")));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_or_goal_in_collision_is_left_to_the_planner() {
    Scenario::parse(&with(DISC, "[0.2, 0.2]", "[1, 1]")).expect("the start lies in the obstacle");
    Scenario::parse(&with(DISC, "[0.2, 0.2]", "[-5, 1]")).expect("the start lies outside the bounds");
}

#[wasm_bindgen_test(unsupported = test)]
fn more_obstacles_or_vertices_than_the_limits_of_the_contract_are_refused() {
    assert_eq!((MAX_OBSTACLES, MAX_VERTICES, LARGEST), (10_000, 100_000, 1e6));
    let edge = with(DISC, r#"[1, 1], "radius": 0.5"#, r#"[-1e6, 1e6], "radius": 1e6"#);
    assert!(matches!(Scenario::parse(&edge).unwrap().world().obstacles[0], Obstacle::Disc(disc) if disc.radius == 1e6));
    let world = |text: String| with(DISC, r#"{"type": "disc", "center": [1, 1], "radius": 0.5}"#, &text);
    let discs = |n: usize| vec![r#"{"type":"disc","center":[1,1],"radius":0.5}"#; n].join(",");
    assert_eq!(Scenario::parse(&world(discs(MAX_OBSTACLES))).unwrap().world().obstacles.len(), MAX_OBSTACLES);
    let many = world(discs(MAX_OBSTACLES + 1));
    assert!(refusal(&many, "too-large", "/world/obstacles").contains("10001"));
    check_schema(&serde_json::from_str(&many).unwrap(), false);

    // A comb of so many vertices, at most a millionth apart.
    let comb = |n: usize| {
        let corner = |i: usize| format!("[{},{}]", i as f64 * 1e-6, 1 + i % 2);
        let corners: Vec<String> = (0..n - 2).map(corner).chain(["[1,3]".to_owned(), "[0,3]".to_owned()]).collect();
        format!(r#"{{"type":"polygon","vertices":[{}]}}"#, corners.join(","))
    };
    let half = MAX_VERTICES / 2;
    Scenario::parse(&world(format!("{},{}", comb(half), comb(half)))).expect("as many vertices as allowed");
    refusal(&world(format!("{},{}", comb(half), comb(half + 1))), "too-large", "/world/obstacles/1/vertices");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_written_scenario_reads_back_as_the_same() {
    for document in [ARM, DISC, BODY, CAR, &with(ARM, r#""title": "An arm","#, "")] {
        let scenario = Scenario::parse(document).unwrap();
        let text = scenario.to_json_string();
        let tree = serde_json::to_value(&scenario).expect("a scenario has a form in JSON");
        assert_eq!(Scenario::parse(&text).unwrap().to_json_string(), text);
        assert_eq!([Scenario::parse(&text), Scenario::parse(&tree.to_string())], [Ok(scenario.clone()), Ok(scenario)]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_written_form_is_the_contract_in_order_with_defaults_and_without_repeats() {
    let given = r#"{"queries": [{"goal": [0.30000000000000004], "start": [-0.0], "name": "q\u0041/\""}],
        "robot": {"links": [1.0], "base": [0.0, 1e-7], "type": "arm"},
        "world": {"obstacles": [{"vertices": [[2, 2], [2, 3], [3, 2], [2, 2]], "type": "polygon"},
                                {"radius": 0.5, "center": [-5, 1e6], "type": "disc"}]},
        "name": "n", "format": "planarium-scenario-1"}"#;
    let expected = concat!(
        r#"{"format":"planarium-scenario-1","name":"n","world":{"obstacles":["#,
        r#"{"type":"polygon","vertices":[[3,2],[2,3],[2,2]]},{"type":"disc","center":[-5,1000000],"radius":0.5}]},"#,
        r#""robot":{"type":"arm","base":[0,1e-7],"links":[1],"radius":0},"#,
        r#""queries":[{"name":"qA/\"","start":[0],"goal":[0.30000000000000004]}]}"#
    );
    assert_eq!(Scenario::parse(given).unwrap().to_json_string(), expected);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_body_or_a_car_that_is_wrong_is_refused() {
    let (tolerance, step) = ("/queries/0/goal_tolerance/translation", r#""integration_step": 0.02"#);
    let region = r#"{"translation": 0.1, "rotation": 0.5}"#;
    let shape = "/robot/shape/vertices";
    for (document, piece, replacement, code, pointer) in [
        (BODY, r#""type": "polygon""#, r#""type": "disc""#, "unknown-type", "/robot/shape/type"),
        (BODY, "[0.1, -0.05], [0.1, 0.05], [0, 0], [-0.1, 0.05]", "[0, 0]", "degenerate-polygon", shape),
        (BODY, r#""shape": {"#, r#""shape": [], "z": {"#, "wrong-type", "/robot/shape"),
        (BODY, r#""translation": 0.7"#, r#""translation": 0"#, "out-of-range", "/robot/metric/translation"),
        (BODY, r#""rotation": 0.3"#, r#""rotation": -1"#, "out-of-range", "/robot/metric/rotation"),
        (BODY, r#""metric""#, r#""wheelbase": 1, "metric""#, "unknown-field", "/robot/wheelbase"),
        (BODY, r#""translation": 0.1"#, r#""translation": -1"#, "out-of-range", tolerance),
        (BODY, region, "0.1", "wrong-type", "/queries/0/goal_tolerance"),
        (BODY, r#""rotation": 0.5"#, r#""rotation": -1"#, "out-of-range", "/queries/0/goal_tolerance/rotation"),
        (CAR, r#""wheelbase": 0.2"#, r#""wheelbase": 0"#, "out-of-range", "/robot/wheelbase"),
        (CAR, "[-0.5, 0.5]", "[0.5]", "wrong-dimension", "/robot/speed"),
        (CAR, "[-0.5, 0.5]", r#"["1", 0.5]"#, "wrong-type", "/robot/speed/0"),
        (CAR, r#"{"translation": 0.5, "rotation": 0.25}"#, "null", "wrong-type", "/robot/metric"),
        (CAR, "[-0.75, 0.75]", "[-0.75, 1.6]", "out-of-range", "/robot/steering/1"),
        (CAR, "[-0.75, 0.75]", "[-0.75]", "wrong-dimension", "/robot/steering"),
        (CAR, step, r#""integration_step": 0"#, "out-of-range", "/robot/integration_step"),
        (CAR, step, r#""integration_step": 11"#, "out-of-range", "/robot/integration_step"),
    ] {
        check_refusals(document, true, &[(piece, replacement, code, pointer, "")]);
    }
    for corners in ["[0.1, 0.05], [0, -0.05]", "[0.1, 0.05], [0, -0.3], [-0.1, 0.05]"] {
        let piece = "[0.1, 0.05], [0, 0], [-0.1, 0.05]";
        check_refusals(BODY, false, &[(piece, corners, "degenerate-polygon", shape, "")]);
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn the_shared_scenarios_are_read_and_written_again() {
    let Some(shared) = crate::common::documents::shared() else { return };
    let mut seen = 0;
    for (name, text) in shared {
        let parsed = Scenario::parse(&text);
        check_schema(&serde_json::from_str(&text).unwrap(), parsed.is_ok());
        if !text.contains(FORMAT) {
            continue;
        }
        let scenario = parsed.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(scenario.name(), name);
        assert!(!scenario.queries().is_empty());
        assert_eq!(Scenario::parse(&scenario.to_json_string()), Ok(scenario));
        seen += 1;
    }
    assert!(seen >= 9, "there are shared scenarios");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_query_may_have_a_target_of_the_end_effector() {
    let reaching = reaching();
    let scenario = Scenario::parse(&reaching).unwrap();
    let wanted = Target { point: Point::new(1.0, 0.5), orientation: Some(7.0) };
    assert_eq!((&scenario.queries()[0].goal, scenario.queries()[0].configuration()), (&Goal::Target(wanted), None));
    let written = scenario.to_json_string();
    assert!(written.contains(r#""start":[-1,0],"target":{"point":[1,0.5],"orientation":7}}"#), "{written}");
    assert_eq!(Scenario::parse(&written).unwrap(), scenario);
    let (at, turn) = ("/queries/0/target", "/queries/0/target/orientation");
    let cases = [
        (r#""target""#, r#""goal": [0, 0], "target""#, "unknown-field", at, "a goal or a target, not both"),
        (r#""point": [1, 0.5]"#, r#""point": [1]"#, "wrong-dimension", "/queries/0/target/point", "2"),
        (r#""orientation": 7"#, r#""orientation": "up""#, "wrong-type", turn, "number"),
        (r#""orientation": 7"#, r#""orientation": 2e6"#, "out-of-range", turn, "2000000"),
        (r#""orientation""#, r#""turn""#, "unknown-field", "/queries/0/target/turn", "known are point, orientation"),
    ];
    check_refusals(&reaching, true, &cases);
    let why = "a target is for the end effector of an arm";
    let target = r#""target": {"point": [1, 1]}, "start""#;
    for document in [DISC, BODY, CAR] {
        check_refusals(document, true, &[(r#""start""#, target, "unknown-field", at, why)]);
    }
}

/// A scenario of values is the scenario of its document, and obeys the same rules.
#[wasm_bindgen_test(unsupported = test)]
fn scenarios_are_made_of_values() {
    for text in [ARM, DISC, BODY, CAR] {
        let read = parse(text);
        let queries = read.queries().to_vec();
        let made =
            Scenario::new(read.name(), read.world().clone(), read.robot().clone(), queries).expect("it was read");
        let untitled = Scenario::new(made.name(), made.world().clone(), made.robot().clone(), made.queries().to_vec());
        assert_eq!(made.to_json_string(), untitled.expect("the same again").to_json_string());
        assert_eq!((made.world(), made.robot(), made.queries()), (read.world(), read.robot(), read.queries()));
    }
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]].map(Point::from);
    let bounds = Aabb::of(Point::new(0.0, 0.0), Point::new(4.0, 4.0));
    let wall = Obstacle::from(polygon(&corners).expect("a triangle"));
    let disc = DiscRobot::new(0.1).expect("a robot");
    let with = |bounds: Option<Aabb>, obstacles: &[Obstacle], start: [f64; 2]| {
        let world = World::new(bounds, obstacles.to_vec());
        Scenario::new("made", world, disc.clone(), [Query::new("over", start, [3.0, 3.0])]).map(|_| ())
    };
    assert_eq!(with(Some(bounds), std::slice::from_ref(&wall), [2.0, 1.0]), Ok(()));
    refuses(with(None, &[], [2.0, 1.0]), "missing-field", "/world/bounds");
    refuses(
        with(Some(bounds), &[wall.clone(), Obstacle::disc(corners[0], -1.0)], [2.0, 1.0]),
        "out-of-range",
        "/world/obstacles/1/radius",
    );
    refuses(
        with(Some(bounds), &[Obstacle::disc(corners[0], f64::NAN)], [2.0, 1.0]),
        "not-finite",
        "/world/obstacles/0/radius",
    );
    refuses(with(Some(bounds), &[], [2.0, f64::INFINITY]), "not-finite", "/queries/0/start/1");
    refuses(with(Some(bounds), &[], [2.0, 1e7]), "out-of-range", "/queries/0/start/1");
    refuses(polygon(&corners[..2]), "degenerate-polygon", "/vertices");
    let short = Scenario::new("made", World::new(Some(bounds), []), disc.clone(), [Query::new("q", [1.0], [1.0, 1.0])]);
    refuses(short, "wrong-dimension", "/queries/0/start");
}
