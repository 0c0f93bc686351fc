//! A JSON value.

/// The longest text that is read, in bytes.
pub const MAX_TEXT: usize = 64 << 20;

/// Arrays and objects may lie within each other less deep than this.
pub const MAX_DEPTH: u32 = 128;

/// A JSON value. Fields of an object keep their order; numbers are 64-bit floats, as in JavaScript (from another source
/// than text they may be NaN or infinite).
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number.
    Number(f64),
    /// A string.
    String(String),
    /// An array.
    Array(Vec<Node>),
    /// An object: its fields in order.
    Object(Vec<(String, Node)>),
}

impl Node {
    /// A string.
    pub fn text(value: &str) -> Self {
        Node::String(value.to_owned())
    }

    /// An array of strings.
    pub fn words(words: &[&str]) -> Self {
        Node::Array(words.iter().map(|word| Node::text(word)).collect())
    }

    /// An array of numbers.
    pub fn numbers(values: &[f64]) -> Self {
        Node::Array(values.iter().copied().map(Node::Number).collect())
    }

    /// An array of arrays of numbers.
    pub fn rows(rows: &[Vec<f64>]) -> Self {
        Node::Array(rows.iter().map(|row| Node::numbers(row)).collect())
    }

    /// An object of these fields; those that are `None` are left out.
    pub fn object(fields: Vec<(&str, Option<Node>)>) -> Self {
        let there = fields.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?)));
        Node::Object(there.collect())
    }
}

/// Appends the name of a field to a JSON pointer, escaped as RFC 6901 asks.
pub(crate) fn push_field(pointer: &mut String, name: &str) {
    pointer.push('/');
    for character in name.chars() {
        match character {
            '~' => pointer.push_str("~0"),
            '/' => pointer.push_str("~1"),
            _ => pointer.push(character),
        }
    }
}
