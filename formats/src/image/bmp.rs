//! BMP without compression, of 1, 4, 8, 24 or 32 bits a pixel.
//!
//! The fourth byte of 32 bits counts as opacity only where the header says so (a mask of alpha), as it is 0 in most
//! files.

use super::{Cells, Pixel, truncated};
use crate::error::{Code, FormatError, Place};
use crate::grid::Cell;

/// Compression 0 is none, 3 and 6 are none with masks of the channels.
const MASKED: [u32; 2] = [3, 6];

pub fn read(bytes: &[u8], mut cell: impl FnMut(Pixel) -> Cell) -> Result<Cells, FormatError> {
    let invalid = |at: usize, message: String| Err(FormatError::new(Code::InvalidFile, message).at(Place::Byte(at)));
    let unsupported =
        |at: usize, message: String| Err(FormatError::new(Code::UnsupportedFeature, message).at(Place::Byte(at)));
    let short = |at: usize| u16::from_le_bytes([bytes[at], bytes[at + 1]]);
    let long = |at: usize| bytes.get(at..at + 4).map(|four| u32::from_le_bytes([four[0], four[1], four[2], four[3]]));
    let header = long(14).unwrap_or_default() as usize;
    if header < 40 {
        return unsupported(14, format!("a BMP with a header of {header} bytes is not read; 40 or more are needed"));
    }
    if bytes.len() < 54 {
        return Err(truncated("the header ends too early", bytes.len()));
    }
    let [width, height] = [18, 22].map(|at| long(at).unwrap_or_default().cast_signed());
    if width <= 0 || height == 0 {
        let sentence = format!("a picture of {width} x {height} pixels does not exist");
        return Err(FormatError::new(Code::InvalidNumber, sentence).at(Place::Byte(18)));
    }
    let is_top_down = height < 0;
    let [width, height] = [width.unsigned_abs() as usize, height.unsigned_abs() as usize];
    let (bits, compression) = (usize::from(short(28)), long(30).unwrap_or_default());
    let is_masked = MASKED.contains(&compression) && bits == 32;
    if compression != 0 && !is_masked {
        return unsupported(30, format!("compression {compression} of a BMP is not read; save it without"));
    }
    let masks = [54, 58, 62].map(|at| if is_masked { long(at) } else { None });
    if is_masked && masks != [0xff_0000, 0xff00, 0xff].map(Some) {
        return unsupported(54, "a BMP of 32 bits has blue, green and red in this order, or is not read".to_owned());
    }
    let has_alpha = is_masked && (header >= 56 || compression == 6) && long(66) == Some(0xff00_0000);
    let palette = match bits {
        1 | 4 | 8 => {
            let count = match long(46).unwrap_or_default() as usize {
                0 => 1 << bits,
                count => count.min(1 << bits),
            };
            let colors = bytes.get(14 + header..).and_then(|rest| rest.get(..4 * count));
            let Some(colors) = colors else { return Err(truncated("the palette ends too early", bytes.len())) };
            colors.chunks_exact(4).map(|color| color[..3].iter().map(|&part| u32::from(part)).sum()).collect()
        }
        24 | 32 => Vec::<u32>::new(),
        _ => return unsupported(28, format!("a BMP of {bits} bits a pixel is not read; 1, 4, 8, 24 and 32 are")),
    };
    let mut cells = Cells::for_size(width, height)?;
    // Rows are filled up to four bytes.
    let stride = (width * bits).div_ceil(32) * 4;
    let start = long(10).unwrap_or_default() as usize;
    let Some(data) = bytes.get(start..).and_then(|rest| rest.get(..stride * height)) else {
        return Err(truncated(format!("the file is too short for {width} x {height} pixels"), bytes.len()));
    };
    for row in 0..height {
        let place = if is_top_down { row } else { height - 1 - row };
        let line = &data[place * stride..][..stride];
        for x in 0..width {
            let (sum, alpha) = if bits >= 24 {
                let pixel = &line[x * bits / 8..][..bits / 8];
                let sum = pixel[..3].iter().map(|&part| u32::from(part)).sum();
                (sum, has_alpha.then(|| u32::from(pixel[3])))
            } else {
                let shift = 8 - bits - x * bits % 8;
                let index = usize::from(line[x * bits / 8] >> shift) & ((1 << bits) - 1);
                let Some(&sum) = palette.get(index) else {
                    return invalid(
                        start + place * stride + x * bits / 8,
                        format!("a pixel has colour {index}, but the palette has {}", palette.len()),
                    );
                };
                (sum, None)
            };
            cells.cells.push(cell(Pixel { sum, channels: 3, alpha, most: 255 }));
        }
    }
    Ok(cells)
}
