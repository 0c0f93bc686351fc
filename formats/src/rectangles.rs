//! Occupied cells as the fewest rectangles that do not overlap.
//!
//! A corner of the outline at which three of four cells are occupied has to be cut, along the row or along the column.
//! A chord is a cut between two such corners of one line: it serves both. The fewest rectangles have the most chords of
//! which no two touch (Ohtsuki 1982, "Minimum dissection of rectilinear regions"; Imai and Asano 1986, SIAM J. Comput.
//! 15(2)): a largest independent set, since chords along rows touch chords along columns only. All other corners are
//! cut along their row. So once the chosen chords along columns have cut the runs of each row, equal runs of successive
//! rows make up one rectangle.
//!
//! O(n + c sqrt(v)) for n cells and v chords that touch each other c times. A grid with more than [`MAX_TOUCHES`] of
//! them is cut along its rows only, and [`Cover::is_fewest`] is false. Cuts along rows alone make at most three times
//! as many rectangles: N corners with three cells, c regions and h holes give at most a = N - h + c along rows and at
//! least a - N / 2, and a hole has four corners. So a grid that is far beyond what is allowed is refused by its rows.

use crate::matching::independent_on_the_right;
use crate::regions::runs;
use std::collections::BTreeMap;
use std::ops::Range;

/// How often chords may touch each other.
const MAX_TOUCHES: usize = 4_000_000;

/// No line.
const NONE: usize = usize::MAX;

/// Rectangles that have exactly the cells of a bitmap.
pub struct Cover {
    /// Columns and rows of each, in cells.
    pub rectangles: Vec<Rectangle>,
    /// Whether no fewer rectangles without overlap are possible.
    pub is_fewest: bool,
}

/// Covers the cells that are true with at most `most` rectangles.
///
/// # Errors
/// How many rectangles were found, in words, if they are more.
pub fn cover(bits: &[bool], width: usize, most: usize) -> Result<Cover, String> {
    let far_beyond = 3 * most;
    let by_rows = divide(bits, width, &[], far_beyond).ok_or_else(|| format!("more than {far_beyond}"))?;
    let (rectangles, is_fewest) = match chosen_columns(bits, width) {
        // Chords that are chosen never make more.
        Some(cuts) => (divide(bits, width, &cuts, far_beyond).unwrap_or(by_rows), true),
        None => (by_rows, false),
    };
    if rectangles.len() > most { Err(rectangles.len().to_string()) } else { Ok(Cover { rectangles, is_fewest }) }
}

/// The columns and rows of a rectangle.
type Rectangle = (Range<usize>, Range<usize>);

/// The rectangles of equal runs of successive rows, once these cuts along columns divide the runs; `None` if there are
/// more than
/// `most`.
fn divide(bits: &[bool], width: usize, cuts: &[Chord], most: usize) -> Option<Vec<Rectangle>> {
    let mut rectangles = Vec::new();
    // The rectangles that end at the present row, by their columns.
    let mut open: Vec<(Range<usize>, usize)> = Vec::new();
    let mut pieces: Vec<Range<usize>> = Vec::new();
    // The rows of chords along the present row, by their column.
    let mut active: BTreeMap<usize, usize> = BTreeMap::new();
    let mut next_cut = 0;
    for (row, line) in bits.chunks_exact(width).enumerate() {
        active.retain(|_, &mut end| end > row);
        while let Some(chord) = cuts.get(next_cut).filter(|chord| chord.from == row) {
            active.insert(chord.line, chord.to);
            next_cut += 1;
        }
        pieces.clear();
        for run in runs(line, true) {
            let mut start = run.start;
            for (&column, _) in active.range(run.start + 1..run.end.max(run.start + 1)) {
                pieces.push(start..column);
                start = column;
            }
            pieces.push(start..run.end);
        }
        let mut next = Vec::with_capacity(pieces.len());
        let mut before = open.drain(..).peekable();
        for piece in &pieces {
            let mut start = row;
            while let Some((columns, first)) = before.next_if(|(columns, _)| columns.start <= piece.start) {
                if columns == *piece {
                    start = first;
                } else {
                    rectangles.push((columns, first..row));
                }
            }
            next.push((piece.clone(), start));
        }
        rectangles.extend(before.map(|(columns, first)| (columns, first..row)));
        open = next;
        if rectangles.len() > most {
            return None;
        }
    }
    let height = bits.len() / width;
    rectangles.extend(open.into_iter().map(|(columns, first)| (columns, first..height)));
    (rectangles.len() <= most).then_some(rectangles)
}

/// A chord: on which line of the lattice, and from where to where.
#[derive(Clone, Copy)]
struct Chord {
    line: usize,
    from: usize,
    to: usize,
}

/// The chords along columns of a largest set of chords that do not touch, by their first row; `None` if too many touch.
fn chosen_columns(bits: &[bool], width: usize) -> Option<Vec<Chord>> {
    let (along_rows, mut along_columns) = chords(bits, width);
    along_columns.sort_unstable_by_key(|chord| (chord.from, chord.line));
    // Both ends of a chord touch others: a column is active from its first row to its last.
    let mut active: BTreeMap<usize, (u32, usize)> = BTreeMap::new();
    let mut edges = Vec::with_capacity(along_rows.len());
    let (mut next, mut touches) = (0, 0);
    for row in &along_rows {
        while let Some(column) = along_columns.get(next).filter(|column| column.from <= row.line) {
            // A later chord of the same column begins where no earlier one is: they cannot share an end.
            active.insert(column.line, (next as u32, column.to));
            next += 1;
        }
        let touching: Vec<u32> = active
            .range(row.from..=row.to)
            .filter(|(_, (_, last))| *last >= row.line)
            .map(|(_, &(column, _))| column)
            .collect();
        touches += touching.len();
        if touches > MAX_TOUCHES {
            return None;
        }
        edges.push(touching);
    }
    let chosen = independent_on_the_right(&edges, along_columns.len());
    Some(along_columns.into_iter().zip(chosen).filter(|(_, is_chosen)| *is_chosen).map(|(chord, _)| chord).collect())
}

/// All chords along rows, by their line, and all along columns.
fn chords(bits: &[bool], width: usize) -> (Vec<Chord>, Vec<Chord>) {
    let (mut along_rows, mut along_columns) = (Vec::new(), Vec::new());
    // Where a cut down a column that began at a corner would still be inside, by column.
    let mut down: Vec<usize> = vec![NONE; width];
    let lines: Vec<&[bool]> = bits.chunks_exact(width).collect();
    for (above, pair) in lines.windows(2).enumerate() {
        let line = above + 1;
        let [upper, lower] = [pair[0], pair[1]];
        // Where a cut to the right that began at a corner of this line would still be inside.
        let mut right = NONE;
        for x in 1..width {
            let [a, b, c, d] = [upper[x - 1], upper[x], lower[x - 1], lower[x]];
            if a && b && c && d {
                continue;
            }
            if right != NONE && a && c && b != d {
                along_rows.push(Chord { line, from: right, to: x });
            }
            right = if a != c && b && d { x } else { NONE };
            if down[x] != NONE && a && b && c != d {
                along_columns.push(Chord { line: x, from: down[x], to: line });
            }
            down[x] = if a != b && c && d { line } else { NONE };
        }
    }
    (along_rows, along_columns)
}
