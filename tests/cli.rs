//! The command line as a person or a script meets it: the real program, its output, its exit codes.

use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};

/// A disc in a room with a wall that has a gap, and one query behind a closed wall.
const ROOM: &str = r#"{
    "format": "planarium-scenario-1", "name": "room",
    "world": { "bounds": {"min": [0, 0], "max": [4, 2]}, "obstacles": [
        {"type": "polygon", "vertices": [[1, 0], [1.1, 0], [1.1, 1.5], [1, 1.5]]},
        {"type": "polygon", "vertices": [[3, 0], [3.1, 0], [3.1, 2], [3, 2]]} ] },
    "robot": {"type": "disc", "radius": 0.1},
    "queries": [ {"name": "around", "start": [0.5, 0.5], "goal": [2, 0.5]}, {"name": "cut off", "start": [0.5, 0.5], "goal": [3.5, 1]},
                 {"name": "in the wall", "start": [0.5, 0.5], "goal": [3.05, 1]} ] }"#;

/// What a finished program left behind.
struct Finished {
    code: i32,
    stdout: String,
    stderr: String,
}

impl Finished {
    #[track_caller]
    fn json(&self) -> Value {
        serde_json::from_str(&self.stdout)
            .unwrap_or_else(|error| panic!("{error}: {:?} {:?}", self.stdout, self.stderr))
    }

    /// The code and the pointer of the error that standard output holds, with exit code 2 and a word on standard error.
    #[track_caller]
    fn error(&self) -> (String, String) {
        let document = self.json();
        let error = document["error"].as_object().expect("an error");
        assert_eq!(self.code, 2, "{document}");
        assert!(self.stderr.starts_with("error: "), "{:?}", self.stderr);
        let text = |key: &str| error[key].as_str().expect("a string").to_owned();
        assert!(text("message").len() > 8, "{document}");
        (text("code"), text("pointer"))
    }
}

fn spawn(arguments: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_planarium"));
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().expect("the program starts")
}

fn planarium_with(arguments: &[&str], input: &str) -> Finished {
    let mut child = spawn(arguments);
    // A program that refuses its arguments reads nothing: then the pipe is closed, and that is fine.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    let output = child.wait_with_output().expect("the program ends");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    Finished {
        code: output.status.code().expect("no signal"),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    }
}

fn planarium(arguments: &[&str]) -> Finished {
    planarium_with(arguments, "")
}

/// The path of a file with this text, of its own for each name.
fn file(name: &str, text: &str) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).expect("the folder for test files can be written");
    path.into_os_string().into_string().expect("the folder's name is text")
}

#[test]
fn plan_prints_the_result_document() {
    let room = file("plan.json", ROOM);
    for (planner, query) in [("rrt-connect", None), ("prm", Some("around"))] {
        let mut arguments = vec!["plan", &room, "--planner", planner, "--seed", "3"];
        arguments.extend(query.into_iter().flat_map(|name| ["--query", name]));
        let finished = planarium(&arguments);
        let result = finished.json();
        assert_eq!((finished.code, result["status"].as_str()), (0, Some("solved")), "{}", finished.stderr);
        assert!(finished.stderr.starts_with("solved: "), "{}", finished.stderr);
        assert!(!finished.stderr.contains('\u{1b}'), "no progress bar where nobody looks: {:?}", finished.stderr);
        assert_eq!(finished.stdout.lines().count(), 1, "one line of JSON");
        let names = [("scenario", "room"), ("query", "around"), ("planner", planner)];
        names.into_iter().for_each(|(key, name)| assert_eq!(result[key], name));
        assert_eq!(result["seed"], 3);
        let path = result["path"].as_array().expect("a path");
        assert_eq!((&path[0], &path[path.len() - 1]), (&serde_json::json!([0.5, 0.5]), &serde_json::json!([2, 0.5])));
        assert!(result["length"].as_f64().expect("a length") > 2.0, "over the wall");
        assert_eq!(result["fingerprint"].as_str().expect("digits").len(), 16);
        let stats = &result["stats"];
        for count in ["iterations", "vertices", "edges", "motion_checks", "nearest_queries", "clearance_evaluations"] {
            assert!(stats[count].as_u64().expect(count) > 0, "{count}: {stats}");
        }
        assert!(stats["build_seconds"].as_f64().expect("seconds") > 0.0, "{stats}");
        if planner == "prm" {
            assert!(stats["search_seconds"].as_f64().expect("seconds") > 0.0, "{stats}");
            assert!(stats["visited"].as_u64().expect("a count") > 0, "{stats}");
        }
        assert!(result.get("motions").is_none(), "motions are for cars");
    }
}

