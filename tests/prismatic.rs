//! Arms with prismatic joints: kinematics, documents, paths, the verifier, and inverse kinematics.

use crate::common::documents::{arm, disc, jointed_arm, judged, rectangle, refuses, result, scenario};
use crate::common::{PLANNERS, arm_and_wall, assert_valid, begin_with, finish, seeds, sliding_arm_and_wall};
use planarium::geometry::Point;
use planarium::ik::{
    ClosedFormOptions, IterativeOptions, MethodOptions, Solver, SolverOptions, Target, Verdict, follow, jacobian,
    nearest_reachable,
};
use planarium::problem::{Status, Stepped};
use planarium::random::{Random, Stream};
use planarium::robot::{Arm, Joint, MAX_LINKS};
use planarium::run::inspect::Inspector;
use planarium::scenario::{Query, Robot, Scenario, World};
use wasm_bindgen_test::wasm_bindgen_test;

/// An arm of one to six links of which some slide, in some unit of length, and a configuration.
fn random_arm(random: &mut Random, scale: f64) -> (Arm, Vec<f64>) {
    let links: Vec<f64> = (0..1 + random.below(6)).map(|_| scale * (0.2 + random.uniform())).collect();
    let at_least = random.below(links.len() as u64) as usize;
    let mut joints = Vec::new();
    for (i, length) in links.iter().enumerate() {
        joints.push(match random.below(3) {
            0 if i != at_least => Joint::CIRCLE,
            1 if i != at_least => Joint::Revolute { limits: Some([-2.0, 2.5]) },
            _ => Joint::Prismatic {
                range: [-0.5 * length, scale * (0.2 + random.uniform())],
                angle: if random.below(2) == 0 { 0.0 } else { 4.0 * random.uniform() - 2.0 },
            },
        });
    }
    let base = Point::new(random.uniform() * scale, random.uniform() * scale);
    let arm = Arm::with_joints(base, links, 0.0, joints).expect("an arm");
    let q = arm.joint_types().iter().map(|joint| {
        let [low, high] = joint.range().unwrap_or([-3.1, 3.1]);
        low + (high - low) * random.uniform()
    });
    let q = q.collect();
    (arm, q)
}

