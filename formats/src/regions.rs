//! Connected regions of a bitmap, by the runs of its rows and union-find: near linear in the number of cells.

use std::ops::Range;

/// Which neighbours are connected.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Connected {
    /// Those that share a side.
    Sides,
    /// Those that share a side or a corner.
    Corners,
}

/// The connected regions of cells that have a value.
pub struct Regions {
    runs: Vec<Run>,
    parents: Vec<u32>,
    width: usize,
    height: usize,
}

struct Run {
    row: u32,
    columns: Range<u32>,
}

/// What is known of a region.
#[derive(Clone, Copy)]
pub struct Region {
    /// Its number of cells.
    pub cells: usize,
    /// Whether it has a cell at the border of the bitmap.
    pub touches_border: bool,
}

impl Regions {
    /// The regions of the cells that are `value`.
    pub fn of(bits: &[bool], width: usize, value: bool, connected: Connected) -> Self {
        let height = bits.len() / width;
        let mut regions = Self { runs: Vec::new(), parents: Vec::new(), width, height };
        let mut above = 0..0;
        for (row, line) in bits.chunks_exact(width).enumerate() {
            let first = regions.runs.len();
            for columns in runs(line, value) {
                let columns = columns.start as u32..columns.end as u32;
                regions.parents.push(regions.runs.len() as u32);
                regions.runs.push(Run { row: row as u32, columns });
            }
            let here = first..regions.runs.len();
            regions.join(above, here.clone(), u32::from(connected == Connected::Corners));
            above = here;
        }
        regions
    }

    /// Joins the runs of a row with those of the row above that they touch; `reach` is 1 if corners count.
    fn join(&mut self, above: Range<usize>, here: Range<usize>, reach: u32) {
        let mut first = above.start;
        for i in here {
            let Range { start, end } = self.runs[i].columns;
            while first < above.end && self.runs[first].columns.end + reach <= start {
                first += 1;
            }
            let mut j = first;
            while j < above.end && self.runs[j].columns.start < end + reach {
                let (a, b) = (self.root(i), self.root(j));
                self.parents[a.max(b)] = a.min(b) as u32;
                j += 1;
            }
        }
    }

    fn root(&mut self, mut i: usize) -> usize {
        while self.parents[i] as usize != i {
            self.parents[i] = self.parents[self.parents[i] as usize];
            i = self.parents[i] as usize;
        }
        i
    }

    /// Each region, in the order of its first cell, and the columns of its rows.
    pub fn list(mut self) -> Vec<(Region, Vec<(usize, Range<usize>)>)> {
        let mut places = vec![u32::MAX; self.runs.len()];
        let mut found: Vec<(Region, Vec<_>)> = Vec::new();
        for i in 0..self.runs.len() {
            let root = self.root(i);
            if places[root] == u32::MAX {
                places[root] = found.len() as u32;
                found.push((Region { cells: 0, touches_border: false }, Vec::new()));
            }
            let (region, rows) = &mut found[places[root] as usize];
            let Run { row, columns } = &self.runs[i];
            let (row, columns) = (*row as usize, columns.start as usize..columns.end as usize);
            region.cells += columns.len();
            region.touches_border |=
                row == 0 || row + 1 == self.height || columns.start == 0 || columns.end == self.width;
            rows.push((row, columns));
        }
        found
    }
}

/// The stretches of a row that are `value`.
pub fn runs(line: &[bool], value: bool) -> impl Iterator<Item = Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let start = at + line[at..].iter().position(|&bit| bit == value)?;
        let end = line[start..].iter().position(|&bit| bit != value).map_or(line.len(), |length| start + length);
        at = end;
        Some(start..end)
    })
}
