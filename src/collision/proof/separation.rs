//! The proof by separating lines: per pair of a link and an obstacle, with directional bounds on travel of third order (see
//! `joint.rs`).
//!
//! **The answers.** Where a link stays ahead of an obstacle's support in some direction, by its radius and the slack, the
//! two are apart on the whole stretch and the pair is dropped for good. Where they touch in the middle, the motion is
//! refused. Otherwise the stretch is halved with the pairs still open. A stretch whose first-order bound is below the
//! tolerance is judged by the distance itself, so that everything the proof by distances accepts is accepted here.
//!
//! **The slack.** A test passes only where its terms sum to no more than about 2 S, S the largest coordinate plus the reach.
//! As W has no cancelling terms, L_j summing to at most S gives h |v| < 3 S and h^2 |a| / 2 < 3 S then, so that each of
//! the roughly 30 roundings costs less than 8 S times 2^-53: below 3e-14 S in all. Unit vectors are products of those of
//! `rotation.rs`: the absolute angle at the start, off by 1.4e-14 at most; half the turn by 2.8e-14; a quarter, an eighth and
//! so on by half as much each, 2.8e-14 together; and a product a level, at most 50, by 3 times 2^-53 each: 9e-14 in all, and
//! so much times S. Links that turn by more than 12.8 radians are not squared up but reduced level by level, each off by
//! 1.4e-14, until they are small: of eight circles one level, with the widest limits nine, 1.3e-13 more. Absolute angles and
//! rates are sums of up to eight joints: of circles up to 26 radians; with limits up to 50, sums up to 800 and differences up to
//! 100, rounded to 5e-13 in all at worst. Where limits are wider, up to twice that, the slack is doubled. The slack is
//! 1e-12 S.

use super::joint::MovingJoint;
use super::pair::{Answer, Link, NO_HINT};
use super::rotation::{Units, unit};
use super::{Motion, Setting};
use crate::collision::Tolerance;
use crate::collision::obstacles::Face;
use crate::geometry::{Aabb, Point, Segment, Vector};
use crate::robot::MAX_LINKS;

/// Turns over this many halvings are found together, by squaring the smallest.
const SQUARED: usize = 4;

/// The fastest rate, in radians over the motion, whose thirty-second is small enough to be squared up.
const FASTEST_SQUARED: f64 = 12.8;

/// A link that turns by more radians than this over half a stretch may be held better by its travel and reach.
const FAST: f64 = 1.5;

/// How many stretches may be open before the proof goes on depth-first.
const WIDEST: usize = 1024;

/// A link and an obstacle not yet known to be apart.
#[derive(Debug, Clone, Copy)]
struct Pair {
    link: u32,
    obstacle: u32,
    /// The direction to try first: see [`Link::separate_from_polygon`].
    hint: u32,
}

/// In place of an obstacle's index: the bounds of the world.
const BOUNDS: u32 = u32::MAX;

/// A stretch of the motion: its middle and half its length (fractions of the motion), how often the motion was halved to
/// get it, which pairs are open on it, and the unit vectors along the links in its middle.
#[derive(Debug, Clone, Copy)]
struct Stretch<const N: usize> {
    middle: f64,
    half: f64,
    level: usize,
    pairs: (usize, usize),
    along: Units<N>,
}

/// In which order stretches are looked at.
#[derive(Clone, Copy, PartialEq)]
enum Order {
    /// Any hit refuses the motion: level by level, the longest stretches first.
    MiddleFirst,
    /// The first hit is wanted: halve towards the front until the bound is below the tolerance.
    FrontFirst,
}

/// What proofs use again and again, for arms of up to `N` links, and the count of pairs evaluated.
#[derive(Debug, Clone)]
pub(in crate::collision) struct Work<const N: usize> {
    /// The configuration last begun from, and its unit vectors: roadmaps try many motions from one.
    from: [f64; N],
    from_along: Units<N>,
    /// Of every link: its absolute rate, in radians over the whole motion, the bound on its travel, of first order, and the
    /// bound W on its outer end.
    rates: [f64; N],
    travel: [f64; N],
    third: [f64; N],
    /// The largest absolute rate of all links.
    fastest: f64,
    /// The turn of every link over a quarter of the motion, an eighth, and so on.
    turns: [Units<N>; SQUARED],
    finer_turns: Vec<Units<N>>,
    /// The joints in the middle of the stretch that is looked at.
    joints: [MovingJoint; MAX_LINKS + 1],
    pairs: Vec<Pair>,
    stretches: Vec<Stretch<N>>,
    pub evaluations: u64,
}

