//! Nearest neighbours on toruses: median microseconds per query of the linear scan, the kd-tree and the approximate index; and
//! all three beside the kd-tree of the crate kiddo.
//!
//! `cargo bench --bench nearest`; a run pinned to one core is quieter. `-- kiddo` runs that comparison alone.

use kiddo::{MutableKdTree, SquaredEuclidean};
use planarium::graph::VertexId;
use planarium::nearest::{Forest, ForestParameters, Index, KdTree, LinearScan, Nearest, Neighbour, Query, recall};
use planarium::random::{Random, Stream};
use planarium::space::{Coordinate, Metric, ProductSpace, Space};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::num::NonZero;
use std::time::Instant;

/// Trees built of the same states beside kiddo, of which the fastest counts.
const BUILDS: usize = 3;
/// States in an approximate index beside kiddo: a million take it 20 s.
const MOST_IN_FOREST: usize = 100_000;

fn main() {
    beside_kiddo();
    if std::env::args().any(|argument| argument == "kiddo") {
        return;
    }
    println!("\nMicroseconds per query; the approximate index with its recall\n");
    println!(
        "| dimension | n | k | linear | kd-tree | index | approximate | recall | kd-tree, approximate built in ms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    rows::<2>();
    rows::<3>();
    rows::<4>();
    rows::<6>();
    rows::<8>();
    building();
    println!(
        "\nFrom how many states on the kd-tree is faster than the scan\n\n| dimension | k = 1 | 3 | 10 | 30 | 100 |"
    );
    println!("|---|---|---|---|---|---|");
    crossovers::<2>();
    crossovers::<3>();
    crossovers::<4>();
    crossovers::<5>();
    crossovers::<6>();
}

/// Beside the mutable tree of kiddo, with coordinates of 64 bits and the Euclidean metric, in which a radian counts like a metre. Both
/// must find the same distances.
///
/// The tree itself does not wrap. A query to it names a period for every axis, and kiddo measures modulo the periods or also searches
/// round shifted images of the query, at most 3^d - 1 of them; an axis that does not wrap has a period beyond any distance. In a box
/// no period is named.
fn beside_kiddo() {
    println!("Beside kiddo: insertion in ns per state, queries for k = 1 and 10 in microseconds, recall for k = 10\n");
    print!("| space | n | kd-tree: insertion | kiddo: insertion | kd-tree: query | kiddo: query | scan: query ");
    println!("| approximate: insertion | query | recall |");
    println!("|---|---|---|---|---|---|---|---|---|---|");
    let side = Coordinate::Interval { low: -2.0, high: 2.0 };
    peers("box, 3 dimensions", &[side; 3]);
    peers("box, 6 dimensions", &[side; 6]);
    peers("torus, 3 dimensions", &[Coordinate::Circle; 3]);
    peers("torus, 6 dimensions", &[Coordinate::Circle; 6]);
    peers("placements", &[side, side, Coordinate::Circle]);
}

fn peers<const N: usize>(name: &str, coordinates: &[Coordinate; N]) {
    let space = ProductSpace::<N>::new(coordinates, Metric::Euclidean);
    let wraps = (0..N).any(|i| space.is_circle(i));
    let periods: [f64; N] = std::array::from_fn(|i| if space.is_circle(i) { TAU } else { 1e6 });
    // A period begins at 0.
    let moved = |state: &[f64; N]| std::array::from_fn(|i| state[i] - space.range(i)[0]);
    for n in [10_000, 100_000, 1_000_000] {
        let mut random = Random::new(4, Stream::Samples);
        let states: Vec<_> = (0..n).map(|_| space.sample(&mut random)).collect();
        let asked: Vec<_> = (0..400).map(|_| space.sample(&mut random)).collect();
        let (linear, _) = build(LinearScan::default(), &space, &states);
        let (tree, mut built) = build(KdTree::default(), &space, &states);
        for _ in 1..BUILDS {
            built = built.min(build(KdTree::default(), &space, &states).1);
        }
        let mut peer = MutableKdTree::<f64, N>::default();
        let mut grown = f64::INFINITY;
        for _ in 0..BUILDS {
            peer = MutableKdTree::default();
            let began = Instant::now();
            for (i, state) in states.iter().enumerate() {
                peer.add(&moved(state), i as u32).expect("a tree that splits");
            }
            grown = grown.min(began.elapsed().as_secs_f64() * 1e3);
        }
        let of_peer = |from: &[f64; N], k: usize| {
            let (from, most) = (moved(from), NonZero::new(k).expect("a neighbour"));
            let query = peer.query(&from);
            match (wraps, k) {
                (false, 1) => vec![query.nearest_one::<SquaredEuclidean<f64>>().execute()],
                (false, _) => query.nearest_n::<SquaredEuclidean<f64>>(most).execute(),
                (true, 1) => {
                    let query = query.periodic_boundary_condition(&periods);
                    vec![query.nearest_one::<SquaredEuclidean<f64>>().execute()]
                }
                (true, _) => {
                    let query = query.periodic_boundary_condition(&periods);
                    query.nearest_n::<SquaredEuclidean<f64>>(most).execute()
                }
            }
        };
        let mut exact = Vec::new();
        let times = [1, 10].map(|k| {
            for from in &asked {
                tree.k_nearest(Query::to(&space, &states, from), k, &mut exact);
                let theirs = of_peer(from, k);
                assert_eq!(theirs.len(), k);
                for (ours, theirs) in exact.iter().zip(&theirs) {
                    let (ours, theirs) = (ours.distance, theirs.distance.sqrt());
                    assert!((ours - theirs).abs() < 1e-12, "{name}, n = {n}, k = {k}: {ours} and {theirs}");
                }
            }
            [
                time(&tree, &space, &states, &asked, k),
                median(&asked, |from| drop(black_box(of_peer(from, k)))),
                time(&linear, &space, &states, &asked[..(4_000_000 / n).min(asked.len())], k),
            ]
        });
        let [ours, theirs, scan] = [0, 1, 2].map(|i| times.map(|of_k| format!("{:.2}", of_k[i])).join(", "));
        let [built, grown] = [built, grown].map(|ms| ms * 1e6 / n as f64);
        print!("| {name} | {n} | {built:.0} | {grown:.0} | {ours} | {theirs} | {scan} ");
        if n > MOST_IN_FOREST {
            println!("| | | |");
            continue;
        }
        let key = Random::new(4, Stream::Projections).bits();
        let (forest, planted) = build(Forest::new(ForestParameters::default(), key), &space, &states);
        let guess = [1, 10].map(|k| format!("{:.1}", time(&forest, &space, &states, &asked, k))).join(", ");
        println!(
            "| {:.0} | {guess} | {:.2} |",
            planted * 1e6 / n as f64,
            recalled(&forest, &tree, &space, &states, &asked, 10)
        );
    }
}

/// The time to build a kd-tree, in the order of the samples and in that of a coordinate, the worst for its balance.
fn building() {
    let space = ProductSpace::<4>::new(&[Coordinate::Circle; 4], Metric::Sum);
    println!("\nThe kd-tree of the 4-torus built by insertion, ms\n\n| n | random | increasing |\n|---|---|---|");
    for n in [10_000, 100_000, 1_000_000] {
        let mut random = Random::new(3, Stream::Samples);
        let mut states: Vec<_> = (0..n).map(|_| space.sample(&mut random)).collect();
        let scattered = build(KdTree::default(), &space, &states).1;
        states.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let increasing = build(KdTree::default(), &space, &states).1;
        println!("| {n} | {scattered:.1} | {increasing:.1} |");
    }
}

/// The least n, in steps of a quarter, from which on the kd-tree is faster up to three times as many states.
fn crossovers<const N: usize>() {
    let space = ProductSpace::<N>::new(&[Coordinate::Circle; N], Metric::Sum);
    let mut random = Random::new(2, Stream::Samples);
    let asked: Vec<_> = (0..400).map(|_| space.sample(&mut random)).collect();
    let mut row = format!("| {N} |");
    for k in [1, 3, 10, 30, 100] {
        let (mut n, mut from, mut wins) = (32, 0, 0);
        while wins < 5 && n < 40_000 {
            let states: Vec<_> = (0..n).map(|_| space.sample(&mut random)).collect();
            let (linear, _) = build(LinearScan::default(), &space, &states);
            let (tree, _) = build(KdTree::default(), &space, &states);
            let is_faster = time(&tree, &space, &states, &asked, k) < time(&linear, &space, &states, &asked, k);
            wins = if is_faster { wins + 1 } else { 0 };
            from = if wins == 1 { n } else { from };
            n += n / 4;
        }
        row += &format!(" {from} |");
    }
    println!("{row}");
}

fn rows<const N: usize>() {
    let space = ProductSpace::<N>::new(&[Coordinate::Circle; N], Metric::Sum);
    for n in [1_000, 10_000, 100_000] {
        let mut random = Random::new(1, Stream::Samples);
        let states: Vec<_> = (0..n).map(|_| space.sample(&mut random)).collect();
        let asked: Vec<_> = (0..1000).map(|_| space.sample(&mut random)).collect();
        let key = Random::new(1, Stream::Projections).bits();
        let (linear, _) = build(LinearScan::default(), &space, &states);
        let (tree, built) = build(KdTree::default(), &space, &states);
        let (index, _) = build(Index::default(), &space, &states);
        let (forest, planted) = build(Forest::new(ForestParameters::default(), key), &space, &states);
        for k in [1, 10, 30] {
            let scan = time(&linear, &space, &states, &asked[..(10_000_000 / n).min(1000)], k);
            let search = time(&tree, &space, &states, &asked, k);
            let either = time(&index, &space, &states, &asked, k);
            let guess = time(&forest, &space, &states, &asked[..200], k);
            let part = recalled(&forest, &tree, &space, &states, &asked[..200], k);
            print!("| {N} | {n} | {k} | {scan:.2} | {search:.2} | {either:.2} ");
            println!("| {guess:.2} | {part:.3} | {built:.2}, {planted:.1} |");
        }
    }
}

/// The mean share of the nearest that the forest finds.
fn recalled<S: Space>(
    forest: &Forest,
    tree: &KdTree,
    space: &S,
    states: &[S::State],
    asked: &[S::State],
    k: usize,
) -> f64 {
    let (mut found, mut exact, mut sum) = (Vec::new(), Vec::new(), 0.0);
    for from in asked {
        forest.k_nearest(Query::to(space, states, from), k, &mut found);
        tree.k_nearest(Query::to(space, states, from), k, &mut exact);
        sum += recall(&found, &exact);
    }
    sum / asked.len() as f64
}

fn build<S: Space, I: Nearest<S>>(mut index: I, space: &S, states: &[S::State]) -> (I, f64) {
    let began = Instant::now();
    for (i, state) in states.iter().enumerate() {
        index.insert(space, VertexId(i as u32), state);
    }
    (index, began.elapsed().as_secs_f64() * 1e3)
}

/// Microseconds per query of an index.
fn time<S: Space>(index: &impl Nearest<S>, space: &S, states: &[S::State], asked: &[S::State], k: usize) -> f64 {
    let mut found: Vec<Neighbour> = Vec::new();
    median(asked, |state| {
        index.k_nearest(Query::to(space, states, state), k, &mut found);
        black_box(&found);
    })
}

/// Microseconds per query: the median over short runs, of which another process disturbs only some.
fn median<T>(asked: &[T], mut query: impl FnMut(&T)) -> f64 {
    let mut times = Vec::new();
    for _ in 0..5 {
        for some in asked.chunks(40) {
            let began = Instant::now();
            some.iter().for_each(&mut query);
            times.push(began.elapsed().as_secs_f64() * 1e6 / some.len() as f64);
        }
    }
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
