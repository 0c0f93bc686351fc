//! Boxes that can be asked which of them meet another: four at a time, and by a tree where there are many.
//!
//! Coordinates are kept as `f32`: rounding to nearest never turns two numbers round, so boxes that meet still meet once
//! rounded. What is listed is all that meets, and rarely a box that is only all but touched.
//!
//! The tree is implicit, with four branches: boxes are ordered by splitting them again and again along the longer side of
//! their common box; then every four neighbours make a group, the boxes around every four groups the next level's groups,
//! and so on.

use crate::geometry::Aabb;

/// Levels are added until the last has this many groups or fewer, which are all looked at.
const TOP: usize = 16;

/// More groups than wait in a walk down the tree: three a level, and up to 2^32 boxes.
const STACK: usize = 48;

/// Boxes, ready to be asked.
#[derive(Debug, Clone)]
pub(super) struct Boxes {
    /// All levels behind each other, the one of the boxes themselves first.
    groups: Vec<Group>,
    /// Where each level begins.
    levels: Vec<usize>,
    /// Which box stands where in the groups of the first level.
    order: Vec<u32>,
}

/// Four boxes, side by side.
#[derive(Debug, Clone, Copy)]
struct Group {
    min_x: [f32; 4],
    min_y: [f32; 4],
    max_x: [f32; 4],
    max_y: [f32; 4],
}

/// A box that meets none.
const NOWHERE: Lanes = [f32::INFINITY, f32::INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY];

/// One box: its least x and y, its largest x and y.
type Lanes = [f32; 4];

fn lanes(aabb: &Aabb) -> Lanes {
    [aabb.min.x as f32, aabb.min.y as f32, aabb.max.x as f32, aabb.max.y as f32]
}

impl Group {
    /// Of up to four boxes.
    fn new(boxes: &[Lanes]) -> Self {
        let side = |k: usize| std::array::from_fn(|lane| boxes.get(lane).unwrap_or(&NOWHERE)[k]);
        Self { min_x: side(0), min_y: side(1), max_x: side(2), max_y: side(3) }
    }

    /// The box around all four.
    fn around(&self) -> Lanes {
        let least = |side: [f32; 4]| side.into_iter().fold(f32::INFINITY, f32::min);
        let most = |side: [f32; 4]| side.into_iter().fold(f32::NEG_INFINITY, f32::max);
        [least(self.min_x), least(self.min_y), most(self.max_x), most(self.max_y)]
    }

    /// Which of the four meet the box: one bit each.
    #[inline(always)]
    fn meeting(&self, near: Lanes) -> u32 {
        let mut bits = 0;
        for lane in 0..4 {
            let meets = (self.min_x[lane] <= near[2])
                & (self.min_y[lane] <= near[3])
                & (self.max_x[lane] >= near[0])
                & (self.max_y[lane] >= near[1]);
            bits |= u32::from(meets) << lane;
        }
        bits
    }
}

impl Boxes {
    /// Takes the boxes up. O(n log n).
    pub fn new(boxes: &[Aabb]) -> Self {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        if boxes.len() > 4 * TOP {
            arrange(&mut order, boxes);
        }
        let leaves: Vec<Lanes> = order.iter().map(|&i| lanes(&boxes[i as usize])).collect();
        let mut groups: Vec<Group> = leaves.chunks(4).map(Group::new).collect();
        let mut levels = vec![0];
        let mut first = 0;
        while groups.len() - first > TOP {
            let around: Vec<Lanes> = groups[first..].iter().map(Group::around).collect();
            first = groups.len();
            levels.push(first);
            groups.extend(around.chunks(4).map(Group::new));
        }
        Self { groups, levels, order }
    }

    /// Calls `visit` with the index of every box that meets `near` until it answers true, in an order that depends on the
    /// boxes alone; answers whether it did.
    #[inline(always)]
    pub fn any(&self, near: &Aabb, mut visit: impl FnMut(usize) -> bool) -> bool {
        let near = lanes(near);
        if self.levels.len() > 1 {
            return self.any_below(near, &mut visit);
        }
        for (i, group) in self.groups.iter().enumerate() {
            let mut bits = group.meeting(near);
            while bits != 0 {
                if visit(4 * i + bits.trailing_zeros() as usize) {
                    return true;
                }
                bits &= bits - 1;
            }
        }
        false
    }

    /// The same by the tree.
    #[inline(never)]
    fn any_below(&self, near: Lanes, visit: &mut dyn FnMut(usize) -> bool) -> bool {
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
                    let below = 4 * (at - self.levels[level]) + bits.trailing_zeros() as usize;
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

/// Orders the boxes so that neighbours stand together: the halves along the longer side of the box around all middles, each
/// ordered likewise. The first half is four times a power of two, so that groups of groups hold together too.
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
