//! The proof by separating lines for bodies: per pair of a convex piece of the body and a convex obstacle, with directional bounds
//! on travel of third order (see `course.rs`).
//!
//! **The answers.** Where a piece stays ahead of an obstacle's support in some direction, by the slack, the two are apart on the
//! whole stretch and the pair is dropped for good. Where they touch in the middle, the motion is refused. Otherwise the
//! stretch is halved with the pairs still open. A stretch whose first-order bound is below the tolerance is judged by the
//! distance itself, so that everything the proof by distances accepts is accepted here.
//!
//! **The slack.** S is the largest coordinate plus the reach. Nothing is summed up along a motion: every middle is found from the
//! start. The direction there is the product of that at the start and of the turn since, each off by 1.4e-14 (see
//! `rotation.rs`) and by roundings of angles of 7 radians at most, 1e-15; on an arc, half of the turn is taken twice: 4.5e-14
//! in all, and so much times S for every corner. A way is off by roundings, 4e-16 times its length, which is 9 S at most; a
//! chord besides by its direction, 3e-14 times its length, and by the sine of half its turn, 1.4e-14 times the diameter
//! of the arc. As long as all before has been within the bounds, chords are no longer than 3 S; and where more than 0.4
//! radians of half a turn are behind, so that the sine is not from the bare series, the diameter is at most 3 S / sin 0.4 =
//! 7.8 S: 2.1e-13 S in all. A normal of the body is of unit length to 4.5e-14, its terms sum to no more than 2 S where a test
//! passes: 9e-14 S. With no cancelling terms in K, each of the roughly 30 roundings of a test costs less than 8 S times
//! 2^-53: 3e-14 S. Together that is below 4e-13 S; the slack is 1e-12 S.

use super::body_pair::Piece;
use super::body_shape::BodyShape;
use super::course::{Course, Middle};
use super::pair::NO_HINT;
use super::rotation::{turned, unit};
use super::{Answer, BodySetting};
use crate::collision::{BodyMotion, Tolerance};
use crate::geometry::{Aabb, Point, Vector};

/// How many stretches may be open before the proof goes on depth-first.
const WIDEST: usize = 1024;

/// A piece of the body and a convex obstacle not yet known to be apart.
#[derive(Debug, Clone, Copy)]
struct Pair {
    piece: u32,
    obstacle: u32,
    /// The direction to try first: see [`Piece::separate_from_polygon`].
    hint: u32,
}

/// In place of an obstacle's index: the bounds of the world, for the whole body.
const BOUNDS: u32 = u32::MAX;

/// A stretch of the motion: its middle and half its length (fractions of the motion), and which pairs are open on it.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    middle: f64,
    half: f64,
    pairs: (usize, usize),
}

/// In which order stretches are looked at.
#[derive(Clone, Copy, PartialEq)]
enum Order {
    /// Any hit refuses the motion: level by level, the longest stretches first.
    MiddleFirst,
    /// The first hit is wanted: halve towards the front until the bound is below the tolerance.
    FrontFirst,
}

/// What proofs use again and again, and the count of pairs evaluated.
#[derive(Debug, Clone)]
pub(in crate::collision) struct Work {
    /// The angle last begun from, and its unit vector: roadmaps try many motions from one placement.
    from: f64,
    heading: Vector,
    /// The corners of the body as seen from the origin of its frame, in the middle of the stretch that is looked at.
    places: Vec<Vector>,
    pairs: Vec<Pair>,
    stretches: Vec<Stretch>,
    pub evaluations: u64,
}

impl Default for Work {
    fn default() -> Self {
        let (places, pairs, stretches) = (Vec::new(), Vec::new(), Vec::new());
        Self { from: 0.0, heading: Vector::new(1.0, 0.0), places, pairs, stretches, evaluations: 0 }
    }
}

/// Whether the motion is proven free, ends included.
pub(in crate::collision) fn is_free(setting: &BodySetting, motion: &BodyMotion, work: &mut Work) -> bool {
    prove(setting, motion, Order::MiddleFirst, work).is_none()
}

/// Where the first stretch begins that cannot be proven free, as a fraction of the motion; `None` where all is proven.
pub(in crate::collision) fn first_hit(setting: &BodySetting, motion: &BodyMotion, work: &mut Work) -> Option<f64> {
    prove(setting, motion, Order::FrontFirst, work)
}

