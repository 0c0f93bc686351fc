//! Golden fingerprints: the same bits on native, Node and Chrome, and tomorrow. `PLANARIUM_BLESS=1 cargo test --test golden`
//! writes them anew after a change that is meant to change results.

use crate::common::golden;
use planarium::run::{Options, Value, start};
use planarium::scenario::generate::generate;
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

/// The outcome of a case: status, fingerprint, length and the number of waypoints.
fn outcome(case: &Json) -> Json {
    // A scene of the page, or a generated one.
    let scenario = match case["generate"].as_str() {
        Some(kind) => generate(kind, &case["options"]).expect("it can be generated"),
        None => golden::scene(case["scene"].as_str().expect("a scene or a generator")),
    };
    let parameters = case["parameters"].as_object().expect("parameters").iter();
    let parameters = parameters.map(|(name, value)| (name.clone(), Value::from(value)));
    let options = Options {
        planner: Some(case["planner"].as_str().expect("a planner").to_owned()),
        query: None,
        seed: case["seed"].as_u64().expect("a seed"),
        parameters: parameters.collect(),
    };
    let mut run = start(&scenario, &options).expect("it starts");
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
    // Every planner with every sampler, bodies, cars by controls and by curves, targets.
    golden::check("golden.json", include_str!("golden.json"), 120, outcome);
}
