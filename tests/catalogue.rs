//! The table of planners: short descriptions, and pseudo-code that every iteration of every planner highlights.

use crate::common::documents::refuses;
use crate::common::requests::{resume, start};
use crate::common::{
    DRIVEN, PLANNERS, arm_and_wall, begin_with, body_and_wall, car_and_wall, car_shut_in, disc_and_pillar,
    disc_and_wall, finish, fitting, no_way, options, parse,
};
use planarium::graph::EventKind;
use planarium::options::{Kind, Value};
use planarium::planner::{Mark, PlannerOptions, PseudocodeLine, planners};
use planarium::run::{EVENT_HEAD, Run, Status};
use planarium::scenario::Scenario;
use std::collections::BTreeSet;
use wasm_bindgen_test::wasm_bindgen_test;

/// The word of a mark, as viewers see it.
fn word(mark: Mark) -> String {
    <&str>::from(mark).to_owned()
}

/// Does one iteration and returns its marks.
fn marks_of_one(run: &mut dyn Run) -> BTreeSet<String> {
    let (vertices, edges, events) = (run.vertex_count(), run.edge_count(), run.event_count());
    let mut marks = BTreeSet::from([run.phase().as_str().to_owned()]);
    run.step(1);
    let more = [
        (run.vertex_count() > vertices, Mark::Vertex),
        (run.edge_count() > edges, Mark::Edge),
        (run.status() != Status::Running, Mark::Done),
    ];
    marks.extend(more.into_iter().filter(|(is_so, _)| *is_so).map(|(_, mark)| word(mark)));
    for row in run.event_rows(events).chunks(EVENT_HEAD + run.dimension()) {
        let kind = EventKind::ALL[row[0] as usize];
        assert_eq!(f64::from(kind as u8), row[0]);
        marks.insert(kind.as_str().to_owned());
    }
    marks
}

fn lit<'a>(lines: &'a [PseudocodeLine], marks: &BTreeSet<String>) -> Vec<&'a str> {
    let is_lit = |line: &&PseudocodeLine| line.lit_by.iter().any(|&mark| marks.contains(&word(mark)));
    lines.iter().filter(is_lit).map(|line| line.text).collect()
}

