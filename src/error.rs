//! The error type of the crate.

use std::fmt;
use std::ops::RangeInclusive;
use strum::{EnumMessage, IntoStaticStr, VariantArray};

/// The kind of an error, as a stable kebab-case code that programs may match on. Versions may add codes; none changes its
/// meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumMessage, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Code {
    /// The text is not JSON, or a number in it does not fit a 64-bit float.
    InvalidJson,
    /// The format of the document is not the one that is read here, such as planarium-scenario-1.
    UnknownFormat,
    /// An unknown field.
    UnknownField,
    /// A required field is absent.
    MissingField,
    /// A field or a parameter is given twice.
    DuplicateField,
    /// A value of another type than required.
    WrongType,
    /// A type of obstacle, robot or shape that does not exist.
    UnknownType,
    /// A number that is not finite.
    NotFinite,
    /// A number, a count or the length of a list is outside its range.
    OutOfRange,
    /// A configuration or a list of limits with the wrong number of entries.
    WrongDimension,
    /// A polygon with too few distinct vertices, without area, with crossing edges, a coordinate near 0, or misplaced holes.
    DegeneratePolygon,
    /// A wall with fewer than two distinct points, or with a coordinate near 0.
    DegenerateWall,
    /// Two queries, worlds or planners share a name, or two rows that differ a trial.
    DuplicateName,
    /// An obstacle lies within the arm's radius of its base, which never moves.
    BaseInCollision,
    /// More obstacles, vertices or trials than the limits allow.
    TooLarge,
    /// The start of the query touches something.
    StartInCollision,
    /// The goal of the query touches something.
    GoalInCollision,
    /// The end effector cannot reach the target of the query.
    TargetUnreachable,
    /// The scenario has no query of that name, or none at all.
    UnknownQuery,
    /// No planner has that id.
    UnknownPlanner,
    /// There is no parameter of that name.
    UnknownParameter,
    /// Nothing of that name can be generated.
    UnknownGenerator,
    /// The request needs another robot or another planner.
    Unsupported,
    /// A search has reached its limit without a result; that does not prove that there is none.
    GaveUp,
    /// A function that decides what is free, of a custom robot, has failed: in JavaScript it has thrown an exception.
    CallbackFailed,
    /// A file cannot be read or written (command line only).
    File,
    /// A result document is malformed, or belongs to another scenario.
    InvalidResult,
    /// A saved roadmap is damaged, contradicts itself, or has vertices or edges that are not free.
    InvalidRoadmap,
    /// A saved roadmap belongs to another world or another robot.
    OtherScenario,
    /// A file of rows cannot be continued: it has rows of another experiment or of another shard (command line only).
    OtherExperiment,
    /// A file that is to be written contains something else, or is an input or another output (command line only).
    WouldOverwrite,
    /// The arguments do not make sense (command line only).
    Usage,
}

impl Code {
    /// Every code, in the order of their declaration.
    pub const ALL: &[Code] = Code::VARIANTS;

    /// The code as it is printed: kebab-case, stable between versions.
    pub fn as_str(self) -> &'static str {
        self.into()
    }

    /// The meaning of the code, in a sentence: the comment at its declaration.
    pub fn meaning(self) -> &'static str {
        self.get_documentation().unwrap_or_default()
    }
}

/// An error: a stable code, a sentence with the offending value, and the JSON pointer of that value (RFC 6901; empty for the
/// whole document or without one).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error(Box<Detail>);

/// The content of an error: boxed, so that results stay small.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Detail {
    code: Code,
    message: String,
    pointer: String,
    /// The bits of the coordinates of a free configuration.
    nearest: Option<Vec<u64>>,
}

impl Error {
    /// An error about the value at `pointer`.
    pub fn new(code: Code, pointer: impl Into<String>, message: impl Into<String>) -> Self {
        Self(Box::new(Detail { code, message: message.into(), pointer: pointer.into(), nearest: None }))
    }

    /// The stable code.
    pub fn code(&self) -> Code {
        self.0.code
    }

    /// The sentence, with the offending value in it.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// The JSON pointer of the offending value.
    pub fn pointer(&self) -> &str {
        &self.0.pointer
    }

    /// Of a start or a goal in collision, the nearest free configuration that a bounded search has found.
    pub fn nearest(&self) -> Option<Vec<f64>> {
        self.0.nearest.as_ref().map(|bits| bits.iter().map(|&bits| f64::from_bits(bits)).collect())
    }

    /// The same error with the free configuration nearest to the offending one, and their distance.
    #[must_use]
    pub(crate) fn with_nearest(mut self, nearest: &[f64], distance: f64) -> Self {
        let distance = Number(serde_json::from_str(&format!("{distance:.3e}")).unwrap_or(distance));
        self.0.message += &format!(
            "; the nearest free configuration found is {nearest:?}, {distance} away in the metric of the space"
        );
        self.0.nearest = Some(nearest.iter().map(|x| x.to_bits()).collect());
        self
    }

    /// The same error with another pointer.
    #[must_use]
    pub(crate) fn at(mut self, pointer: impl Into<String>) -> Self {
        self.0.pointer = pointer.into();
        self
    }

    /// The same error about a value deeper in a document: `prefix` is put before the pointer.
    #[must_use]
    pub fn under(mut self, prefix: &str) -> Self {
        self.0.pointer.insert_str(0, prefix);
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())?;
        if !self.pointer().is_empty() {
            write!(f, " (at {})", self.pointer())?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}

/// The number, if it lies within a range: `what` names it in the sentence.
///
/// # Errors
/// `out-of-range`, `not-finite`
pub(crate) fn within(
    pointer: impl Into<String>,
    what: &str,
    value: f64,
    range: RangeInclusive<f64>,
) -> Result<f64, Error> {
    if range.contains(&value) {
        return Ok(value);
    }
    let code = if value.is_finite() { Code::OutOfRange } else { Code::NotFinite };
    let [low, high, value] = [*range.start(), *range.end(), value].map(Number);
    Err(Error::new(code, pointer, format!("{what} must lie within [{low}, {high}], not {value}")))
}

/// A string in quotes for a sentence, its control characters escaped, cut to 60 characters.
pub(crate) fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for (i, character) in text.chars().enumerate() {
        if i == 60 {
            return quoted + "\"...";
        }
        if character.is_control() || matches!(character, '"' | '\\') {
            quoted.extend(character.escape_default());
        } else {
            quoted.push(character);
        }
    }
    quoted + "\""
}

/// A number for a sentence, as short as possible: with an exponent if it is very large or very small.
pub(crate) struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-6..1e16).contains(&size) || !size.is_finite() {
            write!(f, "{}", self.0)
        } else {
            write!(f, "{:e}", self.0)
        }
    }
}
