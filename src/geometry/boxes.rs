//! The boxes that meet a given one: eight are compared at a time, in a tree if there are many.
//!
//! Coordinates are stored as whole numbers of 15 bits in the lanes of vectors. Scaling, rounding and clamping never exchange two
//! numbers, so boxes that meet still meet afterwards. All boxes that meet are listed, and rarely one that is only nearly
//! touched.
//!
//! The tree is implicit, with eight branches: boxes are ordered by splitting them again and again along the longer side of
//! their common box; then every eight neighbours make a group, the boxes around every eight groups the next level's
//! groups, and so on.

use super::{Aabb, arrange};
use wide::i16x8;

/// How many boxes a group holds.
const LANES: usize = 8;

/// Levels are added until the last has this many groups or fewer, which are all examined.
const TOP: usize = 8;

/// An upper bound on the groups that wait in a traversal of the tree: seven a level, and up to 2^32 boxes.
const STACK: usize = 80;

/// Coordinates lie strictly between 0 and this.
const END: i16 = i16::MAX;

/// The last of them.
const LAST: f64 = (END - 1) as f64;

/// Sums with it are rounded to whole numbers.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Boxes prepared for queries.
#[derive(Debug, Clone)]
pub(crate) struct Boxes {
    grid: Grid,
    /// All levels in sequence, that of the boxes themselves first.
    groups: Vec<Group>,
    /// The index of the first group of each level.
    levels: Vec<usize>,
    /// The index of each box in the groups of the first level.
    order: Vec<u32>,
}

/// The map from coordinates to integers.
#[derive(Debug, Clone, Copy)]
struct Grid {
    origin: [f64; 2],
    scale: f64,
}

/// A box on the grid: its least x and y, its largest x and y.
type Cells = [i16; 4];

impl Grid {
    /// The grid over all boxes.
    fn new(boxes: &[Aabb]) -> Self {
        let Some(all) = boxes.iter().copied().reduce(|a, b| a.union(&b)) else {
            return Self { origin: [0.0; 2], scale: 1.0 };
        };
        // Whatever the scale, coordinates stay in order: a bad one only lists more boxes.
        // Cells next to the ends are left to what lies outside.
        let scale = f64::from(END - 5) / all.longer_side();
        Self { origin: [all.min.x, all.min.y], scale: if scale.is_finite() { scale } else { 1.0 } }
    }

    #[inline(always)]
    fn cell(&self, x: f64, axis: usize) -> i16 {
        let cell = (x - self.origin[axis]) * self.scale + 2.0;
        let cell = if cell > 1.0 { cell } else { 1.0 };
        let cell = if cell < LAST { cell } else { LAST };
        // The lowest bits of the sum are the number rounded to a whole one: no conversion is as cheap.
        (cell + ROUNDING).to_bits() as i16
    }

    #[inline(always)]
    fn cells(&self, aabb: &Aabb) -> Cells {
        let (min, max) = (aabb.min, aabb.max);
        [self.cell(min.x, 0), self.cell(min.y, 1), self.cell(max.x, 0), self.cell(max.y, 1)]
    }
}

/// Eight boxes, side by side: least x and y, largest x and y.
#[derive(Debug, Clone, Copy)]
struct Group([i16x8; 4]);

impl Group {
    /// A group of up to eight boxes; the other lanes meet nothing.
    fn new(boxes: &[Cells]) -> Self {
        let mut rows = [[END; LANES], [END; LANES], [0; LANES], [0; LANES]];
        for (lane, cells) in boxes.iter().enumerate() {
            for (row, &cell) in rows.iter_mut().zip(cells) {
                row[lane] = cell;
            }
        }
        Self(rows.map(i16x8::new))
    }

    /// Which of the eight meet the box, the first in the lowest bit.
    #[inline(always)]
    fn meeting(&self, near: &Near) -> u64 {
        let [min_x, min_y, max_x, max_y] = self.0;
        let [near_min_x, near_min_y, near_max_x, near_max_y] = near.0;
        let beside = min_x.simd_gt(near_max_x) | near_min_x.simd_gt(max_x);
        let above = min_y.simd_gt(near_max_y) | near_min_y.simd_gt(max_y);
        u64::from((!(beside | above)).to_bitmask())
    }
}

/// The box of a query, once in every lane: least x and y, largest x and y.
struct Near([i16x8; 4]);

impl Near {
    #[inline(always)]
    fn new([min_x, min_y, max_x, max_y]: Cells) -> Self {
        Self([i16x8::splat(min_x), i16x8::splat(min_y), i16x8::splat(max_x), i16x8::splat(max_y)])
    }
}

impl Boxes {
    /// Prepares the boxes. O(n log n).
    pub fn new(boxes: &[Aabb]) -> Self {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        if boxes.len() > LANES * TOP {
            arrange(&mut order, boxes, LANES);
        }
        let grid = Grid::new(boxes);
        let mut around: Vec<Cells> = order.iter().map(|&i| grid.cells(&boxes[i as usize])).collect();
        let mut groups: Vec<Group> = around.chunks(LANES).map(Group::new).collect();
        let mut levels = vec![0];
        let mut first = 0;
        while groups.len() - first > TOP {
            around = around.chunks(LANES).map(union).collect();
            first = groups.len();
            levels.push(first);
            groups.extend(around.chunks(LANES).map(Group::new));
        }
        Self { grid, groups, levels, order }
    }

    /// Calls `visit` with the index of every box that meets `near` until it returns true, in an order that depends on the
    /// boxes alone; returns whether it did.
    #[inline(always)]
    pub fn any(&self, near: &Aabb, mut visit: impl FnMut(usize) -> bool) -> bool {
        let near = Near::new(self.grid.cells(near));
        if self.levels.len() > 1 {
            return self.any_below(&near, &mut visit);
        }
        // The bits of all groups fit side by side, and the end of only one loop is hard to predict.
        let mut bits = 0;
        for (i, group) in self.groups.iter().enumerate() {
            bits |= group.meeting(&near) << (LANES * i);
        }
        while bits != 0 {
            if visit(bits.trailing_zeros() as usize) {
                return true;
            }
            bits &= bits - 1;
        }
        false
    }

    /// The same by the tree.
    #[inline(never)]
    fn any_below(&self, near: &Near, visit: &mut dyn FnMut(usize) -> bool) -> bool {
        let top = self.levels.len() - 1;
        let mut stack = [(0, 0); STACK];
        for root in self.levels[top]..self.groups.len() {
            stack[0] = (top, root);
            let mut waiting = 1;
            while waiting > 0 {
                waiting -= 1;
                let (level, at) = stack[waiting];
                let mut bits = self.groups[at].meeting(near);
                while bits != 0 {
                    let below = LANES * (at - self.levels[level]) + bits.trailing_zeros() as usize;
                    bits &= bits - 1;
                    if level > 0 {
                        stack[waiting] = (level - 1, self.levels[level - 1] + below);
                        waiting += 1;
                    } else if visit(self.order[below] as usize) {
                        return true;
                    }
                }
            }
        }
        false
    }
}

/// The box around up to eight.
fn union(boxes: &[Cells]) -> Cells {
    let least = |k: usize| boxes.iter().map(|cells| cells[k]).fold(END, i16::min);
    let most = |k: usize| boxes.iter().map(|cells| cells[k]).fold(0, i16::max);
    [least(0), least(1), most(2), most(3)]
}
