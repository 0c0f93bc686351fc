//! Shortest curves of cars: against numerical search, known values and the laws they obey.

use crate::common::cases;
use nalgebra::{Matrix3, Vector3};
use planarium::fingerprint::Fingerprint;
use planarium::random::{Random, Stream};
use planarium::space::steering::{Curve, Pose, Steering, Turn, advance, dubins, reeds_shepp, wrap};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

type Steer = fn(Pose, Pose, f64) -> Curve;
const BOTH: [(&str, Steer); 2] = [("dubins", dubins), ("reeds-shepp", reeds_shepp)];

fn pose(x: f64, y: f64, heading: f64) -> Pose {
    Pose { x, y, heading }
}

const ORIGIN: Pose = Pose { x: 0.0, y: 0.0, heading: 0.0 };

fn between(a: Pose, b: Pose) -> f64 {
    ((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)).sqrt()
}

fn uniform(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * random.uniform()
}

/// A heading: mostly any, often one that is special.
fn heading(random: &mut Random) -> f64 {
    match random.below(8) {
        0 => 0.0,
        1 => PI,
        2 => FRAC_PI_2,
        3 => -FRAC_PI_2,
        4 => 1e-9,
        5 => wrap(PI + 1e-12),
        _ => wrap(uniform(random, -PI, PI)),
    }
}

/// A pose near another or far from it, often straight ahead, beside or behind.
fn near(random: &mut Random, from: Pose, radius: f64) -> Pose {
    let exponent = uniform(random, -13.0, 2.0);
    let distance = if random.below(2) == 0 { uniform(random, 0.0, 6.0) } else { libm::pow(10.0, exponent) };
    let direction = from.heading + heading(random);
    let (sin, cos) = libm::sincos(direction);
    let turn = heading(random);
    pose(from.x + radius * distance * cos + 0.0, from.y + radius * distance * sin + 0.0, wrap(from.heading + turn))
}

/// A start, a radius and a goal near it.
fn case(random: &mut Random) -> (Pose, Pose, f64) {
    let exponent = uniform(random, -2.0, 2.0);
    let radius = if random.below(2) == 0 { 1.0 } else { libm::pow(10.0, exponent) };
    let size = [0.0, 1.0, 100.0][random.below(3) as usize];
    let from = pose(uniform(random, -size, size) + 0.0, uniform(random, -size, size) + 0.0, heading(random));
    (from, near(random, from, radius), radius)
}

