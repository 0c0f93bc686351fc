//! The proof of any single motion ends within a stated number of evaluations, whatever the scene: arms, bodies, arcs, rollouts.

use crate::common::bodies::{self, p, rectangle, world};
use crate::common::documents::{self, scenario};
use crate::common::{begin_with, finish};
use planarium::collision::{ArmValidity, BodyCollision, BodyMotion};
use planarium::driving::{RolloutOptions, rollout};
use planarium::geometry::{Disc, Point};
use planarium::problem::{Control, Motion, Validity};
use planarium::random::{Random, Stream};
use planarium::robot::{Arm, joint_space};
use planarium::run::Status;
use planarium::scenario::{Obstacle, World};
use planarium::space::{Metric, ProductSpace, Space};
use std::f64::consts::{FRAC_PI_2, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

/// The most evaluations that a motion takes: see `proof/driver.rs`. Of all pairs of a part and a convex obstacle the first interval
/// tests each once; after it there are at most 48 levels of two tests per pair and 8192 more.
fn most(pairs: usize) -> u64 {
    let pairs = pairs as u64;
    pairs + 48 * (2 * pairs + 8192)
}

/// So many as suffice where clearance grows with distance from the closest place, or with bounds of third order along a wall.
const FEW: u64 = 20_000;

fn disc(x: f64, y: f64, radius: f64) -> Obstacle {
    Obstacle::Disc(Disc { center: p(x, y), radius })
}

fn polygon(corners: &[[f64; 2]]) -> Obstacle {
    Obstacle::Polygon(bodies::polygon(corners))
}

/// Obstacles close to an arm of two links of length 1 at the origin: name, obstacles, how many convex pieces they are.
fn close_by() -> Vec<(&'static str, Vec<Obstacle>, usize)> {
    let notch = |gap: f64| {
        // A notch whose concave corner the elbow at (0, 1) comes near to.
        polygon(&[[-0.5, 2.0], [-0.5, 0.95], [gap, 1.0 + gap], [0.5, 0.95], [0.5, 2.0]])
    };
    let mut all = vec![
        ("a tiny disc at the base", vec![disc(-1e-10, 0.0, 1e-11)], 1),
        ("tiny discs around the base", (1..=8).map(|i| disc(-1e-10 * f64::from(i), 3e-10, 1e-11)).collect(), 8),
        ("a corner at the base", vec![polygon(&[[-1e-9, 0.0], [-1.0, 0.1], [-1.0, -0.1]])], 1),
        ("a concave corner at the base", vec![polygon(&[[-1e-9, 0.0], [-1.0, 0.3], [-0.5, 0.0], [-1.0, -0.3]])], 2),
        (
            "a wedge around the base",
            vec![polygon(&[[-1e-9, 0.0], [1.0, 2.0], [-3.0, 2.0], [-3.0, -2.0], [1.0, -2.0]])],
            4,
        ),
        (
            "a wall below the tip",
            vec![polygon(&[[0.3, -1e-9], [2.5, -1e-9], [2.5, 1.0], [3.0, 1.0], [3.0, -1.0], [0.3, -1.0]])],
            4,
        ),
    ];
    all.extend([1e-5, 1e-7, 1e-9].map(|gap| ("a notch at the elbow", vec![notch(gap)], 4)));
    all
}

#[wasm_bindgen_test(unsupported = test)]
fn an_arm_with_something_close_by_takes_few_evaluations_per_motion() {
    let arm = Arm::new(Point::origin(), vec![1.0, 1.0], 0.0, None).expect("an arm");
    let space: ProductSpace<2> = joint_space(&arm, Metric::Sum);
    let mut random = Random::new(1, Stream::Samples);
    let (mut free, mut worst) = (0, 0);
    for (name, obstacles, pieces) in close_by() {
        let world = World { bounds: None, obstacles: obstacles.into() };
        let coarse = || ArmValidity::new(&arm, space.clone(), &world, 1e-4);
        for validity in [coarse(), coarse().finest()] {
            let mut motions = vec![
                ([2.9, 0.3], [0.2, -0.3]),
                ([0.5, -1.0], [1.3, -2.6]),
                ([FRAC_PI_2, 2.0], [FRAC_PI_2, 3.0]),
                ([FRAC_PI_2 - 1e-7, 2.0], [FRAC_PI_2 + 1e-7, 3.0]),
                ([FRAC_PI_2, 2.5], [0.5, 2.0]),
            ];
            motions.extend((0..300).map(|_| {
                let [a, b] = [(); 2].map(|()| space.sample(&mut random));
                (a, if random.below(2) == 0 { b } else { space.interpolate(&a, &b, 0.1) })
            }));
            for (a, b) in motions {
                for is_first_hit in [false, true] {
                    let before = validity.clearance_evaluations();
                    let hits = || validity.first_hit(&a, &b).is_some();
                    let is_free = if is_first_hit { !hits() } else { validity.is_motion_free(&a, &b) };
                    let evaluations = validity.clearance_evaluations() - before;
                    assert!(evaluations <= FEW.min(most(2 * pieces)), "{name}: {evaluations} for {a:?} to {b:?}");
                    worst = worst.max(evaluations);
                    free += u32::from(is_free);
                }
            }
            assert_eq!(validity.unproven_motions(), 0, "{name}");
        }
    }
    assert!(free > 1000 && worst > 100, "{free} free, {worst} at most");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_motion_whose_budget_is_spent_is_refused_and_counted() {
    // Discs all around, just beyond the tip: an arm that turns 32 times passes each as often.
    let around = |i: u32| {
        let (sin, cos) = libm::sincos(TAU * f64::from(i) / 300.0);
        let radius = 0.005;
        disc((1.0 + 2e-10 + radius) * cos, (1.0 + 2e-10 + radius) * sin, radius)
    };
    let world = World { bounds: None, obstacles: (0..300).map(around).collect() };
    let arm = Arm::new(Point::origin(), vec![1.0], 0.0, Some(vec![[-100.0, 100.0]])).expect("an arm");
    let space: ProductSpace<1> = joint_space(&arm, Metric::Sum);
    let validity = ArmValidity::new(&arm, space, &world, 1e-4).finest();
    assert!(validity.is_motion_free(&[0.0], &[6.0]), "one turn is proven");
    assert_eq!(validity.unproven_motions(), 0);
    let before = validity.clearance_evaluations();
    assert!(!validity.is_motion_free(&[-100.0], &[100.0]));
    assert_eq!(validity.unproven_motions(), 1);
    let hit = validity.first_hit(&[-100.0], &[100.0]).expect("refused where the proof stopped");
    assert!(hit > 0.0 && hit < 1.0, "{hit}");
    assert_eq!(validity.unproven_motions(), 2);
    let evaluations = validity.clearance_evaluations() - before;
    assert!(evaluations <= 2 * most(300), "{evaluations}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_body_that_all_but_touches_takes_few_evaluations_per_motion() {
    let body = rectangle([-0.2, -0.1], [0.2, 0.1]);
    let mut random = Random::new(2, Stream::Samples);
    let (mut free, mut worst) = (0, 0);
    for gap in [1e-4, 1e-6, 1e-8, 1e-10] {
        let teeth = (0..20).map(|i| 1.5 + 0.05 * f64::from(i)).flat_map(|x| [[x, 1.0 - gap], [x + 0.025, 0.9]]);
        let comb: Vec<[f64; 2]> =
            [[1.0, 0.5]].into_iter().chain([[3.0, 0.5]]).chain(teeth.collect::<Vec<_>>().into_iter().rev()).collect();
        let obstacles = vec![polygon(&comb), disc(2.0, 1.2 + gap + 1e-9, 1e-9), disc(1.0, 1.2 + gap + 0.5, 0.5)];
        let collision = BodyCollision::new(&body, &world([0.0, 0.0], [4.0, 4.0], obstacles), 1e-4).finest();
        // Above the comb, below the discs; to and fro, and arcs that are all but straight or turn within the gap.
        let mut motions = vec![
            BodyMotion::Straight { from: [0.5, 1.1, 0.0], delta: [3.0, 0.0, 0.0] },
            BodyMotion::Straight { from: [0.5, 1.1, 0.0], delta: [3.0, 0.0, gap] },
            BodyMotion::Arc { from: [0.5, 1.1, 0.0], speed: 1.0, turn_rate: 0.1 * gap, duration: 3.0 },
            BodyMotion::Arc { from: [0.5, 1.1, 0.0], speed: 1.0, turn_rate: -0.1 * gap, duration: 3.0 },
            BodyMotion::Arc { from: [2.0, 1.1, 0.0], speed: -1.0, turn_rate: 1.0, duration: 1.0 },
        ];
        motions.extend((0..300).map(|_| {
            let from = [0.5 + 3.0 * random.uniform(), 1.1, 0.0];
            let (along, turn) = (2.0 * random.uniform() - 1.0, random.uniform() - 0.5);
            match random.below(3) {
                0 => BodyMotion::Straight { from, delta: [along, 0.0, turn] },
                1 => BodyMotion::Straight { from, delta: [along, 0.2 * random.uniform(), turn] },
                _ => BodyMotion::Arc { from, speed: along, turn_rate: 2.0 * turn, duration: 1.0 },
            }
        }));
        for motion in motions {
            for is_first_hit in [false, true] {
                let before = collision.clearance_evaluations();
                let hits = || collision.first_hit(&motion).is_some();
                let is_free = if is_first_hit { !hits() } else { collision.is_motion_free(&motion) };
                let evaluations = collision.clearance_evaluations() - before;
                assert!(evaluations <= FEW, "{gap}: {evaluations} for {motion:?}");
                worst = worst.max(evaluations);
                free += u32::from(is_free);
            }
        }
        assert_eq!(collision.unproven_motions(), 0, "{gap}");
    }
    assert!(free > 100 && worst > 100, "{free} free, {worst} at most");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_step_of_a_planner_ends_with_a_disc_all_but_on_the_base() {
    for obstacle in [
        documents::disc([-1e-10, 0.0], 1e-11),
        documents::polygon(&[[-1e-9, 0.0], [-1.0, 0.1], [-0.5, 0.0], [-1.0, -0.1]]),
    ] {
        let arm = documents::arm(&[1.0, 1.0], 0.0);
        let world = scenario("", &obstacle, &arm, r#""start": [2.9, 0.3], "goal": [0.2, -0.3]"#);
        for (planner, settings) in [("prm", "samples=200 k=6"), ("rrt-connect", "")] {
            let run = finish(begin_with(&world, planner, 1, settings));
            assert_eq!(run.status(), Status::Solved, "{planner}");
            let stats = run.stats();
            assert!(stats.clearance_evaluations <= 3000 * stats.motion_checks, "{stats:?}");
            assert_eq!(stats.unproven_motions, 0);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_rollout_that_scrapes_along_a_wall_ends() {
    for gap in [1e-6, 1e-9, 1e-11] {
        let wall = documents::polygon(&[[0.0, 0.5], [10.0, 0.5], [10.0, 0.9], [5.0, 0.8], [0.0, 0.9]]);
        let obstacles = [wall, documents::disc([5.0, 1.1 + gap + 1e-9], 1e-9)].join(",");
        let limits = r#""wheelbase": 0.3, "speed": [-1, 1], "steering": [-0.7, 0.7]"#;
        let car = documents::rectangular("car", 0.2, 0.1, limits);
        let scenario = scenario("[0, 0], [10, 10]", &obstacles, &car, "");
        let control = |steering| Motion { control: Control { speed: 1.0, steering }, duration: 8.0 };
        for steering in [0.0, 1e-12, -1e-9, 1e-3] {
            let rollout =
                rollout(&scenario, &[1.0, 1.0, 0.0], control(steering), RolloutOptions::default()).expect("a car");
            assert!(rollout.seconds > 0.0);
        }
    }
}
