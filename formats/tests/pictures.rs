//! Pictures without metadata.

use crate::files::{PGM, Places, Random, bmp, file, npy, one, png, refused};
use planarium::geometry::Point;
use planarium_formats::{Code, Format, Options, Place, read};
use png::{BitDepth, ColorType};

#[test]
fn a_threshold_and_a_scale_make_a_world_of_a_picture() {
    let picture = png(3, 2, ColorType::Grayscale, BitDepth::Eight, &[0, 127, 128, 255, 200, 10]);
    let world = one("plan.png", &picture);
    let grid = world.report.grid.clone().expect("a grid");
    assert_eq!((world.report.format, grid.free, grid.occupied), (Format::Picture, 3, 3));
    assert_eq!(world.report.notes.len(), 2, "threshold and scale were assumed: {:?}", world.report.notes);
    let options = Options { threshold: Some(0.8), scale: Some(0.05), ..Options::default() };
    let world = read(&[file("plan.png", &picture)], &options).expect("a picture");
    assert_eq!(world.report.grid.as_ref().map(|grid| (grid.free, grid.resolution)), Some((1, 0.05)));
    assert!((world.scenario.world().bounds.expect("bounds").max.x - 0.15).abs() < 1e-15);
    refused(
        &[file("plan.png", &picture)],
        &Options { threshold: Some(2.0), ..Options::default() },
        Code::InvalidOption,
    );
    refused(&[file("plan.png", &picture)], &Options { scale: Some(0.0), ..Options::default() }, Code::InvalidOption);
    refused(
        &[file("plan.png", &picture)],
        &Options { scale: Some(f64::NAN), ..Options::default() },
        Code::InvalidOption,
    );
}

#[test]
fn what_can_be_seen_through_is_unknown() {
    let picture = png(2, 1, ColorType::Rgba, BitDepth::Eight, &[255, 255, 255, 254, 255, 255, 255, 255]);
    let grid = one("plan.png", picture).report.grid.expect("a grid");
    assert_eq!((grid.free, grid.unknown, grid.transparent), (1, 1, 1));
}

#[test]
fn pgm_and_bmp_are_pictures_too() {
    let wanted = one("map.pgm", PGM).scenario;
    let grey = [0, 255, 255, 205, 255, 255, 255, 0, 255, 0, 255, 255];
    assert_eq!(one("map.bmp", bmp(4, 3, &grey)).scenario, wanted);
    // From the top down: a negative height, and the rows the other way round.
    let mut turned = bmp(4, 3, &grey);
    turned[22..26].copy_from_slice(&(-3i32).to_le_bytes());
    let rows: Vec<u8> = turned[54 + 1024..].chunks(4).rev().flatten().copied().collect();
    turned.truncate(54 + 1024);
    turned.extend(rows);
    assert_eq!(one("map.bmp", turned).scenario, wanted);
    // 24 bits a pixel, rows filled up to four bytes; 32 bits; one bit with a palette of white and black.
    let with = |bits: u32, width: u32, palette: &[u8], data: &[u8]| {
        let mut bytes = b"BM".to_vec();
        let start = 54 + palette.len() as u32;
        for number in [0, 0, start, 40, width, 1, 1 | bits << 16, 0, 0, 0, 0, palette.len() as u32 / 4, 0] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(palette);
        bytes.extend(data);
        one("map.bmp", bytes).report.grid.expect("a grid").occupied
    };
    assert_eq!(with(24, 2, &[], &[0, 0, 0, 255, 255, 255, 0, 0]), 1);
    assert_eq!(with(32, 2, &[], &[0, 0, 0, 0, 255, 255, 255, 0]), 1);
    assert_eq!(with(1, 3, &[255, 255, 255, 0, 0, 0, 0, 0], &[0b1010_0000, 0, 0, 0]), 2);
    assert_eq!(with(4, 3, &[255, 255, 255, 0, 0, 0, 0, 0], &[0x01, 0x10, 0, 0]), 2);
}

