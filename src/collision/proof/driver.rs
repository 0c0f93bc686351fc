//! The driver of the proof, for arms and bodies: the algorithm of the [module](super).
//!
//! **Budget.** Let l be the number of halvings until the bound on travel is below the tolerance, at most 48, and p the
//! number of pairs open after the first intervals. A motion that comes close to obstacles here and there leaves an
//! interval or two open a pair and level, since clearance grows as fast as distance from the closest position: some 2 l p
//! tests. One that slides along an obstacle at distance d leaves as many intervals open as third-order bounds need, about
//! (travel/d)^(1/2). So a motion gets l (2 p + [`CLOSE_TESTS`]) tests after those of the first intervals, which are no
//! more than parts times obstacles each. A motion that needs more is refused as not proven, and counted in
//! [`Prover::unproven`]. The finest tolerance allows the most halvings, so it also proves every motion that a coarser
//! one proves within its budget.

use super::moving_point::BOTH;
use super::pair::{
    NO_HINT, Part, Separation, find_direction, offset, separate_from_disc, separate_from_polygon, swept_box,
};
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

/// Instead of the index of a direction: the pair is apart.
const APART: u32 = NO_HINT - 1;

/// The surroundings of the robot.
pub(in crate::collision) struct Scene {
    /// The obstacles, each convex, or a convex core and all within a radius of it.
    pub obstacles: Arc<Obstacles>,
    pub bounds: Option<Aabb>,
    pub tolerance: Tolerance,
}

/// A robot of convex parts whose motion is proven: an arm or a body. It holds the data of one motion, and of the interval
/// whose halves are under test: both are tested at once, each in a lane of vectors.
pub(in crate::collision) trait Moving {
    /// The state in the middle of an interval.
    type State: Copy;
    type Part<'a>: Part
    where
        Self: 'a;

    /// The number of parts.
    fn parts(&self) -> usize;

    /// Places the first `parts` parts in the middles of both halves of the interval; `state` is that in its middle.
    fn place(&mut self, interval: &Interval, state: &Self::State, parts: usize);

    /// The state in the middle of a half, as far as parts have been placed.
    fn state(&self, half: usize) -> Self::State;

    /// A part that has been placed.
    fn part(&self, part: usize) -> Self::Part<'_>;

    /// A box that holds the part, grown by [`Moving::margin`], on both halves.
    fn swept_box(&self, part: usize) -> Aabb;

    /// The depth of the part within the bounds in the middle of a half; negative if it is not wholly inside.
    fn depth(&self, part: usize, half: usize, bounds: &Aabb) -> f64;

    /// An upper bound of first order on how far any point of the part can travel along the whole motion. No part has a
    /// greater one than the last.
    fn travel(&self, part: usize) -> f64;

    /// The least distance of a part from an obstacle: its radius and the slack.
    fn margin(&self) -> f64;
}

/// An interval of the motion, whose halves are to be tested.
#[derive(Debug, Clone, Copy)]
pub(in crate::collision) struct Interval {
    /// Its middle and half its length, as fractions of the motion.
    pub middle: f64,
    pub half: f64,
    /// The number of halvings that led to it.
    pub level: usize,
    /// The range of the pairs among which are those open on it, and which half of their interval it is: its lane.
    pairs: (usize, usize),
    lane: usize,
    /// Whether it has been refused.
    is_refused: bool,
}

impl Interval {
    /// The whole motion.
    const WHOLE: Self = Self { middle: 0.5, half: 0.5, level: 0, pairs: (0, 0), lane: 0, is_refused: false };

    /// The parts of the motion after this many halvings, each far from the one before (van der Corput 1935,
    /// "Verteilungsfunktionen").
    fn parts(level: u32) -> impl Iterator<Item = Self> {
        let half = 0.5 / f64::from(1u32 << level);
        (0..1u32 << level).map(move |i| {
            let at = if level == 0 { 0 } else { i.reverse_bits() >> (32 - level) };
            Self { middle: f64::from(2 * at + 1) * half, half, level: level as usize, ..Self::WHOLE }
        })
    }
}

/// A part and an obstacle not yet known to be apart on some half of an interval.
#[derive(Debug, Clone, Copy)]
struct Pair {
    part: u32,
    obstacle: u32,
    /// On each half the direction to try first, see [`separate_from_polygon`]; or [`APART`].
    hints: [u32; 2],
}

/// The order in which intervals are tested.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::collision) enum Order {
    /// Any hit refuses the motion: level by level, the longest intervals first.
    MiddleFirst,
    /// The first hit is wanted: halve towards the front until the bound is below the tolerance, or, if the motion consists of a
    /// number of equal steps, until it is known in which of them the hit is.
    FrontFirst { steps: Option<f64> },
}

