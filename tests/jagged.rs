//! Polygons with many corners, as contours of pictures and maps have them: every answer is that of a search through all
//! edges, and takes a number of comparisons that hardly grows with the corners.

use crate::common::bodies::{p, round, star, straight, world};
use crate::common::{cases, deep, parse};
use crate::geometry::random;
use planarium::collision::{ArmValidity, BodyCollision, CollisionWorld, DiscValidity};
use planarium::fleet::{Fleet, FleetOptions, FleetPlanner, PbsOptions, verify};
use planarium::geometry::{
    Aabb, Placed, Point, Polygon, Segment, Vector, convex_pieces, distance_point_polygon, distance_point_segment,
    distance_polygon_polygon, distance_segment_polygon, distance_segment_segment, intersects_polygon_polygon,
    intersects_segment_polygon, intersects_segment_segment, orientation, signed_distance_point_polygon,
    small_convex_pieces,
};
use planarium::problem::{Status, Stepped, Validity};
use planarium::random::Random;
use planarium::robot::{Arm, DiscRobot, joint_space};
use planarium::scenario::Obstacle;
use planarium::space::Metric;
use serde_json::json;
use std::f64::consts::TAU;
use wasm_bindgen_test::wasm_bindgen_test;

/// A jagged floor of `n + 3` corners below a free sky, 100 m wide and at most 60 m high.
fn skyline(random: &mut Random, n: usize) -> Polygon {
    let mut corners = vec![p(0.0, -1.0), p(100.0, -1.0)];
    corners.extend((0..=n).rev().map(|i| {
        let y = if i % 2 == 0 { 5.0 + 20.0 * random.uniform() } else { 20.0 + 40.0 * random.uniform() };
        p(100.0 * i as f64 / n as f64, y)
    }));
    Polygon::new(&corners).expect("a simple polygon")
}

/// The same as convex pieces: one below each edge.
fn pieces_of_skyline(skyline: &Polygon) -> Vec<Obstacle> {
    let top = &skyline.vertices()[2..];
    let piece = |pair: &[Point]| {
        let (right, left) = (pair[0], pair[1]);
        Polygon::new(&[p(left.x, -1.0), p(right.x, -1.0), right, left]).expect("a trapezium")
    };
    top.windows(2).map(|pair| Obstacle::Polygon(piece(pair))).collect()
}

/// A corridor's wall that winds inwards at right angles, on whole coordinates, as a traced map has it: 1 m thick, 4 m
/// from its next turn.
fn spiral(turns: usize) -> Polygon {
    let direction = |leg: usize| [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][leg % 4];
    let legs = 2 * turns;
    let (mut at, mut outer, mut inner) = (p(0.0, 0.0), Vec::new(), Vec::new());
    for corner in 0..=legs {
        // Moved to the left of the legs before and after it.
        let beside = [corner.checked_sub(1), (corner < legs).then_some(corner)];
        let left = beside.into_iter().flatten().map(direction).fold((0.0, 0.0), |(x, y), (u, v)| (x - v, y + u));
        outer.push(at);
        inner.push(p(at.x + left.0, at.y + left.1));
        let (length, (x, y)) = (4.0 * (turns + 1 - corner.saturating_sub(1) / 2) as f64, direction(corner));
        at = p(at.x + length * x, at.y + length * y);
    }
    inner.reverse();
    Polygon::new(&[outer, inner].concat()).expect("a simple polygon")
}

/// Polygons of 17 to some hundred corners, about 100 m wide.
fn jagged(random: &mut Random) -> Polygon {
    let n = 17 + random.below(300) as usize;
    match random.below(5) {
        0 => skyline(random, n),
        1 => spiral(4 + n / 20),
        2 => Polygon::new(&round(p(50.0, 50.0), 50.0, n, random.uniform())).expect("a simple polygon"),
        3 => Polygon::new(&star(p(50.0, 50.0), 50.0, n, random.uniform())).expect("a simple polygon"),
        _ => {
            let corner = |i: usize| {
                let (sin, cos) = libm::sincos(TAU * (i as f64 + 0.9 * random.uniform()) / n as f64);
                let radius = 5.0 + 45.0 * random.uniform();
                p(50.0 + radius * cos, 50.0 + radius * sin)
            };
            Polygon::new(&(0..n).map(corner).collect::<Vec<_>>()).expect("corners in order round a centre")
        }
    }
}