#[test]
fn a_seed_decides_all_but_the_seconds() {
    let room = file("seed.json", ROOM);
    let run = |seed: &str| {
        let mut result = planarium(&["plan", &room, "--planner", "prm", "--seed", seed, "--set", "samples=300"]).json();
        result["stats"]["build_seconds"] = 0.into();
        result["stats"]["search_seconds"] = 0.into();
        result
    };
    assert_eq!(run("5"), run("5"));
    assert_ne!(run("5")["fingerprint"], run("6")["fingerprint"]);
    let drawn = run("random");
    assert_eq!(run(&drawn["seed"].to_string()), drawn, "the result tells the seed that was drawn");
    assert_ne!(run("random")["seed"], drawn["seed"]);
}

#[test]
fn parameters_reach_the_planner() {
    let room = file("set.json", ROOM);
    let finished =
        planarium(&["plan", &room, "--planner", "prm", "--set", "samples=150", "--set", "k=7", "--set", "shortcut=40"]);
    let result = finished.json();
    assert_eq!((finished.code, result["stats"]["vertices"].as_u64()), (0, Some(152)));
    let plain = planarium(&["plan", &room, "--planner", "prm", "--set", "samples=150", "--set", "k=7"]).json();
    assert!(result["length"].as_f64() < plain["length"].as_f64(), "shortcuts shorten");
    assert!(result["stats"]["search_seconds"].as_f64().expect("seconds") > 0.0);
}

#[test]
fn an_impossible_query_exhausts_its_budget() {
    let room = file("impossible.json", ROOM);
    let cut_off = ["plan", &room, "--query", "cut off"];
    let finished = planarium(&[&cut_off[..], &["--max-iterations", "500"]].concat());
    let result = finished.json();
    assert_eq!((finished.code, result["status"].as_str()), (1, Some("exhausted")));
    assert_eq!(result["stats"]["iterations"], 500);
    assert_eq!(result["path"], serde_json::json!([]));
    assert_eq!(result["length"].as_f64().map(f64::to_bits), Some(0), "0, not -0");
    assert!(finished.stderr.starts_with("exhausted: "), "{}", finished.stderr);
}

#[test]
fn time_stops_a_run_and_the_result_tells_how_far_it_came() {
    let room = file("time.json", ROOM);
    let cut_off = ["plan", &room, "--query", "cut off"];
    // A busy machine may stop the program while it runs; one try in five must keep to its time.
    let mut shortest = f64::INFINITY;
    let mut result = Value::Null;
    for _ in 0..5 {
        let timed = planarium(&[&cut_off[..], &["--max-seconds", "0.2", "--max-iterations", "4000000000"]].concat());
        result = timed.json();
        assert_eq!((timed.code, result["status"].as_str()), (1, Some("running")));
        assert_eq!(result["path"], serde_json::json!([]));
        assert!(timed.stderr.starts_with("running: "), "{}", timed.stderr);
        let seconds = result["stats"]["build_seconds"].as_f64().expect("seconds");
        assert!(seconds > 0.1, "0.2 s were given, {seconds} s used");
        shortest = shortest.min(seconds);
        if shortest < 0.25 {
            break;
        }
    }
    assert!(shortest < 0.25, "0.2 s were given, {shortest} s taken");

    // The iterations made, given as a budget, grow the same trees.
    let iterations = result["stats"]["iterations"].as_u64().expect("a count").to_string();
    let counted = planarium(&[&cut_off[..], &["--max-iterations", &iterations]].concat()).json();
    assert_eq!(counted["status"], "exhausted");
    assert_eq!(counted["fingerprint"], result["fingerprint"]);

    let none = planarium(&[&cut_off[..], &["--max-seconds", "0"]].concat()).json();
    assert_eq!((none["status"].as_str(), none["stats"]["iterations"].as_u64()), (Some("running"), Some(0)));
}

