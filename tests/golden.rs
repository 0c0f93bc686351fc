//! Golden outcomes: the same bits on every platform and with every change, unless it is meant to change results.

use crate::common::golden::{check, scene};
use crate::common::requests::start;
use crate::common::{finish, parse};
use planarium::geometry::Point;
use planarium::ik::{MethodOptions, Solver, SolverOptions, Target, follow, nearest_reachable};
use planarium::options::Options;
use planarium::problem::Stepped;
use planarium::run::inspect::Inspector;
use planarium::run::neighbours::{IndexOptions, index};
use planarium::run::{Request, Value};
use planarium::scenario::{Robot, Scenario, generate::generate};
use planarium::trajectories::Trajectories;
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

/// A generated scenario, a scene of the pages, or one of the case itself.
fn scenario(case: &Json) -> Scenario {
    match (case["generate"].as_str(), case["scene"].as_str()) {
        (Some(kind), _) => generate(kind, &case["options"]).expect("it can be generated"),
        (_, Some(name)) => scene(name),
        _ => parse(&case["scenario"].to_string()),
    }
}

fn parameters(given: &Json) -> Vec<(String, Value)> {
    given.as_object().expect("options").iter().map(|(name, value)| (name.clone(), Value::from(value))).collect()
}

/// Of a planner: status, fingerprint, length and the number of waypoints.
fn planned(case: &Json) -> Json {
    let options = Request {
        planner: Some(case["planner"].as_str().expect("a planner").to_owned()),
        query: None,
        seed: case["seed"].as_u64().expect("a seed"),
        parameters: parameters(&case["parameters"]),
        ..Request::default()
    };
    let run = finish(start(scenario(case), &options).expect("it starts"));
    assert_eq!(run.stats().unproven_motions, 0, "no ordinary motion spends its budget: {case}");
    let mut outcome = json!({
        "status": run.status().as_str(),
        "fingerprint": format!("{:016x}", run.fingerprint()),
        "length": run.length(),
        "waypoints": run.path().len(),
        "clearance_evaluations": run.stats().clearance_evaluations,
    });
    if let Some(blended) = run.result().blended_length {
        outcome["blended_length"] = blended.into();
    }
    outcome
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_has_its_golden_outcomes() {
    // Every planner with every sampler, bodies, cars by controls and by curves, targets.
    check("golden.json", include_str!("golden.json"), 120, planned);
}

#[wasm_bindgen_test(unsupported = test)]
fn worlds_with_holes_and_walls_have_their_golden_outcomes() {
    // Every robot, with and without a margin.
    check("golden-walls.json", include_str!("golden-walls.json"), 14, planned);
}

/// The number of steps of the followed target.
const MOVES: u32 = 20;

/// Of inverse kinematics: the run, how near the arm can come, and its configuration after following to the target.
fn reached(case: &Json) -> Json {
    let mut given = case["reach"].clone();
    let mut take = |name: &str| given.as_object_mut().expect("options").remove(name).unwrap_or_default();
    let [x, y] = serde_json::from_value(take("target")).expect("a point");
    let target = Target { point: Point::new(x, y), orientation: take("orientation").as_f64() };
    let (method, seed) = (take("method"), take("seed").as_u64().unwrap_or_default());
    let method = MethodOptions::read(method.as_str(), &parameters(&given)).expect("options in range");
    let options = SolverOptions { method, seed, ..SolverOptions::to(target) };
    let scenario = scenario(case);
    let mut run = Solver::new(&scenario, &options).expect("it starts");
    let start = run.configuration();
    run.step(u64::MAX);
    let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
    let nearest = nearest_reachable(arm, target).expect("a target");
    let (mut q, from) = (start[..run.dimension()].to_vec(), arm.end_effector(&start));
    let mut distance = 0.0;
    for step in 1..=MOVES {
        let point = from + (target.point - from) * (f64::from(step) / f64::from(MOVES));
        let moved = follow(arm, &q, Target { point, ..target }).expect("it follows");
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
fn every_method_of_inverse_kinematics_has_its_golden_outcomes() {
    // With and without limits and orientations.
    check("golden-ik.json", include_str!("golden-ik.json"), 30, reached);
}

fn drawn(case: &Json) -> Json {
    let seed = case["seed"].as_u64().expect("a seed");
    let options = Options::read(&parameters(&case["options"])).expect("options in range");
    let mut run = Trajectories::new(&options, seed).expect("options that go together");
    run.step(u64::MAX);
    json!(run.result())
}

#[wasm_bindgen_test(unsupported = test)]
fn trajectories_have_their_golden_outcomes() {
    check("golden-trajectories.json", include_str!("golden-trajectories.json"), 10, drawn);
}

fn nearest(case: &Json) -> Json {
    let (scenario, id) = (scenario(case), case["index"].as_str());
    let number = |name: &str| case[name].as_u64().expect("a count");
    let options = IndexOptions::read(id, &parameters(&case["parameters"])).expect("options in range");
    let mut index = index(&scenario, &options).expect("an index");
    let rows = Inspector::new(&scenario).samples(number("samples"), number("seed"), case["free"] == true);
    index.add(&rows.expect("samples")).expect("rows");
    let q: Vec<f64> = serde_json::from_value(case["target"].clone()).expect("a target");
    let found = match case["radius"].as_f64() {
        Some(radius) => index.within(&q, radius),
        None => index.k_nearest(&q, number("k") as usize),
    };
    let found = found.expect("neighbours");
    let indices: Vec<_> = found.neighbours.iter().map(|neighbour| neighbour.vertex.0).collect();
    let distances: Vec<_> = found.neighbours.iter().map(|neighbour| neighbour.distance).collect();
    // A tree's shape, and so what it visits, is the platform's own.
    let visited = if id == Some("kd-tree") { Json::Null } else { json!(found.visited) };
    json!({ "indices": indices, "distances": distances, "visited": visited })
}

#[wasm_bindgen_test(unsupported = test)]
fn indexes_have_their_golden_neighbours() {
    check("golden-neighbours.json", include_str!("golden-neighbours.json"), 24, nearest);
}
