//! The proof law: no accepted motion touches an obstacle, however thin; nothing with clearance to spare is refused.

use crate::common::bodies::{clearance, random_obstacle};
use crate::common::documents::{arm, disc, polygon, rectangle, scenario};
use crate::common::{arm_and_wall, arm_of, assert_valid, begin_with, disc_and_wall, finish, seeds, thick_arm_and_wall};
use planarium::collision::{ArmValidity, CollisionWorld, DiscValidity, Obstacles};
use planarium::geometry::{Aabb, Disc, Point, Segment};
use planarium::problem::{Sampled, Samples, Touched, Validity};
use planarium::random::{Random, Stream};
use planarium::robot::{Arm, DiscRobot, Joint, MAX_LINKS, joint_space, plane};
use planarium::run::Status;
use planarium::scenario::generate::{ForestOptions, Generator};
use planarium::scenario::{Obstacle, Robot, Scenario, World};
use planarium::space::{Metric, ProductSpace, Space};
use wasm_bindgen_test::wasm_bindgen_test;

const THICKNESSES: [f64; 7] = [0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

#[wasm_bindgen_test(unsupported = test)]
fn no_path_of_a_roadmap_or_a_tree_crosses_a_wall_shortened_or_not() {
    let (roadmap, shortcut) = ("samples=250 k=8", "shortcut=30");
    for (world, planner, settings, all) in [
        (&arm_and_wall as &dyn Fn(f64) -> Scenario, "prm", roadmap, 1000),
        (&thick_arm_and_wall, "prm", roadmap, 1000),
        (&|thickness| disc_and_wall(0.0, thickness), "prm", roadmap, 1000),
        (&arm_and_wall, "rrt-connect", "", 1000),
        (&thick_arm_and_wall, "rrt-connect", "", 1000),
        (&thick_arm_and_wall, "rrt-connect", shortcut, 200),
        (&|thickness| disc_and_wall(0.2, thickness), "rrt-connect", "", 1000),
        (&|thickness| disc_and_wall(0.0, thickness), "rrt-connect", shortcut, 200),
    ] {
        let (all, mut solved) = (seeds(all), 0);
        for seed in 0..all {
            let thickness = THICKNESSES[seed as usize % THICKNESSES.len()];
            let scenario = world(thickness);
            let run = finish(begin_with(&scenario, planner, seed, settings));
            if run.status() == Status::Solved {
                solved += 1;
                assert_valid(&scenario, &*run);
            }
        }
        assert!(solved * 10 >= all * 9, "{planner} solved only {solved} of {all}: too few paths were judged");
    }
}

/// An arm's space and validity, of the largest size.
fn arm_in(scenario: &Scenario) -> (ProductSpace<MAX_LINKS>, ArmValidity<MAX_LINKS>) {
    let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
    let space = joint_space(arm, Metric::Sum);
    (space.clone(), ArmValidity::new(arm, space, scenario.world(), 1e-4))
}

fn disc_in(scenario: &Scenario) -> DiscValidity {
    let Robot::Disc(disc) = scenario.robot() else { panic!("a disc") };
    DiscValidity::new(disc, scenario.world())
}

fn arm_worlds() -> Vec<Scenario> {
    let forest = |links| ForestOptions { links, seed: 40 + links as u64 }.generate().expect("a forest");
    let mut worlds: Vec<Scenario> = (2..=4).map(forest).collect();
    worlds.extend([arm_and_wall(1e-3), thick_arm_and_wall(0.1), arm_of(3, true, 0.05), arm_of(8, false, 0.0)]);
    worlds.push(crossed());
    worlds
}

/// An arm in bounds it can touch, among a disc and a concave cross.
fn crossed() -> Scenario {
    let cross = [
        0.5, 0.3, 0.6, 0.3, 0.6, 0.6, 0.9, 0.6, 0.9, 0.7, 0.6, 0.7, 0.6, 1.0, 0.5, 1.0, 0.5, 0.7, 0.2, 0.7, 0.2, 0.6,
        0.5, 0.6,
    ];
    let obstacles = [polygon(cross.as_chunks().0), disc([-0.6, -0.8], 0.25)].join(",");
    scenario("[-1.5, -2], [2, 1.8]", &obstacles, &arm(&[0.7, 0.6, 0.5], 0.02), "")
}

/// Whether the robot touches an obstacle at `q`.
fn touches(scenario: &Scenario, q: &[f64]) -> bool {
    clearance(&scenario.robot().footprint(q), scenario.world()) <= 0.0
}

#[wasm_bindgen_test(unsupported = test)]
fn no_accepted_motion_is_refuted_by_two_thousand_samples() {
    for world in arm_worlds() {
        let (space, validity) = arm_in(&world);
        let mut random = Random::new(2, Stream::Samples);
        for _ in 0..seeds(150) {
            let (a, b) = (space.sample(&mut random), space.sample(&mut random));
            if validity.is_motion_free(&a, &b) {
                for i in 0..=2000 {
                    let q = space.interpolate(&a, &b, f64::from(i) / 2000.0);
                    assert!(!touches(&world, &q), "{}: {a:?} to {b:?} at {i} of 2000", world.name());
                    assert!(i % 100 != 0 || validity.is_free(&q));
                }
            }
        }
    }
}

/// An arm of any size, thin or thick, with limits or without, in any unit of length, among up to a hundred obstacles, in
/// bounds or not. If it slides, some of its joints are prismatic.
fn random_world(random: &mut Random, slides: bool) -> (Arm, World) {
    let scale = [1.0, 1.0, 1e-3, 1e3, 1e5][random.below(5) as usize];
    let links: Vec<f64> = (0..1 + random.below(8)).map(|_| scale * (0.2 + 0.6 * random.uniform())).collect();
    let radius = if random.below(2) == 0 { 0.0 } else { scale * 0.06 * random.uniform() };
    let limits = [None, None, Some([-3.5, 3.0]), Some([-100.0, 100.0])][random.below(4) as usize];
    let limits = limits.map(|limits| vec![limits; links.len()]);
    let base = Point::new(random.uniform() - 0.5, random.uniform() - 0.5);
    let count = [3, 10, 30, 100][random.below(4) as usize];
    let centers = (0..count).map(|_| Point::new(8.0 * random.uniform() - 4.0, 8.0 * random.uniform() - 4.0));
    let centers: Vec<Point> = centers.filter(|center| (center - base).norm() > 1.2).collect();
    // At most as large as leaves the base free.
    let obstacle = |center: Point| random_obstacle(random, center * scale, 1.5 * scale);
    let obstacles = centers.into_iter().map(obstacle).collect();
    let bounds = (random.below(3) == 0).then(|| {
        let [x, y] = [(); 2].map(|()| scale * (0.6 + 2.0 * random.uniform()));
        Aabb { min: Point::new(-x, -y), max: Point::new(y, x) }
    });
    let base = Point::new(base.x * scale, base.y * scale);
    let world = World { bounds, obstacles };
    if !slides {
        return (Arm::new(base, links, radius, limits).expect("an arm"), world);
    }
    let at_least = random.below(links.len() as u64) as usize;
    let joint = |(i, length): (usize, &f64)| {
        if i != at_least && random.below(2) == 0 {
            return Joint::Revolute { limits: limits.as_ref().map(|limits| limits[i]) };
        }
        let range = [-length * random.uniform(), scale * (0.01 + random.uniform())];
        let angle = [0.0, 0.0, 2.0, 20.0, 90.0][random.below(5) as usize] * (2.0 * random.uniform() - 1.0);
        Joint::Prismatic { range, angle }
    };
    let joints = links.iter().enumerate().map(joint).collect();
    (Arm::with_joints(base, links, radius, joints).expect("an arm"), world)
}

#[wasm_bindgen_test(unsupported = test)]
fn in_any_world_the_fast_proof_accepts_what_distances_prove_and_nothing_that_touches() {
    the_fast_proof_agrees_with_distances(false);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_holds_where_links_slide() {
    the_fast_proof_agrees_with_distances(true);
}

fn the_fast_proof_agrees_with_distances(slides: bool) {
    let mut random = Random::new(4, Stream::Samples);
    let (mut accepted, mut refused, mut beyond, mut clear, mut all) = (0, 0, 0, 0, 0);
    for world_number in 0..seeds(400) {
        let (arm, world) = random_world(&mut random, slides);
        let space: ProductSpace<MAX_LINKS> = joint_space(&arm, Metric::Sum);
        let validity = ArmValidity::new(&arm, space.clone(), &world, 1e-4);
        let mut tried = 0;
        for _ in 0..3000 {
            let (a, far) = (space.sample(&mut random), space.sample(&mut random));
            assert_eq!(validity.is_free(&a), validity.contacts(&a).is_empty(), "world {world_number}: {a:?}");
            if !validity.is_free(&a) {
                assert_eq!(validity.first_hit(&a, &far), Some(0.0), "world {world_number}: {a:?} {far:?}");
                continue;
            }
            // Far ends are many turns away where limits are wide.
            let is_wide = arm
                .joint_types()
                .iter()
                .any(|joint| matches!(joint, Joint::Revolute { limits: Some([_, high]) } if *high > 10.0));
            let most = if is_wide { 0.03 } else { 1.0 };
            let b = space.interpolate(&a, &far, most * random.uniform() * random.uniform());
            let (fast, slow) = (validity.is_motion_free(&a, &b), validity.first_hit_by_distances(&a, &b).is_none());
            assert!(fast || !slow, "world {world_number}: refused, though distances prove it free: {a:?} {b:?}");
            let hit = validity.first_hit(&a, &b);
            assert_eq!(fast, hit.is_none(), "world {world_number}: {a:?} {b:?}");
            assert!(hit.is_none_or(|t| (0.0..1.0).contains(&t)), "world {world_number}: {hit:?}");
            let samples = if fast && !slow { 1000 } else { 30 };
            for i in 0..=samples {
                // All of an accepted motion, and of others what lies before the hit: up to contact.
                let q = space.interpolate(&a, &b, hit.unwrap_or(1.0) * f64::from(i) / f64::from(samples));
                let is_touching = !validity.contacts(&q).is_empty();
                assert_eq!(validity.is_free(&q), !is_touching, "world {world_number}: {q:?}");
                assert!(!is_touching || (!fast && i == samples), "world {world_number}: {a:?} {b:?} touches at {q:?}");
            }
            // No contact on the way is missed by the boxes that decide what a changed world leaves as it was.
            let boxes: Vec<Aabb> = world.obstacles.iter().map(Obstacle::aabb).collect();
            for i in 0..=10 {
                for contact in validity.contacts(&space.interpolate(&a, &b, f64::from(i) / 10.0)) {
                    let Touched::Obstacle(obstacle) = contact.with else { continue };
                    assert!(
                        validity.may_meet(&a, &b, &boxes[obstacle..=obstacle]),
                        "world {world_number}: {a:?} {b:?}"
                    );
                }
            }
            clear += boxes.iter().filter(|one| !validity.may_meet(&a, &b, std::slice::from_ref(*one))).count();
            all += boxes.len();
            accepted += u32::from(fast);
            refused += u32::from(!fast);
            beyond += u32::from(fast && !slow);
            tried += 1;
            if tried == 100 {
                break;
            }
        }
    }
    assert!(u64::from(accepted) > 10 * seeds(400) && u64::from(refused) > seeds(400), "{accepted} and {refused}");
    assert!(beyond * 200 <= accepted, "{beyond} of {accepted} only by separating lines");
    assert!(clear * 2 > all, "{clear} of {all} boxes are never met");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_check_by_samples_tests_each_of_them_and_no_other() {
    let world = &arm_worlds()[1];
    let (space, validity) = arm_in(world);
    let mut random = Random::new(5, Stream::Samples);
    let (mut free, mut unproven) = (0, 0);
    for _ in 0..seeds(2000) {
        let (a, b) = (space.sample(&mut random), space.sample(&mut random));
        for samples in [1, 2, 3, 7, 20, 64] {
            let mut tested = (1..=samples).map(|i| space.interpolate(&a, &b, f64::from(i) / f64::from(samples)));
            let expected = tested.all(|q| validity.is_free(&q));
            let sampled = Sampled::new(space.clone(), Box::new(arm_in(world).1), Samples::Count(samples));
            assert_eq!(sampled.is_motion_free(&a, &b), expected, "{samples} of {a:?} to {b:?}");
            assert!(expected || !validity.is_motion_free(&a, &b), "proven, yet {a:?} to {b:?} hits");
            free += u32::from(expected && samples == 20);
            unproven += u32::from(expected && samples == 20 && !validity.is_motion_free(&a, &b));
        }
    }
    assert!(free > 0 && (unproven > 0 || seeds(2000) < 2000), "{unproven} of {free}");

    let world = disc_and_wall(0.1, 0.5);
    let space: ProductSpace<2> = plane(&world.world().bounds.expect("a disc has bounds"));
    let sampled = |samples| Sampled::new(space.clone(), Box::new(disc_in(&world)), Samples::Count(samples));
    assert!(sampled(1).is_motion_free(&[1.0, 1.0], &[9.0, 1.0]), "the far end alone is free");
    assert!(!sampled(2).is_motion_free(&[1.0, 1.0], &[9.0, 1.0]), "the middle is in the wall");
    assert!(sampled(3).is_motion_free(&[1.0, 1.0], &[9.0, 1.0]), "a third is before the wall, two thirds behind");
    assert!(!sampled(3).is_motion_free(&[1.0, 1.0], &[5.0, 1.0]), "the far end is in the wall");
    assert_eq!(sampled(8).first_hit(&[1.0, 1.0], &[9.0, 1.0]), Some(0.375), "the last sample before the wall");
}

#[wasm_bindgen_test(unsupported = test)]
fn culling_by_boxes_lists_all_that_meet_once_and_little_else() {
    let mut random = Random::new(6, Stream::Samples);
    for count in [0, 1, 4, 5, 63, 64, 65, 257, 1025, 5000] {
        for scale in [1e-160, 1e-3, 1.0, 1e5] {
            let shapes: Vec<Obstacle> = (0..count)
                .map(|_| {
                    let center = Point::new(scale * random.uniform(), -scale * random.uniform());
                    Obstacle::Disc(Disc { center, radius: scale * 0.02 * random.uniform() })
                })
                .collect();
            let obstacles = Obstacles::new(shapes.clone());
            let (mut listed, mut meeting) = (0, 0);
            for _ in 0..seeds(200) {
                let corner = |random: &mut Random| {
                    Point::new(scale * (3.0 * random.uniform() - 1.0), scale * (3.0 * random.uniform() - 2.0))
                };
                let near = Aabb::of(corner(&mut random), corner(&mut random));
                let mut found = Vec::new();
                assert!(!obstacles.any_near(&near, |i| {
                    found.push(i);
                    false
                }));
                listed += found.len();
                found.sort_unstable();
                assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "each once");
                for i in (0..count).filter(|&i| obstacles.aabb(i).intersects(&near)) {
                    assert!(found.binary_search(&i).is_ok(), "{i} of {count} meets {near:?}");
                    meeting += 1;
                }
                assert_eq!(obstacles.any_near(&near, |_| true), !found.is_empty(), "it stops when it is true");
            }
            assert!(listed as f64 <= 1.001 * f64::from(meeting) + 10.0, "{listed} for {meeting} of {count} at {scale}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn motions_of_many_turns_examine_nothing_beyond_the_arm_s_reach() {
    let obstacle = |i: u32| {
        let center = Point::new(3.0 + f64::from(i % 50), f64::from(i / 50) - 25.0);
        Obstacle::Disc(Disc { center, radius: 0.4 })
    };
    let world = World { bounds: None, obstacles: (0..2500).map(obstacle).collect() };
    let arm = Arm::new(Point::origin(), vec![1.0, 1.0], 0.1, Some(vec![[-100.0, 100.0]; 2])).expect("an arm");
    let space: ProductSpace<2> = joint_space(&arm, Metric::Sum);
    let validity = ArmValidity::new(&arm, space, &world, 1e-4);
    assert!(validity.is_motion_free(&[-100.0, 90.0], &[100.0, -100.0]));
    assert_eq!(validity.clearance_evaluations(), 0);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_motion_that_samples_accept_through_a_thin_wall_is_refused() {
    for thickness in THICKNESSES {
        let world = arm_and_wall(thickness);
        let (space, validity) = arm_in(&world);
        let (above, below) = (space.state(&[0.6, 0.2]), space.state(&[-0.6, -0.2]));
        assert!(!validity.is_motion_free(&above, &below));
        // Twenty samples, as in the reports, see walls of these thicknesses only by luck.
        let samples = (0..20).map(|i| space.interpolate(&above, &below, (f64::from(i) + 0.5) / 20.0));
        let seen = samples.filter(|q| !validity.is_free(q)).count();
        assert!(thickness > 1e-2 || seen == 0, "samples miss a wall {thickness} thick");

        let validity = disc_in(&disc_and_wall(0.0, thickness));
        assert!(!validity.is_motion_free(&[1.0, 1.0], &[9.0, 1.0]));
        let hit = validity.first_hit(&[1.0, 1.0], &[9.0, 1.0]).expect("it hits the wall");
        assert!((1.0 + 8.0 * hit - (5.0 - thickness / 2.0)).abs() < 1e-9, "at the wall, not {hit}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_near_an_obstacle_or_the_bounds_can_be_left() {
    for gap in [1e-3, 1e-5, 1e-7, 1e-9] {
        // The arm lies along the top of a block, `gap` above it.
        let block = rectangle([0.5, -1.0], [1.5, -gap]);
        let world = scenario("", &block, &arm(&[1.0, 1.0], 0.0), r#""start": [0, 0], "goal": [1.5, 1.0]"#);
        for planner in ["prm", "rrt-connect"] {
            let run = finish(begin_with(&world, planner, 1, ""));
            assert_eq!(run.status(), Status::Solved, "{planner} from {gap} above a block");
            assert_valid(&world, &*run);
        }
    }
    for room in [1e-4, 1e-6, 1e-9] {
        // The tip of the only link points at the upper bound, `room` below it.
        let bounds = format!("[-10, -10], [10, {:?}]", 1.0 + 0.7 * 0.841_470_984_807_896_5 + room);
        let robot = r#"{ "type": "arm", "base": [0, 1], "links": [0.7] }"#;
        let world = scenario(&bounds, "", robot, r#""start": [1], "goal": [-1]"#);
        let run = finish(begin_with(&world, "rrt-connect", 1, ""));
        assert_eq!(run.status(), Status::Solved, "{room} below the bound");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn contact_with_an_obstacle_is_collision_and_contact_with_the_bounds_is_not() {
    let obstacles = [rectangle([2.0, 1.0], [3.0, 2.0]), disc([1.0, 3.0], 0.5)].join(",");
    let world = scenario("[0, 0], [4, 4]", &obstacles, r#"{ "type": "disc", "radius": 0.25 }"#, "");
    let validity = disc_in(&world);
    assert!(!validity.is_free(&[1.75, 1.5]), "touching the polygon's side");
    assert!(!validity.is_free(&[1.75, 3.0]), "touching the disc");
    assert!(validity.is_free(&[1.7499, 1.5]), "just beside it");
    assert!(validity.is_free(&[0.25, 0.25]), "touching two sides of the bounds");
    assert!(!validity.is_free(&[0.2499, 0.25]), "outside by a little");
    assert!(validity.is_motion_free(&[0.25, 0.25], &[3.75, 0.25]), "sliding along the bounds");
    assert!(!validity.is_motion_free(&[1.0, 1.5], &[1.75, 1.5]), "driving up to contact");
    let contacts = validity.contacts(&[2.5, 1.5]);
    assert_eq!(contacts.iter().map(ToString::to_string).collect::<Vec<_>>(), ["part 0 touches obstacle 0"]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_long_motion_of_a_disc_is_free_exactly_if_every_obstacle_is_farther_than_its_radius() {
    const SIDE: f64 = 100.0;
    let mut random = Random::new(23, Stream::Samples);
    let (mut apart, mut met) = (0, 0);
    for count in [1, 9, 60, 65, 300].repeat(seeds(8) as usize) {
        let place = |random: &mut Random| Point::new(SIDE * random.uniform(), -SIDE * random.uniform());
        let mut obstacle = || {
            let center = place(&mut random);
            random_obstacle(&mut random, center, SIDE / f64::from(count))
        };
        let obstacles: Vec<Obstacle> = (0..count).map(|_| obstacle()).collect();
        let world = CollisionWorld::from(&World::new(None, obstacles.clone()));
        let is_free = |radius: f64, Segment { a, b }: &Segment| {
            let robot = DiscRobot::new(radius).expect("a disc");
            DiscValidity::new(&robot, world.clone()).is_motion_free(&[a.x, a.y], &[b.x, b.y])
        };
        for _ in 0..20 {
            let motion = Segment::new(place(&mut random), place(&mut random));
            let distances = obstacles.iter().map(|obstacle| obstacle.distance_to_segment(&motion));
            let least = distances.fold(f64::INFINITY, f64::min);
            if least <= 0.0 {
                assert!(!is_free(0.0, &motion), "{motion:?} meets one of {obstacles:?}");
                met += 1;
                continue;
            }
            for gap in [1e-9, 1e-3, 1.0] {
                let fits = (least - gap).max(0.0);
                assert!(is_free(fits, &motion), "{fits} on {motion:?} among {obstacles:?}");
                assert!(!is_free(least + gap, &motion), "{least} + {gap} on {motion:?} among {obstacles:?}");
            }
            apart += 1;
        }
    }
    assert!(apart > 100 && met > 100, "{apart} apart, {met} met");

    let world = CollisionWorld::from(&World::new(None, [Obstacle::disc(Point::new(0.0, 1.5), 1.0)]));
    let validity = DiscValidity::new(&DiscRobot::new(1.0).expect("a disc"), world);
    for length in [0.0, 1e-320, 1e-170, 1e-155, 1e-150, 1e-8, 1e3, 1e8] {
        assert!(!validity.is_motion_free(&[0.0, 0.0], &[length, 0.0]), "{length} m from the contact");
        assert!(!validity.is_motion_free(&[-length, length], &[0.0, 0.0]), "{length} m to the contact");
    }
    assert!(validity.is_motion_free(&[-1e3, -1e-3 - 0.5], &[1e3, -1e-3 - 0.5]));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_polygon_with_a_vanishing_edge_is_as_solid_as_any() {
    let solid = polygon(&[[-1.0, 0.0], [-2.71e-140, 0.0], [0.0, 1.556e-140], [0.0, 1.0], [-1.0, 1.0]]);
    let robot = r#"{ "type": "arm", "base": [0.3535, -0.6157], "links": [0.63], "radius": 0.1 }"#;
    let world = scenario("", &solid, robot, "");
    let (space, validity) = arm_in(&world);
    let mut collisions = 0;
    for i in 0..20_000 {
        let angle = std::f64::consts::TAU * f64::from(i) / 20_000.0;
        let (a, b) = (space.state(&[angle]), space.state(&[angle + 1e-9]));
        if !validity.is_free(&a) {
            collisions += 1;
            assert!(!validity.is_motion_free(&a, &b), "a motion from a collision at {angle}");
        }
    }
    assert!(collisions > 100);
}

#[wasm_bindgen_test(unsupported = test)]
fn sliding_close_along_a_concave_wall_is_proven() {
    // As the first joint turns by one angle and the second back by two, the tip slides along the base's height.
    for gap in [1e-6, 1e-9] {
        let wall = polygon(&[[0.3, -gap], [2.5, -gap], [2.5, 1.0], [3.0, 1.0], [3.0, -1.0], [0.3, -1.0]]);
        let world = scenario("", &wall, &arm(&[1.0, 1.0], 0.0), "");
        let (space, validity) = arm_in(&world);
        let (a, b) = (space.state(&[0.5, -1.0]), space.state(&[1.3, -2.6]));
        let validity = validity.fitted(&a, &b);
        assert!(validity.is_motion_free(&a, &b), "with a tolerance fitted to its ends");
        let evaluations = validity.clearance_evaluations();
        assert!((20..10_000).contains(&evaluations), "{evaluations} at {gap}: by bounds of third order");
    }
}
