//! The layers of the library: the table and the drawing in `docs/architecture.md` are what the code does. The modules of the command
//! line use each other in one direction.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What the core never contains: clocks, printing, globals, JavaScript, hashing and arithmetic that differs between platforms.
const NEVER: &str = "Instant:: SystemTime println! eprintln! print!( dbg! static thread_local! wasm_bindgen js_sys web_sys \
    mul_add .powi( .hypot( HashMap HashSet .sin() .cos() .tan() .atan2( .exp() .ln() .powf(";

const LIBRARY: &str = "src";
const COMMAND_LINE: &str = "cli/src";

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

/// Every file of a crate with its module, but the one at the top.
fn modules(source: &str) -> Vec<(String, PathBuf)> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(source);
    let mut found = Vec::new();
    files(&source, &mut found);
    let module = |path: &PathBuf| {
        let first = path.strip_prefix(&source).expect("below src").components().next().expect("a name");
        first.as_os_str().to_str().expect("a readable name").trim_end_matches(".rs").to_owned()
    };
    found
        .into_iter()
        .map(|path| (module(&path), path))
        .filter(|(module, _)| module != "lib" && module != "main")
        .collect()
}

/// The code of a file, without its comments.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source file");
    text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// Modules, each with those that it uses.
type Arrows = BTreeMap<String, BTreeSet<String>>;

fn architecture() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/architecture.md"))
        .expect("docs/architecture.md")
}

/// What the code uses.
fn arrows_of_code(source: &str) -> Arrows {
    let mut arrows = Arrows::new();
    for (module, path) in modules(source) {
        let used = arrows.entry(module.clone()).or_default();
        for after in code(&path).split("crate::").skip(1) {
            let named: String = after.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let named = match &*named {
                "Error" | "Code" => "error",
                "PlanningWorld" => "world",
                // The macros at the root of the crate belong to `options`.
                _ if after[named.len()..].starts_with('!') => "options",
                _ => &named,
            };
            if named != module {
                used.insert(named.to_owned());
            }
        }
    }
    arrows
}

/// The rows of the table, from the top: a module, and the modules that it uses.
fn rows_of_table() -> Vec<(String, BTreeSet<String>)> {
    let text = architecture();
    let table = text.split("| module | contents | uses |\n").nth(1).expect("the table of modules");
    let rows = table.lines().skip(1).take_while(|line| line.starts_with("| `"));
    rows.map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let used = cells[2].split(", ").filter(|name| *name != "–").map(str::to_owned).collect();
        (cells[0].trim_matches('`').to_owned(), used)
    })
    .collect()
}

/// The arrows of the drawing, lines such as `a --> b & c`. `graph` is a word of the drawing's language, so that node is `graph_`.
fn arrows_of_drawing() -> Arrows {
    let text = architecture();
    let drawing = text.split("```mermaid\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a drawing");
    let name = |node: &str| node.split('[').next().unwrap_or("").trim().trim_end_matches('_').to_owned();
    let lines = drawing.lines().filter_map(|line| line.split_once(" --> "));
    lines.map(|(from, to)| (name(from), to.split(" & ").map(name).collect())).collect()
}

/// Everything that can be reached from a module.
fn reached(arrows: &Arrows, from: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open = vec![from];
    while let Some(module) = open.pop() {
        open.extend(arrows[module].iter().map(String::as_str).filter(|next| found.insert((*next).to_owned())));
    }
    found
}

#[test]
fn the_table_of_modules_is_what_the_code_uses() {
    let (code, table) = (arrows_of_code(LIBRARY), rows_of_table());
    for (module, used) in &code {
        let row = table.iter().find(|(name, _)| name == module);
        let (_, listed) = row.unwrap_or_else(|| panic!("{module} has no row in docs/architecture.md"));
        let expected = used.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
        assert_eq!(listed, used, "{module} uses {expected}: correct its row in docs/architecture.md, or the code");
    }
    assert_eq!(table.len(), code.len(), "docs/architecture.md has a row for a module that does not exist");
}

#[test]
fn modules_use_only_modules_below_them() {
    let table = rows_of_table();
    for (i, (module, used)) in table.iter().enumerate() {
        for named in used {
            let at = table.iter().position(|(name, _)| name == named).expect("a module of the table");
            assert!(at > i, "{module} uses {named}, which is above it");
        }
    }
}

#[test]
fn the_drawing_has_an_arrow_wherever_there_is_no_longer_way() {
    let arrows: Arrows = rows_of_table().into_iter().collect();
    let is_short = |used: &BTreeSet<String>, to: &String| !used.iter().any(|via| reached(&arrows, via).contains(to));
    let expected: Arrows = arrows
        .iter()
        .map(|(from, used)| {
            (from.clone(), used.iter().filter(|to| is_short(used, to)).cloned().collect::<BTreeSet<_>>())
        })
        .filter(|(_, used)| !used.is_empty())
        .collect();
    assert_eq!(arrows_of_drawing(), expected);
}

/// A file as the path of its module below `src`: `fleet/run`, and `fleet` for its `mod.rs`.
fn module_of(path: &Path) -> String {
    let file =
        path.strip_prefix(Path::new(env!("CARGO_MANIFEST_DIR")).join("src")).expect("below src").with_extension("");
    let name = file.iter().map(|part| part.to_str().expect("a readable name")).collect::<Vec<_>>().join("/");
    name.strip_suffix("/mod").map_or(name.clone(), str::to_owned)
}

