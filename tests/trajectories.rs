//! Many trajectories: none crosses another, the same in any slices, on every platform, with the index and without.

use crate::common::{given, golden};
use planarium::options::{Kind, Options, Value};
use planarium::problem::Status;
use planarium::trajectories::{Model, Particle, Trajectories, TrajectoryOptions, halve};
use serde_json::Value as Json;
use wasm_bindgen_test::wasm_bindgen_test;

fn begin(options: &str, seed: u64) -> Trajectories {
    Trajectories::new(&given(options), seed).unwrap_or_else(|error| panic!("{error}"))
}

fn finish(mut trajectories: Trajectories) -> Trajectories {
    trajectories.step(u64::MAX);
    trajectories
}

fn particles(trajectories: &Trajectories) -> Vec<Particle> {
    trajectories.accepted_since(0).copied().collect()
}

/// The outcome of a golden case.
fn outcome(case: &Json) -> Json {
    let options = case["options"].as_object().expect("options").iter();
    let given: Vec<_> = options.map(|(name, value)| (name.clone(), Value::from(value))).collect();
    let done = finish(Trajectories::new(&given, case["seed"].as_u64().expect("a seed")).expect("options in range"));
    serde_json::to_value(done.result()).expect("a document")
}

#[wasm_bindgen_test(unsupported = test)]
fn every_case_has_its_golden_outcome() {
    golden::check("golden-trajectories.json", include_str!("golden-trajectories.json"), 10, outcome);
}

#[wasm_bindgen_test(unsupported = test)]
fn slices_do_not_change_the_result() {
    for options in ["count=300", "count=200 model=spiral", "count=100 fastest=40 max_iterations=900"] {
        let whole = finish(begin(options, 5));
        for slice in [1, 7, 100] {
            let mut sliced = begin(options, 5);
            while sliced.step(slice) == Status::Running {}
            assert_eq!(sliced.fingerprint(), whole.fingerprint(), "{options}, slices of {slice}");
            assert_eq!(sliced.tally(), whole.tally());
            assert_eq!(sliced.tries(), whole.tries());
        }
        let before = whole.fingerprint();
        let mut whole = whole;
        whole.step(100);
        assert_eq!(whole.fingerprint(), before, "no more is done once it has ended");
        assert_ne!(finish(begin(options, 6)).fingerprint(), before);
    }
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
    for refused in done.refused_since(0) {
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
    assert_eq!(done.accepted_count() + done.refused_count(), done.tally().iterations as usize);
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
    assert!(done.accepted_count() < 100);
    let text = planarium::json::to_string(&done.result());
    assert!(text.contains(r#""status":"exhausted""#), "{text}");
}

#[wasm_bindgen_test(unsupported = test)]
fn cursors_return_the_new_rows() {
    let mut trajectories = begin("", 2);
    trajectories.step(400);
    let (accepted, refused) = (trajectories.accepted_count(), trajectories.refused_count());
    assert!(refused > 0 && accepted > 100);
    trajectories.step(400);
    assert_eq!(trajectories.accepted_since(accepted).len(), trajectories.accepted_count() - accepted);
    assert_eq!(trajectories.refused_since(refused).len(), trajectories.refused_count() - refused);
    assert_eq!(trajectories.accepted_since(10_000).len(), 0);
    assert_eq!(trajectories.refused_since(10_000).len(), 0);
    for refused in trajectories.refused_since(0) {
        assert_eq!(refused.numbers()[6], f64::from(refused.other));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn bad_options_are_refused_with_code_and_pointer() {
    let cases = [
        ("colour=red", "unknown-parameter", "/colour"),
        ("count=0", "out-of-range", "/count"),
        ("count=2.5", "out-of-range", "/count"),
        ("count=many", "wrong-type", "/count"),
        ("count=5 count=6", "duplicate-field", "/count"),
        ("half_side=NaN", "not-finite", "/half_side"),
        ("half_side=0", "out-of-range", "/half_side"),
        ("spread=4", "out-of-range", "/spread"),
        ("slowest=-1", "out-of-range", "/slowest"),
        ("slowest=2", "out-of-range", "/slowest"),
        ("fastest=1e9", "out-of-range", "/fastest"),
        ("least_turn_rate=4", "out-of-range", "/least_turn_rate"),
        ("greatest_turn_rate=1e4", "out-of-range", "/greatest_turn_rate"),
        ("duration=0", "out-of-range", "/duration"),
        ("duration=50", "out-of-range", "/duration"),
        ("model=line", "out-of-range", "/model"),
        ("index=tree", "out-of-range", "/index"),
        ("index=3", "wrong-type", "/index"),
        ("max_iterations=0", "out-of-range", "/max_iterations"),
    ];
    for (options, code, pointer) in cases {
        let error = TrajectoryOptions::new(&given(options), 0).expect_err(options);
        assert_eq!((error.code().as_str(), error.pointer()), (code, pointer), "{options}: {error}");
        assert!(error.message().len() > 15, "{error}");
    }
    let error = TrajectoryOptions::new(&[], 1 << 53).expect_err("too large a seed");
    assert_eq!((error.code().as_str(), error.pointer()), ("out-of-range", "/seed"));
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
    let defaults = TrajectoryOptions::new(&[], 0).expect("the defaults go together");
    assert_eq!((defaults.model, defaults.count, defaults.half_side), (Model::Arc, 1000, 3.0));
    let extremes = [
        "count=100000 half_side=10000 fastest=1000 duration=1000 least_turn_rate=-0.1 greatest_turn_rate=0.1 max_iterations=300",
        "count=100 half_side=0.01 fastest=1000 duration=0.1 least_turn_rate=-1000 greatest_turn_rate=1000 max_iterations=300",
        "count=100 duration=0.001 max_iterations=1000",
        "model=spiral count=50 fastest=1000 duration=0.1 least_turn_rate=-1000 greatest_turn_rate=1000 max_iterations=200",
    ];
    for options in extremes {
        let done = finish(begin(options, 3));
        assert_eq!(done.accepted_count() + done.refused_count(), done.tally().iterations as usize, "{options}");
    }
}
