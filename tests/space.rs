//! The laws that every configuration space obeys.

use planarium::random::{Random, Stream};
use planarium::space::steering::Steering;
use planarium::space::{
    Coordinate, Lanes, Metric, MotionSpace, ProductSpace, Space, angular_distance, gap, gap_to_interval, wrap,
};
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;
use wide::f32x8;

const CASES: usize = 2000;

#[wasm_bindgen_test(unsupported = test)]
fn an_angle_is_wrapped_to_the_remainder_of_a_turn() {
    let mut random = Random::new(11, Stream::Samples);
    let drawn = (0..CASES).map(|_| 20.0 * (random.uniform() - 0.5));
    let ends =
        [-TAU, -PI, -0.0, 0.0, PI, TAU, 3.0 * PI].into_iter().flat_map(|end| [end.next_down(), end, end.next_up()]);
    for angle in drawn.chain(ends) {
        let rest = libm::remainder(angle, TAU);
        let expected = if rest <= -PI { PI } else { rest + 0.0 };
        assert_eq!(wrap(angle).to_bits(), expected.to_bits(), "{angle}");
    }
}

fn mixed(metric: Metric) -> ProductSpace<4> {
    ProductSpace::new(&[Coordinate::Circle, Coordinate::Interval { low: -4.0, high: 7.5 }, Coordinate::Circle], metric)
}

fn toruses() -> Vec<ProductSpace<4>> {
    let joints = [Coordinate::Circle; 4];
    [Metric::Sum, Metric::Euclidean]
        .into_iter()
        .flat_map(|metric| {
            let naive = mixed(metric).cut_open();
            let weighted = mixed(metric).weighted(&[0.3, 1e3, 2.5]);
            let line = [Coordinate::Line { low: -2.0, high: 7.0 }, Coordinate::Circle];
            let line = ProductSpace::new(&line, metric).weighted(&[1e-6, 1.0]);
            let whole =
                [ProductSpace::new(&joints, metric), ProductSpace::new(&joints[..3], metric), mixed(metric), naive];
            whole.into_iter().chain([weighted.cut_open(), weighted, line])
        })
        .collect()
}

/// Every law on random states of one space.
fn obeys_the_laws<S: Space>(space: &S) {
    let mut random = Random::new(7, Stream::Samples);
    let slack = 1e-14 * (1.0 + space.extent());
    for _ in 0..CASES {
        let states = [0; 3].map(|_| space.sample(&mut random));
        let at = obey_the_laws(space, states, random.uniform(), slack);
        let [a, b, _] = states;
        assert!(space.contains(&a), "a sample lies in the space: {a:?}");
        assert!(space.contains(&at), "a state between two others lies in the space");
        assert!(space.distance(&a, &b) <= space.extent() + slack, "the extent is the largest distance");
    }
}

/// The laws of any space on three of its states, up to `slack` for rounding; returns the state at `t` from the first to the
/// second.
fn obey_the_laws<S: Space>(space: &S, [a, b, c]: [S::State; 3], t: f64, slack: f64) -> S::State {
    let d = |x: &S::State, y: &S::State| space.distance(x, y);
    assert_eq!(space.state(space.coordinates(&a)), a, "a sample is canonical");
    assert_eq!(d(&a, &a).to_bits(), 0.0f64.to_bits(), "a state is at distance 0 from itself");
    assert!(!space.is_symmetric() || d(&a, &b).to_bits() == d(&b, &a).to_bits(), "symmetry, to the bit");
    assert!(d(&a, &c) <= d(&a, &b) + d(&b, &c) + slack, "triangle inequality");

    assert_eq!(space.interpolate(&a, &b, 0.0), a, "interpolation starts at the start");
    assert_eq!(space.interpolate(&a, &b, 1.0), b, "and ends at the end");
    let at = space.interpolate(&a, &b, t);
    assert_eq!(space.state(space.coordinates(&at)), at, "and is canonical");
    assert!((d(&a, &at) - t * d(&a, &b)).abs() <= slack, "a fraction t of the motion is a fraction t of the distance");
    assert!((d(&at, &b) - (1.0 - t) * d(&a, &b)).abs() <= slack, "and the rest is the rest");
    at
}