/// By the crossings of all edges with a ray, exact.
fn contains(polygon: &Polygon, at: Point) -> bool {
    let mut is_inside = false;
    for Segment { a, b } in polygon.edges() {
        if intersects_segment_segment(&Segment::new(a, b), &Segment::new(at, at)) {
            return true;
        }
        is_inside ^= (a.y > at.y) != (b.y > at.y) && (orientation(a, b, at) > 0.0) == (b.y > a.y);
    }
    is_inside
}

fn least(distances: impl Iterator<Item = f64>) -> f64 {
    distances.fold(f64::INFINITY, f64::min)
}

#[wasm_bindgen_test(unsupported = test)]
fn every_answer_is_that_of_a_search_through_all_edges() {
    let mut random = random(1);
    let (mut inside, mut met, mut polygons_met) = (0, 0, 0);
    let count = cases(400);
    for _ in 0..count {
        let polygon = jagged(&mut random);
        let mut point = || p(120.0 * random.uniform() - 10.0, 120.0 * random.uniform() - 10.0);
        let corner = polygon.vertices()[polygon.vertices().len() / 3];
        let beside = p(corner.x + 10.0, corner.y);
        for at in [point(), point(), corner, beside, p(corner.x.round(), corner.y.round())] {
            let expected = contains(&polygon, at);
            assert_eq!(polygon.contains(at), expected, "{at} in {polygon:?}");
            let border = least(polygon.edges().map(|edge| distance_point_segment(at, &edge)));
            assert_eq!(distance_point_polygon(at, &polygon), if expected { 0.0 } else { border });
            assert_eq!(signed_distance_point_polygon(at, &polygon), if expected { -border } else { border });
            inside += usize::from(expected);
        }
        let other = point();
        for s in [Segment::new(point(), point()), Segment::new(corner, other), Segment::new(other, other)] {
            let expected = contains(&polygon, s.a) || polygon.edges().any(|e| intersects_segment_segment(&s, &e));
            assert_eq!(intersects_segment_polygon(&s, &polygon), expected, "{s:?} and {polygon:?}");
            let distance = least(polygon.edges().map(|edge| distance_segment_segment(&s, &edge)));
            let distance = if contains(&polygon, s.a) { 0.0 } else { distance };
            assert_eq!(distance_segment_polygon(&s, &polygon), distance, "{s:?} and {polygon:?}");
            // Of those far away no more than that is asked.
            let placed = Placed::resting(&polygon);
            let most = 60.0 * random.uniform();
            let found = placed.distance_to_segment(&s, most, &mut 0);
            assert!(if distance < most { found == distance } else { found >= most }, "{found} for {distance}, {most}");
            met += usize::from(expected);
            let near = s.aabb();
            let mut edges = Vec::new();
            polygon.any_edge_near(&near, |i, edge| {
                edges.push((i, *edge));
                false
            });
            let all = polygon.edges().enumerate().filter(|(_, edge)| edge.aabb().intersects(&near));
            assert_eq!(edges, all.collect::<Vec<_>>());
        }
        let (sin, cos) = libm::sincos(TAU * random.uniform());
        let direction = Vector::new(cos, sin);
        let along = polygon.vertices().iter().map(|v| direction.dot(&v.coords));
        assert_eq!(polygon.support(direction), along.fold(f64::NEG_INFINITY, f64::max));
        // Beside each other, or one in or across the other; and placed as a whole or as far as is needed.
        let small = if random.below(2) == 0 { jagged(&mut random) } else { crate::geometry::whole(&mut random) };
        let pose = [160.0 * random.uniform() - 80.0, 160.0 * random.uniform() - 80.0, TAU * random.uniform()];
        let moved = small.placed(pose);
        let holds = contains(&polygon, moved.vertices()[0]) || contains(&moved, polygon.vertices()[0]);
        let between = polygon.edges().map(|s| least(moved.edges().map(|t| distance_segment_segment(&s, &t))));
        let expected = if holds { 0.0 } else { least(between) };
        assert_eq!(distance_polygon_polygon(&polygon, &moved), expected, "{polygon:?} and {moved:?}");
        assert_eq!(intersects_polygon_polygon(&polygon, &moved), expected == 0.0, "{polygon:?} and {moved:?}");
        let placed = Placed::new(&small, pose);
        assert_eq!(placed.distance(&Placed::resting(&polygon), f64::INFINITY, &mut 0), expected);
        assert_eq!(placed.distance_to_point(corner, f64::INFINITY, &mut 0), distance_point_polygon(corner, &moved));
        assert_eq!(placed.contains(corner), contains(&moved, corner));
        polygons_met += usize::from(expected == 0.0);
    }
    assert!(inside > count && inside < 4 * count, "{inside} of {count}");
    assert!(met > count / 2 && met < 3 * count, "{met} of {count}");
    assert!(polygons_met > count / 10 && polygons_met < count, "{polygons_met} of {count}");
}

