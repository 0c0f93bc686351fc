//! JSON text and trees: what is refused, with which code and where, whatever the document is about; numbers to the
//! last bit.

#[path = "common/documents.rs"]
mod documents;

use documents::{ARM, DISC, refusal, with};
use planarium::scenario::{MAX_DEPTH, MAX_TEXT, Node, Scenario};
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

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
    let error = refusal(&" ".repeat(MAX_TEXT + 1));
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
        let written = Node::Number(found).to_json();
        // Others write no shorter.
        assert!(written.len() <= serde_json::to_string(&found).unwrap().len(), "{written}");
        assert_eq!(Node::parse(&written), Ok(Node::Number(found)), "{text} is written {written}");
    }
}

/// A value of any kind, as another reader and writer of JSON sees it.
fn other(node: &Node) -> Value {
    match node {
        Node::Null => Value::Null,
        Node::Bool(value) => json!(value),
        Node::Number(value) => json!(value),
        Node::String(value) => json!(value),
        Node::Array(items) => items.iter().map(other).collect(),
        Node::Object(fields) => {
            Value::Object(fields.iter().map(|(name, value)| (name.clone(), other(value))).collect())
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn strings_are_read_and_written_as_others_do() {
    for text in [
        r#""""#,
        r#""plain""#,
        r#""\"\\\/\b\f\n\r\t""#,
        r#""\u0041\u00e9\u20ac\uD83D\uDE00\u0000\u001f\u007f""#,
        "\"\u{e9}\u{20ac}\u{1f600}\u{7f}\"",
        r#"{"":{"a\nb":[1,-2.5,1e-7,1e21,true,false,null,"x"],"\u00e9":{}},"b":[[],[[]]]}"#,
        " [ 1 , 2 ] \n",
        "\t{ \"a\" : 1\r\n}",
    ] {
        let node = Node::parse(text).expect(text);
        let value: Value = serde_json::from_str(text).expect(text);
        let doubles = |value: &Value| other(&Node::parse(&value.to_string()).expect("JSON"));
        assert_eq!(other(&node), doubles(&value), "{text}");
        let again: Value = serde_json::from_str(&node.to_json()).expect("what is written is JSON");
        assert_eq!(doubles(&again), other(&node), "{text}");
        assert_eq!(Node::parse(&node.to_json()), Ok(node), "{text}");
    }
    let marks = "a\"\\/\u{7}\u{8}\u{c}\n\r\t\u{e9}";
    assert_eq!(Node::text(marks).to_json(), json!(marks).to_string());
    for bad in [
        r#""\x""#,
        r#""\u12g4""#,
        r#""\u12"#,
        r#""\ud800x""#,
        r#""\udc00""#,
        r#""\ud800\u0041""#,
        "\"a\nb\"",
        "\"open",
        "\"\\",
        "{a:1}",
        "{\"a\"}",
        "{\"a\" 1}",
        "[1 2]",
        "[",
        "[1",
        "[1,",
        "{\"a\":1,}",
        "{,}",
        "[,]",
        "-",
        "1.",
        ".5",
        "1e",
        "1e+",
        "+1",
        "--1",
        "tru",
        "nulll",
        "truefalse",
        "1,2",
        "'a'",
        "\u{a0}1",
    ] {
        assert!(serde_json::from_str::<Value>(bad).is_err(), "{bad}");
        let error = Node::parse(bad).expect_err(bad);
        assert_eq!(error.code().as_str(), "invalid-json", "{bad}");
        assert!(error.message().contains(" at line "), "{error}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn texts_cut_or_changed_anywhere_are_judged_as_others_judge_them() {
    for document in [ARM, DISC] {
        let text = Node::parse(document).expect("a document").to_json();
        for cut in (0..text.len()).filter(|&cut| text.is_char_boundary(cut)) {
            let (before, after) = text.split_at(cut);
            let mut texts = vec![before.to_owned()];
            let pieces = ["\"", ",", "}", "]", "{", "0", "e", "\\", " ", "-"];
            texts.extend(pieces.map(|piece| format!("{before}{piece}{after}")));
            for text in texts {
                let (ours, theirs) = (Node::parse(&text), serde_json::from_str::<Value>(&text));
                // They let a field stand twice.
                let is_twice = ours.as_ref().is_err_and(|error| error.code().as_str() == "duplicate-field");
                assert!(is_twice || ours.is_ok() == theirs.is_ok(), "{text}: {ours:?}, {theirs:?}");
            }
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn of_many_fields_the_one_that_stands_twice_is_found() {
    for count in [1, 2, 3, 7, 64, 1000] {
        let fields: Vec<String> = (0..count).map(|i| format!("\"f{}\":{i}", i * 7919 % 1009)).collect();
        let whole = fields.join(",");
        assert!(Node::parse(&format!("{{{whole}}}")).is_ok(), "{count} fields");
        for twice in [0, count / 2, count - 1] {
            let error = refusal(&format!("{{{whole},{}}}", fields[twice]));
            let pointer = format!("/f{}", twice * 7919 % 1009);
            assert_eq!((error.code().as_str(), error.pointer()), ("duplicate-field", pointer.as_str()));
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn nesting_is_read_to_its_bound() {
    let nested = |depth: usize| format!("{}{}", "[".repeat(depth), "]".repeat(depth));
    let most = MAX_DEPTH as usize;
    assert!(Node::parse(&nested(most - 1)).is_ok() && serde_json::from_str::<Value>(&nested(most - 1)).is_ok());
    let error = refusal(&nested(most));
    assert!(error.message().contains("recursion limit") && error.pointer() == "/0".repeat(most - 1), "{error}");
}
