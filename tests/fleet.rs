//! Fleets: what a document may contain; plans that another check finds free of conflict at every time; the same plan in any slices and on
//! every platform; what one order of priorities cannot solve.

use crate::common::documents::refuses;
use crate::common::{cases, deep, golden, seeds};
use planarium::fleet::{
    CompositeOptions, Fleet, FleetOptions, FleetPlanner, FleetPlannerOptions, FleetReason, PbsOptions, Trajectory,
    conflicts, generate, straight, trajectories, verify,
};
use planarium::geometry::wrap;
use planarium::problem::{Status, Stepped};
use planarium::random::{Random, Stream};
use planarium::robot::Part;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// How far a robot moves at most between two looks of the dense check, in metres.
const LOOK: f64 = 5e-3;

/// No robot here has a point farther from its own origin, in metres.
const REACH: f64 = 0.7;

fn two_discs() -> serde_json::Value {
    json!({
        "format": "planarium-fleet-1", "name": "two",
        "world": { "bounds": { "min": [0, 0], "max": [10, 4] }, "obstacles": [ { "type": "disc", "center": [5, 0.5], "radius": 0.2 } ] },
        "robots": [
            { "name": "a", "robot": { "type": "disc", "radius": 0.5 }, "start": [1, 2], "goal": [9, 2] },
            { "name": "b", "robot": { "type": "disc", "radius": 0.5 }, "speed": 2, "start": [9, 2], "goal": [1, 2] }
        ]
    })
}

fn planner(fleet: &Fleet, id: &str, seed: u64, order: Option<&[&str]>) -> FleetPlanner {
    let order = order.map(|names| names.iter().map(|name| (*name).to_owned()).collect());
    let options = FleetOptions { planner: None, seed, order }.with(Some(id), &[]).expect("a planner");
    FleetPlanner::new(fleet, &options).expect("options of this planner")
}

pub fn planned(fleet: &Fleet, id: &str, seed: u64) -> FleetPlanner {
    let mut planner = planner(fleet, id, seed, None);
    planner.step(u64::MAX);
    planner
}

/// Two convex parts touch or overlap: discs by their centres, else no side of one has the other beyond it.
fn overlap(a: &Part, b: &Part) -> bool {
    let outline = |part: &Part| match part {
        Part::Disc { center, radius } => (vec![[center.x, center.y]], *radius),
        Part::Polygon { vertices } => (vertices.iter().map(|p| [p.x, p.y]).collect(), 0.0),
        Part::Capsule { .. } => panic!("no robot of a fleet has links"),
    };
    let ((p, r), (q, s)) = (outline(a), outline(b));
    // The gap along the normals of sides and between corners: the largest is a lower bound of the distance, 0 or less in contact.
    let mut normals: Vec<[f64; 2]> = Vec::new();
    for corners in [&p, &q] {
        for i in 0..corners.len() {
            let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
            normals.extend([[b[1] - a[1], a[0] - b[0]], [a[1] - b[1], b[0] - a[0]]]);
        }
    }
    normals.extend(p.iter().flat_map(|a| q.iter().map(move |b| [b[0] - a[0], b[1] - a[1]])));
    let gap = |normal: [f64; 2]| {
        let length = (normal[0] * normal[0] + normal[1] * normal[1]).sqrt();
        let along = |corner: &[f64; 2]| (corner[0] * normal[0] + corner[1] * normal[1]) / length;
        let farthest = p.iter().map(along).fold(f64::NEG_INFINITY, f64::max) + r;
        let nearest = q.iter().map(along).fold(f64::INFINITY, f64::min) - s;
        if length > 0.0 { nearest - farthest } else { f64::NEG_INFINITY }
    };
    normals.into_iter().map(gap).fold(f64::NEG_INFINITY, f64::max) <= 0.0
}

