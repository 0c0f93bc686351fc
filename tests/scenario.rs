//! What a scenario document may hold, what is refused, with which code and where, and how it is written again.

use planarium::Error;
use planarium::scenario::{FORMAT, LARGEST, MAX_OBSTACLES, MAX_VERTICES, Node, Obstacle, Robot, Scenario};
use wasm_bindgen_test::wasm_bindgen_test;

/// A document with every field that a scenario with an arm may have.
const ARM: &str = r#"{
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
const DISC: &str = r#"{
  "format": "planarium-scenario-1", "name": "disc", "title": "A disc",
  "world": {"bounds": {"min": [0, 0], "max": [2, 2]}, "obstacles": [{"type": "disc", "center": [1, 1], "radius": 0.5}]},
  "robot": {"type": "disc", "radius": 0.1},
  "queries": [{"name": "across", "start": [0.2, 0.2], "goal": [1.8, 1.8]}]
}"#;

/// A change to the first place where a piece of a document stands.
fn with(document: &str, piece: &str, replacement: &str) -> String {
    assert!(document.contains(piece), "{piece} does not stand in {document}");
    document.replacen(piece, replacement, 1)
}

fn refusal(document: &str) -> Error {
    match Scenario::parse(document) {
        Err(error) => error,
        Ok(_) => panic!("this was accepted: {}", &document[..document.len().min(2000)]),
    }
}

/// Replacement for a piece of a document; the code, the pointer, and a part of the sentence that must come of it.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str);

