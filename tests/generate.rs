//! Scenarios by seed: what the generators promise.

use crate::common::bodies;
use crate::common::documents::refuses;
use crate::common::{begin_with, finish};
use planarium::fingerprint::Fingerprint;
use planarium::fleet::{self, fleet_generators};
use planarium::geometry::{Aabb, Disc, Point, Polygon, Segment, distance_polygon_polygon, intersects_segment_polygon};
use planarium::graph::UnionFind;
use planarium::navigation::{self, navigation_generators};
use planarium::options::{Info, Kind};
use planarium::robot::Part;
use planarium::run::inspect::Inspector;
use planarium::run::{Status, Value};
use planarium::scenario::generate::{
    BugTrapOptions, ClutterOptions, ForestOptions, GapOptions, Generator, RobotChoice, Turn, generate, generators,
};
use planarium::scenario::{Obstacle, Query, Robot, Scenario};
use planarium::{Error, worlds};
use wasm_bindgen_test::wasm_bindgen_test;

/// Options are the fields of an object, without its braces.
fn try_make(kind: &str, options: &str) -> Result<Scenario, Error> {
    generate(kind, &planarium::json::parse(&format!("{{{options}}}")).expect("the options are JSON"))
}

fn make(kind: &str, options: &str, seed: u64) -> Scenario {
    let options =
        if options.is_empty() { format!(r#""seed": {seed}"#) } else { format!(r#"{options}, "seed": {seed}"#) };
    try_make(kind, &options).unwrap_or_else(|error| panic!("{kind} {options}: {error}"))
}

fn forest(links: usize, seed: u64) -> Scenario {
    ForestOptions { links, seed }.generate().unwrap()
}

/// The hash of the normalised document.
fn hash(scenario: &Scenario) -> u64 {
    let mut hash = Fingerprint::default();
    hash.bytes(scenario.to_json_string().as_bytes());
    hash.value()
}

fn polygons<'a>(scenario: &'a Scenario) -> Vec<&'a Polygon> {
    let of = |obstacle: &'a Obstacle| match obstacle {
        Obstacle::Polygon(polygon) => polygon,
        _ => panic!("generators make polygons"),
    };
    scenario.world().obstacles.iter().map(of).collect()
}

/// How deep a part lies within the bounds.
fn depth(bounds: &Aabb, part: Part) -> f64 {
    let (points, radius) = match part {
        Part::Capsule { a, b, radius } => (vec![a, b], radius),
        Part::Disc { center, radius } => (vec![center], radius),
        Part::Polygon { vertices } => (vertices, 0.0),
    };
    points.iter().map(|&point| bounds.depth(point)).fold(f64::INFINITY, f64::min) - radius
}

/// Refuses a start or a goal that is not free, within the bounds and away from every obstacle.
fn assert_ends_are_free(scenario: &Scenario) {
    let inspector = Inspector::new(scenario);
    for q in scenario.queries().iter().flat_map(Query::ends) {
        assert_eq!(inspector.check(q), Ok(vec![]), "{} at {q:?}", scenario.title());
        if let Some(bounds) = scenario.world().bounds {
            let mut parts = scenario.robot().footprint(q).into_iter();
            assert!(parts.all(|part| depth(&bounds, part) > 0.0), "{}", scenario.title());
        }
    }
    assert!(clearance(scenario) > 1e-9, "{}", scenario.title());
}

/// The distance from the robot at its starts and goals to the nearest obstacle.
fn clearance(scenario: &Scenario) -> f64 {
    let parts = scenario.queries().iter().flat_map(Query::ends).flat_map(|q| scenario.robot().footprint(q));
    bodies::clearance(&parts.collect::<Vec<_>>(), scenario.world())
}

#[wasm_bindgen_test(unsupported = test)]
fn a_forest_has_four_triangles_per_link_in_distinct_cells_of_the_grid_and_leaves_base_start_and_goal_free() {
    let mut nearest = f64::INFINITY;
    for links in 1..=8 {
        for seed in 0..60 {
            let scenario = forest(links, seed);
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
            nearest = nearest.min(clearance(&scenario));
        }
    }
    assert!((1e-9..0.1).contains(&nearest), "some triangle is close by, none touches: {nearest}");
}

