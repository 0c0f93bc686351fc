//! Parameters of planners and of other methods: their tables, and values checked against them.

use crate::decimal::Decimal;
use crate::error::{Code, Error, quoted};
use crate::json::{Node, push_field};

/// What values a parameter takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A whole number from `min` to `max`.
    Integer {
        /// The least value.
        min: f64,
        /// The greatest value.
        max: f64,
    },
    /// A finite number from `min` to `max`.
    Number {
        /// The least value.
        min: f64,
        /// The greatest value.
        max: f64,
    },
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// True or false.
    Switch,
}

/// What a parameter is when it is not given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fallback {
    /// This number.
    Number(f64),
    /// This word.
    Text(&'static str),
    /// False: switches are off unless they are turned on.
    Off,
    /// What depends on the rest, told in words.
    Computed(&'static str),
}

/// One row of a table of parameters: what controls, help texts and checks are made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterInfo {
    /// The name, in snake_case, the same everywhere.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// Type and range.
    pub kind: Kind,
    /// The unit; empty for counts and words.
    pub unit: &'static str,
    /// The default.
    pub default: Fallback,
    /// What it means, in one sentence.
    pub meaning: &'static str,
    /// The types of robots that it is for, as in documents; of others it says nothing. Empty where there is no robot.
    pub robots: &'static [&'static str],
}

impl ParameterInfo {
    /// The row as a tree: a default that depends on the rest is null and told in words.
    pub fn node(&self) -> Node {
        let (kind, range, choices) = match self.kind {
            Kind::Integer { min, max } => ("integer", Some([min, max]), None),
            Kind::Number { min, max } => ("number", Some([min, max]), None),
            Kind::Choice(words) => ("choice", None, Some(words)),
            Kind::Switch => ("boolean", None, None),
        };
        let (default, meaning) = match self.default {
            Fallback::Number(number) => (Node::Number(number), None),
            Fallback::Text(word) => (Node::text(word), None),
            Fallback::Off => (Node::Bool(false), None),
            Fallback::Computed(words) => (Node::Null, Some(words)),
        };
        let or_null = |node: Option<Node>| Some(node.unwrap_or(Node::Null));
        Node::object(vec![
            ("name", Some(Node::text(self.name))),
            ("title", Some(Node::text(self.title))),
            ("kind", Some(Node::text(kind))),
            ("unit", Some(Node::text(self.unit))),
            ("min", or_null(range.map(|[min, _]| Node::Number(min)))),
            ("max", or_null(range.map(|[_, max]| Node::Number(max)))),
            ("choices", or_null(choices.map(Node::words))),
            ("default", Some(default)),
            ("default_meaning", or_null(meaning.map(Node::text))),
            ("meaning", Some(Node::text(self.meaning))),
            ("robots", Some(Node::words(self.robots))),
        ])
    }
}

/// A value given for a parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A word.
    Text(String),
    /// Yes or no.
    Boolean(bool),
}

impl Value {
    /// The value that a text stands for: a number where it reads as one, true or false, else a word.
    pub fn from_text(text: &str) -> Self {
        match text {
            "true" => Value::Boolean(true),
            "false" => Value::Boolean(false),
            _ => text.parse().map_or_else(|_| Value::Text(text.to_owned()), Value::Number),
        }
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Value::Number(number) => write!(f, "{}", Decimal(*number)),
            Value::Text(text) => f.write_str(&quoted(text)),
            Value::Boolean(yes) => write!(f, "{yes}"),
        }
    }
}

/// Values for every parameter of one table: those given, checked, and the defaults for the rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters {
    /// Name, value, whether it was given.
    values: Vec<(&'static str, Option<Value>, bool)>,
}

impl Parameters {
    /// Checks the given values against the table.
    ///
    /// # Errors
    /// `unknown-parameter`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name`.
    pub fn resolve(table: &[ParameterInfo], given: &[(String, Value)]) -> Result<Self, Error> {
        let default = |info: &ParameterInfo| match info.default {
            Fallback::Number(number) => Some(Value::Number(number)),
            Fallback::Text(word) => Some(Value::Text(word.to_owned())),
            Fallback::Off => Some(Value::Boolean(false)),
            Fallback::Computed(_) => None,
        };
        let mut values: Vec<_> = table.iter().map(|info| (info.name, default(info), false)).collect();
        for (i, (name, value)) in given.iter().enumerate() {
            let Some(at) = table.iter().position(|info| info.name == name) else {
                let known = table.iter().map(|info| info.name).collect::<Vec<_>>().join(", ");
                let sentence = format!("there is no parameter {}; there are {known}", quoted(name));
                return Err(Error::new(Code::UnknownParameter, pointer(name), sentence));
            };
            if given[..i].iter().any(|(earlier, _)| earlier == name) {
                return Err(Error::new(Code::DuplicateField, pointer(name), format!("{name} is given twice")));
            }
            check(&table[at], value)?;
            (values[at].1, values[at].2) = (Some(value.clone()), true);
        }
        Ok(Self { values })
    }

