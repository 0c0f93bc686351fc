//! The cost of proving an edge of an arm free: the edges of k-PRM roadmaps (k = 30) in generated worlds, nanoseconds an
//! edge. "mixed" is in the order in which the roadmap tries them, the others are grouped by outcome, which flatters branch
//! prediction.
//!
//! `cargo bench --bench proof`; a run pinned to one core is quieter. `-- forests`, `-- many` run one table alone.

use planarium::collision::{ArmValidity, Sampled};
use planarium::graph::VertexId;
use planarium::nearest::{LinearScan, Nearest};
use planarium::problem::Validity;
use planarium::random::{Random, Stream};
use planarium::robot::joint_space;
use planarium::scenario::{Robot, Scenario, generate::generate};
use planarium::space::{Metric, ProductSpace, Space};
use serde_json::{Value as Json, json};
use std::collections::BTreeSet;
use std::hint::black_box;
use std::time::Instant;

/// Neighbours of a vertex.
const K: usize = 30;
/// Passes over the edges, of which the fastest counts: the least disturbed one.
const PASSES: usize = 15;
/// Samples along an edge of the check that proves nothing.
const LOOKS: u32 = 20;

fn main() {
    let only = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let wanted = |table: &str| only.as_ref().is_none_or(|only| only == table);
    println!("| world | edges | free | mixed ns | free ns | refused ns | sampled mixed | free | refused | ratio |");
    println!("|---|---|---|---|---|---|---|---|---|---|");
    if wanted("forests") {
        for radius in [0.0, 0.05] {
            for links in [2, 3, 4] {
                let worlds: Vec<Scenario> = (0..5).map(|seed| forest(links, seed, radius)).collect();
                row(&format!("forest {links}R, radius {radius}"), &worlds, 300 * links - 200);
            }
        }
    }
    if wanted("many") {
        for count in [16, 64, 256, 1024, 4096] {
            row(&format!("{count} triangles, 4R"), &[triangles(count)], 700);
        }
    }
}

/// An edge of a roadmap.
type Edge = ([f64; 4], [f64; 4]);

fn row(name: &str, worlds: &[Scenario], samples: usize) {
    let mut total = [[0.0; 3]; 2];
    let mut counts = [0; 3];
    for (seed, world) in worlds.iter().enumerate() {
        let Robot::Arm(arm) = world.robot() else { unreachable!("all these worlds have arms") };
        let space = joint_space::<4>(arm, Metric::Sum);
        let [validity, unproven] = [(); 2].map(|()| ArmValidity::new(arm, space.clone(), world.world(), 1e-4));
        let sampled = Sampled::new(space.clone(), Box::new(unproven), LOOKS);
        let edges = edges(&space, &validity, samples, seed as u64);
        let (free, refused): (Vec<_>, Vec<_>) = edges.iter().copied().partition(|(a, b)| validity.is_motion_free(a, b));
        for (group, edges) in [&edges, &free, &refused].into_iter().enumerate() {
            counts[group] += edges.len();
            total[0][group] += nanoseconds(edges, |a, b| validity.is_motion_free(a, b));
            total[1][group] += nanoseconds(edges, |a, b| sampled.is_motion_free(a, b));
        }
    }
    print!("| {name} | {} | {} |", counts[0], counts[1]);
    let each = total.map(|ns| [0, 1, 2].map(|group| ns[group] / counts[group] as f64));
    each.as_flattened().iter().for_each(|ns| print!(" {ns:.0} |"));
    println!(" {:.1} |", each[1][0] / each[0][0]);
}

/// The least over all passes of the time that all edges take, in nanoseconds.
fn nanoseconds(edges: &[Edge], check: impl Fn(&[f64; 4], &[f64; 4]) -> bool) -> f64 {
    let pass = |_| {
        let began = Instant::now();
        black_box(edges.iter().filter(|(a, b)| check(a, b)).count());
        began.elapsed().as_secs_f64() * 1e9
    };
    (0..PASSES).map(pass).fold(f64::INFINITY, f64::min)
}

/// The pairs of free samples that a k-PRM tries, in its order.
fn edges(space: &ProductSpace<4>, validity: &ArmValidity<4>, samples: usize, seed: u64) -> Vec<Edge> {
    let mut random = Random::new(seed, Stream::Samples);
    let draws = (0..1_000_000).map(|_| space.sample(&mut random));
    let states: Vec<_> = draws.filter(|state| validity.is_free(state)).take(samples).collect();
    let mut index = LinearScan::default();
    states.iter().enumerate().for_each(|(i, &state)| index.insert(space, VertexId(i as u32), state));
    let (mut near, mut tried, mut edges) = (Vec::new(), BTreeSet::new(), Vec::new());
    for (i, a) in states.iter().enumerate() {
        // The nearest is the vertex itself.
        index.k_nearest(space, a, K + 1, &mut near);
        for j in near.iter().map(|neighbour| neighbour.vertex.0 as usize).filter(|&j| j != i) {
            if tried.insert((i.min(j), i.max(j))) {
                edges.push((*a, states[j]));
            }
        }
    }
    edges
}

/// A forest whose arm has links of the given radius.
fn forest(links: usize, seed: u64, radius: f64) -> Scenario {
    let forest = generate("forest", &json!({ "links": links, "seed": seed })).expect("a forest can be generated");
    let mut document: Json = serde_json::from_str(&forest.to_json_string()).expect("a document");
    document["robot"]["radius"] = json!(radius);
    Scenario::parse(&document.to_string()).expect("a thicker arm")
}

/// That many triangles anywhere within the reach of an arm of four links, together as large as sixteen of the forest.
fn triangles(count: usize) -> Scenario {
    let size = 2.0 / (count as f64).sqrt();
    let mut random = Random::new(1, Stream::Scenario);
    let mut obstacles = Vec::new();
    while obstacles.len() < count {
        let [x, y] = [(); 2].map(|()| random.uniform() * 8.0 - 4.0);
        if x * x + y * y > 0.3 {
            let corners = [[x, y], [x + size, y], [x + size / 2.0, y + size]];
            obstacles.push(json!({ "type": "polygon", "vertices": corners }));
        }
    }
    let document = json!({
        "format": "planarium-scenario-1", "name": "bench", "world": { "obstacles": obstacles },
        "robot": { "type": "arm", "base": [0, 0], "links": [1, 1, 1, 1] }, "queries": [],
    });
    Scenario::parse(&document.to_string()).expect("the document is right")
}
