//! The widest disc that passes: closed forms, the exact shortest path of narrower and wider discs, and certificates.

use crate::common::documents::{BODY, CAR, disc, disc_among, parse, polygon, reaching, rectangle, refuses, scenario};
use crate::common::{cases, seeds};
use planarium::certificate::{Options, Subdivision, Verdict};
use planarium::geometry::{Point, Vector};
use planarium::optimum::{Limit, MetricOptions, Widest, optimum, widest};
use planarium::problem::{Stepped, Touched};
use planarium::random::{Random, Stream};
use std::f64::consts::TAU;
use wasm_bindgen_test::wasm_bindgen_test;

pub const ROOM: &str = "[0, 0], [10, 10]";
const ACROSS: [[f64; 2]; 2] = [[1.0, 5.0], [9.0, 5.0]];

fn of(obstacles: &[String], ends: [[f64; 2]; 2]) -> Widest {
    widest(disc_among(ROOM, obstacles, 0.0, ends), None).unwrap_or_else(|error| panic!("{error}"))
}

pub fn wall(points: &[[f64; 2]], width: f64, closed: bool) -> String {
    format!(r#"{{"type": "wall", "points": {points:?}, "width": {width:?}, "closed": {closed}}}"#)
}

fn pierced([x, y]: [f64; 2], [u, v]: [f64; 2], hole: &[[f64; 2]]) -> String {
    format!(r#"{{"type": "polygon", "vertices": {:?}, "holes": [{hole:?}]}}"#, [[x, y], [u, y], [u, v], [x, v]])
}

/// A gap of this width limits, and the segment that is drawn is as long.
#[track_caller]
fn is_gap(found: &Widest, width: f64) {
    let radius = found.radius.expect("a point passes");
    assert!((radius - 0.5 * width).abs() <= 1e-11, "{found:?} is not {width}");
    let [a, b] = found.bottleneck.expect("a gap").map(|[x, y]| Point::new(x, y));
    assert!(((b - a).norm() - width).abs() <= 1e-11, "{found:?}");
    assert_eq!((found.limit, found.between.len()), (Limit::Gap, 2));
}

#[track_caller]
fn is_closed(found: &Widest) {
    assert_eq!((found.radius, found.limit, found.bottleneck, found.between.len()), (None, Limit::Closed, None, 0));
}

#[track_caller]
fn is_end(found: &Widest, limit: Limit, radius: f64, with: Touched) {
    assert!(found.radius.is_some_and(|found| (found - radius).abs() <= 1e-14), "{found:?} is not {radius}");
    assert_eq!((found.limit, &found.between[..]), (limit, &[with][..]));
}

const LOW: [f64; 2] = [4.0, -1.0];
const HIGH: [f64; 2] = [6.0, 11.0];

#[wasm_bindgen_test(unsupported = test)]
fn gaps_with_a_closed_form() {
    // Two discs between walls to the bounds, whose surfaces are 1.5 apart.
    let columns = [
        disc([5.0, 3.0], 1.0),
        rectangle([4.9, 0.0], [5.1, 3.0]),
        disc([5.0, 6.75], 1.25),
        rectangle([4.9, 7.0], [5.1, 10.0]),
    ];
    let found = of(&columns, ACROSS);
    is_gap(&found, 1.5);
    let mut between = found.between.clone();
    between.sort_by_key(|with| format!("{with:?}"));
    assert_eq!(between, [Touched::Obstacle(0), Touched::Obstacle(2)]);
    // Between an obstacle and the bounds, also if others stand in the way of nothing.
    for gap in [1e-6, 0.3, 1.9] {
        let found = of(&[rectangle([4.0, gap], [6.0, 10.0]), disc([1.0, 8.0], 0.5)], ACROSS);
        is_gap(&found, gap);
        assert!(found.between.contains(&Touched::Bounds) && found.between.contains(&Touched::Obstacle(0)));
    }
    // A slit, of walls with and without a width, of polygons, straight across and at an angle; the wider of two is taken.
    for width in [0.0, 0.25] {
        let slit = |gap: f64| {
            let end = 0.5 * (gap + width);
            [wall(&[[5.0, 0.0], [5.0, 5.0 - end]], width, false), wall(&[[5.0, 5.0 + end], [5.0, 10.0]], width, false)]
        };
        is_gap(&of(&slit(0.75), ACROSS), 0.75);
        is_gap(&of(&slit(1e-9), ACROSS), 1e-9);
        is_closed(&of(&slit(0.0), ACROSS));
    }
    let slanted = |gap: f64| {
        let step = gap / 2.0_f64.sqrt();
        let low = polygon(&[[3.0, 0.0], [7.0, 0.0], [7.0, 6.0], [3.0, 2.0]]);
        [low, polygon(&[[3.0 - step, 2.0 + step], [7.0 - step, 6.0 + step], [7.0 - step, 10.0], [3.0 - step, 10.0]])]
    };
    is_gap(&of(&slanted(0.6), ACROSS), 0.6);
    let two = [
        rectangle([4.0, 0.0], [6.0, 2.0]),
        rectangle([4.0, 2.5], [6.0, 6.0]),
        rectangle([4.0, 7.25], [6.0, 9.0]),
        rectangle([4.0, 9.5], [6.0, 10.0]),
    ];
    is_gap(&of(&two, ACROSS), 1.25);
    // A door in one obstacle.
    let bent = wall(&[[3.0, 3.0], [3.0, 7.0], [7.0, 7.0], [7.0, 3.0], [3.5, 3.0]], 0.0, false);
    let found = of(&[bent], [[5.0, 5.0], [1.0, 1.0]]);
    is_gap(&found, 0.5);
    assert_eq!(found.between, [Touched::Obstacle(0); 2]);
    // One door after another: the narrower counts.
    let doors = [
        rectangle([3.0, 0.0], [3.5, 5.0]),
        rectangle([3.0, 6.0], [3.5, 10.0]),
        rectangle([6.0, 0.0], [6.5, 2.0]),
        rectangle([6.0, 2.25], [6.5, 10.0]),
    ];
    is_gap(&of(&doors, ACROSS), 0.25);
}

#[wasm_bindgen_test(unsupported = test)]
fn start_and_goal_limit() {
    is_end(&of(&[], [[3.0, 5.0], [5.0, 1.0]]), Limit::Goal, 1.0, Touched::Bounds);
    is_end(&of(&[disc([5.0, 5.0], 1.0)], [[3.5, 5.0], [5.0, 8.0]]), Limit::Start, 0.5, Touched::Obstacle(0));
    // As wide as a disc at the start, and nothing to pass.
    is_end(&of(&[disc([5.0, 5.0], 1.0)], [[3.5, 5.0]; 2]), Limit::Start, 0.5, Touched::Obstacle(0));
    // On the bounds there is room for a point; a wall closes even so.
    is_end(&of(&[], [[0.0, 5.0], [5.0, 5.0]]), Limit::Start, 0.0, Touched::Bounds);
    is_end(&of(&[], [[0.0, 0.0], [10.0, 0.0]]), Limit::Start, 0.0, Touched::Bounds);
    for ends in [[[1.0, 0.0], [9.0, 0.0]], [[9.0, 10.0], [1.0, 10.0]], [[0.0, 5.0], [10.0, 0.0]], [[0.0; 2], [10.0; 2]]]
    {
        for reversed in [ends, [ends[1], ends[0]]] {
            is_closed(&of(&[rectangle(LOW, HIGH)], reversed));
            is_closed(&of(&[rectangle([4.0, 0.0], [6.0, 10.0])], reversed));
            is_closed(&of(&[wall(&[[5.0, 0.0], [5.0, 10.0]], 0.0, false)], reversed));
            is_closed(&of(&[wall(&[[5.0, -1.0], [5.0, 11.0]], 0.5, false)], reversed));
            is_end(&of(&[rectangle([4.0, -1.0], [6.0, 9.0])], reversed), Limit::Start, 0.0, Touched::Bounds);
            is_end(&of(&[rectangle([4.0, 2.0], [6.0, 11.0])], reversed), Limit::Start, 0.0, Touched::Bounds);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn contacts_close() {
    // Polygons that share a corner, a part of a side, or an area; a corner in a side; coordinates that are rounded.
    let squares = |x: f64, y: f64| [rectangle([0.0, 0.0], [x, y]), rectangle([x, y], [10.0, 10.0])];
    let corner = [[1.0, 9.0], [9.0, 1.0]];
    for [x, y] in [[5.0, 5.0], [0.1 + 0.2, 3.3], [6.1, 4.7]] {
        let ends = if x < 1.0 { [[0.1, 9.0], [9.0, 1.0]] } else { corner };
        is_closed(&of(&squares(x, y), ends));
    }
    let low = rectangle([4.1, 0.0], [5.3, 4.7]);
    for above in
        [rectangle([5.3, 4.7], [6.6, 10.0]), rectangle([5.0, 4.7], [6.6, 10.0]), rectangle([4.5, 4.0], [4.9, 10.0])]
    {
        is_closed(&of(&[low.clone(), above], ACROSS));
    }
    let tip = polygon(&[[4.0, 10.0], [4.7, 4.7], [6.0, 10.0]]);
    is_closed(&of(&[low.clone(), tip], ACROSS));
    // A disc that touches a wall, discs that touch, thick walls that overlap, lines that cross.
    is_closed(&of(&[disc([5.0, 4.0], 4.0), rectangle([4.0, 8.0], [6.0, 10.0])], [[1.0, 9.0], [9.0, 9.0]]));
    let discs: Vec<_> = (0..10).map(|i| disc([5.0, 0.5 + f64::from(i)], 0.5)).collect();
    is_closed(&of(&discs, ACROSS));
    is_closed(&of(
        &[wall(&[[3.0, 0.0], [6.0, 6.0]], 0.2, false), wall(&[[3.0, 10.0], [6.0, 5.0]], 0.2, false)],
        ACROSS,
    ));
    is_closed(&of(
        &[wall(&[[3.0, 0.0], [7.0, 6.0]], 0.0, false), wall(&[[3.0, 10.0], [7.0, 4.0]], 0.0, false)],
        ACROSS,
    ));
    // In a hole, a ring, or a closed wall; a bridge from ring to ring does not help.
    let ring = [[3.0, 3.0], [7.0, 3.0], [7.0, 7.0], [3.0, 7.0]];
    let rooms =
        [(pierced([2.0, 2.0], [8.0, 8.0], &ring), 1.5), (wall(&ring, 0.0, true), 1.5), (wall(&ring, 0.5, true), 1.25)];
    for (around, room) in rooms {
        is_closed(&of(std::slice::from_ref(&around), [[5.0, 5.0], [1.0, 1.0]]));
        is_closed(&of(&[around.clone(), disc([4.0, 5.0], 0.3)], [[5.0, 5.0], [1.0, 1.0]]));
        is_end(
            &of(&[around, disc([9.0, 9.0], 0.3)], [[5.0, 5.0], [5.0, 4.5]]),
            Limit::Goal,
            room,
            Touched::Obstacle(0),
        );
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn obstacles_that_are_nested_overlap_or_lie_outside() {
    // What lies within another one, or outside, changes nothing; nor does a cut of an obstacle into parts.
    let gap = [rectangle(LOW, [6.0, 4.0]), rectangle([4.0, 5.0], HIGH)];
    let within =
        [disc([5.0, 2.0], 0.2), rectangle([4.5, 6.0], [5.5, 7.0]), wall(&[[4.2, 8.0], [5.8, 9.0]], 0.1, false)];
    let outside = [disc([5.0, -3.0], 0.5), rectangle([11.0, 0.0], [12.0, 3.0]), disc([20.0, 5.0], 5.0)];
    is_gap(&of(&gap, ACROSS), 1.0);
    is_gap(&of(&[&gap[..], &within, &outside].concat(), ACROSS), 1.0);
    let cut = [
        rectangle([4.0, 0.0], [5.0, 4.0]),
        rectangle([5.0, -1.0], [6.0, 4.0]),
        rectangle([4.0, 5.0], [5.2, 10.0]),
        rectangle([4.8, 5.0], [6.0, 9.0]),
        rectangle([4.8, 8.5], [6.0, 11.0]),
    ];
    is_gap(&of(&cut, ACROSS), 1.0);
    // A disc outside whose border is within the bounds; a polygon around the bounds with a strip through it.
    is_gap(&of(&[disc([5.0, -1.0], 2.0), rectangle([4.0, 2.5], [6.0, 10.0])], [[1.0, 3.0], [9.0, 3.0]]), 1.5);
    let strip = pierced([-5.0, -5.0], [15.0, 15.0], &[[-1.0, 3.0], [11.0, 3.0], [11.0, 7.0], [-1.0, 7.0]]);
    is_gap(&of(&[strip.clone(), disc([5.0, 4.75], 0.5)], ACROSS), 1.75);
    is_end(&of(&[strip], ACROSS), Limit::Start, 1.0, Touched::Bounds);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_not_served_is_refused() {
    let reaches =
        scenario("[0, 0], [2, 2]", "", r#"{"type": "disc", "radius": 0.1}"#, r#""start": [1, 1], "goal": [1, 1]"#);
    refuses(widest(&reaches, Some("other")), "unknown-query", "/query");
    for document in [reaching(), BODY.to_owned(), CAR.to_owned()] {
        refuses(widest(parse(&document), None), "unsupported", "");
    }
    let block = [rectangle([4.0, 4.0], [6.0, 6.0]), disc([8.0, 8.0], 0.5)];
    for (ends, code, pointer) in [
        ([[5.0, 5.0], [1.0, 1.0]], "start-in-collision", "/queries/0/start"),
        ([[4.0, 5.0], [1.0, 1.0]], "start-in-collision", "/queries/0/start"),
        ([[1.0, 1.0], [6.0, 6.0]], "goal-in-collision", "/queries/0/goal"),
        ([[1.0, 1.0], [8.0, 8.1]], "goal-in-collision", "/queries/0/goal"),
        ([[1.0, 1.0], [8.0, 10.1]], "goal-in-collision", "/queries/0/goal"),
    ] {
        refuses(widest(disc_among(ROOM, &block, 0.0, ends), None), code, pointer);
    }
    // The robot of the scenario does not matter, nor does its margin.
    let robot = r#"{"type": "disc", "radius": 3, "margin": 0.5}"#;
    let wide = scenario(ROOM, &block.join(","), robot, r#""start": [1, 1], "goal": [9, 9]"#);
    let found = widest(&wide, None).expect("a way");
    assert_eq!(found.radius, of(&block, [[1.0, 1.0], [9.0, 9.0]]).radius);
    // A pile of discs has too many contacts.
    let pile: Vec<_> = (0..2100).map(|i| disc([5.0 + 1e-4 * f64::from(i), 5.0], 0.5)).collect();
    refuses(widest(disc_among(ROOM, &pile, 0.0, [[1.0; 2], [9.0; 2]]), None), "too-large", "");
}

/// A random world: polygons, discs and walls, some of which overlap, and corridors of them.
pub fn random_world(random: &mut Random, count: u64) -> Vec<String> {
    let mut at = |low: f64, high: f64| low + random.uniform() * (high - low);
    let mut obstacles = Vec::new();
    if count.is_multiple_of(3) {
        // From side to side, closed or with a door.
        let (low, door) = (at(2.0, 8.0), at(-0.5, 1.0));
        let [a, b, c, d] = [0; 4].map(|_| at(3.0, 7.0));
        obstacles.push(wall(&[[a, -0.5], [b, low]], 0.1, false));
        obstacles.push(wall(&[[b, low + door], [c, 9.0], [d, 10.5]], 0.1, false));
    }
    for i in 0..count {
        let center = Vector::new(at(-0.5, 10.5), at(-0.5, 10.5));
        let size = at(0.2, 1.6);
        obstacles.push(match i % 4 {
            0 => disc([center.x, center.y], 0.6 * size),
            1 => {
                let end = center + 2.0 * size * Vector::new(at(-1.0, 1.0), at(-1.0, 1.0));
                let far = end + size * Vector::new(at(-1.0, 1.0), at(-1.0, 1.0));
                let width = if at(0.0, 1.0) < 0.5 { 0.0 } else { 0.3 * size };
                wall(&[[center.x, center.y], [end.x, end.y], [far.x, far.y]], width, false)
            }
            _ => {
                let corners = 3 + (at(0.0, 6.0) as u64);
                let corner = |i: u64, at: &mut dyn FnMut(f64, f64) -> f64| {
                    let angle = TAU * (i as f64 + at(0.0, 0.7)) / corners as f64;
                    let p = center + size * at(0.3, 1.0) * Vector::new(libm::cos(angle), libm::sin(angle));
                    [p.x, p.y]
                };
                polygon(&(0..corners).map(|i| corner(i, &mut at)).collect::<Vec<_>>())
            }
        });
    }
    obstacles
}

/// Two points that are free, if there are any among some.
pub fn free_ends(random: &mut Random, obstacles: &[String]) -> Option<[[f64; 2]; 2]> {
    let mut point = || [0, 1].map(|_| 0.2 + 9.6 * random.uniform());
    (0..20).map(|_| [point(), point()]).find(|&ends| widest(disc_among(ROOM, obstacles, 0.0, ends), None).is_ok())
}

#[wasm_bindgen_test(unsupported = test)]
fn shortest_paths_exist_just_below_and_not_above() {
    let mut limits = [0; 4];
    for seed in 0..cases(2000) as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        let obstacles = random_world(&mut random, 3 + seed % 24);
        let Some(ends) = free_ends(&mut random, &obstacles) else { continue };
        let found = of(&obstacles, ends);
        let passes =
            |radius: f64| match optimum(disc_among(ROOM, &obstacles, radius, ends), None, MetricOptions::default()) {
                Ok(optimum) => optimum.length.is_some(),
                Err(error) if error.code().as_str().ends_with("in-collision") => false,
                Err(error) => panic!("{error}"),
            };
        limits[found.limit as usize] += 1;
        match found.radius {
            None => assert!(!passes(0.0), "seed {seed}: {found:?}"),
            Some(radius) => {
                // Start and goal need the slack of proofs, 1e-12 of the size, to be free.
                assert!(passes(radius * (1.0 - 1e-9) - 2e-11), "seed {seed}, below: {found:?}");
                assert!(!passes(radius * (1.0 + 1e-9) + 2e-11), "seed {seed}, above: {found:?}");
            }
        }
        // From the goal to the start it is the same.
        let back = of(&obstacles, [ends[1], ends[0]]);
        assert_eq!(back.radius.is_some(), found.radius.is_some(), "seed {seed}");
        let difference = back.radius.unwrap_or(0.0) - found.radius.unwrap_or(0.0);
        assert!(difference.abs() <= 1e-12, "seed {seed}: {back:?} {found:?}");
    }
    assert!(limits.iter().all(|&times| times > 0), "{limits:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn certificates_agree_within_a_millimetre() {
    for seed in 0..seeds(120) {
        let mut random = Random::new(1000 + seed, Stream::Samples);
        let obstacles = random_world(&mut random, 6 + seed % 16);
        let Some(ends) = free_ends(&mut random, &obstacles) else { continue };
        let Some(radius) = of(&obstacles, ends).radius.filter(|&radius| radius > 0.01) else { continue };
        for (wider, expected) in [(-1e-3, Verdict::Connected), (1e-3, Verdict::Infeasible)] {
            // A larger disc, not a point with a clearance, which would be that from obstacles alone.
            match Subdivision::new(disc_among(ROOM, &obstacles, radius + wider, ends), &Options::default()) {
                Ok(mut subdivision) => {
                    subdivision.step(u64::MAX);
                    assert_eq!(subdivision.verdict(), Some(expected), "seed {seed}: {radius} {wider}");
                }
                Err(error) => {
                    assert!(error.code().as_str().ends_with("in-collision") && wider > 0.0, "seed {seed}: {error}");
                }
            }
        }
    }
}
