//! Valid documents, invalid changes to them, and what the environment says of tests.

use planarium::Error;
use planarium::path::{ResultDocument, Verdict, verify};
use planarium::scenario::Scenario;
use serde_json::Value;

/// A document with every field that a scenario with an arm may have.
pub const ARM: &str = r#"{
  "format": "planarium-scenario-1", "name": "arm", "title": "An arm",
  "world": {
    "bounds": {"min": [-3, -3], "max": [3, 3]},
    "obstacles": [
      {"type": "disc", "center": [2, 0], "radius": 0.25},
      {"type": "polygon", "vertices": [[1, 1], [2, 1], [2, 2], [1.5, 1.25], [1, 2]]}
    ]
  },
  "robot": {"type": "arm", "base": [0, 0], "links": [1, 0.5], "radius": 0.05, "joint_limits": [[-1, 1], [-2, 2]]},
  "queries": [{"name": "first", "start": [-1, 0], "goal": [1, 2]}, {"name": "second", "start": [0, 0], "goal": [0, 1]}]
}"#;

/// A document with every field that a scenario with a disc may have.
pub const DISC: &str = r#"{
  "format": "planarium-scenario-1", "name": "disc", "title": "A disc",
  "world": {"bounds": {"min": [0, 0], "max": [2, 2]}, "obstacles": [{"type": "disc", "center": [1, 1], "radius": 0.5}]},
  "robot": {"type": "disc", "radius": 0.1},
  "queries": [{"name": "across", "start": [0.2, 0.2], "goal": [1.8, 1.8]}]
}"#;

/// A document with every field that a scenario with a rigid body may have.
pub const BODY: &str = r#"{
  "format": "planarium-scenario-1", "name": "body", "title": "A body",
  "world": {"bounds": {"min": [0, 0], "max": [2, 2]}, "obstacles": [{"type": "disc", "center": [1, 1], "radius": 0.3}]},
  "robot": {"type": "rigid_body", "shape": {"type": "polygon", "vertices": [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [0, 0], [-0.1, 0.05]]},
            "metric": {"translation": 0.7, "rotation": 0.3}},
  "queries": [{"name": "across", "start": [0.2, 0.2, 0], "goal": [1.8, 1.8, 7], "goal_tolerance": {"translation": 0.1, "rotation": 0.5}}]
}"#;

/// The same with a car.
pub const CAR: &str = r#"{
  "format": "planarium-scenario-1", "name": "car", "title": "A car",
  "world": {"bounds": {"min": [0, 0], "max": [2, 2]}, "obstacles": [{"type": "disc", "center": [1, 1], "radius": 0.3}]},
  "robot": {"type": "car", "shape": {"type": "polygon", "vertices": [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]},
            "wheelbase": 0.2, "speed": [-0.5, 0.5], "steering": [-0.75, 0.75], "integration_step": 0.02,
            "metric": {"translation": 0.5, "rotation": 0.25}},
  "queries": [{"name": "across", "start": [0.2, 0.2, 0], "goal": [1.8, 1.8, -1], "goal_tolerance": {"translation": 0.1, "rotation": 0.5}}]
}"#;

/// A document with a polygon with a hole, a wall, and a robot with a margin.
pub const WALLS: &str = r#"{
  "format": "planarium-scenario-1", "name": "walls", "title": "Walls",
  "world": {"bounds": {"min": [0, 0], "max": [2, 2]}, "obstacles": [
    {"type": "polygon", "vertices": [[0.25, 0.25], [1.25, 0.25], [1.25, 1.25], [0.25, 1.25]], "holes": [[[0.5, 0.5], [1, 0.5], [1, 1], [0.5, 1]]]},
    {"type": "wall", "points": [[0.2, 1.8], [1, 1.9]], "width": 0.05, "closed": false}]},
  "robot": {"type": "disc", "radius": 0.1, "margin": 0.01},
  "queries": [{"name": "across", "start": [0.12, 0.12], "goal": [1.8, 1.7]}]
}"#;

