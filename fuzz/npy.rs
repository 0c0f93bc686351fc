//! The reader of NumPy arrays, given any bytes.

use planarium_formats::npy::read;

/// A NumPy array: its rows are whole, and no longer than the file.
pub fn npy(bytes: &[u8]) {
    let Ok(table) = read(bytes) else { return };
    assert!(table.numbers.len() <= bytes.len());
    assert!(table.width == 0 || table.numbers.len().is_multiple_of(table.width));
}