impl<const N: usize> Default for Work<N> {
    fn default() -> Self {
        Self {
            from: [f64::NAN; N],
            from_along: Units::ZERO,
            rates: [0.0; N],
            travel: [0.0; N],
            third: [0.0; N],
            fastest: 0.0,
            turns: [Units::ZERO; SQUARED],
            finer_turns: Vec::new(),
            joints: [MovingJoint::default(); MAX_LINKS + 1],
            pairs: Vec::new(),
            stretches: Vec::new(),
            evaluations: 0,
        }
    }
}

/// Whether the motion is proven free, ends included.
pub(in crate::collision) fn is_free<const N: usize>(setting: &Setting, motion: &Motion<N>, work: &mut Work<N>) -> bool {
    prove(setting, motion, Order::MiddleFirst, work).is_none()
}

/// Where the first stretch begins that cannot be proven free, as a fraction of the motion; `None` where all is proven.
pub(in crate::collision) fn first_hit<const N: usize>(
    setting: &Setting,
    motion: &Motion<N>,
    work: &mut Work<N>,
) -> Option<f64> {
    prove(setting, motion, Order::FrontFirst, work)
}

/// Where the stretch begins that refuses the motion, in this order the first; `None` where all is proven.
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
#[cfg_attr(target_arch = "wasm32", inline(never))]
fn prove<const N: usize>(setting: &Setting, motion: &Motion<N>, order: Order, work: &mut Work<N>) -> Option<f64> {
    let mut proof = Proof::new(setting, order, work);
    let root = proof.begin(motion);
    if proof.look_at_all(&root) {
        return Some(0.0);
    }
    if proof.work.pairs.is_empty() {
        return None;
    }
    proof.halve(&root, 0);
    let mut next = 0;
    while next < proof.work.stretches.len() {
        let is_last = order == Order::FrontFirst || proof.work.stretches.len() - next > WIDEST;
        let stretch = if is_last {
            // The front lies last; and too many open stretches are not all kept, but the last one is taken first. Lists behind
            // its own belong to stretches already done.
            let last = proof.work.stretches.pop().expect("some are left");
            proof.work.pairs.truncate(last.pairs.1);
            last
        } else {
            next += 1;
            proof.work.stretches[next - 1]
        };
        let first = proof.work.pairs.len();
        if proof.look_at_open(&stretch) {
            return Some(stretch.middle - stretch.half);
        }
        if proof.work.pairs.len() > first {
            proof.halve(&stretch, first);
        }
    }
    None
}

/// One proof at work.
struct Proof<'a, const N: usize> {
    setting: &'a Setting<'a>,
    order: Order,
    work: &'a mut Work<N>,
    /// Links of the arm.
    links: usize,
    /// What a link must be ahead of an obstacle: its radius and the slack.
    margin: f64,
}

impl<'a, const N: usize> Proof<'a, N> {
    #[inline(always)]
    fn new(setting: &'a Setting<'a>, order: Order, work: &'a mut Work<N>) -> Self {
        let margin = setting.arm.radius() + setting.tolerance.eta;
        Self { setting, order, work, links: setting.arm.links().len().min(N), margin }
    }

    /// Prepares the motion; its whole as a stretch.
    #[inline(always)]
    fn begin(&mut self, motion: &Motion<N>) -> Stretch<N> {
        let work = &mut *self.work;
        work.pairs.clear();
        work.stretches.clear();
        work.finer_turns.clear();
        if work.from != *motion.from {
            work.from = *motion.from;
            let mut angle = 0.0;
            for i in 0..N {
                angle += work.from[i];
                let e = unit(angle);
                (work.from_along.x[i], work.from_along.y[i]) = (e.x, e.y);
            }
        }
        let (mut rate, mut travel, mut third, mut fastest) = (0.0, 0.0, 0.0, 0.0);
        for (i, &length) in self.setting.arm.links().iter().enumerate().take(N) {
            rate += motion.delta[i];
            let spin = f64::abs(rate);
            let speed = length * spin;
            travel += speed;
            third += speed * rate * rate;
            if spin > fastest {
                fastest = spin;
            }
            (work.rates[i], work.travel[i], work.third[i]) = (rate, travel, third);
        }
        work.fastest = fastest;
        let mut turns = Units::new(&work.rates, 1.0 / 32.0, fastest);
        for level in (0..SQUARED).rev() {
            work.turns[level] = turns;
            turns = turns.doubled();
        }
        if fastest > FASTEST_SQUARED {
            turns = Units::new(&work.rates, 0.5, fastest);
            let mut part = 0.25;
            for level in &mut work.turns {
                *level = Units::new(&work.rates, part, fastest);
                part *= 0.5;
            }
        }
        let [_, along] = work.from_along.turned_both_ways(&turns);
        let stretch = Stretch { middle: 0.5, half: 0.5, level: 0, pairs: (0, 0), along };
        self.place_joints(&stretch, self.links);
        stretch
    }

