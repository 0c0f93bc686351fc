//! DXF: where entities are, what is read of them, and what is counted.

use crate::files::{dropped, file, free, refused};
use planarium_formats::{Code, Options, World, read};

/// Group codes and values on lines of their own.
pub fn groups(words: &str) -> String {
    words.split_whitespace().map(|word| format!("{}\n", word.replace('_', " "))).collect()
}

/// A file with a header, layers, blocks and entities, as words.
pub fn document(header: &str, layers: &str, blocks: &str, entities: &str) -> String {
    let section = |name: &str, body: &str| format!("0 SECTION 2 {name} {body} 0 ENDSEC ");
    let tables = format!("0 TABLE 2 LAYER {layers} 0 ENDTAB");
    let all = [
        section("HEADER", header),
        section("TABLES", &tables),
        section("BLOCKS", blocks),
        section("ENTITIES", entities),
        "0 EOF".to_owned(),
    ];
    groups(&all.concat())
}

fn entities(entities: &str) -> String {
    document("", "", "", entities)
}

#[track_caller]
fn with(text: &str, options: &Options) -> World {
    read(&[file("a.dxf", text)], options).unwrap_or_else(|error| panic!("{error}"))
}

/// Entities of every kind, in a block as well.
pub fn every_kind() -> String {
    let kinds = "0 LINE 8 a 10 0 20 0 11 10 21 0 0 ARC 8 a 10 20 20 0 40 5 50 270 51 90
        0 CIRCLE 8 b 10 40 20 0 40 5 210 0 220 0 230 -1 0 ELLIPSE 8 a 10 60 20 0 11 6 21 0 40 0.5 41 0 42 6.2
        0 LWPOLYLINE 8 a 90 3 70 1 43 0.5 10 0 20 20 42 0.3 10 10 20 20 42 1 10 10 20 30
        0 POLYLINE 8 a 66 1 70 0 40 1 41 2 0 VERTEX 10 20 20 20 42 -2 0 VERTEX 10 30 20 20 0 SEQEND
        0 SPLINE 8 a 70 8 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 2 41 1 10 40 20 20 10 40 20 30 10 50 20 30
        0 SOLID 8 a 10 0 20 40 11 2 21 40 12 0 22 42 13 2 23 42 0 TEXT 8 a 1 b
        0 HATCH 8 a 91 2 92 3 72 1 73 1 93 3 10 0 20 50 42 0.2 10 9 20 50 42 0 10 9 20 59 42 0 97 0
          92 1 93 2 72 2 10 5 20 52 40 1 50 0 51 180 73 1 72 1 10 4 20 52 11 6 21 52 97 1 330 F 75 0";
    let blocks = format!("0 BLOCK 2 x 70 0 10 1 20 2 {kinds} 0 ENDBLK");
    let layers = "0 LAYER 2 a 70 0 62 7 0 LAYER 2 b 70 0 62 -7";
    document("9 $INSUNITS 70 5", layers, &blocks, &format!("{kinds} 0 INSERT 8 b 2 x 10 90 20 0 41 2 50 30 70 2 44 99"))
}

/// Lines of 0.2 m.
fn thick() -> Options {
    Options { wall_thickness: Some(0.2), tolerance: Some(1e-4), ..Options::default() }
}

fn filled() -> Options {
    Options { fill: vec!["*".to_owned()], tolerance: Some(1e-4), ..Options::default() }
}

#[track_caller]
fn places(world: &World, wanted: &[(f64, f64, char)]) {
    for &(x, y, what) in wanted {
        assert_eq!(free(world, [x, y]), what == '.', "{x}, {y}: {}", world.scenario.to_json_string());
    }
}

