//! Small worlds of every format and errors of every kind, with their outcomes: the tests of the package read the same file
//! and must find the same bits. `PLANARIUM_BLESS=1` writes it anew.

use crate::dxf::every_kind;
use crate::files::*;
use crate::geojson::HOUSE;
use crate::rmf::BUILDING;
use crate::svg::STYLED;
use crate::wkt::ROOM;
use planarium::json;
use planarium_formats::{Code, File, FormatError, MAX_FILES, Options, World, read};
use serde_json::{Value, json};
use std::path::Path;

/// A world: a name, its files, and the options as JSON.
type Case = (&'static str, Vec<(&'static str, Vec<u8>)>, Value);

fn cases() -> Vec<Case> {
    let grey = |pixels: &[u8]| png(4, 2, png::ColorType::Grayscale, png::BitDepth::Eight, pixels);
    let pixels = [0, 255, 255, 0, 255, 255, 200, 90];
    let map = || vec![("maps/map.yaml", YAML.into()), ("map.pgm", PGM.to_vec())];
    let one = |name, bytes: &[u8]| vec![(name, bytes.to_vec())];
    let yaml = |from: &str, to: &str| one("map.yaml", YAML.replace(from, to).as_bytes());
    let query = json!({ "start": [0.25, 2.25], "goal": [0.75, 3.25] });
    vec![
        ("a map of ROS", map(), json!({})),
        ("its picture first", map().into_iter().rev().collect(), json!({ "unknown": "free" })),
        (
            "a disc in it",
            map(),
            json!({ "robot": { "type": "disc", "radius": 0.01 }, "start": [0.1, 2.6], "goal": [0.4, 2.9] }),
        ),
        ("a disc and its margin in it", map(), json!({ "robot": { "type": "disc", "radius": 0.01 }, "margin": 0.02 })),
        ("a margin that is none", map(), json!({ "margin": -1 })),
        ("a point in it", map(), json!({ "robot": { "type": "point" } })),
        (
            "a footprint in it",
            map(),
            json!({ "robot": { "type": "footprint", "corners": [[0.1, 0], [-0.1, 0.05], [-0.1, -0.05]] } }),
        ),
        ("a car in it", map(), json!({ "robot": { "type": "car", "length": 0.2, "width": 0.1 } })),
        (
            "a car with all its measures",
            map(),
            json!({ "robot": { "type": "car", "length": 0.2, "width": 0.1, "wheelbase": 0.11, "steering": 0.5 } }),
        ),
        (
            "a map of MovingAI",
            vec![("small.map.scen", SCEN.into()), ("small.map", MAP.into())],
            json!({ "scale": 0.5 }),
        ),
        ("a picture", one("plan.png", &grey(&pixels)), json!({ "threshold": 0.3, "scale": 0.1 })),
        ("a picture, simplified", one("plan.png", &grey(&pixels)), json!({ "min_island": 2, "simplify": 1 })),
        ("a bitmap", one("plan.bmp", &bmp(3, 2, &[0, 255, 255, 255, 0, 255])), json!({})),
        ("a NumPy array", one("grid.npy", &npy("|u1", 2, 3, &[0, 1, 0, 0, 0, 0])), json!({})),
        ("a grid", one("grid.csv", b"0,1,0\n0,0,-1\n"), json!({ "scale": 2 })),
        ("a parking case", one("case.csv", PARKING.as_bytes()), json!({})),
        ("obstacles of Modern Robotics", one("obstacles.csv", MODERN.as_bytes()), json!({})),
        ("a grid of OMPL", one("env.txt", OMPL_GRID.as_bytes()), json!({})),
        ("circles of OMPL", vec![("c.txt", CIRCLES.into()), ("q.txt", QUERIES.into())], json!({})),
        ("a drawing as SVG", one("page.svg", STYLED.as_bytes()), json!({ "scale": 0.1, "tolerance": 0.01 })),
        ("a drawing as DXF", one("plan.dxf", every_kind().as_bytes()), json!({ "fill": ["a"], "wall_thickness": 0.2 })),
        (
            "GeoJSON",
            one("house.geojson", HOUSE.as_bytes()),
            json!({ "coordinates": "metres", "filters": [{ "key": "type", "value": "window", "keep": false }] }),
        ),
        (
            "degrees",
            one("point.wkt", b"SRID=4326;LINESTRING (13.0 52.0, 13.001 52.001)"),
            json!({ "layers": ["lines"] }),
        ),
        ("WKT", one("room.wkt", ROOM.as_bytes()), json!({ "walkable": true })),
        ("a building", one("office.building.yaml", BUILDING.as_bytes()), json!({ "level": "L1" })),
        ("no world", one("letter.txt", b"Dear reader"), json!({})),
        ("a picture is missing", one("maps/map.yaml", YAML.as_bytes()), json!({})),
        ("a file too many", vec![("plan.pgm", PGM.to_vec()), ("small.map", MAP.into())], json!({})),
        ("many files", (0..=MAX_FILES).map(|_| ("plan.pgm", PGM.to_vec())).collect(), json!({})),
        ("an end too early", one("plan.pgm", &PGM[..PGM.len() - 3]), json!({})),
        ("an empty file", one("plan.pgm", b""), json!({})),
        ("a mode that is none", yaml("negate: 0", "negate: maybe"), json!({})),
        ("a number out of range", yaml("0.65", "1.5"), json!({})),
        ("30000 x 30000 pixels", one("plan.pgm", b"P5 30000 30000 255\n"), json!({})),
        ("a version of MovingAI that is not read", one("big.map", MAP.replace("octile", "hex").as_bytes()), json!({})),
        (
            "scenarios of another map",
            vec![("small.map", MAP.into()), ("s.scen", SCEN.replace("5\t4\t", "9\t9\t").into())],
            json!({}),
        ),
        ("a scale that is none", map(), json!({ "scale": -1 })),
        ("a start alone", map(), json!({ "start": [0, 0] })),
        ("a query outside", map(), query),
        ("a query that no scenario has", map(), json!({ "start": [1e300, 0.5], "goal": [1.5, 0.5] })),
        (
            "a robot without area",
            map(),
            json!({ "robot": { "type": "footprint", "corners": [[0, 0], [1, 1], [2, 2]] } }),
        ),
    ]
}

