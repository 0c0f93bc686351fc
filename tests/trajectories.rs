//! Trajectories. Two: closed forms against halving, and both against known cases. Many: none crosses another, the same in any
//! slices, with the index and without.

use crate::common::documents::refuses;
use crate::common::{cases, given};
use planarium::Error;
use planarium::geometry::Point;
use planarium::options::{Kind, Options, Value};
use planarium::problem::{Status, Stepped};
use planarium::random::{Random, Stream};
use planarium::trajectories::{MOST_TURNING, Model, Particle, Trajectories, TrajectoryOptions, crossing, halve};
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

fn crosses(a: &Particle, b: &Particle) -> bool {
    let [one, other] = [crossing(a, b), crossing(b, a)].map(|found| found.expect("particles in range").is_some());
    assert_eq!(one, other, "{a:?} {b:?}");
    one
}

/// Whether two trajectories cross, by closed forms and by halving: apart is proven again with a hundredth of the slack, crossing
/// stays crossing with five slacks.
#[track_caller]
fn judged(a: &Particle, b: &Particle) -> bool {
    let scale = |p: &Particle| p.start.x.abs().max(p.start.y.abs()) + p.speed * p.duration;
    let (eta, crosses) = (1e-12 * scale(a).max(scale(b)), crosses(a, b));
    let again = halve(a, b, if crosses { 5.0 * eta } else { 0.01 * eta }, PLENTY);
    assert!(again.pairs < PLENTY, "the oracle gave up on {a:?} {b:?}");
    assert_eq!(crosses, again.meeting.is_some(), "{a:?} {b:?}");
    crosses
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

    fn point(&mut self, most: f64) -> [f64; 2] {
        [(); 2].map(|()| self.within(-most, most))
    }

    fn angle(&mut self) -> f64 {
        self.within(-PI, PI)
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
        refuses(crossing(&arc(bad), &arc(good)), code, pointer);
        refuses(crossing(&arc(good), &arc(bad)), code, &pointer.replace("/0", "/1"));
    }
    refuses(crossing(&arc([0.0, 0.0, 0.0, 1e5, 0.0, 20.0]), &arc(good)), "out-of-range", "/0/duration");
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
    for model in [Model::Arc, Model::Spiral] {
        for turn_rate in [0.0, 1e-15, 0.4, -3.0, 20.0] {
            let one = particle(model, [0.3, -0.2, 1.1, 0.8, turn_rate, 1.0]);
            assert!(judged(&one, &one));
        }
    }
    // Overlapping arcs of one circle, driven in opposite directions; a circle about another's arc does not touch it.
    assert!(judged(&about([0.2, 0.1], 0.7, 0.0, 2.0), &about([0.2, 0.1], 0.7, 3.0, -2.0)));
    assert!(!judged(&about([0.2, 0.1], 0.7, 0.0, 2.0), &about([0.2, 0.1], 0.7, 2.5, 2.0)));
    assert!(!judged(&about([0.0, 0.0], 1.0, 0.0, 7.0), &about([0.0, 0.0], 0.5, 0.0, 50.0)));
    // A segment passes through the gap of an open circle, not through its other side.
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
            let turn_rate = if kind == 0 { 0.0 } else { draws.angle() };
            let speed = if kind == 1 { 0.0 } else { draws.within(0.0, 2.0) };
            let duration = if kind == 2 { draws.within(1.0, 8.0) } else { 1.0 };
            let model = if i % 3 == 0 { Model::Spiral } else { Model::Arc };
            let [x, y] = draws.point(1.0);
            particle(model, [x, y, draws.angle(), speed, turn_rate, duration])
        })
    });
    assert!(crossing > cases(1000) && cases(20_000) - crossing > cases(2000), "{crossing}");
}