    /// Places the joints of the first `links` links in the middle of the stretch.
    #[inline(always)]
    fn place_joints(&mut self, stretch: &Stretch<N>, links: usize) {
        let h = stretch.half;
        let sixth = h * h * h / 6.0;
        let lengths = &self.setting.arm.links()[..links];
        let mut joint = MovingJoint::base(self.setting.arm.base());
        self.work.joints[0] = joint;
        for (i, &length) in lengths.iter().enumerate() {
            joint = joint.next(stretch.along.at(i), length, h * self.work.rates[i], sixth * self.work.third[i]);
            self.work.joints[i + 1] = joint;
        }
    }

    /// Adds the two halves of a stretch, with the pairs from `first` on open.
    #[inline(always)]
    fn halve(&mut self, stretch: &Stretch<N>, first: usize) {
        let half = stretch.half / 2.0;
        let turns = match stretch.level.checked_sub(SQUARED) {
            None => &self.work.turns[stretch.level],
            Some(finer) => {
                if finer == self.work.finer_turns.len() {
                    self.work.finer_turns.push(Units::new(&self.work.rates, half, self.work.fastest));
                }
                &self.work.finer_turns[finer]
            }
        };
        let pairs = (first, self.work.pairs.len());
        let child = Stretch { half, level: stretch.level + 1, pairs, ..*stretch };
        let (mut front, mut back) = (child, child);
        front.middle -= half;
        back.middle += half;
        [front.along, back.along] = stretch.along.turned_both_ways(turns);
        let halves = if self.order == Order::MiddleFirst { [front, back] } else { [back, front] };
        self.work.stretches.extend_from_slice(&halves);
    }

    /// A box that holds link `i` with its radius on the whole stretch.
    #[inline(always)]
    fn swept_box(&self, i: usize, half: f64) -> Aabb {
        self.around(&self.joint_box(i, half), &self.joint_box(i + 1, half))
    }

    /// A box that holds joint `k` on the whole stretch.
    #[inline(always)]
    fn joint_box(&self, k: usize, half: f64) -> Aabb {
        let swept = self.work.joints[k].swept_box();
        if k > 0 && self.work.fastest * half > FAST { self.held(swept, k, half) } else { swept }
    }

    /// The box around a link between two joints in these boxes.
    #[inline(always)]
    fn around(&self, a: &Aabb, b: &Aabb) -> Aabb {
        let lesser = |axis: usize| if a.min[axis] < b.min[axis] { a.min[axis] } else { b.min[axis] };
        let greater = |axis: usize| if a.max[axis] > b.max[axis] { a.max[axis] } else { b.max[axis] };
        let (min, max) = ([lesser(0), lesser(1)], [greater(0), greater(1)]);
        Aabb { min: min.into(), max: max.into() }.grown(self.margin)
    }

    /// The part of a joint's box within its bound of first order, and within its reach from the base.
    #[cold]
    fn held(&self, swept: Aabb, joint: usize, half: f64) -> Aabb {
        let arm = self.setting.arm;
        let travel = self.work.travel[joint - 1] * half;
        let reach = arm.links()[..joint].iter().sum::<f64>() + self.setting.tolerance.eta;
        let within = |swept: Aabb, place: Point, by: f64| Aabb {
            min: swept.min.sup(&(place - Vector::new(by, by))),
            max: swept.max.inf(&(place + Vector::new(by, by))),
        };
        within(within(swept, self.work.joints[joint].place(), travel), arm.base(), reach)
    }

    /// Looks at every link and everything near its swept box; lists what stays open. Answers whether the motion is refused.
    #[inline(always)]
    fn look_at_all(&mut self, root: &Stretch<N>) -> bool {
        let obstacles = self.setting.obstacles;
        let mut inner = self.joint_box(0, root.half);
        for link in 0..self.links {
            let outer = self.joint_box(link + 1, root.half);
            let swept = self.around(&inner, &outer);
            inner = outer;
            if obstacles.any_near(&swept, |obstacle| self.look(root, link, obstacle, NO_HINT)) {
                return true;
            }
            if self.setting.bounds.is_some() && self.look_at_bounds(root, link, &swept) {
                return true;
            }
        }
        false
    }

