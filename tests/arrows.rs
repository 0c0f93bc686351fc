//! The layers of the crate: each module uses only the modules that its line below lists.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Every module of `src`, from the ground up, and the modules that it may use.
const LAYERS: &[(&str, &str)] = &[
    ("error", ""),
    ("json", "error"),
    ("options", "error"),
    ("random", "error"),
    ("geometry", ""),
    ("space", "geometry random"),
    ("robot", "error geometry space"),
    ("scenario", "error geometry json options random robot"),
    ("problem", "error json random space"),
    ("collision", "geometry problem random robot scenario space"),
    ("world", "collision error geometry problem robot scenario space"),
    ("graph", "problem space"),
    ("nearest", "graph random space"),
    ("sampling", "problem random space"),
    ("path", "error geometry json problem random robot scenario space"),
    ("planner", "error graph nearest options problem random sampling space"),
    ("trajectories", "error geometry graph json options problem random"),
    ("ik", "error geometry graph json options problem random robot scenario space world"),
    ("driving", "collision error geometry problem robot scenario space world"),
    (
        "run",
        "collision error geometry graph ik json nearest options path planner problem random robot sampling \
         scenario space trajectories world",
    ),
    (
        "bindings",
        "driving error geometry ik json options path planner problem random robot run scenario trajectories \
         world",
    ),
];

/// What the core never contains: clocks, printing, globals, JavaScript, hashing and arithmetic that differs between platforms.
const NEVER: &str = "Instant:: SystemTime println! eprintln! print!( dbg! static thread_local! wasm_bindgen js_sys web_sys \
    mul_add .powi( .hypot( HashMap HashSet .sin() .cos() .tan() .atan2( .exp() .ln() .powf(";

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

/// Every file of the library with its module; not those of the command line.
fn modules() -> Vec<(String, PathBuf)> {
    let mut found = Vec::new();
    files(&source(), &mut found);
    let module = |path: &PathBuf| {
        let first = path.strip_prefix(source()).expect("below src").components().next().expect("a name");
        first.as_os_str().to_str().expect("a readable name").trim_end_matches(".rs").to_owned()
    };
    found
        .into_iter()
        .map(|path| (module(&path), path))
        .filter(|(module, _)| module != "lib" && module != "bin")
        .collect()
}

/// The code of a file, without its comments.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source file");
    text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

#[test]
fn each_module_uses_only_modules_below_it() {
    let mut seen = BTreeSet::new();
    for (module, path) in modules() {
        let line = LAYERS.iter().find(|(name, _)| *name == module);
        let (_, allowed) = line.unwrap_or_else(|| panic!("{module} has no line in the list of this test"));
        for after in code(&path).split("crate::").skip(1) {
            let named: String = after.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            // `crate::Error` is re-exported from `error`.
            let named = if named == "Error" { "error".to_owned() } else { named };
            // The macros at the root of the crate belong to `options`.
            let named = if after[named.len()..].starts_with('!') { "options".to_owned() } else { named };
            let is_allowed = named == module || allowed.split(' ').any(|name| name == named);
            assert!(is_allowed, "{} uses {named}, which {module} may not", path.display());
        }
        seen.insert(module);
    }
    assert_eq!(seen.len(), LAYERS.len(), "the list has a module that does not exist");
}

#[test]
fn the_layers_have_no_cycle() {
    for (i, (module, allowed)) in LAYERS.iter().enumerate() {
        for named in allowed.split_whitespace() {
            let at = LAYERS.iter().position(|(name, _)| *name == named).expect("a module of the list");
            assert!(at < i, "{module} may use {named}, which is above it");
        }
    }
}

#[test]
fn the_core_reads_no_clock_prints_nothing_and_uses_no_arithmetic_that_differs_between_platforms() {
    for (module, path) in modules().into_iter().filter(|(module, _)| module != "bindings") {
        let code = code(&path);
        for word in NEVER.split_whitespace() {
            // A lifetime is not a global.
            let code = code.replace("'static", "");
            assert!(!code.contains(word), "{} of {module} contains {word}", path.display());
        }
    }
}
