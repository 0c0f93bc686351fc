//! The two-dimensional test files of OMPL: a grid with start and end (`tests/resources/env1.txt`), and circles with
//! queries (`circle_obstacles.txt`, `circle_queries.txt`).
//!
//! In OMPL the first number of a cell is its row, the second its column; here row 0 is the highest y.

use crate::draft::{Draft, DraftQuery};
use crate::error::{Code, FormatError, quoted};
use crate::grid::{Cell, Frame, Grid, cell_count};
use crate::numbers::{bounds_of, note_scale};
use crate::options::Options;
use crate::raster::add_grid;
use crate::report::Format;
use crate::text::{self, Lines};
use planarium::geometry::{Aabb, Point};
use planarium::scenario::MAX_OBSTACLES;

/// The first word of a grid.
const GRID: &[u8] = b"discretization(cells):";

/// The most queries of a file.
const MAX_QUERIES: usize = 100_000;

/// Whether the file is a grid.
pub fn is_grid(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().starts_with(GRID)
}

/// Whether the file is a list of circles: units, then the names of the columns.
pub fn is_circles(bytes: &[u8]) -> bool {
    let mut lines = Lines::of(bytes);
    let units = lines.next().is_some_and(|(_, line)| line.starts_with(b"units:"));
    units && lines.next().is_some_and(|(_, line)| text::words(line).eq([b"x", b"y", b"r"]))
}

/// Whether the file is a list of queries.
pub fn is_queries(bytes: &[u8]) -> bool {
    let Some((_, line)) = Lines::of(bytes).next() else { return false };
    text::words(line).nth(1) == Some(b"start:")
}

/// Reads a grid.
pub fn grid(name: &str, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    let mut lines = Lines::of(bytes).filter(|(_, line)| !line.trim_ascii().is_empty());
    let mut field = |name: &'static [u8]| -> Result<(usize, [usize; 2]), FormatError> {
        let missing = || FormatError::new(Code::Truncated, format!("the line {} is missing", text::utf8(name)));
        let (number, line) = lines.next().ok_or_else(missing)?;
        let mut words = text::words(line);
        let found = words.next().unwrap_or_default();
        if found != name {
            let sentence = format!("the line begins with {}, not {}", text::utf8(name), quoted(found));
            return Err(FormatError::at_line(Code::InvalidFile, number, sentence));
        }
        let pair = [words.next(), words.next()].map(|word| word.and_then(text::count));
        let [Some(first), Some(second)] = pair else {
            let sentence = format!("{} takes two whole numbers", text::utf8(name));
            return Err(FormatError::at_line(Code::InvalidNumber, number, sentence));
        };
        Ok((number, [first, second]))
    };
    let (_, [height, width]) = field(GRID)?;
    let ends = [field(b"start(cells):")?, field(b"end(cells):")?];
    let count = cell_count(width, height)?;
    if count > bytes.len() {
        return Err(FormatError::new(Code::Truncated, format!("the file is too short for {height} x {width} cells")));
    }
    match lines.next() {
        Some((_, line)) if line.trim_ascii() == b"environment:" => {}
        Some((number, line)) => {
            let sentence = format!("the line is environment:, not {}", quoted(line));
            return Err(FormatError::at_line(Code::InvalidFile, number, sentence));
        }
        None => return Err(FormatError::new(Code::Truncated, "the line environment: is missing")),
    }
    let mut cells = Vec::with_capacity(count);
    for (number, line) in lines {
        for word in text::words(line) {
            cells.push(match word {
                b"0" => Cell::Free,
                b"1" => Cell::Occupied,
                _ => {
                    let sentence = format!("a cell is 0 or 1, not {}", quoted(word));
                    return Err(FormatError::at_line(Code::InvalidNumber, number, sentence));
                }
            });
        }
        if cells.len() > count {
            let sentence = format!("there are more than {height} x {width} cells");
            return Err(FormatError::at_line(Code::InvalidFile, number, sentence));
        }
    }
    if cells.len() < count {
        return Err(FormatError::new(
            Code::Truncated,
            format!("{} of {height} x {width} cells are there", cells.len()),
        ));
    }
    let scale = options.scale.unwrap_or(1.0);
    let mut draft = Draft::new(Format::OmplGrid, name);
    add_grid(&mut draft, Grid { width, height, cells, frame: Frame::of_scale(scale) }, options)?;
    let middle = |(number, [row, column]): (usize, [usize; 2])| {
        if row >= height || column >= width {
            let sentence = format!("cell ({row}, {column}) lies outside {height} x {width} cells");
            return Err(FormatError::at_line(Code::InvalidNumber, number, sentence));
        }
        Ok([(column as f64 + 0.5) * scale, ((height - row) as f64 - 0.5) * scale])
    };
    let [start, goal] = ends;
    draft.queries.push(DraftQuery::new("start to end", middle(start)?, middle(goal)?));
    note_scale(&mut draft, options);
    Ok(draft)
}