/// Where a robot is, from its rows alone.
fn at(trajectory: &Trajectory, time: f64) -> [f64; 3] {
    let (times, poses) = (trajectory.times(), trajectory.poses());
    let Some(next) = times.iter().position(|row| *row > time) else { return poses[poses.len() - 1] };
    let (from, to) = (poses[next - 1], poses[next]);
    let part = (time - times[next - 1]) / (times[next] - times[next - 1]);
    let turn = wrap(to[2] - from[2]);
    [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1]), from[2] + part * turn]
}

/// The first pair of robots that a look at many times finds in contact.
fn seen(fleet: &Fleet, trajectories: &[Trajectory]) -> Option<([usize; 2], f64)> {
    let end = trajectories.iter().map(Trajectory::arrival).fold(0.0, f64::max);
    let fastest = fleet.robots().iter().map(|member| member.speed).fold(0.0, f64::max);
    let looks = (end * fastest / LOOK).ceil().max(1.0) as u32;
    (0..=looks).find_map(|look| {
        let time = end * f64::from(look) / f64::from(looks);
        let poses: Vec<[f64; 3]> = trajectories.iter().map(|trajectory| at(trajectory, time)).collect();
        let parts: Vec<Vec<Part>> = fleet
            .robots()
            .iter()
            .zip(&poses)
            .map(|(member, pose)| member.footprint(&pose[..member.start.len()]))
            .collect();
        let is_near = |i: usize, j: usize| (0..2).all(|axis| (poses[i][axis] - poses[j][axis]).abs() <= 2.0 * REACH);
        let touch =
            |i: usize, j: usize| is_near(i, j) && parts[i].iter().any(|a| parts[j].iter().any(|b| overlap(a, b)));
        (0..parts.len()).find_map(|i| (i + 1..parts.len()).find(|j| touch(i, *j)).map(|j| ([i, j], time)))
    })
}

/// Verified, and without contact at any look of other code.
#[track_caller]
pub fn assert_free(planner: &FleetPlanner, about: &str) {
    let verification = verify(planner.fleet(), &planner.result()).expect("a plan of this fleet");
    assert!(verification.is_valid(), "{about}: {verification:?}");
    let trajectories = trajectories(planner.fleet(), &planner.result()).expect("a plan of this fleet");
    assert_eq!(seen(planner.fleet(), &trajectories), None, "{about}");
}

/// A fleet drawn at random: of discs or rectangles, in a hall, a ring, at crossroads or at a corridor.
fn drawn(seed: u64) -> Fleet {
    let mut random = Random::new(seed, Stream::Samples);
    let shape = if random.below(3) == 0 { "rectangle" } else { "disc" };
    let (id, most) =
        [("hall", 20), ("hall", 20), ("ring", 8), ("crossroads", 8), ("corridor", 6)][random.below(5) as usize];
    let count = 2 + random.below(most - 1);
    let speed = 0.5 + random.uniform();
    let options = json!({ "count": count, "seed": seed, "shape": shape, "speed": speed });
    generate(id, &options).unwrap_or_else(|error| panic!("{id} {options}: {error}"))
}

#[wasm_bindgen_test(unsupported = test)]
fn a_document_is_read_back_as_the_same_fleet() {
    let fleet = Fleet::read(&two_discs()).expect("a fleet");
    assert_eq!(Fleet::parse(&fleet.to_json_string()).expect("its own document"), fleet);
    assert_eq!(fleet.robots().iter().map(|member| member.speed).collect::<Vec<_>>(), [1.0, 2.0]);
}