#[test]
fn lines_and_curves_are_walls() {
    let world = with(
        &entities(
            "0 LINE 8 walls 10 0 20 0 11 10 21 0
             0 ARC 8 walls 10 20 20 0 40 5 50 270 51 90
             0 CIRCLE 8 walls 10 40 20 0 40 5
             0 ELLIPSE 8 walls 10 60 20 0 11 6 21 0 40 0.5 41 0 42 6.283185307179586
             0 LWPOLYLINE 8 walls 90 3 70 0 10 0 20 20 10 10 20 20 42 1 10 10 20 30
             0 POLYLINE 8 walls 66 1 70 1 0 VERTEX 10 20 20 20 0 VERTEX 10 30 20 20 0 VERTEX 10 30 20 30 0 SEQEND
             0 SPLINE 8 walls 70 8 71 3 72 8 73 4 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1
               10 40 20 20 10 40 20 30 10 50 20 30 10 50 20 20",
        ),
        &thick(),
    );
    places(
        &world,
        &[
            (5.0, 0.09, '#'),
            (5.0, 0.11, '.'),
            (25.0, 0.0, '#'),
            (15.0, 0.0, '.'),
            (24.8, 0.0, '.'),
            (40.0, 5.09, '#'),
            (35.0, 0.0, '#'),
            (40.0, 0.0, '.'),
            (60.0, 3.0, '#'),
            (66.0, 0.0, '#'),
            (60.0, 0.0, '.'),
            (15.0, 25.0, '#'),
            (10.0, 25.0, '.'),
            (25.0, 25.0, '#'),
            (28.0, 22.0, '.'),
            // The middle of the spline.
            (45.0, 27.5, '#'),
            (45.0, 27.0, '.'),
        ],
    );
    assert_eq!((world.report.obstacles.walls, world.report.obstacles.polygons), (7, 0));
    assert!(world.report.grown <= 1e-4 && world.report.grown > 0.0);
    let notes = world.report.notes.join("\n");
    assert!(notes.contains("3 closed lines are walls") && notes.contains("a unit of the drawing is 1 m"), "{notes}");
    let thin = with(&entities("0 LINE 8 walls 10 0 20 0 11 10 21 0"), &Options::default());
    assert_eq!(thin.report.obstacles.walls, 1);
    places(&thin, &[(5.0, 0.0, '#'), (5.0, 1e-6, '.')]);
}

#[test]
fn closed_lines_are_filled_where_the_option_says_so() {
    let text = entities(
        "0 CIRCLE 8 columns 10 0 20 0 40 1
         0 LWPOLYLINE 8 columns 90 2 70 1 10 10 20 0 42 1 10 12 20 0 42 1
         0 LWPOLYLINE 8 walls 90 4 70 1 10 20 20 0 10 30 20 0 10 30 20 10 10 20 20 10
         0 LWPOLYLINE 8 columns 90 3 70 0 10 40 20 0 10 44 20 0 10 44 20 4",
    );
    let outlines = with(&text, &thick());
    places(&outlines, &[(0.0, 0.0, '.'), (11.0, 0.0, '.'), (25.0, 5.0, '.'), (11.0, 1.0, '#')]);
    let all = with(&text, &filled());
    places(&all, &[(0.0, 0.0, '#'), (11.0, 0.0, '#'), (11.0, 0.99, '#'), (25.0, 5.0, '#'), (43.0, 1.0, '.')]);
    assert_eq!(all.report.obstacles.discs, 1);
    let some = with(&text, &Options { fill: vec!["columns".to_owned()], ..thick() });
    places(&some, &[(0.0, 0.0, '#'), (25.0, 5.0, '.')]);
}

#[test]
fn bulges_and_splines_are_contained_by_polygons() {
    for bulge in [0.1, -0.3, 0.5, 1.0, 3.0, 50.0] {
        let text = entities(&format!("0 LWPOLYLINE 8 a 90 2 70 1 10 0 20 0 42 {bulge} 10 10 20 0"));
        let world = with(&text, &Options { tolerance: Some(1e-3), ..filled() });
        // The circle through the ends and the apex, which is right of the way from one to the other.
        let radius = 5.0 * (1.0 + bulge * bulge) / (2.0f64 * bulge).abs();
        let apex = -5.0 * bulge;
        let center = apex + radius * bulge.signum();
        for i in 0..2000 {
            let angle = f64::from(i) * std::f64::consts::PI / 1000.0;
            let (x, y) = (5.0 + radius * angle.cos(), center + radius * angle.sin());
            if y * bulge < -1e-9 {
                let at =
                    |by: f64| free(&world, [5.0 + (radius + by) * angle.cos(), center + (radius + by) * angle.sin()]);
                assert!(!at(-1e-9) && at(2.1e-3), "{bulge}: {x}, {y}");
            }
        }
    }
    // A circle as a rational spline of degree 2.
    let half = 0.5f64.sqrt();
    let points = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let controls: String = points.iter().map(|(x, y)| format!("10 {x} 20 {y} ")).collect();
    let weights: String = (0..9).map(|i| format!("41 {} ", if i % 2 == 1 { half } else { 1.0 })).collect();
    let knots: String = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4].iter().map(|knot| format!("40 {knot} ")).collect();
    let spline = |degree: i32, controls: &str| {
        entities(&format!("0 SPLINE 8 a 70 5 71 {degree} 72 12 73 9 {knots} {weights} {controls}"))
    };
    let world = with(&spline(2, &controls), &filled());
    for i in 0..2000 {
        let angle = f64::from(i) * std::f64::consts::PI / 1000.0;
        let at = |radius: f64| free(&world, [radius * angle.cos(), radius * angle.sin()]);
        assert!(!at(1.0 - 1e-9) && at(1.0 + 2.1e-4), "{angle}");
    }
    for wrong in [spline(3, &controls), spline(2, "10 0 20 0"), spline(0, &controls)] {
        refused(&[file("a.dxf", &wrong)], &Options::default(), Code::InvalidFile);
    }
    let through =
        with(&entities("0 SPLINE 8 a 71 3 74 2 11 0 21 0 11 1 21 1 0 LINE 8 a 10 0 20 0 11 1 21 0"), &thick());
    assert_eq!(dropped(&through, "without control points"), 1);
}

