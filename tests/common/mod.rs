//! Shared by several tests: small worlds and runs to the end.
pub mod arms;
pub mod bodies;
pub mod documents;
pub mod driven;
pub mod golden;
pub mod graphs;
pub mod places;
pub mod requests;

use documents::{arm, disc, jointed_arm, judged, limited_arm, named, polygon, rectangle, rectangular};
pub use documents::{deep, parse};
use planarium::problem::{Status, Stepped};
use planarium::run::{Request, Run, Value};
use planarium::scenario::Scenario;
use std::fmt::Debug;

/// How many seeds a property is tested on: all in a deep run, a quarter natively and at most ten in WebAssembly, but at least ten.
pub fn seeds(all: u64) -> u64 {
    let bounded = if cfg!(target_arch = "wasm32") { 10 } else { (all / 4).max(10) };
    if deep() { all } else { all.min(bounded) }
}

/// How many random cases a property is tested on: all in a deep run, a quarter natively, a fortieth in WebAssembly.
pub fn cases(all: usize) -> usize {
    let part = if cfg!(target_arch = "wasm32") { 40 } else { 4 };
    if deep() { all } else { all.div_ceil(part) }
}

/// A two-link arm at the origin whose plane is cut by a wall of the given thickness to the right of the base: the straight
/// motion from above the wall to below it is blocked, the other direction, round the back, is free.
pub fn arm_and_wall(thickness: f64) -> Scenario {
    arm_at_wall(thickness, "", 0.0)
}

/// The same with links of radius 0.05, within bounds.
pub fn thick_arm_and_wall(thickness: f64) -> Scenario {
    arm_at_wall(thickness, "[-2, -2], [2, 2]", 0.05)
}

