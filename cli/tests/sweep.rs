//! `planarium sweep`: the same rows by any number of threads, in shards, after it was killed, and in both formats.

use crate::documents::needed;
use crate::program::{Finished, file, path, planarium, spawn, text_of};
use serde_json::{Value, json};
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

/// An experiment of 90 trials whose names need quotes, one of them with a line break.
fn document() -> Value {
    json!({
        "format": "planarium-experiment-1", "title": "Tries, \"quoted\"",
        "worlds": [
            { "scenario": "room.json", "name": "a \"room\",\nwith walls", "queries": ["around", "cut-off"] },
            { "generate": "discs", "set": { "count": 4 }, "seeds": { "from": 2, "count": 1 } },
        ],
        "planners": [{ "algorithm": "rrt", "vary": { "goal_bias": [0.05, 0.2] } }, { "algorithm": "prm", "set": { "samples": 40 } }],
        "seeds": { "from": 0, "count": 10 },
        "budget": { "clearance_evaluations": 500 },
    })
}

fn sweep(line: &str) -> Finished {
    let finished = planarium(&format!("sweep {line}"));
    assert!(!finished.stderr.contains('\u{1b}'), "no progress bar without a terminal: {:?}", finished.stderr);
    finished
}

fn times_of(name: &str) -> String {
    format!("{}.times.csv", name.strip_suffix(".csv").unwrap_or(name))
}

/// Removes the files of an earlier sweep; returns the name.
fn fresh(name: &str) -> &str {
    for file in [name, &times_of(name)] {
        let _ = std::fs::remove_file(path(file));
    }
    name
}

#[track_caller]
fn swept(line: &str) -> Value {
    let finished = sweep(line);
    assert_eq!(finished.code, 0, "{}", finished.stderr);
    finished.json()
}

#[test]
fn rows_are_the_same_by_threads_and_in_shards() {
    file("tries.json", document().to_string());
    let summary = swept(&format!("tries.json --out {} --threads 1", fresh("one.csv")));
    assert_eq!((&summary["rows"], &summary["trials"]), (&json!(90), &json!(90)));
    let one = text_of("one.csv");
    assert!(
        one.starts_with("experiment,trial,world,world_seed,query,planner,planner.goal_bias,seed,status,"),
        "{one:.200}"
    );
    assert_eq!(
        one.matches(",solved,").count() as u64,
        summary["groups"]
            .as_array()
            .unwrap()
            .iter()
            .map(|group| group["solved"]["count"].as_u64().unwrap())
            .sum::<u64>()
    );
    assert!(one.contains(",running,"), "some trials spend their budget");
    assert_eq!(swept(&format!("tries.json --out {} --threads 2", fresh("two.csv"))), summary);
    assert!(text_of("two.csv") == one);
    // More shards than threads, of unequal sizes; and more shards than trials.
    for shards in [7, 100] {
        let (mut rows, mut times) = (String::new(), String::new());
        for shard in 1..=shards {
            let part = swept(&format!("tries.json --out {} --shard {shard}/{shards}", fresh("part.csv")));
            assert!((90 / shards..=90 / shards + 1).contains(&part["rows"].as_u64().unwrap()), "{part}");
            rows += &text_of("part.csv");
            times += &text_of("part.times.csv");
        }
        assert!(rows == one, "{shards}: {rows:.3000}");
        assert_eq!(times.lines().count(), 91);
        // Together they are a finished sweep: nothing runs again, and the summary is the same.
        file("joined.csv", &rows);
        assert_eq!(swept("tries.json --out joined.csv"), summary);
        assert!(text_of("joined.csv") == one);
    }
    let times = text_of("one.times.csv");
    for (i, line) in times.lines().skip(1).enumerate() {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(cells[0], i as f64);
        assert!(cells[1] + cells[2] > 0.0, "{line}");
    }
}