#[test]
fn blocks_are_where_they_are_inserted() {
    let blocks =
        "0 BLOCK 2 chair 70 0 10 1 20 1 0 LINE 8 0 10 1 20 1 11 3 21 1 0 LINE 8 legs 10 1 20 1 11 1 21 2 0 ENDBLK
         0 BLOCK 2 Table 70 0 10 0 20 0 0 INSERT 8 0 2 chair 10 0 20 5 0 ENDBLK";
    let text = document(
        "",
        "",
        blocks,
        "0 INSERT 8 room 2 CHAIR 10 10 20 10
         0 INSERT 8 room 2 chair 10 20 20 10 41 2 42 3 50 90
         0 INSERT 8 room 2 table 10 30 20 10 50 180
         0 INSERT 8 room 2 chair 10 40 20 10 70 2 71 3 44 10 45 5
         0 INSERT 8 room 2 chair 10 -70 20 10 210 0 220 0 230 -1
         0 INSERT 8 room 2 gone 10 0 20 0",
    );
    let world = with(&text, &thick());
    places(
        &world,
        &[
            (11.9, 10.0, '#'),
            (12.2, 10.0, '.'),
            (10.0, 10.9, '#'),
            (20.0, 13.9, '#'),
            (17.1, 10.0, '#'),
            (28.1, 5.0, '#'),
            (30.0, 4.1, '#'),
            (41.0, 10.0, '#'),
            (51.0, 20.0, '#'),
            (41.0, 25.0, '.'),
            // Mirrored: x goes the other way.
            (69.0, 10.0, '#'),
            (71.0, 10.0, '.'),
        ],
    );
    assert_eq!(world.report.obstacles.walls, 2 * (1 + 1 + 1 + 6 + 1));
    assert_eq!(dropped(&world, "blocks that are not there"), 1);
    // What is on layer 0 in a block is on the layer of the insertion.
    let layers: Vec<(String, usize)> =
        world.report.layers.iter().map(|layer| (layer.name.clone(), layer.shapes)).collect();
    assert_eq!(layers, [("room".to_owned(), 10), ("legs".to_owned(), 10)]);
    for (blocks, code) in [
        ("0 BLOCK 2 a 0 INSERT 2 a 0 ENDBLK", Code::InvalidFile),
        ("0 BLOCK 2 a 0 INSERT 2 b 0 ENDBLK 0 BLOCK 2 b 0 INSERT 2 a 0 ENDBLK", Code::InvalidFile),
    ] {
        let error = refused(&[file("a.dxf", &document("", "", blocks, "0 INSERT 2 a"))], &Options::default(), code);
        assert!(error.message().contains("in itself"), "{error}");
    }
}

