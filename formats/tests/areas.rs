//! Areas whose rings cross: what is filled is compared, at random points, with a count of the rings about each.

use crate::documents::deep;
use crate::files::{Random, file, free};
use planarium::geometry::{Point, Segment, distance_point_segment};
use planarium_formats::{Code, Options, World, read};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// How often the ring goes about the point, counter-clockwise; the point is on none of its edges.
fn winding(ring: &[[f64; 2]], [x, y]: [f64; 2]) -> i32 {
    let next = ring.iter().cycle().skip(1);
    ring.iter()
        .zip(next)
        .map(|(a, b)| {
            let is_left = (b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1]) > 0.0;
            match (a[1] <= y, b[1] <= y) {
                (true, false) if is_left => 1,
                (false, true) if !is_left => -1,
                _ => 0,
            }
        })
        .sum()
}

/// The distance to the nearest edge of rings.
fn distance(rings: &[Vec<[f64; 2]>], p: [f64; 2]) -> f64 {
    let point = |[x, y]: [f64; 2]| Point::new(x, y);
    let edges = rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    edges
        .map(|(&a, &b)| distance_point_segment(point(p), &Segment::new(point(a), point(b))))
        .fold(f64::INFINITY, f64::min)
}

/// A ring of random corners: whole numbers of a few, so that corners and edges meet often; or any.
fn ring(random: &mut Random, is_whole: bool) -> Vec<[f64; 2]> {
    let mut number = || if is_whole { random.below(7) as f64 } else { 7.0 * random.unit() };
    let first = [number(), number()];
    let count = 3 + (number() as usize) * 2;
    std::iter::once(first).chain((1..count).map(|_| [number(), number()])).collect()
}

fn polygon(rings: &[Vec<[f64; 2]>]) -> String {
    let mut text = "POLYGON (".to_owned();
    for (i, ring) in rings.iter().enumerate() {
        text += if i == 0 { "(" } else { ", (" };
        for [x, y] in ring.iter().chain(&ring[..1]) {
            write!(text, "{}{x} {y}", if text.ends_with('(') { "" } else { ", " }).expect("memory");
        }
        text.push(')');
    }
    text + ")"
}

fn building(ring: &[[f64; 2]]) -> String {
    let mut text = "coordinate_system: cartesian_meters\nlevels:\n  L1:\n    vertices:\n".to_owned();
    ring.iter().for_each(|[x, y]| writeln!(text, "      - [{x}, {y}, 0, \"\"]").expect("memory"));
    let numbers: Vec<String> = (0..ring.len()).map(|number| number.to_string()).collect();
    text + &format!("    floors:\n      - {{vertices: [{}]}}\n", numbers.join(", "))
}

/// Compares a world with what is filled, at random points that are not on an edge, and at the middles of edges, which
/// belong to the area.
fn agrees(world: &World, rings: &[Vec<[f64; 2]>], is_blocked: impl Fn([f64; 2]) -> bool, random: &mut Random) {
    for _ in 0..40 {
        let p = [random.unit() * 8.0 - 0.5, random.unit() * 8.0 - 0.5];
        if distance(rings, p) > 1e-9 {
            assert_eq!(!free(world, p), is_blocked(p), "{p:?} of {rings:?}");
        }
    }
    for ring in rings {
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let middle = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
            // That of whole numbers is exact.
            let is_exact = [a, b].iter().all(|p| p[0].fract() == 0.0 && p[1].fract() == 0.0);
            assert!(!is_exact || !free(world, middle), "{middle:?} of {rings:?}");
        }
    }
}

#[test]
fn crossing_rings_are_filled_by_their_rule() {
    let count = if deep() { 20_000 } else { 400 };
    let mut random = Random(77);
    for i in 0..count {
        let is_whole = i % 3 > 0;
        let rings: Vec<_> = (0..1 + random.below(3)).map(|_| ring(&mut random, is_whole)).collect();
        let even_odd = Options { walkable: Some(false), ..Options::default() };
        let text = polygon(&rings);
        match read(&[file("a.wkt", &text)], &even_odd) {
            Ok(world) => {
                assert!(world.report.grown < 1e-10);
                let is_blocked = |p| rings.iter().map(|ring| winding(ring, p)).sum::<i32>() % 2 != 0;
                agrees(&world, &rings, is_blocked, &mut random);
            }
            Err(error) => panic!("{error}: {text}"),
        }
        let nonzero = Options { layers: Some(vec!["floors".to_owned()]), ..Options::default() };
        let world = read(&[file("a.yaml", &building(&rings[0]))], &nonzero).unwrap_or_else(|error| panic!("{error}"));
        agrees(&world, &rings[..1], |p| winding(&rings[0], p) != 0, &mut random);
    }
}

#[test]
fn walkable_areas_are_united() {
    let count = if deep() { 10_000 } else { 200 };
    let mut random = Random(78);
    for i in 0..count {
        let is_whole = i % 3 > 0;
        let rings: Vec<_> = (0..1 + random.below(4)).map(|_| ring(&mut random, is_whole)).collect();
        let text: String = rings.iter().map(|ring| polygon(std::slice::from_ref(ring)) + "\n").collect();
        let options = Options { walkable: Some(true), ..Options::default() };
        let world = read(&[file("a.wkt", &text)], &options).unwrap_or_else(|error| panic!("{error}: {text}"));
        for _ in 0..40 {
            let p = [random.unit() * 8.0 - 0.5, random.unit() * 8.0 - 0.5];
            let bounds = world.scenario.world().bounds.expect("bounds");
            if distance(&rings, p) > 1e-9 && bounds.contains(Point::new(p[0], p[1])) {
                let is_free = rings.iter().any(|ring| winding(ring, p) % 2 != 0);
                assert_eq!(free(&world, p), is_free, "{p:?}: {text}");
            }
        }
    }
}

#[test]
fn many_corners_take_little_time_and_too_many_crossings_are_refused() {
    let started = Instant::now();
    let circle = |count: usize, step: usize| -> Vec<[f64; 2]> {
        let angle = |i: usize| (i * step % count) as f64 * std::f64::consts::TAU / count as f64;
        (0..count).map(|i| [100.0 * angle(i).cos(), 100.0 * angle(i).sin()]).collect()
    };
    let options = Options { walkable: Some(false), ..Options::default() };
    let simple = read(&[file("a.wkt", &polygon(&[circle(50_000, 1)]))], &options).expect("a circle");
    assert_eq!((simple.report.obstacles.vertices, simple.report.grown), (50_000, 0.0));
    // A star whose edges cross each other all.
    let star = polygon(&[circle(5_001, 2_500)]);
    crate::files::refused(&[file("a.wkt", &star)], &options, Code::WorldTooLarge);
    let small = read(&[file("a.wkt", &polygon(&[circle(101, 50)]))], &options).expect("a star");
    assert!(small.report.obstacles.polygons > 100, "{}", small.report);
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
}
