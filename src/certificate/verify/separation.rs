//! Whether closed cells separate two points of the square: by sweeping a line over it, not by the quadtree.
//!
//! The ends of all cells along the first axis cut the square into slabs. In a slab the gaps between cells are intervals of the
//! second axis. What the cells leave open is connected through gaps of neighbouring slabs that overlap.

use crate::certificate::cell::{Cell, SIDE};
use crate::graph::UnionFind;

/// A gap of the slab under the line: its ends, and its number.
type Gap = ([u64; 2], usize);

/// Whether every path in the square, of which axes may wrap, from one point to the other meets a cell. Points are in sides of the
/// smallest cells, and so is how far rounding may have moved them along each axis out of a cell. O(n log n) for n cells, and O(m)
/// for each slab with m cells.
pub(super) fn separates(cells: &[Cell], wraps: [bool; 2], points: [[f64; 2]; 2], rounded: [f64; 2]) -> bool {
    let mut spans: Vec<[[u64; 2]; 2]> = cells.iter().map(Cell::spans).collect();
    let is_in = |span: [u64; 2], x: f64| span[0] as f64 <= x && x <= span[1] as f64;
    let is_near = |spans: &[[u64; 2]; 2], point: &[f64; 2]| {
        (0..2).all(|axis| {
            let ([low, high], x) = (spans[axis].map(|at| at as f64), point[axis]);
            let is_between = |x: f64| low - rounded[axis] <= x && x <= high + rounded[axis];
            is_between(x) || (wraps[axis] && (is_between(x - SIDE as f64) || is_between(x + SIDE as f64)))
        })
    };
    if points.iter().any(|point| spans.iter().any(|spans| is_near(spans, point))) {
        return true;
    }
    spans.sort_unstable();
    let mut cuts: Vec<u64> = spans.iter().flat_map(|[column, _]| *column).chain([0, SIDE]).collect();
    cuts.sort_unstable();
    cuts.dedup();
    let mut sets = UnionFind::default();
    let mut count = 0;
    let mut found = [None; 2];
    let (mut first, mut before): (Option<Vec<Gap>>, Vec<Gap>) = (None, Vec::new());
    let (mut next, mut active) = (0, Vec::new());
    for slab in cuts.windows(2) {
        active.retain(|[column, _]: &[[u64; 2]; 2]| column[1] > slab[0]);
        while next < spans.len() && spans[next][0][0] == slab[0] {
            active.push(spans[next]);
            next += 1;
        }
        let mut gaps = Vec::new();
        for gap in gaps_of(active.iter().map(|[_, row]| *row).collect()) {
            sets.add();
            gaps.push((gap, count));
            count += 1;
        }
        if let (true, Some(low), Some(high)) = (wraps[1], gaps.first(), gaps.last())
            && low.0[0] == 0
            && high.0[1] == SIDE
        {
            sets.join(low.1, high.1);
        }
        join(&mut sets, &before, &gaps);
        for (point, found) in points.iter().zip(&mut found) {
            if found.is_none() && is_in([slab[0], slab[1]], point[0]) {
                *found = gaps.iter().find(|(gap, _)| is_in(*gap, point[1])).map(|gap| gap.1);
            }
        }
        first.get_or_insert_with(|| gaps.clone());
        before = gaps;
    }
    if wraps[0] {
        join(&mut sets, &before, &first.unwrap_or_default());
    }
    let [Some(start), Some(goal)] = found else { return false };
    sets.find(start) != sets.find(goal)
}

/// The intervals that the spans leave open, in order.
fn gaps_of(mut spans: Vec<[u64; 2]>) -> Vec<[u64; 2]> {
    spans.sort_unstable();
    let (mut gaps, mut end) = (Vec::new(), 0);
    for [low, high] in spans.into_iter().chain([[SIDE, SIDE]]) {
        if low > end {
            gaps.push([end, low]);
        }
        end = end.max(high);
    }
    gaps
}

/// Joins the gaps of neighbouring slabs that overlap.
fn join(sets: &mut UnionFind, left: &[Gap], right: &[Gap]) {
    let (mut i, mut j) = (0, 0);
    while i < left.len() && j < right.len() {
        let ([a, b], [c, d]) = (left[i].0, right[j].0);
        if a.max(c) < b.min(d) {
            sets.join(left[i].1, right[j].1);
        }
        if b < d { i += 1 } else { j += 1 }
    }
}
