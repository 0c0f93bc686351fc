//! Reading a tree as a type that derives `Deserialize`, with our codes and pointers if it does not fit.

use super::{push_field, put_before};
use crate::error::{Code, Error, Number, quoted};
use serde::de::value::{BorrowedStrDeserializer, StrDeserializer};
use serde::de::{
    self, Deserialize, DeserializeSeed, Deserializer, Expected, MapAccess, SeqAccess, Unexpected, Visitor,
};
use serde_json::{Value, map};
use std::borrow::Cow;
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

/// The errors of serde as our codes. A method of [`Tree`] that knows what is wanted says so in our words; those of serde, which
/// change with its versions, decide nothing.
#[derive(Debug)]
enum Reason {
    /// Another value than wanted: a code, and what is wanted.
    Other(Code, Cow<'static, str>),
    /// The field is missing.
    Missing(&'static str),
    /// A word that is none of those known.
    Word(String),
    /// All else: a code and a sentence.
    Refused(Code, String),
}

impl Reason {
    #[cold]
    fn fault(self) -> Box<Fault> {
        Box::new(Fault { pointer: String::new(), reason: self })
    }
}

impl Fault {
    /// The same error; if it is that this very value is another than wanted, with what is wanted in these words.
    #[cold]
    fn wanted(mut self: Box<Self>, words: &'static str) -> Box<Self> {
        if let (Reason::Other(_, wanted), true) = (&mut self.reason, self.pointer.is_empty()) {
            *wanted = words.into();
        }
        self
    }

    /// The same error, seen from the array or object around it.
    #[cold]
    fn under(mut self: Box<Self>, name: &str) -> Box<Self> {
        put_before(&mut self.pointer, name);
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
            Reason::Word(sentence) if pointer.ends_with("/type") => (Code::UnknownType, sentence),
            Reason::Word(sentence) => (Code::OutOfRange, sentence),
            Reason::Refused(code, sentence) => (code, sentence),
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
        Reason::Refused(Code::OutOfRange, sentence.to_string()).fault()
    }

    fn invalid_type(_: Unexpected, wanted: &dyn Expected) -> Self {
        Reason::Other(Code::WrongType, wanted.to_string().into()).fault()
    }

    fn invalid_value(_: Unexpected, wanted: &dyn Expected) -> Self {
        Reason::Other(Code::OutOfRange, wanted.to_string().into()).fault()
    }

    fn invalid_length(_: usize, wanted: &dyn Expected) -> Self {
        Reason::Other(Code::WrongDimension, wanted.to_string().into()).fault()
    }

    fn unknown_variant(word: &str, known: &'static [&'static str]) -> Self {
        Reason::Word(format!("this must be one of {}, not {}", known.join(", "), quoted(word))).fault()
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Self {
        let sentence = format!("the field {} is not known here; known are {}", quoted(field), known.join(", "));
        Reason::Refused(Code::UnknownField, sentence).fault()
    }

    fn missing_field(field: &'static str) -> Self {
        Reason::Missing(field).fault()
    }
}

/// The error about an array of another length.
#[cold]
fn wrong_length(count: usize, length: usize) -> Box<Fault> {
    Reason::Refused(Code::WrongDimension, format!("this must have {count} entries, not {length}")).fault()
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

impl<'de> Tree<'de> {
    /// A whole number.
    fn integer<V: Visitor<'de>>(self, visitor: V, words: &'static str) -> Result<V::Value, Box<Fault>> {
        self.deserialize_any(visitor).map_err(|mut fault| {
            // A fraction has another type than a whole number for serde, not for us.
            if let (Reason::Other(code, _), Value::Number(_)) = (&mut fault.reason, self.0) {
                *code = Code::OutOfRange;
            }
            fault.wanted(words)
        })
    }
}

/// Methods of a deserializer that say in words what they want.
macro_rules! wanted {
    ($($method:ident: $words:literal),* $(,)?) => {
        $(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Fault>> {
            self.deserialize_any(visitor).map_err(|fault| fault.wanted($words))
        })*
    };
}

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
                Err(wrong_length(count, length))
            }
            Value::Object(fields) => {
                let kind = fields.get_key_value("type");
                visitor.visit_map(Fields { kind, others: fields.iter(), last: None })
            }
        }
    }

    wanted! {
        deserialize_bool: "true or false",
        deserialize_f64: "a number",
        deserialize_str: "a string",
        deserialize_string: "a string",
        deserialize_seq: "an array",
        deserialize_map: "an object",
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Fault>> {
        self.integer(visitor, "a whole number from 0 to 4294967295")
    }

    fn deserialize_u64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Fault>> {
        self.integer(visitor, "a whole number from 0 to 2^53 - 1")
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, count: usize, visitor: V) -> Result<V::Value, Box<Fault>> {
        self.deserialize_any(visitor).map_err(|fault| match (self.0, &fault.reason) {
            (Value::Array(items), Reason::Other(Code::WrongDimension, _)) if fault.pointer.is_empty() => {
                wrong_length(count, items.len())
            }
            _ => fault.wanted("an array"),
        })
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        count: usize,
        visitor: V,
    ) -> Result<V::Value, Box<Fault>> {
        self.deserialize_tuple(count, visitor)
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
            let plural = if fields.len() == 1 { "" } else { "s" };
            let wanted = format!("an object with the field{plural} {}", fields.join(", "));
            Err(Reason::Other(Code::WrongType, wanted.into()).fault())
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
        i8 i16 i32 i64 i128 u8 u16 u128 f32 char bytes byte_buf unit unit_struct identifier ignored_any
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
#[doc(hidden)]
#[macro_export]
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
                source.deserialize_struct(stringify!($name), &["type"], ByType)
            }
        }
    };
}
pub use by_type;
