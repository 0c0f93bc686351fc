//! Changed files of every format are read or refused, without a panic: a few thousand of each, with `PLANARIUM_DEEP=1`
//! a million together. The corpus of the fuzzers is tried as well.

use crate::documents::deep;
use crate::drawings::DRAWING;
use crate::dxf::every_kind;
use crate::files::*;
use crate::fuzzed;
use crate::geojson::HOUSE;
use crate::rmf::BUILDING;
use crate::svg::STYLED;
use crate::wkt::ROOM;
use png::{BitDepth, ColorType};

/// The changes of each file, and with `PLANARIUM_DEEP=1`.
const CHANGES: [usize; 2] = [2_000, 70_000];

/// Numbers that readers may not expect.
const ODD: [&str; 15] = [
    "-1",
    "0",
    "1e309",
    "nan",
    "-inf",
    "99999999999999999999",
    "4294967296",
    "65536",
    "1e-320",
    "0.5",
    "",
    "30000",
    "1e300",
    "1e-300",
    "1.7e308",
];

/// A few changes of bytes, pieces and numbers.
fn changed(original: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = original.to_vec();
    for _ in 0..1 + random.below(3) {
        if bytes.is_empty() {
            break;
        }
        let at = random.below(bytes.len());
        let end = at + random.below((bytes.len() - at).min(16) + 1);
        match random.below(8) {
            0 => bytes[at] ^= 1 << random.below(8),
            1 => bytes[at] = random.bits() as u8,
            2 => bytes[at] = b"0123456789 -.\n\t,#@:[]"[random.below(21)],
            3 => drop(bytes.drain(at..end)),
            4 => {
                let piece = bytes[at..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, piece);
            }
            5 => bytes.truncate(at),
            6 => {
                // A number becomes another one.
                let is_digit = |byte: &u8| byte.is_ascii_digit();
                let Some(start) = bytes[at..].iter().position(is_digit).map(|offset| at + offset) else { continue };
                let length = bytes[start..].iter().take_while(|byte| is_digit(byte)).count();
                bytes.splice(start..start + length, ODD[random.below(ODD.len())].bytes());
            }
            _ => bytes.insert(at, random.bits() as u8),
        }
    }
    bytes
}

/// Makes the checksums of a PNG's chunks right, so that changes reach the decoder.
fn with_checksums(bytes: &mut [u8]) {
    let mut at = 8;
    while at + 12 <= bytes.len() {
        let length = u32::from_be_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]) as usize;
        let Some(end) = at.checked_add(8 + length).filter(|end| end + 4 <= bytes.len()) else { break };
        let mut crc = u32::MAX;
        for byte in &bytes[at + 4..end] {
            crc ^= u32::from(*byte);
            for _ in 0..8 {
                crc = (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg());
            }
        }
        bytes[end..end + 4].copy_from_slice(&(!crc).to_be_bytes());
        at = end + 4;
    }
}

/// Tries changes of a file.
fn try_changes(name: &str, original: &[u8], target: fn(&[u8]), seed: u64) {
    target(original);
    let mut random = Random(0x9e37_79b9_7f4a_7c15 ^ seed);
    for i in 0..CHANGES[usize::from(deep())] {
        let mut bytes = changed(original, &mut random);
        if original.starts_with(b"\x89PNG") && random.below(4) > 0 {
            with_checksums(&mut bytes);
        }
        let result = std::panic::catch_unwind(|| target(&bytes));
        if result.is_err() {
            panic!("change {i} of {name} is not survived: {bytes:?}");
        }
    }
}

#[test]
fn changed_text_is_survived() {
    try_changes("YAML", YAML.as_bytes(), fuzzed::metadata, 1);
    try_changes("MovingAI map", MAP.as_bytes(), fuzzed::alone, 2);
    try_changes("MovingAI scenarios", SCEN.replace("\t5\t4\t", "\t3\t2\t").as_bytes(), fuzzed::scenarios, 3);
    try_changes("parking case", PARKING.as_bytes(), fuzzed::alone, 4);
    try_changes("Modern Robotics", MODERN.as_bytes(), fuzzed::alone, 5);
    try_changes("grid of OMPL", OMPL_GRID.as_bytes(), fuzzed::alone, 6);
    try_changes("circles of OMPL", CIRCLES.as_bytes(), fuzzed::alone, 7);
    try_changes("queries of OMPL", QUERIES.as_bytes(), fuzzed::queries, 8);
    try_changes("grid", b"0,1,0\n0,0,1\n-1,0,0\n", fuzzed::alone, 9);
}

