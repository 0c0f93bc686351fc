//! Cells of a map, row by row from the top, and where they lie in the plane.

use crate::error::{Code, FormatError};
use planarium::geometry::Point;

/// The most cells of a grid.
pub const MAX_CELLS: usize = 1 << 26;

/// The most cells along a side.
pub const MAX_SIDE: usize = 1 << 16;

/// What a cell of a map is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Cell {
    /// Free.
    Free,
    /// Occupied.
    Occupied,
    /// Unknown.
    Unknown,
}

/// The cells of a map as its file has them, whatever the options make of them, with their place in the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) cells: Vec<Cell>,
    pub(crate) frame: Frame,
}

/// Where the cells of a grid lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    /// The lower left corner of the grid.
    pub origin: Point,
    /// Metres per cell.
    pub resolution: f64,
    /// The turn of the grid about its lower left corner, counter-clockwise.
    pub yaw: f64,
}

impl Frame {
    /// Cells of this size, the lower left corner at the origin of the plane.
    pub fn of_scale(resolution: f64) -> Self {
        Self { origin: Point::new(0.0, 0.0), resolution, yaw: 0.0 }
    }
}

impl Grid {
    /// The number of columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The number of rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The cells, row by row from the top.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Metres per cell.
    pub fn resolution(&self) -> f64 {
        self.frame.resolution
    }

    /// The corner where `column` cells lie to the left and `row` rows above, in the coordinates of the scenario.
    pub fn corner(&self, column: f64, row: f64) -> Point {
        let Frame { origin, resolution, yaw } = self.frame;
        // Neighbours compute the same numbers, so that they share their corners exactly.
        let (x, y) = (column * resolution, (self.height as f64 - row) * resolution);
        if yaw == 0.0 {
            return Point::new(origin.x + x, origin.y + y);
        }
        let (sin, cos) = yaw.sin_cos();
        Point::new(origin.x + (cos * x - sin * y), origin.y + (sin * x + cos * y))
    }

    /// The column and the row, from the left and from the top in cells, of a place in the coordinates of the scenario.
    pub fn locate(&self, p: Point) -> [f64; 2] {
        let Frame { origin, resolution, yaw } = self.frame;
        let (sin, cos) = yaw.sin_cos();
        let [x, y] = [p.x - origin.x, p.y - origin.y];
        [(cos * x + sin * y) / resolution, self.height as f64 - (cos * y - sin * x) / resolution]
    }

    /// The cell at a place in the coordinates of the scenario; `None` outside the grid.
    pub fn cell_at(&self, p: Point) -> Option<Cell> {
        self.index_at(p).map(|i| self.cells[i])
    }

    /// The index of that cell.
    pub(crate) fn index_at(&self, p: Point) -> Option<usize> {
        let [column, row] = self.locate(p);
        let inside = column >= 0.0 && row >= 0.0 && column < self.width as f64 && row < self.height as f64;
        inside.then(|| row as usize * self.width + column as usize)
    }

    /// The number of cells of a kind.
    pub fn count(&self, kind: Cell) -> usize {
        self.cells.iter().filter(|&&cell| cell == kind).count()
    }
}

/// The number of cells of a grid of this size.
///
/// # Errors
/// `invalid-number` without a cell, `world-too-large`
pub(crate) fn cell_count(width: usize, height: usize) -> Result<usize, FormatError> {
    if width == 0 || height == 0 {
        return Err(FormatError::new(Code::InvalidNumber, format!("a grid of {width} x {height} cells is empty")));
    }
    let count = width.checked_mul(height).filter(|&count| count <= MAX_CELLS && width.max(height) <= MAX_SIDE);
    count.ok_or_else(|| {
        let sentence =
            format!("{width} x {height} cells are too many; at most {MAX_CELLS} are read, and {MAX_SIDE} along a side");
        FormatError::new(Code::WorldTooLarge, sentence)
    })
}
