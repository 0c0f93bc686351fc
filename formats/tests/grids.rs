//! MovingAI maps, and grids of zeros and ones.

use crate::files::{MAP, SCEN, file, npy, one, refused};
use planarium_formats::{Code, Format, Options, Place, RobotChoice, read};

#[test]
fn terrain_is_free_or_blocked_by_its_letter() {
    let world = one("maps/small.map", MAP);
    let grid = world.report.grid.clone().expect("a grid");
    assert_eq!((grid.width, grid.height, grid.free, grid.occupied, grid.unknown), (5, 4, 16, 4, 0));
    let kinds: Vec<(&str, usize)> = grid.kinds.iter().map(|(kind, count)| (&**kind, *count)).collect();
    assert_eq!(kinds, [(".", 14), ("G", 1), ("S", 1), ("@", 1), ("O", 1), ("T", 1), ("W", 1)]);
    assert_eq!((world.report.format, world.scenario.name()), (Format::MovingAi, "small"));
    assert_eq!(one("a.map", MAP.replace('\n', "\r\n")).scenario.world(), world.scenario.world());
}

#[test]
fn scenarios_become_queries_between_middles_of_cells() {
    let options = Options { robot: RobotChoice::Disc { radius: 0.3 }, ..Options::default() };
    let world = read(&[file("small.map.scen", SCEN), file("small.map", MAP)], &options).expect("a map");
    let query = &world.scenario.queries()[1];
    // Row 2 from the top of 4 rows.
    assert_eq!((query.start.as_slice(), query.configuration()), (&[0.5, 1.5][..], Some(&[4.5, 0.5][..])));
    let read = &world.report.queries[1];
    assert_eq!((&*read.name, read.bucket, read.length, read.blocked), ("1", Some(7), Some(5.414_213_56), false));
    assert!(world.report.to_string().contains("queries: 2, buckets 0 to 7, lengths on the grid 4.000 to 5.414 m"));

    let error = refused(&[file("x/small.map.scen", SCEN)], &options, Code::MissingFile);
    assert_eq!((error.wanted(), error.file()), (Some("small.map"), Some("x/small.map.scen")));
    let scaled = Options { scale: Some(0.5), ..options };
    let world =
        planarium_formats::read(&[file("small.map.scen", SCEN), file("small.map", MAP)], &scaled).expect("a map");
    assert_eq!(
        (world.scenario.queries()[1].start.as_slice(), world.report.queries[1].length),
        (&[0.25, 0.75][..], Some(2.707_106_78))
    );
}

#[test]
fn wrong_maps_and_scenarios_are_refused_at_their_line() {
    let cases = [
        (MAP.replace(".@T..", ".@T."), Code::InvalidFile, 6),
        (MAP.replace(".@T..", ".@T..."), Code::InvalidFile, 6),
        (MAP.replace(".@T..", ".@x.."), Code::InvalidFile, 6),
        (MAP.replace("W....\n", ""), Code::Truncated, 7),
        (format!("{MAP}....."), Code::InvalidFile, 9),
        (MAP.replace("octile", "hexagonal"), Code::UnsupportedFeature, 1),
        (MAP.replace("height 4", "height -4"), Code::InvalidNumber, 2),
        (MAP.replace("height 4", "height 1e3"), Code::InvalidNumber, 2),
        (MAP.replace("width 5", "depth 5"), Code::InvalidFile, 3),
        ("type octile\nheight 4\n".to_owned(), Code::Truncated, 2),
    ];
    for (map, code, line) in cases {
        let error = refused(&[file("small.map", &map)], &Options::default(), code);
        assert_eq!(error.place(), Some(&Place::Line(line)), "{error}");
    }
    let cases = [
        (SCEN.replace("\t4.0", ""), Code::InvalidFile, 2),
        (SCEN.replace("\t5\t4\t0\t2", "\t6\t4\t0\t2"), Code::Contradiction, 3),
        (SCEN.replace("4\t3\t5.41", "5\t3\t5.41"), Code::InvalidNumber, 3),
        (SCEN.replace("4\t3\t5.41", "4\t-3\t5.41"), Code::InvalidNumber, 3),
        (SCEN.replace("5.41421356", "nan"), Code::InvalidNumber, 3),
        (SCEN.replace("7\t", "99999999999\t"), Code::InvalidNumber, 3),
    ];
    for (scen, code, line) in cases {
        let error = refused(&[file("small.map", MAP), file("small.scen", &scen)], &Options::default(), code);
        assert_eq!((error.file(), error.place()), (Some("small.scen"), Some(&Place::Line(line))), "{error}");
    }
    let blocked = SCEN.replace("\t0\t0\t4\t0", "\t1\t1\t4\t0");
    let world = read(&[file("small.map", MAP), file("small.scen", &blocked)], &Options::default()).expect("a map");
    assert!(world.report.queries[0].blocked && world.report.to_string().contains("1 with an end in an obstacle"));
}

