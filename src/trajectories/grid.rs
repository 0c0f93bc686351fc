//! The index of trajectories: which of them may be near another, by a uniform grid of square cells.

use super::track::Track;
use crate::geometry::Aabb;

/// The most cells along a side.
const WIDEST: usize = 128;

/// A trajectory is entered by at most this many stretches for every column.
const STRETCHES: f64 = 4.0;

/// What is done with a cell, the last questions that met each trajectory, and the question at hand.
type Visit<'a> = &'a mut dyn FnMut(&mut Vec<u32>, &mut [u32], u32);

/// A square of cells about the origin. What lies outside belongs to the cells of the border, so nothing is lost however far
/// trajectories reach; there the grid is only coarser.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    half_side: f64,
    width: usize,
    cells: Vec<Vec<u32>>,
    /// Of every trajectory entered: the last question that has met it.
    met: Vec<u32>,
    question: u32,
    margin: f64,
}

impl Grid {
    /// A grid over the square from -`half_side` to `half_side` metres, for about `count` trajectories: as many cells. Boxes
    /// are grown by `margin`, twice the slack.
    pub fn new(half_side: f64, count: usize, margin: f64) -> Self {
        let width = (libm::ceil((count as f64).sqrt()) as usize).clamp(1, WIDEST);
        Self { half_side, width, cells: vec![Vec::new(); width * width], met: Vec::new(), question: 0, margin }
    }

    /// Enters the next trajectory; its number is how many were entered before.
    pub fn insert(&mut self, track: &Track) {
        let number = self.met.len() as u32;
        self.met.push(0);
        self.visit(track, &mut |cells, _, _| {
            if cells.last() != Some(&number) {
                cells.push(number);
            }
        });
    }

    /// Puts the numbers of all trajectories that share a cell with this one into `near`, each once, in no order that means
    /// anything. O(cells crossed + entries in them).
    pub fn near(&mut self, track: &Track, near: &mut Vec<u32>) {
        near.clear();
        self.question += 1;
        self.visit(track, &mut |cells, met, question| {
            for &number in cells.iter() {
                let last = &mut met[number as usize];
                if *last != question {
                    *last = question;
                    near.push(number);
                }
            }
        });
    }

    fn visit(&mut self, track: &Track, each: Visit) {
        let Self { half_side, width, cells, met, question, margin } = self;
        let per_metre = *width as f64 / (2.0 * *half_side);
        let last = (*width - 1) as f64;
        // Not `clamp`, whose panic would bring the formatting of floats into the module.
        let place = |x: f64| libm::floor((x + *half_side) * per_metre).max(0.0).min(last) as usize;
        let particle = &track.particle;
        let wanted =
            particle.fastest() * particle.duration * per_metre + (particle.turn_rate * particle.duration).abs();
        let stretches = libm::ceil(wanted).max(1.0).min(STRETCHES * *width as f64) as u32;
        track.stretches(stretches, &mut |stretch: Aabb| {
            let Aabb { min, max } = stretch.grown(*margin);
            for row in place(min.y)..=place(max.y) {
                for column in place(min.x)..=place(max.x) {
                    each(&mut cells[row * *width + column], met, *question);
                }
            }
        });
    }
}