#[wasm_bindgen_test(unsupported = test)]
fn conflicts_of_two_motions_are_those_that_a_dense_look_sees() {
    let mut random = Random::new(1, Stream::Samples);
    let mut met = 0;
    for case in 0..cases(400) {
        let mut draw = |low: f64, high: f64| low + random.uniform() * (high - low);
        let body = json!({ "type": "rigid_body", "shape": { "type": "polygon", "vertices": [[-0.6, -0.2], [0.6, -0.2], [0.6, 0.2], [-0.6, 0.2]] } });
        let disc = json!({ "type": "disc", "radius": draw(0.1, 0.6) });
        let mut robot = |name: &str, is_body: bool, x: [f64; 2]| {
            let place = |x: f64, y: f64, theta: f64| if is_body { json!([x, y, theta]) } else { json!([x, y]) };
            let (start, goal) =
                (place(x[0], draw(1.0, 9.0), draw(-3.0, 3.0)), place(x[1], draw(1.0, 9.0), draw(-3.0, 3.0)));
            json!({ "name": name, "robot": if is_body { &body } else { &disc }, "speed": draw(0.5, 2.0), "start": start, "goal": goal })
        };
        let robots = [robot("a", case % 3 > 0, [1.0, 9.0]), robot("b", case % 3 > 1, [9.0, 1.0])];
        let document = json!({ "format": "planarium-fleet-1", "name": "pair", "robots": robots,
            "world": { "bounds": { "min": [0, 0], "max": [10, 10] }, "obstacles": [] } });
        let Ok(fleet) = Fleet::read(&document) else { continue };
        let motions = straight(&fleet);
        let (found, seen) = (conflicts(&fleet, &motions), seen(&fleet, &motions));
        met += usize::from(seen.is_some());
        match (found.first(), seen) {
            (None, seen) => assert_eq!(seen, None, "{document}"),
            (Some(conflict), Some((_, time))) => {
                assert!(conflict.from <= time && time - conflict.from < 0.1, "{conflict:?} {time} {document}")
            }
            // Between two looks robots approach by no more than both move.
            (Some(conflict), None) => {
                assert!(conflict.to.is_some_and(|to| to - conflict.from < 0.1), "{conflict:?} {document}")
            }
        }
    }
    assert!(met > cases(400) / 10, "only {met} pairs met");
}

