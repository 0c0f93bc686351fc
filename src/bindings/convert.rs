//! Between JavaScript's values and ours.

use crate::decimal::Decimal;
use crate::error::{Code, Error};
use crate::geometry::Point;
use crate::json::Node;
use crate::reach::{ReachOptions, Target};
use crate::run::{Options, Value};
use wasm_bindgen::prelude::*;

/// The JavaScript error for ours: an `Error` with `code` and `pointer`.
pub(super) fn throw(error: Error) -> JsValue {
    let thrown = JsValue::from(js_sys::Error::new(error.message()));
    for (key, value) in [("code", error.code().as_str()), ("pointer", error.pointer())] {
        // Setting a property of a fresh object cannot fail.
        let _ = js_sys::Reflect::set(&thrown, &key.into(), &value.into());
    }
    thrown
}

/// A whole number from 0 to 2^53 - 1.
pub(super) fn count(value: f64, name: &str) -> Result<u64, Error> {
    if value >= 0.0 && value <= crate::random::MAX_SEED as f64 && value == value.trunc() {
        return Ok(value as u64);
    }
    let code = if value.is_finite() { Code::OutOfRange } else { Code::NotFinite };
    let sentence = format!("{name} must be a whole number from 0 to 2^53 - 1, not {}", Decimal(value));
    Err(Error::new(code, format!("/{name}"), sentence))
}

/// A cursor into `length` rows.
pub(super) fn cursor(value: f64, length: usize) -> Result<usize, JsValue> {
    let row = count(value, "row").map_err(throw)?;
    if row > length as u64 {
        let sentence = format!("row {row} lies behind the last of {length} rows");
        return Err(throw(Error::new(Code::OutOfRange, "/row", sentence)));
    }
    Ok(row as usize)
}

/// The fields of an object in JSON text.
fn fields(text: &str) -> Result<Vec<(String, Node)>, Error> {
    match Node::parse(text)? {
        Node::Object(fields) => Ok(fields),
        _ => Err(Error::new(Code::WrongType, "", "options must be an object")),
    }
}

/// Refuses an option of the wrong type.
fn wrong<T>(name: &str, what: &str) -> Result<T, Error> {
    Err(Error::new(Code::WrongType, format!("/{name}"), format!("{name} must be {what}")))
}

/// The value of a parameter.
fn value(name: &str, given: Node) -> Result<Value, Error> {
    match given {
        Node::Number(number) => Ok(Value::Number(number)),
        Node::String(text) => Ok(Value::Text(text)),
        Node::Bool(yes) => Ok(Value::Boolean(yes)),
        _ => wrong(name, "a number, a word or a truth value"),
    }
}

/// The id of an index, if any, and its parameters.
type IndexOptions = (Option<String>, Vec<(String, Value)>);

/// What index is wanted, from JSON text.
pub(super) fn index_options(text: &str) -> Result<IndexOptions, Error> {
    let (mut id, mut parameters) = (None, Vec::new());
    for (name, given) in fields(text)? {
        match (name.as_str(), given) {
            ("index", Node::String(word)) => id = Some(word),
            ("index", _) => return wrong("index", "a string"),
            (_, given) => {
                let value = value(&name, given)?;
                parameters.push((name, value));
            }
        }
    }
    Ok((id, parameters))
}

/// The options of a run from JSON text, beginning with the defaults.
pub(super) fn options(text: &str, mut wanted: Options) -> Result<Options, Error> {
    for (name, given) in fields(text)? {
        match (name.as_str(), given) {
            ("algorithm", Node::String(id)) => wanted.planner = Some(id),
            ("query", Node::String(query)) => wanted.query = Some(query),
            ("seed", Node::Number(seed)) => wanted.seed = count(seed, &name)?,
            ("algorithm" | "query", _) => return wrong(&name, "a string"),
            ("seed", _) => return wrong("seed", "a number"),
            (_, given) => {
                let value = value(&name, given)?;
                wanted.parameters.push((name, value));
            }
        }
    }
    Ok(wanted)
}

/// Settings of a table and the seed, 0 where there is none, from JSON text.
pub(super) fn settings(text: &str) -> Result<(Vec<(String, Value)>, u64), Error> {
    let Node::Object(fields) = Node::parse(text)? else {
        return Err(Error::new(Code::WrongType, "", "options must be an object"));
    };
    let (mut given, mut seed) = (Vec::with_capacity(fields.len()), 0);
    for (name, node) in fields {
        let value = match node {
            Node::Number(number) if name == "seed" => {
                seed = count(number, &name)?;
                continue;
            }
            Node::Number(number) => Value::Number(number),
            Node::String(text) => Value::Text(text),
            Node::Bool(yes) => Value::Boolean(yes),
            _ => {
                let sentence = format!("{name} must be a number, a word or a truth value");
                return Err(Error::new(Code::WrongType, format!("/{name}"), sentence));
            }
        };
        if name == "seed" {
            return Err(Error::new(Code::WrongType, "/seed", "seed must be a number"));
        }
        given.push((name, value));
    }
    Ok((given, seed))
}

/// The options of inverse kinematics from JSON text.
pub(super) fn reach_options(text: &str) -> Result<ReachOptions, Error> {
    let Node::Object(fields) = Node::parse(text)? else {
        return Err(Error::new(Code::WrongType, "", "options must be an object"));
    };
    let mut wanted = ReachOptions::to(Target { point: Point::origin(), orientation: None });
    let mut has_target = false;
    for (name, given) in fields {
        let fail = |what: &str| Err(Error::new(Code::WrongType, format!("/{name}"), format!("{name} must be {what}")));
        match (name.as_str(), given) {
            ("target", Node::Array(point)) => match numbers(&point, &name)?[..] {
                [x, y] => (wanted.target.point, has_target) = (Point::new(x, y), true),
                _ => return Err(Error::new(Code::WrongDimension, "/target", "target must hold two numbers, x and y")),
            },
            ("orientation", Node::Number(angle)) => wanted.target.orientation = Some(angle),
            ("start", Node::Array(start)) => wanted.start = Some(numbers(&start, &name)?),
            ("method", Node::String(id)) => wanted.method = Some(id),
            ("seed", Node::Number(seed)) => wanted.seed = count(seed, &name)?,
            ("target" | "start", _) => return fail("an array of numbers"),
            ("orientation" | "seed", _) => return fail("a number"),
            ("method", _) => return fail("a string"),
            (_, Node::Number(number)) => wanted.parameters.push((name, Value::Number(number))),
            (_, Node::String(text)) => wanted.parameters.push((name, Value::Text(text))),
            (_, Node::Bool(yes)) => wanted.parameters.push((name, Value::Boolean(yes))),
            _ => return fail("a number, a word or a truth value"),
        }
    }
    if !has_target {
        return Err(Error::new(Code::MissingField, "/target", "the target is missing: [x, y]"));
    }
    Ok(wanted)
}

/// An array of numbers.
fn numbers(nodes: &[Node], name: &str) -> Result<Vec<f64>, Error> {
    let number = |(i, node): (usize, &Node)| match node {
        Node::Number(number) => Ok(*number),
        _ => Err(Error::new(Code::WrongType, format!("/{name}/{i}"), format!("{name} must hold numbers"))),
    };
    nodes.iter().enumerate().map(number).collect()
}
