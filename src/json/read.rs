//! JSON text (RFC 8259) to a tree.

use super::names::Names;
use super::{MAX_DEPTH, MAX_TEXT, Node, push_field};
use crate::decimal;
use crate::error::{Code, Error, quoted};

impl Node {
    /// Reads JSON text. O(n log^2 n) in its length.
    ///
    /// # Errors
    /// `too-large` for text longer than [`MAX_TEXT`]; `duplicate-field` for a field that stands twice in one object;
    /// `invalid-json` for anything else that is not JSON, for nesting as deep as [`MAX_DEPTH`] and for a number beyond
    /// the range of a 64-bit float. With the pointer of the value and, in the sentence, line and column.
    pub fn parse(text: &str) -> Result<Self, Error> {
        if text.len() > MAX_TEXT {
            let sentence = format!("the text is {} bytes long; at most {MAX_TEXT} are read", text.len());
            return Err(Error::new(Code::TooLarge, "", sentence));
        }
        let mut source = Source { text, at: 0 };
        let node = source.value(0)?;
        match source.next() {
            None => Ok(node),
            Some(_) => Err(source.wrong("trailing characters")),
        }
    }
}

/// A text and how far it is read.
struct Source<'a> {
    text: &'a str,
    at: usize,
}

impl Source<'_> {
    /// The byte here, where there is one.
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// The next byte that is no white space; it is not taken.
    fn next(&mut self) -> Option<u8> {
        while let Some(b' ' | b'\n' | b'\r' | b'\t') = self.peek() {
            self.at += 1;
        }
        self.peek()
    }

    /// The text from a place up to here.
    fn since(&self, start: usize) -> &str {
        self.text.get(start..self.at).unwrap_or_default()
    }

    /// Takes the byte where it is this one.
    fn take(&mut self, byte: u8) -> bool {
        let is_here = self.peek() == Some(byte);
        self.at += usize::from(is_here);
        is_here
    }

    /// Reads a value within so many arrays and objects.
    fn value(&mut self, depth: u32) -> Result<Node, Error> {
        match self.next() {
            Some(b'"') => Ok(Node::String(self.string()?)),
            Some(b'{' | b'[') if depth + 1 == MAX_DEPTH => Err(self.wrong("recursion limit exceeded")),
            Some(b'{') => self.object(depth + 1),
            Some(b'[') => self.array(depth + 1),
            Some(b'-' | b'0'..=b'9') => self.number(),
            _ => {
                for (word, node) in [("null", Node::Null), ("true", Node::Bool(true)), ("false", Node::Bool(false))] {
                    if self.text.as_bytes()[self.at..].starts_with(word.as_bytes()) {
                        self.at += word.len();
                        return Ok(node);
                    }
                }
                Err(self.wrong("expected value"))
            }
        }
    }

    fn array(&mut self, depth: u32) -> Result<Node, Error> {
        self.at += 1;
        let mut items = Vec::new();
        while self.goes_on(b']', items.is_empty())? {
            match self.value(depth) {
                Ok(item) => items.push(item),
                Err(error) => return Err(error.under(&format!("/{}", items.len()))),
            }
        }
        Ok(Node::Array(items))
    }

    fn object(&mut self, depth: u32) -> Result<Node, Error> {
        self.at += 1;
        let (mut fields, mut names) = (Vec::<(String, Node)>::new(), Names::default());
        while self.goes_on(b'}', fields.is_empty())? {
            if self.peek() != Some(b'"') {
                return Err(self.wrong("a name must be a string"));
            }
            let name = self.string()?;
            match self.field(&name, names.has(&name, &|i| &fields[i as usize].0), depth) {
                Ok(value) => fields.push((name, value)),
                Err(error) => {
                    let mut pointer = String::new();
                    push_field(&mut pointer, &name);
                    return Err(error.under(&pointer));
                }
            }
            names.add(&|i| &fields[i as usize].0);
        }
        Ok(Node::Object(fields))
    }

    /// What stands behind the name of a field.
    fn field(&mut self, name: &str, is_known: bool, depth: u32) -> Result<Node, Error> {
        if self.next() != Some(b':') {
            return Err(self.wrong("expected `:`"));
        }
        self.at += 1;
        if is_known {
            let sentence = format!("the field {} stands twice in one object", quoted(name));
            return Err(self.refuse(Code::DuplicateField, &sentence));
        }
        self.value(depth)
    }

    /// Whether another item follows; takes the comma before it, or the end.
    fn goes_on(&mut self, end: u8, is_first: bool) -> Result<bool, Error> {
        self.next();
        if self.take(end) {
            return Ok(false);
        }
        if is_first {
            return Ok(true);
        }
        if !self.take(b',') {
            return Err(self.wrong(if end == b']' { "expected `,` or `]`" } else { "expected `,` or `}`" }));
        }
        if self.next() == Some(end) {
            return Err(self.wrong("trailing comma"));
        }
        Ok(true)
    }

    fn number(&mut self) -> Result<Node, Error> {
        let start = self.at;
        self.take(b'-');
        let is_zero = self.take(b'0');
        let mut is_well = is_zero || self.digits();
        // No digit may follow a zero in front.
        is_well &= !(is_zero && matches!(self.peek(), Some(b'0'..=b'9')));
        if is_well && self.take(b'.') {
            is_well = self.digits();
        }
        if is_well && (self.take(b'e') || self.take(b'E')) {
            let _ = self.take(b'+') || self.take(b'-');
            is_well = self.digits();
        }
        if !is_well {
            return Err(self.wrong("invalid number"));
        }
        let text = self.since(start);
        let value = decimal::read(text);
        if value.is_infinite() {
            let sentence = format!("{}: number out of range", text.get(..60).unwrap_or(text));
            return Err(self.refuse(Code::InvalidJson, &sentence));
        }
        Ok(Node::Number(value))
    }

    /// Takes digits; whether there is one at least.
    fn digits(&mut self) -> bool {
        let start = self.at;
        while let Some(b'0'..=b'9') = self.peek() {
            self.at += 1;
        }
        self.at > start
    }

    fn string(&mut self) -> Result<String, Error> {
        self.at += 1;
        let mut string = String::new();
        loop {
            let start = self.at;
            while !matches!(self.peek(), None | Some(b'"' | b'\\' | 0..0x20)) {
                self.at += 1;
            }
            string.push_str(self.since(start));
            match self.peek() {
                Some(b'"') => {
                    self.at += 1;
                    return Ok(string);
                }
                Some(b'\\') => string.push(self.escape()?),
                Some(_) => return Err(self.wrong("a control character in a string must be escaped")),
                None => return Err(self.wrong("a string has no end")),
            }
        }
    }

    /// The character that an escape stands for.
    fn escape(&mut self) -> Result<char, Error> {
        self.at += 2;
        let character = match self.text.as_bytes().get(self.at - 1) {
            Some(&byte @ (b'"' | b'\\' | b'/')) => char::from(byte),
            Some(b'b') => '\u{8}',
            Some(b'f') => '\u{c}',
            Some(b'n') => '\n',
            Some(b'r') => '\r',
            Some(b't') => '\t',
            Some(b'u') => {
                let mut code = self.hex()?;
                if (0xd800..0xdc00).contains(&code) && self.take(b'\\') && self.take(b'u') {
                    // Two halves make a character; any other pair makes none.
                    let low = self.hex()?;
                    let is_low = (0xdc00..0xe000).contains(&low);
                    code = if is_low { 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) } else { code };
                }
                return char::from_u32(code).ok_or_else(|| self.wrong("half a character in a hex escape"));
            }
            _ => {
                self.at -= 1;
                return Err(self.wrong("invalid escape"));
            }
        };
        Ok(character)
    }

    /// Four hexadecimal digits.
    fn hex(&mut self) -> Result<u32, Error> {
        let mut code = 0;
        for _ in 0..4 {
            let Some(digit) = self.peek().and_then(|byte| char::from(byte).to_digit(16)) else {
                return Err(self.wrong("invalid hex escape"));
            };
            code = 16 * code + digit;
            self.at += 1;
        }
        Ok(code)
    }

    /// The error of text that is not JSON, here.
    #[cold]
    fn wrong(&self, what: &str) -> Error {
        self.refuse(Code::InvalidJson, &format!("this is not JSON: {what}"))
    }

    /// An error with line and column, in bytes, both from 1; 0 where an empty line ends the text.
    #[cold]
    fn refuse(&self, code: Code, sentence: &str) -> Error {
        let before = &self.text.as_bytes()[..self.at.min(self.text.len())];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        let column =
            before.iter().rev().take_while(|&&byte| byte != b'\n').count() + usize::from(self.peek().is_some());
        Error::new(code, "", format!("{sentence} at line {line} column {column}"))
    }
}
