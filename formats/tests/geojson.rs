//! GeoJSON: what becomes an obstacle, where degrees are, and what is left out.

use crate::files::{file, free, one, refused};
use planarium::geometry::Point;
use planarium::scenario::Obstacle;
use planarium_formats::{Code, Coordinates, Filter, Format, Options, Place, World, is_world, read};

/// Features with a property `type`: a room with a wall, a door and a window, in metres.
pub const HOUSE: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"type": "wall", "id": 1},
     "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [8, 0], [8, 1], [0, 1], [0, 0]]]}},
    {"type": "Feature", "properties": {"type": "door", "id": 2},
     "geometry": {"type": "Polygon", "coordinates": [[[8, 0], [9, 0], [9, 1], [8, 1], [8, 0]]]}},
    {"type": "Feature", "properties": {"type": "window", "id": 3},
     "geometry": {"type": "LineString", "coordinates": [[9, 0.5, 2.5], [12, 0.5, 2.5]]}},
    {"type": "Feature", "properties": {"type": "room", "id": 4},
     "geometry": {"type": "Polygon", "coordinates": [[[0, 1], [12, 1], [12, 9], [0, 9]]]}}]}"#;

#[track_caller]
fn with(text: &str, options: Options) -> World {
    read(&[file("a.geojson", text)], &options).unwrap_or_else(|error| panic!("{error}"))
}