#[test]
fn settings_are_compared_with_any_baseline_or_each_with_each() {
    file("compared.json", document().to_string());
    let first = swept(&format!("compared.json --out {}", fresh("compared.csv")));
    let rows = text_of("compared.csv");
    let again = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_planarium"));
        let command = command.args(["sweep", "compared.json", "--out", "compared.csv"]).args(more);
        let output = command.current_dir(path("")).output().expect("the program ends");
        let text = |bytes| String::from_utf8(bytes).expect("text");
        assert!(text_of("compared.csv") == rows, "the baseline changes no row");
        Finished {
            code: output.status.code().expect("no signal"),
            stdout: text(output.stdout),
            stderr: text(output.stderr),
        }
    };
    let pairs = |summary: &Value| -> Vec<[u64; 2]> {
        let all = summary["comparisons"].as_array().expect("a list").iter();
        all.map(|one| ["group", "with"].map(|side| one[side].as_u64().expect("a number"))).collect()
    };
    // Three problems with three settings each.
    assert_eq!(pairs(&first), [[1, 0], [2, 0], [4, 3], [5, 3], [7, 6], [8, 6]]);
    assert_eq!(again(&["--baseline", "rrt (goal_bias=0.05)"]).json(), first, "the default by its name");
    let mut other = again(&["--baseline", "rrt (goal_bias=0.2)"]).json();
    assert_eq!(pairs(&other), [[0, 1], [2, 1], [3, 4], [5, 4], [6, 7], [8, 7]]);
    let words = other["comparisons"][1]["solved"]["words"].as_str().expect("words");
    assert!(words.contains("The success of prm is smaller than that of rrt (goal_bias=0.2) in "), "{words}");
    let prm = again(&["--baseline", "prm"]).json();
    assert_eq!(pairs(&prm), [[0, 2], [1, 2], [3, 5], [4, 5], [6, 8], [7, 8]]);
    let mut all = again(&["--all-pairs"]).json();
    assert_eq!(pairs(&all), [[1, 0], [2, 0], [2, 1], [4, 3], [5, 3], [5, 4], [7, 6], [8, 6], [8, 7]]);
    // The level is divided by the number of all tests: half as many again, each of the success and of every measure.
    let tests = |summary: &Value| {
        let each = 1 + summary["comparisons"][0]["measures"].as_object().expect("measures").len();
        format!(" of {} tests ", summary["comparisons"].as_array().expect("a list").len() * each)
    };
    for summary in [&first, &other, &prm, &all] {
        let words = summary["comparisons"][0]["solved"]["words"].as_str().expect("words");
        assert!(words.contains(&tests(summary)), "{words}");
    }
    assert_ne!(tests(&all), tests(&first));
    // Everything but the comparisons is the same.
    for summary in [&mut other, &mut all] {
        summary["comparisons"] = first["comparisons"].clone();
        assert_eq!(*summary, first);
    }
    let refused = again(&["--baseline", "rrt"]);
    refused.refuses("out-of-range", "/baseline");
    let known = "known names are \"rrt (goal_bias=0.05)\", \"rrt (goal_bias=0.2)\", \"prm\"";
    assert!(refused.stderr.contains(known), "{}", refused.stderr);
    assert_eq!(again(&["--baseline", "prm", "--all-pairs"]).code, 2);
    // It is refused before any trial.
    let name = fresh("unknown.csv");
    sweep(&format!("compared.json --out {name} --baseline no")).refuses("out-of-range", "/baseline");
    assert!(!path(name).exists());
}

/// The example for clusters, with a cluster of Dask on this machine. `npm test` installs Dask if it may, and sets the variable.
#[test]
fn dask_joins_the_rows_of_one_run() {
    let Some(python) = needed("PLANARIUM_PYTHON") else { return };
    file("dask.json", document().to_string());
    swept(&format!("dask.json --out {}", fresh("whole.csv")));
    for part in 1..=4 {
        fresh(&format!("dask.part-{part}-of-4.csv"));
    }
    let run = || {
        let done = Command::new(&python)
            .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/cluster/dask_sweep.py"))
            .args(["dask.json", "dask.csv", "--parts", "4", "--planarium", env!("CARGO_BIN_EXE_planarium")])
            .current_dir(path(""))
            .output()
            .expect("PLANARIUM_PYTHON names a Python");
        let [out, errors] = [&done.stdout, &done.stderr].map(|text| String::from_utf8_lossy(text));
        assert!(done.status.success(), "{out}{errors}");
        assert!(out.contains("4 of 4"), "{out}");
        assert!(text_of("dask.csv") == text_of("whole.csv"));
        assert_eq!(text_of("dask.times.csv").lines().count(), 91);
    };
    run();
    // Stopped in one part, it goes on there.
    let part = text_of("dask.part-2-of-4.csv");
    file("dask.part-2-of-4.csv", &part[..part.len() / 2]);
    run();
}

#[test]
fn a_sweep_that_was_cut_anywhere_goes_on_from_its_complete_rows() {
    file("cut.json", document().to_string());
    for format in ["csv", "json"] {
        let line = format!("cut.json --out cut.rows --format {format}");
        fresh("cut.rows");
        let summary = swept(&line);
        let (whole, times) = (text_of("cut.rows"), text_of("cut.rows.times.csv"));
        let quoted = whole.rfind("with walls").expect("a name with a line break");
        for size in [0, 1, 60, quoted, whole.len() / 2, whole.len() - 1, whole.len()] {
            file("cut.rows", &whole[..size]);
            assert_eq!(swept(&line), summary, "{format} {size}");
            assert!(text_of("cut.rows") == whole, "{format} {size}");
            assert_eq!(text_of("cut.rows.times.csv").lines().count(), times.lines().count(), "{format} {size}");
        }
    }
}