#[wasm_bindgen_test(unsupported = test)]
fn every_cell_that_is_not_excluded_is_drawn_sometimes() {
    let mut cells = std::collections::BTreeSet::new();
    for seed in 0..600 {
        for triangle in polygons(&forest(2, seed)) {
            let corner = triangle.vertices()[0];
            cells.insert(((2.0 * corner.x) as i32, (2.0 * corner.y) as i32));
        }
    }
    // 64 cells; those under the base, the start and the goal never are.
    assert!(cells.len() > 40 && cells.len() < 60, "{}", cells.len());
    assert!(cells.contains(&(-4, -4)) && cells.contains(&(3, 3)) && !cells.contains(&(0, 0)));
}

#[wasm_bindgen_test(unsupported = test)]
fn forests_have_the_queries_of_the_report() {
    for (links, start, goal) in [
        (2, vec![0.5, 5.0], vec![2.0, 1.0]),
        (3, vec![1.0, 0.5, 5.0], vec![4.0, 1.0, 1.0]),
        (4, vec![0.1, 0.2, 0.3, 0.4], vec![5.0, 1.0, 5.0, 0.5]),
    ] {
        let scenario = forest(links, 3);
        let query = &scenario.queries()[0];
        assert_eq!((query.name.as_str(), &query.start, query.configuration()), ("report", &start, Some(&goal[..])));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn clutter_is_convex_disjoint_within_bounds_and_leaves_start_and_goal_free() {
    let others = [RobotChoice::Disc, RobotChoice::RigidBody, RobotChoice::Car].map(|robot| (robot, 2));
    for (robot, links) in others.into_iter().chain([1, 3, 8].map(|links| (RobotChoice::Arm, links))) {
        for seed in 0..25 {
            let (count, options) = (14, ClutterOptions { robot, links, seed, count: Some(14), ..Default::default() });
            let scenario = options.generate().unwrap();
            let polygons = polygons(&scenario);
            assert_eq!(polygons.len(), count);
            let bounds = scenario.world().bounds.expect("clutter has bounds");
            for (i, polygon) in polygons.iter().enumerate() {
                assert!(polygon.is_convex() && (3..=7).contains(&polygon.vertices().len()));
                assert!(bounds.contains(polygon.aabb().min) && bounds.contains(polygon.aabb().max));
                assert!(polygons[..i].iter().all(|other| distance_polygon_polygon(polygon, other) > options.gap));
            }
            assert!(clearance(&scenario) > options.gap);
            assert_ends_are_free(&scenario);
        }
    }
}

/// The hash of one document, the same on every platform; others by seed differ from each other.
#[wasm_bindgen_test(unsupported = test)]
fn a_seed_is_a_document() {
    for (kind, options, seed, golden) in [
        ("forest", r#""links": 2"#, 1, 0x1ebe_6b0f_44bf_45a0),
        ("forest", r#""links": 3"#, 9_007_199_254_740_991, 0xbcb8_a9d5_9d22_2340),
        ("forest", r#""links": 4"#, 0, 0x0265_032b_56ae_3dd0),
        ("forest", r#""links": 8"#, 5, 0x5c27_f2e6_a8f5_c3e3),
        ("clutter", "", 0, 0x8b31_3591_0e07_facb),
        (
            "clutter",
            r#""robot": "arm", "links": 3, "count": 20, "largest": 0.2, "radius": 0.02"#,
            7,
            0xc046_26df_927b_294d,
        ),
        ("discs", "", 1, 0xf1d2_0cce_022a_c05b),
        ("discs", r#""robot": "arm", "links": 4, "count": 24, "placement": "overlapping""#, 2, 0x4557_3809_161e_431c),
        ("maze", "", 0, 0x4192_d110_18ba_46c3),
        ("maze", r#""difficulty": "medium""#, 3, 0x7ddd_5278_9044_84b5),
        ("maze", r#""difficulty": "hard", "thickness": 0.05"#, 4, 0xc05e_f99d_f07b_9497),
        ("maze", r#""robot": "car""#, 3, 0x61ee_9d55_6c73_3901),
        ("gap", "", 5, 0xc7b3_fab8_26c3_2209),
        ("gap", r#""robot": "arm", "links": 3"#, 6, 0x9159_1477_a146_68a5),
        ("bug-trap", "", 7, 0x15be_b970_7526_5f52),
        ("bug-trap", r#""start": "outside", "turn": "quarter""#, 8, 0xa70f_cfff_c9fa_e495),
    ] {
        let found = hash(&make(kind, options, seed));
        assert_eq!(found, hash(&make(kind, options, seed)));
        assert_eq!(found, golden, "{kind} {options}: {found:#018x}");
    }
    for info in generators() {
        let distinct: std::collections::BTreeSet<u64> = (0..50).map(|seed| hash(&make(info.id, "", seed))).collect();
        assert_eq!(distinct.len(), 50, "{}", info.id);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn options_have_defaults() {
    assert_eq!(try_make("clutter", ""), ClutterOptions::default().generate());
    assert!(make("clutter", r#""robot": "disc", "count": 0"#, 0).world().obstacles.is_empty());
    let arm = make("clutter", r#""robot": "arm""#, 0);
    assert_eq!(arm.robot().dimension(), 2);
    let (name, title) = ("clutter-2r-2-0", "2R arm among 2 convex polygons, seed 0");
    assert_eq!((arm.name(), arm.title()), (name, title));
}

#[wasm_bindgen_test(unsupported = test)]
fn options_that_are_wrong_are_refused() {
    let by_type = |options: ClutterOptions, code, pointer| refuses(options.generate(), code, pointer);
    refuses(generate("forest", &serde_json::Value::Null), "wrong-type", "");
    refuses(ForestOptions { links: 9, seed: 0 }.generate(), "out-of-range", "/links");
    refuses(ForestOptions { links: 2, seed: 1 << 53 }.generate(), "out-of-range", "/seed");
    by_type(ClutterOptions { radius: f64::NAN, ..Default::default() }, "not-finite", "/radius");
    by_type(ClutterOptions { gap: f64::NAN, ..Default::default() }, "not-finite", "/gap");
    by_type(ClutterOptions { largest: Some(f64::NAN), ..Default::default() }, "not-finite", "/largest");
    by_type(ClutterOptions { count: Some(1 << 30), ..Default::default() }, "out-of-range", "/count");
    // What finds no place ends in an error, not in an endless loop.
    let message =
        refuses(try_make("clutter", r#""count": 60, "smallest": 0.4, "largest": 0.5"#), "out-of-range", "/count");
    assert!(message.contains("of 60 obstacles could be placed in 10000 draws"), "{message}");
}

/// The ids of a table of generators.
fn ids(infos: Vec<Info>) -> Vec<&'static str> {
    infos.iter().map(|info| info.id).collect()
}

#[wasm_bindgen_test(unsupported = test)]
fn a_mistake_has_one_code_in_scenarios_fleets_and_navigation_tasks() {
    type Generate = fn(&str, &serde_json::Value) -> Result<String, Error>;
    let kinds: [(Vec<&str>, Generate); 4] = [
        (ids(generators()), |id, options| generate(id, options).map(|made| made.to_json_string())),
        (ids(worlds::generators()), |id, options| worlds::generate(id, options).map(|made| made.to_json_string())),
        (ids(fleet_generators()), |id, options| fleet::generate(id, options).map(|made| made.to_json_string())),
        (ids(navigation_generators()), |id, options| {
            navigation::generate(id, options).map(|made| made.to_json_string())
        }),
    ];
    for (ids, make) in &kinds {
        let refused = |id: &str, options: &str, code, pointer, sentence: &str| {
            let message = refuses(make(id, &planarium::json::parse(options).unwrap()), code, pointer);
            assert!(message.contains(sentence), "{id} {options}: {message}");
        };
        refused("jungle", "{}", "unknown-generator", "", "there is no generator \"jungle\"; there are ");
        for id in ids {
            refused(id, "[]", "wrong-type", "", "options must be an object");
            refused(id, r#"{"a/b": 1}"#, "unknown-field", "/a~1b", "unknown option \"a/b\"; known options are ");
            refused(id, r#"{"seed": -1}"#, "out-of-range", "/seed", "seed must lie within");
            refused(id, r#"{"seed": 0.5}"#, "out-of-range", "/seed", "seed must be a whole number");
            refused(id, r#"{"seed": "1"}"#, "wrong-type", "/seed", "seed must be a number");
            refused(id, r#"{"seed": null}"#, "wrong-type", "/seed", "seed must be a number");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_table_of_options_is_what_generators_take() {
    for info in generators() {
        let plain = make(info.id, "", 0);
        let has_disc = info.options.iter().any(|option| option.name == "robot");
        for option in info.options {
            let name = option.name;
            let one = |value: String| {
                let arm = if matches!(name, "links" | "sliding") && has_disc { r#""robot": "arm", "# } else { "" };
                try_make(info.id, &format!("{arm}\"{name}\": {value}"))
            };
            match option.kind {
                Kind::Integer(range) | Kind::Number(range) => {
                    let (min, max) = (*range.start(), *range.end());
                    let default = match option.default {
                        Some(Value::Number(default)) => Some(default),
                        // It depends on the robot.
                        _ => (!option.computed.is_empty()).then_some(f64::NAN),
                    };
                    let default = default.unwrap_or_else(|| panic!("{name} has a default"));
                    assert!(min < max && (default.is_nan() || (min..=max).contains(&default)), "{} {name}", info.id);
                    for outside in [min - 1.0, max + 1.0, min - 1e-9, max + 1e-9] {
                        refuses(one(outside.to_string()), "out-of-range", &format!("/{name}"));
                    }
                    // At the ends of its range an option may conflict with the defaults of others, which is an error.
                    for inside in [min, max] {
                        match one(inside.to_string()) {
                            Ok(scenario) => assert_ends_are_free(&scenario),
                            Err(error) => assert_eq!(error.code().as_str(), "out-of-range", "{error}"),
                        }
                    }
                    if !matches!(name, "links" | "sliding") && !default.is_nan() {
                        assert_eq!(one(default.to_string()).as_ref(), Ok(&plain), "{} {name}", info.id);
                    }
                }
                Kind::Switch => panic!("{name} is a switch"),
                Kind::Choice(words) => {
                    let made: Vec<Scenario> = words.iter().map(|word| one(format!("{word:?}")).unwrap()).collect();
                    made.iter().for_each(assert_ends_are_free);
                    assert_eq!(made[0], plain, "{} {name}", info.id);
                    assert!(made[1..].iter().all(|other| *other != plain), "{} {name}", info.id);
                }
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn starts_and_goals_are_free_with_every_seed_and_setting() {
    let settings = [
        ("discs", r#""count": 60, "smallest": 0.02, "largest": 0.1, "gap": 0"#),
        ("discs", r#""count": 200, "smallest": 0.01, "largest": 0.5, "placement": "overlapping", "radius": 0.1"#),
        ("discs", r#""robot": "arm", "links": 1, "radius": 0.1, "count": 24"#),
        ("discs", r#""robot": "arm", "links": 8"#),
        ("discs", r#""robot": "arm", "links": 3, "sliding": 1"#),
        ("clutter", r#""robot": "arm", "links": 8, "sliding": 7, "radius": 0.05"#),
        ("clutter", r#""robot": "disc""#),
        ("clutter", r#""robot": "arm", "radius": 0.1"#),
        ("clutter", r#""robot": "arm", "radius": 0.1, "count": 14, "largest": 0.2"#),
        ("forest", r#""links": 1"#),
        ("forest", r#""links": 5"#),
        ("forest", r#""links": 8"#),
        ("maze", r#""difficulty": "medium", "radius": 0.1, "thickness": 0.03"#),
        ("maze", r#""difficulty": "hard", "radius": 0, "thickness": 0.1"#),
        ("maze", r#""difficulty": "medium", "robot": "car", "thickness": 0.1"#),
        ("gap", r#""radius": 0.1, "width": 1, "thickness": 0.5"#),
        ("gap", r#""radius": 0.1, "width": 0, "thickness": 0.005"#),
        ("gap", r#""robot": "arm", "links": 2, "radius": 0.1, "width": 0.21, "thickness": 0.5"#),
        ("gap", r#""robot": "arm", "links": 8, "radius": 0.1, "width": 1, "thickness": 0.5"#),
        ("gap", r#""robot": "arm", "links": 3, "radius": 0, "width": 0.01, "thickness": 0.005"#),
        ("gap", r#""robot": "arm", "links": 5, "radius": 0, "width": 1, "thickness": 0.005"#),
        ("bug-trap", r#""radius": 0.1, "mouth": 0.4"#),
        ("bug-trap", r#""radius": 0.1, "mouth": 0.01, "turn": "quarter", "start": "outside""#),
    ];
    for (kind, options) in settings {
        for seed in 0..60 {
            let scenario = make(kind, options, seed);
            assert_ends_are_free(&scenario);
            assert_eq!(Scenario::parse(&scenario.to_json_string()), Ok(scenario));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_solvable_by_construction_is_solved_and_a_passage_that_is_too_narrow_is_named_in_the_title() {
    for (kind, options, is_solvable) in [
        ("discs", r#""count": 50, "largest": 0.1"#, true),
        ("discs", r#""radius": 0.05, "gap": 0.1, "count": 12, "largest": 0.5"#, true),
        ("maze", r#""difficulty": "easy", "radius": 0.08"#, true),
        ("maze", r#""difficulty": "medium""#, true),
        ("maze", r#""difficulty": "hard", "radius": 0"#, true),
        ("maze", r#""robot": "rigid_body""#, true),
        ("maze", r#""difficulty": "medium", "robot": "car""#, true),
        ("gap", r#""width": 0.1"#, true),
        ("gap", r#""width": 0.25, "radius": 0.1, "thickness": 0.3"#, true),
        ("bug-trap", r#""mouth": 0.1"#, true),
        ("bug-trap", r#""start": "outside", "mouth": 0.3, "radius": 0.1"#, true),
        ("gap", r#""width": 0.06"#, false),
        ("gap", r#""width": 0"#, false),
        ("gap", r#""width": 0, "radius": 0"#, false),
        ("bug-trap", r#""mouth": 0.06"#, false),
        ("bug-trap", r#""mouth": 0.1, "radius": 0.1, "start": "outside""#, false),
    ] {
        let (seeds, limit, status) = if is_solvable { (6, 1e5, Status::Solved) } else { (4, 3e3, Status::Exhausted) };
        for seed in 0..seeds {
            let scenario = make(kind, options, seed);
            let run = finish(begin_with(&scenario, "rrt-connect", 0, &format!("max_iterations={limit}")));
            assert_eq!(run.status(), status, "{}", scenario.title());
            assert_eq!(scenario.title().contains("no path"), !is_solvable, "{}", scenario.title());
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn discs_stand_apart_or_overlap_within_bounds() {
    let discs_of = |scenario: &Scenario| -> Vec<Disc> {
        let disc = |obstacle: &Obstacle| match obstacle {
            Obstacle::Disc(disc) => *disc,
            _ => panic!("discs are discs"),
        };
        scenario.world().obstacles.iter().map(disc).collect()
    };
    let gap_between = |a: &Disc, b: &Disc| (a.center - b.center).norm() - a.radius - b.radius;
    let mut overlaps = 0;
    for seed in 0..30 {
        for placement in ["apart", "overlapping"] {
            let scenario = make("discs", &format!(r#""placement": "{placement}""#), seed);
            let discs = discs_of(&scenario);
            assert_eq!(discs.len(), 24);
            assert!(clearance(&scenario) > 0.07);
            let bounds = scenario.world().bounds.expect("discs have bounds");
            for (i, disc) in discs.iter().enumerate() {
                assert!((0.05..=0.18).contains(&disc.radius) && bounds.depth(disc.center) >= disc.radius - 1e-12);
                for other in &discs[..i] {
                    assert!(placement == "overlapping" || gap_between(disc, other) > 0.07);
                    overlaps += usize::from(gap_between(disc, other) < 0.0);
                }
            }
        }
    }
    assert!(overlaps > 100, "{overlaps}");
}

/// The pairs of neighbouring cells of a maze that no wall parts, cells numbered row by row.
fn passages(maze: &Scenario, cells: usize) -> Vec<(usize, usize)> {
    let walls = polygons(maze);
    let middle = |cell: usize| {
        let along = |i: usize| 0.25 * i as f64 + 0.125;
        Point::new(along(cell % cells), along(cell / cells))
    };
    let mut open = Vec::new();
    for cell in 0..cells * cells {
        let right = (cell % cells + 1 < cells).then_some(cell + 1);
        let above = (cell / cells + 1 < cells).then_some(cell + cells);
        for next in [right, above].into_iter().flatten() {
            let passage = Segment::new(middle(cell), middle(next));
            if walls.iter().all(|wall| !intersects_segment_polygon(&passage, wall)) {
                open.push((cell, next));
            }
        }
    }
    open
}

#[wasm_bindgen_test(unsupported = test)]
fn mazes_connect_all_cells_and_hard_ones_by_one_path_only() {
    for (difficulty, cells, count) in [("easy", 6, 35 + 5), ("medium", 9, 80 + 6), ("hard", 12, 143)] {
        for seed in 0..20 {
            let open = passages(&make("maze", &format!(r#""difficulty": "{difficulty}""#), seed), cells);
            assert_eq!(open.len(), count, "{difficulty} {seed}");
            let mut sets = UnionFind::default();
            (0..cells * cells).for_each(|_| sets.add());
            // Each passage that connects two sets leaves one less.
            let connecting = open.iter().filter(|(cell, next)| sets.join(*cell, *next)).count();
            assert_eq!(connecting, cells * cells - 1, "{difficulty} {seed}: all cells are connected");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn walls_in_a_row_are_one_rectangle() {
    for seed in 0..20 {
        let scenario = make("maze", r#""difficulty": "hard""#, seed);
        let walls = polygons(&scenario);
        for (i, wall) in walls.iter().enumerate() {
            for other in &walls[..i] {
                let (a, b) = (wall.aabb(), other.aabb());
                let in_line = (a.min.x, a.max.x) == (b.min.x, b.max.x) || (a.min.y, a.max.y) == (b.min.y, b.max.y);
                let is_long = |aabb: &Aabb| aabb.longer_side() > 0.1;
                assert!(is_long(a) && is_long(b) && !(in_line && a.intersects(b)), "{a:?} {b:?}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_hard_maze_has_the_dead_ends_of_a_uniform_spanning_tree() {
    // In the square lattice 8 / pi^2 (1 - 2 / pi) of the vertices are leaves (Manna, Dhar and Majumdar 1992, "Spanning
    // trees in two dimensions"); a depth-first maze has a third of that. Only cells away from the border are counted.
    let (mut ends, mut counted) = (0, 0);
    for seed in 0..150 {
        let open = passages(&make("maze", r#""difficulty": "hard""#, seed), 12);
        for cell in (0..144).filter(|cell| (2..10).contains(&(cell % 12)) && (2..10).contains(&(cell / 12))) {
            counted += 1;
            ends += usize::from(open.iter().filter(|(a, b)| *a == cell || *b == cell).count() == 1);
        }
    }
    let share = ends as f64 / counted as f64;
    assert!((0.28..0.31).contains(&share), "{share}");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_gap_has_the_width_of_its_option_and_the_arm_reaches_through_it() {
    for links in 0..=8 {
        for seed in 0..20 {
            let robot = if links < 2 { RobotChoice::Disc } else { RobotChoice::Arm };
            let links = links.max(2);
            let options = GapOptions { robot, links, width: Some(0.15), thickness: 0.3, seed, ..Default::default() };
            let scenario = options.generate().unwrap();
            let walls = polygons(&scenario);
            let (lower, upper) = (walls[0].aabb(), walls[1].aabb());
            assert_eq!((walls.len(), lower.min.y, upper.max.y), (2, 0.0, 2.0));
            let (width, thickness) = (upper.min.y - lower.max.y, lower.max.x - lower.min.x);
            assert!((width - 0.15).abs() < 1e-12 && (thickness - 0.3).abs() < 1e-12);
            let inspector = Inspector::new(&scenario);
            let query = &scenario.queries()[0];
            let [before, behind] =
                [&query.start, query.configuration().unwrap()].map(|q| inspector.end_effector(q).unwrap().x);
            assert!(before + 0.03 < lower.min.x && lower.max.x + 0.03 < behind, "{before} {behind}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_mouth_has_the_width_of_its_option() {
    for seed in 0..20 {
        for (mouth, radius, ways) in [(0.1, 0.05 - 1e-9, 1), (0.1, 0.05, 0), (0.04, 0.02 - 1e-9, 1), (0.04, 0.02, 0)] {
            let turn = Turn::Quarter;
            let scenario = BugTrapOptions { mouth, radius, turn, seed, ..Default::default() }.generate().unwrap();
            let Obstacle::Polygon(trap) = &scenario.world().obstacles[0] else { panic!("a trap is a polygon") };
            let inspector = Inspector::new(&scenario);
            // The trap is even about the axis of its mouth: the middle of its box lies on it.
            let middle = nalgebra::center(&trap.aabb().min, &trap.aabb().max);
            let is_way_out = |(x, y): &(f64, f64)| {
                inspector.first_hit(&[middle.x, middle.y], &[middle.x + x, middle.y + y]).unwrap().is_none()
            };
            let free =
                [(0.75, 0.0), (0.0, 0.75), (-0.75, 0.0), (0.0, -0.75)].iter().filter(|to| is_way_out(to)).count();
            assert_eq!(free, ways, "seed {seed}, mouth {mouth}, radius {radius}");
        }
    }
}