#[wasm_bindgen_test(unsupported = test)]
fn an_arc_does_not_cancel_where_the_turn_is_small() {
    let quarter = advance(pose(1.0, 2.0, 0.0), 0.5, PI);
    assert!(between(quarter, pose(3.0, 4.0, 0.0)) < 1e-15 && quarter.heading == FRAC_PI_2);
    assert_eq!(advance(pose(1.0, 2.0, FRAC_PI_2), 0.0, -2.0).y, 0.0);
    for exponent in 1..300 {
        let curvature = libm::pow(10.0, -f64::from(exponent));
        let end = advance(ORIGIN, curvature, 2.0);
        // s - k^2 s^3 / 6 and k s^2 / 2 - k^3 s^4 / 24, for what follows is below the last bit from 1e-4 on.
        let k = curvature;
        let (x, y) = (2.0 - k * k * 8.0 / 6.0, k * 2.0 - k * k * k * 16.0 / 24.0);
        if exponent >= 4 {
            assert!((end.x - x).abs() <= 4e-16 && (end.y - y).abs() <= 4e-16 * y, "{curvature}: {end:?}");
        }
    }
    let mut random = Random::new(1, Stream::Samples);
    for _ in 0..cases(10_000) {
        let [x, y, k, s, t] = [5.0, 5.0, 3.0, 4.0, 4.0].map(|most| uniform(&mut random, -most, most));
        let from = pose(x, y, heading(&mut random));
        let (once, twice) = (advance(from, k, s + t), advance(advance(from, k, s), k, t));
        assert!(between(once, twice) < 2e-14 && wrap(once.heading - twice.heading).abs() < 2e-14);
        assert!(once.heading > -PI && once.heading <= PI);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_curve_ends_at_its_goal_and_is_as_long_as_its_segments() {
    for (name, steer) in BOTH {
        let mut random = Random::new(2, Stream::Samples);
        for _ in 0..cases(50_000) {
            let (from, to, radius) = case(&mut random);
            let curve = steer(from, to, radius);
            let largest = [from.x, from.y, to.x, to.y].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let slack = 4e-13 * (radius + between(from, to) + largest);
            let end = curve.end(from);
            assert!(between(end, to) <= slack, "{name} {from:?} {to:?} {radius}: {curve:?} ends at {end:?}");
            assert!(wrap(end.heading - to.heading).abs() <= 4e-13, "{name} {from:?} {to:?} {radius}: {end:?}");
            assert_eq!(curve.at(from, curve.length()), end);
            assert_eq!(curve.at(from, 0.0), from);
            let sum: f64 = curve.segments().iter().map(|segment| segment.length.abs()).sum();
            assert!((sum - curve.length()).abs() <= 1e-15 * sum);
            assert!(curve.segments().iter().all(|segment| segment.length.is_finite() && segment.length != 0.0));
            let is_forwards = curve.segments().iter().all(|segment| segment.length > 0.0);
            assert!(name == "reeds-shepp" || is_forwards, "{curve:?}");
            // No curve is shorter.
            assert!(curve.length() >= between(from, to) - slack);
            assert!(curve.length() >= radius * wrap(from.heading - to.heading).abs() - slack);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn known_curves_have_their_known_lengths() {
    for (to, expected) in [
        (pose(0.0, 0.0, 0.0), [0.0; 2]),
        (pose(5.0, 0.0, 0.0), [5.0; 2]),
        (pose(0.0, 2.0, PI), [PI; 2]),
        (pose(1.0, 1.0, FRAC_PI_2), [FRAC_PI_2; 2]),
        // About face: three arcs of 60, 300 and 60 degrees, or three of 60 with two changes of gear.
        (pose(0.0, 0.0, PI), [7.0 * PI / 3.0, PI]),
        // Straight back.
        (pose(-3.0, 0.0, 0.0), [TAU + 3.0, 3.0]),
    ] {
        for ((name, steer), expected) in BOTH.into_iter().zip(expected) {
            let found = steer(ORIGIN, to, 1.0).length();
            assert!((found - expected).abs() < 1e-12, "{name} to {to:?}: {found}, not {expected}");
        }
    }
    // An S-curve by hand: centres (0, 1) and (4, 1) of a left and a right circle, the line between them crosses at (2, 1).
    let s_curve = dubins(ORIGIN, pose(4.0, 2.0, 0.0), 1.0);
    let turn = libm::asin(2.0 / 4.0);
    assert!((s_curve.length() - (2.0 * turn + f64::sqrt(16.0 - 4.0))).abs() < 1e-12, "{s_curve:?}");
    // Parked sideways by y: backwards, forwards on either lock, and backwards again. The first circle and the last are 2 + y
    // apart, and the two between them, alike, make that |4 - 2 exp(-iu)|.
    let parked = reeds_shepp(ORIGIN, pose(0.0, 0.5, 0.0), 1.0);
    let u = libm::acos((20.0 - 2.5 * 2.5) / 16.0);
    let t = libm::atan2(libm::sin(u), 2.0 - libm::cos(u));
    assert!((parked.length() - 2.0 * (t + u)).abs() < 1e-12, "{parked:?}");
    let turns: Vec<Turn> = parked.segments().iter().map(|segment| segment.turn).collect();
    assert!(turns.windows(2).all(|pair| pair[0] == pair[1].mirrored()));
}

/// The segments of a family of words for three unknown lengths.
type Family = (&'static str, fn([f64; 3]) -> Vec<(Turn, f64)>);

const L: Turn = Turn::Left;
const S: Turn = Turn::Straight;
const R: Turn = Turn::Right;
const Q: f64 = FRAC_PI_2;

const FORWARDS: &[Family] = &[
    ("LSL", |[t, u, v]| vec![(L, t), (S, u), (L, v)]),
    ("LSR", |[t, u, v]| vec![(L, t), (S, u), (R, v)]),
    ("LRL", |[t, u, v]| vec![(L, t), (R, u), (L, v)]),
];

const SHUNTING: &[Family] = &[
    ("LRLR, alike and back", |[t, u, v]| vec![(L, t), (R, u), (L, -u), (R, v)]),
    ("LRLR, alike", |[t, u, v]| vec![(L, t), (R, u), (L, u), (R, v)]),
    ("LRSL+", |[t, u, v]| vec![(L, t), (R, Q), (S, u), (L, v)]),
    ("LRSL-", |[t, u, v]| vec![(L, t), (R, -Q), (S, u), (L, v)]),
    ("LRSR+", |[t, u, v]| vec![(L, t), (R, Q), (S, u), (R, v)]),
    ("LRSR-", |[t, u, v]| vec![(L, t), (R, -Q), (S, u), (R, v)]),
    ("LSRL+", |[t, u, v]| vec![(L, t), (S, u), (R, Q), (L, v)]),
    ("LSRL-", |[t, u, v]| vec![(L, t), (S, u), (R, -Q), (L, v)]),
    ("LSLR+", |[t, u, v]| vec![(L, t), (S, u), (L, Q), (R, v)]),
    ("LSLR-", |[t, u, v]| vec![(L, t), (S, u), (L, -Q), (R, v)]),
    ("LRSLR+", |[t, u, v]| vec![(L, t), (R, Q), (S, u), (L, Q), (R, v)]),
    ("LRSLR-", |[t, u, v]| vec![(L, t), (R, -Q), (S, u), (L, -Q), (R, v)]),
];

/// The curvature of a turn at radius 1.
fn curvature(turn: Turn) -> f64 {
    match turn {
        L => 1.0,
        S => 0.0,
        R => -1.0,
    }
}

fn drive(segments: &[(Turn, f64)]) -> Pose {
    segments.iter().fold(ORIGIN, |at, &(turn, length)| advance(at, curvature(turn), length))
}

/// Newton's method on the end of the drive, derivatives by differences: lengths that lead to the goal, if it finds them.
fn solve(family: fn([f64; 3]) -> Vec<(Turn, f64)>, goal: Pose, mut lengths: [f64; 3]) -> Option<[f64; 3]> {
    let miss = |lengths| {
        let end = drive(&family(lengths));
        [end.x - goal.x, end.y - goal.y, wrap(end.heading - goal.heading)]
    };
    for _ in 0..25 {
        let at = miss(lengths);
        if at.iter().all(|part| part.abs() < 1e-11) {
            return Some(lengths);
        }
        let derivative = Matrix3::from_columns(&[0, 1, 2].map(|i| {
            let mut other = lengths;
            other[i] += 1e-7;
            let there = miss(other);
            Vector3::from_fn(|row, _| wrap(there[row] - at[row]) / 1e-7)
        }));
        let inverse = derivative.try_inverse().filter(|_| derivative.determinant().abs() >= 1e-9)?;
        let step = inverse * Vector3::from(at);
        [0, 1, 2].into_iter().for_each(|i| lengths[i] -= step[i].clamp(-1.0, 1.0));
    }
    None
}

/// The shortest curve that numerical search finds among the families and their mirror images.
fn searched(random: &mut Random, families: &[Family], goal: Pose, is_forwards: bool) -> f64 {
    let mut best = f64::INFINITY;
    for &(_, family) in families {
        for mirror in [false, true] {
            let goal = if mirror { pose(goal.x, -goal.y, -goal.heading) } else { goal };
            for _ in 0..24 {
                let start =
                    [0; 3].map(|_| if is_forwards { uniform(random, 0.0, TAU) } else { uniform(random, -PI, PI) });
                let Some(lengths) = solve(family, goal, start) else { continue };
                let parts = family(lengths).into_iter().map(|(turn, length)| match turn {
                    S if is_forwards && length < -1e-9 => f64::INFINITY,
                    S => length.abs(),
                    _ if is_forwards => (length + 1e-9).rem_euclid(TAU) - 1e-9,
                    _ => wrap(length).abs(),
                });
                best = best.min(parts.sum());
            }
        }
    }
    best
}

#[wasm_bindgen_test(unsupported = test)]
fn numerical_search_over_words_finds_the_same_lengths_and_none_below() {
    for (name, steer) in BOTH {
        let mut random = Random::new(3, Stream::Samples);
        let all = [FORWARDS, SHUNTING].concat();
        let is_forwards = name == "dubins";
        let families = if is_forwards { FORWARDS } else { &all };
        let tried = cases(300);
        let mut found = 0;
        for _ in 0..tried {
            let size = [0.5, 2.0, 5.0][random.below(3) as usize];
            let [x, y] = [0; 2].map(|_| uniform(&mut random, -size, size));
            let goal = pose(x, y, uniform(&mut random, -PI, PI));
            let (ours, best) = (steer(ORIGIN, goal, 1.0).length(), searched(&mut random, families, goal, is_forwards));
            assert!(best >= ours - 1e-8, "{name} to {goal:?}: {ours}, but {best} is shorter");
            found += usize::from(best <= ours + 1e-8);
        }
        assert!(found * 100 >= tried * 97, "{name}: the search found only {found} of {tried}");
    }
}

/// Bellman's principle: whatever is driven first, what is left is not shortened by more than what was driven. With an end
/// that is met this makes a length the least of all drives, of any number of segments.
#[wasm_bindgen_test(unsupported = test)]
fn no_first_move_gains_more_than_its_length_and_one_gains_as_much() {
    for (name, steer) in BOTH {
        let mut random = Random::new(4, Stream::Samples);
        let gears: &[f64] = if name == "dubins" { &[1.0] } else { &[1.0, -1.0] };
        for _ in 0..cases(20_000) {
            let size = [0.1, 1.0, 3.0, 8.0][random.below(4) as usize];
            let [x, y] = [0; 2].map(|_| uniform(&mut random, -size, size));
            let goal = pose(x, y, heading(&mut random));
            let whole = steer(ORIGIN, goal, 1.0).length();
            let step = [1e-3, 0.05, 1.0][random.below(3) as usize];
            let mut most: f64 = -1.0;
            for gear in gears {
                for curvature in [1.0, 0.0, -1.0, uniform(&mut random, -1.0, 1.0)] {
                    let left = steer(advance(ORIGIN, curvature, gear * step), goal, 1.0).length();
                    assert!(whole <= step + left + 1e-9, "{name} to {goal:?}: {whole} > {step} + {left}");
                    most = most.max(whole - left);
                }
            }
            let first = steer(ORIGIN, goal, 1.0).segments()[0].length.abs();
            assert!(first < step || (most - step).abs() < 1e-9, "{name} to {goal:?}: no move of {step} gains that");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_piece_of_a_curve_is_the_curve_of_its_ends() {
    for (name, steer) in BOTH {
        let mut random = Random::new(6, Stream::Samples);
        for _ in 0..cases(30_000) {
            let (from, to, radius) = case(&mut random);
            let whole = steer(from, to, radius);
            let [s, t] = [0; 2].map(|_| whole.length() * random.uniform());
            let [s, t] = match random.below(4) {
                0 => [0.0, t],
                1 => [s, whole.length()],
                _ => [s.min(t), s.max(t)],
            };
            let [a, b] = [s, t].map(|along| if along < whole.length() { whole.at(from, along) } else { to });
            let piece = steer(a, b, radius);
            // Aside by what rounding amounts to costs a car the root of it.
            let slack = 2e-6 * radius + 1e-9 * (whole.length() + from.x.abs() + from.y.abs());
            let off = (piece.length() - (t - s)).abs();
            assert!(off <= slack, "{name} {from:?} {to:?} {radius} {s} {t}: {whole:?} {piece:?}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn curves_are_symmetric_as_cars_are() {
    let mut random = Random::new(7, Stream::Samples);
    for _ in 0..cases(30_000) {
        let (from, to, radius) = case(&mut random);
        let slack = 1e-9 * (radius + between(from, to));
        let mirror = |p: Pose| pose(p.x, -p.y, wrap(-p.heading));
        let turned = |p: Pose| pose(p.x, p.y, wrap(p.heading + PI));
        for (name, steer) in BOTH {
            let length = steer(from, to, radius).length();
            let in_mirror = steer(mirror(from), mirror(to), radius).length();
            assert!((length - in_mirror).abs() <= slack, "{name} {from:?} {to:?}: {length}, mirrored {in_mirror}");
            let back = steer(turned(to), turned(from), radius).length();
            assert!((length - back).abs() <= slack, "{name} {from:?} {to:?}: {length}, from the goal {back}");
        }
        let (there, back) = (reeds_shepp(from, to, radius), reeds_shepp(to, from, radius));
        assert_eq!(there.reversed(), back, "reversed, to the bit");
        assert_eq!(there.length().to_bits(), back.length().to_bits());
        assert!(there.length() <= dubins(from, to, radius).length() + slack, "reverse gears make nothing longer");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn lengths_obey_the_triangle_inequality_and_scale_with_the_radius() {
    for (name, steer) in BOTH {
        let mut random = Random::new(8, Stream::Samples);
        for _ in 0..cases(30_000) {
            let (a, b, radius) = case(&mut random);
            let middle = if random.below(2) == 0 { a } else { b };
            let c = near(&mut random, middle, radius);
            let d = |p, q| steer(p, q, radius).length();
            let slack = 1e-9 * (radius + between(a, b) + between(b, c) + a.x.abs() + a.y.abs());
            assert!(d(a, c) <= d(a, b) + d(b, c) + slack, "{name} {a:?} {b:?} {c:?} {radius}");
            // A power of two scales every number exactly.
            let scaled = |p: Pose| pose(4.0 * p.x, 4.0 * p.y, p.heading);
            let (one, four) = (steer(a, b, radius), steer(scaled(a), scaled(b), 4.0 * radius));
            assert_eq!((4.0 * one.length()).to_bits(), four.length().to_bits());
            // But for poses so close that they are apart by rounding at one radius and not at the other.
            let wider = if between(a, b) > 1e-11 * radius { steer(a, b, 1.5 * radius) } else { one };
            assert!(d(a, b) <= wider.length() + slack, "{name} {a:?} {b:?} {radius}: {one:?} {wider:?}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn rounding_costs_neither_a_loop_nor_a_shunt() {
    let mut random = Random::new(9, Stream::Samples);
    for _ in 0..cases(30_000) {
        let size = [1.0, 1e3, 1e6][random.below(3) as usize];
        let from = pose(uniform(&mut random, -size, size), uniform(&mut random, -size, size), heading(&mut random));
        let turn = [L, S, R][random.below(3) as usize];
        let curvature = curvature(turn);
        let exponent = uniform(&mut random, -8.0, 0.4);
        let length = libm::pow(10.0, exponent);
        let to = advance(from, curvature, length);
        for (name, steer) in BOTH {
            let curve = steer(from, to, 1.0);
            assert_eq!(curve.segments().len(), 1, "{curvature} {name} {from:?} {to:?} {length}: {curve:?}");
            assert!((curve.length() - length).abs() <= 1e-14 * size.max(100.0), "{name} {length}: {curve:?}");
        }
    }
}

/// Also poses at the end of words, where several are as long as each other, and equal ones.
fn tied(random: &mut Random) -> (Pose, Pose, f64) {
    let (from, to, radius) = case(random);
    if random.below(2) == 0 {
        return (from, to, radius);
    }
    let mut to = from;
    for _ in 0..random.below(5) {
        let turn = curvature([L, S, R][random.below(3) as usize]);
        let length = [Q, -Q, PI, 1.0, -1.0, uniform(random, -0.5, 0.5)][random.below(6) as usize];
        to = advance(to, turn / radius, length * radius);
    }
    (from, to, radius)
}

#[wasm_bindgen_test(unsupported = test)]
fn a_length_within_a_limit_is_the_length_to_the_bit_and_beyond_it_is_greater() {
    let mut random = Random::new(11, Stream::Samples);
    for _ in 0..cases(400_000) {
        let (from, to, radius) = tied(&mut random);
        for steering in [Steering::Dubins, Steering::ReedsShepp] {
            let length = steering.shortest(from, to, radius).length();
            let part = 2.0 * random.uniform();
            for most in [length, length.next_down(), length * (1.0 + 1e-12), length * (1.0 - 1e-12), length * part, 0.0]
            {
                let found = steering.length_within(from, to, radius, most);
                let is_right = if length <= most { found.to_bits() == length.to_bits() } else { found > most };
                assert!(is_right, "{steering:?} {from:?} {to:?} {radius}: {length}, within {most} {found}");
            }
            assert_eq!(steering.length_within(from, to, radius, f64::INFINITY).to_bits(), length.to_bits());
        }
    }
}

/// The expected number is that of a search through all words in their order, without any bounds.
#[wasm_bindgen_test(unsupported = test)]
fn bounds_on_words_change_no_bit() {
    let mut random = Random::new(12, Stream::Samples);
    let mut hash = Fingerprint::default();
    for _ in 0..100_000 {
        let (from, to, radius) = tied(&mut random);
        for (_, steer) in BOTH {
            for segment in steer(from, to, radius).segments() {
                hash.integer(segment.turn as u64);
                hash.numbers(&[segment.length]);
            }
        }
    }
    assert_eq!(hash.value(), 0x668c_52d3_5f21_6a69, "{:016x}", hash.value());
}

#[wasm_bindgen_test(unsupported = test)]
fn curves_have_the_same_bits_on_every_platform() {
    let mut random = Random::new(10, Stream::Samples);
    let mut hash = Fingerprint::default();
    for _ in 0..2000 {
        let (from, to, radius) = case(&mut random);
        for (_, steer) in BOTH {
            let curve = steer(from, to, radius);
            let middle = curve.at(from, 0.5 * curve.length());
            hash.numbers(&[curve.length(), middle.x, middle.y, middle.heading]);
            for segment in curve.segments() {
                hash.integer(segment.turn as u64);
                hash.numbers(&[segment.length]);
            }
        }
    }
    assert_eq!(hash.value(), 0x5184_ec8d_7b9e_dc02, "{:016x}", hash.value());
}
