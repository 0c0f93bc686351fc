//! Maps and scenarios of the MovingAI benchmarks: <https://movingai.com/benchmarks/formats.html>.
//!
//! `.` and `G` are free, and `S`, swamp; `@`, `O`, `T` are blocked, and `W`, water, which cannot be entered from land.
//! Their y points down: here row 0 is the highest y, and a scenario's cell (x, y) of a map with h rows has its middle
//! at (x + 0.5, h - y - 0.5) cells.

use crate::draft::{Draft, DraftQuery, stem};
use crate::error::{Code, FormatError, quoted};
use crate::grid::{Cell, Frame, Grid, cell_count};
use crate::options::Options;
use crate::raster::add_grid;
use crate::report::Format;
use crate::text::{self, Lines};

/// The letters of terrain and what they are.
const TERRAIN: [(u8, Cell); 7] = [
    (b'.', Cell::Free),
    (b'G', Cell::Free),
    (b'S', Cell::Free),
    (b'@', Cell::Occupied),
    (b'O', Cell::Occupied),
    (b'T', Cell::Occupied),
    (b'W', Cell::Occupied),
];

/// The most queries of a scenario file.
const MAX_QUERIES: usize = 100_000;

/// Whether the file begins like a map.
pub fn is_map(bytes: &[u8]) -> bool {
    let mut lines = Lines::of(bytes);
    lines.next().is_some_and(|(_, line)| line.starts_with(b"type "))
        && lines.next().is_some_and(|(_, line)| line.starts_with(b"height") || line.starts_with(b"width"))
}

/// Whether the file is a list of scenarios: a version, or rows of nine columns that end with numbers.
pub fn is_scenarios(bytes: &[u8]) -> bool {
    let mut lines = Lines::of(bytes).filter(|(_, line)| !line.is_empty());
    let Some((_, first)) = lines.next() else { return false };
    first.strip_prefix(b"version").is_some_and(|rest| text::number(rest.trim_ascii()).is_some())
}

/// Reads a map.
pub fn map(name: &str, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    let invalid = |line: usize, message: String| FormatError::at_line(Code::InvalidFile, line, message);
    let mut lines = Lines::of(bytes);
    let [mut width, mut height] = [None, None];
    let mut last = 0;
    loop {
        let Some((number, line)) = lines.next() else {
            return Err(FormatError::at_line(Code::Truncated, last, "the file ends before the rows of its map"));
        };
        last = number;
        let mut words = text::words(line);
        match words.next() {
            Some(b"type") => {
                let kind = words.next().unwrap_or_default();
                if kind != b"octile" {
                    let sentence = format!("the type of a map is octile, not {}", quoted(kind));
                    return Err(FormatError::at_line(Code::UnsupportedFeature, number, sentence));
                }
            }
            Some(key @ (b"height" | b"width")) => {
                let word = words.next().unwrap_or_default();
                let side = if key == b"width" { &mut width } else { &mut height };
                *side = Some(text::count(word).ok_or_else(|| {
                    let sentence = format!("the {} is a whole number, not {}", text::utf8(key), quoted(word));
                    FormatError::at_line(Code::InvalidNumber, number, sentence)
                })?);
            }
            Some(b"map") => break,
            None => {}
            Some(word) => return Err(invalid(number, format!("a map has no field {}", quoted(word)))),
        }
    }
    let (Some(width), Some(height)) = (width, height) else {
        return Err(invalid(last, "the width or the height is missing".to_owned()));
    };
    let count = cell_count(width, height)?;
    if count > bytes.len() {
        let sentence = format!("the file is too short for {width} x {height} cells");
        return Err(FormatError::at_line(Code::Truncated, last, sentence));
    }
    let mut cells = Vec::with_capacity(count);
    let mut counts = [0; TERRAIN.len()];
    for row in 0..height {
        let Some((number, line)) = lines.next() else {
            let sentence = format!("{row} of {height} rows are there");
            return Err(FormatError::at_line(Code::Truncated, last, sentence));
        };
        last = number;
        if line.len() != width {
            return Err(invalid(number, format!("the row has {} cells, but the width is {width}", line.len())));
        }
        for letter in line {
            let Some(i) = TERRAIN.iter().position(|(known, _)| known == letter) else {
                return Err(invalid(number, format!("there is no terrain {}", quoted(&[*letter]))));
            };
            counts[i] += 1;
            cells.push(TERRAIN[i].1);
        }
    }
    if let Some((number, _)) = lines.find(|(_, line)| !line.trim_ascii().is_empty()) {
        return Err(invalid(number, format!("there is more after the {height} rows")));
    }
    let mut draft = Draft::new(Format::MovingAi, name);
    let frame = Frame::of_scale(options.scale.unwrap_or(1.0));
    add_grid(&mut draft, Grid { width, height, cells, frame }, options)?;
    if let Some(grid) = &mut draft.report.grid {
        let kinds = TERRAIN.iter().zip(counts).filter(|(_, count)| *count > 0);
        grid.kinds = kinds.map(|(&(letter, _), count)| (char::from(letter).to_string(), count)).collect();
    }
    Ok(draft)
}

