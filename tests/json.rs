//! JSON text and other sources: what is refused, with which code and where, whatever the document is about; numbers to the
//! last bit.

#[path = "common/documents.rs"]
mod documents;

use documents::{ARM, DISC, refusal, with};
use planarium::scenario::{MAX_TEXT, Node, Scenario};
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

#[cfg(target_arch = "wasm32")]
mod javascript {
    use super::*;

    fn read(expression: &str) -> Result<Node, planarium::Error> {
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
