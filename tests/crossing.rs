//! Particles, and whether two trajectories cross: closed forms against halving, and both against known cases.

use crate::common::cases;
use planarium::geometry::Point;
use planarium::random::{Random, Stream};
use planarium::trajectories::{MOST_TURNING, Model, Particle, crossing, halve};
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

/// Enough pairs of intervals for every pair of trajectories here.
const PLENTY: u64 = 20_000_000;

fn particle(model: Model, [x, y, theta, speed, turn_rate, duration]: [f64; 6]) -> Particle {
    Particle { model, start: Point::new(x, y), theta, speed, turn_rate, duration }
}

fn arc(numbers: [f64; 6]) -> Particle {
    particle(Model::Arc, numbers)
}

/// The arc about a centre, from an angle on over a turn, in one second.
fn about(center: [f64; 2], radius: f64, from: f64, turn: f64) -> Particle {
    let (sin, cos) = (libm::sin(from), libm::cos(from));
    let theta = from + if turn < 0.0 { -PI / 2.0 } else { PI / 2.0 };
    arc([center[0] + radius * cos, center[1] + radius * sin, theta, radius * turn.abs(), turn, 1.0])
}

fn scale(a: &Particle, b: &Particle) -> f64 {
    [a, b].map(|p| p.start.x.abs().max(p.start.y.abs()) + p.speed * p.duration).into_iter().fold(0.0, f64::max)
}

fn crosses(a: &Particle, b: &Particle) -> bool {
    let answer = crossing(a, b).expect("a particle in range");
    assert_eq!(answer.is_some(), crossing(b, a).expect("likewise").is_some(), "{a:?} {b:?}");
    answer.is_some()
}

/// Whether two trajectories cross, by closed forms and by halving: apart is proven again with a hundredth of the slack, crossing
/// stays crossing with five slacks.
#[track_caller]
fn judged(a: &Particle, b: &Particle) -> bool {
    let eta = 1e-12 * scale(a, b);
    let answer = crosses(a, b);
    let again = if answer { halve(a, b, 5.0 * eta, PLENTY) } else { halve(a, b, 0.01 * eta, PLENTY) };
    assert!(again.pairs < PLENTY, "the oracle gave up on {a:?} {b:?}");
    assert_eq!(answer, again.meeting.is_some(), "{a:?} {b:?}");
    answer
}

/// How many of so many drawn pairs cross, each judged by closed forms and by halving.
fn crossings(cases: usize, mut draw: impl FnMut(usize) -> [Particle; 2]) -> usize {
    let is_crossing = |case: &usize| {
        let [a, b] = draw(*case);
        judged(&a, &b)
    };
    (0..cases).filter(is_crossing).count()
}

struct Draws(Random);

impl Draws {
    fn new(seed: u64) -> Self {
        Self(Random::new(seed, Stream::Samples))
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + self.0.uniform() * (high - low)
    }

