//! Tables of numbers without a header: 0-1 grids, parking cases, the obstacles of Modern Robotics. Their shape tells
//! which it is.

use crate::draft::{Draft, DraftQuery};
use crate::error::{Code, FormatError, Place, quoted};
use crate::grid::{Cell, Frame, Grid, cell_count};
use crate::npy;
use crate::options::Options;
use crate::raster::add_grid;
use crate::report::Format;
use crate::text::{self, Lines};
use planarium::geometry::{Aabb, Point};
use planarium::robot::{Car, Weights};
use planarium::scenario::{self, GoalTolerance, MAX_OBSTACLES, MAX_VERTICES};

/// The rows of a table.
pub struct Table {
    rows: Vec<Row>,
    /// How many numbers each row has, where all have as many.
    width: Option<usize>,
    /// Whether it has digits without anything between them.
    is_dense: bool,
}

struct Row {
    line: usize,
    numbers: Vec<f64>,
}

impl Table {
    /// Reads rows of numbers between commas, semicolons or blanks; a row of only zeros and ones may have nothing
    /// between them. Lines that begin with # and empty ones are skipped.
    ///
    /// # Errors
    /// `unknown-world` if something is no number, `invalid-number` if one is not finite
    pub fn read(bytes: &[u8]) -> Result<Self, FormatError> {
        let mut rows: Vec<Row> = Vec::new();
        let mut is_dense = false;
        for (line, text) in Lines::of(bytes) {
            let text = text.trim_ascii();
            if text.is_empty() || text.starts_with(b"#") {
                continue;
            }
            let numbers = if text.len() > 1 && text.iter().all(|byte| b"01".contains(byte)) {
                is_dense = true;
                text.iter().map(|byte| f64::from(byte - b'0')).collect()
            } else {
                numbers(line, text)?
            };
            rows.push(Row { line, numbers });
        }
        let first = rows.first().map(|row| row.numbers.len());
        let width = first.filter(|&width| rows.iter().all(|row| row.numbers.len() == width));
        Ok(Self { rows, width, is_dense })
    }

    /// What the table is; `None` for none of them.
    pub fn format(&self, options: &Options) -> Option<Format> {
        let are_all =
            |known: [f64; 3]| self.rows.iter().flat_map(|row| &row.numbers).all(|number| known.contains(number));
        if self.rows.is_empty() {
            return None;
        }
        if self.is_dense || are_all([-1.0, 0.0, 1.0]) {
            return Some(Format::Grid);
        }
        if self.rows.len() == 1 && self.rows[0].numbers.len() >= 7 {
            return Some(Format::Tpcap);
        }
        match self.width {
            Some(_) if options.threshold.is_some() => Some(Format::Grid),
            // Values of an occupancy grid are no discs.
            Some(3) if !are_all([-1.0, 0.0, 100.0]) => Some(Format::ModernRobotics),
            _ => None,
        }
    }

    /// As a grid, row 0 at the top.
    pub fn grid(&self, name: &str, options: &Options) -> Result<Draft, FormatError> {
        let first = self.rows.first().map_or(0, |row| row.numbers.len());
        let mut cells = Vec::with_capacity(cell_count(first, self.rows.len())?);
        for Row { line, numbers } in &self.rows {
            if numbers.len() != first {
                let sentence = format!("the row has {} cells, but the first one has {first}", numbers.len());
                return Err(FormatError::at_line(Code::InvalidFile, *line, sentence));
            }
            for &number in numbers {
                let cell =
                    cell(number, options).map_err(|message| FormatError::at_line(Code::InvalidNumber, *line, message));
                cells.push(cell?);
            }
        }
        grid_of(name, first, cells, options)
    }

