//! The cost of proving a motion free, in nanoseconds.
//!
//! Of arms: the edges of k-PRM roadmaps (k = 30) in generated worlds. "mixed" is in the order in which the roadmap tries them, the
//! others are grouped by outcome, which flatters branch prediction. Of bodies: a rectangle in random clutter, grouped by outcome;
//! "distances" is the simple variant of the proof. "sampled" checks samples and proves nothing.
//!
//! Of corners: a jagged floor as one polygon and as its convex pieces, for a point, a disc, an arm and a body.
//!
//! `cargo bench --bench proof`; a run pinned to one core is quieter. `-- forests`, `-- many`, `-- bodies`, `-- corners`
//! run one table alone; `-- bodies 0.3` runs motions of that length alone, `-- bodies proof` the fast proof alone.

use planarium::collision::{ArmValidity, BodyCollision, BodyMotion, CollisionWorld, DiscValidity};
use planarium::geometry::{Aabb, Point, Polygon};
use planarium::graph::VertexId;
use planarium::nearest::{LinearScan, Nearest, Query};
use planarium::problem::{Sampled, Samples, Validity};
use planarium::random::{Random, Stream};
use planarium::robot::{Arm, DiscRobot, joint_space};
use planarium::scenario::{Obstacle, Robot, Scenario, World, generate::generate};
use planarium::space::{Metric, ProductSpace, Space};
use serde_json::{Value as Json, json};
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::time::Instant;

/// Neighbours of a vertex.
const K: usize = 30;
/// Passes over the motions, of which the fastest counts: the least disturbed one.
const PASSES: usize = 15;
/// Samples along the edge of an arm for the check that proves nothing.
const SAMPLES: u32 = 20;
/// Motions of a body in each world.
const MOTIONS: usize = 1000;
/// The distance between the samples of a body, in metres and in radians alike.
const RESOLUTION: f64 = 0.01;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let wanted = |table: &str| arguments.first().is_none_or(|first| first == table);
    if wanted("forests") || wanted("many") {
        println!("| world | edges | free | mixed ns | free ns | refused ns | sampled mixed | free | refused | ratio |");
        println!("|---|---|---|---|---|---|---|---|---|---|");
    }
    if wanted("forests") {
        for radius in [0.0, 0.05] {
            for links in [2, 3, 4] {
                let worlds: Vec<Scenario> = (0..5).map(|seed| forest(links, seed, radius)).collect();
                arms(&format!("forest {links}R, radius {radius}"), &worlds, 300 * links - 200);
            }
        }
    }
    if wanted("many") {
        for count in [16, 64, 256, 1024, 4096] {
            arms(&format!("{count} triangles, 4R"), &[triangles(count)], 700);
        }
    }
    if wanted("bodies") {
        let options = arguments.get(1..).unwrap_or_default();
        bodies(options.iter().find_map(|option| option.parse().ok()), options.iter().any(|option| option == "proof"));
    }
    if wanted("corners") {
        corners();
    }
}

/// The least over all passes of the time that checking all motions takes, in nanoseconds.
fn nanoseconds<M>(motions: &[M], passes: usize, check: impl Fn(&M) -> bool) -> f64 {
    let pass = |_| {
        let began = Instant::now();
        black_box(motions.iter().filter(|motion| check(motion)).count());
        began.elapsed().as_secs_f64() * 1e9
    };
    (0..passes).map(pass).fold(f64::INFINITY, f64::min)
}

/// An edge of a roadmap.
type Edge = ([f64; 4], [f64; 4]);

