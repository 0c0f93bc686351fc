//! Roadmaps: which samples are connected, PRM*, guards, searches by name, repeated queries, and improved paths.

use crate::common::documents::{arm, judged, refuses, scenario};
use crate::common::graphs::{edges, events, rows, tried};
use crate::common::{arm_and_wall, arm_of, assert_valid, begin_with, disc_and_wall, finish, no_way, seeds};
use planarium::graph::EventKind;
use planarium::planner::{logarithmic_k, prm_star_k};
use planarium::run::{Phase, Run, Status};
use planarium::space::angular_distance;
use wasm_bindgen_test::wasm_bindgen_test;

/// The distance of two configurations of an arm of circles, summed over the joints.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| angular_distance(*a, *b)).sum()
}

/// Of the vertices before `to` the `k` nearest to a vertex within the radius, by brute force.
fn nearest(vertices: &[Vec<f64>], v: usize, to: usize, k: usize, radius: f64) -> Vec<usize> {
    let far = |other: usize| distance(&vertices[v], &vertices[other]);
    let mut others: Vec<usize> = (0..to).filter(|&other| other != v && far(other) <= radius).collect();
    others.sort_by(|&i, &j| far(i).total_cmp(&far(j)).then(i.cmp(&j)));
    others.truncate(k);
    others
}

