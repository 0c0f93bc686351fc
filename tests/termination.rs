//! Where runs of planners that go on to shorter paths end: at the first iteration at which the conditions hold, computed here from the
//! history of a longer run.

use crate::common::{begin_with, car_and_wall, disc_and_wall, finish};
use planarium::run::{HISTORY_WIDTH, Status};
use planarium::scenario::Scenario;
use wasm_bindgen_test::wasm_bindgen_test;

/// The length of the path after each iteration, from 1, and the clearance evaluations by then.
struct History {
    lengths: Vec<f64>,
    evaluations: Vec<f64>,
}

impl History {
    fn of(world: &Scenario, planner: &str, settings: &str) -> Self {
        let mut run = begin_with(world, planner, 3, settings);
        run.record().expect("nothing is done yet");
        let history = finish(run).history_since(0);
        let column = |i: usize| history.chunks(HISTORY_WIDTH).map(|row| row[i]).collect();
        Self { lengths: column(HISTORY_WIDTH - 1), evaluations: column(HISTORY_WIDTH - 2) }
    }

    /// The length after an iteration.
    fn length(&self, iteration: usize) -> f64 {
        self.lengths[iteration - 1]
    }

    /// Whether a condition holds after an iteration, by its definition.
    fn holds(&self, condition: &str, iteration: usize) -> bool {
        let (name, value) = condition.split_once('=').expect("name=value");
        let value: f64 = value.parse().expect("a number");
        let now = self.length(iteration);
        let first = 1 + self.lengths.iter().position(|length| length.is_finite()).expect("a path");
        match name {
            "stop_evaluations" => self.evaluations[iteration - 1] >= value,
            _ if iteration < first => false,
            "improve_iterations" => iteration >= first + value as usize,
            "stop_cost" => now <= value,
            "stop_stale" => iteration >= first + value as usize && self.length(iteration - value as usize) == now,
            "stop_converged" => {
                let half = (iteration - first) / 2;
                half >= 500 && self.length(iteration - half) * (1.0 - value) <= now
            }
            other => panic!("{other}"),
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_ends_as_soon_as_one_of_the_conditions_holds_or_all() {
    let sst = "selection_radius=0.3 pruning_radius=0.15";
    for (world, planner, settings) in [(disc_and_wall(0.3, 0.5), "rrt-star", ""), (car_and_wall(0.1), "sst", sst)] {
        let long = History::of(&world, planner, &format!("{settings} improve_iterations=2000"));
        let last = long.lengths.len();
        let first = long.lengths.iter().copied().find(|length| length.is_finite()).expect("a path");
        let conditions = [
            format!("stop_evaluations={}", (0.6 * long.evaluations[last - 1]).floor()),
            format!("stop_cost={}", 0.3 * first + 0.7 * long.length(last)),
            "stop_stale=300".to_owned(),
            "stop_converged=0.02".to_owned(),
        ];
        let mut ends = Vec::new();
        // The number of further iterations is always given.
        for (rule, improve) in
            [("any", "improve_iterations=1500"), ("all", "improve_iterations=0"), ("all", "improve_iterations=700")]
        {
            for others in 0..1 << conditions.len() {
                let given = (0..conditions.len()).filter(|i| others >> i & 1 == 1).map(|i| conditions[i].as_str());
                let given: Vec<&str> = given.chain([improve]).collect();
                let holds = |i: usize| {
                    let mut all = given.iter().map(|one| long.holds(one, i));
                    if rule == "any" { all.any(|holds| holds) } else { all.all(|holds| holds) }
                };
                let what = format!("{settings} {} stop_when={rule}", given.join(" "));
                let Some(expected) = (1..=last).find(|&i| holds(i)) else { continue };
                let run = finish(begin_with(&world, planner, 3, &what));
                assert_eq!(run.iterations(), expected as u64, "{planner} {what}");
                assert_eq!(run.status(), Status::Solved, "{planner} {what}");
                assert_eq!(run.length(), long.length(expected), "{planner} {what}");
                ends.push(expected);
            }
        }
        ends.sort_unstable();
        ends.dedup();
        assert!(ends.len() > 5, "{planner}: {ends:?} differ");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn evaluations_are_a_budget_before_the_first_path_too() {
    let world = disc_and_wall(0.3, 0.5);
    let run = finish(begin_with(&world, "rrt-star", 3, "stop_evaluations=50"));
    assert_eq!(run.status(), Status::Exhausted);
    let evaluations = run.stats().clearance_evaluations;
    assert!((50..500).contains(&evaluations), "{evaluations}");
    assert!(run.result().approximate.is_some());
}