    /// Whether the table has a parameter of that name.
    pub fn has(&self, name: &str) -> bool {
        self.values.iter().any(|(known, ..)| *known == name)
    }

    /// The number given for the parameter, or its default; `None` where the default depends on the space.
    ///
    /// # Panics
    /// Where the table has no such parameter, or it is not a number.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.get(name) {
            Some(Value::Number(number)) => Some(*number),
            None => None,
            Some(other) => unreachable!("{name} is not a number but {other}"),
        }
    }

    /// The whole number given for the parameter, or its default.
    ///
    /// # Panics
    /// Where the table has no such parameter, it is not a number, or its default depends on the space.
    pub fn integer(&self, name: &str) -> u64 {
        self.number(name).expect("counts have fixed defaults") as u64
    }

    /// The word given for the parameter, or its default; `None` where that depends on the space, or the table has no such
    /// parameter.
    ///
    /// # Panics
    /// Where it is not a choice.
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.values.iter().find(|(known, ..)| *known == name)?.1.as_ref() {
            Some(Value::Text(text)) => Some(text),
            None => None,
            Some(other) => unreachable!("{name} is not a word but {other}"),
        }
    }

    /// Whether the switch is on.
    ///
    /// # Panics
    /// Where the table has no such parameter, or it is not a switch.
    pub fn is_on(&self, name: &str) -> bool {
        match self.get(name) {
            Some(Value::Boolean(on)) => *on,
            _ => unreachable!("{name} is not a switch"),
        }
    }

    /// Whether a value was given for the parameter; false where the table has none of that name.
    pub fn is_given(&self, name: &str) -> bool {
        self.values.iter().any(|(known, _, given)| *known == name && *given)
    }

    fn get(&self, name: &str) -> Option<&Value> {
        let found = self.values.iter().find(|(known, ..)| *known == name);
        found.unwrap_or_else(|| unreachable!("no parameter {name}")).1.as_ref()
    }
}

/// The JSON pointer of a field at the top.
fn pointer(name: &str) -> String {
    let mut pointer = String::new();
    push_field(&mut pointer, name);
    pointer
}

/// Refuses a value that the row does not allow.
fn check(info: &ParameterInfo, value: &Value) -> Result<(), Error> {
    let name = info.name;
    let fail = |code, sentence: String| Err(Error::new(code, pointer(name), sentence));
    match (info.kind, value) {
        (Kind::Integer { min, max } | Kind::Number { min, max }, Value::Number(number)) => {
            if !number.is_finite() {
                return fail(Code::NotFinite, format!("{name} must be a finite number, not {value}"));
            }
            if matches!(info.kind, Kind::Integer { .. }) && *number != libm::trunc(*number) {
                return fail(Code::OutOfRange, format!("{name} must be a whole number, not {value}"));
            }
            if !(min..=max).contains(number) {
                let [min, max] = [min, max].map(Decimal);
                return fail(Code::OutOfRange, format!("{name} must lie within [{min}, {max}], not {value}"));
            }
            Ok(())
        }
        (Kind::Integer { .. } | Kind::Number { .. }, _) => {
            fail(Code::WrongType, format!("{name} must be a number, not {value}"))
        }
        (Kind::Switch, Value::Boolean(_)) => Ok(()),
        (Kind::Switch, _) => fail(Code::WrongType, format!("{name} must be true or false, not {value}")),
        (Kind::Choice(words), Value::Text(text)) if words.contains(&text.as_str()) => Ok(()),
        (Kind::Choice(words), _) => {
            let code = if matches!(value, Value::Text(_)) { Code::OutOfRange } else { Code::WrongType };
            fail(code, format!("{name} must be one of {}, not {value}", words.join(", ")))
        }
    }
}
