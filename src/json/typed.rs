//! Reading a tree as a type that derives `Deserialize`, with our codes and pointers if it does not fit.

use super::push_field;
use crate::error::{Code, Error, Number, quoted};
use serde::de::value::{MapDeserializer, SeqDeserializer};
use serde::de::{self, Deserialize, Deserializer, Expected, IntoDeserializer, Unexpected, Visitor};
use serde_json::Value;
use serde_path_to_error::{Path, Segment};
use std::fmt;

/// Reads a value as a type. Structs are objects, absent options are absent (`null` is none), -0 is 0, and whole numbers below
/// 2^53 are integers however they were written.
///
/// # Errors
/// With the pointer below `value`: `unknown-field`, `missing-field`, `wrong-type`, `wrong-dimension` for an array of another
/// length, `unknown-type` for an unknown `type`, and `out-of-range` for other unknown words, for integers that do not fit, and
/// for values that a type refuses with a message of its own.
pub fn read<'de, T: Deserialize<'de>>(value: &'de Value) -> Result<T, Error> {
    serde_path_to_error::deserialize(Tree(value)).map_err(|error| {
        let pointer = pointer(error.path());
        error.into_inner().at(pointer, value)
    })
}

/// Reads a number that is not negative: for `#[serde(deserialize_with = "not_negative")]`.
///
/// # Errors
/// Those of the source, and if the number is negative.
pub fn not_negative<'de, D: Deserializer<'de>>(source: D) -> Result<f64, D::Error> {
    let value = f64::deserialize(source)?;
    let sentence = || de::Error::custom(format!("this must not be negative, but is {}", Number(value)));
    if value < 0.0 { Err(sentence()) } else { Ok(value) }
}

/// The pointer for a path, without segments that have no name or index.
fn pointer(path: &Path) -> String {
    let mut pointer = String::new();
    for segment in path {
        match segment {
            Segment::Seq { index } => push_field(&mut pointer, &index.to_string()),
            Segment::Map { key } => push_field(&mut pointer, key),
            Segment::Enum { .. } | Segment::Unknown => {}
        }
    }
    pointer
}

