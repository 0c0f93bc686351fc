//! The proof that an arm's motion is free, by distances.
//!
//! In the middle of a stretch of motion the clearance d of a link from an obstacle and a bound on how far the link can
//! travel to either end are known. If d exceeds the bound by more than the slack, the two are apart on the whole stretch
//! and the pair is dropped for good; otherwise the stretch is halved and the pairs still open are looked at again.
//! (Schwarzer, Saha and Latombe 2005, "Adaptive dynamic collision checking for single and multiple articulated robots in
//! complex environments"; LaValle 2006, "Planning Algorithms", section 5.3.4.)

use super::{Obstacles, Tolerance};
use crate::geometry::{Aabb, Point, Segment};
use crate::robot::{Arm, MAX_LINKS};

/// A link and an obstacle not yet known to be apart.
#[derive(Debug, Clone, Copy)]
struct Pair {
    link: u32,
    obstacle: u32,
}

/// In place of an obstacle's index: the bounds of the world.
const BOUNDS: u32 = u32::MAX;

/// A stretch of the motion: its middle, half its length (both fractions of the motion), and which pairs are open.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    middle: f64,
    half: f64,
    pairs: (usize, usize),
}

/// What one look at the middle of a stretch says.
enum Look {
    /// Every pair is apart on the whole stretch.
    Free,
    /// The pairs at the end of the list from this index on are still open.
    Open(usize),
    /// A pair touches in the middle, or is too near for its bound.
    Refused,
}

/// Whether to give up on a stretch once a pair touches in its middle.
#[derive(Clone, Copy, PartialEq)]
enum Order {
    /// Any hit refuses the motion: level by level, longest stretches first.
    MiddleFirst,
    /// The first hit is wanted: halve towards the front until the bound is below the tolerance.
    FrontFirst,
}

/// Proves motions of one arm in one world.
pub(super) struct Proof<'a> {
    pub arm: &'a Arm,
    pub obstacles: &'a Obstacles,
    pub bounds: Option<&'a Aabb>,
    pub tolerance: Tolerance,
    pub work: &'a mut Work,
}

/// Lists that proofs use again and again, and the count of clearances evaluated.
#[derive(Debug, Clone, Default)]
pub(super) struct Work {
    pairs: Vec<Pair>,
    stretches: Vec<Stretch>,
    pub evaluations: u64,
}

