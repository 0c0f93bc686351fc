//! The reader of NumPy arrays of the command line, given any bytes.

#[path = "../cli/src/npy.rs"]
mod file;

/// A NumPy array: its rows are whole, and no longer than the file.
pub fn npy(bytes: &[u8]) {
    let Ok(table) = file::read(bytes) else { return };
    assert!(table.numbers.len() <= bytes.len());
    assert!(table.width == 0 || table.numbers.len().is_multiple_of(table.width));
}
