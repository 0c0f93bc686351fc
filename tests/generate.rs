//! Scenarios by seed: what forests and clutter promise.

use planarium::geometry::{Polygon, Segment, distance_segment_polygon, intersects_segment_polygon};
use planarium::robot::Part;
use planarium::scenario::generate::{ClutterOptions, ForestOptions, RobotChoice, clutter, forest, generate};
use planarium::scenario::{Node, Obstacle, Robot, Scenario};
use wasm_bindgen_test::wasm_bindgen_test;

fn make(kind: &str, options: &str) -> Result<Scenario, planarium::Error> {
    generate(kind, &Node::parse(options).expect("the options are JSON"))
}

/// 64-bit FNV-1a of the normalised document.
fn hash(scenario: &Scenario) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
    scenario.to_json_string().bytes().fold(0xcbf2_9ce4_8422_2325, step)
}

fn polygons(scenario: &Scenario) -> Vec<&Polygon> {
    let mut polygons = Vec::new();
    for obstacle in &scenario.world().obstacles {
        let Obstacle::Polygon(polygon) = obstacle else { panic!("generators make polygons") };
        polygons.push(polygon);
    }
    polygons
}

fn footprint(robot: &Robot, q: &[f64]) -> Vec<Part> {
    match robot {
        Robot::Arm(arm) => arm.footprint(q),
        Robot::Disc(disc) => disc.footprint(q),
    }
}

fn axis_and_radius(part: &Part) -> (Segment, f64) {
    match *part {
        Part::Capsule { a, b, radius } => (Segment::new(a, b), radius),
        Part::Disc { center, radius } => (Segment::new(center, center), radius),
    }
}

