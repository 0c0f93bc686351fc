//! Searches on random graphs, against brute force: every search is a walker that expands one vertex a step.

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

    /// The cheapest costs from vertex 0 to all others, by petgraph; edges are followed both ways if they are undirected.
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

/// Walks to the end: the path, empty where there is none, and how many vertices were expanded.
fn walk(
    walker: &mut dyn Walker,
    world: &World,
    cost: &dyn Fn(VertexId, VertexId) -> f64,
    heuristic: &dyn Fn(VertexId) -> f64,
) -> (Vec<VertexId>, usize) {
    let adjacency = Adjacency::new(world.points.len(), &world.edges);
    let view = View { adjacency: &adjacency, cost, heuristic };
    let mut expanded = 0;
    loop {
        match walker.step(&view) {
            Expansion::Vertex(_) => expanded += 1,
            Expansion::Goal => return (walker.path(), expanded),
            Expansion::Nothing => return (Vec::new(), expanded),
        }
    }
}

/// The cost of a path; every step must be an edge.
fn cost_of(world: &World, path: &[VertexId], cost: impl Fn(VertexId, VertexId) -> f64) -> f64 {
    let pairs = path.windows(2).map(|pair| {
        let is_edge = world.edges.iter().any(|&[a, b]| [a, b] == [pair[0], pair[1]] || [b, a] == [pair[0], pair[1]]);
        assert!(is_edge, "a path goes along edges");
        cost(pair[0], pair[1])
    });
    pairs.sum()
}

const START: VertexId = VertexId(0);

#[wasm_bindgen_test(unsupported = test)]
fn every_search_finds_the_best_path_by_its_own_measure_and_only_where_there_is_one() {
    let (mut reachable, mut fewer) = (0, [0, 0]);
    for seed in 0..2000 {
        let world = World::new(seed);
        let n = world.points.len();
        let goal = VertexId(n as u32 - 1);
        let metric = |a, b| world.length(a, b);
        let hops = |_: VertexId, _: VertexId| 1.0;
        let (shortest, fewest) =
            (world.costs::<Undirected>(metric)[goal.index()], world.costs::<Undirected>(hops)[goal.index()]);

        let none = |_: VertexId| 0.0;
        let to_goal = |v| world.length(v, goal);
        // Admissible but inconsistent: full strength at some vertices, nothing at others.
        let patchy = |v: VertexId| if v.0.is_multiple_of(3) { world.length(v, goal) } else { 0.0 };
        let goals = goal..VertexId(n as u32);
        let (dijkstra, plain) = walk(&mut BestFirst::new(n, START, goals.clone()), &world, &metric, &none);
        let (a_star, guided) = walk(&mut BestFirst::new(n, START, goals.clone()), &world, &metric, &to_goal);
        let (reopening, _) = walk(&mut BestFirst::new(n, START, goals.clone()), &world, &metric, &patchy);
        let (breadth, one_sided) = walk(&mut BreadthFirst::new(n, START, goals.clone()), &world, &metric, &none);
        let (both, two_sided) = walk(&mut Bidirectional::new(n, START, goals.clone()), &world, &metric, &none);
        let (hopping, _) = walk(&mut BestFirst::new(n, START, goals.clone()), &world, &hops, &none);
        let paths = [&dijkstra, &a_star, &reopening, &breadth, &both, &hopping];
        if shortest.is_infinite() {
            assert!(paths.iter().all(|path| path.is_empty()), "seed {seed}: no search finds what is not there");
            continue;
        }
        reachable += 1;
        for path in paths {
            assert_eq!((path[0], path[path.len() - 1]), (START, goal));
        }
        for path in [&dijkstra, &a_star, &reopening] {
            let cost = cost_of(&world, path, metric);
            assert!((cost - shortest).abs() <= 1e-12 * shortest.max(1.0), "seed {seed}: {cost} is not {shortest}");
        }
        for path in [&breadth, &both, &hopping] {
            assert_eq!(cost_of(&world, path, hops), fewest, "seed {seed}");
        }
        assert!(guided <= plain, "a consistent heuristic never expands more");
        fewer[0] += usize::from(guided < plain);
        fewer[1] += usize::from(two_sided < one_sided);
    }
    assert!(reachable > 800, "{reachable} of 2000 graphs join their ends");
    assert!(fewer[0] > reachable / 4 && fewer[1] > reachable / 4, "{fewer:?}: guidance and two sides pay");
}