#[test]
fn damaged_pictures_are_refused_at_their_byte() {
    let byte = |error: planarium_formats::FormatError| match error.place() {
        Some(Place::Byte(at)) => *at,
        other => panic!("{other:?}: {error}"),
    };
    let of = |bytes: &[u8], code| refused(&[file("a", bytes)], &Options::default(), code);
    assert_eq!(byte(of(&PGM[..PGM.len() - 1], Code::Truncated)), PGM.len() - 1);
    assert_eq!(byte(of(b"P5\n4", Code::Truncated)), 4);
    assert_eq!(byte(of(b"P5\n-4 3\n255\n", Code::InvalidFile)), 3);
    assert_eq!(byte(of(b"P5\n4 3\n0\n", Code::InvalidNumber)), 7);
    assert_eq!(byte(of(b"P5\n4 3\n70000\n", Code::InvalidNumber)), 7);
    assert_eq!(byte(of(b"P5\n99999999999999999999 3\n255\n", Code::InvalidNumber)), 3);
    assert_eq!(byte(of(b"P2\n2 1\n3\n1 4", Code::InvalidNumber)), 11);
    assert_eq!(byte(of(b"P2\n2 1\n3\n1 x", Code::InvalidFile)), 11);
    assert_eq!(byte(of(b"P2\n2 2\n3\n1 2 3\n", Code::Truncated)), 15);
    of(b"P5\n0 3\n255\n", Code::InvalidNumber);
    of(b"P5\n30000 30000\n255\n", Code::WorldTooLarge);
    of(b"P2\n100000 1\n255\n", Code::WorldTooLarge);
    let picture = png(3, 2, ColorType::Grayscale, BitDepth::Eight, &[0, 127, 128, 255, 200, 10]);
    for length in 8..picture.len() - 12 {
        let error = of(&picture[..length], Code::Truncated);
        assert_eq!(byte(error), length);
    }
    let mut damaged = picture.clone();
    damaged[20] ^= 1;
    of(&damaged, Code::InvalidFile);
    let whole = bmp(4, 3, &[0; 12]);
    of(&whole[..whole.len() - 1], Code::Truncated);
    of(&whole[..60], Code::Truncated);
    let with = |at: usize, bytes: &[u8], code| {
        let mut changed = whole.clone();
        changed[at..at + bytes.len()].copy_from_slice(bytes);
        of(&changed, code)
    };
    assert_eq!(byte(with(18, &(-4i32).to_le_bytes(), Code::InvalidNumber)), 18);
    assert_eq!(byte(with(28, &16u16.to_le_bytes(), Code::UnsupportedFeature)), 28);
    assert_eq!(byte(with(30, &1u32.to_le_bytes(), Code::UnsupportedFeature)), 30);
    assert_eq!(byte(with(14, &12u32.to_le_bytes(), Code::UnsupportedFeature)), 14);
    with(22, &i32::MIN.to_le_bytes(), Code::WorldTooLarge);
    with(10, &u32::MAX.to_le_bytes(), Code::Truncated);
}

/// The same cells in every format, compared with the cells themselves.
#[test]
fn every_raster_agrees_with_its_cells_at_random_points() {
    let (width, height, scale) = (37, 29, 0.05);
    let mut random = Random(19);
    let occupied: Vec<bool> = (0..width * height).map(|_| random.unit() < 0.4).collect();
    let grey: Vec<u8> = occupied.iter().map(|&bit| if bit { 0 } else { 255 }).collect();
    let text = |free: char, wall: char| -> String {
        let rows = occupied.chunks(width);
        rows.map(|row| row.iter().map(|&bit| if bit { wall } else { free }).chain(['\n']).collect::<String>()).collect()
    };
    let cells: Vec<u8> = occupied.iter().map(|&bit| u8::from(bit)).collect();
    let plain: Vec<String> = grey.iter().map(u8::to_string).collect();
    let rasters: [(&str, Vec<u8>); 7] = [
        ("raw PGM", [format!("P5 {width} {height} 255\n").as_bytes(), &grey].concat()),
        ("plain PGM", format!("P2 {width} {height} 255\n{}", plain.join(" ")).into_bytes()),
        ("PNG", png(width as u32, height as u32, ColorType::Grayscale, BitDepth::Eight, &grey)),
        ("BMP", bmp(width, height, &grey)),
        ("MovingAI", format!("type octile\nheight {height}\nwidth {width}\nmap\n{}", text('.', '@')).into_bytes()),
        ("text", text('0', '1').into_bytes()),
        ("array", npy("|b1", height, width, &cells)),
    ];
    let options = Options { scale: Some(scale), ..Options::default() };
    for (name, bytes) in rasters {
        let world = read(&[file("raster", &bytes)], &options).unwrap_or_else(|error| panic!("{name}: {error}"));
        let places = Places::of(&world.scenario);
        let mut compared = 0;
        while compared < 100_000 {
            let [column, row] = [random.unit() * width as f64, random.unit() * height as f64];
            if [column, row].iter().any(|at| (at - at.round()).abs() < 1e-9) {
                continue;
            }
            let p = Point::new(column * scale, (height as f64 - row) * scale);
            assert_eq!(places.is_free(p), !occupied[row as usize * width + column as usize], "{name}: {p}");
            compared += 1;
        }
    }
}
