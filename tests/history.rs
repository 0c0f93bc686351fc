//! The history of a run: one row an iteration, the same in any slices, without any effect on the run.

use crate::common::{PLANNERS, arm_and_wall, begin_with, disc_and_wall, finish, fitting, no_way};
use planarium::error::Code;
use planarium::run::{HISTORY_WIDTH, Phase, Run, Status};
use planarium::scenario::Scenario;
use wasm_bindgen_test::wasm_bindgen_test;

const PHASE: usize = 3;
const COST: usize = 7;

/// A run of which the history is recorded.
fn recorded(world: &Scenario, planner: &str, seed: u64, settings: &str) -> Box<dyn Run> {
    let mut run = begin_with(world, planner, seed, settings);
    run.record().expect("no iteration is done yet");
    run
}

/// The columns of counts, as the run itself reports them now.
fn counts(run: &dyn Run) -> [f64; COST] {
    let stats = run.stats();
    let phase = Phase::ALL.iter().position(|&phase| phase == run.phase()).expect("all phases are listed");
    [
        run.vertex_count(),
        run.edge_count(),
        run.event_count(),
        phase,
        stats.configuration_checks as usize,
        stats.motion_checks as usize,
        stats.clearance_evaluations as usize,
    ]
    .map(|count| count as f64)
}

#[wasm_bindgen_test(unsupported = test)]
fn every_iteration_has_a_row_that_matches_the_run() {
    for world in [arm_and_wall(0.1), disc_and_wall(0.3, 0.5)] {
        for (planner, settings) in PLANNERS {
            let settings = fitting(&world, settings);
            let mut run = recorded(&world, planner, 5, &settings);
            let mut rows = Vec::new();
            let mut status = Status::Running;
            while status == Status::Running {
                status = run.step(1);
                let row = run.take_history();
                assert_eq!(row.len(), HISTORY_WIDTH, "{planner} {settings}");
                assert_eq!(row[..COST], counts(&*run), "{planner} {settings}");
                rows.extend(row);
            }
            assert!(run.step(3) == status && run.take_history().is_empty(), "a run that has ended adds no rows");
            assert_eq!(rows.len() as u64, run.iterations() * HISTORY_WIDTH as u64);
            let costs: Vec<f64> = rows.chunks(HISTORY_WIDTH).map(|row| row[COST]).collect();
            assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "{planner} {settings}: costs fall");
            let last = costs[costs.len() - 1];
            match status {
                Status::Solved => assert!((last - run.length()).abs() <= 1e-12 * last, "{planner} {settings}"),
                _ => assert!(costs.iter().all(|cost| *cost == f64::INFINITY)),
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn rows_are_the_same_in_any_slices_and_change_nothing() {
    let world = arm_and_wall(0.1);
    for (planner, settings) in PLANNERS {
        let plain = finish(begin_with(&world, planner, 9, settings));
        let mut whole = recorded(&world, planner, 9, settings);
        whole.record().expect("recording twice changes nothing");
        whole.step(u64::MAX);
        assert_eq!((whole.fingerprint(), whole.stats()), (plain.fingerprint(), plain.stats()), "{planner} {settings}");
        assert_eq!(whole.path(), plain.path());
        let rows = whole.take_history();
        for slice in [1, 7, 64] {
            let mut run = recorded(&world, planner, 9, settings);
            let mut taken = Vec::new();
            let mut calls = 0;
            while run.step(slice) == Status::Running {
                calls += 1;
                // Sometimes the rows of several slices are taken together.
                if calls % 3 != 0 {
                    taken.extend(run.take_history());
                }
            }
            taken.extend(run.take_history());
            assert_eq!(taken, rows, "{planner} {settings} in slices of {slice}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn costs_fall_while_a_path_is_improved_and_finishing_adds_no_row() {
    let mut run = recorded(&disc_and_wall(0.2, 0.3), "rrt-connect", 1, "shortcut=1000");
    while run.phase() != Phase::Improving {
        run.step(1);
    }
    run.step(200);
    let before = run.iterations();
    run.finish();
    let rows = run.take_history();
    assert_eq!(rows.len() as u64, before * HISTORY_WIDTH as u64, "finishing is no iteration");
    let improving: Vec<&[f64]> =
        rows.chunks(HISTORY_WIDTH).filter(|row| row[PHASE] == f64::from(Phase::Improving as u8)).collect();
    assert_eq!(improving.len(), 201, "the last row is of the same phase");
    assert!(improving[200][COST] < improving[0][COST]);
    assert!((improving[200][COST] - run.length()).abs() <= 1e-12 * run.length());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_that_has_begun_cannot_be_recorded_any_more() {
    let mut run = begin_with(&no_way(), "rrt", 1, "max_iterations=20");
    run.step(0);
    assert!(run.take_history().is_empty(), "nothing is recorded");
    run.step(3);
    let error = run.record().expect_err("three iterations are not recorded");
    assert_eq!((error.code(), error.pointer()), (Code::Unsupported, ""));
    assert_eq!(error.message(), "a run is recorded from its first iteration on, and 3 are made");
    run.step(3);
    assert!(run.take_history().is_empty());

    let mut run = recorded(&no_way(), "rrt", 1, "max_iterations=20");
    run.step(3);
    run.record().expect("it is being recorded");
    assert_eq!(run.take_history().len(), 3 * HISTORY_WIDTH);
}
