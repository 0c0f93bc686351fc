//! Pairs of a group code and a value, on two lines, and entities made of them.

use crate::error::{Code, FormatError, quoted};
use crate::text;

/// The most pairs of an entity.
const MAX_PAIRS: usize = 4_000_000;

/// A value and its group code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair<'a> {
    pub code: i32,
    pub value: &'a [u8],
    /// The line of the value, from 1.
    pub line: usize,
}

impl Pair<'_> {
    pub fn is(&self, code: i32, value: &str) -> bool {
        self.code == code && self.value == value.as_bytes()
    }

    /// A finite number.
    pub fn number(&self) -> Result<f64, FormatError> {
        text::number(self.value).ok_or_else(|| {
            let sentence = format!("{} of group {} is no finite number", quoted(self.value), self.code);
            FormatError::at_line(Code::InvalidNumber, self.line, sentence)
        })
    }

    /// A whole number.
    pub fn integer(&self) -> Result<i64, FormatError> {
        std::str::from_utf8(self.value).ok().and_then(|text| text.parse().ok()).ok_or_else(|| {
            let sentence = format!("{} of group {} is no whole number", quoted(self.value), self.code);
            FormatError::at_line(Code::InvalidNumber, self.line, sentence)
        })
    }
}

/// The pairs from a place on.
#[derive(Debug, Clone, Copy)]
pub struct Pairs<'a> {
    bytes: &'a [u8],
    line: usize,
}

impl<'a> Pairs<'a> {
    pub fn of(bytes: &'a [u8]) -> Self {
        Self { bytes, line: 0 }
    }

    fn line(&mut self) -> Option<&'a [u8]> {
        if self.bytes.is_empty() {
            return None;
        }
        let end = self.bytes.iter().position(|&byte| byte == b'\n').unwrap_or(self.bytes.len());
        let line = &self.bytes[..end];
        self.bytes = self.bytes.get(end + 1..).unwrap_or(&[]);
        self.line += 1;
        Some(line.trim_ascii())
    }

    /// The next pair; the file ends with the pair 0 EOF. Comments are skipped.
    pub fn next(&mut self) -> Result<Pair<'a>, FormatError> {
        loop {
            let cut = |line| FormatError::at_line(Code::Truncated, line, "the file ends before its EOF");
            let code = self.line().ok_or_else(|| cut(self.line))?;
            let code_line = self.line;
            let value = self.line().ok_or_else(|| cut(self.line))?;
            let code = std::str::from_utf8(code).ok().and_then(|text| text.parse().ok()).ok_or_else(|| {
                let sentence = format!("{} is no group code", quoted(code));
                FormatError::at_line(Code::InvalidFile, code_line, sentence)
            })?;
            if code != 999 {
                return Ok(Pair { code, value, line: self.line });
            }
        }
    }

    /// The next entity, or any other thing that begins with group 0; `next` goes on after it.
    pub fn entity(&mut self) -> Result<Entity<'a>, FormatError> {
        let kind = self.next()?;
        if kind.code != 0 {
            let sentence = format!("group 0 is expected, not {}", kind.code);
            return Err(FormatError::at_line(Code::InvalidFile, kind.line, sentence));
        }
        let mut entity = Entity { kind: kind.value, line: kind.line, pairs: Vec::new() };
        if kind.value == b"EOF" {
            return Ok(entity);
        }
        loop {
            let mut ahead = *self;
            let pair = ahead.next()?;
            if pair.code == 0 {
                return Ok(entity);
            }
            if entity.pairs.len() == MAX_PAIRS {
                let sentence = format!("it has more than {MAX_PAIRS} groups");
                return Err(entity.wrong(Code::WorldTooLarge, sentence));
            }
            entity.pairs.push(pair);
            *self = ahead;
        }
    }
}

/// What begins with group 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Entity<'a> {
    pub kind: &'a [u8],
    pub line: usize,
    pub pairs: Vec<Pair<'a>>,
}

impl<'a> Entity<'a> {
    /// The first value of a group.
    pub fn get(&self, code: i32) -> Option<Pair<'a>> {
        self.pairs.iter().copied().find(|pair| pair.code == code)
    }

    pub fn number(&self, code: i32, default: f64) -> Result<f64, FormatError> {
        self.get(code).map_or(Ok(default), |pair| pair.number())
    }

    pub fn integer(&self, code: i32, default: i64) -> Result<i64, FormatError> {
        self.get(code).map_or(Ok(default), |pair| pair.integer())
    }

    /// A point: x of the group, y and z of those that are 10 and 20 more.
    pub fn point(&self, code: i32) -> Result<[f64; 3], FormatError> {
        Ok([self.number(code, 0.0)?, self.number(code + 10, 0.0)?, self.number(code + 20, 0.0)?])
    }

    /// All points of a group, in order; y and z follow their x.
    pub fn points(&self, code: i32) -> Result<Vec<[f64; 3]>, FormatError> {
        let mut points: Vec<[f64; 3]> = Vec::new();
        for pair in &self.pairs {
            let axis = match pair.code.wrapping_sub(code) {
                0 => {
                    points.push([0.0; 3]);
                    0
                }
                10 => 1,
                20 => 2,
                _ => continue,
            };
            if let Some(point) = points.last_mut() {
                point[axis] = pair.number()?;
            }
        }
        Ok(points)
    }

    pub fn layer(&self) -> String {
        self.get(8).map_or_else(|| "0".to_owned(), |pair| name(pair.value))
    }

    pub fn wrong(&self, code: Code, sentence: impl std::fmt::Display) -> FormatError {
        FormatError::at_line(code, self.line, format!("{}: {sentence}", String::from_utf8_lossy(self.kind)))
    }
}

/// A name: UTF-8, else Latin 1, with letters that are written as \U+XXXX.
pub fn name(bytes: &[u8]) -> String {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    };
    let mut parts = text.split("\\U+");
    let mut name = parts.next().unwrap_or("").to_owned();
    for part in parts {
        let letter = part.get(..4).and_then(|digits| u32::from_str_radix(digits, 16).ok()).and_then(char::from_u32);
        match letter {
            Some(letter) => {
                name.push(letter);
                name.push_str(&part[4..]);
            }
            None => {
                name.push_str("\\U+");
                name.push_str(part);
            }
        }
    }
    name
}
