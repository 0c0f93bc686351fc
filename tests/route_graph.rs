//! Route graphs: every edge verified by other code, detours against exact shortest paths, parts, refusals, and the same bits
//! for a seed.

use crate::common::documents::{disc, judged, parse, rectangle, refuses, result};
use crate::common::{arm_and_wall, car_and_wall, cases, given};
use planarium::collision::DiscValidity;
use planarium::geometry::wrap;
use planarium::optimum::{MetricOptions, optimum};
use planarium::options::Options;
use planarium::path::ResultDocument;
use planarium::problem::Validity;
use planarium::random::{Random, Stream};
use planarium::robot::DiscRobot;
use planarium::route_graph::{RouteEdge, RouteGraph, RouteGraphOptions, route_graph};
use planarium::run::storage::fingerprint;
use planarium::scenario::{Query, Robot, Scenario};
use serde_json::json;
use std::f64::consts::FRAC_PI_2;
use wasm_bindgen_test::wasm_bindgen_test;

const BODY: &str = r#"{"type": "rigid_body", "margin": 0.02, "shape": {"type": "polygon",
    "vertices": [[-0.3, -0.15], [0.5, -0.15], [0.5, 0.15], [-0.3, 0.15]]}}"#;

/// Rooms with doors, and posts: ways around corners.
fn rooms(robot: &str) -> Scenario {
    let obstacles = [
        rectangle([3.9, 0.0], [4.1, 4.0]),
        rectangle([3.9, 5.2], [4.1, 10.0]),
        rectangle([5.5, 4.9], [10.0, 5.1]),
        rectangle([0.0, 6.9], [2.5, 7.1]),
        disc([7.0, 2.5], 0.8),
        disc([2.0, 2.0], 0.4),
        rectangle([6.0, 7.0], [8.0, 8.0]),
    ];
    with_robot([10.0, 10.0], &obstacles, robot)
}

fn disc_of(radius: f64) -> String {
    format!(r#"{{"type": "disc", "radius": {radius:?}}}"#)
}

/// A world with a robot, without queries.
fn with_robot(bounds: [f64; 2], obstacles: &[String], robot: &str) -> Scenario {
    parse(&format!(
        r#"{{"format": "planarium-scenario-1", "name": "floor", "robot": {robot}, "queries": [],
            "world": {{"bounds": {{"min": [0, 0], "max": {bounds:?}}}, "obstacles": [{}]}}}}"#,
        obstacles.join(",")
    ))
}

fn small(samples: u32, seed: u64) -> RouteGraphOptions {
    RouteGraphOptions { samples, seed, ..RouteGraphOptions::default() }
}

fn made(world: &Scenario, options: &RouteGraphOptions) -> RouteGraph {
    route_graph(world, options).unwrap_or_else(|error| panic!("{error}"))
}

/// The neighbours of every node.
fn neighbours(graph: &RouteGraph) -> Vec<Vec<(usize, f64)>> {
    let mut neighbours = vec![Vec::new(); graph.nodes.len()];
    for &RouteEdge { nodes: [a, b], length } in &graph.edges {
        neighbours[a as usize].push((b as usize, length));
        neighbours[b as usize].push((a as usize, length));
    }
    neighbours
}

/// The lengths of the ways between all nodes, by relaxing edges until nothing changes.
fn all_ways(graph: &RouteGraph) -> Vec<Vec<f64>> {
    let count = graph.nodes.len();
    let relaxed = |from: usize| {
        let mut ways = vec![f64::INFINITY; count];
        ways[from] = 0.0;
        loop {
            let before = ways.clone();
            for &RouteEdge { nodes, length } in &graph.edges {
                let [a, b] = nodes.map(|node| node as usize);
                ways[a] = ways[a].min(ways[b] + length);
                ways[b] = ways[b].min(ways[a] + length);
            }
            if ways == before {
                return ways;
            }
        }
    };
    (0..count).map(relaxed).collect()
}

/// A walk that takes every edge in both directions, from the first node of each part.
fn walks(graph: &RouteGraph) -> Vec<Vec<usize>> {
    let neighbours = neighbours(graph);
    let mut taken: Vec<Vec<bool>> = neighbours.iter().map(|all| vec![false; all.len()]).collect();
    let mut known = vec![false; graph.nodes.len()];
    let mut walks = Vec::new();
    for first in 0..graph.nodes.len() {
        if known[first] {
            continue;
        }
        // The stack is a trail of edges out of the first node; each edge is walked forward when it is pushed, back when popped.
        let (mut walk, mut trail) = (vec![first], vec![first]);
        known[first] = true;
        while let Some(&at) = trail.last() {
            if let Some(i) = taken[at].iter().position(|taken| !taken) {
                let next = neighbours[at][i].0;
                taken[at][i] = true;
                let back = neighbours[next].iter().position(|(node, _)| *node == at).expect("edges lead both ways");
                taken[next][back] = true;
                walk.push(next);
                if known[next] {
                    walk.push(at);
                } else {
                    known[next] = true;
                    trail.push(next);
                }
            } else {
                trail.pop();
                walk.extend(trail.last());
            }
        }
        walks.push(walk);
    }
    walks
}