/// What comes out: a scenario, a report and the sum of the cells, each with the place of its row; or an error.
fn outcome(files: &[(&str, Vec<u8>)], options: &Value) -> Value {
    let options: Options = json::read(options).expect("options");
    let files: Vec<File> = files.iter().map(|(name, bytes)| File { name, bytes }).collect();
    match read(&files, &options) {
        Ok(World { scenario, report, grid }) => {
            let document: Value = serde_json::from_str(&scenario.to_json_string()).expect("JSON");
            let cells = grid.map(|grid| grid.cells().iter().map(|&cell| cell as u8).collect::<Vec<u8>>());
            json!({ "scenario": document, "report": report, "cells": cells })
        }
        Err(error) => json!({ "error": thrown(&error) }),
    }
}

fn thrown(error: &FormatError) -> Value {
    let mut fields = json!({ "code": error.code().as_str(), "message": error.message() });
    let mut set = |key: &str, value: Option<Value>| {
        if let Some(value) = value {
            fields[key] = value;
        }
    };
    set("file", error.file().map(Into::into));
    set("place", error.place().map(|place| json!(place)));
    set("wanted", error.wanted().map(Into::into));
    fields
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Some editors write a mark of three bytes before a text.
#[test]
fn a_byte_order_mark_before_a_file_changes_nothing() {
    let mut read = 0;
    for (name, files, options) in cases() {
        let marked: Vec<_> =
            files.iter().map(|(name, bytes)| (*name, [b"\xef\xbb\xbf", &bytes[..]].concat())).collect();
        let [plain, marked] = [outcome(&files, &options), outcome(&marked, &options)];
        for part in ["scenario", "cells"] {
            assert_eq!(plain[part], marked[part], "{name}");
        }
        for part in ["code", "file", "wanted"] {
            assert_eq!(plain["error"][part], marked["error"][part], "{name}");
        }
        let places = [&plain, &marked].map(|outcome| outcome["error"]["place"]["byte"].as_u64());
        assert_eq!(places[0].map(|byte| byte + 3), places[1], "{name}");
        read += usize::from(!plain["scenario"].is_null());
    }
    assert!(read > 18, "{read}");
}

#[test]
fn outcomes_are_those_of_the_file() {
    let found: Vec<Value> = cases()
        .into_iter()
        .map(|(name, files, options)| {
            let outcome = outcome(&files, &options);
            let files: Vec<Value> =
                files.iter().map(|(name, bytes)| json!({ "name": name, "hex": hex(bytes) })).collect();
            json!({ "case": name, "files": files, "options": options, "outcome": outcome })
        })
        .collect();
    let codes = |case: &Value| case["outcome"]["error"]["code"].as_str().map(str::to_owned);
    let thrown: Vec<String> = found.iter().filter_map(codes).collect();
    // That of paths is refused in their tests.
    for code in Code::ALL.iter().filter(|code| **code != Code::WrongColumns) {
        assert!(thrown.iter().any(|thrown| thrown == code.as_str()), "no case has the code {}", code.as_str());
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/golden-worlds.json");
    let lines: Vec<String> = found.iter().map(Value::to_string).collect();
    let text = format!("[\n{}\n]\n", lines.join(",\n"));
    if std::env::var_os("PLANARIUM_BLESS").is_some() {
        std::fs::write(&path, &text).expect("the file is written");
    }
    let committed = std::fs::read_to_string(&path).expect("tests/golden-worlds.json");
    let committed: Vec<&str> = committed.lines().collect();
    for (line, (found, name)) in text.lines().zip(committed).enumerate() {
        assert_eq!(found, name, "line {}", line + 1);
    }
}