#[test]
fn a_sweep_that_was_killed_goes_on() {
    let mut long = document();
    long["seeds"]["count"] = json!(240);
    file("long.json", long.to_string());
    let all = 9 * 240;
    swept(&format!("long.json --out {}", fresh("unharmed.csv")));
    let mut child = spawn(&format!("sweep long.json --out {} --threads 1", fresh("killed.csv")));
    let rows = || std::fs::read_to_string(path("killed.csv")).map_or(0, |text| text.matches(",rrt,").count());
    while rows() == 0 {
        let has_ended = child.try_wait().expect("it can be asked").is_some();
        assert!(!has_ended || rows() > 0, "no row is written");
        sleep(Duration::from_millis(1));
    }
    sweep("long.json --out killed.csv").refuses("file", "");
    child.kill().expect("it runs");
    child.wait().expect("it has ended");
    let kept = rows();
    assert!(kept < all, "it was killed before its end");
    let finished = sweep("long.json --out killed.csv");
    assert!(!finished.stderr.ends_with("; 0 were there\n"), "{}", finished.stderr);
    assert!(text_of("killed.csv") == text_of("unharmed.csv"));
}

#[test]
fn rows_as_json_have_the_cells_of_rows_as_csv() {
    file("formats.json", document().to_string());
    let summary = swept(&format!("formats.json --out {}", fresh("formats.csv")));
    assert_eq!(swept(&format!("formats.json --format json --out {}", fresh("formats.jsonl"))), summary);
    let mut reader = csv::Reader::from_path(path("formats.csv")).unwrap();
    let columns = reader.headers().unwrap().clone();
    let text = text_of("formats.jsonl");
    assert_eq!(text.lines().count(), 90);
    for (line, record) in text.lines().zip(reader.records()) {
        let row: Value = serde_json::from_str(line).unwrap();
        for (column, cell) in columns.iter().zip(&record.unwrap()) {
            let value = &row[column];
            let as_text = value
                .as_str()
                .map_or_else(|| if value.is_null() { String::new() } else { value.to_string() }, str::to_owned);
            assert_eq!(as_text, cell, "{column}: {line}");
        }
    }
}

#[test]
fn other_rows_are_refused_and_left_as_they_are() {
    file("mine.json", document().to_string());
    let mut other = document();
    other["budget"] = json!({ "iterations": 90 });
    file("others.json", other.to_string());
    swept(&format!("others.json --out {}", fresh("theirs.csv")));
    let theirs = text_of("theirs.csv");
    sweep("mine.json --out theirs.csv").refuses("other-experiment", "");
    sweep("others.json --out theirs.csv --shard 2/3").refuses("other-experiment", "");
    sweep("others.json --out theirs.csv --shard 1/3").refuses("other-experiment", "");
    assert_eq!(text_of("theirs.csv"), theirs);
    // A title changes no row.
    other["title"] = json!("Renamed");
    file("others.json", other.to_string());
    assert_eq!(swept("others.json --out theirs.csv")["title"], "Renamed");
    let damaged = theirs.replacen(",rrt,", ",", 1);
    file("theirs.csv", &damaged);
    sweep("others.json --out theirs.csv").refuses("other-experiment", "");
    assert_eq!(text_of("theirs.csv"), damaged);
    file("notes.txt", "not rows\n");
    sweep("mine.json --out notes.txt").refuses("other-experiment", "");
    assert_eq!(text_of("notes.txt"), "not rows\n");
}

#[test]
fn wrong_input_is_refused_before_any_trial() {
    let mut cases = Vec::new();
    let mut case = |pointer: &str, value: Value, code: &'static str, at: &'static str| {
        let mut document = document();
        *document.pointer_mut(pointer).expect("it exists") = value;
        cases.push((document.to_string(), code, at));
    };
    case("/planners/0/vary/goal_bias", json!([2]), "out-of-range", "/planners/0/vary/goal_bias/0");
    case("/planners/1/set", json!({ "sample": 1 }), "unknown-parameter", "/planners/1/set/sample");
    case("/planners/1", json!({ "algorithm": "sst" }), "unsupported", "/planners/1/algorithm");
    case("/seeds/count", json!(1e9), "too-large", "/seeds");
    case("/seeds/count", json!(0), "out-of-range", "/seeds");
    case("/worlds/0/queries/0", json!("in-wall"), "goal-in-collision", "/worlds/0/scenario/queries/2/goal");
    case("/worlds/0/scenario", json!("nowhere.json"), "file", "/worlds/0/scenario");
    case("/worlds/0/scenario", json!("rows.py"), "invalid-json", "/worlds/0/scenario");
    file("rows.py", "print(1)");
    cases.push((document().to_string().replace("500}", "NaN}"), "invalid-json", "/budget/clearance_evaluations"));
    for (text, code, at) in cases {
        file("wrong.json", &text);
        sweep(&format!("wrong.json --out {}", fresh("wrong.csv"))).refuses(code, at);
        assert!(!path("wrong.csv").exists() && !path("wrong.times.csv").exists(), "{at}");
    }
    for shard in ["0/2", "3/2", "1", "-1/2", "a/b", "1/0"] {
        sweep(&format!("wrong.json --out wrong.csv --shard {shard}")).refuses("usage", "");
    }
    file("right.json", document().to_string());
    sweep("right.json --out nowhere/rows.csv").refuses("file", "");
}

