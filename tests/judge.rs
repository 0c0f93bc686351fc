//! The judge of paths of any origin: against dense samples by other code, and by hand.

use crate::common::documents::{disc, limited_arm, polygon, rectangle, refuses, text};
use planarium::geometry::{Point, Segment, arc_pose, distance_point_segment, distance_segment_segment};
use planarium::path::{Blocked, FirstContact, JudgeOptions, Judgement, TurnFault, judge};
use planarium::random::{Random, Stream};
use planarium::scenario::Scenario;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

const ROOM: &str = "[-4, -4], [4, 4]";

/// The short way from one angle to another.
fn turn(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(TAU);
    if turn > PI { turn - TAU } else { turn }
}

/// A robot, by what this file computes itself.
#[derive(Clone)]
enum Kind {
    Disc(f64),
    Arm(Vec<f64>, f64),
    /// Corners, margin, and whether it moves along arcs.
    Body(Vec<Point>, f64, bool),
}

/// An obstacle: edges, and how far it reaches beyond them.
struct Shape {
    ring: Vec<Point>,
    radius: f64,
}

fn ring(corners: &[Point]) -> Vec<Segment> {
    (0..corners.len()).map(|i| Segment::new(corners[i], corners[(i + 1) % corners.len()])).collect()
}

/// By the number of crossings of a ray.
fn contains(corners: &[Point], p: Point) -> bool {
    let crosses = |s: &&Segment| {
        (s.a.y > p.y) != (s.b.y > p.y) && p.x < s.a.x + (p.y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x)
    };
    ring(corners).iter().filter(crosses).count() % 2 == 1
}

impl Kind {
    /// Its segments at a configuration, and how far it reaches beyond them.
    fn placed(&self, q: &[f64]) -> (Vec<Segment>, f64) {
        match self {
            Self::Disc(radius) => (vec![Segment::new(Point::new(q[0], q[1]), Point::new(q[0], q[1]))], *radius),
            Self::Arm(links, radius) => {
                let (mut at, mut angle) = (Point::origin(), 0.0);
                let link = |(length, q): (&f64, &f64)| {
                    angle += q;
                    let from = at;
                    at = Point::new(at.x + length * angle.cos(), at.y + length * angle.sin());
                    Segment::new(from, at)
                };
                (links.iter().zip(q).map(link).collect(), *radius)
            }
            Self::Body(corners, margin, _) => {
                let (sin, cos) = q[2].sin_cos();
                let place = |p: &Point| Point::new(q[0] + cos * p.x - sin * p.y, q[1] + sin * p.x + cos * p.y);
                (ring(&corners.iter().map(place).collect::<Vec<_>>()), *margin)
            }
        }
    }

    /// The clearance from all obstacles, and the depth in the room.
    fn clearance(&self, q: &[f64], obstacles: &[Shape]) -> (f64, f64) {
        let (own, radius) = self.placed(q);
        let corners: Vec<Point> = own.iter().map(|s| s.a).collect();
        let distance = |shape: &Shape| {
            let edges = ring(&shape.ring);
            let is_inside = (shape.ring.len() > 2 && own.iter().any(|s| contains(&shape.ring, s.a)))
                || (matches!(self, Self::Body(..)) && contains(&corners, shape.ring[0]));
            let apart = own.iter().flat_map(|s| edges.iter().map(move |t| distance_segment_segment(s, t)));
            if is_inside { -1.0 } else { apart.fold(f64::INFINITY, f64::min) - shape.radius - radius }
        };
        let room = own.iter().flat_map(|s| [s.a, s.b]).map(|p| 4.0 - p.x.abs().max(p.y.abs()) - radius);
        (obstacles.iter().map(distance).fold(f64::INFINITY, f64::min), room.fold(f64::INFINITY, f64::min))
    }

    /// The configuration at a fraction of an edge.
    fn between(&self, a: &[f64], b: &[f64], t: f64) -> Vec<f64> {
        if let Self::Body(_, _, true) = self {
            // The waypoints lie on arcs.
            let (angle, chord) = (turn(a[2], b[2]), [b[0] - a[0], b[1] - a[1]]);
            let middle = a[2] + 0.5 * angle;
            let along = chord[0] * middle.cos() + chord[1] * middle.sin();
            let length = if angle == 0.0 { along } else { along * 0.5 * angle / (0.5 * angle).sin() };
            return arc_pose([a[0], a[1], a[2]], length, angle, t).to_vec();
        }
        let is_angle = |i: usize| matches!(self, Self::Arm(..)) || i == 2;
        let step = |i: usize| if is_angle(i) { turn(a[i], b[i]) } else { b[i] - a[i] };
        (0..a.len()).map(|i| a[i] + t * step(i)).collect()
    }

