//! AORRTC: the path never gets longer, each search begins with new trees, and only what is on the best path stays of the trees before.

use crate::common::graphs::{edges, events, rows};
use crate::common::{arm_and_wall, assert_valid, begin_with, disc_and_wall, finish, seeds};
use planarium::graph::EventKind;
use planarium::run::inspect::Inspector;
use planarium::run::{HISTORY_WIDTH, Status};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn the_path_only_gets_shorter_and_is_along_edges_that_stay() {
    let (mut all_falls, mut all_removed) = (0, 0);
    for world in [arm_and_wall(0.1), disc_and_wall(0.3, 0.5)] {
        let inspector = Inspector::new(&world);
        let mut run = begin_with(&world, "aorrtc", 3, "improve_iterations=2500");
        run.record().expect("nothing is done yet");
        while run.step(100) == Status::Running {
            let (vertices, edges, path) = (rows(&*run), edges(&*run), run.raw_path());
            let row = run.history_since(run.history_count() - 1);
            let length: f64 =
                path.windows(2).map(|pair| inspector.distance(&pair[0], &pair[1]).expect("configurations")).sum();
            assert!(path.is_empty() || (row[HISTORY_WIDTH - 1] - length).abs() <= 1e-12 * length);
            let removed: Vec<usize> =
                events(&*run, EventKind::VertexRemoved).iter().map(|event| event[2] as usize).collect();
            let mut once = removed.clone();
            once.sort_unstable();
            once.dedup();
            assert_eq!(once.len(), removed.len(), "a vertex leaves once");
            // States of the path may be those of former vertices as well.
            let stays = |v: &usize| once.binary_search(v).is_err();
            let at =
                |q: &Vec<f64>| (0..vertices.len()).filter(|&v| vertices[v] == *q).filter(stays).collect::<Vec<_>>();
            for pair in path.windows(2).filter(|pair| pair.iter().all(|q| vertices.contains(q))) {
                let [a, b] = [at(&pair[0]), at(&pair[1])];
                let joins = |from: &usize, to: &usize| a.contains(from) && b.contains(to);
                assert!(edges.iter().any(|[from, to]| joins(from, to) || joins(to, from)), "an edge of the path stays");
            }
        }
        let history = run.history_since(0);
        let costs: Vec<f64> = history.chunks(HISTORY_WIDTH).map(|row| row[HISTORY_WIDTH - 1]).collect();
        assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "the cost never rises");
        let falls: Vec<f64> = (2..=costs.len()).filter(|&i| costs[i - 1] < costs[i - 2]).map(|i| i as f64).collect();
        let mut found: Vec<f64> = events(&*run, EventKind::SolutionFound).iter().map(|event| event[1]).collect();
        found.dedup();
        assert_eq!(found[costs[0].is_finite() as usize..], falls, "an event for each shorter path");
        all_falls += falls.len();
        all_removed += events(&*run, EventKind::VertexRemoved).len();
        assert_valid(&world, &*run);
    }
    assert!(all_falls > 4 && all_removed > 50, "{all_falls} {all_removed}");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_first_path_is_that_of_rrt_connect() {
    for world in [arm_and_wall(0.1), disc_and_wall(0.3, 0.5)] {
        for seed in 0..seeds(12) {
            let one = finish(begin_with(&world, "rrt-connect", seed, ""));
            let first = finish(begin_with(&world, "aorrtc", seed, "improve_iterations=0"));
            assert_eq!((first.path(), first.fingerprint()), (one.path(), one.fingerprint()), "seed {seed}");
        }
    }
}
