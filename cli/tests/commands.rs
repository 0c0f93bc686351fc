//! The command line: the program itself, its output, its exit codes.

use crate::documents::{disc, text as document};
use crate::program::{ROOM, file, path, planarium, planarium_with, spawn, text_of};
use serde_json::{Value, json};
use std::io::Write;
use std::process::Command;

#[test]
fn plan_prints_the_result_document() {
    for (planner, query) in [("rrt-connect", ""), ("prm", "--query around")] {
        let finished = planarium(&format!("plan room.json --planner {planner} --seed 3 {query}"));
        let result = finished.ended(0, "solved");
        assert!(!finished.stderr.contains('\u{1b}'), "no progress bar without a terminal: {:?}", finished.stderr);
        assert_eq!(finished.stdout.lines().count(), 1, "one line of JSON");
        let names = [("scenario", "room"), ("query", "around"), ("planner", planner)];
        names.into_iter().for_each(|(key, name)| assert_eq!(result[key], name));
        assert_eq!(result["seed"], 3);
        let path = result["path"].as_array().expect("a path");
        assert_eq!((&path[0], &path[path.len() - 1]), (&json!([0.5, 0.5]), &json!([2, 0.5])));
        assert!(result["length"].as_f64().expect("a length") > 2.0, "over the wall");
        assert_eq!(result["fingerprint"].as_str().expect("digits").len(), 16);
        let counts =
            "iterations vertices edges motion_checks nearest_queries clearance_evaluations build_seconds".split(' ');
        let more: &[&str] = if planner == "prm" { &["search_seconds", "visited"] } else { &[] };
        for name in counts.chain(more.iter().copied()) {
            assert!(result["stats"][name].as_f64() > Some(0.0), "{name}: {result}");
        }
        assert!(result.get("motions").is_none(), "motions are for cars");
    }
}

#[test]
fn a_seed_determines_all_but_the_seconds() {
    let run = |seed: &str| {
        let mut result = planarium(&format!("plan room.json --planner prm --seed {seed} --set samples=300")).json();
        result["stats"]["build_seconds"] = 0.into();
        result["stats"]["search_seconds"] = 0.into();
        result
    };
    assert_eq!(run("5"), run("5"));
    for threads in 1..=3 {
        assert_eq!(run("5"), run(&format!("5 --threads {threads}")));
    }
    assert_ne!(run("5")["fingerprint"], run("6")["fingerprint"]);
    let drawn = run("random");
    assert_eq!(run(&drawn["seed"].to_string()), drawn, "the result contains the seed that was drawn");
    assert_ne!(run("random")["seed"], drawn["seed"]);
}

#[test]
fn the_optimum_is_printed_and_a_result_compared_with_it() {
    let planned = planarium("plan room.json --seed 3");
    let finished = planarium_with("optimum room.json --result -", &planned.stdout);
    let found = finished.json();
    // Tangents to the arcs about the corners of the wall's top, and what lies between them.
    let corner = |x: f64| ((x * x + 1.0 - 0.01).sqrt(), 0.1 * (1.0_f64.atan2(x) + (0.1 / (x * x + 1.0).sqrt()).asin()));
    let [(left, turn_left), (right, turn_right)] = [corner(0.5), corner(0.9)];
    let length = found["length"].as_f64().expect("a length");
    assert!((length - (left + turn_left + 0.1 + turn_right + right)).abs() < 1e-12, "{length}");
    let gap = 100.0 * (planned.json()["length"].as_f64().expect("a length") / length - 1.0);
    assert!((found["gap"].as_f64().expect("a gap") - gap).abs() < 1e-9 && gap > 0.0, "{gap}");
    assert_eq!((finished.code, &found["exact"], &found["method"]), (0, &json!(true), &json!("tangent-graph")));
    assert!(finished.stderr.starts_with("shortest path: length 2.") && finished.stderr.contains(" % longer"));

    // What the result claims is not believed: neither a length nor a path through a wall.
    let told = |name: &str, value: Value| {
        let mut told = planned.json();
        told[name] = value;
        planarium_with("optimum room.json --result -", &told.to_string()).refuses("invalid-result", "/path");
    };
    told("length", json!(1.5));
    told("path", json!([[0.5, 0.5], [2, 0.5]]));
    told("status", json!("exhausted"));

    let none = planarium("optimum room.json --query cut-off");
    assert_eq!((none.code, &none.json()["length"], none.json().get("gap")), (1, &Value::Null, None));
    let firs = planarium("optimum firs.json --metric euclidean").json();
    assert_eq!((&firs["method"], &firs["exact"]), (&json!("grid"), &json!(false)));
    planarium("optimum room.json --query in-wall").refuses("goal-in-collision", "/queries/2/goal");
    planarium("optimum arm.json").refuses("unknown-query", "/query");
    planarium_with("optimum firs.json --result -", &planned.stdout).refuses("invalid-result", "/scenario");
}