    /// A number from 10^low to 10^high, uniform in its logarithm.
    fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        libm::pow(10.0, self.within(low, high))
    }

    fn sign(&mut self) -> f64 {
        if self.0.below(2) == 0 { -1.0 } else { 1.0 }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_spiral_has_its_published_points() {
    let spiral = particle(Model::Spiral, [0.0, 0.0, 0.0, 1.0, PI / 4.0, 1.0]);
    let first = spiral.position(0.1);
    assert!((first.x - 0.0996917333733128).abs() < 1e-15 && (first.y - 0.007845909572784495).abs() < 1e-15, "{first}");
    assert!((spiral.position(0.2).x - 0.19753766811902757).abs() < 1e-15);
    assert_eq!(spiral.position(0.0), Point::origin());
}

#[wasm_bindgen_test(unsupported = test)]
fn the_arc_has_its_radius_and_loses_no_digits_if_it_hardly_turns() {
    let half = arc([1.0, 2.0, 0.0, PI, PI, 1.0]);
    // Half a circle of radius 1 to the left: across from the start.
    assert!((half.position(1.0) - Point::new(1.0, 4.0)).norm() < 1e-15);
    for time in [0.1, 0.37, 0.9] {
        assert!(((half.position(time) - Point::new(1.0, 3.0)).norm() - 1.0).abs() < 1e-15);
    }
    for turn_rate in [1e-300, 1e-17, 1e-12, 1e-9, 1e-6] {
        let place = arc([0.0, 0.0, 0.0, 1.0, turn_rate, 1.0]).position(1.0);
        // y = (1 - cos w) / w = w / 2 - w^3 / 24 + ...
        let y = turn_rate / 2.0 - turn_rate * turn_rate * turn_rate / 24.0;
        assert!((place.y - y).abs() <= 1e-15 * y && (place.x - 1.0).abs() < 1e-12, "{turn_rate} {place}");
    }
    assert_eq!(arc([0.0, 0.0, 0.0, 1.0, 0.0, 1.0]).position(0.5), Point::new(0.5, 0.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn particles_out_of_range_are_refused_with_the_field() {
    let good = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    let cases = [
        (0, f64::NAN, "not-finite", "/0/x"),
        (1, f64::INFINITY, "not-finite", "/0/y"),
        (1, -2e6, "out-of-range", "/0/y"),
        (2, 101.0, "out-of-range", "/0/theta"),
        (3, -1.0, "out-of-range", "/0/v"),
        (4, 1e7, "out-of-range", "/0/w"),
        (4, MOST_TURNING + 1.0, "out-of-range", "/0/duration"),
        (5, -0.5, "out-of-range", "/0/duration"),
        (5, 1e5, "out-of-range", "/0/duration"),
    ];
    for (i, value, code, pointer) in cases {
        let mut bad = good;
        bad[i] = value;
        let error = crossing(&arc(bad), &arc(good)).expect_err("out of range");
        assert_eq!((error.code().as_str(), error.pointer()), (code, pointer), "{value}");
        let error = crossing(&arc(good), &arc(bad)).expect_err("out of range");
        assert_eq!(error.pointer(), pointer.replace("/0", "/1"));
    }
    let long = crossing(&arc([0.0, 0.0, 0.0, 1e5, 0.0, 20.0]), &arc(good)).expect_err("too long a way");
    assert_eq!((long.code().as_str(), long.pointer()), ("out-of-range", "/0/duration"));
}

#[wasm_bindgen_test(unsupported = test)]
fn contact_is_crossing_and_the_smallest_gap_is_not() {
    let gaps = [(0.0, true), (1e-13, true), (1e-10, false), (1e-7, false), (0.1, false)];
    for (gap, expected) in gaps {
        // Whole circles beside each other and within each other; halves; a segment beside a circle; a point on it.
        let pairs = [
            (about([0.0, 0.0], 1.0, 0.3, 2.0 * PI), about([2.0 + gap, 0.0], 1.0, 2.0, -7.0)),
            (about([0.0, 0.0], 1.0, 0.3, 2.0 * PI), about([0.7 - gap, 0.0], 0.3, 2.0, 6.3)),
            (about([0.0, 0.0], 1.0, -1.0, 2.0), about([2.0 + gap, 0.0], 1.0, PI - 1.0, 2.0)),
            (about([0.0, 0.0], 1.0, 0.0, 7.0), arc([1.0 + gap, -2.0, PI / 2.0, 4.0, 0.0, 1.0])),
            (about([0.0, 0.0], 1.0, 0.0, 7.0), arc([1.0 + gap, 0.0, 0.0, 0.0, 1.0, 1.0])),
            (arc([0.0, 0.0, 0.0, 1.0, 0.0, 1.0]), arc([0.5, gap, 1.0, 0.5, 0.0, 1.0])),
            (arc([0.0, 0.0, 0.0, 1.0, 0.0, 1.0]), arc([1.0 + gap, 0.0, 0.0, 1.0, 0.0, 1.0])),
            (arc([1.0, 1.0, 0.0, 0.0, 0.0, 1.0]), arc([1.0 + gap, 1.0, 0.0, 0.0, 2.0, 1.0])),
            // Arcs one after the other on one circle, and side by side on concentric ones.
            (about([0.0, 0.0], 1.0, 0.0, 1.0), about([0.0, 0.0], 1.0, 1.0 + gap, 1.0)),
            (about([0.0, 0.0], 1.0, 0.0, 1.0), about([0.0, 0.0], 1.0 + gap, -0.5, 2.0)),
        ];
        for (i, (a, b)) in pairs.into_iter().enumerate() {
            assert_eq!(crosses(&a, &b), expected, "pair {i}, gap {gap}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn equal_and_overlapping_trajectories_cross() {
    for &model in Model::ALL {
        for turn_rate in [0.0, 1e-15, 0.4, -3.0, 20.0] {
            let one = particle(model, [0.3, -0.2, 1.1, 0.8, turn_rate, 1.0]);
            assert!(judged(&one, &one));
        }
    }
    // Overlapping arcs of one circle, driven in opposite directions; a circle about another's arc does not touch it.
    assert!(judged(&about([0.2, 0.1], 0.7, 0.0, 2.0), &about([0.2, 0.1], 0.7, 3.0, -2.0)));
    assert!(!judged(&about([0.2, 0.1], 0.7, 0.0, 2.0), &about([0.2, 0.1], 0.7, 2.5, 2.0)));
    assert!(!judged(&about([0.0, 0.0], 1.0, 0.0, 7.0), &about([0.0, 0.0], 0.5, 0.0, 50.0)));
    // The gap of an open circle is passed by a segment, its other side is not.
    let open = about([0.0, 0.0], 1.0, 0.1, 2.0 * PI - 0.2);
    assert!(!judged(&open, &arc([0.0, 0.0, 0.0, 3.0, 0.0, 1.0])));
    assert!(judged(&open, &arc([0.0, 0.0, 0.2, 3.0, 0.0, 1.0])));
    assert!(judged(&open, &arc([0.0, 0.0, PI, 3.0, 0.0, 1.0])));
}

#[wasm_bindgen_test(unsupported = test)]
fn random_trajectories_are_judged_alike_by_closed_forms_and_by_halving() {
    let mut draws = Draws::new(1);
    let crossing = crossings(cases(20_000), |i| {
        [(); 2].map(|()| {
            let kind = draws.0.below(5);
            let turn_rate = if kind == 0 { 0.0 } else { draws.within(-PI, PI) };
            let speed = if kind == 1 { 0.0 } else { draws.within(0.0, 2.0) };
            let duration = if kind == 2 { draws.within(1.0, 8.0) } else { 1.0 };
            let model = if i % 3 == 0 { Model::Spiral } else { Model::Arc };
            let place = [draws.within(-1.0, 1.0), draws.within(-1.0, 1.0)];
            particle(model, [place[0], place[1], draws.within(-PI, PI), speed, turn_rate, duration])
        })
    });
    assert!(crossing > cases(1000) && cases(20_000) - crossing > cases(2000), "{crossing}");
}

#[wasm_bindgen_test(unsupported = test)]
fn radii_and_turns_of_all_sizes_are_judged_alike() {
    let mut draws = Draws::new(2);
    let crossing = crossings(cases(20_000), |_| {
        // Both pass near one point, so that about half of them cross there.
        let near = [draws.within(-1.0, 1.0), draws.within(-1.0, 1.0)];
        [(); 2].map(|()| {
            let length = draws.magnitude(-6.0, 0.5);
            let turn = draws.sign() * draws.magnitude(-16.0, 1.5);
            let (theta, before) = (draws.within(-PI, PI), draws.within(-0.2, 1.2) * length);
            let start = [near[0] - before * libm::cos(theta), near[1] - before * libm::sin(theta)];
            arc([start[0], start[1], theta, length, turn, 1.0])
        })
    });
    assert!(crossing > cases(1000) && crossing < cases(20_000), "{crossing}");
}

#[wasm_bindgen_test(unsupported = test)]
fn tangent_circles_are_judged_by_their_gap() {
    let mut draws = Draws::new(3);
    for _ in 0..cases(20_000) {
        let (r, s) = (draws.magnitude(-5.0, 0.5), draws.magnitude(-5.0, 0.5));
        let gap = draws.sign() * draws.magnitude(-10.0, -1.0);
        let (center, direction) = ([draws.within(-1.0, 1.0), draws.within(-1.0, 1.0)], draws.within(-PI, PI));
        // Outside: the centres r + s + gap apart. Inside: |r - s| - gap apart, if the circles are large enough.
        let outside = draws.0.below(2) == 0;
        let apart = if outside { r + s + gap } else { (r - s).abs() - gap };
        if apart <= 0.0 || gap.abs() > r.min(s) {
            continue;
        }
        let other = [center[0] + apart * libm::cos(direction), center[1] + apart * libm::sin(direction)];
        let a = about(center, r, draws.within(-PI, PI), 2.0 * PI + 0.1);
        let b = about(other, s, draws.within(-PI, PI), -2.0 * PI - 0.1);
        assert_eq!(crosses(&a, &b), gap <= 0.0, "{gap} {a:?} {b:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn arcs_that_end_at_a_gap_from_another_are_judged_by_the_gap() {
    let mut draws = Draws::new(4);
    for _ in 0..cases(20_000) {
        // A ray from the centre of a whole circle that begins at the gap from it, inside or outside; straight or bent.
        let (r, gap) = (draws.magnitude(-4.0, 0.5), draws.sign() * draws.magnitude(-9.8, -1.0));
        let (center, direction) = ([draws.within(-1.0, 1.0), draws.within(-1.0, 1.0)], draws.within(-PI, PI));
        let circle = about(center, r, draws.within(-PI, PI), 6.5);
        let from = r + gap;
        if from < 0.5 * r || gap.abs() > 0.2 * r {
            continue;
        }
        let start = [center[0] + from * libm::cos(direction), center[1] + from * libm::sin(direction)];
        let turn = draws.sign() * draws.magnitude(-14.0, 0.0);
        let out = arc([start[0], start[1], direction, 0.3 * r, turn, 1.0]);
        assert_eq!(crosses(&circle, &out), gap < 0.0, "{gap} {circle:?} {out:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn nearly_concentric_and_nearly_equal_circles_are_judged_alike() {
    let mut draws = Draws::new(5);
    let tried = cases(1000);
    let crossing = crossings(tried, |_| {
        let r = draws.within(0.5, 1.5);
        // Gaps that halving, which needs about 1 / sqrt(gap) intervals, can decide.
        let (shift, growth) = (draws.magnitude(-7.0, -1.0), draws.sign() * draws.magnitude(-7.0, -1.0));
        let direction = draws.within(-PI, PI);
        let other = [shift * libm::cos(direction), shift * libm::sin(direction)];
        let a = about([0.0, 0.0], r, draws.within(-PI, PI), draws.sign() * draws.within(0.5, 7.0));
        [a, about(other, r + growth, draws.within(-PI, PI), draws.sign() * draws.within(0.5, 7.0))]
    });
    assert!(crossing > tried / 10 && crossing < tried, "{crossing} of {tried}");
}

#[wasm_bindgen_test(unsupported = test)]
fn arcs_that_share_an_end_cross_whatever_their_sizes() {
    let mut draws = Draws::new(6);
    for _ in 0..cases(20_000) {
        let shared = [draws.within(-1.0, 1.0), draws.within(-1.0, 1.0)];
        let [a, b] = [(); 2].map(|()| {
            let (length, turn) = (draws.magnitude(-8.0, 0.5), draws.sign() * draws.magnitude(-12.0, 1.0));
            arc([shared[0], shared[1], draws.within(-PI, PI), length, turn, 1.0])
        });
        assert!(crosses(&a, &b), "{a:?} {b:?}");
        // One begins where the other ends, up to rounding.
        let end = a.position(a.duration);
        assert!(crosses(&a, &Particle { start: end, ..b }), "{a:?} {b:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn halving_never_reports_as_apart_what_samples_find_together() {
    let mut draws = Draws::new(8);
    for i in 0..cases(1000) {
        let model = if i % 2 == 0 { Model::Arc } else { Model::Spiral };
        let [a, b] = [(); 2].map(|()| {
            let place = [draws.within(-0.5, 0.5), draws.within(-0.5, 0.5)];
            particle(model, [place[0], place[1], draws.within(-PI, PI), 1.0, draws.within(-9.0, 9.0), 1.0])
        });
        // Places 1/200 s apart are at most 1/200 m of the arc apart, ten times that of the spiral: within a quarter of that
        // of each other somewhere, a gap of five times that is seen.
        let places = |one: &Particle| (0..=200).map(|k| one.position(f64::from(k) / 200.0)).collect::<Vec<_>>();
        let (p, q) = (places(&a), places(&b));
        let nearest = p.iter().flat_map(|p| q.iter().map(move |q| (p - q).norm())).fold(f64::MAX, f64::min);
        let apart = halve(&a, &b, 1e-12, PLENTY).meeting.is_none();
        assert!(nearest > 0.0 || !apart);
        let step = if model == Model::Arc { 0.005 } else { 0.05 };
        assert!(apart || nearest <= step, "{nearest} {a:?} {b:?}");
        // With a slack as wide as the gap seen it must meet.
        assert!(halve(&a, &b, nearest.max(1e-9), PLENTY).meeting.is_some());
    }
}
