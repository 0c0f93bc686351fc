//! Nearest neighbours: every exact index returns what a plain scan returns, to the bit, ties by index, in every space and metric.

use crate::common::{cases, deep};
use planarium::graph::VertexId;
use planarium::nearest::{
    Direction, Forest, ForestParameters, Index, KdTree, LinearScan, Nearest, Neighbour, Neighbourhood, Query, recall,
};
use planarium::random::{Random, Stream};
use planarium::space::steering::Steering;
use planarium::space::{Coordinate, Metric, MotionSpace, ProductSpace, Space, gap, gap_to_interval};
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

type Wide = ProductSpace<8>;

/// The vertex of a state by its position: numbers increase, but not by one.
fn number(i: usize) -> VertexId {
    VertexId(3 * i as u32 + 1)
}

/// The states by their numbers, as queries take them; those that are no one's number are the first state.
fn numbered<T: Copy>(states: &[T]) -> Vec<T> {
    let mut all = vec![states[0]; 3 * states.len()];
    states.iter().enumerate().for_each(|(i, &state)| all[number(i).index()] = state);
    all
}

/// The definition: the distances of motions between a state and all states, sorted, ties by number.
fn truth<S: Space>(space: &S, direction: Direction, states: &[S::State], from: &S::State) -> Vec<Neighbour> {
    sorted(states, |state| match direction {
        Direction::In => space.distance(state, from),
        Direction::Out => space.distance(from, state),
    })
}

/// The same by the metric of the space on plain numbers, without wrap-around.
fn unwrapped_truth(space: &Wide, states: &[[f64; 8]], from: &[f64; 8]) -> Vec<Neighbour> {
    sorted(states, |state| space.norm(|i| gap(state[i], from[i], f64::INFINITY)))
}

/// All states by a distance, ties by number.
fn sorted<T>(states: &[T], distance: impl Fn(&T) -> f64) -> Vec<Neighbour> {
    let neighbour = |(i, state)| Neighbour { distance: distance(state), vertex: number(i) };
    let mut all: Vec<Neighbour> = states.iter().enumerate().map(neighbour).collect();
    all.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.vertex.cmp(&b.vertex)));
    all
}

fn same(found: &[Neighbour], expected: &[Neighbour], what: &dyn Fn() -> String) {
    let bits = |neighbour: &Neighbour| (neighbour.distance.to_bits(), neighbour.vertex);
    assert!(found.iter().map(bits).eq(expected.iter().map(bits)), "{}:\n{found:?}\n{expected:?}", what());
}

/// Checks all queries of an index against the sorted distances to all states.
fn check<S: Space>(
    name: &str,
    index: &impl Nearest<S>,
    space: &S,
    states: &[S::State],
    from: &S::State,
    truth: &[Neighbour],
) {
    assert_eq!((index.len(), index.is_empty()), (truth.len(), false), "{name}");
    let k_nearest = |k, found: &mut _| index.k_nearest(Query::to(space, states, from), k, found);
    let within = |radius, found: &mut _| index.within(Query::to(space, states, from), radius, found);
    check_queries(name, index.nearest(Query::to(space, states, from)), k_nearest, within, truth);
}

/// Checks the nearest, and the queries for the `k` nearest and for those within a radius.
fn check_queries(
    name: &str,
    nearest: Option<Neighbour>,
    k_nearest: impl Fn(usize, &mut Vec<Neighbour>) -> usize,
    within: impl Fn(f64, &mut Vec<Neighbour>) -> usize,
    truth: &[Neighbour],
) {
    let n = truth.len();
    let mut found = Vec::new();
    assert_eq!(nearest, Some(truth[0]), "{name}");
    for k in [0, 1, 2, 10, 30, 100, n, n + 1, usize::MAX] {
        let visited = k_nearest(k, &mut found);
        assert!(if k == 0 { visited == 0 } else { (k.min(n)..=n).contains(&visited) }, "{name}: {visited} of {n}");
        same(&found, &truth[..k.min(n)], &|| format!("{name}: {k} of {n}"));
    }
    // Radii that are distances themselves: a state exactly at the radius is included.
    for radius in [-1.0, 0.0, truth[n / 50].distance, truth[n / 3].distance, f64::INFINITY] {
        let inside = truth.partition_point(|neighbour| neighbour.distance <= radius);
        within(radius, &mut found);
        same(&found, &truth[..inside], &|| format!("{name}: within {radius} of {n}"));
    }
}

