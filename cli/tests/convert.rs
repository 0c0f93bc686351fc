//! `planarium convert`: paths in the coordinates of the imported file, which `planarium verify` finds free again.

use crate::program::{file, path, planarium, text_of};
use serde_json::{Value, json};

/// A wall of two cells in the middle of six by four, as of a map that is turned by 0.3 rad about a place far from the origin.
const TURNED: &str = "image: turned.pgm\nresolution: 0.5\norigin: [-3.0, 2.0, 0.3]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";
const PGM: &[u8] = b"P2 6 4 1\n1 1 1 1 1 1\n1 1 1 1 1 1\n1 1 0 1 1 1\n1 1 0 1 1 1\n";
const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";

/// A house of some 67 by 111 m in longitude and latitude, with a wall from its southern side.
const HOUSE: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[13.0, 52.0], [13.001, 52.0]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[13.0, 52.001], [13.001, 52.001]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[13.0005, 52.0], [13.0005, 52.0005]]}}]}"#;

/// A drawing in metres far from the origin, as those of national grids.
const FAR: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[4500000, 5800000], [4500010, 5800000]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[4500000, 5800010], [4500010, 5800010]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[4500005, 5800000], [4500005, 5800006]]}}]}"#;

/// A world: its files, the first of which is the map; options of a disc, of a rectangle and of none; start and goal as given.
struct Case {
    files: Vec<(&'static str, Vec<u8>)>,
    options: &'static str,
    robots: [&'static str; 2],
    start: [f64; 2],
    goal: [f64; 2],
}

fn cases() -> Vec<Case> {
    // The corner of the turned map is at (-3, 2).
    let (sin, cos) = 0.3_f64.sin_cos();
    let turned = |x: f64, y: f64| [-3.0 + cos * x - sin * y, 2.0 + sin * x + cos * y];
    let rows = ["--radius 0.1", "--footprint 0.3x0.2"];
    vec![
        Case {
            files: vec![("turned.yaml", TURNED.into()), ("turned.pgm", PGM.to_vec())],
            options: "",
            robots: rows,
            start: turned(0.5, 0.5),
            goal: turned(2.5, 0.5),
        },
        Case {
            files: vec![("picture.pgm", PGM.to_vec())],
            options: "--scale 0.5",
            robots: rows,
            start: [0.5, 0.5],
            goal: [2.5, 0.5],
        },
        Case { files: vec![("hall.map", MAP.into())], options: "", robots: rows, start: [0.5, 1.5], goal: [3.5, 1.5] },
        Case {
            files: vec![("house.geojson", HOUSE.into())],
            options: "",
            robots: ["--radius 1", "--footprint 3x2"],
            start: [13.0001, 52.0001],
            goal: [13.0009, 52.0001],
        },
        Case {
            files: vec![("far.geojson", FAR.into())],
            options: "--coordinates metres",
            robots: rows,
            start: [4_500_001.0, 5_800_001.0],
            goal: [4_500_009.0, 5_800_001.0],
        },
        Case {
            files: vec![("far.geojson", FAR.into())],
            options: "--coordinates metres --scale 0.01",
            robots: ["--radius 0.001", "--footprint 0.003x0.002"],
            start: [45_000.01, 58_000.01],
            goal: [45_000.09, 58_000.01],
        },
    ]
}

/// The first and the last position of a line of GeoJSON.
fn ends(text: &str) -> [Value; 2] {
    let document: Value = serde_json::from_str(text).expect("JSON");
    let line = document["features"][0]["geometry"]["coordinates"].as_array().expect("a line").clone();
    [line[0].clone(), line[line.len() - 1].clone()]
}

/// The path of a plan in a map, or in the scenario that was saved from it, is in the coordinates of the map in every form that is
/// read: there it is free, and the other way round it would not be found again.
#[test]
fn an_exported_path_is_free_in_the_map_that_it_comes_from() {
    for (i, Case { files, options, robots, start, goal }) in cases().into_iter().enumerate() {
        let at = format!("convert-{i}");
        let _ = std::fs::remove_dir_all(path(&at));
        std::fs::create_dir(path(&at)).expect("the folder for test files can be written");
        for (name, bytes) in &files {
            file(&format!("{at}/{name}"), bytes);
        }
        let map = format!("{at}/{}", files[0].0);
        for robot in robots {
            let query = format!("--start {},{} --goal {},{}", start[0], start[1], goal[0], goal[1]);
            let world = format!("{map} {options} {robot} {query}");
            let imported = planarium(&format!("import {world} --out {at}/saved.json --force"));
            assert_eq!(imported.code, 0, "{}", imported.stderr);
            let planned = planarium(&format!("plan {at}/saved.json --seed 3 --out {at}/result.json"));
            assert_eq!(planned.code, 0, "{}", planned.stderr);
            for form in ["csv", "json", "npy", "geojson", "nav-path", "nav-waypoints"] {
                let out = format!("{at}/path.{form}");
                let saved =
                    planarium(&format!("convert {at}/saved.json {at}/result.json --to {form} --out {out} --force"));
                assert_eq!((saved.code, &*saved.stdout), (0, ""), "{}", saved.stderr);
                // The map itself gives the same, and both are verified.
                let direct = format!("{at}/direct.{form}");
                let words: Vec<&str> = world.split(' ').filter(|word| !word.is_empty()).collect();
                let own = words[1..].join(" ");
                let line = format!("convert {map} {at}/result.json {own} --to {form} --out {direct} --force");
                assert_eq!(planarium(&line).code, 0, "{line}");
                let [one, other] = [&out, &direct].map(|name| std::fs::read(path(name)).expect("it is written"));
                assert!(one == other, "{form} {world}");
                for judged in [format!("{map} {out} {own}"), format!("{at}/saved.json {out}")] {
                    let verified = planarium(&format!("verify {judged}"));
                    assert_eq!(
                        (verified.code, &verified.json()["valid"]),
                        (0, &json!(true)),
                        "{judged}: {}",
                        verified.stderr
                    );
                }
            }
            let units = if options.contains("0.01") { 100.0 } else { 1.0 };
            let wanted = [start, goal].map(|[x, y]| [units * x, units * y]);
            for (found, wanted) in ends(&text_of(&format!("{at}/path.geojson"))).iter().zip(wanted) {
                for (found, wanted) in found.as_array().expect("a position").iter().zip(wanted) {
                    let found = found.as_f64().expect("a number");
                    assert!((found - wanted).abs() < 1e-9 * wanted.abs().max(1.0), "{found}, not {wanted}");
                }
            }
            // Elsewhere it is not free: the frame is needed.
            let document: Value = serde_json::from_str(&text_of(&format!("{at}/saved.json"))).expect("JSON");
            let has_frame = !document["frame"].is_null();
            assert_eq!(has_frame, i >= 3, "{document}");
            if i > 3 {
                let mut bare = document.clone();
                bare.as_object_mut().expect("an object").remove("frame");
                file(&format!("{at}/bare.json"), bare.to_string());
                let verified = planarium(&format!("verify {at}/bare.json {at}/path.geojson"));
                assert_ne!(verified.code, 0, "{}", verified.stdout);
            }
        }
    }
}

/// The arcs of a car are chords near them, and as arcs the car can drive them.
#[test]
fn the_arcs_of_a_car_are_sampled() {
    let car = file("convert-car.json", planarium("generate gap --set robot=car --seed 1").stdout).to_owned();
    let planned = planarium(&format!("plan {car} --planner rrt-connect --set steering=reeds-shepp --seed 1"));
    let result = file("convert-driven.json", &planned.stdout).to_owned();
    let mut counts = Vec::new();
    for deviation in ["0.1", "0.001", "0.00001"] {
        let line = format!("convert {car} {result} --to csv --out convert-arcs.csv --deviation {deviation} --force");
        let written = planarium(&line);
        assert!(written.stderr.contains(&format!("chords are within {deviation} m")), "{}", written.stderr);
        let driven = planarium(&format!("verify {car} convert-arcs.csv --arcs"));
        assert_eq!((driven.code, &driven.json()["turns"]["count"]), (0, &json!(0)), "{}", driven.stderr);
        counts.push(text_of("convert-arcs.csv").lines().count() - 1);
    }
    assert!(counts[0] < counts[1] && 5 * counts[1] < counts[2], "{counts:?}");
    let corners = planned.json()["path"].as_array().map(Vec::len).expect("a path");
    assert!(corners <= counts[0], "{corners} {counts:?}");
    let straight = planarium(&format!("verify {car} convert-arcs.csv --drive-tolerance 1"));
    assert_eq!(straight.json()["free"], json!(true), "{}", straight.stderr);
    planarium(&format!("convert {car} {result} --to csv --deviation 0")).refuses("out-of-range", "/deviation");
}

#[test]
fn a_trajectory_has_times_and_speeds() {
    planarium(
        "plan firs.json --seed 1 --planner rrt-connect --set shortcut=100 --set blend=0.5 --out convert-firs.json",
    );
    let line = "time firs.json convert-firs.json --speed 1 --acceleration 2 --out convert-times.json";
    let timed = planarium(line);
    assert_eq!(timed.code, 0, "{}", timed.stderr);
    let trajectory: Value = serde_json::from_str(&text_of("convert-times.json")).expect("JSON");
    let duration = trajectory["duration"].as_f64().expect("a duration");
    let rows = |options: &str| -> Vec<Vec<f64>> {
        let line = format!("convert firs.json convert-firs.json --trajectory convert-times.json --to csv {options}");
        let written = planarium(&line);
        assert_eq!(written.code, 0, "{}", written.stderr);
        let mut lines = written.stdout.lines();
        assert!(
            lines.next().is_some_and(|names| names.starts_with("t_s,joint_0_rad,") && names.ends_with("_speed_rad_s"))
        );
        lines.map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect()
    };
    for (options, step) in [("", None), ("--dt 0.05", Some(0.05))] {
        let rows = rows(options);
        let (first, last) = (&rows[0], &rows[rows.len() - 1]);
        let dimension = (first.len() - 1) / 2;
        assert_eq!((first[0], last[0]), (0.0, duration), "{options}");
        assert!([first, last].iter().all(|row| row[1 + dimension..].iter().all(|speed| *speed == 0.0)), "{options}");
        assert!(rows.iter().flat_map(|row| &row[1 + dimension..]).all(|speed| speed.abs() <= 1.0 + 1e-12));
        for pair in rows.windows(2) {
            let lasting = pair[1][0] - pair[0][0];
            assert!(lasting > 0.0 && step.is_none_or(|step| lasting < step + 1e-9), "{options}: {lasting}");
            // No joint is faster on the way than its limit.
            assert!((1..=dimension).all(|k| (pair[1][k] - pair[0][k]).abs() <= lasting * (1.0 + 1e-9)), "{options}");
        }
    }
    // Those at the knots follow the blends, so they are free; the corners without times are as well.
    for options in ["--trajectory convert-times.json", ""] {
        let line = format!("convert firs.json convert-firs.json {options} --to csv --out convert-firs.csv --force");
        assert_eq!(planarium(&line).code, 0, "{line}");
        let verified = planarium("verify firs.json convert-firs.csv");
        assert_eq!(verified.code, 0, "{}", verified.stderr);
    }
    let line = "convert firs.json convert-firs.json --to csv";
    planarium(&format!("{line} --dt 0.1")).refuses("usage", "");
    planarium(&format!("{line} --trajectory convert-times.json --dt 0.1 --deviation 0.1")).refuses("usage", "");
    planarium(&format!("{line} --trajectory convert-times.json --dt 0")).refuses("out-of-range", "/step");
    planarium(&format!("{line} --trajectory convert-times.json --dt 1e-7")).refuses("out-of-range", "/step");
    planarium("convert firs.json - --trajectory - --to csv").refuses("usage", "");
    // That of another path.
    planarium("plan firs.json --seed 2 --raw --out convert-other.json");
    let line = "convert firs.json convert-other.json --trajectory convert-times.json --to csv";
    planarium(line).refuses("invalid-result", "/pieces");
}

/// A disc that turns and drives has a heading, which its own configuration has not.
#[test]
fn a_differential_drive_has_a_heading() {
    planarium("plan room.json --query around --seed 3 --set shortcut=20 --out convert-driven.json");
    let limits = "--differential --speed 1 --acceleration 2 --turn-rate 2 --turn-acceleration 4";
    let timed = planarium(&format!("time room.json convert-driven.json {limits} --out convert-drive.json"));
    assert_eq!(timed.code, 0, "{}", timed.stderr);
    let trajectory: Value = serde_json::from_str(&text_of("convert-drive.json")).expect("JSON");
    assert_eq!(trajectory["limits"]["type"], json!("differential"));
    let verified = planarium("verify room.json convert-driven.json --trajectory convert-drive.json");
    assert_eq!((verified.code, &verified.json()["valid"]), (0, &json!(true)), "{}", verified.stderr);
    let line = "convert room.json convert-driven.json --trajectory convert-drive.json --force --out convert-rows";
    for (form, options) in [
        ("csv", "--dt 0.01"),
        ("json", ""),
        ("npy", ""),
        ("geojson", ""),
        ("svg", ""),
        ("nav-path", "--dt 0.1"),
        ("nav-waypoints", ""),
    ] {
        let written = planarium(&format!("{line}.{form} --to {form} {options}"));
        assert_eq!(written.code, 0, "{form}: {}", written.stderr);
    }
    let table = text_of("convert-rows.csv");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("t_s,x_m,y_m,theta_rad,vx_m_s,vy_m_s,omega_rad_s"));
    let mut turning = 0;
    for line in lines {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        let [_, _, _, theta, vx, vy, omega] = row[..] else { panic!("{line}") };
        assert!((vy * theta.cos() - vx * theta.sin()).abs() < 1e-12, "it moves sideways: {line}");
        assert!(omega.abs() <= 2.0 + 1e-9 && (omega == 0.0 || (vx, vy) == (0.0, 0.0)), "{line}");
        turning += usize::from(omega != 0.0);
    }
    assert!(turning > 10, "{turning}");
    // What it drives is free, as the path is.
    let verified = planarium("verify room.json convert-rows.csv");
    assert_eq!(verified.code, 0, "{}", verified.stderr);
    for (options, code, pointer) in [
        ("--differential --speed 1 --acceleration 1", "missing-field", "/limits/turn_rate"),
        (&*format!("{limits} --lateral-acceleration 1"), "unsupported", "/limits/lateral_acceleration"),
        (
            "--differential --speed 1,1 --acceleration 1 --turn-rate 1 --turn-acceleration 1",
            "wrong-dimension",
            "/limits/speed",
        ),
    ] {
        planarium(&format!("time room.json convert-driven.json {options}")).refuses(code, pointer);
    }
}

#[test]
fn what_is_no_path_and_no_form_is_refused() {
    planarium("plan room.json --query around --seed 1 --out convert-room.json");
    planarium("convert room.json convert-room.json --to pdf").refuses("usage", "");
    planarium("convert room.json convert-room.json").refuses("usage", "");
    planarium("convert room.json convert-room.json --to csv --frame-id odom").refuses("invalid-option", "");
    planarium("convert room.json convert-room.json --to nav-path --frame-id=").refuses("invalid-option", "");
    planarium("convert arm.json convert-room.json --to csv").refuses("invalid-result", "/scenario");
    let mut bent: Value = serde_json::from_str(&text_of("convert-room.json")).expect("JSON");
    bent["path"] = json!([[0.5, 0.5], [2, 0.5]]);
    let bent = file("convert-bent.json", bent.to_string()).to_owned();
    planarium(&format!("convert room.json {bent} --to csv")).refuses("invalid-result", "/path");
    // The query that has no path.
    planarium("plan room.json --query cut-off --seed 1 --set max_iterations=50 --out convert-cut.json");
    planarium("convert room.json convert-cut.json --to csv").refuses("invalid-result", "/path");
    planarium("plan firs.json --seed 1 --out convert-arm.result");
    for form in ["geojson", "nav-path", "nav-waypoints"] {
        planarium(&format!("convert firs.json convert-arm.result --to {form}")).refuses("invalid-option", "");
    }
    for form in ["csv", "json", "svg", "npy"] {
        let out = format!("convert-arm.{form}");
        let line = format!("convert firs.json convert-arm.result --to {form} --out {out} --force");
        assert_eq!(planarium(&line).code, 0, "{form}");
    }
}

/// Each form replaces what this command wrote in that form, and nothing else. Any table or array may be another program's.
#[test]
fn forms_replace_their_own_files_alone() {
    planarium("plan room.json --query around --seed 1 --out convert-own.result");
    let forms = ["csv", "json", "geojson", "svg", "nav-path", "nav-waypoints", "npy"];
    let line =
        |form: &str, out: &str| format!("convert room.json convert-own.result --to {form} --out convert-own.{out}");
    for form in forms {
        let _ = std::fs::remove_file(path(&format!("convert-own.{form}")));
    }
    for form in forms {
        let first = planarium(&line(form, form));
        assert_eq!(first.code, 0, "{}", first.stderr);
    }
    for form in forms {
        for out in forms {
            let again = planarium(&line(form, out));
            if form == out && !["csv", "npy"].contains(&form) {
                assert_eq!(again.code, 0, "{form}: {}", again.stderr);
            } else {
                again.refuses("would-overwrite", "");
            }
        }
    }
    planarium("convert room.json convert-own.result --to csv --out convert-own.result --force")
        .refuses("would-overwrite", "");
}
