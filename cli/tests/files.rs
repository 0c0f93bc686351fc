//! What the command line does to files: nothing is lost that no earlier run wrote, whatever an output is named.

use crate::program::{file, path, planarium, text_of};
use serde_json::{Value, json};
use std::process::Command;

/// An experiment of four trials.
fn experiment() -> String {
    json!({
        "format": "planarium-experiment-1", "worlds": [{ "generate": "discs", "set": { "count": 3 } }],
        "planners": [{ "algorithm": "rrt-connect" }], "seeds": { "from": 0, "count": 4 },
    })
    .to_string()
}

/// A folder of its own below that of the program.
fn folder(name: &str) -> String {
    let _ = std::fs::remove_dir_all(path(name));
    std::fs::create_dir(path(name)).expect("the folder for test files can be written");
    name.to_owned()
}

/// The command is refused with this code, names the file, and has left it as it was.
#[track_caller]
fn refused(line: &str, code: &str, name: &str, contents: &str) {
    let finished = planarium(line);
    finished.refuses(code, "");
    let message = finished.json()["error"]["message"].as_str().expect("a message").to_owned();
    assert!(message.contains(name), "{line}: {message}");
    assert_eq!(text_of(name), contents, "{line}");
}

/// Runs a line of a shell in the folder of the program, whose name is `$P`.
#[cfg(unix)]
fn shell(line: &str) -> (i32, String, String) {
    planarium("--version");
    let mut command = Command::new("sh");
    command.args(["-c", line]).env("P", env!("CARGO_BIN_EXE_planarium")).current_dir(path(""));
    let output = command.output().expect("a shell");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().expect("no signal"), text(&output.stdout), text(&output.stderr))
}

/// The files of a folder.
fn names_in(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(path(folder)).expect("a folder");
    let mut names: Vec<_> =
        entries.map(|entry| entry.expect("a file").file_name().into_string().expect("text")).collect();
    names.sort();
    names
}

#[test]
fn every_command_leaves_what_it_did_not_write() {
    let at = folder("kept");
    file("kept/policy.json", include_str!("../../www/prm-rl/policy.json"));
    let made = [
        ("generate rooms", "task.json"),
        ("generate ring --set count=2", "ring.json"),
        ("generate gap", "gap.json"),
        ("plan room.json", "plan.json"),
        ("fleet kept/ring.json", "fleet.json"),
        ("certify room.json", "certificate.json"),
        ("time room.json kept/plan.json --speed 1 --acceleration 1", "trajectory.json"),
        ("reach arm.json --target 1,0.5", "reach.json"),
        ("optimum room.json", "optimum.json"),
        ("widest room.json", "widest.json"),
        ("route-graph room.json --samples 50", "graph.geojson"),
        ("train --set generations=1 --set pairs=2 --set tasks=1", "trained.json"),
        (
            "navigate kept/task.json --policy kept/policy.json --set samples=20 --set rollouts=1 --trials 1",
            "driven.json",
        ),
        (
            "compare kept/task.json --policy kept/policy.json --set queries=1 --set trials=1 --set samples=9 --set rollouts=1",
            "compared.json",
        ),
    ];
    for (line, name) in made {
        let line = format!("{line} --out {at}/{name}");
        let mut contents = String::new();
        for run in ["first", "again"] {
            let done = planarium(&line);
            assert!(done.code < 2, "{run}: {line}: {}", done.stderr);
            contents = text_of(&format!("{at}/{name}"));
            assert!(serde_json::from_str::<Value>(&contents).is_ok(), "{line}");
        }
        // Whatever else is there: text, JSON, half of what the command wrote, the input of another command.
        let half = &contents[..contents.len() / 2];
        for other in ["notes", "\n\nnotes\n", "{}", "[1, 2]", half, &experiment()] {
            file(&format!("{at}/{name}"), other);
            refused(&line, "would-overwrite", &format!("{at}/{name}"), other);
        }
        // An empty file has nothing to lose.
        file(&format!("{at}/{name}"), "");
        assert!(planarium(&line).code < 2 && !text_of(&format!("{at}/{name}")).is_empty(), "{line}");
        file(&format!("{at}/{name}"), "notes");
        assert!(planarium(&format!("{line} --force")).code < 2, "{line}");
        assert!(text_of(&format!("{at}/{name}")) != "notes", "{line}");
    }
    for (line, name) in [
        ("trajectories --set count=3 --csv", "tracks.csv"),
        ("plan room.json --planner prm --set samples=50 --out kept/plan.json --save-roadmap", "map.roadmap"),
        ("plan room.json --planner prm --set samples=50 --out kept/plan.json --save-roadmap", "map.json"),
        ("plan room.json --planner prm --set samples=50 --out kept/plan.json --save-roadmap", "map.graphml"),
        ("sweep kept/experiment.json --out kept/rows.csv --ompl-log", "rows.log"),
    ] {
        file("kept/experiment.json", experiment());
        let line = format!("{line} {at}/{name}");
        file(&format!("{at}/{name}"), "notes");
        refused(&line, "would-overwrite", &format!("{at}/{name}"), "notes");
        assert!(planarium(&format!("{line} --force")).code < 2 && planarium(&line).code < 2, "{line}");
    }
    assert!(names_in(&at).iter().all(|name| !name.ends_with(".partial")), "{:?}", names_in(&at));
}