/// Whether the body at rest at `q` is clear of everything: `None` where separating lines leave less than half the slack to
/// spare, so that distances must tell.
pub(in crate::collision) fn is_free_at(setting: &BodySetting, q: &[f64; 3], work: &mut Work) -> Option<bool> {
    let Tolerance { eta, .. } = setting.tolerance;
    let middle = Middle::at_rest(Vector::new(q[0], q[1]), unit(q[2]));
    place(setting.shape, &middle, &mut work.places);
    let mut is_clear = true;
    for piece in 0..setting.shape.pieces() {
        let range = setting.shape.range(piece);
        let (corners, places) = (&setting.shape.corners()[range.clone()], &work.places[range]);
        let piece = Piece { middle: &middle, corners, places };
        let swept = middle.swept_box(places);
        let depth = setting.bounds.depth(swept.min).min(setting.bounds.depth(swept.max));
        if depth < -1.5 * eta {
            return Some(false);
        }
        is_clear &= depth >= -0.5 * eta;
        let touches = |obstacle: usize| {
            work.evaluations += 1;
            match piece.separate_at_rest(setting.obstacles, obstacle, 1.5 * eta, eta) {
                Answer::Apart => false,
                Answer::Touching => true,
                _ => {
                    is_clear = false;
                    false
                }
            }
        };
        if setting.obstacles.any_near(&swept.grown(1.5 * eta), touches) {
            return Some(false);
        }
    }
    is_clear.then_some(true)
}

/// Turns the corners of the body.
#[inline(always)]
fn place(shape: &BodyShape, middle: &Middle, places: &mut Vec<Vector>) {
    places.clear();
    places.extend(shape.corners().iter().map(|corner| turned(corner.at, middle.heading)));
}

/// Where the stretch begins that refuses the motion, in this order the first; `None` where all is proven.
#[cfg_attr(target_arch = "wasm32", inline(never))]
fn prove(setting: &BodySetting, motion: &BodyMotion, order: Order, work: &mut Work) -> Option<f64> {
    let mut proof = Proof::new(setting, motion, order, work);
    let root = Stretch { middle: 0.5, half: 0.5, pairs: (0, 0) };
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
struct Proof<'a> {
    setting: &'a BodySetting<'a>,
    order: Order,
    course: Course,
    work: &'a mut Work,
}

impl<'a> Proof<'a> {
    #[inline(always)]
    fn new(setting: &'a BodySetting<'a>, motion: &BodyMotion, order: Order, work: &'a mut Work) -> Self {
        work.pairs.clear();
        work.stretches.clear();
        let [_, _, theta] = motion.from();
        if work.from != theta {
            (work.from, work.heading) = (theta, unit(theta));
        }
        let course = Course::new(motion, setting.shape.reach(), work.heading);
        Self { setting, order, course, work }
    }

    /// Adds the two halves of a stretch, with the pairs from `first` on open.
    #[inline(always)]
    fn halve(&mut self, stretch: &Stretch, first: usize) {
        let half = stretch.half / 2.0;
        let child = Stretch { half, pairs: (first, self.work.pairs.len()), ..*stretch };
        let (mut front, mut back) = (child, child);
        front.middle -= half;
        back.middle += half;
        let halves = if self.order == Order::MiddleFirst { [front, back] } else { [back, front] };
        self.work.stretches.extend_from_slice(&halves);
    }

    /// A box that holds these corners on the whole stretch, and the slack.
    #[inline(always)]
    fn swept_box(&self, middle: &Middle, half: f64, corners: std::ops::Range<usize>) -> Aabb {
        self.course.swept_box(middle, half, &self.work.places[corners]).grown(self.setting.tolerance.eta)
    }

    /// Looks at every piece and everything near its swept box; lists what stays open. Answers whether the motion is refused.
    #[inline(always)]
    fn look_at_all(&mut self, root: &Stretch) -> bool {
        let middle = self.course.middle(root.middle, root.half);
        let (shape, obstacles) = (self.setting.shape, self.setting.obstacles);
        place(shape, &middle, &mut self.work.places);
        let mut all: Option<Aabb> = None;
        for piece in 0..shape.pieces() {
            let swept = self.swept_box(&middle, root.half, shape.range(piece));
            if obstacles.any_near(&swept, |obstacle| self.look(root, &middle, piece, obstacle, NO_HINT)) {
                return true;
            }
            all = Some(all.map_or(swept, |all| all.union(&swept)));
        }
        all.is_some_and(|all| self.look_at_bounds(root, &middle, &all))
    }

