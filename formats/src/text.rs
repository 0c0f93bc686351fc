//! Lines, words and numbers of text files, as bytes.

/// The byte order mark of UTF-8, which some editors write before a text.
pub const MARK: &[u8] = b"\xef\xbb\xbf";

/// The bytes after a byte order mark, if there is one.
pub fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(MARK).unwrap_or(bytes)
}

/// Whether bytes begin like a JSON object.
pub fn is_object(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().starts_with(b"{")
}

/// The lines of a file with their numbers, from 1, without their ends.
pub struct Lines<'a> {
    rest: Option<&'a [u8]>,
    number: usize,
}

impl<'a> Lines<'a> {
    pub fn of(bytes: &'a [u8]) -> Self {
        Self { rest: Some(bytes), number: 0 }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let rest = self.rest.filter(|rest| self.number == 0 || !rest.is_empty())?;
        let (line, rest) = match rest.iter().position(|&byte| byte == b'\n') {
            Some(end) => (&rest[..end], Some(&rest[end + 1..])),
            None => (rest, None),
        };
        self.rest = rest;
        self.number += 1;
        Some((self.number, line.strip_suffix(b"\r").unwrap_or(line)))
    }
}

/// A length as text, rounded up to two digits, for sentences that name the most. The same on every platform: decimal digits
/// alone decide.
pub fn at_most(length: f64) -> String {
    let nearest = format!("{length:.1e}");
    let above = |(digits, exponent): (&str, &str)| -> Option<f64> {
        let digits: u32 = digits.replace('.', "").parse().ok()?;
        let exponent: i32 = exponent.parse().ok()?;
        format!("{}e{}", digits + 1, exponent - 1).parse().ok()
    };
    let rounded = match nearest.parse() {
        Ok(rounded) if rounded >= length => rounded,
        _ => nearest.split_once('e').and_then(above).unwrap_or(length),
    };
    if rounded < 1e-3 { format!("{rounded:e}") } else { rounded.to_string() }
}

/// What stands between blanks.
pub fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// A whole number of decimal digits.
pub fn count(word: &[u8]) -> Option<usize> {
    if word.is_empty() || !word.iter().all(u8::is_ascii_digit) {
        return None;
    }
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// A finite number.
pub fn number(word: &[u8]) -> Option<f64> {
    let value: f64 = std::str::from_utf8(word).ok()?.parse().ok()?;
    value.is_finite().then_some(value)
}

/// Text for a sentence or a name.
pub fn utf8(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
