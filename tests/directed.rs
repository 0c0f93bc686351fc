//! Planners whose motions are curves and may have a direction: paths in order, roadmaps whose edges are never followed backwards.

use planarium::graph::{Graph, VertexId};
use planarium::path::{Improvement, Wanted, length};
use planarium::planner::{
    Algorithm, AorrtcOptions, BitStarOptions, Extend, FmtStarOptions, GoalBias, Insertion, LazyPrmOptions, Planner,
    PlannerKind, PrmOptions, Rewiring, RrtConnectOptions, RrtOptions, RrtStarOptions, Searching, Status,
};
use planarium::problem::{Contact, Problem, Touched, Validity};
use planarium::space::steering::{Pose, Steering};
use planarium::space::{MotionSpace, ProductSpace, Space};
use wasm_bindgen_test::wasm_bindgen_test;

type State = [f64; 4];
type Car = MotionSpace<4>;

const SEEDS: u64 = if cfg!(target_arch = "wasm32") { 1 } else { 8 };
const SIDE: f64 = 10.0;

/// A point-sized car among discs, checked every few centimetres of its curves, which is enough here.
struct Discs {
    space: Car,
    discs: Vec<[f64; 3]>,
}

impl Discs {
    fn first_contact(&self, a: &State, b: &State) -> Option<f64> {
        let curve = self.space.curve(a, b).expect("cars follow curves");
        let pieces = (curve.length() / 0.05) as u32 + 1;
        let from = Pose { x: a[0], y: a[1], heading: a[2] };
        let is_free = |t: f64| {
            let at = curve.at(from, t * curve.length());
            self.is_free(&[at.x, at.y, at.heading, 0.0])
        };
        (0..=pieces).map(|i| f64::from(i) / f64::from(pieces)).find(|&t| !is_free(t))
    }
}

impl Validity<State> for Discs {
    fn is_motion_free(&self, a: &State, b: &State) -> bool {
        self.first_contact(a, b).is_none()
    }

    fn first_hit(&self, a: &State, b: &State) -> Option<f64> {
        let pieces = (self.space.distance(a, b) / 0.05) as u32 + 1;
        self.first_contact(a, b).map(|t| (t - 1.0 / f64::from(pieces)).max(0.0))
    }

    fn contacts(&self, [x, y, ..]: &State) -> Vec<Contact> {
        let contact = |with| Contact { part: 0, with };
        let is_inside = (0.0..=SIDE).contains(x) && (0.0..=SIDE).contains(y);
        let near = |[cx, cy, r]: &[f64; 3]| (x - cx) * (x - cx) + (y - cy) * (y - cy) <= r * r;
        let touched = self.discs.iter().position(near).map(Touched::Obstacle);
        touched.or((!is_inside).then_some(Touched::Bounds)).into_iter().map(contact).collect()
    }
}

/// Every kind of curves with some seeds, and the problem.
fn problems() -> impl Iterator<Item = (Steering, u64, Problem<Car>)> {
    let both = [Steering::Dubins, Steering::ReedsShepp];
    both.into_iter().flat_map(|steering| (0..SEEDS).map(move |seed| (steering, seed, problem(steering))))
}

/// From one corner to the other and about face, among a few discs.
fn problem(steering: Steering) -> Problem<Car> {
    let torus = ProductSpace::of_placements([0.0; 2], [SIDE; 2], 0.7, 0.3);
    let space = MotionSpace::steered(torus, steering, 0.6);
    let discs = vec![[5.0, 5.0, 1.2], [2.0, 6.5, 0.8], [7.0, 2.0, 1.0], [8.0, 7.0, 0.7]];
    let [start, goal] = [[1.5, 1.5, 0.5], [8.5, 8.8, -2.5]].map(|q| space.state(&q));
    Problem::new(space.clone(), Box::new(Discs { space, discs }), start, goal).expect("both are free")
}

