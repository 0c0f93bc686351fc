//! Rooms of polygons with holes and of walls: which rings are holes, what is written, and what planners, the verifier, shortest paths
//! and certificates say of them.

use crate::common::bodies::{p, polygon};
use crate::common::documents::{WALLS, disc, judged, rectangle, refuses, result, scenario, with};
use crate::common::places::point_gap;
use crate::common::{assert_valid, begin_with, cases, finish, parse, seeds};
use planarium::certificate::{self, Subdivision, Verdict};
use planarium::geometry::{
    HoleFault, Placed, Polygon, PolygonWithHoles, Segment, distance_segment_segment, intersects_segment_segment,
};
use planarium::optimum::{MetricOptions, optimum};
use planarium::problem::Stepped as _;
use planarium::random::{Random, Stream};
use planarium::run::{self, Status};
use planarium::scenario::{Obstacle, Scenario};
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

/// A square ring about the middle of the box, from which a hole of another square is cut.
fn frame([low, high]: [f64; 2], [inner_low, inner_high]: [f64; 2]) -> String {
    let ring = |a: f64, b: f64| format!("[[{a:?}, {a:?}], [{b:?}, {a:?}], [{b:?}, {b:?}], [{a:?}, {b:?}]]");
    format!(r#"{{"type": "polygon", "vertices": {}, "holes": [{}]}}"#, ring(low, high), ring(inner_low, inner_high))
}

fn wall(points: &[[f64; 2]], width: f64, closed: bool) -> String {
    format!(r#"{{"type": "wall", "points": {points:?}, "width": {width:?}, "closed": {closed}}}"#)
}

const ROOM: [[f64; 2]; 4] = [[3.0, 3.0], [7.0, 3.0], [7.0, 7.0], [3.0, 7.0]];

/// The same room with a gap.
const DOORS: [[f64; 2]; 6] = [[5.0, 7.0], [7.0, 7.0], [7.0, 3.0], [3.0, 3.0], [3.0, 7.0], [3.5, 7.0]];

/// Every robot: what its document says besides, and a query from the middle to a place outside the room.
fn robots() -> [(String, &'static str, &'static str); 4] {
    let shape = rectangle([-0.3, -0.15], [0.3, 0.15]);
    let region = r#", "goal_tolerance": {"translation": 0.3, "rotation": 0.7}"#;
    let placed = format!(r#""start": [5, 5, 0], "goal": [1, 1, 0]{region}"#).leak();
    [
        (r#"{"type": "disc", "radius": 0}"#.into(), r#""start": [5, 5], "goal": [1, 1]"#, "rrt-connect"),
        (r#"{"type": "disc", "radius": 0.3}"#.into(), r#""start": [5, 5], "goal": [1, 1]"#, "prm"),
        (format!(r#"{{"type": "rigid_body", "shape": {shape}}}"#), placed, "rrt-connect"),
        (
            format!(
                r#"{{"type": "car", "shape": {shape}, "wheelbase": 0.4, "speed": [-1, 1], "steering": [-0.9, 0.9]}}"#
            ),
            placed,
            "rrt-control",
        ),
    ]
}

#[wasm_bindgen_test(unsupported = test)]
fn a_room_is_left_through_its_gap_alone() {
    for width in [0.0, 1e-6, 0.2] {
        let (closed, open) = (wall(&ROOM, width, true), wall(&DOORS, width, false));
        for (robot, query, planner) in robots() {
            let settings = if planner == "prm" { "samples=1500 k=12" } else { "max_iterations=40000" };
            let solved = scenario("[0, 0], [10, 10]", &open, &robot, query);
            for seed in 0..seeds(12) / 4 {
                let run = finish(begin_with(&solved, planner, seed, settings));
                if planner != "rrt-control" {
                    assert_eq!(run.status(), Status::Solved, "{robot} {width}");
                }
                if run.status() == Status::Solved {
                    assert_valid(&solved, &*run);
                }
            }
            let settings = if planner == "prm" { "samples=400 k=12" } else { "max_iterations=3000" };
            for obstacles in [closed.clone(), frame([2.5, 7.5], [3.0, 7.0])] {
                let shut = scenario("[0, 0], [10, 10]", &obstacles, &robot, query);
                let run = finish(begin_with(&shut, planner, 1, settings));
                assert_eq!(run.status(), Status::Exhausted, "{robot} leaves {obstacles}");
            }
        }
    }
}

/// A path through a wall or the frame of a hole, and one that begins within the frame, are refused by the verifier.
#[wasm_bindgen_test(unsupported = test)]
fn the_verifier_refuses_what_crosses_a_wall_or_lies_in_a_frame() {
    let path = |scenario: &Scenario, path: &str| judged(scenario, &result("s", path, None, 0.0)).map(|_| ());
    for (robot, query, _) in robots().into_iter().take(3) {
        let is_disc = query.contains("[5, 5]");
        let (there, inside) =
            if is_disc { ("[[5, 5], [1, 1]]", "[[2.75, 5]]") } else { ("[[5, 5, 0], [1, 1, 0]]", "[[2.75, 5, 1.57]]") };
        for obstacle in [wall(&ROOM, 0.0, true), wall(&ROOM, 1e-6, true), frame([2.0, 8.0], [3.0, 7.0])] {
            let world = scenario("[0, 0], [10, 10]", &obstacle, &robot, query);
            let why = path(&world, there).expect_err("it crosses");
            assert!(why.contains("obstacle 0"), "{why}");
        }
        let start = if is_disc {
            r#""start": [2.75, 5], "goal": [2.75, 5]"#
        } else {
            r#""start": [2.75, 5, 1.57], "goal": [2.75, 5, 1.57]"#
        };
        let buried = scenario("[0, 0], [10, 10]", &frame([1.0, 9.0], [4.0, 6.0]), &robot, start);
        let why = path(&buried, inside).expect_err("it lies in the frame");
        assert!(why.contains("obstacle 0"), "{why}");
    }
    // A hole that lies wholly within the body is touched, too.
    let ring = frame([4.0, 6.0], [4.9, 5.1]);
    let large = format!(r#"{{"type": "rigid_body", "shape": {}}}"#, rectangle([-0.5, -0.5], [0.5, 0.5]));
    let world = scenario("[0, 0], [10, 10]", &ring, &large, r#""start": [5, 5, 0], "goal": [5, 5, 0]"#);
    assert!(path(&world, "[[5, 5, 0]]").is_err());
    let start = run::start(&world, run::Options::default());
    refuses(start.map(|_| ()), "start-in-collision", "/queries/0/start");
}

#[wasm_bindgen_test(unsupported = test)]
fn rings_touch_in_points_and_no_more() {
    let square = |[x, y]: [f64; 2], [u, v]: [f64; 2]| polygon(&[[x, y], [u, y], [u, v], [x, v]]);
    let outline = || square([0.0, 0.0], [8.0, 8.0]);
    let diamond = |x: f64, y: f64, r: f64| polygon(&[[x - r, y], [x, y - r], [x + r, y], [x, y + r]]);
    let fault = |holes: Vec<Polygon>| PolygonWithHoles::new(outline(), holes).err();
    for holes in [
        vec![square([1.0, 1.0], [2.0, 2.0]), square([3.0, 1.0], [4.0, 2.0])],
        vec![square([1.0, 1.0], [2.0, 2.0]), square([2.0, 2.0], [3.0, 3.0])],
        vec![diamond(2.0, 4.0, 2.0)],
        vec![diamond(4.0, 4.0, 4.0)],
        vec![diamond(2.0, 2.0, 1.0), diamond(4.0, 2.0, 1.0), diamond(3.0, 3.0, 1.0 - 0.5)],
        vec![
            polygon(&[[1.0, 1.0], [7.0, 1.0], [4.0, 4.0]]),
            polygon(&[[1.0, 7.0], [4.0, 4.0], [7.0, 7.0]]),
            polygon(&[[4.0, 4.0], [7.0, 3.0], [7.0, 5.0]]),
        ],
    ] {
        assert_eq!(fault(holes.clone()), None, "{holes:?}");
    }
    for (holes, expected) in [
        (vec![square([1.0, 1.0], [9.0, 2.0])], HoleFault::Crossing(0, 1)),
        (vec![square([0.0, 1.0], [2.0, 2.0])], HoleFault::Crossing(0, 1)),
        (vec![outline()], HoleFault::Crossing(0, 1)),
        (vec![square([9.0, 1.0], [10.0, 2.0])], HoleFault::Outside(1)),
        (vec![square([8.0, 8.0], [9.0, 9.0])], HoleFault::Outside(1)),
        (vec![square([-1.0, -1.0], [9.0, 9.0])], HoleFault::Outside(1)),
        (vec![square([1.0, 1.0], [5.0, 5.0]), square([2.0, 2.0], [3.0, 3.0])], HoleFault::Nested(2, 1)),
        (vec![square([2.0, 2.0], [3.0, 3.0]), square([1.0, 1.0], [5.0, 5.0])], HoleFault::Nested(1, 2)),
        (vec![square([1.0, 1.0], [3.0, 3.0]), square([2.0, 2.0], [4.0, 4.0])], HoleFault::Crossing(1, 2)),
        (vec![square([1.0, 1.0], [3.0, 3.0]), square([3.0, 2.0], [4.0, 4.0])], HoleFault::Crossing(1, 2)),
        (vec![diamond(2.0, 2.0, 1.0), diamond(3.0, 3.0, 1.0)], HoleFault::Crossing(1, 2)),
        // Crossing in corners of both.
        (
            vec![diamond(3.0, 3.0, 2.0), polygon(&[[3.0, 1.0], [6.0, 3.0], [3.0, 5.0], [2.5, 3.0]])],
            HoleFault::Crossing(1, 2),
        ),
    ] {
        assert_eq!(fault(holes.clone()), Some(expected), "{holes:?}");
    }
}

/// Many rings at random: the sweep agrees with a comparison of all pairs.
#[wasm_bindgen_test(unsupported = test)]
fn the_sweep_over_rings_agrees_with_all_pairs() {
    let (mut random, mut good, mut bad) = (Random::new(7, Stream::Samples), 0, 0);
    for _ in 0..cases(2000) {
        // Corners on a coarse grid, so that rings touch often.
        let mut triangle = |side: u64| loop {
            let mut corner = || p(random.below(side) as f64, random.below(side) as f64);
            if let Ok(one) = Polygon::new(&[corner(), corner(), corner()]) {
                return one;
            }
        };
        let holes = vec![triangle(7), triangle(7)];
        let outline = polygon(&[[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]]);
        let is_good = PolygonWithHoles::new(outline, holes.clone()).is_ok();
        // Two triangles in the square are apart inside if no point near a corner, an edge or the middle of one, moved a little into
        // it, lies inside the other.
        let [a, b] = [&holes[0], &holes[1]];
        let inner = |one: &Polygon| {
            let v = one.vertices().to_vec();
            let mut points = Vec::new();
            for i in 0..=24 {
                for j in 0..=24 - i {
                    let (s, t) = ((f64::from(i) + 1e-4) / 24.001, (f64::from(j) + 1e-4) / 24.001);
                    points.push(p(
                        v[0].x + s * (v[1].x - v[0].x) + t * (v[2].x - v[0].x),
                        v[0].y + s * (v[1].y - v[0].y) + t * (v[2].y - v[0].y),
                    ));
                }
            }
            points.retain(|&q| one.contains_inside(q));
            points
        };
        let overlap = inner(a).iter().any(|&q| b.contains_inside(q)) || inner(b).iter().any(|&q| a.contains_inside(q));
        let shared_side = a.edges().any(|s| {
            b.edges().any(|t| {
                let middle = |u: &Segment, x: f64| u.a + (u.b - u.a) * x;
                (1..48).filter(|&k| point_gap(middle(&s, f64::from(k) / 48.0), [t.a, t.b]) < 1e-9).count() > 1
            })
        });
        let on_outline = [a, b].iter().any(|one| {
            one.edges().any(|e| {
                (e.a.x == e.b.x && (e.a.x == 0.0 || e.a.x == 6.0)) || (e.a.y == e.b.y && (e.a.y == 0.0 || e.a.y == 6.0))
            })
        });
        assert_eq!(is_good, !overlap && !shared_side && !on_outline, "{holes:?}");
        (good, bad) = if is_good { (good + 1, bad) } else { (good, bad + 1) };
    }
    assert!(good > 5 && bad > 5, "{good} {bad}");
}

/// A square outline with a hole in many of its cells, of some of which the corners touch.
fn sieve(cells: usize, random: &mut Random) -> PolygonWithHoles {
    let mut holes = Vec::new();
    for i in 0..cells * cells {
        let [x, y] = [i % cells, i / cells].map(|k| k as f64);
        let half = if random.below(3) == 0 { 0.5 } else { 0.1 + 0.35 * random.uniform() };
        let (u, v) = (x + 0.5, y + 0.5);
        if random.below(8) > 0 {
            holes.push(polygon(&[[u - half, v], [u, v - half], [u + half, v], [u, v + half]]));
        }
    }
    // Not in the order of their places.
    for i in (1..holes.len()).rev() {
        holes.swap(i, random.below(i as u64 + 1) as usize);
    }
    let side = cells as f64;
    PolygonWithHoles::new(polygon(&[[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]]), holes).expect("apart")
}

/// What is asked of many holes is what all of them say, one by one.
#[wasm_bindgen_test(unsupported = test)]
fn many_holes_are_searched_as_if_all_were() {
    let mut random = Random::new(11, Stream::Samples);
    let (mut inside, mut outside, mut met) = (0, 0, 0);
    for cells in [2, 4, 5, 17] {
        let sieve = sieve(cells, &mut random);
        let resting: Vec<Placed> = sieve.rings().map(Placed::resting).collect();
        for _ in 0..cases(1200) {
            // Every other place is a corner or the middle of an edge of a cell.
            let on_grid = random.below(2) == 0;
            let mut place = || {
                let at = (cells as f64 + 2.0) * random.uniform() - 1.0;
                if on_grid { libm::round(2.0 * at) / 2.0 } else { at }
            };
            let s = Segment::new(p(place(), place()), p(place(), place()));
            let q = s.a;
            let holds = sieve.outline().contains(q) && !sieve.holes().iter().any(|hole| hole.contains_inside(q));
            assert_eq!(sieve.contains(q), holds, "{q:?}");
            (inside, outside) = if holds { (inside + 1, outside) } else { (inside, outside + 1) };
            let least = |distance: &dyn Fn(&Placed) -> f64| resting.iter().map(distance).fold(f64::INFINITY, f64::min);
            let border = least(&|ring| ring.distance_to_border(q, f64::INFINITY, &mut 0));
            assert_eq!(sieve.signed_distance_to_point(q), if holds { -border } else { border }, "{q:?}");
            let across = sieve.edges().any(|edge| intersects_segment_segment(&s, &edge));
            assert_eq!(sieve.intersects_segment(&s), holds || across, "{s:?}");
            met += usize::from(!holds && across);
            let apart = sieve.edges().map(|edge| distance_segment_segment(&s, &edge)).fold(f64::INFINITY, f64::min);
            let apart = if holds { 0.0 } else { apart };
            for most in [f64::INFINITY, 0.3, 0.01] {
                let found = sieve.distance_to_segment(&s, most);
                assert!(found == apart || (found >= most && apart >= most), "{s:?} {most}: {found} is not {apart}");
            }
            let body = polygon(&[[q.x, q.y], [q.x + 0.3, q.y + 0.1], [q.x + 0.2, q.y + 0.4]]);
            let swallowed = sieve.rings().any(|ring| body.contains(ring.vertices()[0]));
            let pairs = body.edges().flat_map(|e| sieve.edges().map(move |f| distance_segment_segment(&f, &e)));
            let apart = if holds || swallowed { 0.0 } else { pairs.fold(f64::INFINITY, f64::min) };
            assert_eq!(sieve.distance_to_polygon(&Placed::resting(&body), f64::INFINITY), apart, "{body:?}");
        }
    }
    assert!(inside > 30 && outside > 30 && met > 30, "{inside} {outside} {met}");
}

/// Rings whose edges fill many blocks of the sweep, and many at one point: their one fault is found, and no other.
#[wasm_bindgen_test(unsupported = test)]
fn faults_are_found_among_thousands_of_rings() {
    let slit = |y: f64, x: f64| polygon(&[[x, y], [900.0, y + 0.25], [x, y + 0.5]]);
    let outline = || polygon(&[[0.0, 0.0], [1000.0, 0.0], [1000.0, 2000.0], [0.0, 2000.0]]);
    let count = 1500;
    // Beside each other, their left ends in no order.
    let apart: Vec<Polygon> =
        (0..count).map(|i| slit(1.0 + i as f64, 1.0 + ((i * 7919) % count) as f64 / 10.0)).collect();
    assert_eq!(PolygonWithHoles::new(outline(), apart.clone()).err(), None);
    // All with one corner in common.
    let fan: Vec<Polygon> =
        (0..count).map(|i| polygon(&[[1.0, 1000.0], [900.0, 1.0 + i as f64], [900.0, 1.5 + i as f64]])).collect();
    assert_eq!(PolygonWithHoles::new(outline(), fan.clone()).err(), None);
    for at in [0, 700, count - 1] {
        let y = 1.0 + at as f64;
        let ring = at + 1;
        let with = |one: Polygon| [&apart[..], &[one]].concat();
        let crossing = polygon(&[[500.0, y - 0.2], [501.0, y + 0.2], [500.0, y + 0.2]]);
        assert_eq!(PolygonWithHoles::new(outline(), with(crossing)).err(), Some(HoleFault::Crossing(ring, count + 1)));
        let nested = polygon(&[[300.0, y + 0.22], [301.0, y + 0.25], [300.0, y + 0.28]]);
        assert_eq!(PolygonWithHoles::new(outline(), with(nested)).err(), Some(HoleFault::Nested(count + 1, ring)));
        // One that shares a side of the fan.
        let mut shared = fan.clone();
        shared.push(polygon(&[[1.0, 1000.0], [900.0, y], [899.0, y - 0.25]]));
        assert_eq!(PolygonWithHoles::new(outline(), shared).err(), Some(HoleFault::Crossing(ring, count + 1)));
    }
}

/// The same place as a polygon with a hole and as four polygons; as a wall and as a polygon with two discs.
#[wasm_bindgen_test(unsupported = test)]
fn shortest_paths_are_those_among_equal_obstacles() {
    let of = |obstacles: &str, radius: f64, query: &str| {
        let robot = format!(r#"{{"type": "disc", "radius": {radius:?}}}"#);
        optimum(scenario("[0, 0], [10, 10]", obstacles, &robot, query), None, MetricOptions::default()).unwrap().length
    };
    let around = r#""start": [5, 1], "goal": [5.5, 9.5]"#;
    let within = r#""start": [3.7, 3.7], "goal": [6.3, 6.2]"#;
    let sides = [
        rectangle([2.0, 2.0], [8.0, 3.0]),
        rectangle([2.0, 7.0], [8.0, 8.0]),
        rectangle([2.0, 2.0], [3.0, 8.0]),
        rectangle([7.0, 2.0], [8.0, 8.0]),
    ];
    let post = disc([5.0, 5.0], 0.5);
    for radius in [0.0, 0.4] {
        for query in [around, within] {
            let whole = of(&format!("{}, {post}", frame([2.0, 8.0], [3.0, 7.0])), radius, query).unwrap();
            let parts = of(&format!("{}, {post}", sides.join(",")), radius, query).unwrap();
            assert!((whole - parts).abs() < 1e-10, "{whole} {parts}");
        }
        // From a hole to the outside there is no way.
        assert_eq!(of(&frame([2.0, 8.0], [3.0, 7.0]), radius, r#""start": [5, 1], "goal": [5, 5]"#), None);
        for width in [0.5, 1e-3] {
            let line = wall(&[[2.0, 4.0], [5.0, 4.0], [8.0, 4.0]], width, false);
            let half = width / 2.0;
            let same =
                [rectangle([2.0, 4.0 - half], [8.0, 4.0 + half]), disc([2.0, 4.0], half), disc([8.0, 4.0], half)]
                    .join(",");
            let [whole, parts] = [&line, &same].map(|obstacles| of(obstacles, radius, around).unwrap());
            assert!((whole - parts).abs() < 1e-10, "{whole} {parts}");
        }
        // Along a line without width: around its end, an arc of the radius.
        let line =
            of(&wall(&[[2.0, 4.0], [8.0, 4.0]], 0.0, false), radius, r#""start": [5, 1], "goal": [5, 7]"#).unwrap();
        let turn = 1.5 * PI - 2.0 * libm::acos(radius / libm::sqrt(18.0));
        let expected = 2.0 * libm::sqrt(18.0 - radius * radius) + radius * turn;
        assert!((line - expected).abs() < 1e-10, "{line} {expected}");
        // A ring with a gap.
        assert!(of(&wall(&DOORS, 0.2, false), radius, r#""start": [5, 5], "goal": [5, 1]"#).is_some());
        assert_eq!(of(&wall(&ROOM, 0.0, true), radius, r#""start": [5, 5], "goal": [5, 1]"#), None);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn certificates_tell_rooms_with_a_gap_from_those_without() {
    for (obstacles, verdict) in [
        (wall(&DOORS, 0.2, false), Verdict::Connected),
        (wall(&ROOM, 0.2, true), Verdict::Infeasible),
        (frame([2.0, 8.0], [3.0, 7.0]), Verdict::Infeasible),
    ] {
        let robot = r#"{"type": "disc", "radius": 0.2, "margin": 0.1}"#;
        let world = scenario("[0, 0], [10, 10]", &obstacles, robot, r#""start": [5, 5], "goal": [1, 1]"#);
        let options = certificate::Options { clearance: 0.0, cells: 20_000, ..certificate::Options::default() };
        let mut subdivision = Subdivision::new(&world, &options).expect("it starts");
        subdivision.step(u64::MAX);
        let found = subdivision.certificate();
        assert_eq!(found.verdict, verdict, "{obstacles}");
        assert_eq!(certificate::verify(&world, &found).expect("of this scenario"), None, "{obstacles}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn documents_are_written_in_normal_form() {
    let world = parse(WALLS);
    let text = world.to_json_string();
    assert_eq!(parse(&text), world);
    assert!(text.contains(r#""holes":[[[0.5,1],[1,1],[1,0.5],[0.5,0.5]]]"#), "{text}");
    assert!(text.contains(r#""type":"wall","points":[[0.2,1.8],[1,1.9]],"width":0.05,"closed":false"#), "{text}");
    assert!(text.contains(r#""margin":0.01"#), "{text}");
    // Either direction, open or closed, repeated points: the same scenario.
    let other = with(
        WALLS,
        "[[[0.5, 0.5], [1, 0.5], [1, 1], [0.5, 1]]]",
        "[[[0.5, 0.5], [0.5, 1], [1, 1], [1, 1], [1, 0.5], [0.5, 0.5]]]",
    );
    let vertices = |world: &Scenario| world.world().obstacles[0].clone();
    assert_eq!(vertices(&parse(&other)).distance_to_segment(&Segment::new(p(0.75, 0.75), p(0.75, 0.75))), 0.25);
    assert_eq!(vertices(&parse(&other)).points(), 8);
    // No holes are as none.
    let none = with(WALLS, "[[[0.5, 0.5], [1, 0.5], [1, 1], [0.5, 1]]]", "[]");
    assert!(matches!(vertices(&parse(&none)), Obstacle::Polygon(_)));
    assert!(!parse(&none).to_json_string().contains("holes"));
}
