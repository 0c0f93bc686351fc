//! From cells to rectangles: which are obstacles, islands, simplification, and the bounds.

use crate::draft::{Draft, largest};
use crate::error::{Code, FormatError};
use crate::grid::{Cell, Grid};
use crate::options::{Options, Unknown};
use crate::rectangles::cover;
use crate::regions::{Connected, Regions};
use crate::report::{Dropped, GridRead};
use planarium::geometry::{Aabb, Point};
use planarium::scenario::MAX_OBSTACLES;

/// The smallest side of a cell, in metres.
const MIN_RESOLUTION: f64 = 1e-6;

/// How far rectangles of a turned grid are grown, in parts of the largest coordinate: rounding is below a thousandth of
/// it.
const TURNED_SLACK: f64 = 1e-12;

/// Adds the obstacles and the bounds of a grid to a draft.
///
/// # Errors
/// `world-too-large`
pub fn add_grid(draft: &mut Draft, grid: Grid, options: &Options) -> Result<(), FormatError> {
    let resolution = grid.frame.resolution;
    if resolution < MIN_RESOLUTION {
        let sentence = format!("a cell is at least {MIN_RESOLUTION:e} m, not {resolution:e} m");
        return Err(FormatError::new(Code::InvalidNumber, sentence));
    }
    let unknown_is_occupied = options.unknown == Unknown::Occupied;
    let is_blocked = |&cell: &Cell| cell == Cell::Occupied || cell == Cell::Unknown && unknown_is_occupied;
    let mut bits: Vec<bool> = grid.cells.iter().map(is_blocked).collect();
    if options.min_island > 1 {
        draft.report.dropped.extend(drop_islands(&mut bits, grid.width, options.min_island));
    }
    let (grown_cells, grown) = simplify(&mut bits, grid.width, grid.frame.resolution, options.simplify);
    let cover = cover(&bits, grid.width, MAX_OBSTACLES).map_err(|excess| {
        let sentence = format!(
            "the obstacles make up {excess} rectangles; a scenario has at most {MAX_OBSTACLES}: drop small islands (min_island) or let \
             obstacles grow a little (simplify)"
        );
        FormatError::new(Code::WorldTooLarge, sentence)
    })?;
    let rectangles = cover.rectangles.len();
    let is_turned = grid.frame.yaw != 0.0;
    let hull = hull(&grid);
    let slack = if is_turned { TURNED_SLACK * largest(hull) } else { 0.0 };
    let margin = slack / grid.frame.resolution;
    for (columns, rows) in &cover.rectangles {
        let [left, right] = [columns.start as f64 - margin, columns.end as f64 + margin];
        let [top, bottom] = [rows.start as f64 - margin, rows.end as f64 + margin];
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top)];
        draft.polygons.push(corners.map(|(x, y)| grid.corner(x, y)).to_vec());
    }
    draft.bounds = Aabb::around(hull).expect("it has four corners");
    if is_turned {
        block_outside(draft, hull);
    }
    draft.report.grown = draft.report.grown.max(grown + slack * 2f64.sqrt());
    let free = Regions::of(&bits, grid.width, false, Connected::Sides).list();
    draft.report.grid = Some(GridRead {
        width: grid.width,
        height: grid.height,
        resolution: grid.frame.resolution,
        yaw: grid.frame.yaw,
        free: grid.count(Cell::Free),
        occupied: grid.count(Cell::Occupied),
        unknown: grid.count(Cell::Unknown),
        unknown_is_occupied,
        transparent: 0,
        kinds: Vec::new(),
        islands: Regions::of(&bits, grid.width, true, Connected::Corners).list().len(),
        enclosed: free.iter().filter(|region| !region.touches_border).count(),
        grown_cells,
        merged_cells: bits.iter().filter(|&&bit| bit).count(),
        rectangles,
        fewest: cover.is_fewest,
    });
    draft.blocked = bits;
    draft.grid = Some(grid);
    Ok(())
}

/// Clears islands of fewer than `least` cells.
fn drop_islands(bits: &mut [bool], width: usize, least: usize) -> Option<Dropped> {
    let regions = Regions::of(bits, width, true, Connected::Corners);
    let (count, rows) = regions.choose(|region| region.cells < least);
    let cells = rows.iter().map(|(_, columns)| columns.len()).sum();
    for (row, columns) in rows {
        bits[row * width..][columns].fill(false);
    }
    let what = format!("islands smaller than {least} cells");
    (count > 0).then_some(Dropped { what, count, cells: Some(cells) })
}

/// Fills every square block of cells that has an occupied one; blocks are as large as the bound on growth allows.
/// Returns how many cells were filled, and how far they are from an occupied one at most.
fn simplify(bits: &mut [bool], width: usize, resolution: f64, bound: f64) -> (usize, f64) {
    // In a block of k cells a side, a point is within (k - 1) diagonals of a cell of any other cell of the block.
    let diagonal = 2f64.sqrt() * resolution;
    let side = 1 + (bound / diagonal).floor().min(width.max(bits.len() / width) as f64) as usize;
    if side == 1 {
        return (0, 0.0);
    }
    let height = bits.len() / width;
    let mut filled = 0;
    for top in (0..height).step_by(side) {
        let rows = top..(top + side).min(height);
        for left in (0..width).step_by(side) {
            let columns = left..(left + side).min(width);
            let count: usize =
                rows.clone().map(|row| bits[row * width..][columns.clone()].iter().filter(|&&bit| bit).count()).sum();
            if count > 0 {
                filled += rows.len() * columns.len() - count;
                rows.clone().for_each(|row| bits[row * width..][columns.clone()].fill(true));
            }
        }
    }
    let farthest = if filled > 0 { (side - 1) as f64 * diagonal } else { 0.0 };
    (filled, farthest)
}

/// The corners of the grid, counter-clockwise from the lower left one of the file.
fn hull(grid: &Grid) -> [Point; 4] {
    let [width, height] = [grid.width as f64, grid.height as f64];
    [(0.0, height), (width, height), (width, 0.0), (0.0, 0.0)].map(|(column, row)| grid.corner(column, row))
}

/// Blocks what lies within the bounds and outside a turned grid: a triangle at each corner of the bounds.
fn block_outside(draft: &mut Draft, hull: [Point; 4]) {
    let Aabb { min, max } = draft.bounds;
    let count = draft.polygons.len();
    for i in 0..4 {
        let (a, b) = (hull[i], hull[(i + 1) % 4]);
        // The side from a to b has the grid on its left; the corner of the bounds is on its right.
        let corner = Point::new(if b.y > a.y { max.x } else { min.x }, if b.x > a.x { min.y } else { max.y });
        // A side along the bounds leaves no triangle.
        if (a.x - b.x).abs() > 0.0 && (a.y - b.y).abs() > 0.0 {
            draft.polygons.push(vec![corner, b, a]);
        }
    }
    let count = draft.polygons.len() - count;
    draft
        .report
        .notes
        .push(format!("the map is turned: {count} triangles block what is within the bounds and outside the map"));
}