#[wasm_bindgen_test(unsupported = test)]
fn places_are_products_of_turns_and_the_jacobian_agrees_with_differences() {
    let mut random = Random::new(51, Stream::Samples);
    for case in 0..500 {
        let scale = [1.0, 1e-3, 100.0][case % 3];
        let (arm, q) = random_arm(&mut random, scale);
        // By turning vectors, joint by joint.
        let (mut at, mut along) = (arm.base(), [1.0, 0.0]);
        let places = arm.joints(&q);
        for (i, joint) in arm.joint_types().iter().enumerate() {
            let (turn, length) = match *joint {
                Joint::Revolute { .. } => (q[i], arm.links()[i]),
                Joint::Prismatic { angle, .. } => (angle, arm.links()[i] + q[i]),
            };
            let [x, y] = along;
            along = [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
            at = Point::new(at.x + length * along[0], at.y + length * along[1]);
            assert!((places[i + 1] - at).norm() < 1e-12 * scale, "case {case}, joint {i}");
        }
        assert_eq!(arm.end_effector(&q), places[q.len()]);
        assert!((places[q.len()] - arm.base()).norm() <= arm.reach() * (1.0 + 1e-12));
        let rows = jacobian(&arm, &q);
        for i in 0..q.len() {
            let by = if arm.joint_types()[i].is_prismatic() { 1e-6 * scale } else { 1e-6 };
            let tip = |by: f64| {
                let mut moved = q.clone();
                moved[i] += by;
                arm.end_effector(&moved)
            };
            let slope = (tip(by) - tip(-by)) / (2.0 * by);
            let close = |a: f64, b: f64| (a - b).abs() < 1e-8 * scale.max(1.0);
            assert!(close(slope.x, rows[0][i]) && close(slope.y, rows[1][i]), "case {case}, joint {i}");
        }
        // No point travels farther than the bound, from any configuration.
        let delta: Vec<f64> = arm
            .joint_types()
            .iter()
            .zip(&q)
            .map(|(joint, at)| {
                let [low, high] = joint.range().unwrap_or([-3.1, 3.1]);
                low + (high - low) * random.uniform() - at
            })
            .collect();
        let travel = arm.travel(&delta);
        let mut paths = [0.0; MAX_LINKS];
        let moved = |k: u32| q.iter().zip(&delta).map(|(at, by)| at + by * f64::from(k) / 200.0).collect::<Vec<f64>>();
        for k in 0..200 {
            let (a, b) = (arm.joints(&moved(k)), arm.joints(&moved(k + 1)));
            (0..q.len()).for_each(|i| paths[i] += (b[i + 1] - a[i + 1]).norm());
        }
        assert!((0..q.len()).all(|i| paths[i] <= travel[i] * (1.0 + 1e-9)), "case {case}: {paths:?} {travel:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn joints_are_written_as_they_were_meant() {
    let written = |robot: &str| {
        let world = scenario("", "", robot, "");
        let text = world.to_json_string();
        assert_eq!(Scenario::parse(&text).expect("its own text").to_json_string(), text);
        text
    };
    let slide = r#"{"type": "prismatic", "range": [-0, 0.5]}"#;
    let text = written(&jointed_arm(&[1.0, 0.5], 0.0, &format!(r#""revolute", {slide}"#)));
    assert!(text.contains(r#""joints":["revolute",{"type":"prismatic","range":[0,0.5],"angle":0}]"#), "{text}");
    let mixed = r#"{"type": "revolute", "limits": [-1, 1]}, {"type": "revolute"}"#;
    let text = written(&jointed_arm(&[1.0, 0.5], 0.0, mixed));
    assert!(text.contains(r#""joints":[{"type":"revolute","limits":[-1,1]},"revolute"]"#), "{text}");
    // What a scenario could say before is said as before.
    let text = written(&jointed_arm(&[1.0, 0.5], 0.0, r#""revolute", "revolute""#));
    assert!(!text.contains("joint"), "{text}");
    let limited = r#"{"type": "revolute", "limits": [-1, 1]}, {"type": "revolute", "limits": [0, 2]}"#;
    assert!(written(&jointed_arm(&[1.0, 0.5], 0.0, limited)).contains(r#""joint_limits":[[-1,1],[0,2]]"#));
}

#[wasm_bindgen_test(unsupported = test)]
fn from_values_it_is_the_same_arm() {
    let slide = |range| Joint::Prismatic { range, angle: 0.0 };
    let made = |range| Arm::with_joints(Point::origin(), vec![1.0, 0.2], 0.01, vec![Joint::CIRCLE, slide(range)]);
    let arm = made([0.0, 0.5]).expect("an arm");
    let query = Query::new("out", [0.0, 0.1], [2.0, 0.4]);
    let world = Scenario::new("crane", World::new(None, []), arm.clone(), [query]).expect("a scenario");
    assert_eq!(Scenario::parse(&world.to_json_string()).expect("its text").robot(), &Robot::Arm(arm));
    refuses(made([f64::NAN, 1.0]), "not-finite", "/joints/1/range/0");
    refuses(made([0.5, 0.5]), "out-of-range", "/joints/1/range");
    refuses(made([-0.3, 0.5]), "out-of-range", "/joints/1/range/0");
    let steep = Joint::Prismatic { range: [0.0, 1.0], angle: f64::INFINITY };
    refuses(Arm::with_joints(Point::origin(), vec![1.0], 0.0, vec![steep]), "not-finite", "/joints/0/angle");
    refuses(Arm::with_joints(Point::origin(), vec![1.0], 0.0, vec![]), "wrong-dimension", "/joints");
}

/// Arms whose first, middle or last joint slides, thin and thick, among obstacles.
fn worlds() -> Vec<Scenario> {
    let slide =
        |range: [f64; 2], angle: f64| format!(r#"{{"type": "prismatic", "range": {range:?}, "angle": {angle:?}}}"#);
    let limited = r#"{"type": "revolute", "limits": [-2.8, 2.8]}"#;
    let mut worlds = Vec::new();
    for radius in [0.0, 0.03] {
        let arms = [
            (
                vec![slide([-0.3, 0.6], 0.7), r#""revolute""#.into(), limited.into()],
                "[-0.2, -1.5, 0.3]",
                "[0.5, 1.4, -0.5]",
            ),
            (
                vec![r#""revolute""#.into(), slide([0.0, 0.7], 0.0), limited.into()],
                "[0.2, 0.1, 0.4]",
                "[2.6, 0.5, -0.4]",
            ),
            (
                vec![limited.into(), r#""revolute""#.into(), slide([-0.2, 0.6], -0.4)],
                "[0.3, 0.2, 0.1]",
                "[2.0, -0.4, 0.3]",
            ),
        ];
        for (joints, start, goal) in arms {
            let obstacles = [disc([0.3, 1.1], 0.06), rectangle([-0.8, 1.0], [-0.7, 1.3]), disc([1.3, 0.9], 0.05)];
            let query = format!(r#""start": {start}, "goal": {goal}"#);
            let robot = jointed_arm(&[0.5, 0.4, 0.4], radius, &joints.join(", "));
            worlds.push(scenario("[-2, -2], [2, 2]", &obstacles.join(","), &robot, &query));
        }
    }
    worlds
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_of_arms_finds_paths_that_the_verifier_confirms() {
    for world in worlds() {
        for (planner, settings) in PLANNERS {
            let run = finish(begin_with(&world, planner, 3, settings));
            if run.status() == Status::Solved {
                assert_valid(&world, &*run);
            }
            let may_fail = ["discard", "naive", "samples=40"].iter().any(|name| settings.contains(name));
            let may_fail = may_fail || *planner == "visibility-prm";
            assert!(may_fail || run.status() == Status::Solved, "{planner} {settings}: {}", world.to_json_string());
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn edge_checks_metrics_and_rounded_corners_serve_sliding_arms() {
    for world in worlds() {
        for settings in
            ["metric=euclidean", "metric=naive", "shortcut=30 reduce=true blend=0.3", "heuristic=end-effector"]
        {
            let run = finish(begin_with(&world, "prm", 5, &format!("samples=400 {settings}")));
            // The naive metric does not go round the back.
            let may_fail = settings.starts_with("metric=naive");
            assert!(may_fail || run.status() == Status::Solved, "{settings}: {}", world.to_json_string());
            if run.status() == Status::Solved {
                assert_valid(&world, &*run);
            }
        }
        let lines = finish(begin_with(&world, "prm", 5, "samples=200 edge_check=joint-lines"));
        assert_ne!(lines.status(), Status::Running);
    }
}

/// What the verifier says of a path of two joints.
fn judge(world: &Scenario, path: &[[f64; 2]]) -> Result<f64, String> {
    let length: f64 = path.windows(2).map(|ends| (0..2).map(|i| (ends[1][i] - ends[0][i]).abs()).sum::<f64>()).sum();
    judged(world, &result(world.name(), &format!("{path:?}"), None, length))
}

#[wasm_bindgen_test(unsupported = test)]
fn a_link_that_slides_does_not_cross_a_wall_however_thin() {
    // The arm points along x and slides out through a wall across it.
    let robot = jointed_arm(&[0.4, 0.1], 0.0, r#""revolute", {"type": "prismatic", "range": [0, 1.2], "angle": 0}"#);
    for thickness in [0.5, 1e-3, 1e-6, 1e-9] {
        let wall = rectangle([0.8, -0.5], [0.8 + thickness, 0.5]);
        let query = r#""start": [0, 0], "goal": [0, 0.2]"#;
        let world = scenario("", &wall, &robot, query);
        assert!(judge(&world, &[[0.0, 0.0], [0.0, 0.2]]).is_ok());
        let through = scenario("", &wall, &robot, r#""start": [0, 0], "goal": [0, 1.1]"#);
        let why = judge(&through, &[[0.0, 0.0], [0.0, 1.1]]).expect_err("it crosses the wall");
        assert!(why.contains("link 2") && why.contains("obstacle 0"), "{why}");
        let inspector = Inspector::new(&through);
        let hit = inspector.first_hit(&[0.0, 0.0], &[0.0, 1.1]).expect("a motion").expect("it crosses the wall");
        assert!((1.1 * hit - 0.3).abs() < 1e-3, "at {hit}");
        assert_eq!(inspector.first_hit(&[0.0, 0.0], &[0.0, 0.29]), Ok(None));
    }
    let why = judge(&sliding_arm_and_wall(0.1), &[[0.6, 0.9], [0.6, 1.3], [-0.6, 0.8]]).expect_err("beyond the range");
    assert!(why.contains("waypoint 1") && why.contains("joint 1"), "{why}");
    // The same arm as in `arm_and_wall`, to compare: a longer way, round the back or drawn in.
    for seed in 0..seeds(20) {
        for world in [sliding_arm_and_wall(1e-6), arm_and_wall(1e-6)] {
            let run = finish(begin_with(&world, "rrt-connect", seed, "shortcut=50"));
            assert_eq!(run.status(), Status::Solved);
            assert_valid(&world, &*run);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn inverse_kinematics_reaches_what_sliding_arms_can_reach() {
    let mut random = Random::new(52, Stream::Samples);
    let mut found = [0; 3];
    for case in 0..seeds(300) {
        let scale = [1.0, 1e-3, 100.0][case as usize % 3];
        let (arm, q) = random_arm(&mut random, scale);
        if q.len() < 2 {
            continue;
        }
        let target = Target { point: arm.end_effector(&q), orientation: None };
        let world = Scenario::new("s", World::new(None, []), arm.clone(), []).expect("a scenario");
        let iterative = IterativeOptions::default();
        let methods = [
            MethodOptions::Newton(iterative),
            MethodOptions::GradientDescent(iterative),
            MethodOptions::DampedLeastSquares(iterative),
        ];
        for (i, method) in methods.into_iter().enumerate() {
            let options = SolverOptions { target, method, start: None, seed: case };
            let mut run = Solver::new(&world, &options).expect("a run");
            run.step(u64::MAX);
            for solution in run.solutions() {
                assert!(
                    (arm.end_effector(solution) - target.point).norm() <= run.tolerance() * 1.000_001,
                    "case {case}"
                );
                let ranges = arm.joint_types().iter().map(|joint| joint.range().unwrap_or([-4.0, 4.0]));
                assert!(ranges.zip(solution).all(|([low, high], at)| low <= *at && *at <= high), "case {case}");
            }
            assert!(run.solutions().is_empty() || run.explain() == Verdict::Reached);
            found[i] += u32::from(!run.solutions().is_empty());
        }
        let followed = follow(&arm, &q, target).expect("a target");
        assert!(followed.is_reached && followed.distance <= 1e-9 * arm.reach(), "case {case}: it is there already");
    }
    let most = *found.iter().max().expect("three methods");
    assert!(found[2] * 100 >= most * 95 && found[0] * 100 >= most * 80 && found[1] * 100 >= most * 60, "{found:?}");
    // Out of reach: nothing is found, and nothing is claimed.
    let slide = Joint::Prismatic { range: [0.0, 0.5], angle: 0.0 };
    let arm = Arm::with_joints(Point::origin(), vec![1.0, 0.2], 0.0, vec![Joint::CIRCLE, slide]).expect("an arm");
    let world = Scenario::new("s", World::new(None, []), arm.clone(), []).expect("a scenario");
    let far = Target { point: Point::new(5.0, 0.0), orientation: None };
    let method = MethodOptions::DampedLeastSquares(IterativeOptions::default());
    let mut run = Solver::new(&world, &SolverOptions { target: far, method, start: None, seed: 1 }).expect("a run");
    run.step(u64::MAX);
    assert_eq!(run.explain(), Verdict::NotFound);
    refuses(nearest_reachable(&arm, far), "unsupported", "/robot/joints");
    let method = MethodOptions::ClosedForm(ClosedFormOptions::default());
    refuses(
        Solver::new(&world, &SolverOptions { target: far, method, start: None, seed: 1 }),
        "unsupported",
        "/method",
    );
    // As far out as it gets.
    let stretched = follow(&arm, &[1.0, 0.1], far).expect("a target");
    assert!((stretched.distance - 3.3).abs() < 1e-3 && !stretched.is_reached, "{stretched:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn queries_with_a_target_are_planned() {
    let robot =
        jointed_arm(&[0.5, 0.3, 0.3], 0.02, r#""revolute", {"type": "prismatic", "range": [0, 0.6]}, "revolute""#);
    let obstacles = [disc([0.9, 0.9], 0.1), rectangle([-0.9, 0.6], [-0.7, 0.9])].join(",");
    let world = scenario("", &obstacles, &robot, r#""start": [0, 0.1, 0], "target": {"point": [-0.1, 1.1]}"#);
    for planner in ["prm", "rrt-connect", "bit-star"] {
        let run = finish(begin_with(&world, planner, 2, ""));
        assert_eq!(run.status(), Status::Solved, "{planner}");
        assert_valid(&world, &*run);
    }
    let world = scenario("", &obstacles, &robot, r#""start": [0, 0.1, 0], "target": {"point": [3, 1.1]}"#);
    let error = planarium::run::start(&world, planarium::run::PrmOptions::default()).err().expect("out of reach");
    assert_eq!(error.code().as_str(), "target-unreachable");
    assert!(error.message().contains("was found"), "{}", error.message());
}

#[wasm_bindgen_test(unsupported = test)]
fn the_shortest_path_of_a_boom_is_a_reference() {
    let world = sliding_arm_and_wall(0.1);
    let options = planarium::optimum::MetricOptions::default();
    let found = planarium::optimum::optimum(&world, None, options).expect("two joints");
    let (least, run) =
        (found.length.expect("a path"), finish(begin_with(&world, "rrt-star", 4, "improve_iterations=2000")));
    assert_eq!(run.status(), Status::Solved);
    assert!(run.length() > 0.99 * least && run.length() < 1.3 * least, "{} and {least}", run.length());
}

#[wasm_bindgen_test(unsupported = test)]
fn rrt_ends_in_the_goal_region_of_an_arm_or_a_disc_and_others_at_the_goal() {
    let boom = jointed_arm(&[0.4, 0.1], 0.02, r#""revolute", {"type": "prismatic", "range": [0, 1.2], "angle": 0}"#);
    let wall = rectangle([0.7, -0.05], [3.0, 0.05]);
    let worlds = [
        (arm(&[1.0, 0.8], 0.0), r#""start": [0.6, 0.2], "goal": [-0.6, -0.2]"#, r#"{"rotation": 0.3}"#, 0.0, 0.3),
        (boom, r#""start": [0.6, 0.9], "goal": [-0.6, 0.8]"#, r#"{"translation": 0.2, "rotation": 0.4}"#, 0.2, 0.4),
        (
            r#"{"type": "disc", "radius": 0.1}"#.to_owned(),
            r#""start": [0.3, 1], "goal": [0.3, -1]"#,
            r#"{"translation": 0.3}"#,
            0.3,
            0.0,
        ),
    ];
    for (robot, query, region, translation, rotation) in worlds {
        let query = format!(r#"{query}, "goal_tolerance": {region}"#);
        let world = scenario("[-2, -2], [2, 2]", &wall, &robot, &query);
        assert_eq!(Scenario::parse(&world.to_json_string()).as_ref(), Ok(&world));
        let goal = world.queries()[0].configuration().expect("a goal").to_vec();
        let mut inside = 0;
        for seed in 0..seeds(40) {
            let run = finish(begin_with(&world, "rrt", seed, "direct=false goal_bias=0.02 step=0.2"));
            assert_eq!(run.status(), Status::Solved);
            assert_valid(&world, &*run);
            let end = run.path().last().expect("a path").to_vec();
            let gaps: Vec<f64> = end.iter().zip(&goal).map(|(a, b)| (a - b).abs()).collect();
            assert!(gaps.iter().all(|gap| *gap <= f64::max(translation, rotation) + 1e-9), "{gaps:?}");
            inside += u64::from(gaps.iter().any(|gap| *gap > 1e-9));
        }
        assert!(inside > 0, "some end before the goal");
        for planner in ["rrt-connect", "prm"] {
            let run = finish(begin_with(&world, planner, 1, ""));
            assert_eq!(run.path().last().map(|q| q.to_vec()), Some(goal.clone()), "{planner}");
            assert_valid(&world, &*run);
        }
        // Without the region that path does not reach the goal.
        let exact = Scenario::parse(&world.to_json_string().replace(
            &world.to_json_string()[world.to_json_string().find(r#","goal_tolerance""#).expect("a region")..],
            "}]}",
        ))
        .expect("a scenario");
        let run = finish(begin_with(&world, "rrt", 0, "direct=false goal_bias=0.02 step=0.2"));
        let is_at_goal = run.path().last().map(|q| q.to_vec()) == Some(goal);
        assert_eq!(judged(&exact, &run.result()).is_ok(), is_at_goal);
    }
}
