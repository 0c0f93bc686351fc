//! Options of planners, generators and other methods: a typed struct and its table in one declaration.
//!
//! `options!` declares a struct whose fields are options. Each field is given by its type, its default, its
//! range, its title and, as its documentation, its meaning. From that follow the struct itself, its defaults, reading
//! values by name ([`Options::read`]) and the table that help texts and controls are made from ([`Options::table`]). A field
//! whose type is another such struct contributes all options of it: a group that several tables share. Reading values
//! does not depend on the texts of a table.

use crate::error::{Code, Error, quoted};
use std::any::Any;
use std::str::FromStr;

/// The range of an option that is a number; of no meaning for others.
pub type Range = std::ops::RangeInclusive<f64>;

/// Every number.
pub const ANY: Range = f64::NEG_INFINITY..=f64::INFINITY;

/// Every robot, by its type in documents.
pub const ALL: &[&str] = &["arm", "disc", "rigid_body", "car"];

/// The robot that is moved by controls.
pub const CAR: &[&str] = &["car"];

/// The robots whose motions are straight in their coordinates.
pub const STRAIGHT: &[&str] = &["arm", "disc", "rigid_body"];

/// The values that an option takes.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Kind {
    /// A whole number within the range.
    Integer(Range),
    /// A finite number within the range.
    Number(Range),
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// True or false.
    #[default]
    Switch,
}

/// One row of a table of options.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OptionInfo {
    /// The name, in snake_case, the same everywhere.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// Type and range.
    pub kind: Kind,
    /// The unit; empty for counts and words.
    pub unit: &'static str,
    /// The default; `None` if it depends on the rest.
    pub default: Option<Value>,
    /// The default in words if it depends on the rest.
    pub computed: &'static str,
    /// Its meaning, in one sentence.
    pub meaning: String,
    /// The types of robots that it is for, as in documents; others have no use for it, and may refuse it. Empty if there is no
    /// robot.
    pub robots: &'static [&'static str],
}

/// The description of a method or a generator.
#[derive(Debug, Clone, PartialEq)]
pub struct Info {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The title for people.
    pub title: &'static str,
    /// A summary, in one sentence.
    pub summary: &'static str,
    /// Its options; a generator takes `seed` as well, a whole number from 0 (default) to 2^53 - 1.
    pub options: Vec<OptionInfo>,
}

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

/// Whether an option or a planner with these robots is for a robot of this type. Those of all robots are for robots of other
/// types too.
pub fn is_for(robots: &[&str], robot: &str) -> bool {
    robots == ALL || robots.contains(&robot)
}

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

/// The name of an option in JavaScript.
pub(crate) fn in_camel_case(name: &str) -> String {
    let mut letters = name.chars();
    let mut camel = String::new();
    while let Some(letter) = letters.next() {
        match letter {
            '_' => camel.extend(letters.next().map(|letter| letter.to_ascii_uppercase())),
            _ => camel.push(letter),
        }
    }
    camel
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
fn check(name: &str, kind: &Kind, value: &Value) -> Result<(), Error> {
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

/// Declares a struct of options. A field is
/// `name: Type = default, in range, "Title", unit "unit", else "a default that depends on the rest", for ROBOTS;`
/// in which all but name and type may be left out: a type `Option<T>` has the default `None`, a group its own. `for ROBOTS`
/// after the name of the struct holds for all fields that name none. A field without a title is read, but in no table.
#[macro_export]
#[doc(hidden)]
macro_rules! options {
    (
        $(#[$attribute:meta])*
        pub struct $Name:ident for $all:expr;
        $(
            $(#[doc = $doc:literal])+
            $field:ident : $Type:ty
            $(= $default:expr)? $(, in $range:expr)? $(, $title:literal)? $(, unit $unit:literal)? $(, else $computed:literal)?
            $(, for $robots:expr)? ;
        )*
    ) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $Name {
            $( $(#[doc = $doc])+ pub $field: $Type, )*
        }

        impl Default for $Name {
            #[allow(unused_assignments, unused_mut)]
            fn default() -> Self {
                Self { $( $field: $crate::options!(@or (Default::default()) $($default)?), )* }
            }
        }

        impl $crate::options::Field for $Name {
            fn rows(self, _: $crate::options::OptionInfo, _: &$crate::options::Range, table: &mut Vec<$crate::options::OptionInfo>) {
                $(
                    let row = $crate::options::OptionInfo {
                        name: stringify!($field),
                        title: $crate::options!(@or ("") $($title)?),
                        unit: $crate::options!(@or ("") $($unit)?),
                        meaning: [$($doc.trim()),+].join(" "),
                        computed: $crate::options!(@or ("") $($computed)?),
                        robots: $crate::options!(@or ($all) $($robots)?),
                        ..Default::default()
                    };
                    let range = &$crate::options!(@or ($crate::options::ANY) $($range)?);
                    $crate::options::Field::rows(self.$field, row, range, table);
                )*
            }

            fn take(self, _: &'static str, _: &$crate::options::Range, given: &mut $crate::options::Given) -> Self {
                Self { $( $field: {
                    let range = &$crate::options!(@or ($crate::options::ANY) $($range)?);
                    $crate::options::Field::take(self.$field, stringify!($field), range, given)
                }, )* }
            }

            fn visit(self, _: &'static str, _: &'static [&'static str], visitor: &mut $crate::options::Visitor) {
                $(
                    let robots = $crate::options!(@or ($all) $($robots)?);
                    $crate::options::Field::visit(self.$field, stringify!($field), robots, visitor);
                )*
            }

            fn group<G: 'static>(&self) -> Option<&G> {
                let found = (self as &dyn std::any::Any).downcast_ref();
                $( let found = found.or_else(|| $crate::options::Field::group(&self.$field)); )*
                found
            }
        }

        impl $crate::options::Options for $Name {
            const ROBOTS: &'static [&'static str] = $all;
        }
    };
    (@or ($other:expr)) => { $other };
    (@or ($other:expr) $given:expr) => { $given };
}

/// Declares an enum whose variants are the words of a choice, in kebab-case.
#[macro_export]
#[doc(hidden)]
macro_rules! choice {
    ($(#[$attribute:meta])* pub enum $Name:ident { $($body:tt)* }) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr, strum::VariantNames)]
        #[strum(serialize_all = "kebab-case")]
        pub enum $Name { $($body)* }

        impl $crate::options::Choice for $Name {}
    };
}
