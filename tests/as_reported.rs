//! The ways of the course reports: growth past the goal, edges that nobody checks, neighbours by an index and a metric of their own,
//! faulty searches, lengths by chords. They obey the laws of all runs, and what they miss shows.

use crate::common::documents::{arm, judged, refuses, scenario};
use crate::common::driven::car;
use crate::common::graphs::{edges, rows, tried};
use crate::common::requests;
use crate::common::requests::start;
use crate::common::{
    arm_and_wall, arm_of, assert_valid, begin_with, car_and_wall, disc_and_wall, finish, no_way, options, seeds, worlds,
};
use planarium::geometry::{Point, Segment};
use planarium::planner::{EdgeCheck, planners};
use planarium::problem::{Motion, Reason};
use planarium::run::storage::RoadmapDocument;
use planarium::run::{Request, Run, Status};
use planarium::scenario::generate::generate;
use planarium::scenario::{Robot, Scenario};
use planarium::space::angular_distance;
use std::f64::consts::TAU;
use wasm_bindgen_test::wasm_bindgen_test;

/// Settings of planners of every robot.
pub const REPORTED: &[(&str, &str)] = &[
    ("rrt", "vertices=150"),
    ("rrt", "extend=half goal_bias=0.2 vertices=90 edge_check=sampled edge_samples=5"),
    ("rrt", "extend=until-obstacle vertices=60 shortcut=20"),
    ("rrt", "edge_check=none"),
    ("rrt-connect", "edge_check=none"),
    ("prm", "samples=150 k=6 edge_check=none search=bidirectional-requeued"),
    ("prm", "samples=150 k=6 neighbour_metric=naive heuristic=naive"),
    ("prm", "samples=150 k=6 neighbour_metric=naive insertion=one-by-one discard=true"),
    ("prm", "samples=200 k=4 neighbour_index=forest"),
    ("prm", "samples=150 k=6 neighbour_index=kd-tree-unwrapped neighbour_metric=naive"),
    ("prm", "samples=200 k=4 neighbour_index=forest neighbour_metric=naive radius=2"),
];

/// Settings of planners by controls.
pub const REPORTED_DRIVEN: &[(&str, &str)] = &[
    ("rrt-control", "vertices=200"),
    ("rrt-control", "vertices=120 controls=reeds-shepp duration_steps=120 once=true"),
];

