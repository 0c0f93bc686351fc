//! The driver of the proof, for arms and bodies: the algorithm of the [module](super).
//!
//! **Budget.** Let l be the number of halvings until the bound on travel is below the tolerance, at most 48, and p the
//! number of pairs open after the first interval. A motion that comes close to obstacles here and there leaves an
//! interval or two open a pair and level, since clearance grows as fast as distance from the closest position: some 2 l p
//! tests. One that slides along an obstacle at distance d leaves as many intervals open as third-order bounds need, about
//! (travel/d)^(1/2). So a motion gets l (2 p + [`CLOSE_TESTS`]) tests after those of the first interval, which are no
//! more than parts times obstacles. A motion that needs more is refused as not proven, and counted in
//! [`Prover::unproven`]. The finest tolerance allows the most halvings, so it also proves every motion that a coarser
//! one proves within its budget.

use super::pair::{NO_HINT, Part, Separation, find_direction, offset, separate_from_polygon};
use crate::collision::{Obstacles, Tolerance};
use crate::geometry::Aabb;
use std::sync::Arc;

/// The number of open intervals above which the proof continues depth-first: bounds memory.
const WIDEST: usize = 1024;

/// Tests per level that a motion is given in addition to two per pair.
const CLOSE_TESTS: u64 = 1 << 13;

/// After this many tests, and 16 more per pair, the best separating direction is searched for each unresolved pair. For
/// shorter proofs the search does not pay off.
const SEARCHED: u64 = 1 << 10;

/// Instead of an obstacle's index: the bounds of the world.
const BOUNDS: u32 = u32::MAX;

/// The surroundings of the robot.
pub(in crate::collision) struct Scene {
    /// The obstacles, each convex.
    pub obstacles: Arc<Obstacles>,
    pub bounds: Option<Aabb>,
    pub tolerance: Tolerance,
}

/// A robot of convex parts whose motion is proven: an arm or a body. It holds the data of one motion and of the interval
/// under test.
pub(in crate::collision) trait Moving {
    /// The state in the middle of an interval.
    type State: Copy;
    type Part<'a>: Part
    where
        Self: 'a;

    /// The number of parts.
    fn parts(&self) -> usize;

    /// Makes the first `parts` parts ready for tests on the interval.
    fn place(&mut self, interval: &Interval<Self::State>, parts: usize);

    /// The states in the middles of the interval's halves, the front one first.
    fn halves(&mut self, interval: &Interval<Self::State>) -> [Self::State; 2];

    /// A part that has been placed.
    fn part(&self, part: usize, state: &Self::State) -> Self::Part<'_>;

    /// A box that holds the part, grown by [`Moving::margin`], on the whole interval of this half-length.
    fn swept_box(&self, part: usize, half: f64) -> Aabb;

    /// The depth of the part within the bounds in the middle; negative if it is not wholly inside.
    fn depth(&self, part: usize, bounds: &Aabb) -> f64;

    /// An upper bound of first order on how far any point of the part can travel along the whole motion. No part has a
    /// greater one than the last.
    fn travel(&self, part: usize) -> f64;

    /// The least distance of a part from an obstacle: its radius and the slack.
    fn margin(&self) -> f64;
}

/// An interval of the motion: its middle and half its length, as fractions of the motion; the number of halvings; and the
/// range of the pairs that are open on it.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct Interval<S> {
    pub middle: f64,
    pub half: f64,
    pub level: usize,
    pairs: (usize, usize),
    pub state: S,
}

/// A part and an obstacle not yet known to be apart.
#[derive(Debug, Clone, Copy)]
struct Pair {
    part: u32,
    obstacle: u32,
    /// The direction to try first: see [`separate_from_polygon`].
    hint: u32,
}

/// The order in which intervals are tested.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::collision) enum Order {
    /// Any hit refuses the motion: level by level, the longest intervals first.
    MiddleFirst,
    /// The first hit is wanted: halve towards the front until the bound is below the tolerance.
    FrontFirst,
}

/// A robot, lists that proofs reuse, and counts of their work.
pub(in crate::collision) struct Prover<M: Moving> {
    pub moving: M,
    pairs: Vec<Pair>,
    intervals: Vec<Interval<M::State>>,
    /// Pairs of a part and an obstacle evaluated so far.
    pub evaluations: u64,
    /// Motions refused because their budget was spent.
    pub unproven: u64,
}

impl<M: Moving> Prover<M> {
    pub fn new(moving: M) -> Self {
        Self { moving, pairs: Vec::new(), intervals: Vec::new(), evaluations: 0, unproven: 0 }
    }