#[test]
fn time_that_is_up_while_a_path_is_improved_leaves_the_path() {
    let room = file("improved.json", ROOM);
    let improved = planarium(&["plan", &room, "--set", "shortcut=1000000", "--max-seconds", "0.3"]);
    let result = improved.json();
    assert_eq!((improved.code, result["status"].as_str()), (0, Some("solved")), "{}", improved.stderr);
    assert!(result["path"].as_array().is_some_and(|path| path.len() >= 2));
}

#[test]
fn a_roadmap_is_saved_and_gone_on_with() {
    let room = file("kept.json", ROOM);
    let place = |name: &str| {
        PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name).into_os_string().into_string().expect("text")
    };
    let build = ["plan", &room, "--planner", "prm", "--set", "samples=300", "--set", "k=9", "--save-roadmap"];
    let mut planned = Value::Null;
    for (name, format) in
        [("kept.roadmap", None), ("kept.roadmap.json", None), ("kept.graphml", None), ("kept.text", Some("json"))]
    {
        let name = place(name);
        let format = format.map_or(vec![], |format| vec!["--roadmap-format", format]);
        let finished = planarium(&[&build[..], &[&name], &format].concat());
        planned = finished.json();
        assert_eq!(finished.code, 0, "{}", finished.stderr);
    }
    let bytes = std::fs::read(place("kept.roadmap")).expect("it is saved");
    let text = std::fs::read_to_string(place("kept.roadmap.json")).expect("it is saved");
    assert!(
        bytes.starts_with(&planarium::run::storage::MAGIC) && text.starts_with("{\"format\":\"planarium-roadmap-2\"")
    );
    assert_eq!(text, std::fs::read_to_string(place("kept.text")).expect("it is saved"));
    assert!(std::fs::read_to_string(place("kept.graphml")).expect("it is saved").contains("<graphml "));
    for kept in ["kept.roadmap", "kept.text"] {
        let resumed = planarium(&["plan", &room, "--roadmap", &place(kept), "--save-roadmap", &place("kept.again")]);
        let result = resumed.json();
        assert_eq!((resumed.code, &result["planner"]), (0, &Value::from("prm")), "{}", resumed.stderr);
        assert_eq!((&result["path"], &result["length"]), (&planned["path"], &planned["length"]));
        assert!(result["stats"]["motion_checks"] == 0, "nothing is left to join: {result}");
        assert_eq!(std::fs::read(place("kept.again")).expect("it is saved"), bytes);
    }
    let piped = planarium_with(&["plan", &room, "--roadmap", "-", "--query", "cut off"], &text);
    assert_eq!((piped.code, piped.json()["status"].as_str()), (1, Some("exhausted")), "a question of its own");

    let damaged = file("kept.damaged", &text.replacen("\"k\":9", "\"k\":8", 1));
    let other = file("kept.other.json", &ROOM.replacen("[3.1, 2]", "[3.2, 2]", 1));
    let kept = place("kept.roadmap");
    let cases: &[(&[&str], &str, &str)] = &[
        (&["--roadmap", &damaged], "invalid-roadmap", "/checksum"),
        (&["--roadmap", &place("kept.graphml")], "invalid-roadmap", ""),
        (&["--roadmap", "no such file"], "file", ""),
        (&["--roadmap", &kept, "--planner", "rrt-connect"], "out-of-range", "/algorithm"),
        (&["--roadmap", &kept, "--set", "k=8"], "out-of-range", "/k"),
        (&["--roadmap", &kept, "--save-roadmap", "/no/such/folder/roadmap"], "file", ""),
        (&["--save-roadmap", &kept], "unsupported", ""),
        (&["--roadmap-format", "json"], "usage", ""),
        (&["--save-roadmap", &kept, "--roadmap-format", "png"], "usage", ""),
    ];
    for (arguments, code, pointer) in cases {
        let (found, pointed) = planarium(&[&["plan", &room], *arguments].concat()).error();
        assert_eq!((found.as_str(), pointed.as_str()), (*code, *pointer), "{arguments:?}");
    }
    assert_eq!(planarium(&["plan", &other, "--roadmap", &kept]).error().0, "other-scenario");
    assert_eq!(planarium(&["plan", "-", "--roadmap", "-"]).error().0, "usage");
}

