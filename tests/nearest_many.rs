//! Up to 920,000 questions, by `PLANARIUM_DEEP=1`: the kd-tree and the planners' index answer as the linear scan does, to the bit, ties by number, in every
//! space and metric that there is; on native, Node and Chrome alike, where a browser is asked fewer.

use crate::common::cases;
use planarium::graph::VertexId;
use planarium::nearest::{Index, KdTree, LinearScan, Nearest, Neighbour};
use planarium::random::{Random, Stream};
use planarium::space::{Coordinate, Metric, ProductSpace, Space};
use wasm_bindgen_test::wasm_bindgen_test;

type Wide = ProductSpace<8>;

/// Questions a set of states is asked.
const ASKED: usize = 200;

/// The most states of a set.
const MOST: u64 = 2000;

fn same(found: &[Neighbour], expected: &[Neighbour], what: &dyn Fn() -> String) {
    let bits = |neighbour: &Neighbour| (neighbour.distance.to_bits(), neighbour.vertex);
    assert!(found.iter().map(bits).eq(expected.iter().map(bits)), "{}:\n{found:?}\n{expected:?}", what());
}

/// A state of a set: anywhere, about a few centres, on a coarse grid where most distances are ties, or one of a few.
fn state<S: Space>(space: &S, ranges: &[[f64; 2]], kind: u64, random: &mut Random, few: &[S::State]) -> S::State {
    let mut numbers = [0.0; 8];
    match kind {
        0 => space.sample(random),
        1 => {
            let center = few[random.below(few.len() as u64) as usize];
            for (i, number) in numbers.iter_mut().enumerate().take(space.dimension()) {
                let [low, high] = ranges[i];
                *number = (space.coordinates(&center)[i] + 0.02 * (high - low) * random.normal()).clamp(low, high);
            }
            space.state(&numbers)
        }
        2 => {
            for (number, [low, high]) in numbers.iter_mut().zip(ranges) {
                *number = low + (high - low) * random.below(5) as f64 / 4.0;
            }
            space.state(&numbers)
        }
        _ => few[random.below(few.len() as u64) as usize],
    }
}

/// A set of states by its number.
fn set<S: Space>(space: &S, ranges: &[[f64; 2]], kind: u64, n: usize, random: &mut Random) -> Vec<S::State> {
    let few: Vec<_> = (0..5).map(|_| space.sample(random)).collect();
    (0..n).map(|_| state(space, ranges, kind, random, &few)).collect()
}

/// Where a question is asked: mostly anywhere, else at a state or on the grid.
fn target<S: Space>(space: &S, ranges: &[[f64; 2]], states: &[S::State], random: &mut Random) -> S::State {
    match random.below(4) {
        0 => states[random.below(states.len() as u64) as usize],
        1 => state(space, ranges, 2, random, states),
        _ => space.sample(random),
    }
}

/// How many neighbours: few, mostly.
fn how_many(n: usize, random: &mut Random) -> usize {
    match random.below(20) {
        0 => n,
        1 => 1 + random.below(100) as usize,
        _ => 1 + random.below(20) as usize,
    }
}

/// How many states: few more often than many.
fn size(most: u64, random: &mut Random) -> usize {
    let spread = libm::pow(most as f64, random.uniform());
    libm::floor(spread) as usize
}

/// Asks scan, tree and index of sets of states of one space `questions` questions in all; answers how many those were.
fn ask<S: Space>(name: &str, space: &S, ranges: &[[f64; 2]], questions: usize, seed: u64) -> usize {
    let mut random = Random::new(seed, Stream::Samples);
    let (mut one, mut other, mut asked, mut round) = (Vec::new(), Vec::new(), 0, 0);
    while asked < questions {
        let (kind, n) = (round % 4, size(MOST, &mut random));
        round += 1;
        let states = set(space, ranges, kind, n, &mut random);
        let (mut scan, mut tree, mut index) = (LinearScan::default(), KdTree::default(), Index::default());
        for (i, &state) in (0..).zip(&states) {
            scan.insert(space, VertexId(i), state);
            tree.insert(space, VertexId(i), state);
            index.insert(space, VertexId(i), state);
        }
        for question in 0..ASKED {
            let from = target(space, ranges, &states, &mut random);
            let k = how_many(n, &mut random);
            assert_eq!(scan.k_nearest(space, &from, k, &mut one), n, "a scan visits all");
            if question == 0 {
                // The scan itself, by the definition.
                let distance = |state: &S::State| space.distance(&from, state);
                let all =
                    (0..).zip(&states).map(|(i, state)| Neighbour { distance: distance(state), vertex: VertexId(i) });
                let mut all: Vec<_> = all.collect();
                all.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.vertex.cmp(&b.vertex)));
                same(&one, &all[..k.min(n)], &|| format!("{name}, set {round}: the definition"));
            }
            let what = || format!("{name}, set {round} of {n}, question {question}: {k} nearest");
            let visited = tree.k_nearest(space, &from, k, &mut other);
            assert!((one.len()..=n).contains(&visited), "{visited} of {n} visited");
            same(&other, &one, &what);
            index.k_nearest(space, &from, k, &mut other);
            same(&other, &one, &what);
            if question % 4 == 0 {
                // On the rim of it: ties belong to it.
                let radius = one[one.len() - 1].distance;
                let what = || format!("{name}, set {round} of {n}, question {question}: within {radius}");
                scan.within(space, &from, radius, &mut one);
                assert!(one.len() >= k.min(n));
                tree.within(space, &from, radius, &mut other);
                same(&other, &one, &what);
                index.within(space, &from, radius, &mut other);
                same(&other, &one, &what);
                asked += 1;
            }
            asked += 1;
        }
    }
    asked
}

