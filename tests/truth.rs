//! The shared scenarios against what is known about them: which queries have a path, which start or end in collision.
//! They are not part of this repository; the environment variable `PLANARIUM_SCENARIOS` names their folder.

use crate::common::deep;
use planarium::path::{ResultDocument, Verdict, verify};
use planarium::scenario::Scenario;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

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
    ("arm2-class", "comparison-1", "start-in-collision", "part 1 touches obstacle 1"),
    ("arm2-class", "comparison-2", "goal-in-collision", "part 0 touches obstacle 0"),
    ("arm2-class", "comparison-4", "goal-in-collision", "part 0 touches obstacle 0"),
    ("arm2-class", "comparison-5", "goal-in-collision", "part 0 touches obstacle 0"),
    ("arm2-environment2", "rrt-4", "start-in-collision", "part 1 touches obstacle 2"),
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
    ("visibility-prm", &[]),
    ("rrt", &["steering=dubins"]),
    ("rrt-connect", &["steering=dubins"]),
    ("prm", &["steering=dubins", "samples=1000"]),
];

const PLANNERS: [&str; 5] = ["prm", "prm-star", "visibility-prm", "rrt", "rrt-connect"];

/// Each query is tried with so many seeds.
fn seeds() -> u64 {
    if deep() { 10 } else { 2 }
}

/// The folder of the scenarios; prints a line, past the capture of the test harness, if it is not set.
fn folder(test: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("PLANARIUM_SCENARIOS").filter(|folder| !folder.is_empty()).map(PathBuf::from);
    if folder.is_none() {
        let line = format!("\nSKIPPED {test}: PLANARIUM_SCENARIOS is not set\n");
        let _ = std::io::stderr().write_all(line.as_bytes());
    }
    folder
}

/// Plans with these settings.
fn plan(scenario: &Path, query: &str, planner: &str, seed: u64, set: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_planarium"));
    command.arg("plan").arg(scenario).args(["--query", query, "--planner", planner, "--seed", &seed.to_string()]);
    command.args(set.iter().flat_map(|pair| ["--set", pair]));
    command.output().expect("the program runs")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// How many of these seeds find a path; the judge accepts every one.
fn solved(file: &Path, query: &str, (planner, set): (&str, &[&str]), seeds: u64) -> u64 {
    let scenario = Scenario::parse(&read(file)).expect("the scenario is in order");
    let is_solved = |&seed: &u64| {
        let output = plan(file, query, planner, seed, set);
        let what = format!("{} {query} {planner} {set:?} seed {seed}", file.display());
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(0 | 1)), "{what}: {errors}");
        let result = ResultDocument::parse(&String::from_utf8_lossy(&output.stdout)).expect("a result");
        if output.status.success() {
            let verdict = verify(&scenario, &result).expect("a verdict");
            assert!(matches!(verdict, Verdict::Valid { .. }), "{what}: {verdict:?}");
        }
        output.status.success()
    };
    (1..=seeds).filter(is_solved).count() as u64
}

#[test]
fn every_solvable_query_is_solved_and_the_judge_agrees() {
    let Some(folder) = folder("every_solvable_query_is_solved_and_the_judge_agrees") else { return };
    for (name, queries) in SOLVABLE {
        for (query, planner) in queries.iter().flat_map(|query| PLANNERS.map(|planner| (query, planner))) {
            let solved = solved(&folder.join(format!("{name}.json")), query, (planner, &[]), seeds());
            assert_eq!(solved, seeds(), "{name} {query} {planner}");
        }
    }
}

#[test]
fn bodies_and_cars_arrive_whoever_plans_and_the_judge_agrees() {
    let Some(folder) = folder("bodies_and_cars_arrive_whoever_plans_and_the_judge_agrees") else { return };
    for (name, queries) in PLACED {
        let of_bodies: Vec<(&str, &[&str])> = PLANNERS.iter().map(|&planner| (planner, &[][..])).collect();
        let planners = if name.starts_with("car") { DRIVERS } else { &of_bodies };
        for (query, &planner) in queries.iter().flat_map(|query| planners.iter().map(move |planner| (query, planner))) {
            let solved = solved(&folder.join(format!("{name}.json")), query, planner, seeds());
            // Forwards alone the car of this scene cannot leave its corner: whichever way it turns, 3 cm of it leave the world.
            let is_trapped = *name == "car-scene3" && planner.1.contains(&"steering=dubins");
            let is_right = if is_trapped { solved == 0 } else { solved + 1 >= seeds() };
            assert!(is_right, "{name} {query} {planner:?}: {solved} of {}", seeds());
        }
    }
}

#[test]
fn a_query_in_collision_is_refused_by_name() {
    let Some(folder) = folder("a_query_in_collision_is_refused_by_name") else { return };
    for (name, query, code, contact) in COLLIDING {
        for planner in PLANNERS {
            let output = plan(&folder.join(format!("{name}.json")), query, planner, 1, &[]);
            let document: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
            assert_eq!(output.status.code(), Some(2), "{name} {query}: {document}");
            assert_eq!(document["error"]["code"], *code, "{name} {query}");
            let message = document["error"]["message"].as_str().expect("a message");
            assert!(message.contains(contact), "{name} {query}: {message}");
        }
    }
}

#[test]
fn a_query_without_a_path_is_never_solved() {
    let Some(folder) = folder("a_query_without_a_path_is_never_solved") else { return };
    // In forest-2r-2 the first link can go from start to goal only through the angle pi / 2, where its tip, at (0, 1),
    // touches the corner of obstacle 2 there; the other way round obstacle 6 bars a quarter of its turn. Obstacles are
    // closed: no path. A grid over the angles steps over that one angle and joins both sides.
    for name in ["forest-2r-1", "forest-2r-2"] {
        for planner in PLANNERS {
            let output = plan(&folder.join(format!("{name}.json")), "report", planner, 1, &[]);
            let document: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
            assert_eq!(
                (output.status.code(), document["status"].as_str()),
                (Some(1), Some("exhausted")),
                "{name} {planner}"
            );
        }
    }
    // With the first link a millimetre shorter there is a path.
    let text = read(&folder.join("forest-2r-2.json"));
    let mut shorter: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    shorter["robot"]["links"][0] = 0.999.into();
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("forest-2r-2-shorter.json");
    std::fs::write(&file, shorter.to_string()).expect("the folder for test files can be written");
    for planner in PLANNERS {
        assert_eq!(solved(&file, "report", (planner, &[]), 3), 3, "{planner}");
    }
}
