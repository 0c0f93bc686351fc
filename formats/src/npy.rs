//! NumPy's array files, `.npy`, versions 1 to 3: truth values, integers and floating-point numbers of either byte
//! order, in C or Fortran order. Written is version 1 with 64-bit floating-point numbers.

use npyz::{DType, Deserialize, NpyFile, NpyHeader, Order, TypeChar};

/// An array of two dimensions, row by row.
pub struct Table {
    /// The numbers per row.
    pub width: usize,
    /// The numbers, row by row.
    pub numbers: Vec<f64>,
}

/// The first bytes of such a file.
pub const MAGIC: &[u8] = b"\x93NUMPY";

/// The most brackets that a header opens: npyz takes exponential time if they are nested. That of an array of numbers
/// opens two.
const MOST_BRACKETS: usize = 6;

/// Reads rows of numbers.
///
/// # Errors
/// A sentence about the file.
pub fn read(bytes: &[u8]) -> Result<Table, String> {
    // npyz reserves memory for a header of any length, up to 4 GB.
    let (start, length) = match bytes.get(MAGIC.len()..MAGIC.len() + 6) {
        Some(&[1, _, a, b, ..]) => (10, u16::from_le_bytes([a, b]).into()),
        Some(&[_, _, a, b, c, d]) => (12, u32::from_le_bytes([a, b, c, d]) as usize),
        _ => (0, bytes.len()),
    };
    let Some(header) = bytes.get(start..).and_then(|rest| rest.get(..length)) else {
        return Err("it ends within its header".to_owned());
    };
    if header.iter().filter(|byte| b"{[(".contains(byte)).count() > MOST_BRACKETS {
        return Err("its header is not that of an array of numbers".to_owned());
    }
    let mut data = bytes;
    let header = NpyHeader::from_reader(&mut data).map_err(|error| error.to_string())?;
    let &[height, width] = header.shape() else {
        return Err(format!("its shape must have two numbers, rows and columns, not {:?}", header.shape()));
    };
    let DType::Plain(kind) = header.dtype() else { return Err("it contains records, not numbers".to_owned()) };
    // The product that npyz takes of the shape may have wrapped around.
    let size = height.checked_mul(width).and_then(|count| count.checked_mul(kind.size_field()));
    if size != Some(data.len() as u64) {
        return Err(format!("{height} rows of {width} numbers do not take {} bytes", data.len()));
    }
    let order = header.order();
    let file = NpyFile::with_header(header, data);
    let stored = match (kind.type_char(), kind.size_field()) {
        (TypeChar::Bool, 1) => numbers(file, |x: bool| f64::from(u8::from(x))),
        (TypeChar::Float, 8) => numbers(file, |x: f64| x),
        (TypeChar::Float, 4) => numbers(file, |x: f32| x.into()),
        (TypeChar::Int, 1) => numbers(file, |x: i8| x.into()),
        (TypeChar::Int, 2) => numbers(file, |x: i16| x.into()),
        (TypeChar::Int, 4) => numbers(file, |x: i32| x.into()),
        (TypeChar::Int, 8) => numbers(file, |x: i64| x as f64),
        (TypeChar::Uint, 1) => numbers(file, |x: u8| x.into()),
        (TypeChar::Uint, 2) => numbers(file, |x: u16| x.into()),
        (TypeChar::Uint, 4) => numbers(file, |x: u32| x.into()),
        (TypeChar::Uint, 8) => numbers(file, |x: u64| x as f64),
        _ => return Err(format!("its numbers are of the type {:?}, which is not read", kind.to_string())),
    }?;
    let [height, width] = [height, width].map(|side| side as usize);
    let numbers = match order {
        Order::C => stored,
        Order::Fortran => (0..stored.len()).map(|i| stored[i % width * height + i / width]).collect(),
    };
    Ok(Table { width, numbers })
}

/// An array of rows, `width` numbers each, as version 1: little-endian 64-bit floating-point numbers.
///
/// # Panics
/// Never: the header of two whole numbers is shorter than the 65,535 bytes that version 1 allows.
pub fn write(width: usize, numbers: &[f64]) -> Vec<u8> {
    let height = numbers.len().checked_div(width).unwrap_or(0);
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({height}, {width}), }}");
    // The numbers begin at a multiple of 64 bytes: after the mark, two bytes of the version, two of the length, and a line break.
    let length = (MAGIC.len() + 4 + header.len() + 1).next_multiple_of(64) - MAGIC.len() - 4;
    let mut bytes = MAGIC.to_vec();
    bytes.extend([1, 0]);
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{header:<0$}\n", length - 1).as_bytes());
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

/// All numbers of a file, in the order in which they are stored.
fn numbers<T: Deserialize>(file: NpyFile<&[u8]>, convert: fn(T) -> f64) -> Result<Vec<f64>, String> {
    let stored = file.data::<T>().map_err(|error| error.to_string())?;
    stored.map(|number| number.map(convert)).collect::<Result<_, _>>().map_err(|error| error.to_string())
}