#[wasm_bindgen_test(unsupported = test)]
fn events_change_nothing() {
    let cars = std::iter::once((car_and_wall(0.1), REPORTED_DRIVEN));
    for (world, planners) in worlds().into_iter().map(|world| (world, REPORTED)).chain(cars) {
        for &(planner, settings) in planners {
            let settings = format!("{settings} max_iterations=3000");
            let whole = finish(begin_with(&world, planner, 5, &settings));
            let what = format!("{planner} {settings} on {}", world.name());
            let silent = Request { events: false, ..options(planner, 5, &settings) };
            let silent = finish(start(&world, &silent).expect("a run"));
            assert_eq!((silent.stats(), silent.path()), (whole.stats(), whole.path()), "{what}");
            if whole.status() == Status::Solved && !settings.contains("edge_check") {
                assert_valid(&world, &*whole);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tree_grows_past_the_goal_to_so_many_vertices_and_keeps_its_first_path() {
    for (world, planner, settings, unreached) in [
        (arm_and_wall(0.1), "rrt", "direct=false goal_bias=0.2", 0),
        (disc_and_wall(0.3, 0.5), "rrt", "direct=false extend=until-obstacle", 0),
        (car_and_wall(0.1), "rrt-control", "duration_steps=120", 0),
    ] {
        for seed in 0..seeds(10) {
            let first = finish(begin_with(&world, planner, seed, settings));
            assert_eq!(first.status(), Status::Solved, "{planner} seed {seed}");
            let most = first.vertex_count() + 100;
            let settings = format!("{settings} vertices={most}");
            let mut run = begin_with(&world, planner, seed, &settings);
            run.step(first.iterations());
            assert_eq!((run.status(), run.fingerprint()), (Status::Running, first.fingerprint()), "it goes on");
            assert_eq!(run.raw_path(), first.path(), "the path is there");
            let mut short = begin_with(&world, planner, seed, &settings);
            short.step(first.iterations() + 1);
            assert_eq!((short.finish(), short.path()), (Status::Solved, first.path()), "and can be taken at any time");
            run.step(u64::MAX);
            assert_eq!((run.status(), run.vertex_count()), (Status::Solved, most + unreached), "{planner} seed {seed}");
            assert_eq!((run.path(), run.edge_count()), (first.path(), most - 1), "a tree, and its first path");
            assert_valid(&world, &*run);
            // The budget may end first; then the path stands, too.
            let budget = format!("{settings} max_iterations={}", first.iterations() + 3);
            let cut = finish(begin_with(&world, planner, seed, &budget));
            assert_eq!((cut.status(), cut.path()), (Status::Solved, first.path()));
        }
    }
    let never = finish(begin_with(&no_way(), "rrt", 1, "vertices=50"));
    // The goal is a vertex of the graph from the beginning.
    assert_eq!((never.status(), never.vertex_count()), (Status::Exhausted, 51));
    assert!(never.result().approximate.is_some());
}

#[wasm_bindgen_test(unsupported = test)]
fn without_an_edge_check_vertices_are_free_and_paths_cross_obstacles() {
    let world = arm_and_wall(0.1);
    let inspector = planarium::run::inspect::Inspector::new(&world);
    for (planner, settings) in [("prm", "samples=200 k=10"), ("rrt", "step=1"), ("rrt-connect", "step=1")] {
        let mut through = 0;
        for seed in 0..seeds(20) {
            let run = |check: &str| finish(begin_with(&world, planner, seed, &format!("{settings} {check}")));
            let unchecked = run("edge_check=none");
            let result = unchecked.result();
            assert_eq!((result.status, result.edge_check.as_deref()), (Status::Solved, Some("none")));
            assert!(rows(&*unchecked).iter().all(|q| inspector.check(q).expect("a configuration").is_empty()));
            let far_end = run("edge_check=sampled edge_samples=1");
            assert_eq!((unchecked.fingerprint(), unchecked.stats()), (far_end.fingerprint(), far_end.stats()));
            through += u64::from(judged(&world, &result).is_err());
            assert_valid(&world, &*run(""));
        }
        assert!(through >= seeds(20) / 2, "{planner}: {through} of {} paths cross the wall", seeds(20));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn an_unchecked_roadmap_is_stored_as_such() {
    let world = arm_and_wall(0.1);
    let settings = "samples=100 k=8 edge_check=none";
    let run = finish(begin_with(&world, "prm", 1, settings));
    let document = run.roadmap().expect("a roadmap");
    assert_eq!((document.edge_check, document.edge_samples), (EdgeCheck::None, None));
    assert!(document.to_json().contains(r#""edge_check":"none""#) && !document.to_json().contains("edge_samples"));
    for form in [document.to_json().into_bytes(), document.to_bytes()] {
        assert_eq!(RoadmapDocument::read(&form).expect("it can be read"), document);
    }
    let again = |settings: &str| requests::resume(&world, &options("prm", 1, settings), &document);
    let resumed = finish(again("edge_check=none").expect("it continues")).result();
    assert_eq!((resumed.edge_check.as_deref(), resumed.path), (Some("none"), run.path()));
    refuses(again("edge_check=proven"), "out-of-range", "/edge_check");
    let lie = RoadmapDocument { edge_check: EdgeCheck::Proven, ..document.clone() };
    refuses(
        requests::resume(&world, &options("prm", 1, ""), &lie).map(|_| ()),
        "invalid-roadmap",
        &first_blocked(&lie),
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn joints_on_straight_lines_miss_collisions_and_refuse_free_motions() {
    // A disc that the first link sweeps and no joint meets.
    let post = r#"{"type": "disc", "center": [0.5, 0], "radius": 0.1}"#;
    let world = scenario("", post, &arm(&[1.0, 1.0], 0.0), r#""start": [0.6, 0.1], "goal": [-0.6, -0.1]"#);
    let inspector = planarium::run::inspect::Inspector::new(&world);
    let Robot::Arm(robot) = world.robot() else { panic!("an arm") };
    let crosses = |a: Point, b: Point| {
        world.world().obstacles.iter().any(|wall| wall.distance_to_segment(&Segment::new(a, b)) <= 0.0)
    };
    let passes = |a: &[f64], b: &[f64]| (1..=2).all(|joint| !crosses(robot.joints(a)[joint], robot.joints(b)[joint]));
    for (planner, settings) in
        [("prm", "samples=200 k=10"), ("rrt", "extend=until-obstacle"), ("rrt-connect", "step=1")]
    {
        let (mut through, mut needless) = (0, 0);
        for seed in 0..seeds(20) {
            let settings = format!("{settings} edge_check=joint-lines");
            let run = finish(begin_with(&world, planner, seed, &settings));
            let result = run.result();
            assert_eq!((result.status, result.edge_check.as_deref()), (Status::Solved, Some("joint-lines")));
            let vertices = rows(&*run);
            assert!(vertices.iter().all(|q| inspector.check(q).expect("a configuration").is_empty()));
            let edges = edges(&*run);
            assert!(edges.iter().all(|&[a, b]| passes(&vertices[a], &vertices[b])));
            through += u64::from(judged(&world, &result).is_err());
            let is_proven = |a: &[f64], b: &[f64]| inspector.first_hit(a, b).expect("configurations").is_none();
            let is_needless =
                |&&[a, b]: &&[usize; 2]| !passes(&vertices[a], &vertices[b]) && is_proven(&vertices[a], &vertices[b]);
            needless += tried(&*run).iter().filter(is_needless).count();
        }
        assert!(through >= seeds(20) / 4, "{planner}: {through} of {} paths meet the post", seeds(20));
        assert!(planner != "prm" || needless > 0, "a chord may cross what the joint goes round");
    }
    let settings = "samples=100 k=8 edge_check=joint-lines";
    let run = finish(begin_with(&world, "prm", 1, settings));
    let document = run.roadmap().expect("a roadmap");
    assert_eq!((document.edge_check, document.edge_samples), (EdgeCheck::JointLines, None));
    for form in [document.to_json().into_bytes(), document.to_bytes()] {
        assert_eq!(RoadmapDocument::read(&form).expect("it can be read"), document);
    }
    let resumed = requests::resume(&world, &options("prm", 1, "edge_check=joint-lines"), &document);
    assert_eq!(finish(resumed.expect("it continues")).path(), run.path());
}

#[wasm_bindgen_test(unsupported = test)]
fn interpolation_by_the_sign_of_the_difference_misses_goals_across_the_cut() {
    let inspector = planarium::run::inspect::Inspector::new(arm_of(2, false, 0.0));
    let is_near = |q: &[f64], other: &[f64]| q.iter().zip(other).all(|(a, b)| angular_distance(*a, *b) < 1e-12);
    for t in [0.0, 0.25, 0.5, 1.0] {
        let [a, b] = [[-1.0, 0.5], [1.5, -1.0]];
        let [short, by_sign] = [inspector.interpolate(&a, &b, t), inspector.interpolate_by_sign(&a, &b, t)];
        assert!(is_near(&short.unwrap(), &by_sign.unwrap()), "less than half a turn");
        // Six radians apart: 2 pi - 6 the short way, which is downwards.
        let turn = t * (TAU - 6.0);
        assert!(is_near(&inspector.interpolate(&[-3.0, 0.5], &[3.0, 0.5], t).unwrap(), &[-3.0 - turn, 0.5]));
        assert!(is_near(&inspector.interpolate_by_sign(&[-3.0, 0.5], &[3.0, 0.5], t).unwrap(), &[-3.0 + turn, 0.5]));
    }
    refuses(inspector.interpolate_by_sign(&[0.0, 0.0], &[1.0, 1.0], 1.5), "out-of-range", "/t");
}

/// The pointer of the first edge that is not free.
fn first_blocked(document: &RoadmapDocument) -> String {
    let rows: Vec<&[f64]> = document.rows().collect();
    let inspector = planarium::run::inspect::Inspector::new(arm_and_wall(0.1));
    let is_hit =
        |&[a, b]: &[u32; 2]| inspector.first_hit(rows[a as usize], rows[b as usize]).expect("configurations").is_some();
    format!("/edges/{}", document.edges.iter().position(is_hit).expect("some edge crosses the wall"))
}

/// The distance of two configurations of an arm without wrap-around.
fn naive(a: &[f64], b: &[f64]) -> f64 {
    let open = |x: f64| if x < 0.0 { x + TAU } else { x };
    a.iter().zip(b).map(|(&a, &b)| (open(a) - open(b)) * (open(a) - open(b))).sum::<f64>().sqrt()
}

#[wasm_bindgen_test(unsupported = test)]
fn naive_neighbours_are_chosen_without_wrapping_while_edges_wrap() {
    const K: usize = 5;
    let world = arm_of(2, false, 0.0);
    for (index, insertion) in [("exact", "batch"), ("forest", "batch"), ("exact", "one-by-one")] {
        let settings = format!("direct=false samples=40 k={K} neighbour_index={index} insertion={insertion}");
        let run = finish(begin_with(&world, "prm", 3, &format!("{settings} neighbour_metric=naive")));
        let vertices = rows(&*run);
        let nearest = |v: usize, among: usize| {
            let mut others: Vec<usize> = (0..among).filter(|&other| other != v).collect();
            others.sort_by(|&a, &b| naive(&vertices[v], &vertices[a]).total_cmp(&naive(&vertices[v], &vertices[b])));
            others.truncate(K);
            others
        };
        // As few as these a forest finds all.
        let mut expected: Vec<[usize; 2]> = match insertion {
            "batch" => {
                (0..vertices.len()).flat_map(|v| nearest(v, vertices.len()).into_iter().map(move |w| [v, w])).collect()
            }
            _ => (2..vertices.len())
                .flat_map(|v| nearest(v, v).into_iter().map(move |w| [v, w]))
                .chain([[1, 0]])
                .collect(),
        };
        let mut found = tried(&*run);
        for pairs in [&mut expected, &mut found] {
            pairs.iter_mut().for_each(|pair| pair.sort_unstable());
            pairs.sort_unstable();
        }
        let count = found.len();
        found.dedup();
        expected.dedup();
        assert_eq!(found.len(), count, "no motion is tried twice");
        assert_eq!(found, expected, "{settings}");
        assert_eq!(run.status() == Status::Solved, !run.path().is_empty());
    }
    let settings = format!("direct=false samples=40 k={K} neighbour_metric=naive neighbour_index=");
    let [exact, tree] = ["exact", "kd-tree-unwrapped"]
        .map(|index| tried(&*finish(begin_with(&world, "prm", 3, &format!("{settings}{index}")))));
    assert_eq!(exact, tree, "the naive metric wraps nothing");
    // The short way round: no edge turns a joint by more than half a turn, and lengths are those of edges.
    let run = finish(begin_with(&world, "prm", 3, "samples=300 k=30 neighbour_metric=naive"));
    let path = run.path();
    let length: f64 =
        path.windows(2).map(|pair| (0..2).map(|i| angular_distance(pair[0][i], pair[1][i])).sum::<f64>()).sum();
    assert!((run.length() - length).abs() < 1e-9);
    assert_valid(&world, &*run);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tree_without_wrap_around_misses_edges_across_pi_and_those_that_it_finds_are_proven() {
    const K: usize = 5;
    let world = arm_of(2, false, 0.0);
    let settings = format!("direct=false samples=60 k={K} neighbour_index=kd-tree-unwrapped");
    let run = finish(begin_with(&world, "prm", 3, &settings));
    let vertices = rows(&*run);
    let plain = |a: usize, b: usize| -> f64 { vertices[a].iter().zip(&vertices[b]).map(|(a, b)| (a - b).abs()).sum() };
    let mut expected = Vec::new();
    for v in 0..vertices.len() {
        let mut others: Vec<usize> = (0..vertices.len()).filter(|&other| other != v).collect();
        others.sort_by(|&a, &b| plain(v, a).total_cmp(&plain(v, b)));
        expected.extend(others[..K].iter().map(|&other| [v.min(other), v.max(other)]));
    }
    let mut found = tried(&*run);
    found.iter_mut().for_each(|pair| pair.sort_unstable());
    let count = found.len();
    for pairs in [&mut expected, &mut found] {
        pairs.sort_unstable();
        pairs.dedup();
    }
    assert_eq!((found.len(), &found), (count, &expected), "the nearest by plain numbers, no motion twice");
    assert!(found.iter().all(|&[a, b]| plain(a, b) < 3.0), "no edge crosses the seam");

    // Where so many neighbours are asked for that some lie beyond the seam, edges go the short way.
    let run = finish(begin_with(&world, "prm", 3, "samples=60 k=61 direct=false neighbour_index=kd-tree-unwrapped"));
    let exact = finish(begin_with(&world, "prm", 3, "samples=60 k=61 direct=false"));
    assert_eq!((run.path(), run.length()), (exact.path(), exact.length()), "every vertex is a neighbour");
    assert_valid(&world, &*run);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_misses_some_neighbours_and_tries_no_motion_twice() {
    let world = arm_of(4, false, 0.0);
    let run = |index: &str| {
        finish(begin_with(&world, "prm", 2, &format!("samples=1000 k=5 neighbour_index={index} radius=3")))
    };
    let pairs = |run: &dyn planarium::run::Run| {
        let mut pairs = tried(run);
        pairs.iter_mut().for_each(|pair| pair.sort_unstable());
        pairs.sort_unstable();
        pairs
    };
    let [exact, forest] = [run("exact"), run("forest")];
    assert_eq!(rows(&*exact), rows(&*forest), "the vertices are the same");
    let [exact, forest] = [pairs(&*exact), pairs(&*forest)];
    let mut once = forest.clone();
    once.dedup();
    assert_eq!(once, forest);
    let found = exact.iter().filter(|pair| forest.binary_search(pair).is_ok()).count();
    assert!(found < exact.len() && found * 2 > exact.len(), "{found} of {}", exact.len());
    let car = car_and_wall(0.1);
    let solved = finish(begin_with(&car, "prm", 1, "samples=300 k=20 neighbour_index=forest neighbour_metric=naive"));
    assert_eq!(solved.status(), Status::Solved);
    assert_valid(&car, &*solved);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_naive_heuristic_may_miss_the_shortest_path() {
    let world = scenario("", "", &arm(&[1.0, 1.0], 0.0), r#""start": [1.2, 0.1], "goal": [-1.2, 0.1]"#);
    let mut longer = 0;
    for seed in 0..seeds(20) {
        let run = |heuristic: &str| {
            let settings = format!("direct=false samples=300 k=8 heuristic={heuristic}");
            finish(begin_with(&world, "prm", seed, &settings))
        };
        let [metric, naive] = [run("metric"), run("naive")];
        assert_eq!((naive.status(), naive.edge_count()), (metric.status(), metric.edge_count()));
        assert!(naive.length() >= metric.length() * (1.0 - 1e-12));
        longer += u64::from(naive.length() > metric.length() * 1.01);
    }
    assert!(longer >= seeds(20) / 4, "{longer} of {}: it shuns the short way across 0", seeds(20));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_requeueing_search_visits_more_vertices_than_there_are() {
    let world = generate("forest", &serde_json::json!({ "links": 2, "seed": 7 })).expect("a forest");
    let mut longer = 0;
    for seed in 0..seeds(10) {
        let run = |search: &str| {
            finish(begin_with(&world, "prm", seed, &format!("samples=400 k=30 max_iterations=1000000 search={search}")))
        };
        let [requeued, breadth] = [run("bidirectional-requeued"), run("breadth-first")];
        assert_eq!(edges(&*requeued), edges(&*breadth));
        assert_eq!(requeued.status(), breadth.status());
        if requeued.status() == Status::Solved {
            assert_valid(&world, &*requeued);
            let most = requeued.vertex_count() as u64;
            assert!(requeued.stats().visited > most && breadth.stats().visited <= most, "seed {seed}");
            let extra = requeued.raw_path().len() - breadth.raw_path().len();
            assert!(extra <= 2, "{extra} more vertices");
            longer += u64::from(extra > 0);
        }
    }
    assert!(longer > 0, "the first meeting is not the best");
}

#[wasm_bindgen_test(unsupported = test)]
fn chords_are_no_longer_than_arcs_and_are_verified() {
    let world = car_and_wall(0.1);
    for seed in 0..seeds(10) {
        let result = finish(begin_with(&world, "rrt-control", seed, "")).result();
        let chords = result.chord_length.expect("a driven path has chords");
        // Along the arcs, in the metric of the car, by which the chords are measured too.
        let along = |Motion { control, duration }: &Motion| {
            let turn = car(&world).turn_rate(control.speed, control.steering).abs();
            (0.7 * control.speed.abs() + 0.3 * turn) * duration
        };
        let arcs: f64 = result.motions.iter().flatten().map(along).sum();
        assert!(chords > 0.5 * arcs && chords < arcs, "{chords} of {arcs}");
        judged(&world, &result).expect("a valid path");
        let wrong = planarium::path::ResultDocument { chord_length: Some(1.01 * chords), ..result };
        assert!(judged(&world, &wrong).expect_err("a wrong length").contains("chord"));
    }
    for planner in ["rrt-connect", "prm"] {
        assert!(finish(begin_with(&world, planner, 1, "")).result().chord_length.is_none());
    }
    let unsolved = finish(begin_with(&world, "rrt-control", 1, "max_iterations=2")).result();
    assert_eq!((unsolved.status, unsolved.chord_length), (Status::Exhausted, None));
}

#[wasm_bindgen_test(unsupported = test)]
fn every_preset_runs() {
    for planner in planners() {
        let world = if planner.robots().contains(&"arm") { arm_of(3, false, 0.02) } else { car_and_wall(0.1) };
        for preset in planner.info().presets {
            let options = Request {
                planner: Some(planner.info().id.to_owned()),
                parameters: preset.parameters(),
                ..Request::default()
            };
            let run = finish(start(&world, &options).unwrap_or_else(|error| panic!("{}: {error}", preset.id)));
            let is_hopeful = run.status() == Status::Solved || run.result().approximate.is_some();
            assert!(is_hopeful || preset.id.contains("three-nearest"), "{} {}", planner.info().id, preset.id);
        }
    }
}

/// What a search of the same roadmaps finds.
fn searched(world: &Scenario, seed: u64, settings: &str) -> Box<dyn Run> {
    finish(begin_with(world, "prm", seed, &format!("samples=300 k=10 direct=false {settings}")))
}

#[wasm_bindgen_test(unsupported = test)]
fn the_stale_a_star_finds_a_path_wherever_there_is_one_and_not_always_the_shortest() {
    let mut longer = 0;
    for seed in 0..seeds(60) {
        let world = generate("forest", &serde_json::json!({ "links": 2, "seed": seed })).expect("a forest");
        let [right, stale] =
            ["a-star", "a-star-stale"].map(|search| searched(&world, seed, &format!("search={search}")));
        assert_eq!((stale.status(), edges(&*stale)), (right.status(), edges(&*right)), "seed {seed}");
        assert_eq!(stale.stats().reopened, 0, "what is closed stays closed");
        assert!(stale.stats().visited <= stale.vertex_count() as u64);
        if right.status() == Status::Solved {
            assert_valid(&world, &*stale);
            assert!(stale.length() >= right.length() * (1.0 - 1e-12), "seed {seed}");
            longer += u64::from(stale.length() > right.length() * (1.0 + 1e-9));
        }
    }
    assert!(longer > 0, "of {} forests", seeds(60));
}

#[wasm_bindgen_test(unsupported = test)]
fn overwritten_parents_lead_to_the_start_now_and_then_and_a_miss_is_not_called_unconnected() {
    let mut counts = [0; 2];
    for seed in 0..seeds(60) {
        let world = generate("forest", &serde_json::json!({ "links": 2, "seed": seed })).expect("a forest");
        for insertion in ["batch", "one-by-one"] {
            let given = |search: &str| format!("insertion={insertion} search={search}");
            let [right, parents] = ["a-star", "parents"].map(|search| searched(&world, seed, &given(search)));
            assert_eq!(edges(&*parents), edges(&*right));
            assert!(parents.stats().visited <= parents.vertex_count() as u64, "no vertex twice");
            if parents.status() == Status::Solved {
                assert_valid(&world, &*parents);
                assert!(parents.length() >= right.length() * (1.0 - 1e-12));
            } else {
                assert_eq!(parents.reason(), Some(Reason::SearchFailed));
                assert!(parents.explanation().expect("a reason").contains("may have one"));
            }
            counts[usize::from(parents.status() == Status::Solved)] += u64::from(right.status() == Status::Solved);
        }
    }
    assert!(counts[0] > 0 && counts[1] > 0, "missed and found: {counts:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn consistent_heuristics_expand_nothing_again_and_goals_drawn_are_counted() {
    let mut reopened = 0;
    for seed in 0..seeds(40) {
        let world = generate("forest", &serde_json::json!({ "links": 3, "seed": seed })).expect("a forest");
        for heuristic in ["metric", "end-effector", "none"] {
            assert_eq!(searched(&world, seed, &format!("heuristic={heuristic}")).stats().reopened, 0, "{heuristic}");
        }
        reopened += searched(&world, seed, "heuristic=naive").stats().reopened;
    }
    assert!(reopened > 0, "the naive heuristic is not consistent");
    for (settings, low, high) in [("goal_every=5", 200, 200), ("goal_bias=0", 0, 0), ("goal_bias=0.05", 20, 90)] {
        let run = finish(begin_with(&no_way(), "rrt", 3, &format!("direct=false max_iterations=1000 {settings}")));
        let drawn = run.stats().goal_samples;
        assert!((low..=high).contains(&drawn), "{settings}: {drawn}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn rrt_may_grow_towards_free_samples_only() {
    for (world, seed) in [(arm_and_wall(0.1), 2), (disc_and_wall(0.3, 0.5), 3)] {
        let run = finish(begin_with(&world, "rrt", seed, "direct=false free_samples=true"));
        assert_eq!(run.status(), Status::Solved);
        assert_valid(&world, &*run);
        let anywhere = finish(begin_with(&world, "rrt", seed, "direct=false"));
        assert!(run.stats().rejected_samples > 0 && anywhere.stats().rejected_samples == 0);
    }
}
