//! The types of fields and of structs of options: how they are read by name, listed and checked.

use super::value::{Value, check, refusal};
use super::{ANY, Kind, OptionInfo, Range};
use crate::error::{Code, Error, quoted};
use std::any::Any;
use std::str::FromStr;

/// Values given by name, while a struct of options is read from them.
pub struct Given<'a> {
    given: &'a [(String, Value)],
    known: Vec<&'static str>,
    /// The first refusal, by the position of the value that was given.
    refused: Option<(usize, Error)>,
}

impl Given<'_> {
    fn refuse(&mut self, at: usize, error: Error) {
        if self.refused.as_ref().is_none_or(|(earlier, _)| at < *earlier) {
            self.refused = Some((at, error));
        }
    }

    /// Reads the option of this name; `default`, which must be in range as well, if it is not given.
    fn read<T: Single>(&mut self, name: &'static str, range: &Range, default: Option<T>) -> Option<T> {
        self.known.push(name);
        let (at, value) = match self.given.iter().position(|(given, _)| given == name) {
            Some(at) => (at, self.given[at].1.clone()),
            None => (usize::MAX, default?.to_value()),
        };
        if let Err(error) = check(name, &T::kind(range), &value) {
            self.refuse(at, error);
        }
        T::from_value(&value)
    }

    /// Refuses names that are not known or given twice; `others` are known elsewhere.
    fn finish(mut self, others: &[&'static str]) -> Result<(), Error> {
        for (at, (name, _)) in self.given.iter().enumerate() {
            if !self.known.contains(&name.as_str()) {
                let known = [&self.known, others].concat().join(", ");
                let sentence = format!("unknown option {}; known options are {known}", quoted(name));
                self.refuse(at, refusal(Code::UnknownParameter, name, sentence));
            } else if self.given[..at].iter().any(|(earlier, _)| earlier == name) {
                self.refuse(at, refusal(Code::DuplicateField, name, format!("{name} is given twice")));
            }
        }
        self.refused.map_or(Ok(()), |(_, error)| Err(error))
    }
}

/// The type of a field: a value, a value that may be left out, or a group of options.
pub trait Field: Sized + 'static {
    /// Adds the rows of the field to a table; `row` is the declaration, without kind and default.
    fn rows(self, row: OptionInfo, range: &Range, table: &mut Vec<OptionInfo>);

    /// Reads the field; its present value if it is not given.
    fn take(self, name: &'static str, range: &Range, given: &mut Given) -> Self;

    /// Visits the single values of the field in order: the name, the robots that it is for, and the value if there is one.
    fn visit(self, name: &'static str, robots: &'static [&'static str], visitor: &mut Visitor);

    /// The group of this type: the field itself, or one that it contains.
    fn group<G: 'static>(&self) -> Option<&G> {
        (self as &dyn Any).downcast_ref()
    }
}

/// Is given the name of an option, the robots that it is for, and its value if it has one.
pub type Visitor<'a> = dyn FnMut(&'static str, &'static [&'static str], Option<Value>) + 'a;

/// A struct of options, as `options!` declares it.
pub trait Options: Field + Default + Copy {
    /// The robots that they are for, by their types in documents; empty if there is no robot.
    const ROBOTS: &'static [&'static str];

    /// The table of its options.
    fn table() -> Vec<OptionInfo> {
        let mut table = Vec::new();
        Self::default().rows(OptionInfo::default(), &ANY, &mut table);
        table
    }

    /// Reads the values given by name; the rest take their defaults.
    ///
    /// # Errors
    /// `unknown-parameter`, `duplicate-field`, `wrong-type`, `not-finite` or `out-of-range`, with the pointer `/name`.
    fn read(given: &[(String, Value)]) -> Result<Self, Error> {
        Self::default().updated(given)
    }

    /// The same; a refusal of a name says that `others` are known as well: options that are read elsewhere.
    ///
    /// # Errors
    /// As [`Options::read`].
    fn read_among(given: &[(String, Value)], others: &[&'static str]) -> Result<Self, Error> {
        let mut given = Given { given, known: Vec::new(), refused: None };
        let options = Self::default().take("", &ANY, &mut given);
        given.finish(others).map(|()| options)
    }

    /// The names of its options, in order. Unlike the table, they bring no texts along.
    fn names() -> Vec<&'static str> {
        let mut names = Vec::new();
        Self::default().visit("", Self::ROBOTS, &mut |name, _, _| names.push(name));
        names
    }

    /// Whether there is an option of this name.
    fn has(name: &str) -> bool {
        Self::names().contains(&name)
    }

    /// The options that differ from their defaults: their names, the robots that they are for, and their values.
    fn changes(self) -> Vec<Change> {
        let (mut standard, mut changes) = (Vec::new(), Vec::new());
        Self::default().visit("", Self::ROBOTS, &mut |_, _, value| standard.push(value));
        let mut standard = standard.into_iter();
        self.visit("", Self::ROBOTS, &mut |name, robots, value| {
            let before = standard.next().flatten();
            if let Some(value) = value.filter(|value| before.as_ref() != Some(value)) {
                changes.push(Change { name, robots, value });
            }
        });
        changes
    }

    /// Refuses values out of range, of options that were not read.
    ///
    /// # Errors
    /// `not-finite` or `out-of-range`, with the pointer `/name`.
    fn check(&self) -> Result<(), Error> {
        self.updated(&[]).map(|_| ())
    }

    /// These options with the values given by name; all must be in range.
    ///
    /// # Errors
    /// As [`Options::read`].
    fn updated(self, given: &[(String, Value)]) -> Result<Self, Error> {
        let mut given = Given { given, known: Vec::new(), refused: None };
        let options = self.take("", &ANY, &mut given);
        given.finish(&[]).map(|()| options)
    }
}