#[test]
fn no_output_is_an_input_or_another_output() {
    let at = folder("apart");
    let scenario = planarium("generate gap").stdout;
    let text = experiment();
    for name in ["apart/world.json", "apart/experiment.json"] {
        file(name, if name.ends_with("world.json") { &scenario } else { &text });
    }
    // An input is refused even if it looks like a document of the command, and by force.
    for force in ["", " --force"] {
        let line = format!("plan apart/world.json --planner prm --set samples=30 --save-roadmap apart/map.json{force}");
        assert!(planarium(&line).code < 2);
        let map = text_of("apart/map.json");
        refused(
            &format!("plan apart/world.json --roadmap apart/map.json --save-roadmap apart/map.json{force}"),
            "would-overwrite",
            "apart/map.json",
            &map,
        );
        refused(
            &format!("plan apart/world.json --out apart/world.json{force}"),
            "would-overwrite",
            "apart/world.json",
            &scenario,
        );
        refused(
            &format!("sweep apart/experiment.json --out apart/experiment.json{force}"),
            "would-overwrite",
            "apart/experiment.json",
            &text,
        );
    }
    // Two outputs that are one new file, by two names of it.
    for (one, other) in [("new", "new"), ("new", "../apart/new"), ("rows", "rows.times.csv"), ("a/../new", "new")] {
        folder("apart/a");
        let finished = planarium(&format!("sweep apart/experiment.json --out {at}/{one} --ompl-log {at}/{other}"));
        finished.refuses("would-overwrite", "");
        assert!(!path("apart/new").exists() && !path("apart/rows").exists(), "{one} {other}");
    }
    planarium(&format!("plan apart/world.json --planner prm --out {at}/both --save-roadmap {at}/both"))
        .refuses("would-overwrite", "");
    // The file of a scenario that the experiment names is an input as well.
    let mut named: Value = serde_json::from_str(&text).expect("JSON");
    named["worlds"][0] = json!({ "scenario": "world.json" });
    file("apart/named.json", named.to_string());
    refused("sweep apart/named.json --out apart/world.json", "would-overwrite", "apart/world.json", &scenario);
}

