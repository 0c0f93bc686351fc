//! The error type: a stable code, a sentence, the file and the place in it.

use serde::Serialize;
use std::fmt;
use strum::{EnumMessage, IntoStaticStr, VariantArray};

/// The kind of an error, as a stable kebab-case code that programs may match on. Versions may add codes; none changes
/// its meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumMessage, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Code {
    /// The content of a file is of no format that is read.
    UnknownWorld,
    /// A file names another one that was not given.
    MissingFile,
    /// A file was given that the others have no use for.
    UnusedFile,
    /// A file ends before all that it announces.
    Truncated,
    /// A file breaks the rules of its format.
    InvalidFile,
    /// A number in a file is not finite, or outside the range that its format allows.
    InvalidNumber,
    /// A file announces or contains more than the limits allow.
    WorldTooLarge,
    /// A file uses a part of its format that is not read.
    UnsupportedFeature,
    /// Two files, or two parts of one, contradict each other.
    Contradiction,
    /// An option does not fit the file, or has a value that makes no sense.
    InvalidOption,
    /// What was read is no valid scenario.
    InvalidScenario,
    /// A path has other columns than the robot needs.
    WrongColumns,
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

/// Where in a file an error is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Place {
    /// A line of text, from 1.
    Line(usize),
    /// A byte, from 0.
    Byte(usize),
    /// A part of the file by its name, such as a key.
    Element(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::Element(name) => f.write_str(name),
        }
    }
}

/// Why files could not be read as a world.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormatError(Box<Detail>);

/// The content of an error: boxed, so that results stay small.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Detail {
    code: Code,
    message: String,
    file: Option<String>,
    place: Option<Place>,
    wanted: Option<String>,
}

impl FormatError {
    pub(crate) fn new(code: Code, message: impl Into<String>) -> Self {
        Self(Box::new(Detail { code, message: message.into(), file: None, place: None, wanted: None }))
    }

    /// An error at a line, from 1.
    pub(crate) fn at_line(code: Code, line: usize, message: impl Into<String>) -> Self {
        Self::new(code, message).at(Place::Line(line))
    }

    /// The error at a place, unless it has one.
    pub(crate) fn at_or(mut self, place: impl FnOnce() -> Place) -> Self {
        self.0.place.get_or_insert_with(place);
        self
    }

    pub(crate) fn at(mut self, place: Place) -> Self {
        self.0.place = Some(place);
        self
    }

    /// The same error about a file, unless it already names one.
    pub(crate) fn in_file(mut self, name: &str) -> Self {
        self.0.file.get_or_insert_with(|| name.to_owned());
        self
    }

    /// The error with its place moved by a number of bytes, if it is a byte.
    pub(crate) fn moved(mut self, by: usize) -> Self {
        if let Some(Place::Byte(at)) = &mut self.0.place {
            *at += by;
        }
        self
    }

    /// Text that is not the JSON of a format.
    pub(crate) fn of_json(error: &serde_json::Error, what: &str) -> Self {
        let code = match () {
            () if error.is_eof() => Code::Truncated,
            () if error.to_string().contains("number out of range") => Code::InvalidNumber,
            () => Code::InvalidFile,
        };
        Self::at_line(code, error.line(), format!("this is no {what}: {error}"))
    }

    /// An option that names something that is not there.
    pub(crate) fn none_of<'a>(what: &str, wanted: &str, known: impl Iterator<Item = &'a str>) -> Self {
        let known: Vec<String> = known.take(20).map(|name| quoted(name.as_bytes())).collect();
        let sentence = format!("there is no {what} {}, but {}", quoted(wanted.as_bytes()), known.join(", "));
        Self::new(Code::InvalidOption, sentence)
    }

    /// A file that is named but not given.
    pub(crate) fn missing(wanted: &str, message: impl Into<String>) -> Self {
        let mut error = Self::new(Code::MissingFile, message);
        error.0.wanted = Some(wanted.to_owned());
        error
    }

    /// The stable code.
    pub fn code(&self) -> Code {
        self.0.code
    }

    /// The sentence, with the offending value in it.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// The name of the file; `None` if the error is about none of them, or about all.
    pub fn file(&self) -> Option<&str> {
        self.0.file.as_deref()
    }

    /// The place in the file, where it is known.
    pub fn place(&self) -> Option<&Place> {
        self.0.place.as_ref()
    }

    /// Of `missing-file`, the name of that file as the file has it that names it: read it and try again.
    pub fn wanted(&self) -> Option<&str> {
        self.0.wanted.as_deref()
    }
}

impl fmt::Display for FormatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.file(), self.place()) {
            (Some(file), Some(place)) => write!(f, "{file}, {place}: ")?,
            (Some(file), None) => write!(f, "{file}: ")?,
            (None, Some(place)) => write!(f, "{place}: ")?,
            (None, None) => {}
        }
        f.write_str(self.message())
    }
}

impl std::error::Error for FormatError {}

/// A piece of a file for a sentence: in quotes, its control characters escaped, cut to 40 characters.
pub(crate) fn quoted(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]);
    let mut cut: String = text.chars().take(40).collect();
    if cut.len() < text.len() {
        cut.push('…');
    }
    format!("{cut:?}")
}
