//! Closed forms, and how near an arm can come: against the ring of free arms, against dense samples where there are limits.

use crate::common::arms::{arm, configuration, deviation, is_within, reachable, scenario};
use crate::common::cases;
use planarium::geometry::Point;
use planarium::ik::{Reason, Solver, SolverOptions, Target, Verdict, nearest_reachable, orientation};
use planarium::random::{Random, Stream};
use planarium::robot::Arm;
use planarium::run::{Status, Value};
use planarium::space::angular_distance;
use std::f64::consts::{PI, SQRT_2, TAU};
use wasm_bindgen_test::wasm_bindgen_test;

fn target(x: f64, y: f64, orientation: Option<f64>) -> Target {
    Target { point: Point::new(x, y), orientation }
}

fn free(links: &[f64]) -> Arm {
    Arm::new(Point::origin(), links.to_vec(), 0.0, None).expect("an arm")
}

fn limited(links: &[f64], limits: &[[f64; 2]]) -> Arm {
    Arm::new(Point::origin(), links.to_vec(), 0.0, Some(limits.to_vec())).expect("an arm")
}

/// All closed solutions from a start.
fn closed_from(arm: &Arm, target: Target, start: Option<Vec<f64>>) -> Vec<Vec<f64>> {
    let parameters = vec![("solutions".to_owned(), Value::Number(9.0)), ("separation".to_owned(), Value::Number(1e-6))];
    let options = SolverOptions { method: Some("closed-form".into()), start, parameters, ..SolverOptions::to(target) };
    let mut run = Solver::new(&scenario(arm, ""), &options).expect("a run");
    run.step(u64::MAX);
    run.solutions().iter().map(|q| q[..arm.links().len()].to_vec()).collect()
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
    // Two links of one length fold back to the base, whatever the first angle: that of the start is kept.
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
            let mut padded = [0.0; 8];
            padded[..links].copy_from_slice(q);
            assert!(is_within(&arm, &padded), "case {case}: {q:?}");
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
        let wanted = (links >= 2 && case % 3 == 0).then(|| 6.0 * random.uniform() - 3.0);
        let (near, angle) = (1.5 * arm.reach() * random.uniform(), TAU * random.uniform());
        let goal = target(arm.base().x + near * angle.cos(), arm.base().y + near * angle.sin(), wanted);
        let chain = if wanted.is_some() { &arm.links()[..links - 1] } else { arm.links() };
        let last =
            wanted.map_or(Point::origin(), |wanted| Point::new(wanted.cos(), wanted.sin()) * arm.links()[links - 1]);
        let wrist = goal.point - last.coords - arm.base().coords;
        let sum: f64 = chain.iter().sum();
        let longest = chain.iter().copied().fold(0.0, f64::max);
        let away = wrist.coords.norm();
        let gap = (away - sum).max((2.0 * longest - sum).max(0.0) - away).max(0.0);
        let nearest = nearest_reachable(&arm, goal).expect("a target");
        assert!((nearest.distance - gap).abs() < 1e-12, "case {case}: {} {gap} {arm:?} {goal:?}", nearest.distance);
        let [distance, turn] = deviation(&arm, &nearest.configuration[..links], &goal);
        assert!((distance - nearest.distance).abs() < 1e-13 && turn < 1e-14, "case {case}");
        assert!((arm.end_effector(&nearest.configuration) - nearest.point).norm() == 0.0 && nearest.turn == 0.0);
    }
}

/// The least distance among random configurations, each improved joint by joint: the best angle of one joint, limits held, while
/// the rest stand still. With an orientation the last joint makes up for the others, so they go by small turns.
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