#[cfg(unix)]
#[test]
fn files_are_told_apart_by_what_they_are() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
    let at = folder("links");
    let text = experiment();
    file("links/experiment.json", &text);
    symlink("experiment.json", path("links/soft.csv")).expect("a link");
    std::fs::hard_link(path("links/experiment.json"), path("links/hard.csv")).expect("a link");
    symlink("nowhere", path("links/dangling")).expect("a link");
    for name in ["soft.csv", "hard.csv"] {
        refused(
            &format!("sweep links/experiment.json --out {at}/{name}"),
            "would-overwrite",
            &format!("{at}/{name}"),
            &text,
        );
    }
    planarium(&format!("sweep links/experiment.json --out {at}/nowhere --ompl-log {at}/dangling"))
        .refuses("would-overwrite", "");
    // The target of a link is replaced, and keeps its permissions; the link stays.
    file("links/plan.json", "");
    std::fs::set_permissions(path("links/plan.json"), std::fs::Permissions::from_mode(0o640)).expect("its owner");
    symlink("plan.json", path("links/link.json")).expect("a link");
    let before = std::fs::metadata(path("links/plan.json")).expect("a file");
    for name in ["links/link.json", "links/dangling"] {
        assert_eq!(planarium(&format!("plan room.json --out {name}")).code, 0);
        assert!(std::fs::symlink_metadata(path(name)).expect("a link").is_symlink());
    }
    let after = std::fs::metadata(path("links/plan.json")).expect("a file");
    assert_eq!((after.permissions().mode() & 0o777, after.uid()), (0o640, before.uid()));
    assert!(after.ino() != before.ino() && text_of("links/nowhere") == text_of("links/dangling"));
    // A file that may not be written is not replaced, although its folder may be.
    let plan = text_of("links/plan.json");
    std::fs::set_permissions(path("links/plan.json"), std::fs::Permissions::from_mode(0o440)).expect("its owner");
    refused("plan room.json --out links/plan.json --force", "file", "links/plan.json", &plan);
}

#[cfg(unix)]
#[test]
fn standard_output_destroys_nothing_either() {
    folder("stream");
    let text = experiment();
    file("stream/experiment.json", &text);
    planarium("generate gap --out stream/gap.json");
    let gap = text_of("stream/gap.json");
    for line in ["plan stream/gap.json", "plan - < stream/gap.json", "verify room.json stream/gap.json"] {
        let (code, _, stderr) = shell(&format!("$P {line} >> stream/gap.json"));
        assert!(code == 2 && stderr.contains("standard output"), "{line}: {code} {stderr}");
        assert_eq!(text_of("stream/gap.json"), gap, "{line}");
    }
    let (code, _, stderr) = shell("$P sweep stream/experiment.json --out stream/rows.csv >> stream/rows.csv");
    assert!(code == 2 && stderr.contains("standard output"), "{stderr}");
    // What a file already has stays in front; pipes and devices take what they are given.
    file("stream/notes", "notes\n");
    assert_eq!(shell("$P plan room.json --out /dev/stdout >> stream/notes").0, 0);
    let notes = text_of("stream/notes");
    assert!(notes.starts_with("notes\n{\"scenario\":\"room\"") && notes.ends_with("}\n"), "{notes}");
    let (code, stdout, stderr) = shell("$P trajectories --set count=3 --csv /dev/stdout | cat");
    assert!(code == 0 && stdout.starts_with("x,y,theta,") && stdout.ends_with("}\n"), "{stdout} {stderr}");
    assert_eq!(shell("$P plan room.json --out /dev/null --planner prm --save-roadmap /dev/null").0, 0);
    let (code, stdout, _) =
        shell("mkfifo stream/pipe && { $P plan room.json --out stream/pipe & cat stream/pipe; wait; }");
    assert!(code == 0 && stdout.starts_with("{\"scenario\":\"room\""), "{stdout}");
}

