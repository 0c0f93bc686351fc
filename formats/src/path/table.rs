//! Rows of numbers as text, with a line of names or without.

use super::{MAX_WAYPOINTS, PathFormat, Places, Rows};
use crate::error::{Code, FormatError, quoted};
use crate::text::{Lines, utf8};

/// What stands between the numbers of a row.
#[derive(Clone, Copy, PartialEq)]
enum Separator {
    Byte(u8),
    Blanks,
}

impl Separator {
    /// That of a line.
    fn of(line: &[u8]) -> Self {
        match [b'\t', b';', b','].into_iter().find(|byte| line.contains(byte)) {
            Some(byte) => Self::Byte(byte),
            None => Self::Blanks,
        }
    }

    /// The cells of a line, without quotes.
    fn cells(self, line: &[u8]) -> impl Iterator<Item = &[u8]> {
        let split = move |byte: &u8| match self {
            Self::Byte(separator) => *byte == separator,
            Self::Blanks => byte.is_ascii_whitespace(),
        };
        // A separator at the end of a row is no further cell.
        let line = if let Self::Byte(b',' | b';') = self {
            line.strip_suffix(b",").or(line.strip_suffix(b";")).unwrap_or(line)
        } else {
            line
        };
        line.split(split)
            .map(|cell| unquoted(cell.trim_ascii()))
            .filter(move |cell| self != Self::Blanks || !cell.is_empty())
    }
}

fn unquoted(cell: &[u8]) -> &[u8] {
    cell.strip_prefix(b"\"").and_then(|cell| cell.strip_suffix(b"\"")).unwrap_or(cell)
}

/// A number; `None` if it is none.
fn number(cell: &[u8]) -> Option<f64> {
    std::str::from_utf8(cell).ok()?.parse().ok()
}

/// Reads a table. Empty lines, and those that begin with # or %, are skipped; the last of these before the first row can have the
/// names.
///
/// # Errors
/// `unknown-world` if nothing is a number; `invalid-file`, `invalid-number` and `truncated` with the line
pub fn rows(bytes: &[u8]) -> Result<Rows, FormatError> {
    let mut lines = Lines::of(bytes).filter(|(_, line)| !line.trim_ascii().is_empty()).peekable();
    let mut comment: Option<&[u8]> = None;
    while let Some((_, line)) = lines.next_if(|(_, line)| is_comment(line)) {
        comment = Some(&line.trim_ascii_start()[1..]);
    }
    let Some(&(at, first)) = lines.peek() else {
        return Err(FormatError::new(Code::Truncated, "the file has no row of numbers"));
    };
    let separator = Separator::of(first);
    let names = |line: &[u8]| -> Vec<String> { Separator::of(line).cells(line).map(utf8).collect() };
    let width = separator.cells(first).count();
    let has_number = separator.cells(first).any(|cell| number(cell).is_some());
    let is_header = separator.cells(first).any(|cell| !cell.is_empty() && number(cell).is_none());
    let names = if is_header && !has_number {
        lines.next();
        Some(names(first))
    } else {
        comment
            .map(names)
            .filter(|names| names.len() == width && names.iter().all(|name| number(name.as_bytes()).is_none()))
    };
    let (mut numbers, mut places) = (Vec::new(), Vec::new());
    while let Some((line, text)) = lines.next() {
        if is_comment(text) {
            continue;
        }
        let before = numbers.len();
        for cell in separator.cells(text) {
            match number(cell) {
                Some(number) => numbers.push(number),
                // A cell without a number may be in a column that is not used.
                None if cell.is_empty() => numbers.push(f64::NAN),
                None if places.is_empty() && names.is_none() => {
                    let sentence = format!("this is no path that is read: {} is no number", quoted(cell));
                    return Err(FormatError::at_line(Code::UnknownWorld, line, sentence));
                }
                None => {
                    let sentence = format!("{} is no number", quoted(cell));
                    return Err(FormatError::at_line(Code::InvalidFile, line, sentence));
                }
            }
        }
        let found = numbers.len() - before;
        if found != width {
            let is_last = lines.peek().is_none() && found < width;
            let code = if is_last { Code::Truncated } else { Code::InvalidFile };
            let sentence = format!("the row has {found} cells, but line {at} has {width}");
            return Err(FormatError::at_line(code, line, sentence));
        }
        places.push(line);
        if places.len() > MAX_WAYPOINTS {
            let sentence = format!("there are more than {MAX_WAYPOINTS} waypoints, the most that are read");
            return Err(FormatError::at_line(Code::WorldTooLarge, line, sentence));
        }
    }
    Ok(Rows::plain(PathFormat::Table, names, width, numbers, Places::Lines(places)))
}

fn is_comment(line: &[u8]) -> bool {
    line.trim_ascii_start().starts_with(b"#") || line.trim_ascii_start().starts_with(b"%")
}
