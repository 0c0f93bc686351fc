//! Navigation: what a document may contain; what rays measure; arcs that another check finds free; training that is the same on several
//! threads and on every platform; edges that are driven reliably; and how the shipped policy does.

use crate::common::documents::refuses;
use crate::common::{given, golden};
use planarium::Error;
use planarium::geometry::{Point, Segment};
use planarium::navigation::{
    Comparison, ComparisonOptions, Executor, Navigation, NavigationResult, Outcome, Policy, Training, TrainingOptions,
    assess, edge_rollouts, generate, read_options,
};
use planarium::options::Options;
use planarium::problem::{Status, Stepped};
use planarium::robot::Part;
use planarium::run::{Request, Run};
use planarium::scenario::Obstacle;
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

/// A training that takes a moment.
pub const SMALL: &str = "generations=3 pairs=4 tasks=4 floors=3 hidden=4";

fn task() -> Value {
    json!({
        "format": "planarium-navigation-1", "name": "hall",
        "world": { "bounds": { "min": [0, 0], "max": [10, 4] },
                   "obstacles": [ { "type": "disc", "center": [5, 2], "radius": 0.5 },
                                  { "type": "polygon", "vertices": [[7, 0], [7.2, 0], [7.2, 1], [7, 1]] } ] },
        "robot": { "type": "differential_drive", "shape": { "type": "disc", "radius": 0.25 }, "speed": [0, 1], "turn_rate": [-1.5, 1.5] },
        "queries": [ { "name": "through", "start": [1, 2, 0], "goal": [9, 2] } ]
    })
}

pub fn hall() -> Navigation {
    Navigation::read(&task()).expect("a task")
}

pub fn shipped() -> Policy {
    Policy::parse(include_str!("../www/prm-rl/policy.json")).expect("our own policy is right")
}

fn small() -> TrainingOptions {
    TrainingOptions::read(&given(SMALL)).expect("options of a training")
}

fn compare(task: &Navigation, settings: &str, seed: u64) -> Result<Comparison, Error> {
    Comparison::new(task, &shipped(), &ComparisonOptions::read(&given(settings))?, seed)
}

/// As the page and the command line begin it.
pub fn start(task: &Navigation, policy: &Policy, request: &Request) -> Result<Box<dyn Run>, Error> {
    let (rollouts, options) = read_options(request)?;
    planarium::navigation::start(task, policy, &rollouts, &options)
}

fn navigate(task: &Navigation, policy: &Policy, request: &Request, trials: u64) -> NavigationResult {
    let (rollouts, options) = read_options(request).expect("options");
    planarium::navigation::navigate(task, policy, &rollouts, &options, trials).expect("a result")
}

