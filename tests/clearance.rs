//! The clearance shown to viewers, by parry, against the crate's own distances.

use crate::common::bodies::part_distance;
use planarium::run::inspect::Inspector;
use planarium::scenario::generate;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn the_clearance_is_the_least_distance_and_its_points_are_that_far_apart() {
    let (mut free, mut touching) = (0, 0);
    for kind in ["clutter", "discs"] {
        for robot in ["disc", "arm", "rigid_body", "car"] {
            let options = serde_json::json!({ "robot": robot, "seed": 3 });
            let scenario = generate::generate(kind, &options).expect("a scenario");
            let inspector = Inspector::new(&scenario);
            let (obstacles, n) = (&scenario.world().obstacles, inspector.dimension());
            for q in inspector.samples(100, 5, false).expect("samples").chunks(n) {
                let parts = inspector.footprint(q).expect("parts");
                let Some(found) = inspector.clearance(q).expect("a configuration") else {
                    assert!(!inspector.check(q).expect("a configuration").is_empty());
                    touching += 1;
                    continue;
                };
                free += 1;
                let all = parts.iter().flat_map(|part| obstacles.iter().map(|obstacle| part_distance(part, obstacle)));
                let expected = all.fold(f64::INFINITY, f64::min);
                let own = part_distance(&parts[found.part], &obstacles[found.obstacle]);
                let [a, b] = found.points;
                for same in [expected, own, (b - a).norm()] {
                    assert!((found.distance - same).abs() < 1e-9, "{kind} {robot} {q:?}: {found:?} is not {same}");
                }
            }
        }
    }
    assert!(free > 200 && touching > 200, "{free} free, {touching} touching");
    let empty = r#"{"format":"planarium-scenario-1","name":"empty","world":{"obstacles":[]},
        "robot":{"type":"arm","base":[0,0],"links":[1]},"queries":[]}"#;
    let empty = Inspector::new(&crate::common::parse(empty));
    assert_eq!(empty.clearance(&[0.0]).expect("a configuration"), None);
    assert_eq!(empty.clearance(&[f64::NAN]).expect_err("no number").code().as_str(), "not-finite");
}
