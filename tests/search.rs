//! Searches on random graphs, against brute force: every search is a walker that expands one vertex per step.

use petgraph::algo::bellman_ford;
use petgraph::{Directed, EdgeType, Graph, Undirected};
use planarium::graph::search::{BestFirst, Bidirectional, BreadthFirst, Expansion, View, Walker};
use planarium::graph::{Adjacency, UnionFind, VertexId};
use planarium::random::{Random, Stream};
use wasm_bindgen_test::wasm_bindgen_test;

/// A random geometric graph: points in the unit square, edges between random pairs that are not too far apart.
struct World {
    points: Vec<[f64; 2]>,
    edges: Vec<[VertexId; 2]>,
}

impl World {
    fn new(seed: u64) -> Self {
        let mut random = Random::new(seed, Stream::Scenario);
        let n = 2 + random.below(60);
        let points: Vec<[f64; 2]> = (0..n).map(|_| [random.uniform(), random.uniform()]).collect();
        let mut edges = Vec::new();
        for _ in 0..random.below(4 * n) {
            let (a, b) = (random.below(n) as u32, random.below(n) as u32);
            if a != b && distance(points[a as usize], points[b as usize]) < 0.5 {
                edges.push([VertexId(a), VertexId(b)]);
            }
        }
        Self { points, edges }
    }

    fn length(&self, a: VertexId, b: VertexId) -> f64 {
        distance(self.points[a.index()], self.points[b.index()])
    }

