//! NumPy's array files, `.npy`: a magic string, a header (a literal of a Python dictionary), and the numbers. Versions 1 to 3 are
//! read, whole and real numbers of either byte order, in C or Fortran order.

/// An array of two dimensions, row by row.
pub struct Table {
    /// How many numbers a row has.
    pub width: usize,
    /// The numbers.
    pub numbers: Vec<f64>,
}

const MAGIC: &[u8] = b"\x93NUMPY";

/// Whether the bytes begin as such a file does.
pub fn is_npy(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// Reads rows of numbers.
///
/// # Errors
/// What is wrong with the file, in a sentence.
pub fn read(bytes: &[u8]) -> Result<Table, String> {
    let rest = bytes.strip_prefix(MAGIC).ok_or("it does not begin with \\x93NUMPY")?;
    let (&[major, _minor], rest) = rest.split_first_chunk().ok_or("it ends within its header")?;
    let (length, rest) = match major {
        1 => rest.split_first_chunk().map(|(size, rest)| (usize::from(u16::from_le_bytes(*size)), rest)),
        2 | 3 => rest.split_first_chunk().map(|(size, rest)| (u32::from_le_bytes(*size) as usize, rest)),
        _ => return Err(format!("version {major} is not one of 1, 2 and 3")),
    }
    .ok_or("it ends within its header")?;
    let (header, data) = rest.split_at_checked(length).ok_or("it ends within its header")?;
    let header = std::str::from_utf8(header).map_err(|_| "its header is not text")?;
    let kind =
        field(header, "descr").and_then(|value| value.strip_prefix('\'')).and_then(|value| value.split('\'').next());
    let kind = kind.ok_or("it holds something else than an array of numbers")?;
    let is_fortran = match field(header, "fortran_order") {
        Some(value) if value.starts_with("True") => true,
        Some(value) if value.starts_with("False") => false,
        _ => return Err("its header does not say in which order the numbers stand".to_owned()),
    };
    let shape = field(header, "shape").and_then(|value| value.strip_prefix('(')?.split(')').next());
    let sides: Option<Vec<usize>> = shape.and_then(|shape| {
        shape.split(',').map(str::trim).filter(|side| !side.is_empty()).map(|side| side.parse().ok()).collect()
    });
    let Some([height, width]) = sides.as_deref().and_then(|sides| <[usize; 2]>::try_from(sides).ok()) else {
        return Err(format!("its shape must have two numbers, rows and columns, not ({})", shape.unwrap_or("")));
    };
    let (size, number) =
        reader(kind).ok_or_else(|| format!("its numbers are of the type {kind:?}, which is not read"))?;
    let count = height.checked_mul(width).filter(|count| count.checked_mul(size) == Some(data.len()));
    let count = count.ok_or_else(|| format!("{height} rows of {width} numbers do not take {} bytes", data.len()))?;
    let at = |i: usize| if is_fortran { i % width * height + i / width } else { i };
    let numbers = (0..count).map(|i| number(&data[at(i) * size..][..size])).collect();
    Ok(Table { width, numbers })
}

/// What stands behind the name of a field.
fn field<'a>(header: &'a str, name: &str) -> Option<&'a str> {
    let (_, after) = header.split_once(&format!("'{name}':"))?;
    Some(after.trim_start())
}

/// How many bytes a number of this type has, and what it is.
type Reader = (usize, Box<dyn Fn(&[u8]) -> f64>);

/// The reader of a type, such as `<f8`.
fn reader(kind: &str) -> Option<Reader> {
    let (order, kind) = kind.split_at_checked(1)?;
    let is_big = match order {
        "<" | "|" | "=" => false,
        ">" => true,
        _ => return None,
    };
    let (letter, size) = kind.split_at_checked(1)?;
    let size: usize = size.parse().ok()?;
    let convert: fn(u64) -> f64 = match (letter, size) {
        ("f", 8) => f64::from_bits,
        ("f", 4) => |bits| f64::from(f32::from_bits(bits as u32)),
        ("i", 1) => |bits| f64::from(bits as i8),
        ("i", 2) => |bits| f64::from(bits as i16),
        ("i", 4) => |bits| f64::from(bits as i32),
        ("i", 8) => |bits| bits as i64 as f64,
        ("u", 1 | 2 | 4 | 8) => |bits| bits as f64,
        _ => return None,
    };
    let read = move |bytes: &[u8]| {
        let shift = |bits: u64, byte: &u8| (bits << 8) | u64::from(*byte);
        convert(if is_big { bytes.iter().fold(0, shift) } else { bytes.iter().rev().fold(0, shift) })
    };
    Some((size, Box::new(read)))
}
