//! A JSON value as a plain tree, from text or from any other source of serde's data model.
//!
//! The contracts are read from this tree and not straight into structs, so that every refusal can say where it stands and
//! text and JavaScript objects go one way.

use crate::error::{Code, Error};
use serde::de::{self, Deserialize, DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_path_to_error::Segment;
use std::collections::BTreeSet;
use std::fmt;

/// The longest text that is read, in bytes.
pub const MAX_TEXT: usize = 64 << 20;

/// How deep arrays and objects may lie within each other. (Text is held to serde_json's own bound, which is no deeper.)
pub const MAX_DEPTH: u32 = 128;

/// Whole numbers below this are exact as 64-bit floats and are written without a fraction.
const EXACT: f64 = (1u64 << 53) as f64;

/// A JSON value. Fields of an object keep their order; numbers are 64-bit floats, as in JavaScript (from another source
/// than text they may be NaN or infinite).
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number.
    Number(f64),
    /// A string.
    String(String),
    /// An array.
    Array(Vec<Node>),
    /// An object: its fields in order.
    Object(Vec<(String, Node)>),
}

impl Node {
    /// Reads JSON text. O(n log n) in its length.
    ///
    /// # Errors
    /// `too-large` for text longer than [`MAX_TEXT`]; `duplicate-field` for a field that stands twice in one object;
    /// `invalid-json` for anything else that is not JSON, for nesting deeper than [`MAX_DEPTH`] and for a number beyond
    /// the range of a 64-bit float. With the pointer of the value and, in the sentence, line and column.
    pub fn parse(text: &str) -> Result<Self, Error> {
        if text.len() > MAX_TEXT {
            let sentence = format!("the text is {} bytes long; at most {MAX_TEXT} are read", text.len());
            return Err(Error::new(Code::TooLarge, "", sentence));
        }
        let mut source = serde_json::Deserializer::from_str(text);
        let node: Node = serde_path_to_error::deserialize(&mut source).map_err(|error| {
            let pointer = pointer(error.path());
            let error = error.into_inner();
            // A node accepts every JSON value, so its only complaint is a field that stands twice.
            let code = if error.is_data() { Code::DuplicateField } else { Code::InvalidJson };
            Error::new(code, pointer, sentence(&error, text))
        })?;
        source.end().map_err(|error| Error::new(Code::InvalidJson, "", sentence(&error, text)))?;
        Ok(node)
    }

    /// Reads from a source that is not text, such as a JavaScript value.
    ///
    /// # Errors
    /// `invalid-json`, with the pointer of the value, for what JSON does not have (functions, byte strings, keys that are
    /// not strings), for a field that stands twice, and for nesting deeper than [`MAX_DEPTH`], cycles among it.
    pub fn read<'de, D: Deserializer<'de>>(source: D) -> Result<Self, Error> {
        serde_path_to_error::deserialize(source).map_err(|error| {
            let sentence = format!("this is not a JSON value: {}", error.inner());
            Error::new(Code::InvalidJson, pointer(error.path()), sentence)
        })
    }
}

/// The sentence for an error in text; with the number where one is out of range.
fn sentence(error: &serde_json::Error, text: &str) -> String {
    let what = error.to_string();
    if error.is_data() {
        return what;
    }
    match number_at(text, error.line(), error.column()) {
        Some(number) if what.starts_with("number out of range") => format!("{number}: {what}"),
        _ => format!("this is not JSON: {what}"),
    }
}

/// The run of characters of a number that ends at a line and column (both from 1, columns in bytes), cut to 60.
fn number_at(text: &str, line: usize, column: usize) -> Option<&str> {
    let line = text.split('\n').nth(line.checked_sub(1)?)?;
    let is_part = |byte: &u8| byte.is_ascii_digit() || b"+-.eE".contains(byte);
    let bytes = line.as_bytes();
    let column = column.min(bytes.len());
    let end = column + bytes[column..].iter().take_while(|byte| is_part(byte)).count();
    let start = end - bytes[..end].iter().rev().take_while(|byte| is_part(byte)).count();
    line.get(start..end.min(start + 60)).filter(|number| !number.is_empty())
}

/// The path of an error as a JSON pointer, as far as it is known.
fn pointer(path: &serde_path_to_error::Path) -> String {
    let mut pointer = String::new();
    for segment in path {
        match segment {
            Segment::Seq { index } => pointer.push_str(&format!("/{index}")),
            Segment::Map { key } => push_field(&mut pointer, key),
            Segment::Enum { .. } | Segment::Unknown => break,
        }
    }
    pointer
}

/// Appends the name of a field to a JSON pointer, escaped as RFC 6901 asks.
pub(crate) fn push_field(pointer: &mut String, name: &str) {
    pointer.push('/');
    pointer.push_str(&name.replace('~', "~0").replace('/', "~1"));
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        AtDepth(0).deserialize(deserializer)
    }
}

/// Reads a node that lies within so many arrays and objects.
struct AtDepth(u32);

impl AtDepth {
    fn deeper<E: de::Error>(&self) -> Result<u32, E> {
        if self.0 == MAX_DEPTH {
            return Err(E::custom(format!("nested deeper than {MAX_DEPTH}")));
        }
        Ok(self.0 + 1)
    }
}

impl<'de> DeserializeSeed<'de> for AtDepth {
    type Value = Node;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Node, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for AtDepth {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Node, E> {
        Ok(Node::Bool(value))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Node, E> {
        Ok(Node::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Node, E> {
        Ok(Node::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Node, E> {
        Ok(Node::Number(value as f64))
    }

    fn visit_str<E>(self, value: &str) -> Result<Node, E> {
        Ok(Node::String(value.to_owned()))
    }

    fn visit_string<E>(self, value: String) -> Result<Node, E> {
        Ok(Node::String(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut access: A) -> Result<Node, A::Error> {
        let depth = self.deeper()?;
        let mut items = Vec::new();
        while let Some(item) = access.next_element_seed(AtDepth(depth))? {
            items.push(item);
        }
        Ok(Node::Array(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<Node, A::Error> {
        let depth = self.deeper()?;
        let (mut fields, mut names) = (Vec::new(), BTreeSet::new());
        while let Some(name) = access.next_key::<String>()? {
            if !names.insert(name.clone()) {
                // Refused as a value, so that the pointer ends in the name.
                access.next_value_seed(Twice(&name))?;
            }
            fields.push((name, access.next_value_seed(AtDepth(depth))?));
        }
        Ok(Node::Object(fields))
    }
}

/// Refuses the value of a field that has stood before.
struct Twice<'a>(&'a str);

impl<'de> DeserializeSeed<'de> for Twice<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, _: D) -> Result<(), D::Error> {
        let name: String = self.0.chars().take(60).collect();
        Err(de::Error::custom(format!("the field {name:?} stands twice in one object")))
    }
}

impl Serialize for Node {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Node::Null => serializer.serialize_unit(),
            Node::Bool(value) => serializer.serialize_bool(*value),
            Node::Number(value)
                if value.fract() == 0.0 && value.abs() < EXACT && value.to_bits() != (-0.0f64).to_bits() =>
            {
                serializer.serialize_i64(*value as i64)
            }
            Node::Number(value) => serializer.serialize_f64(*value),
            Node::String(value) => serializer.serialize_str(value),
            Node::Array(items) => serializer.collect_seq(items),
            Node::Object(fields) => {
                let mut map = serializer.serialize_map(Some(fields.len()))?;
                for (name, value) in fields {
                    map.serialize_entry(name, value)?;
                }
                map.end()
            }
        }
    }
}
