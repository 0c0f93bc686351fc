//! The shortest path of a query: closed forms, an independent visibility graph on random worlds, ways that only touch, and references.

use crate::common::documents::{disc, disc_among, judged, polygon, rectangle, refuses, scenario};
use crate::common::{arm_and_wall, arm_of, begin_with, cases, finish, given, no_way, seeds};
use planarium::geometry::{Point, Polygon, Vector, orientation};
use planarium::optimum::{Method, MetricOptions, Optimum, ShortestPaths, by_all_tangents, optimum};
use planarium::options::Options;
use planarium::random::{Random, Stream};
use planarium::run::Status;
use planarium::run::inspect::Inspector;
use planarium::scenario::Scenario;
use std::f64::consts::{PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

const ROOM: &str = "[0, 0], [10, 10]";

fn of(world: &Scenario) -> Optimum {
    optimum(world, None, MetricOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The exact length of the shortest path.
fn shortest(world: &Scenario) -> f64 {
    let found = of(world);
    assert_eq!((found.method, found.exact, found.resolution), (Method::TangentGraph, true, None));
    assert!(found.slack.is_some_and(|slack| 0.0 < slack && slack < 1e-6));
    found.length.expect("there is a path")
}

#[track_caller]
fn assert_close(found: f64, expected: f64, scale: f64) {
    assert!((found - expected).abs() <= 1e-12 * scale, "{found} is not {expected}: {:e}", found - expected);
}

#[wasm_bindgen_test(unsupported = test)]
fn lengths_with_a_closed_form() {
    for (scale, radius) in [(1.0, 0.0), (1.0, 0.5), (1e-3, 0.25), (1e5, 0.125), (1.0, 1e-9)] {
        let bounds = format!("[{0:?}, {0:?}], [{1:?}, {1:?}]", -5.0 * scale, 5.0 * scale);
        let r = radius * scale;
        let s = |x: f64| x * scale;
        let world =
            |obstacles: &[String], a: f64, b: f64| disc_among(&bounds, obstacles, r, [[s(a), 0.0], [s(b), 0.0]]);

        assert_close(shortest(&world(&[], -4.0, 3.0)), s(7.0), s(5.0));

        // Around a disc: two tangents and an arc.
        let rho = s(1.0) + r;
        let half = libm::sqrt(s(4.0) * s(4.0) - rho * rho);
        let around = 2.0 * half + rho * (PI - 2.0 * libm::acos(rho / s(4.0)));
        assert_close(shortest(&world(&[disc([0.0; 2], s(1.0))], -4.0, 4.0)), around, s(5.0));

        // Over a square, whose corners are arcs.
        let square = rectangle([s(-1.0), s(-1.0)], [s(1.0), s(1.0)]);
        let turn = PI / 4.0 + libm::asin(radius / libm::sqrt(2.0));
        let over = 2.0 * libm::sqrt(s(1.0) * s(2.0) - r * r) + s(2.0) + 2.0 * r * turn;
        // A rectangle of two that share a side, and an L whose inner corner the path does not touch, are no other obstacle.
        let halves = [rectangle([s(-1.0), s(-1.0)], [0.0, s(1.0)]), rectangle([0.0, s(-1.0)], [s(1.0), s(1.0)])];
        for obstacles in [&[square][..], &halves] {
            assert_close(shortest(&world(obstacles, -2.0, 2.0)), over, s(5.0));
        }

        // Over one disc and under the next one, as walls to the border demand.
        let walls = [
            disc([s(-2.0), 0.0], s(1.0)),
            rectangle([s(-2.1), s(-5.0)], [s(-1.9), 0.0]),
            disc([s(2.0), 0.0], s(1.0)),
            rectangle([s(1.9), 0.0], [s(2.1), s(5.0)]),
        ];
        let phi = libm::asin(rho / s(2.5)) + libm::asin(rho / s(2.0));
        let wave =
            2.0 * (libm::sqrt(s(2.5) * s(2.5) - rho * rho) + rho * phi) + 2.0 * libm::sqrt(s(2.0) * s(2.0) - rho * rho);
        assert_close(shortest(&world(&walls, -4.5, 4.5)), wave, s(5.0));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_way_that_only_touches_is_none() {
    let ends = [[1.0, 5.0], [9.0, 5.0]];
    for radius in [0.0, 0.5] {
        let through = |gap: f64| {
            let walls = [rectangle([4.0, 0.0], [6.0, 5.0 - gap / 2.0]), rectangle([4.0, 5.0 + gap / 2.0], [6.0, 10.0])];
            of(&disc_among(ROOM, &walls, radius, ends)).length
        };
        assert_eq!(through(2.0 * radius), None, "a disc of radius {radius}");
        assert_close(through(2.0 * radius + 1e-9).expect("a gap"), 8.0, 10.0);
        // Between a wall and the bounds, which may be touched.
        let below = |gap: f64| {
            let walls = [rectangle([4.0, gap], [6.0, 10.0])];
            of(&disc_among(ROOM, &walls, radius, ends)).length
        };
        assert_eq!(below(2.0 * radius), None);
        assert!(below(2.0 * radius + 1e-9).is_some());
        // Polygons that share only a corner, and a disc that touches a wall.
        let diagonal = [rectangle([0.0, 5.0], [5.0, 10.0]), rectangle([5.0, 0.0], [10.0, 5.0])];
        assert_eq!(of(&disc_among(ROOM, &diagonal, radius, [[2.0, 2.0], [8.0, 8.0]])).length, None);
        let ring = [disc([5.0, 4.0], 4.0), rectangle([4.0, 8.0], [6.0, 10.0])];
        let walled = of(&disc_among(ROOM, &ring, 0.75, [[1.0, 9.0], [9.0, 9.0]]));
        assert_eq!((walled.length, walled.exact, walled.path.len()), (None, true, 0));
    }
    let here = of(&disc_among(ROOM, &[], 0.5, [[2.0, 3.0]; 2]));
    assert_eq!((here.length, here.path), (Some(0.0), vec![vec![2.0, 3.0]]));
}

/// The corners of a polygon about a point, in this order, at random distances up to `size`; at equal ones it is convex.
fn about(random: &mut Random, size: f64, is_convex: bool) -> Vec<Point> {
    let center = Vector::new(2.0 + 6.0 * random.uniform(), 2.0 + 6.0 * random.uniform());
    let corners = 3 + random.below(5);
    let corner = |i: u64, random: &mut Random| {
        let angle = TAU * (i as f64 + 0.7 * random.uniform()) / corners as f64;
        let distance = if is_convex { size } else { size * (0.3 + 0.7 * random.uniform()) };
        Point::from(center + distance * Vector::new(libm::cos(angle), libm::sin(angle)))
    };
    (0..corners).map(|i| corner(i, random)).collect()
}

fn obstacle(corners: &[Point]) -> String {
    polygon(&corners.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>())
}

/// The shortest path of a point among polygons in general position by all pairs of corners: O(n^3), and Dijkstra's algorithm by scans.
/// Corners outside the box, given by its lowest and highest coordinate, are not passed.
fn by_corners(polygons: &[Vec<Point>], [low, high]: [f64; 2], ends: [Point; 2]) -> Option<f64> {
    let shapes: Vec<Polygon> = polygons.iter().map(|corners| Polygon::new(corners).expect("a polygon")).collect();
    let is_inside = |p: &Point| [p.x, p.y].iter().all(|x| (low..=high).contains(x));
    let mut points = ends.to_vec();
    points.extend(shapes.iter().flat_map(|shape| shape.vertices().iter().copied()).filter(is_inside));
    let is_side = |shape: &Polygon, p: Point, q: Point| {
        shape.edges().any(|edge| [edge.a, edge.b] == [p, q] || [edge.a, edge.b] == [q, p])
    };
    let crosses = |shape: &Polygon, p: Point, q: Point| {
        let apart = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
        shape.edges().any(|edge| {
            apart(orientation(p, q, edge.a), orientation(p, q, edge.b))
                && apart(orientation(edge.a, edge.b, p), orientation(edge.a, edge.b, q))
        })
    };
    let is_visible = |p: Point, q: Point| {
        let middle = middle_of(p, q);
        shapes.iter().all(|shape| !crosses(shape, p, q) && (is_side(shape, p, q) || !shape.contains(middle)))
    };
    let mut cost = vec![f64::INFINITY; points.len()];
    let mut is_done = vec![false; points.len()];
    cost[0] = 0.0;
    loop {
        let open = (0..points.len()).filter(|&i| !is_done[i] && cost[i] < f64::INFINITY);
        let i = open.min_by(|&i, &j| cost[i].total_cmp(&cost[j]))?;
        if i == 1 {
            return Some(cost[1]);
        }
        is_done[i] = true;
        for j in 0..points.len() {
            let through = cost[i] + (points[j] - points[i]).norm();
            if !is_done[j] && through < cost[j] && is_visible(points[i], points[j]) {
                cost[j] = through;
            }
        }
    }
}

fn middle_of(p: Point, q: Point) -> Point {
    Point::from(0.5 * (p.coords + q.coords))
}

#[wasm_bindgen_test(unsupported = test)]
fn points_go_as_a_visibility_graph_says() {
    let (mut found, mut bent) = (0, 0);
    for seed in 0..cases(400) as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        // Many overlap.
        let polygons: Vec<_> = (0..2 + seed % 9).map(|i| about(&mut random, 1.5, i % 2 == 0)).collect();
        let obstacles: Vec<_> = polygons.iter().map(|corners| obstacle(corners)).collect();
        let ends = [[0.4, 0.4 + random.uniform()], [9.6, 9.6 - random.uniform()]];
        let expected = by_corners(&polygons, [0.0, 10.0], ends.map(|[x, y]| Point::new(x, y)));
        let length = of(&disc_among(ROOM, &obstacles, 0.0, ends)).length;
        assert_eq!(length.is_some(), expected.is_some(), "seed {seed}");
        if let Some((length, expected)) = length.zip(expected) {
            assert_close(length, expected, 10.0);
            found += 1;
            bent += usize::from(length > 1.001 * (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]));
        }
    }
    assert!(found > 0 && 2 * bent > found, "{bent} of {found} paths turn at corners");
}

/// The corners of a regular polygon of radius 1.
fn regular(corners: u32) -> impl Iterator<Item = Vector> {
    let angle = move |i| TAU * f64::from(i) / f64::from(corners);
    (0..corners).map(move |i| Vector::new(libm::cos(angle(i)), libm::sin(angle(i))))
}

/// The convex hull, counter-clockwise.
fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    points.dedup();
    let mut hull: Vec<Point> = Vec::new();
    for pass in [points.clone(), points.into_iter().rev().collect()] {
        let first = hull.len();
        for p in pass {
            while hull.len() > first + 1 && orientation(hull[hull.len() - 2], hull[hull.len() - 1], p) <= 0.0 {
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
    }
    hull
}

/// Obstacles grown by regular polygons within and around the disc bound its shortest path from both sides.
#[wasm_bindgen_test(unsupported = test)]
fn discs_go_between_two_visibility_graphs() {
    const SIDES: u32 = 20;
    let outer = 1.0 / libm::cos(PI / f64::from(SIDES));
    for seed in 0..cases(80) as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        let radius = 0.1 + 0.4 * random.uniform();
        // A polygon and its radius: a disc is grown from a point.
        let mut shapes: Vec<(Vec<Point>, f64)> = (0..3).map(|_| (about(&mut random, 1.2, true), 0.0)).collect();
        shapes.extend((0..2).map(|_| {
            let [x, y] = [0, 1].map(|_| 2.0 + 6.0 * random.uniform());
            (vec![Point::new(x, y)], 0.3 + random.uniform())
        }));
        let written = |(corners, round): &(Vec<Point>, f64)| match corners[..] {
            [center] => disc([center.x, center.y], *round),
            _ => obstacle(corners),
        };
        let ends = [[0.6, 0.6], [9.4, 9.4]];
        let obstacles: Vec<_> = shapes.iter().map(written).collect();
        let length = of(&disc_among(ROOM, &obstacles, radius, ends)).length.expect("a way along the border");
        let grown = |factor: f64| {
            let grow = |(corners, round): &(Vec<Point>, f64)| {
                hull(
                    corners
                        .iter()
                        .flat_map(|p| regular(SIDES).map(move |side| p + factor * (radius + round) * side))
                        .collect(),
                )
            };
            let polygons: Vec<_> = shapes.iter().map(grow).collect();
            by_corners(&polygons, [radius, 10.0 - radius], ends.map(|[x, y]| Point::new(x, y)))
        };
        let [low, high] = [grown(1.0), grown(outer)].map(|length| length.expect("the same way"));
        assert!(low <= length && length <= high && high < 1.02 * low, "seed {seed}: {length} in [{low}, {high}]");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_run_is_shorter_and_the_path_is_that_long() {
    for seed in 0..seeds(40) {
        let mut random = Random::new(seed, Stream::Samples);
        let radius = if seed % 2 == 0 { 0.2 } else { 0.0 };
        let mut obstacles: Vec<_> = (0..5).map(|i| obstacle(&about(&mut random, 1.2, i > 2))).collect();
        obstacles.push(disc([5.0, 5.0], 1.0));
        let world = disc_among(ROOM, &obstacles, radius, [[0.5, 0.5], [9.5, 9.5]]);
        let found = of(&world);
        let length = found.length.expect("a way along the border");
        let run = finish(begin_with(&world, "rrt-connect", seed, "shortcut=200 reduce=true"));
        assert!(run.length() >= length * (1.0 - 1e-13) && run.length() < 1.3 * length, "{} {length}", run.length());
        // Chords of at most 0.05 radians are shorter than their arcs by less than 0.05^2 / 24 of them.
        let inspector = Inspector::new(&world);
        let drawn: f64 =
            found.path.windows(2).map(|pair| inspector.distance(&pair[0], &pair[1]).expect("points")).sum();
        assert!(drawn <= length * (1.0 + 1e-13) && drawn > length * (1.0 - 1.1e-4), "{drawn} {length}");
        assert_eq!([&found.path[0], &found.path[found.path.len() - 1]], [&vec![0.5, 0.5], &vec![9.5, 9.5]]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_reference_is_a_valid_path_and_no_run_is_much_shorter() {
    let shelf = rectangle([0.2, 0.55], [1.4, 0.65]);
    let sliding = scenario(
        "[0, 0], [2, 2]",
        &shelf,
        &crate::common::documents::rectangular("rigid_body", 0.1, 0.05, ""),
        r#""start": [0.5, 0.3, 1], "goal": [0.5, 1.0, 7.283185307179586]"#,
    );
    for (world, settings) in
        [(arm_and_wall(0.1), ""), (arm_and_wall(0.1), "metric=euclidean"), (arm_of(2, true, 0.02), ""), (sliding, "")]
    {
        let found = optimum(&world, None, Options::read(&given(settings)).expect("a metric")).expect("a reference");
        assert_eq!((found.method, found.exact), (Method::Grid, false));
        let mut result = finish(begin_with(&world, "rrt-connect", 1, "")).result();
        (result.path, result.length) = (found.path, found.length.expect("a path"));
        if settings.is_empty() {
            judged(&world, &result).expect("a valid path");
        }
        let run =
            finish(begin_with(&world, "rrt-connect", 1, &format!("{settings} shortcut=300 partial_shortcut=300")));
        assert!(result.length < 1.01 * run.length(), "{} {}", result.length, run.length());
    }
    // From 0.6 to -0.6 the long way round, in a straight line: with two joints that move, the sum is the same for all orders.
    let found = of(&no_way());
    assert_eq!((found.length, found.exact, found.path.len()), (None, false, 0));
}

/// Polygons, discs and walls, of which many overlap.
fn jumble(random: &mut Random, seed: u64) -> Vec<String> {
    let place = |random: &mut Random| [0, 1].map(|_| 2.0 + 6.0 * random.uniform());
    let mut obstacles: Vec<_> = (0..1 + seed % 9).map(|i| obstacle(&about(random, 1.5, i % 2 == 0))).collect();
    if seed.is_multiple_of(3) {
        obstacles.extend((0..2).map(|_| disc(place(random), 0.3 + random.uniform())));
    }
    if seed.is_multiple_of(5) {
        let width = 0.1 * (seed % 2) as f64;
        let points = [place(random), place(random), [5.0, 5.0]];
        obstacles.push(format!(r#"{{"type": "wall", "points": {points:?}, "width": {width:?}}}"#));
    }
    obstacles
}

/// The world prepared for a few queries.
fn prepared(world: &Scenario) -> ShortestPaths {
    ShortestPaths::new(world).unwrap_or_else(|error| panic!("{error}"))
}

#[wasm_bindgen_test(unsupported = test)]
fn a_search_finds_what_all_tangents_give() {
    for seed in 0..cases(1000) as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        let obstacles = jumble(&mut random, seed);
        let radius = if seed % 2 == 0 { 0.0 } else { 0.05 + 0.4 * random.uniform() };
        let world = disc_among(ROOM, &obstacles, radius, [[0.6; 2], [9.4; 2]]);
        let expected = by_all_tangents(&world, None).unwrap_or_else(|error| panic!("{error}"));
        let [few, many] = [prepared(&world), prepared(&world).for_many_queries()];
        assert_eq!((few.tangents(), many.tangents().is_some()), (None, true));
        for ends in [[[0.6; 2], [9.4; 2]], [[9.4; 2], [0.6; 2]]] {
            for paths in [&few, &many] {
                let found = paths.query(ends[0], ends[1]).unwrap_or_else(|error| panic!("{error}"));
                assert_eq!(found.is_some(), expected.is_some(), "seed {seed}");
                if let Some((found, expected)) = found.zip(expected) {
                    assert_close(found.length, expected, 10.0);
                    assert_eq!([found.path[0], found.path[found.path.len() - 1]], ends);
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn no_planner_is_shorter_among_anything() {
    let planners = [
        ("rrt-connect", "shortcut=100 reduce=true"),
        ("bit-star", "improve_iterations=400"),
        ("rrt-star", "improve_iterations=200"),
        ("prm", "samples=200"),
        ("lazy-prm-star", "improve_iterations=400"),
    ];
    let (mut solved, count) = (0, cases(1000));
    for seed in 0..count as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        let obstacles = jumble(&mut random, seed);
        let world = disc_among(ROOM, &obstacles, 0.05 + 0.4 * random.uniform(), [[0.6; 2], [9.4; 2]]);
        let (planner, settings) = planners[seed as usize % planners.len()];
        let run = finish(begin_with(&world, planner, seed, &format!("max_iterations=3000 {settings}")));
        match of(&world).length {
            Some(length) if run.status() == Status::Solved => {
                assert!(run.length() >= length * (1.0 - 1e-13), "seed {seed}: {planner} {} {length}", run.length());
                solved += 1;
            }
            Some(_) => {}
            None => assert_ne!(run.status(), Status::Solved, "seed {seed}: {planner} has a path"),
        }
    }
    assert!(solved * 2 > count, "{solved} paths");
}

/// Blocked cells of a grid, each run of a row as one rectangle: they share parts of sides or only corners, and positions in the
/// middle of cells lie on the diagonals between corners.
#[wasm_bindgen_test(unsupported = test)]
fn cells_of_a_map_are_one_obstacle() {
    const SIDE: u64 = 14;
    let mut found = 0;
    for seed in 0..cases(60) as u64 {
        let mut random = Random::new(seed, Stream::Samples);
        let cells: Vec<bool> = (0..SIDE * SIDE).map(|_| random.uniform() < 0.3).collect();
        let mut obstacles = Vec::new();
        for (y, row) in cells.chunks(SIDE as usize).enumerate() {
            let mut x = 0;
            for run in row.chunk_by(|a, b| a == b) {
                if run[0] {
                    obstacles.push(rectangle([x as f64, y as f64], [(x + run.len()) as f64, y as f64 + 1.0]));
                }
                x += run.len();
            }
        }
        let free: Vec<u64> = (0..SIDE * SIDE).filter(|&cell| !cells[cell as usize]).collect();
        let radius = [0.0, 0.0, 0.1, 0.4][seed as usize % 4];
        for _ in 0..4 {
            let ends = [0, 1].map(|_| {
                let cell = free[random.below(free.len() as u64) as usize];
                [cell % SIDE, cell / SIDE].map(|x| x as f64 + 0.5)
            });
            let world = disc_among("[0, 0], [14, 14]", &obstacles, radius, ends);
            let expected = by_all_tangents(&world, None).unwrap_or_else(|error| panic!("{error}"));
            let many = prepared(&world).for_many_queries().query(ends[0], ends[1]);
            let many = many.unwrap_or_else(|error| panic!("{error}")).map(|shortest| shortest.length);
            for length in [of(&world).length, many] {
                assert_eq!(length.is_some(), expected.is_some(), "seed {seed}, {ends:?}");
                if let Some((length, expected)) = length.zip(expected) {
                    assert_close(length, expected, 14.0);
                    found += usize::from(length > 0.0);
                }
            }
        }
    }
    assert!(found > 2 * cases(60), "{found} paths");
}

#[wasm_bindgen_test(unsupported = test)]
fn ten_thousand_corners_are_prepared_once() {
    // Squares in 50 rows of 50, each turned and moved a little.
    let mut random = Random::new(1, Stream::Samples);
    let mut square = |i: u32, half: f64| {
        let center = [i % 50, i / 50].map(|x| 2.0 * f64::from(x) + 1.0 + 0.3 * random.uniform());
        let turn = TAU * random.uniform();
        let corner = |k: i32| {
            let angle = turn + 0.5 * PI * f64::from(k);
            [center[0] + half * libm::cos(angle), center[1] + half * libm::sin(angle)]
        };
        polygon(&[0, 1, 2, 3].map(corner))
    };
    let squares: Vec<_> = (0..2500).map(|i| square(i, 0.6)).collect();
    let world = disc_among("[0, 0], [101, 101]", &squares, 0.1, [[0.11; 2], [100.8; 2]]);
    let paths = prepared(&world);
    let length =
        |a: [f64; 2], b: [f64; 2]| paths.query(a, b).unwrap_or_else(|error| panic!("{error}")).expect("a path").length;
    let places = [[0.11, 0.11], [100.8, 100.8], [100.8, 0.11], [0.11, 100.8]];
    for (i, &a) in places.iter().enumerate() {
        for &b in &places[..i] {
            assert_close(length(a, b), length(b, a), 101.0);
            let straight = Vector::new(a[0] - b[0], a[1] - b[1]).norm();
            assert!(straight <= length(a, b) && length(a, b) < 1.1 * straight);
        }
    }
    assert!(length(places[0], places[1]) <= length(places[0], places[2]) + length(places[2], places[1]) + 1e-9);
    // Small ones see each other over long distances: too many tangents.
    let squares: Vec<_> = (0..2500).map(|i| square(i, 0.05)).collect();
    let open = disc_among("[0, 0], [101, 101]", &squares, 0.1, [[0.11; 2], [100.8; 2]]);
    assert_eq!(prepared(&open).for_many_queries().tangents(), None);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_thousand_corners_are_compared() {
    // In the way stands one square; the others stand aside, some of them aligned and in contact.
    let square = |x: f64, y: f64| rectangle([x, y], [x + 1.0, y + 1.0]);
    let mut squares = vec![square(16.0, 0.5)];
    squares.extend((0..250).map(|i| square(2.0 * f64::from(i % 16) + f64::from(i % 2), 3.0 + 1.5 * f64::from(i / 16))));
    let bounds = "[0, 0], [34, 34]";
    let [alone, all] =
        [&squares[..1], &squares].map(|squares| of(&disc_among(bounds, squares, 0.0, [[0.5, 1.0], [33.5, 1.0]])));
    assert!(all.exact && all.length.is_some());
    assert_eq!(all.length, alone.length);
}

#[wasm_bindgen_test(unsupported = test)]
fn what_has_no_optimum_is_refused() {
    // A point that is free by an exact test, but nearer than rounding.
    let beside = disc_among(ROOM, &[rectangle([4.0, 4.0], [6.0, 6.0])], 0.0, [[4.0_f64.next_down(), 5.0], [9.0, 9.0]]);
    refuses(optimum(&beside, None, MetricOptions::default()), "start-in-collision", "/queries/0/start");
    let paths = prepared(&disc_among(ROOM, &[rectangle([4.0, 4.0], [6.0, 6.0])], 0.5, [[1.0; 2], [9.0; 2]]));
    refuses(paths.query([5.0; 2], [9.0; 2]), "start-in-collision", "/start");
    refuses(paths.query([1.0; 2], [9.6, 9.0]), "goal-in-collision", "/goal");
    refuses(paths.query([1.0; 2], [f64::NAN, 9.0]), "not-finite", "/goal");
    refuses(ShortestPaths::new(arm_and_wall(0.1)).map(|_| ()), "unsupported", "/robot");
}
