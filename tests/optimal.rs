//! Planners whose paths approach the shortest: paths never get longer, costs are the sums of edges after every rewiring, and the tree
//! stays a tree.

use crate::common::graphs::{events, rows, tried};
use crate::common::{
    PLANNERS, arm_and_wall, arm_of, assert_valid, begin_with, disc_and_pillar, disc_and_wall, finish, seeds,
};
use planarium::graph::{CostTree, EventKind, VertexId};
use planarium::random::{Random, Stream};
use planarium::run::inspect::Inspector;
use planarium::run::{HISTORY_WIDTH, Reason, Run, Status};
use wasm_bindgen_test::wasm_bindgen_test;

/// Each planner with settings, and whether it goes on after its first path.
const OPTIMAL: [(&str, &str, bool); 4] = [
    ("rrt-star", "improve_iterations=1000 max_iterations=4000", true),
    ("informed-rrt-star", "improve_iterations=1000 max_iterations=4000", true),
    ("fmt-star", "samples=600", false),
    ("bit-star", "improve_iterations=4000 max_iterations=10000", true),
];

/// The parent of every vertex by the edges of a run: the last edge to a vertex counts.
fn parents(run: &dyn Run) -> Vec<Option<usize>> {
    let mut parents = vec![None; run.vertex_count()];
    for edge in run.edge_rows(0).chunks(2) {
        parents[edge[1] as usize] = Some(edge[0] as usize);
    }
    parents
}

/// The vertices from the root to this one.
///
/// # Panics
/// If they have no end.
fn from_root(parents: &[Option<usize>], vertex: usize) -> Vec<usize> {
    let mut path: Vec<usize> = std::iter::successors(Some(vertex), |&at| parents[at]).take(parents.len() + 1).collect();
    assert!(path.len() <= parents.len(), "a cycle through vertex {vertex}");
    path.reverse();
    path
}

/// The length along configurations, added from the first on.
fn length(world: &Inspector, path: &[&[f64]]) -> f64 {
    path.windows(2).fold(0.0, |sum, pair| sum + world.distance(pair[0], pair[1]).expect("configurations"))
}

#[wasm_bindgen_test(unsupported = test)]
fn the_path_is_along_the_edges_and_never_gets_longer() {
    let worlds = [arm_and_wall(0.1), disc_and_wall(0.3, 0.5)];
    for (world, (planner, settings, goes_on)) in worlds.iter().flat_map(|world| OPTIMAL.map(|case| (world, case))) {
        let inspector = Inspector::new(world);
        for near in ["radius", "k-nearest"] {
            let mut run = begin_with(world, planner, 3, &format!("near={near} {settings}"));
            run.record().expect("nothing is done yet");
            let (mut found, mut rewired) = (0, 0);
            while run.status() == Status::Running {
                run.step(50);
                let parents = parents(&*run);
                let vertices = run.vertex_rows(0);
                let state = |vertex: usize| &vertices[vertex * run.dimension()..][..run.dimension()];
                let row = run.history_since(run.history_count() - 1);
                let cost = row[HISTORY_WIDTH - 1];
                // The goal has no parent until it is reached; FMT* has a path once there is no cheaper one.
                assert!(parents[1].is_some() || cost == f64::INFINITY);
                assert!(!goes_on || parents[1].is_none() || cost < f64::INFINITY);
                if cost < f64::INFINITY {
                    let path: Vec<&[f64]> = from_root(&parents, 1).into_iter().map(state).collect();
                    assert_eq!(
                        cost.to_bits(),
                        length(&inspector, &path).to_bits(),
                        "{planner}: the cost is the sum of the edges"
                    );
                    found += 1;
                }
                (0..parents.len()).for_each(|vertex| drop(from_root(&parents, vertex)));
                let rewirings = events(&*run, EventKind::ParentChanged).len();
                let joined = (1..parents.len()).filter(|&vertex| parents[vertex].is_some()).count();
                assert_eq!(run.edge_count(), joined + rewirings, "every edge is new or replaces one");
                rewired = rewirings;
                let mut is_removed = vec![false; parents.len()];
                events(&*run, EventKind::VertexRemoved).iter().for_each(|event| is_removed[event[2] as usize] = true);
                let remain = (0..parents.len()).filter(|&vertex| !is_removed[vertex]);
                assert!(remain.filter_map(|vertex| parents[vertex]).all(|parent| !is_removed[parent]), "{planner}");
            }
            assert!(if goes_on { found > 5 && rewired > 20 } else { rewired == 0 }, "{planner}: {found} {rewired}");
            let history = run.history_since(0);
            let costs: Vec<f64> = history.chunks(HISTORY_WIDTH).map(|row| row[HISTORY_WIDTH - 1]).collect();
            assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "the cost never rises");
            let falls = costs.windows(2).filter(|pair| pair[1] < pair[0]).count();
            assert_eq!(events(&*run, EventKind::SolutionFound).len(), falls, "an event for each shorter path");
            assert_valid(world, &*run);
        }
    }
}

