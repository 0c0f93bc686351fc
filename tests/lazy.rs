//! Lazy roadmaps: the paths of PRM with few proofs, the search that goes on where edges come and go, and roadmaps among obstacles that
//! have moved.

use crate::common::documents::{BODY, refuses};
use crate::common::graphs::{rows, tried};
use crate::common::requests;
use crate::common::{arm_of, assert_valid, begin_with, disc_and_wall, finish, parse, seeds, worlds};
use planarium::PlanningWorld;
use planarium::graph::VertexId;
use planarium::graph::search::{Edge, EdgeState, Expansion, Lifelong};
use planarium::random::{Random, Stream};
use planarium::run::Status;
use planarium::run::inspect::Inspector;
use planarium::scenario::Scenario;
use planarium::scenario::generate::generate;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// The costs from vertex 0 along the edges that are not refused, by relaxing all edges again and again.
fn costs(vertices: usize, edges: &[Edge], is_directed: bool) -> Vec<f64> {
    let mut costs = vec![f64::INFINITY; vertices];
    costs[0] = 0.0;
    for _ in 0..vertices {
        for Edge { ends: [a, b], cost, .. } in edges.iter().filter(|edge| edge.state != EdgeState::Refused) {
            costs[b.index()] = costs[b.index()].min(costs[a.index()] + cost);
            if !is_directed {
                costs[a.index()] = costs[a.index()].min(costs[b.index()] + cost);
            }
        }
    }
    costs
}

