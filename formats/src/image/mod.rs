//! Pictures, pixel by pixel: PGM, PNG and BMP.

mod bmp;
mod pgm;
mod png;

use crate::error::{Code, FormatError};
use crate::grid::{Cell, Grid, cell_count};

/// The first bytes of a PNG.
pub const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// A pixel: the sum of its colour channels, how many there are, its opacity, and the largest value of a channel.
#[derive(Clone, Copy)]
pub struct Pixel {
    pub sum: u32,
    pub channels: u32,
    /// `None` if the picture has no transparency.
    pub alpha: Option<u32>,
    pub most: u32,
}

impl Pixel {
    /// The mean of the colour channels, from 0 for black to 1.
    pub fn brightness(self) -> f64 {
        f64::from(self.sum) / f64::from(self.channels * self.most)
    }

    /// The mean of the colour channels and the opacity.
    pub fn with_alpha(self) -> f64 {
        // A picture of one channel with transparency counts as one of three.
        let [sum, channels] = if self.channels == 1 { [3 * self.sum, 3] } else { [self.sum, self.channels] };
        self.alpha.map_or(self.brightness(), |alpha| {
            f64::from(sum + alpha) / (f64::from(channels + 1) * f64::from(self.most))
        })
    }

    pub fn is_opaque(self) -> bool {
        self.alpha.is_none_or(|alpha| alpha == self.most)
    }

    /// Whether nothing of its colour can be seen.
    pub fn is_clear(self) -> bool {
        self.alpha == Some(0)
    }
}

/// Which picture the bytes are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Picture {
    Pgm,
    Png,
    Bmp,
}

impl Picture {
    /// By the first bytes.
    pub fn of(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [b'P', b'2' | b'5', next, ..] if next.is_ascii_whitespace() || *next == b'#' => Some(Self::Pgm),
            // The size of the second header.
            [b'B', b'M', ..] if matches!(bytes.get(14..18), Some([12..=124, 0, 0, 0])) => Some(Self::Bmp),
            _ => bytes.starts_with(PNG).then_some(Self::Png),
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Pgm => "PGM",
            Self::Png => "PNG",
            Self::Bmp => "BMP",
        }
    }

    /// Reads all pixels, row by row from the top, as cells; the grid has no place yet.
    pub fn read(self, bytes: &[u8], cell: impl FnMut(Pixel) -> Cell) -> Result<Cells, FormatError> {
        match self {
            Self::Pgm => pgm::read(bytes, cell),
            Self::Png => png::read(bytes, cell),
            Self::Bmp => bmp::read(bytes, cell),
        }
    }
}

/// The cells of a picture without a place.
pub struct Cells {
    pub width: usize,
    pub height: usize,
    pub cells: Vec<Cell>,
}

impl Cells {
    /// No cell yet; refuses sizes beyond the limits before memory is taken.
    pub fn for_size(width: usize, height: usize) -> Result<Self, FormatError> {
        Ok(Self { width, height, cells: Vec::with_capacity(cell_count(width, height)?) })
    }

    /// With a place.
    pub fn in_frame(self, frame: crate::grid::Frame) -> Grid {
        Grid { width: self.width, height: self.height, cells: self.cells, frame }
    }
}

/// The error for a file that ends too early.
fn truncated(message: impl Into<String>, at: usize) -> FormatError {
    FormatError::new(Code::Truncated, message).at(crate::error::Place::Byte(at))
}
