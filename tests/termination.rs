//! Where runs of planners that go on to shorter paths end: at the first iteration at which the conditions hold, computed here from the
//! history of a longer run.

use crate::common::documents::named;
use crate::common::requests;
use crate::common::{
    assert_valid, begin_with, car_and_wall, car_shut_in, disc_and_wall, finish, no_way, options, parse,
};
use planarium::path::ResultDocument;
use planarium::planner::Termination;
use planarium::run::{HISTORY_WIDTH, PlannerOptions, Reason, Status, planners};
use planarium::scenario::Scenario;
use serde_json::json;
use wasm_bindgen_test::wasm_bindgen_test;

/// The length of the path after each iteration, from 1, and the clearance evaluations by then.
struct History {
    lengths: Vec<f64>,
    evaluations: Vec<f64>,
}

impl History {
    fn of(world: &Scenario, planner: &str, settings: &str) -> Self {
        let mut run = begin_with(world, planner, 3, settings);
        run.record().expect("nothing is done yet");
        let history = finish(run).history_since(0);
        let column = |i: usize| history.chunks(HISTORY_WIDTH).map(|row| row[i]).collect();
        Self { lengths: column(HISTORY_WIDTH - 1), evaluations: column(HISTORY_WIDTH - 2) }
    }

    /// The length after an iteration.
    fn length(&self, iteration: usize) -> f64 {
        self.lengths[iteration - 1]
    }