    /// The cheapest costs from vertex 0 to all others, by petgraph; undirected edges are followed in either direction.
    fn costs<D: EdgeType>(&self, cost: impl Fn(VertexId, VertexId) -> f64) -> Vec<f64> {
        let mut graph = Graph::<(), f64, D>::default();
        for _ in &self.points {
            graph.add_node(());
        }
        graph.extend_with_edges(self.edges.iter().map(|&[a, b]| (a.0, b.0, cost(a, b))));
        bellman_ford(&graph, 0.into()).expect("no cost is negative").distances
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()
}

/// Walks to the end: the path, empty if there is none, and how many vertices were expanded.
fn walk(mut walker: impl Walker, view: &View) -> (Vec<VertexId>, usize) {
    let mut expanded = 0;
    loop {
        match walker.step(view) {
            Expansion::Vertex(_) => expanded += 1,
            Expansion::Goal => return (walker.path(), expanded),
            Expansion::Nothing => return (Vec::new(), expanded),
        }
    }
}

const START: VertexId = VertexId(0);

/// What the searches of a law meet: pairs of vertices with a path, and those with one against an edge only; how often A* expands
/// fewer vertices than Dijkstra, and bidirectional search than one from the start.
#[derive(Debug, Default)]
struct Met {
    reachable: usize,
    only_back: usize,
    fewer: [usize; 2],
}

/// Every search finds the best path by its own measure, and only if there is one: to one goal or several, along edges of both
/// directions or one.
fn best_paths(seeds: u64, has_more_goals: bool, is_directed: bool) -> Met {
    let mut met = Met::default();
    for seed in 0..seeds {
        let world = World::new(seed);
        let n = world.points.len();
        let first = if has_more_goals { 1 + seed as usize % (n - 1) } else { n - 1 };
        let goals = VertexId(first as u32)..VertexId(n as u32);
        // Where edges have a direction, uphill is dearer, so that a cost has a direction too.
        let metric = |a: VertexId, b: VertexId| world.length(a, b) * if is_directed && a < b { 1.5 } else { 1.0 };
        let hops = |_: VertexId, _: VertexId| 1.0;
        let best = |costs: Vec<f64>| costs[first..].iter().copied().fold(f64::INFINITY, f64::min);
        let undirected = best(world.costs::<Undirected>(hops));
        let (shortest, fewest) = match is_directed {
            true => (best(world.costs::<Directed>(metric)), best(world.costs::<Directed>(hops))),
            false => (best(world.costs::<Undirected>(metric)), undirected),
        };
        let (some, more) = world.edges.split_at(world.edges.len() / 2);
        let adjacency = Adjacency::new(n, some, more, is_directed);
        let none = |_: VertexId| 0.0;
        let to_goal = |v| (first..n).map(|goal| world.length(v, VertexId(goal as u32))).fold(f64::INFINITY, f64::min);
        // Admissible but inconsistent: full strength at some vertices, nothing at others.
        let patchy = |v: VertexId| if v.0.is_multiple_of(3) { to_goal(v) } else { 0.0 };
        let by_metric = View { adjacency: &adjacency, cost: &metric, heuristic: &none };
        let best_first = || BestFirst::new(n, START, goals.clone());
        // The first three by the metric, the others by hops.
        let found = [
            walk(best_first(), &by_metric),
            walk(best_first(), &View { heuristic: &to_goal, ..by_metric }),
            walk(best_first(), &View { heuristic: &patchy, ..by_metric }),
            walk(BreadthFirst::new(n, START, goals.clone()), &by_metric),
            walk(Bidirectional::new(n, START, goals.clone()), &by_metric),
            walk(best_first(), &View { cost: &hops, ..by_metric }),
        ];
        met.reachable += usize::from(shortest.is_finite());
        met.only_back += usize::from(shortest.is_infinite() && undirected.is_finite());
        for (i, (path, _)) in found.iter().enumerate() {
            assert_eq!(path.is_empty(), shortest.is_infinite(), "seed {seed}: no search finds what is not there");
            let (Some(&start), Some(goal)) = (path.first(), path.last()) else { continue };
            assert!(start == START && goals.contains(goal), "seed {seed}: {path:?}");
            let mut pairs = path.windows(2).map(|pair| [pair[0], pair[1]]);
            let is_edge =
                |[a, b]: [VertexId; 2]| world.edges.contains(&[a, b]) || !is_directed && world.edges.contains(&[b, a]);
            assert!(pairs.clone().all(is_edge), "a path goes along edges, seed {seed}");
            if i < 3 {
                let cost: f64 = pairs.map(|[a, b]| metric(a, b)).sum();
                assert!((cost - shortest).abs() <= 1e-12 * shortest.max(1.0), "seed {seed}: {cost} is not {shortest}");
            } else {
                assert_eq!(pairs.by_ref().count() as f64, fewest, "seed {seed}");
            }
        }
        if shortest.is_finite() {
            let [plain, guided, _, one_sided, two_sided, _] = found.map(|(_, expanded)| expanded);
            assert!(guided <= plain || has_more_goals || is_directed, "a consistent heuristic never expands more");
            met.fewer[0] += usize::from(guided < plain);
            met.fewer[1] += usize::from(two_sided < one_sided);
        }
    }
    met
}

#[wasm_bindgen_test(unsupported = test)]
fn every_search_finds_the_best_path_by_its_own_measure_and_only_where_there_is_one() {
    let met = best_paths(2000, false, false);
    assert!(met.reachable > 800, "{met:?}");
    assert!(met.fewer.iter().all(|&fewer| fewer > met.reachable / 4), "{met:?}: guidance and two sides pay");
    let of_several_goals = best_paths(1000, true, false);
    assert!(of_several_goals.reachable > 400, "{of_several_goals:?}");
    let directed = best_paths(2000, false, true);
    assert!(directed.reachable > 300 && directed.only_back > 100, "{directed:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_search_from_a_vertex_to_itself_is_over_at_once() {
    let adjacency = Adjacency::new(2, &[[VertexId(0), VertexId(1)]], &[], false);
    let view = View { adjacency: &adjacency, cost: &|_, _| 1.0, heuristic: &|_| 0.0 };
    let goals = START..VertexId(1);
    assert_eq!(walk(BestFirst::new(2, START, goals.clone()), &view), (vec![START], 0));
    assert_eq!(walk(BreadthFirst::new(2, START, goals.clone()), &view), (vec![START], 0));
    assert_eq!(walk(Bidirectional::new(2, START, goals), &view), (vec![START], 0));
}

#[wasm_bindgen_test(unsupported = test)]
fn connected_sets_are_one() {
    for seed in 0..50 {
        let world = World::new(seed);
        let mut sets = UnionFind::default();
        world.points.iter().for_each(|_| sets.add());
        for &[a, b] in &world.edges {
            let were_two = sets.find(a.index()) != sets.find(b.index());
            assert_eq!(sets.join(a.index(), b.index()), were_two);
        }
        let costs = world.costs::<Undirected>(|_, _| 1.0);
        for (i, cost) in costs.iter().enumerate() {
            assert_eq!(sets.find(i) == sets.find(0), cost.is_finite());
        }
    }
}