/// A planner at its beginning.
fn begin(options: &impl PlannerKind, problem: &Problem<Car>, seed: u64) -> Box<dyn Planner<Car>> {
    options.begin(problem, seed).unwrap_or_else(|error| panic!("{error}"))
}

fn prm(
    problem: &Problem<Car>,
    seed: u64,
    samples: usize,
    (insertion, discard): (Insertion, bool),
    search: Algorithm,
) -> Box<dyn Planner<Car>> {
    let searching = Searching { search, ..Searching::default() };
    begin(
        &PrmOptions { samples: Some(samples), k: Some(6), insertion, discard, searching, ..PrmOptions::default() },
        problem,
        seed,
    )
}

fn lazy_prm(problem: &Problem<Car>, seed: u64) -> Box<dyn Planner<Car>> {
    begin(&LazyPrmOptions { samples: Some(120), k: 6, ..LazyPrmOptions::default() }, problem, seed)
}

fn rrt(problem: &Problem<Car>, seed: u64, extend: Extend) -> Box<dyn Planner<Car>> {
    let reaching = GoalBias { goal_bias: 0.1, goal_every: None };
    begin(&RrtOptions { step: Some(1.0), extend, reaching, ..RrtOptions::default() }, problem, seed)
}

fn rrt_star(problem: &Problem<Car>, seed: u64) -> Box<dyn Planner<Car>> {
    let rewiring = Rewiring { step: Some(2.0), ..Rewiring::default() };
    begin(&RrtStarOptions { rewiring, ..RrtStarOptions::default() }, problem, seed)
}

fn fmt_star(problem: &Problem<Car>, seed: u64) -> Box<dyn Planner<Car>> {
    begin(&FmtStarOptions { samples: Some(150), ..FmtStarOptions::default() }, problem, seed)
}

fn bit_star(problem: &Problem<Car>, seed: u64) -> Box<dyn Planner<Car>> {
    begin(&BitStarOptions { batch_size: 60, ..BitStarOptions::default() }, problem, seed)
}

fn rrt_connect(problem: &Problem<Car>, seed: u64, step: f64) -> Box<dyn Planner<Car>> {
    begin(&RrtConnectOptions { step: Some(step), ..RrtConnectOptions::default() }, problem, seed)
}

/// Runs to the end, and a planner that goes on to shorter paths for a while.
fn finish(planner: &mut dyn Planner<Car>, problem: &Problem<Car>) -> Status {
    let mut improved = 0;
    for i in 1..20_000 {
        let status = planner.iterate(problem, i);
        improved += u32::from(planner.cost() < f64::INFINITY);
        if status != Status::Running || improved > 150 {
            return if improved > 0 { Status::Solved } else { status };
        }
    }
    Status::Running
}

/// The path is one of the graph's, from start to goal, every edge of it along its arrow and driven in that order.
fn is_driven(planner: &dyn Planner<Car>, problem: &Problem<Car>, what: &str) {
    let (graph, path) = (planner.graph(), planner.path());
    let states: Vec<State> = path.iter().map(|&v| *graph.state(v)).collect();
    assert_eq!((states[0], states[states.len() - 1]), (*problem.start(), *problem.goal()), "{what}");
    for pair in path.windows(2) {
        let is_edge = graph.edges().contains(&[pair[0], pair[1]]);
        let is_back = problem.space().is_symmetric() && graph.edges().contains(&[pair[1], pair[0]]);
        assert!(is_edge || is_back, "{what}: {pair:?} is no edge in this direction");
    }
    assert!(is_free(&states, problem), "{what}");
}

/// Whether every motion from a state to the next is free.
fn is_free(states: &[State], problem: &Problem<Car>) -> bool {
    states.windows(2).all(|pair| problem.validity().is_motion_free(&pair[0], &pair[1]))
}