/// Checks that a query in any order has the neighbours of that in order, and visits as many vertices.
fn check_any_order<S: Space>(name: &str, index: &Index, query: Query<S>, truth: &[Neighbour]) {
    let (mut found, mut expected) = (Vec::new(), Vec::new());
    let n = truth.len();
    for radius in [-1.0, 0.0, truth[n / 50].distance, truth[n / 3].distance, f64::INFINITY] {
        for wanted in [Neighbourhood::Within(radius), Neighbourhood::of(7, radius)] {
            let visited = index.find_in_any_order(query, wanted, &mut found);
            assert_eq!(visited, index.find(query, wanted, &mut expected), "{name}");
            found.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.vertex.cmp(&b.vertex)));
            same(&found, &expected, &|| format!("{name}: {wanted:?} in any order"));
        }
    }
}

/// An index of the states.
fn grown<S: Space, I: Nearest<S>>(mut index: I, space: &S, states: &[S::State]) -> I {
    states.iter().enumerate().for_each(|(i, state)| index.insert(space, number(i), state));
    index
}

/// Grows every exact index by the same states; after each insertion they agree, now and then and at the end with the definition.
fn agrees<S: Space>(name: &str, space: &S, states: &[S::State], asked: &[S::State]) {
    let (mut linear, mut tree, mut index) = (LinearScan::default(), KdTree::default(), Index::default());
    let (mut one, mut other) = (Vec::new(), Vec::new());
    let numbered = numbered(states);
    for (i, state) in states.iter().enumerate() {
        linear.insert(space, number(i), state);
        tree.insert(space, number(i), state);
        index.insert(space, number(i), state);
        let (n, from) = (i + 1, &asked[i % asked.len()]);
        linear.k_nearest(Query::to(space, &numbered, from), 1 + i % 12, &mut one);
        tree.k_nearest(Query::to(space, &numbered, from), 1 + i % 12, &mut other);
        same(&other, &one, &|| format!("{name} after {n}"));
        let is_last = n == states.len();
        for from in asked.iter().take(if is_last { asked.len() } else { usize::from(n.is_power_of_two()) }) {
            let expected = truth(space, Direction::In, &states[..n], from);
            check(&format!("scan, {name}"), &linear, space, &numbered, from, &expected);
            check(&format!("kd-tree, {name}"), &tree, space, &numbered, from, &expected);
            check(&format!("index, {name}"), &index, space, &numbered, from, &expected);
            check_any_order(name, &index, Query::to(space, &numbered, from), &expected);
        }
    }
}

fn samples<S: Space>(space: &S, seed: u64, n: usize) -> Vec<S::State> {
    let mut random = Random::new(seed, Stream::Samples);
    (0..n).map(|_| space.sample(&mut random)).collect()
}

