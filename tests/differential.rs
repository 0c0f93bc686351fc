//! Differential drives: discs that drive straight edges forward and turn on the spot at corners. Durations are those of trapezoids,
//! limits hold, the robot never moves sideways, and other documents are refused.

use crate::common::cases;
use crate::common::documents::refuses;
use crate::timing::{arm, between, body, corners, disc, result};
use planarium::path::ResultDocument;
use planarium::random::{Random, Stream};
use planarium::timing::{
    self, DifferentialLimits, LimitOptions, Limits, PlaneLimits, Trajectory, Verdict, verify, verify_document,
};
use serde_json::{Value as Json, json};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// Speed, acceleration, turn rate and acceleration of turns.
fn limits([speed, acceleration, turn_rate, turn_acceleration]: [f64; 4]) -> Limits {
    Limits::Differential(DifferentialLimits { speed, acceleration, turn_rate, turn_acceleration })
}

const USUAL: [f64; 4] = [1.0, 2.0, 2.0, 4.0];

fn timed(path: &[[f64; 2]], own: [f64; 4]) -> Trajectory {
    let path: Vec<Vec<f64>> = path.iter().map(|q| q.to_vec()).collect();
    timing::time(&disc(), &result(&path, None, None), &limits(own)).expect("a trajectory")
}

/// The least time from rest to rest along a distance.
fn trapezoid(distance: f64, speed: f64, acceleration: f64) -> f64 {
    if distance * acceleration >= speed * speed {
        distance / speed + speed / acceleration
    } else {
        2.0 * (distance / acceleration).sqrt()
    }
}

/// Two metres and a metre with a right angle in between.
const CORNER: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]];

#[wasm_bindgen_test(unsupported = test)]
fn a_right_angle_takes_two_edges_and_a_turn() {
    // 2.5 s and 1.5 s for the edges; pi / 2 at 2 rad/s, with half a second to speed up and to slow down.
    let trajectory = timed(&CORNER, USUAL);
    let turn = 0.25 * PI + 0.5;
    assert!((trajectory.duration() - (2.5 + turn + 1.5)).abs() < 1e-9, "{}", trajectory.duration());
    assert_eq!((trajectory.dimension(), trajectory.pieces().len(), trajectory.rests()), (3, 3, 2));
    for (time, place, velocity) in [
        (0.0, [0.0, 0.0, 0.0], [0.0; 3]),
        (1.25, [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        (2.5 + 0.25, [2.0, 0.0, 0.125], [0.0, 0.0, 1.0]),
        (2.5 + 0.5 * turn, [2.0, 0.0, 0.25 * PI], [0.0, 0.0, 2.0]),
        (3.25 + turn, [2.0, 0.5, FRAC_PI_2], [0.0, 1.0, 0.0]),
        (4.0 + turn, [2.0, 1.0, FRAC_PI_2], [0.0; 3]),
    ] {
        let state = trajectory.state(time);
        for k in 0..3 {
            assert!((state.configuration[k] - place[k]).abs() < 1e-9, "{time}: {state:?}");
            assert!((state.velocity[k] - velocity[k]).abs() < 1e-9, "{time}: {state:?}");
        }
    }
    // So fast that it speeds up for half the turn.
    let fast = timed(&CORNER, [1.0, 2.0, 100.0, 4.0]);
    assert!((fast.duration() - (4.0 + 2.0 * (PI / 8.0).sqrt())).abs() < 1e-9, "{}", fast.duration());
}

#[wasm_bindgen_test(unsupported = test)]
fn turns_go_the_short_way_and_straight_lines_have_none() {
    let heading = |trajectory: &Trajectory| trajectory.configuration(trajectory.duration())[2];
    // From 135 degrees to 225, not back to -135.
    let past = timed(&[[0.0, 0.0], [-1.0, 1.0], [-2.0, 0.0]], USUAL);
    assert!((heading(&past) - 1.25 * PI).abs() < 1e-12);
    let edge = trapezoid(2.0_f64.sqrt(), 1.0, 2.0);
    assert!((past.duration() - (2.0 * edge + trapezoid(FRAC_PI_2, 2.0, 4.0))).abs() < 1e-9);
    let back = timed(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]], USUAL);
    assert!((heading(&back).abs() - PI).abs() < 1e-12);
    assert!((back.duration() - (3.0 + trapezoid(PI, 2.0, 4.0))).abs() < 1e-9);
    // Four left turns are one whole turn.
    let round = timed(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]], USUAL);
    assert!((heading(&round) - TAU).abs() < 1e-12);
    let straight = timed(&[[0.0, 0.0], [0.3, 0.1], [0.3, 0.1], [3.0, 1.0]], USUAL);
    assert!((straight.duration() - (0.5 + 10.0_f64.sqrt())).abs() < 1e-9);
    assert_eq!(straight.rests(), 0);
    assert!((straight.configuration(0.0)[2] - libm::atan2(1.0, 3.0)).abs() < 1e-15);
    let rest = timed(&[[0.5, 0.25], [0.5, 0.25]], USUAL);
    assert_eq!((rest.duration(), rest.configuration(1.0)), (0.0, vec![0.5, 0.25, 0.0]));
}

