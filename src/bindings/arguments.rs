//! Arguments from JavaScript, checked once. The package has copied them: a list of numbers is a `Float64Array`, objects and other
//! lists hold plain values, a document is text where text can say it, and what could not be copied is an `Error` that says why.
//! So nothing of the caller runs in here.

use crate::error::{Code, Error, Number, quoted};
use crate::json::{Unread, in_javascript, parse, read, read_tree};
use crate::options::{in_camel_case, refusal};
use crate::run::{Request, Value};
use crate::scenario::Scenario;
use js_sys::{Array, ArrayBuffer, Float64Array, JsString, RangeError, Uint8Array};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value as Json};
use serde_wasm_bindgen::Deserializer;
use wasm_bindgen::prelude::*;

/// The longest scenario text that is read, in characters.
const LONGEST_TEXT: u32 = 32 << 20;

/// The longest roadmap that is read, in bytes or characters.
const LONGEST_FILE: u32 = 256 << 20;

/// A value for a sentence.
fn show(value: &JsValue) -> String {
    if let Some(text) = value.as_string() {
        return quoted(&text);
    }
    if let Some(number) = value.as_f64() {
        return Number(number).to_string();
    }
    match value.js_typeof().as_string().as_deref() {
        Some("undefined") => "undefined",
        Some("function") => "a function",
        Some("bigint") => "a bigint",
        Some("symbol") => "a symbol",
        Some("boolean") => return value.is_truthy().to_string(),
        _ if value.is_null() => "null",
        _ if Array::is_array(value) || ArrayBuffer::is_view(value) => "an array",
        _ => "an object",
    }
    .to_owned()
}

/// The error about an argument of another type.
fn wrong(value: &JsValue, name: &str, wanted: &str) -> Error {
    let pointer = format!("/{name}");
    match value.dyn_ref::<js_sys::Error>() {
        Some(reason) => {
            let code = if reason.has_type::<RangeError>() { Code::TooLarge } else { Code::WrongType };
            let place = place(reason).unwrap_or_default();
            let sentence = match text_of(reason, "kind") {
                Some(kind) if place.is_empty() => format!("{name} must be {wanted}, not {kind}"),
                _ => format!("{name} cannot be read: {}", String::from(reason.message())),
            };
            Error::new(code, pointer + &place, sentence)
        }
        None => Error::new(Code::WrongType, pointer, format!("{name} must be {wanted}, not {}", show(value))),
    }
}

/// Where in an argument something stands that could not be copied, as a JSON pointer; `None` if the caller's own code has thrown.
fn place(reason: &js_sys::Error) -> Option<String> {
    text_of(reason, "pointer")
}

/// A property of an error of the package, if it is there: the `pointer` of a refusal, the `kind` of a value that has no JSON
/// form.
fn text_of(reason: &js_sys::Error, property: &str) -> Option<String> {
    js_sys::Reflect::get(reason, &property.into()).ok()?.as_string()
}

/// A finite number.
pub(super) fn finite(value: &JsValue, name: &str) -> Result<f64, Error> {
    let number = value.as_f64().ok_or_else(|| wrong(value, name, "a number"))?;
    if !number.is_finite() {
        let sentence = format!("{name} must be a finite number, not {}", in_javascript(number));
        return Err(Error::new(Code::NotFinite, format!("/{name}"), sentence));
    }
    Ok(number)
}

/// A finite number that is not negative.
pub(super) fn not_negative(value: &JsValue, name: &str) -> Result<f64, Error> {
    let number = finite(value, name)?;
    if number < 0.0 {
        let sentence = format!("{name} must be at least 0, not {}", Number(number));
        return Err(Error::new(Code::OutOfRange, format!("/{name}"), sentence));
    }
    Ok(number)
}

/// A whole number from 0 to 2^53 - 1.
pub(super) fn count(value: &JsValue, name: &str) -> Result<u64, Error> {
    let number = finite(value, name)?;
    if number < 0.0 || number > crate::random::MAX_SEED as f64 || number != number.trunc() {
        let sentence = format!("{name} must be a whole number from 0 to 2^53 - 1, not {}", Number(number));
        return Err(Error::new(Code::OutOfRange, format!("/{name}"), sentence));
    }
    Ok(number as u64)
}

/// A count that saturates: more than this machine can count is beyond every limit too.
pub(super) fn size(value: &JsValue, name: &str) -> Result<usize, Error> {
    count(value, name).map(|count| usize::try_from(count).unwrap_or(usize::MAX))
}

/// A cursor into `length` rows.
pub(super) fn cursor(value: &JsValue, length: usize) -> Result<usize, Error> {
    let row = size(value, "row")?;
    if row > length {
        let sentence = format!("row {row} is beyond the last of {length} rows");
        return Err(Error::new(Code::OutOfRange, "/row", sentence));
    }
    Ok(row)
}

/// A string.
pub(super) fn text(value: &JsValue, name: &str) -> Result<String, Error> {
    value.as_string().ok_or_else(|| wrong(value, name, "a string"))
}

