//! Trajectories: limits hold at every time, they are as fast as a dense grid finds, and documents read back.

use crate::common::documents::{parse, refuses};
use crate::common::golden::check;
use crate::common::{cases, deep};
use planarium::fingerprint::Fingerprint;
use planarium::geometry::arc_pose;
use planarium::path::ResultDocument;
use planarium::random::{Random, Stream};
use planarium::scenario::{Robot, Scenario};
use planarium::timing::{
    self, CarLimits, CoordinateLimits, Curve, LimitOptions, Limits, PlaneLimits, Trajectory, Verdict, verify,
};
use serde_json::{Value as Json, json};
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

const SQUARE: &str = r#"{"type": "polygon", "vertices": [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]}"#;

/// A scenario without obstacles for a robot with this many coordinates.
fn empty(robot: &str, dimension: usize) -> Scenario {
    let zero = json!(vec![0.0; dimension]);
    parse(
        &format!(
            r#"{{"format": "planarium-scenario-1", "name": "empty", "robot": {robot},
            "world": {{"bounds": {{"min": [-20, -20], "max": [20, 20]}}, "obstacles": []}},
            "queries": [{{"name": "any", "start": {zero}, "goal": {zero}, "goal_tolerance": {tolerance}}}]}}"#,
            tolerance = if robot.contains("shape") { r#"{"translation": 50, "rotation": 4}"# } else { "null" },
        )
        .replace(r#", "goal_tolerance": null"#, ""),
    )
}