/// Prints the row of arms in these worlds.
fn arms(name: &str, worlds: &[Scenario], samples: usize) {
    let mut total = [[0.0; 3]; 2];
    let mut counts = [0; 3];
    for (seed, world) in worlds.iter().enumerate() {
        let Robot::Arm(arm) = world.robot() else { unreachable!("all these worlds have arms") };
        let space = joint_space::<4>(arm, Metric::Sum);
        let [validity, unproven] = [(); 2].map(|()| ArmValidity::new(arm, space.clone(), world.world(), 1e-4));
        let sampled = Sampled::new(space.clone(), Box::new(unproven), Samples::Count(SAMPLES));
        let edges = edges(&space, &validity, samples, seed as u64);
        let (free, refused): (Vec<_>, Vec<_>) = edges.iter().copied().partition(|(a, b)| validity.is_motion_free(a, b));
        for (group, edges) in [&edges, &free, &refused].into_iter().enumerate() {
            counts[group] += edges.len();
            total[0][group] += nanoseconds(edges, PASSES, |(a, b)| validity.is_motion_free(a, b));
            total[1][group] += nanoseconds(edges, PASSES, |(a, b)| sampled.is_motion_free(a, b));
        }
    }
    print!("| {name} | {} | {} |", counts[0], counts[1]);
    let each = total.map(|ns| [0, 1, 2].map(|group| ns[group] / counts[group] as f64));
    each.as_flattened().iter().for_each(|ns| print!(" {ns:.0} |"));
    println!(" {:.1} |", each[1][0] / each[0][0]);
}