/// A geometry as a document, in metres.
#[track_caller]
fn geometry(kind: &str, coordinates: &str) -> World {
    let text = format!(r#"{{"type": "{kind}", "coordinates": {coordinates}}}"#);
    with(&text, Options { coordinates: Coordinates::Metres, ..Options::default() })
}

fn layers(names: &[&str]) -> Options {
    Options { layers: Some(names.iter().map(|&name| name.to_owned()).collect()), ..Options::default() }
}

#[test]
fn layers_are_properties_and_doors_are_open() {
    assert!(is_world(HOUSE.as_bytes()));
    let world = one("house.geojson", HOUSE);
    let report = &world.report;
    assert_eq!(report.format, Format::GeoJson);
    let obstacles = report.obstacles;
    assert_eq!((obstacles.polygons, obstacles.walls, obstacles.discs, obstacles.vertices), (1, 1, 0, 6));
    let read: Vec<_> =
        report.layers.iter().map(|layer| (&*layer.name, layer.shapes, layer.omitted.as_deref())).collect();
    assert_eq!(
        read,
        [
            ("wall", 1, None),
            ("door", 1, Some("doors are open")),
            ("window", 1, None),
            ("room", 1, Some("floors are no obstacles"))
        ]
    );
    assert_eq!(report.dropped.iter().map(|dropped| dropped.count).collect::<Vec<_>>(), [2]);
    assert!(free(&world, [8.5, 0.9]) && !free(&world, [4.0, 0.5]) && !free(&world, [10.0, 0.5]));
    assert!(free(&world, [10.0, 0.4999]) && free(&world, [6.0, 5.0]));
    let text = report.to_string();
    for words in
        ["read geojson", "\"door\" (1, doors are open)", "1 walls", "x and y of 1 m", "2 positions have a height"]
    {
        assert!(text.contains(words), "{words}: {text}");
    }
    // Chosen layers are read whatever they are, with walls of a thickness.
    let options = Options { wall_thickness: Some(0.5), ..layers(&["door", "window"]) };
    let chosen = with(HOUSE, options);
    assert!(!free(&chosen, [8.5, 0.9]) && !free(&chosen, [10.0, 0.7]) && free(&chosen, [10.0, 0.76]));
    assert!(free(&chosen, [4.0, 0.5]));
    let unknown = refused(&[file("a", HOUSE)], &layers(&["doors"]), Code::InvalidOption);
    assert!(unknown.message().contains("\"window\""), "{unknown}");
    // Rooms alone are what is there.
    let room = HOUSE.replace("\"wall\"", "\"room\"").replace("\"window\"", "\"room\"");
    assert_eq!(one("rooms.geojson", room).report.obstacles.polygons, 2);
}

#[test]
fn filters_choose_features_by_properties() {
    let filters = |texts: &[&str]| {
        let filters = texts.iter().map(|text| text.parse::<Filter>().expect("a filter")).collect();
        with(HOUSE, Options { filters, ..Options::default() }).report
    };
    assert_eq!(filters(&["type=wall"]).obstacles.polygons, 1);
    assert_eq!(filters(&["type=wall", "type=door"]).obstacles.polygons, 2);
    assert_eq!(filters(&["type=wall", "id=1", "id=2"]).obstacles.polygons, 1);
    let without = filters(&["type!=room", "id!=2"]);
    assert_eq!((without.obstacles.polygons, without.obstacles.walls), (1, 1));
    assert_eq!(without.dropped[0].what, "features that the filters leave out");
    assert!("type".parse::<Filter>().is_err());
}

#[test]
fn every_geometry_is_read() {
    let point = geometry("Point", "[1, 2]");
    assert_eq!(point.report.obstacles.discs, 1);
    assert!(!free(&point, [1.0, 2.0]) && free(&point, [1.001, 2.0]));
    assert_eq!(geometry("MultiPoint", "[[1, 2], [3, 4]]").report.obstacles.discs, 2);
    let line = geometry("LineString", "[[0, 0], [4, 0], [4, 4]]");
    assert!(!free(&line, [4.0, 1.5]) && free(&line, [2.0, 2.0]));
    assert_eq!(geometry("LineString", "[[1, 1], [1, 1]]").report.obstacles.discs, 1);
    assert_eq!(geometry("MultiLineString", "[[[0, 0], [4, 0]], [[1, 1], [2, 2]]]").report.obstacles.walls, 2);
    let square = "[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [3, 1], [3, 3], [1, 3], [1, 1]]";
    let options = Options { coordinates: Coordinates::Metres, walkable: Some(false), ..Options::default() };
    let text = format!(r#"{{"type": "Polygon", "coordinates": [{square}]}}"#);
    let ring = with(&text, options);
    assert_eq!((ring.report.obstacles.polygons, ring.report.obstacles.holes), (1, 1));
    assert!(free(&ring, [2.0, 2.0]) && !free(&ring, [0.5, 2.0]) && !free(&ring, [1.0, 2.0]));
    let Obstacle::PolygonWithHoles(polygon) = &ring.scenario.world().obstacles[0] else { panic!("a hole") };
    assert_eq!(polygon.outline().vertices()[2], Point::new(4.0, 4.0), "corners are those of the file");
    let two = geometry("MultiPolygon", &format!("[[{square}], [[[5, 0], [6, 0], [6, 1]]]]"));
    assert_eq!(two.report.obstacles.polygons, 2);
    assert!(two.report.notes.iter().any(|note| note.starts_with("1 rings are not closed")), "{}", two.report);
    let all = r#"{"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [0, 0]},
        {"type": "Curve", "coordinates": []}, {"type": "LineString", "coordinates": []},
        {"type": "GeometryCollection", "geometries": [{"type": "LineString", "coordinates": [[0, 0], [2, 2]]}]}]}"#;
    let all = one("all.geojson", all);
    assert_eq!((all.report.obstacles.discs, all.report.obstacles.walls), (1, 1));
    let dropped: Vec<_> = all.report.dropped.iter().map(|dropped| (&*dropped.what, dropped.count)).collect();
    assert_eq!(dropped, [("geometries of the unknown type \"Curve\"", 1), ("geometries without coordinates", 1)]);
}