#[test]
fn turned_planes_are_seen_from_above() {
    let world = with(
        &entities(
            "0 ARC 8 a 10 -10 20 0 40 5 50 0 51 90 210 0 220 0 230 -1
             0 LWPOLYLINE 8 a 90 2 70 0 10 -20 20 0 42 1 10 -20 20 10 210 0 220 0 230 -1
             0 SOLID 8 a 10 -30 20 0 11 -32 21 0 12 -30 22 2 13 -32 23 2 210 0 220 0 230 -1
             0 CIRCLE 8 a 10 0 20 0 40 3 210 1 220 0 230 0
             0 3DFACE 8 a 10 40 20 0 30 5 11 44 21 0 31 5 12 44 22 4 32 5 13 40 23 4 33 9",
        ),
        &thick(),
    );
    places(
        &world,
        &[
            (10.0 - 5.0 * 0.6, 4.0, '#'),
            (10.0 + 5.0 * 0.6, 4.0, '.'),
            // Counter-clockwise, seen from below: right of the way up is left.
            (15.0, 5.0, '#'),
            (25.0, 5.0, '.'),
            (31.0, 1.0, '#'),
            (31.9, 1.9, '#'),
            (29.0, 1.0, '.'),
            // A circle on its edge is a line along y.
            (0.0, 2.9, '#'),
            (0.3, 0.0, '.'),
            (42.0, 2.0, '#'),
        ],
    );
    refused(
        &[file("a.dxf", &entities("0 CIRCLE 8 a 10 0 20 0 40 3 210 0 220 0 230 0"))],
        &Options::default(),
        Code::InvalidNumber,
    );
}

#[test]
fn hatches_are_areas() {
    let square = |at: i32, size: i32| {
        format!("92 3 72 0 73 1 93 4 10 {at} 20 {at} 10 {0} 20 {at} 10 {0} 20 {0} 10 {at} 20 {0} 97 0", at + size)
    };
    let hatch = |style: i32, loops: &[String]| {
        let loops = format!("91 {} {}", loops.len(), loops.join(" "));
        entities(&format!("0 HATCH 8 a 10 0 20 0 30 0 2 SOLID 70 1 71 0 {loops} 75 {style} 76 1 98 1 10 0 20 0"))
    };
    let island = [square(0, 10), square(3, 4)];
    places(&with(&hatch(0, &island), &thick()), &[(1.0, 1.0, '#'), (5.0, 5.0, '.')]);
    places(&with(&hatch(2, &island), &thick()), &[(1.0, 1.0, '#'), (5.0, 5.0, '#')]);
    let edges = "92 1 93 3 72 1 10 0 20 0 11 10 21 0 72 2 10 5 20 0 40 5 50 0 51 90 73 1
         72 1 10 5 20 5 11 0 21 0 97 1 330 1F";
    let world = with(&hatch(0, &[edges.to_owned()]), &thick());
    places(&world, &[(8.0, 3.9, '#'), (2.0, 3.0, '.'), (5.0, 1.0, '#'), (9.0, 3.5, '.')]);
    let clockwise = "92 1 93 2 72 2 10 0 20 0 40 5 50 180 51 360 73 0 72 1 10 5 20 0 11 -5 21 0 97 0";
    places(&with(&hatch(0, &[clockwise.to_owned()]), &thick()), &[(0.0, 4.9, '#'), (0.0, -1.0, '.')]);
    // A spline along three sides: with the count of points that it goes through, as from R2010 on, or without; with the objects
    // that it was made from, or without; with weights behind their points, or behind all.
    let knots = "40 0 40 0 40 1 40 2 40 3 40 3";
    let spline = |flag: i32, points: &str, rest: &str| {
        format!("92 1 93 2 72 4 94 1 73 {flag} 74 0 95 6 96 4 {knots} {points} {rest}")
    };
    let line = "72 1 10 0 20 10 11 0 21 0";
    let plain = "10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";
    let weighted = "10 0 20 0 42 1 10 10 20 0 42 2 10 10 20 10 42 1 10 0 20 10 42 1";
    for (flag, points) in [(0, plain), (1, weighted), (1, &format!("{plain} 42 1 42 2 42 1 42 1"))] {
        for fit in ["", "97 0", "97 2 11 0 21 0 11 10 21 0 12 1 22 0 13 -1 23 0"] {
            for sources in ["", "97 0", "97 2 330 1F 330 20"] {
                let last = format!("92 1 93 2 {line} {} {sources}", &spline(flag, points, fit)["92 1 93 2 ".len()..]);
                for edges in [last, spline(flag, points, &format!("{fit} {line} {sources}"))] {
                    let world = with(&hatch(0, &[edges.clone(), square(4, 2)]), &thick());
                    places(&world, &[(1.0, 1.0, '#'), (9.0, 9.0, '#'), (5.0, 5.0, '.'), (-1.0, 5.0, '.')]);
                }
            }
        }
    }
    refused(
        &[file("a.dxf", &hatch(0, &["92 3 72 0 73 1 93 400000000 10 0".to_owned()]))],
        &Options::default(),
        Code::Truncated,
    );
}

