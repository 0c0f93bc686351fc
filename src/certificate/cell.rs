//! The cells of a quadtree over a square of configurations.

use serde::{Deserialize, Serialize};

/// The depth of the smallest cells. Over a cell much less deep the robot moves by less than the slack, so that one with a contact
/// in it is blocked: 42 is enough for a disc, 49 for an arm whose joints have the widest limits. All numbers of cells are exact
/// as 64-bit floats.
pub(super) const DEEPEST: u32 = 50;

/// The side of the square, in sides of the smallest cells.
pub(super) const SIDE: u64 = 1 << DEEPEST;

/// A closed cell: along the first coordinate from `column / 2^depth` to `(column + 1) / 2^depth` of its range, along the second
/// by the row. In JSON `[depth, column, row]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "[u64; 3]", into = "[u64; 3]")]
pub struct Cell {
    /// How often the square has been divided into quarters to get it, 0 to 50.
    pub depth: u32,
    /// The number of cells of its size before it along the first coordinate.
    pub column: u64,
    /// The number of cells of its size before it along the second coordinate.
    pub row: u64,
}

impl From<[u64; 3]> for Cell {
    /// A depth that does not fit is kept as one that no cell has.
    fn from([depth, column, row]: [u64; 3]) -> Self {
        Self { depth: u32::try_from(depth).unwrap_or(u32::MAX), column, row }
    }
}

impl From<Cell> for [u64; 3] {
    fn from(Cell { depth, column, row }: Cell) -> Self {
        [u64::from(depth), column, row]
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
    pub(super) fn spans(&self) -> [[u64; 2]; 2] {
        let side = SIDE >> self.depth;
        [self.column, self.row].map(|at| [at * side, at * side + side])
    }

    /// Whether the closed cells share a point: a part of a side, or a corner. An axis that wraps ends where it begins.
    pub(super) fn touches(&self, other: &Self, wraps: [bool; 2]) -> bool {
        let (ours, theirs) = (self.spans(), other.spans());
        (0..2).all(|axis| {
            let ([a, b], [c, d]) = (ours[axis], theirs[axis]);
            let meet_around = |low: u64, high: u64| wraps[axis] && low == 0 && high == SIDE;
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
        let part = 0.5 / (1u64 << cell.depth) as f64;
        let half = [0, 1].map(|axis| part * (self.high[axis] - self.low[axis]));
        let at = [cell.column, cell.row];
        [[0, 1].map(|axis| self.low[axis] + half[axis] * (2 * at[axis] + 1) as f64), half]
    }

    /// The quarter of a cell that contains a configuration of the cell.
    pub fn quarter(&self, cell: &Cell, q: &[f64; 2]) -> usize {
        let [center, _] = self.place(cell);
        usize::from(q[0] >= center[0]) + 2 * usize::from(q[1] >= center[1])
    }
}
