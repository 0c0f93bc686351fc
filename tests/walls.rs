//! Motions and places among polygons with holes and walls, with and without a margin: verdicts agree with simple code of its own.

use crate::common::bodies::{p, polygon, random_body, random_motion, random_placement, straight, world};
use crate::common::documents::{disc, judged, scenario};
use crate::common::places::{Place, SIDE, Tally, extent, random_world, room};
use crate::common::{assert_valid, begin_with, cases, finish};
use planarium::collision::{ArmValidity, BodyCollision, DiscValidity};
use planarium::geometry::{Aabb, Point, Polygon, Segment};
use planarium::path::ResultDocument;
use planarium::problem::Validity;
use planarium::random::{Random, Stream};
use planarium::robot::{Arm, DiscRobot, MAX_LINKS, Part, joint_space};
use planarium::run::Status;
use planarium::scenario::Obstacle;
use planarium::space::{Metric, Space};
use std::f64::consts::PI;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn verdicts_about_discs_and_points_agree_with_dense_samples() {
    let (mut random, mut tally) = (Random::new(1, Stream::Samples), Tally::default());
    for k in 0..cases(500) {
        let radius = [0.0, 0.1, 0.4][k % 3];
        let (world, places) = random_world(&mut random);
        let robot = DiscRobot::new(radius).unwrap();
        let collision = DiscValidity::new(&robot, &world);
        let bounds = world.bounds.unwrap();
        for _ in 0..20 {
            let [a, b] = [0; 2].map(|_| [SIDE * random.uniform(), SIDE * random.uniform()]);
            let b = [0, 1].map(|i| a[i] + 0.4 * (b[i] - a[i]));
            let at = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            let travel = (p(b[0], b[1]) - p(a[0], a[1])).norm();
            let verdict = collision.is_motion_free(&a, &b);
            tally.judge(
                verdict,
                travel,
                (&places, &bounds),
                |t| robot.footprint(&at(t)),
                |t| collision.is_free(&at(t)),
            );
        }
    }
    tally.both();
}

#[wasm_bindgen_test(unsupported = test)]
fn verdicts_about_arms_agree_with_dense_samples() {
    let (mut random, mut tally) = (Random::new(2, Stream::Samples), Tally::default());
    for k in 0..cases(500) {
        let links = [vec![3.0], vec![2.0, 1.5], vec![1.5, 1.0, 1.0]][k % 3].clone();
        let arm = Arm::new(p(5.0, 5.0), links, [0.0, 0.05][k % 2], None).unwrap();
        let (world, places) = random_world(&mut random);
        let base = Part::Disc { center: arm.base(), radius: arm.radius() };
        let bounds = world.bounds.unwrap();
        if room(&[base], &places, &bounds) < 0.01 {
            continue;
        }
        let space = joint_space::<MAX_LINKS>(&arm, Metric::Sum);
        let collision = ArmValidity::new(&arm, space.clone(), &world, 1e-5);
        for _ in 0..20 {
            let [a, b] = [0; 2].map(|_| space.sample(&mut random));
            let b = space.interpolate(&a, &b, 0.3);
            let travel = arm.travel(&space.difference(&a, &b))[arm.links().len() - 1];
            let at = |t: f64| space.interpolate(&a, &b, t);
            let verdict = collision.is_motion_free(&a, &b);
            tally.judge(verdict, travel, (&places, &bounds), |t| arm.footprint(&at(t)), |t| collision.is_free(&at(t)));
        }
    }
    tally.both();
}