pub fn arm() -> Scenario {
    empty(r#"{"type": "arm", "base": [0, 0], "links": [1, 1, 0.5]}"#, 3)
}

/// Limited joints, a circle and one that slides.
fn sliding_arm() -> Scenario {
    let joints = r#"["revolute", {"type": "revolute", "limits": [-9, 9]}, {"type": "prismatic", "range": [-0.5, 2], "angle": 0.3},
        {"type": "revolute", "limits": [-3, 3]}]"#;
    empty(&format!(r#"{{"type": "arm", "base": [0, 0], "links": [1, 1, 0.5, 0.2], "joints": {joints}}}"#), 4)
}

pub fn disc() -> Scenario {
    empty(r#"{"type": "disc", "radius": 0.1}"#, 2)
}

pub fn body() -> Scenario {
    empty(&format!(r#"{{"type": "rigid_body", "shape": {SQUARE}}}"#), 3)
}

fn car() -> Scenario {
    let limits = r#""wheelbase": 0.2, "speed": [-0.5, 1.5], "steering": [-0.7, 0.7]"#;
    empty(&format!(r#"{{"type": "car", "shape": {SQUARE}, {limits}}}"#), 3)
}

/// A solved result with this path and, if any, blends and motions.
pub fn result(path: &[Vec<f64>], blends: Option<&[[f64; 2]]>, motions: Option<Json>) -> ResultDocument {
    let mut document = json!({
        "scenario": "empty", "query": "any", "planner": "given", "seed": 0, "status": "solved", "path": path, "length": 0,
        "stats": planarium::problem::Stats::default(), "fingerprint": "0000000000000000",
    });
    if let Some(blends) = blends {
        document["blends"] = json!(blends);
    }
    if let Some(motions) = motions {
        document["motions"] = motions;
    }
    ResultDocument::parse(&document.to_string()).expect("a result")
}

/// A number between two others.
pub fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * random.uniform()
}

/// A random path of straight edges: most corners have blends; one waypoint in eight is at a share `beside` of the way to another.
pub fn corners(random: &mut Random, robot: &Robot, beside: f64) -> ResultDocument {
    let reach: Vec<[f64; 2]> = match robot {
        Robot::Arm(arm) => arm.joint_types().iter().map(|joint| joint.range().unwrap_or([-PI, PI])).collect(),
        Robot::Disc(_) => vec![[-2.0, 2.0]; 2],
        _ => vec![[-2.0, 2.0], [-2.0, 2.0], [-PI, PI]],
    };
    let count = 2 + (7.0 * random.uniform()) as usize;
    let mut path: Vec<Vec<f64>> = Vec::new();
    while path.len() < count {
        let mut next: Vec<f64> = reach.iter().map(|&[low, high]| between(random, low, high)).collect();
        if let (Some(last), kind) = (path.last(), random.uniform())
            && kind < 0.25
        {
            let share = if kind < 0.125 { beside } else { 0.3 };
            next = last.iter().zip(&next).map(|(a, b)| a + share * (b - a)).collect();
        }
        path.push(next);
    }
    let mut share = || if random.uniform() < 0.16 { 0.0 } else { 0.02 + 0.48 * random.uniform() };
    let blends: Vec<[f64; 2]> = (2..count).map(|_| [share(), share()]).collect();
    result(&path, Some(&blends), None)
}

/// A random path of a car, left, right and straight, forward and backward.
fn arcs(random: &mut Random, robot: &Robot) -> ResultDocument {
    let Robot::Car(car) = robot else { panic!("a car") };
    let (mut path, mut motions) = (vec![vec![0.0, 0.0, 0.5]], Vec::new());
    for _ in 0..1 + (8.0 * random.uniform()) as usize {
        let speed = if random.uniform() < 0.7 { 1.0 } else { -0.5 };
        let steering = [0.0, 0.6, -0.6, 0.2][(4.0 * random.uniform()) as usize];
        let duration = 2.0 * random.uniform();
        let last = &path[path.len() - 1];
        let pose = arc_pose([last[0], last[1], last[2]], speed, car.turn_rate(speed, steering), duration);
        path.push(vec![pose[0], pose[1], planarium::geometry::wrap(pose[2])]);
        motions.push(json!({"control": [speed, steering], "duration": duration}));
    }
    result(&path, None, Some(json!(motions)))
}

/// Every robot with random limits and a random path.
fn drawn(random: &mut Random, kind: usize, beside: f64) -> (Scenario, ResultDocument, Limits) {
    let scenario = [arm, sliding_arm, disc, body, car, disc, body][kind]();
    let robot = scenario.robot();
    let mut limit = || libm::exp(between(random, -2.0, 2.0));
    let limits = match (robot, kind) {
        (Robot::Car(_), _) => Limits::Car(CarLimits {
            speed: limit(),
            acceleration: limit(),
            lateral_acceleration: Some(limit()).filter(|limit| *limit < 2.0),
        }),
        (Robot::Disc(_) | Robot::RigidBody(_), 2 | 3) => Limits::Plane(PlaneLimits {
            speed: limit(),
            acceleration: limit(),
            turn_rate: Some(limit()).filter(|_| kind == 3),
            turn_acceleration: Some(limit()).filter(|_| kind == 3),
        }),
        _ => Limits::Coordinates(CoordinateLimits {
            speed: (0..robot.dimension()).map(|_| limit()).collect(),
            acceleration: (0..robot.dimension()).map(|_| limit()).collect(),
        }),
    };
    let result = if matches!(robot, Robot::Car(_)) { arcs(random, robot) } else { corners(random, robot, beside) };
    (scenario, result, limits)
}

/// The groups of coordinates that have limits of speed and acceleration.
fn groups(limits: &Limits) -> Vec<(Vec<usize>, f64, f64)> {
    match limits {
        Limits::Coordinates(CoordinateLimits { speed, acceleration }) => {
            (0..speed.len()).map(|i| (vec![i], speed[i], acceleration[i])).collect()
        }
        Limits::Plane(PlaneLimits { speed, acceleration, turn_rate, turn_acceleration }) => {
            let turn = turn_rate.zip(*turn_acceleration).map(|(rate, most)| (vec![2], rate, most));
            std::iter::once((vec![0, 1], *speed, *acceleration)).chain(turn).collect()
        }
        _ => Vec::new(),
    }
}

fn norm(vector: &[f64], group: &[usize]) -> f64 {
    group.iter().map(|&i| vector[i] * vector[i]).sum::<f64>().sqrt()
}

/// The largest share of a limit that a state has, minus one.
fn excess(scenario: &Scenario, limits: &Limits, state: &timing::State) -> f64 {
    let mut most = 0.0_f64;
    for (group, speed, acceleration) in groups(limits) {
        most = most.max(norm(&state.velocity, &group) / speed).max(norm(&state.acceleration, &group) / acceleration);
    }
    if let (Limits::Car(limits), Robot::Car(car)) = (limits, scenario.robot()) {
        let heading = state.configuration[2];
        let (sin, cos) = libm::sincos(heading);
        let along = |v: &[f64]| v[0] * cos + v[1] * sin;
        let across = |v: &[f64]| v[1] * cos - v[0] * sin;
        let speed = along(&state.velocity);
        assert!(across(&state.velocity).abs() < 1e-12, "a car does not slide");
        most = most.max(speed.abs() / limits.speed).max(speed / car.speed()[1]).max(speed / car.speed()[0]);
        most = most.max(along(&state.acceleration).abs() / limits.acceleration);
        most = most.max(limits.lateral_acceleration.map_or(0.0, |most| across(&state.acceleration).abs() / most));
    }
    most - 1.0
}

/// How many times of a trajectory are examined: 10^5 in a deep run.
fn times() -> u32 {
    if deep() { 100_000 } else { 40 }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_limit_is_exceeded_at_any_time_and_both_ends_are_at_rest() {
    let (mut worst, count) = (f64::NEG_INFINITY, if deep() { 1000 } else { cases(200) });
    for kind in 0..7 {
        for seed in 0..count as u64 {
            let mut random = Random::new(seed, Stream::Samples);
            let (scenario, result, limits) = drawn(&mut random, kind, 1e-3);
            let trajectory = timing::time(&scenario, &result, &limits).unwrap_or_else(|e| panic!("{kind} {seed}: {e}"));
            let duration = trajectory.duration();
            for i in 0..=times() {
                let state = trajectory.state(duration * f64::from(i) / f64::from(times()));
                worst = worst.max(excess(&scenario, &limits, &state));
                assert!(worst < 1e-9, "{kind} {seed}: {worst:e} too much at {}", state.time);
            }
            for time in [0.0, duration] {
                assert!(trajectory.velocity(time).iter().all(|v| *v == 0.0), "{kind} {seed}");
            }
            match verify(&scenario, &result, &trajectory).expect("they belong together") {
                Verdict::Invalid { why } => panic!("{kind} {seed}: {why}"),
                Verdict::Valid { speed, acceleration, .. } => {
                    assert!(speed.max(acceleration) > 1.0 - 1e-6, "{kind} {seed}: no limit is reached");
                }
            }
        }
    }
    if deep() {
        println!("largest excess of a limit: {worst:e}");
    }
}

/// The duration that a dense grid finds, densest at both ends of each piece: constraints at its knots alone, whatever lies
/// between.
fn dense(trajectory: &Trajectory, intervals: usize) -> f64 {
    let at = |k: usize| {
        let s = k as f64 / intervals as f64;
        s * s * (3.0 - 2.0 * s)
    };
    let pieces = trajectory.pieces();
    let is_stop: Vec<bool> = pieces.iter().map(|piece| piece.knots()[0][1] == 0.0).collect();
    let groups = groups(trajectory.limits());
    // Of each piece: first derivatives at its knots, and the second.
    let slopes = |piece: &timing::Piece, k: usize| -> (Vec<f64>, Vec<f64>) {
        let u = at(k);
        match piece.curve() {
            Curve::Straight { rate, .. } => (rate.clone(), vec![0.0; rate.len()]),
            Curve::Parabola { rate, bend, .. } => {
                (rate.iter().zip(bend).map(|(r, b)| r + 2.0 * u * b).collect(), bend.iter().map(|b| 2.0 * b).collect())
            }
            _ => panic!("no grid for arcs"),
        }
    };
    let whole: Vec<usize> = (0..trajectory.dimension()).collect();
    // The range of the second derivative at x.
    let range = |slope: &[f64], second: &[f64], x: f64| {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for (group, _, most) in &groups {
            let a: f64 = group.iter().map(|&i| slope[i] * slope[i]).sum();
            let b: f64 = group.iter().map(|&i| slope[i] * second[i] * x).sum();
            let c: f64 = group.iter().map(|&i| second[i] * second[i] * x * x).sum::<f64>() - most * most;
            if a == 0.0 {
                if c > 0.0 {
                    low = f64::INFINITY
                }
                continue;
            }
            let root = (b * b - a * c).sqrt();
            if root.is_nan() {
                low = f64::INFINITY
            }
            (low, high) = (low.max((-b - root) / a), high.min((-b + root) / a));
        }
        (low, high)
    };
    let ceiling = |slope: &[f64]| {
        let of = |(group, speed, _): &(Vec<usize>, f64, f64)| (speed / norm(slope, group)).powi(2);
        groups.iter().map(of).fold(f64::INFINITY, f64::min)
    };
    let mut most: Vec<Vec<f64>> = vec![Vec::new(); pieces.len()];
    let mut beyond = 0.0;
    for (i, piece) in pieces.iter().enumerate().rev() {
        let size = |k: usize| norm(&slopes(piece, k).0, &whole).powi(2);
        let mut next = beyond / size(intervals);
        let mut found = Vec::new();
        for k in (0..=intervals).rev() {
            let (slope, second) = slopes(piece, k);
            // At the end it is not about a next knot, but about what the next piece allows.
            let twice = if k == intervals { 0.0 } else { 2.0 * (at(k + 1) - at(k)) };
            let fits = |x: f64| {
                let (low, high) = range(&slope, &second, x);
                if k == intervals {
                    x <= next && low <= high
                } else {
                    low.max(-x / twice) <= high.min((next - x) / twice)
                }
            };
            let (mut good, mut bad) = (0.0, ceiling(&slope).min(1e12));
            if fits(bad) {
                good = bad;
            } else {
                for _ in 0..50 {
                    let middle = 0.5 * (good + bad);
                    if fits(middle) { good = middle } else { bad = middle }
                }
            }
            next = good;
            found.push(good);
        }
        found.reverse();
        beyond = if is_stop[i] { 0.0 } else { next * size(0) };
        most[i] = found;
    }
    let (mut duration, mut before) = (0.0, 0.0);
    for (i, piece) in pieces.iter().enumerate() {
        let size = |k: usize| norm(&slopes(piece, k).0, &whole).powi(2);
        let mut x = if is_stop[i] { 0.0 } else { f64::min(before / size(0), most[i][0]) };
        for k in 0..intervals {
            let (slope, second) = slopes(piece, k);
            let twice = 2.0 * (at(k + 1) - at(k));
            let rise = range(&slope, &second, x).1.min((most[i][k + 1] - x) / twice);
            let next = (x + twice * rise).max(0.0).min(most[i][k + 1]);
            duration += twice / (x.sqrt() + next.sqrt());
            x = next;
        }
        before = x * size(intervals);
    }
    duration
}

#[wasm_bindgen_test(unsupported = test)]
fn it_is_as_fast_as_a_dense_grid_finds() {
    for kind in [0, 1, 2, 3, 5, 6] {
        for seed in 0..cases(40) as u64 {
            let mut random = Random::new(seed, Stream::Shortcut);
            let (scenario, result, limits) = drawn(&mut random, kind, 0.03);
            let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
            let ratio = trajectory.duration() / dense(&trajectory, 600);
            assert!((0.99..1.005).contains(&ratio), "{kind} {seed}: {ratio}");
        }
    }
}

/// Paths, limits and durations by other programs: tests/timing.py. Where a derivative turns fast, the equal steps of toppra's grid
/// lose up to some hundredths.
#[wasm_bindgen_test(unsupported = test)]
fn it_is_as_fast_as_toppra_and_ruckig() {
    let fixtures: Json = serde_json::from_str(include_str!("timing.json")).expect("JSON");
    for (name, least, most) in [("blended", 0.9, 1.005), ("straight", 1.0 - 1e-6, 1.0 + 1e-6)] {
        for case in fixtures[name].as_array().expect("cases") {
            let numbers = |field: &str| -> Vec<f64> { serde_json::from_value(case[field].clone()).expect("numbers") };
            let path: Vec<Vec<f64>> = serde_json::from_value(case["path"].clone()).expect("a path");
            let blends: Option<Vec<[f64; 2]>> = serde_json::from_value(case["blends"].clone()).expect("blends");
            let links = json!(vec![1.0; path[0].len()]);
            let scenario = empty(&format!(r#"{{"type": "arm", "base": [0, 0], "links": {links}}}"#), path[0].len());
            let result = result(&path, blends.as_deref(), None);
            let [speed, acceleration] = [numbers("speed"), numbers("acceleration")];
            let limits = Limits::Coordinates(CoordinateLimits { speed, acceleration });
            let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
            let ratio = trajectory.duration() / case["duration"].as_f64().expect("seconds");
            assert!((least..most).contains(&ratio), "{name}, {} waypoints: {ratio}", path.len());
            assert!(verify(&scenario, &result, &trajectory).expect("they belong together").is_valid());
            if deep() {
                println!("{name}: {ratio}");
            }
        }
    }
}

/// A car, its path and its limits: forward round a corner, backward, and on in the same direction along another arc.
fn parked() -> (Scenario, ResultDocument, Limits) {
    let scenario = car();
    let Robot::Car(own) = scenario.robot() else { panic!("a car") };
    let (mut path, mut pose) = (vec![vec![0.0; 3]], [0.0; 3]);
    let controls = [(1.0, 0.0, 2.0), (1.0, 0.5, 0.3), (-0.5, 0.0, 1.0), (-0.5, -0.5, 0.5)];
    for (speed, steering, duration) in controls {
        pose = arc_pose(pose, speed, own.turn_rate(speed, steering), duration);
        path.push(pose.to_vec());
    }
    let motion =
        |(speed, steering, duration): (f64, f64, f64)| json!({"control": [speed, steering], "duration": duration});
    let result = result(&path, None, Some(controls.into_iter().map(motion).collect()));
    (scenario, result, Limits::Car(CarLimits { speed: 1.0, acceleration: 2.0, lateral_acceleration: Some(0.5) }))
}

#[wasm_bindgen_test(unsupported = test)]
fn a_car_rests_where_it_changes_its_direction_and_only_there() {
    let (scenario, result, limits) = parked();
    let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
    let begins: Vec<f64> = trajectory.pieces().iter().map(|piece| piece.knots()[0][1]).collect();
    assert_eq!(begins.iter().map(|rate| *rate == 0.0).collect::<Vec<_>>(), [true, false, true, false]);
    // Straight on at 1 m/s, down to the speed of the arc, and to rest; backward at the 0.5 m/s that the car can drive.
    let radius = 0.2 / libm::tan(0.5);
    let arc = (0.5 * radius).sqrt();
    let (along, last) = (2.0 - 0.25 - (1.0 - arc * arc) / 4.0, 0.3 - arc * arc / 4.0);
    let forward = 0.5 + along + (1.0 - arc) / 2.0 + last / arc + arc / 2.0;
    let slow = arc.min(0.5);
    let (back, end) = (0.5 - 0.0625 - (0.25 - slow * slow) / 4.0, 0.25 - slow * slow / 4.0);
    let backward = 0.25 + back / 0.5 + (0.5 - slow) / 2.0 + end / slow + slow / 2.0;
    assert!((trajectory.duration() - forward - backward).abs() < 1e-9, "{}", trajectory.duration());
}

#[wasm_bindgen_test(unsupported = test)]
fn corners_without_a_blend_are_rests_and_straight_lines_are_none() {
    let scenario = disc();
    let limits = |speed, acceleration| {
        Limits::Plane(PlaneLimits { speed, acceleration, turn_rate: None, turn_acceleration: None })
    };
    let duration = |path: &[[f64; 2]]| {
        let path: Vec<Vec<f64>> = path.iter().map(|q| q.to_vec()).collect();
        timing::time(&scenario, &result(&path, None, None), &limits(1.0, 2.0)).expect("a trajectory").duration()
    };
    // A metre: half a second to the greatest speed, half a second on it, half a second to rest.
    let metre = 1.5;
    assert!((duration(&[[0.0, 0.0], [1.0, 0.0]]) - metre).abs() < 1e-9);
    assert!((duration(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]) - 2.0 * metre).abs() < 1e-9);
    assert!((duration(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 1.0]]) - 2.0 * metre).abs() < 1e-9);
    assert!((duration(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]) - 2.0 * metre).abs() < 1e-9);
    assert!((duration(&[[0.0, 0.0], [0.3, 0.1], [3.0, 1.0]]) - (0.5 + libm::sqrt(10.0))).abs() < 1e-9);
    assert_eq!(duration(&[[0.5, 0.5]]), 0.0);
    assert_eq!(duration(&[[0.5, 0.5], [0.5, 0.5]]), 0.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn angles_go_on_where_they_pass_half_a_turn() {
    let scenario = arm();
    let path = [vec![3.0, 0.0, 0.0], vec![-3.0, 0.0, 0.0], vec![-1.0, 0.0, 0.0]];
    let limits = Limits::Coordinates(CoordinateLimits { speed: vec![1.0; 3], acceleration: vec![1.0; 3] });
    let trajectory = timing::time(&scenario, &result(&path, None, None), &limits).expect("a trajectory");
    let end = trajectory.configuration(trajectory.duration());
    assert!((end[0] - (2.0 * PI - 1.0)).abs() < 1e-12, "{end:?}");
    assert!((trajectory.duration() - (2.0 * PI - 4.0 + 1.0)).abs() < 1e-9, "{}", trajectory.duration());
}

#[wasm_bindgen_test(unsupported = test)]
fn samples_are_a_step_apart_and_the_last_is_the_end() {
    let (scenario, result, limits) = parked();
    let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
    let duration = trajectory.duration();
    for step in [0.01, 0.37, duration / 8.0, duration, 100.0, 1e12, f64::MAX] {
        let states: Vec<_> = trajectory.sampled(step).expect("states").collect();
        let count = libm::ceil(duration / step - 1e-9).max(1.0) as usize + 1;
        assert_eq!((states.len(), states[0].time, states[count - 1].time), (count, 0.0, duration));
        assert!(states.windows(2).all(|two| two[0].time < two[1].time && two[1].time - two[0].time < step * 1.000001));
        assert_eq!(states[count - 1], trajectory.state(f64::INFINITY));
    }
    refuses(trajectory.sampled(0.0).map(|_| ()), "out-of-range", "/step");
    refuses(trajectory.sampled(f64::NAN).map(|_| ()), "not-finite", "/step");
}

#[wasm_bindgen_test(unsupported = test)]
fn documents_read_back_as_they_are_and_no_others_are_read() {
    for kind in 0..7 {
        let (scenario, result, limits) = drawn(&mut Random::new(5, Stream::Samples), kind, 0.1);
        let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
        assert_eq!(Trajectory::parse(&trajectory.to_json(), &scenario), Ok(trajectory), "{kind}");
    }
    let (scenario, result, limits) = parked();
    let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
    let document: Json = serde_json::from_str(&trajectory.to_json()).expect("JSON");
    let refused = |place: &str, value: Json, code: &str, pointer: &str| {
        let mut changed = document.clone();
        *changed.pointer_mut(place).unwrap_or_else(|| panic!("{place}")) = value;
        refuses(Trajectory::parse(&changed.to_string(), &scenario), code, pointer);
    };
    refused("/format", json!("planarium-result-1"), "unknown-format", "/format");
    refused("/scenario", json!("another"), "invalid-result", "/scenario");
    refused("/query", json!("another"), "unknown-query", "/query");
    refused("/duration", json!(1.0), "invalid-result", "/duration");
    refused("/start", json!([0.0, 0.0]), "wrong-dimension", "/start");
    refused("/start", json!([0.0, 1e-3, 0.0]), "invalid-result", "/pieces/0");
    refused("/limits/speed", json!(0.99), "invalid-result", "/pieces");
    refused("/limits/acceleration", json!(1.99), "invalid-result", "/pieces");
    refused("/limits/lateral_acceleration", json!(0.49), "invalid-result", "/pieces");
    refused("/limits/speed", json!(0.0), "out-of-range", "/limits/speed");
    refused("/pieces/1/type", json!("spiral"), "unknown-type", "/pieces/1/type");
    refused("/pieces/1/turn", json!(0.1), "invalid-result", "/pieces/2");
    refused("/pieces/0/knots", json!([]), "invalid-result", "/pieces/0/knots");
    refused("/pieces/0/knots/1/0", json!(-0.5), "invalid-result", "/pieces/0/knots");
    refused("/pieces/0/knots/1/1", json!(0.4), "invalid-result", "/pieces/0/knots");
    refused("/pieces/3/knots", json!([[0, 1, 0], [1, 1, 0]]), "invalid-result", "/pieces/3");
    let mut straight = document["pieces"][0].clone();
    straight["type"] = json!("straight");
    straight["rate"] = json!([1, 0, 0]);
    ["length", "turn"].iter().for_each(|field| drop(straight.as_object_mut().expect("a piece").remove(*field)));
    refused("/pieces/0", straight, "unsupported", "/pieces/0/type");
}

/// The same limits with this speed and this acceleration everywhere.
fn with_size(limits: &Limits, [speed, acceleration]: [f64; 2]) -> Limits {
    match limits {
        Limits::Coordinates(limits) => Limits::Coordinates(CoordinateLimits {
            speed: vec![speed; limits.speed.len()],
            acceleration: vec![acceleration; limits.speed.len()],
        }),
        Limits::Plane(limits) => Limits::Plane(PlaneLimits {
            speed,
            acceleration,
            turn_rate: limits.turn_rate.map(|_| speed),
            turn_acceleration: limits.turn_rate.map(|_| acceleration),
        }),
        _ => Limits::Car(CarLimits { speed, acceleration, lateral_acceleration: Some(acceleration) }),
    }
}

/// From the least limits to the greatest ones, and where a speed is reached at once.
#[wasm_bindgen_test(unsupported = test)]
fn limits_of_any_size_are_kept() {
    let sizes = [1e-6, 1.0, 1e7, 1e9];
    let pairs = sizes.iter().flat_map(|&speed| sizes.map(|acceleration| [speed, acceleration]));
    for ([speed, acceleration], kind) in pairs.flat_map(|pair| (0..7).map(move |kind| (pair, kind))) {
        for seed in 0..cases(8) as u64 {
            let (scenario, result, limits) = drawn(&mut Random::new(seed, Stream::Samples), kind, 1e-3);
            let limits = with_size(&limits, [speed, acceleration]);
            let what = format!("kind {kind}, seed {seed}, speed {speed}, acceleration {acceleration}");
            let trajectory = timing::time(&scenario, &result, &limits).unwrap_or_else(|e| panic!("{what}: {e}"));
            assert_eq!(Trajectory::parse(&trajectory.to_json(), &scenario).as_ref(), Ok(&trajectory), "{what}");
            let verdict = verify(&scenario, &result, &trajectory).expect("they belong together");
            assert!(verdict.is_valid(), "{what}: {verdict:?}");
            let times: Vec<f64> = trajectory.rows(0.1).expect("rows").iter().map(|state| state.time).collect();
            assert!(times.windows(2).all(|pair| pair[1] - pair[0] > 1e-12 * pair[1]), "{what}: {times:?}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_fit_the_robot() {
    let (car, driven, along) = parked();
    let each = |n: usize| Limits::Coordinates(CoordinateLimits { speed: vec![1.0; n], acceleration: vec![1.0; n] });
    let plane = |turn_rate, turn_acceleration| {
        Limits::Plane(PlaneLimits { speed: 1.0, acceleration: 1.0, turn_rate, turn_acceleration })
    };
    let refused = |scenario: &Scenario, limits: &Limits, code: &str, pointer: &str| {
        refuses(limits.check(scenario.robot()), code, pointer);
    };
    refused(&car, &each(3), "unsupported", "/limits");
    refused(&arm(), &along, "unsupported", "/limits");
    refused(&arm(), &plane(None, None), "unsupported", "/limits");
    refused(&arm(), &each(2), "wrong-dimension", "/limits/speed");
    refused(&disc(), &plane(Some(1.0), None), "unsupported", "/limits/turn_rate");
    refused(&body(), &plane(Some(1.0), None), "missing-field", "/limits/turn_acceleration");
    refused(&body(), &plane(Some(f64::NAN), Some(1.0)), "not-finite", "/limits/turn_rate");
    refused(&body(), &plane(Some(1.0), Some(0.0)), "out-of-range", "/limits/turn_acceleration");
    let mut unsolved = driven.clone();
    unsolved.status = planarium::run::Status::Exhausted;
    refuses(timing::time(&car, &unsolved, &along), "invalid-result", "/status");
    refuses(
        timing::time(&car, &ResultDocument { motions: None, ..driven.clone() }, &along),
        "invalid-result",
        "/motions",
    );
    refuses(
        timing::time(&car, &ResultDocument { path: vec![vec![0.0]], ..driven }, &along),
        "invalid-result",
        "/path/0",
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_by_their_names_are_those_of_the_robot() {
    let options = |speed: &[f64], acceleration: &[f64]| LimitOptions {
        speed: speed.to_vec(),
        acceleration: acceleration.to_vec(),
        ..LimitOptions::default()
    };
    let one = options(&[1.0], &[2.0]);
    let of = |options: &LimitOptions, scenario: &Scenario| options.limits(scenario.robot()).expect("limits");
    let each = |n: usize| Limits::Coordinates(CoordinateLimits { speed: vec![1.0; n], acceleration: vec![2.0; n] });
    assert_eq!([of(&one, &arm()), of(&one, &sliding_arm())], [each(3), each(4)]);
    assert_eq!(of(&options(&[1.0; 3], &[2.0]), &body()), each(3), "a list for one, a number for the other");
    let plane = |turn_rate, turn_acceleration| {
        Limits::Plane(PlaneLimits { speed: 1.0, acceleration: 2.0, turn_rate, turn_acceleration })
    };
    assert_eq!(of(&one, &disc()), plane(None, None));
    let turning = LimitOptions { turn_rate: Some(3.0), turn_acceleration: Some(4.0), ..one.clone() };
    assert_eq!(of(&turning, &body()), plane(Some(3.0), Some(4.0)));
    let across = LimitOptions { lateral_acceleration: Some(0.5), ..one.clone() };
    let driven = CarLimits { speed: 1.0, acceleration: 2.0, lateral_acceleration: Some(0.5) };
    assert_eq!(of(&across, &car()), Limits::Car(driven));
    let listed = LimitOptions { turn_rate: Some(3.0), ..options(&[1.0; 3], &[2.0; 3]) };
    for (scenario, options, code, pointer) in [
        (body(), &one, "missing-field", "/limits/turn_rate"),
        (disc(), &turning, "unsupported", "/limits/turn_rate"),
        (body(), &listed, "unsupported", "/limits/turn_rate"),
        (car(), &turning, "unsupported", "/limits/turn_rate"),
        (arm(), &turning, "unsupported", "/limits/turn_rate"),
        (arm(), &across, "unsupported", "/limits/lateral_acceleration"),
        (body(), &across, "unsupported", "/limits/lateral_acceleration"),
        (car(), &options(&[1.0; 3], &[2.0; 3]), "unsupported", "/limits"),
        (arm(), &options(&[1.0; 2], &[2.0]), "wrong-dimension", "/limits/speed"),
        (arm(), &LimitOptions::default(), "wrong-dimension", "/limits/speed"),
        (disc(), &options(&[0.0], &[2.0]), "out-of-range", "/limits/speed"),
    ] {
        refuses(options.limits(scenario.robot()), code, pointer);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_document_with_other_pieces_is_a_verdict_and_rests_are_counted() {
    let (scenario, result, limits) = parked();
    let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
    let mut document: Json = serde_json::from_str(&trajectory.to_json()).expect("JSON");
    let judged = |document: &Json| timing::verify_document(&scenario, &result, document);
    match judged(&document) {
        Ok(Verdict::Valid { duration, .. }) => assert_eq!(duration, trajectory.duration()),
        other => panic!("{other:?}"),
    }
    document["limits"]["speed"] = json!(0.99);
    assert!(matches!(judged(&document), Ok(Verdict::Invalid { .. })));
    document["scenario"] = json!("another");
    refuses(judged(&document), "invalid-result", "/scenario");
    let resting = trajectory.pieces().iter().skip(1).filter(|piece| piece.knots()[0][1] == 0.0).count();
    assert_eq!(trajectory.rests(), resting);
    assert!(resting > 0, "it drives backward, too");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_speed_of_a_tip_is_how_fast_it_gets_on() {
    for kind in 0..2 {
        let (scenario, result, limits) = drawn(&mut Random::new(7, Stream::Samples), kind, 0.1);
        let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
        let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
        for i in 1..20 {
            let state = trajectory.state(trajectory.duration() * f64::from(i) / 20.0);
            let tip = |sign: f64| {
                let moved = state.configuration.iter().zip(&state.velocity).map(|(q, rate)| q + sign * 1e-6 * rate);
                arm.end_effector(&moved.collect::<Vec<f64>>())
            };
            let found = (tip(1.0) - tip(-1.0)).norm() / 2e-6;
            let speed = planarium::ik::tip_speed(arm, &state.configuration, &state.velocity);
            assert!((speed - found).abs() < 1e-6 * (1.0 + speed), "{kind}: {speed}, {found}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_verifier_refuses_a_trajectory_along_another_path() {
    for kind in 0..5 {
        let (scenario, result, limits) = drawn(&mut Random::new(3, Stream::Samples), kind, 0.1);
        let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
        let judged = |result: &ResultDocument| verify(&scenario, result, &trajectory).expect("they belong together");
        assert!(judged(&result).is_valid());
        let mut moved = result.clone();
        moved.path[1][0] += 1e-6;
        if let Some(motion) = moved.motions.as_mut().and_then(|motions| motions.first_mut()) {
            motion.duration += 1e-6;
        }
        assert!(!judged(&moved).is_valid(), "{kind}: a waypoint is elsewhere");
        let mut longer = result.clone();
        longer.path.push(vec![0.123; scenario.robot().dimension()]);
        if let Some(motions) = &mut longer.motions {
            motions.extend(motions.first().copied());
        }
        longer.blends.iter_mut().for_each(|blends| blends.push([0.1, 0.1]));
        assert!(!judged(&longer).is_valid(), "{kind}: the path goes on");
        let other = ResultDocument { query: "other".to_owned(), ..result.clone() };
        refuses(verify(&scenario, &other, &trajectory), "invalid-result", "/query");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn trajectories_have_their_golden_bits() {
    check("golden-timing.json", include_str!("golden-timing.json"), 14, |case| {
        let number = |name: &str| case[name].as_u64().expect("a number");
        let mut random = Random::new(number("seed"), Stream::Samples);
        let (scenario, result, limits) = drawn(&mut random, number("kind") as usize, 0.02);
        let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
        let mut fingerprint = Fingerprint::default();
        fingerprint.bytes(trajectory.to_json().as_bytes());
        let states = [0.3, 0.8].map(|share| trajectory.state(share * trajectory.duration()));
        // What was drawn is there for the tests of the package, which draw nothing.
        json!({
            "scenario": scenario, "result": result, "limits": limits, "states": states,
            "duration": trajectory.duration(), "fingerprint": format!("{:016x}", fingerprint.value()),
        })
    });
}

/// The distance of a configuration from the straight line between two others.
fn beside(q: &[f64], a: &[f64], b: &[f64]) -> f64 {
    let along: Vec<f64> = a.iter().zip(b).map(|(a, b)| b - a).collect();
    let length_squared: f64 = along.iter().map(|d| d * d).sum();
    let dot: f64 = (0..q.len()).map(|k| (q[k] - a[k]) * along[k]).sum();
    let t = if length_squared > 0.0 { (dot / length_squared).clamp(0.0, 1.0) } else { 0.0 };
    (0..q.len()).map(|k| (q[k] - a[k] - t * along[k]).powi(2)).sum::<f64>().sqrt()
}

/// Rows of a path have its corners and bring chords as near as is asked for; those of a trajectory have their times.
#[wasm_bindgen_test(unsupported = test)]
fn rows_are_the_path_and_chords_are_near() {
    for case in 0..cases(40) {
        let mut random = Random::new(case as u64, Stream::Scenario);
        let (scenario, result, limits) = drawn(&mut random, case % 7, 1e-3);
        let circles: Vec<bool> = match scenario.robot() {
            Robot::Arm(arm) => arm.joint_types().iter().map(|joint| joint.range().is_none()).collect(),
            Robot::Disc(_) => vec![false; 2],
            _ => vec![false, false, true],
        };
        let off = |a: &[f64], b: &[f64]| {
            let turned = |k: usize| if circles[k] { planarium::geometry::wrap(a[k] - b[k]) } else { a[k] - b[k] };
            (0..a.len()).map(|k| turned(k).abs()).fold(0.0, f64::max)
        };
        for deviation in [1e-2, 1e-4] {
            let rows = timing::rows(&scenario, &result, deviation).expect("rows");
            // Every waypoint in its order, and only straight robots have no others.
            let mut next = result.path.iter().peekable();
            for row in &rows {
                while next.next_if(|waypoint| off(row, waypoint) < 1e-12).is_some() {}
            }
            assert_eq!(next.count(), 0, "case {case}");
            let is_car = matches!(scenario.robot(), Robot::Car(_));
            assert!(is_car || rows.len() <= result.path.len(), "case {case}");
            // Angles are continuous.
            let steps = rows.windows(2).flat_map(|pair| (0..pair[0].len()).map(|k| (k, pair[1][k] - pair[0][k])));
            assert!(steps.into_iter().all(|(k, step)| !circles[k] || step.abs() <= PI + 1e-9), "case {case}");
            let trajectory = timing::time(&scenario, &result, &limits).expect("a trajectory");
            let states = trajectory.rows(deviation).expect("states");
            assert_eq!(states[states.len() - 1], trajectory.state(trajectory.duration()));
            for state in &states {
                let at = trajectory.state(state.time);
                assert!(off(&at.configuration, &state.configuration) < 1e-9, "case {case}: {at:?} {state:?}");
            }
            let most = deviation + 1e-9;
            for pair in states.windows(2) {
                let (begin, lasting) = (pair[0].time, pair[1].time - pair[0].time);
                assert!(lasting > 0.0, "case {case}: {pair:?}");
                for share in [0.25, 0.5, 0.75] {
                    let at = trajectory.configuration(begin + share * lasting);
                    let off = beside(&at, &pair[0].configuration, &pair[1].configuration);
                    assert!(off <= most, "case {case}: {off} > {deviation}");
                }
            }
            // Without times the arcs of a car are as near.
            for state in trajectory.sampled(0.02 * trajectory.duration()).expect("states").filter(|_| is_car) {
                let off = |pair: &[Vec<f64>]| beside(&state.configuration, &pair[0], &pair[1]);
                let nearest = rows.windows(2).map(off).fold(f64::INFINITY, f64::min);
                assert!(nearest <= most, "case {case}: {nearest} > {deviation}");
            }
        }
    }
    for (deviation, code) in [(0.0, "out-of-range"), (f64::NAN, "not-finite"), (2e6, "out-of-range")] {
        let result = result(&[vec![0.0; 2], vec![1.0; 2]], None, None);
        let error = timing::rows(&disc(), &result, deviation).expect_err("it is refused");
        assert_eq!((error.code().as_str(), error.pointer()), (code, "/deviation"));
    }
    // One configuration is one row.
    assert_eq!(timing::rows(&disc(), &result(&[vec![0.5; 2]], None, None), 1e-3).expect("a row"), [[0.5; 2]]);
}