#[wasm_bindgen_test(unsupported = test)]
fn of_several_goals_the_best_is_found() {
    let mut reachable = 0;
    for seed in 0..1000 {
        let world = World::new(seed);
        let n = world.points.len();
        let first = 1 + seed as usize % (n - 1);
        let goals = VertexId(first as u32)..VertexId(n as u32);
        let metric = |a, b| world.length(a, b);
        let hops = |_: VertexId, _: VertexId| 1.0;
        let best = |costs: Vec<f64>| costs[first..].iter().copied().fold(f64::INFINITY, f64::min);
        let (shortest, fewest) = (best(world.costs::<Undirected>(metric)), best(world.costs::<Undirected>(hops)));
        let nearest = |v| (first..n).map(|goal| world.length(v, VertexId(goal as u32))).fold(f64::INFINITY, f64::min);
        let none = |_: VertexId| 0.0;
        let (dijkstra, _) = walk(&mut BestFirst::new(n, START, goals.clone()), &world, &metric, &none);
        let (a_star, _) = walk(&mut BestFirst::new(n, START, goals.clone()), &world, &metric, &nearest);
        let (breadth, _) = walk(&mut BreadthFirst::new(n, START, goals.clone()), &world, &metric, &none);
        let (both, _) = walk(&mut Bidirectional::new(n, START, goals.clone()), &world, &metric, &none);
        for path in [&dijkstra, &a_star, &breadth, &both] {
            assert_eq!(path.is_empty(), shortest.is_infinite(), "seed {seed}");
        }
        if shortest.is_infinite() {
            continue;
        }
        reachable += 1;
        for path in [&dijkstra, &a_star, &breadth, &both] {
            assert!(path[0] == START && goals.contains(&path[path.len() - 1]), "seed {seed}: {path:?}");
        }
        for path in [&dijkstra, &a_star] {
            assert!((cost_of(&world, path, metric) - shortest).abs() <= 1e-12, "seed {seed}");
        }
        for path in [&breadth, &both] {
            assert_eq!(cost_of(&world, path, hops), fewest, "seed {seed}");
        }
    }
    assert!(reachable > 400, "{reachable} of 1000 graphs lead to a goal");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_search_from_a_vertex_to_itself_is_over_at_once() {
    let world = World { points: vec![[0.0; 2]; 2], edges: vec![[VertexId(0), VertexId(1)]] };
    let cost = |_: VertexId, _: VertexId| 1.0;
    let none = |_: VertexId| 0.0;
    let walkers: [Box<dyn Walker>; 3] = [
        Box::new(BestFirst::new(2, START, START..VertexId(1))),
        Box::new(BreadthFirst::new(2, START, START..VertexId(1))),
        Box::new(Bidirectional::new(2, START, START..VertexId(1))),
    ];
    for mut walker in walkers {
        assert_eq!(walk(walker.as_mut(), &world, &cost, &none), (vec![START], 0));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn sets_that_are_joined_are_one() {
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

#[wasm_bindgen_test(unsupported = test)]
fn searches_follow_edges_that_lead_one_way() {
    let (mut reachable, mut only_back) = (0, 0);
    for seed in 0..2000 {
        let world = World::new(seed);
        let n = world.points.len();
        let goal = VertexId(n as u32 - 1);
        // Uphill is dearer, so that a cost has a direction too.
        let metric = |a: VertexId, b: VertexId| world.length(a, b) * if a < b { 1.5 } else { 1.0 };
        let hops = |_: VertexId, _: VertexId| 1.0;
        let shortest = world.costs::<Directed>(metric)[goal.index()];
        let fewest = world.costs::<Directed>(hops)[goal.index()];
        let adjacency =
            Adjacency::directed(n, &world.edges[..world.edges.len() / 2], &world.edges[world.edges.len() / 2..]);
        let none = |_: VertexId| 0.0;
        let to_goal = |v| world.length(v, goal);
        let goals = goal..VertexId(n as u32);
        let walkers: [Box<dyn Walker>; 4] = [
            Box::new(BestFirst::new(n, START, goals.clone())),
            Box::new(BestFirst::new(n, START, goals.clone())),
            Box::new(BreadthFirst::new(n, START, goals.clone())),
            Box::new(Bidirectional::new(n, START, goals.clone())),
        ];
        reachable += usize::from(shortest.is_finite());
        only_back += usize::from(shortest.is_infinite() && world.costs::<Undirected>(hops)[goal.index()].is_finite());
        for (i, mut walker) in walkers.into_iter().enumerate() {
            let (is_guided, by_metric) = (i == 1, i < 2);
            let heuristic: &dyn Fn(VertexId) -> f64 = if is_guided { &to_goal } else { &none };
            let view = View { adjacency: &adjacency, cost: &metric, heuristic };
            let path = loop {
                match walker.step(&view) {
                    Expansion::Vertex(_) => {}
                    Expansion::Goal => break walker.path(),
                    Expansion::Nothing => break Vec::new(),
                }
            };
            assert_eq!(path.is_empty(), shortest.is_infinite(), "seed {seed}");
            assert!(
                path.windows(2).all(|pair| world.edges.contains(&[pair[0], pair[1]])),
                "against an edge, seed {seed}"
            );
            if !path.is_empty() {
                assert_eq!((path[0], path[path.len() - 1]), (START, goal));
                let costs: f64 = path.windows(2).map(|pair| metric(pair[0], pair[1])).sum();
                assert!(!by_metric || (costs - shortest).abs() <= 1e-12 * shortest.max(1.0), "seed {seed}");
                assert!(by_metric || (path.len() - 1) as f64 == fewest, "seed {seed}");
            }
        }
    }
    assert!(reachable > 300 && only_back > 100, "{reachable} can be reached, {only_back} only against an edge");
}
