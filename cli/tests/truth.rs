//! The shared scenarios against what is known about them: which queries have a path, which start or end in collision.
//! They are not part of this repository; the environment variable `PLANARIUM_SCENARIOS` names their folder.

use crate::documents::{deep, judged, parse, shared};
use crate::program::{Finished, planarium_with};
use planarium::path::ResultDocument;
use serde_json::{Value, json};

/// Arm scenarios with queries that have a path.
const SOLVABLE: &[(&str, &[&str])] = &[
    ("arm2-class", &["report-1", "comparison-3"]),
    ("arm2-environment1", &["rrt-2", "rrt-3", "prm-2", "prm-3"]),
    ("arm2-environment2", &["rrt-5", "prm-4", "prm-5"]),
    ("forest-3r-1", &["report"]),
    ("forest-3r-2", &["report"]),
    ("forest-4r-1", &["report"]),
    ("forest-4r-2", &["report"]),
];

/// Queries that start or end in collision: the code, and what must be named.
const COLLIDING: &[(&str, &str, &str, &str)] = &[
    ("arm2-class", "comparison-1", "start-in-collision", "link 2 touches obstacle 1"),
    ("arm2-class", "comparison-2", "goal-in-collision", "link 1 touches obstacle 0"),
    ("arm2-class", "comparison-4", "goal-in-collision", "link 1 touches obstacle 0"),
    ("arm2-class", "comparison-5", "goal-in-collision", "link 1 touches obstacle 0"),
    ("arm2-environment2", "rrt-4", "start-in-collision", "link 2 touches obstacle 2"),
];

/// Bodies and cars, all of whose queries have a path.
const PLACED: &[(&str, &[&str])] = &[
    ("rigid-scene1", &["1-1", "1-2"]),
    ("rigid-scene2", &["2-1", "2-2"]),
    ("rigid-scene3", &["3-1", "3-2"]),
    ("car-scene1", &["table-1"]),
    ("car-scene2", &["table-2", "film-2"]),
    ("car-scene3", &["table-3"]),
];

/// What plans for a car, with what is set besides the defaults.
const DRIVERS: &[(&str, &[&str])] = &[
    ("rrt-control", &[]),
    ("sst", &[]),
    ("rrt", &[]),
    ("rrt-connect", &[]),
    ("prm", &[]),
    ("prm-star", &["samples=400"]),
    ("lazy-prm", &["samples=400"]),
    ("visibility-prm", &[]),
    ("rrt-star", SOON),
    ("fmt-star", &["samples=300"]),
    ("bit-star", SOON),
    ("aorrtc", SOON),
    ("rrt", &["steering=dubins"]),
    ("rrt-connect", &["steering=dubins"]),
    ("prm", &["steering=dubins", "samples=1000"]),
];

const PLANNERS: [(&str, &[&str]); 12] = [
    ("prm", &[]),
    ("prm-star", &[]),
    ("lazy-prm", &[]),
    ("lazy-prm-star", SOON),
    ("visibility-prm", &[]),
    ("rrt", &[]),
    ("rrt-connect", &[]),
    ("rrt-star", SOON),
    ("informed-rrt-star", SOON),
    ("fmt-star", &[]),
    ("bit-star", SOON),
    ("aorrtc", SOON),
];

/// Planners that go on after their first path end soon after it.
const SOON: &[&str] = &["improve_iterations=100"];

/// Each query is tried with so many seeds.
fn seeds() -> u64 {
    if deep() { 10 } else { 2 }
}

/// Plans with these settings.
fn plan(scenario: &str, query: &str, planner: &str, seed: u64, set: &[&str]) -> Finished {
    let set: String = set.iter().map(|pair| format!(" --set {pair}")).collect();
    planarium_with(&format!("plan - --query {query} --planner {planner} --seed {seed}{set}"), scenario)
}

/// How many of these seeds find a path; the judge accepts every one.
fn solved(text: &str, query: &str, (planner, set): (&str, &[&str]), seeds: u64) -> u64 {
    let scenario = parse(text);
    let is_solved = |&seed: &u64| {
        let finished = plan(text, query, planner, seed, set);
        let what = format!("{} {query} {planner} {set:?} seed {seed}", scenario.name());
        assert!(matches!(finished.code, 0 | 1), "{what}: {}", finished.stderr);
        let result = ResultDocument::parse(&finished.stdout).expect("a result");
        if finished.code == 0 {
            judged(&scenario, &result).unwrap_or_else(|why| panic!("{what}: {why}"));
        }
        finished.code == 0
    };
    (1..=seeds).filter(is_solved).count() as u64
}