#[test]
fn verify_tells_valid_from_not() {
    let room = file("verify.json", ROOM);
    let planned = planarium(&["plan", &room]).stdout;
    let result = file("verify.result.json", &planned);
    let valid = planarium(&["verify", &room, &result]);
    let verdict = valid.json();
    assert_eq!((valid.code, verdict["valid"].as_bool()), (0, Some(true)), "{verdict}");
    assert!(verdict["waypoints"].as_u64() > Some(2) && verdict["looks"].as_u64() > Some(1), "{verdict}");
    assert!(verdict["clearance"].as_f64().expect("there are obstacles") > 0.0, "{verdict}");
    assert!(valid.stderr.starts_with("valid: "), "{}", valid.stderr);

    let mut straight: Value = serde_json::from_str(&planned).expect("a result");
    straight["path"] = serde_json::json!([[0.5, 0.5], [2.0, 0.5]]);
    straight["length"] = 1.5.into();
    let invalid = planarium_with(&["verify", &room, "-"], &straight.to_string());
    let verdict = invalid.json();
    assert_eq!((invalid.code, verdict["valid"].as_bool()), (1, Some(false)), "{verdict}");
    assert_eq!(verdict["why"], "edge 0 touches obstacle 0");
    assert!(invalid.stderr.contains("edge 0 touches obstacle 0"), "{}", invalid.stderr);

    let errors = [
        (r#""seed":0"#, r#""seed":-4"#, ("out-of-range", "/seed")),
        (r#""query":"around""#, r#""query":"sideways""#, ("unknown-query", "/query")),
        (r#""scenario":"room""#, r#""scenario":"hall""#, ("invalid-result", "/scenario")),
        (r#""vertices":"#, r#""vertexes":"#, ("unknown-field", "/stats/vertexes")),
        (r#"]],"#, r#"]"#, ("invalid-json", "")),
    ];
    for (from, to, (code, pointer)) in errors {
        let text = planned.replacen(from, to, 1);
        assert_ne!(text, planned, "{from} occurs");
        let error = planarium_with(&["verify", &room, "-"], &text).error();
        assert_eq!(error.0, code, "{to}");
        assert!(code == "invalid-json" || error.1 == pointer, "{to}: {}", error.1);
    }
    assert_eq!(planarium(&["verify", "-", "-"]).error(), ("usage".into(), String::new()));
}

#[test]
fn a_pipeline_of_generate_plan_and_verify_holds_together() {
    let kinds: [&[&str]; 7] = [
        &["forest", "--set", "links=3", "--seed", "2"],
        &["clutter", "--seed", "4"],
        &["clutter", "--set", "robot=arm", "--set", "links=2", "--seed", "5"],
        &["discs", "--set", "count=12", "--seed", "1"],
        &["maze", "--set", "difficulty=easy", "--seed", "2"],
        &["gap", "--set", "width=0.3", "--seed", "3"],
        &["bug-trap", "--set", "mouth=0.3", "--set", "turn=quarter", "--seed", "4"],
    ];
    for (i, kind) in kinds.into_iter().enumerate() {
        let generated = planarium(&[&["generate"], kind].concat());
        assert_eq!((generated.code, generated.stderr.as_str()), (0, ""), "{kind:?}");
        assert_eq!(generated.json()["format"], "planarium-scenario-1");
        assert_eq!(generated.stdout, planarium(&[&["generate"], kind].concat()).stdout, "a seed is a scenario");
        let scenario = file(&format!("pipeline.{i}.json"), "");
        assert_eq!(planarium(&[&["generate"], kind, &["--out", &scenario]].concat()).stdout, "", "to the file instead");
        assert_eq!(std::fs::read_to_string(&scenario).expect("written"), generated.stdout);
        for planner in ["prm", "rrt-connect"] {
            let planned = planarium_with(&["plan", "-", "--planner", planner], &generated.stdout);
            assert_eq!(planned.code, 0, "{kind:?} {planner}: {}", planned.stderr);
            let verdict = planarium_with(&["verify", &scenario, "-"], &planned.stdout);
            assert_eq!(verdict.code, 0, "{kind:?} {planner}: {}", verdict.stdout);
            let result = file(&format!("pipeline.{i}.{planner}.json"), "");
            let quiet = planarium(&["plan", &scenario, "--planner", planner, "--out", &result]);
            assert_eq!((quiet.code, quiet.stdout.as_str()), (0, ""));
            let verdict = planarium_with(&["verify", "-", &result], &generated.stdout);
            assert_eq!(verdict.code, 0, "{kind:?} {planner}: {}", verdict.stdout);
        }
    }
}

#[test]
fn trajectories_prints_counts_and_writes_a_row_for_each() {
    let table = file("tracks.csv", "");
    let done = planarium(&["trajectories", "--set", "count=120", "--seed", "5", "--csv", &table]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    let result = done.json();
    assert_eq!((&result["status"], &result["accepted"], &result["seed"]), (&json!("solved"), &json!(120), &json!(5)));
    assert!(result["seconds"].as_f64().expect("seconds") > 0.0);
    let text = std::fs::read_to_string(&table).expect("written");
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0], "x,y,theta,v,w,duration,tries,microseconds,average_of_20".split(',').collect::<Vec<_>>());
    assert_eq!(rows.len(), 121);
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().expect("a number");
    let tries: f64 = (1..=120).map(|row| number(row, 6)).sum();
    assert_eq!(Some(tries), result["iterations"].as_f64(), "every try belongs to one that was accepted");
    let mean = (1..=20).map(|row| number(row, 7)).sum::<f64>() / 20.0;
    assert!((number(20, 8) - mean).abs() < 0.01 && rows[19][8].is_empty(), "the mean begins with the twentieth");
    // The same seed, the same rows; and a square too small for so many.
    let again = planarium(&["trajectories", "--set", "count=120", "--seed", "5"]).json();
    assert_eq!(again["fingerprint"], result["fingerprint"]);
    let crowded = planarium(&["trajectories", "--set", "half_side=0.1", "--set", "max_iterations=500"]);
    assert_eq!((crowded.code, &crowded.json()["status"]), (1, &json!("exhausted")));
}

#[test]
fn reach_prints_solutions_or_how_near_the_arm_can_come() {
    let arm = r#"{ "format": "planarium-scenario-1", "name": "arm", "world": { "obstacles": [] },
        "robot": { "type": "arm", "base": [0, 0], "links": [1, 0.8], "joint_limits": [[-3, 3], [-2, 2]] }, "queries": [] }"#;
    let arm = file("reach.json", arm);
    let reached =
        planarium(&["reach", &arm, "--target", "1,-0.5", "--solutions", "2", "--seed", "3", "--start", "0.5,-1e-1"]);
    let result = reached.json();
    assert_eq!(
        (reached.code, result["status"].as_str(), result["seed"].as_u64()),
        (0, Some("solved"), Some(3)),
        "{result}"
    );
    assert_eq!(result["solutions"].as_array().map(Vec::len), Some(2));
    assert!(reached.stderr.starts_with("reached: 2 solutions"), "{}", reached.stderr);
    let by_name = |method: &str| {
        planarium(&[
            "reach",
            &arm,
            "--target=-1,0.5",
            "--orientation",
            "2.5",
            "--method",
            method,
            "--set",
            "restarts=3",
        ])
    };
    let far = by_name("newton");
    assert_eq!((far.code, far.json()["verdict"]["verdict"].as_str()), (1, Some("out-of-reach")));
    assert!(far.json()["verdict"]["nearest"]["distance"].as_f64().is_some_and(|distance| distance > 0.0));
    let error = |code: &str, pointer: &str| (code.to_owned(), pointer.to_owned());
    assert_eq!(by_name("magic").error(), error("out-of-range", "/method"));
    let refused = |arguments: &[&str]| planarium(&[&["reach", &arm], arguments].concat()).error();
    assert_eq!(refused(&["--target", "1,nan"]), error("not-finite", "/target/1"));
    assert_eq!(refused(&["--target", "1"]), error("usage", ""));
    assert_eq!(refused(&[]), error("usage", ""));
    assert_eq!(refused(&["--target", "1,0", "--start", "0"]), error("wrong-dimension", "/start"));
    assert_eq!(refused(&["--target", "1,0", "--start", "0,2.5"]), error("out-of-range", "/start/1"));
    assert_eq!(refused(&["--target", "1,0", "--set", "speed=1"]), error("unknown-parameter", "/speed"));
    let disc = planarium_with(&["reach", "-", "--target", "1,0"], ROOM);
    assert_eq!(disc.error(), error("unsupported", ""));
    let tables = planarium(&["list"]);
    for method in planarium(&["list", "--json"]).json()["reach_methods"].as_array().expect("methods") {
        assert!(tables.stdout.contains(method["id"].as_str().expect("an id")));
        assert!(tables.stdout.contains(method["summary"].as_str().expect("a summary")));
    }
}

#[test]
fn list_tells_planners_parameters_and_error_codes() {
    let tables = planarium(&["list"]);
    let listed = planarium(&["list", "--json"]).json();
    assert_eq!((tables.code, tables.stderr.as_str()), (0, ""));
    let names = |rows: &Value, key: &str| -> Vec<String> {
        rows.as_array().expect("rows").iter().map(|row| row[key].as_str().expect(key).to_owned()).collect()
    };
    let ids = names(&listed["planners"], "id");
    assert!(ids.iter().any(|id| id == "prm") && ids.iter().any(|id| id == "rrt-connect"), "{ids:?}");
    for planner in listed["planners"].as_array().expect("planners") {
        for parameter in planner["parameters"].as_array().expect("parameters") {
            assert!(!parameter["meaning"].as_str().expect("a meaning").is_empty());
            let numeric = parameter["kind"] == "integer" || parameter["kind"] == "number";
            assert!(!numeric || parameter["min"].as_f64() <= parameter["max"].as_f64(), "{parameter}");
        }
        for line in planner["pseudocode"].as_array().expect("pseudo-code") {
            assert!(line["text"].as_str().is_some_and(|text| !text.is_empty()) && line["indent"].is_u64(), "{line}");
            assert!(line["lit_by"].as_array().expect("marks").iter().all(Value::is_string), "{line}");
        }
        let parameters = names(&planner["parameters"], "name");
        assert!(parameters.iter().any(|name| name == "max_iterations"), "{parameters:?}");
        parameters.iter().for_each(|name| assert!(tables.stdout.contains(name.as_str()), "{name}"));
    }
    let generators = names(&listed["generators"], "id");
    assert_eq!(generators, ["forest", "clutter", "discs", "maze", "gap", "bug-trap"]);
    for generator in listed["generators"].as_array().expect("generators") {
        for option in generator["options"].as_array().expect("options") {
            let is_choice = option["kind"] == "choice";
            assert!(if is_choice { option["default"] == option["choices"][0] } else { option["default"].is_number() });
            for word in ["name", "meaning"].map(|key| option[key].as_str().expect(key)) {
                assert!(!word.is_empty() && tables.stdout.contains(word), "{word}");
            }
        }
    }
    generators.iter().for_each(|id| assert!(tables.stdout.contains(id.as_str()), "{id}"));
    let codes = names(&listed["errors"], "code");
    let known: Vec<&str> = planarium::error::Code::ALL.iter().map(|code| code.as_str()).collect();
    assert_eq!((known.len(), known[0], known[26]), (27, "invalid-json", "usage"));
    assert_eq!(codes, known, "every code once, in order");
    codes.iter().for_each(|code| assert!(tables.stdout.contains(code.as_str()), "{code}"));
    ids.iter().for_each(|id| assert!(tables.stdout.contains(id.as_str()), "{id}"));
}

#[test]
fn wrong_input_exits_2_with_code_and_pointer() {
    let room = file("errors.json", ROOM);
    let missing = format!("{room}.missing");
    let unwritable = format!("{room}/out.json");
    let cases: &[(&[&str], &str, &str)] = &[
        (&["plan", &missing], "file", ""),
        (&["plan", &room, "--out", &unwritable], "file", ""),
        (&["plan", &room, "--planner", "dijkstra"], "unknown-planner", "/algorithm"),
        (&["plan", &room, "--query", "nowhere"], "unknown-query", "/query"),
        (&["plan", &room, "--query", "in the wall"], "goal-in-collision", "/queries/2/goal"),
        (&["plan", &room, "--set", "n=3"], "unknown-parameter", "/n"),
        (&["plan", &room, "--set", "k=3"], "unknown-parameter", "/k"),
        (&["plan", &room, "--planner", "prm", "--set", "k=0"], "out-of-range", "/k"),
        (&["plan", &room, "--planner", "prm", "--set", "k=1.5"], "out-of-range", "/k"),
        (&["plan", &room, "--planner", "prm", "--set", "k=many"], "wrong-type", "/k"),
        (&["plan", &room, "--set", "step=nan"], "not-finite", "/step"),
        (&["plan", &room, "--set", "metric=manhattan"], "out-of-range", "/metric"),
        (&["plan", &room, "--set", "shortcut=1", "--set", "shortcut=2"], "duplicate-field", "/shortcut"),
        (&["plan", &room, "--max-iterations", "0"], "out-of-range", "/max_iterations"),
        (&["plan", &room, "--set", "k"], "usage", ""),
        (&["plan", &room, "--set", "=3"], "usage", ""),
        (&["plan", &room, "--seed", "-1"], "usage", ""),
        (&["plan", &room, "--seed", "9007199254740992"], "usage", ""),
        (&["plan", &room, "--seed", "1.5"], "usage", ""),
        (&["plan", &room, "--max-seconds", "-1"], "usage", ""),
        (&["plan", &room, "--max-seconds", "nan"], "usage", ""),
        (&["plan", &room, "--max-iterations", "-1"], "usage", ""),
        (&["plan", &room, "--speed", "9"], "usage", ""),
        (&["plan"], "usage", ""),
        (&["verify", &room], "usage", ""),
        (&["verify", &room, &missing], "file", ""),
        (&["dance"], "usage", ""),
        (&["generate", "desert"], "unknown-generator", ""),
        (&["generate", "forest", "--set", "links=99"], "out-of-range", "/links"),
        (&["generate", "forest", "--set", "trees=9"], "unknown-field", "/trees"),
        (&["generate", "maze", "--set", "difficulty=brutal"], "out-of-range", "/difficulty"),
        (&["generate", "maze", "--set", "thickness=thin"], "wrong-type", "/thickness"),
        (&["generate", "gap", "--set", "robot=arm", "--set", "width=0"], "out-of-range", "/width"),
        (&["generate", "bug-trap", "--set", "mouth=nan"], "not-finite", "/mouth"),
        (&["generate", "discs", "--set", "count=200", "--set", "gap=0.2"], "out-of-range", "/count"),
        (&["generate", "forest", "--set", "seed=1"], "duplicate-field", "/seed"),
        (&["trajectories", "--set", "count=0"], "out-of-range", "/count"),
        (&["trajectories", "--set", "colour=red"], "unknown-parameter", "/colour"),
        (&["trajectories", "--set", "slowest=2"], "out-of-range", "/slowest"),
        (&["trajectories", "--set", "count=5", "--csv", "/no/such/folder/tracks.csv"], "file", ""),
    ];
    for (arguments, code, pointer) in cases {
        let finished = planarium(arguments);
        let (found, place) = finished.error();
        assert_eq!((found.as_str(), place.as_str()), (*code, *pointer), "{arguments:?}: {}", finished.stdout);
    }
    // Without any argument the help is the message.
    let bare = planarium(&[]);
    assert_eq!((bare.code, bare.json()["error"]["code"].as_str()), (2, Some("usage")));
    assert!(bare.stderr.contains("Usage: planarium"), "{}", bare.stderr);
}

#[test]
fn wrong_scenarios_exit_2_with_code_and_pointer() {
    let cases = [
        ("{", "invalid-json", ""),
        (&ROOM.replacen("scenario-1", "scenario-9", 1), "unknown-format", "/format"),
        (&ROOM.replacen("\"radius\": 0.1", "\"radius\": -0.1", 1), "out-of-range", "/robot/radius"),
        (&ROOM.replacen("\"radius\": 0.1", "\"radius\": 1e999", 1), "invalid-json", "/robot/radius"),
        (&ROOM.replacen("[3, 0]", "[3, \"0\"]", 1), "wrong-type", "/world/obstacles/1/vertices/0/1"),
        (&ROOM.replacen("\"cut off\"", "\"around\"", 1), "duplicate-name", "/queries/1/name"),
        (&ROOM.replacen("[3.5, 1]", "[3.5]", 1), "wrong-dimension", "/queries/1/goal"),
        (&ROOM.replacen("\"queries\"", "\"questions\"", 1), "unknown-field", "/questions"),
    ];
    for (text, code, pointer) in cases {
        let (found, place) = planarium_with(&["plan", "-"], text).error();
        assert_eq!((found.as_str(), place.as_str()), (code, pointer), "{text}");
        let (found, place) = planarium_with(&["verify", "-", "/dev/null"], text).error();
        assert_eq!((found.as_str(), place.as_str()), (code, pointer), "{text}");
    }
}

#[test]
fn a_collision_is_told_by_name() {
    let finished = planarium_with(&["plan", "-", "--query", "in the wall"], ROOM);
    let document = finished.json();
    let message = document["error"]["message"].as_str().expect("a message");
    assert!(message.contains("part 0 touches obstacle 1"), "{message}");
    assert!(finished.stderr.contains("part 0 touches obstacle 1"), "{}", finished.stderr);
}

#[test]
fn help_is_there_for_every_command() {
    let version = planarium(&["--version"]);
    assert_eq!((version.code, version.stdout.trim()), (0, concat!("planarium ", env!("CARGO_PKG_VERSION"))));
    let commands: [&[&str]; 7] = [
        &["--help"],
        &["plan", "--help"],
        &["verify", "-h"],
        &["list", "-h"],
        &["generate", "-h"],
        &["trajectories", "-h"],
        &["help"],
    ];
    for arguments in commands {
        let help = planarium(arguments);
        assert_eq!((help.code, help.stderr.as_str()), (0, ""), "{arguments:?}");
        assert!(help.stdout.contains("Examples:") && help.stdout.contains("Usage: planarium"), "{}", help.stdout);
    }
    let plan = planarium(&["plan", "--help"]).stdout;
    for option in [
        "--query",
        "--planner",
        "--seed",
        "--set",
        "--max-iterations",
        "--max-seconds",
        "--roadmap",
        "--save-roadmap",
        "--out",
    ] {
        assert!(plan.contains(option), "{option}");
    }
}

#[test]
fn a_reader_that_goes_away_is_no_reason_to_panic() {
    for arguments in [&["plan", "-"][..], &["plan", "-", "--query", "in the wall"], &["verify", "-", "/dev/null"]] {
        let mut child = spawn(arguments);
        drop(child.stdout.take());
        child.stdin.take().expect("a pipe").write_all(ROOM.as_bytes()).expect("it reads");
        let output = child.wait_with_output().expect("the program ends");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(!stderr.contains("panicked") && !stderr.contains("cannot write"), "{arguments:?}: {stderr}");
        assert_eq!(output.status.code(), Some(if arguments.len() == 2 { 0 } else { 2 }), "{arguments:?}: {stderr}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_result_that_is_lost_is_an_error() {
    let (room, kept) = (file("lost.json", ROOM), file("kept.json", ""));
    let program = env!("CARGO_BIN_EXE_planarium");
    let run = |rest: &str| {
        let line = format!("'{program}' plan '{room}' --query around {rest}");
        let output = Command::new("sh").args(["-c", &line]).output().expect("a shell");
        (output.status.code().expect("no signal"), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for closed in [">&-", ">/dev/full"] {
        let (code, stderr) = run(closed);
        assert_eq!(code, 2, "{closed}: {stderr}");
        assert!(stderr.contains("error: cannot write to standard output"), "{closed}: {stderr}");
    }
    assert_eq!(run(&format!("--out '{kept}' >&-")).0, 0, "nothing is lost");
    assert_eq!(run(">/dev/null").0, 0, "nobody wants it");
}

#[cfg(feature = "schema")]
#[test]
fn the_schema_is_printed() {
    let schema = planarium(&["schema"]);
    assert_eq!(schema.code, 0);
    assert_eq!(schema.json(), planarium::scenario::schema());
}