    /// Whether a condition holds after an iteration, by its definition.
    fn holds(&self, condition: &str, iteration: usize) -> bool {
        let (name, value) = condition.split_once('=').expect("name=value");
        let value: f64 = value.parse().expect("a number");
        let now = self.length(iteration);
        let first = 1 + self.lengths.iter().position(|length| length.is_finite()).expect("a path");
        match name {
            "stop_evaluations" => self.evaluations[iteration - 1] >= value,
            _ if iteration < first => false,
            "improve_iterations" => iteration >= first + value as usize,
            "stop_cost" => now <= value,
            "stop_stale" => iteration >= first + value as usize && self.length(iteration - value as usize) == now,
            "stop_converged" => {
                let half = (iteration - first) / 2;
                half >= 500 && self.length(iteration - half) * (1.0 - value) <= now
            }
            other => panic!("{other}"),
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_run_ends_as_soon_as_one_of_the_conditions_holds_or_all() {
    let sst = "selection_radius=0.3 pruning_radius=0.15";
    for (world, planner, settings) in [(disc_and_wall(0.3, 0.5), "rrt-star", ""), (car_and_wall(0.1), "sst", sst)] {
        let long = History::of(&world, planner, &format!("{settings} improve_iterations=2000"));
        let last = long.lengths.len();
        let first = long.lengths.iter().copied().find(|length| length.is_finite()).expect("a path");
        let conditions = [
            format!("stop_evaluations={}", (0.6 * long.evaluations[last - 1]).floor()),
            format!("stop_cost={}", 0.3 * first + 0.7 * long.length(last)),
            "stop_stale=300".to_owned(),
            "stop_converged=0.02".to_owned(),
        ];
        let mut ends = Vec::new();
        // The number of further iterations is always given.
        for (rule, improve) in
            [("any", "improve_iterations=1500"), ("all", "improve_iterations=0"), ("all", "improve_iterations=700")]
        {
            for others in 0..1 << conditions.len() {
                let given = (0..conditions.len()).filter(|i| others >> i & 1 == 1).map(|i| conditions[i].as_str());
                let given: Vec<&str> = given.chain([improve]).collect();
                let holds = |i: usize| {
                    let mut all = given.iter().map(|one| long.holds(one, i));
                    if rule == "any" { all.any(|holds| holds) } else { all.all(|holds| holds) }
                };
                let what = format!("{settings} {} stop_when={rule}", given.join(" "));
                let Some(expected) = (1..=last).find(|&i| holds(i)) else { continue };
                let run = finish(begin_with(&world, planner, 3, &what));
                assert_eq!(run.iterations(), expected as u64, "{planner} {what}");
                assert_eq!(run.status(), Status::Solved, "{planner} {what}");
                assert_eq!(run.length(), long.length(expected), "{planner} {what}");
                ends.push(expected);
            }
        }
        ends.sort_unstable();
        ends.dedup();
        assert!(ends.len() > 5, "{planner}: {ends:?} differ");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn evaluations_are_a_budget_before_the_first_path_too() {
    let world = disc_and_wall(0.3, 0.5);
    let run = finish(begin_with(&world, "rrt-star", 3, "stop_evaluations=50"));
    assert_eq!(run.status(), Status::Exhausted);
    let evaluations = run.stats().clearance_evaluations;
    assert!((50..500).contains(&evaluations), "{evaluations}");
    assert!(run.result().approximate.is_some());
}

/// A world, a planner and its settings, and how its run ends.
type Ending = (Scenario, &'static str, &'static str, Reason, &'static str);

#[wasm_bindgen_test(unsupported = test)]
fn a_run_without_a_path_says_why() {
    let mut document = json!(car_and_wall(0.1));
    document["world"] = json!({ "bounds": { "min": [0, 0], "max": [0.9, 0.6] }, "obstacles": [] });
    document["queries"][0]["goal"] = json!([0.7, 0.3, 0]);
    let shut_in = parse(&document.to_string());
    let endings: [Ending; 12] = [
        (
            no_way(),
            "rrt",
            "max_iterations=1300",
            Reason::IterationLimit,
            "gave up after 1,300 iterations without a path (max_iterations)",
        ),
        (
            no_way(),
            "rrt-connect",
            "max_work=2000",
            Reason::WorkLimit,
            "gave up after 2,000 units of work without a path (max_work)",
        ),
        (
            no_way(),
            "prm",
            "max_work=20",
            Reason::WorkLimit,
            "gave up after 20 units of work without a path (max_work), before the roadmap was searched",
        ),
        (
            disc_and_wall(0.3, 0.5),
            "rrt-star",
            "stop_evaluations=50",
            Reason::EvaluationLimit,
            "gave up after 50 clearance evaluations without a path (stop_evaluations)",
        ),
        (
            no_way(),
            "rrt",
            "vertices=40",
            Reason::VertexLimit,
            "gave up with a tree of 40 vertices without a path (vertices)",
        ),
        (
            car_shut_in(0.1),
            "rrt-control",
            "vertices=40",
            Reason::VertexLimit,
            "gave up with a tree of 40 vertices without a path (vertices)",
        ),
        (
            shut_in,
            "rrt-control",
            "controls=reeds-shepp once=true blocked=refused duration_steps=250",
            Reason::NothingToExtend,
            "gave up: no vertex of the tree may be extended again",
        ),
        (
            no_way(),
            "prm",
            "samples=40",
            Reason::NotConnected,
            "start and goal are not connected in this roadmap of 42 vertices",
        ),
        (
            no_way(),
            "prm",
            "samples=40 insertion=one-by-one",
            Reason::NotConnected,
            "start and goal are not connected in this roadmap of 42 vertices",
        ),
        (
            no_way(),
            "prm-star",
            "samples=40",
            Reason::NotConnected,
            "start and goal are not connected in this roadmap of 42 vertices",
        ),
        (
            no_way(),
            "lazy-prm",
            "samples=40",
            Reason::NotConnected,
            "start and goal are not connected in this roadmap of 42 vertices",
        ),
        (
            no_way(),
            "fmt-star",
            "samples=40",
            Reason::NotConnected,
            "start and goal are not connected in this roadmap of 42 vertices",
        ),
    ];
    for (world, planner, settings, reason, explanation) in endings {
        let run = finish(begin_with(&world, planner, 1, settings));
        let result = run.result();
        assert_eq!((result.status, result.reason), (Status::Exhausted, Some(reason)), "{planner} {settings}");
        assert_eq!(result.explanation.as_deref(), Some(explanation), "{planner} {settings}");
        assert_eq!((run.reason(), run.explanation()), (result.reason, result.explanation.clone()));
        assert_eq!(ResultDocument::parse(&result.to_json()).expect("a result"), result, "{planner}");
    }
    let solved = finish(begin_with(&disc_and_wall(0.3, 0.5), "rrt-connect", 1, ""));
    assert_eq!((solved.status(), solved.reason()), (Status::Solved, None));
    assert!(!solved.result().to_json().contains("reason"));
}

/// Along curves a query measures the distances of many vertices, so its work grows with the tree.
#[wasm_bindgen_test(unsupported = test)]
fn the_distances_along_curves_that_a_query_measures_are_work() {
    let work = |world: &Scenario, iterations: u32| {
        finish(begin_with(world, "rrt", 1, &format!("max_iterations={iterations}"))).stats().work
    };
    for (world, is_curved) in [(car_shut_in(0.1), true), (no_way(), false)] {
        let [few, many] = [4000, 16_000].map(|iterations| work(&world, iterations));
        assert_eq!(many > 6 * few, is_curved, "{few}, then {many}");
    }
}

/// The work is a count: no slicing changes it, and it only grows.
#[wasm_bindgen_test(unsupported = test)]
fn every_planner_gives_up_by_work_in_small_steps() {
    for (planner, world) in every_planner(&no_way(), &car_shut_in(0.1)) {
        let most = 30_000;
        let whole = finish(begin_with(world, planner, 1, &format!("max_work={most}")));
        assert_eq!(whole.reason(), Some(Reason::WorkLimit), "{planner}");
        let mut sliced = begin_with(world, planner, 1, &format!("max_work={most}"));
        let (mut work, mut longest) = (0, 0);
        while sliced.step(1) == Status::Running {
            let now = sliced.stats().work;
            assert!((work..most).contains(&now), "{planner}: {now} after {work}");
            (work, longest) = (now, longest.max(now - work));
        }
        longest = longest.max(sliced.stats().work - work);
        // A thousandth of the default limit.
        assert!(longest <= 5000, "{planner}: a step of {longest}");
        assert_eq!((sliced.fingerprint(), sliced.stats()), (whole.fingerprint(), whole.stats()), "{planner}");
    }
}

/// Every planner with a world that it serves.
pub fn every_planner<'a>(arm: &'a Scenario, car: &'a Scenario) -> Vec<(&'static str, &'a Scenario)> {
    let world = |planner: &PlannerOptions| if planner.robots().contains(&"arm") { arm } else { car };
    planners().iter().map(|planner| (planner.info().id, world(planner))).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn limits_hold_until_there_is_a_path() {
    let world = disc_and_wall(0.3, 0.5);
    for (planner, world) in every_planner(&world, &car_and_wall(0.1)) {
        if planners().iter().all(|one| one.info().id != planner || one.group::<Termination>().is_none()) {
            continue;
        }
        let path = finish(begin_with(world, planner, 3, "improve_iterations=0"));
        assert_eq!(path.status(), Status::Solved, "{planner}");
        let first = path.iterations();
        for limit in ["max_iterations", "max_work"] {
            let most = if limit == "max_work" { path.stats().work + 1 } else { first + 1 };
            let run = finish(begin_with(world, planner, 3, &format!("improve_iterations=700 {limit}={most}")));
            assert_eq!(run.iterations(), first + 700, "{planner} {limit}");
        }
    }
}

/// Conditions that never hold end a run once a limit is spent without a shorter path; a tree, once it is spent without a new vertex.
#[wasm_bindgen_test(unsupported = test)]
fn a_run_with_a_path_ends_where_nothing_is_gained() {
    let world = disc_and_wall(0.3, 0.5);
    let settings = "improve_iterations=10 stop_cost=0 stop_when=all max_iterations=2000";
    let run = finish(begin_with(&world, "rrt-star", 3, settings));
    assert_eq!(run.status(), Status::Solved);
    assert!(run.iterations() > 2000, "{}", run.iterations());
    // It did not reach what it was asked for, and says why.
    let result = run.result();
    assert_eq!((run.reason(), result.reason), (Some(Reason::IterationLimit), Some(Reason::IterationLimit)));
    assert_eq!(result.explanation.as_deref(), Some("stopped early: no gain in 2,000 iterations (max_iterations)"));
    let robot = r#"{"type": "disc", "radius": 0.1}"#;
    let open = named("open", "[0, 0], [10, 10]", "", robot, r#""start": [1, 5], "goal": [9, 5]"#);
    // The sampler finds no bridge in the open, and the goal is reached at once.
    let settings = "sampler=bridge goal_bias=0.5 vertices=50 max_iterations=300 extend=until-obstacle";
    let run = finish(begin_with(&open, "rrt", 3, settings));
    assert_eq!((run.status(), run.vertex_count() < 50), (Status::Solved, true));
    assert_eq!(run.reason(), Some(Reason::IterationLimit));
}

#[wasm_bindgen_test(unsupported = test)]
fn the_default_limit_is_counted_from_the_last_sample() {
    let options = options("prm", 1, "samples=200000");
    assert!(requests::start(disc_and_wall(0.3, 0.5), &options).is_ok());
}

/// Where no number of samples is given, the roadmap grows as long as work is left.
#[wasm_bindgen_test(unsupported = test)]
fn samples_grow_in_batches_until_there_is_a_path() {
    for (planner, settings, first) in [
        ("prm", "", 2002),
        ("prm", "insertion=one-by-one", 2002),
        ("prm", "radius=0.1", 2002),
        ("prm-star", "", 2002),
        ("lazy-prm", "", 2002),
        ("fmt-star", "", 1002),
    ] {
        let settings = format!("{settings} max_work=2000000");
        let mut run = begin_with(&no_way(), planner, 1, &settings);
        while run.vertex_count() <= first + 100 && run.step(100) == Status::Running {}
        assert!(run.vertex_count() > first + 100, "{planner} {settings}: {}", run.vertex_count());
        assert_eq!(run.status(), Status::Running, "{planner} {settings}");
    }
    // A gap that two thousand samples miss.
    let narrow = disc_and_wall(0.49, 0.5);
    let few = finish(begin_with(&narrow, "prm", 2, "samples=2000"));
    assert_eq!(few.reason(), Some(Reason::NotConnected));
    let grown = finish(begin_with(&narrow, "prm", 2, ""));
    assert_eq!(grown.status(), Status::Solved);
    assert!(grown.vertex_count() > 2002);
    assert_valid(&narrow, &*grown);
}
