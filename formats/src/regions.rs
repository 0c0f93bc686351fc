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

    /// Each region, in the order of its first cell.
    pub fn list(&mut self) -> Vec<Region> {
        self.number().0
    }

    /// The stretches of rows of all regions that a rule chooses, as rows and columns, and how many regions it chooses.
    pub fn choose(mut self, rule: impl Fn(&Region) -> bool) -> (usize, Vec<(usize, Range<usize>)>) {
        let (regions, numbers) = self.number();
        let runs = self.runs.iter().zip(numbers).filter(|(_, number)| rule(&regions[*number as usize]));
        let chosen = runs.map(|(run, _)| (run.row as usize, run.columns.start as usize..run.columns.end as usize));
        (regions.iter().filter(|region| rule(region)).count(), chosen.collect())
    }

    /// All regions, and the number of the region of each run.
    fn number(&mut self) -> (Vec<Region>, Vec<u32>) {
        let mut numbers = vec![u32::MAX; self.runs.len()];
        let mut regions: Vec<Region> = Vec::new();
        for i in 0..self.runs.len() {
            // The root of a region is its first run.
            let root = self.root(i);
            if root == i {
                numbers[i] = regions.len() as u32;
                regions.push(Region { cells: 0, touches_border: false });
            }
            numbers[i] = numbers[root];
            let (region, Run { row, columns }) = (&mut regions[numbers[i] as usize], &self.runs[i]);
            region.cells += columns.len();
            region.touches_border |= *row == 0
                || *row as usize + 1 == self.height
                || columns.start == 0
                || columns.end as usize == self.width;
        }
        (regions, numbers)
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
