//! Well-known text.

use crate::files::{file, free, one, refused};
use planarium_formats::{Code, Format, Options, Place, is_world, read};

pub const ROOM: &str =
    "GEOMETRYCOLLECTION (POLYGON ((0 0, 40 0, 40 40, 0 40, 0 0), (10 10, 30 10, 30 30, 10 30, 10 10)))";

#[test]
fn a_walkable_area_with_holes_is_free() {
    assert!(is_world(ROOM.as_bytes()));
    let world = one("room.wkt", ROOM);
    assert_eq!((world.report.format, world.report.obstacles.holes), (Format::Wkt, 1));
    assert!(free(&world, [5.0, 20.0]) && !free(&world, [20.0, 20.0]) && !free(&world, [-1.0, 5.0]));
    let filled = Options { walkable: Some(false), ..Options::default() };
    let filled = read(&[file("room.wkt", ROOM)], &filled).expect("a world");
    assert!(!free(&filled, [5.0, 20.0]) && free(&filled, [20.0, 20.0]));
}

#[test]
fn every_geometry_is_read_and_several_in_a_file() {
    let text = "point z (1 2 3)\nMULTIPOINT ((5 5), 6 6, EMPTY);\nLINESTRING M (0 0 7, 3 0 7)\n\
        LinearRing(0 1, 2 1, 2 2, 0 1)\nMULTILINESTRINGZM ((0 3 1 2, 3 3 1 2), EMPTY, (0 4 0 0, 3 4 0 0))\n\
        POLYGON EMPTY\nTRIANGLE ((10 0, 12 0, 10 2, 10 0)), MULTIPOLYGON (((20 0, 22 0, 20 2)), EMPTY, ((30 0, 32 0, 30 2, 30 0)))\n\
        GEOMETRYCOLLECTION (POINT (7 7), GEOMETRYCOLLECTION EMPTY)\n";
    let world = one("all.wkt", text);
    let obstacles = world.report.obstacles;
    assert_eq!((obstacles.discs, obstacles.walls, obstacles.polygons), (4, 4, 3), "{}", world.report);
    assert!(!free(&world, [6.0, 6.0]) && !free(&world, [1.5, 3.0]) && !free(&world, [20.5, 0.5]));
    let words = world.report.to_string();
    for words_of_it in
        ["dropped: 5 empty geometries", "1 rings are not closed", "7 positions have Z or M", "9 geometries"]
    {
        assert!(words.contains(words_of_it), "{words_of_it}: {words}");
    }
    let degrees = one("d.wkt", "SRID=4326;LINESTRING (13.0 52.0, 13.001 52.001)");
    assert!(degrees.report.plane.is_some_and(|plane| plane.error.is_some()));
    assert_eq!(one("d.wkt", "SRID=25833;LINESTRING (13.0 52.0, 13.001 52.001)").report.plane, None);
}

#[test]
fn what_is_no_wkt_is_refused_with_its_place() {
    let refuse = |text: &str, code| refused(&[file("a.wkt", text)], &Options::default(), code);
    for end in [18, 20, 29, 33, 60, ROOM.len() - 1] {
        let cut = refuse(&ROOM[..end], Code::Truncated);
        assert!(matches!(cut.place(), Some(Place::Byte(_))), "{cut}");
    }
    assert_eq!(refuse("POINT (1 x)", Code::InvalidNumber).place(), Some(&Place::Byte(9)));
    refuse("POINT (1 nan)", Code::InvalidNumber);
    refuse("POINT (1 1e999)", Code::InvalidNumber);
    refuse("LINESTRING (1 1e300, 0 0)", Code::WorldTooLarge);
    refuse("LINESTRING (1 1e308, -1e308 -1.7e308)", Code::WorldTooLarge);
    refuse("POINT (1 2 3 4 5)", Code::InvalidFile);
    refuse("POLYGON (0 0, 1 0, 1 1)", Code::InvalidFile);
    refuse("POINT (1 2) CIRCLE", Code::UnsupportedFeature);
    refuse("CURVEPOLYGON (CIRCULARSTRING (0 0, 1 1, 2 0))", Code::UnsupportedFeature);
    refuse("POINT (1 2) SQUARE (1 2)", Code::InvalidFile);
    refuse("POLYGON EMPTY", Code::InvalidFile);
    let deep = format!("{}POINT (1 2){}", "GEOMETRYCOLLECTION (".repeat(100_000), ")".repeat(100_000));
    refuse(&deep, Code::WorldTooLarge);
    refuse(&format!("LINESTRING ({}1 1)", "1 2, ".repeat(1_000_001)), Code::WorldTooLarge);
}

#[test]
fn empty_parts_are_nowhere() {
    let world = one("a.wkt", "MULTIPOLYGON (((2000000 5000000, 2000010 5000000, 2000010 5000010)), (EMPTY))");
    let [[left, bottom], [right, top]] = world.report.bounds;
    assert!(right - left < 12.0 && top - bottom < 12.0, "{:?}", world.report.bounds);
    assert_eq!(world.report.obstacles.polygons, 1);
}