/// Sets of n states: anywhere, about a few centres, too close to each other for single precision, on a coarse grid where most distances are ties, one of a few, all equal,
/// at the seam and the limits or a few steps of rounding from them, in increasing and decreasing order, and on a spiral that
/// closes in, so that every new state lies in the smallest box.
fn sets(space: &Wide, random: &mut Random, n: usize) -> Vec<(&'static str, Vec<[f64; 8]>)> {
    let few: Vec<_> = (0..5).map(|_| space.sample(random)).collect();
    let mut set = |coordinate: &dyn Fn(&mut Random, f64, [f64; 2]) -> f64| -> Vec<[f64; 8]> {
        let mut state = |_| {
            let center = few[random.below(5) as usize];
            let at: Vec<f64> = (0..space.dimension()).map(|i| coordinate(random, center[i], space.range(i))).collect();
            space.state(&at)
        };
        (0..n).map(&mut state).collect()
    };
    let uniform = set(&|random, _, [low, high]| low + (high - low) * random.uniform());
    let mut increasing = uniform.clone();
    increasing.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let decreasing = increasing.iter().rev().copied().collect();
    let spiral =
        |i: usize| std::array::from_fn::<_, 8, _>(|j| 0.4 * 0.98f64.powi(i as i32) * (1.0 - ((i + j) % 3) as f64));
    vec![
        ("uniform", uniform),
        ("clusters", set(&|random, x, [low, high]| (x + 0.02 * (high - low) * random.normal()).clamp(low, high))),
        ("dense", set(&|random, x, [low, high]| (x + 1e-9 * random.normal()).clamp(low, high))),
        ("grid", set(&|random, _, [low, high]| low + (high - low) * random.below(5) as f64 / 4.0)),
        ("few", set(&|_, x, _| x)),
        (
            "seam",
            set(&|random, _, [low, high]| {
                let steps = f64::EPSILON * random.below(4) as f64;
                match random.below(5) {
                    0 => high,
                    1 => high - high.abs() * steps,
                    2 => low + low.abs() * (steps + f64::EPSILON),
                    3 => (0.0 + steps).clamp(low, high),
                    _ => low + (high - low) * random.uniform(),
                }
            }),
        ),
        ("equal", vec![few[0]; n]),
        ("increasing", increasing),
        ("decreasing", decreasing),
        ("spiral", (0..n).map(|i| space.state(&spiral(i)[..space.dimension()])).collect()),
    ]
}

/// Arms of so many joints: all circles, all limited, and both, each in every metric, the naive one among them.
fn arms_of(joints: usize) -> Vec<(String, Wide)> {
    let limited = |i: usize| Coordinate::Interval { low: -0.5 - i as f64, high: 2.0 + 0.3 * i as f64 };
    let kinds: [(&str, Vec<Coordinate>); 3] = [
        ("circles", vec![Coordinate::Circle; joints]),
        ("limits", (0..joints).map(limited).collect()),
        ("both", (0..joints).map(|i| if i % 2 == 0 { Coordinate::Circle } else { limited(i) }).collect()),
    ];
    let mut spaces = Vec::new();
    for (kind, of) in &kinds {
        let [sum, euclidean] = [Metric::Sum, Metric::Euclidean].map(|metric| Wide::new(of, metric));
        spaces.push((format!("{joints} joints, {kind}, naive"), euclidean.clone().cut_open()));
        let weights: Vec<f64> = (0..joints).map(|i| [0.1, 1.0, 300.0][i % 3]).collect();
        spaces.push((format!("{joints} joints, {kind}, weighted"), euclidean.clone().weighted(&weights)));
        spaces.push((format!("{joints} joints, {kind}, weighted sum"), sum.clone().weighted(&weights)));
        spaces.push((format!("{joints} joints, {kind}, sum"), sum));
        spaces.push((format!("{joints} joints, {kind}, euclidean"), euclidean));
    }
    spaces
}

/// Planes, and placements with weights up to four orders of magnitude apart.
fn planes_and_placements() -> Vec<(String, Wide)> {
    let mut random = Random::new(1, Stream::Scenario);
    let mut power = |most: f64| libm::pow(10.0, most * (2.0 * random.uniform() - 1.0));
    let mut spaces = vec![("slab".to_owned(), Wide::of_box(&[0.0, 0.0, -1e6], &[1.0, 1e-3, 1e6]))];
    // Far from the origin, and beyond the range of single precision.
    spaces.push(("far".to_owned(), Wide::of_box(&[1e6, -1e6], &[1e6 + 1.0, -1e6 + 1e-3])));
    spaces.push(("huge".to_owned(), Wide::of_box(&[-1e60, 0.0], &[1e60, 1e30])));
    for [translation, rotation] in [[1e-50, 1e-48], [1e45, 1e44]] {
        let space = Wide::of_placements([0.0, -1.0], [2.0, 3.0], translation, rotation);
        spaces.push((format!("placements, {translation} and {rotation}"), space));
    }
    for _ in 0..5 {
        let [width, height] = [power(3.0), power(3.0)];
        spaces.push((format!("plane {width} by {height}"), Wide::of_box(&[-width, 0.0], &[width, height])));
    }
    for _ in 0..15 {
        let [translation, rotation] = [power(2.0), power(2.0)];
        let space = Wide::of_placements([0.0, -1.0], [2.0, 3.0], translation, rotation);
        spaces.push((format!("placements, {translation} and {rotation}"), space));
    }
    spaces
}

