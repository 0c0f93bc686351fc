//! Values of options given by name, and the refusal of those that an option does not take.

use super::Kind;
use crate::error::{Code, Error, quoted};

/// A value given for an option.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A word.
    Text(String),
    /// Yes or no.
    Boolean(bool),
    /// A value that no option takes, by its kind.
    Other(&'static str),
}

impl Value {
    /// The value of a text: a number if it can be parsed as one, true or false, else a word.
    pub fn from_text(text: &str) -> Self {
        match text {
            "true" => Value::Boolean(true),
            "false" => Value::Boolean(false),
            _ => text.parse().map_or_else(|_| Value::Text(text.to_owned()), Value::Number),
        }
    }
}

impl From<&serde_json::Value> for Value {
    fn from(value: &serde_json::Value) -> Self {
        match value {
            serde_json::Value::Number(number) => Value::Number(number.as_f64().unwrap_or(f64::NAN)),
            serde_json::Value::String(text) => Value::Text(text.clone()),
            serde_json::Value::Bool(yes) => Value::Boolean(*yes),
            serde_json::Value::Null => Value::Other("null"),
            serde_json::Value::Array(_) => Value::Other("an array"),
            serde_json::Value::Object(_) => Value::Other("an object"),
        }
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Value::Number(number) => write!(f, "{number}"),
            Value::Text(text) => f.write_str(&quoted(text)),
            Value::Boolean(yes) => write!(f, "{yes}"),
            Value::Other(what) => f.write_str(what),
        }
    }
}

/// An error about the option of this name.
pub fn refusal(code: Code, name: &str, sentence: impl Into<String>) -> Error {
    // As in a JSON pointer.
    let name = name.replace('~', "~0").replace('/', "~1");
    Error::new(code, format!("/{name}"), sentence)
}

/// The error `out-of-range` about the option of this name.
pub fn out_of_range(name: &str, sentence: impl Into<String>) -> Error {
    refusal(Code::OutOfRange, name, sentence)
}

/// Refuses a value that is not of this kind.
pub(super) fn check(name: &str, kind: &Kind, value: &Value) -> Result<(), Error> {
    let fail = |code, what: String| Err(refusal(code, name, format!("{name} must {what}, not {value}")));
    match (kind, value) {
        (Kind::Integer(_) | Kind::Number(_), Value::Number(number)) if !number.is_finite() => {
            fail(Code::NotFinite, "be a finite number".to_owned())
        }
        (Kind::Integer(_), Value::Number(number)) if *number != libm::trunc(*number) => {
            fail(Code::OutOfRange, "be a whole number".to_owned())
        }
        (Kind::Integer(range) | Kind::Number(range), Value::Number(number)) if !range.contains(number) => {
            fail(Code::OutOfRange, format!("lie within [{}, {}]", range.start(), range.end()))
        }
        (Kind::Choice(words), Value::Text(text)) if !words.contains(&text.as_str()) => {
            fail(Code::OutOfRange, format!("be one of {}", words.join(", ")))
        }
        (Kind::Integer(_) | Kind::Number(_), Value::Number(_))
        | (Kind::Switch, Value::Boolean(_))
        | (Kind::Choice(_), Value::Text(_)) => Ok(()),
        (Kind::Integer(_) | Kind::Number(_), _) => fail(Code::WrongType, "be a number".to_owned()),
        (Kind::Switch, _) => fail(Code::WrongType, "be true or false".to_owned()),
        (Kind::Choice(words), _) => fail(Code::WrongType, format!("be one of {}", words.join(", "))),
    }
}