/// The document with an arm and a target in place of a goal.
pub fn reaching() -> String {
    with(ARM, r#""goal": [1, 2]"#, r#""target": {"point": [1, 0.5], "orientation": 7}"#)
}

/// The document with the first occurrence of a piece replaced.
pub fn with(document: &str, piece: &str, replacement: &str) -> String {
    assert!(document.contains(piece), "{piece} does not occur in {document}");
    document.replacen(piece, replacement, 1)
}

/// Parses a valid scenario.
pub fn parse(text: &str) -> Scenario {
    Scenario::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Checks code and pointer of a refusal; returns its message.
#[track_caller]
pub fn refuses<T>(result: Result<T, Error>, code: &str, pointer: &str) -> String {
    let error = result.err().unwrap_or_else(|| panic!("this was accepted, not refused with {code} at {pointer}"));
    assert_eq!((error.code().as_str(), error.pointer()), (code, pointer), "{error}");
    assert!(error.message().len() > 10, "{error}");
    error.message().to_owned()
}

/// The same of an invalid document.
#[track_caller]
pub fn refusal(document: &str, code: &str, pointer: &str) -> String {
    refuses(Scenario::parse(document), code, pointer)
}

/// The JSON pointers of all values in the document, each after what it contains.
pub fn pointers(document: &Value) -> Vec<String> {
    let inner: Vec<(String, &Value)> = match document {
        Value::Object(fields) => fields.iter().map(|(name, field)| (name.clone(), field)).collect(),
        Value::Array(items) => items.iter().enumerate().map(|(i, item)| (i.to_string(), item)).collect(),
        _ => Vec::new(),
    };
    let below = |(name, value)| pointers(value).into_iter().map(move |pointer| format!("/{name}{pointer}"));
    inner.into_iter().flat_map(below).chain([String::new()]).collect()
}

/// A solved result: the path as JSON, and of a car its motions.
pub fn result(scenario: &str, path: &str, motions: Option<&str>, length: f64) -> ResultDocument {
    let motions = motions.map_or(String::new(), |motions| format!(r#""motions": {motions},"#));
    let text = format!(
        r#"{{ "scenario": "{scenario}", "query": "q", "planner": "prm", "seed": 1, "status": "solved", "path": {path}, {motions}
            "length": {length:e}, "stats": {{ "iterations": 0, "vertices": 0, "edges": 0, "configuration_checks": 0,
                "motion_checks": 0, "nearest_queries": 0, "visited": 0, "clearance_evaluations": 0, "build_seconds": 0.0,
                "search_seconds": 0.0 }}, "fingerprint": "0123456789abcdef" }}"#
    );
    ResultDocument::parse(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The clearance of a result of this scenario, or why it is invalid.
#[track_caller]
pub fn judged(scenario: &Scenario, result: &ResultDocument) -> Result<f64, String> {
    match verify(scenario, result).expect("a result of this scenario") {
        Verdict::Valid { clearance, .. } => Ok(clearance),
        Verdict::Invalid { why } => Err(why),
    }
}

/// A scenario "s": bounds as `[0, 0], [4, 4]` or none, obstacles, a robot, and the fields of its query "q" besides the name.
pub fn scenario(bounds: &str, obstacles: &str, robot: &str, query: &str) -> Scenario {
    named("s", bounds, obstacles, robot, query)
}

/// A disc of the given radius among obstacles.
pub fn disc_among(bounds: &str, obstacles: &[String], radius: f64, [start, goal]: [[f64; 2]; 2]) -> Scenario {
    let robot = format!(r#"{{"type": "disc", "radius": {radius:?}}}"#);
    scenario(bounds, &obstacles.join(","), &robot, &format!(r#""start": {start:?}, "goal": {goal:?}"#))
}

/// The same with another name.
pub fn named(name: &str, bounds: &str, obstacles: &str, robot: &str, query: &str) -> Scenario {
    parse(&text(name, bounds, obstacles, robot, query))
}

/// Its document.
pub fn text(name: &str, bounds: &str, obstacles: &str, robot: &str, query: &str) -> String {
    let bounds = bounds
        .split_once("], ")
        .map_or(String::new(), |(min, max)| format!(r#""bounds": {{ "min": {min}], "max": {max} }}, "#));
    let queries = if query.is_empty() { String::new() } else { format!(r#"{{ "name": "q", {query} }}"#) };
    format!(
        r#"{{ "format": "planarium-scenario-1", "name": "{name}", "world": {{ {bounds}"obstacles": [{obstacles}] }},
            "robot": {robot}, "queries": [{queries}] }}"#
    )
}

/// An obstacle, or the shape of a robot.
pub fn polygon(vertices: &[[f64; 2]]) -> String {
    format!(r#"{{"type": "polygon", "vertices": {vertices:?}}}"#)
}

pub fn rectangle([x, y]: [f64; 2], [u, v]: [f64; 2]) -> String {
    polygon(&[[x, y], [u, y], [u, v], [x, v]])
}

pub fn disc(center: [f64; 2], radius: f64) -> String {
    format!(r#"{{"type": "disc", "center": {center:?}, "radius": {radius:?}}}"#)
}

/// An arm with its base at the origin.
pub fn arm(links: &[f64], radius: f64) -> String {
    limited_arm(links, radius, &[])
}

/// The same with limits, unless there are none.
pub fn limited_arm(links: &[f64], radius: f64, limits: &[[f64; 2]]) -> String {
    let limits = if limits.is_empty() { String::new() } else { format!(r#", "joint_limits": {limits:?}"#) };
    format!(r#"{{"type": "arm", "base": [0, 0], "links": {links:?}, "radius": {radius:?}{limits}}}"#)
}

/// An arm with its base at the origin, its joints as JSON.
pub fn jointed_arm(links: &[f64], radius: f64, joints: &str) -> String {
    format!(r#"{{"type": "arm", "base": [0, 0], "links": {links:?}, "radius": {radius:?}, "joints": [{joints}]}}"#)
}

/// A `"rigid_body"` or a `"car"`: half its length, half its width, and its fields after the shape.
pub fn rectangular(kind: &str, x: f64, y: f64, fields: &str) -> String {
    let comma = if fields.is_empty() { "" } else { ", " };
    format!(r#"{{"type": "{kind}", "shape": {}{comma}{fields}}}"#, rectangle([-x, -y], [x, y]))
}

/// Whether properties are tested at full depth: natively, with `PLANARIUM_DEEP=1`.
pub fn deep() -> bool {
    cfg!(not(target_arch = "wasm32")) && std::env::var_os("PLANARIUM_DEEP").is_some_and(|value| value == "1")
}

/// A variable that a test needs; prints a line, past the capture of the test harness, if it is not set.
#[cfg(not(target_arch = "wasm32"))]
pub fn needed(variable: &str) -> Option<std::ffi::OsString> {
    let value = std::env::var_os(variable).filter(|value| !value.is_empty());
    if value.is_none() {
        let test = std::thread::current().name().unwrap_or_default().to_owned();
        let line = format!("\nSKIPPED {test}: {variable} is not set\n");
        let _ = std::io::Write::write_all(&mut std::io::stderr(), line.as_bytes());
    }
    value
}

/// The JSON files of the folder `PLANARIUM_SCENARIOS` by name, if it is set.
#[cfg(not(target_arch = "wasm32"))]
pub fn shared() -> Option<std::collections::BTreeMap<String, String>> {
    let folder = needed("PLANARIUM_SCENARIOS")?;
    let files = std::fs::read_dir(folder).expect("PLANARIUM_SCENARIOS names a folder");
    let paths = files.map(|file| file.expect("a file").path());
    let json = paths.filter(|path| path.extension().is_some_and(|extension| extension == "json"));
    let read = |path: std::path::PathBuf| {
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name");
        (name.to_owned(), std::fs::read_to_string(&path).expect("text"))
    };
    Some(json.map(read).collect())
}