pub fn options(settings: &str) -> Request {
    Request { parameters: given(settings), seed: 1, ..Request::default() }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_document_is_read_and_written_again() {
    let task = hall();
    assert_eq!((task.name(), task.goal_tolerance(), task.robot().sensor().rays), ("hall", 0.3, 16));
    assert_eq!(Navigation::parse(&task.to_json_string()).expect("its own text"), task);
    let policy = shipped();
    assert_eq!(Policy::parse(&policy.to_json_string()).expect("its own text"), policy);
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_drives_are_refused() {
    let task = hall();
    let executor = Executor::new(&task, None).expect("no policy");
    let from = [1.0, 2.0, 0.0];
    refuses(executor.drive(from, &[], 0, 0), "out-of-range", "/path");
    refuses(executor.drive(from, &[[1.0, 2.0], [f64::NAN, 2.0]], 0, 0), "not-finite", "/path/1");
    refuses(executor.drive([f64::NAN, 2.0, 0.0], &[[1.0, 2.0]], 0, 0), "not-finite", "/start");
    let stays = executor.drive(from, &[[1.0, 2.0]], 0, 0).expect("a path of one position");
    assert_eq!((stays.outcome, stays.trace), (Outcome::Reached, vec![from]));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_may_have_turned_many_times() {
    for shape in ["disc", "rectangle"] {
        let task = generate("rooms", &json!({ "seed": 2, "shape": shape })).expect("rooms");
        let [x, y, theta] = task.queries()[0].start;
        let executor = Executor::new(&task, None).expect("no policy");
        let goal = [x + 0.01, y];
        let drive = executor.drive([x, y, theta + 1e5], &[[x, y], goal], 0, 0).expect("a drive");
        assert_eq!(drive.outcome, Outcome::Reached);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_vertices_of_a_shortened_path_are_free() {
    let task = generate("rooms", &json!({ "columns": 2, "rows": 1, "seed": 3 })).expect("rooms");
    let settings = options("samples=150 k=8 rollouts=4 least_share=0.5 shortcut=100");
    let mut run = start(&task, &shipped(), &settings).expect("a run");
    assert_eq!(run.step(u64::MAX), Status::Solved);
    let reach = task.robot().reach();
    for q in run.path() {
        let p = Point::new(q[0], q[1]);
        let obstacles = task.world().obstacles.iter().map(|one| one.distance_to_segment(&Segment::new(p, p)));
        assert!(obstacles.fold(task.bounds().depth(p), f64::min) > reach, "{q:?}");
    }
}

/// The distance along a ray, by small steps of the distance to everything.
fn marched(task: &Navigation, from: [f64; 3], angle: f64) -> f64 {
    let (sin, cos) = libm::sincos(from[2] + angle);
    let mut along = 0.0;
    while along < task.robot().sensor().range {
        let p = Point::new(from[0] + along * cos, from[1] + along * sin);
        let obstacles = task.world().obstacles.iter().map(|one| one.distance_to_segment(&Segment::new(p, p)));
        let free = obstacles.fold(task.bounds().depth(p), f64::min);
        if free < 1e-7 {
            return along;
        }
        along += free;
    }
    task.robot().sensor().range
}

#[wasm_bindgen_test(unsupported = test)]
fn rays_measure_the_distance_to_what_they_meet_first() {
    for task in [
        hall(),
        generate("rooms", &json!({ "seed": 4 })).expect("rooms"),
        generate("furnished", &json!({})).expect("a floor"),
    ] {
        let start = task.queries()[0].start;
        for turn in 0..20 {
            let pose = [start[0], start[1], f64::from(turn)];
            let sensor = task.robot().sensor();
            for (i, distance) in task.sense(pose).into_iter().enumerate() {
                let angle = sensor.field_of_view * (i as f64 / (sensor.rays - 1) as f64 - 0.5);
                let marched = marched(&task, pose, angle);
                assert!((distance - marched).abs() < 1e-3, "ray {i} at {pose:?}: {distance}, not {marched}");
            }
        }
    }
}

/// The distance from the robot to everything, 0 or less in contact.
fn clearance(task: &Navigation, pose: [f64; 3]) -> f64 {
    let to = |obstacle: &Obstacle| match task.footprint(pose) {
        Part::Disc { center, radius } => obstacle.distance_to_segment(&Segment::new(center, center)) - radius,
        Part::Polygon { vertices } => {
            obstacle.distance_to_polygon(&planarium::geometry::Polygon::new(&vertices).expect("a polygon"))
        }
        Part::Capsule { .. } => panic!("a drive has no links"),
    };
    task.world().obstacles.iter().map(to).fold(f64::INFINITY, f64::min)
}

#[wasm_bindgen_test(unsupported = test)]
fn no_arc_that_is_driven_touches_anything() {
    for shape in ["disc", "rectangle"] {
        let task = generate("rooms", &json!({ "seed": 2, "shape": shape, "noise": 2 })).expect("rooms");
        let executor = Executor::new(&task, None).expect("an executor");
        let query = &task.queries()[0];
        let ([x, y, _], goal) = (query.start, query.goal);
        let mut collisions = 0;
        for trial in 0..10 {
            let drive = executor.drive(query.start, &[[x, y], goal], 1, trial).expect("a drive");
            collisions += u32::from(drive.outcome == Outcome::Collision);
            for pair in drive.trace.windows(2) {
                let (dx, dy, turn) = (pair[1][0] - pair[0][0], pair[1][1] - pair[0][1], pair[1][2] - pair[0][2]);
                let half = 0.5 * turn;
                let forward = dx * libm::cos(pair[0][2] + half) + dy * libm::sin(pair[0][2] + half);
                let length = if half.abs() < 1e-9 { forward } else { forward * half / libm::sin(half) };
                for look in 0..=50 {
                    let part = f64::from(look) / 50.0;
                    let pose = planarium::geometry::arc_pose(pair[0], length, turn, part);
                    assert!(clearance(&task, pose) > 0.0, "{shape} touches something at {pose:?}");
                }
            }
        }
        assert!(collisions > 0, "straight on through the rooms something is in the way");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn training_is_the_same_by_shares_of_candidates() {
    let fresh = || Training::new(&hall(), &small(), 5).expect("a training");
    let mut whole = fresh();
    assert_eq!(whole.step(u64::MAX), Status::Solved);
    assert_eq!((whole.iterations(), whole.generation(), whole.history().len()), (24, 3, 3));
    let mut shared = fresh();
    while shared.status() == Status::Running {
        let returns = [shared.returns_of(0..3), shared.returns_of(3..8)].concat();
        shared.advance(&returns).expect("returns of all candidates");
    }
    assert_eq!((shared.policy(), shared.fingerprint()), (whole.policy(), whole.fingerprint()));
    assert_eq!(shared.history(), whole.history());
    refuses(fresh().advance(&[[0.0, 0.0]]), "out-of-range", "/returns");
    let shown = whole.demonstrations(3);
    assert!(shown.len() == 3 && shown.iter().all(|(floor, _, drive)| *floor < 3 && drive.trace.len() > 1));
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn training_on_threads_is_the_same_to_the_bit() {
    let mut alone = Training::new(&hall(), &small(), 5).expect("a training");
    alone.step(u64::MAX);
    let threads = std::num::NonZeroUsize::new(3).expect("three");
    let mut generations = 0;
    let watch = |_: &Training| {
        generations += 1;
        true
    };
    let together = planarium::navigation::train(&hall(), &small(), 5, threads, watch).expect("a training");
    assert_eq!((together.policy(), generations), (alone.policy(), 3));
    if crate::common::deep() {
        let floor = generate("furnished", &json!({})).expect("a floor");
        let again = planarium::navigation::train(&floor, &TrainingOptions::default(), 4, threads, |_| true)
            .expect("a training");
        assert_eq!(again.policy().to_json_string(), include_str!("../www/prm-rl/policy.json").trim_end());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_policy_is_better_after_training() {
    let floor = generate("furnished", &json!({})).expect("a floor");
    let mut training = Training::new(
        &floor,
        &TrainingOptions::read(&given("generations=12 pairs=12 tasks=12 floors=8")).expect("options"),
        1,
    )
    .expect("a training");
    training.step(u64::MAX);
    let history = training.history();
    let (first, last) = (history[0].reached, history[11].reached);
    assert!(last > first + 0.1, "from {first} to {last}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_shipped_policy_reaches_near_goals_on_fresh_floors() {
    let reached =
        assess(&generate("furnished", &json!({})).expect("a floor"), &shipped(), 5.0, 1000, 1).expect("a share");
    assert!(reached.n == 1000 && reached.share >= Some(0.95), "{reached:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn every_edge_of_a_path_is_driven_reliably_in_both_directions() {
    let (task, policy) = (hall(), shipped());
    let options = options("samples=60 k=8 rollouts=10 least_share=0.9");
    let result = navigate(&task, &policy, &options, 10);
    assert_eq!((result.plan.status, result.plan.edge_check.as_deref()), (Status::Solved, Some("rollouts")));
    assert_eq!(result.rollouts.len() + 1, result.plan.path.len());
    assert!(
        result.rollouts.iter().all(|edge| edge.of == 10 && edge.forward >= 9 && edge.backward >= 9),
        "{:?}",
        result.rollouts
    );
    assert!(result.reached.count >= 8 && result.driven_length.mean >= Some(7.0), "{result:?}");
    let path: Vec<[f64; 2]> = result.plan.path.iter().map(|q| [q[0], q[1]]).collect();
    assert_eq!(
        edge_rollouts(&task, &policy, &read_options(&options).expect("options").0, 1, &path).expect("rollouts"),
        result.rollouts
    );
}

/// The product of the shares of successes along the path, each the lesser of both directions.
fn success(settings: &str) -> f64 {
    let result = navigate(&hall(), &shipped(), &options(settings), 1);
    assert_eq!(result.plan.status, Status::Solved);
    let shares = result.rollouts.iter().map(|edge| f64::from(edge.forward.min(edge.backward)) / f64::from(edge.of));
    shares.product()
}

#[wasm_bindgen_test(unsupported = test)]
fn reliability_makes_detours_along_edges_that_succeed_more_often() {
    let settings = "samples=60 k=8 rollouts=10 least_share=0.5";
    let [shortest, reliable] = [" reliability=0", ""].map(|more| success(&format!("{settings}{more}")));
    assert!(reliable > shortest, "{reliable} and {shortest}");
    let eager = Request { planner: Some("prm".to_owned()), ..options("reliability=1") };
    refuses(start(&hall(), &shipped(), &eager).map(|_| ()), "unsupported", "/reliability");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_lazy_roadmap_has_the_same_path_for_less() {
    let (task, policy) = (hall(), shipped());
    let run = |planner: &str| {
        let options =
            Request { planner: Some(planner.to_owned()), ..options("samples=40 k=6 rollouts=5 reliability=0") };
        let mut run = start(&task, &policy, &options).expect("a run");
        run.step(u64::MAX);
        run
    };
    let (whole, lazy) = (run("prm"), run("lazy-prm"));
    assert_eq!((lazy.path(), lazy.status()), (whole.path(), Status::Solved));
    assert!(lazy.stats().clearance_evaluations < whole.stats().clearance_evaluations / 2);
}

#[wasm_bindgen_test(unsupported = test)]
fn there_is_no_way_through_a_wall() {
    let mut document = task();
    document["world"]["obstacles"] =
        json!([{ "type": "polygon", "vertices": [[5, 0], [5.000001, 0], [5.000001, 4], [5, 4]] }]);
    let task = Navigation::read(&document).expect("a task");
    let result = navigate(&task, &shipped(), &options("samples=60 k=8 rollouts=3 least_share=0"), 5);
    // With a least share of 0 every edge counts as driven, yet no execution crosses the wall.
    assert_eq!((result.plan.status, result.reached.count), (Status::Solved, 0));
    let result = navigate(&task, &shipped(), &options("samples=60 k=8 rollouts=3 least_share=0.3"), 5);
    assert_eq!((result.plan.status, result.plan.path.len(), result.reached.n), (Status::Exhausted, 0, 0));
}

/// The claim of PRM-RL: in three fresh offices by the 500 executions of docs/prm-rl.md in each, or in one of them by a few.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn prm_rl_executes_long_queries_that_the_policy_alone_does_not() {
    let (queries, offices) =
        if crate::common::deep() { ("queries=50 trials=10", 3) } else { ("queries=10 trials=3", 1) };
    let mut all = [0.0; planarium::navigation::Method::ALL.len()];
    for seed in 1..=offices {
        let task = generate("rooms", &json!({ "seed": seed })).expect("rooms");
        let mut comparison = compare(&task, queries, 7).expect("a comparison");
        assert_eq!(comparison.step(u64::MAX), Status::Solved);
        let shares: Vec<f64> = comparison.summary().iter().map(|one| one.reached.share.expect("trials")).collect();
        all.iter_mut().zip(&shares).for_each(|(all, share)| *all += share / offices as f64);
        assert!(!crate::common::deep() || (shares[5] >= 0.9 && shares[0] < 0.6), "rooms {seed}: {shares:?}");
    }
    let [policy, straight, with_margin, by_policy, with_margin_by_policy, prm_rl] = all;
    assert!(prm_rl >= 0.9 && policy < 0.6 && straight < prm_rl, "{all:?}");
    assert!(straight < with_margin && straight < by_policy && by_policy < with_margin_by_policy + 0.1, "{all:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_comparison_executes_every_query_in_six_ways() {
    let task = generate("rooms", &json!({ "columns": 2, "rows": 1, "seed": 1 })).expect("rooms");
    let settings = "queries=2 trials=2 least_distance=4 samples=60 k=6 rollouts=5 least_share=0.8";
    let mut whole = compare(&task, settings, 1).expect("a comparison");
    assert_eq!(whole.step(u64::MAX), Status::Solved);
    assert_eq!((whole.executions().len(), whole.count()), (24, 24));
}

#[wasm_bindgen_test(unsupported = test)]
fn outcomes_are_the_same_on_every_platform() {
    golden::check("golden-navigation.json", include_str!("golden-navigation.json"), 7, |case| {
        let seed = case["seed"].as_u64().expect("a seed");
        let task = generate(case["generator"].as_str().expect("a generator"), &case["options"]).expect("a task");
        let Some(planner) = case["planner"].as_str() else {
            let mut training = Training::new(&task, &small(), seed).expect("a training");
            training.step(u64::MAX);
            return json!({ "fingerprint": format!("{:016x}", training.fingerprint()) });
        };
        let settings = case["settings"].as_str().expect("settings");
        let options = Request { planner: Some(planner.to_owned()), seed, ..options(settings) };
        let is_cargo = case["options"]["shape"] == "cargo";
        let policy = if is_cargo { crate::delivery::shipped_cargo() } else { shipped() };
        let result = navigate(&task, &policy, &options, 4);
        json!({ "status": result.plan.status, "fingerprint": format!("{:016x}", result.plan.fingerprint), "reached": result.reached.count,
            "length": result.driven_length.mean.map(f64::to_bits) })
    });
}
