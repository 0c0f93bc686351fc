//! The law of slices: whatever is stepped ends the same in slices of 1, of 7, and in one. Custom robots, saved roadmaps and
//! fleets in a corridor obey it in their own tests; so do experiments and drives, which are not `Stepped`.

use crate::as_reported::{REPORTED, REPORTED_DRIVEN};
use crate::common::{
    DRIVEN, PLANNERS, SAMPLERS, arm_and_wall, begin_with, body_and_wall, car_and_wall, disc_and_wall, fitting, given,
    no_way, of_run, sliced, worlds,
};
use planarium::certificate::{self, Subdivision};
use planarium::fleet::{self, FleetOptions, FleetPlanner};
use planarium::geometry::Point;
use planarium::ik::{MethodOptions, Solver, SolverOptions};
use planarium::navigation::{self, Comparison, ComparisonOptions, Training, TrainingOptions};
use planarium::options::Options as _;
use planarium::problem::Stepped;
use planarium::robot::Target;
use planarium::scenario::Scenario;
use planarium::trajectories::{Trajectories, TrajectoryOptions};
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// A planner in a world. Returns the fingerprint of its run.
fn plan(world: &Scenario, planner: &str, settings: &str) -> u64 {
    let limit = if settings.contains("max_iterations") { "" } else { " max_iterations=3000" };
    let settings = fitting(world, settings) + limit;
    let what = format!("{planner} {settings} on {}", world.name());
    sliced(&what, || begin_with(world, planner, 5, &settings), of_run).fingerprint()
}

#[wasm_bindgen_test(unsupported = test)]
fn planners() {
    for world in worlds() {
        for &(planner, settings) in PLANNERS.iter().chain(REPORTED) {
            plan(&world, planner, settings);
        }
    }
    let car = car_and_wall(0.1);
    for &(planner, settings) in DRIVEN.iter().chain(REPORTED_DRIVEN) {
        let other = crate::common::finish(begin_with(&car, planner, 4, settings));
        assert_ne!(plan(&car, planner, settings), other.fingerprint(), "{planner} {settings}");
    }
    for world in [arm_and_wall(0.1), disc_and_wall(0.3, 0.5), body_and_wall(0.1)] {
        plan(&world, "rrt-connect", "reduce=true shortcut=10 partial_shortcut=10 blend=0.4");
    }
    for (planner, settings) in
        [("prm", "samples=200 k=10"), ("rrt", "extend=until-obstacle"), ("rrt-connect", "step=1")]
    {
        plan(&arm_and_wall(0.1), planner, &format!("{settings} edge_check=joint-lines"));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn planners_to_a_target_with_every_sampler() {
    let (world, _) = crate::targets::reaching_tip(&arm_and_wall(0.1));
    for &(planner, settings) in PLANNERS {
        for &sampler in SAMPLERS {
            plan(&world, planner, &format!("{settings} sampler={sampler} max_iterations=4000"));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn everything_else() {
    for (id, fleet, options) in [
        ("prioritized", "hall", json!({})),
        ("prioritized", "corridor", json!({})),
        ("composite", "swap", json!({})),
        ("pbs", "swap", json!({})),
        ("pbs", "ring", json!({ "exchange": true })),
    ] {
        let fleet = fleet::generate(fleet, &options).expect("a fleet");
        let options = FleetOptions { seed: 3, ..FleetOptions::default() }.with(Some(id), &[]).expect("options");
        sliced(id, || FleetPlanner::new(&fleet, &options).expect("a planner"), FleetPlanner::result);
    }
    for options in ["count=300", "count=200 model=spiral", "count=100 fastest=40 max_iterations=900"] {
        let options_of = TrajectoryOptions::read(&given(options)).expect("options");
        let begin = |seed| Trajectories::new(&options_of, seed).expect("options");
        let whole = sliced(options, || begin(5), |run| (run.fingerprint(), run.tally(), run.tries().to_vec()));
        let mut other = begin(6);
        other.step(u64::MAX);
        assert_ne!(other.fingerprint(), whole.fingerprint());
    }
    for (world, clearance) in [(no_way(), 0.0), (arm_and_wall(0.1), 0.1), (disc_and_wall(0.3, 0.5), 0.19)] {
        let options = certificate::Options { clearance, cells: 5000, ..certificate::Options::default() };
        let begin = || Subdivision::new(&world, &options).expect("a subdivision");
        sliced(world.name(), begin, |run| (run.certificate(), run.cells_since(0).collect::<Vec<_>>()));
    }
    let reaching = json!({ "format": "planarium-scenario-1", "name": "reaching",
        "world": { "obstacles": [ { "type": "disc", "center": [0.7, 0.9], "radius": 0.3 } ] },
        "robot": { "type": "arm", "base": [0, 0], "links": [1, 0.8, 0.5, 0.4] }, "queries": [] });
    let reaching = Scenario::read(&reaching).expect("a scenario");
    for method in ["newton", "damped-least-squares", "gradient-descent"] {
        let mut options = SolverOptions::to(Target { point: Point::new(0.9, 0.3), orientation: None });
        let parameters = given("solutions=5 max_iterations=700 free_only=true");
        options.method = MethodOptions::read(Some(method), &parameters).expect("options");
        options.seed = 3;
        sliced(method, || Solver::new(&reaching, &options).expect("a run"), |run| (run.fingerprint(), run.stats()));
    }
    let hall = crate::navigation::hall();
    let settings = TrainingOptions::read(&given(crate::navigation::SMALL)).expect("options");
    let outcome = |run: &Training| (run.fingerprint(), run.history().to_vec());
    sliced("a training", || Training::new(&hall, &settings, 5).expect("a training"), outcome);
    let policy = crate::navigation::shipped();
    let settings = crate::navigation::options("samples=40 k=6 rollouts=5");
    sliced("prm-rl", || crate::navigation::start(&hall, &policy, &settings).expect("a run"), of_run);
    let rooms = navigation::generate("rooms", &json!({ "columns": 2, "rows": 1, "seed": 1 })).expect("rooms");
    let settings = given("queries=2 trials=2 least_distance=4 samples=60 k=6 rollouts=5 least_share=0.8");
    let settings = ComparisonOptions::read(&settings).expect("options");
    let begin = || Comparison::new(&rooms, &policy, &settings, 1).expect("a comparison");
    sliced("a comparison", begin, |run| run.executions().to_vec());
}