    /// The start, as a fraction of the motion, of the first interval, in this order, that cannot be proven free; `None`
    /// if all of the motion is proven free, ends included. With [`Order::FrontFirst`] everything before that is proven
    /// free. `state` is the state in the middle of the whole motion.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    pub fn first_unproven(&mut self, scene: &Scene, state: M::State, order: Order) -> Option<f64> {
        self.pairs.clear();
        self.intervals.clear();
        let mut proof = Proof { scene, order, searches: false, prover: self };
        let whole = Interval { middle: 0.5, half: 0.5, level: 0, pairs: (0, 0), state };
        if proof.test_all(&whole) {
            return Some(0.0);
        }
        let open = proof.prover.pairs.len();
        if open == 0 {
            return None;
        }
        let (mut tests, mut budget) = (0, CLOSE_TESTS);
        proof.halve(&whole, 0);
        let mut next = 0;
        while next < proof.prover.intervals.len() {
            let is_last = order == Order::FrontFirst || proof.prover.intervals.len() - next > WIDEST;
            let interval = if is_last {
                // The front is last; and if there are too many open intervals, the last one is taken first. Pairs listed
                // after its own belong to intervals already done.
                let last = proof.prover.intervals.pop().expect("some are left");
                proof.prover.pairs.truncate(last.pairs.1);
                last
            } else {
                next += 1;
                proof.prover.intervals[next - 1]
            };
            tests += (interval.pairs.1 - interval.pairs.0) as u64;
            proof.searches = tests > SEARCHED + 16 * open as u64;
            if tests > budget {
                budget = proof.budget(open);
                if tests > budget {
                    proof.prover.unproven += 1;
                    return Some(interval.middle - interval.half);
                }
            }
            let first = proof.prover.pairs.len();
            if proof.test_open(&interval) {
                return Some(interval.middle - interval.half);
            }
            if proof.prover.pairs.len() > first {
                proof.halve(&interval, first);
            }
        }
        None
    }

    /// Whether the robot, placed at rest, is clear of everything; `None` if the result depends on less than half the slack, so
    /// that exact distances are needed.
    pub fn is_free_at_rest(&mut self, scene: &Scene, state: &M::State) -> Option<bool> {
        let eta = scene.tolerance.eta;
        let mut is_clear = true;
        for part in 0..self.moving.parts() {
            let around = self.moving.swept_box(part, 0.0);
            if let Some(bounds) = &scene.bounds
                && !(bounds.contains(around.min) && bounds.contains(around.max))
            {
                let depth = self.moving.depth(part, bounds);
                if depth < -1.5 * eta {
                    return Some(false);
                }
                is_clear &= depth >= -0.5 * eta;
            }
            let near = around.grown(0.5 * eta);
            let (part, margin) = (self.moving.part(part, state), self.moving.margin());
            let touches = |obstacle: usize| {
                self.evaluations += 1;
                let faces = scene.obstacles.faces(obstacle);
                if !faces.is_empty() {
                    match separate_from_polygon(&part, faces, NO_HINT, margin + 0.5 * eta, eta).0 {
                        Separation::Apart => return false,
                        Separation::Touching => return true,
                        Separation::Open | Separation::Unknown => {}
                    }
                }
                let room = offset(&part, &scene.obstacles, obstacle).1 - margin;
                is_clear &= room.abs() > 0.5 * eta;
                room < -0.5 * eta
            };
            if scene.obstacles.any_near(&near, touches) {
                return Some(false);
            }
        }
        is_clear.then_some(true)
    }
}

/// One proof in progress.
struct Proof<'a, M: Moving> {
    scene: &'a Scene,
    order: Order,
    /// Whether directions are searched for.
    searches: bool,
    prover: &'a mut Prover<M>,
}

