//! `planarium import`, and maps in place of scenarios.

use crate::program::{file, path, planarium, planarium_with, text_of};
use serde_json::{Value, json};

const YAML: &str =
    "image: room.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";

/// A wall of two cells in the middle of six by four.
const PGM: &[u8] = b"P2 6 4 1\n1 1 1 1 1 1\n1 1 1 1 1 1\n1 1 0 1 1 1\n1 1 0 1 1 1\n";

const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";
const SCEN: &str = "version 1\n2\tmaps/hall.map\t4\t3\t0\t1\t3\t1\t5.0\n";

/// A folder of its own with a map.
fn folder(name: &str) -> String {
    let _ = std::fs::remove_dir_all(path(name));
    std::fs::create_dir(path(name)).expect("the folder for test files can be written");
    file(&format!("{name}/room.yaml"), YAML);
    file(&format!("{name}/room.pgm"), PGM);
    file(&format!("{name}/hall.map"), MAP);
    file(&format!("{name}/hall.map.scen"), SCEN);
    name.to_owned()
}

#[test]
fn a_map_becomes_a_scenario_that_is_planned_in_and_verified() {
    let at = folder("import-map");
    let query = "--radius 0.2 --start 0.5,0.5 --goal 2.5,0.5";
    let printed = planarium(&format!("import {at}/room.yaml {query}"));
    let scenario = printed.json();
    assert_eq!(
        (printed.code, &scenario["format"], &scenario["name"]),
        (0, &json!("planarium-scenario-1"), &json!("room"))
    );
    assert_eq!(scenario["world"]["obstacles"].as_array().map(Vec::len), Some(1));
    assert_eq!(scenario["queries"], json!([{ "name": "given", "start": [0.5, 0.5], "goal": [2.5, 0.5] }]));
    for words in
        ["read ros-map: ", "22 free, 2 occupied, 0 unknown", "2 cells into 1 rectangles", "a disc of radius 0.2 m"]
    {
        assert!(printed.stderr.contains(words), "{words}: {}", printed.stderr);
    }
    // Both files in either order, and into a file.
    let both = planarium(&format!("import {at}/room.pgm {at}/room.yaml {query} --out {at}/room.json"));
    assert_eq!((both.code, &*both.stdout), (0, ""));
    assert_eq!(text_of(&format!("{at}/room.json")), printed.stdout);
    let planned = planarium(&format!("plan {at}/room.json --seed 2 --out {at}/result.json"));
    assert_eq!(planned.code, 0, "{}", planned.stderr);
    assert_eq!(planarium(&format!("verify {at}/room.json {at}/result.json")).code, 0);
    // Directly, with the same result but for its times.
    let direct = planarium(&format!("plan {at}/room.yaml --seed 2 {query}"));
    let saved: Value = serde_json::from_str(&text_of(&format!("{at}/result.json"))).expect("a result");
    assert_eq!((direct.code, &direct.json()["fingerprint"]), (0, &saved["fingerprint"]), "{}", direct.stderr);
    assert!(direct.stderr.starts_with("read ros-map: ") && direct.stderr.contains("\nsolved: "), "{}", direct.stderr);
    file(&format!("{at}/direct.json"), &direct.stdout);
    let verified = planarium(&format!("verify {at}/room.yaml {at}/direct.json {query}"));
    assert_eq!((verified.code, &verified.json()["valid"]), (0, &json!(true)), "{}", verified.stderr);
    // For a larger robot the same path is not free.
    let wider = planarium(&format!("verify {at}/room.yaml {at}/direct.json {}", query.replace("0.2", "0.45")));
    assert_eq!((wider.code, &wider.json()["valid"]), (1, &json!(false)), "{}", wider.stderr);
    let certified = planarium(&format!("certify {at}/room.yaml {query}"));
    assert_eq!((certified.code, &certified.json()["verdict"]), (0, &json!("connected")));
    let optimum = planarium(&format!("optimum {at}/room.yaml {query}"));
    assert!(optimum.json()["length"].as_f64().is_some_and(|length| length > 2.0), "{}", optimum.stderr);
}