/// All sets of states in these spaces, small ones more often than large ones, which have a test of their own.
fn hold(spaces: impl IntoIterator<Item = (String, Wide)>) {
    for (seed, (name, space)) in (1..).zip(spaces) {
        let mut random = Random::new(seed, Stream::Samples);
        for _ in 0..cases(8) {
            let n = libm::pow(if deep() { 2000.0 } else { 700.0 }, random.uniform()) as usize;
            for (kind, states) in sets(&space, &mut random, n) {
                let mut asked = samples(&space, seed, cases(12));
                asked.extend(states.iter().step_by(n.div_ceil(4)));
                agrees(&format!("{name}, {kind}"), &space, &states, &asked);
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn arms() {
    hold((1..=8).flat_map(arms_of));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_plane_and_placements() {
    hold(planes_and_placements());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_hundred_thousand_states_of_any_kind() {
    let mut spaces = planes_and_placements().split_off(20);
    spaces.extend([2, 4, 8].into_iter().flat_map(|joints| arms_of(joints).into_iter().step_by(4)));
    for (seed, (name, space)) in (4000..).zip(&spaces) {
        for (kind, states) in sets(space, &mut Random::new(seed, Stream::Samples), cases(100_000)).drain(..5) {
            let scan = grown(LinearScan::default(), space, &states);
            let tree = grown(KdTree::default(), space, &states);
            let index = grown(Index::default(), space, &states);
            let (numbered, mut found) = (numbered(&states), Vec::new());
            for (from, k) in samples(space, seed, 3).iter().zip([1, 10, 100]) {
                let expected = &truth(space, Direction::In, &states, from)[..k];
                scan.k_nearest(Query::to(space, &numbered, from), k, &mut found);
                same(&found, expected, &|| format!("scan, {name}, {kind}: {k}"));
                tree.k_nearest(Query::to(space, &numbered, from), k, &mut found);
                same(&found, expected, &|| format!("tree, {name}, {kind}: {k}"));
                index.k_nearest(Query::to(space, &numbered, from), k, &mut found);
                same(&found, expected, &|| format!("index, {name}, {kind}: {k}"));
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tree_without_wrap_around_is_a_scan_by_plain_numbers() {
    let spaces = [1, 2, 5].into_iter().flat_map(arms_of).chain(planes_and_placements().into_iter().step_by(3));
    for (seed, (name, space)) in (1..).zip(spaces) {
        let mut random = Random::new(seed, Stream::Samples);
        for (kind, states) in sets(&space, &mut random, cases(1200)) {
            let (tree, numbered) = (grown(KdTree::unwrapped(), &space, &states), numbered(&states));
            let mut asked = samples(&space, seed, 3);
            asked.push(states[states.len() / 2]);
            for from in &asked {
                let plain = unwrapped_truth(&space, &states, from);
                check(&format!("{name}, {kind}"), &tree, &space, &numbered, from, &plain);
                if (0..space.dimension()).all(|i| space.period(i) == f64::INFINITY) {
                    let scan = truth(&space, Direction::In, &states, from);
                    same(&plain, &scan, &|| format!("{name}, {kind}: nothing wraps"));
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tree_without_wrap_around_misses_neighbours_across_the_seam_and_no_others() {
    let space = Wide::new(&[Coordinate::Circle; 2], Metric::Sum);
    let states = samples(&space, 1, 2000);
    let (tree, numbered) = (grown(KdTree::unwrapped(), &space, &states), numbered(&states));
    let share = |at: [f64; 2]| {
        let (from, mut found) = (space.state(&at), Vec::new());
        tree.k_nearest(Query::to(&space, &numbered, &from), 20, &mut found);
        assert!(found.iter().all(|one| (numbered[one.vertex.index()][0] < 0.0) == (from[0] < 0.0)), "none from beyond");
        recall(&found, &truth(&space, Direction::In, &states, &from)[..20])
    };
    for at in [[PI, 1.0], [-3.1, 1.0], [3.13, -2.0]] {
        let share = share(at);
        assert!(share > 0.2 && share < 0.8, "about half of the neighbours of {at:?} are beyond the seam: {share}");
    }
    assert_eq!([[1.5, 1.0], [-1.5, 0.0]].map(share), [1.0; 2], "far from the seam");
}

#[wasm_bindgen_test(unsupported = test)]
fn an_empty_index_has_no_neighbours() {
    fn empty(index: &impl Nearest<Wide>, space: &Wide) {
        let from = space.state(&[1.0; 8]);
        let mut found = vec![Neighbour { distance: 1.0, vertex: VertexId(1) }];
        assert!(index.is_empty());
        assert_eq!(index.nearest(Query::to(space, &[], &from)), None);
        index.k_nearest(Query::to(space, &[], &from), 3, &mut found);
        assert!(found.is_empty(), "what the list held before is gone");
        index.k_nearest(Query::to(space, &[], &from), 0, &mut found);
        index.within(Query::to(space, &[], &from), 10.0, &mut found);
        assert!(found.is_empty());
    }
    for (_, space) in arms_of(3).into_iter().chain(planes_and_placements()) {
        empty(&LinearScan::default(), &space);
        empty(&KdTree::default(), &space);
        empty(&KdTree::unwrapped(), &space);
        empty(&Index::default(), &space);
        empty(&Forest::new(ForestParameters::default(), 1), &space);
    }
}

/// A forest of the states, and the average part of the nearest `k` that it finds.
fn forest_recall<S: Space>(space: &S, seed: u64, n: usize, k: usize, parameters: ForestParameters) -> f64 {
    let states = samples(space, seed, n);
    let forest = grown(Forest::new(parameters, Random::new(seed, Stream::Projections).bits()), space, &states);
    assert_eq!(Nearest::<S>::len(&forest), n);
    let numbered = numbered(&states);
    let asked = samples(space, seed + 1, cases(40));
    let parts = asked.iter().map(|from| {
        let exact = truth(space, Direction::In, &states, from);
        let mut found = Vec::new();
        forest.k_nearest(Query::to(space, &numbered, from), k, &mut found);
        assert_eq!(found.len(), k.min(n), "as many as asked for, if not all the nearest");
        for (i, neighbour) in found.iter().enumerate() {
            let distance = space.distance(from, &states[neighbour.vertex.index() / 3]);
            assert_eq!(neighbour.distance.to_bits(), distance.to_bits(), "its distance is true");
            assert!(i == 0 || found[i - 1].is_before(neighbour), "nearest first, none twice");
        }
        assert_eq!(forest.nearest(Query::to(space, &numbered, from)).is_some(), n > 0);
        let radius = found[k / 2].distance;
        let (first, mut inside) = (found[..=k / 2].to_vec(), Vec::new());
        forest.within(Query::to(space, &numbered, from), radius, &mut inside);
        same(&inside, &first, &|| "within a radius are those of the k nearest that are".to_owned());
        recall(&found, &exact[..k.min(n)])
    });
    parts.sum::<f64>() / asked.len() as f64
}

#[wasm_bindgen_test(unsupported = test)]
fn the_approximate_index_finds_most_of_the_nearest_and_more_with_more_candidates() {
    let n = cases(10_000);
    let six = ProductSpace::<8>::new(&[Coordinate::Circle; 6], Metric::Sum);
    let of = |candidates| ForestParameters { candidates, ..ForestParameters::default() };
    let [few, default, all] = [100, 400, n].map(|candidates| forest_recall(&six, 21, n, 10, of(candidates)));
    assert!(few < default, "{few} with 100 candidates, {default} with 400");
    assert!(default >= 0.8, "{default} of the ten nearest");
    assert_eq!(all, 1.0, "all candidates are all states");
    let mixed = [Coordinate::Circle, Coordinate::Interval { low: -9.0, high: 0.5 }, Coordinate::Circle];
    let three = ProductSpace::<4>::new(&mixed, Metric::Euclidean);
    let found = forest_recall(&three, 23, n, 10, of(400));
    assert!(found >= 0.98, "{found} of the ten nearest in three dimensions");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_stays_flat_whatever_order_states_come_in() {
    let space = MotionSpace::new(ProductSpace::<4>::of_box(&[0.0, 0.0], &[1.0, 1.0]));
    let n = cases(20_000);
    let parameters = ForestParameters { trees: 2, leaf: 8, candidates: n };
    let line = |i: usize| [i as f64 / n as f64, 0.5];
    type Place<'a> = &'a dyn Fn(usize) -> [f64; 2];
    let orders: [(&str, Place); 4] = [
        ("on a line", &line),
        ("on a line, backwards", &|i| line(n - 1 - i)),
        ("a lattice, row by row", &|i| [(i / 128) as f64 / 160.0, (i % 128) as f64 / 128.0]),
        ("the same, but for a few", &|i| if i % 97 == 0 { line(i) } else { [0.25, 0.25] }),
    ];
    for (what, place) in orders {
        let states: Vec<_> = (0..n).map(|i| space.state(&place(i))).collect();
        let forest = grown(Forest::new(parameters, 3), &space, &states);
        // Twice as deep as it has to be, and a few.
        let most = 18.0 + 2.0 * libm::log2(n as f64 / 8.0);
        assert!(forest.depth() as f64 <= most, "{what}: {} of {most}", forest.depth());
        // All of them are still there.
        let (from, mut found) = (space.state(&[0.3, 0.4]), Vec::new());
        assert_eq!(forest.k_nearest(Query::to(&space, &numbered(&states), &from), n, &mut found), n, "{what}");
        same(&found, &truth(&space, Direction::In, &states, &from), &|| what.to_owned());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_of_equal_states_grows_and_the_same_key_grows_the_same_forest() {
    let space = ProductSpace::<4>::new(&[Coordinate::Circle; 4], Metric::Sum);
    let parameters = ForestParameters { trees: 3, leaf: 2, candidates: 50 };
    let state = space.state(&[1.0, 2.0, 3.0, -3.0]);
    let equal = grown(Forest::new(parameters, 5), &space, &[state; 200]);
    let mut found = Vec::new();
    equal.k_nearest(Query::to(&space, &[state; 600], &state), 70, &mut found);
    assert!(found.len() == 70 && found.iter().all(|neighbour| neighbour.distance == 0.0));

    let states = samples(&space, 24, 2000);
    let found_by = |key| {
        let forest = grown(Forest::new(parameters, key), &space, &states);
        let mut all = Vec::new();
        for from in samples(&space, 25, 20) {
            let mut found = Vec::new();
            forest.k_nearest(Query::to(&space, &numbered(&states), &from), 30, &mut found);
            all.extend(found);
        }
        all
    };
    same(&found_by(7), &found_by(7), &|| "one key".to_owned());
    assert_ne!(found_by(7), found_by(8), "another key draws other planes");
}

#[wasm_bindgen_test(unsupported = test)]
fn recall_is_the_part_of_the_exact_neighbours_that_was_found() {
    let all = [1, 2, 3, 4].map(|i| Neighbour { distance: f64::from(i), vertex: VertexId(i) });
    assert_eq!(recall(&all[1..], &all), 0.75);
    assert_eq!(recall(&all, &all[..2]), 1.0);
    assert_eq!(recall(&[], &all), 0.0);
    assert_eq!(recall(&all, &[]), 1.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_metric_of_the_gaps_is_the_distance_to_the_bit() {
    fn holds<S: Space>(space: &S) {
        let states = samples(space, 17, cases(4000));
        for (a, b) in states.iter().zip(&states[1..]) {
            let (x, y) = (space.coordinates(a), space.coordinates(b));
            let distance = space.norm(|i| gap(x[i], y[i], space.period(i)));
            assert_eq!(distance.to_bits(), space.distance(a, b).to_bits(), "{a:?} {b:?}");
        }
    }
    let spaces = (1..=4).flat_map(arms_of).chain(planes_and_placements());
    spaces.for_each(|(_, space)| holds(&space));
}

#[wasm_bindgen_test(unsupported = test)]
fn no_gap_is_less_than_the_gap_to_an_interval_around_it() {
    let mut random = Random::new(18, Stream::Samples);
    // Numbers of the circle, many of them at the seam, at quarters, or a step of rounding away from another.
    let mut number = || {
        let quarter = PI * 0.5 * (random.below(4) as f64 - 1.0);
        match random.below(3) {
            0 => quarter,
            1 if quarter < PI => quarter + f64::EPSILON * random.below(3) as f64,
            _ => PI - TAU * random.uniform(),
        }
    };
    for _ in 0..cases(200_000) {
        let (a, mut in_order) = (number(), [number(), number(), number()]);
        in_order.sort_by(f64::total_cmp);
        let [low, x, high] = in_order;
        for period in [TAU, f64::INFINITY] {
            let bound = gap_to_interval(low - a, a - high, period);
            assert!(bound <= gap(a, x, period), "{a} from [{low}, {high}] and {x}");
            let is_inside = low <= a && a <= high;
            assert_eq!(bound == 0.0, is_inside || gap(a, low, period) * gap(a, high, period) == 0.0);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn steered_motions_have_the_neighbours_of_a_plain_scan_in_either_direction() {
    for (steering, radius) in [(Steering::Dubins, 0.5), (Steering::ReedsShepp, 0.5), (Steering::ReedsShepp, 4.0)] {
        let placements = ProductSpace::<4>::of_placements([0.0, 0.0], [10.0, 10.0], 0.7, 0.3);
        let space = MotionSpace::steered(placements, steering, radius);
        let few = samples(&space, 20, 4);
        let lattice: Vec<_> = (0..512)
            .map(|i| space.state(&[f64::from(i % 8), f64::from(i / 8 % 8), f64::from(i / 64) * TAU / 8.0]))
            .collect();
        // At random, on a lattice where most are ties, many times the same, and hardly any.
        let sets = [samples(&space, 21, 1500), lattice, (0..300).map(|i| few[i * i % 4]).collect(), few.clone()];
        for states in &sets {
            let index = grown(Index::default(), &space, states);
            let numbered = numbered(states);
            let mut asked = samples(&space, 22, cases(20));
            asked.extend(states.iter().step_by(states.len().div_ceil(4)));
            for from in &asked {
                for direction in [Direction::In, Direction::Out] {
                    let truth = truth(&space, direction, states, from);
                    let name = format!("{steering:?} {direction:?}");
                    let query = Query { space: &space, states: &numbered, direction, from };
                    let k_nearest = |k, found: &mut _| index.k_nearest(query, k, found);
                    let within = |radius, found: &mut _| index.within(query, radius, found);
                    check_queries(&name, index.nearest(query), k_nearest, within, &truth);
                    check_any_order(&name, &index, query, &truth);
                    if direction == Direction::In {
                        check("plain queries are about motions to the state", &index, &space, &numbered, from, &truth);
                    }
                }
            }
        }
        assert_eq!(Index::default().nearest(Query::to(&space, &[], &few[0])), None);
    }
}