impl<M: Moving> Proof<'_, M> {
    /// Tests every part against everything near its swept box; lists what stays open. Returns whether the motion is refused.
    #[inline(always)]
    fn test_all(&mut self, whole: &Interval<M::State>) -> bool {
        let scene = self.scene;
        let parts = self.prover.moving.parts();
        self.prover.moving.place(whole, parts);
        for part in 0..parts {
            let swept = self.prover.moving.swept_box(part, whole.half);
            if scene.obstacles.any_near(&swept, |obstacle| self.test(whole, part, obstacle, NO_HINT)) {
                return true;
            }
            if scene.bounds.is_some() && self.test_bounds(whole, part, &swept) {
                return true;
            }
        }
        false
    }

    /// Tests the pairs still open; lists again what stays so. Returns whether the interval is refused.
    #[inline(always)]
    fn test_open(&mut self, interval: &Interval<M::State>) -> bool {
        let (first, end) = interval.pairs;
        // Pairs are listed by part: the last has the last part.
        let parts = self.prover.pairs[end - 1].part as usize + 1;
        self.prover.moving.place(interval, parts);
        let mut of = self.prover.pairs[first].part as usize;
        let mut swept = self.prover.moving.swept_box(of, interval.half);
        (first..end).any(|at| {
            let Pair { part, obstacle, hint } = self.prover.pairs[at];
            let part = part as usize;
            if part != of {
                (of, swept) = (part, self.prover.moving.swept_box(part, interval.half));
            }
            if obstacle == BOUNDS {
                self.test_bounds(interval, part, &swept)
            } else {
                self.scene.obstacles.aabb(obstacle as usize).intersects(&swept)
                    && self.test(interval, part, obstacle as usize, hint)
            }
        })
    }

    /// Tests a part and an obstacle; lists them if they stay open. Returns whether they refuse the interval.
    #[inline(always)]
    fn test(&mut self, interval: &Interval<M::State>, part: usize, obstacle: usize, hint: u32) -> bool {
        self.prover.evaluations += 1;
        let (answer, hint) = self.separate(interval, part, obstacle, hint);
        let pair = Pair { part: part as u32, obstacle: obstacle as u32, hint };
        answer != Separation::Apart && self.list_or_refuse(interval, pair, answer, self.scene.tolerance.tau)
    }

    /// Whether part and obstacle are apart on the whole interval: in the directions at hand, else in those of
    /// [`Proof::separate_closely`].
    #[inline(always)]
    fn separate(&self, interval: &Interval<M::State>, part: usize, obstacle: usize, hint: u32) -> (Separation, u32) {
        let Tolerance { eta, tau, .. } = self.scene.tolerance;
        let moving = &self.prover.moving;
        let faces = self.scene.obstacles.faces(obstacle);
        let bound = moving.travel(part) * interval.half;
        let part = moving.part(part, &interval.state);
        let mut next = NO_HINT;
        if !faces.is_empty() {
            let answer;
            (answer, next) = separate_from_polygon(&part, faces, hint, moving.margin(), eta);
            let is_enough = answer == Separation::Open && bound >= tau && !self.searches;
            if is_enough || matches!(answer, Separation::Apart | Separation::Touching) {
                return (answer, next);
            }
        }
        (self.separate_closely(&part, obstacle, bound), next)
    }

    /// The same by the nearest points: their direction, their distance against the bound of first order, and, if
    /// directions are searched for, the best.
    #[inline(never)]
    fn separate_closely(&self, part: &M::Part<'_>, obstacle: usize, bound: f64) -> Separation {
        let (obstacles, margin) = (&self.scene.obstacles, self.prover.moving.margin());
        let (towards, distance) = offset(part, obstacles, obstacle);
        if distance <= margin {
            Separation::Touching
        } else if distance - bound > margin || find_direction(part, obstacles, obstacle, towards, margin, self.searches)
        {
            Separation::Apart
        } else {
            Separation::Open
        }
    }

    /// Whether the part stays within the bounds of the world, contact allowed; lists it if that is open. Returns whether it
    /// refuses the interval.
    #[inline(always)]
    fn test_bounds(&mut self, interval: &Interval<M::State>, part: usize, swept: &Aabb) -> bool {
        let bounds = self.scene.bounds.as_ref().expect("a pair with the bounds exists only where there are bounds");
        let Tolerance { eta, bounds_tau, .. } = self.scene.tolerance;
        // The swept box already holds one slack; contact may exceed the bounds by one.
        let roomy = bounds.grown(2.0 * eta);
        if roomy.contains(swept.min) && roomy.contains(swept.max) {
            return false;
        }
        let depth = self.prover.moving.depth(part, bounds);
        if depth - self.prover.moving.travel(part) * interval.half >= -eta {
            return false;
        }
        let answer = if depth < -eta { Separation::Touching } else { Separation::Open };
        self.list_or_refuse(interval, Pair { part: part as u32, obstacle: BOUNDS, hint: NO_HINT }, answer, bounds_tau)
    }

    /// Lists a pair that is not apart; returns whether it refuses the interval instead.
    #[inline(always)]
    fn list_or_refuse(&mut self, interval: &Interval<M::State>, pair: Pair, answer: Separation, tau: f64) -> bool {
        let is_hit = answer == Separation::Touching && self.order == Order::MiddleFirst;
        if is_hit || self.prover.moving.travel(pair.part as usize) * interval.half < tau {
            return true;
        }
        self.prover.pairs.push(pair);
        false
    }

    /// Adds the two halves of an interval, with the pairs from `first` on open.
    #[inline(always)]
    fn halve(&mut self, interval: &Interval<M::State>, first: usize) {
        let (half, level) = (interval.half / 2.0, interval.level + 1);
        let pairs = (first, self.prover.pairs.len());
        let [front, back] = self.prover.moving.halves(interval);
        let mut push = |middle: f64, state: M::State| {
            self.prover.intervals.push(Interval { middle, half, level, pairs, state });
        };
        if self.order == Order::FrontFirst {
            push(interval.middle + half, back);
            push(interval.middle - half, front);
        } else {
            push(interval.middle - half, front);
            push(interval.middle + half, back);
        }
    }

    /// The budget of tests after the first interval, which left `open` pairs open.
    #[cold]
    fn budget(&self, open: usize) -> u64 {
        let Tolerance { tau, bounds_tau, .. } = self.scene.tolerance;
        let moving = &self.prover.moving;
        let levels = libm::log2(moving.travel(moving.parts() - 1) / tau.min(bounds_tau)).ceil().max(1.0) as u64;
        levels.saturating_mul(2 * open as u64 + CLOSE_TESTS)
    }
}
