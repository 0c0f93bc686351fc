//! Nearest neighbours of a scenario's robot: results, counts, refusals and samples; on native, Node and Chrome alike.

use crate::common::documents::refuses;
use crate::common::golden::scene;
use planarium::run::catalogue::catalogue;
use planarium::run::inspect::{Inspector, MAX_SAMPLES};
use planarium::run::neighbours::{Answer, Neighbours, index, indexes, recall};
use planarium::run::{Options, Value, start};
use planarium::scenario::Scenario;
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

const SCENES: [&str; 8] = ["corner", "firs", "locked", "rings", "shelf", "tentacle", "thicket", "turn"];

fn text(word: &str) -> Value {
    Value::Text(word.to_owned())
}

/// An index with these options.
fn made(scenario: &Scenario, id: &str, set: &[(&str, Value)]) -> Box<dyn Neighbours> {
    let set: Vec<_> = set.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    index(scenario, Some(id), &set).expect("it can be made")
}

fn bits(answer: &Answer) -> Vec<(u32, u64)> {
    answer.neighbours.iter().map(|neighbour| (neighbour.vertex.0, neighbour.distance.to_bits())).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn tree_and_scan_return_the_same_for_every_robot_and_metric_and_count_what_they_visit() {
    for name in SCENES {
        let scenario = scene(name);
        let inspector = Inspector::new(&scenario);
        let is_arm = scenario.robot().kind() == "arm";
        let metrics: &[&str] = if is_arm { &["sum", "euclidean", "naive"] } else { &[""] };
        for metric in metrics {
            let set: Vec<_> = is_arm.then(|| ("metric", text(metric))).into_iter().collect();
            let [mut scan, mut tree, mut forest] = ["linear", "kd-tree", "forest"].map(|id| made(&scenario, id, &set));
            let rows = inspector.samples(1500, 1, false).expect("samples");
            for index in [&mut scan, &mut tree, &mut forest] {
                assert!(index.is_empty());
                assert_eq!(index.k_nearest(&rows[..index.dimension()], 3).expect("none").neighbours, []);
                index.add(&rows[..rows.len() / 2]).expect("rows");
                index.add(&rows[rows.len() / 2..]).expect("more rows");
                assert_eq!((index.len(), index.dimension()), (1500, inspector.dimension()));
            }
            let (mut found, mut visited) = (0.0, 0);
            let targets = inspector.samples(40, 2, false).expect("targets");
            for q in targets.chunks_exact(inspector.dimension()) {
                for k in [0, 1, 5, 20, 1500, usize::MAX] {
                    let [a, b] = [&scan, &tree].map(|index| index.k_nearest(q, k).expect("an answer"));
                    assert_eq!((bits(&a), a.neighbours.len()), (bits(&b), k.min(1500)), "{name} {metric} {k}");
                    assert_eq!(a.visited, if k == 0 { 0 } else { 1500 }, "a scan visits all");
                    assert!((k.min(1500)..=1500).contains(&b.visited));
                }
                let exact = scan.k_nearest(q, 10).expect("an answer");
                visited += tree.k_nearest(q, 10).expect("an answer").visited;
                let near = forest.k_nearest(q, 10).expect("an answer");
                assert!((400..1500).contains(&near.visited), "{} visited", near.visited);
                found += recall(&near.neighbours, &exact.neighbours);
                let radius = exact.neighbours[9].distance;
                let [a, b] = [&scan, &tree].map(|index| index.within(q, radius).expect("an answer"));
                assert_eq!(bits(&a), bits(&b));
                assert_eq!(bits(&a), bits(&exact), "none of them is on the rim but the tenth");
                assert_eq!(tree.within(q, 0.0).expect("an answer").neighbours, []);
            }
            assert!(found / 40.0 > 0.8, "{name} {metric}: the forest finds {} of 40", found);
            assert!(
                inspector.dimension() > 4 || visited < 40 * 700,
                "{name} {metric}: the tree visits {visited} in all"
            );
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_naive_metric_sees_two_angles_at_the_seam_far_apart() {
    let scenario = scene("firs");
    let rows = [3.1, 0.0, -3.1, 0.0, 0.1, 0.0, -0.1, 0.0];
    let nearest = |metric: &str, q: [f64; 2]| {
        let mut tree = made(&scenario, "kd-tree", &[("metric", text(metric))]);
        tree.add(&rows).expect("rows");
        let answer = tree.k_nearest(&q, 4).expect("an answer");
        answer.neighbours.iter().map(|neighbour| neighbour.vertex.0).collect::<Vec<_>>()
    };
    assert_eq!(nearest("sum", [-3.13, 0.0]), [1, 0, 3, 2]);
    assert_eq!(nearest("euclidean", [0.05, 0.0])[..2], [2, 3]);
    assert_eq!(nearest("naive", [0.05, 0.0]), [2, 0, 1, 3], "-0.1 is read as 6.18, a whole turn away");
    assert_eq!(nearest("sum", [-3.13 + 4.0 * std::f64::consts::PI, 0.0]), [1, 0, 3, 2], "any number of turns");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_seed_draws_the_same_forest_and_another_another() {
    let scenario = scene("tentacle");
    let rows = Inspector::new(&scenario).samples(3000, 5, false).expect("samples");
    let found = |seed: f64| {
        let small = [("trees", Value::Number(2.0)), ("candidates", Value::Number(50.0)), ("seed", Value::Number(seed))];
        let mut forest = made(&scenario, "forest", &small);
        forest.add(&rows).expect("rows");
        bits(&forest.k_nearest(&[0.0; 6], 30).expect("an answer"))
    };
    assert_eq!(found(3.0), found(3.0));
    assert_ne!(found(3.0), found(4.0));
}

#[wasm_bindgen_test(unsupported = test)]
fn what_makes_no_sense_is_refused_and_leaves_the_index_as_it_was() {
    let arm = scene("locked");
    for (id, name, value, code) in [
        ("kd-tree", "trees", Value::Number(4.0), "unknown-parameter"),
        ("forest", "trees", Value::Number(0.0), "out-of-range"),
        ("forest", "leaf", Value::Number(32.5), "out-of-range"),
        ("forest", "seed", Value::Number(f64::NAN), "not-finite"),
        ("linear", "metric", Value::Number(1.0), "wrong-type"),
        ("linear", "metric", text("taxi"), "out-of-range"),
    ] {
        refuses(index(&arm, Some(id), &[(name.to_owned(), value)]), code, &format!("/{name}"));
    }
    refuses(index(&arm, Some("ball-tree"), &[]), "out-of-range", "/index");
    for name in ["corner", "turn", "rings"] {
        let naive = [("metric".to_owned(), text("naive"))];
        refuses(index(&scene(name), None, &naive), "out-of-range", "/metric");
    }
    assert!(index(&scene("rings"), None, &[("metric".to_owned(), text("euclidean"))]).is_ok());

    for info in indexes() {
        let mut index = made(&arm, info.id, &[]);
        index.add(&[0.1, 0.2]).expect("a row");
        for (rows, code, pointer) in [
            (&[0.0, 0.0, 0.0][..], "wrong-dimension", "/rows"),
            (&[0.0, 0.0, 0.0, f64::NAN], "not-finite", "/rows/1/1"),
            (&[0.0, 0.0, 1e7, 0.0], "out-of-range", "/rows/1/0"),
            (&[0.0, 0.0, 100.0, 0.0], "out-of-range", "/rows/1/0"),
        ] {
            refuses(index.add(rows), code, pointer);
            assert_eq!(index.len(), 1, "none of them was added");
        }
        refuses(index.k_nearest(&[0.0], 1), "wrong-dimension", "/q");
        refuses(index.k_nearest(&[0.0, f64::INFINITY], 1), "not-finite", "/q/1");
        refuses(index.k_nearest(&[100.0, 0.0], 1), "out-of-range", "/q/0");
        refuses(index.within(&[0.0, 0.0], -1.0), "out-of-range", "/radius");
        refuses(index.within(&[0.0, 0.0], f64::NAN), "not-finite", "/radius");
    }
    let rows = vec![0.0; 2 * 156_251];
    let mut forest = made(&arm, "forest", &[("trees", Value::Number(64.0))]);
    refuses(forest.add(&rows), "too-large", "/rows");
}

#[wasm_bindgen_test(unsupported = test)]
fn samples_are_those_of_a_planner_of_the_same_seed() {
    for name in ["firs", "rings", "corner", "locked"] {
        let scenario = scene(name);
        let inspector = Inspector::new(&scenario);
        let options = Options {
            planner: Some("prm".to_owned()),
            query: None,
            seed: 11,
            parameters: vec![("samples".to_owned(), Value::Number(100.0))],
        };
        let mut run = start(&scenario, &options).expect("it starts");
        run.step(100_000);
        let vertices = run.vertices_since(0);
        let free = inspector.samples(100, 11, true).expect("samples");
        // Start and goal stand among the vertices.
        let dimension = inspector.dimension();
        let kept: Vec<_> = vertices.chunks_exact(dimension).collect();
        let is_kept = |q: &&[f64]| kept.contains(q);
        assert_eq!((free.len(), kept.len()), (100 * dimension, 102), "{name}");
        assert!(free.chunks_exact(dimension).all(|q| is_kept(&q)), "{name}");
        assert!(free.chunks_exact(dimension).all(|q| inspector.check(q).expect("a configuration").is_empty()));
        let all = inspector.samples(2000, 11, false).expect("samples");
        let some_free = all.chunks_exact(dimension).filter(|q| inspector.check(q).expect("a configuration").is_empty());
        assert_eq!(some_free.take(100).collect::<Vec<_>>().concat(), free, "{name}: those of all that are free");
        assert_ne!(inspector.samples(100, 12, true).expect("samples"), free);
    }
    let inspector = Inspector::new(&scene("firs"));
    assert_eq!(inspector.samples(0, 0, true), Ok(Vec::new()));
    refuses(inspector.samples(MAX_SAMPLES + 1, 0, false), "out-of-range", "/n");
    refuses(inspector.samples(1, 1 << 53, false), "out-of-range", "/seed");
    let full = r#"{"format": "planarium-scenario-1", "name": "full", "world": {"bounds": {"min": [0, 0], "max": [1, 1]},
        "obstacles": [{"type": "disc", "center": [0.5, 0.5], "radius": 2}]}, "robot": {"type": "disc", "radius": 0}, "queries": []}"#;
    let inspector = Inspector::new(&Scenario::parse(full).expect("a scenario"));
    refuses(inspector.samples(1, 0, true), "unsupported", "/free");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_lists_what_can_be_set() {
    let table: Json = catalogue()["indexes"].clone();
    let ids: Vec<_> = table.as_array().expect("rows").iter().map(|row| row["id"].as_str().expect("an id")).collect();
    assert_eq!(ids, ["linear", "kd-tree", "forest"]);
    for (row, info) in table.as_array().expect("rows").iter().zip(indexes()) {
        assert_eq!(row["exact"], json!(info.id != "forest"));
        for parameter in row["parameters"].as_array().expect("parameters") {
            let name = parameter["name"].as_str().expect("a name");
            assert!(parameter["meaning"].as_str().expect("a meaning").ends_with('.'));
            // The ends of its range are taken, and what lies beyond is not.
            let Some(max) = parameter["max"].as_f64() else { continue };
            let given = |value: f64| index(&scene("firs"), Some(info.id), &[(name.to_owned(), Value::Number(value))]);
            assert!(given(max).is_ok() && given(parameter["min"].as_f64().expect("a range")).is_ok(), "{name}");
            assert!(given(max + 1.0).is_err(), "{name}");
        }
    }
}

/// The targets and counts of the course reports, on the lists of configurations of the folder `PLANARIUM_SCENARIOS`, where there
/// is one.
#[cfg(not(target_arch = "wasm32"))]
#[allow(clippy::approx_constant)] // the reports say 3.14
#[test]
fn the_reports_targets_on_the_reports_lists() {
    let Some(shared) = crate::common::documents::shared() else { return };
    let arm = scene("firs");
    let body = scene("corner");
    type Asked<'a> = (&'a Scenario, &'a str, &'a [(&'a [f64], usize)]);
    let asked: [Asked; 2] = [
        (
            &arm,
            "arm_configs",
            &[(&[0.0, 0.0], 3), (&[3.14, 1.5], 6), (&[4.0, 5.2], 4), (&[1.5, 1.1], 10), (&[5.8, -1.5], 5)],
        ),
        (
            &body,
            "rigid_configs",
            &[
                (&[1.0, 1.0, 0.0], 3),
                (&[0.5, 0.5, 0.0], 4),
                (&[0.75, 0.5, 0.2], 4),
                (&[1.0, 1.5, -0.2], 4),
                (&[0.4, 0.5, -0.3], 5),
                (&[0.5, 0.5, 1.0], 4),
                (&[1.75, 1.75, 0.0], 20),
            ],
        ),
    ];
    for (scenario, name, targets) in asked {
        let list: Vec<Vec<f64>> = serde_json::from_str(&shared[name]).expect("an array of arrays of numbers");
        assert!(list.len() >= 100, "{name} has {}", list.len());
        let inspector = Inspector::new(scenario);
        let [mut scan, mut tree] = ["linear", "kd-tree"].map(|id| made(scenario, id, &[]));
        scan.add(&list.concat()).expect("rows");
        tree.add(&list.concat()).expect("rows");
        for (q, k) in targets {
            let mut all: Vec<_> =
                (0u32..).zip(&list).map(|(i, row)| (inspector.distance(row, q).expect("a distance"), i)).collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let expected: Vec<_> = all[..*k].iter().map(|(distance, i)| (*i, distance.to_bits())).collect();
            assert_eq!(bits(&scan.k_nearest(q, *k).expect("an answer")), expected, "{name} {q:?}");
            assert_eq!(bits(&tree.k_nearest(q, *k).expect("an answer")), expected, "{name} {q:?}");
        }
    }
}