/// Cyclic coordinate descent.
fn descend(arm: &Arm, q: &mut [f64], point: Point) {
    for _ in 0..30 {
        for i in (0..q.len()).rev() {
            let places = arm.joints(q);
            let (tip, to) = (arm.end_effector(q) - places[i], point - places[i]);
            let turn = to.y.atan2(to.x) - tip.y.atan2(tip.x);
            let [low, high] = arm.joint_limits().expect("limits")[i];
            let inside = q[i] + turn + TAU * ((low - q[i] - turn) / TAU).ceil();
            // Outside the limits, whichever of them is nearer on the circle.
            q[i] = if inside <= high {
                inside
            } else if low - (inside - TAU) < inside - high {
                low
            } else {
                high
            };
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn with_limits_no_sample_comes_nearer() {
    let mut random = Random::new(7, Stream::Samples);
    let (mut out, mut close) = (0, 0);
    for case in 0..cases(4000) {
        let links = 1 + case % 8;
        let arm = arm(&mut random, links, true);
        let wanted = (links >= 2 && case % 3 == 0).then(|| 6.0 * random.uniform() - 3.0);
        let (near, angle) = (1.2 * arm.reach() * random.uniform(), TAU * random.uniform());
        let goal = target(arm.base().x + near * angle.cos(), arm.base().y + near * angle.sin(), wanted);
        let nearest = nearest_reachable(&arm, goal).expect("a target");
        assert!(is_within(&arm, &nearest.configuration), "case {case}");
        let [distance, turn] = deviation(&arm, &nearest.configuration[..links], &goal);
        assert!((distance - nearest.distance).abs() < 1e-13 && (turn - nearest.turn).abs() < 1e-13, "case {case}");
        if nearest.turn > 0.0 {
            let sums =
                (0..2).map(|end| arm.joint_limits().expect("limits").iter().map(|limit| limit[end]).sum::<f64>());
            let turned =
                sums.map(|sum| angular_distance(sum, wanted.expect("an orientation"))).fold(f64::INFINITY, f64::min);
            assert!((turned - nearest.turn).abs() < 1e-13, "case {case}");
            continue;
        }
        let best = sampled(&mut random, &arm, &goal, if wanted.is_some() { 3000 } else { 40 });
        assert!(nearest.distance <= best + 1e-9, "case {case}: {} {best} {arm:?} {goal:?}", nearest.distance);
        out += u32::from(nearest.distance > 1e-9);
        close += u32::from(nearest.distance > 1e-9 && best < nearest.distance + 1e-6);
    }
    println!("{out} out of reach, at {close} the samples come as near");
    assert!(4 * out as usize > cases(4000) && (out as usize) < cases(4000), "{out}");
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
        let wanted = (links >= 2 && case % 3 == 0).then(|| orientation(&q));
        let nearest =
            nearest_reachable(&arm, Target { point: arm.end_effector(&q), orientation: wanted }).expect("a target");
        assert!(nearest.distance < 1e-12 && nearest.turn == 0.0, "case {case}: {} {arm:?} {q:?}", nearest.distance);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn closed_forms_find_what_folded_arms_and_bounds_allow() {
    let reaches = |arm: &Arm, q: &[f64], is_oriented: bool| {
        let goal = Target { point: arm.end_effector(q), orientation: is_oriented.then(|| orientation(q)) };
        let found = closed(arm, goal);
        let q = found.first().unwrap_or_else(|| panic!("{arm:?} {goal:?}"));
        let [distance, turn] = deviation(arm, q, &goal);
        assert!(distance <= 1e-9 && turn <= 1e-9, "{distance:e}, {turn:e}");
        assert!(arm.joint_limits().is_none_or(|limits| limits.iter().zip(q).all(|([a, b], q)| a <= q && q <= b)));
    };
    // Two links folded back to the base, up to rounding: any first angle brings the wrist there, few bring the last link along.
    reaches(&limited(&[1.0; 3], &[[1.0, 8.0], [PI / 2.0, PI], [PI / 2.0, PI]]), &[0.75 * PI, PI, PI], true);
    reaches(&limited(&[0.5, 0.5, 2.0], &[[1.0, 8.0], [PI, 3.2], [0.5, 1.0]]), &[1.3, PI, 0.25 * PI], true);
    reaches(&limited(&[1.0, 1.0], &[[-1.0, 0.5], [-PI, PI]]), &[0.5, PI], false);
    // Off by a little where the last joint is held at its limit, exact where the first stands differently.
    let narrow = limited(&[1.1; 3], &[[-7.0, -6.0], [-1e-9, 1e-9], [-3.2, -PI]]);
    reaches(&narrow, &[-6.0, 1e-9, -PI], true);
    reaches(&narrow, &[-6.0, -1e-9, -PI], true);
    reaches(&limited(&[1e-6; 3], &[[3.1, PI], [-1e-9, 1e-9], [PI / 2.0, PI]]), &[PI, 1e-9, PI], true);
    // Nearly one length.
    reaches(&free(&[1.0, 1.0 + 1e-13]), &[0.3, PI], false);
    // Rounding of coordinates far from the origin is no reason to give up.
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
    // What coordinates far from the origin are rounded by is none of the limits' business.
    let far =
        Arm::new(Point::new(1e6, -1e6), vec![2.0, 0.5], 0.0, Some(vec![[3.1, PI], [0.0, 1e-12]])).expect("an arm");
    let q = [3.1100232458877284, 1e-12];
    let goal = Target { point: far.end_effector(&q), orientation: Some(orientation(&q)) };
    assert_eq!(nearest_reachable(&far, goal).expect("a target").turn, 0.0);
    for beyond in [1e-6, 5e-8, 2e-9] {
        let goal = Target { point: arm.end_effector(&[0.1, 0.1]), orientation: Some(0.2 + beyond) };
        let nearest = nearest_reachable(&arm, goal).expect("a target");
        assert!((nearest.turn - beyond).abs() < 1e-11, "{beyond}: {nearest:?}");
        let mut run = Solver::new(&scenario(&arm, ""), &SolverOptions::to(goal)).expect("a run");
        run.step(u64::MAX);
        let verdict = run.explain();
        assert!(matches!(verdict, Verdict::OutOfReach { reason: Reason::Orientation, .. }), "{beyond}: {verdict:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_tells_why_a_target_is_out_of_reach() {
    let why = |arm: &Arm, goal: Target| {
        let mut run = Solver::new(&scenario(arm, ""), &SolverOptions::to(goal)).expect("a run");
        assert_eq!(run.step(u64::MAX), Status::Exhausted);
        match run.explain() {
            Verdict::OutOfReach { reason, nearest } => (reason, nearest),
            other => panic!("{other:?}"),
        }
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
    assert_eq!(nearest_reachable(&stiff, target(tip.x, tip.y, Some(1.0))).map(|nearest| nearest.turn), Ok(0.0));
    let other = limited(&[1.0, 1.0, 1.0], &[[-0.5, 0.5], [0.2, 0.5], [-0.1, 0.3]]);
    assert!(
        closed(&other, Target { point: other.end_effector(&[0.5, 0.4, 0.3]), orientation: Some(1.2 + 5e-8) })
            .is_empty()
    );
    assert_eq!(closed(&other, Target { point: other.end_effector(&[0.5, 0.4, 0.3]), orientation: Some(1.2) }).len(), 1);
}
