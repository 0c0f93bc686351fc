//! `planarium import`, and maps in place of scenarios.

use crate::program::{file, path, planarium, planarium_with, program, text_of};
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

/// A margin is for maps and for documents; a fleet has none.
#[test]
fn a_margin_makes_the_robot_larger_wherever_there_is_one() {
    let at = folder("import-margin");
    let query = "--radius 0.2 --start 0.5,0.5 --goal 2.5,0.5";
    let printed = planarium(&format!("import {at}/room.yaml {query} --margin 0.1 --out {at}/wide.json"));
    assert!(printed.stderr.contains("a disc of radius 0.2 m; a margin of 0.1 m"), "{}", printed.stderr);
    let wide: Value = serde_json::from_str(&text_of(&format!("{at}/wide.json"))).expect("JSON");
    assert_eq!(wide["robot"], json!({ "type": "disc", "radius": 0.2, "margin": 0.1 }));
    planarium(&format!("import {at}/room.yaml {query} --out {at}/room.json"));
    // The same by the map, the document with a margin, and the one without; and for all that check a path.
    let mut found = Vec::new();
    for (world, margin) in [
        (format!("{at}/room.yaml {query}"), "--margin 0.1"),
        (format!("{at}/room.json"), "--margin 0.1"),
        (format!("{at}/wide.json"), ""),
        (format!("{at}/wide.json"), "--margin 0.1"),
    ] {
        let planned = planarium(&format!("plan {world} {margin} --seed 1"));
        assert_eq!((planned.code, &planned.json()["margin"]), (0, &json!(0.1)), "{}", planned.stderr);
        file(&format!("{at}/result.json"), &planned.stdout);
        let words: Vec<&str> = world.split(' ').collect();
        let verify = |more: &str| {
            let line = format!("verify {} {at}/result.json {} {more}", words[0], words[1..].join(" "));
            planarium(&line)
        };
        assert_eq!(verify(margin).code, 0, "{world}");
        let other = verify("--margin 0.05");
        assert!(other.code == 1 && other.stdout.contains("it is for a margin of 0.1 m"), "{}", other.stdout);
        let optimum = planarium(&format!("optimum {world} {margin}"));
        let certified = planarium(&format!("certify {world} {margin}"));
        assert_eq!(certified.json()["verdict"], json!("connected"), "{}", certified.stderr);
        found.push((planned.json()["path"].clone(), optimum.json()["length"].clone()));
    }
    assert!(found.iter().all(|same| *same == found[0]), "{found:?}");
    planarium(&format!("plan {at}/room.json --margin 0.35")).refuses("start-in-collision", "/queries/0/start");
    // An arm has one as well.
    assert_eq!(planarium("plan firs.json --margin 0.001").json()["margin"], json!(0.001));
    let ring = planarium("generate ring --set count=3 --seed 1");
    file(&format!("{at}/ring.json"), &ring.stdout);
    planarium(&format!("verify {at}/ring.json {at}/result.json --margin 0.1")).refuses("usage", "");
    for wrong in ["-0.1", "wide", "nan"] {
        planarium(&format!("plan {at}/room.json --margin {wrong}")).refuses("usage", "");
    }
    planarium(&format!("plan {at}/room.json --margin 1e7")).refuses("out-of-range", "/robot/margin");
    planarium(&format!("plan {at}/room.yaml {query} --margin 1e7")).refuses("invalid-option", "");
}

/// Blanks after commas, a byte order mark before a document, and what is no file.
#[test]
fn what_people_write_and_name_is_understood() {
    let at = folder("import-people");
    let map = format!("{at}/room.yaml");
    let spaced = program(&["import", &map, "--radius", " 0.2", "--start", "0.5, 0.5", "--goal", " 2.5 , 0.5 "]);
    let plain = planarium(&format!("import {map} --radius 0.2 --start 0.5,0.5 --goal 2.5,0.5"));
    assert_eq!((spaced.code, &spaced.stdout), (0, &plain.stdout), "{}", spaced.stderr);
    program(&["import", &map, "--start", "0.5,,0.5", "--goal", "1,1"]).refuses("usage", "");
    program(&["import", &map, "--start", "0.5 0.5", "--goal", "1,1"]).refuses("usage", "");
    let body = program(&["import", &map, "--footprint", "0.9 x 0.62"]);
    assert_eq!(body.stdout, planarium(&format!("import {map} --footprint 0.9x0.62")).stdout, "{}", body.stderr);
    let near = program(&["nearest", "arm.json", "--target", "0.1, -0.2", "--samples", "10"]);
    assert_eq!(near.code, 0, "{}", near.stderr);
    let marked = file(&format!("{at}/marked.json"), format!("\u{feff}{}", plain.stdout)).to_owned();
    assert_eq!(planarium(&format!("plan {marked}")).code, 0);
    // A folder, and a pipe, in place of the picture.
    for what in ["a folder", "a pipe or a device"] {
        let picture = path(&format!("{at}/room.pgm"));
        let _ = std::fs::remove_file(&picture);
        if what == "a folder" {
            std::fs::create_dir(&picture).expect("a folder can be made");
        } else {
            std::fs::remove_dir(&picture).expect("it is there");
            let made = std::process::Command::new("mkfifo").arg(&picture).status();
            assert!(made.is_ok_and(|status| status.success()), "a pipe can be made");
        }
        for command in ["import", "plan"] {
            let refused = planarium(&format!("{command} {map} --start 0.5,0.5 --goal 2.5,0.5"));
            refused.refuses("file", "");
            assert!(refused.stderr.contains(&format!("room.pgm\": it is {what}, not a file")), "{}", refused.stderr);
        }
    }
    let folder = planarium(&format!("plan {at}"));
    folder.refuses("file", "");
    assert!(folder.stderr.contains("it is a folder"), "{}", folder.stderr);
}