/// Every planner with more settings than the laws need, so that all that can happen does.
fn settings() -> Vec<(&'static str, String)> {
    let mut all: Vec<(&str, String)> = PLANNERS.iter().map(|&(planner, words)| (planner, words.to_owned())).collect();
    all.extend(DRIVEN.iter().map(|&(planner, words)| (planner, words.to_owned())));
    all.extend(["rrt-control", "sst"].map(|planner| (planner, "sampler=bridge max_iterations=400".to_owned())));
    all.push(("prm", "samples=60 k=1 insertion=one-by-one discard=true".to_owned()));
    let (samples, failures) = ("samples=60", "failures=40");
    let few = [
        ("prm", samples),
        ("prm-star", samples),
        ("lazy-prm", samples),
        ("lazy-prm-star", ""),
        ("visibility-prm", failures),
        ("rrt", ""),
        ("rrt-connect", ""),
        ("rrt-star", ""),
        ("informed-rrt-star", ""),
        ("fmt-star", samples),
        ("bit-star", ""),
        ("aorrtc", ""),
    ];
    for (planner, few) in few {
        all.push((planner, format!("{few} sampler=bridge max_iterations=400")));
        all.push((planner, format!("{few} shortcut=5")));
    }
    all
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_and_parameter_has_one_short_sentence_on_what_it_does() {
    for planner in planners() {
        let (info, table) = (planner.info(), planner.table());
        let texts = table.iter().map(|row| (row.name, &*row.meaning));
        for (name, words) in texts.chain([(info.id, info.summary), (info.id, info.guarantee)]) {
            let length = words.chars().count();
            assert!((30..=110).contains(&length), "{name}: {length} characters in {words:?}");
            assert!(words.ends_with('.') && !words.contains(". "), "{name}: one sentence, not {words:?}");
        }
        assert!(table.iter().any(|row| row.name == "max_iterations"), "{}", info.id);
        let is_empty = |kind: &Kind| matches!(kind, Kind::Integer(range) | Kind::Number(range) if range.is_empty());
        assert!(!table.iter().any(|row| is_empty(&row.kind)), "{}: no range is empty", info.id);
        assert!(table.iter().all(|row| (1..=20).contains(&row.title.chars().count())), "{}", info.id);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_parameter_takes_its_default_its_choices_and_its_ends_and_nothing_beyond() {
    let worlds = [arm_and_wall(0.1), disc_and_wall(0.3, 0.5), body_and_wall(0.1), car_and_wall(0.1)];
    for planner in planners() {
        let id = planner.info().id;
        for row in planner.table() {
            let name = row.name;
            let fits = |world: &&Scenario| {
                let kind = world.robot().kind();
                row.robots.contains(&kind) && planner.robots().contains(&kind)
            };
            let world = worlds.iter().find(fits).expect("a robot that it is for");
            // What is for the last quarter of the iterations needs their number.
            let rest = if name.starts_with("late") { " max_iterations=1000" } else { "" };
            let given = |value: &str| start(world, &options(id, 1, &format!("{name}={value}{rest}")));
            let taken = |value: &str| given(value).map(drop).unwrap_or_else(|error| panic!("{id}: {error}"));
            match &row.default {
                Some(Value::Text(word)) => taken(word),
                Some(value) => taken(&value.to_string()),
                None => {}
            }
            match row.kind {
                // These planners need motions in both directions, and these curves lead one way.
                Kind::Choice(words) => words
                    .iter()
                    .filter(|word| **word != "dubins" || !["visibility-prm", "aorrtc"].contains(&id))
                    .for_each(|word| taken(word)),
                Kind::Integer(range) | Kind::Number(range) => {
                    for (end, sign) in [(*range.start(), -1.0), (*range.end(), 1.0)] {
                        if end.is_finite() {
                            let beyond = end + sign * end.abs().max(1.0);
                            refuses(given(&beyond.to_string()).map(drop), "out-of-range", &format!("/{name}"));
                            // The world narrows a step, another parameter the shortest durations.
                            if !["step", "shortest_steps"].contains(&name) {
                                taken(&end.to_string());
                            }
                        }
                    }
                }
                Kind::Switch => {}
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_planner_has_a_few_short_lines() {
    for info in planners().map(|planner| planner.info()) {
        let lines = info.pseudocode;
        assert!((6..=12).contains(&lines.len()), "{}: {} lines", info.id, lines.len());
        assert_eq!(lines[0].indent, 0, "{}", info.id);
        for pair in lines.windows(2) {
            assert!(pair[1].indent <= pair[0].indent + 1, "{}: {}", info.id, pair[1].text);
        }
        for line in lines {
            let length = line.text.chars().count();
            assert!((1..=46).contains(&length), "{}: {length} characters in {:?}", info.id, line.text);
            let marks: BTreeSet<String> = line.lit_by.iter().copied().map(word).collect();
            assert_eq!(marks.len(), line.lit_by.len(), "no mark twice: {}", line.text);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn every_iteration_lights_a_line_and_every_mark_is_met() {
    let worlds = [arm_and_wall(0.1), disc_and_wall(0.3, 0.5), disc_and_pillar(), no_way()];
    let cars = [car_and_wall(0.1), car_shut_in(0.1)];
    let mut met: BTreeSet<(&str, String)> = BTreeSet::new();
    for (planner, words) in settings() {
        let options = PlannerOptions::of(planner).expect("a planner");
        let lines = options.info().pseudocode;
        for world in if options.robots() == ["car"] { &cars[..] } else { &worlds } {
            let settings = fitting(world, &words);
            let limit = if settings.contains("max_iterations") { "" } else { " max_iterations=1500" };
            let mut run = begin_with(world, planner, 5, &(settings + limit));
            while run.status() == Status::Running {
                let marks = marks_of_one(&mut *run);
                assert!(!lit(lines, &marks).is_empty(), "{planner} {words}: nothing is lit by {marks:?}");
                met.extend(marks.into_iter().map(|mark| (planner, mark)));
            }
        }
    }
    for info in planners().map(|planner| planner.info()) {
        let marks = |lines: &[PseudocodeLine]| -> BTreeSet<String> {
            lines.iter().flat_map(|line| line.lit_by).copied().map(word).collect()
        };
        let happened: BTreeSet<String> =
            met.iter().filter(|(id, _)| *id == info.id).map(|(_, mark)| mark.clone()).collect();
        let mut lines = marks(info.pseudocode);
        // Only a resumed roadmap connects here: see the next test.
        if info.id == "visibility-prm" {
            assert!(lines.remove("connecting"));
        }
        assert_eq!(lines, happened, "{}: what lights a line, and what happens", info.id);
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_resumed_roadmap_lights_lines_too() {
    let world = arm_and_wall(0.1);
    for (planner, settings) in [
        ("prm", "samples=80"),
        ("prm-star", "samples=80"),
        ("lazy-prm", "samples=80"),
        ("visibility-prm", "failures=60"),
    ] {
        let lines = PlannerOptions::of(planner).expect("a planner").info().pseudocode;
        let saved = finish(begin_with(&world, planner, 5, settings)).roadmap().expect("a roadmap");
        // Another start, so that it has to be connected.
        let mut other = serde_json::json!(world);
        other["queries"][0]["start"][0] = 0.7.into();
        let other = parse(&other.to_string());
        let mut run = resume(&other, &options(planner, 5, ""), &saved).unwrap_or_else(|error| panic!("{error}"));
        let mut phases = BTreeSet::new();
        while run.status() == Status::Running {
            phases.insert(run.phase().as_str());
            let marks = marks_of_one(&mut *run);
            assert!(!lit(lines, &marks).is_empty(), "{planner}: nothing is lit by {marks:?}");
        }
        assert!(phases.contains("connecting"), "{planner}: {phases:?}");
    }
}

/// The committed catalogue is the one that the declarations give; `PLANARIUM_BLESS=1` writes it anew.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn the_committed_catalogue_is_up_to_date() {
    let text = format!("{:#}\n", planarium::catalogue::catalogue());
    crate::common::golden::committed("schema/catalogue.json", &text);
}

/// The patch of `docs/adding-a-planner.md` fits the tree as it is.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn the_documented_planner_can_be_added() {
    use std::io::Write;
    use std::process::{Command, Stdio};
    let root = env!("CARGO_MANIFEST_DIR");
    let text = std::fs::read_to_string(format!("{root}/docs/adding-a-planner.md")).expect("the file is there");
    let patch = text.split("```diff\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a patch");
    let mut git = Command::new("git")
        .args(["apply", "--check", "-"])
        .current_dir(root)
        .stdin(Stdio::piped())
        .spawn()
        .expect("git is there");
    git.stdin.take().expect("a pipe").write_all(patch.as_bytes()).expect("git reads the patch");
    assert!(git.wait().expect("git ends").success(), "the patch in docs/adding-a-planner.md does not apply");
}