/// The most comparisons of one query, and those of all.
fn work_of(queries: impl Iterator<Item = u64>) -> (u64, u64) {
    queries.fold((0, 0), |(most, all), work| (most.max(work), all + work))
}

#[wasm_bindgen_test(unsupported = test)]
fn comparisons_hardly_grow_with_the_corners() {
    const QUERIES: u64 = 300;
    let mut random = random(2);
    let polygon = skyline(&mut random, 5000);
    let placed = Placed::resting(&polygon);
    let mut point = |height: f64| p(100.0 * random.uniform(), height * random.uniform());
    let counted = |query: &dyn Fn(&mut u64)| {
        let mut work = 0;
        query(&mut work);
        work
    };
    let points: Vec<Point> = (0..QUERIES).map(|_| point(100.0)).collect();
    let to_points = points.iter().map(|&at| counted(&|work| _ = placed.distance_to_point(at, f64::INFINITY, work)));
    let (most, all) = work_of(to_points);
    assert!(most < 2000 && all < 200 * QUERIES, "at most {most}, {all} in all");
    // A disc that moves a little asks for no more than its radius.
    let moved = |at: &Point| Segment::new(*at, p(at.x + 2.0, at.y + 1.0));
    let to_segments = points.iter().map(|at| counted(&|work| _ = placed.distance_to_segment(&moved(at), 0.5, work)));
    let (most, all) = work_of(to_segments);
    assert!(most < 2000 && all < 100 * QUERIES, "at most {most}, {all} in all");
    // Two bodies of 500 corners side by side: of their 250,000 pairs of edges.
    let body = Polygon::new(&star(p(0.0, 0.0), 1.0, 250, 0.0)).expect("a simple polygon");
    let poses: Vec<[f64; 3]> = points.iter().map(|at| [2.0 + 0.05 * at.y, 0.0, at.x]).collect();
    let resting = Placed::resting(&body);
    let to_bodies =
        poses.iter().map(|&at| counted(&|work| _ = Placed::new(&body, at).distance(&resting, f64::INFINITY, work)));
    let (most, all) = work_of(to_bodies);
    assert!(most < 12_000 && all < 3000 * QUERIES, "at most {most}, {all} in all");
    let within = poses.iter().map(|&at| counted(&|work| _ = Placed::new(&body, at).distance(&resting, 0.01, work)));
    let (most, all) = work_of(within);
    assert!(most < 12_000 && all < 300 * QUERIES, "at most {most}, {all} in all");
}