impl Proof<'_> {
    /// Whether the motion from `from` by `delta` (radians a joint, linear in time) is proven free, ends included.
    pub fn is_free(&mut self, from: &[f64], delta: &[f64]) -> bool {
        let travel = self.arm.travel(delta);
        let Some(root) = self.begin(from, delta, &travel) else { return true };
        self.work.stretches.push(root);
        let mut next = 0;
        while next < self.work.stretches.len() {
            let stretch = self.work.stretches[next];
            next += 1;
            match self.look(&stretch, from, delta, &travel, Order::MiddleFirst) {
                Look::Free => {}
                Look::Refused => return false,
                Look::Open(first) => {
                    let [front, back] = halves(&stretch, (first, self.work.pairs.len()));
                    self.work.stretches.extend([front, back]);
                }
            }
        }
        true
    }

    /// Where the first stretch begins that cannot be proven free, as a fraction of the motion; `None` where all is proven.
    pub fn first_hit(&mut self, from: &[f64], delta: &[f64]) -> Option<f64> {
        let travel = self.arm.travel(delta);
        let root = self.begin(from, delta, &travel)?;
        self.work.stretches.push(root);
        while let Some(stretch) = self.work.stretches.pop() {
            // Lists behind this one's belong to stretches already done.
            self.work.pairs.truncate(stretch.pairs.1);
            match self.look(&stretch, from, delta, &travel, Order::FrontFirst) {
                Look::Free => {}
                Look::Refused => return Some(stretch.middle - stretch.half),
                Look::Open(first) => {
                    let [front, back] = halves(&stretch, (first, self.work.pairs.len()));
                    self.work.stretches.extend([back, front]);
                }
            }
        }
        None
    }

    /// Lists the pairs whose boxes are not apart on the whole motion; `None` where there is no such pair.
    fn begin(&mut self, from: &[f64], delta: &[f64], travel: &[f64; MAX_LINKS]) -> Option<Stretch> {
        self.work.pairs.clear();
        self.work.stretches.clear();
        let places = self.places(from, delta, 0.5);
        for link in 0..self.arm.links().len() {
            let reach = 0.5 * travel[link] + self.arm.radius() + self.tolerance.eta;
            let near = Segment::new(places[link], places[link + 1]).aabb().grown(reach);
            let pairs = &mut self.work.pairs;
            self.obstacles
                .candidates(&near, |obstacle| pairs.push(Pair { link: link as u32, obstacle: obstacle as u32 }));
            if self.bounds.is_some_and(|bounds| !(bounds.contains(near.min) && bounds.contains(near.max))) {
                pairs.push(Pair { link: link as u32, obstacle: BOUNDS });
            }
        }
        let count = self.work.pairs.len();
        (count > 0).then_some(Stretch { middle: 0.5, half: 0.5, pairs: (0, count) })
    }

    /// Looks at the middle of the stretch; pairs still open are listed again at the end of the list.
    fn look(
        &mut self,
        stretch: &Stretch,
        from: &[f64],
        delta: &[f64],
        travel: &[f64; MAX_LINKS],
        order: Order,
    ) -> Look {
        let places = self.places(from, delta, stretch.middle);
        let Tolerance { eta, tau } = self.tolerance;
        let first = self.work.pairs.len();
        for at in stretch.pairs.0..stretch.pairs.1 {
            let pair = self.work.pairs[at];
            let link = pair.link as usize;
            let bound = travel[link] * stretch.half;
            let axis = Segment::new(places[link], places[link + 1]);
            let (is_apart, touches) = if pair.obstacle == BOUNDS {
                let depth = self.depth(&axis);
                (depth - bound >= -eta, depth < -eta)
            } else {
                let reach = bound + self.arm.radius() + eta;
                if boxes_apart(&axis, self.obstacles.aabb(pair.obstacle as usize), reach) {
                    continue;
                }
                self.work.evaluations += 1;
                let clearance = self.obstacles.distance(pair.obstacle as usize, &axis) - self.arm.radius();
                (clearance - bound > eta, clearance <= eta)
            };
            if is_apart {
                continue;
            }
            if bound < tau || (touches && order == Order::MiddleFirst) {
                return Look::Refused;
            }
            self.work.pairs.push(pair);
        }
        if self.work.pairs.len() == first { Look::Free } else { Look::Open(first) }
    }

    /// How deep within the bounds the link lies: negative where a part of it is outside.
    fn depth(&self, axis: &Segment) -> f64 {
        let bounds = self.bounds.expect("a pair with the bounds exists only where there are bounds");
        bounds.depth(axis.a).min(bounds.depth(axis.b)) - self.arm.radius()
    }

    /// The places of the joints at fraction `t` of the motion.
    fn places(&self, from: &[f64], delta: &[f64], t: f64) -> [Point; MAX_LINKS + 1] {
        let mut q = [0.0; MAX_LINKS];
        for i in 0..self.arm.links().len() {
            q[i] = from[i] + t * delta[i];
        }
        self.arm.joints(&q)
    }
}

/// Whether the boxes of segment and obstacle are more than `reach` apart.
fn boxes_apart(axis: &Segment, aabb: &Aabb, reach: f64) -> bool {
    !axis.aabb().grown(reach).intersects(aabb)
}

/// The two halves of a stretch, with the pairs that are open on it.
fn halves(stretch: &Stretch, pairs: (usize, usize)) -> [Stretch; 2] {
    let half = stretch.half / 2.0;
    [stretch.middle - half, stretch.middle + half].map(|middle| Stretch { middle, half, pairs })
}
