//! Scenarios with rigid bodies and cars: what their documents may hold, and how they are written again.

use crate::common::documents::{ARM, BODY, CAR, DISC, refusal, with};
use planarium::robot::{Part, Weights};
use planarium::run::inspect::Inspector;
use planarium::scenario::{GoalTolerance, Robot, Scenario};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn a_document_becomes_a_body_or_a_car_and_is_written_again() {
    let scenario = Scenario::parse(BODY).unwrap();
    let Robot::RigidBody(body) = scenario.robot() else { panic!("a body") };
    assert_eq!((body.shape().vertices().len(), body.shape().is_convex()), (5, false));
    assert_eq!(body.weights(), Weights { translation: 0.7, rotation: 0.3 });
    let query = &scenario.queries()[0];
    assert_eq!(query.configuration(), Some(&[1.8, 1.8, 7.0][..]), "angles are kept as they are written");
    assert_eq!(query.goal_tolerance, Some(GoalTolerance { translation: 0.1, rotation: 0.5 }));
    let scenario = Scenario::parse(CAR).unwrap();
    let Robot::Car(car) = scenario.robot() else { panic!("a car") };
    assert_eq!((car.wheelbase(), car.integration_step()), (0.2, 0.02));
    assert_eq!((car.speed(), car.steering()), ([-0.5, 0.5], [-0.75, 0.75]));
    assert_eq!((scenario.robot().dimension(), scenario.robot().kind()), (3, "car"));
    for document in [BODY, CAR] {
        let scenario = Scenario::parse(document).unwrap();
        let text = scenario.to_json_string();
        assert_eq!(Scenario::parse(&text), Ok(scenario), "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn metric_step_and_region_may_be_left_out() {
    for document in [BODY, CAR] {
        let region = r#", "goal_tolerance": {"translation": 0.1, "rotation": 0.5}"#;
        assert_eq!(Scenario::parse(&with(document, region, "")).unwrap().queries()[0].goal_tolerance, None);
    }
    let metric = r#",
            "metric": {"translation": 0.5, "rotation": 0.25}"#;
    let plain = with(&with(CAR, metric, ""), r#""integration_step": 0.02"#, r#""integration_step": 0.01"#);
    let left_out = with(&plain, r#", "integration_step": 0.01"#, "");
    let Robot::Car(car) = Scenario::parse(&left_out).unwrap().robot().clone() else { panic!("a car") };
    assert_eq!((car.weights(), car.integration_step()), (Weights::default(), 0.01));
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_wrong_is_refused_in_its_place() {
    let cases = [
        (BODY, r#""type": "polygon""#, r#""type": "disc""#, "unknown-type", "/robot/shape/type"),
        (BODY, r#"[0.1, 0.05], [0, 0], [-0.1, 0.05]"#, "[0, -0.05]", "degenerate-polygon", "/robot/shape/vertices"),
        (BODY, "[0, 0], [-0.1, 0.05]", "[0, -0.3], [-0.1, 0.05]", "degenerate-polygon", "/robot/shape/vertices"),
        (BODY, r#""translation": 0.7"#, r#""translation": 0"#, "out-of-range", "/robot/metric/translation"),
        (BODY, r#""rotation": 0.3"#, r#""rotation": -1"#, "out-of-range", "/robot/metric/rotation"),
        (BODY, r#""rotation": 0.3"#, r#""turn": 0.3"#, "unknown-field", "/robot/metric/turn"),
        (BODY, r#""metric""#, r#""wheelbase": 1, "metric""#, "unknown-field", "/robot/wheelbase"),
        (
            BODY,
            r#""translation": 0.1"#,
            r#""translation": -0.1"#,
            "out-of-range",
            "/queries/0/goal_tolerance/translation",
        ),
        (BODY, "[0.2, 0.2, 0]", "[0.2, 0.2]", "wrong-dimension", "/queries/0/start"),
        (BODY, r#""bounds": {"min": [0, 0], "max": [2, 2]}, "#, "", "missing-field", "/world/bounds"),
        (CAR, r#""wheelbase": 0.2, "#, "", "missing-field", "/robot/wheelbase"),
        (CAR, r#""wheelbase": 0.2"#, r#""wheelbase": 0"#, "out-of-range", "/robot/wheelbase"),
        (CAR, "[-0.5, 0.5]", "[0.5, 0.5]", "out-of-range", "/robot/speed"),
        (CAR, "[-0.75, 0.75]", "[-0.75, 1.6]", "out-of-range", "/robot/steering/1"),
        (CAR, "[-0.75, 0.75]", "[-0.75]", "wrong-dimension", "/robot/steering"),
        (CAR, r#""integration_step": 0.02"#, r#""integration_step": 0"#, "out-of-range", "/robot/integration_step"),
        (CAR, r#""integration_step": 0.02"#, r#""integration_step": 11"#, "out-of-range", "/robot/integration_step"),
    ];
    for (document, piece, replacement, code, pointer) in cases {
        let error = refusal(&with(document, piece, replacement));
        assert_eq!((error.code().as_str(), error.pointer()), (code, pointer), "{piece} -> {replacement}: {error}");
    }
    for (document, words) in [(ARM, "an arm reaches"), (DISC, "a disc reaches")] {
        let error = refusal(&with(document, r#""goal""#, r#""goal_tolerance": {}, "goal""#));
        assert!(error.message().contains(words), "{error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_viewer_is_told_where_the_corners_are_and_what_they_touch() {
    let inspector = Inspector::new(&Scenario::parse(CAR).unwrap());
    assert_eq!((inspector.dimension(), inspector.circles()), (3, vec![false, false, true]));
    let parts = inspector.footprint(&[1.0, 0.5, std::f64::consts::FRAC_PI_2]).unwrap();
    let [Part::Polygon { vertices }] = &parts[..] else { panic!("one polygon: {parts:?}") };
    assert!((vertices[0].x - 1.05).abs() < 1e-15 && (vertices[0].y - 0.4).abs() < 1e-15, "{vertices:?}");
    assert_eq!(inspector.check(&[1.0, 0.5, 0.0]), Ok(vec![]));
    let both = inspector.check(&[1.0, 0.65, 0.0]).unwrap();
    assert_eq!(both.iter().map(ToString::to_string).collect::<Vec<_>>(), ["part 0 touches obstacle 0"]);
    assert_eq!(inspector.check(&[0.05, 0.5, 0.0]).unwrap()[0].to_string(), "part 0 leaves the bounds");
    assert_eq!(inspector.check(&[0.1, 0.5, 0.0]), Ok(vec![]), "the bounds may be touched");
}
