//! The cost of proving a motion of a body free: a rectangle in random clutter, nanoseconds a motion, grouped by outcome.
//! "distances" is the simple variant of the proof; "sampled" checks every hundredth of the longer side of the bounds and proves
//! nothing.
//!
//! `cargo bench --bench body`; a run pinned to one core is quieter. `-- 0.3` runs motions of that length alone, `-- proof` the fast
//! proof alone.

use planarium::collision::{BodyCollision, BodyMotion};
use planarium::geometry::{Aabb, Point, Polygon};
use planarium::random::{Random, Stream};
use planarium::scenario::{Obstacle, World};
use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::time::Instant;

/// Passes over the motions, of which the fastest counts: the least disturbed one.
const PASSES: usize = 9;
/// Motions in each world.
const MOTIONS: usize = 1000;
/// The distance between the samples of the check that proves nothing, in metres and in radians alike.
const RESOLUTION: f64 = 0.01;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let only = arguments.iter().find(|argument| *argument != "proof");
    let is_alone = arguments.iter().any(|argument| argument == "proof");
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
        if only.is_some_and(|only| *only != format!("{length}")) {
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

/// The least over all passes of the time that all motions take, in nanoseconds.
fn nanoseconds(motions: &[BodyMotion], passes: usize, check: impl Fn(&BodyMotion) -> bool) -> f64 {
    let pass = |_| {
        let began = Instant::now();
        black_box(motions.iter().filter(|motion| check(motion)).count());
        began.elapsed().as_secs_f64() * 1e9
    };
    (0..passes).map(pass).fold(f64::INFINITY, f64::min)
}

/// Samples from coarse to fine, like `Sampled`.
fn are_samples_free(collision: &BodyCollision, motion: &BodyMotion) -> bool {
    let (a, b) = (motion.at(0.0), motion.at(1.0));
    let length = ((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])).sqrt() + 0.1 * (b[2] - a[2]).abs();
    let looks = (length / RESOLUTION).ceil().max(1.0) as u32;
    (0..=looks.ilog2()).rev().all(|level| {
        (1u32 << level..=looks)
            .step_by(2 << level)
            .all(|i| collision.is_free(&motion.at(f64::from(i) / f64::from(looks))))
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

/// Polygons anywhere in the unit square, of the same total size whatever their number; every other one concave if wanted.
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