    /// As a parking case: start and goal with headings, the number of obstacles, how many corners each has, and the
    /// corners. <https://www.tpcap.net/#/benchmarks>
    pub fn parking(&self, name: &str) -> Result<Draft, FormatError> {
        let Row { line, numbers } = &self.rows[0];
        let truncated =
            |what: &str| FormatError::at_line(Code::Truncated, *line, format!("the case ends before {what}"));
        let invalid = |message: String| FormatError::at_line(Code::InvalidNumber, *line, message);
        let &[x0, y0, heading0, x1, y1, heading1, count, ref rest @ ..] = &numbers[..] else {
            return Err(truncated("the number of its obstacles"));
        };
        let count = whole(count, MAX_OBSTACLES)
            .ok_or_else(|| invalid(format!("the number of obstacles is from 0 to {MAX_OBSTACLES}, not {count}")))?;
        let (counts, mut corners) = rest.split_at_checked(count).ok_or_else(|| truncated("the numbers of corners"))?;
        let mut draft = Draft::new(Format::Tpcap, name);
        for (i, &count) in counts.iter().enumerate() {
            let count = whole(count, MAX_VERTICES).filter(|&count| count > 0).ok_or_else(|| {
                invalid(format!("an obstacle has from 1 to {MAX_VERTICES} corners, not {count}"))
                    .at(Place::Element(format!("obstacle {i}")))
            })?;
            let Some((own, rest)) = corners.split_at_checked(2 * count) else {
                return Err(truncated("all corners").at(Place::Element(format!("obstacle {i}"))));
            };
            draft.polygons.push(own.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect());
            corners = rest;
        }
        if !corners.is_empty() {
            let sentence = format!("{} numbers follow after all corners", corners.len());
            return Err(FormatError::at_line(Code::InvalidFile, *line, sentence));
        }
        let ends = [Point::new(x0, y0), Point::new(x1, y1)];
        let all = draft.polygons.iter().flatten().copied().chain(ends);
        draft.bounds = Aabb::around(all).expect("it has a start").grown(PARKING_MARGIN);
        draft
            .report
            .notes
            .push(format!("the format has no bounds: they are {PARKING_MARGIN} m from all obstacles, start and goal"));
        let mut query = DraftQuery::new("park", [x0, y0], [x1, y1]);
        query.headings = Some([heading0, heading1]);
        query.tolerance = Some(GoalTolerance { translation: 0.25, rotation: 0.1 });
        draft.queries.push(query);
        let words = "the car of the competition: 4.689 x 1.942 m, wheelbase 2.8 m, steering up to 0.75 rad, 2.5 m/s";
        draft.robot = Some((parking_car()?.into(), words));
        Ok(draft)
    }

    /// As the obstacles of the course Modern Robotics: x, y and diameter of discs in a square of side 1 about the
    /// origin, in which a point goes from the lower left corner to the upper right one.
    pub fn modern_robotics(&self, name: &str) -> Result<Draft, FormatError> {
        let mut draft = Draft::new(Format::ModernRobotics, name);
        let square = Aabb::of(Point::new(-0.5, -0.5), Point::new(0.5, 0.5));
        let mut is_in_square = true;
        for Row { line, numbers } in &self.rows {
            let &[x, y, diameter] = &numbers[..] else {
                let sentence = format!("an obstacle has 3 numbers, x, y and diameter, not {}", numbers.len());
                return Err(FormatError::at_line(Code::InvalidFile, *line, sentence));
            };
            if diameter < 0.0 {
                return Err(FormatError::at_line(
                    Code::InvalidNumber,
                    *line,
                    format!("the diameter {diameter} is negative"),
                ));
            }
            let center = Point::new(x, y);
            is_in_square &= square.contains(center);
            draft.discs.push((center, diameter / 2.0));
        }
        draft.bounds = if is_in_square {
            draft.queries.push(DraftQuery::new("corner to corner", [-0.5, -0.5], [0.5, 0.5]));
            draft
                .report
                .notes
                .push("bounds, start and goal are those of the course's task, the square of side 1".to_owned());
            square
        } else {
            draft.report.notes.push(
                "obstacles lie outside the square of the course's task: the bounds are a box around all".to_owned(),
            );
            bounds_of(&draft.discs)
        };
        Ok(draft)
    }
}

/// How far the bounds of a parking case are from everything, in metres: more than the car is long from its rear axle.
const PARKING_MARGIN: f64 = 6.0;

