//! The car driven by keys: keys, steps, stops, replay, rollout.

use crate::common;
use crate::common::bodies::{placed, touches};
use crate::common::documents::{disc, rectangle, rectangular, refuses, scenario};
use crate::common::driven::car as car_of;
use planarium::driving::{Drive, Integration, Key, MAX_STEPS, Press, RolloutOptions, rollout};
use planarium::geometry::arc_pose;
use planarium::problem::{Control, Motion, Touched};
use planarium::random::{Random, Stream};
use planarium::scenario::Scenario;
use planarium::space::angular_distance;
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

/// The reports' car in a box of side 2, a wall to the right of it.
fn road() -> Scenario {
    car("[-0.5, 0.5]", "[-0.7853981633974483, 0.7853981633974483]")
}

fn car(speed: &str, steering: &str) -> Scenario {
    let obstacles = [disc([0.2, 1.8], 0.05), rectangle([1.5, 0.0], [1.6, 1.2])].join(",");
    let limits = format!(r#""wheelbase": 0.2, "speed": {speed}, "steering": {steering}"#);
    let car = rectangular("car", 0.1, 0.05, &limits);
    scenario("[0, 0], [2, 2]", &obstacles, &car, r#""start": [0.5, 0.5, 0], "goal": [1.8, 0.5, 0]"#)
}

fn drive() -> Drive {
    Drive::new(road(), None).expect("a drive")
}

/// Presses the keys of a text: faster, slower, left, right, keep.
fn press(drive: &mut Drive, keys: &str) {
    for key in keys.chars() {
        let number = "+-lr=".find(key).expect("a key") as u8;
        drive.press(Key::from_repr(number).expect("a key")).expect("a drive of few keys");
    }
}

fn bits(drive: &Drive) -> Vec<u64> {
    drive.trace().iter().flatten().map(|number| number.to_bits()).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn keys_change_the_control_within_its_limits() {
    let mut drive = drive();
    drive.tick(100).expect("time");
    assert_eq!((drive.pose(), drive.steps(), drive.trace().len()), ([0.5, 0.5, 0.0], 100, 1), "it starts at rest");
    // Limits of speed and steering angle, keys, and the control after them; without limits the drive continues.
    for (limits, keys, speed, steering) in [
        (Some(["[-0.5, 0.5]", "[-0.7853981633974483, 0.7853981633974483]"]), "", 0.0, 0.0),
        (None, "+++", 0.3, 0.0),
        (None, "+++++++++", 0.5, 0.0),
        // Presses at the limit are not counted.
        (None, "-", 0.4, 0.0),
        (None, "ll=", 0.4, PI / 6.0),
        (None, "lllllll", 0.4, PI / 4.0),
        (None, "rrr", 0.4, 0.0),
        (None, "------------------------------", -0.5, 0.0),
        // Zero is reached again from limits that are no multiple of a press.
        (Some(["[-0.25, 0.31]", "[-0.4, 0.7]"]), "llllllll", 0.0, 0.7),
        (None, "rrr", 0.0, 0.0),
        (None, "-----", -0.25, 0.0),
        (None, "+++", 0.0, 0.0),
        (None, "+++++++++", 0.31, 0.0),
        // A car that cannot drive slowly can stand still.
        (Some(["[0.25, 0.5]", "[0.1, 0.7]"]), "", 0.0, 0.1),
        (None, "-", 0.0, 0.1),
        (None, "+", 0.25, 0.1),
    ] {
        if let Some([speeds, angles]) = limits {
            drive = Drive::new(car(speeds, angles), None).expect("a drive");
        }
        press(&mut drive, keys);
        assert_eq!(drive.control(), Control { speed, steering }, "{keys}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn each_step_is_an_exact_arc() {
    let mut drive = drive();
    press(&mut drive, "++l");
    drive.tick(150).expect("time");
    assert_eq!(drive.blocked(), None);
    let [x, y, theta] = drive.pose();
    let turn_rate = 0.2 * f64::tan(PI / 12.0) / 0.2;
    let [ex, ey, etheta] = arc_pose([0.5, 0.5, 0.0], 0.2, turn_rate, 1.5);
    assert!((x - ex).abs() < 1e-12 && (y - ey).abs() < 1e-12 && angular_distance(theta, etheta) < 1e-12);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_keys_at_the_same_steps_give_the_same_bits_however_the_steps_are_cut() {
    let keys =
        [(0, Key::Faster), (0, Key::Faster), (40, Key::Left), (90, Key::Faster), (130, Key::Right), (131, Key::Right)];
    let run = |slice: u64| {
        let mut drive = drive();
        for (at, key) in keys {
            while drive.steps() < at {
                drive.tick(slice.min(at - drive.steps())).expect("time");
            }
            drive.press(key).expect("a key");
        }
        while drive.steps() < 200 {
            drive.tick(slice.min(200 - drive.steps())).expect("time");
        }
        drive
    };
    let whole = bits(&run(u64::from(u32::MAX).min(MAX_STEPS)));
    assert_eq!(whole.len(), 3 * 201);
    for slice in [1, 3, 33] {
        assert_eq!(bits(&run(slice)), whole, "in slices of {slice}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn it_stops_before_an_obstacle_or_the_bounds_reports_it_and_can_back_off() {
    let mut drive = drive();
    press(&mut drive, "+++++lr");
    drive.tick(1000).expect("time");
    assert_eq!(drive.blocked(), Some(Some(Touched::Obstacle(1))));
    assert_eq!(drive.control().speed, 0.0);
    let [x, ..] = drive.pose();
    assert!(x > 1.395 - 1e-9 && x < 1.4, "within a step of the wall at 1.5: {x}");
    assert_eq!(drive.steps(), 1000, "time is counted while it is blocked");
    let stood = drive.pose();
    press(&mut drive, "+");
    drive.tick(5).expect("time");
    drive.tick(5).expect("time");
    assert_eq!(drive.blocked(), Some(Some(Touched::Obstacle(1))), "it may come a little nearer, and stops again");
    assert!(drive.pose()[0] - stood[0] < 5e-3);
    press(&mut drive, "-");
    assert!(drive.blocked().is_some());
    drive.tick(10).expect("time");
    assert_eq!(drive.blocked(), None);
    assert!(drive.pose()[0] < stood[0]);
    let mut drive = self::drive();
    press(&mut drive, "-----");
    drive.tick(1000).expect("time");
    assert_eq!(drive.blocked(), Some(Some(Touched::Bounds)));
    assert!(drive.pose()[0] >= 0.1 - 1e-9);
}

#[wasm_bindgen_test(unsupported = test)]
fn no_pose_of_a_wild_drive_touches_anything() {
    let (road, mut random) = (road(), Random::new(5, Stream::Scenario));
    let (shape, bounds) = (car_of(&road).shape(), road.world().bounds.expect("a box"));
    for _ in 0..common::seeds(40) {
        let mut drive = drive();
        for _ in 0..60 {
            let key = Key::from_repr((random.uniform() * 4.0) as u8).expect("a key");
            drive.press(key).expect("a key");
            drive.tick(20).expect("time");
        }
        for pose in drive.trace() {
            assert!(!touches(shape, road.world(), pose), "{pose:?}");
            assert!(placed(shape, pose).iter().all(|&corner| bounds.depth(corner) > -1e-9), "{pose:?}");
        }
        let mut again = Drive::new(&road, None).expect("a drive");
        again.replay(drive.record(), drive.steps()).expect("a record");
        assert_eq!(bits(&again), bits(&drive));
        assert_eq!(
            (again.record(), again.steps(), again.blocked(), again.control()),
            (drive.record(), drive.steps(), drive.blocked(), drive.control())
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_replay_stops_at_the_given_step() {
    let record = [Press { step: 0, key: Key::Faster }, Press { step: 10, key: Key::Slower }];
    let mut drive = drive();
    drive.replay(&record, 5).expect("a record");
    assert_eq!((drive.steps(), drive.record().len(), drive.control().speed), (5, 1, 0.1));
    drive.replay(&record, 50).expect("a record");
    assert_eq!((drive.steps(), drive.record().len(), drive.trace().len()), (50, 2, 11));
    refuses(drive.replay(&[record[1], record[0]], 50), "out-of-range", "/record/1/step");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_rollout_is_the_arc_up_to_what_it_hits() {
    let hold = |speed, steering, duration| {
        let motion = Motion { control: Control { speed, steering }, duration };
        rollout(road(), &[0.5, 0.5, 0.0], motion, RolloutOptions::default())
    };
    let free = hold(0.5, PI / 4.0, 1.234).expect("a rollout");
    assert_eq!((free.poses.len(), free.seconds, free.blocked), (125, 1.234, None));
    let end = arc_pose([0.5, 0.5, 0.0], 0.5, 0.5 * libm::tan(PI / 4.0) / 0.2, 1.234);
    let last = free.poses[124];
    assert!((0..2).all(|i| (last[i] - end[i]).abs() < 1e-15) && angular_distance(last[2], end[2]) < 1e-15);
    let hit = hold(0.5, 0.0, 10.0).expect("a rollout");
    assert_eq!(hit.blocked, Some(Some(Touched::Obstacle(1))));
    assert!((hit.seconds - 1.79).abs() < 0.011 && hit.poses.len() == (hit.seconds * 100.0 + 1.5) as usize);
    assert_eq!(hold(0.0, 0.0, 0.0).expect("a rollout").poses, vec![[0.5, 0.5, 0.0]]);
    for (speed, steering, duration, pointer) in [
        (0.6, 0.0, 1.0, "/v"),
        (0.1, 1.0, 1.0, "/phi"),
        (0.1, 0.0, -1.0, "/duration"),
        (0.1, 0.0, 1e9, "/duration"),
        (f64::NAN, 0.0, 1.0, "/v"),
        (0.1, f64::INFINITY, 1.0, "/phi"),
    ] {
        assert_eq!(hold(speed, steering, duration).expect_err("bad input").pointer(), pointer);
    }
    let motion = Motion { control: Control { speed: 0.1, steering: 0.0 }, duration: 1.0 };
    for integration in [Integration::Exact, Integration::Euler] {
        let options = RolloutOptions { integration, step: None };
        let inside = rollout(road(), &[1.5, 0.5, 0.0], motion, options).expect("a rollout that goes nowhere");
        assert_eq!((inside.poses.len(), inside.blocked), (1, Some(Some(Touched::Obstacle(1)))));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_steps_drift_from_the_arc_in_proportion_to_their_length() {
    let hold = |speed, steering, duration, integration, step| {
        let motion = Motion { control: Control { speed, steering }, duration };
        rollout(road(), &[0.5, 0.5, 0.0], motion, RolloutOptions { integration, step })
    };
    let rolled = |step| {
        let of = |integration| hold(0.5, PI / 4.0, 1.234, integration, Some(step)).expect("a rollout");
        let [exact, euler] = [of(Integration::Exact), of(Integration::Euler)];
        assert_eq!((euler.poses.len(), euler.seconds, euler.blocked), (exact.poses.len(), 1.234, None));
        assert_eq!(exact.poses.len(), (1.234 / step).ceil() as usize + 1);
        let turn_rate = 0.5 * libm::tan(PI / 4.0) / 0.2;
        for pair in euler.poses.windows(2).take(euler.poses.len() - 2) {
            let [from, to] = [pair[0], pair[1]];
            assert!((to[0] - from[0] - 0.5 * step * libm::cos(from[2])).abs() < 1e-15);
            assert!((to[1] - from[1] - 0.5 * step * libm::sin(from[2])).abs() < 1e-15);
            assert!((angular_distance(to[2], from[2]) - turn_rate * step).abs() < 1e-14);
        }
        let [arc, steps] = [exact, euler].map(|rollout| rollout.poses[rollout.poses.len() - 1]);
        assert!(angular_distance(arc[2], steps[2]) < 1e-12, "headings are exact");
        (arc[0] - steps[0]).hypot(arc[1] - steps[1])
    };
    let [coarse, fine, finest] = [0.1, 0.01, 0.001].map(rolled);
    assert!(coarse > 5.0 * fine && fine > 5.0 * finest && finest > 1e-6, "{coarse} {fine} {finest}");
    // Straight ahead there is no error, and the wall is met at the same step.
    let [exact, euler] = [Integration::Exact, Integration::Euler].map(|way| hold(0.5, 0.0, 10.0, way, None).unwrap());
    assert_eq!(euler.blocked, Some(Some(Touched::Obstacle(1))));
    assert!((euler.seconds - exact.seconds).abs() < 0.011 && euler.poses.len() >= exact.poses.len());
    for step in [0.0, -0.1, 1e-7, f64::NAN] {
        assert_eq!(hold(0.1, 0.0, 0.0, Integration::Euler, Some(step)).expect_err("bad input").pointer(), "/dt");
    }
    refuses(hold(0.1, 0.0, 2.0, Integration::Euler, Some(1e-6)), "out-of-range", "/duration");
}

/// Where `n` steps of `dt` end that begin at the origin: a sum of a geometric series of rotations, v dt times
/// sin(n a / 2) / sin(a / 2) in direction (n - 1) a / 2, with a = turn rate x dt.
fn euler_sum(speed: f64, turn_rate: f64, dt: f64, n: u32) -> [f64; 2] {
    let (n, half) = (f64::from(n), 0.5 * turn_rate * dt);
    let length = speed * dt * libm::sin(n * half) / libm::sin(half);
    [length * libm::cos((n - 1.0) * half), length * libm::sin((n - 1.0) * half)]
}

#[wasm_bindgen_test(unsupported = test)]
fn euler_steps_end_where_their_sum_does_and_the_gap_to_the_arc_is_linear_in_the_step() {
    let (speed, steering, duration) = (0.4, 0.5, 1.5);
    let turn_rate = speed * libm::tan(steering) / 0.2;
    let start = [0.5, 0.5, 0.0];
    let arc = arc_pose(start, speed, turn_rate, duration);
    let chord = libm::hypot(arc[0] - start[0], arc[1] - start[1]);
    for n in [6, 15, 150, 1500] {
        let dt = duration / f64::from(n);
        let motion = Motion { control: Control { speed, steering }, duration };
        let options = RolloutOptions { integration: Integration::Euler, step: Some(dt) };
        let rolled = rollout(road(), &start, motion, options).expect("a rollout");
        assert_eq!((rolled.seconds, rolled.blocked), (duration, None));
        let [x, y, theta] = rolled.poses[rolled.poses.len() - 1];
        let [dx, dy] = euler_sum(speed, turn_rate, dt, n);
        assert!(libm::hypot(x - start[0] - dx, y - start[1] - dy) < 1e-13, "{n} steps");
        assert!(angular_distance(theta, arc[2]) < 1e-12);
        // A step turns the chord by half its own angle, and lengthens it by a term of second order.
        let gap = libm::hypot(x - arc[0], y - arc[1]) / (chord * 0.5 * turn_rate * dt);
        assert!((gap - 1.0).abs() < 0.05 * turn_rate * dt, "{n} steps: {gap} times the first order");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn bad_input_is_refused_with_code_and_pointer() {
    for (start, code, pointer) in [
        (&[0.0, 0.0][..], "wrong-dimension", "/q"),
        (&[0.0, f64::NAN, 0.0], "not-finite", "/q/1"),
        (&[0.0, 1e7, 0.0], "out-of-range", "/q/1"),
        (&[1.5, 0.5, 0.0], "start-in-collision", "/q"),
    ] {
        refuses(Drive::new(road(), Some(start)), code, pointer);
    }
    refuses(Drive::new(common::disc_and_wall(0.1, 0.1), None), "unsupported", "");
    refuses(drive().tick(MAX_STEPS + 1), "out-of-range", "/n");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_drive_ends_after_a_million_steps() {
    let mut drive = Drive::new(car("[-0.5, 0.5]", "[-1.5, 1.5]"), Some(&[0.8, 1.0, 0.0])).expect("a drive");
    press(&mut drive, "+llllll");
    // It drives in a small circle, without end.
    if cfg!(target_arch = "wasm32") {
        return;
    }
    drive.tick(MAX_STEPS).expect("a million steps");
    assert_eq!(drive.trace().len() as u64, MAX_STEPS + 1);
    assert_eq!(drive.tick(1).expect_err("one more").code().as_str(), "too-large");
    drive.replay(&[], 0).expect("anew");
    assert_eq!(drive.trace().len(), 1);
}