/// The length of the shortest path of a disc over the wall of `disc_and_wall`: a tangent to the disc about either upper corner, an arc
/// on it, and the width of the wall.
fn shortest_over_wall(radius: f64, thickness: f64) -> f64 {
    let (across, up) = (4.0 - thickness / 2.0, 7.0f64);
    let distance = up.hypot(across);
    let arc = std::f64::consts::FRAC_PI_2 + up.atan2(across) - (radius / distance).acos();
    2.0 * ((distance * distance - radius * radius).sqrt() + radius * arc) + thickness
}

#[wasm_bindgen_test(unsupported = test)]
fn paths_approach_the_shortest() {
    let world = disc_and_wall(0.3, 0.5);
    let shortest = shortest_over_wall(0.3, 0.5);
    let nears = ["near=radius", "near=k-nearest"];
    for (planner, settings, nears, most) in [
        ("rrt-star", "improve_iterations=3000", &nears[..], 1.04),
        ("informed-rrt-star", "improve_iterations=3000", &nears, 1.04),
        ("fmt-star", "samples=2000", &nears, 1.06),
        ("bit-star", "improve_iterations=4000", &nears, 1.04),
        ("aorrtc", "improve_iterations=3000", &[""], 1.04),
    ] {
        for near in nears {
            for seed in 0..seeds(3) {
                let run = finish(begin_with(&world, planner, seed, &format!("{near} {settings}")));
                let ratio = run.length() / shortest;
                assert!((1.0 - 1e-12..most).contains(&ratio), "{planner} {near} {seed}: {ratio}");
                assert_valid(&world, &*run);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn samples_that_cannot_help_are_discarded() {
    let world = disc_and_wall(0.3, 0.5);
    let settings = "improve_iterations=2000";
    let (plain, informed) = (
        finish(begin_with(&world, "rrt-star", 1, settings)),
        finish(begin_with(&world, "informed-rrt-star", 1, settings)),
    );
    assert!(events(&*plain, EventKind::SampleDiscarded).is_empty());
    let discarded = events(&*informed, EventKind::SampleDiscarded);
    assert!(discarded.len() > 20, "{}", discarded.len());
    let inspector = Inspector::new(&world);
    let [start, goal] = [[1.0, 1.0], [9.0, 1.0]];
    let best = informed.length();
    let by_way = |q: &[f64]| {
        let apart = |a: &[f64], b: &[f64]| inspector.distance(a, b).expect("configurations");
        apart(&start, q) + apart(q, &goal)
    };
    assert!(discarded.iter().all(|event| by_way(&event[4..]) >= best * (1.0 - 1e-12) || event[2] < 0.0));
    assert!(informed.vertex_count() < plain.vertex_count());
}

#[wasm_bindgen_test(unsupported = test)]
fn what_cannot_be_on_a_shorter_path_is_removed() {
    for world in [disc_and_pillar(), arm_and_wall(0.1)] {
        let run = finish(begin_with(&world, "bit-star", 1, "improve_iterations=3000"));
        let removed = events(&*run, EventKind::VertexRemoved);
        assert!(removed.len() > 20, "{}", removed.len());
        let inspector = Inspector::new(&world);
        let ends = rows(&*run);
        let by_way = |q: &[f64]| length(&inspector, &[&ends[0], q, &ends[1]]);
        assert!(removed.iter().all(|event| by_way(&event[4..]) >= run.length() * (1.0 - 1e-12)));
        let mut numbers: Vec<u64> = removed.iter().map(|event| event[2] as u64).collect();
        numbers.sort_unstable();
        numbers.dedup();
        assert_eq!(numbers.len(), removed.len(), "none twice");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn batches_try_no_motion_twice() {
    for world in [arm_and_wall(0.1), arm_of(3, true, 0.02), disc_and_wall(0.3, 0.5)] {
        for (planner, settings) in PLANNERS.iter().filter(|(planner, _)| ["fmt-star", "bit-star"].contains(planner)) {
            let run = finish(begin_with(&world, planner, 1, &format!("direct=false {settings}")));
            let mut pairs = tried(&*run);
            let count = pairs.len();
            assert_eq!(run.stats().motion_checks, count as u64, "{planner} {settings}");
            pairs.sort_unstable();
            pairs.dedup();
            assert_eq!(pairs.len(), count, "{planner} {settings}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_march_that_finds_no_path_goes_on_with_twice_as_many_samples() {
    let world = disc_and_wall(0.3, 0.5);
    for seed in 0..seeds(3) {
        let few = finish(begin_with(&world, "fmt-star", seed, "samples=2"));
        assert_eq!((few.reason(), few.vertex_count()), (Some(Reason::NotConnected), 4), "as many as were asked for");
    }
    let narrow = disc_and_wall(0.49, 0.5);
    let run = finish(begin_with(&narrow, "fmt-star", 1, ""));
    assert_eq!(run.status(), Status::Solved);
    let vertices = run.vertex_count();
    assert!(vertices > 1002 && vertices.is_multiple_of(1002) && (vertices / 1002).is_power_of_two(), "{vertices}");
    assert_valid(&narrow, &*run);
    let run = finish(begin_with(&crate::common::no_way(), "fmt-star", 1, "max_iterations=2000"));
    assert_eq!((run.status(), run.iterations()), (Status::Exhausted, 2000));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_straight_path_is_the_shortest_and_ends_the_run() {
    let empty = crate::common::parse(
        r#"{"format": "planarium-scenario-1", "name": "empty", "world": {"bounds": {"min": [0, 0], "max": [4, 4]}, "obstacles": []},
            "robot": {"type": "disc", "radius": 0.1}, "queries": [{"name": "q", "start": [1, 1], "goal": [1.5, 1.5]}]}"#,
    );
    for planner in ["rrt-star", "informed-rrt-star", "bit-star"] {
        let run = finish(begin_with(&empty, planner, 0, ""));
        assert_eq!((run.status(), run.path()), (Status::Solved, vec![vec![1.0, 1.0], vec![1.5, 1.5]]));
        assert!(run.iterations() < 5000);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn costs_follow_every_change_of_a_parent() {
    let mut random = Random::new(7, Stream::Samples);
    let mut tree = CostTree::of(VertexId(0));
    let mut simple: Vec<Option<(usize, f64)>> = vec![None];
    for step in 0..10_000u32 {
        let vertex =
            if step % 3 == 0 { simple.len() } else { 1 + random.below(simple.len() as u64) as usize % simple.len() };
        let parent = random.below(simple.len() as u64) as usize;
        let (child, edge) = (VertexId(vertex as u32), random.uniform());
        if tree.cost(VertexId(parent as u32)) + edge >= tree.cost(child) {
            continue;
        }
        let former = tree.attach(child, VertexId(parent as u32), edge);
        if vertex == simple.len() {
            simple.push(None);
        }
        assert_eq!(former.map(VertexId::index), simple[vertex].map(|(parent, _)| parent));
        simple[vertex] = Some((parent, edge));
        // A vertex without children leaves the tree, and may come back.
        let leaf = VertexId(step % simple.len() as u32);
        if step % 5 == 0 && leaf.0 > 0 && tree.is_leaf(leaf) {
            let is_parent = |&(parent, _): &(usize, f64)| parent == leaf.index();
            assert!(!simple.iter().flatten().any(is_parent));
            let former = simple[leaf.index()].take();
            assert_eq!(tree.remove(leaf).map(VertexId::index), former.map(|(parent, _)| parent));
            assert_eq!(tree.cost(leaf), f64::INFINITY);
        }
        if step % 97 == 0 {
            for at in (0..simple.len()).filter(|&at| at == 0 || simple[at].is_some()) {
                let edges: Vec<f64> =
                    std::iter::successors(simple[at], |&(parent, _)| simple[parent]).map(|(_, edge)| edge).collect();
                let cost = edges.iter().rev().fold(0.0, |sum, edge| sum + edge);
                assert_eq!(tree.cost(VertexId(at as u32)).to_bits(), cost.to_bits());
            }
        }
    }
}