/// A random path, the same without its blends, and random limits.
fn drawn(seed: u64) -> (ResultDocument, [f64; 4]) {
    let mut random = Random::new(seed, Stream::Samples);
    let own = [(); 4].map(|()| libm::exp(between(&mut random, -2.0, 2.0)));
    (corners(&mut random, disc().robot(), 1e-3), own)
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_hold_at_every_time_and_it_never_moves_sideways() {
    let scenario = disc();
    for seed in 0..cases(200) as u64 {
        let (result, own) = drawn(seed);
        let trajectory = timing::time(&scenario, &result, &limits(own)).unwrap_or_else(|e| panic!("{seed}: {e}"));
        // Each edge and each turn by itself takes as long as its trapezoid.
        let steps = result.path.windows(2).map(|pair| [0, 1].map(|k| pair[1][k] - pair[0][k]));
        let steps: Vec<[f64; 2]> = steps.collect();
        let edges = steps.iter().map(|[x, y]| trapezoid(x.hypot(*y), own[0], own[1])).sum::<f64>();
        let turn = |[a, b]: [[f64; 2]; 2]| (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]).abs();
        let turns = steps.windows(2).map(|pair| trapezoid(turn([pair[0], pair[1]]), own[2], own[3])).sum::<f64>();
        let duration = trajectory.duration();
        assert!((duration / (edges + turns) - 1.0).abs() < 1e-6, "{seed}: {duration}, not {edges} and {turns}");
        for i in 0..=1000 {
            let state = trajectory.state(duration * f64::from(i) / 1000.0);
            let (sin, cos) = state.configuration[2].sin_cos();
            let [along, across] =
                [state.velocity[0] * cos + state.velocity[1] * sin, state.velocity[1] * cos - state.velocity[0] * sin];
            let rise = state.acceleration[0].hypot(state.acceleration[1]);
            let shares = [along / own[0], rise / own[1], state.velocity[2].abs() / own[2]];
            assert!(shares.iter().all(|share| *share < 1.0 + 1e-9), "{seed}: {shares:?}");
            assert!(state.acceleration[2].abs() < own[3] * (1.0 + 1e-9), "{seed}: {state:?}");
            assert!(across.abs() <= 1e-12 * own[0] && along >= 0.0, "{seed}: it moves sideways: {state:?}");
            assert!(along == 0.0 || state.velocity[2] == 0.0, "{seed}: it turns as it drives");
            let from_edge = |pair: &[Vec<f64>]| {
                let [x, y] = [0, 1].map(|k| pair[1][k] - pair[0][k]);
                let [a, b] = [0, 1].map(|k| state.configuration[k] - pair[0][k]);
                let t = ((a * x + b * y) / (x * x + y * y)).clamp(0.0, 1.0);
                (a - t * x).hypot(b - t * y)
            };
            let off = result.path.windows(2).map(from_edge).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-12, "{seed}: {off} from the path");
        }
        assert_eq!(Trajectory::parse(&trajectory.to_json(), &scenario).as_ref(), Ok(&trajectory), "{seed}");
        match verify(&scenario, &result, &trajectory).expect("they belong together") {
            Verdict::Invalid { why } => panic!("{seed}: {why}"),
            Verdict::Valid { speed, acceleration, .. } => {
                assert!(speed.max(acceleration) > 1.0 - 1e-6, "{seed}: no limit is reached");
            }
        }
        let rows = trajectory.rows(1e-3).expect("rows");
        assert!(rows.iter().all(|row| row.configuration.len() == 3 && row.velocity.len() == 3));
        // The path is of discs alone; without its blends it takes as long.
        let sharp = ResultDocument { blends: None, ..result.clone() };
        assert_eq!(timing::time(&scenario, &sharp, &limits(own)).expect("a trajectory"), trajectory);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_of_any_size_are_kept() {
    let scenario = disc();
    let sizes = [1e-6, 1.0, 1e9];
    for seed in 0..cases(12) as u64 {
        let (result, _) = drawn(seed);
        for own in sizes.iter().flat_map(|a| sizes.iter().flat_map(move |b| [[*a, *b, 1.0, 1.0], [1.0, 1.0, *a, *b]])) {
            let trajectory = timing::time(&scenario, &result, &limits(own)).unwrap_or_else(|e| panic!("{own:?}: {e}"));
            assert_eq!(Trajectory::parse(&trajectory.to_json(), &scenario).as_ref(), Ok(&trajectory), "{own:?}");
            let verdict = verify(&scenario, &result, &trajectory).expect("they belong together");
            assert!(verdict.is_valid(), "{seed}, {own:?}: {verdict:?}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn other_documents_are_refused() {
    let scenario = disc();
    let document: Json = serde_json::from_str(&timed(&CORNER, USUAL).to_json()).expect("JSON");
    assert_eq!(document["limits"]["type"], json!("differential"));
    let refused = |place: &str, value: Json, code: &str, pointer: &str| {
        let mut changed = document.clone();
        *changed.pointer_mut(place).unwrap_or_else(|| panic!("{place}")) = value;
        refuses(Trajectory::parse(&changed.to_string(), &scenario), code, pointer);
    };
    // Sideways, backward, on an arc; a turn that drifts, and one by nothing.
    refused("/pieces/0/from/2", json!(1e-6), "invalid-result", "/pieces/0");
    refused("/pieces/0/from/2", json!(PI), "invalid-result", "/pieces/0");
    refused("/pieces/0/rate/1", json!(0.1), "invalid-result", "/pieces/0");
    refused("/pieces/2/rate/2", json!(0.1), "invalid-result", "/pieces/2");
    refused("/pieces/1/rate/0", json!(1e-3), "invalid-result", "/pieces/1");
    refused("/pieces/1/rate/2", json!(0.0), "invalid-result", "/pieces/1");
    // Another turn, so that the next edge begins with another heading.
    refused("/pieces/1/rate/2", json!(1.0), "invalid-result", "/pieces/2");
    refused("/start", json!([0.0, 0.0]), "wrong-dimension", "/start");
    refused("/start/2", json!(1.0), "invalid-result", "/pieces/0");
    refused("/pieces/1/from", json!([2.0, 0.0]), "wrong-dimension", "/pieces/1/from");
    refused("/duration", json!(6.0), "invalid-result", "/duration");
    for (limit, least) in [("speed", 0.99), ("acceleration", 1.99), ("turn_rate", 1.99), ("turn_acceleration", 3.99)] {
        refused(&format!("/limits/{limit}"), json!(least), "invalid-result", "/pieces");
        refused(&format!("/limits/{limit}"), json!(0.0), "out-of-range", &format!("/limits/{limit}"));
    }
    refused("/limits", json!({"type": "differential", "speed": 1}), "missing-field", "/limits/acceleration");
    refused("/limits", json!({"type": "plane", "speed": 1, "acceleration": 2}), "wrong-dimension", "/start");
    let mut arc = document.clone();
    arc["pieces"][2] =
        json!({"type": "arc", "from": [2, 0, FRAC_PI_2], "length": 1, "turn": 0, "knots": arc["pieces"][2]["knots"]});
    refuses(Trajectory::parse(&arc.to_string(), &scenario), "unsupported", "/pieces/2/type");
    let mut blend = document.clone();
    blend["pieces"][0]["type"] = json!("parabola");
    blend["pieces"][0]["bend"] = json!([0, 0, 0]);
    refuses(Trajectory::parse(&blend.to_string(), &scenario), "unsupported", "/pieces/0/type");
}

/// A turn about a place in 2 s.
fn spin(place: [f64; 2], from: f64, turn: f64) -> Json {
    json!({"type": "straight", "from": [place[0], place[1], from], "rate": [0, 0, turn], "knots": [[0, 0, 1], [0.5, 1, -1], [1, 0, 0]]})
}

#[wasm_bindgen_test(unsupported = test)]
fn the_verifier_refuses_what_does_not_follow_the_path() {
    let scenario = disc();
    let path: Vec<Vec<f64>> = CORNER.iter().map(|q| q.to_vec()).collect();
    let followed = result(&path, None, None);
    let trajectory = timing::time(&scenario, &followed, &limits([1.0, 2.0, 9.0, 9.0])).expect("a trajectory");
    let judged = |result: &ResultDocument| verify(&scenario, result, &trajectory).expect("they belong together");
    assert!(judged(&followed).is_valid());
    for change in [[0, 0], [1, 0], [1, 1], [2, 1]] {
        let mut moved = followed.clone();
        moved.path[change[0]][change[1]] += 1e-6;
        assert!(!judged(&moved).is_valid(), "{change:?}");
    }
    let mut longer = followed.clone();
    longer.path.push(vec![3.0, 1.0]);
    assert!(!judged(&longer).is_valid());
    // Trajectories in themselves, whose turns are none of the path.
    let document: Json = serde_json::from_str(&trajectory.to_json()).expect("JSON");
    let turning = document["duration"].as_f64().expect("seconds");
    let short = 2.0 * (FRAC_PI_2 / 9.0).sqrt();
    let with = |pieces: Vec<Json>, duration: f64| {
        let mut changed = document.clone();
        changed["start"] = pieces[0]["from"].clone();
        changed["pieces"] = json!(pieces);
        changed["duration"] = json!(duration);
        assert!(Trajectory::read(&changed, &scenario).is_ok(), "{:?}", Trajectory::read(&changed, &scenario));
        verify_document(&scenario, &followed, &changed).expect("they belong together")
    };
    let [first, corner, second] = [0, 1, 2].map(|i| document["pieces"][i].clone());
    let edges = turning - short;
    assert!(with(vec![first.clone(), corner.clone(), second.clone()], turning).is_valid());
    assert!(with(vec![first.clone(), spin([2.0, 0.0], 0.0, FRAC_PI_2), second.clone()], edges + 2.0).is_valid());
    let mut turned = second.clone();
    turned["from"][2] = json!(FRAC_PI_2 - TAU);
    let halves = [0.0, 1.0].map(|k| spin([2.0, 0.0], 0.5 * k * FRAC_PI_2, 0.5 * FRAC_PI_2));
    let begun = vec![spin([0.0; 2], -1.0, 1.0), first.clone(), corner.clone(), second.clone()];
    let ended = vec![first.clone(), corner.clone(), second.clone(), spin([2.0, 1.0], FRAC_PI_2, 1.0)];
    for (why, pieces, duration) in [
        ("half a turn", vec![first.clone(), spin([2.0, 0.0], 0.0, FRAC_PI_2 - TAU), turned], edges + 2.0),
        ("no corner", vec![first.clone(), halves[0].clone(), halves[1].clone(), second.clone()], edges + 4.0),
        ("no corner", begun, turning + 2.0),
        ("at the end", ended, turning + 2.0),
        ("to its end", vec![first.clone()], 2.5),
    ] {
        match with(pieces, duration) {
            Verdict::Invalid { why: found } => assert!(found.contains(why), "{found}, not {why}"),
            valid => panic!("{why}: {valid:?}"),
        }
    }
    let mut sideways = document.clone();
    sideways["pieces"][0]["from"][2] = json!(0.5);
    assert!(!verify_document(&scenario, &followed, &sideways).expect("they belong together").is_valid());
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_by_their_names_are_those_of_a_disc_that_drives() {
    let one = LimitOptions {
        speed: vec![1.0],
        acceleration: vec![2.0],
        turn_rate: Some(2.0),
        turn_acceleration: Some(4.0),
        differential: true,
        ..LimitOptions::default()
    };
    assert_eq!(one.limits(disc().robot()), Ok(limits(USUAL)));
    let lacking = LimitOptions { turn_rate: None, ..one.clone() };
    let listed = LimitOptions { speed: vec![1.0, 1.0], ..one.clone() };
    let across = LimitOptions { lateral_acceleration: Some(1.0), ..one.clone() };
    let huge = LimitOptions { turn_acceleration: Some(1e10), ..one.clone() };
    for (scenario, options, code, pointer) in [
        (disc(), &lacking, "missing-field", "/limits/turn_rate"),
        (disc(), &listed, "wrong-dimension", "/limits/speed"),
        (disc(), &across, "unsupported", "/limits/lateral_acceleration"),
        (disc(), &huge, "out-of-range", "/limits/turn_acceleration"),
        (body(), &one, "unsupported", "/limits/differential"),
        (arm(), &one, "unsupported", "/limits/differential"),
    ] {
        refuses(options.limits(scenario.robot()), code, pointer);
    }
    refuses(limits(USUAL).check(body().robot()), "unsupported", "/limits");
    let plane = PlaneLimits { speed: 1.0, acceleration: 2.0, turn_rate: Some(2.0), turn_acceleration: Some(4.0) };
    refuses(Limits::Plane(plane).check(disc().robot()), "unsupported", "/limits/turn_rate");
}
