//! The one error type of the crate: a stable code, a sentence with the offending value, and where it stands.

use std::fmt;

/// What went wrong, as a stable kebab-case code that programs may match on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Code {
    /// The text is not JSON, a number in it does not fit a 64-bit float, or a value given has no counterpart in JSON.
    InvalidJson,
    /// The document says another `format` than `planarium-scenario-1`.
    UnknownFormat,
    /// A field that the contract does not know.
    UnknownField,
    /// A field that the contract requires is absent.
    MissingField,
    /// A field stands twice in one object.
    DuplicateField,
    /// A value of another JSON type than the contract asks for.
    WrongType,
    /// A `type` (of obstacle, robot, shape) that the contract does not know.
    UnknownType,
    /// A number that is not finite.
    NotFinite,
    /// A number, a count or a length of a list outside its range.
    OutOfRange,
    /// A configuration or a list of limits with the wrong number of entries.
    WrongDimension,
    /// A polygon with fewer than three distinct vertices, zero area, or edges that cross.
    DegeneratePolygon,
    /// Two queries share a name.
    DuplicateName,
    /// An obstacle lies within the arm's radius of its base, which never moves.
    BaseInCollision,
    /// More obstacles or vertices than the limits allow.
    TooLarge,
    /// The start of the query touches something.
    StartInCollision,
    /// The goal of the query touches something.
    GoalInCollision,
    /// The scenario has no query of that name, or none at all.
    UnknownQuery,
    /// No planner has that id.
    UnknownPlanner,
    /// The planner has no parameter of that name.
    UnknownParameter,
    /// Nothing of that name can be generated.
    UnknownGenerator,
    /// What was asked needs another robot.
    Unsupported,
    /// A file cannot be read or written (command line only).
    File,
    /// A result does not hold what the contract of results asks for.
    InvalidResult,
}

impl Code {
    /// The code as it is printed: kebab-case, stable between versions.
    pub fn as_str(self) -> &'static str {
        match self {
            Code::InvalidJson => "invalid-json",
            Code::UnknownFormat => "unknown-format",
            Code::UnknownField => "unknown-field",
            Code::MissingField => "missing-field",
            Code::DuplicateField => "duplicate-field",
            Code::WrongType => "wrong-type",
            Code::UnknownType => "unknown-type",
            Code::NotFinite => "not-finite",
            Code::OutOfRange => "out-of-range",
            Code::WrongDimension => "wrong-dimension",
            Code::DegeneratePolygon => "degenerate-polygon",
            Code::DuplicateName => "duplicate-name",
            Code::BaseInCollision => "base-in-collision",
            Code::TooLarge => "too-large",
            Code::StartInCollision => "start-in-collision",
            Code::GoalInCollision => "goal-in-collision",
            Code::UnknownQuery => "unknown-query",
            Code::UnknownPlanner => "unknown-planner",
            Code::UnknownParameter => "unknown-parameter",
            Code::UnknownGenerator => "unknown-generator",
            Code::Unsupported => "unsupported",
            Code::File => "file",
            Code::InvalidResult => "invalid-result",
        }
    }
}

/// An error: what, in a sentence with the offending value, and where, as a JSON pointer (RFC 6901; empty where
/// the whole document or no document is meant).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    code: Code,
    message: String,
    pointer: String,
}

impl Error {
    /// An error about the value at `pointer`.
    pub fn new(code: Code, pointer: impl Into<String>, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), pointer: pointer.into() }
    }

    /// The stable code.
    pub fn code(&self) -> Code {
        self.code
    }

    /// The sentence, with the offending value in it.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The JSON pointer of the offending value; empty for the document as a whole.
    pub fn pointer(&self) -> &str {
        &self.pointer
    }

    /// The same error about a value that stands deeper in a document: `prefix` goes before the pointer.
    #[must_use]
    pub fn under(mut self, prefix: &str) -> Self {
        self.pointer = format!("{prefix}{}", self.pointer);
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        if !self.pointer.is_empty() {
            write!(f, " (at {})", self.pointer)?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}
