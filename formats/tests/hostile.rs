//! Bad input: a clear error, in bounded time and memory.

use crate::files::{MAP, PGM, SCEN, YAML, file, png, refused};
use planarium_formats::{Code, MAX_BYTES, Options, RobotChoice, is_world, read};
use png::{BitDepth, ColorType};
use std::time::{Duration, Instant};

#[test]
fn what_is_no_world_is_refused_and_known_formats_are_named() {
    let cases: [(&[u8], &str); 8] = [
        (b"{\"format\": \"planarium-scenario-1\"}", "JSON"),
        (b"<html><svg/></html>", "XML, but not SVG"),
        (b"\xff\xd8\xff\xe0", "JPEG"),
        (b"PK\x03\x04", "ZIP"),
        (b"P6 1 1 255 abc", "PPM"),
        (b"hello", "\"hello\" is no number"),
        (b"1 2\n3 4\n", "of no known shape"),
        (b"\x00\x01\x02\x03", "not known"),
    ];
    for (bytes, word) in cases {
        let error = refused(&[file("a", bytes)], &Options::default(), Code::UnknownWorld);
        assert!(error.message().contains(word), "{error}");
        assert!(!is_world(bytes), "{error}");
    }
    assert!(is_world(YAML.as_bytes()) && is_world(PGM) && is_world(MAP.as_bytes()) && is_world(SCEN.as_bytes()));
    assert!(is_world(b"<?xml version='1.0'?><svg/>") && is_world(b"  0\r\nSECTION\r\n"));
    refused(&[file("a", b"")], &Options::default(), Code::Truncated);
    refused(&[], &Options::default(), Code::InvalidOption);
    refused(&[file("a", b"\n\n")], &Options::default(), Code::UnknownWorld);
}

#[test]
fn sizes_are_refused_before_memory_is_taken() {
    let started = Instant::now();
    let huge = vec![b'1'; MAX_BYTES + 1];
    refused(&[file("a.txt", &huge)], &Options::default(), Code::WorldTooLarge);
    refused(&[file("a.pgm", b"P5\n30000 30000\n255\n")], &Options::default(), Code::WorldTooLarge);
    refused(
        &[file("a.map", b"type octile\nheight 30000\nwidth 30000\nmap\n")],
        &Options::default(),
        Code::WorldTooLarge,
    );
    // A size that is allowed, but that the file does not have.
    refused(&[file("a.pgm", b"P5\n8000 8000\n255\n")], &Options::default(), Code::Truncated);
    refused(&[file("a.map", b"type octile\nheight 8000\nwidth 8000\nmap\n")], &Options::default(), Code::Truncated);
    let many = vec![file("a.map", MAP); 17];
    refused(&many, &Options::default(), Code::WorldTooLarge);
    // The header of a PNG alone, with a right checksum.
    let mut picture = png(1, 1, ColorType::Grayscale, BitDepth::Eight, &[0]);
    picture[16..24].copy_from_slice(&[0, 0, 0x75, 0x30, 0, 0, 0x75, 0x30]);
    let checksum = crc(&picture[12..29]);
    picture[29..33].copy_from_slice(&checksum.to_be_bytes());
    refused(&[file("a.png", &picture)], &Options::default(), Code::WorldTooLarge);
    assert!(started.elapsed() < Duration::from_secs(20), "{:?}", started.elapsed());
}

fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg()))
    })
}

#[test]
fn a_bomb_is_read_no_further_than_its_header_says() {
    // 64 million white pixels in 62 kB: as many as are allowed, and they are one free cell each.
    let data = vec![255; 8192 * 1024];
    let started = Instant::now();
    let picture = png(8192, 1024, ColorType::Grayscale, BitDepth::Eight, &data);
    assert!(picture.len() < 20_000, "{}", picture.len());
    let world = read(&[file("a.png", &picture)], &Options::default()).expect("a picture");
    assert_eq!(world.report.grid.map(|grid| (grid.free, grid.rectangles)), Some((data.len(), 0)));
    println!("{} pixels: {:?}", data.len(), started.elapsed());
    // The same data under a header of 4 x 4 pixels: only those are read.
    let mut small = picture.clone();
    small[16..24].copy_from_slice(&[0, 0, 0, 4, 0, 0, 0, 4]);
    let checksum = crc(&small[12..29]);
    small[29..33].copy_from_slice(&checksum.to_be_bytes());
    if let Ok(world) = read(&[file("a.png", &small)], &Options::default()) {
        assert_eq!(world.report.grid.map(|grid| grid.free + grid.occupied), Some(16));
    }
}

