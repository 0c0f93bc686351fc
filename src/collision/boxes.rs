//! The boxes that meet a given one: four are compared at a time, in a tree if there are many.
//!
//! Coordinates are stored as integers of 15 bits, four in a word with a free bit above each: so one subtraction compares
//! four, on any machine. Scaling, rounding and clamping never exchange two numbers, so boxes that meet still meet
//! afterwards. All boxes that meet are listed, and rarely one that is only nearly touched.
//!
//! The tree is implicit, with four branches: boxes are ordered by splitting them again and again along the longer side of
//! their common box; then every four neighbours make a group, the boxes around every four groups the next level's groups,
//! and so on.

use crate::geometry::Aabb;

/// Levels are added until the last has this many groups or fewer, which are all examined.
const TOP: usize = 16;

/// An upper bound on the groups that wait in a traversal of the tree: three a level, and up to 2^32 boxes.
const STACK: usize = 48;

/// The free bit of every lane.
const FREE: u64 = 0x8000_8000_8000_8000;

/// One in every lane.
const ONES: u64 = 0x0001_0001_0001_0001;

/// Coordinates lie strictly between 0 and this.
const END: u16 = 0x7fff;

/// The last of them.
const LAST: f64 = (END - 1) as f64;

/// Sums with it are rounded to whole numbers.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Boxes prepared for queries.
#[derive(Debug, Clone)]
pub(super) struct Boxes {
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
type Cells = [u16; 4];

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
    fn cell(&self, x: f64, axis: usize) -> u16 {
        let cell = (x - self.origin[axis]) * self.scale + 2.0;
        let cell = if cell > 1.0 { cell } else { 1.0 };
        let cell = if cell < LAST { cell } else { LAST };
        // The lowest bits of the sum are the number rounded to a whole one: no conversion is as cheap.
        (cell + ROUNDING).to_bits() as u16
    }

    #[inline(always)]
    fn cells(&self, aabb: &Aabb) -> Cells {
        let (min, max) = (aabb.min, aabb.max);
        [self.cell(min.x, 0), self.cell(min.y, 1), self.cell(max.x, 0), self.cell(max.y, 1)]
    }
}

/// Four boxes, side by side: least x and y, largest x and y with the free bits set.
#[derive(Debug, Clone, Copy)]
struct Group([u64; 4]);

impl Group {
    /// A group of up to four boxes; the other lanes meet nothing.
    fn new(boxes: &[Cells]) -> Self {
        let mut words = [0; 4];
        for lane in 0..4 {
            let cells = boxes.get(lane).unwrap_or(&[END, END, 0, 0]);
            for (word, &cell) in words.iter_mut().zip(cells) {
                *word |= u64::from(cell) << (16 * lane);
            }
        }
        let [min_x, min_y, max_x, max_y] = words;
        Self([min_x, min_y, max_x | FREE, max_y | FREE])
    }

    /// Which of the four meet the box: the free bits of their lanes.
    #[inline(always)]
    fn meeting(&self, near: &Near) -> u64 {
        let [min_x, min_y, max_x, max_y] = self.0;
        // A free bit stays set if nothing was borrowed from it.
        (near.0[2] - min_x) & (near.0[3] - min_y) & (max_x - near.0[0]) & (max_y - near.0[1]) & FREE
    }
}

/// The box of a query, once in every lane: least x and y, largest x and y with the free bits set.
struct Near([u64; 4]);

impl Near {
    #[inline(always)]
    fn new([min_x, min_y, max_x, max_y]: Cells) -> Self {
        let lanes = |cell: u16| u64::from(cell) * ONES;
        Self([lanes(min_x), lanes(min_y), lanes(max_x) | FREE, lanes(max_y) | FREE])
    }
}

impl Boxes {
    /// Prepares the boxes. O(n log n).
    pub fn new(boxes: &[Aabb]) -> Self {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        if boxes.len() > 4 * TOP {
            arrange(&mut order, boxes);
        }
        let grid = Grid::new(boxes);
        let mut around: Vec<Cells> = order.iter().map(|&i| grid.cells(&boxes[i as usize])).collect();
        let mut groups: Vec<Group> = around.chunks(4).map(Group::new).collect();
        let mut levels = vec![0];
        let mut first = 0;
        while groups.len() - first > TOP {
            around = around.chunks(4).map(union).collect();
            first = groups.len();
            levels.push(first);
            groups.extend(around.chunks(4).map(Group::new));
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
        // At most 16 groups: their bits fit side by side, and the end of only one loop is hard to predict.
        let mut bits = 0;
        for (i, group) in self.groups.iter().enumerate() {
            bits |= group.meeting(&near) >> (15 - i);
        }
        while bits != 0 {
            let at = bits.trailing_zeros() as usize;
            if visit(4 * (at % 16) + at / 16) {
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
                    let below = 4 * (at - self.levels[level]) + (bits.trailing_zeros() / 16) as usize;
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

/// The box around up to four.
fn union(boxes: &[Cells]) -> Cells {
    let least = |k: usize| boxes.iter().map(|cells| cells[k]).fold(END, u16::min);
    let most = |k: usize| boxes.iter().map(|cells| cells[k]).fold(0, u16::max);
    [least(0), least(1), most(2), most(3)]
}

/// Orders the boxes so that neighbours are adjacent: the halves along the longer side of the box around all middles, each
/// ordered likewise. The first half is four times a power of two, so that groups of groups are compact too.
fn arrange(order: &mut [u32], boxes: &[Aabb]) {
    if order.len() <= 4 {
        order.sort_unstable();
        return;
    }
    // Twice the middle; coordinates are at most 1e6.
    let middle = |i: u32, axis: usize| boxes[i as usize].min[axis] + boxes[i as usize].max[axis];
    let spread = |axis: usize| {
        let most = order.iter().map(|&i| middle(i, axis)).fold(f64::NEG_INFINITY, f64::max);
        most - order.iter().map(|&i| middle(i, axis)).fold(f64::INFINITY, f64::min)
    };
    let axis = usize::from(spread(1) > spread(0));
    let half = order.len().next_power_of_two() / 2;
    order.select_nth_unstable_by(half, |&i, &j| middle(i, axis).total_cmp(&middle(j, axis)).then(i.cmp(&j)));
    let (front, back) = order.split_at_mut(half);
    arrange(front, boxes);
    arrange(back, boxes);
}