#[wasm_bindgen_test(unsupported = test)]
fn small_convex_pieces_cover_the_polygon_and_have_few_corners() {
    let mut random = random(3);
    let area = |polygon: &Polygon| {
        let corners = polygon.vertices();
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(a, b)| 0.5 * (a.x * b.y - b.x * a.y)).sum::<f64>()
    };
    for _ in 0..cases(100) {
        let polygon = jagged(&mut random);
        let most = 3 + random.below(30) as usize;
        let pieces = small_convex_pieces(&polygon, most);
        for piece in &pieces {
            let again = Polygon::new(piece.vertices()).expect("a simple polygon");
            assert!(again.is_convex() && piece.is_convex() && piece.vertices().len() <= most, "{piece:?}");
            assert!(piece.vertices().iter().all(|v| polygon.vertices().contains(v)));
        }
        let (whole, sum) = (area(&polygon), pieces.iter().map(area).sum::<f64>());
        assert!((whole - sum).abs() <= 1e-9 * whole, "{sum} of {whole}");
        if polygon.vertices().len() <= most {
            assert_eq!(pieces, convex_pieces(&polygon));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn one_polygon_is_the_same_obstacle_as_its_pieces() {
    let mut random = random(4);
    let skyline = skyline(&mut random, if deep() { 5000 } else { 400 });
    let worlds = [vec![Obstacle::Polygon(skyline.clone())], pieces_of_skyline(&skyline)];
    let [one, pieces] = worlds.map(|obstacles| CollisionWorld::from(&world([0.0, -2.0], [100.0, 100.0], obstacles)));
    for radius in [0.0, 0.5] {
        let robot = DiscRobot::new(radius).expect("a radius");
        let [one, pieces] = [&one, &pieces].map(|world| DiscValidity::new(&robot, world.clone()));
        let mut free = 0;
        for _ in 0..1000 {
            let a: [f64; 2] = [1.0 + 98.0 * random.uniform(), 99.0 * random.uniform()];
            let b = [a[0] + 20.0 * (random.uniform() - 0.5), a[1] + 20.0 * (random.uniform() - 0.5)];
            let is_free = one.is_motion_free(&a, &b);
            assert_eq!(is_free, pieces.is_motion_free(&a, &b), "{a:?} to {b:?}, radius {radius}");
            free += u32::from(is_free);
        }
        assert!((200..800).contains(&free), "{free}");
    }
    let arm = Arm::new(p(50.0, 80.0), vec![16.0, 12.0, 8.0], 0.3, None).expect("an arm");
    let [by_one, by_pieces] =
        [&one, &pieces].map(|world| ArmValidity::<3>::new(&arm, joint_space(&arm, Metric::Sum), world.clone(), 1e-4));
    let mut free = 0;
    for _ in 0..cases(200) {
        let mut q = || [(); 3].map(|()| TAU * random.uniform());
        let (a, b) = (q(), q());
        let is_free = by_one.is_motion_free(&a, &b);
        assert_eq!(is_free, by_pieces.is_motion_free(&a, &b), "{a:?} to {b:?}");
        // The proof by distances is the oracle.
        assert!(is_free || by_one.first_hit_by_distances(&a, &b).is_some(), "{a:?} to {b:?}");
        free += u32::from(is_free);
    }
    assert!(free > 3, "{free}");
}

#[wasm_bindgen_test(unsupported = test)]
fn bodies_of_many_corners_are_proven_free_as_by_distances() {
    let mut random = random(5);
    for jagged in [false, true] {
        let shape = |center: Point, size: f64, n: usize| {
            let corners = if jagged { star(center, size, n / 2, 0.1) } else { round(center, size, n, 0.1) };
            Polygon::new(&corners).expect("a simple polygon")
        };
        let body = shape(p(0.1, 0.0), 0.4, 200);
        let obstacles: Vec<Obstacle> = (0..9)
            .map(|i| Obstacle::Polygon(shape(p(1.5 + f64::from(i % 3) * 3.0, 1.5 + f64::from(i / 3) * 3.0), 0.8, 200)))
            .collect();
        let world = world([0.0, 0.0], [9.0, 9.0], obstacles);
        let collision = BodyCollision::new(&body, &world, 1e-4);
        let (mut free, mut refused) = (0, 0);
        for _ in 0..cases(200).max(30) {
            let mut pose = || [9.0 * random.uniform(), 9.0 * random.uniform(), TAU * random.uniform()];
            let (from, to) = (pose(), pose());
            let part = random.uniform();
            let motion = straight(from, [0, 1, 2].map(|i| from[i] + part * (to[i] - from[i])));
            assert_eq!(collision.is_free(&from), collision.contacts(&from).is_empty(), "{from:?}");
            if !collision.is_free(&from) {
                continue;
            }
            let before = collision.clearance_evaluations();
            let is_free = collision.is_motion_free(&motion);
            let work = collision.clearance_evaluations() - before;
            assert!(work < 400_000, "{work} evaluations for {motion:?}");
            let by_distances = collision.first_hit_by_distances(&motion).is_none();
            assert!(is_free || !by_distances, "refused, though distances prove it free: {motion:?}");
            if is_free {
                assert!(
                    (0..=100).all(|i| collision.contacts(&motion.at(f64::from(i) / 100.0)).is_empty()),
                    "{motion:?}"
                );
            }
            free += u32::from(is_free);
            refused += u32::from(!is_free);
        }
        assert!(free > 0 && refused > 0, "{free} free, {refused} refused");
    }
}

/// A fleet of equal stars in a square, each at its start.
fn stars(count: usize, corners: usize, moves: bool) -> serde_json::Value {
    let shape: Vec<[f64; 2]> = star(p(0.0, 0.0), 0.4, corners / 2, 0.0).iter().map(|v| [v.x, v.y]).collect();
    let side = (count as f64).sqrt().ceil() as usize;
    let robot = |i: usize| {
        let start = [i % side, i / side].map(|at| at as f64 + 0.5);
        let goal = if moves { [side as f64 - start[0], start[1] + 2.0] } else { start };
        json!({
            "name": format!("r{i}"), "start": [start[0], start[1], 0], "goal": [goal[0], goal[1], i32::from(moves)],
            "robot": { "type": "rigid_body", "shape": { "type": "polygon", "vertices": shape } },
        })
    };
    json!({
        "format": "planarium-fleet-1", "name": "stars",
        "world": { "bounds": { "min": [0, 0], "max": [side, side + 2] }, "obstacles": [] },
        "robots": (0..count).map(robot).collect::<Vec<_>>(),
    })
}

#[wasm_bindgen_test(unsupported = test)]
fn a_fleet_of_bodies_with_many_corners_is_read_and_planned_for_in_small_steps() {
    Fleet::read(&stars(50, 500, false)).expect("a fleet whose robots stand apart");
    let fleet = Fleet::read(&stars(3, 100, true)).expect("a fleet");
    let pbs = PbsOptions { samples: Some(40), ..PbsOptions::default() };
    let options = FleetOptions { planner: Some(pbs.into()), seed: 1, order: None };
    let mut planner = FleetPlanner::new(&fleet, &options).expect("options");
    let mut spread = 0;
    loop {
        let before = planner.stats();
        let status = planner.step(1);
        let after = planner.stats();
        // The expansion goes on in the next step.
        let is_part = after.expanded == before.expanded && after.pair_checks > before.pair_checks;
        spread += u32::from(is_part && status == Status::Running);
        assert!(after.pair_checks - before.pair_checks < 20_000);
        if status != Status::Running {
            assert_eq!(status, Status::Solved);
            break;
        }
    }
    assert!(spread > 3, "{spread} steps end within an expansion");
    let mut again = FleetPlanner::new(&fleet, &options).expect("options");
    again.step(u64::MAX);
    assert_eq!(again.result().fingerprint, planner.result().fingerprint);
    assert!(verify(&fleet, &planner.result()).expect("its own result").is_valid());
}

#[wasm_bindgen_test(unsupported = test)]
fn five_thousand_corners_are_read_at_once_and_planned_around() {
    let mut random = random(6);
    let corners: Vec<[f64; 2]> = skyline(&mut random, 5000).vertices().iter().map(|v| [v.x, v.y]).collect();
    let scenario = parse(
        &json!({
            "format": "planarium-scenario-1", "name": "skyline",
            "world": { "bounds": { "min": [0, -2], "max": [100, 100] }, "obstacles": [ { "type": "polygon", "vertices": corners } ] },
            "robot": { "type": "disc", "radius": 0.5 },
            "queries": [ { "name": "across", "start": [1, 70], "goal": [99, 70] } ]
        })
        .to_string(),
    );
    let run = crate::common::finish(crate::common::begin_with(&scenario, "rrt-connect", 1, ""));
    crate::common::assert_valid(&scenario, &*run);
    let around = Aabb { min: p(40.0, 0.0), max: p(41.0, 100.0) };
    let Obstacle::Polygon(polygon) = &scenario.world().obstacles[0] else { panic!("it is a polygon") };
    let mut edges = 0;
    polygon.any_edge_near(&around, |_, _| {
        edges += 1;
        false
    });
    assert!((40..70).contains(&edges), "{edges}");
}
