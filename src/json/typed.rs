//! Reading a tree as a type that derives `Deserialize`, with our codes and pointers if it does not fit.

use super::push_field;
use crate::error::{Code, Error, Number, quoted};
use serde::de::value::{BorrowedStrDeserializer, StrDeserializer};
use serde::de::{
    self, Deserialize, DeserializeSeed, Deserializer, Expected, MapAccess, SeqAccess, Unexpected, Visitor,
};
use serde_json::{Value, map};
use std::{fmt, slice};

/// Reads a value as a type. Structs are objects, absent options are absent (`null` is none), -0 is 0, and whole numbers below
/// 2^53 are integers however they were written.
///
/// # Errors
/// With the pointer below `value`: `unknown-field`, `missing-field`, `wrong-type`, `wrong-dimension` for an array of another
/// length, `unknown-type` for an unknown `type`, and `out-of-range` for other unknown words, for integers that do not fit, and
/// for values that a type refuses with a message of its own.
pub fn read<'de, T: Deserialize<'de>>(value: &'de Value) -> Result<T, Error> {
    T::deserialize(Tree(value)).map_err(|fault| fault.at(value))
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

/// Reads a number that is not negative and may be left out.
///
/// # Errors
/// Those of [`not_negative`].
pub fn some_not_negative<'de, D: Deserializer<'de>>(source: D) -> Result<Option<f64>, D::Error> {
    not_negative(source).map(Some)
}

/// An error of serde, on its way out to the value that is read.
#[derive(Debug)]
struct Fault {
    /// The pointer to the offending value, from where the error is now.
    pointer: String,
    reason: Reason,
}

/// The errors of serde as our codes.
#[derive(Debug)]
enum Reason {
    /// Another value than expected: a code, and the expected one.
    Other(Code, String),
    /// The field is missing.
    Missing(&'static str),
    /// All else: a code and a sentence.
    Told(Code, String),
}

impl Reason {
    #[cold]
    fn fault(self) -> Box<Fault> {
        Box::new(Fault { pointer: String::new(), reason: self })
    }
}

impl Fault {
    /// The same error, seen from the array or object around it.
    #[cold]
    fn under(mut self: Box<Self>, name: &str) -> Box<Self> {
        let mut pointer = String::new();
        push_field(&mut pointer, name);
        pointer.push_str(&self.pointer);
        self.pointer = pointer;
        self
    }

    /// The error about a value in `root`.
    fn at(self, root: &Value) -> Error {
        let Self { mut pointer, reason } = self;
        let (code, sentence) = match reason {
            Reason::Other(code, wanted) => {
                (code, format!("this must be {wanted}, not {}", root.pointer(&pointer).map_or("this".into(), describe)))
            }
            Reason::Missing(field) => {
                push_field(&mut pointer, field);
                (Code::MissingField, format!("the field {} is missing", quoted(field)))
            }
            Reason::Told(Code::OutOfRange, sentence) if pointer.ends_with("/type") => (Code::UnknownType, sentence),
            Reason::Told(code, sentence) => (code, sentence),
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

impl de::Error for Box<Fault> {
    fn custom<T: fmt::Display>(sentence: T) -> Self {
        Reason::Told(Code::OutOfRange, sentence.to_string()).fault()
    }

    fn invalid_type(found: Unexpected, wanted: &dyn Expected) -> Self {
        let wanted = wanted.to_string();
        let is_number = matches!(found, Unexpected::Float(_)) && wanted.starts_with('u');
        Reason::Other(if is_number { Code::OutOfRange } else { Code::WrongType }, in_words(&wanted)).fault()
    }

    fn invalid_value(_: Unexpected, wanted: &dyn Expected) -> Self {
        Reason::Other(Code::OutOfRange, in_words(&wanted.to_string())).fault()
    }

    fn invalid_length(length: usize, wanted: &dyn Expected) -> Self {
        let count: String = wanted.to_string().chars().filter(char::is_ascii_digit).collect();
        Reason::Told(Code::WrongDimension, format!("this must have {count} entries, not {length}")).fault()
    }

    fn unknown_variant(word: &str, known: &'static [&'static str]) -> Self {
        Self::custom(format_args!("this must be one of {}, not {}", known.join(", "), quoted(word)))
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Self {
        let sentence = format!("the field {} is not known here; known are {}", quoted(field), known.join(", "));
        Reason::Told(Code::UnknownField, sentence).fault()
    }

    fn missing_field(field: &'static str) -> Self {
        Reason::Missing(field).fault()
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
    type Error = Box<Fault>;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Fault>> {
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
                let mut left = Items(items.iter().enumerate());
                let value = visitor.visit_seq(&mut left)?;
                let (count, length) = (items.len() - left.0.len(), items.len());
                if count == length {
                    return Ok(value);
                }
                let sentence = format!("this must have {count} entries, not {length}");
                Err(Reason::Told(Code::WrongDimension, sentence).fault())
            }
            Value::Object(fields) => {
                let kind = fields.get_key_value("type");
                visitor.visit_map(Fields { kind, others: fields.iter(), last: None })
            }
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Fault>> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Box<Fault>> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Box<Fault>> {
        if self.0.is_object() {
            self.deserialize_any(visitor)
        } else {
            Err(Reason::Other(Code::WrongType, format!("an object with the fields {}", fields.join(", "))).fault())
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Box<Fault>> {
        match self.0 {
            Value::String(word) => visitor.visit_enum(StrDeserializer::new(word)),
            _ => Err(Reason::Other(Code::WrongType, "a string".into()).fault()),
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct seq tuple
        tuple_struct map identifier ignored_any
    }
}

/// The items of an array that are not read yet, with their indices.
struct Items<'de>(std::iter::Enumerate<slice::Iter<'de, Value>>);

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = Box<Fault>;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Box<Fault>> {
        let Some((i, item)) = self.0.next() else { return Ok(None) };
        seed.deserialize(Tree(item)).map(Some).map_err(|fault| fault.under(&i.to_string()))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

/// The fields of an object that are not read yet, `type` first.
struct Fields<'de> {
    kind: Option<(&'de String, &'de Value)>,
    others: map::Iter<'de>,
    /// The field whose name was read last.
    last: Option<(&'de String, &'de Value)>,
}

impl<'de> MapAccess<'de> for Fields<'de> {
    type Error = Box<Fault>;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Box<Fault>> {
        self.last = self.kind.take().or_else(|| self.others.find(|(name, _)| *name != "type"));
        let Some((name, _)) = self.last else { return Ok(None) };
        seed.deserialize(BorrowedStrDeserializer::new(name)).map(Some).map_err(|fault: Box<Fault>| fault.under(name))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Box<Fault>> {
        let (name, value) = self.last.expect("the name of a field is read first");
        seed.deserialize(Tree(value)).map_err(|fault| fault.under(name))
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