/// The errors of serde as our codes.
#[derive(Debug)]
enum Fault {
    /// Another value than expected: a code, and the expected one.
    Other(Code, String),
    /// The field is missing.
    Missing(&'static str),
    /// All else: a code and a sentence.
    Told(Code, String),
}

impl Fault {
    /// The error about the value at `pointer` in `root`.
    fn at(self, mut pointer: String, root: &Value) -> Error {
        let (code, sentence) = match self {
            Fault::Other(code, wanted) => {
                (code, format!("this must be {wanted}, not {}", root.pointer(&pointer).map_or("this".into(), describe)))
            }
            Fault::Missing(field) => {
                push_field(&mut pointer, field);
                (Code::MissingField, format!("the field {} is missing", quoted(field)))
            }
            Fault::Told(Code::OutOfRange, sentence) if pointer.ends_with("/type") => (Code::UnknownType, sentence),
            Fault::Told(code, sentence) => (code, sentence),
        };
        Error::new(code, pointer, sentence)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for Fault {}

impl de::Error for Fault {
    fn custom<T: fmt::Display>(sentence: T) -> Self {
        Fault::Told(Code::OutOfRange, sentence.to_string())
    }

    fn invalid_type(found: Unexpected, wanted: &dyn Expected) -> Self {
        let wanted = wanted.to_string();
        let is_number = matches!(found, Unexpected::Float(_)) && wanted.starts_with('u');
        Fault::Other(if is_number { Code::OutOfRange } else { Code::WrongType }, in_words(&wanted))
    }

    fn invalid_value(_: Unexpected, wanted: &dyn Expected) -> Self {
        Fault::Other(Code::OutOfRange, in_words(&wanted.to_string()))
    }

    fn invalid_length(length: usize, wanted: &dyn Expected) -> Self {
        let count: String = wanted.to_string().chars().filter(char::is_ascii_digit).collect();
        Fault::Told(Code::WrongDimension, format!("this must have {count} entries, not {length}"))
    }

    fn unknown_variant(word: &str, known: &'static [&'static str]) -> Self {
        Self::custom(format_args!("this must be one of {}, not {}", known.join(", "), quoted(word)))
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Self {
        let sentence = format!("the field {} is not known here; known are {}", quoted(field), known.join(", "));
        Fault::Told(Code::UnknownField, sentence)
    }

    fn missing_field(field: &'static str) -> Self {
        Fault::Missing(field)
    }
}

/// The name in JSON of what serde expects.
fn in_words(wanted: &str) -> String {
    match wanted {
        "f64" => "a number",
        "u32" => "a whole number from 0 to 4294967295",
        "u64" | "usize" => "a whole number from 0 to 2^53 - 1",
        "a boolean" => "true or false",
        "a map with the field type" => "an object with the field type",
        _ if wanted.starts_with("struct") || wanted.contains("map") => "an object",
        _ if wanted.contains("sequence") || wanted.contains("tuple") || wanted.contains("array") => "an array",
        _ => "a string",
    }
    .to_owned()
}

/// A value for a sentence.
fn describe(value: &Value) -> String {
    match value {
        Value::Null => "null".to_owned(),
        Value::Bool(value) => value.to_string(),
        Value::Number(value) => format!("the number {}", Number(value.as_f64().unwrap_or(f64::NAN))),
        Value::String(value) => format!("the string {}", quoted(value)),
        Value::Array(items) => format!("an array of {}", items.len()),
        Value::Object(_) => "an object".to_owned(),
    }
}

/// A tree to be read by serde, stricter than `serde_json` does: see [`read`]. The field `type` of an object comes first.
#[derive(Clone, Copy)]
struct Tree<'de>(&'de Value);

impl<'de> Deserializer<'de> for Tree<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.0 {
            Value::Null => visitor.visit_unit(),
            Value::Bool(value) => visitor.visit_bool(*value),
            Value::Number(value) => {
                let value = value.as_f64().unwrap_or(f64::NAN) + 0.0;
                if value != libm::trunc(value) || value.abs() >= super::write::EXACT {
                    visitor.visit_f64(value)
                } else if value < 0.0 {
                    visitor.visit_i64(value as i64)
                } else {
                    visitor.visit_u64(value as u64)
                }
            }
            Value::String(value) => visitor.visit_borrowed_str(value),
            Value::Array(items) => {
                let mut items = SeqDeserializer::new(items.iter().map(Tree));
                let value = visitor.visit_seq(&mut items)?;
                items.end().map(|()| value)
            }
            Value::Object(fields) => {
                let kind = fields.get_key_value("type");
                let others = fields.iter().filter(|(name, _)| *name != "type");
                let fields = kind.into_iter().chain(others).map(|(name, value)| (name.as_str(), Tree(value)));
                visitor.visit_map(MapDeserializer::new(fields))
            }
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        if self.0.is_object() {
            self.deserialize_any(visitor)
        } else {
            Err(Fault::Other(Code::WrongType, format!("an object with the fields {}", fields.join(", "))))
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match self.0 {
            Value::String(word) => visitor.visit_enum(word.as_str().into_deserializer()),
            _ => Err(Fault::Other(Code::WrongType, "a string".into())),
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct seq tuple
        tuple_struct map identifier ignored_any
    }
}

impl<'de> IntoDeserializer<'de, Fault> for Tree<'de> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// Derives `Deserialize` for an enum whose variants hold a struct each and are distinguished by the field `type`. A derived
/// internally tagged enum would lose the path of an error; this one is only for [`read`], which has `type` come first.
macro_rules! by_type {
    ($name:ident { $($word:literal => $variant:ident),+ $(,)? }) => {
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
                #[derive(serde::Deserialize)]
                enum Kind {
                    $(#[serde(rename = $word)] $variant),+
                }
                struct ByType;
                impl<'de> serde::de::Visitor<'de> for ByType {
                    type Value = $name;

                    fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                        f.write_str("a map with the field type")
                    }

                    fn visit_map<A: serde::de::MapAccess<'de>>(self, mut fields: A) -> Result<$name, A::Error> {
                        if fields.next_key::<String>()?.as_deref() != Some("type") {
                            return Err(serde::de::Error::missing_field("type"));
                        }
                        let kind: Kind = fields.next_value()?;
                        let fields = serde::de::value::MapAccessDeserializer::new(fields);
                        match kind {
                            $(Kind::$variant => serde::Deserialize::deserialize(fields).map($name::$variant)),+
                        }
                    }
                }
                source.deserialize_map(ByType)
            }
        }
    };
}
pub(crate) use by_type;
