//! The length of a path is one quantity: what planners minimise is what history, conditions and results report. It never rises, and other
//! code finds the same sum along the path.

use crate::common::documents::{judged, named, rectangular};
use crate::common::driven::car;
use crate::common::{
    DRIVEN, arm_and_wall, arm_of, assert_valid, begin_with, body_and_wall, car_and_wall, cases, disc_and_wall, finish,
};
use planarium::path::{LengthMeasure, ResultDocument};
use planarium::run::{HISTORY_WIDTH, Run, Status};
use planarium::scenario::{Robot, Scenario, generate::generate};
use planarium::space::angular_distance;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// Every planner that goes on to shorter paths of straight motions or curves.
const IMPROVING: [&str; 5] = ["rrt-star", "informed-rrt-star", "bit-star", "lazy-prm-star", "aorrtc"];

/// The length of a result by the measure of its robot, from the document alone.
fn measured(world: &Scenario, result: &ResultDocument) -> f64 {
    let steps = result.path.windows(2);
    match (world.robot(), result.length_measure.expect("a scenario names it")) {
        (Robot::Car(_), LengthMeasure::Metres) => {
            let motions = result.motions.as_ref().expect("a car has motions");
            motions.iter().map(|motion| motion.control.speed.abs() * motion.duration).sum()
        }
        (Robot::Disc(_), LengthMeasure::Metres) => steps.map(|q| (q[1][0] - q[0][0]).hypot(q[1][1] - q[0][1])).sum(),
        (Robot::RigidBody(body), LengthMeasure::Weighted) => {
            let weights = body.weights;
            let step = |a: &[f64], b: &[f64]| {
                weights.translation * (a[0] - b[0]).hypot(a[1] - b[1]) + weights.rotation * angular_distance(a[2], b[2])
            };
            steps.map(|q| step(&q[0], &q[1])).sum()
        }
        (Robot::Arm(_), LengthMeasure::SumOfJoints) => steps.map(|q| turns(q).iter().sum::<f64>()).sum(),
        (Robot::Arm(_), LengthMeasure::EuclideanOfJoints) => {
            steps.map(|q| turns(q).iter().map(|turn| turn * turn).sum::<f64>().sqrt()).sum()
        }
        (robot, measure) => panic!("{measure:?} of a path of {}", robot.kind()),
    }
}

/// How far each joint without limits turns.
fn turns(ends: &[Vec<f64>]) -> Vec<f64> {
    ends[0].iter().zip(&ends[1]).map(|(&a, &b)| angular_distance(a, b)).collect()
}

/// The lengths of the history of a run, from the first path on.
fn history(run: &dyn Run) -> Vec<f64> {
    let lengths: Vec<f64> = run.history_since(0).chunks(HISTORY_WIDTH).map(|row| row[HISTORY_WIDTH - 1]).collect();
    lengths.into_iter().filter(|length| *length < f64::INFINITY).collect()
}

/// Whether no length is greater than the one before, to the bit.
fn falls(lengths: &[f64]) -> bool {
    lengths.windows(2).all(|pair| pair[1] <= pair[0])
}

/// A run with its history, to the end.
fn recorded(world: &Scenario, planner: &str, settings: &str) -> Box<dyn Run> {
    let mut run = begin_with(world, planner, 3, settings);
    run.record().expect("nothing is done yet");
    finish(run)
}

/// Robots in worlds, with the settings that name a metric or curves.
fn robots() -> Vec<(Scenario, &'static str)> {
    let generated =
        |kind: &str, seed: u64| generate(kind, &json!({ "robot": "car", "seed": seed })).expect("a world that is made");
    vec![
        (arm_and_wall(0.1), "metric=sum"),
        (arm_of(3, false, 0.02), "metric=euclidean"),
        (disc_and_wall(0.3, 0.5), ""),
        (body_and_wall(0.1), ""),
        (car_and_wall(0.1), "steering=reeds-shepp"),
        (car_and_wall(0.1), "steering=dubins"),
        (generated("maze", 5), ""),
        (generated("discs", 2), ""),
    ]
}

#[wasm_bindgen_test(unsupported = test)]
fn more_improvement_never_reports_a_longer_path() {
    let mut shorter = 0;
    for (i, (world, fixed)) in robots().iter().enumerate() {
        for planner in IMPROVING.into_iter().filter(|&id| !(id == "aorrtc" && fixed.ends_with("dubins"))) {
            let what = format!("{planner} {fixed} in {} ({i})", world.name());
            let of = |settings: &str| recorded(world, planner, &format!("{fixed} max_iterations=6000 {settings}"));
            let mut lengths = Vec::new();
            for more in [0, 150, 600] {
                let run = of(&format!("improve_iterations={more}"));
                let result = run.result();
                if result.status != Status::Solved {
                    break;
                }
                let history = history(&*run);
                assert!(falls(&history), "{what}: the history rises");
                assert_eq!(history[history.len() - 1].to_bits(), result.length.to_bits(), "{what}");
                assert_eq!(run.length().to_bits(), result.length.to_bits(), "{what}");
                let sum = measured(world, &result);
                assert!((result.length - sum).abs() <= 1e-9 * sum, "{what}: {} is {sum}", result.length);
                assert_valid(world, &*run);
                lengths.push(result.length);
            }
            assert!(falls(&lengths), "{what}: {lengths:?}");
            let [first, .., last] = lengths[..] else { continue };
            if last > 0.98 * first {
                continue;
            }
            shorter += 1;
            let most = 0.5 * (first + last);
            let run = of(&format!("stop_cost={most} improve_iterations=600"));
            let history = history(&*run);
            assert!(run.length() <= most, "{what}: {} for at most {most}", run.length());
            assert!(history[..history.len() - 1].iter().all(|length| *length > most), "{what}: it stops at once");
        }
    }
    assert!(shorter >= cases(60), "only {shorter} paths got shorter");
}