#[wasm_bindgen_test(unsupported = test)]
fn every_pair_of_neighbours_is_tried_once_and_no_other() {
    for (settings, k, radius) in
        [("k=10", 10, f64::INFINITY), ("radius=0.9", usize::MAX, 0.9), ("radius=0.9 k=4", 4, 0.9)]
    {
        let run = finish(begin_with(&arm_of(2, false, 0.0), "prm", 4, &format!("direct=false samples=120 {settings}")));
        let mut tried = tried(run.as_ref());
        tried.iter_mut().for_each(|pair| pair.sort_unstable());
        tried.sort_unstable();
        assert_eq!(tried.len() as u64, run.stats().motion_checks, "each check ends as an edge or as a refusal");
        assert_eq!(run.stats().nearest_queries, 122);
        // A pair is tried if either is among the nearest of the other.
        let vertices = rows(run.as_ref());
        let n = vertices.len();
        let pairs =
            (0..n).flat_map(|v| nearest(&vertices, v, n, k, radius).into_iter().map(move |u| [v.min(u), v.max(u)]));
        let expected: std::collections::BTreeSet<[usize; 2]> = pairs.collect();
        assert_eq!(tried, expected.into_iter().collect::<Vec<_>>(), "{settings}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_radius_larger_than_the_space_changes_nothing() {
    let world = arm_of(2, false, 0.0);
    for settings in ["samples=90 k=6", "samples=90 k=6 insertion=one-by-one"] {
        let plain = finish(begin_with(&world, "prm", 4, settings));
        let wide = finish(begin_with(&world, "prm", 4, &format!("{settings} radius=100")));
        assert_eq!(wide.fingerprint(), plain.fingerprint());
    }
    let all = finish(begin_with(&world, "prm", 4, "samples=40 radius=100"));
    assert_eq!(all.stats().motion_checks, 42 * 41 / 2, "without k every pair is tried");
}

#[wasm_bindgen_test(unsupported = test)]
fn start_and_goal_that_see_each_other_are_connected_without_any_sample() {
    let world = scenario("", "", &arm(&[1.0, 1.0], 0.0), r#""start": [0, 0], "goal": [1, 1]"#);
    for settings in ["samples=0", "samples=0 insertion=one-by-one", "samples=0 insertion=one-by-one discard=true"] {
        assert_eq!(finish(begin_with(&world, "prm", 1, settings)).status(), Status::Solved, "{settings}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn inserted_one_by_one_a_sample_is_connected_to_the_nearest_before_it() {
    let run = finish(begin_with(&arm_of(2, false, 0.0), "prm", 6, "samples=100 k=5 insertion=one-by-one"));
    let vertices = rows(run.as_ref());
    assert_eq!(vertices.len(), 102);
    let tried = tried(run.as_ref());
    for v in 2..vertices.len() {
        let own: Vec<usize> = tried.iter().filter(|[from, _]| *from == v).map(|[_, to]| *to).collect();
        let [mut own, mut nearest] = [own, nearest(&vertices, v, v, 5, f64::INFINITY)];
        own.sort_unstable();
        nearest.sort_unstable();
        assert_eq!(own, nearest, "vertex {v}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn with_discarding_every_vertex_but_start_and_goal_has_an_edge() {
    let settings = "samples=150 k=1 insertion=one-by-one discard=true";
    let run = finish(begin_with(&arm_of(3, false, 0.05), "prm", 2, settings));
    let edges = edges(run.as_ref());
    for v in 2..run.vertex_count() {
        assert!(edges.iter().any(|[from, _]| *from == v), "vertex {v} was connected when it came");
    }
    let discarded = events(run.as_ref(), EventKind::SampleDiscarded);
    assert!(!discarded.is_empty() && discarded.iter().all(|event| event[2] == -1.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_neighbours_of_prm_star_grow_with_the_logarithm() {
    // e (1 + 1/2) ln 1000 = 28.17, e (1 + 1/4) ln 1000 = 23.47, ln 1000 = 6.9.
    assert_eq!((prm_star_k(1000, 2), prm_star_k(1000, 4), logarithmic_k(1000)), (29, 24, 7));
    for (settings, k) in [("samples=98", prm_star_k(100, 2)), ("samples=98 k_rule=log-n", 5)] {
        let star = finish(begin_with(&arm_of(2, false, 0.0), "prm-star", 3, settings));
        let plain = finish(begin_with(&arm_of(2, false, 0.0), "prm", 3, &format!("samples=98 k={k}")));
        assert_eq!(star.fingerprint(), plain.fingerprint(), "PRM* is k-PRM with that k");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn among_many_discs_guarding_ends_once_start_and_goal_are_connected() {
    let world = planarium::scenario::generate::generate("discs", &serde_json::json!({ "robot": "car", "seed": 5001 }));
    let world = world.expect("a scenario");
    let run = finish(begin_with(&world, "visibility-prm", 1, ""));
    assert_eq!(run.status(), Status::Solved);
    assert_valid(&world, run.as_ref());
    let coverage = run.result().coverage.expect("it estimates its coverage");
    assert!(coverage < 1.0 - 1.0 / 400.0, "no 400 samples in a row were of no use: {coverage}");
    // As many as are asked for are awaited.
    let asked = format!("failures=400 max_iterations={}", 2 * run.iterations());
    let asked = finish(begin_with(&world, "visibility-prm", 1, &asked));
    assert_eq!(asked.reason(), Some(planarium::run::Reason::IterationLimit));
}

#[wasm_bindgen_test(unsupported = test)]
fn guards_see_no_other_guard_and_links_see_two_components() {
    for seed in 0..seeds(20) {
        let world = arm_of(2, false, 0.02);
        let run = finish(begin_with(&world, "visibility-prm", seed, "failures=150"));
        let inspector = planarium::run::inspect::Inspector::new(&world);
        let vertices = rows(run.as_ref());
        let guards: Vec<usize> =
            events(run.as_ref(), EventKind::GuardAdded).iter().map(|event| event[2] as usize).collect();
        assert_eq!(guards[..2], [0, 1], "start and goal are the first guards");
        for (i, &a) in guards.iter().enumerate().skip(2) {
            for &b in &guards[..i] {
                let hit = inspector.first_hit(&vertices[a], &vertices[b]).expect("configurations of the arm");
                assert!(hit.is_some(), "seed {seed}: guards {a} and {b} do not see each other");
            }
        }
        let edges = edges(run.as_ref());
        for v in (2..vertices.len()).filter(|v| !guards.contains(v)) {
            let linked: Vec<usize> = edges.iter().filter(|[from, _]| *from == v).map(|[_, to]| *to).collect();
            assert!(linked.len() >= 2 && linked.iter().all(|to| guards.contains(to)), "a link connects guards");
        }
        let coverage = run.result().coverage.expect("it estimates its coverage");
        assert!((1.0 - coverage - 1.0 / 150.0).abs() < 1e-12, "{coverage}");
        assert!(vertices.len() < 60, "few vertices: {}", vertices.len());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_rrt_that_gives_up_reports_how_near_it_came() {
    let run = finish(begin_with(&no_way(), "rrt", 1, "max_iterations=300"));
    let result = run.result();
    assert_eq!((result.status, result.path.len()), (Status::Exhausted, 0));
    let approximate = result.approximate.expect("an approximate path, named as such");
    let vertices = rows(run.as_ref());
    let goal = &vertices[1];
    let nearest = (0..vertices.len()).filter(|&v| v != 1).map(|v| distance(&vertices[v], goal)).fold(9.0, f64::min);
    assert_eq!(approximate.path[0], vertices[0]);
    assert_eq!(distance(&approximate.path[approximate.path.len() - 1], goal), approximate.goal_distance);
    assert_eq!(approximate.goal_distance, nearest, "it ends at the vertex of the tree nearest to the goal");
    let solved = finish(begin_with(&arm_and_wall(0.1), "rrt", 1, ""));
    assert!(solved.result().approximate.is_none());
}

#[wasm_bindgen_test(unsupported = test)]
fn every_search_finds_the_best_path_by_its_own_measure() {
    for seed in 0..seeds(10) {
        let world = arm_of(3, false, 0.0);
        let run = |settings: &str| finish(begin_with(&world, "prm", seed, &format!("samples=300 k=10 {settings}")));
        let a_star = run("");
        let (cost, hops) = (a_star.length(), |run: &dyn Run| run.path().len() - 1);
        for settings in ["search=dijkstra", "heuristic=end-effector", "heuristic=none"] {
            let other = run(settings);
            assert!((other.length() - cost).abs() <= 1e-12 * cost, "{settings}");
            assert!(other.stats().visited >= a_star.stats().visited, "{settings} visits at least as many vertices");
        }
        let breadth = run("search=breadth-first");
        assert_eq!(hops(run("search=bidirectional").as_ref()), hops(breadth.as_ref()));
        for heuristic in ["none", "metric", "end-effector"] {
            let settings = format!("cost=hops heuristic={heuristic}");
            assert_eq!(hops(run(&settings).as_ref()), hops(breadth.as_ref()), "{settings} is admissible");
        }
        assert_eq!(run("search=dijkstra cost=hops").path().len(), breadth.path().len());
        let mixed = run("cost=hops heuristic=metric-as-hops");
        assert!(mixed.status() == Status::Solved && hops(mixed.as_ref()) >= hops(breadth.as_ref()));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_roadmap_is_queried_while_it_grows_and_afterwards_and_stays_as_it_was() {
    let world = arm_of(3, false, 0.0);
    let inspector = planarium::run::inspect::Inspector::new(&world);
    let (start, goal) = ([0.2, 0.1, 0.3], [-3.0, -0.2, 0.1]);
    for (planner, settings) in [("prm", "samples=400"), ("prm-star", "samples=300"), ("visibility-prm", "")] {
        let before = finish(begin_with(&world, planner, 1, settings));
        let mut run = begin_with(&world, planner, 1, settings);
        while run.step(31) == Status::Running {
            run.query(&start, &goal, false).expect("a path through what there is, or none");
            refuses(run.query(&start, &goal, true), "unsupported", "/keep");
        }
        let answer = run.query(&start, &goal, false).expect("free ends");
        assert_eq!((answer.status, answer.query.as_str()), (Status::Solved, "asked"), "{planner}");
        assert_eq!([&answer.path[0], &answer.path[answer.path.len() - 1]], [&start.to_vec(), &goal.to_vec()]);
        for pair in answer.path.windows(2) {
            assert_eq!(inspector.first_hit(&pair[0], &pair[1]).expect("of this arm"), None);
        }
        assert_eq!(run.query(&start, &goal, false).expect("free ends").path, answer.path, "the same again");
        assert_eq!(run.fingerprint(), before.fingerprint(), "{planner}: queries leave no trace");
        run.query(&start, &goal, true).expect("free ends");
        let vertices = rows(run.as_ref());
        assert_eq!(vertices[before.vertex_count()..], [start.to_vec(), goal.to_vec()], "{planner} stores the two");
        assert!(run.edge_count() > before.edge_count());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_queries_are_refused_and_impossible_ones_have_no_path() {
    let (world, limited) = (arm_and_wall(0.1), arm_of(2, true, 0.0));
    let (prm, tree) = ((&world, "prm", "samples=100"), (&world, "rrt-connect", ""));
    let free = &[0.6, 0.2][..];
    for ((world, planner, settings), start, goal, code, pointer) in [
        (prm, free, &[0.6][..], "wrong-dimension", "/goal"),
        (prm, free, &[0.6, f64::NAN], "not-finite", "/goal/1"),
        (prm, free, &[1e7, 0.0], "out-of-range", "/goal/0"),
        (prm, free, &[0.0, 0.0], "goal-in-collision", "/goal"),
        (prm, free, &[0.6, 0.2, 0.0], "wrong-dimension", "/goal"),
        (prm, &[0.0, 0.0], free, "start-in-collision", "/start"),
        ((&limited, "prm", "samples=50"), &[0.1, 0.1], &[0.1, 3.6], "out-of-range", "/goal"),
        (tree, free, free, "unsupported", ""),
    ] {
        let mut run = finish(begin_with(world, planner, 1, settings));
        refuses(run.query(start, goal, false), code, pointer);
    }
    let mut cut_off = finish(begin_with(&no_way(), "prm", 1, "samples=200"));
    let answer = cut_off.query(&[1.5, 0.0], &[-1.5, 0.0], false).expect("free ends");
    assert_eq!((answer.status, answer.path.len()), (Status::Exhausted, 0), "there is no path");
}

#[wasm_bindgen_test(unsupported = test)]
fn every_kind_of_improvement_shortens_the_path_and_keeps_it_free() {
    for world in [arm_of(3, false, 0.02), disc_and_wall(0.2, 0.3)] {
        let mut shorter = [0; 3];
        for seed in 0..seeds(20) {
            let raw = finish(begin_with(&world, "rrt-connect", seed, "step=0.4"));
            for (i, settings) in ["reduce=true", "shortcut=60", "partial_shortcut=60"].into_iter().enumerate() {
                let run = finish(begin_with(&world, "rrt-connect", seed, &format!("step=0.4 {settings}")));
                assert!(run.length() <= raw.length(), "{settings}: {} after {}", run.length(), raw.length());
                assert_eq!(run.fingerprint(), raw.fingerprint(), "{settings} leaves the graph alone");
                assert!(i == 0 || run.iterations() == raw.iterations() + 60, "{settings}: one iteration per attempt");
                let path = run.path();
                assert_eq!((&path[0], path.last()), (&raw.path()[0], raw.path().last()));
                assert_valid(&world, &*run);
                shorter[i] += u64::from(run.length() < 0.99 * raw.length());
            }
        }
        assert!(shorter.iter().all(|&count| count >= seeds(20) / 2), "{shorter:?} of {}", seeds(20));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn edges_that_are_only_sampled_are_named_and_jump_through_a_thin_wall() {
    let thin = arm_and_wall(0.01);
    let mut through = 0;
    for seed in 0..seeds(20) {
        let sampled = finish(begin_with(&thin, "rrt-connect", seed, "edge_check=sampled edge_samples=4")).result();
        assert_eq!(sampled.edge_check.as_deref(), Some("sampled"));
        through += u64::from(judged(&thin, &sampled).is_err());
        assert!(finish(begin_with(&thin, "rrt-connect", seed, "")).result().edge_check.is_none());
    }
    assert!(through >= seeds(20) / 2, "{through} of {} paths cross the wall", seeds(20));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_naive_metric_goes_in_the_longer_direction() {
    let world = scenario("", "", &arm(&[1.0, 1.0], 0.0), r#""start": [0.2, 0.1], "goal": [-0.2, 0.1]"#);
    let wrapped = finish(begin_with(&world, "prm", 1, "samples=300 metric=euclidean"));
    let naive = finish(begin_with(&world, "prm", 1, "samples=300 metric=naive"));
    assert!(wrapped.length() < 0.5, "0.4 in the shorter direction: {}", wrapped.length());
    assert!(naive.length() > 5.8, "2 pi - 0.4 in the longer: {}", naive.length());
    assert!(naive.path().iter().flatten().all(|angle| (0.0..std::f64::consts::TAU).contains(angle)));
    assert_valid(&world, &*naive);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_path_as_it_was_found_is_stored() {
    for world in [arm_and_wall(0.1), disc_and_wall(0.2, 0.3)] {
        for planner in ["prm", "visibility-prm", "rrt", "rrt-connect"] {
            let plain = finish(begin_with(&world, planner, 3, ""));
            assert_eq!(plain.raw_path(), plain.path(), "{planner}: without improvement the two are one");
            let mut run = begin_with(&world, planner, 3, "reduce=true shortcut=60");
            while run.phase() != Phase::Improving {
                assert!(run.raw_path().is_empty(), "{planner}: nothing is found yet");
                run.step(1);
            }
            assert_eq!((run.raw_path(), run.path().len()), (plain.path(), 0), "{planner}: while it is improved");
            run.step(u64::MAX);
            assert_eq!(run.raw_path(), plain.path(), "{planner}: afterwards");
            assert!(run.length() < plain.length() && run.raw_path() != run.path());
        }
    }
    assert!(finish(begin_with(&no_way(), "rrt", 1, "max_iterations=50")).raw_path().is_empty());
}
