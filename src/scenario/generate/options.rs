//! The options of a generator: the rows that help texts, documents and controls are made from, and values checked
//! against them. Every generator also takes `seed`, which has no row, like the seed of a run.

use crate::decimal::Decimal;
use crate::error::{Code, Error, quoted};
use crate::random::MAX_SEED;
use crate::scenario::reader::{Fields, Reader};

/// What values an option takes, and the one taken where none is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OptionKind {
    /// A whole number from `min` to `max`.
    Integer {
        /// The least value.
        min: f64,
        /// The greatest value.
        max: f64,
        /// The default.
        default: f64,
    },
    /// A finite number from `min` to `max`.
    Number {
        /// The least value.
        min: f64,
        /// The greatest value.
        max: f64,
        /// The default.
        default: f64,
    },
    /// One of a few words; the first is the default.
    Choice(&'static [&'static str]),
}

impl OptionKind {
    /// Least, greatest and default value; `None` for words.
    pub(super) fn range(&self) -> Option<[f64; 3]> {
        match *self {
            OptionKind::Integer { min, max, default } | OptionKind::Number { min, max, default } => {
                Some([min, max, default])
            }
            OptionKind::Choice(_) => None,
        }
    }
}

/// One row of a generator's table of options.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OptionInfo {
    /// The name, in snake_case, the same everywhere.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// Type, range and default.
    pub kind: OptionKind,
    /// The unit; empty for counts and words.
    pub unit: &'static str,
    /// What it means, in one sentence.
    pub meaning: &'static str,
}

/// What there is to know about a generator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeneratorInfo {
    /// The id, in kebab-case, the same everywhere.
    pub id: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it makes, in one sentence.
    pub summary: &'static str,
    /// Its options; `seed` goes without saying.
    pub options: &'static [OptionInfo],
}

impl GeneratorInfo {
    /// Refuses a seed above 2^53 - 1 and numbers outside the ranges of their rows.
    pub(super) fn check(&self, seed: u64, values: &[(&'static str, f64)]) -> Result<(), Error> {
        for &(name, value) in values {
            let [min, max, _] = self.range(name);
            if !value.is_finite() {
                let sentence = format!("{name} must be a finite number, not {}", Decimal(value));
                return Err(Error::new(Code::NotFinite, format!("/{name}"), sentence));
            }
            if !(min..=max).contains(&value) {
                let [min, max, value] = [min, max, value].map(Decimal);
                return Err(refused(name, format!("{name} must lie within [{min}, {max}], not {value}")));
            }
        }
        if seed > MAX_SEED {
            return Err(refused("seed", format!("seed must lie within [0, {MAX_SEED}], not {seed}")));
        }
        Ok(())
    }

    fn option(&self, name: &str) -> &'static OptionInfo {
        let found = self.options.iter().find(|option| option.name == name);
        found.unwrap_or_else(|| unreachable!("no option {name}"))
    }

    fn range(&self, name: &str) -> [f64; 3] {
        self.option(name).kind.range().unwrap_or_else(|| unreachable!("{name} is not a number"))
    }
}

/// The error `out-of-range` about an option.
pub(super) fn refused(option: &str, sentence: String) -> Error {
    Error::new(Code::OutOfRange, format!("/{option}"), sentence)
}

/// The options as they are given, read by their types; what is not given takes its default.
pub(super) struct Given<'a> {
    info: &'static GeneratorInfo,
    fields: Fields<'a>,
}

impl<'a> Given<'a> {
    /// Refuses what is no object, and fields that the generator has not.
    pub fn read(info: &'static GeneratorInfo, root: &'a Reader<'a>) -> Result<Self, Error> {
        let fields = root.object()?;
        let known: Vec<&str> = info.options.iter().map(|option| option.name).chain(["seed"]).collect();
        fields.only(&known)?;
        Ok(Self { info, fields })
    }

    /// The option as it stands in the document, where it is given.
    pub fn field(&self, name: &'static str) -> Option<Reader<'_>> {
        self.fields.optional(name)
    }

    /// A finite number; its range is checked by [`GeneratorInfo::check`].
    pub fn number(&self, name: &'static str) -> Result<f64, Error> {
        self.field(name).map_or_else(|| Ok(self.info.range(name)[2]), |field| field.number())
    }

    /// A whole number within its range.
    pub fn integer(&self, name: &'static str) -> Result<usize, Error> {
        let [min, max, default] = self.info.range(name);
        let value = self.field(name).map_or(Ok(default as u64), |field| field.integer(name, min as u64, max as u64))?;
        Ok(value as usize)
    }

    /// The number of a word among the row's words.
    pub fn choice(&self, name: &'static str) -> Result<usize, Error> {
        let Some(field) = self.field(name) else { return Ok(0) };
        let OptionKind::Choice(words) = self.info.option(name).kind else { unreachable!("{name} is not a word") };
        let given = field.string()?;
        words.iter().position(|word| *word == given).ok_or_else(|| {
            // Robots are types, as in a scenario.
            let code = if name == "robot" { Code::UnknownType } else { Code::OutOfRange };
            field.error(code, format!("{name} must be one of {}, not {}", words.join(", "), quoted(given)))
        })
    }

    /// The seed: from 0 (default) to 2^53 - 1.
    pub fn seed(&self) -> Result<u64, Error> {
        self.field("seed").map_or(Ok(0), |field| field.integer("seed", 0, MAX_SEED))
    }
}