/// Searches to the end; the cost of the path, which is that of its edges.
fn best(search: &mut Lifelong) -> f64 {
    for _ in 0..100_000 {
        match search.step() {
            Expansion::Vertex(_) => {}
            Expansion::Nothing => return f64::INFINITY,
            Expansion::Goal => return search.cost(),
        }
    }
    panic!("the search does not end");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_search_that_goes_on_finds_what_a_search_from_the_beginning_does() {
    for seed in 0..seeds(200) {
        let mut random = Random::new(seed, Stream::Scenario);
        let mut below = |n: usize| random.below(n as u64) as usize;
        let (n, is_directed) = (2 + below(30), seed % 2 == 0);
        // Points on a coarse grid: many paths are equally long, and some edges have no length.
        let points: Vec<[f64; 2]> = (0..n).map(|_| [0, 1].map(|_| below(6) as f64)).collect();
        let distance = |a: usize, b: usize| (points[a][0] - points[b][0]).hypot(points[a][1] - points[b][1]);
        let goals = VertexId(1)..VertexId(2 + below(2).min(n - 2) as u32);
        let nearest =
            |v: usize| (goals.start.index()..goals.end.index()).map(|goal| distance(v, goal)).fold(9.0, f64::min);
        let mut search = Lifelong::new(is_directed, VertexId(0), goals.clone());
        (0..n).for_each(|vertex| search.add_vertex(nearest(vertex)));
        for _ in 0..4 * n {
            let [a, b] = [below(n), below(n)];
            if a != b {
                let ends = [a, b].map(|end| VertexId(end as u32));
                search.add_edge(Edge { ends, cost: distance(a, b), state: EdgeState::Assumed });
            }
            let cost = best(&mut search);
            let all = costs(n, search.edges(), is_directed);
            let expected = (goals.start.index()..goals.end.index()).map(|goal| all[goal]).fold(f64::INFINITY, f64::min);
            assert!(cost == expected || (cost - expected).abs() < 1e-9, "seed {seed}: {cost}, not {expected}");
            if cost < f64::INFINITY {
                let path = search.path();
                assert!(path[0] == VertexId(0) && goals.contains(&path[path.len() - 1]));
                let joins = |edge: &&Edge, pair: &[VertexId]| {
                    let is_back = !is_directed && edge.ends == [pair[1], pair[0]];
                    edge.state != EdgeState::Refused && (edge.ends == pair || is_back)
                };
                let least = |pair: &[VertexId]| {
                    let own = search.edges().iter().filter(|edge| joins(edge, pair));
                    own.map(|edge| edge.cost).fold(f64::INFINITY, f64::min)
                };
                let length: f64 = path.windows(2).map(least).sum();
                assert!((length - cost).abs() < 1e-9);
                if let Some(edge) = search.first_assumed() {
                    // Refused, or proven to cost as much as was assumed, or more.
                    let surcharge = [None, Some(0.0), Some(0.5 * below(4) as f64)][below(3)];
                    search.settle(edge, surcharge);
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn lazy_prm_finds_the_path_of_prm_and_proves_few_edges() {
    let forests =
        (0..4).map(|seed| generate("forest", &json!({ "links": 2 + seed % 3, "seed": seed })).expect("a forest"));
    let mut solved = 0;
    for (world, is_forest) in worlds().into_iter().map(|world| (world, false)).chain(forests.map(|world| (world, true)))
    {
        for seed in 0..3 {
            let [eager, lazy] = ["prm", "lazy-prm"].map(|id| finish(begin_with(&world, id, seed, "samples=400 k=10")));
            assert_eq!(lazy.vertex_rows(0), eager.vertex_rows(0));
            assert_eq!((lazy.status(), lazy.length().to_bits()), (eager.status(), eager.length().to_bits()));
            let (few, all) = (lazy.stats(), eager.stats());
            assert_eq!(few.motion_checks + few.unchecked_edges, all.motion_checks, "the same candidates");
            assert_eq!((all.unchecked_edges, tried(&*lazy).len() as u64), (0, few.motion_checks));
            if is_forest {
                assert!(5 * few.motion_checks <= all.motion_checks, "{} of {}", few.motion_checks, all.motion_checks);
            }
            solved += u32::from(lazy.status() == Status::Solved);
        }
    }
    assert!(solved > 15, "{solved}");
}

/// The scenario with one of its obstacles moved, removed or added at random.
fn changed(world: &Scenario, random: &mut Random) -> Scenario {
    let mut document = json!(world);
    let mut place = || json!([0, 1].map(|_| 3.5 * random.uniform() - 1.5));
    let disc = json!({ "type": "disc", "center": place(), "radius": 0.2 });
    let obstacles = document["world"]["obstacles"].as_array_mut().expect("a list");
    let at = random.below(obstacles.len() as u64 + 1) as usize;
    match random.below(3) {
        0 => obstacles.insert(at, disc),
        1 if at < obstacles.len() => drop(obstacles.remove(at)),
        _ if at < obstacles.len() => obstacles[at] = disc,
        _ => {}
    }
    Scenario::parse(&document.to_string()).unwrap_or_else(|_| world.clone())
}

/// The length of the shortest path among these motions as far as they are free in a world, every one tried.
fn shortest(world: &Scenario, vertices: &[Vec<f64>], motions: &[[usize; 2]]) -> f64 {
    let inspector = Inspector::new(world);
    let is_free =
        |a: usize, b: usize| inspector.first_hit(&vertices[a], &vertices[b]).expect("within the limits").is_none();
    let distance = |a: usize, b: usize| inspector.distance(&vertices[a], &vertices[b]).expect("within the limits");
    let edge = |&[a, b]: &[usize; 2]| Edge {
        ends: [a, b].map(|end| VertexId(end as u32)),
        cost: distance(a, b),
        state: if is_free(a, b) { EdgeState::Proven } else { EdgeState::Refused },
    };
    costs(vertices.len(), &motions.iter().map(edge).collect::<Vec<_>>(), false)[1]
}

#[wasm_bindgen_test(unsupported = test)]
fn a_reopened_roadmap_finds_the_best_path_that_is_free_now() {
    let [mut solved, mut none, mut left_out] = [0; 3];
    let scenes = [arm_of(2, false, 0.0), arm_of(3, true, 0.05), parse(BODY)];
    for (world, planner) in
        scenes.iter().flat_map(|world| ["prm", "prm-star", "lazy-prm"].map(|planner| (world, planner)))
    {
        for seed in 0..seeds(40) / 10 {
            let mut random = Random::new(seed, Stream::Scenario);
            let settings = if planner == "prm-star" { "samples=100" } else { "samples=100 k=8" };
            let mut run = finish(begin_with(world, planner, seed, settings));
            let motions = tried(&*finish(begin_with(world, &planner.replace("lazy-", ""), seed, settings)));
            let mut world = world.clone();
            for _ in 0..6 {
                world = changed(&world, &mut random);
                let reopened = match run.reopen(&PlanningWorld::new(world.clone())) {
                    Ok(reopened) => finish(reopened),
                    Err(error) => {
                        assert!(error.code().as_str().ends_with("-in-collision"), "{error}");
                        break;
                    }
                };
                assert_eq!(rows(&*reopened), rows(&*run), "the vertices stay");
                // Those that are in collision now are not saved.
                let saved = reopened.roadmap().expect("a roadmap");
                requests::resume(&world, &Default::default(), &saved).expect("it is free, and fits");
                left_out += reopened.vertex_count() - saved.vertex_count();
                let expected = shortest(&world, &rows(&*run), &motions);
                if expected < f64::INFINITY {
                    assert_valid(&world, &*reopened);
                    assert!(
                        (reopened.length() - expected).abs() < 1e-9,
                        "{planner} {seed}: {} {expected}",
                        reopened.length()
                    );
                    solved += 1;
                } else {
                    assert_eq!(reopened.status(), Status::Exhausted, "{planner} {seed}");
                    none += 1;
                }
                run = reopened;
            }
        }
    }
    assert!(solved > 20 && none > 5 && left_out > 5, "{solved}, {none} and {left_out}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_query_of_a_lazy_roadmap_proves_what_it_needs() {
    for world in [arm_of(3, false, 0.0), disc_and_wall(0.2, 0.3)] {
        let [mut eager, mut lazy] = ["prm", "lazy-prm"].map(|id| finish(begin_with(&world, id, 3, "samples=200 k=8")));
        let ends: Vec<Vec<f64>> = Inspector::new(&world)
            .samples(2, 7, true)
            .expect("much is free")
            .chunks(lazy.dimension())
            .map(<[f64]>::to_vec)
            .collect();
        let before = (lazy.fingerprint(), lazy.stats().motion_checks);
        for keep in [false, true] {
            let [expected, found] =
                [&mut eager, &mut lazy].map(|run| run.query(&ends[0], &ends[1], keep).expect("both are free"));
            assert_eq!((found.status, found.length.to_bits()), (expected.status, expected.length.to_bits()));
            assert!(found.stats.motion_checks > before.1, "what it proves is counted");
            assert_eq!(lazy.fingerprint() == before.0, !keep, "the roadmap changes if they are kept");
        }
        assert_eq!(&rows(&*lazy)[lazy.vertex_count() - 2..], ends);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_lazy_roadmap_can_be_saved_and_its_candidates_come_back() {
    let world = arm_of(2, false, 0.0);
    let lazy = finish(begin_with(&world, "lazy-prm", 3, "samples=200 k=8"));
    let saved = lazy.roadmap().expect("a roadmap");
    let resumed = requests::resume(&world, &Default::default(), &saved).expect("it fits");
    let resumed = finish(resumed);
    assert_eq!((resumed.path(), resumed.status()), (lazy.path(), Status::Solved));
    // What was refused is not saved.
    assert!(resumed.stats().motion_checks < lazy.stats().motion_checks && resumed.stats().unchecked_edges > 500);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_roadmap_is_reopened_with_the_same_robot_and_bounds_once_it_is_built() {
    let world = arm_of(2, false, 0.0);
    let same = PlanningWorld::new(world.clone());
    let run = finish(begin_with(&world, "lazy-prm", 1, "samples=100"));
    let reopened = finish(run.reopen(&same).expect("the same world"));
    assert_eq!((reopened.path(), reopened.stats().motion_checks), (run.path(), 0), "nothing is proven again");
    refuses(run.reopen(&PlanningWorld::new(arm_of(3, false, 0.0))), "other-scenario", "/robot");
    let mut document = json!(world);
    document["world"]["bounds"] = json!({ "min": [-3, -3], "max": [3, 3] });
    refuses(run.reopen(&PlanningWorld::new(parse(&document.to_string()))), "other-scenario", "/world/bounds");
    refuses(begin_with(&world, "lazy-prm", 1, "").reopen(&same), "unsupported", "");
    refuses(finish(begin_with(&world, "rrt", 1, "")).reopen(&same), "unsupported", "");
    // Another start: the former one is no vertex any more.
    let mut document = json!(world);
    document["queries"][0]["start"] = json!([0.3, 0.2]);
    let moved = parse(&document.to_string());
    let other = finish(run.reopen(&PlanningWorld::new(moved.clone())).expect("obstacles are the same"));
    assert_eq!((other.vertex_count(), &rows(&*other)[0]), (run.vertex_count(), &vec![0.3, 0.2]));
    assert_valid(&moved, &*other);
}
