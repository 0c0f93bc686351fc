//! What a scenario document may contain, and how it is written again. What is refused is in `refusals.json`.

use crate::common::documents::{
    ARM, BODY, CAR, DISC, disc, pointers, reaching, rectangle, refusal, refuses, scenario, with,
};
use crate::common::parse;
#[cfg(all(feature = "schema", not(target_arch = "wasm32")))]
use crate::schema::check as check_schema;
use planarium::geometry::{Aabb, Point};
use planarium::robot::{DiscRobot, Target, Weights};
use planarium::scenario::{
    Goal, GoalTolerance, LARGEST, MAX_OBSTACLES, MAX_VERTICES, MapFrame, MapPlane, Obstacle, Query, Robot, Scenario,
    World, polygon,
};
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

#[cfg(not(all(feature = "schema", not(target_arch = "wasm32"))))]
fn check_schema(_: &Value, _: bool) {}

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
                check_schema(&less, is_optional || name == "bounds" || place.ends_with("goal_tolerance"));
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

/// What touches the base is refused; what comes near is not, and the bounds may be touched.
#[wasm_bindgen_test(unsupported = test)]
fn an_obstacle_may_be_near_the_base_of_an_arm() {
    let (disc, square) = (disc([2.0, 0.0], 1.0), rectangle([-1.0, -1.0], [1.0, 1.0]));
    for (base, radius, obstacle) in [
        ([0.0, 0.0], 0.999999, &disc),
        ([1.250001, 0.5], 0.25, &square),
        ([1.0, 1.000001], 0.0, &square),
        ([-2.75, 5.0], 0.25, &disc),
    ] {
        let robot = format!(r#"{{"type": "arm", "base": {base:?}, "links": [1], "radius": {radius}}}"#);
        scenario("[-3, -3], [60, 60]", obstacle, &robot, "");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_or_goal_in_collision_is_left_to_the_planner() {
    Scenario::parse(&with(DISC, "[0.2, 0.2]", "[1, 1]")).expect("the start lies in the obstacle");
    Scenario::parse(&with(DISC, "[0.2, 0.2]", "[-5, 1]")).expect("the start lies outside the bounds");
    let free = with(ARM, r#", "joint_limits": [[-1, 1], [-2, 2]]"#, "");
    Scenario::parse(&with(&free, "[-1, 0]", "[100, -1e6]")).expect("a circle joint takes any number of turns");
}

#[wasm_bindgen_test(unsupported = test)]
fn more_obstacles_or_vertices_than_the_limits_of_the_contract_are_refused() {
    assert_eq!((MAX_OBSTACLES, MAX_VERTICES, LARGEST), (100_000, 1_000_000, 1e6));
    let edge = with(DISC, r#"[1, 1], "radius": 0.5"#, r#"[-1e6, 1e6], "radius": 1e6"#);
    assert!(matches!(Scenario::parse(&edge).unwrap().world().obstacles[0], Obstacle::Disc(disc) if disc.radius == 1e6));
    let world = |text: String| with(DISC, r#"{"type": "disc", "center": [1, 1], "radius": 0.5}"#, &text);
    let discs = |n: usize| vec![r#"{"type":"disc","center":[1,1],"radius":0.5}"#; n].join(",");
    assert_eq!(Scenario::parse(&world(discs(MAX_OBSTACLES))).unwrap().world().obstacles.len(), MAX_OBSTACLES);
    let many = world(discs(MAX_OBSTACLES + 1));
    assert!(refusal(&many, "too-large", "/world/obstacles").contains("100001"));
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

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn the_shared_scenarios_are_read_and_written_again() {
    let Some(shared) = crate::common::documents::shared() else { return };
    let mut seen = 0;
    for (name, text) in shared {
        let parsed = Scenario::parse(&text);
        check_schema(&serde_json::from_str(&text).unwrap(), parsed.is_ok());
        if !text.contains(planarium::scenario::FORMAT) {
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

/// The way back to the coordinates of a map stays with a scenario, and is written only if there is one.
#[wasm_bindgen_test(unsupported = test)]
fn a_frame_is_kept_and_leads_there_and_back() {
    let bare = Scenario::parse(DISC).unwrap();
    assert!(bare.frame().is_identity() && !bare.to_json_string().contains("frame"));
    let plane = MapPlane { origin: [13.4, 52.5], scale: [67_000.0, 111_000.0], degrees: true };
    for (offset, plane) in [([4.5e6, -1024.0], None), ([0.0, 3.0], Some(plane))] {
        let frame = MapFrame::new(offset, plane).unwrap();
        let scenario = bare.clone().in_frame(frame);
        assert_ne!(scenario, bare);
        let text = scenario.to_json_string();
        let read = Scenario::parse(&text).unwrap();
        assert_eq!((read.frame(), &read, read.to_json_string()), (&frame, &scenario, text));
        assert_eq!((frame.offset(), frame.plane(), frame.has_degrees()), (offset, plane.as_ref(), plane.is_some()));
        for place in [[0.0, 0.0], [1.25, -2.5]] {
            for there_and_back in [frame.from_metres(frame.to_metres(place)), frame.from_units(frame.to_units(place))] {
                let off = [0, 1].map(|k| (there_and_back[k] - place[k]).abs());
                assert!(off[0].max(off[1]) < 1e-8, "{place:?} becomes {there_and_back:?}");
            }
        }
        assert_eq!(frame.to_metres([1.0, 2.0]), [1.0 + offset[0], 2.0 + offset[1]]);
        assert_eq!(scenario.in_frame(MapFrame::default()), bare);
    }
    // Within its ranges nothing becomes infinite, and what an offset costs is known.
    for end in [1e-12, 1e12] {
        let plane = MapPlane { origin: [1e18, -1e18], scale: [end; 2], degrees: false };
        let frame = MapFrame::new([-1e18, 1e18], Some(plane)).unwrap();
        assert!(frame.to_units([1e6; 2]).iter().chain(&frame.from_units([1e18; 2])).all(|x| x.is_finite()));
        assert_eq!(frame.resolution(), 128.0);
    }
    assert_eq!(MapFrame::new([-3.0, 1e12], None).unwrap().resolution(), 2.0_f64.powi(-13));
    refuses(MapFrame::new([1.1e18, 0.0], None), "out-of-range", "/offset/0");
}