#[test]
fn every_solvable_query_is_solved_and_the_judge_agrees() {
    let Some(shared) = shared() else { return };
    for (name, queries) in SOLVABLE {
        for (query, planner) in queries.iter().flat_map(|query| PLANNERS.map(|planner| (query, planner))) {
            let solved = solved(&shared[*name], query, planner, seeds());
            assert_eq!(solved, seeds(), "{name} {query} {planner:?}");
        }
    }
}

#[test]
fn bodies_and_cars_arrive_whoever_plans_and_the_judge_agrees() {
    let Some(shared) = shared() else { return };
    for (name, queries) in PLACED {
        let planners = if name.starts_with("car") { DRIVERS } else { &PLANNERS };
        for (query, &planner) in queries.iter().flat_map(|query| planners.iter().map(move |planner| (query, planner))) {
            // Forwards alone the car of this scene cannot leave its corner: in either direction, 3 cm of it leave the world.
            let is_trapped = *name == "car-scene3" && planner.1.contains(&"steering=dubins");
            let set = if is_trapped { [planner.1, &["max_work=300000"]].concat() } else { planner.1.to_vec() };
            let solved = solved(&shared[*name], query, (planner.0, &set), seeds());
            let is_right = if is_trapped { solved == 0 } else { solved + 1 >= seeds() };
            assert!(is_right, "{name} {query} {planner:?}: {solved} of {}", seeds());
        }
    }
}

#[test]
fn a_query_in_collision_is_refused_by_name() {
    let Some(shared) = shared() else { return };
    for (name, query, code, contact) in COLLIDING {
        for (planner, set) in PLANNERS {
            let finished = plan(&shared[*name], query, planner, 1, set);
            let error = &finished.json()["error"];
            assert_eq!((finished.code, error["code"].as_str()), (2, Some(*code)), "{name} {query}");
            assert!(error["message"].as_str().is_some_and(|text| text.contains(contact)), "{name} {query}: {error}");
        }
    }
}

#[test]
fn a_query_without_a_path_is_never_solved() {
    let Some(shared) = shared() else { return };
    // In forest-2r-2 the first link can go from start to goal only through the angle pi / 2, where its tip, at (0, 1),
    // touches the corner of obstacle 2 there; in the other direction obstacle 6 bars a quarter of its turn. Obstacles are
    // closed: no path. A grid over the angles steps over that one angle and connects both sides.
    for name in ["forest-2r-1", "forest-2r-2"] {
        for (planner, set) in PLANNERS {
            let finished = plan(&shared[name], "report", planner, 1, &[set, &["max_iterations=20000"]].concat());
            assert_eq!((finished.code, &finished.json()["status"]), (1, &json!("exhausted")), "{name} {planner}");
        }
    }
    // Certificates prove it: of the second at any clearance above 0, at 0 only that a path would keep next to none.
    let certify = |text: &str, more: &str| {
        let finished = planarium_with(&format!("certify - {more}"), text).json();
        (finished["verdict"].clone(), finished["clearance_at_most"].as_f64())
    };
    assert_eq!(certify(&shared["forest-2r-1"], ""), (json!("infeasible"), Some(0.0)));
    assert_eq!(certify(&shared["forest-2r-2"], "--clearance 0.0001"), (json!("infeasible"), Some(0.0001)));
    let (verdict, most) = certify(&shared["forest-2r-2"], "--cells 20000");
    assert!(verdict == "unknown" && most > Some(0.0) && most < Some(0.001), "{verdict} {most:?}");
    // With the first link a millimetre shorter there is a path.
    let mut shorter: Value = serde_json::from_str(&shared["forest-2r-2"]).expect("JSON");
    shorter["robot"]["links"][0] = 0.999.into();
    assert_eq!(certify(&shorter.to_string(), "").0, "connected");
    for planner in PLANNERS {
        assert_eq!(solved(&shorter.to_string(), "report", planner, 3), 3, "{planner:?}");
    }
}