/// Reads circles: a number, x, y and radius in each line.
pub fn circles(name: &str, bytes: &[u8]) -> Result<Draft, FormatError> {
    let mut draft = Draft::new(Format::OmplCircles, name);
    for (number, line) in Lines::of(bytes).skip(2).filter(|(_, line)| !line.trim_ascii().is_empty()) {
        let numbers = numbers(number, line, "a circle has a number, x, y and a radius")?;
        let [_, x, y, radius] = numbers;
        if radius < 0.0 {
            return Err(FormatError::at_line(Code::InvalidNumber, number, format!("the radius {radius} is negative")));
        }
        if draft.discs.len() == MAX_OBSTACLES {
            let sentence = format!("there are more than {MAX_OBSTACLES} circles");
            return Err(FormatError::at_line(Code::WorldTooLarge, number, sentence));
        }
        draft.discs.push((Point::new(x, y), radius));
    }
    draft.bounds = bounds_of(&draft.discs);
    draft.report.notes.push("the bounds are the box around all circles, as in OMPL's tests".to_owned());
    Ok(draft)
}

/// Adds queries: two lines each, its start and its goal.
pub fn add_queries(draft: &mut Draft, bytes: &[u8]) -> Result<(), FormatError> {
    let mut start: Option<(Vec<u8>, [f64; 2])> = None;
    let mut last = 0;
    for (number, line) in Lines::of(bytes).filter(|(_, line)| !line.trim_ascii().is_empty()) {
        let invalid = |message: String| Err(FormatError::at_line(Code::InvalidFile, number, message));
        last = number;
        let words: Vec<&[u8]> = text::words(line).collect();
        let &[name, what, x, y] = &words[..] else {
            return invalid(format!("a line has a name, start: or goal:, x and y, not {} words", words.len()));
        };
        let (Some(x), Some(y)) = (text::number(x), text::number(y)) else {
            let sentence = format!("{} and {} are not two finite numbers", quoted(x), quoted(y));
            return Err(FormatError::at_line(Code::InvalidNumber, number, sentence));
        };
        start = match (what, start.take()) {
            (b"start:", None) => Some((name.to_owned(), [x, y])),
            (b"goal:", Some((begun, from))) if begun == name => {
                if draft.queries.len() == MAX_QUERIES {
                    let sentence = format!("there are more than {MAX_QUERIES} queries");
                    return Err(FormatError::at_line(Code::WorldTooLarge, number, sentence));
                }
                draft.queries.push(DraftQuery::new(text::utf8(name), from, [x, y]));
                None
            }
            _ => return invalid(format!("{} {} has no place here", quoted(name), quoted(what))),
        };
    }
    if start.is_some() {
        return Err(FormatError::at_line(Code::Truncated, last, "the last query has no goal"));
    }
    let ends = draft.queries.iter().flat_map(|query| [query.start, query.goal]);
    let outside = ends.clone().filter(|&[x, y]| !draft.bounds.contains(Point::new(x, y))).count();
    if outside > 0 {
        let bounds = Aabb::around(ends.map(|[x, y]| Point::new(x, y))).map(|around| around.union(&draft.bounds));
        draft.bounds = bounds.unwrap_or(draft.bounds);
        draft
            .report
            .notes
            .push(format!("{outside} ends of queries lie outside that box: the bounds were widened to them"));
    }
    Ok(())
}

fn numbers<const N: usize>(number: usize, line: &[u8], form: &str) -> Result<[f64; N], FormatError> {
    let words: Vec<&[u8]> = text::words(line).collect();
    let Ok(words) = <[&[u8]; N]>::try_from(&words[..]) else {
        return Err(FormatError::at_line(Code::InvalidFile, number, format!("{form}, not {} words", words.len())));
    };
    let mut values = [0.0; N];
    for (value, word) in values.iter_mut().zip(words) {
        *value = text::number(word).ok_or_else(|| {
            FormatError::at_line(Code::InvalidNumber, number, format!("{} is not a finite number", quoted(word)))
        })?;
    }
    Ok(values)
}
