//! The arrows of the house run one way: each room names only the rooms that its line below lists.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Every room of `src`, from the ground up, and the rooms it may name.
const HOUSE: &[(&str, &[&str])] = &[
    ("error", &[]),
    ("json", &["error"]),
    ("options", &["error"]),
    ("stats", &["json"]),
    ("status", &[]),
    ("phase", &[]),
    ("geometry", &[]),
    ("random", &["error"]),
    ("validity", &[]),
    ("control", &["json", "random"]),
    ("steering", &["geometry"]),
    ("space", &["geometry", "random", "steering"]),
    ("robot", &["error", "geometry", "space"]),
    ("scenario", &["error", "geometry", "json", "options", "random", "robot"]),
    ("collision", &["control", "geometry", "random", "robot", "scenario", "space", "steering", "validity"]),
    ("world", &["collision", "control", "error", "geometry", "robot", "scenario", "space", "validity"]),
    ("problem", &["control", "error", "space", "validity"]),
    ("graph", &["control", "space"]),
    ("nearest", &["graph", "random", "space"]),
    ("fleet", &["error", "geometry", "graph", "json", "options", "random", "status"]),
    ("result", &["control", "error", "json", "random", "scenario", "stats", "status"]),
    ("kept", &["error", "graph", "json", "scenario", "space", "steering"]),
    (
        "path",
        &[
            "control", "error", "geometry", "problem", "random", "result", "robot", "scenario", "space", "status",
            "validity",
        ],
    ),
    ("sampling", &["problem", "random", "space"]),
    (
        "planner",
        &[
            "control", "error", "graph", "nearest", "options", "phase", "problem", "random", "sampling", "space",
            "status", "steering",
        ],
    ),
    (
        "reach",
        &[
            "error", "geometry", "graph", "json", "options", "random", "robot", "scenario", "space", "status",
            "validity", "world",
        ],
    ),
    (
        "run",
        &[
            "collision",
            "control",
            "error",
            "graph",
            "kept",
            "options",
            "path",
            "planner",
            "problem",
            "random",
            "reach",
            "result",
            "robot",
            "sampling",
            "scenario",
            "space",
            "steering",
            "stats",
            "validity",
            "world",
        ],
    ),
    ("inspect", &["error", "geometry", "planner", "random", "robot", "scenario", "space", "validity", "world"]),
    ("neighbours", &["error", "graph", "nearest", "options", "planner", "random", "space", "world"]),
    ("drive", &["collision", "control", "error", "geometry", "robot", "scenario", "space", "validity", "world"]),
    ("catalogue", &["error", "fleet", "neighbours", "options", "planner", "reach", "scenario"]),
    (
        "bindings",
        &[
            "control",
            "drive",
            "error",
            "fleet",
            "geometry",
            "inspect",
            "json",
            "kept",
            "neighbours",
            "options",
            "phase",
            "planner",
            "random",
            "reach",
            "result",
            "robot",
            "run",
            "scenario",
            "stats",
            "status",
            "validity",
            "world",
        ],
    ),
];

/// Words that the core never says: it reads no clock, prints nothing, keeps no global, knows no JavaScript.
const NEVER: &[&str] = &[
    "Instant::",
    "SystemTime",
    "println!",
    "eprintln!",
    "print!(",
    "dbg!",
    "static ",
    "thread_local!",
    "wasm_bindgen",
    "js_sys",
    "web_sys",
    "mul_add",
    ".powi(",
    ".hypot(",
    "HashMap",
    "HashSet",
    ".sin()",
    ".cos()",
    ".tan()",
    ".atan2(",
    ".exp()",
    ".ln()",
    ".powf(",
];

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    for entry in entries {
        if entry.is_dir() {
            files(&entry, found);
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            found.push(entry);
        }
    }
}

/// Every file of the library with the room it stands in; the command line stands outside.
fn rooms() -> Vec<(String, PathBuf)> {
    let mut found = Vec::new();
    files(&source(), &mut found);
    let room = |path: &PathBuf| {
        let first = path.strip_prefix(source()).expect("below src").components().next().expect("a name");
        first.as_os_str().to_str().expect("a readable name").trim_end_matches(".rs").to_owned()
    };
    found.into_iter().map(|path| (room(&path), path)).filter(|(room, _)| room != "lib" && room != "bin").collect()
}

/// The code of a file, without its comments.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source file");
    text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

#[test]
fn each_room_names_only_rooms_below_it() {
    let mut seen = BTreeSet::new();
    for (room, path) in rooms() {
        let line = HOUSE.iter().find(|(name, _)| *name == room);
        let (_, allowed) = line.unwrap_or_else(|| panic!("{room} has no line in this test's plan of the house"));
        for after in code(&path).split("crate::").skip(1) {
            let named: String = after.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            // `crate::Error` is the error room's, re-exported.
            let named = if named == "Error" { "error".to_owned() } else { named };
            // Macros stand at the root of the crate: those that declare options belong to that room.
            let named = if after[named.len()..].starts_with('!') { "options".to_owned() } else { named };
            let is_allowed = named == room || allowed.contains(&named.as_str());
            assert!(is_allowed, "{} names {named}, which {room} may not", path.display());
        }
        seen.insert(room);
    }
    assert_eq!(seen.len(), HOUSE.len(), "the plan lists a room that is not there");
}

#[test]
fn the_plan_of_the_house_has_no_circle() {
    for (i, (room, allowed)) in HOUSE.iter().enumerate() {
        for named in *allowed {
            let at = HOUSE.iter().position(|(name, _)| name == named).expect("a room of the plan");
            assert!(at < i, "{room} names {named}, which stands above it");
        }
    }
}

#[test]
fn the_core_reads_no_clock_prints_nothing_and_uses_no_arithmetic_that_differs_between_platforms() {
    for (room, path) in rooms().into_iter().filter(|(room, _)| room != "bindings") {
        let code = code(&path);
        for word in NEVER {
            // A lifetime is not a global.
            let code = code.replace("'static ", "");
            assert!(!code.contains(word), "{} of {room} says {word}", path.display());
        }
    }
}
