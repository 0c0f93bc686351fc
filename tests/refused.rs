//! The points at which refused edges are refused, in the run's own space and by its own test; this work is not counted.

use crate::common::graphs::{edges, events, rows};
use crate::common::{PLANNERS, arm_and_wall, begin_with, disc_and_wall, finish, fitting};
use planarium::error::Code;
use planarium::graph::EventKind;
use planarium::run::{EVENT_HEAD, Run};
use wasm_bindgen_test::wasm_bindgen_test;

/// Both ends of every refused edge, from the events.
fn refused(run: &dyn Run) -> Vec<f64> {
    let vertices = rows(run);
    let ends = |event: &Vec<f64>| [&vertices[event[2] as usize], &event[EVENT_HEAD..]].concat();
    events(run, EventKind::EdgeRefused).iter().flat_map(ends).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn refused_edges_are_refused_somewhere_and_others_nowhere() {
    for world in [arm_and_wall(0.1), disc_and_wall(0.3, 0.5)] {
        for edge_check in ["proven", "sampled"] {
            for (planner, settings) in PLANNERS {
                let settings = format!("{} edge_check={edge_check}", fitting(&world, settings));
                let mut run = finish(begin_with(&world, planner, 4, &settings));
                let stats = run.stats();
                let hits = run.first_hits(&refused(&*run)).expect("the run's own states");
                assert!(hits.iter().all(|hit| (0.0..1.0).contains(hit)), "{planner} {settings}: {hits:?}");
                let vertices = rows(&*run);
                let ends: Vec<f64> = edges(&*run).iter().flatten().flat_map(|&v| vertices[v].clone()).collect();
                // A tree may have proven an edge in the other direction, where it ends in a tree grown from the goal.
                let hits = run.first_hits(&ends).expect("the run's own states");
                assert_eq!(hits.len(), run.edge_count());
                let free = hits.iter().filter(|hit| **hit == 1.0).count();
                assert!(free * 100 >= hits.len() * 99, "{planner} {settings}: {free} of {} are free", hits.len());
                assert_eq!(run.stats(), stats, "what is only looked at is not counted");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_motion_is_refused_where_the_wall_begins() {
    // The disc of radius 0.3 meets the wall, 0.5 thick about x = 5, after 3.45 of 8 metres.
    let world = disc_and_wall(0.3, 0.5);
    let ends = [1.0, 1.0, 9.0, 1.0, 1.0, 1.0, 1.0, 9.0];
    let mut proven = begin_with(&world, "rrt", 1, "");
    let hits = proven.first_hits(&ends).expect("two rows of two configurations");
    assert!((hits[0] - 3.45 / 8.0).abs() < 1e-9 && hits[1] == 1.0, "{hits:?}");
    let mut sampled = begin_with(&world, "rrt", 1, "edge_check=sampled edge_samples=4");
    assert_eq!(sampled.first_hits(&ends).expect("the same rows"), [0.25, 1.0], "the last place before the first hit");
    assert!(sampled.first_hits(&[]).expect("no rows").is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn rows_that_are_none_are_refused() {
    let mut run = begin_with(&disc_and_wall(0.3, 0.5), "rrt", 1, "");
    for (ends, code, message) in [
        (vec![1.0; 6], Code::WrongDimension, "a row of ends must have 4 numbers; 6 numbers are not whole rows"),
        (vec![1.0, 1.0, 1.0, f64::NAN], Code::NotFinite, "an end has NaN for a coordinate"),
        (vec![1e300, 1.0, 1.0, 1.0], Code::OutOfRange, "an end has 1e300 for a coordinate"),
        (vec![1.0, 1.0, 11.0, 1.0], Code::OutOfRange, "the end [11.0, 1.0] lies outside the limits"),
    ] {
        let error = run.first_hits(&ends).expect_err(message);
        assert_eq!((error.code(), error.pointer()), (code, "/ends"));
        if !message.contains("1e300") {
            assert_eq!(error.message(), message);
        }
    }
}
