//! Inverse kinematics: microseconds to a target, by method and links; the nearest point; following a target.
//!
//! `cargo bench --bench reach` prints a table. A run pinned to one core is quieter.

#[allow(dead_code, reason = "tests use more of it")]
#[path = "../tests/common/arms.rs"]
mod arms;

use planarium::geometry::Vector;
use planarium::ik::{MethodOptions, Solver, SolverOptions, Target, follow, nearest_reachable};
use planarium::problem::Stepped;
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::run::Status;
use planarium::scenario::Scenario;
use std::hint::black_box;
use std::time::Instant;

/// Targets for each entry of the table.
const TARGETS: usize = 2000;

/// Arms of one kind, each with its world, a configuration and a target within reach.
struct Cell {
    cases: Vec<(Arm, Scenario, Vec<f64>, Target)>,
}

impl Cell {
    fn new(links: usize, has_limits: bool) -> Self {
        let mut random = Random::new(1, Stream::Samples);
        let mut case = || {
            let arm = arms::arm(&mut random, links, has_limits);
            let (q, target) = (arms::configuration(&mut random, &arm), arms::reachable(&mut random, &arm, false));
            (arm.clone(), arms::scenario(&arm, ""), q, target)
        };
        Self { cases: (0..TARGETS).map(|_| case()).collect() }
    }

    /// The median and the 99th percentile of the time for each case, in microseconds.
    fn time(&self, mut work: impl FnMut(&Arm, &Scenario, &[f64], Target) -> f64) -> String {
        let mut times: Vec<f64> = Vec::with_capacity(self.cases.len());
        for (arm, scenario, q, target) in &self.cases {
            let began = Instant::now();
            black_box(work(arm, scenario, q, *target));
            times.push(began.elapsed().as_secs_f64() * 1e6);
        }
        times.sort_by(f64::total_cmp);
        format!("{:.1} / {:.0}", times[TARGETS / 2], times[TARGETS * 99 / 100])
    }

    /// The same of a method, with the number of targets missed, if any.
    fn method(&self, id: &str) -> String {
        let method = MethodOptions::read(Some(id), &[]).expect("a method");
        let mut missed = 0;
        let time = self.time(|_, scenario, q, target| {
            let options = SolverOptions { method, start: Some(q.to_vec()), ..SolverOptions::to(target) };
            let mut run = Solver::new(scenario, &options).expect("a run");
            missed += usize::from(run.step(u64::MAX) != Status::Solved);
            run.error()
        });
        if missed == 0 { time } else { format!("{time} ({missed} missed)") }
    }
}

fn main() {
    println!(
        "Microseconds, median / 99 %: targets within reach; the nearest point to targets up to 1.5 times as far; follow to"
    );
    println!("such a target from anywhere, and along a hundredth of the reach.");
    println!("| links | limits | closed form | newton | damped | gradient | nearest | follow, far | follow, near |");
    println!("|---|---|---|---|---|---|---|---|---|");
    for links in [1, 2, 3, 4, 6, 8] {
        for has_limits in [false, true] {
            let cell = Cell::new(links, has_limits);
            let far =
                |arm: &Arm, target: Target| Target { point: arm.base() + (target.point - arm.base()) * 1.5, ..target };
            let closed = if links <= 2 { cell.method("closed-form") } else { String::new() };
            let [newton, damped, gradient] =
                ["newton", "damped-least-squares", "gradient-descent"].map(|id| cell.method(id));
            let nearest =
                cell.time(|arm, _, _, target| nearest_reachable(arm, far(arm, target)).expect("a target").distance);
            let apart = cell.time(|arm, _, q, target| follow(arm, q, far(arm, target)).expect("it follows").distance);
            let near = cell.time(|arm, _, q, target| {
                let point = arm.end_effector(q) + Vector::new(0.01 * arm.reach(), 0.0);
                follow(arm, q, Target { point, ..target }).expect("it follows").distance
            });
            let limits = if has_limits { "yes" } else { "no" };
            println!(
                "| {links} | {limits} | {closed} | {newton} | {damped} | {gradient} | {nearest} | {apart} | {near} |"
            );
        }
    }
}