    fn document(&self) -> String {
        match self {
            Self::Disc(radius) => format!(r#"{{"type": "disc", "radius": {radius:?}}}"#),
            Self::Arm(links, radius) => limited_arm(links, *radius, &[]),
            Self::Body(corners, margin, _) => {
                let corners: Vec<[f64; 2]> = corners.iter().map(|p| [p.x, p.y]).collect();
                format!(r#"{{"type": "rigid_body", "shape": {}, "margin": {margin:?}}}"#, polygon(&corners))
            }
        }
    }
}

/// A robot, obstacles and a path, drawn at random.
fn drawn(random: &mut Random) -> (Kind, Vec<Shape>, Scenario, Vec<Vec<f64>>) {
    let kind = match random.below(5) {
        0 => Kind::Disc(0.0),
        1 => Kind::Disc(0.1),
        2 => Kind::Arm(vec![1.2, 0.9, 0.5], 0.02),
        n => {
            let corners = [[-0.1, -0.15], [0.6, -0.15], [0.2, 0.0], [0.6, 0.15], [-0.1, 0.15]];
            let margin = 0.03 * random.below(2) as f64;
            Kind::Body(corners.map(|[x, y]| Point::new(x, y)).to_vec(), margin, n == 4)
        }
    };
    let (mut shapes, mut documents) = (Vec::new(), Vec::new());
    while shapes.len() < 5 {
        let mut place = |size: f64| [0, 1].map(|_| size * (random.uniform() - 0.5));
        let [x, y] = place(8.0);
        let shape = if shapes.len() < 2 {
            Shape { ring: vec![Point::new(x, y)], radius: 0.3 }
        } else {
            let corners = [[0.0, 0.0], [0.5, 0.0], [0.1, 0.1], [0.0, 0.5]];
            let [u, v] = place(1.0);
            Shape { ring: corners.map(|[a, b]| Point::new(x + a + u * b, y + b + v * a)).to_vec(), radius: 0.0 }
        };
        if shape.ring.iter().any(|p| p.coords.norm() < 0.6) {
            continue;
        }
        documents.push(match &shape.ring[..] {
            [center] => disc([center.x, center.y], shape.radius),
            corners => polygon(&corners.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>()),
        });
        shapes.push(shape);
    }
    let scenario = text("s", ROOM, &documents.join(","), &kind.document(), "");
    let scenario = Scenario::parse(&scenario).unwrap_or_else(|error| panic!("{error}: {scenario}"));
    let mut path: Vec<Vec<f64>> = Vec::new();
    for _ in 0..4 {
        let q = match (&kind, path.last()) {
            (Kind::Body(_, _, true), Some(last)) => {
                let [length, angle] = [1.5, 3.0].map(|size| size * (random.uniform() - 0.5));
                arc_pose([last[0], last[1], last[2]], length, angle, 1.0).to_vec()
            }
            (Kind::Disc(_), _) => [0, 1].map(|_| 7.0 * (random.uniform() - 0.5)).to_vec(),
            _ => [7.0, 7.0, 9.0].map(|size| size * (random.uniform() - 0.5)).to_vec(),
        };
        path.push(q);
    }
    (kind, shapes, scenario, path)
}

fn judged(scenario: &Scenario, path: &[Vec<f64>], arcs: bool) -> Judgement {
    judge(scenario, path, &JudgeOptions { arcs, ..JudgeOptions::default() }).expect("a path")
}

#[wasm_bindgen_test(unsupported = test)]
fn random_paths_are_judged_as_by_dense_samples() {
    const SAMPLES: usize = 1000;
    let mut random = Random::new(17, Stream::Samples);
    let (mut free, mut blocked, mut left) = (0, 0, 0);
    for case in 0..if cfg!(target_arch = "wasm32") { 25 } else { 1000 } {
        let (kind, obstacles, scenario, path) = drawn(&mut random);
        let judgement = judged(&scenario, &path, matches!(kind, Kind::Body(_, _, true)));
        // A place as one number: the edge and the fraction.
        let end = judgement.contact.as_ref().map_or(f64::INFINITY, |c| c.at.edge as f64 + c.at.fraction);
        let (mut least, mut travel) = (f64::INFINITY, 0.0_f64);
        for (i, pair) in path.windows(2).enumerate() {
            for k in 0..=SAMPLES {
                let t = k as f64 / SAMPLES as f64;
                let q = kind.between(&pair[0], &pair[1], t);
                let (clearance, depth) = kind.clearance(&q, &obstacles);
                assert!(
                    i as f64 + t >= end || (clearance > -1e-9 && depth > -1e-9),
                    "case {case}: at {i} + {t} it is {clearance} from obstacles and {depth} inside, before {end}"
                );
                least = least.min(clearance);
            }
            let steps = pair[0].iter().zip(&pair[1]).map(|(a, b)| (b - a).abs().min(TAU));
            travel = travel.max(4.0 * steps.sum::<f64>() / SAMPLES as f64);
        }
        match &judgement.contact {
            Some(FirstContact { at, with, point, .. }) => {
                let q = kind.between(&path[at.edge], &path[(at.edge + 1).min(3)], at.fraction);
                let (clearance, depth) = kind.clearance(&q, &obstacles);
                let gap = q.iter().zip(&at.configuration).map(|(a, b)| turn(*a, *b).abs()).fold(0.0, f64::max);
                assert!(gap < 1e-9, "case {case}: {q:?} or {:?}", at.configuration);
                let point = point.expect("they touch somewhere");
                let (own, radius) = kind.placed(&q);
                let beside = own.iter().map(|s| distance_point_segment(point, s)).fold(f64::INFINITY, f64::min);
                // At the start the robot may be deep in an obstacle.
                let is_start = at.edge == 0 && at.fraction == 0.0;
                match with {
                    Blocked::Bounds => assert!(depth < 1e-6 && (is_start || depth > -1e-6), "case {case}: {depth}"),
                    Blocked::Obstacle(i) => {
                        let (own, _) = kind.clearance(&q, &obstacles[*i..=*i]);
                        assert!(own < 1e-6 && (is_start || own > -1e-6), "case {case}: {own}, {clearance}");
                    }
                    other => panic!("case {case}: {other:?}"),
                }
                assert!(is_start || beside < radius + 1e-6, "case {case}: {point} is {beside} away");
                if *with == Blocked::Bounds { left += 1 } else { blocked += 1 }
            }
            None => {
                let found = judgement.clearance.expect("there are obstacles");
                assert!(
                    found.at_least <= found.distance && found.distance - found.at_least < 1e-3 * found.distance + 2e-6
                );
                assert!(found.at_least <= least + 1e-9, "case {case}: {} at least, but {least}", found.at_least);
                assert!(found.at_least >= least - travel, "case {case}: {} at least, but {least}", found.at_least);
                let q = kind.between(&path[found.at.edge], &path[(found.at.edge + 1).min(3)], found.at.fraction);
                let (own, _) = kind.clearance(&q, &obstacles[found.obstacle..=found.obstacle]);
                assert!((own - found.distance).abs() < 1e-9, "case {case}: {own}, not {}", found.distance);
                let (own, radius) = kind.placed(&q);
                let beside = own.iter().map(|s| distance_point_segment(found.point, s)).fold(f64::INFINITY, f64::min);
                assert!((beside - radius - found.distance).abs() < 1e-9, "case {case}: {beside}");
                free += 1;
            }
        }
    }
    let [least, fewest] = if cfg!(target_arch = "wasm32") { [1, 0] } else { [300, 20] };
    assert!(
        free >= least && blocked >= least && left >= fewest,
        "{free} free, {blocked} blocked, {left} left the room"
    );
}

fn contact(judgement: &Judgement) -> &FirstContact {
    judgement.contact.as_ref().expect("it is not free")
}

fn scenario(robot: &str, obstacles: &[String]) -> Scenario {
    Scenario::parse(&text("s", ROOM, &obstacles.join(","), robot, "")).expect("a scenario")
}

const CAR: &str = r#"{"type": "car", "shape": {"type": "polygon", "vertices": [[-0.1, -0.15], [0.6, -0.15], [0.6, 0.15], [-0.1, 0.15]]},
    "wheelbase": 0.5, "speed": [-1, 1], "steering": [-0.5, 0.5], "margin": 0.05}"#;

#[wasm_bindgen_test(unsupported = test)]
fn contacts_by_hand() {
    let wall = rectangle([1.0, -1.0], [1.5, 1.0]);
    // A point, a disc, and a disc with a margin, towards a wall.
    for (robot, first) in [
        (r#"{"type": "disc", "radius": 0}"#, 1.0),
        (r#"{"type": "disc", "radius": 0.25}"#, 0.75),
        (r#"{"type": "disc", "radius": 0.25, "margin": 0.125}"#, 0.625),
    ] {
        let found = judged(&scenario(robot, std::slice::from_ref(&wall)), &[vec![0.0, 0.5], vec![2.0, 0.5]], false);
        let FirstContact { at, with, part, point } = contact(&found);
        assert_eq!((at.edge, *with, *part), (0, Blocked::Obstacle(0), 0));
        assert!((2.0 * at.fraction - first).abs() < 1e-9 && found.clearance.is_none(), "{at:?}");
        assert!((point.expect("a point") - Point::new(1.0, 0.5)).norm() < 1e-9);
    }
    // The border counts as soon as the robot would leave.
    let out = judged(&scenario(r#"{"type": "disc", "radius": 0.5}"#, &[]), &[vec![0.0, 0.0], vec![0.0, 5.0]], false);
    let FirstContact { at, with, .. } = contact(&out);
    assert!(*with == Blocked::Bounds && (5.0 * at.fraction - 3.5).abs() < 1e-9, "{at:?}");
    // Far outside from the start, and one waypoint only.
    let far = judged(&scenario(CAR, &[]), &[vec![1e5, 0.0, 0.0]], false);
    assert_eq!((contact(&far).with, contact(&far).at.fraction), (Blocked::Bounds, 0.0));
    let alone = judged(&scenario(CAR, std::slice::from_ref(&wall)), &[vec![0.0, 0.0, 0.0]], false);
    assert!(alone.is_free() && alone.clearance.is_some_and(|least| (least.distance - 0.35).abs() < 1e-12));
    // A car keeps its margin, and turns the short way across pi.
    let turned = judged(&scenario(CAR, &[wall]), &[vec![0.0, 0.0, 3.0], vec![0.0, 0.0, -3.0]], false);
    assert!(turned.is_free(), "{turned:?}");
    // An arm: the link, and the limit of a joint.
    let arm = limited_arm(&[1.0, 1.0], 0.1, &[[-1.0, 1.0], [-2.0, 2.0]]);
    let post = disc([1.9, 0.5], 0.1);
    let swung = judged(&scenario(&arm, &[post]), &[vec![0.0, 0.0], vec![0.9, 0.0]], false);
    assert_eq!((contact(&swung).with, contact(&swung).part), (Blocked::Obstacle(0), 1));
    let beyond = judged(&scenario(&arm, &[]), &[vec![0.0, 0.0], vec![0.5, 0.0], vec![1.5, 1.0]], false);
    let FirstContact { at, with, point, .. } = contact(&beyond);
    assert_eq!((at.edge, *with, *point), (1, Blocked::JointLimit(0), None));
    assert!((at.fraction - 0.5).abs() < 1e-12, "{at:?}");
    // Half a turn has no shorter way.
    let half = judged(&scenario(CAR, &[]), &[vec![0.0, 0.0, 0.0], vec![0.0, 1.0, PI]], false);
    assert_eq!(contact(&half).with, Blocked::HalfTurn(2));
}

#[wasm_bindgen_test(unsupported = test)]
fn turns_of_a_car() {
    let world = scenario(CAR, &[]);
    let least = 0.5 / libm::tan(0.5);
    let arc = |radius: f64, angle: f64| {
        let step = |k: i32| arc_pose([0.0, 0.0, 0.4], radius * angle, angle, f64::from(k) / 8.0).to_vec();
        (0..=8).map(step).collect::<Vec<_>>()
    };
    // To both sides, forward and in reverse, at the limit and a little below it.
    for (radius, angle) in [(least, 1.5), (least, -1.5), (-least, 1.5), (-least, -1.5)] {
        let path = arc(radius, angle);
        let sharp = judged(&world, &path, true);
        assert!(sharp.is_free() && sharp.is_drivable(), "{sharp:?}");
        let radius = 0.98 * radius;
        let tight = judged(&world, &arc(radius, angle), true).turns.expect("a car has turns");
        assert_eq!((tight.count, tight.first[0].edge, tight.first[0].fault), (8, 0, TurnFault::TooTight));
        assert!(tight.least_radius.is_some_and(|found| (found - radius.abs()).abs() < 1e-9), "{tight:?}");
        let options = JudgeOptions { drive_tolerance: 0.03, ..JudgeOptions::default() };
        assert!(judge(&world, &arc(radius, angle), &options).is_ok_and(|found| found.is_drivable()));
    }
    let fault = |path: &[Vec<f64>]| {
        let turns = judged(&world, path, false).turns.expect("a car has turns");
        turns.first.first().map(|turn| turn.fault)
    };
    assert_eq!(fault(&[vec![0.0, 0.0, 0.0], vec![1.0, 0.0, 0.0], vec![0.5, 0.0, 0.0]]), None);
    assert_eq!(fault(&[vec![0.0, 0.0, 0.0], vec![1.0, 0.02, 0.0]]), Some(TurnFault::Sideways));
    assert_eq!(fault(&[vec![0.0, 0.0, 0.0], vec![0.0, 0.0, 1.0]]), Some(TurnFault::TooTight));
    assert_eq!(fault(&[vec![0.0, 0.0, 0.0], vec![0.0, 0.0, 0.0]]), None);
    let forward = scenario(&CAR.replace("[-1, 1]", "[0, 1]"), &[]);
    let back = judged(&forward, &[vec![0.0, 0.0, 0.0], vec![-1.0, 0.0, 0.0]], false).turns.expect("a car has turns");
    assert_eq!(back.first[0].fault, TurnFault::NoSpeed);
    // An arc of a quarter passes a corner that the straight way between its ends cuts.
    let quarter = [vec![0.0, 0.0, 0.0], vec![2.0, 2.0, FRAC_PI_2]];
    let post = scenario(CAR, &[disc([0.65, 0.95], 0.05)]);
    assert!(judged(&post, &quarter, true).is_free() && !judged(&post, &quarter, false).is_free());
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_no_path_is_refused() {
    let world = scenario(r#"{"type": "disc", "radius": 0.1}"#, &[]);
    let judged = |path: &[Vec<f64>], options: JudgeOptions| judge(&world, path, &options);
    let plain = JudgeOptions::default();
    refuses(judged(&[], plain), "out-of-range", "/path");
    refuses(judged(&[vec![0.0, 0.0], vec![0.0]], plain), "wrong-dimension", "/path/1");
    refuses(judged(&[vec![0.0, f64::NAN]], plain), "not-finite", "/path/0/1");
    refuses(judged(&[vec![2e6, 0.0]], plain), "out-of-range", "/path/0/0");
    refuses(judged(&[vec![0.0, 0.0]], JudgeOptions { arcs: true, ..plain }), "unsupported", "/arcs");
    let negative = JudgeOptions { drive_tolerance: -0.1, ..plain };
    refuses(judged(&[vec![0.0, 0.0]], negative), "out-of-range", "/drive_tolerance");
}

/// A million waypoints around a room, natively.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn a_million_waypoints_take_seconds() {
    let posts: Vec<String> =
        (0..400).map(|i| disc([0.05 * f64::from(i % 20), 0.05 * f64::from(i / 20)], 0.01)).collect();
    let world = scenario(CAR, &posts);
    let step = |i: u32| {
        let angle = f64::from(i) * 1e-4;
        vec![2.0 * angle.cos(), 2.0 * angle.sin(), angle + FRAC_PI_2]
    };
    let path: Vec<Vec<f64>> = (0..1_000_000).map(step).collect();
    let begun = std::time::Instant::now();
    let found = judged(&world, &path, true);
    let seconds = begun.elapsed().as_secs_f64();
    assert!(found.is_free() && found.is_drivable(), "{:?}", found.contact);
    println!("a million waypoints: {seconds:.1} s, clearance {:?}", found.clearance);
}