#[test]
fn the_widest_disc_is_printed_with_its_bottleneck() {
    let finished = planarium("widest room.json");
    let found = finished.json();
    assert_eq!((finished.code, &found["radius"], &found["limit"]), (0, &json!(0.25), &json!("gap")));
    assert_eq!(found["between"], json!([0, "bounds"]));
    let [top, side] = [0, 1].map(|i| found["bottleneck"][i].clone());
    assert_eq!((&top[1], &side[1], &top[0]), (&json!(1.5), &json!(2), &side[0]));
    assert!(
        finished.stderr.contains("a radius of 0.250000 m") && finished.stderr.contains("obstacle 0 and the bounds")
    );
    let none = planarium("widest room.json --query cut-off");
    assert_eq!((none.code, &none.json()["radius"], &none.json()["limit"]), (1, &Value::Null, &json!("closed")));
    assert!(none.stderr.contains("not even for a point"), "{}", none.stderr);
    planarium("widest room.json --query in-wall").refuses("goal-in-collision", "/queries/2/goal");
    planarium("widest arm.json").refuses("unknown-query", "/query");
    planarium("widest firs.json").refuses("unsupported", "");
}

#[test]
fn the_safest_path_is_printed_with_the_widest_disc() {
    let (widest, finished) = (planarium("widest room.json").json(), planarium("safest room.json"));
    let found = finished.json();
    assert_eq!(finished.code, 0);
    for name in ["radius", "limit", "bottleneck", "between", "slack"] {
        assert_eq!(found[name], widest[name], "{name}");
    }
    let number = |name: &str| found[name].as_f64().unwrap_or_else(|| panic!("{name} is no number"));
    assert!(number("clearance") <= 0.25 && number("clearance") > 0.25 - 1e-11);
    assert!(number("length") > planarium("optimum room.json").json()["length"].as_f64().expect("a path"));
    // It goes through the middle of the gap.
    let path = found["path"].as_array().expect("a path");
    let is_middle = |point: &Value| point[1].as_f64().is_some_and(|y| (y - 1.75).abs() < 1e-9);
    assert!(path.len() > 2 && path.iter().any(is_middle));
    assert!(finished.stderr.contains("the safest path has length"), "{}", finished.stderr);
    let none = planarium("safest room.json --query cut-off");
    assert_eq!((none.code, &none.json()["length"], &none.json()["path"]), (1, &Value::Null, &json!([])));
    planarium("safest room.json --query in-wall").refuses("goal-in-collision", "/queries/2/goal");
    planarium("safest firs.json").refuses("unsupported", "");
}

#[test]
fn parameters_reach_the_planner() {
    let plain = "plan room.json --planner prm --set samples=150 --set k=7";
    let result = planarium(&format!("{plain} --set shortcut=40")).ended(0, "solved");
    assert_eq!(result["stats"]["vertices"], 152);
    assert!(result["length"].as_f64() < planarium(plain).json()["length"].as_f64(), "shortcuts shorten");
    assert!(result["stats"]["search_seconds"].as_f64().expect("seconds") > 0.0);
}

#[test]
fn a_path_is_made_shorter_unless_it_is_wanted_raw() {
    let length =
        |more: &str| planarium(&format!("plan room.json --seed 3 {more}")).ended(0, "solved")["length"].as_f64();
    assert_eq!(length("--raw"), length("--planner rrt-connect"));
    assert!(length("") < length("--raw"));
    let both = planarium("plan room.json --raw --planner prm");
    assert!(both.code == 2 && both.stderr.contains("cannot be used with"), "{}", both.stderr);
}