#[test]
fn standard_input_and_output_are_files_as_well() {
    let at = folder("import-pipes");
    let grid = planarium_with("import - --scale 0.5 --start 0.2,0.2 --goal 1.2,0.2", "010\n000\n");
    assert_eq!((grid.code, &grid.json()["world"]["bounds"]["max"]), (0, &json!([1.5, 1])), "{}", grid.stderr);
    assert_eq!(planarium_with("plan -", &grid.stdout).code, 0);
    let direct = planarium_with("plan - --scale 0.5 --start 0.2,0.2 --goal 1.2,0.2", "010\n000\n");
    assert_eq!(direct.code, 0, "{}", direct.stderr);
    // The picture of a YAML file from standard input, and the other way round.
    let yaml = planarium_with(&format!("import - {at}/room.pgm"), YAML);
    assert_eq!(yaml.code, 0, "{}", yaml.stderr);
    let picture = planarium_with(&format!("import {at}/room.yaml -"), std::str::from_utf8(PGM).expect("plain"));
    assert_eq!((picture.code, &picture.json()["world"]), (0, &yaml.json()["world"]));
    planarium_with("import - -", "010\n").refuses("usage", "");
}

#[test]
fn scenarios_find_their_map_and_the_report_is_json_on_request() {
    let at = folder("import-scen");
    let read = planarium(&format!("import {at}/hall.map.scen --footprint 0.4x0.2 --report json"));
    let report: Value = serde_json::from_str(&read.stderr).expect("JSON");
    assert_eq!(report["queries"], json!([{ "name": "0", "bucket": 2, "length": 5.0 }]));
    assert_eq!(
        (&report["format"], &report["grid"]["occupied"], &report["obstacles"]["polygons"]),
        (&json!("moving-ai"), &json!(2), &json!(1))
    );
    assert_eq!(read.json()["queries"][0]["start"], json!([0.5, 1.5, 0]));
    let car = planarium(&format!(
        "import {at}/hall.map --car 0.8x0.4 --wheelbase 0.5 --steering 0.7 --start 0.5,0.5,1 --goal 3.5,0.5"
    ));
    assert_eq!(
        (&car.json()["robot"]["wheelbase"], &car.json()["robot"]["steering"]),
        (&json!(0.5), &json!([-0.7, 0.7]))
    );
    assert_eq!(car.json()["queries"][0]["goal"], json!([3.5, 0.5, 0]));
    let corners = planarium(&format!("import {at}/hall.map --footprint [[0.2,0],[-0.1,0.1],[-0.1,-0.1]]"));
    assert_eq!(corners.json()["robot"]["shape"]["vertices"].as_array().map(Vec::len), Some(3));
}

#[test]
fn wrong_files_are_refused_with_their_place() {
    let at = folder("import-wrong");
    let error = |line: &str, code: &str| {
        let finished = planarium(line);
        finished.refuses(code, "");
        finished.json()["error"].clone()
    };
    let cut = file("import-wrong/cut.map", MAP.trim_end_matches("....\n")).to_owned();
    assert_eq!(error(&format!("import {cut}"), "truncated")["place"], json!({ "line": 6 }));
    assert_eq!(error(&format!("plan {cut}"), "truncated")["file"], json!(cut));
    let yaml = file("import-wrong/other.yaml", YAML.replace("room.pgm", "gone.pgm")).to_owned();
    let missing = error(&format!("import {yaml}"), "missing-file");
    assert!(missing["message"].as_str().is_some_and(|message| message.contains("gone.pgm")), "{missing}");
    error(&format!("import {at}/room.yaml {at}/hall.map"), "unused-file");
    error(&format!("import {at}/hall.map --threshold 0.5"), "invalid-option");
    error("import room.json", "unknown-world");
    error("import no-such-file.map", "file");
    for line in
        ["import", "import a.map --radius 1 --car 2x1", "import a.map --start 1,1", "import a.map --footprint wide"]
    {
        error(line, "usage");
    }
    assert!(
        planarium(&format!("plan {at}/room.yaml"))
            .stderr
            .ends_with("error: the file has no query: --start and --goal make one\n")
    );
    // A scenario has its own robot and queries.
    error("plan room.json --radius 0.2", "usage");
    error("plan room.json --unknown free", "usage");
}

#[test]
fn no_input_is_overwritten() {
    let at = folder("import-files");
    for (line, name, code) in [
        (format!("import {at}/room.yaml --out {at}/room.yaml --force"), "room.yaml", "would-overwrite"),
        // The picture is an input that no argument names.
        (format!("import {at}/room.yaml --out {at}/room.pgm --force"), "room.pgm", "would-overwrite"),
        (
            format!("plan {at}/room.yaml --start 0.5,0.5 --goal 2,1.5 --out {at}/room.pgm --force"),
            "room.pgm",
            "would-overwrite",
        ),
        (format!("import {at}/hall.map --out {at}/room.pgm"), "room.pgm", "would-overwrite"),
    ] {
        planarium(&line).refuses(code, "");
        let wanted = if name == "room.yaml" { YAML.as_bytes() } else { PGM };
        assert_eq!(std::fs::read(path(&format!("{at}/{name}"))).expect("a file"), wanted, "{line}");
    }
}
