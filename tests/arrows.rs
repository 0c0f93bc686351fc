//! The arrows of the house run one way: each room names only the rooms that its line below lists.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Every room of `src`, from the ground up, and the rooms it may name.
const HOUSE: &[(&str, &[&str])] = &[
    ("error", &[]),
    ("json", &["error"]),
    ("options", &["error"]),
    ("random", &["error"]),
    ("geometry", &[]),
    ("space", &["geometry", "random"]),
    ("robot", &["error", "geometry", "space"]),
    ("scenario", &["error", "geometry", "json", "options", "random", "robot"]),
    ("problem", &["error", "json", "random", "space"]),
    ("collision", &["geometry", "problem", "random", "robot", "scenario", "space"]),
    ("world", &["collision", "error", "geometry", "problem", "robot", "scenario", "space"]),
    ("graph", &["problem", "space"]),
    ("nearest", &["graph", "random", "space"]),
    ("sampling", &["problem", "random", "space"]),
    ("path", &["error", "geometry", "json", "problem", "random", "robot", "scenario", "space"]),
    ("planner", &["error", "graph", "nearest", "options", "problem", "random", "sampling", "space"]),
    ("trajectories", &["error", "geometry", "graph", "json", "options", "problem", "random"]),
    (
        "ik",
        &["error", "geometry", "graph", "json", "options", "problem", "random", "robot", "scenario", "space", "world"],
    ),
    ("driving", &["collision", "error", "geometry", "problem", "robot", "scenario", "space", "world"]),
    (
        "run",
        &[
            "collision",
            "error",
            "geometry",
            "graph",
            "ik",
            "json",
            "nearest",
            "options",
            "path",
            "planner",
            "problem",
            "random",
            "robot",
            "sampling",
            "scenario",
            "space",
            "trajectories",
            "world",
        ],
    ),
    (
        "bindings",
        &[
            "driving",
            "error",
            "geometry",
            "ik",
            "json",
            "options",
            "path",
            "planner",
            "problem",
            "random",
            "robot",
            "run",
            "scenario",
            "trajectories",
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
