//! Nearest neighbours on toruses: median microseconds per query of the linear scan, the kd-tree and the approximate index.
//!
//! `cargo bench --bench nearest`; a run pinned to one core is quieter.

use planarium::graph::VertexId;
use planarium::nearest::{Forest, ForestParameters, Index, KdTree, LinearScan, Nearest, Neighbour, recall};
use planarium::random::{Random, Stream};
use planarium::space::{Coordinate, Metric, ProductSpace, Space};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    println!("Microseconds per query; the approximate index with its recall\n");
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
            let (mut found, mut exact, mut part) = (Vec::new(), Vec::new(), 0.0);
            for from in &asked[..200] {
                forest.k_nearest(&space, &states, from, k, &mut found);
                tree.k_nearest(&space, &states, from, k, &mut exact);
                part += recall(&found, &exact) / 200.0;
            }
            print!("| {N} | {n} | {k} | {scan:.2} | {search:.2} | {either:.2} ");
            println!("| {guess:.2} | {part:.3} | {built:.2}, {planted:.1} |");
        }
    }
}

fn build<S: Space, I: Nearest<S>>(mut index: I, space: &S, states: &[S::State]) -> (I, f64) {
    let began = Instant::now();
    for (i, state) in states.iter().enumerate() {
        index.insert(space, VertexId(i as u32), state);
    }
    (index, began.elapsed().as_secs_f64() * 1e3)
}

/// Microseconds per query: the median over short runs, of which another process disturbs only some.
fn time<S: Space>(index: &impl Nearest<S>, space: &S, states: &[S::State], asked: &[S::State], k: usize) -> f64 {
    let mut found: Vec<Neighbour> = Vec::new();
    let mut times = Vec::new();
    for _ in 0..5 {
        for some in asked.chunks(40) {
            let began = Instant::now();
            for state in some {
                index.k_nearest(space, states, state, k, &mut found);
                black_box(&found);
            }
            times.push(began.elapsed().as_secs_f64() * 1e6 / some.len() as f64);
        }
    }
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
