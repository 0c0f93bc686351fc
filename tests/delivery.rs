//! A carrier that delivers a load on a rope: its task, its policy, and drives that are integrated again in another way.

use crate::common::documents::refuses;
use crate::common::given;
use crate::navigation::options;
use planarium::geometry::{Point, Segment};
use planarium::navigation::{
    Drive, Executor, Navigation, Navigator, Outcome, Policy, Training, TrainingOptions, assess, generate, read_options,
};
use planarium::options::Options as _;
use planarium::problem::{Status, Stepped};
use planarium::robot::GRAVITY;
use planarium::scenario::Obstacle;
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

fn document() -> Value {
    json!({
        "format": "planarium-navigation-1", "name": "yard",
        "world": { "bounds": { "min": [0, 0], "max": [10, 4] },
                   "obstacles": [ { "type": "disc", "center": [5, 2], "radius": 0.5 } ] },
        "robot": { "type": "cargo", "radius": 0.25, "load_radius": 0.15, "rope": 1, "swing_limit": 0.3, "speed": 1,
                   "acceleration": 2 },
        "queries": [ { "name": "through", "start": [1, 2, 0], "goal": [9, 2] } ]
    })
}

fn yard() -> Navigation {
    Navigation::read(&document()).expect("a task")
}

pub fn shipped_cargo() -> Policy {
    Policy::parse(include_str!("../www/prm-rl/policy-cargo.json")).expect("our own policy is right")
}