    /// Looks at the pairs still open; lists again what stays so. Answers whether the stretch is refused.
    #[inline(always)]
    fn look_at_open(&mut self, stretch: &Stretch<N>) -> bool {
        let (first, end) = stretch.pairs;
        // Pairs are listed by link: the last has the outermost.
        self.place_joints(stretch, self.work.pairs[end - 1].link as usize + 1);
        let (mut of, mut swept) = (usize::MAX, Aabb { min: Point::origin(), max: Point::origin() });
        (first..end).any(|at| {
            let Pair { link, obstacle, hint } = self.work.pairs[at];
            let link = link as usize;
            if link != of {
                (of, swept) = (link, self.swept_box(link, stretch.half));
            }
            if obstacle == BOUNDS {
                self.look_at_bounds(stretch, link, &swept)
            } else {
                self.setting.obstacles.aabb(obstacle as usize).intersects(&swept)
                    && self.look(stretch, link, obstacle as usize, hint)
            }
        })
    }

    /// Evaluates a link and an obstacle; lists them where they stay open. Answers whether they refuse the stretch.
    #[inline(always)]
    fn look(&mut self, stretch: &Stretch<N>, link: usize, obstacle: usize, hint: u32) -> bool {
        self.work.evaluations += 1;
        let ends = [&self.work.joints[link], &self.work.joints[link + 1]];
        let (answer, hint) = self.separate(stretch, Link { ends, along: stretch.along.at(link) }, link, obstacle, hint);
        let pair = Pair { link: link as u32, obstacle: obstacle as u32, hint };
        answer != Answer::Apart && self.keep(stretch, pair, answer, self.setting.tolerance.tau)
    }

    /// Lists a pair that is not apart; answers whether it refuses the stretch instead.
    #[inline(always)]
    fn keep(&mut self, stretch: &Stretch<N>, pair: Pair, answer: Answer, finest: f64) -> bool {
        let is_hit = answer == Answer::Touching && self.order == Order::MiddleFirst;
        if is_hit || self.work.travel[pair.link as usize] * stretch.half < finest {
            return true;
        }
        self.work.pairs.push(pair);
        false
    }

    /// Whether the link stays within the bounds of the world, contact allowed.
    fn look_at_bounds(&mut self, stretch: &Stretch<N>, link: usize, swept: &Aabb) -> bool {
        let bounds = self.setting.bounds.expect("a pair with the bounds exists only where there are bounds");
        let Tolerance { eta, bounds_tau, .. } = self.setting.tolerance;
        // The swept box already holds the radius and one slack; contact may exceed the bounds by one.
        let roomy = bounds.grown(2.0 * eta);
        let [a, b] = [link, link + 1].map(|k| bounds.depth(self.work.joints[k].place()));
        let depth = a.min(b) - self.setting.arm.radius();
        let bound = self.work.travel[link] * stretch.half;
        if (roomy.contains(swept.min) && roomy.contains(swept.max)) || depth - bound >= -eta {
            return false;
        }
        let answer = if depth < -eta { Answer::Touching } else { Answer::Open };
        self.keep(stretch, Pair { link: link as u32, obstacle: BOUNDS, hint: NO_HINT }, answer, bounds_tau)
    }

    /// Whether link and obstacle are apart on the whole stretch: by separating lines, then by the distance.
    #[inline(always)]
    fn separate(&self, stretch: &Stretch<N>, link: Link, index: usize, obstacle: usize, hint: u32) -> (Answer, u32) {
        let Tolerance { eta, tau, .. } = self.setting.tolerance;
        let faces = self.setting.obstacles.faces(obstacle);
        let bound = self.work.travel[index] * stretch.half;
        let mut next = NO_HINT;
        if !faces.is_empty() {
            let answer;
            (answer, next) = link.separate_from_polygon(faces, hint, self.margin, eta);
            if matches!(answer, Answer::Apart | Answer::Touching) || (answer == Answer::Open && bound >= tau) {
                return (answer, next);
            }
        }
        (self.separate_closely(faces, link, obstacle, bound), next)
    }

    /// The same where neither a face nor the link itself tells.
    #[inline(never)]
    fn separate_closely(&self, faces: &[Face], link: Link, obstacle: usize, bound: f64) -> Answer {
        let Tolerance { eta, tau, .. } = self.setting.tolerance;
        let answer = if !faces.is_empty() {
            link.separate_corners(faces, self.margin, eta)
        } else if let Some(disc) = self.setting.obstacles.disc(obstacle) {
            link.separate_from_disc(disc, self.margin, eta)
        } else {
            Answer::Unknown
        };
        if matches!(answer, Answer::Apart | Answer::Touching) || (answer == Answer::Open && bound >= tau) {
            return answer;
        }
        let axis = Segment::new(link.ends[0].place(), link.ends[1].place());
        let clearance = self.setting.obstacles.distance(obstacle, &axis) - self.setting.arm.radius();
        if clearance - bound > eta {
            Answer::Apart
        } else if clearance <= eta {
            Answer::Touching
        } else {
            Answer::Open
        }
    }
}
