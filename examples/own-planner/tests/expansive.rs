//! What holds of every planner holds of this one.

use own_planner::Expansive;
use planarium::path::{Verdict, verify};
use planarium::run::{self, EdgeOptions, Improving, Limits, OwnPlanner, Reason, Run, Status};
use planarium::scenario::Scenario;
use planarium::{Error, worlds::generate};
use serde_json::json;

fn begin(scenario: &Scenario, planner: &OwnPlanner) -> Result<Box<dyn Run>, Error> {
    run::start_with::<8>(scenario, planner, |problem, seed| Ok(Expansive::boxed(problem, seed)))
}

fn seeded(seed: u64) -> OwnPlanner {
    OwnPlanner { id: "expansive", seed, ..OwnPlanner::default() }
}

fn worlds() -> Vec<Scenario> {
    let made = [
        ("discs", json!({ "robot": "disc", "seed": 2 })),
        ("discs", json!({ "robot": "arm", "links": 3, "count": 6, "seed": 1 })),
        ("clutter", json!({ "robot": "rigid_body", "seed": 5 })),
        ("maze", json!({ "seed": 3 })),
    ];
    made.map(|(kind, options)| generate(kind, &options).unwrap_or_else(|error| panic!("{kind} {options}: {error}")))
        .into()
}

#[test]
fn paths_are_valid_and_are_improved() {
    for scenario in worlds() {
        let improving = Improving { reduce: true, shortcut: 50, ..Improving::default() };
        let edges = EdgeOptions { improving, ..EdgeOptions::default() };
        let mut run = begin(&scenario, &OwnPlanner { edges, ..seeded(7) }).expect("a run");
        assert_eq!(run.step(u64::MAX), Status::Solved, "{}: {:?}", scenario.name(), run.explanation());
        let result = run.result();
        assert_eq!(result.planner, "expansive");
        assert!(matches!(verify(&scenario, &result), Ok(Verdict::Valid { .. })), "{}", scenario.name());
    }
}

#[test]
fn slices_and_threads_change_nothing() {
    for scenario in worlds() {
        let mut whole = begin(&scenario, &seeded(3)).expect("a run");
        whole.step(500);
        let mut sliced = begin(&scenario, &seeded(3)).expect("a run");
        for _ in 0..100 {
            sliced = std::thread::spawn(move || {
                sliced.step(5);
                sliced
            })
            .join()
            .expect("no panic");
        }
        assert_eq!(sliced.fingerprint(), whole.fingerprint(), "{}", scenario.name());
    }
}

#[test]
fn limits_and_ends_are_those_of_every_planner() {
    let maze = generate("maze", &json!({ "seed": 3 })).expect("a maze");
    let limits = Limits { max_iterations: Some(5), ..Limits::default() };
    let edges = EdgeOptions { limits, ..EdgeOptions::default() };
    let mut run = begin(&maze, &OwnPlanner { edges, ..seeded(1) }).expect("a run");
    assert_eq!((run.step(u64::MAX), run.reason()), (Status::Exhausted, Some(Reason::IterationLimit)));
    let unknown = OwnPlanner { query: Some("nowhere".to_owned()), ..seeded(1) };
    assert_eq!(begin(&maze, &unknown).err().map(|error| error.code().as_str()), Some("unknown-query"));
    let arm = generate("forest", &json!({ "links": 6 })).expect("a world");
    let small = run::start_with::<4>(&arm, &seeded(1), |problem, seed| Ok(Expansive::boxed(problem, seed)));
    assert_eq!(small.err().map(|error| error.code().as_str()), Some("unsupported"));
}
