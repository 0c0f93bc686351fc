//! Buildings of Open-RMF.

use crate::files::{file, free, one, refused};
use planarium_formats::{Code, Format, Options, Place, World, is_world, read};

/// A room of 20 x 10 m with a door in its lower wall; 10 pixels are a metre, and y points down.
pub const BUILDING: &str = "coordinate_system: reference_image
levels:
  L1:
    doors:
      - [4, 5, {name: [1, main], type: [1, hinged]}]
    drawing: {filename: office.png}
    floors:
      - {parameters: {}, vertices: [0, 1, 2, 3]}
    lanes:
      - [6, 7, {}]
    measurements:
      - [0, 1, {distance: [3, 20]}]
      - [1, 2, {distance: [3, 10]}]
    models:
      - {model_name: Chair, x: 30, y: 40}
    vertices:
      - [100, 100, 0, \"\"]
      - [300, 100, 0, \"\"]
      - [300, 200, 0, \"\"]
      - [100, 200, 0, \"\"]
      - [180, 200, 0, \"\"]
      - [220, 200, 0, \"\"]
      - [120, 120, 0, desk, {is_charger: [4, true]}]
      - [280, 180, 0, shelf]
      - [280, 120, 0, window]
    walls:
      - [0, 1, {}]
      - [1, 2, {}]
      - [3, 0, {}]
      - [3, 4, {}]
      - [5, 2, {}]
  L2: {vertices: [[0, 0, 0, \"\"], [10, 0, 0, \"\"]], walls: [[0, 1, {}]]}
lifts: {}
name: office
";

#[track_caller]
fn with(text: &str, options: Options) -> World {
    read(&[file("office.building.yaml", text)], &options).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn walls_join_vertices_and_measurements_give_metres() {
    assert!(is_world(BUILDING.as_bytes()));
    let world = one("office.building.yaml", BUILDING);
    let report = &world.report;
    assert_eq!((report.format, world.scenario.name()), (Format::RmfBuilding, "office, L1"));
    assert_eq!((report.obstacles.walls, report.obstacles.polygons, report.obstacles.vertices), (5, 0, 10));
    // 0.1 m thick, y up.
    assert!(!free(&world, [15.0, -19.96 + 10.0]) && free(&world, [15.0, -10.06]), "the upper wall");
    assert!(!free(&world, [17.0, -20.0]) && free(&world, [20.0, -20.0]), "the door is open");
    let plane = report.plane.as_ref().expect("a plane");
    assert_eq!((plane.scale, plane.origin), ([0.1, -0.1], [0.0, 0.0]));
    let names: Vec<&str> = report.queries.iter().map(|query| &*query.name).collect();
    assert_eq!(names, ["desk to shelf", "shelf to window"]);
    assert_eq!(world.scenario.queries()[0].start, [12.0, -12.0]);
    let words = report.to_string();
    for part in
        ["1 models", "1 lanes", "mean of 2 measurements", "\"L1\" of 2", "office.png", "\"doors\" (1, doors are open)"]
    {
        assert!(words.contains(part), "{part}: {words}");
    }
    let layers = Some(vec!["walls".to_owned(), "doors".to_owned()]);
    let closed = with(BUILDING, Options { layers, wall_thickness: Some(0.0), ..Options::default() });
    assert!(!free(&closed, [20.0, -20.0]) && free(&closed, [20.0, -20.001]));
    let floors = Options { layers: Some(vec!["floors".to_owned()]), walkable: Some(true), ..Options::default() };
    let floors = with(BUILDING, floors);
    assert!(free(&floors, [20.0, -15.0]) && !free(&floors, [20.0, -20.5]));
}

#[test]
fn levels_and_scales_are_chosen() {
    let level = |name: &str| Options { level: Some(name.to_owned()), ..Options::default() };
    let second = with(BUILDING, level("L2"));
    assert_eq!((second.report.obstacles.walls, second.report.queries.len()), (1, 0));
    assert!(second.report.to_string().contains("no measurement"), "{}", second.report);
    let scaled = with(BUILDING, Options { scale: Some(0.5), ..level("L2") });
    assert_eq!(scaled.report.plane.map(|plane| plane.scale), Some([0.5, -0.5]));
    let unknown = refused(&[file("a", BUILDING)], &level("L3"), Code::InvalidOption);
    assert!(unknown.message().contains("\"L2\""), "{unknown}");
    let metres = BUILDING.replace("reference_image", "cartesian_meters");
    assert_eq!(one("a", metres).report.plane, None);
    refused(&[file("a", &BUILDING.replace("reference_image", "wgs84"))], &Options::default(), Code::UnsupportedFeature);
}

#[test]
fn what_is_no_building_is_refused_with_its_line() {
    let refuse = |from: &str, to: &str, code| {
        assert!(BUILDING.contains(from), "{from}");
        refused(&[file("a", &BUILDING.replacen(from, to, 1))], &Options::default(), code)
    };
    assert_eq!(refuse("- [0, 1, {}]", "- [0, 9, {}]", Code::InvalidNumber).place(), Some(&Place::Line(27)));
    refuse("- [0, 1, {}]", "- [0, -1, {}]", Code::InvalidNumber);
    refuse("- [0, 1, {}]", "- [0]", Code::InvalidFile);
    refuse("- [0, 1, {}]", "- wall", Code::InvalidFile);
    refuse("[100, 100, 0", "[100, .nan, 0", Code::InvalidNumber);
    refuse("[100, 100, 0", "[100, 1e999, 0", Code::InvalidNumber);
    refuse("[100, 100, 0", "[100, [1], 0", Code::InvalidFile);
    refuse("[100, 100, 0, \"\"]", "[100]", Code::InvalidFile);
    refuse("distance: [3, 20]", "distance: [3, 0]", Code::InvalidNumber);
    refuse("distance: [3, 20]", "length: 20", Code::InvalidFile);
    refuse("[0, 1, {distance", "[0, 0, {distance", Code::InvalidNumber);
    refuse("  L1:", "  L2:", Code::InvalidFile);
    let empty = "levels:\n  L1:\n    walls: []\n";
    refused(&[file("a", empty)], &Options::default(), Code::InvalidFile);
    refused(&[file("a", "levels: {}\nwalls: []\n")], &Options::default(), Code::InvalidFile);
    for (depth, code) in [(100, Code::WorldTooLarge), (20_000, Code::InvalidFile)] {
        let deep = format!("{BUILDING}extra: {}{}\n", "[".repeat(depth), "]".repeat(depth));
        refused(&[file("a", &deep)], &Options::default(), code);
    }
    let laughs = "a: &a [x, x]\nb: &b [*a, *a]\nlevels: *b\nwalls: [*b, *b]\n";
    refused(&[file("a", laughs)], &Options::default(), Code::InvalidFile);
}

#[test]
fn all_of_a_building_is_moved_if_a_place_is_far() {
    let far = "coordinate_system: cartesian_meters
levels:
  L1:
    vertices: [[0, 0, 0, \"\"], [10, 0, 0, \"\"], [1, 1, 0, a], [300000, 1, 0, z]]
    walls: [[0, 1, {}]]
";
    let world = one("far.building.yaml", far);
    let [x, _] = world.report.offset;
    assert_eq!(x, 150_000.0);
    let (start, wall) = (&world.scenario.queries()[0].start, world.scenario.world().obstacles[0].aabb());
    assert_eq!((start[0], wall.min.x, wall.max.x), (1.0 - x, -0.05 - x, 10.05 - x));
}