#[test]
fn changed_drawings_are_survived() {
    try_changes("GeoJSON", HOUSE.as_bytes(), fuzzed::drawing, 17);
    try_changes("WKT", ROOM.as_bytes(), fuzzed::drawing, 18);
    let crossing =
        "POLYGON ((0 0, 4 4, 4 0, 0 4), (1 1, 5 1, 1 2)), LINESTRING Z (0 0 1, 2 2 1) MULTIPOINT ((1 1), 2 2)";
    try_changes("WKT of areas that cross", crossing.as_bytes(), fuzzed::drawing, 19);
    try_changes("building", BUILDING.as_bytes(), fuzzed::drawing, 20);
    try_changes("SVG", STYLED.as_bytes(), fuzzed::drawing, 21);
    try_changes("SVG of curves", DRAWING.as_bytes(), fuzzed::drawing, 22);
    try_changes("DXF", every_kind().as_bytes(), fuzzed::drawing, 23);
}

#[test]
fn changed_paths_are_survived() {
    try_changes("table", b"# a path\nt,x [cm],y,theta_deg\n0,1,2,3\n0.5,-1e2,2.5,90\n1,3,4,-5\n", fuzzed::path, 24);
    try_changes("rows", b"0 1 2 3\n1 2 3 4\n2 3 4 5\n", fuzzed::path, 25);
    try_changes("array of a path", &npy("<f8", 3, 2, &[0; 48]), fuzzed::path, 26);
    try_changes("poses", crate::paths::POSES.as_bytes(), fuzzed::path, 27);
    try_changes("poses as JSON", crate::paths::POSES_JSON.as_bytes(), fuzzed::path, 28);
    try_changes("line", crate::paths::LINE.as_bytes(), fuzzed::path, 29);
    try_changes("points", crate::paths::POINTS.as_bytes(), fuzzed::path, 30);
    try_changes("lists", b"{\"path\": [[0, 1], [2.5, -3e-1], [4, 5]]}", fuzzed::path, 31);
}

#[test]
fn changed_pictures_are_survived() {
    let grey = [0, 255, 255, 205, 255, 255, 255, 0, 255, 0, 255, 255];
    let rgba: Vec<u8> = (0..48).map(|i| (i * 37) as u8).collect();
    try_changes("PGM", PGM, fuzzed::picture, 10);
    try_changes("plain PGM", b"P2\n# a\n3 2\n9\n0 1 9\n3 4 5\n", fuzzed::alone, 11);
    try_changes("PNG", &png(4, 3, ColorType::Grayscale, BitDepth::Eight, &grey), fuzzed::picture, 12);
    try_changes("PNG of colours", &png(4, 3, ColorType::Rgba, BitDepth::Eight, &rgba), fuzzed::alone, 13);
    try_changes(
        "PNG of a palette",
        &png(4, 1, ColorType::Indexed, BitDepth::Two, &[0b00_01_10_01]),
        fuzzed::picture,
        14,
    );
    try_changes("BMP", &bmp(4, 3, &grey), fuzzed::picture, 15);
    try_changes("array", &npy("|u1", 2, 3, &[0, 1, 0, 0, 0, 1]), fuzzed::alone, 16);
}

#[test]
fn the_corpus_of_the_fuzzers_is_survived() {
    type Target = fn(&[u8]);
    let targets: [(&str, Target); 10] = [
        ("world_alone", fuzzed::alone),
        ("world_picture", fuzzed::picture),
        ("world_metadata", fuzzed::metadata),
        ("world_scenarios", fuzzed::scenarios),
        ("world_queries", fuzzed::queries),
        ("world_geojson", fuzzed::drawing),
        ("world_wkt", fuzzed::drawing),
        ("world_building", fuzzed::drawing),
        ("world_svg", fuzzed::drawing),
        ("world_dxf", fuzzed::drawing),
    ];
    for (name, target) in targets {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(name);
        let files: Vec<_> = std::fs::read_dir(folder).expect("a folder").collect();
        assert!(!files.is_empty(), "{name} has a corpus");
        for file in files {
            let path = file.expect("a file").path();
            println!("{}", path.display());
            target(&std::fs::read(path).expect("a file"));
        }
    }
}
