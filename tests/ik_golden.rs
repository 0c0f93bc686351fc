//! Golden outcomes of inverse kinematics: the same bits on native, Node and Chrome, and tomorrow. `PLANARIUM_BLESS=1 cargo test
//! --test reach_golden` writes them anew after a change that is meant to change results.

use planarium::geometry::Point;
use planarium::ik::{Solver, SolverOptions, Target, follow, nearest_reachable};
use planarium::run::Value;
use planarium::scenario::{Robot, Scenario, generate::generate};
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

const GOLDEN: &str = include_str!("golden-ik.json");

/// How many times the hand moves on its way to the target.
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
            (_, Json::Bool(on)) => options.parameters.push((name.clone(), Value::Boolean(*on))),
            (_, value) => options.parameters.push((name.clone(), Value::Number(number(value)))),
        }
    }
    options
}

/// What a case comes to: the run, how near the arm can come, and where it is when it has followed a hand to the target.
fn outcome(case: &Json) -> Json {
    let scenario = scenario(case);
    let options = options(&case["reach"]);
    let mut run = Solver::new(&scenario, &options).expect("it starts");
    let start = run.configuration();
    run.step(u64::MAX);
    let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
    let links = arm.links().len();
    let nearest = nearest_reachable(arm, options.target).expect("a target");
    let (mut q, from) = (start, arm.end_effector(&start));
    let mut distance = 0.0;
    for step in 1..=MOVES {
        let part = f64::from(step) / f64::from(MOVES);
        let point = from + (options.target.point - from) * part;
        let moved = follow(arm, &q[..links], Target { point, ..options.target }).expect("it follows");
        (q, distance) = (moved.configuration, moved.distance);
    }
    json!({
        "status": run.status().as_str(),
        "verdict": run.explain().as_str(),
        "iterations": run.iterations(),
        "solutions": run.solutions().len(),
        "rejected": run.rejected().len(),
        "fingerprint": format!("{:016x}", run.fingerprint()),
        "nearest": { "configuration": nearest.configuration[..links], "distance": nearest.distance },
        "followed": { "configuration": q[..links], "distance": distance },
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn every_case_of_inverse_kinematics_has_its_golden_outcome() {
    let cases: Vec<Json> = serde_json::from_str(GOLDEN).expect("the golden file is JSON");
    assert!(cases.len() >= 30, "every method, with and without limits and orientations");
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
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden-ik.json"), text).expect("written");
        return;
    }
    for case in &cases {
        assert_eq!(outcome(case), case["outcome"], "{case}");
    }
}
