//! PGM, plain (P2) and raw (P5), of 8 or 16 bits: <https://netpbm.sourceforge.net/doc/pgm.html>.

use super::{Cells, Pixel, truncated};
use crate::error::{Code, FormatError, Place, quoted};
use crate::grid::Cell;

pub fn read(bytes: &[u8], mut cell: impl FnMut(Pixel) -> Cell) -> Result<Cells, FormatError> {
    let is_raw = bytes.get(1) == Some(&b'5');
    let mut header = Words { bytes, at: 2, start: 2 };
    let [width, height] = [header.number("the width")?, header.number("the height")?];
    let most = header.number("the largest value")?;
    if !(1..=65535).contains(&most) {
        let sentence = format!("the largest value of a PGM is from 1 to 65535, not {most}");
        return Err(FormatError::new(Code::InvalidNumber, sentence).at(Place::Byte(header.start)));
    }
    let mut cells = Cells::for_size(width, height)?;
    let count = width * height;
    let most = most as u32;
    let mut push = |value: u32, at: usize| {
        if value > most {
            let sentence = format!("a pixel has the value {value}, above the largest value {most} of the header");
            return Err(FormatError::new(Code::InvalidNumber, sentence).at(Place::Byte(at)));
        }
        cells.cells.push(cell(Pixel { sum: value, channels: 1, alpha: None, most }));
        Ok(())
    };
    if is_raw {
        // One blank ends the header.
        let start = header.at + 1;
        let size = if most < 256 { 1 } else { 2 };
        let Some(data) = bytes.get(start..).and_then(|rest| rest.get(..count * size)) else {
            let there = bytes.len().saturating_sub(start) / size;
            return Err(truncated(format!("{there} of {width} x {height} pixels are there"), bytes.len()));
        };
        for (i, value) in data.chunks_exact(size).enumerate() {
            let value = value.iter().fold(0, |sum, &byte| 256 * sum + u32::from(byte));
            push(value, start + i * size)?;
        }
    } else {
        // Each pixel takes a digit and a blank, so that memory is in proportion to the file.
        if count > bytes.len() - header.at {
            return Err(truncated(format!("the file is too short for {width} x {height} pixels"), bytes.len()));
        }
        for i in 0..count {
            let value = header.number("a pixel").map_err(|error| {
                if error.code() != Code::Truncated {
                    return error;
                }
                truncated(format!("{i} of {width} x {height} pixels are there"), bytes.len())
            })?;
            push(u32::try_from(value).unwrap_or(u32::MAX), header.start)?;
        }
    }
    Ok(cells)
}

/// Whole numbers between blanks and comments.
struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Where the last number begins.
    start: usize,
}

impl Words<'_> {
    fn number(&mut self, what: &str) -> Result<usize, FormatError> {
        let start = self.skip_blanks();
        let word = &self.bytes[start..];
        let digits = word.iter().take_while(|byte| byte.is_ascii_digit()).count();
        if word.is_empty() {
            return Err(truncated(format!("{what} is missing"), start));
        }
        if digits == 0 || word.get(digits).is_some_and(|next| !next.is_ascii_whitespace() && *next != b'#') {
            let end = word.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
            let sentence = format!("{what} is a whole number, not {}", quoted(&word[..end]));
            return Err(FormatError::new(Code::InvalidFile, sentence).at(Place::Byte(start)));
        }
        (self.start, self.at) = (start, start + digits);
        word[..digits]
            .iter()
            .try_fold(0usize, |sum, digit| sum.checked_mul(10)?.checked_add(usize::from(digit - b'0')))
            .ok_or_else(|| {
                let sentence = format!("{what} {} is too large", quoted(&word[..digits]));
                FormatError::new(Code::InvalidNumber, sentence).at(Place::Byte(start))
            })
    }

    fn skip_blanks(&mut self) -> usize {
        while let Some(byte) = self.bytes.get(self.at) {
            match byte {
                b'#' => {
                    let rest = &self.bytes[self.at..];
                    self.at += rest.iter().position(|byte| b"\r\n".contains(byte)).unwrap_or(rest.len());
                }
                byte if byte.is_ascii_whitespace() => self.at += 1,
                _ => break,
            }
        }
        self.at
    }
}