fn ranges_of(space: &Wide) -> Vec<[f64; 2]> {
    (0..space.dimension()).map(|i| space.range(i)).collect()
}

/// Arms of so many joints: all circles, all limited, and both, each in every metric, the naive one among them.
fn arms(joints: usize) -> Vec<(String, Wide)> {
    let limited = |i: usize| Coordinate::Interval { low: -0.5 - i as f64, high: 2.0 + 0.3 * i as f64 };
    let kinds: [(&str, Vec<Coordinate>); 3] = [
        ("circles", vec![Coordinate::Circle; joints]),
        ("limits", (0..joints).map(limited).collect()),
        ("both", (0..joints).map(|i| if i % 2 == 0 { Coordinate::Circle } else { limited(i) }).collect()),
    ];
    let mut spaces = Vec::new();
    for (kind, joints_of) in &kinds {
        for (metric, name) in [(Metric::Sum, "sum"), (Metric::Euclidean, "euclidean")] {
            spaces.push((format!("{joints} joints, {kind}, {name}"), Wide::new(joints_of, metric)));
        }
        let naive = Wide::new(joints_of, Metric::Euclidean).cut_open();
        spaces.push((format!("{joints} joints, {kind}, naive"), naive));
    }
    spaces
}

fn ask_arms(joints: impl Iterator<Item = usize>) {
    let mut asked = 0;
    for count in joints {
        for (seed, (name, space)) in (0..).zip(arms(count)) {
            asked += ask(&name, &space, &ranges_of(&space), cases(10_000), 100 * count as u64 + seed);
        }
    }
    assert!(asked >= 4 * 9 * cases(10_000), "{asked}");
}

#[wasm_bindgen_test(unsupported = test)]
fn arms_of_one_to_four_joints() {
    ask_arms(1..=4);
}

#[wasm_bindgen_test(unsupported = test)]
fn arms_of_five_to_eight_joints() {
    ask_arms(5..=8);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_plane_and_placements() {
    let mut random = Random::new(1, Stream::Scenario);
    let mut asked = 0;
    for seed in 0..5 {
        let [width, height] = [0, 1].map(|_| libm::pow(10.0, 6.0 * random.uniform() - 3.0));
        let plane = Wide::of_box(&[-width, 0.0], &[width, height]);
        asked += ask("plane", &plane, &ranges_of(&plane), cases(10_000), 1000 + seed);
    }
    for seed in 0..15 {
        // Weights as far apart as four orders of magnitude.
        let [translation, rotation] = [0, 1].map(|_| libm::pow(10.0, 4.0 * random.uniform() - 2.0));
        let space = Wide::of_placements([0.0, -1.0], [2.0, 3.0], translation, rotation);
        let name = format!("placements, {translation} and {rotation}");
        asked += ask(&name, &space, &ranges_of(&space), cases(10_000), 2000 + seed);
    }
    assert!(asked >= 20 * cases(10_000), "{asked}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_hundred_thousand_clustered_gridded_or_twice_there() {
    let n = cases(100_000);
    let mut spaces = vec![("placements".to_owned(), Wide::of_placements([0.0, 0.0], [2.0, 2.0], 0.7, 0.3))];
    spaces.extend([2, 4, 8].into_iter().flat_map(|joints| arms(joints).into_iter().step_by(4)));
    for (seed, (name, space)) in (0..).zip(&spaces) {
        let ranges = ranges_of(space);
        let mut random = Random::new(4000 + seed, Stream::Samples);
        for kind in 0..4 {
            let states = set(space, &ranges, kind, n, &mut random);
            let (mut scan, mut tree, mut index) = (LinearScan::default(), KdTree::default(), Index::default());
            for (i, &state) in (0..).zip(&states) {
                scan.insert(space, VertexId(i), state);
                tree.insert(space, VertexId(i), state);
                index.insert(space, VertexId(i), state);
            }
            let (mut one, mut other) = (Vec::new(), Vec::new());
            for k in [1, 10, 100] {
                let from = target(space, &ranges, &states, &mut random);
                scan.k_nearest(space, &from, k, &mut one);
                tree.k_nearest(space, &from, k, &mut other);
                same(&other, &one, &|| format!("tree, {name}, kind {kind}: {k} of {n}"));
                index.k_nearest(space, &from, k, &mut other);
                same(&other, &one, &|| format!("index, {name}, kind {kind}: {k} of {n}"));
            }
        }
    }
}
