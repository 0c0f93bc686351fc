//! What viewers see: the history of a run, one row per iteration, the same in any slices, which changes nothing else; where refused
//! edges are refused, in the run's own space and by its own test, which is not counted; corners, contacts and clearance.

use crate::common::bodies::{clearance, part_distance};
use crate::common::documents::{CAR, arm, refuses, scenario};
use crate::common::graphs::{edges, events, rows};
use crate::common::{PLANNERS, arm_and_wall, arm_of, begin_with, disc_and_wall, finish, fitting, no_way, parse};
use planarium::graph::EventKind;
use planarium::robot::Part;
use planarium::run::inspect::{Clearance, Inspector};
use planarium::run::{EVENT_HEAD, HISTORY_WIDTH, Phase, Run, Status};
use planarium::scenario::generate;
use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;

const PHASE: usize = 3;
const COST: usize = 7;

/// The counts of a row, from the run itself.
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
fn every_iteration_leaves_the_row_of_counts_of_the_run() {
    for world in [arm_and_wall(0.1), disc_and_wall(0.3, 0.5)] {
        for (planner, settings) in PLANNERS {
            let settings = fitting(&world, settings);
            let mut run = begin_with(&world, planner, 5, &settings);
            run.record().expect("nothing is done yet");
            let mut rows = Vec::new();
            let mut status = Status::Running;
            while status == Status::Running {
                status = run.step(1);
                let row = run.history_since(run.history_count() - 1);
                assert_eq!(row.len(), HISTORY_WIDTH, "{planner} {settings}");
                assert_eq!(row[..COST], counts(&*run), "{planner} {settings}");
                rows.extend(row);
            }
            assert!(run.step(3) == status && run.history_since(0) == rows, "a finished run leaves no rows");
            let beyond = [run.history_count() + 1, usize::MAX / HISTORY_WIDTH + 1, usize::MAX];
            assert!(beyond.into_iter().all(|row| run.history_since(row).is_empty()));
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
        let mut whole = begin_with(&world, planner, 9, settings);
        whole.record().and_then(|()| whole.record()).expect("once or twice is the same");
        whole.step(u64::MAX);
        assert_eq!((whole.fingerprint(), whole.stats()), (plain.fingerprint(), plain.stats()), "{planner} {settings}");
        assert_eq!(whole.path(), plain.path());
        let rows = whole.history_since(0);
        for slice in [1, 7, 64] {
            let mut run = begin_with(&world, planner, 9, settings);
            run.record().expect("nothing is done yet");
            let mut read = Vec::new();
            let mut calls = 0;
            while run.step(slice) == Status::Running {
                calls += 1;
                // Every third time the rows of two slices are read together.
                if calls % 3 != 0 {
                    read.extend(run.history_since(read.len() / HISTORY_WIDTH));
                }
            }
            read.extend(run.history_since(read.len() / HISTORY_WIDTH));
            assert_eq!(read, rows, "{planner} {settings} in slices of {slice}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn costs_fall_while_a_path_is_improved_and_stand_when_it_is_accepted() {
    let mut run = begin_with(&disc_and_wall(0.2, 0.3), "rrt-connect", 1, "shortcut=1000");
    run.record().expect("nothing is done yet");
    assert_eq!(run.finish(), Status::Running, "there is no path yet to be accepted");
    while run.phase() != Phase::Improving {
        run.step(1);
    }
    assert_eq!((run.step(200), run.path().len()), (Status::Running, 0));
    let before = run.iterations();
    assert_eq!((run.finish(), run.step(5)), (Status::Solved, Status::Solved));
    assert!(run.path().len() >= 2);
    let rows = run.history_since(0);
    assert_eq!(rows.len() as u64, before * HISTORY_WIDTH as u64, "to accept the path is no iteration");
    let improving: Vec<&[f64]> =
        rows.chunks(HISTORY_WIDTH).filter(|row| row[PHASE] == f64::from(Phase::Improving as u8)).collect();
    assert_eq!(improving.len(), 201, "the last row, too, is one of improving");
    assert!(improving[200][COST] < improving[0][COST]);
    assert!((improving[200][COST] - run.length()).abs() <= 1e-12 * run.length());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_that_has_begun_cannot_be_recorded() {
    let mut run = begin_with(&no_way(), "rrt", 1, "max_iterations=20");
    run.step(0);
    assert!(run.history_since(0).is_empty(), "nothing is recorded");
    run.step(3);
    let message = refuses(run.record(), "unsupported", "");
    assert_eq!(message, "recording must begin before the first iteration; 3 were made");
    run.step(3);
    assert!(run.history_since(0).is_empty());

    let mut run = begin_with(&no_way(), "rrt", 1, "max_iterations=20");
    run.record().expect("nothing is done yet");
    run.step(3);
    run.record().expect("it is being recorded");
    assert_eq!(run.history_since(0).len(), 3 * HISTORY_WIDTH);
}

/// Both ends of every refused edge, from the events.
fn refused(run: &dyn Run) -> Vec<f64> {
    let vertices = rows(run);
    let ends = |event: &Vec<f64>| [&vertices[event[2] as usize], &event[EVENT_HEAD..]].concat();
    events(run, EventKind::EdgeRefused).iter().flat_map(ends).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn refused_edges_have_a_first_hit_and_others_none() {
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
                assert_eq!(run.stats(), stats, "what is only shown is not counted");
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
    assert_eq!(sampled.first_hits(&ends).expect("the same rows"), [0.25, 1.0], "the last sample before the first hit");
    assert!(sampled.first_hits(&[]).expect("no rows").is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_rows_of_ends_are_refused() {
    let mut run = begin_with(&disc_and_wall(0.3, 0.5), "rrt", 1, "");
    for (ends, code, message) in [
        (vec![1.0; 6], "wrong-dimension", "a row of ends must have 4 numbers; 6 numbers are not whole rows"),
        (vec![1.0, 1.0, 1.0, f64::NAN], "not-finite", "an end has NaN for a coordinate"),
        (vec![1e300, 1.0, 1.0, 1.0], "out-of-range", "an end has 1"),
        (vec![1.0, 1.0, 11.0, 1.0], "out-of-range", "the end [11.0, 1.0] lies outside the limits"),
    ] {
        assert!(refuses(run.first_hits(&ends), code, "/ends").starts_with(message), "{message}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_clearance_is_the_least_distance_and_its_points_are_that_far_apart() {
    let (mut free, mut touching) = (0, 0);
    for kind in ["clutter", "discs"] {
        for robot in ["disc", "arm", "rigid_body", "car"] {
            let options = serde_json::json!({ "robot": robot, "seed": 3 });
            let scenario = generate::generate(kind, &options).expect("a scenario");
            let inspector = Inspector::new(&scenario);
            let (obstacles, n) = (&scenario.world().obstacles, inspector.dimension());
            for q in inspector.samples(100, 5, false).expect("samples").chunks(n) {
                let parts = inspector.footprint(q).expect("parts");
                let Some(found) = inspector.clearance(q).expect("a configuration") else {
                    assert!(!inspector.check(q).expect("a configuration").is_empty());
                    touching += 1;
                    continue;
                };
                free += 1;
                let expected = clearance(&parts, scenario.world());
                let own = part_distance(&parts[found.part], &obstacles[found.obstacle]);
                let [a, b] = found.points;
                for same in [expected, own, (b - a).norm()] {
                    assert!((found.distance - same).abs() < 1e-9, "{kind} {robot} {q:?}: {found:?} is not {same}");
                }
            }
        }
    }
    assert!(free > 200 && touching > 200, "{free} free, {touching} touching");
    // A margin is a part of the robot: what is nearer than it is touched, and clearance is what is left beyond it.
    let (margin, mut smaller, mut within) = (0.05, 0, 0);
    for robot in ["disc", "arm", "rigid_body", "car"] {
        let options = serde_json::json!({ "robot": robot, "seed": 4 });
        let scenario = generate::generate("clutter", &options).expect("a scenario");
        let mut document: Value = serde_json::from_str(&scenario.to_json_string()).expect("JSON");
        document["robot"]["margin"] = margin.into();
        document["queries"] = serde_json::json!([]);
        let [own, grown] = [scenario, parse(&document.to_string())].map(|scenario| Inspector::new(&scenario));
        for q in own.samples(100, 5, true).expect("samples").chunks(own.dimension()) {
            let [own, grown] = [&own, &grown].map(|inspector| inspector.clearance(q).expect("a configuration"));
            let own = own.expect("a free configuration");
            match grown {
                None => within += usize::from(own.distance < margin + 1e-9),
                Some(Clearance { distance, points: [a, b], .. }) => {
                    assert!((own.distance - margin - distance).abs() < 1e-9, "{robot} {q:?}");
                    assert!(((b - a).norm() - distance).abs() < 1e-9, "{robot} {q:?}");
                    smaller += 1;
                }
            }
        }
    }
    assert!(smaller > 100 && within > 10, "{smaller} {within}");
    let empty = Inspector::new(scenario("", "", &arm(&[1.0], 0.0), ""));
    assert_eq!(empty.clearance(&[0.0]).expect("a configuration"), None);
    refuses(empty.clearance(&[f64::NAN]), "not-finite", "/q/0");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_corners_of_a_body_and_what_they_touch_are_shown() {
    let inspector = Inspector::new(parse(CAR));
    assert_eq!((inspector.dimension(), inspector.circles()), (3, vec![false, false, true]));
    let parts = inspector.footprint(&[1.0, 0.5, std::f64::consts::FRAC_PI_2]).unwrap();
    let [Part::Polygon { vertices }] = &parts[..] else { panic!("one polygon: {parts:?}") };
    assert!((vertices[0].x - 1.05).abs() < 1e-15 && (vertices[0].y - 0.4).abs() < 1e-15, "{vertices:?}");
    assert_eq!(inspector.check(&[1.0, 0.5, 0.0]), Ok(vec![]));
    let both = inspector.check(&[1.0, 0.65, 0.0]).unwrap();
    assert_eq!(both.iter().map(ToString::to_string).collect::<Vec<_>>(), ["part 0 touches obstacle 0"]);
    assert_eq!(inspector.check(&[0.05, 0.5, 0.0]).unwrap()[0].to_string(), "part 0 leaves the bounds");
    assert_eq!(inspector.check(&[0.1, 0.5, 0.0]), Ok(vec![]), "the bounds may be touched");
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_configurations_are_refused_before_any_proof() {
    let inspector = Inspector::new(arm_of(2, true, 0.0));
    let hit = |a: &[f64], b: &[f64], code, pointer| refuses(inspector.first_hit(a, b), code, pointer);
    hit(&[-1.7e308, 0.0], &[0.0, 0.0], "out-of-range", "/a/0");
    hit(&[0.0, 0.0], &[0.0, 50.0], "out-of-range", "/b/1");
    hit(&[0.0, f64::NAN], &[0.0, 0.0], "not-finite", "/a/1");
    hit(&[0.0], &[0.0, 0.0], "wrong-dimension", "/a");
    refuses(inspector.check(&[1e308, 0.0]), "out-of-range", "/q/0");
    refuses(inspector.footprint(&[0.0, -1e7]), "out-of-range", "/q/1");
}
