//! The document that a run ends with: what was asked, the path, its length, the work, and a fingerprint of the growth.

use crate::error::{Code, Error};
use crate::random::MAX_SEED;
use crate::stats::Stats;
use crate::status::Status;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_path_to_error::{Path, Segment};

/// The result of a plan, in the order and under the names of its JSON form. Numbers are written with the fewest digits
/// that parse back to the same bits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ResultDocument {
    /// The name of the scenario.
    pub scenario: String,
    /// The name of the query.
    pub query: String,
    /// The id of the planner.
    pub planner: String,
    /// The seed, at most 2^53 - 1.
    pub seed: u64,
    /// How the run ended.
    pub status: Status,
    /// The waypoints, one configuration each, from the start to the goal; empty unless solved.
    pub path: Vec<Vec<f64>>,
    /// The sum of the space's distances along the path; 0 without one.
    pub length: f64,
    /// The work done.
    pub stats: Stats,
    /// A hash over every vertex, edge and event; 16 lower-case hex digits in JSON.
    #[serde(serialize_with = "write_fingerprint", deserialize_with = "read_fingerprint")]
    pub fingerprint: u64,
}

impl ResultDocument {
    /// Reads a result document.
    ///
    /// # Errors
    /// `invalid-json` where the text is not JSON or a number does not fit a double; `invalid-result` for anything that the
    /// contract of results does not allow: a missing, unknown or repeated field, another type, a seed above 2^53 - 1, a
    /// negative length or time, a fingerprint that is not 16 hex digits. The pointer names the offending value, or the
    /// object that lacks a field.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let mut reader = serde_json::Deserializer::from_str(text);
        let document: Self = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
            let pointer = pointer(error.path());
            refused(&pointer, error.inner())
        })?;
        reader.end().map_err(|error| refused("", &error))?;
        document.check()?;
        Ok(document)
    }

    /// The document as one line of JSON.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("strings, numbers and lists can be written as JSON")
    }

    /// Refuses numbers of the right type and the wrong size.
    fn check(&self) -> Result<(), Error> {
        if self.seed > MAX_SEED {
            let sentence = format!("a seed is at most {MAX_SEED}, not {}", self.seed);
            return Err(Error::new(Code::InvalidResult, "/seed", sentence));
        }
        let lengths = [
            ("/length", "a length", self.length),
            ("/stats/build_seconds", "a time", self.stats.build_seconds),
            ("/stats/search_seconds", "a time", self.stats.search_seconds),
        ];
        match lengths.into_iter().find(|(_, _, value)| *value < 0.0) {
            Some((pointer, what, value)) => {
                Err(Error::new(Code::InvalidResult, pointer, format!("{what} is at least 0, not {value}")))
            }
            None => Ok(()),
        }
    }
}

/// The error for what the reader refused at `pointer`.
fn refused(pointer: &str, error: &serde_json::Error) -> Error {
    let code = if error.is_data() { Code::InvalidResult } else { Code::InvalidJson };
    Error::new(code, pointer, format!("not a result: {error}"))
}

/// The place that the reader had come to, as a JSON pointer.
fn pointer(path: &Path) -> String {
    let mut pointer = String::new();
    for segment in path {
        match segment {
            Segment::Seq { index } => pointer += &format!("/{index}"),
            Segment::Map { key } => pointer += &format!("/{}", key.replace('~', "~0").replace('/', "~1")),
            // Neither occurs in a result that is JSON; what has been found so far is still a place.
            Segment::Enum { .. } | Segment::Unknown => break,
        }
    }
    pointer
}

/// Writes the 16 hex digits.
fn write_fingerprint<S: Serializer>(fingerprint: &u64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&format!("{fingerprint:016x}"))
}

/// Reads the 16 hex digits.
fn read_fingerprint<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u64, D::Error> {
    let text = String::deserialize(deserializer)?;
    let is_digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
    let digits = (text.len() == 16 && text.bytes().all(is_digit)).then(|| u64::from_str_radix(&text, 16).ok());
    digits.flatten().ok_or_else(|| {
        serde::de::Error::custom(format_args!("a fingerprint is 16 lower-case hex digits, not {text:?}"))
    })
}
