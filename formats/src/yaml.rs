//! Flat YAML: the scalars and the lists of scalars of a mapping, by the parser saphyr-parser, whose events are read
//! without building a tree. Aliases are never followed, and what lies deeper is skipped.

use crate::error::{Code, FormatError, quoted};
use saphyr_parser::{Event, Parser};

/// A key of the mapping.
pub struct Entry {
    pub key: String,
    /// From 1.
    pub line: usize,
    pub value: Value,
}

/// Its value.
pub enum Value {
    Scalar(String),
    List(Vec<String>),
    /// Anything else.
    Other,
}

/// The longest YAML file that is read, in bytes.
const MAX_TEXT: usize = 1 << 20;

/// Reads the first document of a file.
///
/// # Errors
/// `world-too-large`, `invalid-file`: text that is not YAML, no mapping, a key twice
pub fn read(text: &str) -> Result<Vec<Entry>, FormatError> {
    if text.len() > MAX_TEXT {
        let sentence = format!("the YAML file has {} bytes; at most {MAX_TEXT} are read", text.len());
        return Err(FormatError::new(Code::WorldTooLarge, sentence));
    }
    let mut entries: Vec<Entry> = Vec::new();
    let mut key: Option<(String, usize)> = None;
    let mut list: Option<Vec<String>> = None;
    let mut depth = 0;
    for event in Parser::new_from_str(text.trim_start_matches('\u{feff}')) {
        let (event, span) = event.map_err(|error| {
            FormatError::at_line(
                Code::InvalidFile,
                error.marker().line(),
                format!("this is not YAML: {}", error.info()),
            )
        })?;
        let line = span.start.line();
        let not_flat = || FormatError::at_line(Code::InvalidFile, line, "a map's YAML is a mapping of keys to values");
        let mut ended = None;
        match event {
            Event::MappingStart(..) if depth == 0 => depth = 1,
            Event::MappingStart(..) | Event::SequenceStart(..) => {
                if depth == 0 || depth == 1 && key.is_none() {
                    return Err(not_flat());
                }
                list = (depth == 1 && matches!(event, Event::SequenceStart(..))).then(Vec::new);
                depth += 1;
            }
            Event::MappingEnd | Event::SequenceEnd => {
                depth -= 1;
                if depth == 1 {
                    ended = Some(list.take().map_or(Value::Other, Value::List));
                }
            }
            Event::Scalar(value, ..) => match depth {
                0 => return Err(not_flat()),
                1 if key.is_none() => key = Some((value.into_owned(), line)),
                1 => ended = Some(Value::Scalar(value.into_owned())),
                2 => list.iter_mut().for_each(|list| list.push(value.clone().into_owned())),
                _ => {}
            },
            Event::Alias(_) if depth == 1 && key.is_none() => return Err(not_flat()),
            Event::Alias(_) if depth == 1 => ended = Some(Value::Other),
            Event::Alias(_) => list = None,
            Event::DocumentEnd => break,
            _ => {}
        }
        // A list with anything but scalars is none.
        if depth > 2 {
            list = None;
        }
        if let Some(value) = ended {
            let Some((key, line)) = key.take() else { return Err(not_flat()) };
            if entries.iter().any(|entry| entry.key == key) {
                let sentence = format!("the key {} is there twice", quoted(key.as_bytes()));
                return Err(FormatError::at_line(Code::InvalidFile, line, sentence));
            }
            entries.push(Entry { key, line, value });
        }
    }
    Ok(entries)
}
