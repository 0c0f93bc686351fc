//! Nearest neighbours of a scenario's robot: results, counts, refusals and samples.

use crate::common::documents::{disc, refuses, scenario};
use crate::common::golden::scene;
use crate::common::{begin_with, finish, given};
use planarium::Error;
use planarium::catalogue::catalogue;
use planarium::run::inspect::{Inspector, MAX_SAMPLES};
use planarium::run::neighbours::{IndexOptions, NearestResult, Neighbours, index, indexes, recall};
use planarium::scenario::Scenario;
use serde_json::{Value as Json, json};
use wasm_bindgen_test::wasm_bindgen_test;

const SCENES: [&str; 8] = ["corner", "firs", "locked", "rings", "shelf", "tentacle", "thicket", "turn"];

fn indexed(scenario: &Scenario, id: Option<&str>, settings: &str) -> Result<Box<dyn Neighbours>, Error> {
    index(scenario, &IndexOptions::read(id, &given(settings))?)
}

/// An index with settings as a line of `name=value`.
fn made(scenario: &Scenario, id: &str, settings: &str) -> Box<dyn Neighbours> {
    indexed(scenario, Some(id), settings).expect("it can be made")
}

fn bits(answer: &NearestResult) -> Vec<(u32, u64)> {
    answer.neighbours.iter().map(|neighbour| (neighbour.vertex.0, neighbour.distance.to_bits())).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn tree_and_scan_return_the_same_for_every_robot_and_metric_and_count_what_they_visit() {
    for name in SCENES {
        let scenario = scene(name);
        let inspector = Inspector::new(&scenario);
        let is_arm = scenario.robot().kind() == "arm";
        let metrics: &[&str] = if is_arm { &["metric=sum", "metric=euclidean", "metric=naive"] } else { &[""] };
        for metric in metrics {
            let indexes = ["linear", "kd-tree", "forest"].map(|id| made(&scenario, id, metric));
            let [mut scan, mut tree, mut forest] = indexes;
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
                    let [a, b] = [&scan, &tree].map(|index| index.k_nearest(q, k).expect("neighbours"));
                    assert_eq!((bits(&a), a.neighbours.len()), (bits(&b), k.min(1500)), "{name} {metric} {k}");
                    assert_eq!(a.visited, if k == 0 { 0 } else { 1500 }, "a scan visits all");
                    assert!((k.min(1500)..=1500).contains(&b.visited));
                }
                let exact = scan.k_nearest(q, 10).expect("neighbours");
                visited += tree.k_nearest(q, 10).expect("neighbours").visited;
                let near = forest.k_nearest(q, 10).expect("neighbours");
                assert!((400..1500).contains(&near.visited), "{} visited", near.visited);
                found += recall(&near.neighbours, &exact.neighbours);
                let radius = exact.neighbours[9].distance;
                let [a, b] = [&scan, &tree].map(|index| index.within(q, radius).expect("neighbours"));
                assert_eq!(bits(&a), bits(&b));
                assert_eq!(bits(&a), bits(&exact), "none of them is on the rim but the tenth");
                assert_eq!(tree.within(q, 0.0).expect("neighbours").neighbours, []);
            }
            assert!(found / 40.0 > 0.8, "{name} {metric}: the forest finds {} of 40", found);
            let is_sparing = inspector.dimension() > 4 || visited < 40 * 700;
            assert!(is_sparing, "{name} {metric}: the tree visits {visited} in all");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn in_the_naive_metric_two_angles_at_the_seam_are_far_apart() {
    let scenario = scene("firs");
    let rows = [3.1, 0.0, -3.1, 0.0, 0.1, 0.0, -0.1, 0.0];
    let nearest = |metric: &str, q: [f64; 2]| {
        let mut tree = made(&scenario, "kd-tree", &format!("metric={metric}"));
        tree.add(&rows).expect("rows");
        let answer = tree.k_nearest(&q, 4).expect("neighbours");
        answer.neighbours.iter().map(|neighbour| neighbour.vertex.0).collect::<Vec<_>>()
    };
    assert_eq!(nearest("sum", [-3.13, 0.0]), [1, 0, 3, 2]);
    assert_eq!(nearest("euclidean", [0.05, 0.0])[..2], [2, 3]);
    assert_eq!(nearest("naive", [0.05, 0.0]), [2, 0, 1, 3], "-0.1 is read as 6.18, a whole turn away");
    assert_eq!(nearest("sum", [-3.13 + 4.0 * std::f64::consts::PI, 0.0]), [1, 0, 3, 2], "any number of turns");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_kd_tree_without_wrap_around_misses_what_lies_across_pi_in_every_metric_of_circles() {
    for name in SCENES {
        let scenario = scene(name);
        let inspector = Inspector::new(&scenario);
        let metrics: &[&str] = match scenario.robot().kind() {
            "arm" => &["metric=sum", "metric=euclidean", "metric=naive"],
            _ => &[""],
        };
        for metric in metrics {
            let [mut scan, mut tree] = ["linear", "kd-tree-unwrapped"].map(|id| made(&scenario, id, metric));
            let rows = inspector.samples(1500, 1, false).expect("samples");
            for index in [&mut scan, &mut tree] {
                index.add(&rows).expect("rows");
            }
            let wraps = *metric != "metric=naive" && inspector.circles().contains(&true);
            let mut shares = 0.0;
            for q in inspector.samples(200, 2, false).expect("targets").chunks_exact(inspector.dimension()) {
                let [exact, found] = [&scan, &tree].map(|index| index.k_nearest(q, 10).expect("neighbours"));
                assert!(wraps || bits(&exact) == bits(&found), "{name} {metric}: nothing wraps");
                shares += recall(&found.neighbours, &exact.neighbours) / 200.0;
            }
            assert!(if wraps { shares > 0.3 && shares < 0.999 } else { shares > 0.999 }, "{name} {metric}: {shares}");
        }
    }
    let scenario = scene("firs");
    let mut tree = made(&scenario, "kd-tree-unwrapped", "");
    tree.add(&[3.1, 0.0, -3.1, 0.0, 0.1, 0.0, -0.1, 0.0]).expect("rows");
    let answer = tree.k_nearest(&[-3.13, 0.0], 4).expect("neighbours");
    assert_eq!(answer.neighbours.iter().map(|one| one.vertex.0).collect::<Vec<_>>(), [1, 3, 2, 0], "3.1 is farthest");
    assert!((answer.neighbours[3].distance - 6.23).abs() < 1e-12, "its plain difference");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_same_seed_draws_the_same_forest_and_another_another() {
    let scenario = scene("tentacle");
    let rows = Inspector::new(&scenario).samples(3000, 5, false).expect("samples");
    let found = |seed: u32| {
        let mut forest = made(&scenario, "forest", &format!("trees=2 candidates=50 seed={seed}"));
        forest.add(&rows).expect("rows");
        bits(&forest.k_nearest(&[0.0; 6], 30).expect("neighbours"))
    };
    assert_eq!(found(3), found(3));
    assert_ne!(found(3), found(4));
}

#[wasm_bindgen_test(unsupported = test)]
fn wrong_input_is_refused_and_leaves_the_index_as_it_was() {
    let arm = scene("locked");
    assert!(indexed(&scene("rings"), None, "metric=euclidean").is_ok());

    for info in indexes() {
        let mut index = made(&arm, info.id, "");
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
    let mut forest = made(&arm, "forest", "trees=64");
    refuses(forest.add(&rows), "too-large", "/rows");
}

#[wasm_bindgen_test(unsupported = test)]
fn samples_are_those_of_a_planner_of_the_same_seed() {
    for name in ["firs", "rings", "corner", "locked"] {
        let scenario = scene(name);
        let inspector = Inspector::new(&scenario);
        let run = finish(begin_with(&scenario, "prm", 11, "samples=100"));
        let vertices = run.vertex_rows(0);
        let free = inspector.samples(100, 11, true).expect("samples");
        // Start and goal are among the vertices.
        let dimension = inspector.dimension();
        let kept: Vec<_> = vertices.chunks_exact(dimension).collect();
        assert_eq!((free.len(), kept.len()), (100 * dimension, 102), "{name}");
        assert!(free.chunks_exact(dimension).all(|q| kept.contains(&q)), "{name}");
        assert!(free.chunks_exact(dimension).all(|q| inspector.check(q).expect("a configuration").is_empty()));
        let all = inspector.samples(2000, 11, false).expect("samples");
        let some_free = all.chunks_exact(dimension).filter(|q| inspector.check(q).expect("a configuration").is_empty());
        assert_eq!(some_free.take(100).collect::<Vec<_>>().concat(), free, "{name}: those of all that are free");
        assert_ne!(inspector.samples(100, 12, true).expect("samples"), free);
    }
    let inspector = Inspector::new(scene("firs"));
    assert_eq!(inspector.samples(0, 0, true), Ok(Vec::new()));
    refuses(inspector.samples(MAX_SAMPLES + 1, 0, false), "out-of-range", "/n");
    refuses(inspector.samples(1, 1 << 53, false), "out-of-range", "/seed");
    let full = scenario("[0, 0], [1, 1]", &disc([0.5, 0.5], 2.0), r#"{"type": "disc", "radius": 0}"#, "");
    let inspector = Inspector::new(&full);
    refuses(inspector.samples(1, 0, true), "unsupported", "/free");
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_lists_what_can_be_set() {
    let table: Json = catalogue()["indexes"].clone();
    let ids: Vec<_> = table.as_array().expect("rows").iter().map(|row| row["id"].as_str().expect("an id")).collect();
    assert_eq!(ids, ["linear", "kd-tree", "kd-tree-unwrapped", "forest"]);
    for (row, info) in table.as_array().expect("rows").iter().zip(indexes()) {
        assert_eq!(row["exact"], json!(["linear", "kd-tree"].contains(&info.id)));
        for parameter in row["parameters"].as_array().expect("parameters") {
            let name = parameter["name"].as_str().expect("a name");
            assert!(parameter["meaning"].as_str().expect("a meaning").ends_with('.'));
            // The ends of its range are accepted, and what lies beyond is not.
            let Some(max) = parameter["max"].as_f64() else { continue };
            let with = |value: f64| indexed(&scene("firs"), Some(info.id), &format!("{name}={value}"));
            assert!(with(max).is_ok() && with(parameter["min"].as_f64().expect("a range")).is_ok(), "{name}");
            assert!(with(max + 1.0).is_err(), "{name}");
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
    // Coordinates and the number of neighbours.
    let of_arm = [0.0, 0.0, 3.0, 3.14, 1.5, 6.0, 4.0, 5.2, 4.0, 1.5, 1.1, 10.0, 5.8, -1.5, 5.0];
    let of_body = [
        1.0, 1.0, 0.0, 3.0, 0.5, 0.5, 0.0, 4.0, 0.75, 0.5, 0.2, 4.0, 1.0, 1.5, -0.2, 4.0, 0.4, 0.5, -0.3, 5.0, 0.5,
        0.5, 1.0, 4.0, 1.75, 1.75, 0.0, 20.0,
    ];
    for (robot, name, targets) in [("firs", "arm_configs", &of_arm[..]), ("corner", "rigid_configs", &of_body)] {
        let scenario = scene(robot);
        let list: Vec<Vec<f64>> = serde_json::from_str(&shared[name]).expect("an array of arrays of numbers");
        assert!(list.len() >= 100, "{name} has {}", list.len());
        let inspector = Inspector::new(&scenario);
        let [mut scan, mut tree] = ["linear", "kd-tree"].map(|id| made(&scenario, id, ""));
        scan.add(&list.concat()).expect("rows");
        tree.add(&list.concat()).expect("rows");
        for target in targets.chunks(inspector.dimension() + 1) {
            let (k, q) = target.split_last().map(|(k, q)| (*k as usize, q)).expect("a number");
            let mut all: Vec<_> =
                (0u32..).zip(&list).map(|(i, row)| (inspector.distance(row, q).expect("a distance"), i)).collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let expected: Vec<_> = all[..k].iter().map(|(distance, i)| (*i, distance.to_bits())).collect();
            assert_eq!(bits(&scan.k_nearest(q, k).expect("neighbours")), expected, "{name} {q:?}");
            assert_eq!(bits(&tree.k_nearest(q, k).expect("neighbours")), expected, "{name} {q:?}");
        }
    }
}
