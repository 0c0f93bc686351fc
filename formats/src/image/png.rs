//! PNG of every colour type and depth, by the crate png: no more is decompressed than the header announces.

use super::{Cells, Pixel, truncated};
use crate::error::{Code, FormatError};
use crate::grid::Cell;
use png::{ColorType, Decoder, DecodingError, Limits, Transformations};
use std::io::Cursor;

/// The most bytes that the decoder takes beside a row, and an interlaced picture, which is decoded as a whole.
const MAX_BYTES: usize = 256 << 20;

pub fn read(bytes: &[u8], mut cell: impl FnMut(Pixel) -> Cell) -> Result<Cells, FormatError> {
    let failed = |error: DecodingError| failed(&error, bytes.len());
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), Limits { bytes: MAX_BYTES });
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    // Palettes become colours, and what is transparent has an opacity.
    decoder.set_transformations(Transformations::EXPAND);
    // The size alone, before the decoder takes memory for it.
    let header = decoder.read_header_info().map_err(failed)?;
    let (width, height, is_interlaced) = (header.width as usize, header.height as usize, header.interlaced);
    let mut cells = Cells::for_size(width, height)?;
    let mut reader = decoder.read_info().map_err(failed)?;
    let (color, depth) = reader.output_color_type();
    let (channels, has_alpha) = match color {
        ColorType::Grayscale => (1, false),
        ColorType::GrayscaleAlpha => (1, true),
        ColorType::Rgb => (3, false),
        ColorType::Rgba => (3, true),
        ColorType::Indexed => return Err(FormatError::new(Code::InvalidFile, "the picture has no palette")),
    };
    let size = depth as usize / 8;
    if size == 0 {
        return Err(FormatError::new(Code::InvalidFile, "the depth of the picture is invalid"));
    }
    let most = if size == 1 { 255 } else { 65535 };
    let mut push_row = |row: &[u8]| {
        for pixel in row.chunks_exact((channels + usize::from(has_alpha)) * size) {
            let value = |i: usize| pixel[i * size..][..size].iter().fold(0, |sum, &byte| 256 * sum + u32::from(byte));
            let sum = (0..channels).map(value).sum();
            let alpha = has_alpha.then(|| value(channels));
            cells.cells.push(cell(Pixel { sum, channels: channels as u32, alpha, most }));
        }
    };
    if is_interlaced {
        let size = reader.output_buffer_size().filter(|&size| size <= MAX_BYTES).ok_or_else(|| {
            let sentence =
                format!("an interlaced picture may take {MAX_BYTES} bytes; save this one without interlacing");
            FormatError::new(Code::WorldTooLarge, sentence)
        })?;
        let mut buffer = vec![0; size];
        reader.next_frame(&mut buffer).map_err(failed)?;
        push_row(&buffer);
    } else {
        while let Some(row) = reader.next_row().map_err(failed)? {
            push_row(row.data());
        }
    }
    if cells.cells.len() != width * height {
        return Err(truncated(format!("{} of {width} x {height} pixels are there", cells.cells.len()), bytes.len()));
    }
    Ok(cells)
}

fn failed(error: &DecodingError, length: usize) -> FormatError {
    match error {
        DecodingError::IoError(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
            truncated("the picture ends too early", length)
        }
        DecodingError::LimitsExceeded => {
            FormatError::new(Code::WorldTooLarge, format!("decoding the picture takes more than {MAX_BYTES} bytes"))
        }
        error => FormatError::new(Code::InvalidFile, format!("the PNG is damaged: {error}")),
    }
}