#[wasm_bindgen_test(unsupported = test)]
fn radii_and_turns_of_all_sizes_are_judged_alike() {
    let mut draws = Draws::new(2);
    let crossing = crossings(cases(20_000), |_| {
        // Both pass near one point, so that about half of them cross there.
        let near = draws.point(1.0);
        [(); 2].map(|()| {
            let length = draws.magnitude(-6.0, 0.5);
            let turn = draws.sign() * draws.magnitude(-16.0, 1.5);
            let (theta, before) = (draws.angle(), draws.within(-0.2, 1.2) * length);
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
        let (center, direction) = (draws.point(1.0), draws.angle());
        // Outside: the centres r + s + gap apart. Inside: |r - s| - gap apart, if the circles are large enough.
        let outside = draws.0.below(2) == 0;
        let apart = if outside { r + s + gap } else { (r - s).abs() - gap };
        if apart <= 0.0 || gap.abs() > r.min(s) {
            continue;
        }
        let other = [center[0] + apart * libm::cos(direction), center[1] + apart * libm::sin(direction)];
        let a = about(center, r, draws.angle(), 2.0 * PI + 0.1);
        let b = about(other, s, draws.angle(), -2.0 * PI - 0.1);
        assert_eq!(crosses(&a, &b), gap <= 0.0, "{gap} {a:?} {b:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn arcs_that_end_at_a_gap_from_another_are_judged_by_the_gap() {
    let mut draws = Draws::new(4);
    for _ in 0..cases(20_000) {
        // A ray from the centre of a whole circle that begins at the gap from it, inside or outside; straight or bent.
        let (r, gap) = (draws.magnitude(-4.0, 0.5), draws.sign() * draws.magnitude(-9.8, -1.0));
        let (center, direction) = (draws.point(1.0), draws.angle());
        let circle = about(center, r, draws.angle(), 6.5);
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
        let direction = draws.angle();
        let other = [shift * libm::cos(direction), shift * libm::sin(direction)];
        let a = about([0.0, 0.0], r, draws.angle(), draws.sign() * draws.within(0.5, 7.0));
        [a, about(other, r + growth, draws.angle(), draws.sign() * draws.within(0.5, 7.0))]
    });
    assert!(crossing > tried / 10 && crossing < tried, "{crossing} of {tried}");
}

#[wasm_bindgen_test(unsupported = test)]
fn arcs_that_share_an_end_cross_whatever_their_sizes() {
    let mut draws = Draws::new(6);
    for _ in 0..cases(20_000) {
        let [x, y] = draws.point(1.0);
        let [a, b] = [(); 2].map(|()| {
            let (length, turn) = (draws.magnitude(-8.0, 0.5), draws.sign() * draws.magnitude(-12.0, 1.0));
            arc([x, y, draws.angle(), length, turn, 1.0])
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
            let [x, y] = draws.point(0.5);
            particle(model, [x, y, draws.angle(), 1.0, draws.within(-9.0, 9.0), 1.0])
        });
        // Positions 1/200 s apart are at most 1/200 m apart on the arc, ten times that on the spiral.
        let [p, q] = [a, b].map(|one| (0..=200).map(|k| one.position(f64::from(k) / 200.0)).collect::<Vec<_>>());
        let nearest = p.iter().flat_map(|p| q.iter().map(move |q| (p - q).norm())).fold(f64::MAX, f64::min);
        let apart = halve(&a, &b, 1e-12, PLENTY).meeting.is_none();
        assert!(nearest > 0.0 || !apart);
        let step = if model == Model::Arc { 0.005 } else { 0.05 };
        assert!(apart || nearest <= step, "{nearest} {a:?} {b:?}");
        // With a slack as wide as the smallest gap between samples they meet.
        assert!(halve(&a, &b, nearest.max(1e-9), PLENTY).meeting.is_some());
    }
}

fn begun(options: &str, seed: u64) -> Result<Trajectories, Error> {
    Trajectories::new(&Options::read(&given(options))?, seed)
}

fn begin(options: &str, seed: u64) -> Trajectories {
    begun(options, seed).unwrap_or_else(|error| panic!("{error}"))
}

fn finish(mut trajectories: Trajectories) -> Trajectories {
    trajectories.step(u64::MAX);
    trajectories
}

fn particles(trajectories: &Trajectories) -> Vec<Particle> {
    trajectories.accepted().copied().collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn the_index_changes_nothing_but_the_work() {
    let worlds = [
        "count=400",
        "count=300 model=spiral",
        "count=200 fastest=100",
        "count=200 fastest=1000 duration=3 greatest_turn_rate=30 max_iterations=600",
        "count=300 least_turn_rate=0 greatest_turn_rate=0",
        "count=300 fastest=0",
        "count=50 half_side=0.01 max_iterations=500",
        "count=300 half_side=1000 fastest=100 duration=2 least_turn_rate=-50 greatest_turn_rate=50",
        "count=400 spread=0 least_turn_rate=0.001 greatest_turn_rate=0.001 slowest=1",
    ];
    for options in worlds {
        let with = finish(begin(options, 1));
        let without = finish(begin(&format!("{options} index=none"), 1));
        assert_eq!(with.fingerprint(), without.fingerprint(), "{options}");
        assert_eq!(with.tries(), without.tries());
        assert!(with.tally().boxes <= without.tally().boxes, "{options}");
        assert_eq!(with.tally().iterations, without.tally().iterations);
    }
}

/// Every pair of accepted ones is judged by halving, which uses neither the index nor the closed forms; every refused one must
/// meet the one it names within a few slacks, and their common point must lie on both.
fn check_all_pairs(options: &str, seed: u64) {
    let done = finish(begin(options, seed));
    let accepted = particles(&done);
    let eta = 1e-14;
    for (i, a) in accepted.iter().enumerate() {
        for b in &accepted[..i] {
            assert_eq!(halve(a, b, eta, 100_000_000).meeting, None, "{options}: {a:?} {b:?}");
        }
    }
    for refused in done.refused() {
        let other = &accepted[refused.other as usize];
        assert!(halve(&refused.particle, other, 3e-11, 100_000_000).meeting.is_some(), "{options}: {refused:?}");
        for one in [&refused.particle, other] {
            let positions = (0..=3000).map(|k| one.position(one.duration * f64::from(k) / 3000.0));
            let nearest = positions.map(|p| (p - refused.point).norm()).fold(f64::MAX, f64::min);
            assert!(nearest < 1e-3 * (1.0 + one.speed * one.duration * 5.0), "{options}: {nearest} {refused:?}");
        }
    }
    // Only those refused since the last that was accepted belong to none.
    let (last, all) = (done.tries().iter().map(|&tries| u64::from(tries)).sum::<u64>(), done.tally().iterations);
    assert!(last == all || last < all && done.status() != Status::Solved);
    assert_eq!(done.accepted().len() + done.refused().len(), done.tally().iterations as usize);
}

#[wasm_bindgen_test(unsupported = test)]
fn no_pair_of_accepted_trajectories_crosses() {
    let many = !cfg!(target_arch = "wasm32");
    check_all_pairs(if many { "" } else { "count=200" }, 0);
    check_all_pairs(if many { "model=spiral" } else { "count=100 model=spiral" }, 1);
    check_all_pairs("count=150 fastest=8 least_turn_rate=-20 greatest_turn_rate=20 max_iterations=1500", 2);
    check_all_pairs("count=100 slowest=2 fastest=2 least_turn_rate=7 greatest_turn_rate=9 max_iterations=1500", 3);
    check_all_pairs("count=200 least_turn_rate=-1e-9 greatest_turn_rate=1e-9", 4);
    check_all_pairs("count=150 fastest=4 least_turn_rate=0 greatest_turn_rate=0 max_iterations=1500", 5);
}

#[wasm_bindgen_test(unsupported = test)]
fn draws_lie_in_their_ranges_and_changing_one_range_does_not_affect_the_others() {
    let options =
        "count=300 half_side=2 spread=1 slowest=0.2 fastest=0.4 least_turn_rate=-1 greatest_turn_rate=2 duration=0.5";
    let done = finish(begin(options, 9));
    assert_eq!(done.status(), Status::Solved);
    let (mut low, mut high) = ([f64::MAX; 5], [f64::MIN; 5]);
    for particle in particles(&done) {
        let [x, y, theta, v, w, duration] = particle.numbers();
        assert_eq!(duration, 0.5);
        for (i, value) in [x, y, theta, v, w].into_iter().enumerate() {
            (low[i], high[i]) = (low[i].min(value), high[i].max(value));
        }
    }
    let ranges = [(-2.0, 2.0), (-2.0, 2.0), (-1.0, 1.0), (0.2, 0.4), (-1.0, 2.0)];
    for (i, (least, most)) in ranges.into_iter().enumerate() {
        let edge = 0.05 * (most - least);
        assert!(low[i] >= least && low[i] < least + edge && high[i] <= most && high[i] > most - edge, "{i}");
    }
    // The first draw never crosses anything.
    let (mut one, mut other) = (begin("", 4), begin("fastest=0.5 spread=0", 4));
    one.step(1);
    other.step(1);
    let (one, other) = (particles(&one)[0], particles(&other)[0]);
    assert_eq!((one.start, one.turn_rate), (other.start, other.turn_rate));
    assert_eq!((one.speed, other.theta), (2.0 * other.speed, 0.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_crowded_square_is_exhausted() {
    let done = finish(begin("count=1000 half_side=0.2 slowest=1 max_iterations=2000", 0));
    assert_eq!(done.status(), Status::Exhausted);
    assert_eq!(done.tally().iterations, 2000);
    assert!(done.accepted().len() < 100);
    let text = planarium::json::to_string(&done.result());
    assert!(text.contains(r#""status":"exhausted""#), "{text}");
}

#[wasm_bindgen_test(unsupported = test)]
fn accepted_and_refused_trajectories_are_only_appended() {
    let mut trajectories = begin("", 2);
    trajectories.step(400);
    let (accepted, refused) = (particles(&trajectories), trajectories.refused().to_vec());
    assert!(!refused.is_empty() && accepted.len() > 100);
    trajectories.step(400);
    assert!(particles(&trajectories).len() > accepted.len() && particles(&trajectories).starts_with(&accepted));
    assert!(trajectories.refused().len() > refused.len() && trajectories.refused().starts_with(&refused));
    for refused in trajectories.refused() {
        assert_eq!(refused.numbers()[6], f64::from(refused.other));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_is_complete_and_its_extremes_are_in_range() {
    for info in TrajectoryOptions::table() {
        assert!(info.title.len() > 3 && info.meaning.ends_with('.'), "{}", info.name);
        match (info.kind, info.default) {
            (Kind::Integer(range) | Kind::Number(range), Some(Value::Number(default))) => {
                assert!(range.contains(&default), "{}", info.name);
            }
            (Kind::Choice(words), Some(Value::Text(word))) => assert_eq!(words[0], word),
            other => panic!("{}: {other:?}", info.name),
        }
    }
    let defaults = TrajectoryOptions::default();
    assert_eq!((defaults.model, defaults.count, defaults.half_side), (Model::Arc, 1000, 3.0));
    let extremes = [
        "count=100000 half_side=10000 fastest=1000 duration=1000 least_turn_rate=-0.1 greatest_turn_rate=0.1 max_iterations=300",
        "count=100 half_side=0.01 fastest=1000 duration=0.1 least_turn_rate=-1000 greatest_turn_rate=1000 max_iterations=300",
        "count=100 duration=0.001 max_iterations=1000",
        "model=spiral count=50 fastest=1000 duration=0.1 least_turn_rate=-1000 greatest_turn_rate=1000 max_iterations=200",
    ];
    for options in extremes {
        let done = finish(begin(options, 3));
        assert_eq!(done.accepted().len() + done.refused().len(), done.tally().iterations as usize, "{options}");
    }
}
