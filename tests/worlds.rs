//! Generated worlds that are drawn until a path is known, or until none exists; and how often the defaults of generators have one.

use crate::common::documents::refuses;
use crate::common::{begin_with, finish, seeds};
use planarium::certificate::{Options, Subdivision, Verdict};
use planarium::problem::Stepped;
use planarium::run::Status;
use planarium::scenario::generate::generate as by_seed;
use planarium::scenario::{Scenario, generate};
use planarium::worlds;
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

fn drawn(kind: &str, options: &Value) -> Result<Scenario, planarium::Error> {
    worlds::generate(kind, options)
}

fn verdict(scenario: &Scenario) -> Verdict {
    let mut subdivision = Subdivision::new(scenario, &Options::default()).expect("a subdivision");
    subdivision.step(u64::MAX);
    subdivision.verdict().expect("it has ended")
}

/// The seed at the end of the name of a scenario.
fn seed_of(scenario: &Scenario) -> u64 {
    scenario.name().rsplit('-').next().expect("a part").parse().expect("a seed")
}

#[wasm_bindgen_test(unsupported = test)]
fn a_world_is_drawn_until_a_path_is_known_or_none_exists() {
    let (mut again, mut names) = (0, std::collections::BTreeSet::new());
    for seed in 0..6 {
        for (ensure, expected) in [("path", Verdict::Connected), ("no-path", Verdict::Infeasible)] {
            let given = json!({ "robot": "arm", "count": 4, "largest": 0.2, "seed": seed, "ensure": ensure });
            let scenario = drawn("clutter", &given).unwrap();
            assert_eq!(verdict(&scenario), expected, "{}", scenario.title());
            assert_eq!(drawn("clutter", &given).as_ref(), Ok(&scenario), "the same options are the same world");
            // Its name has the seed that gives it without being drawn again.
            let plain = json!({ "robot": "arm", "count": 4, "largest": 0.2, "seed": seed_of(&scenario) });
            assert_eq!(by_seed("clutter", &plain).as_ref(), Ok(&scenario));
            again += usize::from(seed_of(&scenario) != seed);
            names.insert(scenario.name().to_owned());
        }
    }
    assert!(again > 2 && names.len() == 12, "{again} {names:?}");
    // The first draw is the world of the seed itself.
    assert_eq!(drawn("discs", &json!({ "seed": 3, "ensure": "path" })), by_seed("discs", &json!({ "seed": 3 })));
    assert_eq!(drawn("discs", &json!({ "seed": 3, "ensure": "any" })), by_seed("discs", &json!({ "seed": 3 })));
}

/// What has no certificates is ensured by a planner.
#[wasm_bindgen_test(unsupported = test)]
fn a_path_of_any_robot_is_ensured_by_a_planner() {
    for (kind, options) in [
        ("forest", json!({ "links": 1, "seed": 5, "ensure": "path" })),
        ("discs", json!({ "robot": "arm", "links": 3, "count": 24, "seed": 2, "ensure": "path" })),
        ("clutter", json!({ "robot": "rigid_body", "seed": 1, "ensure": "path" })),
        ("clutter", json!({ "robot": "car", "seed": 1, "ensure": "path" })),
    ] {
        let scenario = drawn(kind, &options).unwrap();
        let run = finish(begin_with(&scenario, "rrt-connect", 0, "max_iterations=5000"));
        assert_eq!(run.status(), Status::Solved, "{}", scenario.title());
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn only_generators_that_draw_again_ensure_a_path() {
    refuses(by_seed("forest", &json!({ "ensure": "path" })), "unknown-field", "/ensure");
    for info in worlds::generators() {
        let names: Vec<&str> = info.options.iter().map(|option| option.name).collect();
        assert!(names.ends_with(&["ensure", "draws"]), "{names:?}");
    }
}

/// A newcomer who generates a world should see a path: of the default worlds of every robot nearly all have one.
#[wasm_bindgen_test(unsupported = test)]
fn nearly_all_worlds_have_a_path_by_default() {
    for (kind, robot, links) in [
        ("clutter", "disc", None),
        ("clutter", "arm", Some(2)),
        ("clutter", "arm", Some(4)),
        ("discs", "disc", None),
        ("discs", "arm", Some(2)),
        ("discs", "arm", Some(3)),
        ("gap", "arm", Some(2)),
        ("gap", "arm", Some(4)),
    ] {
        let (all, mut found) = (seeds(80).min(20), 0);
        for seed in 0..all {
            let mut options = json!({ "robot": robot, "seed": seed });
            if let Some(links) = links {
                options["links"] = links.into();
            }
            let scenario = generate::generate(kind, &options).expect("a scenario");
            let run = finish(begin_with(&scenario, "rrt-connect", 0, "max_iterations=5000"));
            found += u64::from(run.status() == Status::Solved);
        }
        assert!(10 * found >= 9 * all, "{kind} {robot} {links:?}: {found} of {all}");
    }
}
