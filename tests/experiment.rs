//! Experiments: trials by number, rows that are the same however a trial is stepped, and the summary.

use crate::common::documents::{CAR, DISC, refuses, with};
use crate::common::{begin_with, finish, golden};
use planarium::experiment::{Baseline, Experiment, Measure, Summary, Trials, cell_text};
use planarium::scenario::{Scenario, generate::generate};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::sync::Arc;
use wasm_bindgen_test::wasm_bindgen_test;

/// Every field of a document: 2 queries of a scenario, 2 x 3 forests; 2 + 1 settings; 2 seeds.
fn full() -> Value {
    let queries = r#"{"name": "across", "start": [0.2, 0.2], "goal": [1.8, 1.8]}, {"name": "down", "start": [0.2, 1.8], "goal": [1.8, 0.2]}"#;
    let disc: Value =
        serde_json::from_str(&with(DISC, r#"{"name": "across", "start": [0.2, 0.2], "goal": [1.8, 1.8]}"#, queries))
            .unwrap();
    json!({
        "format": "planarium-experiment-1", "title": "All fields",
        "worlds": [
            { "scenario": disc, "name": "round", "queries": ["across", "down"] },
            { "generate": "discs", "set": { "count": 5 }, "vary": { "radius": [0.05, 0.1] }, "seeds": { "from": 4, "count": 3 } },
        ],
        "planners": [
            { "algorithm": "prm", "name": "roadmap", "set": { "samples": 60 }, "vary": { "k": { "from": 2, "to": 6, "step": 4 } } },
            { "algorithm": "rrt" },
        ],
        "seeds": [7, 3],
        "budget": { "iterations": 400 },
        "verify": true,
        "measures": ["visited", "length", "build_seconds"],
    })
}

/// The document with the value at a pointer replaced; an object's field is removed by `null`.
fn changed(pointer: &str, value: Value) -> Value {
    let mut document = full();
    let (parent, name) = pointer.rsplit_once('/').expect("a pointer");
    match document.pointer_mut(parent).expect("it exists") {
        Value::Object(fields) if value.is_null() => drop(fields.remove(name).expect("it exists")),
        Value::Object(fields) => drop(fields.insert(name.to_owned(), value)),
        Value::Array(items) => items[name.parse::<usize>().expect("an index")] = value,
        _ => panic!("{parent} has no fields"),
    }
    document
}

fn experiment(document: &Value) -> Arc<Experiment> {
    Arc::new(Experiment::read(document).unwrap_or_else(|error| panic!("{error}")))
}

/// The row of a trial that is stepped in slices, by column.
fn row(experiment: &Experiment, trials: &mut Trials, number: u64, slice: u64) -> serde_json::Map<String, Value> {
    let mut run = trials.start(number).unwrap_or_else(|error| panic!("{error}"));
    while run.step(slice) {}
    experiment.columns().into_iter().zip(run.row().unwrap()).collect()
}

fn rows(document: &Value, slice: u64) -> Vec<serde_json::Map<String, Value>> {
    let experiment = experiment(document);
    let mut trials = Trials::new(&experiment);
    (0..experiment.trial_count()).map(|number| row(&experiment, &mut trials, number, slice)).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn trials_are_all_combinations_worlds_slowest_and_seeds_fastest() {
    let rows = rows(&full(), u64::MAX);
    let mut expected = Vec::new();
    let mut problems = vec![["round", "", "", "across"], ["round", "", "", "down"]];
    for radius in ["0.05", "0.1"] {
        problems.extend(["4", "5", "6"].map(|seed| ["discs", radius, seed, "across"]));
    }
    for [world, radius, world_seed, query] in problems {
        for [planner, k] in [["roadmap", "2"], ["roadmap", "6"], ["rrt", ""]] {
            for seed in ["7", "3"] {
                expected.push([world, radius, world_seed, query, planner, k, seed].map(str::to_owned));
            }
        }
    }
    let columns = ["world", "world.radius", "world_seed", "query", "planner", "planner.k", "seed"];
    let found: Vec<_> = rows.iter().map(|row| columns.map(|column| cell_text(&row[column]))).collect();
    assert_eq!(found, expected);
    for (i, row) in rows.iter().enumerate() {
        assert_eq!(row["trial"], i);
        assert_eq!(row["experiment"], rows[0]["experiment"]);
    }
    let fingerprints: BTreeSet<_> = rows.iter().map(|row| row["fingerprint"].as_str()).collect();
    assert!(fingerprints.len() > rows.len() * 9 / 10, "trials differ: {}", fingerprints.len());
}

#[wasm_bindgen_test(unsupported = test)]
fn a_row_is_the_result_of_the_run_that_it_names() {
    let experiment = experiment(&full());
    let mut trials = Trials::new(&experiment);
    // Of the first and the last world, in an order that the cache of worlds does not expect.
    for (number, planner, settings) in [
        (47, "rrt", "max_iterations=400"),
        (0, "prm", "samples=60 k=2 max_iterations=400"),
        (44, "prm", "samples=60 k=6 max_iterations=400"),
    ] {
        let row = row(&experiment, &mut trials, number, u64::MAX);
        let world = match row["world_seed"].as_u64() {
            Some(seed) => {
                generate("discs", &json!({ "count": 5, "radius": row["world.radius"], "seed": seed })).unwrap()
            }
            None => Scenario::read(&full()["worlds"][0]["scenario"]).unwrap(),
        };
        let run = finish(begin_with(&world, planner, row["seed"].as_u64().unwrap(), settings));
        let (result, stats) = (run.result(), run.stats());
        assert_eq!((&row["query"], &row["status"]), (&json!(result.query), &json!("solved")));
        assert_eq!(row["fingerprint"], format!("{:016x}", result.fingerprint));
        assert_eq!((&row["length"], &row["waypoints"]), (&json!(result.length), &json!(result.path.len())));
        let stats = serde_json::to_value(stats).unwrap();
        for (name, count) in stats.as_object().unwrap().iter().filter(|(name, _)| !name.ends_with("_seconds")) {
            assert_eq!(&row[name], count, "{name}");
        }
        assert_eq!(row["valid"], true);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn rows_do_not_depend_on_how_a_trial_is_stepped_or_on_the_order_of_trials() {
    for budget in [json!({ "iterations": 300 }), json!({ "clearance_evaluations": 900 }), Value::Null] {
        let document = changed("/budget", budget.clone());
        let whole = rows(&document, u64::MAX);
        assert_eq!(rows(&document, 1), whole, "{budget}");
        assert_eq!(rows(&document, 7), whole, "{budget}");
        let experiment = experiment(&document);
        let mut trials = Trials::new(&experiment);
        for number in (0..experiment.trial_count()).rev().step_by(5) {
            assert_eq!(row(&experiment, &mut trials, number, 64), whole[number as usize]);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_budget_ends_a_trial_with_the_iteration_that_spends_it() {
    let mut all: Vec<_> = rows(&changed("/budget", Value::Null), u64::MAX)
        .iter()
        .map(|row| row["clearance_evaluations"].as_u64().unwrap())
        .collect();
    all.sort_unstable();
    let most = all[all.len() / 2];
    let limited = rows(&changed("/budget", json!({ "clearance_evaluations": most })), u64::MAX);
    let mut spent = 0;
    for row in &limited {
        let [evaluations, iterations] = ["clearance_evaluations", "iterations"].map(|name| row[name].as_u64().unwrap());
        if row["status"] == "running" {
            spent += 1;
            assert!(evaluations >= most, "{row:?}");
            assert_eq!((&row["length"], &row["waypoints"], &row["valid"]), (&Value::Null, &Value::Null, &Value::Null));
            if row["planner"] == "roadmap" {
                continue;
            }
            // One iteration less is within the budget. It may be too few for the samples of a roadmap, whose number is not given here.
            let mut before = changed("/budget", json!({ "iterations": iterations - 1 }));
            before["planners"][0]["set"] = json!({});
            let experiment = experiment(&before);
            let shorter = self::row(&experiment, &mut Trials::new(&experiment), row["trial"].as_u64().unwrap(), 1);
            assert!(shorter["clearance_evaluations"].as_u64().unwrap() < most);
        }
    }
    assert!(spent > 3 && spent < limited.len(), "{spent}");
    let exhausted = rows(&changed("/budget", json!({ "iterations": 123 })), u64::MAX);
    let is_cut = |row: &&serde_json::Map<String, Value>| row["reason"] == "iteration-limit" && row["iterations"] == 123;
    assert!(exhausted.iter().any(|row| is_cut(&row)));
    assert!(exhausted.iter().all(|row| (row["status"] == "exhausted") != row["reason"].is_null()));
}

/// Experiments whose rows and summaries are committed: arms, a body and a car, proven and sampled.
#[wasm_bindgen_test(unsupported = test)]
fn rows_and_summaries_are_the_committed_ones_on_every_platform() {
    golden::check("golden-experiment.json", include_str!("golden-experiment.json"), 2, |case| {
        let (experiment, rows) = (experiment(&case["experiment"]), rows(&case["experiment"], 16));
        let columns = experiment.columns();
        let texts =
            rows.iter().map(|row| columns.iter().map(|name| cell_text(&row[name])).collect::<Vec<_>>().join(","));
        let mut summary = Summary::new(&experiment);
        for (number, row) in (0..).zip(&rows) {
            let cell = |column: &str| row.get(column).map_or(String::new(), cell_text);
            summary.add_row(number, cell).expect("a new trial");
            summary.add_row(number, cell).expect("the same row counts once");
        }
        json!({ "rows": texts.collect::<Vec<_>>(), "summary": planarium::json::to_string(&summary.document()) })
    });
}

#[wasm_bindgen_test(unsupported = test)]
fn a_path_that_is_not_free_is_solved_but_not_valid() {
    let sampled = json!({ "samples": 100, "k": 5, "edge_check": "sampled", "edge_samples": 6 });
    let mut document = changed("/planners", json!([{ "algorithm": "prm", "set": sampled }]));
    document["worlds"] = json!([{ "generate": "forest", "seeds": { "from": 0, "count": 10 } }]);
    let rows = rows(&document, u64::MAX);
    let count = |valid: bool| rows.iter().filter(|row| row["status"] == "solved" && row["valid"] == valid).count();
    assert!(count(false) > 0 && count(true) > 0, "{} and {}", count(false), count(true));
}

#[wasm_bindgen_test(unsupported = test)]
fn a_car_by_controls_is_served_where_it_has_a_goal_region() {
    let car: Value = serde_json::from_str(CAR).unwrap();
    let mut document = changed("/planners", json!([{ "algorithm": "rrt-control" }]));
    document["worlds"] = json!([{ "scenario": car }]);
    assert_eq!(experiment(&document).trial_count(), 2);
}

/// Worlds that are drawn again: a world of every seed has a path, the same in every trial and on every reading.
#[wasm_bindgen_test(unsupported = test)]
fn worlds_are_drawn_until_they_have_a_path() {
    let generated = "/worlds/1";
    let world = |set: Value| json!({ "generate": "discs", "set": set, "vary": { "ensure": ["any", "path"] }, "seeds": [0, 1, 2] });
    let mut document = changed(generated, world(json!({ "robot": "arm", "count": 10 })));
    document["worlds"].as_array_mut().expect("a list").remove(0);
    document["planners"] = json!([{ "algorithm": "rrt-connect" }]);
    document["budget"] = json!({ "iterations": 5000 });
    let solved = |ensure: &str| {
        let rows = rows(&document, u64::MAX);
        rows.iter().filter(|row| row["world.ensure"] == ensure && row["status"] == "solved").count()
    };
    let (any, path) = (solved("any"), solved("path"));
    assert!(any < 6 && path == 6, "{any} {path}");
    assert_eq!(rows(&document, 7), rows(&document, u64::MAX));
}

#[wasm_bindgen_test(unsupported = test)]
fn equal_steps_are_the_decimals_that_are_written() {
    let span = json!([{ "algorithm": "rrt", "vary": { "step": { "from": 0.1, "to": 0.7, "step": 0.1 } } }]);
    let rows = rows(&changed("/planners", span), u64::MAX);
    let steps: Vec<_> = rows.iter().step_by(2).take(7).map(|row| cell_text(&row["planner.step"])).collect();
    assert_eq!(steps, ["0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7"]);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_fingerprint_is_that_of_what_decides_rows() {
    let of = |document: &Value| experiment(document).fingerprint();
    for (pointer, value) in
        [("/title", json!("Another")), ("/measures", json!(["edges"])), ("/budget/iterations", json!(400.0))]
    {
        assert_eq!(of(&changed(pointer, value)), of(&full()), "{pointer}");
    }
    for (pointer, value) in [("/seeds", json!([3, 7])), ("/budget/iterations", json!(401)), ("/verify", json!(false))] {
        assert_ne!(of(&changed(pointer, value)), of(&full()), "{pointer}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_summary_counts_what_is_solved_and_compares_settings_on_the_same_worlds_and_seeds() {
    let experiment = experiment(&changed("/budget", json!({ "iterations": 130 })));
    assert_eq!(experiment.measures(), [Measure::Visited, Measure::Length, Measure::BuildSeconds]);
    let (mut trials, mut summary) = (Trials::new(&experiment), Summary::new(&experiment));
    // All but the last two, backwards: the order does not matter.
    let rows: Vec<_> = (0..experiment.trial_count() - 2).map(|i| row(&experiment, &mut trials, i, u64::MAX)).collect();
    for row in rows.iter().rev() {
        let values = ["visited", "length"].map(|name| row[name].as_f64().unwrap_or(f64::NAN));
        let trial = experiment.trial(row["trial"].as_u64().unwrap());
        let (is_solved, is_valid) = (row["status"] == "solved", row["valid"].as_bool());
        let mut add = |is_solved, is_valid, values: &[f64]| summary.add(&trial, is_solved, is_valid, values);
        add(is_solved, is_valid, &[values[0], values[1], f64::NAN]).expect("a new trial");
        add(is_solved, is_valid, &[values[0], values[1], f64::NAN]).expect("the same again");
        refuses(add(!is_solved, is_valid, &values), "duplicate-name", "/trial");
        refuses(add(is_solved, is_valid.map_or(Some(true), |_| None), &values), "duplicate-name", "/trial");
        if is_solved {
            refuses(add(true, is_valid, &[values[0], values[1] + 1.0, f64::NAN]), "duplicate-name", "/trial");
        }
    }
    let document = summary.document();
    assert_eq!((document.rows, document.trials), (46, 48));
    assert_eq!(document.groups.len(), 4 * 3);
    for group in &document.groups {
        let is_of = |row: &&serde_json::Map<String, Value>| {
            let settings =
                [("world.radius", group.world_settings.get("radius")), ("planner.k", group.settings.get("k"))];
            let same = settings.iter().all(|(column, value)| row[*column] == value.cloned().unwrap_or_default());
            same && row["world"] == group.world.as_str()
                && group.query.as_ref().is_none_or(|query| row["query"] == query.as_str())
                && row["planner"] == group.planner.as_str()
        };
        let own: Vec<_> = rows.iter().filter(is_of).collect();
        let lengths: Vec<f64> = own.iter().filter_map(|row| row["length"].as_f64()).collect();
        assert_eq!((group.solved.n, group.solved.count), (own.len() as u64, lengths.len() as u64));
        let size = if group.world == "round" { 2 } else { 6 };
        assert_eq!(group.solved.n + group.solved.missing, size);
        assert_eq!(group.valid.unwrap().n, group.solved.count);
        let length = &group.measures["length"];
        assert_eq!((length.mean.n, length.quartiles.n + length.quartiles.missing), (group.solved.count, size));
        let total: f64 = lengths.iter().sum();
        let mean = length.mean.mean.unwrap_or(0.0);
        assert!((mean * lengths.len() as f64 - total).abs() < 1e-9, "{mean} {total}");
        assert_eq!(group.measures["build_seconds"].mean.n, 0);
    }
    assert_eq!(document.comparisons.len(), 4 * 2);
    for comparison in &document.comparisons {
        let [one, other] = [comparison.group, comparison.with].map(|i| &document.groups[i]);
        assert_eq!((&one.world, &one.query, &one.world_settings), (&other.world, &other.query, &other.world_settings));
        assert_eq!((other.planner.as_str(), cell_text(&other.settings["k"]).as_str()), ("roadmap", "2"));
        assert_eq!(comparison.solved.n, one.solved.n.min(other.solved.n));
        assert!(comparison.measures["length"].n <= one.solved.count.min(other.solved.count));
        assert!(comparison.solved.words.contains("roadmap (k=2)"), "{}", comparison.solved.words);
    }
    assert_eq!(document, summary.document_against(experiment.baseline("roadmap (k=2)").expect("a name")));
    // Three settings in each of four kinds of world.
    let pairs = |baseline| {
        let document = summary.document_against(baseline);
        document.comparisons.iter().map(|one| [one.group, one.with]).collect::<Vec<_>>()
    };
    let of_all = |pairs: &[[usize; 2]]| -> Vec<_> {
        (0..4).flat_map(|world| pairs.iter().map(move |pair| pair.map(|i| 3 * world + i))).collect()
    };
    assert_eq!(pairs(experiment.baseline("roadmap (k=6)").expect("a name")), of_all(&[[0, 1], [2, 1]]));
    assert_eq!(pairs(experiment.baseline("rrt").expect("a name")), of_all(&[[0, 2], [1, 2]]));
    assert_eq!(pairs(Baseline::AllPairs), of_all(&[[1, 0], [2, 0], [2, 1]]));
    refuses(experiment.baseline("roadmap"), "out-of-range", "/baseline");
    // A baseline without rows is compared with nothing.
    let none = Summary::new(&experiment).document_against(Baseline::AllPairs);
    assert_eq!((none.groups.len(), none.comparisons.len()), (0, 0));
}

#[wasm_bindgen_test(unsupported = test)]
fn of_many_settings_an_unknown_baseline_names_the_first() {
    let k = json!([{ "algorithm": "prm", "vary": { "k": { "from": 1, "to": 200, "step": 1 } } }]);
    let error = experiment(&changed("/planners", k)).baseline("prm (k=0)").expect_err("no such setting");
    let sentence = error.message();
    assert!(
        sentence.starts_with("no setting has the name \"prm (k=0)\"; known names are \"prm (k=1)\", "),
        "{sentence}"
    );
    assert!(sentence.ends_with("\"prm (k=30)\", and 170 more"), "{sentence}");
}