#[test]
fn wide_polylines_are_walls_of_their_width() {
    let world = with(
        &entities(
            "0 LWPOLYLINE 8 a 90 3 70 0 43 1 10 0 20 0 10 10 20 0 10 10 20 10
             0 LWPOLYLINE 8 a 90 3 70 0 10 20 20 0 40 1 41 2 10 30 20 0 40 0 41 0 10 30 20 10
             0 POLYLINE 8 a 70 0 40 2 41 2 0 VERTEX 10 40 20 0 0 VERTEX 10 50 20 0 0 SEQEND",
        ),
        &Options::default(),
    );
    places(
        &world,
        &[
            (5.0, 0.49, '#'),
            (10.49, -0.49, '#'),
            (5.0, 0.51, '.'),
            (25.0, 0.99, '#'),
            (30.1, 5.0, '.'),
            (45.0, 0.99, '#'),
            (45.0, 1.01, '.'),
        ],
    );
}

#[test]
fn units_and_layers_are_those_of_the_file() {
    let line = "0 LINE 8 walls 10 0 20 0 11 1000 21 0 0 LINE 8 Doors 10 0 20 500 11 1000 21 500 0 LINE 8 ice 10 0 20 900 11 1000 21 900";
    let layers = "0 LAYER 2 walls 70 0 62 7 0 LAYER 2 Doors 70 0 62 -7 0 LAYER 2 ice 70 1 62 7";
    for (units, scale, length) in
        [(4, None, 1.0), (5, None, 10.0), (1, None, 25.4), (6, None, 1000.0), (0, None, 1000.0), (4, Some(0.01), 10.0)]
    {
        let text = document(&format!("9 $INSUNITS 70 {units}"), layers, "", line);
        let world = with(&text, &Options { scale, ..Options::default() });
        assert_eq!(world.report.obstacles.walls, 1);
        let aabb = world.scenario.world().obstacles[0].aabb();
        assert!((aabb.max.x - aabb.min.x - length).abs() < 1e-9, "{units}: {aabb:?}");
        let omitted: Vec<bool> = world.report.layers.iter().map(|layer| layer.omitted.is_some()).collect();
        assert_eq!(omitted, [false, true, true]);
    }
    let text = document("", layers, "", line);
    let chosen = |layers: &[&str]| Options {
        layers: Some(layers.iter().map(|name| (*name).to_owned()).collect()),
        ..Options::default()
    };
    assert_eq!(with(&text, &chosen(&["walls", "Doors"])).report.obstacles.walls, 2);
    refused(&[file("a.dxf", &text)], &chosen(&["roof"]), Code::InvalidOption);
    let odd = entities("0 LINE 8 T\\U+00FCren 10 0 20 0 11 1 21 0");
    assert_eq!(with(&odd, &thick()).report.layers[0].name, "Türen");
    let latin = entities("0 LINE 8 TX 10 0 20 0 11 1 21 0").replace('X', "\u{1}").into_bytes();
    let latin: Vec<u8> = latin.into_iter().map(|byte| if byte == 1 { 0xfc } else { byte }).collect();
    let world = read(&[file("a.dxf", &latin)], &thick()).expect("Latin 1");
    assert_eq!(world.report.layers[0].name, "Tü");
}