#[wasm_bindgen_test(unsupported = test)]
fn no_two_robots_of_a_random_plan_touch() {
    let count = if deep() { 1000 } else { seeds(160) };
    let mut solved = 0;
    for seed in 0..count {
        let planner = planned(&drawn(seed), "prioritized", seed);
        if planner.status() == Status::Solved {
            solved += 1;
            assert_free(&planner, &format!("seed {seed}"));
        } else {
            assert!(planner.blocked().is_some(), "seed {seed}: {:?}", planner.status());
        }
    }
    assert!(solved > count / 2, "only {solved} of {count} are solved");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_composite_plan_of_two_or_three_is_free_of_conflict() {
    for seed in 0..8 {
        let (shape, count) = [("disc", 2), ("disc", 3), ("rectangle", 2)][seed as usize % 3];
        let fleet = generate("ring", &json!({ "count": count, "seed": seed, "shape": shape, "pillar": 0.5 }));
        let planner = planned(&fleet.expect("a ring"), "composite", seed);
        assert_eq!(planner.status(), Status::Solved, "seed {seed}");
        assert_free(&planner, &format!("seed {seed}"));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_swap_in_a_corridor_is_solved_by_the_composite_and_by_default_and_by_no_order_of_priorities() {
    for seed in 0..3 {
        let fleet = generate("swap", &json!({ "seed": seed })).expect("a swap");
        let names: Vec<&str> = fleet.robots().iter().map(|member| member.name.as_str()).collect();
        for order in [[0, 1], [1, 0]] {
            let mut planner = planner(&fleet, "prioritized", seed, Some(&order.map(|i| names[i])));
            assert_eq!(planner.step(u64::MAX), Status::Exhausted, "{order:?}");
            let blocked = planner.blocked().expect("a robot finds no way");
            assert_eq!((blocked.robot, &blocked.by[..]), (order[0], &[order[1]][..]));
            assert_eq!(planner.reason(), Some(FleetReason::OrderLimit), "the other order was not to be tried");
        }
        let both = planned(&fleet, "prioritized", seed);
        let known = (Some(FleetReason::NoOrder), 0);
        assert_eq!((both.reason(), both.stats().restarts), known, "no robot may be the first of an order");
        for id in ["composite", "pbs"] {
            let planner = planned(&fleet, id, seed);
            assert_eq!((planner.status(), planner.reason()), (Status::Solved, None), "{id}");
            assert_free(&planner, id);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn robots_in_a_line_each_move_up_one_place_in_the_first_other_order() {
    let robot = |i: u32| {
        json!({ "name": i.to_string(), "robot": { "type": "disc", "radius": 0.5 }, "start": [2 + 3 * i, 0.6],
            "goal": [5 + 3 * i, 0.6] })
    };
    let fleet = Fleet::read(&json!({
        "format": "planarium-fleet-1", "name": "line", "robots": (0..8).map(robot).collect::<Vec<_>>(),
        "world": { "bounds": { "min": [0, 0], "max": [28, 1.2] }, "obstacles": [] }
    }))
    .expect("a fleet");
    let planner = planned(&fleet, "prioritized", 1);
    assert_eq!((planner.status(), planner.stats().restarts), (Status::Solved, 1));
    assert_eq!(planner.order(), (0..8).rev().collect::<Vec<_>>(), "the foremost first");
    assert_free(&planner, "a line");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_robot_whose_roadmap_has_no_way_is_found_among_those_that_others_block() {
    let wall = |x: f64| json!({ "type": "polygon", "vertices": [[x, 1], [x + 0.2, 1], [x + 0.2, 2.9], [x, 2.9]] });
    let mut document = two_discs();
    document["world"] = json!({ "bounds": { "min": [0, 1], "max": [16, 2.9] }, "obstacles": [wall(11.0), wall(14.0)] });
    let shut = json!({ "name": "c", "robot": { "type": "disc", "radius": 0.5 }, "start": [12, 2], "goal": [15, 2] });
    document["robots"].as_array_mut().expect("robots").push(shut);
    let planner = planned(&Fleet::read(&document).expect("a fleet"), "prioritized", 1);
    let blocked = planner.blocked().expect("a robot finds no way");
    assert_eq!((planner.reason(), blocked.robot, blocked.by), (Some(FleetReason::NotConnected), 2, Vec::new()));
}

#[wasm_bindgen_test(unsupported = test)]
fn robots_that_start_too_close_to_each_other_to_leave_are_not_said_to_be_unconnected() {
    let mut document = two_discs();
    (document["robots"][0]["start"], document["robots"][0]["goal"]) = (json!([1, 2]), json!([1, 3]));
    (document["robots"][1]["start"], document["robots"][1]["goal"]) = (json!([2.000_000_001, 2]), json!([8, 2]));
    let planner = planned(&Fleet::read(&document).expect("a fleet"), "prioritized", 1);
    let blocked = planner.blocked().expect("a robot finds no way");
    assert_eq!((planner.reason(), blocked.by), (Some(FleetReason::NoOrder), vec![1 - blocked.robot]));
}

#[wasm_bindgen_test(unsupported = test)]
fn robots_that_cannot_pass_each_other_are_never_said_to() {
    let mut document = two_discs();
    document["world"] = json!({ "bounds": { "min": [0, 1], "max": [10, 2.9] }, "obstacles": [] });
    let fleet = Fleet::read(&document).expect("a fleet");
    for seed in 0..5 {
        assert_eq!(planned(&fleet, "prioritized", seed).status(), Status::Exhausted);
        let composite = CompositeOptions { max_iterations: 2000, ..CompositeOptions::default() };
        let pbs = PbsOptions { max_iterations: Some(60_000), ..PbsOptions::default() };
        for planner in [FleetPlannerOptions::from(composite), pbs.into()] {
            let (id, options) = (planner.id(), FleetOptions { planner: Some(planner), seed, order: None });
            let mut planner = FleetPlanner::new(&fleet, &options).expect("options");
            assert_eq!(planner.step(u64::MAX), Status::Exhausted);
            assert_eq!(planner.reason(), Some(FleetReason::IterationLimit), "{id}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_body_so_thin_that_its_placed_outline_crosses_itself_is_judged_by_where_it_is() {
    // Four corners on a line, but for the last bits.
    let thin = json!({ "type": "rigid_body",
        "shape": { "type": "polygon", "vertices": [[1.4, -0.7], [0.9, -0.2], [0.5, 0.2], [-0.5, 1.2]] } });
    let fleet = json!({
        "format": "planarium-fleet-1", "name": "thin", "world": { "bounds": { "min": [0, 0], "max": [8, 4] }, "obstacles": [] },
        "robots": [
            { "name": "a", "robot": thin, "start": [1, 2, 0], "goal": [5, 2, 1.5] },
            { "name": "b", "robot": thin, "start": [3, 2, 0.1], "goal": [2, 2, 0] },
            { "name": "c", "robot": { "type": "disc", "radius": 0.1 }, "start": [0.5, 0.5], "goal": [7, 0.5] }
        ]
    });
    let fleet = Fleet::parse(&fleet.to_string()).expect("a fleet");
    for seed in 0..3 {
        let result = planned(&fleet, "prioritized", seed).result();
        assert_eq!(result.status, Status::Solved);
        let verification = verify(&fleet, &result).expect("a plan of this fleet");
        assert!(verification.is_valid(), "{verification:?}");
        let trajectories = trajectories(&fleet, &result).expect("a plan of this fleet");
        assert_eq!(seen(&fleet, &trajectories), None);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_plan_that_was_changed_is_found_out() {
    let fleet = generate("crossroads", &json!({ "count": 6 })).expect("crossroads");
    let result = planned(&fleet, "prioritized", 1).result();
    assert!(verify(&fleet, &result).expect("a plan").is_valid());
    let judged = |change: &dyn Fn(&mut planarium::fleet::FleetResult)| {
        let mut changed = result.clone();
        change(&mut changed);
        verify(&fleet, &changed).expect("still a plan")
    };
    let hurried = judged(&|plan| plan.robots[0].times.iter_mut().for_each(|time| *time /= 1.5));
    assert!(hurried.faults.iter().any(|fault| fault.robot == 0 && fault.why.contains("speed")), "{hurried:?}");
    let elsewhere = judged(&|plan| plan.robots[1].path.last_mut().expect("a row")[0] += 0.01);
    assert!(elsewhere.faults.iter().any(|fault| fault.robot == 1), "{elsewhere:?}");
    let all_at_once = {
        let straight = straight(&fleet);
        judged(&|plan| {
            for (robot, trajectory) in plan.robots.iter_mut().zip(&straight) {
                robot.times = trajectory.times().to_vec();
                robot.path = trajectory.poses().iter().map(|pose| pose[..2].to_vec()).collect();
            }
        })
    };
    assert!(!all_at_once.conflicts.is_empty() && all_at_once.conflicts.is_sorted_by(|a, b| a.from <= b.from));
    let mut missing = result.clone();
    missing.robots.pop();
    refuses(verify(&fleet, &missing), "invalid-result", "/robots");
}

/// A fleet in an open square of 10 m, and a plan of it with these rows, whose totals are right.
fn rows_of(robots: serde_json::Value, rows: &[(&[f64], &[&[f64]])]) -> (Fleet, planarium::fleet::FleetResult) {
    let document = json!({ "format": "planarium-fleet-1", "name": "square", "robots": robots,
        "world": { "bounds": { "min": [0, 0], "max": [10, 10] }, "obstacles": [] } });
    let fleet = Fleet::read(&document).expect("a fleet");
    let of = |(member, (times, path)): (&planarium::fleet::FleetRobot, &(&[f64], &[&[f64]]))| {
        let path = path.iter().map(|q| q.to_vec()).collect();
        planarium::fleet::RobotTrajectory { name: member.name.clone(), times: times.to_vec(), path }
    };
    let mut result = planner(&fleet, "prioritized", 0, None).result();
    result.status = Status::Solved;
    result.robots = fleet.robots().iter().zip(rows).map(of).collect();
    if let Ok(trajectories) = trajectories(&fleet, &result) {
        result.makespan = trajectories.iter().map(Trajectory::arrival).fold(0.0, f64::max);
        result.sum_of_costs = trajectories.iter().map(Trajectory::arrival).sum();
        result.waits = trajectories.iter().map(Trajectory::waits).sum();
    }
    (fleet, result)
}

fn small_disc(name: &str, speed: f64, start: [f64; 2], goal: [f64; 2]) -> serde_json::Value {
    json!({ "name": name, "robot": { "type": "disc", "radius": 0.1 }, "speed": speed, "start": start, "goal": goal })
}

#[wasm_bindgen_test(unsupported = test)]
fn a_motion_is_judged_by_its_own_time_however_late_others_are() {
    let one = json!([small_disc("a", 1.0, [1.0, 1.0], [9.0, 1.0])]);
    let honest: (&[f64], &[&[f64]]) = (&[0.0, 8.0, 5e4], &[&[1.0, 1.0], &[9.0, 1.0], &[9.0, 1.0]]);
    let (fleet, plan) = rows_of(one.clone(), &[honest]);
    assert!(verify(&fleet, &plan).expect("a plan").is_valid(), "waiting at the goal is no motion");
    // A jump, at once or in steps that a late row would round away.
    for steps in [1, 40] {
        for late in [0.0, 3e4] {
            let mut times: Vec<f64> = (0..=steps).map(|k| 1e-12 * f64::from(k)).collect();
            let mut path: Vec<[f64; 2]> =
                (0..=steps).map(|k| [1.0 + 8.0 * f64::from(k) / f64::from(steps), 1.0]).collect();
            if late > 0.0 {
                times.push(late);
                path.push([9.0, 1.0]);
            }
            let path: Vec<&[f64]> = path.iter().map(|q| &q[..]).collect();
            let (fleet, plan) = rows_of(one.clone(), &[(&times, &path)]);
            let verification = verify(&fleet, &plan).expect("a plan");
            assert!(verification.faults.iter().any(|fault| fault.why.contains("speed")), "{verification:?}");
        }
    }
    // Where the next double is farther than the slack, at the speed of the robot, nothing is judged.
    for late in [1e5, 1e16, f64::MAX] {
        let (fleet, plan) = rows_of(one.clone(), &[(&[0.0, 8.0, late], honest.1)]);
        refuses(verify(&fleet, &plan), "invalid-result", "/robots/0/times/2");
    }
    let two = json!([small_disc("a", 1.0, [1.0, 1.0], [3.0, 1.0]), small_disc("b", 1.0, [2.25, 1.0], [2.25, 3.0])]);
    let through = |begin: f64| {
        let a: [f64; 4] = [0.0, begin, begin + 2.0, begin + 2000.0];
        let b: [f64; 3] = [0.0, begin + 1000.0, begin + 1002.0];
        rows_of(
            two.clone(),
            &[
                (&a, &[&[1.0, 1.0], &[1.0, 1.0], &[3.0, 1.0], &[3.0, 1.0]]),
                (&b, &[&[2.25, 1.0], &[2.25, 1.0], &[2.25, 3.0]]),
            ],
        )
    };
    let (fleet, plan) = through(1e16);
    refuses(verify(&fleet, &plan), "invalid-result", "/robots/0/times/1");
    for begin in [0.0, 1.0, 3e4] {
        let (fleet, plan) = through(begin);
        let verification = verify(&fleet, &plan).expect("a plan");
        let [conflict] = &verification.conflicts[..] else { panic!("{begin}: {verification:?}") };
        let [from, to] = [conflict.from, conflict.to.expect("it ends")].map(|time| time - begin);
        assert!((from - 1.05).abs() < 1e-9 && (to - 1.45).abs() < 1e-9, "{begin}: {conflict:?}");
        assert!(verification.faults.is_empty() && verification.claims.is_empty(), "{verification:?}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_work_of_the_verifier_is_bounded_by_the_size_of_a_plan() {
    let discs: Vec<_> = (0..4)
        .map(|i| small_disc(&i.to_string(), 1.0, [2.0 * f64::from(i) + 1.0, 1.0], [2.0 * f64::from(i) + 1.0, 3.0]))
        .collect();
    for (far, is_refused) in [(1e300, true), (-1.1e6, true), (1e6, false)] {
        let paths: Vec<[[f64; 2]; 3]> = (0..4)
            .map(|i| 2.0 * f64::from(i) + 1.0)
            .map(|x| [[x, 1.0], [if x > 4.0 { far } else { x }, 2.0], [x, 3.0]])
            .collect();
        let rows: Vec<Vec<&[f64]>> = paths.iter().map(|path| path.iter().map(|q| &q[..]).collect()).collect();
        let rows: Vec<(&[f64], &[&[f64]])> = rows.iter().map(|path| (&[0.0, 1.0, 2.0][..], &path[..])).collect();
        let (fleet, plan) = rows_of(json!(discs), &rows);
        if is_refused {
            refuses(verify(&fleet, &plan), "invalid-result", "/robots/2/path/1");
        } else {
            let verification = verify(&fleet, &plan).expect("a plan");
            assert!(!verification.faults.is_empty() && verification.looks < 100, "{verification:?}");
        }
    }
    // Two bodies that turn side by side, so near that no number of steps decides.
    let shape = json!({ "type": "polygon", "vertices": [[-0.6, -0.2], [0.6, -0.2], [0.6, 0.2], [-0.6, 0.2]] });
    let bodies: Vec<_> = [("a", 2.0), ("b", 2.4 + 1e-7)]
        .map(|(name, y)| {
            json!({ "name": name, "robot": { "type": "rigid_body", "shape": shape }, "start": [1, y, 0], "goal": [9, y, 0] })
        })
        .into();
    let paths = [2.0, 2.4 + 1e-7].map(|y| [[1.0, y, 0.0], [9.0, y, 0.0]]);
    let late = [0.5, 0.0].map(|wait| [0.0, wait, wait + 8.0]);
    let rows: Vec<Vec<&[f64]>> = paths.iter().map(|[from, to]| vec![&from[..], &from[..], &to[..]]).collect();
    let rows: Vec<(&[f64], &[&[f64]])> = late.iter().zip(&rows).map(|(times, path)| (&times[..], &path[..])).collect();
    let (fleet, plan) = rows_of(json!(bodies), &rows);
    let verification = verify(&fleet, &plan).expect("a plan");
    assert!(verification.looks < 300_000, "{verification:?}");
    assert!(!verification.valid, "what is undecided is no valid plan");
}

#[wasm_bindgen_test(unsupported = test)]
fn what_a_plan_says_of_itself_is_compared_with_its_rows() {
    for id in ["prioritized", "composite"] {
        let (kind, options) =
            if id == "composite" { ("swap", json!({})) } else { ("crossroads", json!({ "count": 6 })) };
        let fleet = generate(kind, &options).expect("a fleet");
        let result = planned(&fleet, id, 1).result();
        let claims = |change: &dyn Fn(&mut planarium::fleet::FleetResult)| {
            let mut changed = result.clone();
            change(&mut changed);
            let verification = verify(&fleet, &changed).expect("still a plan");
            assert!(verification.conflicts.is_empty() && verification.faults.is_empty());
            assert_eq!(verification.is_valid(), verification.claims.is_empty());
            verification.claims.into_iter().map(|claim| claim.pointer).collect::<Vec<_>>()
        };
        assert_eq!(claims(&|_| ()), [""; 0]);
        assert_eq!(claims(&|plan| plan.makespan *= 1.0 - 1e-6), ["/makespan"]);
        assert_eq!(claims(&|plan| plan.sum_of_costs += 0.001), ["/sum_of_costs"]);
        assert_eq!(claims(&|plan| plan.waits += 0.001), ["/waits"]);
        assert_eq!(claims(&|plan| plan.waits = f64::NAN), ["/waits"]);
        let names: Vec<String> = fleet.robots().iter().map(|member| member.name.clone()).collect();
        assert_eq!(claims(&|plan| plan.order = Some(names[1..].to_vec())), ["/order"]);
        assert_eq!(claims(&|plan| plan.order = Some(vec![names[0].clone(); names.len()])), ["/order"]);
        let blocked = planarium::fleet::BlockedNames { robot: names[0].clone(), by: Vec::new() };
        assert_eq!(claims(&|plan| plan.blocked = Some(blocked.clone())), ["/blocked"]);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_plan_with_times_too_late_to_be_told_apart_is_not_given() {
    let wall = |[left, bottom]: [f64; 2], [right, top]: [f64; 2]| json!({ "type": "polygon", "vertices": [[left, bottom], [right, bottom], [right, top], [left, top]] });
    let fleet = |slow: f64| {
        let fleet = json!({
        "format": "planarium-fleet-1", "name": "late",
        "world": { "bounds": { "min": [0, 0], "max": [10, 2] },
            "obstacles": [wall([3.0, 0.0], [7.0, 0.7]), wall([3.0, 1.3], [7.0, 2.0])] },
        "robots": [
            { "name": "slow", "robot": { "type": "disc", "radius": 0.25 }, "speed": 1e-6, "start": [slow, 1], "goal": [9, 1] },
            { "name": "fast", "robot": { "type": "disc", "radius": 0.25 }, "speed": 1e3, "start": [9, 0.4], "goal": [1, 0.4] }
        ]
        });
        Fleet::parse(&fleet.to_string()).expect("a fleet")
    };
    // The fast one drives through the corridor first.
    let before = fleet(1.0);
    let first = planned(&before, "prioritized", 1);
    assert_eq!((first.status(), first.reason()), (Status::Solved, None));
    assert!(verify(&before, &first.result()).expect("a plan of this fleet").is_valid());
    // Or it waits for 40 days, a time known to within 5e-10 s and so 5e-7 m.
    let inside = fleet(4.0);
    let mut last = planner(&inside, "prioritized", 1, Some(&["slow", "fast"]));
    assert_eq!((last.step(u64::MAX), last.reason()), (Status::Exhausted, Some(FleetReason::TooLate)));
    assert_eq!((last.makespan(), last.blocked()), (0.0, None));
    let result = last.result();
    assert_eq!(planarium::fleet::FleetResult::parse(&result.to_json()).expect("a result"), result);
}

#[wasm_bindgen_test(unsupported = test)]
fn another_order_can_succeed_where_one_fails() {
    // In a corridor for one, "a" cannot pass the start of "b", which can go on first.
    let mut document = two_discs();
    document["world"] = json!({ "bounds": { "min": [0, 1], "max": [10, 2.9] }, "obstacles": [] });
    (document["robots"][0]["goal"], document["robots"][1]["start"]) = (json!([5, 2]), json!([3, 2]));
    document["robots"][1]["goal"] = json!([9, 2]);
    let fleet = Fleet::read(&document).expect("a fleet");
    let mut failed = planner(&fleet, "prioritized", 1, Some(&["a", "b"]));
    assert_eq!(failed.step(u64::MAX), Status::Exhausted);
    assert_eq!(failed.blocked().map(|blocked| (blocked.robot, blocked.by.clone())), Some((0, vec![1])));
    let mut other = planner(&fleet, "prioritized", 1, Some(&["b", "a"]));
    assert_eq!(other.step(u64::MAX), Status::Solved);
    assert_free(&other, "the other order");
    // If no order is given, others are tried.
    let restarted = planned(&fleet, "prioritized", 1);
    assert_eq!((restarted.status(), restarted.order()), (Status::Solved, vec![1, 0]));
    assert!(restarted.stats().restarts > 0);
    assert_free(&restarted, "restarted");
}

#[wasm_bindgen_test(unsupported = test)]
fn plans_are_the_same_on_every_platform() {
    golden::check("golden-fleet.json", include_str!("golden-fleet.json"), 8, |case| {
        let fleet = generate(case["generator"].as_str().expect("a generator"), &case["options"]).expect("a fleet");
        let planner =
            planned(&fleet, case["planner"].as_str().expect("a planner"), case["seed"].as_u64().expect("a seed"));
        let result = planner.result();
        json!({ "status": result.status, "makespan": result.makespan, "fingerprint": format!("{:016x}", result.fingerprint),
            "expanded": result.stats.expanded, "pair_checks": result.stats.pair_checks })
    });
}