/// The number of a word in a list.
pub(super) fn choice(value: &JsValue, name: &str, words: &[&str]) -> Result<usize, Error> {
    let word = text(value, name)?;
    words.iter().position(|known| *known == word).ok_or_else(|| {
        let sentence = format!("{name} must be one of {}, not {}", words.join(", "), quoted(&word));
        Error::new(Code::OutOfRange, format!("/{name}"), sentence)
    })
}

/// Numbers, finite or not.
pub(super) fn numbers(value: &JsValue, name: &str) -> Result<Vec<f64>, Error> {
    if let Some(numbers) = value.dyn_ref::<Float64Array>() {
        return Ok(numbers.to_vec());
    }
    if let Some(bytes) = value.dyn_ref::<Uint8Array>() {
        return Ok(bytes.to_vec().into_iter().map(f64::from).collect());
    }
    let Some(list) = value.dyn_ref::<Array>() else {
        return Err(wrong(value, name, "an array of numbers"));
    };
    list.iter()
        .enumerate()
        .map(|(i, item)| item.as_f64().ok_or_else(|| wrong(&item, &format!("{name}/{i}"), "a number")))
        .collect()
}

/// Finite numbers in whole rows of `width`.
pub(super) fn rows(value: &JsValue, width: usize, name: &str) -> Result<Vec<f64>, Error> {
    all_finite(whole_rows(numbers(value, name)?, width, name)?, name)
}

/// Numbers that are whole rows of `width`.
pub(super) fn whole_rows(numbers: Vec<f64>, width: usize, name: &str) -> Result<Vec<f64>, Error> {
    if numbers.len().is_multiple_of(width) {
        return Ok(numbers);
    }
    let sentence = format!("{name} must have whole rows of {width} numbers, not {} numbers", numbers.len());
    Err(Error::new(Code::WrongDimension, format!("/{name}"), sentence))
}

/// One row of `width` finite numbers.
pub(super) fn row(value: &JsValue, width: usize, name: &str) -> Result<Vec<f64>, Error> {
    let numbers = numbers(value, name)?;
    if numbers.len() != width {
        let unit = if width == 1 { "number" } else { "numbers" };
        let sentence = format!("{name} must have {width} {unit}, not {}", numbers.len());
        return Err(Error::new(Code::WrongDimension, format!("/{name}"), sentence));
    }
    all_finite(numbers, name)
}

fn all_finite(numbers: Vec<f64>, name: &str) -> Result<Vec<f64>, Error> {
    match numbers.iter().position(|number| !number.is_finite()) {
        Some(i) => finite(&numbers[i].into(), &format!("{name}/{i}")).map(|_| numbers),
        None => Ok(numbers),
    }
}

/// Configurations, one after the other, or an array of arrays; whether the numbers are finite is left to the reader of the rows.
pub(super) fn configurations(value: &JsValue, dimension: usize, name: &str) -> Result<Vec<f64>, Error> {
    let Some(list) = value.dyn_ref::<Array>().filter(|list| list.get(0).is_object()) else {
        return numbers(value, name);
    };
    let mut all = Vec::with_capacity(list.length() as usize * dimension);
    for (i, item) in list.iter().enumerate() {
        all.extend(row(&item, dimension, &format!("{name}/{i}"))?);
    }
    Ok(all)
}

/// A roadmap, as text or as bytes.
pub(super) fn text_or_bytes(value: &JsValue, name: &str) -> Result<Vec<u8>, Error> {
    let sentence = |length| format!("{name} has the length {length}; at most {LONGEST_FILE} is read");
    let error = |length| Error::new(Code::TooLarge, format!("/{name}"), sentence(length));
    let checked = |length| if length > LONGEST_FILE { Err(error(length)) } else { Ok(()) };
    if let Some(bytes) = value.dyn_ref::<Uint8Array>() {
        return checked(bytes.length()).map(|()| bytes.to_vec());
    }
    let Some(text) = value.dyn_ref::<JsString>() else {
        return Err(wrong(value, name, "a string or a Uint8Array"));
    };
    checked(text.length()).map(|()| String::from(text).into_bytes())
}

/// A tree of plain values; `name` is that of the argument, empty for a document or options.
fn tree(value: &JsValue, name: &str) -> Result<Json, Error> {
    if let Some(reason) = value.dyn_ref::<js_sys::Error>() {
        let message = String::from(reason.message());
        let sentence = format!("this object cannot be read: {message}");
        return Err(match place(reason) {
            Some(pointer) if reason.has_type::<RangeError>() => {
                Error::new(Code::TooLarge, format!("{name}{pointer}"), sentence)
            }
            Some(pointer) => Error::new(Code::WrongType, format!("{name}{pointer}"), message),
            None => Error::new(Code::InvalidJson, name, sentence),
        });
    }
    if let Some(numbers) = value.dyn_ref::<Float64Array>() {
        return Ok(numbers.to_vec().into());
    }
    read_tree(Deserializer::from(value.clone())).map_err(|Unread { refusal, pointer, source }| {
        let in_words = |source| match JsValue::from(source).dyn_ref::<js_sys::Error>() {
            Some(reason) => String::from(reason.message()),
            None => "this is no JSON value".to_owned(),
        };
        let (code, sentence) = refusal.unwrap_or_else(|| (Code::InvalidJson, in_words(source)));
        Error::new(code, format!("{name}{pointer}"), sentence)
    })
}