#[test]
fn nested_and_repeated_yaml_takes_no_time() {
    let started = Instant::now();
    let deep = format!("{YAML}extra: {}{}\n", "[".repeat(20_000), "]".repeat(20_000));
    let _ = read(&[file("map.yaml", &deep), file("map.pgm", PGM)], &Options::default());
    // Aliases of aliases are never followed.
    let mut laughs = String::from("a0: &a0 [x, x]\n");
    for i in 1..40 {
        laughs += &format!("a{i}: &a{i} [*a{}, *a{}]\n", i - 1, i - 1);
    }
    let world = read(&[file("map.yaml", &format!("{laughs}{YAML}")), file("map.pgm", PGM)], &Options::default());
    assert!(world.is_ok());
    let aliased = YAML.replace("[-1.0, 2.0, 0.0]", "*o");
    refused(
        &[file("map.yaml", &format!("o: &o [0, 0, 0]\n{aliased}")), file("map.pgm", PGM)],
        &Options::default(),
        Code::InvalidFile,
    );
    let long = format!("{YAML}# {}\n", "x".repeat(2 << 20));
    refused(&[file("map.yaml", &long), file("map.pgm", PGM)], &Options::default(), Code::WorldTooLarge);
    assert!(started.elapsed() < Duration::from_secs(20), "{:?}", started.elapsed());
}

#[test]
fn wrong_options_are_refused() {
    let with = |options: Options| refused(&[file("a.map", MAP)], &options, Code::InvalidOption);
    with(Options { start: Some(vec![0.5, 0.5]), ..Options::default() });
    with(Options { start: Some(vec![0.5]), goal: Some(vec![1.5, 0.5]), ..Options::default() });
    with(Options { start: Some(vec![0.5, 0.5, 0.0]), goal: Some(vec![1.5, 0.5]), ..Options::default() });
    with(Options { start: Some(vec![0.5, f64::INFINITY]), goal: Some(vec![1.5, 0.5]), ..Options::default() });
    with(Options { threshold: Some(0.5), ..Options::default() });
    with(Options { simplify: -1.0, ..Options::default() });
    with(Options { simplify: f64::NAN, ..Options::default() });
    for robot in [
        RobotChoice::Disc { radius: -1.0 },
        RobotChoice::Disc { radius: f64::NAN },
        RobotChoice::Footprint { corners: vec![[0.0, 0.0], [1.0, 1.0]] },
        RobotChoice::Footprint { corners: vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]] },
        RobotChoice::Car { length: 1.0, width: 0.5, wheelbase: 2.0, steering: 0.5 },
        RobotChoice::Car { length: 1.0, width: 0.5, wheelbase: 0.5, steering: 0.0 },
        RobotChoice::Car { length: f64::NAN, width: 0.5, wheelbase: 0.5, steering: 0.5 },
    ] {
        with(Options { robot, ..Options::default() });
    }
    let far = Options { start: Some(vec![1e300, 0.5]), goal: Some(vec![1.5, 0.5]), ..Options::default() };
    refused(&[file("a.map", MAP)], &far, Code::InvalidScenario);
}

#[test]
fn a_world_that_is_too_large_for_a_scenario_says_what_helps() {
    let row = "01".repeat(500) + "\n" + &"0".repeat(1000) + "\n";
    let text = row.repeat(300);
    let error = refused(&[file("dots.txt", &text)], &Options::default(), Code::WorldTooLarge);
    assert!(error.message().contains("150000 rectangles") && error.message().contains("min_island"), "{error}");
    let dropped =
        read(&[file("dots.txt", &text)], &Options { min_island: 2, ..Options::default() }).expect("nothing left");
    assert_eq!((dropped.report.obstacles.polygons, dropped.report.dropped[0].count), (0, 150_000));
    let grown = read(&[file("dots.txt", &text)], &Options { simplify: 1.5, ..Options::default() }).expect("blocks");
    assert_eq!(grown.report.obstacles.polygons, 1);
}

#[test]
fn the_documentation_has_every_code_and_its_limits() {
    let page = include_str!("../../docs/worlds.md");
    for code in Code::ALL {
        assert!(page.contains(&format!("| `{}` |", code.as_str())), "{}", code.as_str());
        assert!(code.meaning().len() > 20);
    }
    let digits = |number: usize| {
        let text = number.to_string();
        let groups: Vec<&str> =
            text.as_bytes().rchunks(3).rev().map(|three| std::str::from_utf8(three).expect("digits")).collect();
        groups.join(",")
    };
    for number in [planarium_formats::MAX_CELLS, planarium_formats::MAX_SIDE, planarium::scenario::MAX_OBSTACLES] {
        assert!(page.contains(&digits(number)), "{}", digits(number));
    }
    assert!(page.contains(&format!("{} MiB", MAX_BYTES >> 20)));
}