/// The report about a map, in either form, from every command that reads one.
#[test]
fn every_command_that_reads_a_map_reports_about_it() {
    let at = folder("import-report");
    let query = "--radius 0.2 --start 0.5,0.5 --goal 2.5,0.5";
    let report =
        |stderr: &str| -> Value { serde_json::from_str(stderr.lines().next().expect("a line")).expect("JSON") };
    let imported = report(&planarium(&format!("import {at}/room.yaml {query} --report json")).stderr);
    file(&format!("{at}/result.json"), planarium(&format!("plan {at}/room.yaml {query}")).stdout);
    for line in ["plan MAP", "certify MAP", "optimum MAP", "widest MAP", "route-graph MAP", "verify MAP RESULT"] {
        let line = line.replace("MAP", &format!("{at}/room.yaml")).replace("RESULT", &format!("{at}/result.json"));
        let printed = planarium(&format!("{line} {query} --report json"));
        assert_eq!((printed.code, report(&printed.stderr)), (0, imported.clone()), "{line}: {}", printed.stderr);
    }
    planarium("plan room.json --report json").refuses("usage", "");
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
fn drawings_are_imported_by_layer_and_feature() {
    let house = r#"{"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"type": "wall"}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [9, 0]]}},
        {"type": "Feature", "properties": {"type": "window"}, "geometry": {"type": "LineString", "coordinates": [[9, 0], [9, 5]]}},
        {"type": "Feature", "properties": {"type": "door"}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [0, 5]]}}]}"#;
    let house = file("import-house.geojson", house).to_owned();
    let walls = |options: &str| {
        let read = planarium(&format!("import {house} {options}"));
        assert_eq!(read.code, 0, "{}", read.stderr);
        read.json()["world"]["obstacles"].as_array().expect("a list").clone()
    };
    let wall = |x: f64, y: f64, from: f64, width: f64| json!({ "type": "wall", "points": [[from, 0], [x, y]], "width": width });
    let same = |found: &[Value], wanted: &[Value]| {
        assert_eq!(found.len(), wanted.len());
        for (found, wanted) in found.iter().zip(wanted) {
            for key in ["type", "points", "width"] {
                assert_eq!(found[key].to_string().replace(".0", ""), wanted[key].to_string().replace(".0", ""));
            }
        }
    };
    same(&walls(""), &[wall(9.0, 0.0, 0.0, 0.0), wall(9.0, 5.0, 9.0, 0.0)]);
    same(&walls("--filter type!=window --wall-thickness 0.2"), &[wall(9.0, 0.0, 0.0, 0.2), wall(0.0, 5.0, 0.0, 0.2)]);
    same(&walls("--layers door,wall"), &[wall(9.0, 0.0, 0.0, 0.0), wall(0.0, 5.0, 0.0, 0.0)]);
    let planned = planarium(&format!("plan {house} --coordinates metres --start -0.2,-0.2 --goal 4,0.2"));
    assert_eq!(planned.code, 0, "{}", planned.stderr);

    let floor = file("import-floor.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9), (3 3, 6 3, 6 6))").to_owned();
    let holes = |options: &str| {
        let read = planarium(&format!("import {floor} {options}"));
        read.json()["world"]["obstacles"].as_array().map(Vec::len)
    };
    assert_eq!((holes(""), holes("--walkable"), holes("--walkable=no")), (Some(2), Some(2), Some(1)));
    planarium(&format!("import {floor} --level L1")).refuses("invalid-option", "");
    planarium(&format!("import {floor} --layers rooms")).refuses("invalid-option", "");
    planarium(&format!("import {floor} --wall-thickness -1")).refuses("usage", "");
    planarium(&format!("import {floor} --walkable=maybe")).refuses("usage", "");
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

