//! Golden fingerprints: the same bits on native, Node and Chrome, and tomorrow. `PLANARIUM_BLESS=1 cargo test --test golden`
//! writes them anew after a change that is meant to change results.

use planarium::run::{Options, Value, start};
use planarium::scenario::{Scenario, generate::generate};
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

const GOLDEN: &str = include_str!("golden.json");

/// The scenario of a case: a scene of the page, or a generated one.
fn scenario(case: &Json) -> Scenario {
    if let Some(kind) = case["generate"].as_str() {
        return generate(kind, &case["options"]).expect("it can be generated");
    }
    let text = match case["scene"].as_str().expect("a scene or a generator") {
        "firs" => include_str!("../www/scenes/firs.json"),
        "locked" => include_str!("../www/scenes/locked.json"),
        "pick" => include_str!("../www/scenes/pick.json"),
        "rings" => include_str!("../www/scenes/rings.json"),
        "shelf" => include_str!("../www/scenes/shelf.json"),
        "stones" => include_str!("../www/scenes/stones.json"),
        "thicket" => include_str!("../www/scenes/thicket.json"),
        other => panic!("no scene {other}"),
    };
    Scenario::parse(text).expect("our own scenes are right")
}

/// What a case comes to: status, fingerprint, length and the number of waypoints.
fn outcome(case: &Json) -> Json {
    let parameters = case["parameters"].as_object().expect("parameters").iter().map(|(name, value)| {
        let value = match value {
            Json::Number(number) => Value::Number(number.as_f64().expect("a double")),
            Json::Bool(on) => Value::Boolean(*on),
            word => Value::Text(word.as_str().expect("a word").into()),
        };
        (name.clone(), value)
    });
    let options = Options {
        planner: Some(case["planner"].as_str().expect("a planner").to_owned()),
        query: None,
        seed: case["seed"].as_u64().expect("a seed"),
        parameters: parameters.collect(),
    };
    let mut run = start(&scenario(case), &options).expect("it starts");
    run.step(u64::MAX);
    assert_eq!(run.stats().unproven_motions, 0, "no ordinary motion spends its budget: {case}");
    json!({
        "status": run.status().as_str(),
        "fingerprint": format!("{:016x}", run.fingerprint()),
        "length": run.length(),
        "waypoints": run.path().len(),
        "clearance_evaluations": run.stats().clearance_evaluations,
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn every_case_has_its_golden_outcome() {
    let cases: Vec<Json> = serde_json::from_str(GOLDEN).expect("the golden file is JSON");
    assert!(cases.len() >= 120, "every planner with every sampler, bodies, cars by controls and by curves, targets");
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("PLANARIUM_BLESS").is_some() {
        let blessed: Vec<Json> = cases
            .iter()
            .map(|case| {
                let mut case = case.clone();
                case["outcome"] = outcome(&case);
                case
            })
            .collect();
        let text = serde_json::to_string_pretty(&blessed).expect("JSON") + "\n";
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden.json"), text).expect("written");
        return;
    }
    for case in &cases {
        assert_eq!(outcome(case), case["outcome"], "{case}");
    }
}