/// A record in an argument, or a list of them.
pub(super) fn records<T: DeserializeOwned>(value: &JsValue, name: &str) -> Result<T, Error> {
    let pointer = format!("/{name}");
    read(&tree(value, &pointer)?).map_err(|error| error.under(&pointer))
}

/// A scenario document as text or as an object.
pub(super) fn document(value: &JsValue) -> Result<Scenario, Error> {
    Scenario::read(&document_tree(value, "a scenario")?)
}

/// A document as text or as an object.
pub(super) fn document_tree(value: &JsValue, what: &str) -> Result<Json, Error> {
    if let Some(text) = value.dyn_ref::<JsString>() {
        let length = text.length();
        let error = || {
            Error::new(Code::TooLarge, "", format!("the text has {length} characters; at most {LONGEST_TEXT} are read"))
        };
        return if length > LONGEST_TEXT { Err(error()) } else { parse(&String::from(text)) };
    }
    if !value.is_object() || ArrayBuffer::is_view(value) {
        let sentence = format!("{what} is a string or an object with the fields of a document, not {}", show(value));
        return Err(Error::new(Code::WrongType, "", sentence));
    }
    tree(value, "")
}

/// Options by their names in documents.
pub(super) struct Fields(Map<String, Json>);

/// The fields of an object of options, none if it is absent: named in camelCase in JavaScript, in snake_case in the core.
pub(super) fn fields(value: Option<impl AsRef<JsValue>>) -> Result<Fields, Error> {
    fields_named(value, "options")
}

/// The same of an argument with another name.
pub(super) fn fields_named(value: Option<impl AsRef<JsValue>>, argument: &str) -> Result<Fields, Error> {
    let Some(value) = value else { return Ok(Fields(Map::new())) };
    let value = value.as_ref();
    let is_list = Array::is_array(value) || ArrayBuffer::is_view(value);
    let Json::Object(given) = (if value.is_object() && !is_list { tree(value, "")? } else { Json::Null }) else {
        return Err(Error::new(Code::WrongType, "", format!("{argument} must be an object, not {}", show(value))));
    };
    let mut fields = Map::new();
    for (name, value) in given {
        if name.contains('_') {
            let [camel, name] = [in_camel_case(&name), name];
            let sentence = format!("{argument} are named in camelCase in JavaScript: {camel}, not {}", quoted(&name));
            return Err(refusal(Code::UnknownParameter, &name, sentence));
        }
        let snake = name.chars().fold(String::new(), |mut snake, letter| {
            if letter.is_ascii_uppercase() {
                snake.push('_');
            }
            snake.push(letter.to_ascii_lowercase());
            snake
        });
        fields.insert(snake, value);
    }
    Ok(Fields(fields))
}

impl Fields {
    /// Removes the field and reads it, if present.
    pub fn take<T: DeserializeOwned>(&mut self, name: &str) -> Result<Option<T>, Error> {
        let value = self.0.remove(name);
        value.map(|value| read(&value)).transpose().map_err(|error| error.under(&format!("/{name}")))
    }

    /// Removes a field that must be present.
    pub fn required<T: DeserializeOwned>(&mut self, name: &str, meaning: &str) -> Result<T, Error> {
        let missing = || Error::new(Code::MissingField, format!("/{name}"), format!("{name} is missing: {meaning}"));
        self.take(name)?.ok_or_else(missing)
    }

    /// Planner, query, seed and events of a run, and the remaining fields as parameters.
    pub fn request(mut self) -> Result<Request, Error> {
        Ok(Request {
            planner: self.take("algorithm")?,
            query: self.take("query")?,
            seed: self.take("seed")?.unwrap_or(0),
            events: self.take("events")?.unwrap_or(true),
            parameters: self.parameters(),
        })
    }

    /// The remaining fields as parameters by name.
    pub fn parameters(self) -> Vec<(String, Value)> {
        let pair = |(name, value): (String, Json)| (name, Value::from(&value));
        self.0.into_iter().map(pair).collect()
    }

    /// Refuses the remaining fields.
    pub fn finish(self, known: &str) -> Result<(), Error> {
        let Some((name, _)) = self.0.into_iter().next() else { return Ok(()) };
        let sentence = format!("unknown option {}; known options are {known}", quoted(&name));
        Err(refusal(Code::UnknownField, &name, sentence))
    }

    /// The remaining fields as an object.
    pub fn object(self) -> Json {
        Json::Object(self.0)
    }
}