#[wasm_bindgen_test(unsupported = test)]
fn by_controls_metres_are_minimised_reported_and_never_rise() {
    let world = car_and_wall(0.1);
    for (planner, settings) in DRIVEN {
        let run = recorded(&world, planner, settings);
        let result = run.result();
        if result.status == Status::Solved {
            let sum = measured(&world, &result);
            assert!((result.length - sum).abs() <= 1e-12 * sum, "{planner} {settings}: {} is {sum}", result.length);
            assert!(falls(&history(&*run)), "{planner} {settings}");
            // Of a path by controls the weighted sum of chords is another quantity, with a name of its own.
            let chords = result.chord_length.expect("a path by controls has chords");
            assert!((chords - result.length).abs() > 1e-3 * sum, "{planner} {settings}");
        }
    }
    let lengths = [0, 300, 1500].map(|more| recorded(&world, "sst", &format!("improve_iterations={more}")).length());
    assert!(falls(&lengths) && lengths[2] < lengths[0], "{lengths:?}");
    let most = 0.5 * (lengths[0] + lengths[2]);
    let run = recorded(&world, "sst", &format!("improve_iterations=1500 stop_cost={most}"));
    assert!(run.length() <= most && run.iterations() < recorded(&world, "sst", "improve_iterations=1500").iterations());
}

#[wasm_bindgen_test(unsupported = test)]
fn shortcuts_of_a_car_shorten_what_is_reported() {
    let world = car_and_wall(0.1);
    for seed in 0..4 {
        let mut run = begin_with(&world, "rrt", seed, "shortcut=60 reduce=true");
        run.record().expect("nothing is done yet");
        let run = finish(run);
        let history = history(&*run);
        assert!(falls(&history), "seed {seed}");
        assert_eq!(history[history.len() - 1].to_bits(), run.length().to_bits(), "seed {seed}");
        let sum = measured(&world, &run.result());
        assert!((run.length() - sum).abs() <= 1e-9 * sum, "seed {seed}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn ten_metres_straight_ahead_are_ten_metres() {
    let limits = r#""wheelbase": 0.2, "speed": [-0.5, 0.5], "steering": [-0.75, 0.75]"#;
    let region = r#", "goal_tolerance": { "translation": 0.01, "rotation": 0.01 }"#;
    let query = format!(r#""start": [1, 1, 0], "goal": [11, 1, 0]{region}"#);
    let road = named("road", "[0, 0], [12, 2]", "", &rectangular("car", 0.1, 0.05, limits), &query);
    for planner in ["bit-star", "rrt-star", "rrt-connect", "prm"] {
        let run = finish(begin_with(&road, planner, 1, "shortcut=0 max_iterations=20000"));
        assert_eq!(run.status(), Status::Solved, "{planner}");
        assert!(run.length() >= 10.0 - 1e-9, "{planner}: {}", run.length());
    }
    assert!((finish(begin_with(&road, "bit-star", 1, "")).length() - 10.0).abs() < 1e-9);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_verifier_compares_the_length_by_the_measure_that_is_named() {
    let world = car_and_wall(0.1);
    let result = finish(begin_with(&world, "rrt", 1, "")).result();
    judged(&world, &result).expect("a valid path");
    let weights = car(&world).weights();
    let motions = result.motions.clone().expect("a car has motions");
    let turn_rate = |motion: &planarium::problem::Motion| {
        car(&world).turn_rate(motion.control.speed, motion.control.steering).abs() * motion.duration
    };
    let weighted = weights.translation * result.length + weights.rotation * motions.iter().map(turn_rate).sum::<f64>();
    let refused = |result: ResultDocument| judged(&world, &result).expect_err("a wrong length");
    assert!(refused(ResultDocument { length: weighted, ..result.clone() }).contains("the length is given"));
    let other = ResultDocument { length_measure: Some(LengthMeasure::Weighted), ..result.clone() };
    assert!(refused(other).contains("Metres"));
    judged(&world, &ResultDocument { length_measure: None, ..result }).expect("as results were written before");

    let world = arm_of(3, false, 0.02);
    let [sum, euclidean] = ["sum", "euclidean"]
        .map(|metric| finish(begin_with(&world, "rrt-connect", 1, &format!("metric={metric}"))).result());
    for (result, other) in [(sum, LengthMeasure::EuclideanOfJoints), (euclidean, LengthMeasure::SumOfJoints)] {
        judged(&world, &result).expect("a valid path");
        let why =
            judged(&world, &ResultDocument { length_measure: Some(other), ..result }).expect_err("another measure");
        assert!(why.contains("the length is given"), "{why}");
    }
}