/// Judges ten motions of a body among places, within bounds.
fn judge_motions(
    tally: &mut Tally,
    random: &mut Random,
    body: &Polygon,
    collision: &BodyCollision,
    around: (&[Place], &Aabb),
) {
    for _ in 0..10 {
        let from = random_placement(random, 0.5 * SIDE);
        let motion = random_motion(random, from, 0.3 * SIDE);
        let (path, turn) = extent(&motion);
        if turn > PI {
            continue;
        }
        let parts = |t: f64| vec![Part::Polygon { vertices: body.placed(motion.at(t)).vertices().to_vec() }];
        let travel = path + turn * body.reach();
        let verdict = collision.is_motion_free(&motion);
        tally.judge(verdict, travel, around, parts, |t| collision.is_free(&motion.at(t)));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn verdicts_about_bodies_on_lines_and_arcs_agree_with_dense_samples() {
    let (mut random, mut tally) = (Random::new(3, Stream::Samples), Tally::default());
    for _ in 0..cases(1000) {
        let body = random_body(&mut random, 4.0);
        let (world, places) = random_world(&mut random);
        let bounds = world.bounds.unwrap();
        let collision = BodyCollision::new(&body, &world, 1e-5);
        judge_motions(&mut tally, &mut random, &body, &collision, (&places, &bounds));
    }
    tally.both();
}

#[wasm_bindgen_test(unsupported = test)]
fn slits_are_passed_to_the_last_nanometre() {
    for width in [0.0, 1e-6, 0.5] {
        for (spare, passes) in [(1e-9, true), (-1e-9, false), (0.0, false)] {
            let off = 0.25 + width / 2.0 + spare;
            let line = |y: f64| Obstacle::wall(&[p(3.0, y), p(5.0, y), p(7.0, y)], width, false).unwrap();
            let hole =
                [p(1.0, 5.0 - 0.25 - spare), p(9.0, 5.0 - 0.25 - spare), p(9.0, 5.25 + spare), p(1.0, 5.25 + spare)];
            let block = [p(0.5, 2.0), p(9.5, 2.0), p(9.5, 8.0), p(0.5, 8.0)];
            for obstacles in [
                vec![line(5.0 + off), line(5.0 - off)],
                vec![Obstacle::polygon_with_holes(&block, &[hole.to_vec()]).unwrap()],
            ] {
                let world = world([0.0, 0.0], [10.0, 10.0], obstacles);
                let disc = DiscValidity::new(&DiscRobot::new(0.25).unwrap(), &world);
                assert_eq!(disc.is_motion_free(&[2.0, 5.0], &[8.0, 5.0]), passes, "disc {width} {spare}");
                let square = polygon(&[[-0.25, -0.25], [0.25, -0.25], [0.25, 0.25], [-0.25, 0.25]]);
                let body = BodyCollision::new(&square, &world, 1e-4).finest();
                let motion = straight([2.0, 5.0, 0.0], [8.0, 5.0, 0.0]);
                assert_eq!(body.is_motion_free(&motion), passes, "body {width} {spare}");
                let small = polygon(&[[-0.125, -0.125], [0.125, -0.125], [0.125, 0.125], [-0.125, 0.125]]);
                let body = BodyCollision::with_margin(&small, 0.125, &world, 1e-4).finest();
                assert_eq!(body.is_motion_free(&motion), passes, "body with a margin {width} {spare}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_point_touches_a_line_exactly() {
    let line = Obstacle::wall(&[p(0.0, 0.0), p(3.0, 1.0), p(6.0, 0.0)], 0.0, false).unwrap();
    let frame = Obstacle::polygon_with_holes(
        &[p(0.0, 0.0), p(8.0, 0.0), p(8.0, 8.0), p(0.0, 8.0)],
        &[vec![p(1.0, 1.0), p(7.0, 3.0), p(7.0, 7.0), p(1.0, 7.0)]],
    )
    .unwrap();
    let at = |obstacle: &Obstacle, q: Point| obstacle.meets_segment(&Segment::new(q, q)).unwrap();
    assert!(at(&line, p(1.5, 0.5)) && at(&line, p(3.0, 1.0)));
    assert!(!at(&line, p(1.5, 0.5_f64.next_up())) && !at(&line, p(1.5, 0.5_f64.next_down())));
    assert!(
        at(&frame, p(4.0, 2.0)) && !at(&frame, p(4.0, 2.0_f64.next_up())) && at(&frame, p(4.0, 2.0_f64.next_down()))
    );
    // Through the hole, and out of it.
    let crosses = |a: Point, b: Point| frame.meets_segment(&Segment::new(a, b)).unwrap();
    assert!(
        !crosses(p(2.0, 4.0), p(6.5, 6.5)) && crosses(p(2.0, 4.0), p(9.0, 4.0)) && crosses(p(-1.0, 4.0), p(9.0, 4.0))
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_margin_makes_the_robot_larger() {
    // A disc and an arm are those of the larger radius, to the bit.
    let posts =
        [disc([5.0, 5.0], 1.0), r#"{"type": "wall", "points": [[2, 7], [8, 7]], "width": 0.25}"#.to_owned()].join(",");
    let robots = [
        (
            r#"{"type": "disc", "radius": 0.25, "margin": 0.5}"#,
            r#"{"type": "disc", "radius": 0.75}"#,
            r#""start": [1, 1], "goal": [9, 9]"#,
        ),
        (
            r#"{"type": "arm", "base": [1, 2], "links": [2, 2, 1], "radius": 0.125, "margin": 0.125}"#,
            r#"{"type": "arm", "base": [1, 2], "links": [2, 2, 1], "radius": 0.25}"#,
            r#""start": [1.5, 0, 0], "goal": [0, 0, 0]"#,
        ),
    ];
    for (with, without, query) in robots {
        let [with, without] = [with, without].map(|robot| scenario("[0, 0], [10, 10]", &posts, robot, query));
        let runs = [&with, &without].map(|world| finish(begin_with(world, "rrt-connect", 3, "")));
        assert_eq!(runs[0].status(), Status::Solved);
        assert_eq!(runs[0].fingerprint(), runs[1].fingerprint());
        let [result, other] = runs.each_ref().map(|run| run.result());
        assert_eq!((result.margin, other.margin), (Some(with.robot().margin()), None));
        assert_valid(&with, &*runs[0]);
        let wrong = ResultDocument { margin: Some(0.01), ..result };
        assert!(judged(&with, &wrong).unwrap_err().contains("margin"));
    }
    // A body keeps its margin from obstacles and from the bounds, on the way and at rest.
    let mut random = Random::new(9, Stream::Samples);
    let mut tally = Tally::default();
    for _ in 0..cases(200) {
        let (body, margin) = (random_body(&mut random, 3.0), 0.4 * random.uniform());
        let (world, places) = random_world(&mut random);
        let places: Vec<Place> =
            places.into_iter().map(|place| Place { radius: place.radius + margin, ..place }).collect();
        let bounds = world.bounds.unwrap().grown(-margin);
        let collision = BodyCollision::with_margin(&body, margin, &world, 1e-5);
        judge_motions(&mut tally, &mut random, &body, &collision, (&places, &bounds));
    }
    tally.both();
}
