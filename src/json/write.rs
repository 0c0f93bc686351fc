//! A tree to JSON text.

use super::Node;
use crate::decimal::exact;
use std::fmt::Write;

/// Whole numbers below this are exact as 64-bit floats and are written without a fraction.
const EXACT: f64 = (1u64 << 53) as f64;

impl Node {
    /// The value as JSON text on one line. Numbers have the fewest digits that read back to the same bits; those that JSON has no
    /// word for (NaN, infinite) are `null`. Equal trees give equal text, on every platform.
    pub fn to_json(&self) -> String {
        let mut text = String::new();
        self.write(&mut text);
        text
    }

    fn write(&self, text: &mut String) {
        match self {
            Node::Null => text.push_str("null"),
            Node::Bool(value) => text.push_str(if *value { "true" } else { "false" }),
            Node::Number(value) => write_number(*value, text),
            Node::String(value) => write_string(value, text),
            Node::Array(items) => {
                text.push('[');
                for (i, item) in items.iter().enumerate() {
                    text.push_str(if i == 0 { "" } else { "," });
                    item.write(text);
                }
                text.push(']');
            }
            Node::Object(fields) => {
                text.push('{');
                for (i, (name, value)) in fields.iter().enumerate() {
                    text.push_str(if i == 0 { "" } else { "," });
                    write_string(name, text);
                    text.push(':');
                    value.write(text);
                }
                text.push('}');
            }
        }
    }
}

// Writing to a string cannot fail.
fn write_number(value: f64, text: &mut String) {
    if !value.is_finite() {
        text.push_str("null");
    } else if value.abs() < EXACT && value == libm::trunc(value) && (value != 0.0 || value.is_sign_positive()) {
        let _ = write!(text, "{}", value as i64);
    } else {
        text.push_str(&exact(value, -4));
    }
}

fn write_string(value: &str, text: &mut String) {
    text.push('"');
    for character in value.chars() {
        match character {
            '"' | '\\' => text.extend(['\\', character]),
            '\u{8}' => text.push_str("\\b"),
            '\u{c}' => text.push_str("\\f"),
            '\n' => text.push_str("\\n"),
            '\r' => text.push_str("\\r"),
            '\t' => text.push_str("\\t"),
            '\0'..' ' => drop(write!(text, "\\u{:04x}", u32::from(character))),
            _ => text.push(character),
        }
    }
    text.push('"');
}
