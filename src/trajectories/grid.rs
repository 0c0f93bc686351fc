//! The index of trajectories: those that may be near another, by a uniform grid of square cells.

use super::track::Track;
use crate::geometry::Aabb;

/// The most cells along a side.
const WIDEST: usize = 128;

/// A trajectory is entered by at most this many pieces per column.
const PIECES: f64 = 4.0;

/// A function of a cell, the last query that met each trajectory, and the current query.
type Visit<'a> = &'a mut dyn FnMut(&mut Vec<u32>, &mut [u32], u32);

/// A square of cells about the origin. Points outside belong to the cells of the border, so nothing is lost however far
/// trajectories reach; the grid is only coarser there.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    half_side: f64,
    width: usize,
    cells: Vec<Vec<u32>>,
    /// For every trajectory entered: the last query that met it.
    met: Vec<u32>,
    query: u32,
    margin: f64,
}

impl Grid {
    /// A grid over the square from -`half_side` to `half_side` metres, for about `count` trajectories: as many cells. Boxes
    /// are grown by `margin`, twice the slack.
    pub fn new(half_side: f64, count: usize, margin: f64) -> Self {
        let width = (libm::ceil((count as f64).sqrt()) as usize).clamp(1, WIDEST);
        Self { half_side, width, cells: vec![Vec::new(); width * width], met: Vec::new(), query: 0, margin }
    }

    /// Enters the next trajectory; its index is the number of trajectories entered before.
    pub fn insert(&mut self, track: &Track) {
        let number = self.met.len() as u32;
        self.met.push(0);
        self.visit(track, &mut |cells, _, _| {
            if cells.last() != Some(&number) {
                cells.push(number);
            }
        });
    }

    /// Writes the indices of all trajectories that share a cell with this one into `near`, each once, in no particular order.
    /// O(cells crossed + entries in them).
    pub fn near(&mut self, track: &Track, near: &mut Vec<u32>) {
        near.clear();
        self.query += 1;
        self.visit(track, &mut |cells, met, query| {
            for &number in cells.iter() {
                let last = &mut met[number as usize];
                if *last != query {
                    *last = query;
                    near.push(number);
                }
            }
        });
    }

    fn visit(&mut self, track: &Track, each: Visit) {
        let Self { half_side, width, cells, met, query, margin } = self;
        let per_metre = *width as f64 / (2.0 * *half_side);
        let last = (*width - 1) as f64;
        // Not `clamp`, whose panic would link the formatting of floats.
        let cell = |x: f64| libm::floor((x + *half_side) * per_metre).max(0.0).min(last) as usize;
        let particle = &track.particle;
        let wanted =
            particle.fastest() * particle.duration * per_metre + (particle.turn_rate * particle.duration).abs();
        let pieces = libm::ceil(wanted).max(1.0).min(PIECES * *width as f64) as u32;
        track.boxes(pieces, &mut |piece: Aabb| {
            let Aabb { min, max } = piece.grown(*margin);
            for row in cell(min.y)..=cell(max.y) {
                for column in cell(min.x)..=cell(max.x) {
                    each(&mut cells[row * *width + column], met, *query);
                }
            }
        });
    }
}