/// The distance from the robot at its starts and goals to the nearest obstacle.
fn clearance(scenario: &Scenario) -> f64 {
    let mut least = f64::INFINITY;
    for q in scenario.queries().iter().flat_map(|query| [&query.start, &query.goal]) {
        for part in footprint(scenario.robot(), q) {
            let (axis, radius) = axis_and_radius(&part);
            for polygon in polygons(scenario) {
                least = least.min(distance_segment_polygon(&axis, polygon) - radius);
            }
        }
    }
    least
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_has_four_triangles_a_link_in_distinct_cells_of_the_grid() {
    for links in 1..=8 {
        for seed in 0..40 {
            let scenario = forest(&ForestOptions { links, seed }).unwrap();
            let reach = links as f64;
            let mut cells = Vec::new();
            for triangle in polygons(&scenario) {
                let v = triangle.vertices();
                let (x, y) = (v[0].x, v[0].y);
                let corners: Vec<(f64, f64)> = v.iter().map(|p| (p.x, p.y)).collect();
                assert_eq!(corners, [(x, y), (x + 0.5, y), (x + 0.25, y + 0.5)]);
                assert!([x, y].iter().all(|&c| -reach <= c && c < reach && (2.0 * c).fract() == 0.0), "({x}, {y})");
                assert!(!cells.contains(&(x, y)), "({x}, {y}) twice with {links} links, seed {seed}");
                cells.push((x, y));
            }
            assert_eq!(cells.len(), 4 * links);
            assert_eq!(scenario.world().bounds, None);
            let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
            assert_eq!((arm.links(), arm.radius()), (&vec![1.0; links][..], 0.0));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_leaves_base_start_and_goal_free() {
    let mut nearest = f64::INFINITY;
    for links in 1..=8 {
        for seed in 0..60 {
            let scenario = forest(&ForestOptions { links, seed }).unwrap();
            let query = &scenario.queries()[0];
            for part in [&query.start, &query.goal].into_iter().flat_map(|q| footprint(scenario.robot(), q)) {
                let (axis, _) = axis_and_radius(&part);
                assert!(polygons(&scenario).iter().all(|triangle| !intersects_segment_polygon(&axis, triangle)));
            }
            nearest = nearest.min(clearance(&scenario));
        }
    }
    assert!((1e-9..0.1).contains(&nearest), "some triangle stands close by, none touches: {nearest}");
}

#[wasm_bindgen_test(unsupported = test)]
fn every_cell_that_is_left_free_is_drawn_sometimes() {
    let mut cells = std::collections::BTreeSet::new();
    for seed in 0..600 {
        for triangle in polygons(&forest(&ForestOptions { links: 2, seed }).unwrap()) {
            let corner = triangle.vertices()[0];
            cells.insert(((2.0 * corner.x) as i32, (2.0 * corner.y) as i32));
        }
    }
    // 64 cells; those under the base, the start and the goal never are.
    assert!(cells.len() > 40 && cells.len() < 60, "{}", cells.len());
    assert!(cells.contains(&(-4, -4)) && cells.contains(&(3, 3)) && !cells.contains(&(0, 0)));
}

#[wasm_bindgen_test(unsupported = test)]
fn forests_ask_the_questions_of_the_report() {
    for (links, start, goal) in [
        (2, vec![0.5, 5.0], vec![2.0, 1.0]),
        (3, vec![1.0, 0.5, 5.0], vec![4.0, 1.0, 1.0]),
        (4, vec![0.1, 0.2, 0.3, 0.4], vec![5.0, 1.0, 5.0, 0.5]),
    ] {
        let scenario = forest(&ForestOptions { links, seed: 3 }).unwrap();
        let query = &scenario.queries()[0];
        assert_eq!((query.name.as_str(), &query.start, &query.goal), ("report", &start, &goal));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn clutter_is_convex_disjoint_within_bounds_and_leaves_start_and_goal_free() {
    for robot in [RobotChoice::Disc, RobotChoice::Arm(1), RobotChoice::Arm(3), RobotChoice::Arm(8)] {
        for seed in 0..25 {
            let options = ClutterOptions { robot, seed, ..ClutterOptions::default() };
            let scenario = clutter(&options).unwrap();
            let polygons = polygons(&scenario);
            assert_eq!(polygons.len(), options.count);
            let bounds = scenario.world().bounds.expect("clutter has bounds");
            for (i, polygon) in polygons.iter().enumerate() {
                assert!(polygon.is_convex() && (3..=7).contains(&polygon.vertices().len()));
                assert!(bounds.contains(polygon.aabb().min) && bounds.contains(polygon.aabb().max));
                for other in &polygons[..i] {
                    let gap = polygon.edges().map(|edge| distance_segment_polygon(&edge, other)).fold(9.0, f64::min);
                    assert!(gap > options.gap && !other.contains(polygon.vertices()[0]));
                    assert!(!polygon.contains(other.vertices()[0]));
                }
            }
            assert!(clearance(&scenario) > options.gap);
            for q in [&scenario.queries()[0].start, &scenario.queries()[0].goal] {
                for part in footprint(scenario.robot(), q) {
                    let (axis, radius) = axis_and_radius(&part);
                    assert!(bounds.depth(axis.a).min(bounds.depth(axis.b)) > radius);
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_generated_is_a_scenario_that_the_parser_accepts() {
    for seed in 0..20 {
        for scenario in [
            forest(&ForestOptions { links: 1 + seed as usize % 8, seed }).unwrap(),
            clutter(&ClutterOptions { seed, ..ClutterOptions::default() }).unwrap(),
            clutter(&ClutterOptions { robot: RobotChoice::Arm(2), radius: 0.1, seed, ..Default::default() }).unwrap(),
        ] {
            assert_eq!(Scenario::parse(&scenario.to_json_string()), Ok(scenario));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_seed_is_a_document() {
    let cases = [
        ("forest", r#"{"links": 2, "seed": 1}"#, GOLDEN[0]),
        ("forest", r#"{"links": 3, "seed": 9007199254740991}"#, GOLDEN[1]),
        ("forest", r#"{"links": 4}"#, GOLDEN[2]),
        ("forest", r#"{"links": 8, "seed": 5}"#, GOLDEN[3]),
        ("clutter", "{}", GOLDEN[4]),
        ("clutter", r#"{"robot": "arm", "links": 3, "count": 20, "radius": 0.02, "seed": 7}"#, GOLDEN[5]),
    ];
    for (kind, options, golden) in cases {
        let scenario = make(kind, options).unwrap();
        assert_eq!(hash(&scenario), hash(&make(kind, options).unwrap()));
        assert_eq!(hash(&scenario), golden, "{kind} {options}: {:#018x}", hash(&scenario));
    }
    let names: Vec<String> =
        (0..50).map(|seed| hash(&forest(&ForestOptions { links: 3, seed }).unwrap()).to_string()).collect();
    assert_eq!(names.iter().collect::<std::collections::BTreeSet<_>>().len(), 50);
}

/// The hashes of the documents above, the same on every platform.
const GOLDEN: [u64; 6] = [
    0x1ebe_6b0f_44bf_45a0,
    0xbcb8_a9d5_9d22_2340,
    0x0265_032b_56ae_3dd0,
    0x5c27_f2e6_a8f5_c3e3,
    0x8b31_3591_0e07_facb,
    0xc046_26df_927b_294d,
];

#[wasm_bindgen_test(unsupported = test)]
fn options_have_defaults() {
    assert_eq!(make("forest", "{}"), forest(&ForestOptions::default()));
    assert_eq!(make("clutter", "{}"), clutter(&ClutterOptions::default()));
    assert_eq!(make("clutter", r#"{"robot": "disc", "count": 0}"#).unwrap().world().obstacles, []);
    let arm = make("clutter", r#"{"robot": "arm"}"#).unwrap();
    assert_eq!(arm.robot().dimension(), 2);
    let (name, title) = ("clutter-2r-14-0", "2R arm among 14 convex polygons, seed 0");
    assert_eq!((arm.name(), arm.title()), (name, title));
}

#[wasm_bindgen_test(unsupported = test)]
fn options_that_are_wrong_are_refused() {
    let cases = [
        ("desert", "{}", "unknown-generator", ""),
        ("", "{}", "unknown-generator", ""),
        ("forest", "[]", "wrong-type", ""),
        ("forest", "null", "wrong-type", ""),
        ("forest", r#"{"link": 2}"#, "unknown-field", "/link"),
        ("forest", r#"{"links": 0}"#, "out-of-range", "/links"),
        ("forest", r#"{"links": 9}"#, "out-of-range", "/links"),
        ("forest", r#"{"links": 2.5}"#, "out-of-range", "/links"),
        ("forest", r#"{"links": "2"}"#, "wrong-type", "/links"),
        ("forest", r#"{"seed": -1}"#, "out-of-range", "/seed"),
        ("forest", r#"{"seed": 9007199254740992}"#, "out-of-range", "/seed"),
        ("forest", r#"{"seed": null}"#, "wrong-type", "/seed"),
        ("clutter", r#"{"robot": "car"}"#, "unknown-type", "/robot"),
        ("clutter", r#"{"robot": 1}"#, "wrong-type", "/robot"),
        ("clutter", r#"{"links": 2}"#, "unknown-field", "/links"),
        ("clutter", r#"{"robot": "disc", "links": 2}"#, "unknown-field", "/links"),
        ("clutter", r#"{"robot": "arm", "links": 9}"#, "out-of-range", "/links"),
        ("clutter", r#"{"count": 61}"#, "out-of-range", "/count"),
        ("clutter", r#"{"count": -1}"#, "out-of-range", "/count"),
        ("clutter", r#"{"radius": 0.2}"#, "out-of-range", "/radius"),
        ("clutter", r#"{"radius": -0.1}"#, "out-of-range", "/radius"),
        ("clutter", r#"{"smallest": 0.01}"#, "out-of-range", "/smallest"),
        ("clutter", r#"{"smallest": 0.3}"#, "out-of-range", "/smallest"),
        ("clutter", r#"{"largest": 0.6}"#, "out-of-range", "/largest"),
        ("clutter", r#"{"gap": 0.3}"#, "out-of-range", "/gap"),
        ("clutter", r#"{"size": 1}"#, "unknown-field", "/size"),
    ];
    for (kind, options, code, pointer) in cases {
        let error = make(kind, options).expect_err(options);
        assert_eq!((error.code().as_str(), error.pointer()), (code, pointer), "{kind} {options}: {error}");
    }
    let options = Node::Object(vec![("gap".to_owned(), Node::Number(f64::NAN))]);
    let error = generate("clutter", &options).unwrap_err();
    assert_eq!((error.code().as_str(), error.pointer()), ("not-finite", "/gap"));
    for (error, code, pointer) in [
        (forest(&ForestOptions { links: 9, seed: 0 }).unwrap_err(), "out-of-range", "/links"),
        (forest(&ForestOptions { links: 2, seed: 1 << 53 }).unwrap_err(), "out-of-range", "/seed"),
        (clutter(&ClutterOptions { radius: f64::NAN, ..Default::default() }).unwrap_err(), "not-finite", "/radius"),
        (clutter(&ClutterOptions { largest: f64::NAN, ..Default::default() }).unwrap_err(), "not-finite", "/largest"),
        (clutter(&ClutterOptions { count: 1 << 30, ..Default::default() }).unwrap_err(), "out-of-range", "/count"),
    ] {
        assert_eq!((error.code().as_str(), error.pointer()), (code, pointer), "{error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_finds_no_place_is_an_error_and_not_an_endless_loop() {
    let error = make("clutter", r#"{"count": 60, "smallest": 0.4, "largest": 0.5}"#).unwrap_err();
    assert_eq!((error.code().as_str(), error.pointer()), ("out-of-range", "/count"));
    assert!(error.message().contains("of 60 obstacles found a place in 10000 draws"), "{error}");
}