/// The name of the map that the first scenario names.
pub fn map_of(bytes: &[u8]) -> Option<String> {
    let (_, line) = Lines::of(bytes).skip(1).find(|(_, line)| !line.is_empty())?;
    fields(line).nth(1).map(text::utf8)
}

/// The columns of a row: between tabs, or between blanks where there are none.
fn fields(line: &[u8]) -> Box<dyn Iterator<Item = &[u8]> + '_> {
    if line.contains(&b'\t') {
        Box::new(line.split(|&byte| byte == b'\t').map(<[u8]>::trim_ascii))
    } else {
        Box::new(text::words(line))
    }
}

/// Adds the scenarios of a file as queries; their names are their numbers, from 0.
pub fn add_scenarios(draft: &mut Draft, bytes: &[u8]) -> Result<(), FormatError> {
    let invalid = |line: usize, message: String| FormatError::at_line(Code::InvalidNumber, line, message);
    let Some(grid) = &draft.grid else { return Ok(()) };
    let (width, height, scale) = (grid.width, grid.height, grid.frame.resolution);
    let mut of_others = 0;
    for (number, line) in Lines::of(bytes).skip(1).filter(|(_, line)| !line.trim_ascii().is_empty()) {
        let columns: Vec<&[u8]> = fields(line).collect();
        let &[bucket, map, w, h, x0, y0, x1, y1, length] = &columns[..] else {
            let sentence = format!("a scenario has 9 columns, not {}", columns.len());
            return Err(FormatError::at_line(Code::InvalidFile, number, sentence));
        };
        let whole = |what: &str, word: &[u8]| {
            text::count(word).ok_or_else(|| invalid(number, format!("{what} is a whole number, not {}", quoted(word))))
        };
        let (w, h) = (whole("the width", w)?, whole("the height", h)?);
        if (w, h) != (width, height) {
            let sentence = format!("the scenario is for a map of {w} x {h} cells, but the map has {width} x {height}");
            return Err(FormatError::at_line(Code::Contradiction, number, sentence));
        }
        let cell = |what: &str, x: &[u8], y: &[u8]| -> Result<[f64; 2], FormatError> {
            let (x, y) = (whole(what, x)?, whole(what, y)?);
            if x >= width || y >= height {
                return Err(invalid(number, format!("{what} is at cell ({x}, {y}) of {width} x {height}")));
            }
            Ok([(x as f64 + 0.5) * scale, ((height - y) as f64 - 0.5) * scale])
        };
        let (start, goal) = (cell("the start", x0, y0)?, cell("the goal", x1, y1)?);
        let Some(length) = text::number(length).filter(|length| *length >= 0.0) else {
            return Err(invalid(number, format!("the length is a number, not {}", quoted(length))));
        };
        if draft.queries.len() == MAX_QUERIES {
            let sentence = format!("there are more than {MAX_QUERIES} scenarios");
            return Err(FormatError::at_line(Code::WorldTooLarge, number, sentence));
        }
        of_others += usize::from(draft.name != "world" && stem(&text::utf8(map)) != draft.name);
        let mut query = DraftQuery::new(draft.queries.len().to_string(), start, goal);
        let bucket = whole("the bucket", bucket)?;
        query.read.bucket =
            Some(u32::try_from(bucket).map_err(|_| invalid(number, format!("the bucket {bucket} is too large")))?);
        query.read.length = Some(length * scale);
        draft.queries.push(query);
    }
    if of_others > 0 {
        draft.report.notes.push(format!("{of_others} scenarios name a map that is called otherwise"));
    }
    Ok(())
}