/// A robot, lists that proofs reuse, and counts of their work.
pub(in crate::collision) struct Prover<M: Moving> {
    pub moving: M,
    pairs: Vec<Pair>,
    /// Intervals that were added, and the states in their middles.
    intervals: Vec<Interval>,
    states: Vec<M::State>,
    /// Pairs of a part and an obstacle evaluated so far, each half of an interval by itself.
    pub evaluations: u64,
    /// Motions refused because their budget was spent.
    pub unproven: u64,
}

impl<M: Moving> Prover<M> {
    pub fn new(moving: M) -> Self {
        Self { moving, pairs: Vec::new(), intervals: Vec::new(), states: Vec::new(), evaluations: 0, unproven: 0 }
    }

    /// The start, as a fraction of the motion, of the first interval, in this order, that cannot be proven free; `None` if all of
    /// the motion is proven free, ends included. With [`Order::FrontFirst`] everything before that is proven free, and of a
    /// motion of steps only the step of the result is that of the first interval. `state` is the state in the middle of the whole
    /// motion. If any hit refuses the motion, `halvings` may be above 0 where a state is nothing: the motion is halved that often
    /// before anything is tested, since a long one is near many obstacles, of which each part meets few.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    pub fn first_unproven(&mut self, scene: &Scene, state: M::State, order: Order, halvings: u32) -> Option<f64> {
        self.pairs.clear();
        self.intervals.clear();
        self.states.clear();
        let mut proof = Proof { scene, order, searches: false, open: 0, refused: 0, prover: self };
        for part in Interval::parts(halvings) {
            let first = proof.prover.pairs.len();
            proof.test_all(&part, &state);
            if let Some(hit) = proof.continue_with_halves(&part, first) {
                return Some(hit);
            }
        }
        let open = proof.prover.pairs.len();
        let (mut tests, mut budget) = (0, CLOSE_TESTS);
        let mut next = 0;
        while next < proof.prover.intervals.len() {
            // The front is last; and if there are too many open intervals, the last one is taken first.
            let is_last = order != Order::MiddleFirst || proof.prover.intervals.len() - next > WIDEST;
            let at = if is_last { proof.prover.intervals.len() - 1 } else { next };
            let interval = proof.prover.intervals[at];
            if interval.is_refused {
                return Some(interval.middle - interval.half);
            }
            tests += 2 * (interval.pairs.1 - interval.pairs.0) as u64;
            proof.searches = tests > SEARCHED + 16 * open as u64;
            if tests > budget {
                budget = proof.budget(open);
                if tests > budget {
                    proof.prover.unproven += 1;
                    return Some(interval.middle - interval.half);
                }
            }
            proof.place(&interval, at);
            if is_last {
                // Pairs listed after its own belong to intervals already done.
                proof.prover.intervals.truncate(at);
                proof.prover.states.truncate(at);
                proof.prover.pairs.truncate(interval.pairs.1);
            } else {
                next += 1;
            }
            let first = proof.prover.pairs.len();
            proof.test_open(&interval);
            if let Some(hit) = proof.continue_with_halves(&interval, first) {
                return Some(hit);
            }
        }
        None
    }

    /// Whether the robot, placed at rest, is clear of everything; `None` if the result depends on less than half the slack, so
    /// that exact distances are needed.
    pub fn is_free_at_rest(&mut self, scene: &Scene) -> Option<bool> {
        let eta = scene.tolerance.eta;
        let mut is_clear = true;
        for part in 0..self.moving.parts() {
            let around = self.moving.swept_box(part);
            if let Some(bounds) = &scene.bounds
                && !(bounds.contains(around.min) && bounds.contains(around.max))
            {
                let depth = self.moving.depth(part, 0, bounds);
                if depth < -1.5 * eta {
                    return Some(false);
                }
                is_clear &= depth >= -0.5 * eta;
            }
            let near = around.grown(0.5 * eta);
            let (part, own) = (self.moving.part(part), self.moving.margin());
            let touches = |obstacle: usize| {
                self.evaluations += 1;
                let margin = own + scene.obstacles.radius(obstacle);
                let faces = scene.obstacles.faces(obstacle);
                if !faces.is_empty() {
                    let needed = margin + 0.5 * eta;
                    match separate_from_polygon(&part, faces, NO_HINT, needed, eta).on(0, needed, eta).0 {
                        Separation::Apart => return false,
                        Separation::Touching => return true,
                        Separation::Open | Separation::Unknown => {}
                    }
                }
                let room = offset(&part, 0, &scene.obstacles, obstacle).1 - margin;
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

/// The separation of a pair on both halves, with the next hints.
type Answers = [(Separation, u32); 2];

/// One proof in progress.
struct Proof<'a, M: Moving> {
    scene: &'a Scene,
    order: Order,
    /// Whether directions are searched for.
    searches: bool,
    /// The halves of the interval under test on which a pair is open, and those that are refused.
    open: u32,
    refused: u32,
    prover: &'a mut Prover<M>,
}

impl<M: Moving> Proof<'_, M> {
    /// Tests every part against everything near its swept box; lists what stays open.
    #[inline(always)]
    fn test_all(&mut self, whole: &Interval, state: &M::State) {
        (self.open, self.refused) = (0, 0);
        let scene = self.scene;
        let parts = self.prover.moving.parts();
        self.prover.moving.place(whole, state, parts);
        // The last first: it moves farthest.
        for part in (0..parts).rev() {
            let swept = self.prover.moving.swept_box(part);
            if scene.obstacles.any_near(&swept, |obstacle| self.test(whole, part, obstacle, NO_HINT))
                || (scene.bounds.is_some() && self.test_bounds(whole, part, &swept))
            {
                return;
            }
        }
    }

    /// Places the parts of the pairs open on an interval, which is that with the given index.
    #[inline(always)]
    fn place(&mut self, interval: &Interval, at: usize) {
        let Prover { moving, states, pairs, .. } = &mut *self.prover;
        // Pairs are listed by part, the last first.
        moving.place(interval, &states[at], pairs[interval.pairs.0].part as usize + 1);
    }

    /// Tests the pairs still open on an interval that has been placed; lists again what stays so.
    #[inline(always)]
    fn test_open(&mut self, interval: &Interval) {
        (self.open, self.refused) = (0, 0);
        let (first, end) = interval.pairs;
        for at in first..end {
            let Pair { part, obstacle, hints } = self.prover.pairs[at];
            let (part, hint) = (part as usize, hints[interval.lane]);
            let ends = if hint == APART {
                false
            } else if obstacle == BOUNDS {
                let swept = self.prover.moving.swept_box(part);
                self.test_bounds(interval, part, &swept)
            } else {
                self.test(interval, part, obstacle as usize, hint)
            };
            if ends {
                return;
            }
        }
    }

    /// After the test of an interval: the start of the first part of it that is refused, if that is known; else adds the halves
    /// that need to be halved, with the pairs from `first` on.
    #[inline(always)]
    fn continue_with_halves(&mut self, interval: &Interval, first: usize) -> Option<f64> {
        let (half, level) = (interval.half / 2.0, interval.level + 1);
        if self.refused != 0 && (self.order == Order::MiddleFirst || self.refused & 1 != 0) {
            return Some(if self.refused & 1 != 0 { interval.middle - interval.half } else { interval.middle });
        }
        let pairs = (first, self.prover.pairs.len());
        // Of a list whose last is taken first, the front half comes last.
        for lane in if self.order == Order::MiddleFirst { [0, 1] } else { [1, 0] } {
            let is_refused = self.refused >> lane & 1 != 0;
            if is_refused || self.open >> lane & 1 != 0 {
                let middle = if lane == 0 { interval.middle - half } else { interval.middle + half };
                self.prover.intervals.push(Interval { middle, half, level, pairs, lane, is_refused });
                self.prover.states.push(self.prover.moving.state(lane));
            }
        }
        None
    }

    /// Tests a part and an obstacle; lists them if they stay open. Returns whether no more tests of the interval are needed,
    /// as it is refused.
    #[inline(always)]
    fn test(&mut self, interval: &Interval, part: usize, obstacle: usize, hint: u32) -> bool {
        self.prover.evaluations += 2;
        let bound = 0.5 * self.prover.moving.travel(part) * interval.half;
        let is_close = bound < self.scene.tolerance.tau;
        let Some(answers) = self.separate(part, obstacle, hint, bound, is_close) else { return false };
        self.list_or_refuse(interval, [part as u32, obstacle as u32], answers, is_close)
    }

    /// Whether part and obstacle are apart on each half, and the next hints: in the directions at hand, else in those of
    /// [`Proof::separate_closely`]. `None` if they are apart on both.
    #[inline(always)]
    fn separate(&self, part: usize, obstacle: usize, hint: u32, bound: f64, is_close: bool) -> Option<Answers> {
        let Tolerance { eta, .. } = self.scene.tolerance;
        let moving = &self.prover.moving;
        let margin = moving.margin() + self.scene.obstacles.radius(obstacle);
        let faces = self.scene.obstacles.faces(obstacle);
        let part = moving.part(part);
        let mut answers = [(Separation::Unknown, NO_HINT); 2];
        // The distance from a disc is known, but for a slack; of that from a polygon only whether they overlap.
        let (separated, slack) = match self.scene.obstacles.disc(obstacle) {
            Some(disc) => (Some(separate_from_disc(&part, disc, margin)), 2.0 * eta - margin),
            None if faces.is_empty() => (None, eta),
            None => (Some(separate_from_polygon(&part, faces, hint, margin, eta)), eta),
        };
        if let Some(separated) = separated {
            if separated.apart == BOTH {
                return None;
            }
            answers = [separated.on(0, margin, slack), separated.on(1, margin, slack)];
        }
        for (half, (answer, _)) in answers.iter_mut().enumerate() {
            let is_enough = *answer == Separation::Open && !is_close && !self.searches;
            if !is_enough && !matches!(answer, Separation::Apart | Separation::Touching) {
                *answer = self.separate_closely(&part, half, obstacle, bound);
            }
        }
        Some(answers)
    }

    /// Whether they are apart on a half by the nearest points: their direction, their distance against the bound of first
    /// order, and, if directions are searched for, the best; or by their boxes.
    #[inline(never)]
    fn separate_closely(&self, part: &M::Part<'_>, half: usize, obstacle: usize, bound: f64) -> Separation {
        let (obstacles, own) = (&self.scene.obstacles, self.prover.moving.margin());
        let margin = own + obstacles.radius(obstacle);
        let (towards, distance) = offset(part, half, obstacles, obstacle);
        if distance <= margin {
            Separation::Touching
        } else if distance - bound > margin
            || !swept_box(part, half).grown(own).intersects(obstacles.aabb(obstacle))
            || find_direction(part, half, obstacles, obstacle, towards, margin, self.searches)
        {
            Separation::Apart
        } else {
            Separation::Open
        }
    }

    /// Whether the part stays within the bounds of the world, contact allowed; lists it if that is open. Returns whether no
    /// more tests of the interval are needed.
    #[inline(always)]
    fn test_bounds(&mut self, interval: &Interval, part: usize, swept: &Aabb) -> bool {
        let bounds = self.scene.bounds.as_ref().expect("a pair with the bounds exists only where there are bounds");
        let Tolerance { eta, bounds_tau, .. } = self.scene.tolerance;
        // A swept box holds one slack; contact may exceed the bounds by one.
        let roomy = bounds.grown(2.0 * eta);
        let holds = |swept: &Aabb| roomy.contains(swept.min) && roomy.contains(swept.max);
        if holds(swept) {
            return false;
        }
        let moving = &self.prover.moving;
        let travel = 0.5 * moving.travel(part) * interval.half;
        let mut answers = [(Separation::Apart, NO_HINT); 2];
        for (half, (answer, _)) in answers.iter_mut().enumerate() {
            let depth = moving.depth(part, half, bounds);
            let is_inside =
                depth - travel >= -eta || holds(&swept_box(&moving.part(part), half).grown(moving.margin()));
            if !is_inside {
                *answer = if depth < -eta { Separation::Touching } else { Separation::Open };
            }
        }
        self.list_or_refuse(interval, [part as u32, BOUNDS], answers, travel < bounds_tau)
    }

    /// Lists a pair that is not apart on both halves, or refuses those on which it is close or touching. Returns whether no
    /// more tests of the interval are needed.
    #[inline(always)]
    fn list_or_refuse(
        &mut self,
        interval: &Interval,
        [part, obstacle]: [u32; 2],
        answers: Answers,
        is_close: bool,
    ) -> bool {
        let mut hints = [APART; 2];
        for (half, &(answer, hint)) in answers.iter().enumerate() {
            let is_hit = answer == Separation::Touching && self.is_located(interval, half);
            if answer == Separation::Apart {
            } else if is_hit || is_close {
                self.refused |= 1 << half;
            } else {
                self.open |= 1 << half;
                hints[half] = hint;
            }
        }
        if hints != [APART; 2] {
            self.prover.pairs.push(Pair { part, obstacle, hints });
        }
        self.refused & 1 != 0 || (self.refused != 0 && self.order == Order::MiddleFirst)
    }

    /// Whether it is known well enough where the hit is if the robot touches something in the middle of a half: in the step in
    /// which that half begins, if all before it is free.
    #[inline(always)]
    fn is_located(&self, interval: &Interval, half: usize) -> bool {
        match self.order {
            Order::MiddleFirst => true,
            Order::FrontFirst { steps: None } => false,
            Order::FrontFirst { steps: Some(steps) } => {
                let start = if half == 0 { interval.middle - interval.half } else { interval.middle };
                (start * steps) as u64 == ((start + interval.half / 2.0) * steps) as u64
            }
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
