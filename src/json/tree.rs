//! Reading a tree of JSON values, from text or from another source.

use super::{MAX_DEPTH, MAX_TEXT, push_field};
use crate::error::{Code, Error, quoted};
use serde::de::{DeserializeSeed, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use serde_json::map::Entry;
use serde_json::{Map, Value};
use std::fmt;

/// Reads JSON text. O(n log n) in its length.
///
/// # Errors
/// `too-large` for text longer than [`MAX_TEXT`]; `duplicate-field` for a field that occurs twice in one object; `invalid-json`
/// for anything else that is not JSON, for nesting as deep as [`MAX_DEPTH`] and for a number beyond the range of a 64-bit
/// float. With the pointer of the value and, in the sentence, line and column in bytes.
pub fn parse(text: &str) -> Result<Value, Error> {
    if text.len() > MAX_TEXT {
        let sentence = format!("the text is {} bytes long; at most {MAX_TEXT} are read", text.len());
        return Err(Error::new(Code::TooLarge, "", sentence));
    }
    let mut source = serde_json::Deserializer::from_str(text);
    let (tree, pointer) = read_tree(&mut source);
    tree.and_then(|tree| source.end().map(|()| tree)).map_err(|error| {
        // Of all that is read here, only a field that occurs twice is JSON.
        let code = if error.is_data() { Code::DuplicateField } else { Code::InvalidJson };
        let number = if error.to_string().starts_with("number out of range") { number_at(text, &error) } else { "" };
        let prefix = match code {
            Code::DuplicateField => String::new(),
            _ if number.is_empty() => "this is not JSON: ".to_owned(),
            _ => format!("{number}: "),
        };
        Error::new(code, pointer, format!("{prefix}{error}"))
    })
}

/// The number in the text that the error is about, cut to 60 characters.
fn number_at<'a>(text: &'a str, error: &serde_json::Error) -> &'a str {
    let line = text.split('\n').nth(error.line().saturating_sub(1)).unwrap_or_default();
    let is_other = |c: char| !matches!(c, '0'..='9' | '+' | '-' | '.' | 'e' | 'E');
    let before = line.get(..error.column()).unwrap_or(line);
    let start = before.trim_end_matches(is_other).rfind(is_other).map_or(0, |at| at + 1);
    let number = line[start..].split(is_other).next().unwrap_or_default();
    number.get(..60).unwrap_or(number)
}

/// A number as JavaScript writes it, if it is not finite.
pub(crate) fn in_javascript(value: f64) -> String {
    value.to_string().replace("inf", "Infinity")
}

/// Reads a tree from any self-describing source. The second value is the pointer of the offending value if the first is an error.
pub(crate) fn read_tree<'de, D: Deserializer<'de>>(source: D) -> (Result<Value, D::Error>, String) {
    let mut pointer = String::new();
    let tree = Tree { pointer: &mut pointer, depth: 0, index: None }.deserialize(source);
    (tree, pointer)
}

/// Reads one value.
struct Tree<'a> {
    /// The pointer of the value; it stays if the value is wrong.
    pointer: &'a mut String,
    /// The number of arrays and objects that contain it.
    depth: u32,
    /// Its index in an array.
    index: Option<usize>,
}

impl Tree<'_> {
    fn deeper<E: serde::de::Error>(&self) -> Result<u32, E> {
        // Text is held to the same bound by `serde_json`.
        if self.depth + 1 == MAX_DEPTH { Err(E::custom("recursion limit exceeded")) } else { Ok(self.depth + 1) }
    }
}

impl<'de> DeserializeSeed<'de> for Tree<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, source: D) -> Result<Value, D::Error> {
        if let Some(index) = self.index {
            push_field(self.pointer, &index.to_string());
        }
        source.deserialize_any(self)
    }
}

/// The methods of a visitor for values that are converted as they are.
macro_rules! scalars {
    ($($visit:ident: $Type:ty),*) => {
        $(fn $visit<E>(self, value: $Type) -> Result<Value, E> {
            Ok(value.into())
        })*
    };
}

impl<'de> Visitor<'de> for Tree<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    scalars!(visit_bool: bool, visit_i64: i64, visit_u64: u64, visit_str: &str);

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Value, E> {
        if value.is_finite() {
            Ok(value.into())
        } else {
            Err(E::custom(format!("{} is not finite", in_javascript(value))))
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut source: A) -> Result<Value, A::Error> {
        let (depth, length, mut items) = (self.deeper()?, self.pointer.len(), Vec::new());
        while let Some(item) =
            source.next_element_seed(Tree { pointer: self.pointer, depth, index: Some(items.len()) })?
        {
            items.push(item);
            self.pointer.truncate(length);
        }
        Ok(Value::Array(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut source: A) -> Result<Value, A::Error> {
        let (depth, length, mut fields) = (self.deeper()?, self.pointer.len(), Map::new());
        while let Some(name) = source.next_key::<String>()? {
            push_field(self.pointer, &name);
            match fields.entry(name) {
                Entry::Vacant(place) => {
                    place.insert(source.next_value_seed(Tree { pointer: self.pointer, depth, index: None })?);
                }
                Entry::Occupied(other) => {
                    let sentence = format!("the field {} occurs twice in one object", quoted(other.key()));
                    return Err(A::Error::custom(sentence));
                }
            }
            self.pointer.truncate(length);
        }
        Ok(Value::Object(fields))
    }
}
