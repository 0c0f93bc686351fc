//! Reading a tree of JSON values, from text or from another source.

use super::{MAX_DEPTH, MAX_TEXT, put_before};
use crate::error::{Code, Error, quoted};
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::map::Entry;
use serde_json::{Map, Value};
use std::fmt;

/// Reads JSON text; a byte order mark before it is skipped, as RFC 8259 (section 8.1) allows. O(n log n) in its length.
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
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut source = serde_json::Deserializer::from_str(text);
    let tree = read_tree(&mut source).and_then(|tree| {
        source.end().map(|()| tree).map_err(|source| Unread { refusal: None, pointer: String::new(), source })
    });
    tree.map_err(|Unread { refusal, pointer, source }| match refusal {
        Some((code, sentence)) => {
            let sentence = format!("{sentence} at line {} column {}", source.line(), source.column());
            Error::new(code, pointer, sentence)
        }
        None => {
            let what = huge_number_at(text, &source).unwrap_or("this is not JSON");
            Error::new(Code::InvalidJson, pointer, format!("{what}: {source}"))
        }
    })
}

/// The number in the text that the error is about, cut to 60 characters, if it is beyond the range of a 64-bit float.
fn huge_number_at<'a>(text: &'a str, error: &serde_json::Error) -> Option<&'a str> {
    let line = text.split('\n').nth(error.line().saturating_sub(1)).unwrap_or_default();
    let is_other = |c: char| !matches!(c, '0'..='9' | '+' | '-' | '.' | 'e' | 'E');
    let before = line.get(..error.column()).unwrap_or(line);
    let before = before.trim_end_matches(is_other);
    let start = before.len() - before.rsplit(is_other).next().map_or(0, str::len);
    let number = line[start..].split(is_other).next().unwrap_or_default();
    if before[..start].ends_with('"') {
        return None;
    }
    let is_number = serde_json::from_str::<IgnoredAny>(number).is_ok();
    (is_number && serde_json::from_str::<f64>(number).is_err()).then(|| number.get(..60).unwrap_or(number))
}

/// A number as JavaScript writes it, if it is not finite.
pub(crate) fn in_javascript(value: f64) -> String {
    value.to_string().replace("inf", "Infinity")
}

/// Why a tree cannot be read.
pub(crate) struct Unread<E> {
    /// The code and the sentence of what is refused here; `None` if the source itself is at fault.
    pub refusal: Option<(Code, String)>,
    /// The pointer of the offending value.
    pub pointer: String,
    /// The error of the source.
    pub source: E,
}

/// Reads a tree from any self-describing source.
pub(crate) fn read_tree<'de, D: Deserializer<'de>>(source: D) -> Result<Value, Unread<D::Error>> {
    let (mut pointer, mut refusal) = (String::new(), None);
    let tree = source.deserialize_any(Tree { pointer: &mut pointer, refusal: &mut refusal, depth: 0, index: None });
    tree.map_err(|source| Unread { refusal, pointer, source })
}

/// Reads one value.
struct Tree<'a> {
    /// Where the wrong value is, seen from this one.
    pointer: &'a mut String,
    /// What is refused here: sources turn an error into one of theirs, which has no code.
    refusal: &'a mut Option<(Code, String)>,
    /// The number of arrays and objects that contain it.
    depth: u32,
    /// Its index in an array.
    index: Option<usize>,
}

impl Tree<'_> {
    /// The error of the source about what is refused.
    #[cold]
    fn refuse<E: serde::de::Error>(&mut self, code: Code, sentence: String) -> E {
        let error = E::custom(&sentence);
        *self.refusal = Some((code, sentence));
        error
    }

    fn deeper<E: serde::de::Error>(&mut self) -> Result<u32, E> {
        // Text is held to the same bound by `serde_json`.
        if self.depth + 1 == MAX_DEPTH {
            return Err(self.refuse(Code::InvalidJson, "recursion limit exceeded".to_owned()));
        }
        Ok(self.depth + 1)
    }

    /// Reads a value in this one.
    fn inner(&mut self, depth: u32, index: Option<usize>) -> Tree<'_> {
        Tree { pointer: self.pointer, refusal: self.refusal, depth, index }
    }
}

impl<'de> DeserializeSeed<'de> for Tree<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, source: D) -> Result<Value, D::Error> {
        let Tree { pointer, refusal, depth, index } = self;
        source.deserialize_any(Tree { pointer, refusal, depth, index }).inspect_err(|_| {
            if let Some(index) = index {
                put_before(pointer, &index.to_string());
            }
        })
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

    fn visit_f64<E: serde::de::Error>(mut self, value: f64) -> Result<Value, E> {
        if value.is_finite() {
            Ok(value.into())
        } else {
            Err(self.refuse(Code::NotFinite, format!("{} is not finite", in_javascript(value))))
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut source: A) -> Result<Value, A::Error> {
        let (depth, mut items) = (self.deeper()?, Vec::new());
        while let Some(item) = source.next_element_seed(self.inner(depth, Some(items.len())))? {
            items.push(item);
        }
        Ok(Value::Array(items))
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut source: A) -> Result<Value, A::Error> {
        let (depth, mut fields) = (self.deeper()?, Map::new());
        while let Some(name) = source.next_key::<String>()? {
            match fields.entry(name) {
                Entry::Vacant(place) => {
                    let value = source.next_value_seed(self.inner(depth, None));
                    let value = value.inspect_err(|_| put_before(self.pointer, place.key()))?;
                    place.insert(value);
                }
                Entry::Occupied(other) => {
                    put_before(self.pointer, other.key());
                    let sentence = format!("the field {} occurs twice in one object", quoted(other.key()));
                    return Err(self.refuse(Code::DuplicateField, sentence));
                }
            }
        }
        Ok(Value::Object(fields))
    }
}