/// The path of a walk; of a body with the turns on the spot between two edges, and a whole turn wherever it comes first.
fn path_of(graph: &RouteGraph, walk: &[usize], turns: bool) -> Vec<Vec<f64>> {
    let place = |node: usize| graph.nodes[node];
    if !turns {
        return walk.iter().map(|&node| place(node).to_vec()).collect();
    }
    let mut known = vec![false; graph.nodes.len()];
    let [x, y] = place(walk[0]);
    let mut path = vec![vec![x, y, 0.0]];
    for step in walk.windows(2) {
        let [[x, y], [to_x, to_y]] = [step[0], step[1]].map(place);
        let from = path[path.len() - 1][2];
        if !known[step[0]] {
            known[step[0]] = true;
            path.extend([1.0, 2.0, 3.0, 4.0].map(|quarters| vec![x, y, from + quarters * FRAC_PI_2]));
        }
        let turn = wrap(libm::atan2(to_y - y, to_x - x) - from);
        path.extend([0.5, 1.0].map(|part| vec![x, y, from + part * turn]));
        path.push(vec![to_x, to_y, from + turn]);
    }
    path
}

/// Verifies every edge, in both directions, by the independent verifier.
#[track_caller]
fn verify_edges(world: &Scenario, graph: &RouteGraph) {
    let [translation, rotation] = match world.robot() {
        Robot::RigidBody(body) => [body.weights.translation, body.weights.rotation],
        _ => [1.0, 0.0],
    };
    for walk in walks(graph).into_iter().filter(|walk| walk.len() > 1) {
        let path = path_of(graph, &walk, rotation > 0.0);
        let length = path.windows(2).map(|step| {
            let [dx, dy] = [0, 1].map(|i| step[1][i] - step[0][i]);
            let turn = if rotation > 0.0 { wrap(step[1][2] - step[0][2]).abs() } else { 0.0 };
            translation * libm::sqrt(dx * dx + dy * dy) + rotation * turn
        });
        let query = Query::new("q", path[0].clone(), path[path.len() - 1].clone());
        let floor = Scenario::new("s", world.world().clone(), world.robot().clone(), [query]).expect("a floor");
        let margin = Some(world.robot().margin()).filter(|margin| *margin > 0.0);
        let result = ResultDocument { margin, ..result("s", &json!(path).to_string(), None, length.sum()) };
        judged(&floor, &result).unwrap_or_else(|why| panic!("{why}"));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_edge_and_every_turn_is_verified() {
    for seed in 0..2 {
        for robot in [disc_of(0.25), disc_of(0.0), BODY.to_owned()] {
            let world = rooms(&robot);
            let graph = made(&world, &small(400, seed));
            verify_edges(&world, &graph);
            assert_eq!((graph.parts, graph.fingerprint), (1, fingerprint(&world)), "{robot}");
            assert!(graph.nodes.len() < 120 && graph.edges.len() < 3 * graph.nodes.len(), "{}", graph.nodes.len());
            assert!(graph.covered > 0.98, "{}", graph.covered);
            for RouteEdge { nodes, length } in &graph.edges {
                let [a, b] = nodes.map(|node| graph.nodes[node as usize]);
                let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
                assert!(nodes[0] < nodes[1] && (length - libm::sqrt(dx * dx + dy * dy)).abs() < 1e-12);
            }
        }
    }
}

/// The bound of the documentation with the exact shortest path in place of the roadmap's.
#[wasm_bindgen_test(unsupported = test)]
fn ways_over_the_graph_are_no_large_detours_from_exact_shortest_paths() {
    let radius = 0.25;
    let world = rooms(&disc_of(radius));
    let checker = DiscValidity::new(&DiscRobot::new(radius).expect("a disc"), world.world());
    let sees = |a: [f64; 2], b: [f64; 2]| checker.is_motion_free(&a, &b);
    for (detour, samples) in [(1.5, 1000), (1.15, 1000)] {
        let graph = made(&world, &RouteGraphOptions { detour, ..small(samples, 1) });
        assert!(graph.largest_detour <= detour * (1.0 + 1e-9), "{}", graph.largest_detour);
        let (ways, leg) = (all_ways(&graph), graph.options.longest_leg.expect("a leg"));
        let legs = |from: [f64; 2]| -> Vec<(usize, f64)> {
            let distance = |to: [f64; 2]| libm::hypot(to[0] - from[0], to[1] - from[1]);
            let near = graph.nodes.iter().enumerate().filter(|(_, node)| distance(**node) <= leg);
            near.filter(|(_, node)| sees(from, **node)).map(|(i, node)| (i, distance(*node))).collect()
        };
        let mut random = Random::new(7, Stream::Tasks);
        let mut place = || loop {
            let place = [(); 2].map(|()| 10.0 * random.uniform());
            if sees(place, place) {
                break place;
            }
        };
        let (mut joined, mut longest, mut mean) = (0, 0.0f64, 0.0);
        let pairs = cases(4000);
        for _ in 0..pairs {
            let [p, q] = [place(), place()];
            let [from, to] = [legs(p), legs(q)];
            let query = Query::new("q", p, q);
            let floor = Scenario::new("s", world.world().clone(), world.robot().clone(), [query]).expect("a floor");
            let shortest = optimum(&floor, None, MetricOptions::default()).expect("free ends").length.expect("a path");
            let mut best = f64::INFINITY;
            for (&(a, leg), &(b, other)) in from.iter().flat_map(|a| to.iter().map(move |b| (a, b))) {
                let (way, legs) = (ways[a][b], leg + other);
                longest = longest.max(way / (shortest + legs));
                best = best.min(way + legs);
            }
            if best < f64::INFINITY {
                joined += 1;
                mean += best / shortest;
            }
        }
        assert!(f64::from(joined) >= 0.97 * pairs as f64, "{joined} of {pairs} pairs are joined to the graph");
        mean /= f64::from(joined);
        // The roadmap is a little longer than the shortest path; legs lengthen the way most where places are near each other.
        assert!(longest <= 1.02 * detour && mean < 1.3, "{longest} and {mean} for {detour}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn rooms_without_doors_are_parts() {
    let walls = [rectangle([3.0, 0.0], [3.2, 4.0]), rectangle([6.0, 0.0], [6.2, 4.0])];
    let world = with_robot([9.0, 4.0], &walls, &disc_of(0.2));
    let graph = made(&world, &small(300, 0));
    assert_eq!(graph.parts, 3);
    let room = |node: u32| (graph.nodes[node as usize][0] / 3.1) as u32;
    assert!(graph.edges.iter().all(|edge| room(edge.nodes[0]) == room(edge.nodes[1])));
    assert!((0..3).all(|one| (0..graph.nodes.len() as u32).any(|node| room(node) == one)));
    verify_edges(&world, &graph);

    // A world that the disc has no place in, and one with a single place or so.
    let full = with_robot([1.0, 1.0], &[disc([0.5, 0.5], 0.4)], &disc_of(0.3));
    let empty = made(&full, &small(10, 0));
    assert_eq!((empty.nodes.len(), empty.edges.len(), empty.parts, empty.covered), (0, 0, 0, 0.0));
    let one = made(
        &with_robot([1.0, 1.0], &[], &disc_of(0.2)),
        &RouteGraphOptions { longest_leg: Some(2.0), ..small(20, 0) },
    );
    assert_eq!((one.nodes.len(), one.edges.len(), one.parts, one.covered), (1, 0, 1, 1.0));
}

/// A footprint that is driven forward passes where the disc that it turns in does not.
#[wasm_bindgen_test(unsupported = test)]
fn a_footprint_passes_a_door_that_it_cannot_turn_in() {
    let door = [rectangle([4.0, 0.0], [4.2, 1.75]), rectangle([4.0, 2.25], [4.2, 4.0])];
    let body = BODY.replace(r#""margin": 0.02, "#, "");
    let graph = made(&with_robot([8.0, 4.0], &door, &body), &small(600, 0));
    assert_eq!(graph.parts, 1, "a door of 0.5 m for a body 0.3 m wide");
    verify_edges(&with_robot([8.0, 4.0], &door, &body), &graph);
    let narrow = [rectangle([4.0, 0.0], [4.2, 1.86]), rectangle([4.0, 2.14], [4.2, 4.0])];
    assert_eq!(made(&with_robot([8.0, 4.0], &narrow, &body), &small(600, 0)).parts, 2, "a door of 0.28 m");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_seed_decides_every_bit() {
    let world = rooms(&disc_of(0.25));
    let [first, again, other] = [3, 3, 4].map(|seed| made(&world, &small(200, seed)));
    assert_eq!(first, again);
    assert_ne!(first.nodes, other.nodes);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_has_no_route_graph_is_refused() {
    for world in [arm_and_wall(0.1), car_and_wall(0.1)] {
        refuses(route_graph(&world, &small(10, 0)), "unsupported", "/robot/type");
    }
    let world = rooms(&disc_of(0.25));
    let wrong = [
        (RouteGraphOptions { detour: 0.999, ..small(10, 0) }, "out-of-range", "/detour"),
        (RouteGraphOptions { detour: f64::NAN, ..small(10, 0) }, "not-finite", "/detour"),
        (small(0, 0), "out-of-range", "/samples"),
        (small(10, 1 << 53), "out-of-range", "/seed"),
        (RouteGraphOptions { longest_leg: Some(0.0), ..small(10, 0) }, "out-of-range", "/longest_leg"),
        (RouteGraphOptions { longest_leg: Some(1e-6), ..small(2500, 0) }, "too-large", ""),
    ];
    for (options, code, pointer) in wrong {
        refuses(route_graph(&world, &options), code, pointer);
    }
    refuses(RouteGraphOptions::read(&given("detours=2")), "unknown-parameter", "/detours");
    let read = RouteGraphOptions::read(&given("samples=50 detour=2 seed=9")).expect("options");
    assert_eq!(read, RouteGraphOptions { samples: 50, detour: 2.0, longest_leg: None, seed: 9 });
}
