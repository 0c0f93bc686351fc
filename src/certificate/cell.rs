//! The cells of a quadtree over a square of configurations.

use serde::{Deserialize, Serialize};

/// The depth of the smallest cells.
pub(super) const DEEPEST: u32 = 30;

/// The side of the square, in sides of the smallest cells.
pub(super) const SIDE: u32 = 1 << DEEPEST;

/// A closed cell: along the first coordinate from `column / 2^depth` to `(column + 1) / 2^depth` of its range, along the second by
/// the row. In JSON `[depth, column, row]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "[u32; 3]", into = "[u32; 3]")]
pub struct Cell {
    /// How often the square has been divided into quarters to get it, 0 to 30.
    pub depth: u32,
    /// The number of cells of its size before it along the first coordinate.
    pub column: u32,
    /// The number of cells of its size before it along the second coordinate.
    pub row: u32,
}

impl From<[u32; 3]> for Cell {
    fn from([depth, column, row]: [u32; 3]) -> Self {
        Self { depth, column, row }
    }
}

impl From<Cell> for [u32; 3] {
    fn from(Cell { depth, column, row }: Cell) -> Self {
        [depth, column, row]
    }
}

impl Cell {
    /// The whole square.
    pub(super) const WHOLE: Self = Self { depth: 0, column: 0, row: 0 };

    /// Its quarters: the lower two, then the upper two.
    pub(super) fn quarters(&self) -> [Self; 4] {
        let Self { depth, column, row } = *self;
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| Self {
            depth: depth + 1,
            column: 2 * column + x,
            row: 2 * row + y,
        })
    }

    /// Where it begins and ends along each axis, in sides of the smallest cells.
    pub(super) fn spans(&self) -> [[u32; 2]; 2] {
        let side = SIDE >> self.depth;
        [self.column, self.row].map(|at| [at * side, at * side + side])
    }

    /// Whether the closed cells share a point: a part of a side, or a corner. An axis that wraps ends where it begins.
    pub(super) fn touches(&self, other: &Self, wraps: [bool; 2]) -> bool {
        let (ours, theirs) = (self.spans(), other.spans());
        (0..2).all(|axis| {
            let ([a, b], [c, d]) = (ours[axis], theirs[axis]);
            let meet_around = |low: u32, high: u32| wraps[axis] && low == 0 && high == SIDE;
            (a <= d && c <= b) || meet_around(a, d) || meet_around(c, b)
        })
    }
}

/// The square of configurations: the ranges of two coordinates, and which of them wrap.
#[derive(Debug, Clone, Copy)]
pub(super) struct Square {
    pub low: [f64; 2],
    pub high: [f64; 2],
    pub wraps: [bool; 2],
}

impl Square {
    /// The centre of a cell, and half its sides.
    pub fn place(&self, cell: &Cell) -> [[f64; 2]; 2] {
        let part = 0.5 / f64::from(1u32 << cell.depth);
        let half = [0, 1].map(|axis| part * (self.high[axis] - self.low[axis]));
        let at = [cell.column, cell.row];
        [[0, 1].map(|axis| self.low[axis] + half[axis] * f64::from(2 * at[axis] + 1)), half]
    }

    /// The quarter of a cell that contains a configuration of the cell.
    pub fn quarter(&self, cell: &Cell, q: &[f64; 2]) -> usize {
        let [center, _] = self.place(cell);
        usize::from(q[0] >= center[0]) + 2 * usize::from(q[1] >= center[1])
    }
}
