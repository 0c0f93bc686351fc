//! The laws of every planner: slicing changes nothing, impossible queries are never solved, and paths are valid.

use crate::common::documents::{arm, disc, refuses, scenario};
use crate::common::graphs::{edges, rows};
use crate::common::requests::start;
use crate::common::{
    DRIVEN, PLANNERS, SAMPLERS, arm_and_wall, arm_of, assert_valid, begin_with, body_and_wall, car_and_wall, deep,
    disc_and_wall, finish, fitting, no_way, options, seeds, sliding_arm_and_wall, thick_arm_and_wall, worlds,
};
use planarium::random::{Random, Stream};
use planarium::run::{PlannerOptions, Request, Status, planners};
use std::collections::BTreeMap;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn without_events_the_graph_the_path_and_the_counts_are_the_same() {
    let cars = std::iter::once((car_and_wall(0.1), DRIVEN));
    for (world, planners) in worlds().into_iter().map(|world| (world, PLANNERS)).chain(cars) {
        for &(planner, settings) in planners {
            let settings = fitting(&world, settings);
            let options = options(planner, 5, &settings);
            let one = finish(start(&world, &options).expect("a run"));
            let other = finish(start(&world, &Request { events: false, ..options }).expect("a run"));
            let what = format!("{planner} {settings} on {}", world.name());
            assert_eq!((one.event_count() > 0, other.event_count()), (true, 0), "{what}");
            assert_eq!(other.vertex_rows(0), one.vertex_rows(0), "{what}");
            assert_eq!(other.edge_rows(0), one.edge_rows(0), "{what}");
            assert_eq!((other.stats(), other.status()), (one.stats(), one.status()), "{what}");
            assert_eq!((other.path(), other.length()), (one.path(), one.length()), "{what}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_works_with_every_sampler_and_keeps_its_paths_clear() {
    // Thick walls, then walls that a sampled edge would jump.
    let worlds = [arm_and_wall(0.1), disc_and_wall(0.3, 0.5), arm_and_wall(1e-6), disc_and_wall(0.3, 1e-6)];
    for (i, world) in worlds.iter().enumerate() {
        for &sampler in SAMPLERS {
            for planner in ["prm", "prm-star", "visibility-prm", "rrt", "rrt-connect"] {
                let (seeds, most) = if i < 2 { (1, 20_000) } else { (seeds(3), 5000) };
                for seed in 0..seeds {
                    let samples = if planner.starts_with("prm") { "samples=200" } else { "" };
                    let improvement = "shortcut=20 partial_shortcut=20 reduce=true";
                    let settings = format!("{samples} sampler={sampler} {improvement} max_iterations={most}");
                    let what = format!("{planner} {settings} seed {seed} on {}", world.name());
                    let run = finish(begin_with(world, planner, seed, &settings));
                    let is_local = matches!(sampler, "gaussian" | "bridge" | "obstacle-based");
                    let must_solve = i < 2 && !is_local && planner != "visibility-prm";
                    assert!(!must_solve || run.status() == Status::Solved, "{what}");
                    // Two guards may see all there is, and between these obstacles there is little to bridge.
                    let may_stop_early = i >= 2 || planner == "visibility-prm" || sampler == "bridge";
                    assert!(may_stop_early || run.vertex_count() > 2, "{what} grows");
                    if run.status() == Status::Solved {
                        assert_valid(world, &*run);
                    }
                }
            }
        }
    }
}

/// A deep run makes 100,000 runs.
#[wasm_bindgen_test(unsupported = test)]
fn no_path_of_any_planner_crosses_a_wall_however_thin() {
    let all = if cfg!(target_arch = "wasm32") { 60 } else { 600 };
    let mut random = Random::new(1, Stream::Scenario);
    let mut solved: BTreeMap<String, u32> = BTreeMap::new();
    let mut runs = 0;
    for seed in 0.. {
        // From 0.5 to 1e-6, evenly in its logarithm.
        let thickness = 0.5 * libm::pow(2e-6, random.uniform());
        let worlds = [
            arm_and_wall(thickness),
            thick_arm_and_wall(thickness),
            sliding_arm_and_wall(thickness),
            disc_and_wall(0.3, thickness),
            body_and_wall(thickness),
            car_and_wall(thickness),
        ];
        for (world, planner) in worlds.iter().flat_map(|world| planners().map(|planner| (world, planner))) {
            if !planner.is_for(world.robot().kind()) {
                continue;
            }
            let run = finish(begin_with(world, planner.info().id, seed, &short(&planner)));
            runs += 1;
            if run.status() == Status::Solved {
                *solved.entry(format!("{} {}", planner.info().id, world.robot().kind())).or_default() += 1;
                assert_valid(world, &*run);
            }
        }
        if runs >= if deep() { 100_000 } else { all } {
            break;
        }
    }
    // A planner that solves nothing proves nothing.
    let missing: Vec<_> =
        planners().into_iter().filter(|planner| !solved.keys().any(|key| key.starts_with(planner.info().id))).collect();
    assert!(missing.is_empty(), "{missing:?} in {runs} runs: {solved:?}");
}

/// Settings for a run that ends soon, with a path that is improved.
fn short(planner: &PlannerOptions) -> String {
    let table = planner.table();
    let settings =
        [("samples", 100), ("failures", 40), ("improve_iterations", 40), ("shortcut", 10), ("max_iterations", 1500)];
    let known = settings.iter().filter(|(name, _)| table.iter().any(|option| option.name == *name));
    known.map(|(name, value)| format!("{name}={value} ")).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn a_step_does_at_most_what_it_was_asked_and_nothing_once_done() {
    let mut run = begin_with(&arm_and_wall(0.1), "prm", 1, "samples=50");
    for asked in [0, 1, 1, 5, 20] {
        let before = run.iterations();
        run.step(asked);
        assert_eq!(run.iterations(), before + asked);
    }
    run.step(u64::MAX);
    let (iterations, fingerprint) = (run.iterations(), run.fingerprint());
    run.step(100);
    assert_eq!((run.iterations(), run.fingerprint()), (iterations, fingerprint), "a finished run stays as it is");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_path_leads_from_start_to_goal_along_edges_of_the_graph() {
    for world in worlds() {
        // Improvement moves a path off the graph.
        for &(planner, settings) in PLANNERS.iter().filter(|(_, settings)| !settings.contains("shortcut=40")) {
            let settings = fitting(&world, settings);
            let run = finish(begin_with(&world, planner, 2, &settings));
            if run.status() != Status::Solved {
                let may_fail =
                    planner == "visibility-prm" || ["discard", "radius"].iter().any(|s| settings.contains(s));
                assert!(may_fail, "{planner} {settings} on {}", world.name());
                continue;
            }
            let vertices = rows(run.as_ref());
            let path = run.path();
            assert_eq!(path[0], vertices[0], "vertex 0 is the start");
            assert_eq!(path[path.len() - 1], vertices[1], "vertex 1 is the goal");
            // Vertices may have the same configuration, as those of former paths.
            let numbers = |q: &Vec<f64>| (0..vertices.len()).filter(|&v| vertices[v] == *q).collect::<Vec<_>>();
            let edges = edges(run.as_ref());
            for pair in path.windows(2) {
                // Waypoints that split a long turn are no vertices.
                let [a, b] = [numbers(&pair[0]), numbers(&pair[1])];
                let is_edge = edges
                    .iter()
                    .any(|[from, to]| (a.contains(from) && b.contains(to)) || (a.contains(to) && b.contains(from)));
                let are_vertices = !a.is_empty() && !b.is_empty();
                assert!(
                    !are_vertices || is_edge,
                    "{planner}: {a:?} and {b:?} are neighbours on the path and in the graph"
                );
            }
            assert!(edges.iter().all(|[a, b]| a != b), "no vertex is connected to itself");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_impossible_query_is_never_solved() {
    for seed in 0..seeds(20) {
        let budget = "max_iterations=400";
        for (planner, settings) in
            [("prm", "samples=200"), ("visibility-prm", "failures=400"), ("rrt", budget), ("rrt-connect", budget)]
        {
            let run = finish(begin_with(&no_way(), planner, seed, settings));
            assert_eq!(run.status(), Status::Exhausted, "{planner}");
            assert!(settings != budget || run.iterations() == 400, "when the budget ends");
            assert!(run.path().is_empty() && run.length() == 0.0, "an unsolved run has no path");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_or_goal_in_collision_is_refused_with_the_pair_named() {
    let discs = [disc([9.0, 9.0], 1.0), disc([1.5, 0.0], 0.2)].join(",");
    for (query, code, pointer) in [
        (r#""start": [0, 0], "goal": [2, 0]"#, "start-in-collision", "/queries/0/start"),
        (r#""start": [2, 0], "goal": [0, 0]"#, "goal-in-collision", "/queries/0/goal"),
    ] {
        let world = scenario("", &discs, &arm(&[1.0, 1.0], 0.0), query);
        for planner in ["prm", "rrt-connect"] {
            let message = refuses(start(&world, &options(planner, 0, "")), code, pointer);
            assert!(message.contains("link 2 touches obstacle 1"), "{message}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_arm_of_any_number_of_links_plans() {
    for links in 1..=8 {
        for planner in ["prm", "prm-star", "rrt", "rrt-connect"] {
            let run = finish(begin_with(&arm_of(links, links % 2 == 0, 0.02), planner, 1, ""));
            assert_eq!(run.status(), Status::Solved, "{links} links, {planner}");
            assert_eq!(run.dimension(), links);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_step_of_an_emitted_path_turns_a_joint_by_more_than_three_radians() {
    for seed in 0..seeds(50) {
        for settings in ["step=7", "step=7 metric=naive"] {
            let run = finish(begin_with(&arm_of(2, false, 0.0), "rrt-connect", seed, settings));
            for pair in run.path().windows(2) {
                for (a, b) in pair[0].iter().zip(&pair[1]) {
                    assert!(planarium::space::angular_distance(*a, *b) <= 3.0);
                }
            }
        }
    }
}
