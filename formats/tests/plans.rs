//! Plans of other people, and ours, compared with what other libraries read of them at random points. It needs Python
//! with shapely and PyYAML: `PLANARIUM_PYTHON` names it, or else `python3`; where they are missing, the tests say so.

use crate::documents::needed;
use crate::files::{file, free, python};
use crate::geojson::HOUSE;
use crate::rmf::BUILDING;
use crate::wkt::ROOM;
use planarium_formats::{Options, World, read};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Compares a file with the world that was read of it.
fn compare(python: &str, path: &Path, world: &World) {
    let report =
        std::env::temp_dir().join(format!("planarium-report-{}-{}", std::process::id(), world.scenario.name()));
    std::fs::write(&report, world.report.to_json_string()).expect("a file");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/plans.py");
    let output = Command::new(python).arg(script).arg(path).arg(&report).output().expect("Python");
    std::fs::remove_file(&report).expect("the report");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let [mut blocked, mut open] = [0; 2];
    for line in String::from_utf8(output.stdout).expect("text").lines() {
        let numbers: Vec<f64> = line.split(' ').map(|word| word.parse().expect("a number")).collect();
        let &[x, y, is_blocked] = &numbers[..] else { panic!("{line}") };
        assert_eq!(!free(world, [x, y]), is_blocked == 1.0, "{}: {x} {y}", path.display());
        *if is_blocked == 1.0 { &mut blocked } else { &mut open } += 1;
    }
    println!("{}: {blocked} points in obstacles and {open} outside agree", path.display());
    assert!(blocked > 10 && open > 1000, "{blocked} {open}");
}

#[test]
fn our_files_agree_with_other_readers() {
    let Some(python) = python("shapely, yaml") else { return };
    let crossing =
        "MULTIPOLYGON (((0 0, 10 0, 10 10, 0 10, 0 0), (2 2, 4 2, 4 4, 2 4, 2 2)), ((20 0, 30 0, 25 9, 20 0)))";
    let cases: [(&str, &str, Option<bool>); 4] = [
        ("house.geojson", HOUSE, None),
        ("room.wkt", ROOM, None),
        ("rooms.wkt", crossing, Some(true)),
        ("office.building.yaml", BUILDING, None),
    ];
    for (name, text, walkable) in cases {
        let path = std::env::temp_dir().join(format!("planarium-{}-{name}", std::process::id()));
        std::fs::write(&path, text).expect("a file");
        let options = Options { walkable, ..Options::default() };
        let world = read(&[file(name, text)], &options).unwrap_or_else(|error| panic!("{error}"));
        compare(&python, &path, &world);
        std::fs::remove_file(&path).expect("the file");
    }
}

#[test]
fn real_files_agree_with_other_readers() {
    let Some(folder) = needed("PLANARIUM_WORLDS") else { return };
    let Some(python) = python("shapely, yaml") else { return };
    for (part, end) in [("geojson", ".geojson"), ("wkt", ".wkt"), ("rmf", ".building.yaml")] {
        let entries = std::fs::read_dir(Path::new(&folder).join(part)).expect("a folder");
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
        paths.retain(|path| path.to_string_lossy().ends_with(end));
        assert!(!paths.is_empty(), "{part} has no file *{end}");
        for path in paths {
            let bytes = std::fs::read(&path).expect("a file");
            let world = read(&[file(&path.to_string_lossy(), &bytes)], &Options::default())
                .unwrap_or_else(|error| panic!("{error}"));
            compare(&python, &path, &world);
        }
    }
}
