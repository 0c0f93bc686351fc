//! Golden outcomes of inverse kinematics: every method, with and without limits and orientations, the same bits natively, in Node
//! and in Chrome.

use crate::common::golden;
use planarium::geometry::Point;
use planarium::ik::{Solver, SolverOptions, Target, follow, nearest_reachable};
use planarium::run::Value;
use planarium::scenario::{Robot, Scenario, generate::generate};
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

/// The number of steps of the followed target.
const MOVES: u32 = 20;

fn scenario(case: &Json) -> Scenario {
    match case["generate"].as_str() {
        Some(kind) => generate(kind, &case["options"]).expect("it can be generated"),
        None => Scenario::parse(&case["scenario"].to_string()).expect("a scenario"),
    }
}

/// The options of a case.
fn options(given: &Json) -> SolverOptions {
    let number = |value: &Json| value.as_f64().expect("a number");
    let target = Target {
        point: Point::new(number(&given["target"][0]), number(&given["target"][1])),
        orientation: given["orientation"].as_f64(),
    };
    let mut options =
        SolverOptions { method: given["method"].as_str().map(str::to_owned), ..SolverOptions::to(target) };
    for (name, value) in given.as_object().expect("options") {
        match (name.as_str(), value) {
            ("target" | "orientation" | "method", _) => (),
            ("seed", seed) => options.seed = seed.as_u64().expect("a seed"),
            (_, value) => options.parameters.push((name.clone(), Value::from(value))),
        }
    }
    options
}

/// The outcome of a case: the run, how near the arm can come, and its configuration after following to the target.
fn outcome(case: &Json) -> Json {
    let scenario = scenario(case);
    let options = options(&case["reach"]);
    let mut run = Solver::new(&scenario, &options).expect("it starts");
    let start = run.configuration();
    run.step(u64::MAX);
    let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
    let nearest = nearest_reachable(arm, options.target).expect("a target");
    let (mut q, from) = (start[..run.dimension()].to_vec(), arm.end_effector(&start));
    let mut distance = 0.0;
    for step in 1..=MOVES {
        let part = f64::from(step) / f64::from(MOVES);
        let point = from + (options.target.point - from) * part;
        let moved = follow(arm, &q, Target { point, ..options.target }).expect("it follows");
        (q, distance) = (moved.configuration, moved.distance);
    }
    json!({
        "status": run.status().as_str(),
        "verdict": run.explain().as_str(),
        "iterations": run.stats().iterations,
        "solutions": run.solutions().len(),
        "rejected": run.rejected().len(),
        "fingerprint": format!("{:016x}", run.fingerprint()),
        "nearest": { "configuration": nearest.configuration, "distance": nearest.distance },
        "followed": { "configuration": q, "distance": distance },
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn every_case_of_inverse_kinematics_has_its_golden_outcome() {
    golden::check("golden-ik.json", include_str!("golden-ik.json"), 30, outcome);
}