#[cfg(unix)]
#[test]
fn a_full_disk_loses_nothing() {
    let at = folder("full");
    assert_eq!(
        planarium("plan room.json --planner prm --set samples=20 --out full/plan.json --save-roadmap full/map").code,
        0
    );
    let before = [text_of("full/plan.json").into_bytes(), std::fs::read(path("full/map")).expect("a roadmap")];
    // A file of no more than 512 bytes can be written; SIGXFSZ is ignored, so that writing fails.
    for line in ["--planner prm --set samples=900 --save-roadmap full/map --out full/plan.json", "--out full/plan.json"]
    {
        let (code, stdout, _) = shell(&format!("trap '' XFSZ; ulimit -f 0; $P plan room.json {line}"));
        assert!(code == 2 && stdout.contains("\"file\""), "{line}: {code} {stdout}");
    }
    let after = [text_of("full/plan.json").into_bytes(), std::fs::read(path("full/map")).expect("a roadmap")];
    assert!(before == after);
    assert_eq!(names_in(&at), ["map", "plan.json"], "nothing half written stays");
    // A sweep that ran out of space goes on.
    file("full/experiment.json", experiment());
    assert_eq!(planarium("sweep full/experiment.json --out full/whole.csv").code, 0);
    let (code, _, stderr) =
        shell("trap '' XFSZ; ulimit -f 1; $P sweep full/experiment.json --out full/rows.csv --threads 1");
    assert_eq!(code, 2, "{stderr}");
    assert!(text_of("full/rows.csv").len() <= 1024);
    assert_eq!(planarium("sweep full/experiment.json --out full/rows.csv").code, 0);
    assert!(text_of("full/rows.csv") == text_of("full/whole.csv"));
}

#[test]
fn a_sweep_continues_only_its_own_rows_and_times() {
    folder("swept");
    file("swept/experiment.json", experiment());
    let sweep = |rest: &str| planarium(&format!("sweep swept/experiment.json {rest}"));
    assert_eq!(sweep("--out swept/rows.csv").code, 0);
    assert_eq!(sweep("--out swept/rows.json --format json").code, 0);
    let [rows, times, lines] =
        ["rows.csv", "rows.times.csv", "rows.json"].map(|name| text_of(&format!("swept/{name}")));
    let header = &rows[..=rows.find('\n').expect("a line")];
    for (format, whole) in [("csv", &rows), ("json", &lines)] {
        let cut = &whole[..whole.len() - 9];
        let mut others = vec![
            "notes".to_owned(),
            "\n\nnotes".to_owned(),
            "\n".to_owned(),
            "notes\n".to_owned(),
            format!("{whole}notes"),
        ];
        others.extend([format!("{whole}\n"), format!("{}\nnotes", &cut[..whole.find('\n').expect("a line")])]);
        others.push(whole.replace('\n', "\r\n"));
        if format == "csv" {
            others.extend([
                format!("{header}notes"),
                format!("{header}\n"),
                format!("notes{rows}"),
                "experiment,trial".to_owned() + "notes",
            ]);
        } else {
            others.push("{\"experiment\":1}".to_owned());
        }
        for other in others {
            file("swept/others", &other);
            let _ = std::fs::remove_file(path("swept/others.times.csv"));
            refused(
                &format!("sweep swept/experiment.json --format {format} --out swept/others"),
                "other-experiment",
                "swept/others",
                &other,
            );
            assert!(!path("swept/others.times.csv").exists(), "{other:?}");
        }
        file("swept/others", "notes");
        assert_eq!(sweep(&format!("--format {format} --out swept/others --force")).code, 0);
        assert!(text_of("swept/others") == *whole, "{format}");
    }
    for other in [
        "mine",
        "mine\n",
        "1,2,3\n",
        "trial,build_seconds,search_seconds\n0,1.5,2\n",
        &format!("{times}notes"),
        &format!("{times}9,0.000000000,0.000000000\n"),
    ] {
        file("swept/timed.times.csv", other);
        refused("sweep swept/experiment.json --out swept/timed.csv", "would-overwrite", "swept/timed.times.csv", other);
        assert!(!path("swept/timed.csv").exists(), "{other:?}");
    }
    assert_eq!(sweep("--out swept/timed.csv --force").code, 0);
    assert!(text_of("swept/timed.csv") == rows);
    // Rows without the ending have times of the same name.
    refused("sweep swept/experiment.json --out swept/rows", "would-overwrite", "swept/rows.times.csv", &times);
}