/// The paths of a `use` declaration, without its braces.
fn expand(prefix: &str, tree: &str, paths: &mut Vec<String>) {
    let Some((before, inner)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().expect("a path").trim().trim_end_matches("::self");
        return paths.push(format!("{prefix}{path}"));
    };
    let inner = inner.trim_end().strip_suffix('}').expect("braces are closed");
    let (mut depth, mut from) = (0, 0);
    for (i, letter) in inner.char_indices().chain([(inner.len(), ',')]) {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                if !inner[from..i].trim().is_empty() {
                    expand(&format!("{prefix}{}", before.trim()), inner[from..i].trim(), paths);
                }
                from = i + 1;
            }
            _ => {}
        }
    }
}

/// The paths that a file names: those that it re-exports, and those that it uses.
fn paths(code: &str) -> [Vec<String>; 2] {
    let [mut exported, mut used] = [Vec::new(), Vec::new()];
    for statement in code.split(';') {
        let is_use = |line: &str| line.starts_with("use ") || (line.starts_with("pub") && line.contains(" use "));
        let at = statement.lines().position(|line| is_use(line.trim_start()));
        let lines: Vec<&str> = statement.lines().collect();
        let (other, declaration) = lines.split_at(at.unwrap_or(lines.len()));
        let declaration = declaration.join(" ");
        if let Some((before, tree)) = declaration.split_once("use ") {
            expand("", tree.trim(), if before.trim().is_empty() { &mut used } else { &mut exported });
        }
        let other = other.join("\n");
        let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
        let words =
            other.split(|c| !is_path(c)).filter(|word| word.starts_with("crate::") || word.starts_with("super::"));
        used.extend(words.map(str::to_owned));
    }
    [exported, used]
}

/// The file that defines what a path names, as seen from a file, through re-exports.
fn defined_in(files: &BTreeMap<String, [Vec<String>; 2]>, from: &str, path: &str) -> Option<String> {
    let mut place: Vec<&str> = from.split('/').collect();
    let mut names: Vec<&str> = path.split("::").collect();
    match names[0] {
        "crate" => place.clear(),
        "self" => {}
        "super" => {
            let up = names.iter().take_while(|name| **name == "super").count();
            place.truncate(place.len().checked_sub(up)?);
            names.drain(1..up);
        }
        child if files.contains_key(&format!("{from}/{child}")) => names.insert(0, "self"),
        _ => return None,
    }
    let whole: Vec<&str> = place.into_iter().chain(names.into_iter().skip(1)).collect();
    let length = (1..=whole.len()).rev().find(|&n| files.contains_key(&whole[..n].join("/")))?;
    let file = whole[..length].join("/");
    let name = whole.get(length);
    let exported = files[&file][0].iter().find(|path| name.is_some() && path.rsplit("::").next() == name.copied());
    exported.and_then(|path| defined_in(files, &file, path)).or(Some(file))
}

/// Within a module, no files use each other in a circle. What a `mod.rs` re-exports counts for the file that defines it. A `mod.rs`
/// and the files of its folder do not count against each other: it puts them together, and has what they share.
#[test]
fn the_files_of_a_module_use_each_other_in_no_circle() {
    let files: BTreeMap<String, [Vec<String>; 2]> =
        modules("src").into_iter().map(|(_, path)| (module_of(&path), paths(&code(&path)))).collect();
    let room = |file: &str| file.split('/').next().expect("a name").to_owned();
    let is_folder_of = |folder: &str, file: &str| file.rsplit_once('/').is_some_and(|(above, _)| above == folder);
    let mut arrows = Arrows::new();
    for (file, [_, used]) in &files {
        let others = used.iter().filter_map(|path| defined_in(&files, file, path)).filter(|other| {
            other != file && room(other) == room(file) && !is_folder_of(other, file) && !is_folder_of(file, other)
        });
        arrows.insert(file.clone(), others.collect());
    }
    assert!(arrows["fleet/pbs"].contains("fleet/roadmap") && arrows["run/launch"].contains("run/storage/states"));
    // What uses nothing that is left, or is used by nothing that is left, is in no circle.
    loop {
        let used: BTreeSet<String> = arrows.values().flatten().cloned().collect();
        let left: Arrows = arrows
            .iter()
            .filter(|(file, others)| used.contains(*file) && others.iter().any(|other| arrows.contains_key(other)))
            .map(|(file, others)| (file.clone(), others.iter().filter(|o| arrows.contains_key(*o)).cloned().collect()))
            .collect();
        if left.len() == arrows.len() {
            break;
        }
        arrows = left;
    }
    assert!(arrows.is_empty(), "files in circles, with what they use: {arrows:#?}");
}

/// Comments are read beside code: they are at most 130 columns wide, but for tables.
#[test]
fn comments_are_not_wide() {
    let sources = [modules("src"), modules("cli/src")].concat();
    for path in sources.into_iter().map(|(_, path)| path) {
        let text = fs::read_to_string(&path).expect("a source file");
        for (number, line) in text.lines().enumerate().filter(|(_, line)| line.trim_start().starts_with("//")) {
            let is_table = line.trim_start_matches(['/', '!', ' ']).starts_with('|');
            let place = format!("{}:{}", path.display(), number + 1);
            assert!(is_table || line.chars().count() <= 130, "{place}: this comment is wider than 130 columns");
        }
    }
}

#[test]
fn the_core_reads_no_clock_prints_nothing_and_uses_no_arithmetic_that_differs_between_platforms() {
    for (module, path) in modules(LIBRARY).into_iter().filter(|(module, _)| module != "bindings") {
        let code = code(&path);
        for word in NEVER.split_whitespace() {
            // A lifetime is not a global.
            let code = code.replace("'static", "");
            assert!(!code.contains(word), "{} of {module} contains {word}", path.display());
        }
    }
}

#[test]
fn no_module_of_the_command_line_uses_itself_by_way_of_others() {
    let arrows = arrows_of_code(COMMAND_LINE);
    for module in arrows.keys() {
        assert!(!reached(&arrows, module).contains(module), "{module} uses itself: {arrows:?}");
    }
}