fn arm_at_wall(thickness: f64, bounds: &str, radius: f64) -> Scenario {
    let name = if radius > 0.0 { "thick-arm-and-wall" } else { "arm-and-wall" };
    let wall = rectangle([0.7, -thickness / 2.0], [3.0, thickness / 2.0]);
    named(name, bounds, &wall, &arm(&[1.0, 0.8], radius), r#""start": [0.6, 0.2], "goal": [-0.6, -0.2]"#)
}

/// An arm whose second link slides out of the first, at the same wall: it is passed round the back, or drawn in.
pub fn sliding_arm_and_wall(thickness: f64) -> Scenario {
    let wall = rectangle([0.7, -thickness / 2.0], [3.0, thickness / 2.0]);
    let robot = jointed_arm(&[0.4, 0.1], 0.02, r#""revolute", {"type": "prismatic", "range": [0, 1.2], "angle": 0}"#);
    named("sliding-arm-and-wall", "[-2, -2], [2, 2]", &wall, &robot, r#""start": [0.6, 0.9], "goal": [-0.6, 0.8]"#)
}

/// A disc of the given radius in a box of side 10, cut by a wall of the given thickness with a gap of width 1 near the top.
pub fn disc_and_wall(radius: f64, thickness: f64) -> Scenario {
    let (left, right) = (5.0 - thickness / 2.0, 5.0 + thickness / 2.0);
    let walls = [rectangle([left, 0.0], [right, 8.0]), rectangle([left, 9.0], [right, 10.0])].join(",");
    let robot = format!(r#"{{"type": "disc", "radius": {radius:?}}}"#);
    named("disc-and-wall", "[0, 0], [10, 10]", &walls, &robot, r#""start": [1, 1], "goal": [9, 1]"#)
}

/// A disc whose straight way is barely blocked.
pub fn disc_and_pillar() -> Scenario {
    let query = r#""start": [1, 5], "goal": [9, 5]"#;
    named("disc-and-pillar", "[0, 0], [10, 10]", &disc([5.0, 5.0], 0.05), r#"{"type": "disc", "radius": 0.05}"#, query)
}

/// An arm whose start and goal are free but cut off from each other by two walls that it cannot pass.
pub fn no_way() -> Scenario {
    let walls = [rectangle([0.3, -0.1], [0.5, 0.1]), disc([-0.4, 0.0], 0.1)].join(",");
    named("no-way", "", &walls, &arm(&[1.0, 1.0], 0.0), r#""start": [1.5, 0], "goal": [-1.5, 0]"#)
}

/// Arms of one to eight links among discs and polygons, some with limits, thick and thin.
pub fn arm_of(links: usize, limits: bool, radius: f64) -> Scenario {
    let limits = if limits { vec![[-3.5, 3.5]; links] } else { Vec::new() };
    let mut obstacles = vec![disc([0.1, 1.3], 0.2)];
    // A single link sweeps past everything within its reach, so for it the lower side is free.
    if links > 1 {
        obstacles.push(polygon(&[[-0.9, -1.2], [-0.5, -1.1], [-0.7, -0.9], [-0.6, -0.5], [-1.0, -0.6]]));
    }
    let robot = limited_arm(&vec![1.6 / links as f64; links], radius, &limits);
    let query = format!(r#""start": {:?}, "goal": [2.9{}]"#, vec![0.15; links], ", -0.1".repeat(links - 1));
    named(&format!("arm-of-{links}"), "", &obstacles.join(","), &robot, &query)
}

/// A car, 0.2 by 0.1, in a box of side 2 that is cut by a wall of the given thickness, with a gap of width 0.5 above it.
pub fn car_and_wall(thickness: f64) -> Scenario {
    car_at_wall(thickness, 1.5)
}

/// The same with a wall of that thickness without a gap.
pub fn car_shut_in(thickness: f64) -> Scenario {
    car_at_wall(thickness, 2.0)
}

fn car_at_wall(thickness: f64, height: f64) -> Scenario {
    let limits = r#""wheelbase": 0.2, "speed": [-0.5, 0.5], "steering": [-0.75, 0.75]"#;
    let region = r#", "goal_tolerance": { "translation": 0.1, "rotation": 0.5 }"#;
    placed_at_wall("car", limits, region, thickness, height)
}

/// A rigid body of the same size in the same world.
pub fn body_and_wall(thickness: f64) -> Scenario {
    placed_at_wall("rigid_body", "", "", thickness, 1.5)
}

fn placed_at_wall(kind: &str, fields: &str, region: &str, thickness: f64, height: f64) -> Scenario {
    let obstacles = [rectangle([1.0 - thickness, 0.0], [1.0, height]), disc([1.5, 1.3], 0.1)].join(",");
    let query = format!(r#""start": [0.4, 0.3, 0], "goal": [1.6, 0.4, 0]{region}"#);
    named(kind, "[0, 0], [2, 2]", &obstacles, &rectangular(kind, 0.1, 0.05, fields), &query)
}

/// Arms, thin and thick, one of them with a link that slides, and a disc.
pub fn worlds() -> [Scenario; 6] {
    let [thin, thick, sliding] = [arm_and_wall(0.1), thick_arm_and_wall(0.2), sliding_arm_and_wall(0.1)];
    [thin, thick, arm_of(3, true, 0.02), arm_of(6, false, 0.0), disc_and_wall(0.3, 0.5), sliding]
}

/// The planners by controls with settings that show their features, small enough for many runs.
pub const DRIVEN: &[(&str, &str)] = &[
    ("rrt-control", ""),
    ("rrt-control", "blossom=4 shortest_steps=20 goal_test=ends"),
    ("rrt-control", "blossom=6 blocked=refused goal_every=7"),
    ("rrt-control", "nearest=nearest-visible near_goal_steps=20 sampler=halton"),
    ("rrt-control", "controls=reeds-shepp duration_steps=120 once=true"),
    ("rrt-control", "max_iterations=3000 duration_steps=200 late_duration_steps=80 goal_every=10 late_goal_every=5"),
    ("sst", ""),
    ("sst", "improve_iterations=400 selection_radius=0.3 pruning_radius=0.15"),
    ("sst", "shortest_steps=50 blocked=refused sampler=goal-biased"),
];

/// Starts a run of the scenario's first query, with settings as a line of `name=value`.
pub fn begin_with(scenario: &Scenario, planner: &str, seed: u64, settings: &str) -> Box<dyn Run> {
    requests::start(scenario, &options(planner, seed, settings)).unwrap_or_else(|error| panic!("{error}"))
}

/// Options with settings as a line of `name=value`.
pub fn options(planner: &str, seed: u64, settings: &str) -> Request {
    Request { planner: Some(planner.to_owned()), seed, parameters: given(settings), ..Request::default() }
}

/// Settings given as a line of `name=value`.
pub fn given(settings: &str) -> Vec<(String, Value)> {
    let setting = |setting: &str| {
        let (name, value) = setting.split_once('=').expect("name=value");
        (name.to_owned(), Value::from_text(value))
    };
    settings.split_whitespace().map(setting).collect()
}

/// Every planner with settings that show its features, small enough for many runs.
pub const PLANNERS: &[(&str, &str)] = &[
    ("prm", "samples=150 k=8"),
    ("prm", "samples=150 k=8 insertion=one-by-one"),
    ("prm", "samples=100 k=8 insertion=one-by-one discard=true"),
    ("prm", "samples=150 radius=1.2"),
    ("prm", "samples=150 radius=1.5 k=12 metric=naive"),
    ("prm-star", "samples=150"),
    ("lazy-prm", "samples=150 k=8"),
    ("lazy-prm-star", "improve_iterations=300"),
    ("visibility-prm", "failures=60"),
    ("rrt", ""),
    ("rrt", "extend=half goal_every=5"),
    ("rrt", "extend=until-obstacle goal_bias=0.2"),
    ("rrt-connect", ""),
    ("rrt-connect", "shortcut=40 reduce=true partial_shortcut=40"),
    ("rrt-star", "improve_iterations=100"),
    ("rrt-star", "near=k-nearest improve_iterations=50 goal_every=5"),
    ("informed-rrt-star", "improve_iterations=100"),
    ("fmt-star", "samples=150"),
    ("fmt-star", "samples=40 near=radius"),
    ("bit-star", "batch_size=40 improve_iterations=300"),
    ("bit-star", "near=k-nearest improve_iterations=100"),
    ("aorrtc", "improve_iterations=200"),
    ("aorrtc", "improve_iterations=60 path_shortcuts=0"),
    ("informed-rrt-star", "improve_iterations=40 stop_stale=30 stop_evaluations=2000 stop_when=all"),
];

/// Every sampler.
pub const SAMPLERS: &[&str] = &["uniform", "halton", "lattice", "gaussian", "bridge", "obstacle-based", "goal-biased"];

/// Settings without those that this scenario's robot refuses: a disc has no naive metric.
pub fn fitting(scenario: &Scenario, settings: &str) -> String {
    let is_disc = matches!(scenario.robot(), planarium::scenario::Robot::Disc(_));
    let fits = |setting: &&str| !(is_disc && setting.starts_with("metric="));
    settings.split_whitespace().filter(fits).collect::<Vec<_>>().join(" ")
}

/// Checks that the path of a run is valid.
#[track_caller]
pub fn assert_valid(scenario: &Scenario, run: &dyn Run) {
    judged(scenario, &run.result()).unwrap_or_else(|why| panic!("{why}: {}", run.result().to_json()));
}

/// Runs to the end.
pub fn finish(mut run: Box<dyn Run>) -> Box<dyn Run> {
    run.step(u64::MAX);
    run
}

/// All that a run has found, in words.
#[expect(clippy::borrowed_box, reason = "the box is what is stepped")]
pub fn of_run(run: &Box<dyn Run>) -> String {
    run.result().to_json()
}

/// The law of slices: in slices of 1, of 7, and in one the outcome is the same. Returns what was stepped in one.
#[track_caller]
pub fn sliced<S: Stepped, T: PartialEq + Debug>(what: &str, begin: impl Fn() -> S, outcome: impl Fn(&S) -> T) -> S {
    let mut whole = begin();
    whole.step(u64::MAX);
    for slice in [1, 7] {
        let mut run = begin();
        while run.step(slice) == Status::Running {}
        assert_eq!(outcome(&run), outcome(&whole), "{what} in slices of {slice}");
        assert_eq!((run.status(), run.iterations()), (whole.status(), whole.iterations()), "{what}");
    }
    whole
}