fn check_refusals(document: &str, cases: &[Case]) {
    Scenario::parse(document).expect("the document without a change is right");
    for &(piece, replacement, code, pointer, words) in cases {
        let error = refusal(&with(document, piece, replacement));
        let found = (error.code().as_str(), error.pointer());
        assert_eq!(found, (code, pointer), "{piece} -> {replacement}: {error}");
        assert!(error.message().contains(words), "{piece} -> {replacement}: {words:?} is not in {error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_document_becomes_a_scenario() {
    let scenario = Scenario::parse(ARM).unwrap();
    assert_eq!((scenario.name(), scenario.title()), ("arm", "An arm"));
    let Robot::Arm(arm) = scenario.robot() else { panic!("an arm") };
    assert_eq!((arm.links(), arm.radius(), arm.reach()), (&[1.0, 0.5][..], 0.05, 1.5));
    assert_eq!(arm.joint_limits(), Some(&[[-1.0, 1.0], [-2.0, 2.0]][..]));
    assert_eq!(scenario.world().obstacles.len(), 2);
    assert_eq!(scenario.queries()[1].goal, [0.0, 1.0]);
    let scenario = Scenario::parse(DISC).unwrap();
    let Robot::Disc(disc) = scenario.robot() else { panic!("a disc") };
    assert_eq!((disc.radius(), scenario.robot().dimension()), (0.1, 2));
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_optional_may_be_left_out() {
    for piece in [
        r#""title": "An arm","#,
        r#""bounds": {"min": [-3, -3], "max": [3, 3]},"#,
        r#", "radius": 0.05"#,
        r#", "joint_limits": [[-1, 1], [-2, 2]]"#,
    ] {
        Scenario::parse(&with(ARM, piece, "")).expect(piece);
    }
    let bare = with(ARM, r#", "radius": 0.05"#, "");
    let Robot::Arm(arm) = Scenario::parse(&bare).unwrap().robot().clone() else { panic!("an arm") };
    assert_eq!(arm.radius(), 0.0);
    assert_eq!(Scenario::parse(&with(ARM, r#""title": "An arm","#, "")).unwrap().title(), "arm");
    let empty = r#"{"format": "planarium-scenario-1", "name": "n", "world": {"obstacles": []},
        "robot": {"type": "arm", "base": [0, 0], "links": [1]}, "queries": []}"#;
    assert!(Scenario::parse(empty).unwrap().queries().is_empty());
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_required_must_be_there() {
    check_refusals(
        ARM,
        &[
            (r#""format": "planarium-scenario-1","#, "", "missing-field", "/format", "format"),
            (r#""name": "arm","#, "", "missing-field", "/name", "name"),
            (r#""min": [-3, -3], "#, "", "missing-field", "/world/bounds/min", "min"),
            (r#", "max": [3, 3]"#, "", "missing-field", "/world/bounds/max", "max"),
            (r#""type": "disc", "#, "", "missing-field", "/world/obstacles/0/type", "type"),
            (r#""center": [2, 0], "#, "", "missing-field", "/world/obstacles/0/center", "center"),
            (r#", "radius": 0.25"#, "", "missing-field", "/world/obstacles/0/radius", "radius"),
            (r#""type": "arm", "#, "", "missing-field", "/robot/type", "type"),
            (r#""base": [0, 0], "#, "", "missing-field", "/robot/base", "base"),
            (r#""links": [1, 0.5], "#, "", "missing-field", "/robot/links", "links"),
            (r#""name": "first", "#, "", "missing-field", "/queries/0/name", "name"),
            (r#""start": [-1, 0], "#, "", "missing-field", "/queries/0/start", "start"),
            (r#", "goal": [1, 2]"#, "", "missing-field", "/queries/0/goal", "goal"),
        ],
    );
    check_refusals(
        DISC,
        &[
            (r#", "radius": 0.1"#, "", "missing-field", "/robot/radius", "radius"),
            (
                r#""bounds": {"min": [0, 0], "max": [2, 2]}, "#,
                "",
                "missing-field",
                "/world/bounds",
                "only an arm can do without",
            ),
        ],
    );
    let without = |from: &str, to: &str| {
        let (start, end) = (ARM.find(from).unwrap(), ARM.find(to).unwrap());
        refusal(&format!("{}{}", &ARM[..start], &ARM[end..])).pointer().to_owned()
    };
    assert_eq!(without(r#""world""#, r#""robot""#), "/world");
    assert_eq!(without(r#""robot""#, r#""queries""#), "/robot");
    let end = ARM.find(r#", "radius": 0.05"#).unwrap();
    let cut = format!("{}}}, \"queries\": []}}", &ARM[..end]);
    Scenario::parse(&cut).unwrap();
    assert_eq!(refusal(&with(&cut, r#", "queries": []"#, "")).pointer(), "/queries");
}

#[wasm_bindgen_test(unsupported = test)]
fn what_the_contract_does_not_know_is_refused() {
    check_refusals(
        ARM,
        &[
            ("planarium-scenario-1", "planarium-scenario-2", "unknown-format", "/format", "planarium-scenario-2"),
            (r#""format": "#, r#""seed": 1, "format": "#, "unknown-field", "/seed", "seed"),
            (r#""bounds""#, r#""bound""#, "unknown-field", "/world/bound", "bound"),
            (r#""min""#, r#""low": 0, "min""#, "unknown-field", "/world/bounds/low", "low"),
            (r#""center""#, r#""centre""#, "unknown-field", "/world/obstacles/0/centre", "centre"),
            (r#""vertices""#, r#""closed": true, "vertices""#, "unknown-field", "/world/obstacles/1/closed", "closed"),
            (r#""links""#, r#""a/b~c": 1, "links""#, "unknown-field", "/robot/a~1b~0c", "a/b~c"),
            (r#""start""#, r#""from""#, "unknown-field", "/queries/0/from", "known are name, start, goal"),
            (
                r#""start""#,
                r#""goal_tolerance": {"translation": 0.1, "rotation": 0.5}, "start""#,
                "unknown-field",
                "/queries/0/goal_tolerance",
                "an arm reaches its goal exactly",
            ),
            (r#""type": "disc""#, r#""type": "circle""#, "unknown-type", "/world/obstacles/0/type", "circle"),
            (r#""type": "arm""#, r#""type": "snake""#, "unknown-type", "/robot/type", "snake"),
            (r#""type": "arm""#, r#""type": "rigid_body""#, "unsupported", "/robot/type", "arms and discs"),
            (r#""type": "arm""#, r#""type": "car""#, "unsupported", "/robot/type", "arms and discs"),
        ],
    );
    check_refusals(
        DISC,
        &[(r#""radius": 0.1"#, r#""radius": 0.1, "base": [1, 1]"#, "unknown-field", "/robot/base", "base")],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn a_value_of_another_type_is_refused_and_named() {
    check_refusals(
        ARM,
        &[
            (r#""planarium-scenario-1""#, "1", "wrong-type", "/format", "the number 1"),
            (r#""name": "arm""#, r#""name": null"#, "wrong-type", "/name", "null"),
            (r#""title": "An arm""#, r#""title": null"#, "wrong-type", "/title", "null"),
            (r#"{"min": [-3, -3], "max": [3, 3]}"#, "[0, 1]", "wrong-type", "/world/bounds", "an array of 2"),
            (r#""min": [-3, -3]"#, r#""min": -3"#, "wrong-type", "/world/bounds/min", "the number -3"),
            ("[-3, -3]", r#"["-3", -3]"#, "wrong-type", "/world/bounds/min/0", r#"the string "-3""#),
            ("[2, 0]", "[2, true]", "wrong-type", "/world/obstacles/0/center/1", "true"),
            ("[[1, 1], [2, 1]", "[1, [2, 1]", "wrong-type", "/world/obstacles/1/vertices/0", "the number 1"),
            (r#""type": "arm""#, r#""type": {}"#, "wrong-type", "/robot/type", "an object"),
            ("[1, 0.5]", "1.5", "wrong-type", "/robot/links", "the number 1.5"),
            ("[1, 0.5]", "[1, null]", "wrong-type", "/robot/links/1", "null"),
            ("[[-1, 1], [-2, 2]]", "null", "wrong-type", "/robot/joint_limits", "null"),
            ("[[-1, 1], [-2, 2]]", "[-1, 1]", "wrong-type", "/robot/joint_limits/0", "the number -1"),
            (r#""first""#, "7", "wrong-type", "/queries/0/name", "the number 7"),
            (r#""start": [-1, 0]"#, r#""start": "home""#, "wrong-type", "/queries/0/start", r#"the string "home""#),
        ],
    );
    for (document, words) in [("[]", "an array of 0"), ("3", "the number 3"), (r#""text""#, "the string")] {
        let error = refusal(document);
        assert_eq!((error.code().as_str(), error.pointer()), ("wrong-type", ""));
        assert!(error.message().contains(words), "{error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_number_outside_its_range_is_refused() {
    let out = "out-of-range";
    check_refusals(
        ARM,
        &[
            (r#""name": "arm""#, r#""name": """#, out, "/name", "empty"),
            (r#""first""#, r#""""#, out, "/queries/0/name", "empty"),
            ("[3, 3]", "[3, -3]", out, "/world/bounds", "in y the bounds run from -3 to -3"),
            ("[3, 3]", "[-4, 3]", out, "/world/bounds", "in x the bounds run from -3 to -4"),
            ("[3, 3]", "[3, 1000000.1]", out, "/world/bounds/max/1", "1000000.1"),
            ("[2, 0]", "[-1e7, 0]", out, "/world/obstacles/0/center/0", "-10000000"),
            (r#""radius": 0.25"#, r#""radius": 0"#, out, "/world/obstacles/0/radius", "greater than 0"),
            (r#""radius": 0.25"#, r#""radius": -0.25"#, out, "/world/obstacles/0/radius", "-0.25"),
            ("[1.5, 1.25]", "[1.5, 2e6]", out, "/world/obstacles/1/vertices/3/1", "2000000"),
            (r#""base": [0, 0]"#, r#""base": [0, 1e300]"#, out, "/robot/base/1", "1000000"),
            ("[1, 0.5]", "[]", out, "/robot/links", "1 to 8 links, not 0"),
            ("[1, 0.5]", "[1, 1, 1, 1, 1, 1, 1, 1, 1]", out, "/robot/links", "1 to 8 links, not 9"),
            ("[1, 0.5]", "[1, 0]", out, "/robot/links/1", "greater than 0"),
            ("[1, 0.5]", "[1, -0.5]", out, "/robot/links/1", "-0.5"),
            (r#""radius": 0.05"#, r#""radius": -0.05"#, out, "/robot/radius", "-0.05"),
            ("[-2, 2]", "[2, 2]", out, "/robot/joint_limits/1", "less than"),
            ("[-2, 2]", "[3, 2]", out, "/robot/joint_limits/1", "the lower joint limit 3"),
            ("[-2, 2]", "[-2, 101]", out, "/robot/joint_limits/1/1", "101"),
            (r#""start": [-1, 0]"#, r#""start": [-1.5, 0]"#, out, "/queries/0/start/0", "joint 0"),
            // Limited joints do not wrap: 5.3 is -0.98 one turn on, but is not within [-1, 1].
            (r#""goal": [1, 2]"#, r#""goal": [5.3, 2]"#, out, "/queries/0/goal/0", "5.3"),
        ],
    );
    check_refusals(
        DISC,
        &[
            (r#""radius": 0.1"#, r#""radius": -1"#, out, "/robot/radius", "-1"),
            ("[1.8, 1.8]", "[1.8, 1e6001]", "invalid-json", "/queries/0/goal/1", "1e6001"),
            ("[1.8, 1.8]", "[1.8, 1e7]", out, "/queries/0/goal/1", "10000000"),
        ],
    );
    let free = with(ARM, r#", "joint_limits": [[-1, 1], [-2, 2]]"#, "");
    check_refusals(&free, &[("[-1, 0]", "[-1, 1000001]", out, "/queries/0/start/1", "1000001")]);
    Scenario::parse(&with(&free, "[-1, 0]", "[100, -1e6]")).expect("a circle joint takes any number of turns");
}

#[wasm_bindgen_test(unsupported = test)]
fn a_list_of_another_length_is_refused() {
    let wrong = "wrong-dimension";
    check_refusals(
        ARM,
        &[
            ("[-3, -3]", "[-3]", wrong, "/world/bounds/min", "2 entries, not 1"),
            ("[2, 0]", "[2, 0, 0]", wrong, "/world/obstacles/0/center", "2 entries, not 3"),
            ("[1.5, 1.25]", "[]", wrong, "/world/obstacles/1/vertices/3", "2 entries, not 0"),
            ("[[-1, 1], [-2, 2]]", "[[-1, 1]]", wrong, "/robot/joint_limits", "2, not 1"),
            ("[-2, 2]", "[2]", wrong, "/robot/joint_limits/1", "2 entries, not 1"),
            (r#""start": [-1, 0]"#, r#""start": [-1]"#, wrong, "/queries/0/start", "2 entries, not 1"),
            (r#""goal": [1, 2]"#, r#""goal": [1, 2, 3]"#, wrong, "/queries/0/goal", "2 entries, not 3"),
        ],
    );
}

#[wasm_bindgen_test(unsupported = test)]
fn two_queries_do_not_share_a_name() {
    check_refusals(ARM, &[(r#""second""#, r#""first""#, "duplicate-name", "/queries/1/name", r#""first""#)]);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_polygon_that_is_none_is_refused() {
    let at = "/world/obstacles/1/vertices";
    let polygon = "[[1, 1], [2, 1], [2, 2], [1.5, 1.25], [1, 2]]";
    let bad = "degenerate-polygon";
    check_refusals(
        ARM,
        &[
            (polygon, "[]", bad, at, "three distinct"),
            (polygon, "[[1, 1], [2, 1]]", bad, at, "three distinct"),
            (polygon, "[[1, 1], [2, 1], [2, 1], [1, 1]]", bad, at, "three distinct"),
            (polygon, "[[1, 1], [2, 1], [3, 1]]", bad, at, "on one line"),
            (polygon, "[[1, 1], [2, 2], [2, 1], [1, 2]]", bad, at, "from vertex 0 and from vertex 2"),
            (polygon, "[[1, 1], [2, 1], [3, 1], [2, 1], [1, 2]]", bad, at, "touch or cross"),
        ],
    );
    // In either direction, open or closed, the polygon is the same.
    let reference = Scenario::parse(ARM).unwrap();
    for same in [
        "[[1, 1], [2, 1], [2, 2], [1.5, 1.25], [1, 2], [1, 1]]",
        "[[1, 1], [1, 1], [2, 1], [2, 2], [1.5, 1.25], [1, 2]]",
    ] {
        assert_eq!(Scenario::parse(&with(ARM, polygon, same)).unwrap(), reference);
    }
    let reversed = Scenario::parse(&with(ARM, polygon, "[[1, 2], [1.5, 1.25], [2, 2], [2, 1], [1, 1]]")).unwrap();
    assert_eq!(reversed, reference);
}

#[wasm_bindgen_test(unsupported = test)]
fn nothing_may_touch_the_base_of_an_arm() {
    let arm = |base: &str, radius: &str, obstacle: &str, bounds: &str| {
        format!(
            r#"{{"format": "{FORMAT}", "name": "n", "world": {{{bounds} "obstacles": [
            {{"type": "disc", "center": [50, 50], "radius": 1}}, {obstacle}]}},
            "robot": {{"type": "arm", "base": {base}, "links": [1], "radius": {radius}}}, "queries": []}}"#
        )
    };
    let disc = r#"{"type": "disc", "center": [2, 0], "radius": 1}"#;
    let square = r#"{"type": "polygon", "vertices": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}"#;
    let bounds = r#""bounds": {"min": [-3, -3], "max": [60, 60]},"#;
    for (base, radius, obstacle) in [
        ("[2, 0.5]", "0", disc),
        ("[1, 0]", "0", disc),
        ("[0, 0]", "1", disc),
        ("[0.9999999999999, 0]", "0", disc),
        ("[0, 0]", "0", square),
        ("[1, 0.5]", "0", square),
        ("[1.25, 0.5]", "0.25", square),
        ("[1, 1]", "0", square),
    ] {
        let error = refusal(&arm(base, radius, obstacle, ""));
        assert_eq!((error.code().as_str(), error.pointer()), ("base-in-collision", "/world/obstacles/1"), "{error}");
        assert!(error.message().contains("obstacle 1"), "{error}");
    }
    for (base, radius, obstacle) in
        [("[0, 0]", "0.999999", disc), ("[1.250001, 0.5]", "0.25", square), ("[1, 1.000001]", "0", square)]
    {
        Scenario::parse(&arm(base, radius, obstacle, bounds)).expect(base);
    }
    // The bounds may be touched, but not crossed.
    Scenario::parse(&arm("[-2.75, 5]", "0.25", disc, bounds)).expect("the base touches the bounds");
    for (base, radius) in [("[-4, 5]", "0"), ("[-2.75, 5]", "0.2500001"), ("[5, 60.1]", "0")] {
        let error = refusal(&arm(base, radius, disc, bounds));
        assert_eq!((error.code().as_str(), error.pointer()), ("base-in-collision", "/robot/base"), "{error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_start_or_goal_in_collision_is_left_to_the_planner() {
    Scenario::parse(&with(DISC, "[0.2, 0.2]", "[1, 1]")).expect("the start lies in the obstacle");
    Scenario::parse(&with(DISC, "[0.2, 0.2]", "[-5, 1]")).expect("the start lies outside the bounds");
}

#[wasm_bindgen_test(unsupported = test)]
fn too_many_obstacles_or_vertices_are_refused() {
    let world = |obstacles: String| {
        let disc = r#"{"type": "disc", "center": [1, 1], "radius": 0.5}"#;
        with(DISC, disc, &obstacles)
    };
    let discs = |n: usize| vec![r#"{"type":"disc","center":[1,1],"radius":0.5}"#; n].join(",");
    assert_eq!(Scenario::parse(&world(discs(MAX_OBSTACLES))).unwrap().world().obstacles.len(), MAX_OBSTACLES);
    let error = refusal(&world(discs(MAX_OBSTACLES + 1)));
    assert_eq!((error.code().as_str(), error.pointer()), ("too-large", "/world/obstacles"), "{error}");
    assert!(error.message().contains("10001"));

    // A comb of so many vertices, at most a millionth apart.
    let comb = |n: usize| {
        let corner = |i: usize| format!("[{},{}]", i as f64 * 1e-6, 1 + i % 2);
        let corners: Vec<String> = (0..n - 2).map(corner).chain(["[1,3]".to_owned(), "[0,3]".to_owned()]).collect();
        format!(r#"{{"type":"polygon","vertices":[{}]}}"#, corners.join(","))
    };
    let half = MAX_VERTICES / 2;
    Scenario::parse(&world(format!("{},{}", comb(half), comb(half)))).expect("as many vertices as allowed");
    let error = refusal(&world(format!("{},{}", comb(half), comb(half + 1))));
    assert_eq!((error.code().as_str(), error.pointer()), ("too-large", "/world/obstacles/1/vertices"), "{error}");
}

#[wasm_bindgen_test(unsupported = test)]
fn text_that_is_not_json_is_refused_with_line_and_column() {
    for (text, pointer, words) in [
        ("", "", "line 1 column 0"),
        ("{", "", "line 1 column 1"),
        ("{} {}", "", "line 1 column 4"),
        ("{\n  \"name\": nope}", "/name", "line 2 column"),
        (r#"{"world": {"obstacles": [{"a": 1 "b": 2}]}}"#, "/world/obstacles/0", "line 1 column 34"),
        (r#"{"x": NaN}"#, "/x", "expected value"),
        (r#"{"x": [1, Infinity]}"#, "/x/1", "expected value"),
        (r#"{"x": [1, -Infinity]}"#, "/x/1", "invalid number"),
        (r#"{"x": 0x10}"#, "", "line 1 column 8"),
        (r#"{"x": 01}"#, "/x", "invalid number"),
        (r#"{"x": [1,]}"#, "/x", "trailing comma"),
        (r#"{"x": 1e999}"#, "/x", "1e999: number out of range at line 1"),
        (r#"{"a": [0, {"b/c": -2.5E+400}]}"#, "/a/1/b~1c", "-2.5E+400: number out of range"),
        (r#"{"x": "\ud800"}"#, "/x", "hex escape"),
        ("\u{feff}{}", "", "line 1 column"),
    ] {
        let error = refusal(text);
        assert_eq!((error.code().as_str(), error.pointer()), ("invalid-json", pointer), "{text}: {error}");
        assert!(error.message().contains(words), "{text}: {words:?} is not in {error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_field_that_stands_twice_is_refused() {
    for (text, pointer) in [
        (r#"{"name": 1, "name": 1}"#, "/name"),
        (r#"{"world": {"obstacles": [{}, {"a~b": 1, "c": 2, "a~b": 3}]}}"#, "/world/obstacles/1/a~0b"),
        (r#"{"a": 1, "\u0061": {"b": [}}"#, "/a"),
    ] {
        let error = refusal(text);
        assert_eq!((error.code().as_str(), error.pointer()), ("duplicate-field", pointer), "{error}");
        assert!(error.message().contains("twice") && error.message().contains("line 1"), "{error}");
    }
    let Node::Object(mut fields) = Node::parse(DISC).unwrap() else { panic!("an object") };
    fields.push(fields[1].clone());
    let error = Scenario::from_node(&Node::Object(fields)).unwrap_err();
    assert_eq!((error.code().as_str(), error.pointer()), ("duplicate-field", "/name"));
}

#[wasm_bindgen_test(unsupported = test)]
fn deep_and_long_texts_are_refused_without_harm() {
    for deep in ["[".repeat(100_000), "{\"a\":".repeat(100_000), "[{\"a\":".repeat(50_000)] {
        let error = refusal(&deep);
        assert_eq!(error.code().as_str(), "invalid-json");
        assert!(error.message().contains("recursion limit"), "{error}");
    }
    let error = refusal(&" ".repeat(planarium::scenario::MAX_TEXT + 1));
    assert_eq!((error.code().as_str(), error.pointer()), ("too-large", ""));
    let name = "n".repeat(100_000);
    assert!(refusal(&with(DISC, r#""title""#, &format!("{name:?}"))).message().len() < 300);
}

#[wasm_bindgen_test(unsupported = test)]
fn a_tree_that_was_not_text_is_held_to_the_same_rules() {
    fn replace(node: &mut Node, path: &[&str], value: Node) {
        let Some((first, rest)) = path.split_first() else {
            *node = value;
            return;
        };
        match node {
            Node::Array(items) => replace(&mut items[first.parse::<usize>().unwrap()], rest, value),
            Node::Object(fields) => {
                let field = fields.iter_mut().find(|(name, _)| name == first).expect("the field is there");
                replace(&mut field.1, rest, value);
            }
            _ => panic!("{first} is not there"),
        }
    }
    let document = Node::parse(ARM).unwrap();
    assert_eq!(Scenario::from_node(&document), Scenario::parse(ARM));
    for path in [
        "world/bounds/min/0",
        "world/obstacles/0/radius",
        "world/obstacles/1/vertices/2/1",
        "robot/base/1",
        "robot/links/0",
        "robot/radius",
        "robot/joint_limits/1/0",
        "queries/1/goal/1",
    ] {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut changed = document.clone();
            replace(&mut changed, &path.split('/').collect::<Vec<_>>(), Node::Number(value));
            let error = Scenario::from_node(&changed).unwrap_err();
            assert_eq!((error.code().as_str(), error.pointer()), ("not-finite", format!("/{path}").as_str()));
            assert!(error.message().contains(&value.to_string()), "{error}");
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_source_that_is_not_text_is_read_with_the_same_care() {
    use serde::de::value::{Error as Fault, MapDeserializer, SeqDeserializer};
    use serde::de::{Deserializer, IntoDeserializer, Visitor};
    // Endless nesting, as a cycle in JavaScript is.
    struct Cycle;
    impl<'de> Deserializer<'de> for Cycle {
        type Error = Fault;
        fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
            visitor.visit_seq(SeqDeserializer::new(std::iter::once(Cycle)))
        }
        serde::forward_to_deserialize_any! {
            bool i8 i16 i32 i64 u8 u16 u32 u64 f32 f64 char str string bytes byte_buf option unit unit_struct
            newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
        }
    }
    impl<'de> IntoDeserializer<'de, Fault> for Cycle {
        type Deserializer = Self;
        fn into_deserializer(self) -> Self {
            self
        }
    }
    let error = Node::read(Cycle).unwrap_err();
    assert_eq!(error.code().as_str(), "invalid-json");
    assert!(error.message().contains("nested deeper than 128") && error.pointer().starts_with("/0/0/0"), "{error}");
    let bytes = serde::de::value::BytesDeserializer::<Fault>::new(b"bytes");
    assert_eq!(Node::read(bytes).unwrap_err().code().as_str(), "invalid-json");
    let map = MapDeserializer::<_, Fault>::new([("x", f64::NAN), ("y", 2.0)].into_iter());
    let Node::Object(fields) = Node::read(map).unwrap() else { panic!("an object") };
    assert!(matches!(&fields[..], [(_, Node::Number(x)), (_, Node::Number(2.0))] if x.is_nan()));
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_are_read_to_the_last_bit() {
    let mut texts: Vec<String> = [
        "0.1",
        "1e23",
        "9007199254740993",
        "18446744073709551616",
        "123456789012345678901234567890",
        "4.9e-324",
        "2e-324",
        "2.2250738585072011e-308",
        "1.7976931348623157e308",
        "0.30000000000000004",
        "-0.0",
        "1E5",
        "5e-5",
        "179769313486231580793728971405301e276",
        "1.00000000000000011102230246251565404236316680908203125",
    ]
    .map(str::to_owned)
    .to_vec();
    let mut random = planarium::random::Random::new(1, planarium::random::Stream::Samples);
    for _ in 0..5000 {
        let number = f64::from_bits(random.bits());
        if number.is_finite() {
            texts.push(format!("{number:e}"));
            texts.push(format!("{:.3e}", random.uniform()));
        }
    }
    for text in texts {
        let expected: f64 = text.parse().unwrap();
        let Ok(Node::Number(found)) = Node::parse(&text) else { panic!("{text} is a number") };
        assert_eq!(found.to_bits(), expected.to_bits(), "{text}");
        let written = serde_json::to_string(&Node::Number(found)).unwrap();
        assert_eq!(Node::parse(&written), Ok(Node::Number(found)), "{text} is written {written}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn a_written_scenario_reads_back_as_the_same() {
    for document in [ARM, DISC, &with(ARM, r#""title": "An arm","#, "")] {
        let scenario = Scenario::parse(document).unwrap();
        let text = scenario.to_json_string();
        let again = Scenario::parse(&text).unwrap();
        assert_eq!(again, scenario);
        assert_eq!(again.to_json_string(), text);
        assert_eq!(Scenario::from_node(&scenario.to_node()), Ok(scenario.clone()));
        assert_eq!(Scenario::parse(&scenario.to_json().to_string()), Ok(scenario));
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn the_written_form_is_the_contract_in_order_with_defaults_and_without_repeats() {
    let given = r#"{"queries": [{"goal": [0.30000000000000004], "start": [-0.0], "name": "q\u0041/\""}],
        "robot": {"links": [1.0], "base": [0.0, 1e-7], "type": "arm"},
        "world": {"obstacles": [{"vertices": [[2, 2], [2, 3], [3, 2], [2, 2]], "type": "polygon"},
                                {"radius": 0.5, "center": [-5, 1e6], "type": "disc"}]},
        "name": "n", "format": "planarium-scenario-1"}"#;
    let expected = concat!(
        r#"{"format":"planarium-scenario-1","name":"n","world":{"obstacles":["#,
        r#"{"type":"polygon","vertices":[[3,2],[2,3],[2,2]]},{"type":"disc","center":[-5,1000000],"radius":0.5}]},"#,
        r#""robot":{"type":"arm","base":[0,1e-7],"links":[1],"radius":0},"#,
        r#""queries":[{"name":"qA/\"","start":[0],"goal":[0.30000000000000004]}]}"#
    );
    assert_eq!(Scenario::parse(given).unwrap().to_json_string(), expected);
}

#[wasm_bindgen_test(unsupported = test)]
fn the_limits_are_those_of_the_contract() {
    assert_eq!((MAX_OBSTACLES, MAX_VERTICES, LARGEST), (10_000, 100_000, 1e6));
    let edge = with(DISC, r#"[1, 1], "radius": 0.5"#, r#"[-1e6, 1e6], "radius": 1e6"#);
    assert!(matches!(Scenario::parse(&edge).unwrap().world().obstacles[0], Obstacle::Disc(disc) if disc.radius == 1e6));
}

#[cfg(not(target_arch = "wasm32"))]
mod native {
    use super::*;
    use proptest::prelude::*;

    /// The scenarios of `PLANARIUM_SCENARIOS`, by name, where it is set.
    fn shared() -> Vec<(String, String)> {
        let Some(folder) = std::env::var_os("PLANARIUM_SCENARIOS") else {
            println!("PLANARIUM_SCENARIOS is not set: the shared scenarios are not looked at");
            eprintln!("PLANARIUM_SCENARIOS is not set: the shared scenarios are not looked at");
            return Vec::new();
        };
        let files = std::fs::read_dir(folder).expect("PLANARIUM_SCENARIOS names a folder");
        let mut found = Vec::new();
        for path in files.map(|file| file.unwrap().path()).filter(|path| path.extension().is_some_and(|e| e == "json"))
        {
            let text = std::fs::read_to_string(&path).unwrap();
            if text.contains(FORMAT) {
                found.push((path.file_stem().unwrap().to_string_lossy().into_owned(), text));
            }
        }
        assert!(found.len() >= 9, "there are shared scenarios");
        found
    }

    #[test]
    fn the_shared_scenarios_are_read_but_for_bodies_and_cars() {
        for (name, text) in shared() {
            match Scenario::parse(&text) {
                Ok(scenario) => {
                    assert_eq!(scenario.name(), name);
                    assert!(!scenario.queries().is_empty());
                    assert_eq!(Scenario::parse(&scenario.to_json_string()), Ok(scenario));
                }
                Err(error) => {
                    assert!(name.starts_with("rigid-") || name.starts_with("car-"), "{name}: {error}");
                    assert_eq!((error.code().as_str(), error.pointer()), ("unsupported", "/robot/type"));
                }
            }
        }
    }

    /// Any JSON value, most often a small one.
    fn any_node() -> impl Strategy<Value = Node> {
        let leaf = prop_oneof![
            Just(Node::Null),
            any::<bool>().prop_map(Node::Bool),
            any::<f64>().prop_map(Node::Number),
            (-4i8..5).prop_map(|n| Node::Number(n.into())),
            prop_oneof![Just("disc"), Just("polygon"), Just("arm"), Just("")].prop_map(|s| Node::String(s.to_owned())),
        ];
        leaf.prop_recursive(3, 12, 4, |inner| {
            let name = prop_oneof![Just("type"), Just("radius"), Just("min"), Just("name"), Just("start")];
            let fields = prop::collection::vec((name.prop_map(str::to_owned), inner.clone()), 0..4);
            prop_oneof![prop::collection::vec(inner, 0..4).prop_map(Node::Array), fields.prop_map(Node::Object)]
        })
    }

    /// Puts `value` in the place of the `at`-th value of the tree, counted depth first; or leaves it out, or doubles it.
    fn mutate(node: &mut Node, at: &mut usize, value: &Node, how: u8) {
        if *at == 0 {
            *node = value.clone();
        }
        *at = at.wrapping_sub(1);
        match node {
            Node::Array(items) => {
                if *at < items.len() && how == 1 {
                    items.remove(*at);
                }
                if *at < items.len() && how == 2 {
                    items.push(items[*at].clone());
                }
                items.iter_mut().for_each(|item| mutate(item, at, value, how));
            }
            Node::Object(fields) => {
                if *at < fields.len() && how == 1 {
                    fields.remove(*at);
                }
                fields.iter_mut().for_each(|(_, item)| mutate(item, at, value, how));
            }
            _ => {}
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_change_to_a_document_makes_the_parser_panic(at in 0usize..70, value in any_node(), how in 0u8..3) {
            for document in [ARM, DISC] {
                let mut node = Node::parse(document).unwrap();
                mutate(&mut node, &mut at.clone(), &value, how);
                match Scenario::from_node(&node) {
                    Ok(scenario) => prop_assert_eq!(Scenario::parse(&scenario.to_json_string()), Ok(scenario)),
                    Err(error) => prop_assert!(error.pointer().is_empty() || error.pointer().starts_with('/')),
                }
            }
        }

        #[test]
        fn no_text_makes_the_parser_panic(cut in 0usize..600, insert in "[\\[\\]{}:,\"\\\\0-9eE.+\\-a-z\u{e9}\u{1F600} ]{0,6}") {
            let cut = (0..=cut.min(ARM.len())).rev().find(|&i| ARM.is_char_boundary(i)).unwrap();
            let _ = Scenario::parse(&format!("{}{insert}{}", &ARM[..cut], &ARM[cut..]));
            let _ = Scenario::parse(&format!("{}{insert}", &ARM[..cut]));
            let _ = Node::parse(&insert);
        }
    }
}

#[cfg(target_arch = "wasm32")]
mod javascript {
    use super::*;

    fn read(expression: &str) -> Result<Node, Error> {
        let value = js_sys::eval(&format!("({expression})")).expect("the expression is JavaScript");
        Node::read(serde_wasm_bindgen::Deserializer::from(value))
    }

    #[wasm_bindgen_test]
    fn an_object_is_read_as_its_text_is() {
        for document in [ARM, DISC] {
            assert_eq!(read(document), Node::parse(document));
        }
        assert_eq!(
            read("[0.1, -0, 2**53, 5e-324, 1e300, 7n, 'x']"),
            Node::parse("[0.1, -0.0, 9007199254740992, 5e-324, 1e300, 7, \"x\"]")
        );
    }

    #[wasm_bindgen_test]
    fn what_is_not_json_is_refused_where_it_stands() {
        for (expression, pointer) in [
            ("{a: [0, () => 1]}", "/a/1"),
            ("{a: {b: new Set()}}", "/a/b"),
            ("{a: Symbol('s')}", "/a"),
            ("{a: 2n ** 70n}", "/a"),
            ("[new Float64Array(2)]", "/0"),
            ("new Map([[1, 2]])", ""),
        ] {
            let error = read(expression).unwrap_err();
            assert_eq!((error.code().as_str(), error.pointer()), ("invalid-json", pointer), "{expression}: {error}");
        }
        let error = read("(() => { const a = []; a.push(a); return a; })()").unwrap_err();
        assert!(error.message().contains("nested deeper"), "{error}");
    }

    #[wasm_bindgen_test]
    fn numbers_that_are_not_finite_are_refused_where_they_stand() {
        for (written, value) in [("NaN", "NaN"), ("Infinity", "inf"), ("-1 / 0", "-inf")] {
            let node = read(&with(ARM, "[1, 0.5]", &format!("[1, {written}]"))).unwrap();
            let error = Scenario::from_node(&node).unwrap_err();
            assert_eq!((error.code().as_str(), error.pointer()), ("not-finite", "/robot/links/1"));
            assert!(error.message().contains(value), "{error}");
        }
    }
}