/// An option that differs from its default.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// Its name.
    pub name: &'static str,
    /// The types of robots that it is for.
    pub robots: &'static [&'static str],
    /// Its value.
    pub value: Value,
}

/// The type of a single value.
pub trait Single: Copy + 'static {
    /// The values that it takes.
    fn kind(range: &Range) -> Kind;

    /// From a value of that kind.
    fn from_value(value: &Value) -> Option<Self>;

    /// As a value.
    fn to_value(self) -> Value;
}

/// A choice of a few words: the kebab-case names of an enum's variants.
pub trait Choice: Copy + 'static + FromStr + Into<&'static str> + strum::VariantNames {
    /// Its word.
    fn word(self) -> &'static str {
        self.into()
    }
}

impl<T: Choice> Single for T {
    fn kind(_: &Range) -> Kind {
        Kind::Choice(T::VARIANTS)
    }

    fn from_value(value: &Value) -> Option<Self> {
        if let Value::Text(word) = value { word.parse().ok() } else { None }
    }

    fn to_value(self) -> Value {
        Value::Text(self.word().to_owned())
    }
}

impl Single for bool {
    fn kind(_: &Range) -> Kind {
        Kind::Switch
    }

    fn from_value(value: &Value) -> Option<Self> {
        if let Value::Boolean(yes) = value { Some(*yes) } else { None }
    }

    fn to_value(self) -> Value {
        Value::Boolean(self)
    }
}

/// The numbers. A negative zero reads as zero.
macro_rules! numbers {
    ($($Type:ty: $Kind:ident),*) => { $(
        impl Single for $Type {
            fn kind(range: &Range) -> Kind {
                Kind::$Kind(range.clone())
            }

            fn from_value(value: &Value) -> Option<Self> {
                if let Value::Number(number) = value { Some((*number + 0.0) as $Type) } else { None }
            }

            fn to_value(self) -> Value {
                Value::Number(self as f64)
            }
        }
    )* };
}

numbers!(u32: Integer, u64: Integer, usize: Integer, f64: Number);

impl<T: Single> Field for T {
    fn rows(self, row: OptionInfo, range: &Range, table: &mut Vec<OptionInfo>) {
        add_row::<T>(OptionInfo { default: Some(self.to_value()), ..row }, range, table);
    }

    fn take(self, name: &'static str, range: &Range, given: &mut Given) -> Self {
        given.read(name, range, Some(self)).unwrap_or(self)
    }

    fn visit(self, name: &'static str, robots: &'static [&'static str], visitor: &mut Visitor) {
        visitor(name, robots, Some(self.to_value()));
    }
}

impl<T: Single> Field for Option<T> {
    fn rows(self, row: OptionInfo, range: &Range, table: &mut Vec<OptionInfo>) {
        add_row::<T>(row, range, table);
    }

    fn take(self, name: &'static str, range: &Range, given: &mut Given) -> Self {
        given.read(name, range, self)
    }

    fn visit(self, name: &'static str, robots: &'static [&'static str], visitor: &mut Visitor) {
        visitor(name, robots, self.map(Single::to_value));
    }
}

/// Adds the row of a field, unless it has no title.
fn add_row<T: Single>(row: OptionInfo, range: &Range, table: &mut Vec<OptionInfo>) {
    if !row.title.is_empty() {
        table.push(OptionInfo { kind: T::kind(range), ..row });
    }
}