#[test]
fn what_is_left_out_is_counted() {
    let world = with(
        &entities(
            "0 LINE 8 a 10 0 20 0 11 1 21 0 0 TEXT 8 a 1 wall 0 MTEXT 8 a 1 wall 0 DIMENSION 8 a 2 *D1 0 POINT 8 a 10 0 20 0
             0 LINE 8 a 67 1 10 0 20 0 11 1 21 0 0 LINE 8 a 60 1 10 0 20 0 11 1 21 0 0 FOO 8 a 0 VIEWPORT 8 a
             0 POLYLINE 8 a 70 64 0 VERTEX 10 0 20 0 0 SEQEND 0 LINE 8 Defpoints 10 0 20 9 11 1 21 9",
        ),
        &thick(),
    );
    for what in ["TEXT", "MTEXT", "DIMENSION", "POINT", "VIEWPORT", "paper space", "invisible", "other kinds", "meshes"]
    {
        let count = world
            .report
            .dropped
            .iter()
            .filter(|dropped| dropped.what.starts_with(what) || dropped.what.ends_with(what))
            .count();
        assert!(count >= 1, "{what}: {:?}", world.report.dropped);
    }
    assert_eq!(world.report.obstacles.walls, 1);
    assert!(world.report.layers.iter().any(|layer| layer.name == "Defpoints" && layer.omitted.is_some()));
}

#[test]
fn hostile_files_are_refused_in_no_time() {
    let started = std::time::Instant::now();
    let line = "0 LINE 8 a 10 0 20 0 11 1 21 0";
    let whole = entities(line);
    refused(&[file("a.dxf", &whole.replace("0\nEOF\n", ""))], &Options::default(), Code::Truncated);
    refused(&[file("a.dxf", &whole[..whole.len() / 2])], &Options::default(), Code::Truncated);
    refused(&[file("a.dxf", b"AutoCAD Binary DXF\r\n\x1a\x00rest")], &Options::default(), Code::UnsupportedFeature);
    for (wrong, code) in [
        ("0 LINE 8 a 10 nan 20 0 11 1 21 0", Code::InvalidNumber),
        ("0 LINE 8 a 10 1e999 20 0 11 1 21 0", Code::InvalidNumber),
        ("0 LINE 8 a 10 1e300 20 0 11 1 21 0", Code::InvalidNumber),
        ("0 LINE 8 a x 0 20 0 11 1 21 0", Code::InvalidFile),
        ("0 CIRCLE 8 a 10 0 20 0 40 -1", Code::InvalidNumber),
        ("0 LWPOLYLINE 8 a 90 2 10 0 20 0 42 1e300 10 1 20 0", Code::InvalidNumber),
        ("0 TEXT 8 a 1 nothing", Code::InvalidFile),
    ] {
        let error = refused(&[file("a.dxf", &entities(wrong))], &Options::default(), code);
        assert!(error.to_string().starts_with("a.dxf"), "{error}");
    }
    let mut blocks = format!("0 BLOCK 2 b0 {line} 0 ENDBLK ");
    for i in 1..30 {
        blocks += &format!("0 BLOCK 2 b{i} 0 INSERT 2 b{0} 0 INSERT 2 b{0} 10 1 0 ENDBLK ", i - 1);
    }
    refused(&[file("a.dxf", &document("", "", &blocks, "0 INSERT 2 b29"))], &Options::default(), Code::WorldTooLarge);
    let array = document("", "", "0 BLOCK 2 b 0 ENDBLK", "0 INSERT 2 b 70 32767 71 32767");
    refused(&[file("a.dxf", &array)], &Options::default(), Code::WorldTooLarge);
    let deep: String = (0..100).map(|i| format!("0 BLOCK 2 b{i} 0 INSERT 2 b{} 0 ENDBLK ", i + 1)).collect();
    refused(&[file("a.dxf", &document("", "", &deep, "0 INSERT 2 b0"))], &Options::default(), Code::WorldTooLarge);
    assert!(started.elapsed() < std::time::Duration::from_secs(60), "{:?}", started.elapsed());
}

#[test]
fn layers_do_not_tell_small_letters_from_capitals() {
    let line = |layer: &str| format!("0 LINE 8 {layer} 10 0 20 0 11 10 21 0 ");
    let both = [line("WALL"), line("seen")].concat();
    let world = with(&document("", "0 LAYER 2 wall 70 0 62 -7", "", &both), &Options::default());
    let read: Vec<_> = world.report.layers.iter().map(|layer| (&*layer.name, layer.omitted.as_deref())).collect();
    assert_eq!(read, [("wall", Some("hidden")), ("seen", None)]);
}

#[test]
fn the_least_group_code_is_read() {
    let spline = "0 SPLINE 70 8 71 1 40 0 40 0 40 1 40 1 10 0 20 0 10 5 20 0 -2147483648 1";
    assert_eq!(with(&entities(spline), &Options::default()).report.obstacles.walls, 1);
}
