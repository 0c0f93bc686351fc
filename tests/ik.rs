//! Inverse kinematics. Runs: reachable targets are reached, within limits; slices, distinct and free solutions, refusals. Closed
//! forms, and how near an arm can come. An arm that follows a target: it arrives, does not jump, and recovers from being stretched.

use crate::common::arms::{
    arm, at, configuration, deviation, free, is_within, limited, reachable, scenario, solve, target_of,
};
use crate::common::documents::{disc, refuses};
use crate::common::{cases, given};
use planarium::geometry::{Point, Vector};
use planarium::ik::{
    Followed, IterativeOptions, MethodOptions, Nearest, Reason, Solver, SolverOptions, Stopping, Target, Verdict,
    follow, jacobian, manipulability, methods, nearest_reachable, orientation, singular_values,
};
use planarium::problem::{Stepped, Touched};
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::run::Status;
use planarium::space::angular_distance;
use std::f64::consts::{PI, SQRT_2, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

fn options(target: Target, method: &str, settings: &str) -> SolverOptions {
    SolverOptions {
        method: MethodOptions::read(Some(method), &given(settings)).expect("options"),
        ..SolverOptions::to(target)
    }
}

/// The methods that go from one configuration to the next.
const ITERATIVE: [&str; 3] = ["newton", "damped-least-squares", "gradient-descent"];

/// Random arms, half of them with limits, a third of those of three links and more with an orientation.
#[wasm_bindgen_test(unsupported = test)]
fn every_iterative_method_reaches_what_can_be_reached() {
    for (method, tolerance) in ITERATIVE.into_iter().zip([1e-9, 1e-9, 1e-4]) {
        let cases = cases(10_000) as u64;
        let mut random = Random::new(20, Stream::Samples);
        let mut failed = Vec::new();
        for case in 0..cases {
            let links = 2 + (case % 7) as usize;
            let arm = arm(&mut random, links, case % 2 == 0);
            let is_oriented = links >= 3 && random.below(3) == 0;
            let target = reachable(&mut random, &arm, is_oriented);
            let run = solve(&scenario(&arm, ""), &SolverOptions { seed: case, ..options(target, method, "") });
            for iterate in run.iterates() {
                assert!(is_within(&arm, &iterate.configuration), "case {case}: {:?}", iterate.configuration);
            }
            if run.status() == Status::Solved {
                let error = deviation(&arm, &run.solutions()[0], &target);
                assert!(error.iter().all(|&error| error <= tolerance + 1e-14), "case {case}: {error:?}");
                assert_eq!(run.explain(), Verdict::Reached);
            } else {
                assert_eq!(run.explain(), Verdict::NotFound, "case {case}: {arm:?} {target:?}");
                failed.push(case);
            }
        }
        assert!(failed.len() as u64 * 1000 <= cases, "{method} failed {} of {cases}: {failed:?}", failed.len());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_jacobian_agrees_with_differences() {
    let mut random = Random::new(40, Stream::Samples);
    for case in 0..200 {
        let arm = arm(&mut random, 1 + case % 8, false);
        let q = configuration(&mut random, &arm);
        let rows = jacobian(&arm, &q);
        for i in 0..q.len() {
            let tip = |by: f64| {
                let mut moved = q.clone();
                moved[i] += by;
                arm.end_effector(&moved)
            };
            let slope = (tip(1e-6) - tip(-1e-6)) / 2e-6;
            assert!((slope.x - rows[0][i]).abs() < 1e-8 && (slope.y - rows[1][i]).abs() < 1e-8, "case {case}");
        }
        assert!(angular_distance(orientation(&arm, &q), q.iter().sum()) < 1e-14);
        // The determinant of J times its transpose, and the squares of its singular values.
        let product = |a: usize, b: usize| -> f64 { (0..8).map(|i| rows[a][i] * rows[b][i]).sum() };
        let determinant = product(0, 0) * product(1, 1) - product(0, 1) * product(0, 1);
        let [large, small] = singular_values(&arm, &q);
        assert!(large >= small && small >= 0.0);
        assert!((manipulability(&arm, &q) - determinant.max(0.0).sqrt()).abs() < 1e-7 * (1.0 + determinant.abs()));
        assert!((large * large + small * small - product(0, 0) - product(1, 1)).abs() < 1e-12 * large * large);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn manipulability_of_two_links_is_their_lengths_times_the_sine_of_the_elbow() {
    let arm = free(&[1.0, 0.8]);
    for elbow in [0.0, 1e-9, 0.3, 1.5, -2.0, 3.0] {
        let wanted = 0.8 * f64::sin(elbow).abs();
        assert!((manipulability(&arm, &[0.4, elbow]) - wanted).abs() <= 1e-15 * (1.0 + wanted / 1e-3), "{elbow}");
    }
    assert_eq!(manipulability(&free(&[1.0]), &[0.3]), 0.0);
}

#[wasm_bindgen_test(unsupported = test)]
fn solutions_are_distinct_and_as_many_as_there_are() {
    let two = scenario(&free(&[1.0, 0.8]), "");
    for method in ITERATIVE {
        let run = solve(&two, &options(at(1.0, 0.6), method, "solutions=9 separation=0.01"));
        assert_eq!((run.status(), run.solutions().len()), (Status::Solved, 2), "{method}");
        assert_eq!(run.stats().restarts, 200, "it has searched for more");
        let five = solve(&scenario(&free(&[0.5; 5]), ""), &options(at(1.0, 0.6), method, "solutions=12"));
        let found = five.solutions();
        assert_eq!(found.len(), 12, "{method}");
        for (i, a) in found.iter().enumerate() {
            for b in &found[..i] {
                assert!(turn(a, b) > 0.5, "{method}");
            }
        }
    }
    let nothing = solve(&two, &options(at(1.0, 0.6), "newton", "max_iterations=0"));
    assert_eq!(
        (nothing.status(), nothing.stats().iterations, nothing.explain()),
        (Status::Exhausted, 0, Verdict::NotFound)
    );
    let mut here = options(at(1.8, 0.0), "newton", "");
    here.start = Some(vec![0.0, 0.0]);
    let here = Solver::new(&two, &here).expect("a run");
    assert_eq!((here.status(), here.stats().iterations), (Status::Solved, 0));
}

#[wasm_bindgen_test(unsupported = test)]
fn solutions_in_collision_are_listed_apart() {
    // The elbow to the left touches the disc, the elbow to the right is free; with the second disc neither is.
    let one = disc([0.3, 1.0], 0.2);
    let both = [one.clone(), disc([1.0, -0.2], 0.3)].join(",");
    for method in ["closed-form", "newton", "damped-least-squares", "gradient-descent"] {
        let mut wanted = options(at(1.0, 0.9), method, "solutions=2");
        let all = solve(&scenario(&free(&[0.9, 0.9]), &one), &wanted);
        let counts = (all.solutions().len(), all.rejected().len(), all.stats().configuration_checks);
        assert_eq!(counts, (2, 0, 0), "{method}");
        wanted.method = options(at(1.0, 0.9), method, "solutions=2 free_only=true").method;
        let some = solve(&scenario(&free(&[0.9, 0.9]), &one), &wanted);
        let counts = (some.solutions().len(), some.rejected().len(), some.explain());
        assert_eq!(counts, (1, 1, Verdict::Reached), "{method}");
        assert!(some.solutions()[0][1] > 0.0 && some.rejected()[0].configuration[1] < 0.0, "{method}");
        let none = solve(&scenario(&free(&[0.9, 0.9]), &both), &wanted);
        assert_eq!((none.status(), none.rejected().len()), (Status::Exhausted, 2), "{method}");
        let Verdict::InCollision { contacts } = none.explain() else { panic!("{:?}", none.explain()) };
        assert!(contacts.iter().all(|one| matches!(one.with, Touched::Obstacle(_))));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_targets_and_angles_are_refused() {
    let limited = limited(&[1.0, 0.8], &[[-1.0, 1.0], [0.1, 2.0]]);
    let endless = Stopping { tolerance: 0.0, ..Stopping::default() };
    let endless = IterativeOptions { stopping: endless, ..IterativeOptions::default() };
    let endless = SolverOptions { method: MethodOptions::Newton(endless), ..SolverOptions::to(at(1.0, 0.5)) };
    refuses(Solver::new(scenario(&limited, ""), &endless), "out-of-range", "/tolerance");
    let turned = Target { orientation: Some(0.0), ..at(0.5, 0.0) };
    refuses(nearest_reachable(&free(&[1.0]), turned), "unsupported", "/orientation");
    refuses(nearest_reachable(&limited, at(f64::NAN, 0.0)), "not-finite", "/target/0");
    refuses(follow(&limited, &[0.0], at(1.0, 0.0)), "wrong-dimension", "/q");
    refuses(follow(&limited, &[0.0, 0.0], at(1.0, 0.0)), "out-of-range", "/q/1");
    refuses(follow(&limited, &[f64::NAN, 0.5], at(1.0, 0.0)), "not-finite", "/q/0");
    refuses(follow(&free(&[1.0, 1.0]), &[2e6, 0.5], at(1.0, 0.0)), "out-of-range", "/q/0");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_largest_and_the_smallest_arms_reach_too() {
    for scale in [1e-6, 1e-3, 1.0, 1e3, 1e5] {
        let arm =
            Arm::new(Point::new(scale, -scale), vec![scale, 0.8 * scale, 0.5 * scale], 0.0, None).expect("an arm");
        let goal = target_of(&arm, &[0.4, 0.9, -0.7], false);
        for method in ITERATIVE {
            let run = solve(&scenario(&arm, ""), &options(goal, method, ""));
            assert_eq!(run.status(), Status::Solved, "{method} at {scale}");
            let [distance, _] = deviation(&arm, &run.solutions()[0], &goal);
            assert!(distance <= run.tolerance() + 1e-15 * scale, "{method} at {scale}");
        }
        assert!(follow(&arm, &[0.0, 0.1, 0.1], goal).expect("it follows").is_reached);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_lists_every_method() {
    let ids: Vec<&str> = methods().iter().map(|info| info.id).collect();
    assert_eq!(ids, ["closed-form", "newton", "damped-least-squares", "gradient-descent"]);
    for info in methods() {
        assert!(info.title.len() > 3 && info.summary.ends_with('.'));
        assert!(info.options.iter().any(|row| row.name == "max_iterations"));
        assert!(info.options.iter().all(|row| row.robots == ["arm"] && row.meaning.ends_with('.')));
    }
}

fn nearest(arm: &Arm, target: Target) -> Nearest {
    nearest_reachable(arm, target).expect("a target in range")
}

/// A random target up to `farthest` reaches away, for every third case with an orientation.
fn any_target(random: &mut Random, arm: &Arm, case: usize, farthest: f64) -> Target {
    let orientation = (arm.links().len() >= 2 && case.is_multiple_of(3)).then(|| 6.0 * random.uniform() - 3.0);
    let (away, angle) = (farthest * arm.reach() * random.uniform(), TAU * random.uniform());
    Target { orientation, ..at(arm.base().x + away * angle.cos(), arm.base().y + away * angle.sin()) }
}

/// All closed solutions from a start.
fn closed_from(arm: &Arm, target: Target, start: Option<Vec<f64>>) -> Vec<Vec<f64>> {
    let options = SolverOptions { start, ..options(target, "closed-form", "solutions=9 separation=1e-6") };
    solve(&scenario(arm, ""), &options).solutions().to_vec()
}

fn closed(arm: &Arm, target: Target) -> Vec<Vec<f64>> {
    closed_from(arm, target, None)
}

/// The largest rotation of a joint.
fn turn(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(&a, &b)| angular_distance(a, b)).fold(0.0, f64::max)
}

fn assert_near(found: &[Vec<f64>], wanted: &[&[f64]], within: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (q, wanted) in found.iter().zip(wanted) {
        assert!(turn(q, wanted) <= within, "{q:?} is not {wanted:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn two_links_reach_with_the_elbow_on_either_side() {
    let right = PI / 2.0;
    assert_near(&closed(&free(&[1.0, 1.0]), at(1.0, 1.0)), &[&[0.0, right], &[right, -right]], 1e-15);
    let arm = free(&[1.0, 0.8]);
    // Straight, and folded: the two are one.
    assert_near(&closed(&arm, at(0.0, 1.8)), &[&[right, 0.0]], 1e-15);
    assert_near(&closed(&arm, at(0.0, 0.2)), &[&[right, PI]], 1e-7);
    assert!(closed(&arm, at(0.0, 1.800001)).is_empty());
    assert!(closed(&arm, at(0.0, 0.199999)).is_empty());
    // Two links of one length fold back to the base, whatever the first angle: that of the start is used.
    assert_near(&closed_from(&free(&[0.7, 0.7]), at(0.0, 0.0), Some(vec![0.4, 1.0])), &[&[0.4, PI]], 0.0);
    assert!(closed(&arm, at(0.0, 0.0)).is_empty());
    // One link.
    assert_near(&closed(&free(&[0.5]), at(-0.5, 0.0)), &[&[PI]], 0.0);
    assert!(closed(&free(&[0.5]), at(0.2, 0.0)).is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_drop_solutions_and_choose_turns() {
    let right = PI / 2.0;
    let both = |limits: &[[f64; 2]]| closed(&limited(&[1.0, 1.0], limits), at(1.0, 1.0));
    assert_near(&both(&[[-1.0, 2.0], [-2.0, 2.0]]), &[&[0.0, right], &[right, -right]], 1e-15);
    assert_near(&both(&[[-1.0, 2.0], [0.0, 2.0]]), &[&[0.0, right]], 1e-15);
    assert_near(&both(&[[1.0, 2.0], [-2.0, 0.0]]), &[&[right, -right]], 1e-15);
    assert!(both(&[[-1.0, -0.5], [0.0, 2.0]]).is_empty());
    // The second joint lies some turns away.
    let found = both(&[[-1.0, 1.0], [13.0, 15.0]]);
    assert_eq!(found.len(), 1);
    assert!((found[0][1] - (right + 2.0 * TAU)).abs() < 1e-14, "{found:?}");
    let found = closed_from(&limited(&[1.0, 1.0], &[[-100.0, 100.0]; 2]), at(1.0, 1.0), Some(vec![50.0, -70.0]));
    assert!((found[0][0] - 8.0 * TAU).abs() < 1e-12 && (found[0][1] - (right - 11.0 * TAU)).abs() < 1e-12, "{found:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn closed_forms_are_right_to_a_trillionth_of_the_reach() {
    let mut random = Random::new(5, Stream::Samples);
    for case in 0..cases(20_000) {
        let is_oriented = case % 3 == 0;
        let links = if is_oriented { 2 + random.below(2) as usize } else { 1 + random.below(2) as usize };
        let arm = arm(&mut random, links, case % 2 == 0);
        let mut goal = reachable(&mut random, &arm, is_oriented);
        if links == 2 && !is_oriented && case % 5 == 0 {
            // On the very rim, and a little within.
            let away = (goal.point - arm.base()).normalize();
            let inward = [0.0, 1e-16, 1e-15, 1e-12, 1e-9][random.below(5) as usize];
            let rim = if random.below(2) == 0 {
                arm.reach() - inward
            } else {
                (arm.links()[0] - arm.links()[1]).abs() + inward
            };
            goal.point = arm.base() + away * rim;
        }
        let found = closed(&arm, goal);
        for q in &found {
            let [distance, turn] = deviation(&arm, q, &goal);
            assert!(distance <= 1e-12 * arm.reach() && turn <= 1e-12, "case {case}: {distance:e}, {turn:e}");
            assert!(is_within(&arm, q), "case {case}: {q:?}");
        }
        let is_on_rim = links == 2 && !is_oriented && case % 5 == 0;
        assert!(!found.is_empty() || (is_on_rim && case % 2 == 0), "case {case}: {arm:?} {goal:?}");
        if case % 2 == 1 && links == 2 && !is_oriented && !is_on_rim {
            assert_eq!(found.len(), 2, "case {case}");
            assert!(found[0][1] > 0.0 && found[1][1] < 0.0);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn without_limits_the_nearest_point_lies_on_the_ring() {
    let mut random = Random::new(6, Stream::Samples);
    for case in 0..cases(4000) {
        let links = 1 + case % 8;
        let arm = arm(&mut random, links, false);
        let goal = any_target(&mut random, &arm, case, 1.5);
        let chain = &arm.links()[..links - usize::from(goal.orientation.is_some())];
        let last = goal
            .orientation
            .map_or(Point::origin(), |angle| Point::new(angle.cos(), angle.sin()) * arm.links()[links - 1]);
        let wrist = goal.point - last.coords - arm.base().coords;
        let sum: f64 = chain.iter().sum();
        let longest = chain.iter().copied().fold(0.0, f64::max);
        let away = wrist.coords.norm();
        let gap = (away - sum).max((2.0 * longest - sum).max(0.0) - away).max(0.0);
        let nearest = nearest(&arm, goal);
        assert!((nearest.distance - gap).abs() < 1e-12, "case {case}: {} {gap} {arm:?} {goal:?}", nearest.distance);
        let [distance, turn] = deviation(&arm, &nearest.configuration, &goal);
        assert!((distance - nearest.distance).abs() < 1e-13 && turn < 1e-14, "case {case}");
        assert!((arm.end_effector(&nearest.configuration) - nearest.point).norm() == 0.0 && nearest.turn == 0.0);
    }
}

/// The least distance among random configurations, each improved by cyclic coordinate descent; or with an orientation among those
/// whose last joint is set to match it.
fn sampled(random: &mut Random, arm: &Arm, goal: &Target, samples: u64) -> f64 {
    let links = arm.links().len();
    let mut best = f64::INFINITY;
    for _ in 0..samples {
        let mut q = configuration(random, arm);
        match goal.orientation {
            None => descend(arm, &mut q, goal.point),
            Some(wanted) => {
                let [low, high] = arm.joint_limits().expect("limits")[links - 1];
                let last = wanted - q[..links - 1].iter().sum::<f64>();
                let last = last + TAU * ((low - last) / TAU).ceil();
                if last > high {
                    continue;
                }
                q[links - 1] = last;
            }
        }
        best = best.min((arm.end_effector(&q) - goal.point).norm());
    }
    best
}

/// Cyclic coordinate descent: the best angle of one joint within its limits, with the others fixed.
fn descend(arm: &Arm, q: &mut [f64], point: Point) {
    for _ in 0..30 {
        for i in (0..q.len()).rev() {
            let places = arm.joints(q);
            let (tip, to) = (arm.end_effector(q) - places[i], point - places[i]);
            let turn = to.y.atan2(to.x) - tip.y.atan2(tip.x);
            let [low, high] = arm.joint_limits().expect("limits")[i];
            let inside = q[i] + turn + TAU * ((low - q[i] - turn) / TAU).ceil();
            // Outside the limits, whichever of them is nearer on the circle.
            let limit = if low - (inside - TAU) < inside - high { low } else { high };
            q[i] = if inside <= high { inside } else { limit };
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn with_limits_no_sample_comes_nearer() {
    let mut random = Random::new(7, Stream::Samples);
    let mut out = 0;
    for case in 0..cases(4000) {
        let links = 1 + case % 8;
        let arm = arm(&mut random, links, true);
        let goal = any_target(&mut random, &arm, case, 1.2);
        let nearest = nearest(&arm, goal);
        assert!(is_within(&arm, &nearest.configuration), "case {case}");
        let [distance, turn] = deviation(&arm, &nearest.configuration, &goal);
        assert!((distance - nearest.distance).abs() < 1e-13 && (turn - nearest.turn).abs() < 1e-13, "case {case}");
        if nearest.turn > 0.0 {
            let (limits, wanted) = (arm.joint_limits().expect("limits"), goal.orientation.expect("an orientation"));
            let turns = [0, 1].map(|end| angular_distance(limits.iter().map(|limit| limit[end]).sum(), wanted));
            let turned = turns[0].min(turns[1]);
            assert!((turned - nearest.turn).abs() < 1e-13, "case {case}");
            continue;
        }
        let best = sampled(&mut random, &arm, &goal, if goal.orientation.is_some() { 3000 } else { 40 });
        assert!(nearest.distance <= best + 1e-9, "case {case}: {} {best} {arm:?} {goal:?}", nearest.distance);
        out += usize::from(nearest.distance > 1e-9);
    }
    assert!(4 * out > cases(4000) && out < cases(4000), "{out}");
}

#[wasm_bindgen_test(unsupported = test)]
fn what_a_configuration_reaches_is_never_out_of_reach() {
    let mut random = Random::new(8, Stream::Samples);
    for case in 0..cases(40_000) {
        let links = 1 + case % 6;
        let arm = arm(&mut random, links, true);
        // Some joints at their limits: such targets lie on borders.
        let mut q = configuration(&mut random, &arm);
        for (i, limits) in arm.joint_limits().expect("limits").iter().enumerate() {
            if random.below(3) == 0 {
                q[i] = limits[random.below(2) as usize];
            }
        }
        let nearest = nearest(&arm, target_of(&arm, &q, links >= 2 && case % 3 == 0));
        assert!(nearest.distance < 1e-12 && nearest.turn == 0.0, "case {case}: {} {arm:?} {q:?}", nearest.distance);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn closed_forms_find_what_folded_arms_and_bounds_allow() {
    let reaches = |arm: &Arm, q: &[f64], is_oriented: bool| {
        let goal = target_of(arm, q, is_oriented);
        let found = closed(arm, goal);
        let q = found.first().unwrap_or_else(|| panic!("{arm:?} {goal:?}"));
        let [distance, turn] = deviation(arm, q, &goal);
        assert!(distance <= 1e-9 && turn <= 1e-9, "{distance:e}, {turn:e}");
        assert!(arm.joint_limits().is_none_or(|limits| limits.iter().zip(q).all(|([a, b], q)| a <= q && q <= b)));
    };
    // Two links folded back to the base, up to rounding: any first angle reaches the wrist, few the orientation.
    reaches(&limited(&[1.0; 3], &[[1.0, 8.0], [PI / 2.0, PI], [PI / 2.0, PI]]), &[0.75 * PI, PI, PI], true);
    reaches(&limited(&[0.5, 0.5, 2.0], &[[1.0, 8.0], [PI, 3.2], [0.5, 1.0]]), &[1.3, PI, 0.25 * PI], true);
    reaches(&limited(&[1.0, 1.0], &[[-1.0, 0.5], [-PI, PI]]), &[0.5, PI], false);
    // Off by a little if the last joint is held at its limit, exact for another first angle.
    let narrow = limited(&[1.1; 3], &[[-7.0, -6.0], [-1e-9, 1e-9], [-3.2, -PI]]);
    reaches(&narrow, &[-6.0, 1e-9, -PI], true);
    reaches(&narrow, &[-6.0, -1e-9, -PI], true);
    reaches(&limited(&[1e-6; 3], &[[3.1, PI], [-1e-9, 1e-9], [PI / 2.0, PI]]), &[PI, 1e-9, PI], true);
    // Nearly one length.
    reaches(&free(&[1.0, 1.0 + 1e-13]), &[0.3, PI], false);
    // Rounding of coordinates far from the origin must not lose the solution.
    let far =
        |links: &[f64]| Arm::new(Point::new(-1e5, 7.7), links.to_vec(), 0.0, Some(vec![[-0.1, 0.1]; links.len()]));
    reaches(&far(&[1e-6]).expect("an arm"), &[-0.1], false);
    reaches(&far(&[1.0, 1.0]).expect("an arm"), &[0.1, -0.0], false);
    // Within the tolerance, on the outer side of the rim.
    let goal = at(SQRT_2 + 3e-11, SQRT_2 + 3e-11);
    assert_eq!(closed(&free(&[1.0, 1.0]), goal).len(), 1);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_orientation_just_beyond_the_limits_is_out_of_reach() {
    let arm = limited(&[1.0, 1.0], &[[0.0, 0.1]; 2]);
    assert_eq!(nearest(&arm, target_of(&arm, &[0.1, 0.1], true)).turn, 0.0);
    // The rounding of coordinates far from the origin does not count against the limits.
    let far =
        Arm::new(Point::new(1e6, -1e6), vec![2.0, 0.5], 0.0, Some(vec![[3.1, PI], [0.0, 1e-12]])).expect("an arm");
    let q = [3.1100232458877284, 1e-12];
    assert_eq!(nearest(&far, target_of(&far, &q, true)).turn, 0.0);
    for beyond in [1e-6, 5e-8, 2e-9] {
        let goal = Target { point: arm.end_effector(&[0.1, 0.1]), orientation: Some(0.2 + beyond) };
        let nearest = nearest(&arm, goal);
        assert!((nearest.turn - beyond).abs() < 1e-11, "{beyond}: {nearest:?}");
        let verdict = solve(&scenario(&arm, ""), &SolverOptions::to(goal)).explain();
        assert!(matches!(verdict, Verdict::OutOfReach { reason: Reason::Orientation, .. }), "{beyond}: {verdict:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_reports_why_a_target_is_out_of_reach() {
    let why = |arm: &Arm, goal: Target| {
        let run = solve(&scenario(arm, ""), &SolverOptions::to(goal));
        assert_eq!(run.status(), Status::Exhausted);
        let Verdict::OutOfReach { reason, nearest } = run.explain() else { panic!("{:?}", run.explain()) };
        (reason, nearest)
    };
    let (reason, nearest) = why(&free(&[1.0, 0.5]), at(3.0, 0.0));
    assert_eq!((reason, nearest.point, nearest.distance), (Reason::TooFar, Point::new(1.5, 0.0), 1.5));
    let (reason, nearest) = why(&free(&[1.0, 0.5]), at(0.0, 0.25));
    assert!(reason == Reason::TooNear && (nearest.distance - 0.25).abs() < 1e-15, "{nearest:?}");
    let (reason, nearest) = why(&limited(&[1.0, 1.0], &[[-1.0, 1.0], [-1.0, 1.0]]), at(-1.5, 0.0));
    assert_eq!(reason, Reason::Limits);
    assert_eq!(nearest.configuration[0].abs(), 1.0);
    let (reason, nearest) =
        why(&limited(&[1.0, 1.0], &[[-0.5, 0.5], [-0.5, 0.5]]), Target { orientation: Some(2.0), ..at(1.5, 0.5) });
    assert!(reason == Reason::Orientation && (nearest.turn - 1.0).abs() < 1e-15);
    assert_eq!(nearest.configuration[..2], [0.5, 0.5]);
    let other = limited(&[1.0, 1.0, 1.0], &[[-0.5, 0.5], [0.2, 0.5], [-0.1, 0.3]]);
    let solutions =
        |angle| closed(&other, Target { orientation: Some(angle), ..target_of(&other, &[0.5, 0.4, 0.3], false) });
    assert_eq!([1.2 + 5e-8, 1.2].map(|angle| solutions(angle).len()), [0, 1]);
}

/// The arm after it has followed the target.
fn followed(arm: &Arm, q: &[f64], target: Target) -> Followed {
    follow(arm, q, target).expect("a configuration and a target in range")
}

/// Drags the tip along a path, a function of a time from 0 to 1, in so many steps; the largest rotation of a joint in one step.
fn drag(arm: &Arm, start: &[f64], steps: u32, path: &dyn Fn(f64) -> Target) -> f64 {
    let (mut q, mut widest) = (start.to_vec(), 0.0);
    for step in 1..=steps {
        let next = followed(arm, &q, path(f64::from(step) / f64::from(steps))).configuration;
        widest = f64::max(widest, turn(&q, &next));
        q = next;
    }
    widest
}

#[wasm_bindgen_test(unsupported = test)]
fn the_tip_arrives_wherever_a_free_arm_can_reach() {
    let mut random = Random::new(31, Stream::Samples);
    let mut missed = Vec::new();
    for case in 0..cases(10_000) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, false);
        let [q, goal] = [configuration(&mut random, &arm), configuration(&mut random, &arm)];
        let is_oriented = links >= 4 && case % 3 == 0;
        let target = target_of(&arm, &goal, is_oriented);
        let moved = followed(&arm, &q, target);
        let [distance, turned] = deviation(&arm, &moved.configuration, &target);
        assert_eq!(moved.is_reached, moved.distance <= 1e-9 * arm.reach() && moved.turn <= 1e-9);
        assert!((distance - moved.distance).abs() < 1e-13 && (turned - moved.turn).abs() < 1e-13, "case {case}");
        assert!(is_within(&arm, &moved.configuration));
        if !moved.is_reached {
            missed.push((case, links, is_oriented, moved.distance, moved.turn));
        }
    }
    assert!(missed.len() * 200 <= cases(10_000), "{missed:?}");
}

#[wasm_bindgen_test(unsupported = test)]
fn beyond_its_reach_it_stretches_towards_the_target_and_recovers() {
    let mut random = Random::new(32, Stream::Samples);
    let mut worst = 0.0;
    for case in 0..cases(2000) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, false);
        let q = configuration(&mut random, &arm);
        let (sin, cos) = (TAU * random.uniform()).sin_cos();
        let along = |r: f64| {
            let point = arm.base() + Vector::new(cos, sin) * r * arm.reach();
            Target { point, orientation: None }
        };
        let out = followed(&arm, &q, along(1.0 + random.uniform()));
        let gap = nearest_reachable(&arm, along(1.5)).expect("a target").distance - 0.5 * arm.reach();
        assert!(gap.abs() < 1e-12);
        worst = f64::max(worst, (out.point - along(1.0).point).norm() / arm.reach());
        assert!(!out.is_reached && out.manipulability < 1e-3 * arm.reach() * arm.reach());
        // Straight to a rounding, and straight to the bit.
        let mut straight = vec![0.0; links];
        straight[0] = sin.atan2(cos);
        for from in [&out.configuration, &straight] {
            let back = followed(&arm, from, along(0.9));
            let is_hard = links == 2 && arm.links()[0] > 20.0 * arm.links()[1];
            assert!(back.is_reached || is_hard, "case {case}: {}", back.distance);
        }
    }
    assert!(worst < 1e-5, "{worst:e}");
}

#[wasm_bindgen_test(unsupported = test)]
fn small_steps_of_the_target_make_small_rotations_also_near_singular_configurations() {
    let arm = free(&[1.0, 0.8, 0.6]);
    let two = free(&[1.0, 0.8]);
    // Across the workspace, past the base at some distance, and out beyond the rim and in again.
    let across = |t: f64| at(-1.5 + 3.0 * t, 0.9);
    let out_and_in = |t: f64| at(0.6 + 2.4 * (1.0 - (2.0 * t - 1.0).abs()), 0.3);
    let along_the_rim = |t: f64| at(3.0 * (TAU * t).cos(), 3.0 * (TAU * t).sin());
    let paths: [&dyn Fn(f64) -> Target; 3] = [&across, &out_and_in, &along_the_rim];
    for (number, path) in paths.into_iter().enumerate() {
        for arm in [&arm, &two] {
            let links = arm.links().len();
            let start = followed(arm, &[0.3, 0.9, 0.5][..links], path(0.0)).configuration;
            let widest = [64, 256, 1024, 4096].map(|steps| drag(arm, &start, steps, path));
            // A quarter of the step turns the joints at most a little more than half as far: the square root, at the rim.
            for pair in widest[1..].windows(2) {
                assert!(pair[1] < 0.62 * pair[0], "path {number}, {links} links: {widest:?}");
            }
            assert!(widest[3] < 0.08);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_fixed_target_does_not_move_the_arm() {
    let mut random = Random::new(33, Stream::Samples);
    for case in 0..cases(1000) {
        let arm = arm(&mut random, 2 + case % 7, case % 2 == 0);
        let q = configuration(&mut random, &arm);
        let once = followed(&arm, &q, target_of(&arm, &q, false));
        assert!(turn(&once.configuration, &q) < 1e-12 && once.is_reached, "case {case}");
        // The same for any fixed target.
        let goal = at(3.0 * random.uniform(), 3.0 * random.uniform());
        let mut last = followed(&arm, &q, goal);
        for _ in 0..20 {
            last = followed(&arm, &last.configuration, goal);
        }
        let again = followed(&arm, &last.configuration, goal);
        let moved = turn(&again.configuration, &last.configuration);
        assert!(moved < 1e-3, "case {case}: {moved}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_hold_and_a_target_that_moves_along_reachable_points_is_reached() {
    let mut random = Random::new(34, Stream::Samples);
    let (mut missed, mut total) = (0, 0);
    for case in 0..cases(600) {
        let links = 2 + case % 7;
        let arm = arm(&mut random, links, true);
        let ends = [configuration(&mut random, &arm), configuration(&mut random, &arm)];
        let between = |t: f64| (0..links).map(|i| ends[0][i] + t * (ends[1][i] - ends[0][i])).collect::<Vec<f64>>();
        let mut q = ends[0].clone();
        for step in 1..=100 {
            let goal = target_of(&arm, &between(f64::from(step) / 100.0), false);
            let moved = followed(&arm, &q, goal);
            assert!(is_within(&arm, &moved.configuration));
            assert!(moved.distance <= (arm.end_effector(&q) - goal.point).norm() + 1e-12, "it never moves away");
            total += 1;
            missed += u32::from(!moved.is_reached);
            q = moved.configuration;
        }
    }
    assert!(missed * 20 <= total, "missed {missed} of {total}");
}
