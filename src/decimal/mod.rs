//! Decimal numbers to the last bit: text read as the nearest 64-bit float, floats shown with the fewest digits that read back
//! to the same bits.
//!
//! Easy numbers, up to 15 digits or so, take one multiplication or division by an exact power of ten (Clinger 1990, "How to
//! read floating point numbers accurately"). All others are compared as whole numbers of any length (Steele and White 1990,
//! "How to print floating-point numbers accurately"), about a microsecond each. There are no tables: in WebAssembly this room
//! is a tenth of what it replaces.

mod big;
mod read;
mod shortest;
mod show;

pub use read::read;
pub(crate) use show::exact;
pub use show::{Decimal, Row};

/// 10^0 to 10^22, the powers of ten that a float holds exactly.
fn power_of_ten(exponent: usize) -> f64 {
    // Every product is exact.
    (0..exponent).fold(1.0, |power, _| power * 10.0)
}

/// The largest exponent of [`power_of_ten`].
const LARGEST_EXACT: usize = 22;