#[wasm_bindgen_test(unsupported = test)]
fn a_task_is_read_and_written_again() {
    let task = yard();
    assert_eq!(Navigation::parse(&task.to_json_string()).expect("its own text"), task);
    let Navigator::Cargo(robot) = task.robot() else { panic!("no cargo") };
    assert_eq!((robot.arrival_speed, robot.arrival_swing, robot.sensor.rays), (0.5, 0.15, 20));
    assert_eq!(robot.cargo.limits().time_step, 0.2);
    assert_eq!((task.robot().reach(), task.robot().top_speed()), (0.25, 1.0));
    let policy = shipped_cargo();
    assert_eq!(Policy::parse(&policy.to_json_string()).expect("its own text"), policy);
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_robots_and_policies_of_others_are_refused() {
    for (field, value, pointer) in [
        ("rope", json!(0.05), "/robot/rope"),
        ("swing_limit", json!(0.99), "/robot/swing_limit"),
        ("arrival_speed", json!(0), "/robot/arrival_speed"),
        ("arrival_swing", json!(-1), "/robot/arrival_swing"),
        ("damping", json!(11), "/robot/damping"),
        (
            "noise",
            json!({ "range": 0, "position": 0, "velocity": 0, "swing": -1, "acceleration": 0 }),
            "/robot/noise/swing",
        ),
    ] {
        let mut document = document();
        document["robot"][field] = value;
        refuses(Navigation::read(&document), "out-of-range", pointer);
    }
    let wheeled = crate::navigation::shipped();
    refuses(Executor::new(&yard(), Some(&wheeled)).map(|_| ()), "unsupported", "/policy/robot");
    refuses(
        Executor::new(&crate::navigation::hall(), Some(&shipped_cargo())).map(|_| ()),
        "unsupported",
        "/policy/robot",
    );
}

/// Carrier and load at many times of a drive that began at rest, integrated in small steps by the polar angles of the rope: the
/// accelerations follow from the positions of the carrier, which moves along parabolas.
fn replayed(task: &Navigation, drive: &Drive, mut look: impl FnMut([f64; 2], [f64; 2])) {
    const STEPS: u32 = 400;
    let Navigator::Cargo(robot) = task.robot() else { panic!("no cargo") };
    let limits = robot.cargo.limits();
    let step = limits.time_step / f64::from(STEPS);
    let (mut velocity, mut swing, mut rate) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    for (i, pair) in drive.trace.windows(2).enumerate() {
        let t = limits.time_step;
        let acceleration = [0, 1].map(|k| 2.0 * (pair[1][k] - pair[0][k] - velocity[k] * t) / (t * t));
        for n in 1..=STEPS {
            // The equations of Lagrange for the coordinates x and y of the load, z = -(L^2 - x^2 - y^2)^(1/2).
            let slope = |swing: [f64; 2], rate: [f64; 2]| {
                let ([x, y], [u, w]) = (swing, rate);
                let squared = limits.rope * limits.rope - x * x - y * y;
                let climb = x * u + y * w;
                let pushed = x * acceleration[0] + y * acceleration[1];
                let along =
                    (u * u + w * w + climb * climb / squared - pushed + GRAVITY * squared.sqrt()) / limits.rope.powi(2);
                [0, 1].map(|k| -acceleration[k] - along * swing[k] - limits.damping * rate[k])
            };
            // The method of the middle.
            let first = slope(swing, rate);
            let half = [0, 1].map(|k| swing[k] + 0.5 * step * rate[k]);
            let half_rate = [0, 1].map(|k| rate[k] + 0.5 * step * first[k]);
            let middle = slope(half, half_rate);
            swing = [0, 1].map(|k| swing[k] + step * half_rate[k]);
            rate = [0, 1].map(|k| rate[k] + step * middle[k]);
            let t = f64::from(n) * step;
            let carrier = [0, 1].map(|k| pair[0][k] + t * (velocity[k] + 0.5 * t * acceleration[k]));
            look(carrier, swing);
        }
        velocity = [0, 1].map(|k| velocity[k] + t * acceleration[k]);
        let [dx, dy] = [0, 1].map(|k| swing[k] - drive.swing[i + 1][k]);
        assert!(dx * dx + dy * dy < 1e-10, "{swing:?} and {:?} after {} steps", drive.swing[i + 1], i + 1);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_drive_touches_anything_or_swings_too_far() {
    let mut counts = [0; 4];
    let policy = shipped_cargo();
    let rooms = |seed: u64| {
        generate("rooms", &json!({ "seed": seed, "shape": "cargo", "columns": 2, "rows": 2, "noise": 2 }))
            .expect("rooms")
    };
    let mut slack = document();
    slack["robot"]["swing_limit"] = json!(0.12);
    slack["robot"]["noise"] = json!({ "range": 0, "position": 0, "velocity": 0, "swing": 0, "acceleration": 1 });
    let slack = Navigation::read(&slack).expect("a task");
    for (seed, task, controller) in [(1, rooms(1), None), (2, rooms(2), Some(&policy)), (3, slack, None)] {
        let Navigator::Cargo(robot) = task.robot() else { panic!("no cargo") };
        let limit = robot.cargo.limits().swing_limit + 1e-4;
        let executor = Executor::new(&task, controller).expect("an executor");
        let query = &task.queries()[0];
        let ([x, y, _], goal) = (query.start, query.goal);
        for trial in 0..10 {
            let drive = executor.drive(query.start, &[[x, y], goal], seed, trial).expect("a drive");
            counts[drive.outcome as usize] += 1;
            assert_eq!(drive.swing.len(), drive.trace.len());
            replayed(&task, &drive, |[x, y], [dx, dy]| {
                assert!(dx * dx + dy * dy <= limit * limit, "the load is at {dx}, {dy}");
                for (at, radius) in [(Point::new(x, y), 0.25), (Point::new(x + dx, y + dy), 0.15)] {
                    let distance = |obstacle: &Obstacle| obstacle.distance_to_segment(&Segment::new(at, at));
                    let nearest = task.world().obstacles.iter().map(distance).fold(f64::INFINITY, f64::min);
                    assert!(nearest > radius - 1e-5, "{at:?} is {nearest} from an obstacle");
                }
            });
        }
    }
    assert!(counts[Outcome::Collision as usize] > 0, "{counts:?}");
    assert!(counts[Outcome::Swing as usize] > 0, "{counts:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_carrier_arrives_slowly_and_its_sensor_looks_at_the_goal() {
    let mut document = document();
    document["world"]["obstacles"] = json!([]);
    document["robot"]["noise"] = json!({ "range": 0, "position": 0, "velocity": 0, "swing": 0, "acceleration": 0 });
    let task = Navigation::read(&document).expect("a task");
    let drive = Executor::new(&task, None).expect("no policy").drive([1.0, 2.0, 3.0], &[[1.0, 2.0], [9.0, 2.0]], 0, 0);
    let drive = drive.expect("a drive");
    assert_eq!(drive.outcome, Outcome::Reached);
    let [.., before, last] = &drive.trace[..] else { panic!("a short drive") };
    assert!(last[0] - before[0] <= 0.5 * 0.2 + 1e-9, "{before:?} to {last:?}");
    assert!(drive.trace[1..].iter().all(|pose| pose[2] == 0.0 && pose[1] == 2.0));
    // It accelerates with 1 m/s^2 at first, so that the load lags behind.
    assert!(drive.swing[1][0] < -0.01 && drive.swing.iter().all(|swing| swing[1] == 0.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn training_is_the_same_by_shares_of_candidates() {
    let options = TrainingOptions::read(&given(crate::navigation::SMALL)).expect("options");
    let mut whole = Training::new(&yard(), &options, 5).expect("a training");
    assert_eq!(whole.step(u64::MAX), Status::Solved);
    let mut shared = Training::new(&yard(), &options, 5).expect("a training");
    while shared.status() == Status::Running {
        let returns = [shared.returns_of(0..3), shared.returns_of(3..8)].concat();
        shared.advance(&returns).expect("returns of all candidates");
    }
    assert_eq!(shared.policy(), whole.policy());
    let shown = whole.demonstrations(3);
    assert!(shown.iter().all(|(_, _, drive)| drive.swing.len() == drive.trace.len() && drive.trace.len() > 1));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_shipped_policy_delivers_to_near_goals_on_fresh_floors() {
    let floor = generate("furnished", &json!({ "shape": "cargo" })).expect("a floor");
    let reached = assess(&floor, &shipped_cargo(), 5.0, 500, 1).expect("a share");
    assert!(reached.n == 500 && reached.share >= Some(0.9), "{reached:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_roadmap_of_learned_edges_is_planned_and_driven() {
    let (rollouts, options) = read_options(&options("samples=60 k=8 rollouts=10")).expect("options");
    let result = planarium::navigation::navigate(&yard(), &shipped_cargo(), &rollouts, &options, 10).expect("a result");
    assert_eq!((result.plan.status, result.plan.edge_check.as_deref()), (Status::Solved, Some("rollouts")));
    assert!(result.reached.count >= 8 && result.swings.n == 10, "{result:?}");
}

/// In a fresh office; in a deep run, in three together.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn prm_rl_delivers_where_the_policy_alone_and_straight_edges_do_not() {
    use planarium::navigation::{Comparison, ComparisonOptions, Method};
    let options = ComparisonOptions::read(&given("queries=4 trials=3 samples=800")).expect("options");
    let offices = if crate::common::deep() { 3 } else { 1 };
    let mut all = [0.0; Method::ALL.len()];
    for seed in 1..=offices {
        let task = generate("rooms", &json!({ "seed": seed, "shape": "cargo" })).expect("rooms");
        let mut comparison = Comparison::new(&task, &shipped_cargo(), &options, 7).expect("a comparison");
        assert_eq!(comparison.step(u64::MAX), Status::Solved);
        let summary = comparison.summary();
        all.iter_mut().zip(&summary).for_each(|(all, one)| *all += one.reached.share.expect("trials") / offices as f64);
    }
    let [policy, straight, .., prm_rl] = all;
    assert!(prm_rl >= 0.8 && policy < 0.4 && straight < 0.5, "{all:?}");
}