#[wasm_bindgen_test(unsupported = test)]
fn motions_without_steering_are_those_of_the_torus_to_the_bit() {
    for torus in toruses() {
        let space = MotionSpace::new(torus.clone());
        obeys_the_laws(&space);
        let mut random = Random::new(12, Stream::Samples);
        assert_eq!(space.extent().to_bits(), torus.extent().to_bits());
        assert!(space.is_symmetric() && space.is_norm_exact());
        for _ in 0..CASES {
            let ([a, b], t) = ([0; 2].map(|_| torus.sample(&mut random)), random.uniform());
            assert_eq!(space.distance(&a, &b).to_bits(), torus.distance(&a, &b).to_bits());
            assert_eq!(space.interpolate(&a, &b, t), torus.interpolate(&a, &b, t));
            assert_eq!([space.turn(&a, &b), space.sweep(&a, &b)], [torus.turn(&a, &b), torus.sweep(&a, &b)]);
            assert_eq!(space.curve(&a, &b), None);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn steered_motions_obey_the_laws_of_their_direction() {
    for steering in [Steering::Dubins, Steering::ReedsShepp] {
        for (size, radius) in [(1.0, 0.3), (10.0, 1.0), (1e3, 0.5), (2.0, 40.0)] {
            let torus = ProductSpace::<4>::of_placements([-0.5 * size, 0.0], [size, size], 0.7, 0.3);
            let space = MotionSpace::steered(torus.clone(), steering, radius);
            assert_eq!(space.is_symmetric(), steering == Steering::ReedsShepp);
            assert!(!space.is_norm_exact());
            let mut random = Random::new(13, Stream::Samples);
            // Aside by what rounding amounts to costs a car the root of it.
            let slack = 4.0 * (1e-12 * (size + radius) * radius).sqrt();
            for case in 0..CASES {
                let [a, b, c] = [0; 3].map(|_| space.sample(&mut random));
                // Often close by, where the bound is tight or rounding counts.
                let near = |i: usize| a[i] + [1e-15, 1e-9, 1e-3][case % 3] * (random.uniform() - 0.5);
                let b = if case % 4 == 0 { space.state(&[0, 1, 2].map(near)) } else { b };
                obey_the_laws(&space, [a, b, c], random.uniform(), slack);
                let d = |x: &[f64; 4], y: &[f64; 4]| space.distance(x, y);
                assert!(d(&a, &b) <= space.extent(), "the extent is no less than a distance");
                let bound = space.norm(|i| gap(a[i], b[i], torus.period(i)));
                assert!(bound <= d(&a, &b) && bound <= d(&b, &a), "the bound is never above, not by a bit");
                assert_eq!(space.distance_within(&a, &b, d(&a, &b)).to_bits(), d(&a, &b).to_bits());
                assert_eq!([space.turn(&a, &b), space.sweep(&a, &b)], [0.0; 2]);
                let curve = space.curve(&a, &b).expect("steered motions follow curves");
                assert!((curve.length() - d(&a, &b)).abs() <= 1e-12 * (size + radius));
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn toruses_boxes_and_placements_obey_the_laws_whatever_a_metre_and_a_radian_count() {
    toruses().iter().for_each(obeys_the_laws);
    obeys_the_laws(&ProductSpace::<2>::of_box(&[-3.0, 0.5], &[2.0, 9.0]));
    obeys_the_laws(&ProductSpace::<3>::of_box(&[0.0, 0.0, -1e6], &[1.0, 1e-3, 1e6]));
    for (translation, rotation) in [(0.7, 0.3), (1e-6, 1.0), (3.0, 1e-6), (1e6, 1e6)] {
        obeys_the_laws(&ProductSpace::<4>::of_placements([0.0, -1.0], [2.0, 5.0], translation, rotation));
    }
    let space = ProductSpace::<4>::of_placements([0.0, 0.0], [2.0, 2.0], 0.7, 0.3);
    let [a, b] = [[0.0, 0.0, 3.0], [0.3, 0.4, -3.0]].map(|q| space.state(&q));
    assert!((space.distance(&a, &b) - (0.7 * 0.5 + 0.3 * (TAU - 6.0))).abs() < 1e-15);
}

#[wasm_bindgen_test(unsupported = test)]
fn angles_wrap_into_the_half_open_circle_and_whole_turns_change_nothing() {
    // The distance from 1 to 5 of the course reports, in the shorter direction.
    let expected: f64 = 2.2831853071795862;
    let circle = ProductSpace::<2>::new(&[Coordinate::Circle], Metric::Sum);
    for distance in [angular_distance(1.0, 5.0), circle.distance(&circle.state(&[1.0]), &circle.state(&[5.0]))] {
        assert!((distance - expected).abs() <= expected.next_up() - expected);
    }
    for turns in [-1000.0, -2.0, -1.0, 0.0, 1.0, 3.0, 1000.0] {
        for angle in [0.0, 1.0, 3.0, -3.0, 0.5 * PI] {
            assert!((wrap(angle + turns * TAU) - angle).abs() < 1e-12, "{angle} after {turns} turns");
            assert!((angular_distance(1.0 + turns * TAU, 5.0) - expected).abs() < 1e-12);
        }
    }
    for (angle, expected) in [(PI, PI), (-PI, PI), (TAU, 0.0), (-0.0, 0.0)] {
        assert_eq!(wrap(angle).to_bits(), expected.to_bits(), "{angle}");
    }
    assert!(wrap(1e300).abs() <= PI);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_circle_wraps_and_an_interval_does_not() {
    let space = mixed(Metric::Sum);
    let (a, b) = (space.state(&[3.0, -3.0, 0.0]), space.state(&[-3.0, 3.0, 0.0]));
    assert!((space.distance(&a, &b) - (TAU - 6.0 + 6.0)).abs() < 1e-14, "the shorter direction on the circle alone");
    let middle = space.interpolate(&a, &b, 0.5);
    assert!((middle[0].abs() - PI).abs() < 1e-14 && middle[1].abs() < 1e-14, "{middle:?}");
    assert_eq!(space.state(&[0.0, 7.0, 0.0])[1], 7.0, "an interval's values are literal");
}

#[wasm_bindgen_test(unsupported = test)]
fn padding_changes_no_bit() {
    let joints = [Coordinate::Circle, Coordinate::Interval { low: -2.0, high: 5.0 }, Coordinate::Circle];
    for metric in [Metric::Sum, Metric::Euclidean] {
        let (tight, padded) = (ProductSpace::<3>::new(&joints, metric), ProductSpace::<8>::new(&joints, metric));
        let (mut one, mut other) = (Random::new(3, Stream::Samples), Random::new(3, Stream::Samples));
        for _ in 0..CASES {
            let (a, b) = (tight.sample(&mut one), tight.sample(&mut one));
            let (c, d) = (padded.sample(&mut other), padded.sample(&mut other));
            assert_eq!(tight.coordinates(&a), padded.coordinates(&c));
            assert_eq!(tight.distance(&a, &b).to_bits(), padded.distance(&c, &d).to_bits());
            let (at, same) = (tight.interpolate(&a, &b, 0.3), padded.interpolate(&c, &d, 0.3));
            assert_eq!(tight.coordinates(&at), padded.coordinates(&same));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn streams_of_one_seed_differ_and_each_is_the_same_again() {
    let first = |seed, stream| Random::new(seed, stream).bits();
    assert_eq!(first(1, Stream::Samples), first(1, Stream::Samples));
    assert_ne!(first(1, Stream::Samples), first(2, Stream::Samples));
    assert_ne!(first(1, Stream::Samples), first(1, Stream::Shortcut));
    let mut random = Random::new(11, Stream::Samples);
    assert!((0..CASES).all(|_| (0.0..1.0).contains(&random.uniform())));
    let mut seen = [0usize; 5];
    (0..5000).for_each(|_| seen[random.below(5) as usize] += 1);
    assert!(seen.iter().all(|&count| (800..1200).contains(&count)), "all of five about equally often: {seen:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn every_lane_of_a_vector_has_the_bits_of_a_single_number() {
    let turn = TAU as f32;
    let numbers = [0.0, f32::MIN_POSITIVE, 1e-9, 1.0, PI as f32, -PI as f32, 5.0, turn];
    let mut random = Random::new(17, Stream::Samples);
    for case in 0..CASES {
        let mut drawn = || -> [f32; 8] {
            std::array::from_fn(|lane| match case % 3 {
                0 => numbers[(random.uniform() * 8.0) as usize],
                1 => (TAU * random.uniform() - PI) as f32,
                _ => numbers[lane] + 1e-7 * random.uniform() as f32,
            })
        };
        let (a, b) = (drawn(), drawn());
        let bits = |vector: f32x8| vector.to_array().map(f32::to_bits);
        let singles = |one: &dyn Fn(f32, f32) -> f32| std::array::from_fn(|lane| one(a[lane], b[lane]).to_bits());
        let [va, vb] = [a, b].map(f32x8::new);
        assert_eq!(bits(va.greater(vb)), singles(&f32::max));
        for period in [TAU, f64::INFINITY] {
            let (turn, turns) = (period as f32, f32x8::splat(period as f32));
            let shorter = |a: f32, b: f32| (a - b).abs().min(turn - (a - b).abs());
            assert_eq!(bits(gap(va, vb, turns)), singles(&shorter));
            let outside = |below: f32, above: f32| below.max(above).min(turn + below.min(above)).max(0.0);
            assert_eq!(bits(gap_to_interval(va, vb, turns)), singles(&outside));
        }
    }
    let filler = gap(f32x8::splat(1.0), f32x8::splat(f32::NAN), f32x8::splat(turn));
    assert!(filler.to_array().into_iter().all(f32::is_nan), "empty lanes stay NaN");
}