#[test]
fn one_polygon_with_holes_is_where_the_robot_may_be() {
    let text = r#"{"type": "Feature", "properties": null, "geometry": {"type": "Polygon", "coordinates":
        [[[0, 0], [40, 0], [40, 40], [0, 40]], [[10, 10], [30, 10], [30, 30], [10, 30]]]}}"#;
    let world = one("floor.geojson", text);
    assert_eq!(world.scenario.world().bounds.expect("bounds").max, Point::new(42.0, 42.0));
    assert!(free(&world, [5.0, 5.0]) && !free(&world, [20.0, 20.0]) && !free(&world, [41.0, 5.0]));
    assert_eq!(world.report.grown, 0.0);
    assert!(world.report.to_string().contains("areas are where the robot may be"), "{}", world.report);
    let filled = with(text, Options { walkable: Some(false), ..Options::default() });
    assert!(!free(&filled, [5.0, 5.0]) && free(&filled, [20.0, 20.0]));
    // Rooms with a common side, and a line in one of them.
    let rooms = r#"{"type": "GeometryCollection", "geometries": [
        {"type": "Polygon", "coordinates": [[[0, 0], [40, 0], [40, 40], [0, 40]]]},
        {"type": "Polygon", "coordinates": [[[40, 10], [80, 10], [80, 30], [40, 30]]]},
        {"type": "LineString", "coordinates": [[60, 10], [60, 20]]}]}"#;
    let rooms = with(rooms, Options { walkable: Some(true), ..Options::default() });
    assert!(free(&rooms, [40.0, 20.0]) && !free(&rooms, [40.0, 5.0]) && !free(&rooms, [60.0, 15.0]));
    assert!(rooms.report.grown > 0.0 && rooms.report.grown < 1e-9, "{}", rooms.report);
}

