//! The straight motion from start to goal comes first; steps adapt to the scene; neither tree of RRT-Connect starves the other.

use crate::common::documents::{arm, polygon, rectangle, rectangular, scenario};
use crate::common::graphs::{edges, rows};
use crate::common::requests::{start, start_problem};
use crate::common::{assert_valid, begin_with, finish, given, seeds};
use planarium::graph::UnionFind;
use planarium::random::{Random, Stream};
use planarium::run::planners;
use planarium::run::{CoordinateDescription, CustomProblem, Free, Request, Run, SpaceDescription, Status};
use planarium::scenario::Scenario;
use wasm_bindgen_test::wasm_bindgen_test;

const BOUNDS: &str = "[0, 0], [10, 10]";
const TOLERANCE: &str = r#", "goal_tolerance": {"translation": 0.1, "rotation": 0.1}"#;

/// Worlds whose goal is in plain sight, at the goal that is given: every robot, and an obstacle elsewhere.
fn in_sight(goal: [f64; 2]) -> Vec<(Scenario, &'static str)> {
    let obstacle = rectangle([8.0, 8.0], [9.0, 9.0]);
    let ends = |start: &str, goal: String| format!(r#""start": {start}, "goal": {goal}"#);
    let placed = || ends("[1, 5, 0]", format!("[{}, {}, 0]", goal[0], goal[1])) + TOLERANCE;
    let body = rectangular("rigid_body", 0.3, 0.2, "");
    let car = |speed: &str| {
        rectangular("car", 0.3, 0.2, &format!(r#""wheelbase": 0.3, "speed": {speed}, "steering": [-0.7, 0.7]"#))
    };
    let disc = r#"{"type": "disc", "radius": 0.1}"#;
    let turn = (goal[0] - 1.0) / 10.0;
    vec![
        (scenario(BOUNDS, &obstacle, disc, &ends("[1, 5]", format!("{goal:?}"))), ""),
        (
            scenario(
                "",
                &rectangle([1.5, 1.5], [1.6, 1.6]),
                &arm(&[1.0, 0.5], 0.02),
                &ends("[0, 0.2]", format!("[{}, 0.2]", -turn)),
            ),
            "",
        ),
        (scenario(BOUNDS, &obstacle, &body, &placed()), ""),
        (scenario(BOUNDS, &obstacle, &car("[-1, 1]"), &placed()), "steering=reeds-shepp"),
        (scenario(BOUNDS, &obstacle, &car("[0, 1]"), &placed()), "steering=dubins"),
    ]
}

/// Whether the planner grows a tree or trees by motions of the space, and so ends with its first iteration.
fn ends_at_once(id: &str) -> bool {
    !id.contains("prm")
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_takes_the_straight_motion_to_a_goal_in_sight() {
    for goal in [[1.0, 5.0], [1.001, 5.0], [6.0, 5.0]] {
        for (world, settings) in in_sight(goal) {
            for planner in planners() {
                let id = planner.info().id;
                let is_driven = ["rrt-control", "sst"].contains(&id);
                let is_refused = settings.contains("dubins") && planner.needs_symmetry();
                if is_driven || is_refused || !planner.is_for(world.robot().kind()) {
                    continue;
                }
                let samples = if ["prm", "prm-star", "lazy-prm"].contains(&id) { "samples=200 " } else { "" };
                let run = finish(begin_with(&world, id, 3, &format!("{samples}{settings}")));
                let what = format!("{id} {settings} in {} to {goal:?}", world.robot().kind());
                assert_eq!(run.status(), Status::Solved, "{what}");
                let path = run.path();
                let (from, to) = (&path[0], &path[path.len() - 1]);
                let least = if world.robot().kind() == "arm" {
                    (from[0] - to[0]).abs()
                } else {
                    let metres = libm::hypot(to[0] - from[0], to[1] - from[1]);
                    if world.robot().kind() == "rigid_body" { 0.7 * metres } else { metres }
                };
                // Lengths of cars may be weighted: what counts there is that there is no detour.
                let is_car = world.robot().kind() == "car";
                assert!(run.length() <= least + 1e-9, "{what}: {} is more than {least}", run.length());
                assert!(is_car || run.length() >= least - 1e-9, "{what}: {} is less than {least}", run.length());
                assert_valid(&world, &*run);
                if ends_at_once(id) {
                    assert_eq!((run.iterations(), run.edge_count()), (1, 1), "{what}");
                    assert_eq!(edges(&*run)[0], [0, 1], "{what}");
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_straight_motion_that_is_not_wanted_is_not_tried_first() {
    for (world, settings) in in_sight([6.0, 5.0]) {
        for planner in ["rrt", "rrt-connect"] {
            let run = finish(begin_with(&world, planner, 3, &format!("direct=false step=0.4 {settings}")));
            assert_eq!(run.status(), Status::Solved);
            assert!(run.edge_count() > 1, "{planner} grows");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_several_goals_the_nearest_in_sight_is_reached_directly() {
    let side = CoordinateDescription::interval(-2.0, 2.0);
    let space = SpaceDescription { coordinates: vec![side, side], metric: None };
    // A disc hides the nearest goal.
    let free = Free::by_clearance(|rows, clearances| {
        for (q, clearance) in rows.chunks(2).zip(clearances) {
            *clearance = libm::hypot(q[0], q[1]) - 0.5;
        }
        Ok(())
    });
    let goals = [vec![-1.0, 1.9], vec![1.0, 0.0], vec![-1.0, -1.5]];
    let problem = CustomProblem::new(space, free, &[-1.0, 0.0], &goals).expect("a problem");
    let run = |planner: &str, settings: &str| {
        let parameters = given(settings);
        let options = Request { planner: Some(planner.to_owned()), parameters, ..Request::default() };
        finish(start_problem(&problem, &options).expect("a run"))
    };
    for planner in ["rrt", "rrt-connect", "fmt-star", "rrt-star", "bit-star", "aorrtc"] {
        let run = run(planner, "");
        assert_eq!((run.length(), run.iterations(), run.edge_count()), (1.5, 1, 1), "{planner}");
        assert_eq!(edges(&*run)[0], [0, 3], "{planner}");
    }
    for planner in ["prm", "lazy-prm", "prm-star", "visibility-prm"] {
        assert!(run(planner, "").length() <= 1.9 + 1e-9, "{planner}");
    }
}

/// Unit squares, blocked at random, for a disc from corner to corner.
fn field(cells: u64, share: f64, seed: u64) -> Scenario {
    let mut random = Random::new(seed, Stream::Scenario);
    let mut squares = Vec::new();
    for (x, y) in (0..cells).flat_map(|x| (0..cells).map(move |y| (x, y))) {
        let is_end = (x, y) == (0, 0) || (x, y) == (cells - 1, cells - 1);
        if random.uniform() < share && !is_end {
            let [x, y] = [x as f64, y as f64];
            squares.push(rectangle([x, y], [x + 1.0, y + 1.0]));
        }
    }
    let far = cells as f64 - 0.5;
    let bounds = format!("[0, 0], [{cells}, {cells}]");
    let query = format!(r#""start": [0.5, 0.5], "goal": [{far}, {far}]"#);
    scenario(&bounds, &squares.join(","), r#"{"type": "disc", "radius": 0.3}"#, &query)
}

#[wasm_bindgen_test(unsupported = test)]
fn default_steps_find_a_way_among_many_small_obstacles() {
    let world = field(150, 0.09, 2);
    for seed in 0..seeds(20) {
        for (planner, most) in [("rrt-connect", 40_000), ("rrt", 100_000)] {
            let run = finish(begin_with(&world, planner, seed, &format!("max_iterations={most}")));
            assert_eq!(run.status(), Status::Solved, "{planner}, seed {seed}");
            assert_valid(&world, &*run);
        }
    }
}

/// A car that is to leave a lane for a slot between two others, with a quarter of a metre to spare before and behind.
fn slot() -> Scenario {
    let cars = [
        rectangle([-10.0, 0.0], [-0.93 - 0.25, 2.0]),
        rectangle([3.76 + 0.25, 0.0], [12.0, 2.0]),
        rectangle([-10.0, -0.3], [12.0, -0.1]),
    ];
    let shape = polygon(&[[-0.93, -0.97], [3.76, -0.97], [3.76, 0.97], [-0.93, 0.97]]);
    let robot = format!(
        r#"{{"type": "car", "shape": {shape}, "wheelbase": 2.8, "speed": [-2.5, 2.5], "steering": [-0.75, 0.75]}}"#
    );
    let bounds = "[-12, -1], [14, 9]";
    let query = format!(r#""start": [0, 6, 0], "goal": [0, 1, 0]{}"#, TOLERANCE.replace("0.1", "0.2"));
    scenario(bounds, &cars.join(","), &robot, &query)
}

/// How many vertices are connected to the start, and how many to the goal.
fn sizes(run: &dyn Run) -> [usize; 2] {
    let (count, mut parts) = (rows(run).len(), UnionFind::default());
    (0..count).for_each(|_| parts.add());
    for [a, b] in edges(run) {
        parts.join(a, b);
    }
    [0, 1].map(|root| (0..count).filter(|&vertex| parts.find(vertex) == parts.find(root)).count())
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tree_that_is_stuck_does_not_starve_the_other() {
    // Steps that adapt, and steps too long to leave the slot by.
    for (settings, least) in [("", [300, 100]), ("step=3", [300, 1])] {
        let mut run = begin_with(&slot(), "rrt-connect", 1, settings);
        if run.step(5000) == Status::Running {
            let [start_side, goal_side] = sizes(&*run);
            assert!(
                start_side >= least[0] && goal_side >= least[1],
                "{settings}: {start_side} and {goal_side} vertices"
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn without_a_name_the_planner_shortens_its_path_and_a_car_follows_curves() {
    let run = |world: &Scenario, settings: &str| {
        finish(start(world, &Request { parameters: given(settings), seed: 3, ..Request::default() }).expect("a run"))
    };
    let world = field(30, 0.09, 1);
    let (shortened, raw) = (run(&world, ""), run(&world, "reduce=false shortcut=0"));
    assert_eq!(raw.length(), finish(begin_with(&world, "rrt-connect", 3, "")).length());
    assert!(shortened.length() < raw.length(), "{} and {}", shortened.length(), raw.length());
    for (world, settings) in in_sight([6.0, 5.0]) {
        let planner = if world.robot().kind() == "car" { "rrt-connect" } else { continue };
        // Without a word on steering it follows the curves that its gears allow.
        let (told, left_out) = (run(&world, &format!("{settings} direct=false")), run(&world, "direct=false"));
        assert_eq!((told.result().planner.as_str(), told.fingerprint()), (planner, left_out.fingerprint()));
    }
    // A car that only steers to the left.
    let left = rectangular("car", 0.3, 0.2, r#""wheelbase": 0.3, "speed": [-1, 1], "steering": [0, 0.7]"#);
    let query = format!(r#""start": [1, 5, 0], "goal": [6, 5, 0]{TOLERANCE}"#);
    assert_eq!(run(&scenario(BOUNDS, "", &left, &query), "max_iterations=10").result().planner, "rrt-control");
}
