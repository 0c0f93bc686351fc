//! A carrier with a load on a rope: the laws of the pendulum, and the limits of the carrier.

use crate::common::documents::refuses;
use planarium::fingerprint::Fingerprint;
use planarium::random::{Random, Stream};
use planarium::robot::{Cargo, CargoLimits, CargoState, GRAVITY, Part};
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

const LIMITS: CargoLimits = CargoLimits {
    radius: 0.25,
    load_radius: 0.15,
    rope: 1.0,
    swing_limit: 0.8,
    damping: 0.0,
    speed: 1.0,
    acceleration: 1.0,
    time_step: 0.2,
};

fn cargo(limits: CargoLimits) -> Cargo {
    Cargo::new(limits).expect("a carrier")
}

fn swinging(swing: [f64; 2], swing_rate: [f64; 2]) -> CargoState {
    CargoState { swing, swing_rate, ..CargoState::at_rest([0.0; 2]) }
}

/// The state after some time steps in which the carrier does not accelerate.
fn hung(cargo: &Cargo, from: CargoState, steps: usize) -> CargoState {
    (0..steps).fold(from, |state, _| cargo.drive(&state, [0.0; 2], |_| {}))
}

fn near(a: [f64; 2], b: [f64; 2], tolerance: f64) {
    assert!((a[0] - b[0]).abs() <= tolerance && (a[1] - b[1]).abs() <= tolerance, "{a:?} and {b:?}");
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Per mass: the energy above that of the load at rest, and the angular momentum about the vertical.
fn invariants(state: &CargoState, rope: f64) -> [f64; 2] {
    let ([x, y], [u, w]) = (state.swing, state.swing_rate);
    let height = (rope * rope - x * x - y * y).sqrt();
    let climb = (x * u + y * w) / height;
    [0.5 * (u * u + w * w + climb * climb) + GRAVITY * (rope - height), x * w - y * u]
}

#[wasm_bindgen_test(unsupported = test)]
fn without_damping_energy_and_angular_momentum_stay() {
    for (rope, swing, rate) in [(1.0, [0.5, 0.1], [0.3, -0.9]), (3.0, [-0.2, 0.4], [1.0, 0.2])] {
        let cargo = cargo(CargoLimits { rope, ..LIMITS });
        let from = swinging(swing, rate);
        let before = invariants(&from, rope);
        let after = invariants(&hung(&cargo, from, 1000), rope);
        for (before, after) in before.into_iter().zip(after) {
            assert!((after / before - 1.0).abs() < 1e-5, "{before} became {after}");
        }
    }
}

/// The period of a plane swing of any angle: that of small swings, divided by the arithmetic-geometric mean of 1 and the cosine
/// of half the angle (Gauss).
fn period(rope: f64, angle: f64) -> f64 {
    let (mut a, mut b) = (1.0, f64::cos(0.5 * angle));
    for _ in 0..10 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    2.0 * PI * (rope / GRAVITY).sqrt() / a
}

#[wasm_bindgen_test(unsupported = test)]
fn swings_small_and_large_have_the_period_of_a_pendulum() {
    for (rope, angle) in [(0.5, 0.001), (1.0, 0.001), (1.0, 0.5), (1.0, 0.9), (4.0, 0.15)] {
        let cargo =
            cargo(CargoLimits { rope, time_step: period(rope, angle) / 20.0, swing_limit: 0.85 * rope, ..LIMITS });
        let swing = rope * f64::sin(angle);
        let from = swinging([0.6 * swing, 0.8 * swing], [0.0; 2]);
        let half = hung(&cargo, from, 10);
        near(half.swing, from.swing.map(|x| -x), 1e-5 * swing);
        let after = hung(&cargo, from, 200);
        near(after.swing, from.swing, 1e-5 * swing);
    }
    // Small swings: 2 pi sqrt(L / g).
    assert!((period(1.0, 1e-6) - 2.006_409_3).abs() < 1e-6);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_load_can_circle_and_hangs_back_while_the_carrier_accelerates() {
    let cargo = cargo(CargoLimits { speed: 100.0, acceleration: 2.0, ..LIMITS });
    let (radius, height) = (0.6, 0.8);
    let speed = radius * (GRAVITY / height).sqrt();
    let mut state = swinging([radius, 0.0], [0.0, speed]);
    for _ in 0..100 {
        state = cargo.drive(&state, [0.0; 2], |state| assert!((length(state.swing) - radius).abs() < 1e-6));
    }
    // tan = a / g; the carrier moves as if there were no load.
    let back = 2.0 / (4.0 + GRAVITY * GRAVITY).sqrt();
    let mut state = swinging([0.0, -back], [0.0; 2]);
    for _ in 0..50 {
        state = cargo.drive(&state, [0.0, 2.0], |_| {});
    }
    near(state.swing, [0.0, -back], 1e-9);
    near(state.position, [0.0, 100.0], 1e-9);
    near(state.velocity, [0.0, 20.0], 1e-9);
}

#[wasm_bindgen_test(unsupported = test)]
fn damping_makes_small_swings_decay() {
    let cargo = cargo(CargoLimits { damping: 0.4, ..LIMITS });
    let from = swinging([0.01, 0.0], [0.0; 2]);
    let after = hung(&cargo, from, 50);
    // x'' + c x' + (g / L) x = 0 after 10 seconds.
    let rate = (GRAVITY - 0.04f64).sqrt();
    let expected = 0.01 * f64::exp(-2.0) * (f64::cos(10.0 * rate) + 0.2 / rate * f64::sin(10.0 * rate));
    near(after.swing, [expected, 0.0], 2e-6);
}

#[wasm_bindgen_test(unsupported = test)]
fn speed_and_acceleration_stay_within_their_limits() {
    let cargo = cargo(LIMITS);
    let mut random = Random::new(1, Stream::Tasks);
    let mut state = CargoState::at_rest([0.0; 2]);
    let mut fastest: f64 = 0.0;
    for _ in 0..2000 {
        let wanted = [(); 2].map(|()| 6.0 * random.uniform() - 3.0);
        // Whatever the load does: it hangs still again.
        let after = cargo.drive(&CargoState { swing: [0.0; 2], swing_rate: [0.0; 2], ..state }, wanted, |_| {});
        let change = [0, 1].map(|i| after.velocity[i] - state.velocity[i]);
        assert!(length(after.velocity) <= 1.0 + 1e-12 && length(change) <= 0.2 + 1e-12, "{state:?} to {after:?}");
        fastest = fastest.max(length(after.velocity));
        state = after;
    }
    assert!(fastest > 0.99, "{fastest}");
}

#[wasm_bindgen_test(unsupported = test)]
fn beyond_the_limit_of_swing_nothing_moves() {
    let cargo = cargo(CargoLimits { swing_limit: 0.3, acceleration: 2.0, ..LIMITS });
    let mut state = CargoState::at_rest([1.0, 2.0]);
    // To and fro with the swing, until it is too large.
    for _ in 0..200 {
        let push = if state.swing_rate[0] > 0.0 { -2.0 } else { 2.0 };
        let mut states = Vec::new();
        let after = cargo.drive(&state, [push, 0.0], |state| states.push(*state));
        assert_eq!(states.last(), Some(&after));
        assert!(states[..states.len() - 1].iter().all(|state| cargo.is_within_limit(state)));
        state = after;
        if !cargo.is_within_limit(&state) {
            break;
        }
    }
    let beyond = length(state.swing);
    assert!(beyond > 0.3 && beyond < 0.35, "{state:?}");
    assert_eq!(cargo.drive(&state, [1.0, 1.0], |_| panic!("it moves")), state);
    let [Part::Disc { center, radius }, Part::Disc { center: load, radius: load_radius }] = cargo.footprint(&state)
    else {
        panic!("not two discs");
    };
    assert_eq!((center.x, load.x, load.y), (state.position[0], center.x + state.swing[0], center.y + state.swing[1]));
    assert_eq!((radius, load_radius), (0.25, 0.15));
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_outside_their_ranges_are_refused() {
    for (limits, code, pointer) in [
        (CargoLimits { radius: 0.0, ..LIMITS }, "out-of-range", "/radius"),
        (CargoLimits { load_radius: -0.1, ..LIMITS }, "out-of-range", "/load_radius"),
        (CargoLimits { rope: 0.05, ..LIMITS }, "out-of-range", "/rope"),
        (CargoLimits { rope: f64::NAN, ..LIMITS }, "not-finite", "/rope"),
        (CargoLimits { swing_limit: 0.0, ..LIMITS }, "out-of-range", "/swing_limit"),
        // At 45 degrees an acceleration of g makes the rope slack.
        (CargoLimits { swing_limit: 0.7072, acceleration: GRAVITY, ..LIMITS }, "out-of-range", "/swing_limit"),
        (CargoLimits { damping: 11.0, ..LIMITS }, "out-of-range", "/damping"),
        (CargoLimits { speed: f64::INFINITY, ..LIMITS }, "not-finite", "/speed"),
        (CargoLimits { acceleration: 0.0, ..LIMITS }, "out-of-range", "/acceleration"),
        (CargoLimits { time_step: 2.0, ..LIMITS }, "out-of-range", "/time_step"),
    ] {
        refuses(Cargo::new(limits), code, pointer);
    }
    cargo(CargoLimits { swing_limit: 0.707, acceleration: GRAVITY, ..LIMITS });
}

#[wasm_bindgen_test(unsupported = test)]
fn a_drive_has_the_same_bits_on_every_platform() {
    let cargo = cargo(CargoLimits { damping: 0.1, ..LIMITS });
    let mut fingerprint = Fingerprint::default();
    let mut state = CargoState::at_rest([1.0, 2.0]);
    for i in 0..500 {
        let acceleration = [7, 11].map(|k| f64::from(i * i % k) / f64::from(k - 1) - 0.5);
        state = cargo.drive(&state, acceleration, |_| {});
        fingerprint.numbers(&[state.position, state.velocity, state.swing, state.swing_rate].concat());
    }
    assert!(cargo.is_within_limit(&state), "{state:?}");
    assert_eq!(format!("{:016x}", fingerprint.value()), "af3175ced76b069e");
}

#[wasm_bindgen_test(unsupported = test)]
fn heavy_damping_and_a_fast_carrier_take_shorter_steps() {
    // Overdamped on a rope of 1000 km: the displacement falls behind at a rate that tends to a / c.
    let cargo = cargo(CargoLimits {
        rope: 1e6,
        damping: 10.0,
        speed: 100.0,
        acceleration: 1.0,
        swing_limit: 1e5,
        time_step: 1.0,
        ..LIMITS
    });
    let after = (0..5).fold(CargoState::at_rest([0.0; 2]), |state, _| cargo.drive(&state, [1.0, 0.0], |_| {}));
    near(after.swing_rate, [-0.1, 0.0], 1e-3);
    near(after.swing, [-0.49, 0.0], 1e-2);
}