#[test]
fn the_log_for_ompl_has_a_line_for_each_trial() {
    file("logged.json", document().to_string());
    swept(&format!("logged.json --out {} --ompl-log runs.log", fresh("logged.csv")));
    let log = text_of("runs.log");
    let mut lines = log.lines();
    let mut after = |end: &str| lines.by_ref().find(|line| line.ends_with(end)).unwrap_or_else(|| panic!("no {end}"));
    assert!(after(concat!("version ", env!("CARGO_PKG_VERSION"))).starts_with("Planarium"));
    assert_eq!(after("quoted\""), "Experiment Tries,-\"quoted\"");
    assert_eq!(after(" planners"), "3 planners");
    let mut solved = 0;
    for label in ["prm", "rrt goal_bias = 0.05", "rrt goal_bias = 0.2"] {
        assert_eq!(lines.next(), Some(label));
        let count = |line: Option<&str>| line.unwrap().split(' ').next().unwrap().parse::<usize>().unwrap();
        let common = count(lines.next());
        assert_eq!(lines.by_ref().take(common).count(), usize::from(label != "prm"));
        let properties = count(lines.next());
        let names: Vec<&str> = lines.by_ref().take(properties).collect();
        assert_eq!((names[0], names[2]), ("solved BOOLEAN", "time REAL"));
        let runs = count(lines.next());
        assert_eq!(runs, 30);
        for run in lines.by_ref().take(runs) {
            assert_eq!(run.matches("; ").count(), properties, "{run}");
            let values: Vec<&str> = run.split("; ").collect();
            solved += u32::from(values[0] == "1" && values[1] == "6" && values[2].parse::<f64>().unwrap() > 0.0);
        }
        assert_eq!(lines.next(), Some("."));
    }
    assert_eq!(solved as usize, text_of("logged.csv").matches(",solved,").count());
    assert_eq!(lines.next(), None);
}

/// They name the files of their scenarios.
#[test]
fn the_documents_of_the_page_are_accepted() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../www/experiments/documents");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("it is there") {
        let name = entry.expect("a file").path();
        // The first of more parts than there are trials: every setting is started, and next to nothing is run.
        let line = format!("{} --out {} --shard 1/10000", name.display(), fresh("of-a-page.csv"));
        assert!(swept(&line)["rows"].as_u64().expect("a count") <= 1, "{}", name.display());
        count += 1;
    }
    assert!(count >= 11, "{count} documents");
}

/// The blocks of one kind in the text about experiments.
fn blocks(kind: &str) -> Vec<String> {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/experiments.md")).expect("it is there");
    let start = format!("```{kind}\n");
    text.split(&start).skip(1).map(|block| block.split("```").next().unwrap_or_default().to_owned()).collect()
}

#[test]
fn the_examples_of_the_documentation_run() {
    let folder = path("documented");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir(&folder).unwrap();
    let [document] = blocks("json").try_into().expect("one document");
    std::fs::write(folder.join("experiment.json"), document).unwrap();
    let programs = std::path::Path::new(env!("CARGO_BIN_EXE_planarium")).parent().unwrap();
    let paths = format!("{}:{}", programs.display(), std::env::var("PATH").unwrap());
    for block in blocks("sh") {
        let output =
            Command::new("sh").args(["-ec", &block]).current_dir(&folder).env("PATH", &paths).output().unwrap();
        assert!(output.status.success(), "{block}{}", String::from_utf8_lossy(&output.stderr));
    }
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let summary: Value = serde_json::from_str(&read("summary.json")).unwrap();
    assert_eq!((&summary["rows"], read("runs.csv").lines().count()), (&json!(240), 241));
    assert_eq!(summary["groups"].as_array().unwrap().len(), 6);
    // What the text says of k: more motions are tried.
    let more = &summary["comparisons"][3]["measures"]["motion_checks"];
    assert_eq!(more["larger"], more["n"], "{more}");
    assert!(read("runs.log").contains("\n6 planners\n"));
}
