//! JSON text: what is refused beside the cases of `refusals.json`; numbers to the last bit; one normal form.

use crate::common::documents::{DISC, refusal, with};
use planarium::error::Code;
use planarium::json;
use planarium::scenario::{MAX_DEPTH, MAX_TEXT, Scenario};
use serde::de::{Deserialize, Deserializer, Error as _, SeqAccess, Visitor};
use serde_json::{Value, json};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test(unsupported = test)]
fn a_duplicate_field_is_refused_among_any_number_of_fields() {
    for count in [1, 2, 3, 7, 64, 1000] {
        let fields: Vec<String> = (0..count).map(|i| format!("\"f{}\":{i}", i * 7919 % 1009)).collect();
        let whole = fields.join(",");
        assert!(json::parse(&format!("{{{whole}}}")).is_ok(), "{count} fields");
        for twice in [0, count / 2, count - 1] {
            let pointer = format!("/f{}", twice * 7919 % 1009);
            refusal(&format!("{{{whole},{}}}", fields[twice]), "duplicate-field", &pointer);
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn one_byte_order_mark_is_skipped_before_a_text_alone() {
    assert_eq!(Scenario::parse(&format!("\u{feff}{DISC}")), Scenario::parse(DISC));
    for wrong in ["\u{feff}", "\u{feff}\u{feff}{}", "{}\u{feff}", "[\u{feff}1]"] {
        refusal(wrong, "invalid-json", if wrong.starts_with('[') { "/0" } else { "" });
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn deep_and_long_texts_are_refused_without_harm() {
    for deep in ["[".repeat(100_000), "{\"a\":".repeat(100_000), "[{\"a\":".repeat(50_000)] {
        let error = Scenario::parse(&deep).expect_err("too deep");
        assert!(error.code().as_str() == "invalid-json" && error.message().contains("recursion limit"), "{error}");
    }
    let nested = |depth: usize| format!("{}{}", "[".repeat(depth), "]".repeat(depth));
    let most = MAX_DEPTH as usize;
    assert!(json::parse(&nested(most - 1)).is_ok());
    let message = refusal(&nested(most), "invalid-json", &"/0".repeat(most - 1));
    assert!(message.contains("recursion limit"), "{message}");
    refusal(&" ".repeat(MAX_TEXT + 1), "too-large", "");
    let name = "n".repeat(100_000);
    let error = Scenario::parse(&with(DISC, r#""title""#, &format!("{name:?}"))).expect_err("an unknown field");
    assert!(error.message().len() < 300);
}

#[wasm_bindgen_test(unsupported = test)]
fn numbers_are_read_and_written_to_the_last_bit() {
    let special = "0.1 1e23 9007199254740993 18446744073709551616 123456789012345678901234567890 4.9e-324 2e-324 \
        2.2250738585072011e-308 1.7976931348623157e308 0.30000000000000004 -0.0 1E5 5e-5 \
        179769313486231580793728971405301e276 1.00000000000000011102230246251565404236316680908203125";
    let mut texts: Vec<String> = special.split_whitespace().map(str::to_owned).collect();
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
        let found = json::parse(&text).expect(&text).as_f64().expect("a number");
        assert_eq!(found.to_bits(), expected.to_bits(), "{text}");
        let written = json::to_string(&found);
        assert!(written.len() <= serde_json::to_string(&found).unwrap().len(), "{written}");
        let again = json::parse(&written).expect(&written).as_f64().expect("a number");
        assert_eq!(again.to_bits(), expected.to_bits(), "{text} is written {written}");
        // A type reads -0 as 0.
        let typed: f64 = json::read(&json::parse(&text).expect(&text)).expect("a number");
        assert_eq!(typed.to_bits(), (expected + 0.0).to_bits(), "{text}");
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn whole_numbers_are_written_without_a_fraction() {
    let exact = (1u64 << 53) as f64;
    let numbers = [0.0, -0.0, 2.0, -3.0, 1e6, exact - 1.0, exact, 1e16, 0.5, 1e-4, 1e-5, f64::NAN, f64::INFINITY];
    let expected = "[0,-0.0,2,-3,1000000,9007199254740991,9007199254740992.0,1e+16,0.5,0.0001,0.00001,null,null]";
    assert_eq!(json::to_string(&numbers), expected);
    assert_eq!(json::to_string(&json!({ "b": [1.0, "a\n"], "a": null })), r#"{"a":null,"b":[1,"a\n"]}"#);
}

#[wasm_bindgen_test(unsupported = test)]
fn whole_numbers_are_integers_however_they_are_written() {
    for (text, expected) in
        [("2", Some(2)), ("2.0", Some(2)), ("2e0", Some(2)), ("-0", Some(0)), ("2.5", None), ("-1", None)]
    {
        let found = json::read::<u32>(&json::parse(text).unwrap());
        assert_eq!(found.as_ref().ok(), expected.as_ref(), "{text}");
        assert!(found.is_ok() || found.unwrap_err().code().as_str() == "out-of-range", "{text}");
    }
    for text in ["4294967296", "1e300", "9007199254740992"] {
        assert_eq!(json::read::<u32>(&json::parse(text).unwrap()).unwrap_err().code().as_str(), "out-of-range");
    }
    assert_eq!(json::read::<u32>(&json!("2")).unwrap_err().code().as_str(), "wrong-type");
}

#[wasm_bindgen_test(unsupported = test)]
fn strings_arrays_and_objects_are_read_and_other_text_is_refused() {
    for text in [
        r#""\"\\\/\b\f\n\r\t""#,
        r#""\u0041\u00e9\u20ac\uD83D\uDE00\u0000\u001f\u007f""#,
        r#"{"":{"a\nb":[1,-2.5,1e-7,1e21,true,false,null,"x"],"\u00e9":{}},"b":[[],[[]]]}"#,
        " [ 1 , 2 ] \n",
    ] {
        let value: Value = serde_json::from_str(text).expect(text);
        assert_eq!(json::parse(text).expect(text), value, "{text}");
        let again = json::parse(&json::to_string(&value)).expect("what is written is JSON");
        assert_eq!(json::to_string(&again), json::to_string(&value), "{text}");
    }
    let words = ["{a:1}", "[1 2]", "[1,", "{,}", "1.", "+1", "nulll"];
    for bad in [r#""\x""#, r#""\u12g4""#, r#""\udc00""#, "\"a\nb\"", "\"open"].into_iter().chain(words) {
        let error = json::parse(bad).expect_err(bad);
        assert_eq!(error.code().as_str(), "invalid-json", "{bad}");
        assert!(error.message().contains(" at line "), "{error}");
    }
}

/// A type that asks for a number, an integer, two numbers and so on, and tells in misleading words what it expects.
struct Misleading<const ASKED: usize>;

impl<'de, const ASKED: usize> Deserialize<'de> for Misleading<ASKED> {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        struct Words<const ASKED: usize>;
        impl<'de, const ASKED: usize> Visitor<'de> for Words<ASKED> {
            type Value = Misleading<ASKED>;

            fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                f.write_str("usize, a map, struct or sequence of 7 known options: number out of range, is not finite")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Self::Value, A::Error> {
                while items.next_element::<f64>()?.is_some() {}
                Err(A::Error::invalid_length(1, &self))
            }
        }
        match ASKED {
            0 => source.deserialize_f64(Words),
            1 => source.deserialize_u32(Words),
            2 => source.deserialize_u64(Words),
            3 => source.deserialize_bool(Words),
            4 => source.deserialize_string(Words),
            5 => source.deserialize_map(Words),
            _ => source.deserialize_tuple(2, Words),
        }
    }
}

#[wasm_bindgen_test(unsupported = test)]
fn what_is_wrong_does_not_depend_on_the_words_of_serde() {
    fn refused<const ASKED: usize>(value: &Value, code: Code, sentence: &str) {
        let error = json::read::<Misleading<ASKED>>(value).err().expect("no value is accepted");
        assert_eq!((error.code(), error.message()), (code, sentence), "{value}");
    }
    let (fraction, text) = (json!(2.5), json!("known options are 7"));
    let shown = "the string \"known options are 7\"";
    refused::<0>(&text, Code::WrongType, &format!("this must be a number, not {shown}"));
    refused::<1>(&text, Code::WrongType, &format!("this must be a whole number from 0 to 4294967295, not {shown}"));
    refused::<1>(&fraction, Code::OutOfRange, "this must be a whole number from 0 to 4294967295, not the number 2.5");
    refused::<2>(&fraction, Code::OutOfRange, "this must be a whole number from 0 to 2^53 - 1, not the number 2.5");
    refused::<3>(&fraction, Code::WrongType, "this must be true or false, not the number 2.5");
    refused::<4>(&fraction, Code::WrongType, "this must be a string, not the number 2.5");
    refused::<5>(&fraction, Code::WrongType, "this must be an object, not the number 2.5");
    refused::<6>(&fraction, Code::WrongType, "this must be an array, not the number 2.5");
    refused::<6>(&json!([1]), Code::WrongDimension, "this must have 2 entries, not 1");
    refused::<6>(&json!([1, "2"]), Code::WrongType, "this must be a number, not the string \"2\"");
}

#[cfg(not(target_arch = "wasm32"))]
mod fuzz {
    use super::*;
    use crate::common::documents::{ARM, pointers};
    use proptest::prelude::*;

    /// Any JSON value, most often a small one.
    fn any_value() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![
            Just(Value::Null),
            any::<bool>().prop_map(Value::Bool),
            any::<f64>().prop_map(Value::from),
            (-4i8..5).prop_map(Value::from),
            prop_oneof![Just("disc"), Just("polygon"), Just("arm"), Just("")].prop_map(Value::from),
        ];
        leaf.prop_recursive(3, 12, 4, |inner| {
            let name = prop_oneof![Just("type"), Just("radius"), Just("min"), Just("name"), Just("start")];
            let fields = prop::collection::vec((name.prop_map(str::to_owned), inner.clone()), 0..4);
            prop_oneof![
                prop::collection::vec(inner, 0..4).prop_map(Value::Array),
                fields.prop_map(|fields| Value::Object(fields.into_iter().collect()))
            ]
        })
    }

    /// Replaces a value of the tree, removes it from its list or its object, or doubles it there.
    fn mutate(tree: &mut Value, at: usize, value: &Value, how: u8) {
        let all = pointers(tree);
        let at = &all[at % all.len()];
        let (parent, name) = at.rsplit_once('/').unwrap_or_default();
        if how == 0 {
            *tree.pointer_mut(at).expect("it is there") = value.clone();
        } else if let Some(Value::Array(items)) = tree.pointer_mut(parent) {
            let item = items.remove(name.parse().expect("an index"));
            items.extend(vec![item; if how == 2 { 2 } else { 0 }]);
        } else if let Some(Value::Object(fields)) = tree.pointer_mut(parent) {
            fields.remove(name);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_change_to_a_document_makes_the_parser_panic(at in 0usize..70, value in any_value(), how in 0u8..3) {
            for document in [ARM, DISC] {
                let mut node: Value = serde_json::from_str(document).unwrap();
                mutate(&mut node, at, &value, how);
                match Scenario::parse(&node.to_string()) {
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
            let _ = planarium::json::parse(&insert);
        }
    }
}