/// Every edge is free in the direction that it is stored in.
fn edges_are_free(graph: &Graph<Car>, problem: &Problem<Car>) {
    for &[from, to] in graph.edges() {
        assert!(problem.validity().is_motion_free(graph.state(from), graph.state(to)), "{from:?} to {to:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn trees_end_at_the_goal_and_are_driven_in_order() {
    for (steering, seed, problem) in problems() {
        let mut trees: Vec<(String, Box<dyn Planner<Car>>, f64)> = Vec::new();
        for extend in [Extend::Step, Extend::Half, Extend::UntilObstacle] {
            trees.push((format!("rrt {extend:?}"), rrt(&problem, seed, extend), f64::INFINITY));
        }
        trees.push(("rrt-star".to_owned(), rrt_star(&problem, seed), f64::INFINITY));
        trees.push(("fmt-star".to_owned(), fmt_star(&problem, seed), f64::INFINITY));
        trees.push(("bit-star".to_owned(), bit_star(&problem, seed), f64::INFINITY));
        if problem.space().is_symmetric() {
            trees.push(("aorrtc".to_owned(), begin(&AorrtcOptions::default(), &problem, seed), f64::INFINITY));
        }
        for step in [0.4, 1.0, 5.0] {
            trees.push((format!("rrt-connect {step}"), rrt_connect(&problem, seed, step), step));
        }
        for (name, mut planner, longest) in trees {
            let what = format!("{name} {steering:?} {seed}");
            assert_eq!(finish(&mut *planner, &problem), Status::Solved, "{what}");
            is_driven(&*planner, &problem, &what);
            edges_are_free(planner.graph(), &problem);
            for edge in planner.graph().edges() {
                let [a, b] = edge.map(|vertex| planner.graph().state(vertex));
                assert!(problem.space().distance(a, b) <= longest + 1e-6, "{what}: no edge is longer than a step");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn roadmaps_are_never_walked_against_their_arrows() {
    let orders = [(Insertion::Batch, false), (Insertion::OneByOne, false), (Insertion::OneByOne, true)];
    let searches = [Algorithm::AStar, Algorithm::Dijkstra, Algorithm::BreadthFirst, Algorithm::Bidirectional];
    let (mut solved, mut all) = (0, 0);
    for (steering, seed, problem) in problems() {
        for order in orders {
            let mut found = Vec::new();
            for search in searches {
                let mut planner = prm(&problem, seed, 120, order, search);
                let what = format!("prm {steering:?} {order:?} {search:?} {seed}");
                let status = finish(&mut *planner, &problem);
                all += 1;
                solved += usize::from(status == Status::Solved);
                if status == Status::Solved {
                    is_driven(&*planner, &problem, &what);
                }
                edges_are_free(planner.graph(), &problem);
                let states: Vec<State> = planner.path().iter().map(|&v| *planner.graph().state(v)).collect();
                found.push((states.len(), length(problem.space(), &states)));
            }
            let [a_star, dijkstra, breadth, both] = found[..] else { unreachable!("four searches") };
            assert!((a_star.1 - dijkstra.1).abs() <= 1e-4, "{a_star:?} {dijkstra:?}: one cost");
            assert_eq!(breadth.0, both.0, "one number of edges");
            if order == orders[0] {
                let mut lazy = lazy_prm(&problem, seed);
                if finish(&mut *lazy, &problem) == Status::Solved {
                    is_driven(&*lazy, &problem, &format!("lazy-prm {steering:?} {seed}"));
                }
                edges_are_free(lazy.graph(), &problem);
                let states: Vec<State> = lazy.path().iter().map(|&v| *lazy.graph().state(v)).collect();
                assert_eq!(length(problem.space(), &states).to_bits(), dijkstra.1.to_bits(), "the same path");
            }
        }
    }
    assert!(solved * 10 > all * 9, "{solved} of {all} are solved");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_directed_roadmap_tries_each_neighbour_in_either_direction_once() {
    let problem = problem(Steering::Dubins);
    let space = problem.space();
    for seed in 0..SEEDS {
        let mut planner = prm(&problem, seed, 60, (Insertion::Batch, false), Algorithm::AStar);
        finish(&mut *planner, &problem);
        let graph = planner.graph();
        let n = graph.states().len();
        // By the definition: of every vertex the six nearest that it leads to and the six nearest that lead to it, and the motion from
        // start to goal.
        let mut expected = std::collections::BTreeSet::from([[0, 1]]);
        for v in 0..n {
            let mut ranked = |d: &dyn Fn(usize) -> f64, edge: &dyn Fn(usize) -> [usize; 2]| {
                let mut others: Vec<usize> = (0..n).filter(|&u| u != v).collect();
                others.sort_by(|&a, &b| d(a).total_cmp(&d(b)).then(a.cmp(&b)));
                expected.extend(others[..6].iter().map(|&u| edge(u)));
            };
            let at = |i: usize| &graph.states()[i];
            ranked(&|u| space.distance(at(v), at(u)), &|u| [v, u]);
            ranked(&|u| space.distance(at(u), at(v)), &|u| [u, v]);
        }
        let refused = graph.events().iter().filter(|event| event.other.is_some());
        let refused = refused.filter_map(|event| Some([event.vertex?, event.other?]));
        let refused = refused.filter(|pair| !graph.edges().contains(pair));
        let mut tried: Vec<[usize; 2]> =
            graph.edges().iter().copied().chain(refused).map(|pair| pair.map(VertexId::index)).collect();
        let count = tried.len();
        tried.sort();
        tried.dedup();
        assert_eq!(tried.len(), count, "none twice");
        assert_eq!(tried, expected.into_iter().collect::<Vec<_>>());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_roadmap_finds_paths_of_other_queries_in_their_direction() {
    let mut found = 0;
    for (_, seed, problem) in problems() {
        let space = problem.space();
        let mut planner = prm(&problem, seed, 150, (Insertion::Batch, false), Algorithm::Bidirectional);
        finish(&mut *planner, &problem);
        for (ends, keep) in [([[1.0, 9.0, 0.0], [9.0, 1.0, 1.0]], None), ([[9.0, 5.0, -1.5], [1.0, 4.0, 2.0]], Some(7))]
        {
            let ends = ends.map(|q| space.state(&q));
            let roadmap = planner.roadmap_mut().expect("a roadmap");
            let before = roadmap.graph().states().len();
            let answer = roadmap.query(&problem, ends, keep);
            assert_eq!(roadmap.graph().states().len(), before + if keep.is_some() { 2 } else { 0 });
            edges_are_free(roadmap.graph(), &problem);
            if !answer.path.is_empty() {
                found += 1;
                assert_eq!((answer.path[0], answer.path[answer.path.len() - 1]), (ends[0], ends[1]));
                assert!(is_free(&answer.path, &problem));
            }
        }
    }
    assert!(found as u64 > 3 * SEEDS, "{found} paths");
}

#[wasm_bindgen_test(unsupported = test)]
fn improved_paths_are_driven_in_order_and_never_longer() {
    for (steering, seed, problem) in problems() {
        let mut planner = rrt_connect(&problem, seed, 0.8);
        assert_eq!(finish(&mut *planner, &problem), Status::Solved);
        let states: Vec<State> = planner.path().iter().map(|&v| *planner.graph().state(v)).collect();
        let before = length(problem.space(), &states);
        let wanted = Wanted { reduce: true, shortcuts: 60, partial_shortcuts: 20, ..Wanted::default() };
        let mut improvement = Improvement::<Car>::new(states, wanted, seed);
        while !improvement.is_done() {
            improvement.attempt(&problem);
        }
        let path = improvement.path();
        assert_eq!((path[0], path[path.len() - 1]), (*problem.start(), *problem.goal()));
        assert!(length(problem.space(), path) <= before + 1e-6);
        assert!(is_free(path, &problem), "{steering:?} {seed}");
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
#[should_panic(expected = "requires a symmetric space")]
fn guards_need_motions_that_can_be_made_back() {
    begin(&planarium::planner::VisibilityPrmOptions::default(), &problem(Steering::Dubins), 1);
}
