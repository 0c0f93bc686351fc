//! Maps of `map_server`.

use crate::files::{PGM, Places, Random, YAML, bmp, file, png, refused};
use planarium::geometry::Point;
use planarium_formats::{Cell, Code, Format, Options, Place, Unknown, World, read};
use png::{BitDepth, ColorType};

#[track_caller]
fn map(yaml: &str, picture: &[u8]) -> World {
    read(&[file("maps/map.yaml", yaml), file("maps/map.pgm", picture)], &Options::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

/// Free, occupied and unknown cells.
#[track_caller]
fn counts(yaml: &str, picture: &[u8]) -> (usize, usize, usize) {
    let grid = map(yaml, picture).report.grid.expect("a grid");
    (grid.free, grid.occupied, grid.unknown)
}

#[test]
fn a_map_is_read_in_either_order() {
    let world = map(YAML, PGM);
    assert_eq!((world.report.format, world.scenario.name()), (Format::RosMap, "map"));
    let bounds = world.scenario.world().bounds.expect("bounds");
    assert_eq!((bounds.min, bounds.max), (Point::new(-1.0, 2.0), Point::new(1.0, 3.5)));
    // Row 0 is the highest y: the black pixel at its left end is the upper left cell.
    let places = Places::of(&world.scenario);
    assert!(!places.is_free(Point::new(-0.9, 3.4)) && places.is_free(Point::new(-0.9, 2.1)));
    assert!(!places.is_free(Point::new(0.9, 2.6)) && !places.is_free(Point::new(-0.4, 2.1)));
    let other = read(&[file("map.pgm", PGM), file("map.yaml", YAML)], &Options::default()).expect("a map");
    assert_eq!(other.scenario, world.scenario);
    let files: Vec<&str> = other.report.files.iter().map(|file| &*file.kind).collect();
    assert_eq!(files, ["YAML of a map", "PGM"]);
    assert_eq!(other.grid.expect("cells").cell_at(Point::new(0.9, 3.4)), Some(Cell::Free));
}

#[test]
fn unknown_cells_are_obstacles_unless_they_are_said_to_be_free() {
    // Grey 205 lies between the thresholds: 1 - 205 / 255 = 0.196.
    let yaml = YAML.replace("free_thresh: 0.25", "free_thresh: 0.196");
    let files = [file("map.yaml", &yaml), file("map.pgm", PGM)];
    let occupied = read(&files, &Options::default()).expect("a map").report;
    let free = read(&files, &Options { unknown: Unknown::Free, ..Options::default() }).expect("a map").report;
    let cells = |report: &planarium_formats::Report| {
        let grid = report.grid.as_ref().expect("a grid");
        (grid.free, grid.occupied, grid.unknown, grid.merged_cells)
    };
    assert_eq!((cells(&occupied), cells(&free)), ((8, 3, 1, 4), (8, 3, 1, 3)));
    assert!(occupied.to_string().contains("8 free, 3 occupied, 1 unknown; unknown ones are obstacles"), "{occupied}");
    // With the threshold of 0.25, the same grey is free.
    assert_eq!(counts(YAML, PGM), (9, 3, 0));
}

#[test]
fn thresholds_negate_and_modes_are_those_of_map_server() {
    let ramp: Vec<u8> = (0..=255).collect();
    let picture = [b"P5 16 16 255\n", &ramp[..]].concat();
    // occ = 1 - v / 255: above 0.65 for v <= 89, below 0.25 for v >= 192.
    assert_eq!(counts(YAML, &picture), (64, 90, 102));
    let negated = YAML.replace("negate: 0", "negate: true");
    assert_eq!(counts(&negated, &picture), (64, 90, 102));
    let scale = format!("{YAML}mode: scale\n");
    assert_eq!(counts(&scale, &picture), (64, 90, 102));
    let raw = format!("{YAML}mode: 'raw'\n");
    assert_eq!(counts(&raw, &picture), (1, 1, 254));
    // 16 bits, the first byte the larger part; 1 - 0xc000 / 0xffff is a little less than 0.25.
    assert_eq!(counts(YAML, b"P5 2 2 65535\n\xff\xff\x00\xff\xc0\x00\xbf\x00"), (2, 1, 1));
    // Plain text, the largest value 4, comments between numbers.
    assert_eq!(counts(YAML, b"P2 # plain\n2 2 # size\n4\n4 0 # first row\n 3 2"), (1, 1, 2));
}

#[test]
fn transparent_pixels_are_unknown() {
    let pixels = [[255, 255], [255, 0], [0, 255], [0, 0]].concat();
    let grey = png(2, 2, ColorType::GrayscaleAlpha, BitDepth::Eight, &pixels);
    assert_eq!(counts(YAML, &grey), (1, 1, 2));
    assert_eq!(map(YAML, &grey).report.grid.map(|grid| grid.transparent), Some(2));
    // In mode trinary the opacity counts as a further channel, as in map_server: (3 * 255 + 60) / 4 / 255 = 0.81; in
    // mode scale, what is not opaque is unknown.
    let half = png(2, 1, ColorType::Rgba, BitDepth::Eight, &[255, 255, 255, 60, 255, 255, 255, 255]);
    assert_eq!(counts(YAML, &half), (2, 0, 0));
    assert_eq!(counts(&format!("{YAML}mode: scale\n"), &half), (1, 0, 1));
}

#[test]
fn every_kind_of_picture_gives_the_same_cells() {
    let grey = [0, 255, 255, 205, 255, 255, 255, 0, 255, 0, 255, 255];
    let wanted = map(YAML, PGM).scenario;
    let of = |picture: &[u8]| map(YAML, picture).scenario;
    let rgb: Vec<u8> = grey.iter().flat_map(|&v| [v, v, v]).collect();
    let rgba: Vec<u8> = grey.iter().flat_map(|&v| [v, v, v, 255]).collect();
    let wide: Vec<u8> = grey.iter().flat_map(|&v| [v, v]).collect();
    assert_eq!(of(&png(4, 3, ColorType::Grayscale, BitDepth::Eight, &grey)), wanted);
    assert_eq!(of(&png(4, 3, ColorType::Grayscale, BitDepth::Sixteen, &wide)), wanted);
    assert_eq!(of(&png(4, 3, ColorType::Rgb, BitDepth::Eight, &rgb)), wanted);
    assert_eq!(of(&bmp(4, 3, &grey)), wanted);
    // Opacity lightens black: an opaque black pixel is 0.75 occupied, above the threshold.
    assert_eq!(of(&png(4, 3, ColorType::Rgba, BitDepth::Eight, &rgba)), wanted);
    // A palette of black, white and transparent, two bits a pixel.
    let palette = png(4, 1, ColorType::Indexed, BitDepth::Two, &[0b00_01_10_01]);
    assert_eq!(counts(YAML, &palette), (2, 1, 1));
    // One bit a pixel.
    assert_eq!(counts(YAML, &png(4, 1, ColorType::Grayscale, BitDepth::One, &[0b0101_0000])), (2, 2, 0));
}

#[test]
fn a_turned_map_is_placed_by_its_yaw() {
    let yaml = YAML.replace("0.0]", "0.5]");
    let world = map(&yaml, PGM);
    let grid = world.grid.as_ref().expect("cells");
    // The lower left corner stays; the lower right one is turned about it.
    assert_eq!(grid.corner(0.0, 3.0), Point::new(-1.0, 2.0));
    let right = grid.corner(4.0, 3.0);
    assert!((right - Point::new(-1.0 + 2.0 * 0.5f64.cos(), 2.0 + 2.0 * 0.5f64.sin())).norm() < 1e-15);
    assert_eq!(world.report.obstacles.polygons, 3 + 4, "three cells and four triangles outside");
    assert!(world.report.grown > 0.0 && world.report.grown < 1e-11);
    agrees(&world);
    for quarter in [std::f64::consts::FRAC_PI_2, std::f64::consts::PI, -3.0 * std::f64::consts::FRAC_PI_4] {
        agrees(&map(&YAML.replace("0.0]", &format!("{quarter}]")), PGM));
    }
}

/// The free cells of the picture and of the scenario agree at random points.
#[track_caller]
fn agrees(world: &World) {
    let bounds = world.scenario.world().bounds.expect("bounds");
    let (places, grid) = (Places::of(&world.scenario), world.grid.as_ref().expect("cells"));
    let mut random = Random(11);
    let mut compared = 0;
    for _ in 0..20_000 {
        let x = bounds.min.x + random.unit() * (bounds.max.x - bounds.min.x);
        let p = Point::new(x, bounds.min.y + random.unit() * (bounds.max.y - bounds.min.y));
        let [column, row] = grid.locate(p);
        if [column, row].iter().any(|at| (at - at.round()).abs() < 1e-9) {
            continue;
        }
        compared += 1;
        assert_eq!(places.is_free(p), grid.cell_at(p) == Some(Cell::Free), "{p}");
    }
    assert!(compared > 19_000);
}

#[test]
fn a_map_far_away_is_moved() {
    let world = map(&YAML.replace("-1.0, 2.0", "4500000.25, -2e6"), PGM);
    assert_eq!(world.report.offset, [4_500_001.0, -1_999_999.0]);
    let bounds = world.scenario.world().bounds.expect("bounds");
    assert_eq!((bounds.min, bounds.max), (Point::new(-0.75, -1.0), Point::new(1.25, 0.5)));
    agrees(&world);
    let options = Options {
        start: Some(vec![4_500_001.5, -2e6 + 0.25]),
        goal: Some(vec![4_500_001.5, -2e6 + 1.25]),
        ..Options::default()
    };
    let yaml = YAML.replace("-1.0, 2.0", "4500000.25, -2e6");
    let world = read(&[file("map.yaml", &yaml), file("map.pgm", PGM)], &options).expect("a map");
    assert_eq!(world.scenario.queries()[0].start, [0.5, -0.75]);
}

#[test]
fn cells_keep_their_place_however_far_away_the_map_is() {
    for origin in ["1e15, -1e15", "4.5e9, 4.5e9", "1e17, 0.0"] {
        let near = map(&YAML.replace("-1.0, 2.0", "0.0, 0.0"), PGM);
        for yaw in ["0.0]", "0.5]"] {
            let world = map(&YAML.replace("-1.0, 2.0", origin).replace("0.0]", yaw), PGM);
            assert_eq!(
                world.report.obstacles.polygons,
                near.report.obstacles.polygons + 4 * usize::from(yaw != "0.0]")
            );
            assert!(world.report.grown < 1e-9, "{}", world.report);
            agrees(&world);
        }
    }
}

#[test]
fn metadata_may_begin_with_a_byte_order_mark_and_cells_have_a_size() {
    let marked = map(&format!("\u{feff}{YAML}"), PGM);
    assert_eq!(marked.scenario.world(), map(YAML, PGM).scenario.world());
    // Tabs between keys and values, of which YAML allows any number.
    for between in ["\t", " \t", "\t ", "\t\t"] {
        let tabbed = map(&YAML.replace(": ", &format!(":{between}")), PGM);
        assert_eq!(tabbed.scenario, map(YAML, PGM).scenario, "{between:?}");
    }
    let quoted = YAML.replace("image: map.pgm", "image:\t\"a:\tb.pgm\"");
    let error = refused(&[file("map.yaml", &quoted)], &Options::default(), Code::MissingFile);
    assert_eq!(error.wanted(), Some("a:\tb.pgm"));
    for wrong in ["image:\tmap.pgm: 1", "image:\t- map.pgm"] {
        let yaml = YAML.replace("image: map.pgm", wrong);
        refused(&[file("map.yaml", &yaml), file("map.pgm", PGM)], &Options::default(), Code::InvalidFile);
    }
    let image = YAML.lines().find(|line| line.starts_with("image")).expect("a picture");
    let error = refused(&[file("map.yaml", &YAML.replace(image, ""))], &Options::default(), Code::InvalidFile);
    assert!(error.message().contains("image"), "{error}");
    let tiny = YAML.lines().map(|line| if line.starts_with("resolution") { "resolution: 1e-300" } else { line });
    let tiny: String = tiny.flat_map(|line| [line, "\n"]).collect();
    refused(&[file("map.yaml", &tiny), file("map.pgm", PGM)], &Options::default(), Code::InvalidNumber);
}

#[test]
fn what_a_map_names_as_its_picture_is_not_quoted() {
    let error = refused(
        &[file("map.yaml", YAML), file("map.pgm", "root:x:0:0:secret")],
        &Options::default(),
        Code::InvalidFile,
    );
    assert!(error.message().contains("no PGM, PNG or BMP") && !error.message().contains("root"), "{error}");
}

#[test]
fn a_missing_picture_is_named() {
    let error = refused(&[file("dir/map.yaml", YAML)], &Options::default(), Code::MissingFile);
    assert_eq!((error.wanted(), error.file()), (Some("map.pgm"), Some("dir/map.yaml")));
    assert!(error.message().contains("map.pgm"), "{error}");
    let error = refused(&[file("map.yaml", YAML), file("other.pgm", PGM)], &Options::default(), Code::MissingFile);
    assert!(error.message().contains("map.pgm"), "{error}");
    let error = refused(
        &[file("map.yaml", YAML), file("map.pgm", PGM), file("other.pgm", PGM)],
        &Options::default(),
        Code::UnusedFile,
    );
    assert_eq!(error.file(), Some("other.pgm"));
}

#[test]
fn yaml_is_read_as_people_write_it() {
    let flow = "{image: 'map.pgm', resolution: 5.0e-1, origin: [-1, 2, 0.0], negate: no, occupied_thresh: 0.65, free_thresh: .25}";
    assert_eq!(map(flow, PGM).scenario, map(YAML, PGM).scenario);
    let block = "# made by hand\n---\nimage: \"map.pgm\"   # beside\nresolution: 0.5\norigin:\n  - -1.0\n  - 2\n  - 0\n\
                 negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\nmode: trinary\nextra: {deep: [1, {er: 2}]}\n...\n";
    let world = map(block, PGM);
    assert_eq!(world.scenario, map(YAML, PGM).scenario);
    assert!(world.report.notes.iter().any(|note| note.contains("\"extra\"")), "{:?}", world.report.notes);
    let crlf = YAML.replace('\n', "\r\n");
    assert_eq!(map(&crlf, PGM).scenario, map(YAML, PGM).scenario);
}

#[test]
fn wrong_metadata_is_refused_at_its_line() {
    let cases = [
        ("resolution: 0.5", "resolution: 0", Code::InvalidNumber, 2),
        ("resolution: 0.5", "resolution: -0.05", Code::InvalidNumber, 2),
        ("resolution: 0.5", "resolution: .nan", Code::InvalidNumber, 2),
        ("resolution: 0.5", "resolution: wide", Code::InvalidFile, 2),
        ("resolution: 0.5", "resolution: [0.5]", Code::InvalidFile, 2),
        ("resolution: 0.5", "resolution: 0.5\nresolution: 0.5", Code::InvalidFile, 3),
        ("[-1.0, 2.0, 0.0]", "[-1.0, 2.0]", Code::InvalidFile, 3),
        ("[-1.0, 2.0, 0.0]", "[-1.0, .inf, 0.0]", Code::InvalidNumber, 3),
        ("[-1.0, 2.0, 0.0]", "[-1.0, 1e999, 0.0]", Code::InvalidNumber, 3),
        ("[-1.0, 2.0, 0.0]", "[-1.0, [2.0], 0.0]", Code::InvalidFile, 3),
        ("[-1.0, 2.0, 0.0]", "here", Code::InvalidFile, 3),
        ("negate: 0", "negate: perhaps", Code::InvalidFile, 4),
        ("0.65", "1.65", Code::InvalidNumber, 5),
        ("0.25", "0.75", Code::InvalidNumber, 6),
        ("0.25", "0.25\nmode: fancy", Code::InvalidFile, 7),
        ("0.25", "0.25\nmode: ]", Code::InvalidFile, 7),
    ];
    for (from, to, code, line) in cases {
        let yaml = YAML.replace(from, to);
        let error = refused(&[file("map.yaml", &yaml), file("map.pgm", PGM)], &Options::default(), code);
        assert_eq!((error.file(), error.place()), (Some("map.yaml"), Some(&Place::Line(line))), "{to}: {error}");
    }
    for key in ["resolution", "origin", "negate", "occupied_thresh", "free_thresh"] {
        let yaml: String = YAML.lines().filter(|line| !line.starts_with(key)).map(|line| format!("{line}\n")).collect();
        let error = refused(&[file("map.yaml", &yaml), file("map.pgm", PGM)], &Options::default(), Code::InvalidFile);
        assert_eq!(error.place(), Some(&Place::Element(key.to_owned())), "{error}");
    }
    let options = Options { scale: Some(0.1), ..Options::default() };
    refused(&[file("map.yaml", YAML), file("map.pgm", PGM)], &options, Code::InvalidOption);
}