    /// Looks at the pairs still open; lists again what stays so. Answers whether the stretch is refused.
    #[inline(always)]
    fn look_at_open(&mut self, stretch: &Stretch) -> bool {
        let middle = self.course.middle(stretch.middle, stretch.half);
        place(self.setting.shape, &middle, &mut self.work.places);
        let (first, end) = stretch.pairs;
        let (mut of, mut swept) = (u32::MAX, Aabb { min: Point::origin(), max: Point::origin() });
        (first..end).any(|at| {
            let Pair { piece, obstacle, hint } = self.work.pairs[at];
            if obstacle == BOUNDS {
                let all = self.swept_box(&middle, stretch.half, 0..self.setting.shape.corners().len());
                return self.look_at_bounds(stretch, &middle, &all);
            }
            if piece != of {
                swept = self.swept_box(&middle, stretch.half, self.setting.shape.range(piece as usize));
                of = piece;
            }
            self.setting.obstacles.aabb(obstacle as usize).intersects(&swept)
                && self.look(stretch, &middle, piece as usize, obstacle as usize, hint)
        })
    }

    /// Evaluates a piece and an obstacle; lists them where they stay open. Answers whether they refuse the stretch.
    #[inline(always)]
    fn look(&mut self, stretch: &Stretch, middle: &Middle, piece: usize, obstacle: usize, hint: u32) -> bool {
        self.work.evaluations += 1;
        let (answer, hint) = self.separate(stretch, middle, piece, obstacle, hint);
        let pair = Pair { piece: piece as u32, obstacle: obstacle as u32, hint };
        answer != Answer::Apart && self.keep(stretch, pair, answer, self.setting.tolerance.tau)
    }

    /// Lists a pair that is not apart; answers whether it refuses the stretch instead.
    #[inline(always)]
    fn keep(&mut self, stretch: &Stretch, pair: Pair, answer: Answer, finest: f64) -> bool {
        let is_hit = answer == Answer::Touching && self.order == Order::MiddleFirst;
        if is_hit || self.course.travel * stretch.half < finest {
            return true;
        }
        self.work.pairs.push(pair);
        false
    }

    /// Whether the body stays within the bounds of the world, contact allowed.
    #[inline(always)]
    fn look_at_bounds(&mut self, stretch: &Stretch, middle: &Middle, swept: &Aabb) -> bool {
        let Tolerance { eta, bounds_tau, .. } = self.setting.tolerance;
        // The swept box already holds one slack; contact may exceed the bounds by one.
        let roomy = self.setting.bounds.grown(2.0 * eta);
        if roomy.contains(swept.min) && roomy.contains(swept.max) {
            return false;
        }
        let depth = |r: &Vector| self.setting.bounds.depth(Point::from(middle.place + r));
        let depth = self.work.places.iter().map(depth).fold(f64::INFINITY, f64::min);
        if depth - self.course.travel * stretch.half >= -eta {
            return false;
        }
        let answer = if depth < -eta { Answer::Touching } else { Answer::Open };
        self.keep(stretch, Pair { piece: 0, obstacle: BOUNDS, hint: NO_HINT }, answer, bounds_tau)
    }

    /// Whether piece and obstacle are apart on the whole stretch: by separating lines, then by the distance.
    #[inline(always)]
    fn separate(&self, stretch: &Stretch, middle: &Middle, piece: usize, obstacle: usize, hint: u32) -> (Answer, u32) {
        let Tolerance { eta, tau, .. } = self.setting.tolerance;
        let range = self.setting.shape.range(piece);
        let (corners, places) = (&self.setting.shape.corners()[range.clone()], &self.work.places[range]);
        let piece = Piece { middle, corners, places };
        let faces = self.setting.obstacles.faces(obstacle);
        let bound = self.course.travel * stretch.half;
        let mut next = NO_HINT;
        if !faces.is_empty() {
            let direction = self.course.direction(middle);
            let answer;
            (answer, next) = piece.separate_from_polygon(faces, direction, hint, eta, eta);
            if matches!(answer, Answer::Apart | Answer::Touching) || (answer == Answer::Open && bound >= tau) {
                return (answer, next);
            }
        }
        (self.separate_closely(&piece, obstacle, bound), next)
    }

    /// The same where neither a face nor the direction of motion tells.
    #[inline(never)]
    fn separate_closely(&self, piece: &Piece, obstacle: usize, bound: f64) -> Answer {
        let eta = self.setting.tolerance.eta;
        let (answer, clearance) = match self.setting.obstacles.disc(obstacle) {
            Some(disc) => piece.separate_from_disc(disc, eta),
            None => piece.separate_corners(self.setting.obstacles.faces(obstacle), eta),
        };
        if clearance - bound > eta { Answer::Apart } else { answer }
    }
}
