//! Runs of inverse kinematics: they reach what can be reached, within limits, and never say so wrongly.

use crate::common::arms::{arm, deviation, is_within, reachable, scenario};
use crate::common::cases;
use planarium::ik::{Solver, SolverOptions, Verdict};
use planarium::random::{Random, Stream};
use planarium::run::Status;
use wasm_bindgen_test::wasm_bindgen_test;

/// Tries a method on random arms, half of them with limits, a third of those of three links and more with an orientation.
fn success(method: &str, all: usize, tolerance: f64) {
    let cases = cases(all) as u64;
    let mut random = Random::new(20, Stream::Samples);
    let mut failed = Vec::new();
    let mut worst = 0;
    let mut total = [0u64; 9];
    for case in 0..cases {
        let links = 2 + (case % 7) as usize;
        let arm = arm(&mut random, links, case % 2 == 0);
        let is_oriented = links >= 3 && random.below(3) == 0;
        let target = reachable(&mut random, &arm, is_oriented);
        let options = SolverOptions { method: Some(method.into()), seed: case, ..SolverOptions::to(target) };
        let mut run = Solver::new(&scenario(&arm, ""), &options).expect("a run");
        run.step(u64::MAX);
        total[links] += run.iterations();
        worst = worst.max(run.iterations());
        for iterate in run.iterates() {
            assert!(is_within(&arm, &iterate.configuration), "case {case}: {:?}", iterate.configuration);
        }
        match run.status() {
            Status::Solved => {
                let [distance, turn] = deviation(&arm, &run.solutions()[0][..links], &target);
                assert!(
                    distance <= tolerance + 1e-14 && turn <= tolerance + 1e-14,
                    "case {case}: {distance:e}, {turn:e}"
                );
                assert_eq!(run.explain(), Verdict::Reached);
            }
            _ => {
                assert_eq!(run.explain(), Verdict::NotFound, "case {case}: {arm:?} {target:?}");
                failed.push(case);
            }
        }
    }
    println!("{method}: failed {failed:?}, worst {worst}, total {total:?}");
    assert!(failed.len() as u64 * 1000 <= cases, "{method} failed {} of {cases}: {failed:?}", failed.len());
}

#[wasm_bindgen_test(unsupported = test)]
fn newton_reaches_what_can_be_reached() {
    success("newton", 10_000, 1e-9);
}

#[wasm_bindgen_test(unsupported = test)]
fn damped_least_squares_reaches_what_can_be_reached() {
    success("damped-least-squares", 10_000, 1e-9);
}

#[wasm_bindgen_test(unsupported = test)]
fn gradient_descent_reaches_what_can_be_reached() {
    success("gradient-descent", 10_000, 1e-4);
}
