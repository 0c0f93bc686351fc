//! What is wrong with a map or a query.

use planarium::error::Code;
use std::fmt;

/// An error: a stable code, what it is about, and a sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    pub(crate) code: Code,
    pub(crate) subject: Subject,
    pub(crate) message: String,
}

/// What an error is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Subject {
    /// A part of the map, by its number.
    Part(usize),
    /// All parts together.
    Map,
    /// The distance that is kept.
    Distance,
    /// The bounds.
    Bounds,
    /// The start of a query.
    Start,
    /// The goal of a query.
    Goal,
}

impl Fault {
    pub(crate) fn new(code: Code, subject: Subject, message: impl Into<String>) -> Self {
        Self { code, subject, message: message.into() }
    }

    /// The stable code.
    pub fn code(&self) -> Code {
        self.code
    }

    /// What it is about.
    pub fn subject(&self) -> Subject {
        self.subject
    }

    /// The sentence.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}