#[test]
fn degrees_are_metres_in_a_plane_and_the_way_back_is_told() {
    let text = r#"{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {}, "geometry":
        {"type": "Polygon", "coordinates": [[[13.0, 52.0], [13.001, 52.0], [13.001, 52.001], [13.0, 52.001]]]}}]}"#;
    let query = Options {
        start: Some(vec![13.0005, 52.00101]),
        goal: Some(vec![13.0005, 51.99999, 1.0]),
        robot: planarium_formats::RobotChoice::rectangle(0.5, 0.5),
        ..Options::default()
    };
    let world = with(text, query);
    let plane = world.report.plane.clone().expect("a plane");
    assert!((plane.origin[0] - 13.0005).abs() + (plane.origin[1] - 52.0005).abs() < 1e-12, "{plane:?}");
    // Metres per degree at 52.0005 degrees, by the series of the parallel's and the meridian's length
    // (National Geospatial-Intelligence Agency).
    let latitude = 52.0005_f64.to_radians();
    let north =
        111_132.92 - 559.82 * (2.0 * latitude).cos() + 1.175 * (4.0 * latitude).cos() - 0.0023 * (6.0 * latitude).cos();
    let east = 111_412.84 * latitude.cos() - 93.5 * (3.0 * latitude).cos() + 0.118 * (5.0 * latitude).cos();
    assert!((plane.scale[0] - east).abs() < 0.1 && (plane.scale[1] - north).abs() < 0.1, "{plane:?}");
    assert!(plane.error.is_some_and(|error| error > 1e-6 && error < 0.01), "{plane:?}");
    let Obstacle::Polygon(polygon) = &world.scenario.world().obstacles[0] else { panic!("a polygon") };
    let back = |p: Point| [0, 1].map(|i| plane.origin[i] + (p[i] + world.report.offset[i]) / plane.scale[i]);
    assert!(polygon.vertices().iter().any(|&p| {
        let [x, y] = back(p);
        (x - 13.001).abs() < 1e-12 && (y - 52.001).abs() < 1e-12
    }));
    let start = &world.scenario.queries()[0].start;
    assert!(start[0].abs() < 1e-6 && (start[1] - 0.00051 * plane.scale[1]).abs() < 1e-6, "{start:?}");
    assert!(world.report.to_string().contains("start and goal are, too"));

    // What the file or the option says is more than what is likely.
    let projected = text.replacen('{', r#"{"crs": {"type": "name", "properties": {"name": "EPSG:25833"}},"#, 1);
    assert_eq!(one("a", &projected).report.plane, None);
    let wide = text.replace("13.001", "53.001");
    assert_eq!(one("a", &wide).report.plane, None);
    let crs =
        wide.replacen('{', r#"{"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}},"#, 1);
    let error = refused(&[file("a", &crs)], &Options::default(), Code::WorldTooLarge);
    assert!(error.message().contains("m large"), "{error}");
    let says = |crs: &str| with(&text.replacen('{', &format!(r#"{{"crs": {crs},"#), 1), Options::default());
    for degrees in [
        r#"{"type": "name", "properties": {"name": "epsg:4326"}}"#,
        r#"{"type": "EPSG", "properties": {"code": 4326}}"#,
        r#""EPSG:4326""#,
        r#""urn:ogc:def:crs:EPSG::4326""#,
        r#""WGS 84""#,
        "4326",
        "null",
        "[]",
        r#"{"type": "link", "properties": {"href": "http://example.org"}}"#,
    ] {
        assert_eq!(says(degrees).report.plane.as_ref(), Some(&plane), "{degrees}");
    }
    for metres in [r#""EPSG:25833""#, r#""WGS 84 / UTM zone 33N""#, "25833", r#"{"properties": {"code": 25833}}"#] {
        assert_eq!(says(metres).report.plane, None, "{metres}");
    }
    let far = text.replace("13.", "4500013.").replace("52.", "-2000052.");
    let far = one("a", &far);
    assert_eq!((far.report.plane.as_ref(), far.report.offset), (None, [4_500_013.0, -2_000_052.0]));
    let degrees = Options { coordinates: Coordinates::Degrees, ..Options::default() };
    refused(&[file("a", &text.replace("13.", "513."))], &degrees, Code::InvalidNumber);
    let scaled = Options { scale: Some(2.0), ..degrees };
    refused(&[file("a", text)], &scaled, Code::InvalidOption);
    let metres = Options { coordinates: Coordinates::Metres, ..scaled };
    assert_eq!(with(text, metres).report.plane.map(|plane| (plane.scale, plane.error)), Some(([2.0; 2], None)));
}

#[test]
fn what_is_no_geojson_is_refused_with_its_place() {
    let refuse = |text: &str, code| refused(&[file("a", text)], &Options::default(), code);
    let truncated = refuse(&HOUSE[..400], Code::Truncated);
    assert!(matches!(truncated.place(), Some(Place::Line(_))), "{truncated}");
    let line = refuse(&HOUSE.replace("[9, 0.5, 2.5]", "[9, NaN]"), Code::InvalidFile);
    assert_eq!(line.place(), Some(&Place::Line(7)), "{line}");
    refuse(&HOUSE.replace("[9, 0.5, 2.5]", "[9, 1e400]"), Code::InvalidNumber);
    refuse(&HOUSE.replace("[9, 0.5, 2.5]", "[9]"), Code::InvalidFile);
    refuse(&HOUSE.replace("[9, 0.5, 2.5]", "[9, [1]]"), Code::InvalidFile);
    refuse(&HOUSE.replace("[9, 0.5, 2.5]", "[[9, 1], 3]"), Code::InvalidFile);
    refuse(&HOUSE.replace("[9, 0.5, 2.5]", "\"9\""), Code::InvalidFile);
    refuse(&HOUSE.replace("[9, 0.5, 2.5]", "[9, 1e300]"), Code::WorldTooLarge);
    let feature = refuse(&HOUSE.replace("[9, 0.5, 2.5], [12, 0.5, 2.5]", "9, 1"), Code::InvalidFile);
    assert_eq!(feature.place(), Some(&Place::Element("feature 2".to_owned())), "{feature}");
    refuse(r#"{"type": "FeatureCollection", "features": []}"#, Code::InvalidFile);
    refuse(r#"{"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": null}]}"#, Code::InvalidFile);
    refuse(r#"{"type": "Topology", "objects": {}}"#, Code::UnknownWorld);
    refuse(r#"{"type": "FeatureCollection", "features": [], "type": "FeatureCollection"}"#, Code::InvalidFile);
    refuse(r#"{"format": "another", "type": "FeatureCollection", "features": []}"#, Code::UnknownWorld);
    refuse(r#"["Point", null]"#, Code::UnknownWorld);
    let deep = format!(r#"{{"type": "Polygon", "coordinates": {}{}}}"#, "[".repeat(100_000), "]".repeat(100_000));
    assert!(refuse(&deep, Code::InvalidFile).message().contains("recursion"));
    let points = vec!["[1, 2]"; 1_000_001].join(",");
    refuse(&format!(r#"{{"type": "LineString", "coordinates": [{points}]}}"#), Code::WorldTooLarge);
}
