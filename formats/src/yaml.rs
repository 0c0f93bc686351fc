//! YAML as a tree of text, by the events of the parser saphyr-parser. Aliases are never followed, so that a tree is no
//! larger than its file.

use crate::error::{Code, FormatError, quoted};
use saphyr_parser::{Event, Parser};
use std::borrow::Cow;
use std::collections::HashSet;

/// The longest YAML file that is read, in bytes.
const MAX_TEXT: usize = 2 << 20;

/// How deep lists and mappings may lie in each other.
const MAX_DEPTH: usize = 64;

/// A value and where it is.
#[derive(Debug)]
pub struct Node {
    /// From 1.
    pub line: usize,
    pub value: Value,
}

/// A value.
#[derive(Debug)]
pub enum Value {
    Scalar(String),
    List(Vec<Node>),
    /// Keys, each once, in the order of the file.
    Mapping(Vec<(String, Node)>),
    Alias,
}

/// A list or a mapping that has begun.
enum Open {
    List(Vec<Node>),
    Mapping { pairs: Vec<(String, Node)>, seen: HashSet<String>, key: Option<String> },
}

impl Node {
    /// The value of a key, of a mapping.
    pub fn get(&self, key: &str) -> Option<&Node> {
        self.pairs().iter().find(|(own, _)| own == key).map(|(_, node)| node)
    }

    /// The keys and values of a mapping; nothing of others.
    pub fn pairs(&self) -> &[(String, Node)] {
        if let Value::Mapping(pairs) = &self.value { pairs } else { &[] }
    }

    /// The items of a list; nothing of others.
    pub fn items(&self) -> &[Node] {
        if let Value::List(items) = &self.value { items } else { &[] }
    }

    /// The items of the list of a key; nothing if there is none.
    pub fn list(&self, key: &str) -> &[Node] {
        self.get(key).map_or(&[], Node::items)
    }

    /// The text of a scalar.
    pub fn text(&self) -> Option<&str> {
        if let Value::Scalar(text) = &self.value { Some(text.trim()) } else { None }
    }
}

/// Reads the first document of a file, which is a mapping.
///
/// # Errors
/// `world-too-large`, `invalid-file`: text that is not YAML, no mapping, a key twice
pub fn read(text: &str) -> Result<Node, FormatError> {
    let node = tree(text, MAX_TEXT)?;
    match node.value {
        Value::Mapping(_) => Ok(node),
        _ => {
            let sentence = "a map's YAML is a mapping of keys to values";
            Err(FormatError::at_line(Code::InvalidFile, node.line, sentence))
        }
    }
}

/// Reads the first document of a file of at most this many bytes, whatever it is.
///
/// # Errors
/// `world-too-large`; `invalid-file`: text that is not YAML, nothing, a key twice
pub fn tree(text: &str, most: usize) -> Result<Node, FormatError> {
    if text.len() > most {
        let sentence = format!("the YAML file has {} bytes; at most {most} are read", text.len());
        return Err(FormatError::new(Code::WorldTooLarge, sentence));
    }
    let mut open: Vec<(usize, Open)> = Vec::new();
    for event in Parser::new_from_str(&with_spaces(text)) {
        let (event, span) = event.map_err(|error| {
            let sentence = format!("this is not YAML: {}", error.info());
            FormatError::at_line(Code::InvalidFile, error.marker().line(), sentence)
        })?;
        let line = span.start.line();
        if open.len() > MAX_DEPTH {
            let sentence = format!("the YAML file is more than {MAX_DEPTH} levels deep");
            return Err(FormatError::at_line(Code::WorldTooLarge, line, sentence));
        }
        let node = match event {
            Event::MappingStart(..) => {
                open.push((line, Open::Mapping { pairs: Vec::new(), seen: HashSet::new(), key: None }));
                continue;
            }
            Event::SequenceStart(..) => {
                open.push((line, Open::List(Vec::new())));
                continue;
            }
            Event::MappingEnd | Event::SequenceEnd => match open.pop() {
                Some((line, Open::List(items))) => Node { line, value: Value::List(items) },
                Some((line, Open::Mapping { pairs, .. })) => Node { line, value: Value::Mapping(pairs) },
                None => continue,
            },
            Event::Scalar(text, ..) => Node { line, value: Value::Scalar(text.into_owned()) },
            Event::Alias(_) => Node { line, value: Value::Alias },
            _ => continue,
        };
        match open.last_mut() {
            None => return Ok(node),
            Some((_, Open::List(items))) => items.push(node),
            Some((_, Open::Mapping { pairs, seen, key })) => match (key.take(), node.value) {
                (Some(key), value) => pairs.push((key, Node { line: node.line, value })),
                (None, Value::Scalar(text)) => {
                    if !seen.insert(text.clone()) {
                        let sentence = format!("the key {} is there twice", quoted(text.as_bytes()));
                        return Err(FormatError::at_line(Code::InvalidFile, node.line, sentence));
                    }
                    *key = Some(text);
                }
                (None, _) => {
                    let sentence = "a key of a mapping is text, not a list or a mapping";
                    return Err(FormatError::at_line(Code::InvalidFile, node.line, sentence));
                }
            },
        }
    }
    Err(FormatError::at_line(Code::InvalidFile, 1, "the YAML file has no value"))
}

/// The text with spaces for the tabs between keys and values. YAML 1.2 (6.2, separation spaces) allows both, the parser does not
/// before letters. Places stay the same.
fn with_spaces(text: &str) -> Cow<'_, str> {
    if !text.contains(":\t") {
        return Cow::Borrowed(text);
    }
    let mut spaced = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        // Within quotes a tab is a part of the text.
        let mut quote = None;
        let mut before = None;
        for letter in line.chars() {
            match (quote, letter) {
                (None, '"' | '\'') => quote = Some(letter),
                (Some(open), _) if open == letter => quote = None,
                _ => {}
            }
            let is_between = letter == '\t' && quote.is_none() && before == Some(':');
            spaced.push(if is_between { ' ' } else { letter });
            before = if is_between { Some(':') } else { Some(letter) };
        }
    }
    Cow::Owned(spaced)
}
