//! What it costs to prove the edge of an arm free: the edges of k-PRM roadmaps (k = 30) in generated worlds, nanoseconds an
//! edge. "mixed" is in the order in which the roadmap asks, the others are grouped by outcome, which flatters branch
//! prediction.
//!
//! `cargo bench --bench proof`; a run pinned to one core is quieter. `-- forests`, `-- many` run one table alone.

use planarium::collision::{ArmValidity, Sampled};
use planarium::problem::Validity;
use planarium::random::{Random, Stream};
use planarium::robot::joint_space;
use planarium::scenario::{Obstacle, Robot, Scenario};
use planarium::space::{Metric, ProductSpace, Space};
use std::hint::black_box;
use std::time::Instant;

/// Neighbours a vertex.
const K: usize = 30;
/// Passes over the edges, of which the quickest counts: the one that others disturbed least.
const PASSES: usize = 15;
/// Looks an edge of the check that proves nothing.
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

fn row(name: &str, worlds: &[Scenario], samples: usize) {
    println!("| {name} | {}", measure::<4>(worlds, samples));
}

/// An edge of a roadmap.
type Edge<const N: usize> = ([f64; N], [f64; N]);

fn measure<const N: usize>(worlds: &[Scenario], samples: usize) -> String {
    let mut total = [[0.0; 3]; 2];
    let mut counts = [0usize; 2];
    for (seed, world) in worlds.iter().enumerate() {
        let Robot::Arm(arm) = world.robot() else { unreachable!("all these worlds have arms") };
        let space = joint_space::<N>(arm, Metric::Sum);
        let validity = ArmValidity::new(arm, space.clone(), world.world(), 1e-4);
        let unproven = ArmValidity::new(arm, space.clone(), world.world(), 1e-4);
        let sampled = Sampled::new(space.clone(), Box::new(unproven), LOOKS);
        let edges = edges(&space, &validity, samples, seed as u64);
        let (free, refused): (Vec<_>, Vec<_>) = edges.iter().copied().partition(|(a, b)| validity.is_motion_free(a, b));
        counts[0] += edges.len();
        counts[1] += free.len();
        for (group, edges) in [&edges, &free, &refused].into_iter().enumerate() {
            total[0][group] += nanoseconds(edges, |a, b| validity.is_motion_free(a, b));
            total[1][group] += nanoseconds(edges, |a, b| sampled.is_motion_free(a, b));
        }
    }
    let of = [counts[0], counts[1], counts[0] - counts[1]].map(|count| count as f64);
    let each = total.map(|ns| [0, 1, 2].map(|group| ns[group] / of[group]));
    format!(
        "{} | {} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} | {:.1} |",
        counts[0],
        counts[1],
        each[0][0],
        each[0][1],
        each[0][2],
        each[1][0],
        each[1][1],
        each[1][2],
        each[1][0] / each[0][0]
    )
}

/// The least over all passes of the time that all edges take, in nanoseconds.
fn nanoseconds<const N: usize>(edges: &[Edge<N>], check: impl Fn(&[f64; N], &[f64; N]) -> bool) -> f64 {
    let pass = |_| {
        let began = Instant::now();
        black_box(edges.iter().filter(|(a, b)| check(a, b)).count());
        began.elapsed().as_secs_f64() * 1e9
    };
    (0..PASSES).map(pass).fold(f64::INFINITY, f64::min)
}

/// The pairs of free samples that a k-PRM tries, in its order.
fn edges<const N: usize>(
    space: &ProductSpace<N>,
    validity: &ArmValidity<N>,
    samples: usize,
    seed: u64,
) -> Vec<Edge<N>> {
    let mut random = Random::new(seed, Stream::Samples);
    let mut states = Vec::new();
    for _ in 0..1_000_000 {
        let state = space.sample(&mut random);
        if validity.is_free(&state) {
            states.push(state);
        }
        if states.len() == samples {
            break;
        }
    }
    let mut tried = std::collections::BTreeSet::new();
    let mut edges = Vec::new();
    for (i, a) in states.iter().enumerate() {
        let mut others: Vec<usize> = (0..states.len()).filter(|&j| j != i).collect();
        others
            .sort_by(|&j, &k| space.distance(a, &states[j]).total_cmp(&space.distance(a, &states[k])).then(j.cmp(&k)));
        for &j in others.iter().take(K) {
            if tried.insert((i.min(j), i.max(j))) {
                edges.push((*a, states[j]));
            }
        }
    }
    edges
}

/// A forest whose arm has links of the given radius.
fn forest(links: usize, seed: u64, radius: f64) -> Scenario {
    let options = serde_json::json!({ "links": links, "seed": seed });
    let forest = planarium::scenario::generate::generate("forest", &options).expect("a forest can be generated");
    let of = |obstacle: &Obstacle| match obstacle {
        Obstacle::Polygon(polygon) => polygon.vertices().iter().map(|p| [p.x, p.y]).collect(),
        Obstacle::Disc(_) => unreachable!("forests are of triangles"),
    };
    document(&forest.world().obstacles.iter().map(of).collect::<Vec<_>>(), &vec![1.0; links], radius)
}

fn document(polygons: &[Vec<[f64; 2]>], links: &[f64], radius: f64) -> Scenario {
    let polygon = |corners| serde_json::json!({ "type": "polygon", "vertices": corners });
    let obstacles: Vec<_> = polygons.iter().map(polygon).collect();
    let document = serde_json::json!({
        "format": "planarium-scenario-1", "name": "bench", "world": { "obstacles": obstacles },
        "robot": { "type": "arm", "base": [0, 0], "links": links, "radius": radius }, "queries": [],
    });
    Scenario::parse(&document.to_string()).expect("the document is right")
}

/// So many triangles anywhere in the reach of an arm of four links, together as large as sixteen of the forest.
fn triangles(count: usize) -> Scenario {
    let size = 2.0 / (count as f64).sqrt();
    let mut random = Random::new(1, Stream::Scenario);
    let mut polygons = Vec::new();
    while polygons.len() < count {
        let [x, y] = [(); 2].map(|()| random.uniform() * 8.0 - 4.0);
        if x * x + y * y > 0.3 {
            polygons.push(vec![[x, y], [x + size, y], [x + size / 2.0, y + size]]);
        }
    }
    document(&polygons, &[1.0; 4], 0.0)
}