#[test]
fn paths_of_other_programs_are_judged_on_a_map() {
    let at = folder("import-paths");
    let verify = |path: &str, more: &str| planarium(&format!("verify {at}/hall.map {at}/{path} {more}"));
    // Around the two blocked cells, and through them.
    file(&format!("{at}/around.csv"), "x,y\n0.5,1.5\n0.5,2.5\n3.5,2.5\n");
    file(&format!("{at}/through.csv"), "x,y\n0.5,1.5\n3.5,1.5\n");
    let around = verify("around.csv", "--radius 0.25");
    let verdict = around.json();
    assert_eq!(
        (around.code, &verdict["valid"], &verdict["free"]),
        (0, &json!(true), &json!(true)),
        "{}",
        around.stderr
    );
    assert_eq!((&verdict["waypoints"], &verdict["contact"]), (&json!(3), &Value::Null));
    assert!(verdict["clearance"]["distance"].as_f64().is_some_and(|d| (d - 0.25).abs() < 1e-3), "{verdict}");
    assert_eq!(verdict["read"]["format"], "table");
    assert!(around.stderr.contains("free: 3 waypoints; least clearance 0.25"), "{}", around.stderr);
    let through = verify("through.csv", "--radius 0.25");
    let contact = &through.json()["contact"];
    assert_eq!((through.code, &contact["edge"], &contact["with"]["obstacle"]), (1, &json!(0), &json!(0)));
    assert!(contact["fraction"].as_f64().is_some_and(|t| (3.0 * t - 0.25).abs() < 1e-6), "{contact}");
    assert!(through.stderr.contains("touches obstacle 0 at (1"), "{}", through.stderr);
    // A car, along arcs and not.
    file(&format!("{at}/turn.csv"), "x,y,theta_deg\n0.5,0.5,0\n1.5,0.5,0\n1.6,0.6,90\n");
    let turn = verify("turn.csv", "--car 0.3x0.2 --arcs");
    assert_eq!((turn.code, &turn.json()["free"], &turn.json()["turns"]["count"]), (1, &json!(true), &json!(1)));
    assert_eq!(turn.json()["turns"]["first"][0]["fault"], "too-tight");
    // Of a map and a path, the errors have the place; options of paths are for paths.
    file(&format!("{at}/broken.csv"), "x,y\n0.5,1.5\n1\n");
    let broken = verify("broken.csv", "--radius 0.25");
    let error = &broken.json()["error"];
    assert_eq!((broken.code, &error["code"], &error["place"]), (2, &json!("truncated"), &json!({ "line": 3 })));
    let arcs = verify("turn.csv", "--radius 0.1 --arcs");
    let error = &arcs.json()["error"];
    assert_eq!((arcs.code, &error["code"], &error["pointer"]), (2, &json!("unsupported"), &json!("/arcs")));
    planarium("verify room.json room.json --arcs").refuses("usage", "");
}

#[test]
fn a_map_has_a_route_graph() {
    let at = folder("route-graph");
    let made =
        planarium(&format!("route-graph {at}/room.yaml --radius 0.2 --samples 100 --speed-limit 0.8 --frame-id hall"));
    let graph = made.json();
    assert_eq!((made.code, &graph["type"], &graph["name"]), (0, &json!("FeatureCollection"), &json!("room")));
    for words in ["route graph: ", " nodes, ", " connections, ", "times those over the roadmap", "% of free places"] {
        assert!(made.stderr.contains(words), "{words}: {}", made.stderr);
    }
    let features = graph["features"].as_array().expect("features");
    assert_eq!(features[0]["properties"], json!({ "id": 1, "frame": "hall" }));
    let edge = &features[features.len() - 1]["properties"];
    assert_eq!((&edge["id"], &edge["metadata"]), (&features.len().into(), &json!({ "abs_speed_limit": 0.8 })));
    let about = &graph["route_graph"];
    assert_eq!((&about["robot"]["type"], &about["samples"], &about["seed"]), (&json!("disc"), &json!(100), &json!(0)));

    let of = |line: &str| planarium(&format!("route-graph {at}/room.yaml --samples 30 {line}"));
    assert_eq!(of("--footprint 0.6x0.3 --seed 4").json()["route_graph"]["seed"], 4);
    for (line, code, pointer) in [
        ("--detour 0.5", "out-of-range", "/detour"),
        ("--detour much", "wrong-type", "/detour"),
        ("--leg -1", "out-of-range", "/longest_leg"),
        ("--speed-limit 0", "invalid-option", ""),
        ("--car 0.6x0.3", "unsupported", "/robot/type"),
    ] {
        let (refused, code, pointer) = (of(line), json!(code), json!(pointer));
        let error = &refused.json()["error"];
        assert_eq!((refused.code, &error["code"], &error["pointer"]), (2, &code, &pointer), "{line}");
    }
    let none = of("--radius 5");
    assert_eq!((none.code, none.stdout.as_str()), (1, ""), "{}", none.stderr);
}