/// The pairs of free samples that a k-PRM tries, in its order.
fn edges(space: &ProductSpace<4>, validity: &ArmValidity<4>, samples: usize, seed: u64) -> Vec<Edge> {
    let mut random = Random::new(seed, Stream::Samples);
    let draws = (0..1_000_000).map(|_| space.sample(&mut random));
    let states: Vec<_> = draws.filter(|state| validity.is_free(state)).take(samples).collect();
    let mut index = LinearScan::default();
    states.iter().enumerate().for_each(|(i, state)| index.insert(space, VertexId(i as u32), state));
    let (mut near, mut tried, mut edges) = (Vec::new(), BTreeSet::new(), Vec::new());
    for (i, a) in states.iter().enumerate() {
        // The nearest is the vertex itself.
        index.k_nearest(Query::to(space, &states, a), K + 1, &mut near);
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

/// Prints the table of bodies, for one length of their motions or for all.
fn bodies(only: Option<f64>, is_alone: bool) {
    println!(
        "| motions | obstacles | body | length | free | pairs free | refused | proof free ns | refused | distances | | sampled | |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    let polygon = |corners: &[[f64; 2]]| {
        Polygon::new(&corners.iter().map(|&corner| corner.into()).collect::<Vec<_>>()).expect("a simple polygon")
    };
    let rectangle = polygon(&[[-0.05, -0.03], [0.05, -0.03], [0.05, 0.03], [-0.05, 0.03]]);
    let ell = polygon(&[[0.0, 0.0], [0.12, 0.0], [0.12, 0.03], [0.03, 0.03], [0.03, 0.1], [0.0, 0.1]]);
    for length in [0.1, 0.3, 1.0] {
        if only.is_some_and(|only| only != length) {
            continue;
        }
        for is_arc in [false, true] {
            let row = |name: &str, body: &Polygon, count: usize, is_concave: bool| {
                let kind = if is_arc { "arc" } else { "straight" };
                let measured = measure(body, (count, is_concave), (length, is_arc), is_alone);
                println!("| {kind} | {count} {name} | {length} | {measured}");
            };
            row("convex | rectangle", &rectangle, 16, false);
            row("mixed | rectangle", &rectangle, 16, true);
            row("convex | rectangle", &rectangle, 64, false);
            row("convex | rectangle", &rectangle, 256, false);
            row("convex | L", &ell, 16, false);
        }
    }
}

/// Prints the table of one polygon with many corners beside its pieces.
fn corners() {
    println!("| corners | robot | one polygon ns | pieces ns | ratio |");
    println!("|---|---|---|---|---|");
    for count in [50, 500, 5000] {
        let worlds = [true, false].map(|is_one| CollisionWorld::from(&skyline(count, is_one)));
        let mut random = Random::new(1, Stream::Samples);
        let mut pose = || [100.0 * random.uniform(), 100.0 * random.uniform(), TAU * random.uniform()];
        let motions: Vec<[[f64; 3]; 2]> = (0..MOTIONS)
            .map(|_| {
                let (from, by) = (pose(), pose());
                [from, [from[0] + 0.1 * by[0] - 5.0, from[1] + 0.1 * by[1] - 5.0, from[2] + 0.1 * by[2]]]
            })
            .collect();
        let row = |name: &str, ns: [f64; 2]| {
            let [one, pieces] = ns.map(|ns| ns / MOTIONS as f64);
            println!("| {count} | {name} | {one:.0} | {pieces:.0} | {:.2} |", one / pieces);
        };
        for (name, radius) in [("point", 0.0), ("disc", 0.5)] {
            let robot = DiscRobot::new(radius).expect("a radius");
            row(
                name,
                worlds.each_ref().map(|world| {
                    let disc = DiscValidity::new(&robot, world.clone());
                    nanoseconds(&motions, PASSES, |[a, b]| disc.is_motion_free(a, b))
                }),
            );
        }
        let arm = Arm::new(Point::new(50.0, 70.0), vec![20.0, 15.0, 10.0], 0.2, None).expect("an arm");
        row(
            "arm",
            worlds.each_ref().map(|world| {
                let arm = ArmValidity::<3>::new(&arm, joint_space(&arm, Metric::Sum), world.clone(), 1e-4);
                nanoseconds(&motions, PASSES, |[a, b]| arm.is_motion_free(&a.map(|x| x % TAU), &b.map(|x| x % TAU)))
            }),
        );
        let shape = [[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]].map(Point::from);
        let body = Polygon::new(&shape).expect("a rectangle");
        row(
            "body",
            worlds.each_ref().map(|world| {
                let body = BodyCollision::new(&body, world.clone(), 1e-4);
                nanoseconds(&motions, PASSES, |&[from, to]| {
                    body.is_motion_free(&BodyMotion::Straight { from, delta: [0, 1, 2].map(|i| to[i] - from[i]) })
                })
            }),
        );
        row(
            "clearance of a body",
            worlds.each_ref().map(|world| {
                let robot = BodyCollision::new(&body, world.clone(), 1e-4);
                nanoseconds(&motions, 1, |[from, _]| robot.clearance(from) > 1.0)
            }),
        );
    }
}

/// A jagged floor of this number of corners below a free sky, as one polygon or as its convex pieces.
fn skyline(count: usize, is_one: bool) -> World {
    let mut random = Random::new(1, Stream::Scenario);
    let mut top = |i: usize| {
        let y = if i.is_multiple_of(2) { 5.0 + 20.0 * random.uniform() } else { 20.0 + 40.0 * random.uniform() };
        Point::new(100.0 * i as f64 / count as f64, y)
    };
    let mut corners: Vec<Point> = (0..=count).map(&mut top).collect();
    let polygon = |corners: &[Point]| Obstacle::Polygon(Polygon::new(corners).expect("a simple polygon"));
    let foot = |p: Point| Point::new(p.x, -1.0);
    let obstacles = if is_one {
        corners.extend([Point::new(100.0, -1.0), Point::new(0.0, -1.0)]);
        vec![polygon(&corners)]
    } else {
        corners.windows(2).map(|pair| polygon(&[pair[0], pair[1], foot(pair[1]), foot(pair[0])])).collect()
    };
    let bounds = Aabb { min: Point::new(0.0, -2.0), max: Point::new(100.0, 100.0) };
    World { bounds: Some(bounds), obstacles: obstacles.into() }
}

/// The columns of a row, over five worlds.
fn measure(
    body: &Polygon,
    (count, is_concave): (usize, bool),
    (length, is_arc): (f64, bool),
    is_alone: bool,
) -> String {
    let (mut total, mut counts, mut pairs) = ([[0.0; 2]; 3], [0usize; 2], [0; 2]);
    for seed in 0..5 {
        let collision = BodyCollision::new(body, &clutter(count, is_concave, seed), 1e-4);
        let motions = motions(&collision, length, is_arc, seed);
        let groups: (Vec<_>, Vec<_>) = motions.iter().copied().partition(|motion| collision.is_motion_free(motion));
        for (group, motions) in [&groups.0, &groups.1].into_iter().enumerate() {
            counts[group] += motions.len();
            let before = collision.clearance_evaluations();
            motions.iter().for_each(|motion| _ = collision.is_motion_free(motion));
            pairs[group] += collision.clearance_evaluations() - before;
            total[0][group] += nanoseconds(motions, PASSES, |motion| collision.is_motion_free(motion));
            if !is_alone {
                let by_distances = |motion: &BodyMotion| collision.first_hit_by_distances(motion).is_none();
                total[1][group] += nanoseconds(motions, 1, by_distances);
                total[2][group] += nanoseconds(motions, PASSES, |motion| are_samples_free(&collision, motion));
            }
        }
    }
    // Not a number for an empty group.
    let of = |sum: f64, group: usize| if counts[group] == 0 { f64::NAN } else { sum / counts[group] as f64 };
    let mut columns = format!("{} of {} |", counts[0], counts[0] + counts[1]);
    [0, 1].iter().for_each(|&group| columns += &format!(" {:.1} |", of(pairs[group] as f64, group)));
    for each in &total[..if is_alone { 1 } else { 3 }] {
        [0, 1].iter().for_each(|&group| columns += &format!(" {:.0} |", of(each[group], group)));
    }
    columns
}

/// Samples from coarse to fine, like `Sampled`.
fn are_samples_free(collision: &BodyCollision, motion: &BodyMotion) -> bool {
    let (a, b) = (motion.at(0.0), motion.at(1.0));
    let length = ((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])).sqrt() + 0.1 * (b[2] - a[2]).abs();
    let samples = (length / RESOLUTION).ceil().max(1.0) as u32;
    (0..=samples.ilog2()).rev().all(|level| {
        (1u32 << level..=samples)
            .step_by(2 << level)
            .all(|i| collision.is_free(&motion.at(f64::from(i) / f64::from(samples))))
    })
}

/// Motions of this length from free placements: straight ones in any direction with a turn of up to a radian, or arcs of any radius.
fn motions(collision: &BodyCollision, length: f64, is_arc: bool, seed: u64) -> Vec<BodyMotion> {
    let mut random = Random::new(seed, Stream::Samples);
    let mut motions = Vec::new();
    while motions.len() < MOTIONS {
        let from = [random.uniform(), random.uniform(), TAU * random.uniform() - PI];
        let (direction, turn) = (TAU * random.uniform(), 2.0 * random.uniform() - 1.0);
        let (sin, cos) = direction.sin_cos();
        let motion = if is_arc {
            BodyMotion::Arc { from, speed: 0.5, turn_rate: turn / (2.0 * length), duration: 2.0 * length }
        } else {
            BodyMotion::Straight { from, delta: [length * cos, length * sin, turn] }
        };
        if collision.is_free(&from) && collision.is_free(&motion.at(1.0)) {
            motions.push(motion);
        }
    }
    motions
}

/// Polygons anywhere in the unit square, whose total size does not depend on their number; every other one concave if wanted.
fn clutter(count: usize, is_concave: bool, seed: u64) -> World {
    let mut random = Random::new(seed, Stream::Scenario);
    let size = 0.4 / (count as f64).sqrt();
    let obstacle = |i: usize| {
        let (center, turn) = (Point::new(random.uniform(), random.uniform()), TAU * random.uniform());
        let corners = 3 + random.below(4) as usize;
        let dents = is_concave && i.is_multiple_of(2);
        let all = if dents { 2 * corners } else { corners };
        let corner = |k: usize| {
            let (sin, cos) = (turn + TAU * k as f64 / all as f64).sin_cos();
            let radius = if dents && k % 2 == 1 { 0.4 * size } else { size };
            Point::new(center.x + radius * cos, center.y + radius * sin)
        };
        Obstacle::Polygon(Polygon::new(&(0..all).map(corner).collect::<Vec<_>>()).expect("a star is simple"))
    };
    let bounds = Aabb { min: Point::new(-0.1, -0.1), max: Point::new(1.1, 1.1) };
    World { bounds: Some(bounds), obstacles: (0..count).map(obstacle).collect() }
}
