//! Closed forms, and how near an arm can come: against the ring of arms without limits, against dense samples with limits.

use crate::common::arms::{
    arm, configuration, deviation, free, is_within, limited, reachable, scenario, solve, target_of,
};
use crate::common::cases;
use planarium::geometry::Point;
use planarium::ik::{Nearest, Reason, SolverOptions, Target, Verdict, nearest_reachable};
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::run::{Status, Value};
use planarium::space::angular_distance;
use std::f64::consts::{PI, SQRT_2, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

fn target(x: f64, y: f64, orientation: Option<f64>) -> Target {
    Target { point: Point::new(x, y), orientation }
}

fn nearest(arm: &Arm, target: Target) -> Nearest {
    nearest_reachable(arm, target).expect("a target in range")
}

/// A random target up to `farthest` reaches away, for every third case with an orientation.
fn any_target(random: &mut Random, arm: &Arm, case: usize, farthest: f64) -> Target {
    let orientation = (arm.links().len() >= 2 && case.is_multiple_of(3)).then(|| 6.0 * random.uniform() - 3.0);
    let (away, angle) = (farthest * arm.reach() * random.uniform(), TAU * random.uniform());
    target(arm.base().x + away * angle.cos(), arm.base().y + away * angle.sin(), orientation)
}

/// All closed solutions from a start.
fn closed_from(arm: &Arm, target: Target, start: Option<Vec<f64>>) -> Vec<Vec<f64>> {
    let parameters = vec![("solutions".to_owned(), Value::Number(9.0)), ("separation".to_owned(), Value::Number(1e-6))];
    let options = SolverOptions { method: Some("closed-form".into()), start, parameters, ..SolverOptions::to(target) };
    solve(&scenario(arm, ""), &options).solutions().to_vec()
}

fn closed(arm: &Arm, target: Target) -> Vec<Vec<f64>> {
    closed_from(arm, target, None)
}

fn assert_near(found: &[Vec<f64>], wanted: &[&[f64]], within: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (q, wanted) in found.iter().zip(wanted) {
        let far = q.iter().zip(*wanted).map(|(&a, &b)| angular_distance(a, b)).fold(0.0, f64::max);
        assert!(far <= within, "{q:?} is not {wanted:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn two_links_reach_with_the_elbow_on_either_side() {
    let right = PI / 2.0;
    assert_near(&closed(&free(&[1.0, 1.0]), target(1.0, 1.0, None)), &[&[0.0, right], &[right, -right]], 1e-15);
    let arm = free(&[1.0, 0.8]);
    // Straight, and folded: the two are one.
    assert_near(&closed(&arm, target(0.0, 1.8, None)), &[&[right, 0.0]], 1e-15);
    assert_near(&closed(&arm, target(0.0, 0.2, None)), &[&[right, PI]], 1e-7);
    assert!(closed(&arm, target(0.0, 1.800001, None)).is_empty());
    assert!(closed(&arm, target(0.0, 0.199999, None)).is_empty());
    // Two links of one length fold back to the base, whatever the first angle: that of the start is used.
    assert_near(&closed_from(&free(&[0.7, 0.7]), target(0.0, 0.0, None), Some(vec![0.4, 1.0])), &[&[0.4, PI]], 0.0);
    assert!(closed(&arm, target(0.0, 0.0, None)).is_empty());
    // One link.
    assert_near(&closed(&free(&[0.5]), target(-0.5, 0.0, None)), &[&[PI]], 0.0);
    assert!(closed(&free(&[0.5]), target(0.2, 0.0, None)).is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_drop_solutions_and_choose_turns() {
    let right = PI / 2.0;
    let both = |limits: &[[f64; 2]]| closed(&limited(&[1.0, 1.0], limits), target(1.0, 1.0, None));
    assert_near(&both(&[[-1.0, 2.0], [-2.0, 2.0]]), &[&[0.0, right], &[right, -right]], 1e-15);
    assert_near(&both(&[[-1.0, 2.0], [0.0, 2.0]]), &[&[0.0, right]], 1e-15);
    assert_near(&both(&[[1.0, 2.0], [-2.0, 0.0]]), &[&[right, -right]], 1e-15);
    assert!(both(&[[-1.0, -0.5], [0.0, 2.0]]).is_empty());
    // The second joint lies some turns away.
    let found = both(&[[-1.0, 1.0], [13.0, 15.0]]);
    assert_eq!(found.len(), 1);
    assert!((found[0][1] - (right + 2.0 * TAU)).abs() < 1e-14, "{found:?}");
    let found =
        closed_from(&limited(&[1.0, 1.0], &[[-100.0, 100.0]; 2]), target(1.0, 1.0, None), Some(vec![50.0, -70.0]));
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

/// Cyclic coordinate descent: the best angle of one joint within its limits, while the rest stand still.
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
    let goal = target(SQRT_2 + 3e-11, SQRT_2 + 3e-11, None);
    assert_eq!(closed(&free(&[1.0, 1.0]), goal).len(), 1);
}

#[wasm_bindgen_test(unsupported = test)]
fn an_orientation_just_beyond_the_limits_is_out_of_reach() {
    let arm = limited(&[1.0, 1.0], &[[0.0, 0.1]; 2]);
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
    let (reason, nearest) = why(&free(&[1.0, 0.5]), target(3.0, 0.0, None));
    assert_eq!((reason, nearest.point, nearest.distance), (Reason::TooFar, Point::new(1.5, 0.0), 1.5));
    let (reason, nearest) = why(&free(&[1.0, 0.5]), target(0.0, 0.25, None));
    assert!(reason == Reason::TooNear && (nearest.distance - 0.25).abs() < 1e-15, "{nearest:?}");
    let (reason, nearest) = why(&limited(&[1.0, 1.0], &[[-1.0, 1.0], [-1.0, 1.0]]), target(-1.5, 0.0, None));
    assert_eq!(reason, Reason::Limits);
    assert_eq!(nearest.configuration[0].abs(), 1.0);
    let (reason, nearest) = why(&limited(&[1.0, 1.0], &[[-0.5, 0.5], [-0.5, 0.5]]), target(1.5, 0.5, Some(2.0)));
    assert!(reason == Reason::Orientation && (nearest.turn - 1.0).abs() < 1e-15);
    assert_eq!(nearest.configuration[..2], [0.5, 0.5]);
    // Beyond the limits by next to nothing is beyond them.
    let stiff = limited(&[1.0, 1.0], &[[-0.5, 0.5], [-0.5, 0.5]]);
    let tip = stiff.end_effector(&[0.5, 0.5]);
    let (reason, nearest) = why(&stiff, target(tip.x, tip.y, Some(1.0 + 5e-8)));
    assert!(reason == Reason::Orientation && (nearest.turn - 5e-8).abs() < 1e-15 && nearest.distance < 1e-15);
    assert_eq!(self::nearest(&stiff, target(tip.x, tip.y, Some(1.0))).turn, 0.0);
    let other = limited(&[1.0, 1.0, 1.0], &[[-0.5, 0.5], [0.2, 0.5], [-0.1, 0.3]]);
    let solutions =
        |angle| closed(&other, Target { orientation: Some(angle), ..target_of(&other, &[0.5, 0.4, 0.3], false) });
    assert_eq!([1.2 + 5e-8, 1.2].map(|angle| solutions(angle).len()), [0, 1]);
}