#[test]
fn grids_are_read_from_text_csv_and_arrays() {
    let wanted = one("a.txt", "0 1 0\n0 0 1\n").scenario;
    let bounds = wanted.world().bounds.expect("bounds");
    assert_eq!((bounds.max.x, bounds.max.y, wanted.world().obstacles.len()), (3.0, 2.0, 2));
    // Row 0 is the highest y.
    assert_eq!(wanted.world().obstacles[0].aabb().min, planarium::geometry::Point::new(1.0, 1.0));
    for text in [
        "0,1,0\n0,0,1\n",
        "010\n001",
        "0;1;0\r\n0;0;1\r\n",
        "# a comment\n0, 1, 0,\n\n0, 0, 1,\n",
        "0.0\t1.0\t0\n0\t0\t1",
    ] {
        assert_eq!(one("a.csv", text).scenario, wanted, "{text:?}");
    }
    for kind in ["|b1", "|u1", "|i1"] {
        assert_eq!(one("a.npy", npy(kind, 2, 3, &[0, 1, 0, 0, 0, 1])).scenario, wanted, "{kind}");
    }
    let unknown = one("a.npy", npy("|i1", 1, 3, &[255, 1, 0])).report.grid.expect("a grid");
    assert_eq!((unknown.unknown, unknown.occupied, unknown.free), (1, 1, 1));
    assert!(one("a.txt", "010\n001").report.notes.iter().any(|note| note.contains("a cell is 1 m")));
}

#[test]
fn other_numbers_of_grids_need_a_threshold() {
    let error = refused(&[file("a.npy", &npy("|u1", 2, 2, &[0, 1, 7, 0]))], &Options::default(), Code::InvalidNumber);
    assert_eq!(error.place(), Some(&Place::Element("row 1, column 0".to_owned())), "{error}");
    refused(&[file("a.csv", "0,1\n0,5\n")], &Options::default(), Code::UnknownWorld);
    let options = Options { threshold: Some(50.0), scale: Some(0.1), ..Options::default() };
    let world = read(&[file("a.csv", "0,100\n49.5,50\n")], &options).expect("a grid");
    assert_eq!(world.report.grid.map(|grid| (grid.occupied, grid.rectangles)), Some((2, 1)));
    let world = read(&[file("a.npy", &npy("|u1", 2, 2, &[0, 100, 49, 50]))], &options).expect("a grid");
    assert_eq!(world.report.grid.map(|grid| (grid.occupied, grid.rectangles)), Some((2, 1)));
    let error = refused(&[file("a.txt", "010\n01\n")], &Options::default(), Code::InvalidFile);
    assert_eq!(error.place(), Some(&Place::Line(2)));
    let error = refused(&[file("a.txt", "0 1\n0 nan\n")], &Options::default(), Code::InvalidNumber);
    assert_eq!(error.place(), Some(&Place::Line(2)));
    refused(&[file("a.npy", &npy("|u1", 2, 3, &[0, 1, 0, 0]))], &Options::default(), Code::InvalidFile);
}