/// The car of the competition: 0.929 m behind the rear axle, 3.76 m before it.
fn parking_car() -> Result<Car, FormatError> {
    let corners = [(-0.929, -0.971), (3.76, -0.971), (3.76, 0.971), (-0.929, 0.971)].map(|(x, y)| Point::new(x, y));
    let shape = scenario::polygon(&corners);
    let car = shape.and_then(|shape| Car::new(shape, 2.8, [-2.5, 2.5], [-0.75, 0.75], 0.01, Weights::default()));
    car.map_err(|error| FormatError::new(Code::InvalidScenario, error.message()))
}

/// A box around discs that has an area.
pub fn bounds_of(discs: &[(Point, f64)]) -> Aabb {
    let corners = discs.iter().flat_map(|&(center, radius)| {
        [-1.0, 1.0].map(|sign| Point::new(center.x + sign * radius, center.y + sign * radius))
    });
    let around = Aabb::around(corners).unwrap_or(Aabb::of(Point::origin(), Point::origin()));
    if around.min.x < around.max.x && around.min.y < around.max.y { around } else { around.grown(1.0) }
}

/// A NumPy array as a grid, row 0 at the top.
pub fn npy_grid(name: &str, bytes: &[u8], options: &Options) -> Result<Draft, FormatError> {
    let table = npy::read(bytes).map_err(|message| FormatError::new(Code::InvalidFile, message))?;
    let height = table.numbers.len().checked_div(table.width).unwrap_or(0);
    cell_count(table.width, height)?;
    let place = |i: usize| Place::Element(format!("row {}, column {}", i / table.width, i % table.width));
    let cells = table.numbers.iter().enumerate().map(|(i, &number)| {
        cell(number, options).map_err(|message| FormatError::new(Code::InvalidNumber, message).at(place(i)))
    });
    let cells = cells.collect::<Result<_, _>>()?;
    grid_of(name, table.width, cells, options)
}

fn grid_of(name: &str, width: usize, cells: Vec<Cell>, options: &Options) -> Result<Draft, FormatError> {
    let mut draft = Draft::new(Format::Grid, name);
    let frame = Frame::of_scale(options.scale.unwrap_or(1.0));
    let height = cells.len() / width;
    add_grid(&mut draft, Grid { width, height, cells, frame }, options)?;
    note_scale(&mut draft, options);
    Ok(draft)
}

/// Says that a scale was assumed.
pub fn note_scale(draft: &mut Draft, options: &Options) {
    if options.scale.is_none() {
        draft.report.notes.push("the file has no scale: a cell is 1 m".to_owned());
    }
}

/// The cell of a number.
fn cell(number: f64, options: &Options) -> Result<Cell, String> {
    match options.threshold {
        _ if number.is_nan() => Err("a cell is not a number".to_owned()),
        Some(threshold) => Ok(if number >= threshold { Cell::Occupied } else { Cell::Free }),
        None if number == 0.0 => Ok(Cell::Free),
        None if number == 1.0 => Ok(Cell::Occupied),
        None if number == -1.0 => Ok(Cell::Unknown),
        None => Err(format!("a cell is 0, 1 or -1 (unknown), not {number}; a threshold reads other numbers")),
    }
}

/// A whole number from 0 to `most`.
fn whole(number: f64, most: usize) -> Option<usize> {
    (number.fract() == 0.0 && (0.0..=most as f64).contains(&number)).then_some(number as usize)
}

fn numbers(line: usize, text: &[u8]) -> Result<Vec<f64>, FormatError> {
    let is_list = text.iter().any(|byte| b",;".contains(byte));
    // A comma at the end of a row is no further number.
    let text = text.strip_suffix(b",").or(text.strip_suffix(b";")).unwrap_or(text);
    let words: Vec<&[u8]> = if is_list {
        text.split(|byte| b",;".contains(byte)).map(<[u8]>::trim_ascii).collect()
    } else {
        text::words(text).collect()
    };
    let number = |word: &[u8]| {
        let value = std::str::from_utf8(word).ok().and_then(|word| word.parse::<f64>().ok());
        match value {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => {
                let sentence = format!("{} is not finite", quoted(word));
                Err(FormatError::at_line(Code::InvalidNumber, line, sentence))
            }
            None => Err(FormatError::at_line(Code::UnknownWorld, line, format!("{} is no number", quoted(word)))),
        }
    };
    words.into_iter().map(number).collect()
}
