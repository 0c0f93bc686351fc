//! The clearance shown to viewers, by parry, against the crate's own distances.

use planarium::geometry::{
    Polygon, Segment, distance_point_polygon, distance_point_segment, distance_polygon_polygon,
    distance_segment_polygon,
};
use planarium::robot::Part;
use planarium::run::inspect::Inspector;
use planarium::scenario::{Obstacle, generate};
use wasm_bindgen_test::wasm_bindgen_test;

/// The distance from a part to an obstacle by the crate's own functions.
fn distance(part: &Part, obstacle: &Obstacle) -> f64 {
    match (part, obstacle) {
        (Part::Capsule { a, b, radius }, Obstacle::Polygon(polygon)) => {
            distance_segment_polygon(&Segment::new(*a, *b), polygon) - radius
        }
        (Part::Capsule { a, b, radius }, Obstacle::Disc(disc)) => {
            distance_point_segment(disc.center, &Segment::new(*a, *b)) - radius - disc.radius
        }
        (Part::Disc { center, radius }, Obstacle::Polygon(polygon)) => {
            distance_point_polygon(*center, polygon) - radius
        }
        (Part::Disc { center, radius }, Obstacle::Disc(disc)) => (center - disc.center).norm() - radius - disc.radius,
        (Part::Polygon { vertices }, obstacle) => {
            let body = Polygon::new(vertices).expect("a placed polygon");
            match obstacle {
                Obstacle::Polygon(polygon) => distance_polygon_polygon(&body, polygon),
                Obstacle::Disc(disc) => distance_point_polygon(disc.center, &body) - disc.radius,
            }
        }
    }
}

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
                let all = parts.iter().flat_map(|part| obstacles.iter().map(|obstacle| distance(part, obstacle)));
                let expected = all.fold(f64::INFINITY, f64::min);
                let own = distance(&parts[found.part], &obstacles[found.obstacle]);
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