#[test]
fn an_impossible_query_exhausts_its_budget() {
    let result = planarium("plan room.json --query cut-off --max-iterations 500").ended(1, "exhausted");
    assert_eq!((&result["stats"]["iterations"], &result["path"]), (&json!(500), &json!([])));
    assert_eq!(result["length"].as_f64().map(f64::to_bits), Some(0), "0, not -0");
}

#[test]
fn a_certificate_is_printed_and_verified() {
    for (line, code, verdict, says) in [
        ("--query cut-off", 0, "infeasible", "infeasible: no path exists; "),
        ("--query around --clearance 0.25", 0, "connected", "connected: a path with clearance above 0.25 m exists; "),
        (
            "--query around --clearance 0.35",
            0,
            "infeasible",
            "infeasible: no path with clearance above 0.35 m exists; ",
        ),
        ("--query around --cells 1", 1, "unknown", "unknown: gave up after 1 cells; "),
    ] {
        let finished = planarium(&format!("certify room.json {line}"));
        assert_eq!((finished.code, finished.json()["verdict"].as_str()), (code, Some(verdict)), "{}", finished.stderr);
        assert!(finished.stderr.starts_with(says), "{}", finished.stderr);
        let verified = planarium_with("verify room.json -", &finished.stdout);
        assert_eq!((verified.code, verified.json()), (0, json!({ "valid": true })), "{}", verified.stderr);
    }
    planarium("certify room.json --query cut-off --out cut-off.json");
    let holed = text_of("cut-off.json").replacen(r#""part":0"#, r#""part":1"#, 1);
    let refused = planarium_with("verify room.json -", &holed);
    assert_eq!((refused.code, &refused.json()["valid"]), (1, &json!(false)), "{}", refused.stderr);
    planarium("certify room.json --query in-wall").refuses("goal-in-collision", "/goal");
    planarium("certify room.json --clearance -1").refuses("out-of-range", "/clearance");
    planarium("verify arm.json cut-off.json").refuses("invalid-result", "/scenario");
}

#[test]
fn a_path_is_timed_and_its_trajectory_verified() {
    planarium("plan room.json --seed 3 --set shortcut=20 --set blend=0.5 --out rounded.json");
    let finished = planarium("time room.json rounded.json --speed 1 --acceleration 2 --out timed.json");
    assert_eq!((finished.code, &*finished.stdout), (0, ""), "{}", finished.stderr);
    assert!(finished.stderr.ends_with(" rests on the way\n"), "{}", finished.stderr);
    let text = text_of("timed.json");
    let trajectory: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!((&trajectory["format"], &trajectory["query"]), (&json!("planarium-trajectory-1"), &json!("around")));
    let verified = planarium("verify room.json rounded.json --trajectory timed.json");
    let verdict = verified.json();
    assert_eq!((verified.code, &verdict["valid"]), (0, &json!(true)), "{}", verified.stderr);
    assert_eq!(verdict["trajectory"]["duration"], trajectory["duration"]);
    let slower = text.replacen(r#""speed":1"#, r#""speed":0.9"#, 1);
    let refused = planarium_with("verify room.json rounded.json --trajectory -", &slower);
    assert_eq!((refused.code, &refused.json()["valid"]), (1, &json!(false)), "{}", refused.stderr);
    planarium("plan room.json --seed 3 --query around --planner prm --out other.json");
    let refused = planarium("verify room.json other.json --trajectory timed.json");
    assert_eq!((refused.code, &refused.json()["valid"]), (1, &json!(false)), "{}", refused.stderr);
    for (options, code, pointer) in [
        ("--speed 0 --acceleration 1", "out-of-range", "/limits/speed"),
        ("--speed 1 --acceleration 1 --turn-rate 1", "unsupported", "/limits/turn_rate"),
        ("--speed 1,2,3 --acceleration 1", "wrong-dimension", "/limits/speed"),
        ("--speed 1,2 --acceleration 1 --turn-rate 1", "unsupported", "/limits/turn_rate"),
        ("--speed 1 --acceleration 1 --lateral-acceleration 1", "unsupported", "/limits/lateral_acceleration"),
        ("--speed 1", "usage", ""),
    ] {
        planarium(&format!("time room.json rounded.json {options}")).refuses(code, pointer);
    }
    planarium("time room.json room.json --speed 1 --acceleration 1").refuses("unknown-field", "/format");
    planarium("verify room.json timed.json --trajectory timed.json").refuses("usage", "");
}

#[test]
fn time_stops_a_run_and_the_result_contains_the_iterations() {
    let cut_off = "plan room.json --query cut-off";
    // A busy machine may stop the program while it runs; one try in five must keep to its time.
    let seconds = |result: &Value| result["stats"]["build_seconds"].as_f64().expect("seconds");
    let timed = |_| {
        let line = format!("{cut_off} --max-seconds 0.2 --max-iterations 4000000000");
        let result = planarium(&line).ended(1, "running");
        assert!(seconds(&result) > 0.1 && result["path"] == json!([]), "{result}");
        result
    };
    let result = (0..5).map(timed).find(|result| seconds(result) < 0.25).expect("0.2 s were given");

    // The iterations made, given as a budget, grow the same trees.
    let iterations = &result["stats"]["iterations"];
    let counted = planarium(&format!("{cut_off} --max-iterations {iterations}")).json();
    assert_eq!((&counted["status"], &counted["fingerprint"]), (&json!("exhausted"), &result["fingerprint"]));

    let none = planarium(&format!("{cut_off} --max-seconds 0")).json();
    assert_eq!((&none["status"], &none["stats"]["iterations"]), (&json!("running"), &json!(0)));
}

#[test]
fn time_that_is_up_while_a_path_is_improved_leaves_the_path() {
    let result = planarium("plan room.json --set shortcut=1000000 --max-seconds 0.3").ended(0, "solved");
    assert!(result["path"].as_array().is_some_and(|path| path.len() >= 2));
}

#[test]
fn a_roadmap_is_saved_and_resumed() {
    let build = "plan room.json --planner prm --set samples=300 --set k=9 --save-roadmap";
    let mut planned = Value::Null;
    for to in ["saved.roadmap", "saved.roadmap.json", "saved.graphml", "saved.text --roadmap-format json"] {
        planned = planarium(&format!("{build} {to}")).ended(0, "solved");
    }
    let bytes = std::fs::read(path("saved.roadmap")).expect("it is saved");
    let text = text_of("saved.roadmap.json");
    assert!(bytes.starts_with(&planarium::run::storage::MAGIC));
    assert!(text.starts_with("{\"format\":\"planarium-roadmap-2\"") && text == text_of("saved.text"));
    assert!(text_of("saved.graphml").contains("<graphml "));
    for saved in ["saved.roadmap", "saved.text"] {
        let line = format!("plan room.json --roadmap {saved} --save-roadmap saved.again");
        let result = planarium(&line).ended(0, "solved");
        ["planner", "path", "length"].into_iter().for_each(|key| assert_eq!(result[key], planned[key]));
        assert!(result["stats"]["motion_checks"] == 0, "nothing is left to connect: {result}");
        assert_eq!(std::fs::read(path("saved.again")).expect("it is saved"), bytes);
    }
    planarium_with("plan room.json --roadmap - --query cut-off", &text).ended(1, "exhausted");

    file("saved.damaged", text.replacen("\"k\":9", "\"k\":8", 1));
    for (arguments, code, pointer) in [
        ("room.json --roadmap saved.damaged", "invalid-roadmap", "/checksum"),
        ("room.json --roadmap saved.graphml", "invalid-roadmap", ""),
        ("room.json --roadmap no-such-file", "file", ""),
        ("room.json --roadmap saved.roadmap --save-roadmap /no/such/folder/roadmap", "file", ""),
        ("room.json --save-roadmap saved.roadmap", "unsupported", ""),
        ("room.json --roadmap-format json", "usage", ""),
        ("room.json --save-roadmap saved.roadmap --roadmap-format png", "usage", ""),
        ("- --roadmap -", "usage", ""),
    ] {
        planarium(&format!("plan {arguments}")).refuses(code, pointer);
    }
}

#[test]
fn verify_distinguishes_valid_from_invalid() {
    let planned = planarium("plan room.json").stdout;
    file("verify.result.json", &planned);
    let valid = planarium("verify room.json verify.result.json");
    let verdict = valid.json();
    assert_eq!((valid.code, &verdict["valid"]), (0, &json!(true)), "{verdict}");
    assert!(verdict["waypoints"].as_u64() > Some(2) && verdict["looks"].as_u64() > Some(1), "{verdict}");
    assert!(verdict["clearance"].as_f64().expect("there are obstacles") > 0.0, "{verdict}");
    assert!(valid.stderr.starts_with("valid: "), "{}", valid.stderr);

    let mut straight: Value = serde_json::from_str(&planned).expect("a result");
    (straight["path"], straight["length"]) = (json!([[0.5, 0.5], [2.0, 0.5]]), json!(1.5));
    let invalid = planarium_with("verify room.json -", &straight.to_string());
    assert_eq!((invalid.code, invalid.json()), (1, json!({ "valid": false, "why": "edge 0 touches obstacle 0" })));
    assert!(invalid.stderr.contains("edge 0 touches obstacle 0"), "{}", invalid.stderr);

    for (from, to, code, pointer) in [
        (r#""query":"around""#, r#""query":"sideways""#, "unknown-query", "/query"),
        (r#"]],"#, r#"]"#, "invalid-json", "/path"),
    ] {
        let text = planned.replacen(from, to, 1);
        assert_ne!(text, planned, "{from} occurs");
        planarium_with("verify room.json -", &text).refuses(code, pointer);
    }
    planarium("verify - -").refuses("usage", "");
}

#[test]
fn a_scenario_is_drawn_until_it_has_a_path_or_none() {
    for (ensure, verdict) in [("path", "connected"), ("no-path", "infeasible")] {
        let generated =
            planarium(&format!("generate discs --set robot=arm --set count=6 --set ensure={ensure} --seed 1"));
        assert_eq!((generated.code, generated.stderr.as_str()), (0, ""));
        let certified = planarium_with("certify -", &generated.stdout);
        assert_eq!(certified.json()["verdict"], verdict, "{}", certified.stderr);
        let slack = certified.json()["slack"].as_f64().expect("a number");
        assert_eq!(verdict == "infeasible", certified.stderr.contains(&format!("to within {slack:e} m")));
    }
    planarium("generate maze --set ensure=no-path --set draws=2").refuses("gave-up", "/ensure");
    planarium("generate maze --set draws=2").refuses("unknown-field", "/draws");
}

/// A disc that fills its world moves on a line: planners that give up say why samples are of no use, and a certificate decides.
#[test]
fn a_world_as_high_as_the_disc_is_decided_and_planners_say_why() {
    let world = |x: f64| {
        document(
            "flat",
            "[0, 0], [10, 1]",
            &disc([x, 0.5], 0.2),
            r#"{"type": "disc", "radius": 0.5}"#,
            r#""start": [1, 0.5], "goal": [9, 0.5]"#,
        )
    };
    let planned = planarium_with("plan - --planner prm --max-iterations 1000", &world(5.0));
    assert_eq!(planned.code, 1);
    assert!(planned.stderr.contains("the disc fills the world along y"), "{}", planned.stderr);
    assert_eq!(planarium_with("certify -", &world(5.0)).json()["verdict"], "infeasible");
    assert_eq!(planarium_with("certify -", &world(12.0)).json()["verdict"], "connected");
}

#[test]
fn generate_plan_and_verify_form_a_pipeline() {
    for (i, kind) in [
        "forest --set links=3 --seed 2",
        "clutter --seed 4",
        "clutter --set robot=arm --set links=2 --seed 5",
        "discs --set count=12 --seed 1",
        "maze --set difficulty=easy --seed 2",
        "gap --set width=0.3 --seed 3",
        "bug-trap --set mouth=0.3 --set turn=quarter --seed 4",
    ]
    .into_iter()
    .enumerate()
    {
        let generate = format!("generate {kind}");
        let generated = planarium(&generate);
        assert_eq!((generated.code, generated.stderr.as_str()), (0, ""), "{kind}");
        assert_eq!(generated.json()["format"], "planarium-scenario-1");
        assert_eq!(generated.stdout, planarium(&generate).stdout, "a seed is a scenario");
        let scenario = format!("pipeline.{i}.json");
        assert_eq!(planarium(&format!("{generate} --out {scenario}")).stdout, "", "to the file instead");
        assert_eq!(text_of(&scenario), generated.stdout);
        for planner in ["prm", "rrt-connect"] {
            let planned = planarium_with(&format!("plan - --planner {planner}"), &generated.stdout);
            assert_eq!(planned.code, 0, "{kind} {planner}: {}", planned.stderr);
            let verdict = planarium_with(&format!("verify {scenario} -"), &planned.stdout);
            assert_eq!(verdict.code, 0, "{kind} {planner}: {}", verdict.stdout);
            let result = format!("pipeline.{i}.{planner}.json");
            let quiet = planarium(&format!("plan {scenario} --planner {planner} --out {result}"));
            assert_eq!((quiet.code, quiet.stdout.as_str()), (0, ""));
            let verdict = planarium_with(&format!("verify - {result}"), &generated.stdout);
            assert_eq!(verdict.code, 0, "{kind} {planner}: {}", verdict.stdout);
        }
    }
}

#[test]
fn trajectories_prints_counts_and_writes_a_row_for_each() {
    let line = "trajectories --set count=120 --seed 5";
    let done = planarium(&format!("{line} --csv tracks.csv"));
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    let result = done.json();
    assert_eq!((&result["status"], &result["accepted"], &result["seed"]), (&json!("solved"), &json!(120), &json!(5)));
    assert!(result["seconds"].as_f64().expect("seconds") > 0.0);
    let text = text_of("tracks.csv");
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(text.lines().next(), Some("x,y,theta,v,w,duration,tries,microseconds,average_of_20"));
    assert_eq!(rows.len(), 121);
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().expect("a number");
    let tries: f64 = (1..=120).map(|row| number(row, 6)).sum();
    assert_eq!(Some(tries), result["iterations"].as_f64(), "every try belongs to one that was accepted");
    let mean = (1..=20).map(|row| number(row, 7)).sum::<f64>() / 20.0;
    assert!((number(20, 8) - mean).abs() < 0.01 && rows[19][8].is_empty(), "the mean begins with the twentieth");
    // The same seed, the same rows; and a square too small for so many.
    assert_eq!(planarium(line).json()["fingerprint"], result["fingerprint"]);
    let crowded = planarium("trajectories --set half_side=0.1 --set max_iterations=500");
    assert_eq!((crowded.code, &crowded.json()["status"]), (1, &json!("exhausted")));
}

#[test]
fn reach_prints_solutions_or_how_near_the_arm_can_come() {
    let reached = planarium("reach arm.json --target 1,-0.5 --solutions 2 --seed 3 --start 0.5,-1e-1");
    let result = reached.json();
    assert_eq!((reached.code, &result["status"], &result["seed"]), (0, &json!("solved"), &json!(3)), "{result}");
    assert_eq!(result["solutions"].as_array().map(Vec::len), Some(2));
    assert!(reached.stderr.starts_with("reached: 2 solutions"), "{}", reached.stderr);
    let far = planarium("reach arm.json --target=-1,0.5 --orientation 2.5 --method newton --set restarts=3");
    let verdict = &far.json()["verdict"];
    assert_eq!((far.code, &verdict["verdict"]), (1, &json!("out-of-reach")));
    assert!(verdict["nearest"]["distance"].as_f64().is_some_and(|distance| distance > 0.0));
}

#[test]
fn list_describes_everything_in_the_catalogue() {
    let mut listed = planarium("list --json").json();
    let world_errors = listed.as_object_mut().and_then(|listed| listed.remove("world_errors")).expect("codes of maps");
    assert_eq!(listed, planarium::catalogue::catalogue());
    let tables = planarium("list");
    assert_eq!((tables.code, tables.stderr.as_str()), (0, ""));
    let rows = |rows: &Value| -> Vec<Value> { rows.as_array().expect("rows").clone() };
    // The words of a field of all rows, each of which is in the tables too.
    let words = |list: &Value, key: &str| -> Vec<String> {
        let words: Vec<_> = rows(list).iter().map(|row| row[key].as_str().expect(key).to_owned()).collect();
        words.iter().for_each(|word| assert!(!word.is_empty() && tables.stdout.contains(word.as_str()), "{word}"));
        words
    };
    for (field, options) in [("planners", "parameters"), ("reach_methods", "parameters"), ("generators", "options")] {
        words(&listed[field], "id");
        words(&listed[field], "summary");
        for entry in rows(&listed[field]) {
            words(&entry[options], "name");
            words(&entry[options], "meaning");
        }
    }
    assert_eq!(words(&listed["generators"], "id"), ["forest", "clutter", "discs", "maze", "gap", "bug-trap"]);
    let known: Vec<&str> = planarium::error::Code::ALL.iter().map(|code| code.as_str()).collect();
    assert_eq!((known.len(), known[0], known[31]), (32, "invalid-json", "usage"));
    assert_eq!(words(&listed["errors"], "code"), known, "every code once, in order");
    let known: Vec<&str> = planarium_formats::Code::ALL.iter().map(|code| code.as_str()).collect();
    assert_eq!(words(&world_errors, "code"), known, "every code once, in order");
    assert!(known.iter().all(|code| planarium::error::Code::ALL.iter().all(|other| other.as_str() != *code)));
    words(&world_errors, "meaning");
}

#[test]
fn wrong_input_exits_2_with_code_and_pointer() {
    for (line, code, pointer) in [
        ("plan missing.json", "file", ""),
        ("plan room.json --out room.json/out.json", "file", ""),
        ("plan room.json --planner dijkstra", "unknown-planner", "/algorithm"),
        ("plan room.json --query nowhere", "unknown-query", "/query"),
        ("plan room.json --query in-wall", "goal-in-collision", "/queries/2/goal"),
        ("plan room.json --set n=3", "unknown-parameter", "/n"),
        ("plan room.json --planner prm --set k=many", "wrong-type", "/k"),
        ("plan room.json --set step=nan", "not-finite", "/step"),
        ("plan room.json --set shortcut=1 --set shortcut=2", "duplicate-field", "/shortcut"),
        ("plan room.json --max-iterations 0", "out-of-range", "/max_iterations"),
        ("plan room.json --set k", "usage", ""),
        ("plan room.json --set =3", "usage", ""),
        ("plan room.json --seed -1", "usage", ""),
        ("plan room.json --seed 9007199254740992", "usage", ""),
        ("plan room.json --seed 1.5", "usage", ""),
        ("plan room.json --max-seconds -1", "usage", ""),
        ("plan room.json --max-seconds nan", "usage", ""),
        ("plan room.json --max-iterations -1", "usage", ""),
        ("plan room.json --threads 0", "usage", ""),
        ("sweep room.json --out rows.csv --threads 1000000", "usage", ""),
        ("plan room.json --speed 9", "usage", ""),
        ("plan", "usage", ""),
        ("verify room.json", "usage", ""),
        ("verify room.json missing.json", "file", ""),
        ("dance", "usage", ""),
        ("generate maze --set thickness=thin", "wrong-type", "/thickness"),
        ("generate bug-trap --set mouth=nan", "not-finite", "/mouth"),
        ("generate forest --set seed=1", "duplicate-field", "/seed"),
        ("trajectories --set colour=red", "unknown-parameter", "/colour"),
        ("trajectories --set count=5 --csv /no/such/folder/tracks.csv", "file", ""),
        ("reach arm.json --target=-1,0.5 --method magic", "out-of-range", "/method"),
        ("reach arm.json --target 1,nan", "not-finite", "/target/1"),
        ("reach arm.json --target 1", "usage", ""),
        ("reach arm.json", "usage", ""),
        ("reach arm.json --target 1,0 --start 0", "wrong-dimension", "/start"),
        ("reach room.json --target 1,0", "unsupported", ""),
        ("nearest firs.json --target 0", "wrong-dimension", "/target"),
        ("nearest firs.json --target 0,1e7", "out-of-range", "/target/1"),
        ("nearest firs.json --target nan,0", "not-finite", "/target/0"),
        ("nearest firs.json --target 0,x", "usage", ""),
        ("nearest firs.json --k 3", "usage", ""),
        ("nearest firs.json --target 0,0 --k 3 --within 2", "usage", ""),
    ] {
        planarium(line).refuses(code, pointer);
    }
    // Without any argument the help is the message.
    let bare = planarium("");
    assert_eq!((bare.code, &bare.json()["error"]["code"]), (2, &json!("usage")));
    assert!(bare.stderr.contains("Usage: planarium"), "{}", bare.stderr);
}

#[test]
fn wrong_scenarios_exit_2_with_code_and_pointer() {
    for (from, to, code, pointer) in [
        (ROOM, "{", "invalid-json", ""),
        ("\"radius\": 0.1", "\"radius\": 1e999", "invalid-json", "/robot/radius"),
        ("\"queries\"", "\"questions\"", "unknown-field", "/questions"),
    ] {
        let text = ROOM.replacen(from, to, 1);
        planarium_with("plan -", &text).refuses(code, pointer);
        planarium_with("verify - /dev/null", &text).refuses(code, pointer);
    }
}

#[test]
fn every_command_has_a_help() {
    let version = planarium("--version");
    assert_eq!((version.code, version.stdout.trim()), (0, concat!("planarium ", env!("CARGO_PKG_VERSION"))));
    for line in ["--help", "plan --help", "verify -h", "list -h", "generate -h", "trajectories -h", "help"] {
        let help = planarium(line);
        assert_eq!((help.code, help.stderr.as_str()), (0, ""), "{line}");
        assert!(help.stdout.contains("Examples:") && help.stdout.contains("Usage: planarium"), "{}", help.stdout);
    }
    let plan = planarium("plan --help").stdout;
    let options =
        "--query --planner --seed --set --max-iterations --max-seconds --threads --roadmap --save-roadmap --out";
    options.split(' ').for_each(|option| assert!(plan.contains(option), "{option}"));
}

#[test]
fn a_closed_pipe_does_not_panic() {
    for (line, code) in [("plan -", 0), ("plan - --query in-wall", 2), ("verify - /dev/null", 2)] {
        let mut child = spawn(line);
        drop(child.stdout.take());
        child.stdin.take().expect("a pipe").write_all(ROOM.as_bytes()).expect("it reads");
        let output = child.wait_with_output().expect("the program ends");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(!stderr.contains("panicked") && !stderr.contains("cannot write"), "{line}: {stderr}");
        assert_eq!(output.status.code(), Some(code), "{line}: {stderr}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_result_that_is_lost_is_an_error() {
    file("lost.json", ROOM);
    let run = |rest: &str| {
        let line = format!("'{}' plan lost.json --query around {rest}", env!("CARGO_BIN_EXE_planarium"));
        let mut command = Command::new("sh");
        let output = command.args(["-c", &line]).current_dir(env!("CARGO_TARGET_TMPDIR")).output().expect("a shell");
        (output.status.code().expect("no signal"), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for closed in [">&-", ">/dev/full"] {
        let (code, stderr) = run(closed);
        assert_eq!(code, 2, "{closed}: {stderr}");
        assert!(stderr.contains("error: cannot write to standard output"), "{closed}: {stderr}");
    }
    assert_eq!(run("--out lost.result.json >&-").0, 0, "nothing is lost");
    assert_eq!(run(">/dev/null").0, 0, "it is discarded on purpose");
}

#[test]
fn the_schemas_are_printed() {
    for (line, expected) in [
        ("schema", planarium::scenario::schema()),
        ("schema scenario", planarium::scenario::schema()),
        ("schema experiment", planarium::experiment::schema()),
    ] {
        let schema = planarium(line);
        assert_eq!((schema.code, schema.json()), (0, expected));
    }
}
